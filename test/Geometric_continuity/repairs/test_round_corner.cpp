// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// One corner is rounded: the distance of the cuts, the parts, which are exactly parts of the given
// curves, the joins, and what is refused.

#include "support/test.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>

BOOST_AUTO_TEST_SUITE(round_corner)

template <class Traits> using Curve = GC::Bezier_curve<Traits>;
typedef std::vector<std::vector<double>> Rows;

template <class Traits, class FT = typename Traits::FT> Curve<Traits> curve(const Rows& rows) {
  std::vector<typename Traits::Point> points;
  for (const std::vector<double>& row : rows) {
    const std::vector<FT> c(row.begin(), row.end());
    points.push_back(Traits().construct_point_object()(static_cast<int>(c.size()), c.begin(), c.end()));
  }
  return {points.begin(), points.end()};
}

// The arc length between two parameters of the domain, by the speed at the middles of many
// intervals.
template <class Traits, int D> double arc_length(const GC::Bezier_curve<Traits, D>& given, double a, double b) {
  Rows rows;
  for (int j = 0; j <= given.degree(); ++j) {
    rows.emplace_back();
    const auto x = given.coordinates(j);
    for (int i = 0; i < given.dimension(); ++i) rows.back().push_back(CGAL::to_double(x[i]));
  }
  typedef GC::Traits_d<CGAL::Cartesian_d<double>> Rounded;
  const Curve<Rounded> c =
      curve<Rounded>(rows).with_domain(CGAL::to_double(given.domain().first), CGAL::to_double(given.domain().second));
  constexpr int n = 2000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const auto d = c.jet(a + (b - a) * (i + 0.5) / n, 1)[1];
    sum += std::sqrt(dot(d, d)) * (b - a) / n;
  }
  return sum;
}

// The distances of both cuts from the corner are as wanted.
template <class Corner, class Left, class Right>
void check_distances(const Corner& c, const Left& left, const Right& right, double distance) {
  constexpr double allowed = 1e-3 + 1e-5; // the second for the sum
  const double before = arc_length(left, CGAL::to_double(c.left_cut), CGAL::to_double(left.domain().second)),
               after = arc_length(right, CGAL::to_double(right.domain().first), CGAL::to_double(c.right_cut));
  BOOST_TEST_CONTEXT("before " << before << ", after " << after << ", distance " << distance) {
    BOOST_CHECK(std::abs(before - distance) <= allowed * distance);
    BOOST_CHECK(std::abs(after - distance) <= allowed * distance);
  }
}

// The parts are what split() gives, and their control points and domains are equal.
template <class Corner, class Left, class Right>
void check_parts(const Corner& c, const Left& left, const Right& right) {
  const Left l = left.split(c.left_cut).first;
  const Right r = right.split(c.right_cut).second;
  BOOST_REQUIRE(c.left.degree() == left.degree() && c.right.degree() == right.degree());
  for (int j = 0; j <= l.degree(); ++j) BOOST_CHECK(c.left.coordinates(j) == l.coordinates(j));
  for (int j = 0; j <= r.degree(); ++j) BOOST_CHECK(c.right.coordinates(j) == r.coordinates(j));
  BOOST_CHECK(c.left.domain() == l.domain() && c.right.domain() == r.domain());
}

template <class Traits> void check_corner(const Rows& left_rows, const Rows& right_rows, double distance) {
  const Curve<Traits> left = curve<Traits>(left_rows), right = curve<Traits>(right_rows);
  const auto c = GC::round_corner(left, right, distance);
  check_distances(c, left, right, distance);
  check_parts(c, left, right);
  BOOST_CHECK(c.blend.report.fairness <= c.blend.report.automatic_fairness);
  if constexpr (CGAL::Algebraic_structure_traits<typename Traits::FT>::Is_exact::value) {
    BOOST_CHECK(GC::continuity(c.left, c.blend).g_order >= 2);
    BOOST_CHECK(GC::continuity(c.blend, c.right).g_order >= 2);
  } else {
    const GC::Join_deviation d = GC::deviation(c.left, c.blend), e = GC::deviation(c.blend, c.right);
    for (const GC::Join_deviation& x : {d, e}) {
      BOOST_CHECK(x.gap.upper <= 1e-12);
      BOOST_CHECK(x.tangent_angle && x.tangent_angle->upper <= 1e-12);
      if (left.degree() > 1)
        // else of 0
        BOOST_CHECK(x.curvature_jump && x.curvature_jump->upper <= 1e-11 + 1e-13 / distance);
    }
  }
}

