// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rational Bezier and B-spline curves and arcs of conics: on random curves with big rational
// numbers, where an identity that holds is one, on doubles within the bound of their roundings, and
// where weights are negative or zero.

#include "support/random.h"

#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Geometric_continuity.h>

BOOST_AUTO_TEST_SUITE(rational_curves)

typedef std::tuple<Exact_2, Exact_d, Double_3> All;
typedef std::tuple<Exact_2, Exact_d, Epeck_3> Exact_traits;
typedef std::tuple<Exact_2, Double_2> Planar;
typedef std::tuple<Exact_3, Epick_2, Double_2> Ellipses;

std::mt19937_64 engine(first_seed());

template <class Traits> constexpr bool rounded = std::is_floating_point_v<typename Traits::FT>;

// Between -1 and 1; an exact one has 62 random bits.
template <class FT> FT number() {
  const long x = static_cast<long>(engine() >> 2) - (1L << 61);
  if constexpr (std::is_floating_point_v<FT>)
    return static_cast<double>(x) * 0x1p-61;
  else
    return FT(Q(x) / Q(1L << 61));
}
template <class FT> FT weight() { return FT(number<FT>() + FT(5) / FT(4)); } // in [1/4, 9/4]
template <class FT> FT parameter() { return FT(FT(number<FT>() + FT(1)) / FT(2)); }

template <class Traits> int dimension() { return GC::dimension_v<Traits> == 0 ? 5 : GC::dimension_v<Traits>; }
template <class Traits> typename Traits::Point point() {
  GC::Coordinates<Traits> x(dimension<Traits>());
  for (int i = 0; i < x.dimension(); ++i) x[i] = number<typename Traits::FT>();
  return GC::to_point<Traits>(x);
}
template <class Traits> typename Traits::Vector vector() {
  return GC::to_vector<Traits>(GC::coordinates<Traits>(point<Traits>()));
}

template <class Traits, class FT = typename Traits::FT> GC::Rational_bezier_curve<Traits> curve(int m) {
  std::vector<typename Traits::Point> points;
  std::vector<FT> weights;
  for (int j = 0; j <= m; ++j) {
    points.push_back(point<Traits>());
    weights.push_back(weight<FT>());
  }
  return {points, weights, FT(-1), FT(FT(3) / FT(2))};
}

template <class Traits, class FT = typename Traits::FT> GC::Rational_bspline_curve<Traits> spline(int p) {
  std::vector<FT> knots, weights;
  for (int u : {0, 1, 3, 3, 4, 6, 7}) // unclamped at its end, and a double inner knot
    for (int i = u == 0 ? p : 0; i >= 0; --i) knots.push_back(FT(u));
  while (static_cast<int>(knots.size()) < 3 * p + 5) knots.push_back(FT(FT(static_cast<int>(knots.size()))));
  std::vector<typename Traits::Point> points;
  for (std::size_t i = 0; i + p + 1 < knots.size(); ++i) {
    points.push_back(point<Traits>());
    weights.push_back(weight<FT>());
  }
  return {points, weights, GC::Knot_vector<FT>(p, knots)};
}

// Equal for exact numbers; doubles after `size` in units of 2^-44: a few hundred roundings of
// numbers up to this size.
template <class FT, int N>
bool same(const GC::Coordinate_vector<FT, N>& x, const GC::Coordinate_vector<FT, N>& y, double size = 1) {
  if constexpr (std::is_floating_point_v<FT>) {
    for (int i = 0; i < x.dimension(); ++i)
      if (!(std::abs(x[i] - y[i]) <= 0x1p-44 * size)) return false;
    return x.dimension() == y.dimension();
  } else
    return x == y;
}
template <class Traits> bool same(const GC::Curve_jet<Traits>& x, const GC::Curve_jet<Traits>& y, double size = 1) {
  double factor = size;
  for (int k = 0; k <= x.order(); ++k, factor *= 100)
    if (!same(x[k], y[k], factor)) return false;
  return x.order() == y.order();
}
template <class Traits, class X, class Y> bool same_point(const X& x, const Y& y) {
  return same(GC::coordinates<Traits>(x), GC::coordinates<Traits>(y), 16);
}

template <class Traits> typename Traits::FT square(const GC::Coordinates<Traits>& x) { return dot(x, x); }

// x w = p, derived by Leibniz' rule, on the numerator and the denominator as Bernstein polynomials.
TEST_FOR_EACH(jets_are_those_of_the_quotient, Traits, All) {
  for (int m = 0; m <= 5; ++m) {
    const GC::Rational_bezier_curve<Traits> c = curve<Traits>(m);
    const FT u = FT(FT(-1) + parameter<FT>() * FT(5) / FT(2));
    const auto x = c.jet(u, 6);
    const auto p = c.homogeneous().jet(u, 6);
    std::vector<FT> w;
    for (int k = 0; k <= 6; ++k) w.push_back(p[k][dimension<Traits>()]);
    const auto lifted = lift(static_cast<const GC::Coordinate_jet<FT, GC::dimension_v<Traits>>&>(x), w);
    double size = 1;
    for (int k = 0; k <= 6; ++k, size *= 100) BOOST_CHECK(same(lifted[k], p[k], size));
    BOOST_CHECK(same(c.start_jet(4), c.jet(c.domain().first, 4), 16));
    BOOST_CHECK(same(c.end_jet(4), c.jet(c.domain().second, 4), 16));
    const auto d = c.derivative().jet(u, 3);
    for (int k = 0; k <= 3; ++k) BOOST_CHECK(same(d[k], x[k + 1], std::pow(100, k + 1)));
    BOOST_CHECK(c.derivative().degree() == 2 * m);
  }
  CHECK_ERROR(curve<Traits>(2).jet(FT(0), -1), negative_count);
}

