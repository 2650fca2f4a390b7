// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Encloses the joins of edges in space, and the largest curvature of one: with gaps, angles and
// curvatures that are known, and as exact arithmetic measures those of splines.

#define BOOST_TEST_MODULE wire_enclosure

#include "support/cad_sides.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
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

BOOST_AUTO_TEST_CASE(known_curvatures) {
  GC::Edge_precision precision;
  precision.relative = 1e-9;
  const auto largest = [&](GC::Cad_curve<3> curve, double first, double last,
                           const GC::Cad_placement& place = unmoved) {
    return GC::largest_curvature(end_of(std::move(curve), 0, false, place).curve, first, last, precision);
  };
  const auto is = [](const GC::Edge_maximum& found, double curvature) {
    return encloses(found.value, curvature, 2e-9 * curvature);
  };
  BOOST_TEST(largest(GC::Cad_line<3>{{1, 2, 3}, {0, 3, 4}}, -5, 5).value.upper < 1e-9);
  const Conic circle{Conic::Kind::ellipse, {5, 2, 0}, {0, -1, 0}, {1, 0, 0}, 2, 2};
  BOOST_TEST(is(largest(circle, 0, 6), 0.5));
  BOOST_TEST(is(largest(circle, 0, 6, {{{3, 0, 0, 1}, {0, 3, 0, 0}, {0, 0, -3, 7}}}), 0.5 / 3));
  BOOST_TEST(encloses(largest(circle, 1, 1).value, 0.5)); // a point of it
  // an offset by 1 outwards
  BOOST_TEST(is(largest(GC::Cad_offset_curve<3>{std::make_shared<const GC::Cad_curve<3>>(circle), 1, {0, 0, 1}}, 0, 6),
                1. / 3));
  // a / b^2 on the long axis, elsewhere a b / (a^2 sin^2 + b^2 cos^2)^1.5
  const Conic ellipse{Conic::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 4, 2};
  const GC::Edge_maximum at_axis = largest(ellipse, -1, 2), at_end = largest(ellipse, 1, 2);
  BOOST_TEST(is(at_axis, 1));
  BOOST_TEST(std::abs(at_axis.parameter) < 1e-3);
  BOOST_TEST(std::abs(at_axis.point[0] - 4) < 1e-5);
  BOOST_TEST(is(at_end, 8 / std::pow(16 * std::pow(std::sin(1), 2) + 4 * std::pow(std::cos(1), 2), 1.5)));
  BOOST_TEST(at_end.parameter == 1);
  // y^2 = 4 a x with 1 / (2 a) in the vertex
  BOOST_TEST(is(largest(Conic{Conic::Kind::parabola, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.25, 0}, -3, 9), 2));
  BOOST_TEST(is(largest(Conic{Conic::Kind::hyperbola, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 3}, -3, 2), 2. / 9));
  // a line, and behind the knot a parabola that begins with the curvature 1
  const Spline started{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1.5, 0, 0}, {2, 0.5, 0}}, {}};
  BOOST_TEST(is(largest(started, 0, 2), 1));
  BOOST_TEST(largest(started, 0, 2).parameter == 1);
  BOOST_TEST(largest(started, 0, 1).value.upper < 1e-9);
  // a cusp, and a tangent that is zero at the end
  const Spline cusp{3, clamped(3), {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}, {}};
  BOOST_TEST(std::isinf(largest(cusp, 0, 1).value.upper));
  BOOST_TEST(largest(cusp, 0, 1).value.lower > 1e3);
  const Spline stop{2, clamped(2), {{0, 0, 0}, {1, 1, 0}, {1, 1, 0}}, {}};
  BOOST_TEST(std::isinf(largest(stop, 0, 1).value.upper));
  CHECK_ERROR(largest(stop, 0, 1.5), parameter_outside_domain);
  CHECK_ERROR(largest(circle, 1, 0), empty_domain);
}

// Random curves, rational ones too: exact arithmetic finds a curvature in each enclosure.
BOOST_AUTO_TEST_CASE(random_curvatures) {
  std::mt19937 random = seeded(first_seed());
  const auto number = [&] { return std::uniform_int_distribution<int>(-20, 20)(random); };
  for (int i = 0; i < 30; ++i) {
    const int degree = 3 + i % 3;
    Spline spline{degree, clamped(degree), {}, {}};
    std::vector<Exact_3::Point> points;
    std::vector<Exact_3::FT> weights;
    for (int j = 0; j <= degree; ++j) {
      spline.points.push_back({double(number()), double(number()), double(number())});
      const P3& p = spline.points.back();
      points.emplace_back(p[0], p[1], p[2]);
      weights.push_back(i % 2 == 0 ? 1 : 1 + std::abs(number()));
      spline.weights.push_back(CGAL::to_double(weights.back()));
    }
    if (i % 2 == 0) spline.weights.clear();
    const auto exact = GC::Rational_bezier_curve<Exact_3>(points, weights);
    const GC::Enclosure known = GC::curvature_extrema(exact).largest(),
                        found = GC::largest_curvature(end_of(spline, 0).curve, 0, 1).value;
    BOOST_TEST(found.lower <= known.upper);
    BOOST_TEST(known.lower <= found.upper);
    BOOST_TEST(found.upper - found.lower <= 0.0101 * found.upper);
  }
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
