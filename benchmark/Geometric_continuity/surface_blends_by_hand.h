// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_SURFACE_BLENDS_BY_HAND_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_SURFACE_BLENDS_BY_HAND_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Simple_cartesian.h>

#include <random>
#include <vector>

// The blend of two bicubic patches with a given shape: by the package, and by instructions written
// by hand for just that.
namespace by_hand {

namespace GC = CGAL::Geometric_continuity;

// Two patches and a shape of numbers.
template <class FT> struct Surface_blend_input {
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Numbers;
  typedef GC::Bezier_patch<Numbers> Surface;

  Surface a = bicubic(0), b = bicubic(5);
  GC::Surface_blend_shape<FT> shape;

  Surface_blend_input() {
    shape.start.beta = {FT(FT(10) / FT(8))};
    shape.start.delta = {FT(FT(-3) / FT(8))};
    shape.end.beta = {FT(FT(14) / FT(8))};
    shape.end.delta = {FT(FT(12) / FT(8))};
  }
  Surface operator()() const { return GC::blend(a, GC::Patch_edge::v1, b, GC::Patch_edge::v0, shape); }

private:
  static Surface bicubic(int from) {
    std::mt19937_64 random(2026 + static_cast<unsigned>(from));
    const auto number = [&](int base) {
      return FT(FT(1000 * base + static_cast<int>(random() % 601) - 300) / FT(1000));
    };
    std::vector<std::vector<typename Numbers::Point>> net(4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const FT x = number(i), y = number(from + j), z = number(0);
        net[i].push_back({x, y, z});
      }
    return Surface(net);
  }
};

// Sums of the control points of the layers next to the edges.
struct Surface_blend {
  double end[2][4][3][3], b[4][6][3], beta[2], delta[2];

  explicit Surface_blend(const Surface_blend_input<double>& x)
      : beta{x.shape.start.beta[0], x.shape.end.beta[0]}, delta{x.shape.start.delta[0], x.shape.end.delta[0]} {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) {
          end[0][i][j][k] = x.a.control_point(i, 3 - j)[k];
          end[1][i][j][k] = x.b.control_point(i, j)[k];
        }
  }

  void operator()() {
    for (int e = 0; e < 2; ++e) {
      const int first = e == 0 ? 0 : 5, step = e == 0 ? 1 : -1;
      const double f = -3 * beta[e] / 5, g = (-24 * beta[e] - step * 3 * delta[e]) / 20, h = 6 * beta[e] * beta[e] / 20;
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) {
          const double p = end[e][i][0][k], d = end[e][i][1][k] - p, dd = end[e][i][2][k] - end[e][i][1][k] - d;
          b[i][first][k] = p;
          b[i][first + step][k] = p + f * d;
          b[i][first + 2 * step][k] = p + g * d + h * dd;
        }
    }
  }
};

#ifdef CGAL_USE_GMPXX
// The blend in integers: there is one denominator for each patch, beta and delta are in eighths,
// and each result is reduced once.
struct Exact_surface_blend {
  const Surface_blend_input<CGAL::Exact_rational>& x;
  mpz_class n[3][3], denominator, d, dd;
  mpq_class b[4][6][3];

  void operator()() {
    for (int e = 0; e < 2; ++e) {
      const auto point = [&](int i, int j) { return e == 0 ? x.a.control_point(i, 3 - j) : x.b.control_point(i, j); };
      denominator = 1;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) {
          const auto p = point(i, j);
          for (int k = 0; k < 3; ++k)
            if (!mpz_divisible_p(denominator.get_mpz_t(), denominator_of(p[k])))
              mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), denominator_of(p[k]));
        }
      const int step = e == 0 ? 1 : -1, beta = e == 0 ? 10 : 14, delta = e == 0 ? -3 : 12;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
          const auto p = point(i, j);
          for (int k = 0; k < 3; ++k) {
            mpz_divexact(n[j][k].get_mpz_t(), denominator.get_mpz_t(), denominator_of(p[k]));
            mpz_mul(n[j][k].get_mpz_t(), n[j][k].get_mpz_t(), numerator_of(p[k]));
          }
        }
        for (int k = 0; k < 3; ++k) {
          mpq_class* const to = b[i][0] + k;
          // 3 numbers a point
          const int first = e == 0 ? 0 : 15, second = first + 3 * step, third = second + 3 * step;
          d = n[1][k] - n[0][k];
          dd = n[2][k] - n[1][k] - d;
          to[first].get_num() = n[0][k];
          to[first].get_den() = denominator;
          to[second].get_num() = 40 * n[0][k] - 3 * beta * d;
          to[second].get_den() = 40 * denominator;
          to[third].get_num() = 1280 * n[0][k] - 8 * (24 * beta + step * 3 * delta) * d + 6 * beta * beta * dd;
          to[third].get_den() = 1280 * denominator;
          for (int at : {first, second, third}) to[at].canonicalize();
        }
      }
    }
  }

  static mpz_srcptr numerator_of(const mpq_class& q) { return q.get_num_mpz_t(); }
  static mpz_srcptr denominator_of(const mpq_class& q) { return q.get_den_mpz_t(); }
};
#endif

} // namespace by_hand

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_SURFACE_BLENDS_BY_HAND_H