TEST_FOR_EACH(operations_keep_the_points, Traits, All) {
  const GC::Rational_bezier_curve<Traits> c = curve<Traits>(4);
  const FT a = c.domain().first, b = c.domain().second, middle = FT(FT(1) / FT(8));
  const auto parts = c.split(middle);
  const GC::Rational_bezier_curve<Traits, 4> fixed = c;
  BOOST_CHECK((GC::Rational_bezier_curve<Traits>(fixed) == c));
  for (int i = 0; i < 5; ++i) {
    const FT u = FT(a + parameter<FT>() * (b - a));
    const auto x = c.jet(u, 2);
    BOOST_CHECK(same((u < middle ? parts.first : parts.second).jet(u, 2), x));
    BOOST_CHECK(same(c.elevate(3).jet(u, 2), x));
    BOOST_CHECK(same(fixed.template jet<2>(u), x));
    BOOST_CHECK(same(fixed.template elevate_fixed<2>().jet(u, 2), x));
    BOOST_CHECK(same_point<Traits>(c.reverse()(FT(a + b - u)), x.point()));
    BOOST_CHECK(same_point<Traits>(c.with_domain(FT(0), FT(b - a))(FT(u - a)), x.point()));
    BOOST_CHECK(same_point<Traits>(c(u), x.point()));
  }
  BOOST_CHECK(c.reverse().reverse() == c && c.reverse() != c);
  CHECK_ERROR(c.split(a), parameter_outside_domain);
  CHECK_ERROR(c.with_domain(FT(1), FT(1)), empty_domain);
  CHECK_ERROR(c.elevate(-1), negative_count);
}

TEST_FOR_EACH(a_factor_of_all_weights_changes_nothing, Traits, Exact_traits) {
  const GC::Rational_bezier_curve<Traits> c = curve<Traits>(3);
  std::vector<FT> weights;
  const FT factor = weight<FT>();
  for (const FT& w : c.weights()) weights.push_back(FT(factor * w));
  const GC::Rational_bezier_curve<Traits> d(c.begin(), c.end(), weights.begin(), weights.end(), FT(-1),
                                            FT(FT(3) / FT(2)));
  BOOST_CHECK(c != d && c.jet(FT(FT(1) / FT(3)), 4) == d.jet(FT(FT(1) / FT(3)), 4));
}

// Another rational parameter: smooth of every geometric order, and of order 0 in the parameter.
TEST_FOR_EACH(reparametrised_parts_are_geometrically_smooth, Traits, Exact_traits) {
  for (int m = 2; m <= 4; ++m) {
    const auto parts = curve<Traits>(m).split(FT(0));
    const GC::Rational_bezier_curve<Traits> right = parts.second.reparametrised(FT(FT(7) / FT(3)));
    const auto join = GC::continuity(parts.first, right, 5);
    BOOST_CHECK(join.c_order == 0 && join.g_order == 5);
    BOOST_CHECK(GC::continuity(parts.first, parts.second, 5).c_order == 5);
    const GC::Rational_bezier_curve<Traits> other = parts.second.transform([&](const typename Traits::Point& p) {
      return p == parts.second.control_point(2) ? parts.first.control_point(0) : p;
    });
    BOOST_CHECK(GC::continuity(parts.first, other, 5).g_order == 1);
    BOOST_CHECK(GC::is_g1_join(parts.first, other) && !GC::is_g2_join(parts.first, other));
    BOOST_CHECK(GC::is_g2_join(parts.first, right) && GC::is_g3_join(parts.first, right) &&
                GC::continuity(parts.first, right).c_order == 0);
    BOOST_CHECK(GC::order_within(parts.first, right, GC::Join_tolerance()).proved_order() == 3);
    BOOST_CHECK(GC::deviation(parts.first, other).curvature_jump->upper > 0);
  }
  CHECK_ERROR(curve<Traits>(2).reparametrised(FT(0)), zero_weight);
}

