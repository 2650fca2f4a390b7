// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The proofs of the package require this of a platform without directed rounding: intervals that
// contain the exact results, and decimals that are read and written correctly.

#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <cfenv>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(rounding)

typedef CGAL::Interval_nt<false> Interval;
typedef CGAL::Exact_rational Q;

static double number_with_bits(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// Numbers of all sizes, among them subnormal ones, powers of two with their neighbours, and the
// largest.
static std::vector<double> numbers(int n) {
  std::mt19937_64 random(32);
  std::vector<double> result = {0, 1, 3, 0.1, 5e-324, 2.2250738585072014e-308, (std::numeric_limits<double>::max)()};
  while (static_cast<int>(result.size()) < n) {
    const double x = number_with_bits(random());
    if (!std::isfinite(x)) continue;
    const double power = std::ldexp(1., static_cast<int>(random() % 2000) - 1000);
    for (const double y : {x, power, std::nextafter(power, 0.),
                           std::ldexp(static_cast<double>(random() % 1000), static_cast<int>(random() % 60) - 30)})
      result.push_back(random() % 2 ? y : -y);
  }
  return result;
}

// Returns whether an interval contains a number, with infinite bounds.
static bool contains(const Interval& x, const Q& y) {
  return (std::isinf(x.inf()) || Q(x.inf()) <= y) && (std::isinf(x.sup()) || y <= Q(x.sup()));
}

static Interval pair_of(double x, double y) { return x < y ? Interval(x, y) : Interval(y, x); }

BOOST_AUTO_TEST_CASE(intervals_contain_the_exact_results) {
  const CGAL::Protect_FPU_rounding<true> protection;
  const std::vector<double> x = numbers(600);
  std::mt19937 random(7);
  int decided = 0;
  for (int k = 0; k < 3000; ++k) {
    const double a = x[random() % x.size()], b = x[random() % x.size()], c = x[random() % x.size()],
                 d = x[random() % x.size()];
    const Interval ab = k % 3 ? Interval(a) : pair_of(a, b), cd = k % 2 ? Interval(c) : pair_of(c, d);
    for (const double p : {ab.inf(), ab.sup()})
      for (const double q : {cd.inf(), cd.sup()}) {
        const Q u(p), v(q);
        BOOST_TEST(contains(ab + cd, Q(u + v)));
        BOOST_TEST(contains(ab - cd, Q(u - v)));
        BOOST_TEST(contains(ab * cd, Q(u * v)));
        if (!(cd.inf() <= 0 && 0 <= cd.sup())) BOOST_TEST(contains(ab / cd, Q(u / v)));
      }
    const Interval square = CGAL::square(ab);
    for (const double p : {ab.inf(), ab.sup()}) BOOST_TEST(contains(square, Q(Q(p) * Q(p))));
    const Interval positive = CGAL::abs(ab), root = CGAL::sqrt(positive);
    BOOST_TEST(Q(root.inf()) * Q(root.inf()) <= Q(positive.inf()));
    BOOST_TEST(Q(positive.sup()) <= Q(root.sup()) * Q(root.sup()));
    decided += (ab - cd).inf() > 0 || (ab - cd).sup() < 0;
  }
  BOOST_TEST(decided > 700); // they are not wide
}

#ifdef CGAL_ALWAYS_ROUND_TO_NEAREST
BOOST_AUTO_TEST_CASE(bounds_are_two_neighbours_apart_at_most) {
  const std::vector<double> x = numbers(400);
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Interval sum = Interval(x[k - 1]) + Interval(x[k]);
    if (std::isinf(sum.inf()) || std::isinf(sum.sup())) continue;
    BOOST_TEST(std::nextafter(std::nextafter(sum.inf(), sum.sup()), sum.sup()) == sum.sup());
  }
}

BOOST_AUTO_TEST_CASE(nothing_sets_the_rounding_mode) {
  const CGAL::Protect_FPU_rounding<true> protection;
  volatile double one = 1, three = 3;
  BOOST_TEST(one / three == 1. / 3.);
  BOOST_TEST(-(one / three) == (-one) / three);
}
#endif

