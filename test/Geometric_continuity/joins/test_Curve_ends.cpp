// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins of curves of several segments, and of the user's own: the decisions read the ends where
// they are.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

BOOST_AUTO_TEST_SUITE(curve_ends)

typedef GC::Traits_2<CGAL::Epick> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Bezier;
typedef GC::Composite_bezier_curve<Traits> Composite;
typedef GC::Bspline_curve<Traits> Bspline;
typedef GC::Bezier_curve<Exact_2> Exact_bezier;

// A Bézier curve of the user's own that opts in.
struct Own_bezier {
  typedef curve_ends::Traits Traits;
  Bezier curve;

  int degree() const { return curve.degree(); }
  const Point& control_point(int i) const { return curve.control_point(i); }
  std::pair<double, double> domain() const { return curve.domain(); }
};

BOOST_AUTO_TEST_SUITE_END()

namespace CGAL {
namespace Geometric_continuity {
template <> struct Curve_ends<curve_ends::Own_bezier> : Bezier_ends<curve_ends::Own_bezier> {};
} // namespace Geometric_continuity
} // namespace CGAL

BOOST_AUTO_TEST_SUITE(curve_ends)

// A model of ParametricCurve that has no control points.
struct Own_curve {
  typedef curve_ends::Traits Traits;
  Bezier curve;

  std::pair<double, double> domain() const { return curve.domain(); }
  GC::Curve_jet<Traits> jet(double u, int k) const { return curve.jet(u, k); }
};

// ------------------------------------------------------ the pieces at the ends, in an exact kernel

template <class Curve> std::vector<Exact_2::Point> exact_points(const Curve& c) {
  std::vector<Exact_2::Point> points;
  for (const Point& p : c) points.emplace_back(Q(p.x()), Q(p.y()));
  return points;
}
template <class Numbers> std::vector<Q> exact_numbers(const Numbers& numbers) {
  std::vector<Q> result;
  for (const double x : numbers) result.emplace_back(x);
  return result;
}

std::vector<Exact_bezier> pieces(const Bezier& c) {
  const std::vector<Exact_2::Point> p = exact_points(c);
  return {Exact_bezier(p.begin(), p.end(), Q(c.domain().first), Q(c.domain().second))};
}
std::vector<Exact_bezier> pieces(const Composite& c) {
  const std::vector<Exact_2::Point> p = exact_points(c);
  const GC::Composite_bezier_curve<Exact_2> exact(p.begin(), p.end(), exact_numbers(c.knots()));
  return {exact.segments().begin(), exact.segments().end()};
}
std::vector<Exact_bezier> pieces(const Bspline& c) {
  const std::vector<Exact_2::Point> p = exact_points(c);
  return GC::Bspline_curve<Exact_2>(p.begin(), p.end(), GC::Knot_vector<Q>(c.degree(), exact_numbers(c.knots())))
      .bezier_pieces();
}

// All decisions about the join of two curves against the one about the pieces at the join. Returns
// its order G.
template <class Left, class Right> int check(const Left& left, const Right& right) {
  const GC::Join_continuity<Q> truth = GC::continuity(pieces(left).back(), pieces(right).front());
  BOOST_CHECK_EQUAL(GC::is_c_join<0>(left, right), truth.c_order >= 0);
  BOOST_CHECK_EQUAL(GC::is_c_join<1>(left, right), truth.c_order >= 1);
  BOOST_CHECK_EQUAL(GC::is_c_join<2>(left, right), truth.c_order >= 2);
  BOOST_CHECK_EQUAL(GC::is_c_join<3>(left, right), truth.c_order >= 3);
  BOOST_CHECK_EQUAL(GC::is_g1_join(left, right), truth.g_order >= 1);
  BOOST_CHECK_EQUAL(GC::is_g2_join(left, right), truth.g_order >= 2);
  BOOST_CHECK_EQUAL(GC::is_g3_join(left, right), truth.g_order >= 3);
  BOOST_CHECK(!GC::is_f3_join(left, right) && !GC::has_equal_torsion(left, right));
  BOOST_CHECK(GC::has_equal_curvature_vector(left, right) == truth.curvature_vector_equal);
  const GC::Join_continuity<Q> join = GC::continuity(left, right);
  BOOST_CHECK_EQUAL(join.c_order, truth.c_order);
  BOOST_CHECK_EQUAL(join.g_order, truth.g_order);
  BOOST_CHECK_EQUAL(join.f_order, truth.f_order);
  BOOST_CHECK(join.betas() == truth.betas());
  BOOST_CHECK(join.curvature_equal == truth.curvature_equal);
  return truth.g_order;
}

