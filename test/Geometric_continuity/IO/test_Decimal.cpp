// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers as they are written: they are the rational numbers that parse_number() reads, in all
// forms, and so are their order and their multiples of powers of ten.

#include "support/test.h"
#include "support/words.h"

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Interval_nt.h>

BOOST_AUTO_TEST_SUITE(Decimal)

std::mt19937 random_bits;

void seed() { random_bits = seeded(20261122); }

int below(int n) { return static_cast<int>(random_bits() % static_cast<unsigned>(n)); }

// Digits, of which some are zeros in front and behind.
std::string digits(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += static_cast<char>('0' + below(10));
  if (below(3) == 0) text.insert(0, static_cast<std::size_t>(below(4)), '0');
  if (below(3) == 0) text.append(static_cast<std::size_t>(below(4)), '0');
  return text;
}

// A decimal with up to 25 digits, and how many of them a short one must keep: not the zeros in
// front, nor those behind the last other digit behind the point.
std::pair<std::string, std::size_t> random_decimal(bool far = true) {
  const int n = 1 + below(25), before = below(n + 1);
  std::string integer = before == 0 ? "" : digits(before), fraction = before == n ? "" : digits(n - before);
  std::string text = integer;
  if (!fraction.empty() || below(3) == 0) text += '.' + fraction;
  const char* const signs[] = {"", "+", "-"};
  text.insert(0, signs[below(3)]);
  if (below(2) == 0) {
    const int largest = far && below(10) == 0 ? GC::max_decimal_exponent : 25, e = below(largest + 1);
    text += (below(2) == 0 ? "e" : "E") + std::string(signs[below(3)]) + (below(4) == 0 ? "00" : "") +
            std::to_string(below(20) == 0 ? largest : e);
  }
  while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
  const std::string all = integer + fraction;
  const std::size_t first = all.find_first_not_of('0');
  return {text, first == std::string::npos ? 0 : all.size() - first};
}

std::string random_fraction() {
  const char* const signs[] = {"", "+", "-"};
  return signs[below(3)] + digits(1 + below(25)) + "/1" + digits(below(24));
}

Q power_of_ten(int exponent) { return GC::parse_number<Q>("1e" + std::to_string(exponent)); }

// Returns the error for a text, or nothing.
std::string refusal_of_text_number(const std::string& text) {
  return error_of([&] { GC::Decimal{text}; });
}
std::string refusal_of_number(const std::string& text) {
  return error_of([&] { GC::parse_number<Q>(text); });
}

BOOST_AUTO_TEST_CASE(values_are_those_that_are_parsed) {
  seed();
  int short_ones = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto [text, size] = random_decimal();
    const GC::Decimal x{text};
    BOOST_CHECK_MESSAGE(x.value() == GC::parse_number<Q>(text), text);
    BOOST_CHECK_MESSAGE(x.is_decimal() == (size <= 18), text << " has " << size << " digits");
    short_ones += x.is_decimal();
  }
  BOOST_CHECK_GT(short_ones, 1000);
  BOOST_CHECK_LT(short_ones, 3500);
  for (int i = 0; i < 500; ++i) {
    const std::string text = random_fraction();
    const GC::Decimal x{text};
    BOOST_CHECK_MESSAGE(x.value() == GC::parse_number<Q>(text) && !x.is_decimal(), text);
  }
  const std::string zeros(4000, '0');
  for (const std::string& text :
       words_of("0 -0 +0.0 0e4096 -.0e-4096 .5 5. -5.e-3 000.500 1e4096 -1E-4096 999999999999999999 "
                "-.999999999999999999e-4096 000123456789.123456789000 ." +
                zeros + "1 " + zeros + "1 ." + zeros + "1e-4096 1." + zeros + "e4096")) {
    const GC::Decimal x{text};
    BOOST_CHECK_MESSAGE(x.is_decimal() && x.value() == GC::parse_number<Q>(text), text);
  }
  for (const char* text : {"1000000000000000000", "-.1234567890123456789", "1234567890.123456789", "1/1", "0/5"}) {
    const GC::Decimal x{text};
    BOOST_CHECK_MESSAGE(!x.is_decimal() && x.value() == GC::parse_number<Q>(text), text);
  }
  BOOST_CHECK(GC::Decimal().value() == 0 && GC::Decimal().is_decimal());
  BOOST_CHECK(GC::Decimal(-15, -1).value() == Q(-3) / 2);
  BOOST_CHECK(GC::Decimal(Q(-3) / 2).value() == Q(-3) / 2);
}

// Also of numbers that are equal but written in different ways.
BOOST_AUTO_TEST_CASE(order) {
  seed();
  std::vector<std::string> texts =
      words_of("0 -0.0 1/2 .5 5e-1 0.50 10 1e1 100e-1 20/2 -1e4096 1e4096 1e-4096 -1e-4096 1234567890123456789 "
               "1234567890123456789.0 123456789012345678.9e1");
  for (int i = 0; i < 60; ++i) texts.push_back(i % 5 == 0 ? random_fraction() : random_decimal(false).first);
  for (int i = 0; i < 20; ++i) texts.push_back(std::to_string(below(5) - 2) + (i % 2 == 0 ? ".0" : "e-1"));
  for (const std::string& s : texts)
    for (const std::string& t : texts) {
      const GC::Decimal x{s}, y{t};
      const Q a = GC::parse_number<Q>(s), b = GC::parse_number<Q>(t);
      BOOST_CHECK_MESSAGE((x == y) == (a == b) && (x != y) == (a != b) && (x < y) == (a < b), s << " and " << t);
    }
}

