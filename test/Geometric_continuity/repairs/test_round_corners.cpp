// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// All corners of a chain are rounded: which joins are corners, how near they are cut where curves
// are short, what stays as it is, and what is refused.

#include "support/random.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>
#include <CGAL/Polygon_2.h>

BOOST_AUTO_TEST_SUITE(round_corners)

typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;
typedef std::vector<Curve> Chain;
typedef GC::Rounded_chain<Curve> Rounded;

const Chain square = {
    {Point(0, 0), Point(8, 0)}, {Point(8, 0), Point(8, 8)}, {Point(8, 8), Point(0, 8)}, {Point(0, 8), Point(0, 0)}};

bool same(const Curve& a, const Curve& b) {
  return a.domain() == b.domain() && a.degree() == b.degree() && std::equal(a.begin(), a.end(), b.begin());
}

// The least G order of all joins.
int least_order(const Rounded& r, bool closed) {
  return *GC::chain_continuity(r.curves, 3, closed ? GC::Closure::closed : GC::Closure::open).g_order();
}

// The rest of each given curve lies in its place, and is the part of it between the cuts.
void check_parts(const Chain& given, const Rounded& r) {
  std::vector<Q> starts, ends;
  std::vector<bool> is_blend(r.curves.size(), false);
  for (const Curve& c : given) {
    starts.push_back(c.domain().first);
    ends.push_back(c.domain().second);
  }
  for (const GC::Rounded_join<Q>& corner : r.corners) {
    ends[corner.join] = corner.left_cut;
    starts[(corner.join + 1) % given.size()] = corner.right_cut;
    BOOST_REQUIRE(corner.blend < r.curves.size());
    is_blend[corner.blend] = true;
    BOOST_CHECK(r.curves[corner.blend].degree() == 5);
  }
  std::size_t i = 0;
  for (std::size_t k = 0; k < r.curves.size(); ++k) {
    if (is_blend[k]) continue;
    BOOST_REQUIRE(i < given.size());
    Curve part = given[i];
    if (ends[i] != part.domain().second) part = part.split(ends[i]).first;
    if (starts[i] != part.domain().first) part = part.split(starts[i]).second;
    BOOST_CHECK(same(r.curves[k], part));
    ++i;
  }
  BOOST_CHECK(i == given.size());
}

Rounded rounded(const Chain& chain, double distance, bool closed, int order = 2) {
  const Rounded r =
      GC::round_corners(chain.begin(), chain.end(), distance, closed ? GC::Closure::closed : GC::Closure::open, order);
  check_parts(chain, r);
  return r;
}

BOOST_AUTO_TEST_CASE(closed_and_open) {
  const Rounded closed = rounded(square, 1, true), open = rounded(square, 1, false);
  BOOST_REQUIRE(closed.curves.size() == 8 && closed.corners.size() == 4);
  BOOST_REQUIRE(open.curves.size() == 7 && open.corners.size() == 3);
  for (std::size_t i = 0; i < 4; ++i) {
    BOOST_CHECK(closed.corners[i].join == i && closed.corners[i].blend == 2 * i + 1);
    BOOST_CHECK(closed.corners[i].distance == 1);
    BOOST_CHECK(closed.corners[i].left_cut == Q(7) / 8 && closed.corners[i].right_cut == Q(1) / 8);
  }
  BOOST_CHECK(least_order(closed, true) == 2);
  BOOST_CHECK(least_order(open, false) == 2);
  // all four corners have one form
  const Curve &first = closed.curves[1], second = closed.curves[3];
  for (int j = 0; j <= 5; ++j)
    BOOST_CHECK(second.control_point(j) == Point(8 - first.control_point(j).y(), first.control_point(j).x()));
}