std::mt19937_64 engine(2026);
double whole(int n) { return static_cast<double>(static_cast<int>(engine() % (2 * n + 1)) - n); }
std::vector<Point> random_points(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({whole(100), whole(100)});
  return points;
}

// ---------------------------------------------------------------- segmented curves

BOOST_AUTO_TEST_CASE(segmented_curves) {
  const auto piece = [](int x) { // of the parabola y = x^2
    const std::vector<Point> p = {Point(x, x * x), Point(x + 0.5, x * (x + 1)), Point(x + 1, (x + 1) * (x + 1))};
    return Bezier(p.begin(), p.end(), x, x + 1);
  };
  std::vector<Bezier> first, second;
  for (int x = 0; x < 4; ++x) first.push_back(piece(x));
  for (int x = 4; x < 7; ++x) second.push_back(piece(x));
  const Composite left(first.begin(), first.end()), right(second.begin(), second.end());
  BOOST_CHECK_EQUAL(check(left, right), 3);
  BOOST_CHECK_EQUAL(check(right, left), -1); // a gap, although the first segments nearly meet
  const Composite beside(first.begin() + 1, first.end());
  BOOST_CHECK_EQUAL(check(Composite(first.begin(), first.begin() + 1), beside), 3);
  // where reading the end of the first segment sees no gap
  BOOST_CHECK_EQUAL(check(left, beside), -1);
  BOOST_CHECK_EQUAL(check(left, second[0]), 3);
  BOOST_CHECK_EQUAL(check(first[3], right), 3);

  const Bspline left_spline(first.begin(), first.end()), right_spline(second.begin(), second.end());
  BOOST_CHECK_EQUAL(check(left_spline, right_spline), 3);
  BOOST_CHECK_EQUAL(check(left_spline, right), 3);
  BOOST_CHECK_EQUAL(check(right_spline, left_spline), -1);
  BOOST_CHECK_EQUAL(check(left_spline.remove_superfluous_knots(), right_spline.remove_superfluous_knots()), 3);

  // chains of curves of several segments
  const auto is_g2 = [](const auto& x, const auto& y) { return GC::is_g2_join(x, y); };
  const std::vector<Composite> chain = {left, right, beside};
  const std::vector<Bspline> splines = {left_spline, right_spline, left_spline};
  BOOST_CHECK(GC::failing_joins(chain.begin(), chain.end(), is_g2) == std::vector<std::size_t>{1});
  BOOST_CHECK(GC::failing_joins(splines.begin(), splines.end(), is_g2) == std::vector<std::size_t>{1});
}

// ---------------------------------------------------------------- B-splines

// A spline cut at an inner knot of multiplicity m into splines that are not clamped there, by
// taking the control points and knots that each side reads: C^(p-m) by construction. Then one of
// its points is moved by one unit.
BOOST_AUTO_TEST_CASE(splines_that_are_not_clamped) {
  std::cout << "seed 2026\n";
  int orders[5] = {0, 0, 0, 0, 0}; // of the G orders -1 to 3
  for (int round = 0; round < 60; ++round) {
    const int p = 1 + round % 5, m = 1 + static_cast<int>(engine() % p), spans = 3;
    std::vector<double> knots;
    for (int i = -p - spans + 1; i < 0; ++i) knots.push_back(i * (round % 2 ? 1 : 0.3));
    const int cut = static_cast<int>(knots.size()); // the first of the m knots 0
    for (int i = 0; i < m; ++i) knots.push_back(0);
    for (int i = 1; i < p + spans; ++i) knots.push_back(i * (round % 3 ? 1 : 1. / 3));
    std::vector<Point> points = random_points(static_cast<int>(knots.size()) - p - 1);
    const auto part = [&](int first, int last) { // knots first, ..., last-1
      return Bspline(points.begin() + first, points.begin() + (last - p - 1),
                     GC::Knot_vector<double>(p, std::vector<double>(knots.begin() + first, knots.begin() + last)));
    };
    // the domain of the left part ends with the first knot 0, that of the right one starts with the
    // last
    const int left_end = cut + p + 1, right_start = cut + m - 1 - p;
    const Bspline left = part(0, left_end), right = part(right_start, static_cast<int>(knots.size()));
    ++orders[1 + check(left, right)];
    const int j = (std::max)(right_start, 0) + static_cast<int>(engine() % 2);
    points[j] = Point(points[j].x() + 1, points[j].y());
    ++orders[1 + check(left, part(right_start, static_cast<int>(knots.size())))];
    ++orders[1 + check(left.clamp(), right)]; // rounded
  }
  for (int i = 0; i < 5; ++i) BOOST_CHECK_GT(orders[i], 0);
}