// 2, 3 and 4 coordinates: the curves in the plane are bent into the others.
Rows bent(Rows rows, int dimension) {
  for (std::vector<double>& row : rows)
    for (int i = 2; i < dimension; ++i) row.push_back(row[0] * row[0] / 8 - i * row[1]);
  return rows;
}

void check_in_every_space(const Rows& left, const Rows& right, double distance) {
  check_corner<Exact_2>(left, right, distance);
  check_corner<Epeck_2>(left, right, distance);
  check_corner<Double_2>(left, right, distance);
  check_corner<Exact_3>(bent(left, 3), bent(right, 3), distance);
  check_corner<Exact_d>(bent(left, 4), bent(right, 4), distance);
}

const Rows arc = {{-3, -2}, {-2, 1}, {-0.5, 1}, {0, 0}}, hook = {{0, 0}, {1, 2}, {3, 2}, {3, -1}, {2, -2}};

BOOST_AUTO_TEST_CASE(lines) {
  for (const int degrees : {0, 10, 90, 170}) { // the angle by which the direction turns
    const double angle = degrees * std::acos(-1.) / 180;
    BOOST_TEST_CONTEXT("angle " << degrees)
    for (const double distance : {0.125, 1., 3.9})
      check_in_every_space({{-4, 0}, {0, 0}}, {{0, 0}, {4 * std::cos(angle), 4 * std::sin(angle)}}, distance);
  }
}

BOOST_AUTO_TEST_CASE(curves) {
  for (const double distance : {1e-6, 0.3, 1., 2.5}) check_in_every_space(arc, hook, distance);
  check_corner<Exact_2>(arc, {{0, 0}, {-1, -1}, {2, 5}}, 2);
  // slow at the corner, then fast
  check_in_every_space({{-9, 1}, {-0.25, 0}, {0, 0.25}, {0, 0}}, {{0, 0}, {0, 0}, {1, 1}, {9, -1}}, 0.75);
}

// Opposite tangents, of curves that part.
BOOST_AUTO_TEST_CASE(cusps) {
  check_in_every_space({{-3, 2}, {-1, 0}, {0, 0}}, {{0, 0}, {-1, 0}, {-3, -2}}, 1.5);
  check_in_every_space({{-3, 2}, {-1, 0}, {0, 0}}, {{0, 0}, {-2, 0}, {-3, 1}}, 1.5);
}

// A line, and back from a place on it, along it, but with a curvature there: no blend on one line.
BOOST_AUTO_TEST_CASE(bent_back) {
  const Curve<Exact_2> in = curve<Exact_2>({{-100, 0}, {0, 0}}),
                       out = curve<Exact_2>({{0, 0}, {-8, 1}, {-16, -2}, {-24, 3}});
  const auto corner = GC::round_corner(in, out, arc_length(out, 0, 0.5));
  BOOST_CHECK(corner.right_cut == Q(1) / 2);
  BOOST_CHECK_GE(GC::continuity(corner.blend, corner.right).g_order, 2);
}

BOOST_AUTO_TEST_CASE(random_curves) {
  const unsigned seed = 2026;
  std::mt19937 engine(seed);
  const auto number = [&] { return static_cast<double>(engine() % 2001) / 1000 - 1; };
  for (int round = 0; round < 40; ++round) BOOST_TEST_CONTEXT("seed " << seed << ", round " << round) {
      Rows left, right = {{0, 0}};
      for (int j = 0; j < 3; ++j) left.push_back({number(), number()});
      left.push_back({0, 0});
      for (int j = 0; j < 4; ++j) right.push_back({number(), number()});
      const double least = (std::min)(arc_length(curve<Exact_2>(left), 0, 1), arc_length(curve<Exact_2>(right), 0, 1));
      check_corner<Exact_2>(left, right, least * (1 + number()) / 2 * 0.98 + 0.01 * least);
    }
}

