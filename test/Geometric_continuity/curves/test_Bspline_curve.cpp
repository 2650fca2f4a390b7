// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// B-spline curves.

#include "support/archetype.h"
#include "support/splines.h"

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>

// The i-th coordinate as a function.
template <class Traits> Function<typename Traits::FT> coordinate(const GC::Bspline_curve<Traits>& c, int i) {
  std::vector<typename Traits::FT> x;
  for (int j = 0; j < c.number_of_points(); ++j) x.push_back(c.coordinates(j)[i]);
  return Function<typename Traits::FT>(c.knots(), x);
}

// Curves do what functions do, coordinate by coordinate, with the same arithmetic: compared with ==
// in floating point, too.
template <class Traits, class Test> void in_each_coordinate(const GC::Bspline_curve<Traits>& c, Test test) {
  for (int i = 0; i < c.dimension(); ++i) test(coordinate(c, i), i);
}

template <class Traits, class FT = typename Traits::FT>
void check_curve_operations(Random<typename Traits::FT>& random, int d) {
  typedef GC::Bspline_curve<Traits> Curve;
  const int p = random.integer(0, 4);
  const Curve c = random.template curve<Traits>(random.knots(p, p + 1), d);
  BOOST_CHECK_EQUAL(c.dimension(), d);
  BOOST_CHECK_EQUAL(c.degree(), p);
  BOOST_CHECK(c.domain() == c.knots().domain());
  BOOST_CHECK(Curve(c.function()) == c);
  const GC::Knot_vector<FT> knots = finer(c.knots(), random);
  const FT u = random.between(c.domain().first, c.domain().second);
  const Function<FT> factor(GC::Knot_vector<FT>(2, c.domain().first, c.domain().second), random.numbers(3));
  const int times = c.knots().multiplicity(u) > p ? 0 : 1;
  const Curve derivative = c.derivative(), refined = c.refine(knots), inserted = c.insert(u, times),
              elevated = c.elevate(2), reversed = c.reverse(), clamped = c.clamp(), scaled = product(factor, c),
              minimal = refined.remove_superfluous_knots();
  BOOST_CHECK_EQUAL(c.insert(u, 0), c);
  in_each_coordinate(c, [&](const Function<FT>& x, int i) {
    BOOST_CHECK(coordinate(derivative, i) == x.derivative());
    BOOST_CHECK(coordinate(refined, i) == x.refine(knots));
    BOOST_CHECK(coordinate(inserted, i) == x.insert(u, times));
    BOOST_CHECK(coordinate(elevated, i) == x.elevate(2));
    BOOST_CHECK(coordinate(reversed, i) == x.reverse());
    BOOST_CHECK(coordinate(clamped, i) == x.clamp());
    BOOST_CHECK(coordinate(scaled, i) == factor * x);
    for (const FT& v : parameters(c.knots(), random)) {
      const std::vector<FT> right = x.right_derivatives(v, p + 1), left = x.left_derivatives(v, p + 1);
      const GC::Curve_jet<Traits> jet = c.jet(v, p + 1), right_jet = c.right_jet(v, p + 1),
                                  left_jet = c.left_jet(v, p + 1);
      BOOST_CHECK_EQUAL(jet.order(), p + 1);
      for (int j = 0; j <= p + 1; ++j) {
        BOOST_CHECK(jet[j][i] == right[j]);
        BOOST_CHECK(right_jet[j][i] == right[j]);
        BOOST_CHECK(left_jet[j][i] == left[j]);
      }
      BOOST_CHECK(GC::coordinates<Traits>(c(v))[i] == x(v));
    }
    BOOST_CHECK(c.start_jet(3)[2][i] == x.right_derivatives(c.domain().first, 2)[2]);
    BOOST_CHECK(c.end_jet(3)[2][i] == x.left_derivatives(c.domain().second, 2)[2]);
  });
  if (c.knots().is_clamped()) { // exactly, in floating point as well
    BOOST_CHECK(c.start_jet(2)[0] == c.coordinates(0));
    BOOST_CHECK(c.end_jet(2)[0] == c.coordinates(c.number_of_points() - 1));
  }
  if constexpr (exact_v<FT>) {
    BOOST_CHECK(minimal == c || minimal.knots() != c.knots());
    for (const Knot<FT>& knot : c.knots().inner_knots()) BOOST_CHECK(!c.remove(knot.value));
    if (c.knots().multiplicity(u) == 0) BOOST_CHECK(*c.insert(u).remove(u) == c);
  }
  for (const FT& v : {FT(c.domain().first - FT(1)), FT(c.domain().second + FT(1))}) {
    CHECK_ERROR(c(v), parameter_outside_domain);
    CHECK_ERROR(c.jet(v, 2), parameter_outside_domain);
    CHECK_ERROR(c.left_jet(v, 2), parameter_outside_domain);
    CHECK_ERROR(c.insert(v), parameter_outside_domain);
  }
}