static std::string written(double x) {
  char text[40];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}
static double read(const std::string& text) {
  double x = -1;
  const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), x);
  BOOST_TEST((end.ec == std::errc() && end.ptr == text.data() + text.size()), text);
  return x;
}

BOOST_AUTO_TEST_CASE(decimals_are_written_as_the_standard_says) {
  const std::pair<double, const char*> expected[] = {{0, "0"},
                                                     {-0., "-0"},
                                                     {1, "1"},
                                                     {0.1, "0.1"},
                                                     {-1.5, "-1.5"},
                                                     {1e5, "1e+05"},
                                                     {100, "100"},
                                                     {123456, "123456"},
                                                     {1e21, "1e+21"},
                                                     {1e23, "1e+23"},
                                                     {9007199254740993., "9007199254740992"},
                                                     {0.001, "0.001"},
                                                     {0.0001, "1e-04"},
                                                     {0.00012, "0.00012"},
                                                     {5e-324, "5e-324"},
                                                     {2.2250738585072014e-308, "2.2250738585072014e-308"},
                                                     {1.7976931348623157e308, "1.7976931348623157e+308"},
                                                     {9.5367431640625e-07, "9.5367431640625e-07"},
                                                     {0x1p-44, "5.684341886080802e-14"},
                                                     {0x1p-1022, "2.2250738585072014e-308"},
                                                     {1.0 / 3, "0.3333333333333333"},
                                                     {2.0 / 3, "0.6666666666666666"},
                                                     {12345678901234567890., "12345678901234567168"}};
  for (const auto& [x, text] : expected) BOOST_TEST(written(x) == text);
}

// The shortest decimal: it is read as the number, no decimal with a digit less is, and none of its
// length is nearer.
BOOST_AUTO_TEST_CASE(decimals_are_read_back) {
  std::vector<double> x = numbers(300);
  // below which numbers are closer
  for (int e = -1074; e < 1024; e += 7) x.push_back(std::ldexp(1., e));
  for (const double y : x) {
    const std::string text = written(y);
    BOOST_TEST(read(text) == y);
    char fewer[64];
    std::string digits;
    for (const char c : text.substr(0, text.find('e')))
      if ('0' <= c && c <= '9' && (c != '0' || !digits.empty())) digits += c;
    digits.erase(digits.find_last_not_of('0') + 1);
    // integers are written with all digits
    if (digits.size() < 2 || std::abs(y) >= 9007199254740992.) continue;
    const int n = std::snprintf(fewer, sizeof fewer, "%.*e", static_cast<int>(digits.size()) - 2, y);
    BOOST_TEST(read(std::string(fewer, static_cast<std::size_t>(n))) != y);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_number_or_too_large_is_not_read) {
  for (const std::string text : {"", "-", "+1", ".", "e5", "-.e1", " 1"}) {
    double x = 7;
    const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), x);
    BOOST_TEST((end.ec == std::errc::invalid_argument && end.ptr == text.data() && x == 7), text);
  }
  for (const std::string text : {"1e999", "-1e400", "1e-999"}) {
    double x = 7;
    BOOST_TEST((std::from_chars(text.data(), text.data() + text.size(), x).ec == std::errc::result_out_of_range), text);
  }
  for (const auto& [text, length] :
       {std::pair<std::string, int>{"1e", 1}, {"1.5e+", 3}, {"2.x", 2}, {"-.5-", 3}, {"1e5e", 3}, {"0e999 ", 5}}) {
    double x = 7;
    BOOST_TEST((std::from_chars(text.data(), text.data() + text.size(), x).ptr == text.data() + length), text);
  }
}

BOOST_AUTO_TEST_CASE(all_digits) {
  char text[1200];
  const char* const end = std::to_chars(text, text + sizeof text, 0.1, std::chars_format::scientific, 60).ptr;
  BOOST_TEST(std::string(text, static_cast<std::size_t>(end - text)) ==
             "1.000000000000000055511151231257827021181583404541015625000000e-01");
}

BOOST_AUTO_TEST_SUITE_END()
