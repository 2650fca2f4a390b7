// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Enclosures of square roots and of angles: they hold, proved by exact numbers, in every rounding
// mode, and are narrow. Rational square roots.

#include "support/enclosures.h"
#include "support/rounding_modes.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Quotient.h>
#include <locale>

BOOST_AUTO_TEST_SUITE(Enclosure)

using enclosures::angle_is;
using enclosures::encloses_root;
using enclosures::ulps;

template <class FT> GC::Enclosure angle_in(int mode, const FT& sine_squared, const FT& cosine) {
  return in_rounding_mode(mode, [&] { return GC::angle_enclosure(sine_squared, cosine); });
}
template <class FT> GC::Enclosure root_in(int mode, const FT& x) {
  return in_rounding_mode(mode, [&] { return GC::sqrt_enclosure(x); });
}

std::string printed(const GC::Enclosure& e, int precision = 6) {
  std::ostringstream os;
  os.precision(precision);
  os << e;
  return os.str();
}

BOOST_AUTO_TEST_CASE(random_roots_and_angles) {
  std::cout << "seed 2026\n";
  std::mt19937_64 random(2026);
  const auto number = [&random](int exponents) {
    const double digits = double(random() >> 11);
    return std::ldexp(digits, -52 - static_cast<int>(random() % static_cast<unsigned>(exponents)));
  };
  for (int i = 0; i < 400; ++i) {
    const int mode = rounding_mode(i), exponents = i % 3 == 0 ? 1 : i % 3 == 1 ? 30 : 200;
    const double s = number(exponents), c = number(exponents) * (i % 8 < 4 ? 1 : -1);
    const GC::Enclosure root = root_in(mode, Q(Q(s) / Q(3)));
    BOOST_CHECK(encloses_root(root, Q(Q(s) / Q(3))));
    BOOST_CHECK(ulps(root) <= 4);
    // a number without an interval
    BOOST_CHECK(encloses_root(root_in(mode, s), Q(s)) && ulps(root_in(mode, s)) <= 1);
    const Q sine_squared = Q(Q(s) * Q(s) / Q(7));
    const GC::Enclosure angle = angle_in(mode, sine_squared, Q(c));
    const Q lengths = Q(sine_squared + Q(c) * Q(c));
    BOOST_CHECK(angle_is(true, angle.lower, Q(c), lengths));
    BOOST_CHECK(angle_is(false, angle.upper, Q(c), lengths));
    BOOST_CHECK(ulps(angle) <= 4);
    BOOST_CHECK(0 <= angle.lower && angle.lower < angle.upper);
  }
}

BOOST_AUTO_TEST_CASE(special_angles) {
  const double pi = 3.141592653589793, above_pi = std::nextafter(pi, 4.); // pi lies between
  // of a multiple of pi by a power of two
  const auto is_close = [&](const GC::Enclosure& e, double factor) {
    return e.lower <= factor * pi && factor * above_pi <= e.upper && ulps(e) <= 3;
  };
  for (int mode : rounding_modes()) {
    BOOST_CHECK(angle_in(mode, Q(0), Q(5)) == (GC::Enclosure{0, 0}));
    BOOST_CHECK(is_close(angle_in(mode, Q(0), Q(-5)), 1));
    BOOST_CHECK(is_close(angle_in(mode, Q(3), Q(0)), 0.5));
    BOOST_CHECK(angle_in(mode, Q(2), Q(2)).lower < angle_in(mode, Q(5), Q(2)).lower);
    const GC::Enclosure eighth = angle_in(mode, Q(4), Q(2)), obtuse = angle_in(mode, Q(4), Q(-2));
    BOOST_CHECK(is_close(eighth, 0.25));
    BOOST_CHECK(obtuse.lower <= 0.75 * pi && 0.75 * above_pi <= obtuse.upper && ulps(obtuse) <= 3);
    // tiny angles, near 0 and near pi, and nearly right ones
    const Q tiny = Q(std::ldexp(1., -500));
    const GC::Enclosure near_0 = angle_in(mode, Q(tiny * tiny), Q(1));
    BOOST_CHECK(near_0.lower <= std::ldexp(1., -500) && std::ldexp(1., -500) <= near_0.upper && ulps(near_0) <= 3);
    BOOST_CHECK(is_close(angle_in(mode, Q(tiny * tiny), Q(-1)), 1));
    BOOST_CHECK(is_close(angle_in(mode, Q(1), tiny), 0.5));
    BOOST_CHECK(is_close(angle_in(mode, Q(1), Q(-tiny)), 0.5));
    // 2^-1250 is no double
    const GC::Enclosure least = angle_in(mode, Q(tiny * tiny * tiny * tiny * tiny), Q(1));
    BOOST_CHECK(least.lower >= 0 && least.upper <= std::ldexp(1., -530));
  }
  CHECK_ERROR(GC::angle_enclosure(Q(0), Q(0)), zero_direction);
  CHECK_ERROR(GC::angle_enclosure(Q(-1), Q(2)), parameter_outside_domain);
  CHECK_ERROR(GC::angle_enclosure(std::numeric_limits<double>::quiet_NaN(), 1.), not_finite);
}