TEST_FOR_EACH(curves_are_functions_in_each_coordinate, K, Kernels) {
  repeat<FT>(12, [](Random<FT>& random) {
    check_curve_operations<GC::Traits_2<K>>(random, 2);
    check_curve_operations<GC::Traits_3<K>>(random, 3);
  });
}

BOOST_AUTO_TEST_CASE(curves_in_higher_dimension) {
  repeat<Q>(10, [](Random<Q>& random) {
    check_curve_operations<GC::Traits_d<CGAL::Cartesian_d<Q>>>(random, 1);
    check_curve_operations<GC::Traits_d<CGAL::Cartesian_d<Q>>>(random, 5);
  });
}

// Only the members that the concept of a traits class offers are used.
BOOST_AUTO_TEST_CASE(curves_over_an_archetype) {
  typedef archetype::Traits<CGAL::Dimension_tag<2>> Traits;
  typedef archetype::Number FT;
  typedef GC::Bspline_curve<Traits> Curve;
  const auto point = [](int x, int y) {
    const FT c[] = {FT(x), FT(y)};
    return Traits().construct_point_object()(2, c, c + 2);
  };
  const std::vector<Traits::Point> points{point(0, 0), point(2, 4), point(4, 4), point(8, 0)};
  const Curve c(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}));
  const FT half = FT(FT(1) / FT(2));
  BOOST_CHECK(c.jet(half, 3)[0] == c.insert(half).jet(half, 3)[0]);
  BOOST_CHECK(c.elevate(2).jet(half, 3) == c.jet(half, 3));
  BOOST_CHECK(*c.insert(half).remove(half) == c);
  BOOST_CHECK(c.insert(half, 2).remove_superfluous_knots() == c);
  BOOST_CHECK(c.reverse().reverse() == c);
  BOOST_CHECK(c.derivative().jet(half, 0)[0] == c.jet(half, 1)[1]);
  const std::vector<GC::Bezier_curve<Traits>> pieces = c.bezier_pieces();
  BOOST_CHECK(Curve(pieces.begin(), pieces.end()).remove_superfluous_knots() == c);
  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2)), {FT(1), FT(3)});
  BOOST_CHECK(product(f, c).jet(FT(1), 0)[0] == FT(2) * c.jet(FT(1), 0)[0]);
  BOOST_CHECK_EQUAL(knot_continuity(c, FT(1)).c_order, 1);
  BOOST_CHECK_EQUAL(knot_continuities(c).size(), 1u);
  BOOST_CHECK_EQUAL(continuity(c, blend(c, c), 2).g_order, 2);
  BOOST_CHECK_EQUAL(GC::extend(c, GC::Frenet_order::curvature).number_of_points(), 6);
  BOOST_CHECK_EQUAL(GC::extend_toward(c, GC::Frenet_order::tangent, point(9, 1)).number_of_points(), 6);
  BOOST_CHECK_EQUAL((f + f)[1] == FT(6), true);
}

