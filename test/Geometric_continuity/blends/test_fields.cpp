// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends in fields that have nothing but what the concept asks for, and in those of Boost: what is
// chosen in floating-point numbers is the same as in every other field. How blends are called.

#include "support/archetype.h"
#include "support/decided_joins.h"
#include "support/plain_traits.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

BOOST_AUTO_TEST_SUITE(fields)

typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Exact;
typedef boost::multiprecision::cpp_bin_float_100 Float;

// Two cubics that lead from one to the other.
template <class Traits> struct Curves {
  typedef typename Traits::FT FT;
  GC::Bezier_curve<Traits> phi = curve({{{-90, 11}, {-60, -40}, {-30, 20}, {0, 0}}}),
                           psi = curve({{{100, 30}, {140, 10}, {150, -50}, {190, -60}}});

private:
  static GC::Bezier_curve<Traits> curve(const std::array<std::array<int, 2>, 4>& numbers) {
    std::vector<GC::Coordinates<Traits>> rows;
    for (const std::array<int, 2>& x : numbers) {
      rows.emplace_back(2);
      for (int i = 0; i < 2; ++i) rows.back()[i] = FT(FT(x[i]) / FT(7));
    }
    return GC::Bezier_curve<Traits>(rows);
  }
};

// Numerator and denominator in decimals.
std::array<std::string, 2> fraction(const CGAL::Exact_rational& q) {
  typedef CGAL::Fraction_traits<CGAL::Exact_rational> Fraction;
  Fraction::Numerator_type p;
  Fraction::Denominator_type d;
  Fraction::Decompose()(q, p, d);
  std::ostringstream numerator, denominator;
  numerator << p;
  denominator << d;
  return {numerator.str(), denominator.str()};
}
template <class FT> FT whole_number(const std::string& decimals) {
  FT x(0);
  for (const char c : decimals)
    if (c != '-') x = FT(x * FT(10) + FT(c - '0'));
  return decimals[0] == '-' ? FT(-x) : x;
}

// Every blend of the strategies, in one field as in rational numbers. `same(x, q)` compares.
template <class Traits, class Same> void check_blends(const Same& same) {
  const Curves<Traits> given;
  const Curves<Exact> exact;
  const auto check = [&](const auto& strategy) {
    const auto x = blend(given.phi, given.psi, strategy);
    const auto q = blend(exact.phi, exact.psi, strategy);
    BOOST_REQUIRE_EQUAL(x.degree(), q.degree());
    for (int j = 0; j <= x.degree(); ++j)
      for (int i = 0; i < 2; ++i) BOOST_CHECK(same(x.coordinates(j)[i], q.coordinates(j)[i]));
  };
  check(GC::Minimal_energy<3>());
  check(GC::Near_line());
  check(GC::Fair());
  check(GC::Fair_g3());
  check(GC::Fair_f3());
  const auto given_shape = [](const auto& c) { return blend(c.phi, c.psi, GC::Fair(), {1, 2}); };
  const auto x = given_shape(given);
  const auto q = given_shape(exact);
  for (int j = 0; j <= 5; ++j) BOOST_CHECK(same(x.coordinates(j)[0], q.coordinates(j)[0]));
}

BOOST_AUTO_TEST_CASE(field_of_the_concept) {
  typedef archetype::Number Number;
  check_blends<Plain_traits<Number>>([](const Number& x, const CGAL::Exact_rational& q) {
    const auto [p, d] = fraction(q);
    return x * whole_number<Number>(d) == whole_number<Number>(p);
  });
}

BOOST_AUTO_TEST_CASE(floating_point_numbers_of_boost) {
  check_blends<Plain_traits<Float>>([](const Float& x, const CGAL::Exact_rational& q) {
    const auto [p, d] = fraction(q);
    const Float error = x - Float(whole_number<Float>(p) / whole_number<Float>(d));
    return abs(error) <= Float(1e-90);
  });
}

BOOST_AUTO_TEST_CASE(a_shape_without_a_strategy) {
  const Curves<Exact> c;
  const auto least = blend(c.phi, c.psi, GC::Minimal_energy<3>(), {1, 2});
  BOOST_CHECK(blend(c.phi, c.psi, {1, 2}) == least);
  BOOST_CHECK(blend(c.phi, c.psi, GC::Shape_parameters<Exact::FT>(1, 2)) == least);
  BOOST_CHECK(blend(c.phi.end_jet(2), c.psi.start_jet(2), {1, 2}) == least);
  BOOST_CHECK(decide_g2_join(c.phi, least) && decide_g2_join(least, c.psi));
}

BOOST_AUTO_TEST_SUITE_END()
