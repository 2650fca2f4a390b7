// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The Taylor models of points, normals and curvatures along an edge enclose their values, also on ranges that are so wide that what the
// polynomials leave out is large; and they are narrow on those that are not.

#include <boost/test/unit_test.hpp>

#include "support/sampled_edges.h"

#include <CGAL/Geometric_continuity/edges/internal/Placed_side.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Placed_side)

namespace GC = CGAL::Geometric_continuity;
typedef GC::Cad_elementary_surface Elementary;
typedef Elementary::Kind Kind;
typedef GC::Cad_point<3> P3;

namespace {

std::mt19937 random_bits;

double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_bits); }

std::vector<double> bezier_knots(int degree) {
  std::vector<double> k(degree + 1, 0.);
  k.insert(k.end(), degree + 1, 1.);
  return k;
}
template <int D> GC::Cad_spline_curve<D> bezier(int degree, bool rational, double size) {
  GC::Cad_spline_curve<D> c{degree, bezier_knots(degree), {}, {}};
  for (int i = 0; i <= degree; ++i) {
    GC::Cad_point<D> p;
    for (int k = 0; k < D; ++k) p[k] = k == 0 ? size * i / degree : between(0.2, 0.8);
    c.points.push_back(p);
    if (rational) c.weights.push_back(between(0.5, 2));
  }
  return c;
}
GC::Cad_spline_surface patch(int p, int q, bool rational) {
  GC::Cad_spline_surface s{p, q, bezier_knots(p), bezier_knots(q), {}, {}};
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) {
      s.points.push_back({double(i) / p, double(j) / q + between(-0.05, 0.05), between(-0.3, 0.3)});
      if (rational) s.weights.push_back(between(0.5, 2));
    }
  return s;
}

// How often a value lies outside of what is known on the range [first, last], and whether that is close.
struct Outside {
  int outside = 0, known = 0;
  double r = 0;

  Outside(const GC::Edge_side& side, double first, double last) {
    std::vector<GC::internal::Side_models> models;
    const GC::internal::Edge_range range(first, last);
    {
      const CGAL::Protect_FPU_rounding<true> upwards;
      models = GC::internal::Placed_side(side).models(range, GC::internal::Edge_quantity::curvature);
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
    }
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(models_enclose_what_they_stand_for) {
  const unsigned seed = std::random_device()();
  random_bits.seed(seed);
  const GC::Cad_placement unmoved{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
      moved{{{0.48, -0.8, 0.36, 5}, {0.64, 0.6, 0.48, -2}, {0.6, 0, -0.8, 1}}}; // with a mirror
  const GC::Cad_frame frame{{1, 2, 3}, {0, 0.6, 0.8}, {1, 0, 0}, {0, 0.8, -0.6}};
  typedef GC::Cad_conic<2> Conic;
  // How many models on short ranges of each surface are narrow. A few are not, where a normal nearly vanishes.
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
        const GC::Edge_side side{std::make_shared<GC::Cad_surface>(surface), std::make_shared<GC::Cad_curve<2>>(curve),
                                 round % 2 ? moved : unmoved, round == 1};
        BOOST_TEST_CONTEXT(curve_name << " on " << surface_name << ", seed " << seed << ", round " << round) {
          int known = 0;
          for (double length : {1., 0.5, 0.25, 0.0625}) {
            const double first = between(0, 1 - length);
            const Outside o(side, first, first + length);
            BOOST_TEST(o.outside == 0);
            known += o.known;
          }
          const double first = between(0, 0.9);
          const Outside tiny(side, first, first + 0x1p-8);
          BOOST_TEST(tiny.outside == 0);
          BOOST_TEST(tiny.known == 7 * 11);
          narrow[surface_name] += tiny.r < 1e-7;
          ++models[surface_name];
          BOOST_TEST(known > 0);
        }
      }
  }
  for (const auto& [name, number] : models)
    BOOST_TEST_CONTEXT(name << ", seed " << seed) BOOST_TEST(2 * narrow[name] > number);
}

BOOST_AUTO_TEST_SUITE_END()