TEST_FOR_EACH(polynomial_curves_are_recognised, Traits, All) {
  std::vector<typename Traits::Point> p;
  for (int j = 0; j <= 3; ++j) p.push_back(point<Traits>());
  const GC::Bezier_curve<Traits> c(p.begin(), p.end(), FT(1), FT(3));
  const GC::Rational_bezier_curve<Traits> r = c;
  const std::vector<FT> twos(4, FT(2)), others = {FT(2), FT(2), FT(2), FT(1)};
  BOOST_CHECK(r.is_polynomial() && *r.polynomial() == c && r.weight(2) == FT(1));
  BOOST_CHECK((
      GC::Rational_bezier_curve<Traits>(p.begin(), p.end(), twos.begin(), twos.end(), FT(1), FT(3)).polynomial() == c));
  BOOST_CHECK((!GC::Rational_bezier_curve<Traits>(p.begin(), p.end(), others.begin(), others.end()).polynomial()));
  BOOST_CHECK(same(r.jet(FT(2), 5), c.jet(FT(2), 5)));
  const GC::Rational_bspline_curve<Traits> s{GC::Bspline_curve<Traits>(c)};
  BOOST_CHECK(s.is_polynomial() && *s.polynomial() == GC::Bspline_curve<Traits>(c));
  BOOST_CHECK((GC::is_g3_join(r, GC::Rational_bezier_curve<Traits>(c.with_domain(FT(3), FT(5)).reverse().reverse())) ==
               GC::is_g3_join(c, c)));
}

TEST_FOR_EACH(splines_and_their_pieces, Traits, All) {
  for (int p = 1; p <= 3; ++p) {
    const GC::Rational_bspline_curve<Traits> c = spline<Traits>(p);
    const auto pieces = c.bezier_pieces();
    BOOST_CHECK(pieces.size() == c.knots().spans().size());
    for (const GC::Rational_bezier_curve<Traits>& piece : pieces) {
      const FT a = piece.domain().first, b = piece.domain().second, u = FT(a + parameter<FT>() * (b - a));
      BOOST_CHECK(same(c.jet(u, 3), piece.jet(u, 3), 64));
      BOOST_CHECK(same(c.right_jet(a, 2), piece.jet(a, 2), 64) && same(c.left_jet(b, 2), piece.jet(b, 2), 64));
      BOOST_CHECK(same(c.insert(u, p).jet(u, 0), c.jet(u, 0)));
      const GC::Rational_bspline_curve<Traits> finer = c.insert(u);
      const int k = c.knots().span(u), n = c.number_of_points();
      BOOST_CHECK(same(finer.jet(u, p), c.jet(u, p), 64));
      for (int i = 0; i < n; ++i) // what stays is copied
        if (i <= k - p || k <= i) {
          const int j = i <= k - p ? i : i + 1;
          BOOST_CHECK(finer.coordinates(j) == c.coordinates(i) && finer.weight(j) == c.weight(i));
        }
      BOOST_CHECK(same(c.clamp().jet(u, 2), c.jet(u, 2), 64) && same(c.elevate().jet(u, 2), c.jet(u, 2), 64));
      if constexpr (!rounded<Traits>) {
        BOOST_CHECK(*c.insert(u).remove(u) == c);
        BOOST_CHECK(c.insert(u).remove_superfluous_knots() == c);
      }
      const std::pair<FT, FT> domain = c.domain();
      BOOST_CHECK(same_point<Traits>(c.reverse()(FT(domain.first + domain.second - u)), c(u)));
    }
    BOOST_CHECK(!c.remove(FT(1)));
    CHECK_ERROR(c(FT(-1)), parameter_outside_domain);
    if constexpr (!rounded<Traits>) // joined again, in the parameters as they are
      if (p > 1) {
        const GC::Rational_bspline_curve<Traits> joined(pieces.begin(), pieces.begin() + 2);
        BOOST_CHECK(joined.jet(FT(FT(1) / FT(2)), 2) == c.jet(FT(FT(1) / FT(2)), 2));
      }
  }
  const GC::Rational_bezier_curve<Traits> c = curve<Traits>(2), d = curve<Traits>(2);
  const std::vector<GC::Rational_bezier_curve<Traits>> apart = {c, d}, none;
  CHECK_ERROR((GC::Rational_bspline_curve<Traits>(apart.begin(), apart.end())), curves_do_not_meet);
  CHECK_ERROR((GC::Rational_bspline_curve<Traits>(none.begin(), none.end())), wrong_number_of_points);
}

