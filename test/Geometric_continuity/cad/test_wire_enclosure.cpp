// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Encloses the joins of edges in space: with gaps, angles and curvatures that are known, and as
// exact arithmetic measures those of splines.

#define BOOST_TEST_MODULE wire_enclosure

#include "support/cad_sides.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>

namespace {

typedef GC::Cad_conic<3> Conic;
typedef GC::Cad_spline_curve<3> Spline;
const double degree = 0.017453292519943295;

GC::Edge_end end_of(GC::Cad_curve<3> curve, double parameter, bool reversed = false,
                    const GC::Cad_placement& place = unmoved) {
  return {{std::make_shared<const GC::Cad_curve<3>>(std::move(curve)), place}, parameter, reversed};
}

bool encloses(const GC::Enclosure& e, double x, double width = 1e-12) {
  return e.lower <= x + 1e-14 && x - 1e-14 <= e.upper && e.upper - e.lower <= width;
}

} // namespace

BOOST_AUTO_TEST_CASE(known_joins) {
  // the line to (5, 0), and the circle of radius 2 that goes on there
  const GC::Cad_line<3> line{{0, 0, 0}, {1, 0, 0}};
  const Conic circle{Conic::Kind::ellipse, {5, 2, 0}, {0, -1, 0}, {1, 0, 0}, 2, 2};
  GC::Wire_enclosure w = GC::wire_enclosure(end_of(line, 5), end_of(circle, 0));
  BOOST_TEST(encloses(w.deviation.gap, 0));
  BOOST_TEST(encloses(*w.deviation.tangent_angle, 0));
  BOOST_TEST(encloses(*w.deviation.curvature_jump, 1));
  BOOST_TEST(encloses(w.derivative_jumps[0], 0.5)); // speeds 1 and 2
  BOOST_TEST(encloses(w.derivative_jumps[1], 1));
  BOOST_TEST(w.point == (GC::Cad_point<3>{5, 0, 0}));
  BOOST_TEST(!w.deviation.torsion_jump);
  // backwards, and with both edges run through against their parameters
  w = GC::wire_enclosure(end_of(circle, 0, true), end_of(line, 5, true));
  BOOST_TEST(encloses(*w.deviation.tangent_angle, 0));
  BOOST_TEST(encloses(*w.deviation.curvature_jump, 1));
  // the wrong direction turns back
  w = GC::wire_enclosure(end_of(line, 5), end_of(circle, 0, true));
  BOOST_TEST(encloses(*w.deviation.tangent_angle, 180 * degree, 1e-7));
  // a corner of 30 degrees with a gap of 0.25
  const GC::Cad_line<3> inclined{{5, 0, 0.25}, {std::cos(30 * degree), std::sin(30 * degree), 0}};
  w = GC::wire_enclosure(end_of(line, 5), end_of(inclined, 0));
  BOOST_TEST(encloses(w.deviation.gap, 0.25));
  BOOST_TEST(encloses(*w.deviation.tangent_angle, 30 * degree));
  BOOST_TEST(encloses(*w.deviation.curvature_jump, 0)); // both flat
  // circles of radii 2 and 3: 1/2 and 1/3
  const Conic larger{Conic::Kind::ellipse, {5, 3, 0}, {0, -1, 0}, {1, 0, 0}, 3, 3};
  w = GC::wire_enclosure(end_of(circle, 0), end_of(larger, 0));
  BOOST_TEST(encloses(*w.deviation.curvature_jump, 1. / 3));
  BOOST_TEST(encloses(w.derivative_jumps[1], 1. / 3));
  // a placement that mirrors and moves
  const GC::Cad_placement mirrored = {{{1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 7}}};
  w = GC::wire_enclosure(end_of(circle, 0), end_of(circle, 0, false, mirrored));
  BOOST_TEST(encloses(w.deviation.gap, 7));
  BOOST_TEST(encloses(*w.deviation.curvature_jump, 2));
  // an axis of an ellipse, where its curvature is a / b^2
  const Conic ellipse{Conic::Kind::ellipse, {5, 4, 0}, {0, -1, 0}, {1, 0, 0}, 4, 2};
  w = GC::wire_enclosure(end_of(larger, 0), end_of(ellipse, 0));
  BOOST_TEST(encloses(*w.deviation.curvature_jump, 2. / 3));
  // what is flat counts as such
  const Conic flat{Conic::Kind::ellipse, {5, 1e9, 0}, {0, -1, 0}, {1, 0, 0}, 1e9, 1e9};
  BOOST_TEST(encloses(*GC::wire_enclosure(end_of(line, 5), end_of(flat, 0)).deviation.curvature_jump, 1e-3));
  BOOST_TEST(encloses(*GC::wire_enclosure(end_of(line, 5), end_of(flat, 0), 1e-9).deviation.curvature_jump, 1, 1e-6));
}

