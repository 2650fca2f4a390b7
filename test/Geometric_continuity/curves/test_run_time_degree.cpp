// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A degree that is known at run time only changes no bit of a point, a jet or a part of a curve of
// doubles, and up to degree 9 its points and jets allocate no memory.

#define BOOST_TEST_MODULE run_time_degree

#include "support/allocations.h"
#include "support/random_points.h"

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

// The curves have the domain [-0.7, 1.9]; parameters are its ends, others, and one outside.
const double parameters[] = {-0.7, -0.3, 0.1, 0.6, 1.1, 1.7, 1.9, 2.5};

template <class Fixed, class Dynamic> void compare(const Fixed& fixed, const Dynamic& dynamic) {
  for (const double u : parameters) {
    BOOST_TEST_CONTEXT("degree " << fixed.degree() << ", u = " << u) {
      BOOST_CHECK(fixed(u) == dynamic(u));
      for (int k = 0; k <= 4; ++k) BOOST_CHECK(fixed.jet(u, k) == dynamic.jet(u, k));
      BOOST_CHECK(fixed.template jet<2>(u) == dynamic.template jet<2>(u));
      if (!(-0.7 < u && u < 1.9)) continue;
      const std::pair<Fixed, Fixed> parts = fixed.split(u);
      const std::pair<Dynamic, Dynamic> dynamic_parts = dynamic.split(u);
      BOOST_CHECK(Dynamic(parts.first) == dynamic_parts.first);
      BOOST_CHECK(Dynamic(parts.second) == dynamic_parts.second);
    }
  }
}

template <class Curve> std::size_t allocations_of(const Curve& curve) {
  const std::size_t before = allocations;
  double sum = curve(0.6).x();
  for (int k = 0; k <= 4; ++k) sum += curve.jet(0.6, k)[k][0];
  BOOST_CHECK_EQUAL(sum, sum); // not undefined
  return allocations - before;
}

template <int Degree> void compare_degree() {
  const std::vector<Point<double>> p = points<double>(Degree + 1);
  const GC::Bezier_curve<Traits<double>, Degree> curve(p.begin(), p.end(), -0.7, 1.9);
  const GC::Bezier_curve<Traits<double>> dynamic(curve);
  compare(curve, dynamic);
  const auto parts = dynamic.split(0.6); // unrolled, up to degree 9
  for (int i = 0; i < 3; ++i) {
    const auto expected = dynamic.coordinate_polynomial(i).split((0.6 + 0.7) / (1.9 + 0.7));
    BOOST_CHECK(parts.first.coordinate_polynomial(i) == expected.first);
    BOOST_CHECK(parts.second.coordinate_polynomial(i) == expected.second);
  }
  std::vector<double> weights;
  for (int j = 0; j <= Degree; ++j) weights.push_back(1.5 + number<double>());
  const GC::Rational_bezier_curve<Traits<double>, Degree> rational(p.begin(), p.end(), weights.begin(), weights.end(),
                                                                   -0.7, 1.9);
  const GC::Rational_bezier_curve<Traits<double>> dynamic_rational(rational);
  compare(rational, dynamic_rational);
  if (Degree <= 9) {
    BOOST_CHECK_EQUAL(allocations_of(dynamic), 0u);
    BOOST_CHECK_EQUAL(allocations_of(dynamic_rational), 0u);
  }
  if constexpr (Degree > 0) compare_degree<Degree - 1>();
}

BOOST_AUTO_TEST_CASE(bits_do_not_depend_on_how_the_degree_is_known) {
  BOOST_TEST_CONTEXT("seed 2026") compare_degree<11>();
}

// A control point at infinity, whose weight is 0.
BOOST_AUTO_TEST_CASE(infinite_control_points) {
  typedef GC::Rational_bezier_curve<Traits<double>, 2> Conic;
  typedef Conic::Homogeneous::Point Homogeneous_point;
  std::vector<Homogeneous_point> p(3, Homogeneous_point(4));
  p[0][0] = p[0][3] = p[1][1] = p[2][3] = 1;
  p[2][0] = -1;
  const Conic half_circle(Conic::Homogeneous(p.begin(), p.end(), -0.7, 1.9));
  compare(half_circle, GC::Rational_bezier_curve<Traits<double>>(half_circle));
  BOOST_CHECK(half_circle(0.6) == Point<double>(0, 1, 0));
}