// Lines with rational lengths are cut at the distance exactly, and others of one length alike, with
// the number that is nearest to it.
BOOST_AUTO_TEST_CASE(exact_cuts) {
  const auto line = [](const Q& a, const Q& b, const Q& c, const Q& d) {
    return Curve<Exact_2>{Exact_2::Point(a, b), Exact_2::Point(c, d)};
  };
  const auto c = GC::round_corner(line(0, 0, 80, 0), line(80, 0, 80, 50), 12);
  BOOST_CHECK(c.left_cut == Q(68) / 80 && c.right_cut == Q(12) / 50);
  // lengths of 5 and 10/3
  const auto d = GC::round_corner(line(-3, 4, 0, 0), line(0, 0, Q(8) / 3, 2), Q(1) / 7);
  BOOST_CHECK(d.left_cut == Q(34) / 35 && d.right_cut == Q(3) / 70);
  const auto e = GC::round_corner(line(-1, -1, 0, 0), line(0, 0, 1, -1), 1); // twice the root of 2
  BOOST_CHECK(e.left_cut == 1 - e.right_cut && std::abs(CGAL::to_double(e.right_cut) - std::sqrt(0.5)) < 1e-15);
  const auto lazy = GC::round_corner(curve<Epeck_2>({{0, 0}, {80, 0}}), curve<Epeck_2>({{80, 0}, {80, 50}}), 12);
  BOOST_CHECK(CGAL::exact(lazy.left_cut) == c.left_cut && CGAL::exact(lazy.right_cut) == c.right_cut);
  // the blend of lines does not depend on how fast they are run through, and is its own mirror
  // image
  const auto fast = GC::round_corner(line(0, 0, 80, 0), line(80, 0, 80, 50).with_domain(-1, 9), 12);
  for (int j = 0; j <= 5; ++j) {
    const Exact_2::Point p = c.blend.control_point(j), q = c.blend.control_point(5 - j);
    BOOST_CHECK(fast.blend.control_point(j) == p && p == Exact_2::Point(80 - q.y(), 80 - q.x()));
  }
  // of higher degree, and with a domain of its own
  const auto cubic = curve<Exact_2>({{0, 0}, {20, 0}, {40, 0}, {60, 0}}).with_domain(3, 5);
  BOOST_CHECK(GC::round_corner(cubic, line(60, 0, 60, 9), 7).left_cut == 5 - Q(7) / 30);
  // not run through at one speed: a curve like others
  const auto uneven = GC::round_corner(curve<Exact_2>({{0, 0}, {30, 0}, {60, 0}, {60, 0}}), line(60, 0, 60, 9), 7);
  BOOST_CHECK(uneven.right_cut == Q(7) / 9 &&
              uneven.left_cut * 65536 == std::floor(CGAL::to_double(uneven.left_cut) * 65536));
  // rational lines: the weight moves the parameter
  typedef GC::Rational_bezier_curve<Exact_2> Rational;
  const std::vector<Exact_2::Point> points = {{60, 0}, {60, 60}};
  const std::vector<Q> weights = {1, 2};
  const Rational slow(points.begin(), points.end(), weights.begin(), weights.end());
  const auto f = GC::round_corner(Rational(line(0, 0, 60, 0)), slow, 20);
  BOOST_CHECK(f.left_cut == Q(2) / 3 && f.right_cut == Q(1) / 5);
  BOOST_CHECK(f.right.control_point(0) == Exact_2::Point(60, 20));
  // no farther than the curve is long, decided exactly
  CHECK_ERROR(GC::round_corner(line(0, 0, 8, 0), line(8, 0, 8, 9), 8), parameter_outside_domain);
  BOOST_CHECK(GC::round_corner(line(0, 0, 8, 0), line(8, 0, 8, 9), 8 - Q(1) / 1000).left_cut == Q(1) / 8000);
}