TEST_FOR_EACH(bezier_curves_and_back, K, Kernels) {
  typedef Curve3<K> Curve;
  typedef Bezier3<K> Bezier;
  repeat<FT>(25, [](Random<FT>& random) {
    const int p = random.integer(1, 4);
    const Curve c = random.template curve<Traits3<K>>(random.knots(p, p), 3); // continuous
    const std::vector<Bezier> pieces = c.bezier_pieces();
    const std::vector<int> spans = c.knots().spans();
    BOOST_REQUIRE_EQUAL(pieces.size(), spans.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const FT &a = c.knots()[spans[i]], &b = c.knots()[spans[i] + 1];
      BOOST_CHECK(pieces[i].domain() == std::make_pair(a, b));
      BOOST_CHECK_EQUAL(pieces[i].degree(), p);
      if constexpr (exact_v<FT>) {
        BOOST_CHECK(pieces[i].start_jet(p) == c.right_jet(a, p));
        BOOST_CHECK(pieces[i].end_jet(p) == c.left_jet(b, p));
      }
    }
    if constexpr (exact_v<FT>) {
      const Curve joined(pieces.begin(), pieces.end());
      for (const Knot<FT>& knot : joined.knots().inner_knots()) BOOST_CHECK_EQUAL(knot.multiplicity, p);
      BOOST_CHECK_EQUAL(joined.knots().inner_knots().size(), pieces.size() - 1);
      BOOST_CHECK(joined.bezier_pieces() == pieces);
      BOOST_CHECK(joined.remove_superfluous_knots() == c.clamp());
    }
  });
  const typename K::Point_3 a(0, 0, 0), b(1, 2, 0), x(3, 2, 1), y(4, 0, 1), z(6, 1, 1);
  const Bezier line({a, b}), parabola({b, x, y}), far({z, a});
  // a line elevated, and domains that do not continue each other
  const std::vector<Bezier> mixed{line, parabola, Bezier({y, z}).with_domain(FT(7), FT(10))};
  const Curve joined(mixed.begin(), mixed.end());
  BOOST_CHECK(joined.knots() == GC::Knot_vector<FT>(2, FT(0), FT(5), {{FT(1), 2}, {FT(2), 2}}));
  BOOST_CHECK_EQUAL(joined.number_of_points(), 7);
  BOOST_CHECK(joined.control_point(0) == a && joined.control_point(2) == b && joined.control_point(3) == x &&
              joined.control_point(4) == y && joined.control_point(6) == z);
  BOOST_CHECK(joined.coordinates(1)[1] == FT(1));
  BOOST_CHECK(joined(FT(5)) == z);
  const GC::Composite_bezier_curve<Traits3<K>> segmented(mixed.begin(), mixed.end());
  BOOST_CHECK(Curve(segmented.segments().begin(), segmented.segments().end()) == joined);
  const std::vector<Bezier> gap{line, far}, none;
  BOOST_CHECK_EQUAL(error_of([&] { Curve(gap.begin(), gap.end()); }),
                    "curves_do_not_meet: Bspline_curve: Bezier curve 1");
  CHECK_ERROR(Curve(none.begin(), none.end()), wrong_number_of_points);
  // points, where the degree 0 leaves no inner knot
  const std::vector<Bezier> points{Bezier({a}), Bezier({a})};
  BOOST_CHECK(Curve(points.begin(), points.end()).knots() == GC::Knot_vector<FT>(0, FT(0), FT(2)));
  // one curve
  BOOST_CHECK(Curve(parabola) == Curve(&parabola, &parabola + 1));
  BOOST_CHECK(Curve(parabola).bezier_pieces() == std::vector<Bezier>{parabola});
  BOOST_CHECK(Curve(parabola).knots() == GC::Knot_vector<FT>(2, FT(0), FT(1)));
  if constexpr (!exact_v<FT>) { // the length of the second domain vanishes beside the first
    const std::vector<Bezier> tiny{line.with_domain(FT(0), FT(1e20)), parabola};
    CHECK_ERROR(Curve(tiny.begin(), tiny.end()), empty_domain);
  }
}

// The degree, all knots and the points, with knots of any type of numbers and in braces.
TEST_FOR_EACH(degree_knots_and_points, K, Kernels) {
  typedef GC::Traits_2<K> Traits;
  typedef typename K::Point_2 Point;
  typedef GC::Bspline_curve<Traits> Curve;
  typedef GC::Rational_bspline_curve<Traits> Rational;
  const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(3, 4)};
  const std::vector<FT> knots{0, 0, 0, FT(1) / FT(2), FT(1) / FT(2), FT(1) / FT(2)}, weights{1, 2, 1};
  const Curve curve(points, GC::Knot_vector<FT>(2, knots));
  const Rational rational(points, weights, GC::Knot_vector<FT>(2, knots));
  BOOST_CHECK(Curve(2, knots, points) == curve);
  BOOST_CHECK(Curve(knots.size() - points.size() - 1, knots, points) == curve);
  BOOST_CHECK(Curve(2, std::vector<double>{0, 0, 0, 0.5, 0.5, 0.5}, points) == curve);
  BOOST_CHECK(Curve(2, {0, 0, 0, 0.5, 0.5, 0.5}, {Point(0, 0), Point(1, 2), Point(3, 4)}) == curve);
  BOOST_CHECK(Rational(2, knots, points, weights) == rational);
  BOOST_CHECK(Rational(2, {0, 0, 0, 0.5, 0.5, 0.5}, {Point(0, 0), Point(1, 2), Point(3, 4)}, {1, 2, 1}) == rational);
  CHECK_ERROR(Curve(3, knots, points), wrong_number_of_points);
  CHECK_ERROR(Curve(2, std::vector<double>{0, 0, 0, 0.5, 0.5, std::nan("")}, points), not_finite);
}

