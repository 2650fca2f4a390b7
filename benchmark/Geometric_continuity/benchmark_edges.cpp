// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact decisions about whole edges of bicubic patches with double coordinates, against the test at
// samples in floating-point arithmetic that one writes by hand and is not certified, and against
// the same test in exact number types, with so many samples that it is a proof; and whole models,
// against the decisions on their shared edges one by one in multi-precision. All answers are
// compared before anything is timed.

#include "Ratio_table.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef GC::Bezier_patch<Traits> Patch;
typedef Traits::Point Point;
constexpr GC::Patch_edge v0 = GC::Patch_edge::v0;

// ------------------------------------------------------------ the test by hand, in any number type

template <class FT> using Vec = std::array<FT, 3>;
template <class FT> Vec<FT> hand_minus(const Vec<FT>& x, const Vec<FT>& y) {
  return {FT(x[0] - y[0]), FT(x[1] - y[1]), FT(x[2] - y[2])};
}
template <class FT> FT hand_dot(const Vec<FT>& x, const Vec<FT>& y) {
  return FT(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
}
template <class FT> Vec<FT> hand_cross(const Vec<FT>& x, const Vec<FT>& y) {
  return {FT(x[1] * y[2] - x[2] * y[1]), FT(x[2] * y[0] - x[0] * y[2]), FT(x[0] * y[1] - x[1] * y[0])};
}

template <class FT> FT tolerance() { return std::is_floating_point_v<FT> ? FT(1e-9) : FT(0); }
template <class FT> FT size(const FT& x) { return x < FT(0) ? FT(-x) : x; }

// The cubic Bernstein polynomials and those of degree 2 and 1 at the samples.
template <class FT> struct Basis { FT b3[4], b2[3], b1[2]; };
template <class FT> const std::vector<Basis<FT>>& bases(int samples) {
  static const auto make = [](int n) {
    std::vector<Basis<FT>> result;
    for (int k = 0; k < n; ++k) {
      const FT t = FT(FT(k) / FT(n - 1)), s = FT(FT(1) - t);
      result.push_back({{FT(s * s * s), FT(FT(3) * s * s * t), FT(FT(3) * s * t * t), FT(t * t * t)},
                        {FT(s * s), FT(FT(2) * s * t), FT(t * t)},
                        {s, t}});
    }
    return result;
  };
  static const std::vector<Basis<FT>> nine = make(9), nineteen = make(19);
  return samples == 9 ? nine : nineteen;
}
template <class FT, std::size_t n> Vec<FT> value(const FT (&basis)[n], const Vec<FT>* c) {
  Vec<FT> v;
  for (int x = 0; x < 3; ++x) {
    v[x] = FT(basis[0] * c[0][x]);
    for (std::size_t i = 1; i < n; ++i) v[x] = FT(v[x] + basis[i] * c[i][x]);
  }
  return v;
}

template <class FT> Vec<FT> coordinates(const Patch& s, int i, int j) {
  const Point& p = s.control_point(i, j);
  return {FT(p.x()), FT(p.y()), FT(p.z())};
}

// G1: n1 = C' x T1 and n2 = C' x T2 opposite. G2: T2 = p C' + q T1 and n1.W2 = p^2 n1.C'' + 2 p q
// n1.T1' + q^2 n1.W1. The determinant has degree 8 and the identity, times the square of a
// coordinate of n1, degree 18.
template <int order, class FT> bool by_hand(const Patch& a, const Patch& b) {
  constexpr bool certified = !std::is_floating_point_v<FT>;
  Vec<FT> c[4], d[3], e[2], t1[4], t2[4], f[3], w1[4], w2[4];
  for (int i = 0; i < 4; ++i) {
    c[i] = coordinates<FT>(a, i, 0);
    if (!(c[i] == coordinates<FT>(b, i, 0))) return false;
    t1[i] = hand_minus(coordinates<FT>(a, i, 1), c[i]);
    t2[i] = hand_minus(coordinates<FT>(b, i, 1), c[i]);
  }
  for (int i = 0; i < 3; ++i) {
    d[i] = hand_minus(c[i + 1], c[i]);
    f[i] = hand_minus(t1[i + 1], t1[i]);
  }
  if (order == 2) {
    for (int i = 0; i < 2; ++i) e[i] = hand_minus(d[i + 1], d[i]);
    for (int i = 0; i < 4; ++i) {
      w1[i] = hand_minus(hand_minus(coordinates<FT>(a, i, 2), coordinates<FT>(a, i, 1)), t1[i]);
      w2[i] = hand_minus(hand_minus(coordinates<FT>(b, i, 2), coordinates<FT>(b, i, 1)), t2[i]);
    }
  }
  for (const Basis<FT>& basis : bases<FT>(certified && order == 2 ? 19 : 9)) {
    const Vec<FT> dt = value(basis.b2, d), a1 = value(basis.b3, t1), a2 = value(basis.b3, t2), n1 = hand_cross(dt, a1),
                  n2 = hand_cross(dt, a2), sine = hand_cross(n1, n2);
    const FT n11 = hand_dot(n1, n1), n12 = hand_dot(n1, n2);
    if (!(n12 < FT(0))) return false;
    if (tolerance<FT>() * tolerance<FT>() * n11 * hand_dot(n2, n2) < hand_dot(sine, sine)) return false;
    if (order == 2) { // with C'' = 6 e, T1' = 9 f, C' = 3 d, T = 3 t, W = 6 w
      const FT q = FT(n12 / n11), p = FT(hand_dot(hand_cross(a2, a1), n1) / n11);
      const FT left = FT(FT(6) * hand_dot(n1, value(basis.b3, w2))),
               right = FT(FT(6) * p * p * hand_dot(n1, value(basis.b1, e)) +
                          FT(18) * p * q * hand_dot(n1, value(basis.b2, f)) +
                          FT(6) * q * q * hand_dot(n1, value(basis.b3, w1)));
      if (tolerance<FT>() * (size(left) + size(right)) < size(FT(left - right))) return false;
    }
  }
  return true;
}

// ---------------------------------------------------------------- input

enum Class { holds, off_by_one, grossly_off };
const char* const class_names[] = {"holds", "off by one unit", "grossly off"};

struct Input {
  std::vector<Patch> first;
  std::array<std::vector<Patch>, 3> second[3]; // [order][class]
};

// Bicubic patches with whole coordinates of about 50 bits that are G2, with T2 = p C' + q T1 for a
// linear p.
const Input& input() {
  static const Input result = [] {
    Input in;
    std::mt19937_64 engine(2026);
    const auto whole = [&](int most) {
      return static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(2 * most + 1)) - most;
    };
    typedef std::array<std::array<std::int64_t, 3>, 4> Cubic; // coefficients of 1, t, t^2, t^3
    for (int k = 0; k < 256; ++k) {
      Cubic c{}, t1{}, w1{}, t2{}, w2{};
      const std::int64_t p0 = whole(2), p1 = whole(2), q = -(1 + std::abs(whole(2))), r = whole(3), s = whole(3);
      for (int x = 0; x < 3; ++x) {
        for (int i = 0; i < 4; ++i) c[i][x] = whole(9);
        for (int i = 0; i < 3; ++i) {
          t1[i][x] = whole(9);
          w1[i][x] = whole(9);
        }
      }
      c[1][0] += 60;
      t1[0][1] += 60;
      for (int x = 0; x < 3; ++x) {
        const std::int64_t d[3] = {c[1][x], 2 * c[2][x], 3 * c[3][x]}, e[2] = {d[1], 2 * d[2]},
                           f[2] = {t1[1][x], 2 * t1[2][x]};
        for (int i = 0; i < 4; ++i) {
          const auto at = [i](const auto& y, int shift) { // the coefficient of t^i in t^shift y
            const int j = i - shift;
            return 0 <= j && j < static_cast<int>(std::size(y)) ? y[j] : std::int64_t(0);
          };
          const std::int64_t t1_i = i < 3 ? t1[i][x] : 0;
          t2[i][x] = p0 * at(d, 0) + p1 * at(d, 1) + q * t1_i;
          w2[i][x] = p0 * p0 * at(e, 0) + 2 * p0 * p1 * at(e, 1) + p1 * p1 * at(e, 2) + 2 * p0 * q * at(f, 0) +
                     2 * p1 * q * at(f, 1) + q * q * w1[i][x] + r * at(d, 0) + s * t1_i;
        }
      }
      const double unit = static_cast<double>(engine() >> 32 | 1);
      typedef std::array<std::array<std::array<double, 3>, 4>, 4> Net;
      const auto net = [&](const Cubic& t, const Cubic& w) {
        const auto bernstein = [](const Cubic& y, int i, int x) { // times 3
          return 3 * y[0][x] + i * y[1][x] + (i == 2 ? y[2][x] : i == 3 ? 3 * y[2][x] : 0) + (i == 3 ? 3 * y[3][x] : 0);
        };
        Net b;
        for (int i = 0; i < 4; ++i)
          for (int x = 0; x < 3; ++x) { // times 18
            const double p = 6 * bernstein(c, i, x), dt = 2 * bernstein(t, i, x), dw = bernstein(w, i, x);
            b[i][0][x] = unit * p;
            b[i][1][x] = unit * (p + dt);
            b[i][2][x] = unit * (p + 2 * dt + dw);
            b[i][3][x] = unit * static_cast<double>(whole(1000));
          }
        return b;
      };
      const auto patch = [](const Net& b) {
        std::vector<std::vector<Point>> points;
        for (const auto& row : b) {
          points.emplace_back();
          for (const auto& x : row) points.back().emplace_back(x[0], x[1], x[2]);
        }
        return Patch(points);
      };
      in.first.push_back(patch(net(t1, w1)));
      const Net second = net(t2, w2);
      for (int order : {1, 2}) {
        const int i = static_cast<int>(engine() % 4);
        Net moved = second;
        in.second[order][holds].push_back(patch(moved));
        moved[i][order][2] += 1;
        in.second[order][off_by_one].push_back(patch(moved));
        for (auto& row : moved) row[order][2] += unit * static_cast<double>(50 + whole(49));
        in.second[order][grossly_off].push_back(patch(moved));
      }
    }
    return in;
  }();
  return result;
}