// Kinks, a jump of the curvature and a smooth join.
// A polygon is the chain of its sides, and closed where it ends in its first point.
BOOST_AUTO_TEST_CASE(polygons) {
  std::vector<Point> corners{Point(0, 0), Point(8, 0), Point(8, 8), Point(0, 8)};
  const Chain three(square.begin(), square.end() - 1);
  const auto check = [](const Rounded& r, const Rounded& expected) {
    BOOST_REQUIRE(r.curves.size() == expected.curves.size());
    for (std::size_t i = 0; i < r.curves.size(); ++i) BOOST_CHECK(same(r.curves[i], expected.curves[i]));
  };
  check(GC::round_corners(corners, 2), GC::round_corners(three, 2, GC::Closure::open));
  check(GC::round_corners(three, 2), GC::round_corners(three, 2, GC::Closure::open));
  const Rounded closed = GC::round_corners(square, 2, GC::Closure::closed);
  BOOST_CHECK_EQUAL(closed.corners.size(), 4);
  check(GC::round_corners(corners, 2, GC::Closure::closed), closed);
  corners.push_back(corners.front());
  check(GC::round_corners(corners, 2), closed);
  check(GC::round_corners(corners, 2, GC::Closure::closed), closed);
  check(GC::round_corners(square, 2), closed);
  check(GC::round_corners(CGAL::Polygon_2<Traits::Kernel>(corners.begin(), corners.end() - 1), 2), closed);
  BOOST_CHECK(closed.size() == 8 && &closed[7] == &closed.curves[7] && &*closed.begin() == &closed.curves[0]);
  CHECK_ERROR(GC::round_corners(std::vector<Point>(1, Point(0, 0)), 2), wrong_number_of_points);
}

BOOST_AUTO_TEST_CASE(which_joins) {
  const Curve parabola{Point(4, 0), Point(6, 0), Point(8, 2)};
  const Chain chain = {{Point(-2, 2), Point(0, 0)},
                       {Point(0, 0), Point(4, 0)},
                       parabola.split(Q(1) / 3).first,
                       parabola.split(Q(1) / 3).second,
                       {Point(8, 2), Point(8, 5)}};
  const Rounded none = rounded(chain, 0.5, false, 0), kinks = rounded(chain, 0.5, false, 1),
                jumps = rounded(chain, 0.5, false, 2);
  BOOST_CHECK(none.corners.empty() && none.curves.size() == 5);
  BOOST_REQUIRE(kinks.corners.size() == 2 && jumps.corners.size() == 3);
  BOOST_CHECK(kinks.corners[0].join == 0 && kinks.corners[1].join == 3);
  BOOST_CHECK(jumps.corners[0].join == 0 && jumps.corners[1].join == 1 && jumps.corners[2].join == 3);
  BOOST_CHECK(least_order(kinks, false) == 1 && least_order(jumps, false) == 2);
  // a chain that has the order stays
  const Chain smooth = {chain[2], chain[3]};
  BOOST_CHECK(rounded(smooth, 0.5, false).corners.empty());
}

// A quarter of each curve remains: of a curve with two corners 3/8 are cut off on each side, and
// with one 3/4.
BOOST_AUTO_TEST_CASE(short_curves) {
  const Chain chain = {{Point(0, 4), Point(0, 0)}, {Point(0, 0), Point(1, 0)}, {Point(1, 0), Point(1, 4)}};
  const Rounded r = rounded(chain, 100, false);
  BOOST_REQUIRE(r.corners.size() == 2);
  for (const GC::Rounded_join<Q>& corner : r.corners) BOOST_CHECK(corner.distance == 0.375);
  BOOST_CHECK(r.corners[0].right_cut == Q(3) / 8 && r.corners[1].left_cut == Q(5) / 8);
  BOOST_CHECK(least_order(r, false) == 2);
  const Chain two = {chain[0], chain[1]};
  const Rounded one_corner = rounded(two, 100, false);
  BOOST_CHECK(one_corner.corners[0].distance == 0.75 && one_corner.corners[0].right_cut == Q(3) / 4);
  // the same distance on both sides, and the wanted one where it fits
  const Rounded fits = rounded(two, 0.5, false);
  BOOST_CHECK(fits.corners[0].right_cut == Q(1) / 2 && fits.corners[0].left_cut == Q(7) / 8);
}