// The parameters have few digits, and are the same for mirrored curves, on every kernel.
BOOST_AUTO_TEST_CASE(short_parameters) {
  const auto c = GC::round_corner(curve<Exact_2>(arc), curve<Exact_2>(hook), 0.7);
  BOOST_CHECK(CGAL::to_double(c.left_cut) * 65536 == std::floor(CGAL::to_double(c.left_cut) * 65536));
  BOOST_CHECK(CGAL::to_double(c.right_cut) * 65536 == std::floor(CGAL::to_double(c.right_cut) * 65536));
  const auto mirrored = GC::round_corner(curve<Exact_2>(hook).reverse(), curve<Exact_2>(arc).reverse(), 0.7);
  BOOST_CHECK(mirrored.left_cut == 1 - c.right_cut && mirrored.right_cut == 1 - c.left_cut);
  const auto lazy = GC::round_corner(curve<Epeck_2>(arc), curve<Epeck_2>(hook), 0.7);
  const auto rounded = GC::round_corner(curve<Double_2>(arc), curve<Double_2>(hook), 0.7);
  BOOST_CHECK(CGAL::exact(lazy.left_cut) == c.left_cut && CGAL::exact(lazy.right_cut) == c.right_cut);
  BOOST_CHECK(Q(rounded.left_cut) == c.left_cut && Q(rounded.right_cut) == c.right_cut);
  // a half of a line is found at once
  const Curve<Exact_2> in = curve<Exact_2>({{-2, 0}, {0, 0}}), out = curve<Exact_2>({{0, 0}, {0, 2}});
  BOOST_CHECK(GC::round_corner(in, out, 1).left_cut == Q(1) / 2);
  // the domain of each curve is kept
  const auto d = GC::round_corner(in.with_domain(3, 5), out.with_domain(-Q(1) / 3, 1), 0.5);
  BOOST_CHECK(d.left_cut == Q(9) / 2 && d.right_cut == 0);
  check_parts(d, in.with_domain(3, 5), out.with_domain(-Q(1) / 3, 1));
}

// Coordinates and distances of every size.
BOOST_AUTO_TEST_CASE(sizes) {
  const auto c = GC::round_corner(curve<Exact_2>(arc), curve<Exact_2>(hook), 0.7);
  for (const int e : {-900, -300, 300, 900}) {
    Rows left = arc, right = hook;
    for (Rows* rows : {&left, &right})
      for (std::vector<double>& row : *rows)
        for (double& x : row) x = std::ldexp(x, e);
    const auto d = GC::round_corner(curve<Exact_2>(left), curve<Exact_2>(right), std::ldexp(0.7, e));
    BOOST_CHECK(d.left_cut == c.left_cut && d.right_cut == c.right_cut);
  }
  // a cusp: cubes of these numbers would be zero or infinite
  for (const int e : {-400, 400}) {
    const double x = std::ldexp(1, e);
    const auto d = GC::round_corner(curve<Double_2>({{-3 * x, 2 * x}, {-x, 0}, {0, 0}}),
                                    curve<Double_2>({{0, 0}, {-x, 0}, {-3 * x, -2 * x}}), x);
    BOOST_CHECK(d.left_cut == 1 - d.right_cut && d.blend.report.converged);
  }
  const auto tiny = GC::round_corner(curve<Exact_2>(arc), curve<Exact_2>(hook), 0x1p-300);
  BOOST_CHECK(GC::continuity(tiny.left, tiny.blend).g_order >= 2);
  BOOST_CHECK(GC::continuity(tiny.blend, tiny.right).g_order >= 2);
}

// Other strategies, and degrees that are fixed.
BOOST_AUTO_TEST_CASE(strategies) {
  typedef Exact_3::Point Point;
  const GC::Bezier_curve<Exact_3, 2> left{Point(-3, 0, 1), Point(-1, 1, 2), Point(0, 0, 0)};
  const GC::Bezier_curve<Exact_3, 3> right{Point(0, 0, 0), Point(1, 1, 1), Point(2, 0, 3), Point(3, -1, 0)};
  const auto c = GC::round_corner(left, right, 1, GC::Fair_g3());
  static_assert(std::is_same_v<decltype(c.left), GC::Bezier_curve<Exact_3, 2>>);
  check_parts(c, left, right);
  BOOST_CHECK(c.blend.degree() == 7);
  BOOST_CHECK(GC::continuity(c.left, c.blend).g_order == 3 && GC::continuity(c.blend, c.right).g_order == 3);
  const auto d = GC::round_corner(left, right, 1, GC::Minimal_energy<3>());
  BOOST_CHECK(d.left_cut == c.left_cut && GC::continuity(d.left, d.blend).g_order >= 2);
}

