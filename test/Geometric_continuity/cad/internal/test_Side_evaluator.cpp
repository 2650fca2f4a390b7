// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The Taylor models of points, normals and curvatures along an edge enclose their values, also on
// ranges that are so wide that what the polynomials leave out is large; and they are narrow on
// those that are not.

#include "support/cad_sides.h"
#include "support/sampled_edges.h"

#include <CGAL/Geometric_continuity/cad/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/cad/internal/Side_evaluator.h>

BOOST_AUTO_TEST_SUITE(Side_evaluator)

std::mt19937 random_bits;

double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_bits); }

template <int D> GC::Cad_spline_curve<D> bezier(int degree, bool rational, double size) {
  GC::Cad_spline_curve<D> c{degree, clamped(degree), {}, {}};
  for (int i = 0; i <= degree; ++i) {
    GC::Cad_point<D> p;
    for (int k = 0; k < D; ++k) p[k] = k == 0 ? size * i / degree : between(0.2, 0.8);
    c.points.push_back(p);
    if (rational) c.weights.push_back(between(0.5, 2));
  }
  return c;
}
GC::Cad_spline_surface patch(int p, int q, bool rational) {
  GC::Cad_spline_surface s{p, q, clamped(p), clamped(q), {}, {}};
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) {
      s.points.push_back({double(i) / p, double(j) / q + between(-0.05, 0.05), between(-0.3, 0.3)});
      if (rational) s.weights.push_back(between(0.5, 2));
    }
  return s;
}

// How often a value lies outside of what is known on the range [first, last], whether that is
// close, and whether the length of the normal, by which is divided, changes little there.
struct Outside {
  int outside = 0, known = 0;
  double r = 0;
  bool steady = true;

  Outside(const GC::Edge_side& side, double first, double last) {
    std::vector<GC::internal::Side_models> models;
    const GC::internal::Edge_range range(first, last);
    {
      const CGAL::Protect_FPU_rounding<true> upwards;
      models = GC::internal::Side_evaluator(side).models(range, GC::internal::Edge_quantity::curvature);
    }
    if (models.empty()) return;
    const GC::internal::Side_models& m = models.front();
    const auto check = [&](const GC::internal::Taylor_model& f, long double s, long double value) {
      if (!f.known()) return;
      ++known;
      long double y = 0;
      for (int k = GC::internal::Taylor_model::size - 1; k >= 0; --k) y = y * s + f.c[k];
      r = (std::max)(r, f.r);
      outside += !(std::fabs(y - value) <= f.r + 1e-17L * (1 + std::fabs(value)));
    };
    long double shortest = HUGE_VALL, longest = 0;
    for (int i = 0; i <= 10; ++i) {
      const double t = i == 10 ? last : first + i * ((last - first) / 10);
      const long double s = ((long double)t - range.middle) / range.half;
      const auto p = sampled_edges::sampled_side<long double>(side, t).p;
      const sampled_edges::Normal_and_curvature n = sampled_edges::normal_and_curvature(side, t);
      for (int k = 0; k < 3; ++k) {
        check(m.point[k], s, p[k].f);
        check(m.normal[k], s, n.n[k]);
      }
      check(m.curvature, s, n.curvature);
      shortest = (std::min)(shortest, n.length);
      longest = (std::max)(longest, n.length);
    }
    steady = longest <= 1.25L * shortest;
  }
};

// The range of a coordinate that turns back holds its values and little else; where numbers are so
// large that sums of them might overflow, nothing is known.
BOOST_AUTO_TEST_CASE(ranges_of_coordinates) {
  typedef GC::Cad_conic<2> Conic;
  const CGAL::Protect_FPU_rounding<true> upwards;
  const auto models = [](const GC::Cad_curve<2>& curve, const GC::internal::Edge_range& range) {
    constexpr int n = GC::internal::Taylor_model::size;
    const auto jet = [&](const GC::internal::Interval& t, int order) {
      return GC::internal::cad_curve_jet(curve, t, order, 0);
    };
    const auto first = jet(range.t.inf(), 0).c[0][0], last = jet(range.t.sup(), 0).c[0][0];
    return GC::internal::Coordinate_models(jet(range.middle, n), jet(range.t, n + 1), hull(first, last), 0, range.half);
  };
  const GC::internal::Edge_range range(-0.5, 0.25);
  for (const double size : {1., 100.}) {
    const Conic parabola{// x = 100 size + t^2 / (4 size)
                         Conic::Kind::parabola, {100 * size, 0}, {1, 0}, {0, 1}, size, 0};
    const GC::internal::Coordinate_models x = models(parabola, range);
    BOOST_TEST((x.range.inf() <= 100 * size && 100 * size + 0.0625 / size <= x.range.sup()));
    BOOST_TEST((x.range.inf() >= 100 * size - 1 / size && x.range.sup() <= 100 * size + 1 / size));
  }
  BOOST_TEST(models(GC::Cad_line<2>{{1e200, 0}, {1e200, 0}}, range).value.known());
  BOOST_TEST(!models(GC::Cad_line<2>{{1e305, 0}, {1, 0}}, range).value.known());
  BOOST_TEST(!models(GC::Cad_line<2>{{1, 0}, {1e305, 0}}, range).value.known());
}

