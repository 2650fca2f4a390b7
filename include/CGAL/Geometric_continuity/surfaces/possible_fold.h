// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_POSSIBLE_FOLD_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_POSSIBLE_FOLD_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file possible_fold.h
/// Where the normal of a surface may vanish, as it does in folds and cusps; or a proof that it
/// vanishes nowhere.
///
/// On a rectangle the normal vanishes nowhere when the products of all its Bernstein coefficients
/// with one vector are positive. Where they are not, the rectangle is halved. The normal of a
/// rational surface p / w is, up to a positive factor,
/// \f$ w\,(p_u \times p_v) + (w_u\,p_v - w_v\,p_u) \times p \f$. All is computed in intervals of
/// floating-point numbers, rounded outwards.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A rectangle in the parameter plane of a surface.
/// \tparam FT a field number type
template <class FT> struct Parameter_rectangle {
  std::pair<FT, FT> u; ///< the interval of `u`
  std::pair<FT, FT> v; ///< the interval of `v`
};

namespace internal {

typedef Interval_nt<false> Normal_number;
typedef std::array<Normal_number, 3> Normal_vector;
typedef std::array<Normal_number, 4> Normal_point; // homogeneous

// Vectors or points as the coefficients of a polynomial in two variables, each divided by its
// binomial numbers.
template <class Value> class Interval_net {
  int p_, q_;
  std::vector<Value> c_;

public:
  Interval_net(int p, int q) : p_(p), q_(q), c_(static_cast<std::size_t>(p + 1) * (q + 1)) {
    for (Value& x : c_) x.fill(Normal_number(0));
  }

  int degree_u() const { return p_; }
  int degree_v() const { return q_; }
  const std::vector<Value>& values() const { return c_; }
  Value& operator()(int i, int j) { return c_[static_cast<std::size_t>(i) * (q_ + 1) + j]; }
  const Value& operator()(int i, int j) const { return c_[static_cast<std::size_t>(i) * (q_ + 1) + j]; }
};

inline Normal_vector scaled(const Normal_number& w, const Normal_vector& x) { return {w * x[0], w * x[1], w * x[2]}; }
inline Normal_vector cross(const Normal_vector& x, const Normal_vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

// The normals of one Bezier patch as a polynomial, whose rectangle is halved. Points are
// homogeneous, with the weights 1 where it is polynomial.
template <bool is_rational> class Patch_normals {
  typedef Interval_net<Normal_vector> Normals;
  struct Part {
    Normals normals;
    std::array<Range, 2> range; // of u and v on the unit square
    int halvings;
  };

public:
  // A rectangle in the unit square whose normals are not proved not to vanish.
  static std::optional<std::array<Range, 2>> possible_zero(const Interval_net<Normal_point>& net) {
    const Protect_FPU_rounding<true> upwards;
    charge(net);
    Newest_first<Part> parts;
    parts.add({normals(net), {Range{0, 1}, Range{0, 1}}, 0});
    const bool proved = subdivide(
        parts,
        [](const Part& part) {
          if (has_no_zero(part.normals)) return After_part::drop;
          return part.halvings == most_halvings ? After_part::stop : After_part::divide;
        },
        [&](const Part& part) {
          charge(part.normals);
          std::array<Part, 2> both = halves(part);
          for (int upper : {1, 0}) parts.add(std::move(both[upper]));
        });
    if (proved) return std::nullopt;
    return parts.next().range;
  }

private:
  static constexpr int most_halvings = 20;

  static void charge(const Interval_net<Normal_point>& net) {
    const double n = (net.degree_u() + 1.) * (net.degree_v() + 1);
    work_meter().charge_products((is_rational ? 60 * n : 12) * n * n, 1);
  }
  static void charge(const Normals& n) { // additions
    const double p = n.degree_u() + 1, q = n.degree_v() + 1;
    work_meter().charge_products(3 * p * q * (std::max)(p, q), 1);
  }

  // By the algorithm of de Casteljau, whose sums are divided at the end.
  static std::array<Part, 2> halves(const Part& part) {
    std::array<Part, 2> r = {part, part};
    const int x = part.halvings % 2; // u and v in turn
    const int p = part.normals.degree_u(), q = part.normals.degree_v(), n = x == 0 ? p : q, m = x == 0 ? q : p;
    std::vector<Normal_number> powers;
    for (int k = 0; k <= n; ++k) powers.push_back(Normal_number(std::ldexp(1, -k)));
    for (int i = 0; i <= m; ++i) {
      const auto at = [&](int half, int j) -> Normal_vector& {
        return x == 0 ? r[half].normals(j, i) : r[half].normals(i, j);
      };
      for (int k = 1; k <= n; ++k) {
        for (int j = 0; j <= n - k; ++j)
          for (int l = 0; l < 3; ++l) at(1, j)[l] += at(1, j + 1)[l];
        at(0, k) = scaled(powers[k], at(1, 0));
      }
      for (int j = 0; j < n; ++j) at(1, j) = scaled(powers[n - j], at(1, j));
    }
    r[0].range[x].upper = r[1].range[x].lower = part.range[x].middle();
    for (Part& half : r) ++half.halvings;
    return r;
  }

  template <class Value, class A, class B, class Product>
  static void add_product(Interval_net<Value>& sum, const Interval_net<A>& a, const Interval_net<B>& b,
                          const Product& product) {
    for (int i = 0; i <= a.degree_u(); ++i)
      for (int j = 0; j <= a.degree_v(); ++j)
        for (int k = 0; k <= b.degree_u(); ++k)
          for (int l = 0; l <= b.degree_v(); ++l) {
            const Value x = product(a(i, j), b(k, l));
            for (std::size_t c = 0; c < x.size(); ++c) sum(i + k, j + l)[c] += x[c];
          }
  }

  // The coefficients, from which the binomial numbers are divided out.
  static Normals bernstein(Normals n) {
    const std::vector<Normal_number> of_p = binomial_coefficients<Normal_number>(n.degree_u()),
                                     of_q = binomial_coefficients<Normal_number>(n.degree_v());
    for (int i = 0; i <= n.degree_u(); ++i)
      for (int j = 0; j <= n.degree_v(); ++j)
        for (Normal_number& y : n(i, j)) y /= of_p[i] * of_q[j];
    return n;
  }

  // A positive factor is left out.
  static Normals normals(const Interval_net<Normal_point>& net) {
    const int p = net.degree_u(), q = net.degree_v();
    if (p == 0 || q == 0) return {0, 0};
    const std::vector<Normal_number> of_p = binomial_coefficients<Normal_number>(p),
                                     of_q = binomial_coefficients<Normal_number>(q),
                                     below_p = binomial_coefficients<Normal_number>(p - 1),
                                     below_q = binomial_coefficients<Normal_number>(q - 1);
    Interval_net<Normal_point> s(p, q), in_u(p - 1, q), in_v(p, q - 1);
    const Normal_point middle = net(p / 2, q / 2); // the origin is put there
    std::array<double, 3> origin{};
    if constexpr (is_rational)
      for (int l = 0; l < 3; ++l) origin[l] = CGAL::to_double(middle[l]) / CGAL::to_double(middle[3]);
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j)
        for (int l = 0; l < 4; ++l) {
          const auto point = [&](int k, int h) {
            return l < 3 && is_rational ? net(k, h)[l] - net(k, h)[3] * Normal_number(origin[l]) : net(k, h)[l];
          };
          s(i, j)[l] = of_p[i] * of_q[j] * point(i, j);
          if (i < p) in_u(i, j)[l] = below_p[i] * of_q[j] * (point(i + 1, j) - point(i, j));
          if (j < q) in_v(i, j)[l] = of_p[i] * below_q[j] * (point(i, j + 1) - point(i, j));
        }
    const auto vector = [](const Normal_point& x) { return Normal_vector{x[0], x[1], x[2]}; };
    Normals product(2 * p - 1, 2 * q - 1);
    add_product(product, in_u, in_v,
                [&](const Normal_point& x, const Normal_point& y) { return cross(vector(x), vector(y)); });
    if constexpr (!is_rational)
      return bernstein(std::move(product));
    else {
      Normals turned(2 * p - 1, 2 * q - 1), sum(3 * p - 1, 3 * q - 1);
      add_product(turned, in_u, in_v, [&](const Normal_point& x, const Normal_point& y) {
        const Normal_vector a = scaled(x[3], vector(y)), b = scaled(y[3], vector(x));
        return Normal_vector{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
      });
      add_product(sum, s, product, [](const Normal_point& x, const Normal_vector& y) { return scaled(x[3], y); });
      add_product(sum, turned, s, [&](const Normal_vector& x, const Normal_point& y) { return cross(x, vector(y)); });
      return bernstein(std::move(sum));
    }
  }

  static bool has_no_zero(const Normals& n) {
    std::array<double, 3> direction{};
    for (const Normal_vector& x : n.values())
      for (int l = 0; l < 3; ++l) direction[l] += CGAL::to_double(x[l]);
    return std::all_of(n.values().begin(), n.values().end(), [&](const Normal_vector& x) {
      const Normal_number product =
          Normal_number(direction[0]) * x[0] + Normal_number(direction[1]) * x[1] + Normal_number(direction[2]) * x[2];
      return product.inf() > 0;
    });
  }
};

// The polynomial shape of a surface.
template <class Surface> struct Shape_of { typedef Surface type; };
template <class Shape> struct Shape_of<Rational_surface<Shape>> { typedef Shape type; };

// Takes a patch in space, or one of homogeneous points.
template <class Patch> Interval_net<Normal_point> interval_net(const Patch& s) {
  Interval_net<Normal_point> net(s.degree_u(), s.degree_v());
  for (int i = 0; i <= s.degree_u(); ++i)
    for (int j = 0; j <= s.degree_v(); ++j) {
      const auto c = s.coordinates(i, j);
      net(i, j)[3] = Normal_number(1);
      for (int l = 0; l < c.dimension(); ++l) net(i, j)[l] = Normal_number(CGAL::to_interval(c[l]));
    }
  return net;
}

template <class Patch> std::optional<Parameter_rectangle<typename Patch::FT>> possible_fold_of_patch(const Patch& s) {
  typedef typename Patch::FT FT;
  std::optional<std::array<Range, 2>> found;
  if constexpr (std::is_same_v<typename Shape_of<Patch>::type, Patch>)
    found = Patch_normals<false>::possible_zero(interval_net(s));
  else if (s.is_polynomial())
    found = Patch_normals<false>::possible_zero(interval_net(s.unweighted()));
  else
    found = Patch_normals<true>::possible_zero(interval_net(s.homogeneous()));
  if (!found) return std::nullopt;
  const auto part = [](const std::pair<FT, FT>& domain, const Range& range) {
    const FT length = domain.second - domain.first;
    return std::pair<FT, FT>(FT(domain.first + FT(range.lower) * length), FT(domain.first + FT(range.upper) * length));
  };
  return Parameter_rectangle<FT>{part(s.domain_u(), (*found)[0]), part(s.domain_v(), (*found)[1])};
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns a rectangle of parameters in which the normal \f$ S_u \times S_v \f$ of a surface
/// vanishes or is not proved not to; or nothing, when it is proved that the normal vanishes nowhere
/// on the closed domain. Then the surface has neither folds nor cusps inside of its spans. (It may
/// still meet itself in distant points. `knot_line_continuity()` decides the continuity at knots.)
///
/// A normal that vanishes is always found. Conversely, a rectangle is returned where the normal
/// turns by a right angle, or nearly vanishes, within 1/1024 of a span in each parameter. Points
/// are enclosed by floating-point numbers, with exact kernels as well.
/// \tparam Surface `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface>
std::optional<Parameter_rectangle<typename Surface::FT>> possible_fold(const Surface& surface) {
  static_assert(Surface::N == 0 || Surface::N == 3, "surfaces in dimension 3 have normals");
  if (surface.dimension() != 3) throw Error(Error_code::dimension_mismatch, "possible_fold: in dimension 3 only");
  const internal::Work_guard work("possible_fold");
  std::optional<Parameter_rectangle<typename Surface::FT>> found;
  if constexpr (internal::Surface_shape<typename internal::Shape_of<Surface>::type>::is_spline)
    surface.for_each_bezier_patch([&](const auto& patch) {
      if (!found) found = internal::possible_fold_of_patch(patch);
    });
  else
    found = internal::possible_fold_of_patch(surface);
  return found;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_POSSIBLE_FOLD_H
