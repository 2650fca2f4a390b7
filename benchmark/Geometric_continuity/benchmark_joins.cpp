// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact decisions about joins with double coordinates, against the floating-point test that one
// writes by hand and is not certified, and against the same test in other exact number types. All
// answers are compared before anything is timed.

#include "Ratio_table.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Mpzf.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <Geom_BezierCurve.hxx>
#include <LocalAnalysis_CurveContinuity.hxx>
#include <TColgp_Array1OfPnt.hxx>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef GC::Bezier_curve<Traits, 5> Curve;
typedef Traits::Point Point;

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

template <class FT> bool hand_equal(const FT& x, const FT& y) {
  if constexpr (std::is_floating_point_v<FT>)
    return std::abs(x - y) <= 1e-9 * (std::abs(x) + std::abs(y));
  else
    return x == y;
}
// For doubles, relative to the longer vector.
template <class FT> bool equal_vectors(const Vec<FT>& x, const Vec<FT>& y) {
  if constexpr (std::is_floating_point_v<FT>) {
    const Vec<FT> d = hand_minus(x, y);
    return hand_dot(d, d) <= 1e-18 * (hand_dot(x, x) + hand_dot(y, y));
  } else
    return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}

template <class FT> struct Legs { Vec<FT> point, d1, d2, d3; };
template <class FT> Vec<FT> coordinates(const Point& p) { return {FT(p.x()), FT(p.y()), FT(p.z())}; }
template <class FT> Legs<FT> end_of(const Curve& c) {
  const Vec<FT> p0 = coordinates<FT>(c.control_point(5)), p1 = coordinates<FT>(c.control_point(4)),
                p2 = coordinates<FT>(c.control_point(3)), p3 = coordinates<FT>(c.control_point(2));
  const Vec<FT> a = hand_minus(p0, p1), b = hand_minus(p1, p2), e = hand_minus(a, b);
  return {p0, a, e, hand_minus(e, hand_minus(b, hand_minus(p2, p3)))};
}
template <class FT> Legs<FT> start_of(const Curve& c) {
  const Vec<FT> p0 = coordinates<FT>(c.control_point(0)), p1 = coordinates<FT>(c.control_point(1)),
                p2 = coordinates<FT>(c.control_point(2)), p3 = coordinates<FT>(c.control_point(3));
  const Vec<FT> a = hand_minus(p1, p0), b = hand_minus(p2, p1), e = hand_minus(b, a);
  return {p0, a, e, hand_minus(hand_minus(hand_minus(p3, p2), b), e)};
}

// G1: g Y' = a X', a > 0. G2: g^3 (Y' x Y'') = a^3 (X' x X''). F3: g^6 det Y = a^6 det X.
template <bool torsion, class FT> bool by_hand(const Curve& left, const Curve& right) {
  const Legs<FT> x = end_of<FT>(left), y = start_of<FT>(right);
  if (!(x.point[0] == y.point[0] && x.point[1] == y.point[1] && x.point[2] == y.point[2])) return false;
  const FT g = hand_dot(x.d1, x.d1), a = hand_dot(x.d1, y.d1);
  if (!(FT(0) < a)) return false;
  if (!equal_vectors<FT>({FT(g * y.d1[0]), FT(g * y.d1[1]), FT(g * y.d1[2])},
                         {FT(a * x.d1[0]), FT(a * x.d1[1]), FT(a * x.d1[2])}))
    return false;
  const Vec<FT> n = hand_cross(x.d1, x.d2), o = hand_cross(y.d1, y.d2);
  const FT g3 = FT(g * g * g), a3 = FT(a * a * a);
  if (!equal_vectors<FT>({FT(g3 * o[0]), FT(g3 * o[1]), FT(g3 * o[2])}, {FT(a3 * n[0]), FT(a3 * n[1]), FT(a3 * n[2])}))
    return false;
  return !torsion || hand_equal<FT>(FT(g3 * g3 * hand_dot(o, y.d3)), FT(a3 * a3 * hand_dot(n, x.d3)));
}

// ---------------------------------------------------------------- input

enum Class { holds, off_by_one, grossly_off };
const char* const class_names[] = {"holds", "off by one unit", "grossly off"};

struct Input {
  std::vector<Curve> left;
  std::array<std::vector<Curve>, 3> right;
};