// The range of an edge is divided next to where it crosses knot lines, however it runs.
BOOST_AUTO_TEST_CASE(crossed_knot_lines) {
  const std::vector<double> knots{0, 0, 0.25, 0.5, 1, 1};
  const auto ends = [&](bool swapped, double from, double by) {
    GC::Cad_spline_surface s{1, 1, knots, clamped(1), std::vector<P3>(8), {}};
    if (swapped) std::swap(s.u_knots, s.v_knots);
    const GC::Edge_side a = side(s, swapped ? line(0.5, from, 0, by) : line(from, 0.5, by, 0));
    const CGAL::Protect_FPU_rounding<true> upwards;
    return GC::internal::divided_range({&a}, 0, 1);
  };
  for (const bool swapped : {false, true}) {
    BOOST_TEST((ends(swapped, 0, 1) == std::vector<double>{0, 0.25, 0.5, 1}));
    BOOST_TEST((ends(swapped, 1, -1) == std::vector<double>{0, 0.5, 0.75, 1}));
    for (const auto& [from, by] : {std::pair<double, double>{0.1, 0.7}, {0.9, -0.7}, {0.2, 0.2}, {0.3, 0.1}}) {
      std::vector<double> expected{0, 1};
      for (const double knot : {0.25, 0.5}) {
        const double t = (knot - from) / by;
        if (0 < t && t < 1) expected.insert(expected.end(), 2, t); // on both sides of it
      }
      std::sort(expected.begin(), expected.end());
      const std::vector<double> found = ends(swapped, from, by);
      BOOST_TEST_CONTEXT("from " << from << " by " << by) {
        BOOST_TEST_REQUIRE(found.size() == expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) BOOST_TEST(std::fabs(found[i] - expected[i]) < 1e-10);
      }
    }
  }
}

// At a corner where both derivatives have one direction the normal is proved to vanish, in
// whichever plane that lies.
BOOST_AUTO_TEST_CASE(vanishing_normals) {
  const auto vanishes = [&](const P3& along_u, const P3& along_v) {
    const GC::Edge_side a =
        side(GC::Cad_spline_surface{1, 1, clamped(1), clamped(1), {{0, 0, 0}, along_v, along_u, {9, 8, 5}}, {}},
             line(0, 0, 0, 1));
    const CGAL::Protect_FPU_rounding<true> upwards;
    return GC::internal::Vanishing_normal(a).is_on(GC::internal::Edge_range(0, 0.5), false);
  };
  BOOST_TEST(vanishes({2, 4, 6}, {1, 2, 3}));
  BOOST_TEST(vanishes({-1, 0, 2}, {1, 0, -2}));
  BOOST_TEST(vanishes({0, 0, 0}, {1, 0, -2}));
  for (const P3& v : {P3{1, 2, 4}, P3{1, 3, 3}, P3{2, 2, 3}, P3{0, 0, 1}, P3{0, 1, 0}, P3{1, 0, 0}})
    BOOST_TEST(!vanishes({2, 4, 6}, v));
}