BOOST_AUTO_TEST_CASE(refused) {
  const Curve<Exact_2> in = curve<Exact_2>({{-2, 0}, {0, 0}}), out = curve<Exact_2>({{0, 0}, {0, 3}});
  for (const double x : {0., -1., 5e-324}) CHECK_ERROR(GC::round_corner(in, out, x), parameter_outside_domain);
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_ERROR(GC::round_corner(in, out, x), not_finite);
  CHECK_ERROR(GC::round_corner(in, out, 2), parameter_outside_domain);
  BOOST_CHECK_EQUAL(
      error_of([&] { GC::round_corner(in, out, 2.5); }),
      "parameter_outside_domain: round_corner: the distance 2.5 is not less than the length 2 of the left "
      "curve");
  BOOST_CHECK_EQUAL(error_of([&] { GC::round_corner(out.reverse(), in.reverse(), 2.5); }),
                    "parameter_outside_domain: round_corner: the distance 2.5 is not less than the length 2 of the "
                    "right curve");
  CHECK_ERROR(GC::round_corner(curve<Exact_2>({{0, 0}, {0, 0}}), out, 1), parameter_outside_domain);
  CHECK_ERROR(GC::round_corner(curve<Exact_2>({{0, 0}}), out, 1), parameter_outside_domain);
  CHECK_ERROR(GC::round_corner(out, in, 1), curves_do_not_meet);
  CHECK_ERROR(GC::round_corner(curve<Exact_d>({{-2, 0}, {0, 0}}), curve<Exact_d>({{0, 0, 0}, {0, 0, 3}}), 1),
              dimension_mismatch);
  Q huge(1);
  for (int i = 0; i < 400; ++i) huge *= 10;
  const Curve<Exact_2> far{Exact_2::Point(-huge, 0), Exact_2::Point(0, 0)};
  CHECK_ERROR(GC::round_corner(far, out, 1), not_finite);
  // there and back on one line; a cubic with a cusp in the middle, where it is cut
  CHECK_ERROR(GC::round_corner(in, in.reverse(), 1), zero_tangent);
  CHECK_ERROR(GC::round_corner(curve<Double_2>({{-2, -4}, {0, 0}}), curve<Double_2>({{0, 0}, {-1, -2}}), 1),
              zero_tangent);
  // the same way back
  CHECK_ERROR(GC::round_corner(curve<Exact_2>(arc), curve<Exact_2>(arc).reverse(), 1), zero_direction);
  CHECK_ERROR(GC::round_corner(curve<Double_2>(arc), curve<Double_2>(arc).reverse(), 1), zero_direction);
  const Curve<Exact_2> cusp = curve<Exact_2>({{-1, 0}, {0, 1}, {-1, 1}, {0, 0}});
  const double half = arc_length(cusp, 0, 0.5);
  BOOST_CHECK_EQUAL(error_of([&] { GC::round_corner(cusp, out, half); }),
                    "zero_tangent: round_corner: at the cut of the left curve");
  BOOST_CHECK_EQUAL(error_of([&] { GC::round_corner(out.reverse(), cusp.reverse(), half); }),
                    "zero_tangent: round_corner: at the cut of the right curve");
  BOOST_CHECK(GC::round_corner(cusp, out, half / 2).left_cut > Q(1) / 2); // beside it
}

typedef std::tuple<Exact_2, Epeck_2, Double_2, Exact_3, Double_3, Exact_d> All_traits;
typedef std::tuple<Exact_2, Epeck_2, Exact_d> Exact_planar_traits;

template <class Traits> std::vector<Curve<Traits>> segments(const GC::Composite_bezier_curve<Traits>& blend) {
  std::vector<Curve<Traits>> result;
  for (const auto& segment : blend.segments()) result.emplace_back(segment);
  return result;
}

// All joins of two curves and the cubics between them are G2, and C1 between the cubics.
template <class Traits> void check_cubics(const Curve<Traits>& left, const Curve<Traits>& right, bool single = true) {
  const std::vector<Curve<Traits>> cubics = segments(GC::blend(left, right, GC::Cubics{single}));
  BOOST_CHECK(cubics.size() == 2 && cubics[0].degree() == 3 && cubics[1].degree() == 3);
  BOOST_CHECK(GC::is_g2_join(left, cubics.front()) && GC::is_g2_join(cubics.back(), right));
  const auto inner = GC::continuity(cubics[0], cubics[1]);
  BOOST_CHECK(inner.g_order >= 2 && inner.c_order >= 1);
}