TEST_FOR_EACH(the_denominator_must_be_positive, Traits, All) {
  const std::vector<typename Traits::Point> p = {point<Traits>(), point<Traits>(), point<Traits>()};
  const auto make = [&](const FT& a, const FT& b, const FT& c) {
    const std::vector<FT> w = {a, b, c};
    return GC::Rational_bezier_curve<Traits>(p.begin(), p.end(), w.begin(), w.end());
  };
  const FT nearly = FT(FT(-1023) / FT(1024));
  CHECK_ERROR(make(FT(1), FT(-1), FT(1)), zero_weight); // touches zero in the middle
  CHECK_ERROR(make(FT(1), FT(-2), FT(1)), zero_weight);
  CHECK_ERROR(make(FT(0), FT(1), FT(1)), zero_weight);
  CHECK_ERROR(make(FT(1), FT(1), FT(-1)), zero_weight);
  CHECK_ERROR(make(FT(-1), FT(-1), FT(-1)), zero_weight);
  const GC::Rational_bezier_curve<Traits> c = make(FT(1), nearly, FT(1));
  BOOST_CHECK(c.weight(1) == nearly);
  const auto box = c.bounding_box();
  BOOST_CHECK(make(FT(1), FT(3), FT(2)).bounding_box() == GC::Bezier_curve<Traits>(p.begin(), p.end()).bounding_box());
  for (int k : {3, 4, 6}) { // jets of any order: those of the piece
    const GC::Rational_bspline_curve<Traits> spline(make(FT(1), FT(2), FT(1)));
    const auto jet = spline.jet(FT(FT(1) / FT(4)), k), other = make(FT(1), FT(2), FT(1)).jet(FT(FT(1) / FT(4)), k);
    BOOST_REQUIRE(jet.order() == k && other.order() == k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < jet.dimension(); ++i)
        if constexpr (std::is_floating_point_v<FT>) // a few roundings apart
          BOOST_CHECK_SMALL(FT(jet[j][i] - other[j][i]), 0x1p-48 * (1 + std::abs(jet[j][i])));
        else
          BOOST_CHECK(jet[j][i] == other[j][i]);
  }
  for (int i = 0; i <= 64; ++i) {
    const auto x = GC::coordinates<Traits>(c(FT(FT(i) / FT(64)))), low = GC::coordinates<Traits>(box.first),
               high = GC::coordinates<Traits>(box.second);
    for (int k = 0; k < x.dimension(); ++k) BOOST_CHECK(!(x[k] < low[k]) && !(high[k] < x[k]));
  }
  for (const auto& part : c.positive_parts())
    for (const FT& w : part.weights()) BOOST_CHECK(FT(0) < w);
  // a spline that is zero between its knots
  const std::vector<FT> w = {FT(1), FT(-1), FT(1)}, v = {FT(1), nearly, FT(1)};
  CHECK_ERROR((GC::Rational_bspline_curve<Traits>(p.begin(), p.end(), w.begin(), w.end(),
                                                  GC::Knot_vector<FT>(2, FT(0), FT(1)))),
              zero_weight);
  BOOST_CHECK(
      (GC::Rational_bspline_curve<Traits>(p.begin(), p.end(), v.begin(), v.end(), GC::Knot_vector<FT>(2, FT(0), FT(1)))
           .number_of_points() == 3));
  CHECK_ERROR((GC::Rational_bezier_curve<Traits>(p.begin(), p.end(), w.begin(), w.end() - 1)), wrong_number_of_points);
  CHECK_ERROR((GC::Rational_bezier_curve<Traits, 2>(p.begin(), p.end(), w.begin(), w.end() - 1)),
              wrong_number_of_points);
  CHECK_ERROR((GC::Rational_bspline_curve<Traits>(p.begin(), p.end(), w.begin(), w.end() - 1,
                                                  GC::Knot_vector<FT>(2, FT(0), FT(1)))),
              wrong_number_of_points);
}

// Derivatives of the denominator that go beyond the order of the jet are not taken.
BOOST_AUTO_TEST_CASE(lifted_with_more_weights) {
  GC::Coordinate_jet<double, 2> x(2, 1);
  x[0][0] = 3;
  x[1][1] = 5;
  const auto few = GC::lift(x, std::vector<double>{2, 7}), more = GC::lift(x, std::vector<double>{2, 7, 11});
  BOOST_REQUIRE(few.order() == 1 && more.order() == 1);
  for (int j = 0; j <= 1; ++j) BOOST_CHECK(few[j] == more[j]);
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_is_refused) {
  const std::vector<Double_2::Point> p = {{0, 0}, {1, 1}};
  for (double w : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    const std::vector<double> weights = {1, w};
    CHECK_ERROR((GC::Rational_bezier_curve<Double_2>(p.begin(), p.end(), weights.begin(), weights.end())), not_finite);
  }
  const std::vector<Double_2::Point> far = {{0, 0}, {1e300, 1}};
  const std::vector<double> heavy = {1, 1e300};
  CHECK_ERROR((GC::Rational_bezier_curve<Double_2>(far.begin(), far.end(), heavy.begin(), heavy.end()).homogeneous()),
              not_finite);
}

// Half a circle has an infinite control point.
TEST_FOR_EACH(infinite_control_points, Traits, Planar) {
  typedef typename Traits::Point Point;
  const GC::Rational_bezier_curve<Traits, 2> half = GC::circular_arc<Traits>(Point(2, 1), Point(3, 1), FT(1));
  BOOST_CHECK(half.weight(1) == FT(0) && half.control_point(1) == Point(0, 1) &&
              half(FT(FT(1) / FT(2))) == Point(2, 2));
  const CGAL::Aff_transformation_2<typename Traits::Kernel> shift(CGAL::TRANSLATION, typename Traits::Vector(10, 20));
  BOOST_CHECK(half.transform(shift)(FT(FT(1) / FT(2))) == Point(12, 22));
  BOOST_CHECK(half.reverse()(FT(FT(1) / FT(2))) == Point(2, 2) && half.reverse().end_jet(1).point() == Point(3, 1));
  const auto parts = half.split(FT(FT(1) / FT(2)));
  BOOST_CHECK(FT(0) < parts.first.weight(1) && parts.first.control_point(1) == Point(3, 2));
  BOOST_CHECK(half.bounding_box().first == Point(1, 1) && half.bounding_box().second == Point(3, 2));
  BOOST_CHECK((GC::Rational_bspline_curve<Traits>(GC::Rational_bezier_curve<Traits>(half))
                   .bezier_pieces()
                   .front()(FT(FT(1) / FT(2))) == Point(2, 2)));
  // given as a point and the weight 0, it contributes nothing
  const GC::Rational_bezier_curve<Traits> flat({Point(0, 0), Point(7, 9), Point(1, 0)}, {FT(1), FT(0), FT(1)});
  BOOST_CHECK(flat(FT(FT(1) / FT(2))) == Point(FT(FT(1) / FT(2)), FT(0)) && flat.control_point(1) == Point(0, 0));
}