BOOST_AUTO_TEST_CASE(models_enclose_what_they_stand_for) {
  const unsigned seed = first_seed();
  random_bits.seed(seed);
  // with a mirror
  const GC::Cad_placement moved{{{0.48, -0.8, 0.36, 5}, {0.64, 0.6, 0.48, -2}, {0.6, 0, -0.8, 1}}};
  const GC::Cad_frame frame{{1, 2, 3}, {0, 0.6, 0.8}, {1, 0, 0}, {0, 0.8, -0.6}};
  typedef GC::Cad_conic<2> Conic;
  // How many models on short ranges of each surface are narrow. A few are not, where a normal
  // nearly vanishes: there a series of the reciprocal of its length may diverge, and nothing but
  // the points is known.
  std::map<std::string, int> narrow, models;
  for (int round = 0; round < 2; ++round) {
    const std::vector<std::pair<std::string, GC::Cad_surface>> surfaces{
        {"plane", Elementary{Kind::plane, frame}},
        {"cylinder", Elementary{Kind::cylinder, frame, 2}},
        {"cone", Elementary{Kind::cone, frame, 2, 0.3}},
        {"sphere", Elementary{Kind::sphere, frame, 2}},
        {"torus", Elementary{Kind::torus, frame, 3, 1}},
        {"patch", patch(3, 3, false)},
        {"patch of high degree", patch(12, 9, false)},
        {"rational patch", patch(2, 3, true)},
        {"extrusion", GC::Cad_extrusion{bezier<3>(11, true, 1), {0.1, 0.2, 2}}},
        {"extruded hyperbola",
         GC::Cad_extrusion{GC::Cad_conic<3>{GC::Cad_conic<3>::Kind::hyperbola, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.5, 2},
                           {0, 0, 1}}},
        {"extruded parabola",
         GC::Cad_extrusion{GC::Cad_conic<3>{GC::Cad_conic<3>::Kind::parabola, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.5, 0},
                           {0, 0, 1}}},
        {"revolution", GC::Cad_revolution{bezier<3>(10, false, 1), {0, 3, 0}, {0, 0, 1}}},
    };
    const std::vector<std::pair<std::string, GC::Cad_curve<2>>> curves{
        {"line", GC::Cad_line<2>{{0.1, 0.2}, {0.8, 0.5}}},
        {"isoparametric line", GC::Cad_line<2>{{0, 0.3}, {1, 0}}},
        {"curve", bezier<2>(3, false, 1)},
        {"curve of high degree", bezier<2>(14, false, 1)},
        {"rational curve", bezier<2>(3, true, 1)},
        {"ellipse", Conic{Conic::Kind::ellipse, {0.5, 0.5}, {1, 0}, {0, 1}, 0.4, 0.3}},
    };
    for (const auto& [surface_name, surface] : surfaces)
      for (const auto& [curve_name, curve] : curves) {
        const GC::Edge_side a = side(surface, curve, round == 1, round % 2 ? moved : unmoved);
        BOOST_TEST_CONTEXT(curve_name << " on " << surface_name << ", seed " << seed << ", round " << round) {
          int known = 0;
          for (double length : {1., 0.5, 0.25, 0.0625}) {
            const double first = between(0, 1 - length);
            const Outside o(a, first, first + length);
            BOOST_TEST(o.outside == 0);
            known += o.known;
          }
          const double first = between(0, 0.9);
          const Outside tiny(a, first, first + 0x1p-8);
          BOOST_TEST(tiny.outside == 0);
          BOOST_TEST((tiny.known == 7 * 11 || (tiny.known == 3 * 11 && !tiny.steady)));
          narrow[surface_name] += tiny.r < 1e-7;
          ++models[surface_name];
          BOOST_TEST(known > 0);
        }
      }
  }
  for (const auto& [name, number] : models)
    BOOST_TEST_CONTEXT(name << ", seed " << seed) BOOST_TEST(2 * narrow[name] > number);
}

// The parameter where to look stays in the range, also where the length of that is no double.
BOOST_AUTO_TEST_CASE(likely_maxima) {
  typedef GC::internal::Edge_range Range;
  using GC::internal::likely_maximum;
  const auto rising = [](double s) { return s + 3; };
  const auto falling = [](double s) { return 3 - s; };
  const auto bump = [](double s) { return 3 - s * s; };
  BOOST_TEST(likely_maximum(Range(-2, 6), rising) == 6);
  BOOST_TEST(likely_maximum(Range(-2, 6), falling) == -2);
  BOOST_TEST(likely_maximum(Range(-2, 6), bump) == 2);
  BOOST_TEST(likely_maximum(Range(5, 5), rising) == 5);
  const double far = 1.5e308;
  BOOST_TEST(likely_maximum(Range(-far, far), rising) == far);
  BOOST_TEST(likely_maximum(Range(-far, far), falling) == -far);
  BOOST_TEST(std::abs(likely_maximum(Range(-far, far), bump)) ==
             far); // one of both ends: between them no other is tried
}

BOOST_AUTO_TEST_SUITE_END()