BOOST_AUTO_TEST_CASE(knots_and_errors) {
  // C0 at the knot 1: the pieces have the slopes 0 and 1
  const Spline bent{1, {0, 0, 1, 3, 3}, {{0, 0, 0}, {1, 0, 0}, {3, 2, 0}}, {}};
  const GC::Wire_enclosure w = GC::wire_enclosure(end_of(bent, 1), end_of(bent, 1));
  BOOST_TEST(encloses(*w.deviation.tangent_angle, 45 * degree));
  BOOST_TEST(
      encloses(*GC::wire_enclosure(end_of(bent, 1, true), end_of(bent, 1, true)).deviation.tangent_angle, 45 * degree));
  BOOST_TEST((GC::curve_knots(bent, 0) == std::vector<double>{}));
  BOOST_TEST((GC::curve_knots(bent, 1) == std::vector<double>{1}));
  // no tangent
  const Spline stop{2, {0, 0, 0, 1, 1, 1}, {{0, 0, 0}, {1, 1, 0}, {1, 1, 0}}, {}};
  const GC::Wire_enclosure none = GC::wire_enclosure(end_of(stop, 1), end_of(stop, 0));
  BOOST_TEST(!none.deviation.tangent_angle);
  BOOST_TEST(!none.deviation.curvature_jump);
  BOOST_TEST(encloses(none.derivative_jumps[0], 1));
  const auto enclose = [](const GC::Edge_end& end) { return GC::wire_enclosure(end, end); };
  CHECK_ERROR(enclose(end_of(bent, 4)), parameter_outside_domain);
  CHECK_ERROR(enclose(end_of(bent, std::nan(""))), not_finite);
  CHECK_ERROR(enclose(end_of(Spline{1, {0, 0, 1}, {{0, 0, 0}, {1, 0, 0}}, {}}, 0)), wrong_number_of_points);
  CHECK_ERROR(enclose(end_of(bent, 1, false, {{{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}})), singular_frame);
}

// Random cubics on [0, 1], nearly smooth: the enclosures have those of exact arithmetic inside.
BOOST_AUTO_TEST_CASE(random_cubics) {
  std::mt19937 random = seeded(first_seed());
  const auto number = [&] { return std::uniform_real_distribution<double>(-10, 10)(random); };
  for (int i = 0; i < 200; ++i) {
    std::vector<GC::Cad_point<3>> p, q;
    for (int j = 0; j < 4; ++j) {
      p.push_back({number(), number(), number()});
      q.push_back({number(), number(), number()});
    }
    q[0] = p[3];
    if (i % 2 == 0) // the tangent, and the second derivative, but for rounding
      for (std::size_t k = 0; k < 3; ++k) {
        q[1][k] = p[3][k] + (p[3][k] - p[2][k]);
        q[2][k] = p[1][k] - 4 * p[2][k] + 4 * p[3][k];
      }
    const auto exact = [](const std::vector<GC::Cad_point<3>>& points) {
      std::vector<Exact_3::Point> result;
      for (const auto& x : points) result.emplace_back(x[0], x[1], x[2]);
      return GC::Bezier_curve<Exact_3>(result);
    };
    const auto spline = [](const std::vector<GC::Cad_point<3>>& points) {
      return Spline{3, {0, 0, 0, 0, 1, 1, 1, 1}, points, {}};
    };
    const GC::Join_deviation known = GC::deviation(exact(p), exact(q));
    const GC::Wire_enclosure found = GC::wire_enclosure(end_of(spline(p), 1), end_of(spline(q), 0), 1e-300);
    const auto meet = [](const GC::Enclosure& x, const GC::Enclosure& y) {
      return x.lower <= y.upper && y.lower <= x.upper && x.upper - x.lower < 1e-11;
    };
    BOOST_TEST(meet(found.deviation.gap, known.gap));
    BOOST_TEST(meet(*found.deviation.tangent_angle, *known.tangent_angle));
    BOOST_TEST(meet(*found.deviation.curvature_jump, *known.curvature_jump));
    if (i % 2 == 0) {
      BOOST_TEST(found.deviation.tangent_angle->upper < 1e-14);
      BOOST_TEST(found.derivative_jumps[0].upper < 1e-14);
      BOOST_TEST(found.derivative_jumps[1].upper < 1e-12);
    }
  }
}