TEST_FOR_EACH(arcs_lie_on_their_circles, Traits, Exact_traits) {
  const auto on_circle = [](const auto& arc, const GC::Coordinates<Traits>& centre, const FT& radius_squared) {
    for (int i = 0; i <= 8; ++i)
      if (square<Traits>(GC::coordinates<Traits>(arc(FT(FT(i) / FT(8)))) - centre) != radius_squared) return false;
    return true;
  };
  const auto at = [](const auto& p) { return GC::coordinates<Traits>(p); };
  for (int i = 0; i < 8; ++i) {
    const auto p = point<Traits>(), q = point<Traits>(), r = point<Traits>();
    const auto arc = GC::circular_arc_through<Traits>(p, q, r);
    BOOST_CHECK(at(arc(FT(0))) == at(p) && at(arc(FT(FT(1) / FT(2)))) == at(q) && at(arc(FT(1))) == at(r));
    // the centre from the end: p + the multiple of the curvature vector
    const auto k = GC::coordinates<Traits>(*GC::curvature_vector(arc.start_jet(2)));
    const GC::Coordinates<Traits> centre = at(p) + k / FT(dot(k, k));
    BOOST_CHECK(on_circle(arc, centre, FT(FT(1) / FT(dot(k, k)))));
    const auto t = vector<Traits>();
    const auto with_tangent = GC::circular_arc_with_tangent<Traits>(p, t, r);
    const auto jet = with_tangent.start_jet(2);
    const FT length = FT(dot(jet[1], at(t)) / dot(at(t), at(t)));
    BOOST_CHECK(FT(0) < length && jet[1] == length * at(t) && at(with_tangent(FT(1))) == at(r));
    const auto k2 = GC::coordinates<Traits>(*GC::curvature_vector(jet));
    BOOST_CHECK(on_circle(with_tangent, at(p) + k2 / FT(dot(k2, k2)), FT(FT(1) / FT(dot(k2, k2)))));
    // of an ellipse with the half-axes u, v: (x - c) = a u + b v with a^2 + b^2 = 1
    const auto u = vector<Traits>(), v = vector<Traits>();
    const FT angle = FT(number<FT>() * FT(8));
    const auto e = GC::elliptical_arc<Traits>(p, u, v, angle);
    for (int j = 0; j <= 4; ++j) {
      const GC::Coordinates<Traits> x = at(e(FT(FT(j) / FT(4)))) - at(p);
      const FT uu = dot(at(u), at(u)), uv = dot(at(u), at(v)), vv = dot(at(v), at(v)), ux = dot(at(u), x),
               vx = dot(at(v), x), det = FT(uu * vv - uv * uv);
      const FT a = FT((ux * vv - vx * uv) / det), b = FT((vx * uu - ux * uv) / det);
      BOOST_CHECK(FT(a * a + b * b) == FT(1) && a * at(u) + b * at(v) == x);
    }
    CHECK_ERROR(GC::circular_arc_through<Traits>(p, q, p), zero_direction);
    CHECK_ERROR(GC::circular_arc_through<Traits>(p, p, q), zero_direction);
    CHECK_ERROR(GC::circular_arc_through<Traits>(p, q, q), zero_direction);
    CHECK_ERROR(GC::circular_arc_with_tangent<Traits>(p, t, p), zero_direction);
    CHECK_ERROR(GC::elliptical_arc<Traits>(p, u, v, FT(0)), empty_domain);
    // on a line: a segment, or nothing
    const auto towards = [&](int n) { return GC::to_point<Traits>(at(p) + FT(FT(n) / FT(4)) * (at(r) - at(p))); };
    BOOST_CHECK(at(GC::circular_arc_through<Traits>(p, towards(1), r)(FT(FT(1) / FT(2)))) == at(towards(1)));
    BOOST_CHECK(*GC::curvature_squared(GC::circular_arc_through<Traits>(p, towards(1), r).start_jet(2)) == FT(0));
    CHECK_ERROR(GC::circular_arc_through<Traits>(p, towards(5), r), zero_weight);
    CHECK_ERROR(GC::circular_arc_with_tangent<Traits>(p, GC::to_vector<Traits>(at(p) - at(r)), r), zero_weight);
  }
}