// Joins with coordinates of about 45 bits on a grid 2^-45 that are F3; beta_1 = p/q.
const Input& input() {
  static const Input result = [] {
    Input in;
    std::mt19937_64 engine(2026);
    const auto whole = [&](int bits) {
      return static_cast<double>(static_cast<std::int64_t>(engine() >> (64 - bits)) - (std::int64_t(1) << (bits - 1)));
    };
    for (int k = 0; k < 512; ++k) {
      const int q = 1 + static_cast<int>(engine() % 8), p = 1 + static_cast<int>(engine() % 15);
      std::array<double, 3> start, a1, a2, a3, b1, b2, b3;
      const double c[6] = {whole(8), whole(8), whole(8), whole(8), whole(4), whole(4)};
      for (int i = 0; i < 3; ++i) {
        const double x = whole(33), y = whole(30), z = whole(26);
        start[i] = whole(43);
        a1[i] = q * x;
        b1[i] = p * x;
        a2[i] = q * q * y + c[0] * x;
        b2[i] = p * p * y + c[1] * x;
        a3[i] = q * q * q * z + c[2] * x + c[4] * y;
        b3[i] = p * p * p * z + c[3] * x + c[5] * y;
      }
      const auto polygon = [&](const auto& d1, const auto& d2, const auto& d3, double sign) {
        std::array<std::array<double, 3>, 6> x{};
        for (int i = 0; i < 3; ++i) {
          x[0][i] = start[i];
          x[1][i] = start[i] + sign * d1[i];
          x[2][i] = start[i] + 2 * sign * d1[i] + d2[i];
          x[3][i] = start[i] + 3 * sign * d1[i] + 3 * d2[i] + sign * d3[i];
        }
        return x;
      };
      const auto curve = [&](const std::array<std::array<double, 3>, 6>& x, bool reversed) {
        std::array<Point, 6> points;
        for (int j = 0; j < 6; ++j) {
          const std::array<double, 3>& c = x[reversed ? 5 - j : j];
          points[j] = Point(0x1p-45 * c[0], 0x1p-45 * c[1], 0x1p-45 * c[2]);
        }
        return Curve(points.begin(), points.end());
      };
      in.left.push_back(curve(polygon(a1, a2, a3, -1), true));
      std::array<std::array<double, 3>, 6> right = polygon(b1, b2, b3, 1);
      in.right[holds].push_back(curve(right, false));
      right[2][1] += 1;
      right[3][2] += 1;
      in.right[off_by_one].push_back(curve(right, false));
      right[2][1] += 0x1p45;
      right[3][2] += 0x1p45;
      in.right[grossly_off].push_back(curve(right, false));
    }
    return in;
  }();
  return result;
}

// ---------------------------------------------------------------- what is timed

typedef bool (*On_curves)(const Curve&, const Curve&);
struct Method {
  const char* name;
  On_curves g2, f3;
};
typedef CGAL::Exact_predicates_exact_constructions_kernel::FT Lazy;
const Method methods[] = {
    {"by hand, double, not certified", by_hand<false, double>, by_hand<true, double>},
    {"filtered, from doubles", [](const Curve& x, const Curve& y) { return GC::is_g2_join(x, y); },
     [](const Curve& x, const Curve& y) { return GC::is_f3_join(x, y); }},
    {"by hand, Mpzf", by_hand<false, CGAL::Mpzf>, by_hand<true, CGAL::Mpzf>},
    {"by hand, Exact_rational", by_hand<false, CGAL::Exact_rational>, by_hand<true, CGAL::Exact_rational>},
    {"by hand, number type of Epeck", by_hand<false, Lazy>, by_hand<true, Lazy>}};

void compare_answers() {
  const Input& in = input();
  for (int c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < in.left.size(); ++k)
      for (const Method& m : methods) {
        if (m.g2 == methods[0].g2) continue; // which may be wrong
        const bool same = m.g2(in.left[k], in.right[c][k]) == (c == holds) &&
                          m.f3(in.left[k], in.right[c][k]) == (c == holds) &&
                          (GC::continuity(in.left[k], in.right[c][k]).f_order == 3) == (c == holds);
        if (!same) {
          std::cerr << m.name << ": wrong answer, " << class_names[c] << ", join " << k << '\n';
          std::exit(1);
        }
      }
}

template <class Function> void time_joins(benchmark::State& state, Function decide) {
  const std::size_t n = input().left.size();
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(decide(k));
    if (++k == n) k = 0;
  }
}

// Pairs of curves next to each other in memory.
struct Pairs {
  std::vector<Curve> left, right;
  explicit Pairs(std::size_t n) {
    const Input& in = input();
    left.reserve(n);
    right.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
      left.push_back(in.left[k % in.left.size()]);
      right.push_back(in.right[holds][k % in.left.size()]);
    }
  }
};