// A spline is the chain of its Bezier curves: with a kink at a triple knot, between two that are
// smooth. Alone, before a line that it meets in a corner, and as segments.
BOOST_AUTO_TEST_CASE(splines) {
  typedef GC::Bspline_curve<Traits> Spline;
  const std::vector<Q> knots = {0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 4, 4};
  const std::vector<Point> points = {{0, 0}, {1, 0}, {2, 2}, {4, 2}, {5, 0}, {6, 4}, {7, 5}, {8, 4}, {9, 0}};
  const Spline spline(points.begin(), points.end(), GC::Knot_vector<Q>(3, knots));
  const Chain pieces = spline.bezier_pieces();
  BOOST_REQUIRE(pieces.size() == 4);
  const std::vector<Spline> chain = {spline};
  const Rounded r = GC::round_corners(chain.begin(), chain.end(), 0.25, GC::Closure::open);
  check_parts(pieces, r);
  BOOST_REQUIRE(r.corners.size() == 1 && r.corners[0].join == 1);
  BOOST_CHECK(least_order(r, false) == 2);
  const Rounded same_pieces = rounded(pieces, 0.25, false);
  BOOST_REQUIRE(same_pieces.curves.size() == r.curves.size());
  for (std::size_t k = 0; k < r.curves.size(); ++k) BOOST_CHECK(same(r.curves[k], same_pieces.curves[k]));

  const std::vector<GC::Composite_bezier_curve<Traits>> segments = {
      GC::Composite_bezier_curve<Traits>(pieces.begin(), pieces.end())};
  const Rounded of_segments = GC::round_corners(segments.begin(), segments.end(), 0.25, GC::Closure::open);
  BOOST_REQUIRE(of_segments.corners.size() == 1 && of_segments.corners[0].join == 1);
  for (std::size_t k = 0; k < r.curves.size(); ++k) BOOST_CHECK(same(r.curves[k], of_segments.curves[k]));

  // from one spline to the next, and back: corners between them too
  const std::vector<Q> line_knots = {0, 0, 1, 1};
  const std::vector<Point> line = {{9, 0}, {0, 0}};
  const std::vector<Spline> two = {spline, Spline(line.begin(), line.end(), GC::Knot_vector<Q>(1, line_knots))};
  const Rounded closed = GC::round_corners(two, 0.25, GC::Closure::closed); // a range
  BOOST_REQUIRE(closed.corners.size() == 3 && closed.corners[1].join == 3 && closed.corners[2].join == 4);
  BOOST_CHECK(least_order(closed, true) == 2);
}

// On doubles too a smooth knot is no corner, though the Bezier curves next to it are rounded.
BOOST_AUTO_TEST_CASE(spline_of_doubles) {
  typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Inexact;
  const std::vector<double> knots = {0, 0, 0, 0, 0.1, 0.7, 0.7, 0.7, 0.9, 1, 1, 1, 1};
  const std::vector<Inexact::Point> points = {{0, 0},     {0.1, 0},   {0.2, 0.3}, {0.4, 0.2}, {0.5, 0},
                                              {0.6, 0.4}, {0.7, 0.5}, {0.8, 0.4}, {0.9, 0}};
  const std::vector<GC::Bspline_curve<Inexact>> chain = {
      GC::Bspline_curve<Inexact>(points.begin(), points.end(), GC::Knot_vector<double>(3, knots))};
  const auto r = GC::round_corners(chain.begin(), chain.end(), 0.05, GC::Closure::open);
  BOOST_CHECK(r.corners.size() == 1 && r.corners[0].join == 1 && r.curves.size() == 5);
}