// Points of a kernel tell their traits class.
BOOST_AUTO_TEST_CASE(arcs_of_points_of_a_kernel) {
  const Exact_2::Point a(1, 2), b(4, 6), c(-3, 7);
  const Exact_2::Vector u(1, 2), v(-3, 1);
  const Exact_3::Point d(1, 2, 3), e(4, 6, 1);
  const Exact_3::Vector axis(1, -1, 2);
  const Q r = Q(1) / Q(3);
  BOOST_CHECK(GC::circular_arc(a, b, r) == GC::circular_arc<Exact_2>(a, b, r));
  BOOST_CHECK(GC::circular_arc(d, e, axis, r) == GC::circular_arc<Exact_3>(d, e, axis, r));
  BOOST_CHECK(GC::elliptical_arc(a, u, v, r) == GC::elliptical_arc<Exact_2>(a, u, v, r));
  BOOST_CHECK(GC::circular_arc_through(a, b, c) == GC::circular_arc_through<Exact_2>(a, b, c));
  BOOST_CHECK(GC::circular_arc_with_tangent(a, u, c) == GC::circular_arc_with_tangent<Exact_2>(a, u, c));
  BOOST_CHECK(GC::conic_arc(a, u, b, v, Exact_2::Point(3, 5)) ==
              GC::conic_arc<Exact_2>(a, u, b, v, Exact_2::Point(3, 5)));
  BOOST_CHECK(GC::ellipse(a, u, v) == GC::ellipse<Exact_2>(a, u, v));
  BOOST_CHECK(GC::ellipse<Exact_2>(CGAL::ORIGIN, u, v) ==
              GC::ellipse(Exact_2::Point(0, 0), u, v)); // what converts to points
}

BOOST_AUTO_TEST_CASE(arcs_about_a_centre_and_an_axis) {
  const Exact_2::Point centre(1, 2), start(Q(1) / Q(3), 5);
  for (const Q& r : std::vector<Q>{Q(1) / Q(9), Q(2), Q(1), Q(-3) / Q(7)}) {
    const auto arc = GC::circular_arc<Exact_2>(centre, start, r);
    BOOST_CHECK(arc(Q(0)) == start);
    const Exact_2::Vector x = arc(Q(1)) - centre, a = start - centre;
    // the tangent of half the angle 4 atan(r) is 2 r / (1 - r^2)
    const Q cosine = x * a / a.squared_length(), sine = (a.x() * x.y() - a.y() * x.x()) / a.squared_length();
    BOOST_CHECK(cosine * cosine + sine * sine == 1 && (Q(1) - r * r) * sine == Q(2) * r * (Q(1) + cosine));
    const auto turn = GC::signed_curvature(arc.start_jet(2));
    BOOST_CHECK(turn->sign == (r < 0 ? -1 : 1) && turn->square == Q(1) / a.squared_length());
    for (int i = 0; i <= 8; ++i) BOOST_CHECK((arc(Q(i) / Q(8)) - centre).squared_length() == a.squared_length());
  }
  CHECK_ERROR(GC::circular_arc<Exact_2>(centre, centre, Q(1)), zero_direction);
  CHECK_ERROR(GC::circular_arc<Exact_2>(centre, start, Q(0)), empty_domain);

  const Exact_3::Vector axis(1, 2, 3);
  const Exact_3::Point foot(4, 5, 6), from(1, 1, 7);
  for (const Q& r : std::vector<Q>{Q(1) / Q(9), Q(2), Q(-3) / Q(7)}) {
    const auto arc = GC::circular_arc<Exact_3>(foot, from, axis, r);
    const Q height = (from - foot) * axis;
    BOOST_CHECK(arc(Q(0)) == from);
    for (int i = 0; i <= 8; ++i) {
      const Exact_3::Vector x = arc(Q(i) / Q(8)) - foot;
      BOOST_CHECK(x * axis == height && x.squared_length() == (from - foot).squared_length());
    }
    // the rotation of the end, as surfaces of revolution make it: tan(angle / 2) / |axis|
    const Q tangent = Q(2) * r / (Q(1) - r * r * axis.squared_length());
    const Exact_3::Vector x = from - foot, along = (height / axis.squared_length()) * axis, u = x - along;
    const Q s = tangent * tangent * axis.squared_length();
    const Exact_3::Vector turned =
        ((Q(1) - s) / (Q(1) + s)) * u + (Q(2) * tangent / (Q(1) + s)) * CGAL::cross_product(axis, u);
    BOOST_CHECK(arc(Q(1)) == foot + along + turned);
  }
  CHECK_ERROR(GC::circular_arc<Exact_3>(foot, foot + axis, axis, Q(1)), zero_direction);
  CHECK_ERROR(GC::circular_arc<Exact_3>(foot, from, Exact_3::Vector(0, 0, 0), Q(1)), zero_direction);
}