// Clamped at the ends, with simple knots inside: no control points of the last piece, so the jet
// decides.
BOOST_AUTO_TEST_CASE(clamped_splines) {
  for (int round = 0; round < 40; ++round) {
    const int p = 2 + round % 3, inner = 3;
    std::vector<GC::Knot_vector<double>::Knot> knots;
    for (int i = 1; i <= inner; ++i) knots.push_back({double(i), 1});
    const GC::Knot_vector<double> u(p, 0, inner + 1, knots);
    const std::vector<Point> a = random_points(u.number_of_coefficients());
    const Bspline left(a.begin(), a.end(), u);
    BOOST_CHECK(!GC::Curve_ends<Bspline>::has_polygon(left, GC::Curve_end::end));
    std::vector<Point> b; // the left curve mirrored at its end: at most G1 there
    for (auto i = a.rbegin(); i != a.rend(); ++i) b.emplace_back(2 * a.back().x() - i->x(), 2 * a.back().y() - i->y());
    const Bspline right(b.begin(), b.end(), u);
    BOOST_CHECK_GE(check(left, right), 1);
    const Bezier start(b.begin(), b.begin() + p + 1);
    BOOST_CHECK_GE(check(left, start), 1);
    b[0] = Point(b[0].x() + 1, b[0].y());
    BOOST_CHECK_EQUAL(check(left, Bspline(b.begin(), b.end(), u)), -1);
  }
}

// In an exact kernel, and where a spline has Bezier points at the end of one curve only.
BOOST_AUTO_TEST_CASE(ends_without_bezier_points) {
  const std::vector<Point> p{Point(0, 0), Point(1, 2), Point(3, 1), Point(4, 4), Point(6, 0)};
  const Bspline plain(p.begin(), p.end(), GC::Knot_vector<double>(3, std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  const Bezier first = plain.bezier_pieces().front(), last = plain.bezier_pieces().back();
  for (int max_order : {0, 3, 4}) {
    const auto order = [&](const auto& x, const auto& y) { return GC::continuity(x, y, max_order).c_order; };
    BOOST_CHECK_EQUAL(order(first, plain), order(first, first));
    BOOST_CHECK_EQUAL(order(plain, last), order(last, last));
    BOOST_CHECK_EQUAL(order(plain, plain), order(last, first));
  }
  const std::vector<Exact_2::Point> q = exact_points(plain);
  const GC::Bspline_curve<Exact_2> exact(q.begin(), q.end(), GC::Knot_vector<Q>(3, exact_numbers(plain.knots())));
  const auto pieces = exact.bezier_pieces();
  BOOST_CHECK(GC::is_c_join<2>(pieces[0], pieces[1]));
  BOOST_CHECK(!GC::is_c_join<0>(exact, exact));
}

// ---------------------------------------------------------------- curves of the user's own

BOOST_AUTO_TEST_CASE(own_curves) {
  const Bezier left{Point(0, 0), Point(1, 1), Point(2, 1)}, right{Point(2, 1), Point(3, 1), Point(4, 0)};
  BOOST_CHECK(GC::is_g2_join(left, right));
  BOOST_CHECK(GC::is_g2_join(Own_bezier{left}, Own_bezier{right}) && GC::is_g2_join(left, Own_bezier{right}));
  BOOST_CHECK(!GC::is_g1_join(Own_bezier{right}, Own_bezier{left}));
  BOOST_CHECK(GC::is_g2_join(Own_curve{left}, Own_curve{right}) && GC::is_g2_join(left, Own_curve{right}));
  BOOST_CHECK(!GC::is_g1_join(Own_curve{right}, Own_curve{left}));
  for (int max_order : {3, 4}) // control points, and jets of them
    BOOST_CHECK_EQUAL(GC::continuity(Own_bezier{left}, Own_bezier{right}, max_order).g_order,
                      GC::continuity(left, right, max_order).g_order);
  BOOST_CHECK(GC::continuity(Own_curve{left}, Own_curve{right}).g_order == GC::continuity(left, right).g_order);
}

BOOST_AUTO_TEST_SUITE_END()
