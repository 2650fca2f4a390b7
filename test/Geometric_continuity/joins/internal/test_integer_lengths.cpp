// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The test evaluates the equations themselves on bounds, and checks that the residues of fixed
// length suffice.

#include "support/bounded_integers.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/joins/internal/Grid_join.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_ladder.h>

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <int m, int n> struct Product_type<Bounded_integer<m>, Bounded_integer<n>> {
  typedef Bounded_integer<m + n> type;
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

BOOST_AUTO_TEST_SUITE(integer_lengths)

using namespace CGAL::Geometric_continuity::internal;

// Looks at each form. With the one answer and with the other, the equations compute all forms that
// they have.
struct Fitting_zero {
  static constexpr bool exact = true;
  bool answer;
  bool fits = true;

  template <class X> constexpr bool operator()(Join_question, const X& x) {
    fits = fits && x.fits;
    return answer;
  }
};

struct Lengths {
  int bits = 53;          // of the coordinates of points
  std::int64_t times = 1; // the limits of factors
};

// A factor below a limit.
constexpr Factor_bound below(std::int64_t limit) { return Factor_bound(static_cast<double>(limit - 1)); }

// Returns whether all parts of the forms of a question fit, for points of so many bits and factors
// up to their limits.
template <Join_question question, int N> constexpr bool forms_fit(const Lengths& lengths = {}) {
  typedef Bounded_integer<1> Integer;
  typedef Degree_factors<Factor_bound> Factors;
  const Integer d1 = 2 * bound_of_bits(lengths.bits), d2 = 2 * d1.bound, d3 = 2 * d2.bound;
  const std::array<Integer, 3> x1{d1, d1, d1}, x2{d2, d2, d2}, x3{d3, d3, d3};
  Differences<Integer, N> d = [&]() -> Differences<Integer, N> {
    if constexpr (N == 3)
      return {x1, x2, x3};
    else
      return {std::array<Integer, 2>{d1, d1}, std::array<Integer, 2>{d2, d2}, std::array<Integer, 2>{d3, d3}};
  }();
  const Degree_factors<std::int64_t> limits = factor_limits<question>();
  const auto factor = [&](std::int64_t limit) { return below(lengths.times * limit); };
  const Factors w{factor(limits.a2), factor(limits.b2), factor(limits.a3), factor(limits.b3), factor(limits.mix)};
  bool fits = true;
  for (const bool answer : {false, true}) {
    Fitting_zero zero{answer};
    const Join_equations<Integer, N, Factors, Fitting_zero> equations(d, d, w, zero);
    (void)equations.tangents_parallel();
    if constexpr (N == 3) (void)equations.both_have_curvature();
    (void)all_hold<question>(equations);
    fits = fits && zero.fits;
  }
  return fits;
}

template <Join_question question> constexpr bool all_fit(const Lengths& lengths = {}) {
  bool fits = forms_fit<question, 3>(lengths);
  if constexpr (question != Join_question::f3 && question != Join_question::torsion)
    fits = fits && forms_fit<question, 2>(lengths);
  return fits;
}

// Factors are refused exactly where one of them that the question needs reaches its limit.
template <Join_question question> void check_limits() {
  typedef Degree_factors<std::int64_t> Factors;
  const Factors limits = factor_limits<question>();
  for (int k = 0; k < 5; ++k)
    for (const bool reaches : {false, true}) {
      const std::int64_t limit[] = {limits.a2, limits.b2, limits.a3, limits.b3, limits.mix};
      std::int64_t w[5] = {1, 1, 1, 1, 1};
      w[k] = limit[k] - (reaches ? 0 : 1);
      BOOST_CHECK_EQUAL(factors_fit<question>(Factors{w[0], w[1], w[2], w[3], w[4]}), !reaches);
    }
}

BOOST_AUTO_TEST_CASE(limits_of_factors) {
  check_limits<Join_question::g2>();
  check_limits<Join_question::g3>();
  check_limits<Join_question::f3>();
  check_limits<Join_question::curvature_vector>();
  check_limits<Join_question::torsion>();
}

BOOST_AUTO_TEST_CASE(no_form_exceeds_its_limbs) {
  static_assert(all_fit<Join_question::g1>());
  static_assert(all_fit<Join_question::g2>());
  static_assert(all_fit<Join_question::g3>());
  static_assert(all_fit<Join_question::f3>());
  static_assert(all_fit<Join_question::curvature_vector>());
  static_assert(all_fit<Join_question::torsion>());
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_noticed) {
  // Points of 62 bits have differences of 65 bits. Long factors of the second and of the third
  // differences exceed two limbs beside the square and three beside the cube of a number of one
  // limb.
  static_assert(!all_fit<Join_question::g1>({62, 1}));
  static_assert(all_fit<Join_question::g1>({53, 1 << 20})); // has no factors
  static_assert(!all_fit<Join_question::g2>({53, 1 << 20}));
  static_assert(!all_fit<Join_question::g3>({53, 1 << 3}));
  static_assert(!all_fit<Join_question::f3>({53, 1 << 3}));
  static_assert(!all_fit<Join_question::torsion>({53, std::int64_t(1) << 13}));
  static_assert(!all_fit<Join_question::curvature_vector>({53, std::int64_t(1) << 20}));
}

// Ends of integers have short legs where these are no longer than those of points with 53 bits, on
// either side.
BOOST_AUTO_TEST_CASE(short_legs) {
  const std::int64_t longest = std::int64_t(1) << 54;
  static_assert(2 * bound_of_bits(53) == 0x1p54);
  for (int place = 0; place < 6; ++place)
    for (const std::int64_t sign : {-1, 1})
      for (const std::int64_t more : {0, 1}) {
        End_polygon<std::int64_t, 2> points{};
        for (int j = place / 2 + 1; j <= 3; ++j) points[j][place % 2] = sign * (longest + more);
        BOOST_CHECK_EQUAL(Integer_end<2>(points, 0, 3, 1).is_short(), more == 0);
      }
}

// Points of quotients with numbers of 60 bits: a point between two, or none where one of the
// numbers gets longer.
BOOST_AUTO_TEST_CASE(points_between_points) {
  typedef Short_point<2> Point;
  const auto between = [](const Point& x, const Point& y, std::int64_t part, std::int64_t whole) {
    Point p{{7, 7}, 7};
    if (!combine<2>(x, y, part, whole, p)) p.denominator = 0;
    return p;
  };
  const auto equal = [](const Point& p, std::int64_t x, std::int64_t y, std::int64_t denominator) {
    return p.numerators[0] == x && p.numerators[1] == y && p.denominator == denominator;
  };
  const Point a{{1, 4}, 3}, b{{5, -2}, 6};
  BOOST_CHECK(equal(between(a, b, 0, 5), 1, 4, 3) && equal(between(a, b, 5, 5), 5, -2, 6));
  BOOST_CHECK(equal(between(a, b, 1, 2), 7, 6, 12) && equal(between(a, b, 4, 6), 6, 2, 9));
  const std::int64_t power = std::int64_t(1) << 40, largest = (std::int64_t(1) << 60) - 1;
  const auto is_too_long = [&](const Point& x, const Point& y, std::int64_t part, std::int64_t whole) {
    return between(x, y, part, whole).denominator == 0;
  };
  BOOST_CHECK(is_too_long({{1, 1}, power - 1}, {{1, 1}, power + 1}, 1, 2)); // of two denominators
  BOOST_CHECK(is_too_long({{1, 1}, 3}, {{1, 1}, power}, power - 1, power)); // and the whole
  // a denominator and a part
  BOOST_CHECK(is_too_long({{1, 1}, 3}, {{1, 1}, power}, 1, power));
  BOOST_CHECK(is_too_long({{1, 1}, power}, {{1, 1}, 3}, power - 1, power));
  BOOST_CHECK(is_too_long({{largest, 1}, 1}, {{largest, 1}, power - 1}, 1, 2)); // a numerator
  BOOST_CHECK(equal(between({{largest, 1}, 1}, {{largest, 1}, 1}, 1, 3), largest, 1, 1));
}

BOOST_AUTO_TEST_SUITE_END()

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