BOOST_AUTO_TEST_CASE(arcs_of_conics) {
  const Exact_2::Point p(0, 0), r(4, 0), q(1, 2);
  for (const Exact_2::Vector& end : {Exact_2::Vector(1, -3), Exact_2::Vector(0, 3), Exact_2::Vector(-1, -5)}) {
    const auto arc = GC::conic_arc<Exact_2>(p, Exact_2::Vector(0, 1), r, end, q);
    BOOST_CHECK(arc(Q(0)) == p && arc(Q(1)) == r && arc(Q(1) / Q(2)) == q);
    const auto a = arc.start_jet(1)[1], b = arc.end_jet(1)[1];
    BOOST_CHECK(a[0] == 0 && a[1] > 0 && b[0] * end.y() == b[1] * end.x());
  }
  CHECK_ERROR(GC::conic_arc<Exact_2>(p, Exact_2::Vector(1, 0), r, Exact_2::Vector(0, 1), q), singular_frame);
  CHECK_ERROR(GC::conic_arc<Exact_2>(p, Exact_2::Vector(0, 1), r, Exact_2::Vector(1, 0), q), singular_frame);
  CHECK_ERROR(GC::conic_arc<Exact_2>(p, Exact_2::Vector(0, 0), r, Exact_2::Vector(1, 0), q), zero_direction);
  CHECK_ERROR(GC::conic_arc<Exact_2>(p, Exact_2::Vector(0, 1), r, Exact_2::Vector(1, -3), Exact_2::Point(-1, -2)),
              zero_weight);
  // in space, where the projection counts
  const auto arc = GC::conic_arc<Exact_3>({0, 0, 0}, {0, 1, 0}, {4, 0, 0}, {1, -3, 9}, {1, 2, 5});
  BOOST_CHECK(arc(Q(1) / Q(2)) == Exact_3::Point(1, 2, 0));
}

TEST_FOR_EACH(an_ellipse_is_closed_and_smooth, Traits, Ellipses) {
  GC::Coordinates<Traits> c(dimension<Traits>()), u = c, v = c;
  c[0] = FT(1);
  u[0] = FT(3);
  v[1] = FT(2);
  const auto e = GC::ellipse<Traits>(GC::to_point<Traits>(c), GC::to_vector<Traits>(u), GC::to_vector<Traits>(v));
  const auto quarters = e.bezier_pieces();
  BOOST_REQUIRE(quarters.size() == 4);
  for (int i = 0; i < 4; ++i) {
    const auto join = GC::continuity(quarters[i], quarters[(i + 1) % 4], 3);
    BOOST_CHECK(join.c_order >= 1 && join.g_order == 3);
    BOOST_CHECK(GC::is_g2_join(quarters[i], quarters[(i + 1) % 4]));
  }
  const auto extrema = GC::curvature_extrema(e); // from a vertex to itself: three others between
  BOOST_CHECK(extrema.extrema.size() == 3 && extrema.inflections.empty());
  BOOST_CHECK(extrema.greatest.curvature.lower <= 0.75 && 0.75 <= extrema.greatest.curvature.upper);
  BOOST_CHECK(extrema.least.curvature.lower <= 2 / 9. && 2 / 9. <= extrema.least.curvature.upper);
  BOOST_CHECK(GC::fairness(e) > 1);
}

// Exact values for circles: no variation of curvature, and the energy is the square of the angle.
BOOST_AUTO_TEST_CASE(measures_of_circles) {
  const auto arc = GC::circular_arc<Exact_2>({1, 2}, {4, 6}, Q(1) / Q(2));
  const double angle = 4 * std::atan(0.5);
  BOOST_CHECK_SMALL(GC::fairness(arc), 1e-20);
  BOOST_CHECK_CLOSE_FRACTION(GC::bending_energy(arc), angle * angle, 1e-8);
  const auto circle = GC::ellipse<Double_3>({0, 0, 0}, {0, 3e150, 0}, {0, 0, 3e150});
  BOOST_CHECK_CLOSE_FRACTION(GC::bending_energy(circle), 4 * M_PI * M_PI, 1e-8);
  const auto extrema = GC::curvature_extrema(arc);
  BOOST_CHECK(extrema.extrema.empty() && extrema.inflections.empty());
  BOOST_CHECK(extrema.greatest.curvature.lower <= 0.2 && 0.2 <= extrema.greatest.curvature.upper);
  // a cubic with an inflection, in another parameter
  const GC::Rational_bezier_curve<Exact_2> s({{0, 0}, {1, 2}, {2, -2}, {3, 0}}, {Q(1), Q(1), Q(1), Q(1)});
  const auto before = GC::curvature_extrema(s), after = GC::curvature_extrema(s.reparametrised(Q(3)));
  BOOST_CHECK(before.inflections.size() == 1 && after.inflections.size() == 1);
  BOOST_CHECK(before.extrema.size() == after.extrema.size() && before.extrema.size() == 2);
  BOOST_CHECK_CLOSE_FRACTION(before.greatest.curvature.upper, after.greatest.curvature.upper, 1e-8);
  BOOST_CHECK_CLOSE_FRACTION(GC::fairness(s), GC::fairness(s.reparametrised(Q(3))), 1e-6);
}