// In the corner of two lines there is one cubic with both handles in it.
TEST_FOR_EACH(a_cubic_between_lines, Traits, All_traits) {
  const int dimension = std::is_same_v<Traits, Exact_d> ? 4 : GC::dimension_v<Traits>;
  Rows left = {{-6, 8}, {0, 0}}, right = {{0, 0}, {5, 0}}, cubic = {{-1.5, 2}, {0, 0}, {0, 0}, {2.5, 0}};
  for (Rows* rows : {&left, &right, &cubic})
    for (std::vector<double>& row : *rows) row.resize(dimension, 0.5);
  const auto c = GC::round_corner(curve<Traits>(left), curve<Traits>(right), 2.5, GC::Cubics());
  const std::vector<Curve<Traits>> cubics = segments(c.blend);
  BOOST_REQUIRE(cubics.size() == 1 && cubics[0].degree() == 3);
  const Curve<Traits> expected = curve<Traits>(cubic);
  for (int j = 0; j <= 3; ++j) BOOST_CHECK(cubics[0].coordinates(j) == expected.coordinates(j));
  BOOST_CHECK(GC::is_g2_join(c.left, cubics[0]) && GC::is_g2_join(cubics[0], c.right));
  CHECK_ERROR(GC::blend(curve<Traits>(left), curve<Traits>({right[1], right[1]}), GC::Cubics()), zero_tangent);
}

// Two cubics join ends in the plane: lines, curves that bend to one side or to both, and random
// ones.
TEST_FOR_EACH(two_cubics, Traits, Exact_planar_traits) {
  const Curve<Traits> line = curve<Traits>({{-1, 0}, {0, 0}}), up = curve<Traits>({{1, 1}, {1, 2}}),
                      along = curve<Traits>({{3, 1}, {5, 1}}), bent = curve<Traits>({{3, 1}, {4, 2}, {4, 5}}),
                      other = curve<Traits>({{3, -1}, {4, -2}, {5, -2}});
  const auto fuller = GC::blend(line, up, GC::Cubics{false}), tight = GC::blend(line, up, GC::Cubics());
  BOOST_CHECK(4 * GC::fairness(fuller) < GC::fairness(tight));
  // the ends are symmetric, and so are the cubics
  for (int j = 0; j <= 6; ++j) {
    const auto p = GC::coordinates<Traits>(fuller.control_points()[j]),
               q = GC::coordinates<Traits>(fuller.control_points()[6 - j]);
    BOOST_CHECK(p[0] == FT(1 - q[1]) && p[1] == FT(1 - q[0]));
  }
  check_cubics(line, up, false);
  check_cubics(line, along);
  check_cubics(line, bent);
  check_cubics(line, other);
  check_cubics(curve<Traits>(arc), bent);
  const auto straight = GC::blend(line, curve<Traits>({{4, 0}, {5, 0}}), GC::Cubics());
  BOOST_CHECK(straight.number_of_segments() == 1 && GC::curvature_extrema(straight).largest().upper == 0);
  CHECK_ERROR(GC::blend(line, curve<Traits>({{-4, 1}, {-3, 1}}), GC::Cubics()), not_representable);
  std::mt19937 engine = seeded(58);
  int found = 0;
  for (int run = 0; run < 20; ++run) {
    const auto random = [&] { return (static_cast<int>(engine() % 201) - 100) / 100.; };
    // both bend to the left
    const Curve<Traits> x = curve<Traits>({{-2, 1 + random()}, {-1, random() / 4}, {0, 0}}),
                        y = curve<Traits>({{3, 1.5}, {3.5 + random() / 4, 2.5}, {3.5 + random() / 4, 5}});
    const auto bends_left = [](const auto& jet) { return GC::signed_curvature(jet)->sign > 0; };
    if (!bends_left(x.end_jet(2)) || !bends_left(y.start_jet(2))) continue;
    check_cubics(x, y);
    ++found;
  }
  BOOST_CHECK(found > 5);
}

BOOST_AUTO_TEST_CASE(cubics_that_are_refused) {
  const auto x = curve<Exact_3>(bent(arc, 3)), y = curve<Exact_3>(bent(hook, 3));
  CHECK_ERROR(GC::round_corner(x, y, 0.5, GC::Cubics()), dimension_mismatch);
  CHECK_ERROR(GC::blend(curve<Exact_d>(arc), curve<Exact_d>(bent(hook, 3)), GC::Cubics()), dimension_mismatch);
  const auto line = curve<Exact_2>({{0, 0}, {4, 0}});
  CHECK_ERROR(GC::round_corner(line, line.reverse(), 1, GC::Cubics()), zero_tangent);
  CHECK_ERROR(GC::blend(line, line.reverse(), GC::Cubics()), zero_direction);
}

BOOST_AUTO_TEST_SUITE_END()