// A drop, of one curve; a lens, of two; a star with a cusp and a tangent that is zero.
BOOST_AUTO_TEST_CASE(outlines) {
  const Chain drop = {{Point(0, 0), Point(9, 6), Point(-9, 6), Point(0, 0)}},
              lens = {{Point(-2, 0), Point(0, 2), Point(2, 0)}, {Point(2, 0), Point(0, -2), Point(-2, 0)}},
              star = {{Point(0, 0), Point(4, 0), Point(6, 2)},
                      {Point(6, 2), Point(4, 0), Point(2, 6)},
                      {Point(2, 6), Point(2, 6), Point(0, 3), Point(0, 0)}};
  for (const Chain& outline : {drop, lens, star}) {
    const Rounded r = rounded(outline, 0.5, true);
    BOOST_CHECK(r.corners.size() == outline.size() && r.curves.size() == 2 * outline.size());
    BOOST_CHECK(least_order(r, true) >= 2);
  }
  BOOST_CHECK(rounded(drop, 0.5, false).curves.size() == 1);
}

BOOST_AUTO_TEST_CASE(random_polygons) {
  const unsigned seed = 2026;
  std::mt19937 engine(seed);
  const auto number = [&] { return static_cast<int>(engine() % 201) - 100; };
  for (int round = 0; round < 10; ++round) BOOST_TEST_CONTEXT("seed " << seed << ", round " << round) {
      std::vector<Point> corners;
      for (int i = 0; i < 7; ++i) corners.push_back(Point{number(), number()});
      Chain chain;
      for (int i = 0; i < 7; ++i)
        chain.push_back({corners[i], Point{number(), number()}, Point{number(), number()}, corners[(i + 1) % 7]});
      const Rounded r = rounded(chain, 10, true);
      BOOST_CHECK(r.corners.size() == 7 && least_order(r, true) >= 2);
    }
}

// Every kernel rounds the same chain; rounded numbers are near the exact ones.
BOOST_AUTO_TEST_CASE(kernels) {
  const Rounded exact = rounded(square, 1.3, true);
  const auto check = [&](auto traits) {
    typedef decltype(traits) Other;
    std::vector<GC::Bezier_curve<Other>> chain;
    for (const Curve& c : square) {
      std::vector<typename Other::Point> points;
      for (const Point& p : c) points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
      chain.emplace_back(points.begin(), points.end());
    }
    const auto r = GC::round_corners(chain.begin(), chain.end(), 1.3, GC::Closure::closed);
    BOOST_REQUIRE(r.curves.size() == exact.curves.size());
    for (std::size_t k = 0; k < exact.curves.size(); ++k)
      for (int j = 0; j <= exact.curves[k].degree(); ++j)
        for (int i = 0; i < 2; ++i)
          BOOST_CHECK_SMALL(CGAL::to_double(r.curves[k].control_point(j)[i]) -
                                CGAL::to_double(exact.curves[k].control_point(j)[i]),
                            1e-14 * 8);
    if constexpr (!std::is_same_v<typename Other::FT, double>)
      for (std::size_t k = 0; k < 8; ++k) BOOST_CHECK(GC::is_g2_join(r.curves[k], r.curves[(k + 1) % 8]));
  };
  check(GC::Traits_2<CGAL::Epeck>());
  check(GC::Traits_2<CGAL::Simple_cartesian<double>>());
}

BOOST_AUTO_TEST_CASE(refused) {
  const auto round = [](const Chain& chain, double distance, bool closed) {
    return GC::round_corners(chain.begin(), chain.end(), distance, closed ? GC::Closure::closed : GC::Closure::open);
  };
  BOOST_CHECK(round({}, 1, false).curves.empty() && round({}, 1, true).curves.empty());
  const Chain gap = {square[0], square[1], square[3]}, open = {square[0], square[1]};
  BOOST_CHECK_EQUAL(error_of([&] { round(gap, 1, false); }), "curves_do_not_meet: round_corners: join after curve 1");
  BOOST_CHECK_EQUAL(error_of([&] { round(open, 1, true); }), "curves_do_not_meet: round_corners: join after curve 1");
  for (const double x : {0., -1.}) CHECK_ERROR(round(square, x, true), parameter_outside_domain);
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_ERROR(round(square, x, true), not_finite);
  CHECK_ERROR(GC::round_corners(square.begin(), square.end(), 1, GC::Closure::closed, -1), negative_count);
  const Chain point = {square[0], {Point(8, 0), Point(8, 0)}, square[1]};
  BOOST_CHECK_EQUAL(error_of([&] { round(point, 1, false); }),
                    "parameter_outside_domain: round_corners: join after curve 0: the distance 0 is not less than the "
                    "length 0 of the right curve");
  const Chain back = {square[1], square[2], square[2].reverse()};
  BOOST_CHECK_EQUAL(error_of([&] { round(back, 1, false); }),
                    "zero_tangent: round_corners: join after curve 1: the curves turn back on one line, where every "
                    "blend has a cusp");
}