// ---------------------------------------------------------------- what is timed

typedef bool (*Decision)(const Patch&, const Patch&);
struct Method {
  const char* name;
  Decision g1, g2;
};
typedef CGAL::Exact_predicates_exact_constructions_kernel::FT Lazy;

// The last stage alone: it does not compare the edges, which are the same.
template <int order> bool in_multiprecision(const Patch& a, const Patch& b) {
  const GC::Edge_conditions<CGAL::Exact_rational> conditions(GC::edge_rows(a, v0), GC::edge_rows(b, v0));
  return order == 1 ? conditions.g1() : conditions.g2();
}
template <int order> bool in_a_report(const Patch& a, const Patch& b) {
  return GC::edge_continuity(a, v0, b, v0).g_order >= order;
}
const Method methods[] = {
    {"by hand at 9 samples, double, not certified", by_hand<1, double>, by_hand<2, double>},
    {"filtered", [](const Patch& a, const Patch& b) { return GC::is_g1_edge(a, v0, b, v0); },
     [](const Patch& a, const Patch& b) { return GC::is_g2_edge(a, v0, b, v0); }},
    {"Edge_conditions, multi-precision", in_multiprecision<1>, in_multiprecision<2>},
    {"edge_continuity(), with reasons and angles", in_a_report<1>, in_a_report<2>},
    {"by hand at 9 or 19 samples, Exact_rational", by_hand<1, CGAL::Exact_rational>, by_hand<2, CGAL::Exact_rational>},
    {"by hand at 9 or 19 samples, number type of Epeck", by_hand<1, Lazy>, by_hand<2, Lazy>}};