BOOST_AUTO_TEST_CASE(bezier_curves_of_different_dimensions_do_not_join) {
  typedef CGAL::Cartesian_d<Q> K;
  typedef GC::Bezier_curve<GC::Traits_d<K>> Bezier;
  const Q zeros[] = {Q(0), Q(0), Q(0)};
  const K::Point_d plane(2, zeros, zeros + 2), space(3, zeros, zeros + 3);
  const std::vector<Bezier> two{Bezier({plane, plane}), Bezier({space, space})};
  CHECK_ERROR(GC::Bspline_curve<GC::Traits_d<K>>(two.begin(), two.end()), dimension_mismatch);
  const K::Point_d points[] = {plane, space};
  CHECK_ERROR(GC::Bspline_curve<GC::Traits_d<K>>(points, points + 2, GC::Knot_vector<Q>(1, Q(0), Q(1))),
              dimension_mismatch);
}

TEST_FOR_EACH(refused_curves_equality_and_output, K, Kernels) {
  typedef GC::Bspline_curve<GC::Traits_2<K>> Curve;
  typedef typename K::Point_2 Point;
  const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(3, 4), Point(5, 6)};
  const GC::Knot_vector<FT> knots(2, FT(0), FT(4), {{FT(1), 1}});
  const Curve c(points.begin(), points.end(), knots);
  BOOST_CHECK_EQUAL(error_of([&] { Curve(points.begin(), points.end() - 1, knots); }),
                    "wrong_number_of_points: Bspline_curve: 3 coefficients where the knots need 4");
  std::vector<Point> others = points;
  others[3] = Point(5, 7);
  BOOST_CHECK(c == Curve(points.begin(), points.end(), knots));
  BOOST_CHECK(c != Curve(others.begin(), others.end(), knots));
  BOOST_CHECK(c != Curve(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}})));
  BOOST_CHECK_EQUAL(text(c), "B-spline curve of degree 2 over 0 0 0 1 4 4 4: (0, 0) (1, 2) (3, 4) (5, 6)");
  if constexpr (!exact_v<FT>) {
    others[1] = Point(std::numeric_limits<FT>::quiet_NaN(), 0);
    CHECK_ERROR(Curve(others.begin(), others.end(), knots), not_finite);
  }
  const CGAL::Aff_transformation_2<K> shift(CGAL::TRANSLATION, typename K::Vector_2(1, -1));
  BOOST_CHECK(c.transform(shift).control_point(1) == Point(2, 1));
  BOOST_CHECK(c.transform(shift).knots() == knots);
  std::vector<Curve> curves(2); // without points, until others are assigned
  BOOST_CHECK_EQUAL(curves[0].number_of_points(), 0);
  BOOST_CHECK(curves[0] == curves[1]);
  curves[1] = c;
  BOOST_CHECK(curves[1] == c);
  BOOST_CHECK(curves[0] != c);
}

// Returns the curve with rational coordinates.
template <class K> Curve3<CGAL::Simple_cartesian<Q>> rational(const Curve3<K>& c) {
  typedef CGAL::Simple_cartesian<Q> Exact;
  std::vector<Exact::Point_3> points;
  for (int i = 0; i < c.number_of_points(); ++i)
    points.emplace_back(Q(c.coordinates(i)[0]), Q(c.coordinates(i)[1]), Q(c.coordinates(i)[2]));
  return {points.begin(), points.end(),
          GC::Knot_vector<Q>(c.degree(), std::vector<Q>(c.knots().begin(), c.knots().end()))};
}

BOOST_AUTO_TEST_CASE(jets_over_another_field_are_exact) {
  typedef CGAL::Epick K;
  repeat<double>(20, [](Random<double>& random) {
    const int p = random.integer(0, 4);
    const Curve3<K> c = random.curve<Traits3<K>>(random.knots(p, p + 1), 3);
    const Curve3<CGAL::Simple_cartesian<Q>> exact = rational<K>(c);
    const auto same = [](const GC::Coordinate_jet<Q, 3>& x, const GC::Coordinate_jet<Q, 3>& y) {
      BOOST_CHECK_EQUAL(x.order(), 5);
      BOOST_CHECK(x == y);
    };
    same(c.start_jet_over<Q>(5), exact.start_jet(5));
    same(c.end_jet_over<Q>(5), exact.end_jet(5));
    for (double u : parameters(c.knots(), random)) {
      same(c.left_jet_over<Q>(u, 5), exact.left_jet(Q(u), 5));
      same(c.right_jet_over<Q>(u, 5), exact.right_jet(Q(u), 5));
    }
  });
}