BOOST_AUTO_TEST_CASE(special_roots) {
  const double largest = (std::numeric_limits<double>::max)(), least = std::numeric_limits<double>::denorm_min(),
               infinity = std::numeric_limits<double>::infinity();
  for (int mode : rounding_modes()) {
    BOOST_CHECK(root_in(mode, Q(0)) == (GC::Enclosure{0, 0}));
    BOOST_CHECK(root_in(mode, Q(9)) == (GC::Enclosure{3, 3}));
    BOOST_CHECK(encloses_root(root_in(mode, Q(largest)), Q(largest)));
    BOOST_CHECK(encloses_root(root_in(mode, Q(least)), Q(least)));
    const GC::Enclosure huge = root_in(mode, Q(Q(largest) * Q(4)));
    BOOST_CHECK(huge.upper == infinity && Q(huge.lower) * Q(huge.lower) <= Q(Q(largest) * Q(4)));
  }
  CHECK_ERROR(GC::sqrt_enclosure(Q(-1)), parameter_outside_domain);
  const Q tiny(std::ldexp(1., -600));
  CHECK_ERROR(GC::sqrt_enclosure(Q(-tiny * tiny)),
              parameter_outside_domain); // between 0 and the greatest negative double
  CHECK_ERROR(GC::sqrt_enclosure(infinity), not_finite);
  CHECK_ERROR(GC::enclosure(infinity), not_finite);
  BOOST_CHECK(GC::enclosure(Q(Q(1) / Q(2))) == (GC::Enclosure{0.5, 0.5}));
}

BOOST_AUTO_TEST_CASE(rational_roots) {
  CHECK_ERROR(GC::rational_square_root(std::numeric_limits<double>::quiet_NaN()), not_finite);
  // fractions that are not in lowest terms, with a negative denominator
  typedef CGAL::Quotient<long> Fraction;
  BOOST_CHECK(*GC::rational_square_root(Fraction(8, 2)) == Fraction(2));
  BOOST_CHECK(*GC::rational_square_root(Fraction(-8, -18)) == Fraction(2, 3));
  BOOST_CHECK(!GC::rational_square_root(Fraction(8, 4)));
}

BOOST_AUTO_TEST_CASE(what_is_printed_encloses) {
  std::cout << "seed 2027\n";
  std::mt19937_64 random(2027);
  for (int i = 0; i < 1000; ++i) {
    const int precision = 1 + i % 17, mode = rounding_mode(i);
    double x = double(random() >> 11);
    x = std::ldexp(x, static_cast<int>(random() % 2000) - 1074);
    if (i % 3 == 0) x = std::ldexp(double(random() >> 11), -60 + i % 20); // without an exponent
    if (i % 7 == 0) x = 0.1 * double(random() % 1000);
    if (i % 5 < 2) x = -x;
    const double y = i % 2 == 0 ? x : x + std::abs(x) * double(random() % 100) / 64;
    if (std::isinf(x) || std::isinf(y)) continue;
    const std::string text = in_rounding_mode(mode, [&] { return printed({x, y}, precision); });
    const std::size_t comma = text.find(", ");
    const bool one = comma == std::string::npos;
    const Q below = GC::parse_number<Q>(one ? text : text.substr(1, comma - 1)),
            above = one ? below : GC::parse_number<Q>(text.substr(comma + 2, text.size() - comma - 3));
    BOOST_CHECK_MESSAGE(below <= Q(x) && Q(y) <= above, text);
    // close, by the number of digits; a single digit more may be the tenth part
    Q unit(1);
    for (int k = 1; k < precision; ++k) unit = Q(unit / Q(10));
    BOOST_CHECK_MESSAGE(Q(x) - below <= unit * CGAL::abs(Q(x)) && above - Q(y) <= unit * CGAL::abs(Q(y)), text);
  }
  BOOST_CHECK_EQUAL(printed({0, 0}), "0");
  BOOST_CHECK_EQUAL(printed({-0., 0}), "0");
  BOOST_CHECK_EQUAL(printed({0.5, 0.5}), "0.5");
  BOOST_CHECK_EQUAL(printed({-1200, 1234567}), "[-1200, 1.23457e+06]");
  // the floating-point number is larger than 1/10
  BOOST_CHECK_EQUAL(printed({0.1, 0.1}), "[0.1, 0.100001]");
  BOOST_CHECK_EQUAL(printed({-0.1, 0.3}), "[-0.100001, 0.3]");
  BOOST_CHECK_EQUAL(printed({1 / 3., 2 / 3.}, 4), "[0.3333, 0.6667]");
  BOOST_CHECK_EQUAL(printed({0.99999, 99999.5}, 4), "[0.9999, 1e+05]");
  BOOST_CHECK_EQUAL(printed({-9.9999, -9.9999}, 0), "[-1e+01, -9]");
  BOOST_CHECK_EQUAL(printed({1e-5, 0.0001}, 3), "[1e-05, 0.000101]");
  BOOST_CHECK_EQUAL(printed({1, infinity}), "[1, inf]");
  BOOST_CHECK_EQUAL(printed({1, (std::numeric_limits<double>::max)()}, 2), "[1, 1.8e+308]");
}

BOOST_AUTO_TEST_CASE(flags_and_locales_do_not_matter) {
  std::ostringstream os;
  os.imbue(continental());
  os << std::fixed << std::showpos << GC::Enclosure{0.25, 0.5};
  BOOST_CHECK_EQUAL(os.str(), "[0.25, 0.5]");
}

BOOST_AUTO_TEST_CASE(equal_enclosures) {
  const GC::Enclosure x{1, 2};
  BOOST_CHECK((x == GC::Enclosure{1, 2}) && !(x != GC::Enclosure{1, 2}));
  for (const GC::Enclosure& y : {GC::Enclosure{0.5, 2}, GC::Enclosure{1, 3}}) BOOST_CHECK(x != y && !(x == y));
  BOOST_CHECK_EQUAL(text(GC::Enclosure{-infinity, infinity}, ' ', GC::Enclosure{std::nan(""), 1}),
                    "[-inf, inf] [nan, 1]");
}

BOOST_AUTO_TEST_SUITE_END()