template <class Concurrency_tag> void verify(benchmark::State& state, const Pairs& pairs) {
  const auto is_f3 = [](const Curve& left, const Curve& right) { return GC::is_f3_join(left, right); };
  for (auto _ : state)
    if (!GC::failing_joins<Concurrency_tag>(pairs.left.begin(), pairs.left.end(), pairs.right.begin(),
                                            pairs.right.end(), is_f3)
             .empty())
      state.SkipWithError("wrong answer");
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * pairs.left.size()));
}

// 512 joins that stay in the cache, against 10^7 joins in one pass over 3 GiB of curves.
void register_passes() {
  const std::string title = "F3, holds, many joins | ";
  const auto many = []() -> const Pairs& {
    static const Pairs pairs(10000000);
    return pairs;
  };
  const auto add = [&](const char* name, auto run) {
    benchmark::RegisterBenchmark((title + name).c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  add("512 again and again, one core",
      [](benchmark::State& state) { verify<CGAL::Sequential_tag>(state, Pairs(512)); });
  add("10^7 in one pass, one core", [=](benchmark::State& state) { verify<CGAL::Sequential_tag>(state, many()); });
#ifdef CGAL_LINKED_WITH_TBB
  add("10^7 in one pass, two cores", [=](benchmark::State& state) {
    tbb::task_arena two_cores(2);
    two_cores.execute([&] { verify<CGAL::Parallel_tag>(state, many()); });
  });
#endif
}

// Joins of each class for the same left curves: the right one continues the left one as C3, and
// then one control point is moved, that of the first order that shall not hold.
void register_all_orders() {
  static const char* const names[] = {"gap", "C0", "C1 G1", "C2 G2", "C3 G3 F3"};
  static std::array<std::vector<Curve>, 5> right;
  const std::vector<Curve>& left = input().left;
  for (int order = -1; order <= 3; ++order)
    for (const Curve& x : left) {
      std::array<std::array<double, 3>, 6> y{};
      for (int i = 0; i < 3; ++i) {
        const double a = x.control_point(5)[i], b = x.control_point(4)[i], c = x.control_point(3)[i],
                     d = x.control_point(2)[i];
        y[0][i] = a;
        y[1][i] = 2 * a - b;
        y[2][i] = 4 * a - 4 * b + c;
        y[3][i] = 8 * a - 12 * b + 6 * c - d;
      }
      if (order < 3) y[order + 1][1] += 0x1p-10;
      std::array<Point, 6> points;
      for (int j = 0; j < 6; ++j) points[j] = Point(y[j][0], y[j][1], y[j][2]);
      right[order + 1].push_back(Curve(points.begin(), points.end()));
    }
  for (int order = -1; order <= 3; ++order) {
    const std::vector<Curve>& y = right[order + 1];
    for (std::size_t k = 0; k < left.size(); ++k) {
      const auto join = GC::continuity(left[k], y[k]);
      if (join.c_order != order || join.g_order != order || join.f_order != order) {
        std::cerr << "continuity: wrong answer, " << names[order + 1] << ", join " << k << ": " << join << '\n';
        std::exit(1);
      }
    }
    const std::string title = std::string("all orders and flags, ") + names[order + 1] + " | ";
    benchmark::RegisterBenchmark((title + "is_f3_join and is_g3_join").c_str(), [&](benchmark::State& state) {
      time_joins(state, [&](std::size_t k) {
        return GC::is_f3_join(input().left[k], y[k]) + 2 * GC::is_g3_join(input().left[k], y[k]);
      });
    });
    benchmark::RegisterBenchmark((title + "continuity").c_str(), [&](benchmark::State& state) {
      time_joins(state, [&](std::size_t k) { return GC::continuity(input().left[k], y[k]).g_order; });
    });
  }
}

// 10^6 cubics in space that meet C2, the pieces of a uniform B-spline curve, or C1.
void register_chains() {
  typedef GC::Bezier_curve<Traits, 3> Cubic;
  constexpr int size = 1000000;
  for (const int order : {1, 2}) {
    const auto run = [order](benchmark::State& state) {
      std::mt19937_64 engine(2026);
      const auto random = [&] { return 6 * 0x1p-40 * static_cast<double>(engine() >> 24); };
      std::array<std::array<double, 3>, 4> d;
      for (std::array<double, 3>& x : d) x = {random(), random(), random()};
      std::vector<Cubic> chain;
      for (int k = 0; k < size; ++k) {
        std::array<std::array<double, 3>, 4> x;
        for (int i = 0; i < 3; ++i) {
          x[0][i] = (d[0][i] + 4 * d[1][i] + d[2][i]) / 6;
          x[1][i] = order == 2 ? (2 * d[1][i] + d[2][i]) / 3 : x[0][i] + (d[2][i] - d[0][i]) / 2;
          x[3][i] = (d[1][i] + 4 * d[2][i] + d[3][i]) / 6;
          x[2][i] = order == 2 ? (d[1][i] + 2 * d[2][i]) / 3 : x[3][i] - (d[3][i] - d[1][i]) / 2;
        }
        std::array<Point, 4> points;
        for (int j = 0; j < 4; ++j) points[j] = Point(x[j][0], x[j][1], x[j][2]);
        chain.push_back(Cubic(points.begin(), points.end()));
        std::rotate(d.begin(), d.begin() + 1, d.end());
        d[3] = {random(), random(), random()};
      }
      for (auto _ : state)
        if (GC::chain_continuity(chain.begin(), chain.end()).counts(GC::Continuity_kind::C).at(order) != size - 1)
          state.SkipWithError("wrong answer");
      state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * (size - 1)));
    };
    const std::string name = "a chain of 10^6 cubics, C" + std::to_string(order) + " | chain_continuity, up to order 3";
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  }
}

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
// OpenCASCADE offers these checks of G2, with tolerances: they accept the joins that are off by one
// unit as well.
struct Occt_curves {
  std::vector<Handle(Geom_BezierCurve)> left;
  std::array<std::vector<Handle(Geom_BezierCurve)>, 3> right;

