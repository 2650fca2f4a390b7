// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The package without GMP and MPFR, with the numbers of Boost: constructions and decisions on
// doubles and on rational numbers.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE Without_gmp
#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost_mp.h>

#if defined(CGAL_USE_GMP) || defined(__GMP_H__) || defined(__MPFR_H)
#error "this program is compiled without GMP and MPFR"
#endif

#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef boost::multiprecision::cpp_rational Q;
typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact_plane;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_space;
typedef GC::Traits_2<CGAL::Epick> Plane;
typedef GC::Traits_3<CGAL::Epick> Space;

template <class T> std::string text(const T& x) {
  std::ostringstream os;
  os << x;
  return os.str();
}

BOOST_AUTO_TEST_CASE(exact_field) {
  static_assert(std::is_same_v<GC::Exact_field<double>::type, Q> || BOOST_VERSION > 107800);
  static_assert(std::is_same_v<Plane::Predicate_FT, GC::Exact_field<double>::type>);
}

BOOST_AUTO_TEST_CASE(blends) { // the example of the README
  typedef Exact_plane::Point Point;
  const GC::Bezier_curve<Exact_plane> phi{Point(-3, 0), Point(-3, 2), Point(-2, 3), Point(0, 3)},
      psi{Point(4, 0), Point(5, -1)};
  const auto gamma = GC::blend(phi, psi);
  BOOST_CHECK_EQUAL(text(GC::continuity(phi, gamma)), "C0 G2 F2, beta = (213/256, -267691/208896)");
  BOOST_CHECK_EQUAL(text(GC::continuity(gamma, psi)), "C0 G2 F2, beta = (32/113, 1364223/24529249)");
  BOOST_CHECK(GC::is_g2_join(phi, gamma));
  const GC::Join_deviation d = GC::deviation(phi, gamma);
  BOOST_CHECK(d.gap == (GC::Enclosure{0, 0}));
  BOOST_REQUIRE(d.tangent_angle);
  BOOST_CHECK(*d.tangent_angle == (GC::Enclosure{0, 0}));
}

BOOST_AUTO_TEST_CASE(predicates_on_doubles) {
  typedef Space::Point Point;
  const GC::Bezier_curve<Space> a{Point(0, 0, 0), Point(1, 0, 0.5), Point(2, 1, 0.25), Point(3, 3, 0.125)};
  // exact: few binary digits
  const GC::Bezier_curve<Space> left = a.split(0.5).first, right = a.split(0.5).second;
  BOOST_CHECK(GC::is_g2_join(left, right));
  BOOST_CHECK(GC::is_f3_join(left, right));
  const GC::Bezier_curve<Space> moved{right.control_point(0), right.control_point(1),
                                      right.control_point(2) + Space::Vector(0, 0, 0x1p-50), right.control_point(3)};
  BOOST_CHECK(GC::is_g1_join(left, moved));
  BOOST_CHECK(!GC::is_g2_join(left, moved));
  BOOST_CHECK_EQUAL(GC::continuity(left, right).g_order, 3);
  BOOST_CHECK_EQUAL(GC::continuity(left, moved).g_order, 1);
  const auto jump = GC::deviation(left, moved).curvature_jump;
  BOOST_REQUIRE(jump);
  BOOST_CHECK(0 < jump->lower && jump->lower <= jump->upper && jump->upper < 1e-12);
}

BOOST_AUTO_TEST_CASE(splines_and_polynomials) {
  typedef GC::Bspline_function<Q> Function;
  const GC::Knot_vector<Q> knots(2, Q(0), Q(2), {{Q(1), 1}});
  const Function f(knots, {Q(0), Q(1), Q(3), Q(-1)}), g = f * f;
  const Q u = Q(3) / Q(7);
  BOOST_CHECK(g(u) == f(u) * f(u));
  BOOST_CHECK(f.elevate(2)(u) == f(u));
  // (t - 1/2)^2, 1/2 - 2t + t^2
  const GC::Bernstein_polynomial<double> p{0.25, -0.25, 0.25}, q{0.5, -0.5, -0.5};
  BOOST_CHECK_EQUAL(GC::sign_pattern(p), GC::Sign_pattern::nonnegative);
  BOOST_CHECK_EQUAL(GC::isolate_roots(p).size(), 1u);
  const auto roots = GC::isolate_roots(q, GC::Exact_field<double>::type(0x1p-40)); // 1 - sqrt(1/2)
  BOOST_REQUIRE_EQUAL(roots.size(), 1u);
  BOOST_CHECK_CLOSE(CGAL::to_double(roots[0].begin), 0.2928932188134524, 1e-9);
}

BOOST_AUTO_TEST_CASE(roots_and_angles) {
  const GC::Enclosure root = GC::sqrt_enclosure(Q(2)), angle = GC::angle_enclosure(Q(1), Q(1));
  BOOST_CHECK(Q(root.lower) * Q(root.lower) < 2 && 2 < Q(root.upper) * Q(root.upper));
  BOOST_CHECK(angle.lower <= 0.78539816339744830 && 0.78539816339744831 <= angle.upper);
  BOOST_CHECK(*GC::rational_square_root(Q(Q(9) / Q(4))) == Q(3) / Q(2));
}