// A half moon: an arc of more than half a circle, with a negative weight, and its chord; and half a
// circle, with an infinite control point.
BOOST_AUTO_TEST_CASE(rational_chains) {
  typedef GC::Rational_bezier_curve<Traits> Rational;
  for (const Q& r : std::vector<Q>{Q(1), Q(2), Q(1) / Q(3)}) {
    const Rational arc = GC::circular_arc<Traits>(Point(0, 0), Point(4, 0), r),
                   chord = Curve{arc.end_jet(0).point(), Point(4, 0)};
    const std::vector<Rational> moon = {arc, chord};
    const auto rounded = GC::round_corners(moon.begin(), moon.end(), 0.5, GC::Closure::closed);
    BOOST_REQUIRE(rounded.curves.size() == 4 && rounded.corners.size() == 2);
    BOOST_CHECK(GC::chain_continuity(rounded.curves, 2, GC::Closure::closed).g_order() == 2);
    for (const auto& corner : rounded.corners) BOOST_CHECK_EQUAL(corner.distance, 0.5);
    // the cuts have that distance along the circle of the radius 4, and what remains of it lies on
    // it
    const Point cut = rounded.curves[0].end_jet(0).point(), end = arc.end_jet(0).point();
    BOOST_CHECK(cut.x() * cut.x() + cut.y() * cut.y() == 16);
    const double half_chord = std::sqrt(CGAL::to_double((cut - end).squared_length())) / 2;
    BOOST_CHECK_CLOSE_FRACTION(8 * std::asin(half_chord / 4), 0.5, 1e-3);
    BOOST_CHECK(arc(rounded.corners[0].left_cut) == cut);
  }
  // the same as one B-spline curve with a kink at a knot
  const Rational arc = GC::circular_arc<Traits>(Point(0, 0), Point(4, 0), Q(1) / Q(2)),
                 line = Curve{arc.end_jet(0).point(), Point(-9, 9)};
  const std::vector<Rational> parts = {arc, line};
  const std::vector<GC::Rational_bspline_curve<Traits>> spline = {
      GC::Rational_bspline_curve<Traits>(parts.begin(), parts.end())};
  const auto rounded = GC::round_corners(spline.begin(), spline.end(), 0.25, GC::Closure::open);
  BOOST_REQUIRE(rounded.curves.size() == 3);
  BOOST_CHECK(GC::is_g2_join(rounded.curves[0], rounded.curves[1]) &&
              GC::is_g2_join(rounded.curves[1], rounded.curves[2]));
}

// With cubics a blend has one piece in a corner of lines, and two elsewhere.
BOOST_AUTO_TEST_CASE(by_cubics) {
  Chain chain = square;
  chain[1] = Curve{Point(8, 0), Point(10, 4), Point(8, 8)};
  const Rounded r = GC::round_corners(chain, 1, GC::Closure::closed, 2, GC::Cubics());
  BOOST_REQUIRE(r.corners.size() == 4 && r.curves.size() == 10);
  BOOST_CHECK(least_order(r, true) == 2);
  for (std::size_t i = 0; i < 4; ++i) {
    BOOST_CHECK(r.corners[i].pieces == (i < 2 ? 2u : 1u));
    for (std::size_t k = 0; k < r.corners[i].pieces; ++k) BOOST_CHECK(r.curves[r.corners[i].blend + k].degree() == 3);
  }
  BOOST_CHECK(r.corners[0].blend == 1 && r.corners[1].blend == 4 && r.corners[2].blend == 7);
  BOOST_CHECK(GC::round_corners(square, 1, GC::Closure::closed, 2, GC::Cubics{false}).curves.size() == 12);
}