void compare_answers() {
  const Input& in = input();
  for (int order : {1, 2})
    for (int c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < in.first.size(); ++k)
        for (const Method& m : methods) {
          if (&m == &methods[0] && c == off_by_one) continue; // which is wrong
          if ((order == 1 ? m.g1 : m.g2)(in.first[k], in.second[order][c][k]) == (c == holds)) continue;
          std::cerr << m.name << ": wrong answer, order " << order << ", " << class_names[c] << ", edge " << k << '\n';
          std::exit(1);
        }
}

// ---------------------------------------------------------------- models

typedef CGAL::Exact_rational Q;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Rational;

// Bicubic, cut into n x n surfaces of 4 x 4 spans, with whole coordinates.
std::vector<GC::Bspline_surface<Rational>> rational_model(int n) {
  typedef GC::Bspline_surface<Rational> Surface;
  typedef GC::Knot_vector<Q> Knots;
  std::mt19937 engine(2026);
  const auto whole = [&](int most) { return Q(static_cast<int>(engine() % static_cast<unsigned>(most))); };
  const auto knots = [](int first, int last) {
    std::vector<Q> u(4, Q(first));
    for (int k = first + 1; k < last; ++k) u.emplace_back(k);
    u.insert(u.end(), 4, Q(last));
    return Knots(3, u);
  };
  const Knots all = knots(0, 4 * n);
  std::vector<std::vector<Rational::Point>> net(all.number_of_coefficients());
  for (int i = 0; i < all.number_of_coefficients(); ++i)
    for (int j = 0; j < all.number_of_coefficients(); ++j)
      net[i].emplace_back(1296 * (Q(10 * i) + whole(5)), 1296 * (Q(10 * j) + whole(5)), 1296 * whole(50));
  Surface s(net, all, all);
  for (int k = 1; k < n; ++k) s = s.insert_u(4 * k, 2).insert_v(4 * k, 2);
  std::vector<Surface> model;
  for (int i = 0; i < n; ++i) // six control points further on for each cut
    for (int j = 0; j < n; ++j) {
      std::vector<std::vector<Rational::Point>> part(7);
      for (int k = 0; k < 7; ++k)
        for (int l = 0; l < 7; ++l) part[k].push_back(s.control_point(6 * i + k, 6 * j + l));
      model.emplace_back(part, knots(4 * i, 4 * i + 4), knots(4 * j, 4 * j + 4));
    }
  return model;
}