BOOST_AUTO_TEST_CASE(integers_on_grids) {
  seed();
  const Q largest = Q(std::int64_t(1) << 60);
  int found = 0, too_large = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [text, size] = random_decimal(i % 10 == 0);
    const GC::Decimal number{text};
    const int exponent = number.exponent() - below(22);
    const std::int64_t before = -7;
    std::int64_t x = before;
    const bool exists = number.on_grid(exponent, x);
    if (!number.is_decimal()) {
      BOOST_CHECK_MESSAGE(!exists && x == before, text);
      continue;
    }
    const Q expected = number.value() / power_of_ten(exponent);
    BOOST_CHECK_MESSAGE(exists == (-largest < expected && expected < largest), text << ", exponent " << exponent);
    BOOST_CHECK_MESSAGE(exists ? Q(x) == expected : x == before, text << ", exponent " << exponent);
    if (number.value() != 0) // the number is no multiple of higher powers, as it is written
      BOOST_CHECK_MESSAGE(!number.on_grid(number.exponent() + 1 + below(5), x), text);
    ++(exists ? found : too_large);
  }
  BOOST_CHECK_GT(found, 300);
  BOOST_CHECK_GT(too_large, 300);
  // at the bound 2^60 = 1152921504606846976, on both sides of zero
  const auto on_grid = [](const char* text, int exponent) {
    std::int64_t x = 0, y = 0;
    const bool exists = GC::Decimal{text}.on_grid(exponent, x),
               opposite = GC::Decimal{std::string("-") + text}.on_grid(exponent, y);
    BOOST_CHECK_EQUAL(exists, opposite);
    BOOST_CHECK_EQUAL(x, -y);
    return x;
  };
  BOOST_CHECK_EQUAL(on_grid("115292150460684697", -1), 1152921504606846970);
  BOOST_CHECK_EQUAL(on_grid("115292150460684698", -1), 0);
  BOOST_CHECK_EQUAL(on_grid("1.152921504606846", -18), 1152921504606846000);
  BOOST_CHECK_EQUAL(on_grid("1.152921504606847", -18), 0);
  BOOST_CHECK_EQUAL(on_grid("1", -18), 1000000000000000000);
  BOOST_CHECK_EQUAL(on_grid("1", -19), 0);
  BOOST_CHECK_EQUAL(on_grid("1e4096", 4080), 10000000000000000);
  BOOST_CHECK_EQUAL(on_grid("1e4096", -4096), 0);
  // zero is on every grid
  for (int exponent : {-5000, -1, 0, 3, 5000}) {
    std::int64_t x = 1;
    BOOST_CHECK(GC::Decimal{"-0.000e7"}.on_grid(exponent, x) && x == 0);
  }
}

// With the same words as by parse_number().
BOOST_AUTO_TEST_CASE(refused_as_numbers_are) {
  std::vector<std::string> texts = words_of("+ - . -. e5 .e5 1e 1e+ 1E- 1e4097 1e-4097 0e4097 1e99999999999999999999 "
                                            "1x 0x10 nan inf -inf 1/0 1/-2 1/+2 /2 1/ "
                                            "1.5/2 1/2.5 1/2e3 1,5 --1 +-1 1e5e5 1.2.3 1e1.5 \xEF\xBB\xBF\61");
  const std::string zeros(GC::max_number_length, '0');
  for (const std::string& text : {std::string(), std::string("1 "), std::string(" 1"), std::string("1\0", 2),
                                  zeros + "1", "1." + zeros, "7" + zeros})
    texts.push_back(text);
  for (const std::string& text : texts) {
    const std::string expected = refusal_of_number(text);
    BOOST_CHECK_NE(expected, "no error");
    BOOST_CHECK_EQUAL(refusal_of_text_number(text), expected);
  }
  BOOST_CHECK_EQUAL(refusal_of_text_number(std::string(GC::max_number_length - 1, '0') + "1"), "no error");
  // texts of the characters that numbers have
  seed();
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (int n = below(9); n > 0; --n) text += "0123456789+-.eE/ 00.5"[below(21)];
    const std::string expected = refusal_of_number(text);
    BOOST_REQUIRE_EQUAL(refusal_of_text_number(text), expected);
    if (expected == "no error")
      BOOST_REQUIRE_MESSAGE(GC::Decimal{text}.value() == GC::parse_number<Q>(text), text);
    else
      ++refused;
  }
  BOOST_CHECK_LT(refused, 19000);
}

BOOST_AUTO_TEST_CASE(enclosures) {
  const CGAL::Protect_FPU_rounding<true> rounding_upwards;
  for (const char* text :
       {"0", "1", "-7", "0.1", "-0.1", "123456789012345678", "-999999999999999999e-9", "7e17", "3e-40", "-5e90",
        "1234567890123456.78e-300", "1/3", "-22/7", "12345678901234567890.5", "1e300", "1e-400", "-1e400", "1e4000"}) {
    const GC::Decimal x{text};
    const CGAL::Interval_nt<false> i = x.enclosure();
    const Q value = x.value();
    BOOST_CHECK_MESSAGE(std::isinf(i.inf()) || Q(i.inf()) <= value, text);
    BOOST_CHECK_MESSAGE(std::isinf(i.sup()) || value <= Q(i.sup()), text);
    if (std::isfinite(i.inf()) && std::isfinite(i.sup())) // close
      BOOST_CHECK_MESSAGE(i.sup() - i.inf() <= 1e-14 * std::abs(i.sup()) + 1e-300, text);
  }
  BOOST_CHECK(GC::Decimal("0.5").enclosure().is_point() && GC::Decimal("-12e3").enclosure().is_point());
}

BOOST_AUTO_TEST_SUITE_END()