// The distance in which a circle touches both sides: exact where it is rational, and at each corner
// that of its angle.
BOOST_AUTO_TEST_CASE(radius) {
  const auto line = [](const Point& a, const Point& b) { return Curve{a, b}; };
  BOOST_CHECK(GC::corner_distance(square[0], square[1], Q(3) / 7) == Q(3) / 7);
  // turns with the cosines 3/5 and -3/5: the tangents of half the angle are 1/2 and 2
  const Curve base = line(Point(0, 0), Point(8, 0));
  BOOST_CHECK(GC::corner_distance(base, line(Point(8, 0), Point(11, 4)), 1) == Q(1) / 2);
  BOOST_CHECK(GC::corner_distance(base, line(Point(8, 0), Point(5, -4)), 1) == Q(2));
  BOOST_CHECK(GC::corner_distance(base, line(Point(8, 0), Point(9, 0)), 1) == Q(0));
  // at random in doubles: the centre of the circle is as far from both cuts as the radius
  typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Doubles;
  std::mt19937 random = seeded(first_seed());
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  for (int i = 0; i < 1000; ++i) {
    const double x = number(), y = number(), u = number(), v = number(), r = 1 + number();
    const GC::Bezier_curve<Doubles> a{Doubles::Point(-x, -y), Doubles::Point(0, 0)},
        b{Doubles::Point(0, 0), Doubles::Point(u, v)};
    const double d = GC::corner_distance(a, b, r), angle = std::atan2(x * v - y * u, x * u + y * v);
    BOOST_TEST(d == r * std::abs(std::tan(angle / 2)), boost::test_tools::tolerance(1e-9));
  }
  CHECK_ERROR(GC::corner_distance(base, line(Point(8, 0), Point(1, 0)), 1), zero_tangent);
  CHECK_ERROR(GC::corner_distance(base, Curve{Point(8, 0), Point(8, 0)}, 1), zero_tangent);

  // a closed polygon with three kinds of corners; the smooth one between its first sides stays
  const std::vector<Point> points = {Point(0, 0),  Point(10, 0),  Point(20, 0),
                                     Point(26, 8), Point(26, 20), Point(0, 20)};
  const Rounded r = GC::round_corners(points, GC::Corner_radius{2}, GC::Closure::closed, 2, GC::Cubics());
  BOOST_REQUIRE(r.corners.size() == 5 && r.curves.size() == 11);
  const std::vector<Q> distances = {1, Q(2) / 3, 2, 2, 2};
  for (std::size_t i = 0; i < 5; ++i) BOOST_CHECK(r.corners[i].distance == distances[i]);
  BOOST_CHECK(least_order(r, true) >= 2);
  BOOST_CHECK(GC::round_corners(square, GC::Corner_radius{100}, GC::Closure::closed).corners[0].distance == 3);
  BOOST_CHECK(GC::round_corners(points, GC::Corner_radius{0.5}).corners.size() == 3); // open
  CGAL::Polygon_2<CGAL::Simple_cartesian<Q>> polygon(points.begin(), points.end());
  BOOST_CHECK(GC::round_corners(polygon, GC::Corner_radius{0.5}).corners.size() == 5);
  CHECK_ERROR(GC::round_corners(square, GC::Corner_radius{0}, GC::Closure::closed), parameter_outside_domain);
  const Chain back = {base, line(Point(8, 0), Point(1, 0))};
  CHECK_ERROR(GC::round_corners(back, GC::Corner_radius{1}, GC::Closure::open), zero_tangent);
}

BOOST_AUTO_TEST_SUITE_END()