  Occt_curves() {
    const Input& in = input();
    for (const Curve& c : in.left) left.push_back(curve(c));
    for (int j = 0; j < 3; ++j)
      for (const Curve& c : in.right[j]) right[j].push_back(curve(c));
    for (std::size_t k = 0; k < left.size(); ++k)
      if (!is_g2(k, holds) || is_g2(k, grossly_off)) {
        std::cerr << "OpenCASCADE: wrong answer, join " << k << '\n';
        std::exit(1);
      }
  }
  static Handle(Geom_BezierCurve) curve(const Curve& c) {
    TColgp_Array1OfPnt poles(1, 6);
    for (int j = 0; j < 6; ++j)
      poles(j + 1) = gp_Pnt(c.control_point(j).x(), c.control_point(j).y(), c.control_point(j).z());
    return new Geom_BezierCurve(poles);
  }
  bool is_g2(std::size_t k, int c) const {
    const double small = 1e-9;
    const LocalAnalysis_CurveContinuity analysis(left[k], 1, right[c][k], 0, GeomAbs_G2, small, small, small, small,
                                                 small, small, small);
    return analysis.IsDone() && analysis.IsG2();
  }
};
#endif

int main(int argc, char** argv) {
  compare_answers();
  for (const bool torsion : {false, true})
    for (int c = 0; c < 3; ++c) {
      const std::string title = std::string(torsion ? "F3" : "G2") + ", " + class_names[c] + " | ";
      for (const Method& m : methods) {
        const On_curves decide = torsion ? m.f3 : m.g2;
        benchmark::RegisterBenchmark((title + m.name).c_str(), [=](benchmark::State& state) {
          time_joins(state, [&](std::size_t k) { return decide(input().left[k], input().right[c][k]); });
        });
      }
      if (torsion) {
        benchmark::RegisterBenchmark((title + "filtered, and is_g3_join").c_str(), [=](benchmark::State& state) {
          const Input& in = input();
          time_joins(state, [&](std::size_t k) {
            return GC::is_f3_join(in.left[k], in.right[c][k]) + 2 * GC::is_g3_join(in.left[k], in.right[c][k]);
          });
        });
        benchmark::RegisterBenchmark(
            (title + "continuity: all orders and flags").c_str(), [=](benchmark::State& state) {
              const Input& in = input();
              time_joins(state, [&](std::size_t k) { return GC::continuity(in.left[k], in.right[c][k]).f_order; });
            });
      }
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
      static const Occt_curves occt;
      if (!torsion)
        benchmark::RegisterBenchmark((title + "OpenCASCADE, with tolerances").c_str(), [=](benchmark::State& state) {
          time_joins(state, [&](std::size_t k) { return occt.is_g2(k, c); });
        });
#endif
    }
  register_all_orders();
  register_chains();
  register_passes();
  return run_benchmarks(argc, argv);
}