std::vector<GC::Bspline_surface<Traits>> on_doubles(const std::vector<GC::Bspline_surface<Rational>>& model) {
  const auto number = [](const Q& x) {
    const double y = CGAL::to_double(x);
    if (Q(y) != x) throw std::logic_error("the model is not one of doubles");
    return y;
  };
  const auto knots = [&](const GC::Knot_vector<Q>& v) {
    std::vector<double> u;
    for (const Q& x : v) u.push_back(number(x));
    return GC::Knot_vector<double>(v.degree(), u);
  };
  std::vector<GC::Bspline_surface<Traits>> result;
  for (const auto& s : model) {
    std::vector<std::vector<Point>> net(s.number_of_points_u());
    for (int i = 0; i < s.number_of_points_u(); ++i)
      for (int j = 0; j < s.number_of_points_v(); ++j) {
        const auto& p = s.control_point(i, j);
        net[i].emplace_back(number(p.x()), number(p.y()), number(p.z()));
      }
    result.emplace_back(net, knots(s.knots_u()), knots(s.knots_v()));
  }
  return result;
}

// The Bezier patches of all surfaces.
template <class Surface> auto in_patches(const std::vector<Surface>& model) {
  std::vector<GC::Bezier_patch<typename Surface::Traits>> patches;
  for (const Surface& s : model)
    for (const auto& patch : s.bezier_patches()) patches.push_back(patch);
  return patches;
}

// Each shared edge of patches in multi-precision, when they are known: not recognised, and without
// reasons.
template <class Patches, class Model> std::size_t smooth_one_by_one(const Patches& patches, const Model& model) {
  std::size_t smooth = 0;
  for (const auto& e : model.edges) {
    if (e.kind != GC::Model_edge_kind::shared) continue;
    const auto a = edge_rows(patches[e.patch_a], e.edge_a), b = edge_rows(patches[*e.patch_b], *e.edge_b);
    smooth += GC::Edge_conditions<Q>(a, e.continuity.reversed ? b.reversed() : b).g2();
  }
  return smooth;
}

template <class Model> void register_model(const std::string& title, const Model& model, std::size_t edges) {
  if (GC::model_continuity(model).summary.g2 != edges) {
    std::cerr << title << ": wrong answer\n";
    std::exit(1);
  }
  benchmark::RegisterBenchmark(title.c_str(), [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(GC::model_continuity(model).summary.g2);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(edges));
  });
}

void register_models() {
  const auto rational = rational_model(4);
  const auto rational_patches = in_patches(rational);
  const auto doubles = on_doubles(rational);
  std::vector<GC::Bspline_surface<Rational>> as_surfaces;
  for (const auto& patch : rational_patches) as_surfaces.emplace_back(patch);
  const auto patches = in_patches(on_doubles(as_surfaces));
  const std::string model = "an edge of a model of 16 B-spline surfaces, 4 spans | ",
                    small = "an edge of a model of 256 patches | ";
  constexpr std::size_t model_edges = 24, small_edges = 480;
  const auto known = GC::model_continuity(patches);
  if (smooth_one_by_one(patches, known) != small_edges) {
    std::cerr << small << ": wrong answer\n";
    std::exit(1);
  }
  register_model(model + "double", doubles, model_edges);
  register_model(model + "Exact_rational", rational, model_edges);
  register_model(small + "double", patches, small_edges);
  register_model(small + "Exact_rational", rational_patches, small_edges);
  const std::string alone = small + "Edge_conditions, edges known, multi-precision";
  benchmark::RegisterBenchmark(alone.c_str(), [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(smooth_one_by_one(patches, known));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(small_edges));
  });
}

int main(int argc, char** argv) {
  compare_answers();
  register_models();
  for (int order : {1, 2})
    for (int c = 0; c < 3; ++c)
      for (const Method& m : methods) {
        const Decision decide = order == 1 ? m.g1 : m.g2;
        const std::string title = "G" + std::to_string(order) + ", " + class_names[c] + " | " + m.name;
        benchmark::RegisterBenchmark(title.c_str(), [=](benchmark::State& state) {
          const std::vector<Patch>&a = input().first, &b = input().second[order][c];
          std::size_t k = 0;
          for (auto _ : state) {
            benchmark::DoNotOptimize(decide(a[k], b[k]));
            if (++k == a.size()) k = 0;
          }
        });
      }
  return run_benchmarks(argc, argv);
}
