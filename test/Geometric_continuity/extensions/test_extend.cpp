// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Extensions refuse numbers that are not finite, wherever they enter, and degrees without
// alternatives. Their results are tested on every kernel, in typed_alternatives.h.

#include "support/test.h"

#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>

BOOST_AUTO_TEST_SUITE(extend)

const double not_finite_numbers[] = {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};

template <class Traits> GC::Bezier_curve<Traits> cubic() {
  typedef typename Traits::Point Point;
  return {Point(0, 0, 0), Point(1, 2, 0), Point(3, 3, 1), Point(5, 2, 2)};
}

// Numbers of type double in the place of exact ones: a conversion of them would stop the program.
template <class Traits, class FT = typename Traits::FT> void check_conversions() {
  typedef GC::Extension_parameters<FT> Parameters;
  const GC::Bezier_curve<Traits> left = cubic<Traits>();
  for (const double x : not_finite_numbers) {
    CHECK_ERROR((Parameters{x}), not_finite);
    CHECK_ERROR((Parameters{FT(2), x}), not_finite);
    CHECK_ERROR(GC::extend(left, GC::Frenet_order::torsion, {1, 3, {}, x}), not_finite);
    CHECK_ERROR(GC::extend(left, GC::Frenet_order::torsion, {1, FT(3), x, {}}), not_finite);
    CHECK_ERROR(GC::close(left, left, GC::Frenet_order::tangent, {1, x}), not_finite);
  }
  const Parameters given{2, FT(3), std::nullopt, 0.5}, copy = given, none;
  BOOST_CHECK(copy.beta == FT(2) && copy.c0 == FT(3) && !copy.c1 && *copy.c2 == FT(FT(1) / FT(2)));
  BOOST_CHECK(none.beta == FT(1) && !none.c0 && !none.c1 && !none.c2);
}

BOOST_AUTO_TEST_CASE(conversions) {
  check_conversions<GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>>>();
  check_conversions<GC::Traits_3<CGAL::Epeck>>();
}

// Numbers of type double that are decided exactly: the predicates convert them.
BOOST_AUTO_TEST_CASE(equal_scalars) {
  typedef GC::Torsion_parameters<double> Parameters;
  BOOST_CHECK((Parameters{1, 2} == Parameters{1, 2}) && !(Parameters{1, 2} != Parameters{1, 2}));
  for (const Parameters& other : {Parameters{3, 2}, Parameters{1, 3}})
    BOOST_CHECK((Parameters{1, 2} != other) && !(Parameters{1, 2} == other));
}

// A rational curve with equal weights is extended as the polynomial one.
BOOST_AUTO_TEST_CASE(equal_weights) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
  typedef CGAL::Exact_rational Number;
  const GC::Bezier_curve<Traits> left = cubic<Traits>();
  const std::vector<Number> weights(4, Number(5));
  const GC::Rational_bezier_curve<Traits> rational(left.begin(), left.end(), weights.begin(), weights.end());
  const GC::Extension_parameters<Number> parameters{Number(2), Number(3)};
  BOOST_CHECK(GC::extend(rational, GC::Frenet_order::torsion, parameters) ==
              GC::extend(left, GC::Frenet_order::torsion, parameters));
}

BOOST_AUTO_TEST_CASE(numbers_of_the_kernel) {
  typedef GC::Traits_3<CGAL::Epick> Traits;
  typedef Traits::Point Point;
  const GC::Bezier_curve<Traits> left = cubic<Traits>();
  const auto tangent = GC::tangent_alternative(left);
  const auto line = GC::curvature_alternatives(left);
  const auto plane = GC::torsion_alternatives(left, 4);
  for (const double x : not_finite_numbers) {
    const Point p(1, x, 0);
    CHECK_ERROR(tangent.ratio_of(p), not_finite);
    CHECK_ERROR(line.parameter_of(p), not_finite);
    CHECK_ERROR(line.nearest_parameter(p), not_finite);
    CHECK_ERROR(line.point_at(x), not_finite);
    CHECK_ERROR(line.beta2(x), not_finite);
    CHECK_ERROR(plane.contains(p), not_finite);
    CHECK_ERROR(plane.parameters_of(p), not_finite);
    CHECK_ERROR(plane.nearest_parameters(p), not_finite);
    CHECK_ERROR(plane.point_at({0, x}), not_finite);
    CHECK_ERROR(plane.g3_parameters(x), not_finite);
    CHECK_ERROR(plane.connection({x, 0}), not_finite);
    CHECK_ERROR(GC::torsion_alternatives(left, x), not_finite);
    CHECK_ERROR(GC::extend(left, GC::Frenet_order::curvature, {1, x}), not_finite);
    CHECK_ERROR(GC::extend(left, GC::Frenet_order::torsion, {1, 0, x, 0}), not_finite);
    CHECK_ERROR(GC::extend_toward(left, GC::Frenet_order::tangent, p), not_finite);
    CHECK_ERROR(GC::reflection<Traits>(p, Point(0, 0, 0)), not_finite);
    CHECK_ERROR(GC::midpoint_construction(left).b2(x), not_finite);
  }
  CHECK_ERROR(GC::tangent_alternative(left, infinity), not_finite);
  CHECK_ERROR(GC::extend(left, GC::Frenet_order::tangent, {infinity}), not_finite);
  CHECK_ERROR(GC::close(left, left, GC::Frenet_order::curvature, {infinity, 1}), not_finite);
  const double most = (std::numeric_limits<double>::max)();
  CHECK_ERROR(GC::reflection<Traits>(Point(most, 0, 0), Point(-most, 0, 0)), not_finite);
}

BOOST_AUTO_TEST_CASE(degrees_without_alternatives) {
  typedef CGAL::Exact_rational Exact;
  for (int m : {-1, 0, 1}) CHECK_ERROR(GC::connection_beta2<Exact>(m, 1, 4), wrong_number_of_points);
  for (int m : {-1, 0, 1, 2}) {
    CHECK_ERROR(GC::connection_coefficients<Exact>(m, 1, {4, 7, 5}), wrong_number_of_points);
    CHECK_ERROR(GC::g3_c2<Exact>(m, 1, 4), wrong_number_of_points);
    CHECK_ERROR(GC::connection_c1<Exact>(m, 1, 4, 5, 0), wrong_number_of_points);
  }
  BOOST_CHECK(GC::connection_beta2<Exact>(2, 1, 5) == Exact(1));
}

BOOST_AUTO_TEST_SUITE_END()