BOOST_AUTO_TEST_CASE(lines_and_arcs) {
  const GC::Rational_bezier_curve<Exact_2> line(GC::Bezier_curve<Exact_2>{{-5, 0}, {0, 0}}),
      arc = GC::circular_arc<Exact_2>({0, 2}, {0, 0}, Q(1) / Q(3)),
      larger = GC::circular_arc<Exact_2>({0, 3}, {0, 0}, Q(1) / Q(3));
  const auto join = GC::continuity(line, arc);
  BOOST_CHECK(join.g_order == 1 && *join.tangent_equal && !*join.curvature_equal);
  BOOST_CHECK(GC::continuity(arc.reverse(), larger).g_order == 0); // back on the same side
  const auto d = GC::deviation(line, arc);
  BOOST_CHECK(d.curvature_jump->lower <= 1 && 1 <= d.curvature_jump->upper);
  // a blend from the line to the arc, exactly curvature continuous, and fair
  const auto gamma = GC::blend(line, arc.split(Q(1) / Q(2)).second, GC::Fair());
  BOOST_CHECK(GC::is_g2_join(line, gamma) && GC::is_g2_join(gamma, arc.split(Q(1) / Q(2)).second));
  BOOST_CHECK(GC::knot_continuity(GC::Rational_bspline_curve<Exact_2>(arc).insert(Q(1) / Q(2)), Q(1) / Q(2)).c_order ==
              3);
}

// All vertices on the circle, and the middle of each chord no farther away than the tolerance;
// boxes that contain what they should.
TEST_FOR_EACH(polylines_and_boxes, Traits, Planar) {
  typedef typename Traits::Point Point;
  const auto arc = GC::circular_arc<Traits>(Point(0, 0), Point(1, 0), FT(3)); // 286 degrees
  for (int n : {10, 1000, 100000}) {
    std::vector<Point> vertices;
    GC::chord_polyline(arc, FT(FT(1) / FT(n)), std::back_inserter(vertices));
    const double tolerance = 1. / n;
    BOOST_CHECK(vertices.size() > std::sqrt(n) && vertices.size() < 8 * std::sqrt(n) + 8);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const double x = CGAL::to_double(vertices[i].x()), y = CGAL::to_double(vertices[i].y());
      BOOST_CHECK_SMALL(std::hypot(x, y) - 1, 0x1p-48);
      if (i == 0) continue;
      const double px = CGAL::to_double(vertices[i - 1].x()), py = CGAL::to_double(vertices[i - 1].y());
      BOOST_CHECK(1 - std::hypot((x + px) / 2, (y + py) / 2) <= tolerance);
    }
  }
  std::vector<GC::Curve_piece_box<Traits, int>> boxes;
  GC::bounding_boxes(GC::ellipse<Traits>(Point(0, 0), {3, 0}, {0, 2}), 4, 7, std::back_inserter(boxes));
  BOOST_REQUIRE(boxes.size() == 64);
  const auto e = GC::ellipse<Traits>(Point(0, 0), {3, 0}, {0, 2});
  for (const auto& box : boxes)
    for (int i = 0; i <= 4; ++i) {
      const FT t = FT(FT(i) / FT(4)), u = FT((FT(1) - t) * box.interval().first + t * box.interval().second);
      const Point x = e(u);
      for (int k = 0; k < 2; ++k)
        BOOST_CHECK(box.min_coord(k) <= CGAL::to_double(x[k]) && CGAL::to_double(x[k]) <= box.max_coord(k) &&
                    box.max_coord(k) - box.min_coord(k) < 0.5);
    }
}

// The next segment behind a rational curve is polynomial and has its jet there.
TEST_FOR_EACH(extensions, Traits, Exact_traits) {
  for (int m = 1; m <= 4; ++m) {
    const GC::Rational_bezier_curve<Traits> c = curve<Traits>(m);
    const GC::Rational_bspline_curve<Traits> s(c);
    for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion}) {
      const int k = static_cast<int>(order);
      const GC::Bezier_curve<Traits> next = extend(c, order, {FT(2), FT(FT(1) / FT(3))});
      BOOST_CHECK(next.degree() == (std::max)(m, k));
      BOOST_CHECK_GE(GC::continuity(c, next).f_order, (std::min)(k, dimension<Traits>()));
      const auto wished = point<Traits>();
      const GC::Bezier_curve<Traits> toward = extend_toward(c, order, wished);
      BOOST_CHECK_GE(GC::continuity(c, toward).f_order, (std::min)(k, dimension<Traits>()));
      if (m > k) BOOST_CHECK(toward.control_point(m) == wished);
      if (m < k) {
        CHECK_ERROR(extend(s, order), wrong_number_of_points);
        continue;
      }
      const GC::Rational_bspline_curve<Traits> longer = extend(s, order, {FT(2), FT(FT(1) / FT(3))});
      BOOST_CHECK(longer.left_jet(c.domain().second, 4) == c.end_jet(4));
      BOOST_CHECK(longer.right_jet(c.domain().second, 3) == next.start_jet(3));
      BOOST_CHECK(longer.end_jet(2) == next.end_jet(2));
      BOOST_CHECK(extend_toward(s, order, wished).end_jet(2) == toward.end_jet(2));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
