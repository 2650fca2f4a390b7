// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#if defined(__GNUC__) && !defined(__clang__)
// false alarms in the cpp_rational of Boost 1.74
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#define BOOST_TEST_MODULE io
#include "support/test.h"
#include "support/words.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Quotient.h>
#ifdef CGAL_USE_GMP
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#endif

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <streambuf>

namespace fs = std::filesystem;

typedef CGAL::Epeck Epeck;

constexpr unsigned seed = 20260719;

// A field with nothing but what parse_number() and write_number() ask for; nothing is converted
// implicitly.
class Archetype {
  Q q_;
  struct Private {};
  Archetype(const Q& q, Private) : q_(q) {}

public:
  explicit Archetype(int i) : q_(i) {}
  friend Archetype operator+(const Archetype& a, const Archetype& b) { return {a.q_ + b.q_, Private()}; }
  friend Archetype operator-(const Archetype& a, const Archetype& b) { return {a.q_ - b.q_, Private()}; }
  friend Archetype operator*(const Archetype& a, const Archetype& b) { return {a.q_ * b.q_, Private()}; }
  friend Archetype operator/(const Archetype& a, const Archetype& b) { return {a.q_ / b.q_, Private()}; }
  friend bool operator==(const Archetype& a, const Archetype& b) { return a.q_ == b.q_; }
  friend std::ostream& operator<<(std::ostream& os, const Archetype& a) { return os << a.q_; }
};

// Sets the global locale for as long as it lives.
class Global_locale {
  std::locale old_;

public:
  explicit Global_locale(const std::locale& locale) : old_(std::locale::global(locale)) {}
  ~Global_locale() { std::locale::global(old_); }
};

template <class FT> std::string written(const FT& x) {
  return written_by([&](std::ostream& os) { GC::write_number(os, x); });
}

// 10^n for exact types, by another way than the reader's.
Q ten_to_the(int n) {
  Q power(1);
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

double from_bits(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

std::uint64_t to_bits(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

// The shortest decimal with an exponent that is read as x, by trial.
std::string shortest_with_exponent(double x) {
  char text[64];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*e", digits - 1, x);
    if (std::strtod(text, nullptr) == x) break;
  }
  return text;
}

template <class Traits> std::vector<GC::Bezier_curve<Traits>> read(const std::string& text) {
  std::istringstream is(text);
  return GC::read_g2_curves<Traits>(is, "f.g2");
}

template <class Traits> std::string g2_error(const std::string& text) {
  return error_of([&] { read<Traits>(text); });
}

template <class Curve> std::string g2_text(const Curve& curve) {
  return written_by([&](std::ostream& os) { GC::write_g2(os, curve); });
}

const std::string line_text = "100 1 0 0\n2 0\n2 2\n0 0 1 1\n349 388\n221 419\n\n",
                  cubic_text = "100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1\n721 339\n721 543\n570 705\n388 705\n\n";

// numbers

template <class FT> void check_exact_reading() {
  std::istringstream is("0 0/1 -0 0/1 12 12/1 +12 12/1 -12 -12/1 0012 12/1 0.1 1/10 .5 1/2 -.5 -1/2 3. 3/1 "
                        "1e-3 1/1000 1.5E+4 15000/1 1.5e4 15000/1 2.50e-1 1/4 0e4096 0/1 1e0000000001 10/1 "
                        "1/3 1/3 -2/6 -1/3 +7/007 1/1 0/5 0/1 123456789000/123456789 1000/1 "
                        "2000000000000000000000/1000000000000000000000 2/1 0.000000000000000000000125e21 1/8");
  std::string text;
  int p, q;
  for (char slash; is >> text >> p >> slash >> q;)
    BOOST_CHECK_MESSAGE(GC::parse_number<FT>(text) == FT(FT(p) / FT(q)), text << " is not " << p << '/' << q);
  BOOST_CHECK_EQUAL(text, "0.000000000000000000000125e21");
}

BOOST_AUTO_TEST_CASE(exact_numbers_are_read_as_written) {
  check_exact_reading<Q>();
  check_exact_reading<Epeck::FT>();
  check_exact_reading<boost::multiprecision::cpp_rational>();
  check_exact_reading<CGAL::Quotient<boost::multiprecision::cpp_int>>();
  check_exact_reading<CGAL::Quotient<CGAL::MP_Float>>();
  check_exact_reading<Archetype>();
#ifdef CGAL_USE_GMP
  check_exact_reading<CGAL::Gmpq>();
  check_exact_reading<CGAL::Quotient<CGAL::Gmpz>>();
#endif
}

BOOST_AUTO_TEST_CASE(long_exact_numbers) {
  const std::string zeros(3000, '0');
  const Q big = ten_to_the(3000);
  BOOST_CHECK(GC::parse_number<Q>("1" + zeros) == big);
  BOOST_CHECK(GC::parse_number<Q>("1" + zeros.substr(1) + "7") == big + 7);
  BOOST_CHECK(GC::parse_number<Q>("-0." + zeros.substr(1) + "3") == Q(-3) / big);
  BOOST_CHECK(GC::parse_number<Q>("1e4096") == ten_to_the(4096));
  BOOST_CHECK(GC::parse_number<Q>("1e-4096") * ten_to_the(4096) == Q(1));
  BOOST_CHECK(GC::parse_number<Q>("-7/1" + zeros) == Q(-7) / big);
  BOOST_CHECK(GC::parse_number<Q>(std::string(GC::max_number_length - 1, '0') + "5") == Q(5));
  BOOST_CHECK(GC::parse_number<Epeck::FT>("1" + zeros + "/3") == Epeck::FT(Q(big / 3)));
}

// Also fractions, ties, the neighbourhood of a tie, subnormal numbers and the largest ones.
BOOST_AUTO_TEST_CASE(floating_point_numbers_are_rounded_to_the_nearest) {
  const std::string zeros(400, '0'), largest = written(Q(std::numeric_limits<double>::max()));
  // a number, and another word for the nearest double
  const std::vector<std::string> words =
      words_of("+0.1 0.1 -.5 -0.5 3. 3 1.5E+4 15000 -12 -12 9007199254740993 9007199254740992 4.9e-324 4.94e-324 "
               "3e-324 4.94e-324 -2.2250738585072011e-308 -22250738585072011e-324 1.7976931348623157e308 "
               "1.79769313486231571e308 "
               "1.7976931348623158e308 1.79769313486231571e308 1/3 .33333333333333333 -1/10 -0.1 6/3 2 0/3 0 "
               "9007199254740993/1 9007199254740992 9007199254740995/1 9007199254740996 "
               "9007199254740993000000001/1000000000 9007199254740994 "
               "9007199254740993.0" +
               zeros + zeros + "1 9007199254740994 " + "1" + zeros + "/3" + zeros + " .33333333333333333 49/1" +
               zeros.substr(75) + " 4.94e-324 " + largest + "/1 " + largest);
  for (std::size_t i = 0; i < words.size(); i += 2)
    BOOST_CHECK_EQUAL(GC::parse_number<double>(words[i]), std::strtod(words[i + 1].c_str(), nullptr));
  BOOST_CHECK(std::signbit(GC::parse_number<double>("-0")));
  BOOST_CHECK_EQUAL(GC::parse_number<float>("0.1"), 0.1f);
  BOOST_CHECK_EQUAL(GC::parse_number<float>("-1/10"), -0.1f);
  std::mt19937_64 random = seeded<std::mt19937_64>(seed);
  for (int i = 0; i < 300; ++i) {
    const std::uint64_t p = random() >> (11 + random() % 50), q = 1 + (random() >> (11 + random() % 50));
    const std::string text = "-" + std::to_string(p) + "/" + std::to_string(q);
    // both are doubles, so that their quotient is rounded once
    BOOST_CHECK_EQUAL(GC::parse_number<double>(text), -(static_cast<double>(p) / static_cast<double>(q)));
  }
}

template <class FT> void check_refused(const std::string& text, const std::string& reason) {
  const std::string expected = "malformed_input: " + reason + ": '" + text + "'";
  BOOST_CHECK_EQUAL(error_of([&] { GC::parse_number<FT>(text); }), expected);
}

template <class FT> void check_refusals() {
  check_refused<FT>("", "empty number");
  for (const char* text :
       {"nan",  "NaN",  "-nan",  "inf",   "-inf",  "+Inf",  "infinity", "0x10",  "0x1p3", "1p3", "12a",
        "1,5",  "1 2",  " 1",    "1 ",    "+",     "-",     "--1",      "+-1",   "-+1",   ".",   "-.",
        "e5",   ".e5",  "1e",    "1e+",   "1e5.",  "1e5e5", "1..2",     "1.2.3", "/",     "1/",  "/2",
        "1/-2", "1/+2", "1/2/3", "1.5/2", "1/2.5", "1/2e3", "1e3/2",    "-/2",   "1 /2",  "1f",  "1'000"})
    check_refused<FT>(text, "not a number");
  check_refused<FT>("1/0", "zero denominator");
  check_refused<FT>("0/000", "zero denominator");
  check_refused<FT>("1e4097", "decimal exponent beyond 4096");
  check_refused<FT>("1e-4097", "decimal exponent beyond 4096");
  check_refused<FT>("0e999999999", "decimal exponent beyond 4096");
  check_refused<FT>("1e99999999999999999999999", "decimal exponent beyond 4096");
  const std::string beginning = "malformed_input: number longer than 4096 characters: '";
  BOOST_CHECK_EQUAL(error_of([] { GC::parse_number<FT>(std::string(GC::max_number_length + 1, '1')); }),
                    beginning + std::string(40, '1') + "...'");
  BOOST_CHECK_EQUAL(error_of([] { GC::parse_number<FT>(std::string("1\0\n\xC3", 4)); }),
                    "malformed_input: not a number: '1\\x00\\x0A\\xC3'");
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_is_refused) {
  check_refusals<Q>();
  check_refusals<double>();
  check_refusals<float>();
  check_refusals<Epeck::FT>();
  check_refusals<Archetype>();
  for (const char* text : {"1e309", "-1e309", "1.7976931348623159e308", "1e4096", "2e-324", "-2e-324", "1e-4096"})
    check_refused<double>(text, "outside the range of floating-point numbers");
  check_refused<float>("1e39", "outside the range of floating-point numbers");
  check_refused<float>("1e-46", "outside the range of floating-point numbers");
  const std::string zeros(400, '0');
  for (const std::string& text : {"1" + zeros + "/3", "-1" + zeros + "/3", "1/1" + zeros, "-1/1" + zeros})
    BOOST_CHECK(
        contains(error_of([&] { GC::parse_number<double>(text); }), "outside the range of floating-point numbers"));
  BOOST_CHECK(error_of([] { GC::parse_number<Q>("1e309"); }) == "no error");
}

BOOST_AUTO_TEST_CASE(floating_point_numbers_are_written_as_their_shortest_decimal) {
  BOOST_CHECK_EQUAL(written(0.1), "0.1");
  BOOST_CHECK_EQUAL(written(0.1f), "0.1");
  BOOST_CHECK_EQUAL(written(-3.0), "-3");
  BOOST_CHECK_EQUAL(written(0.0), "0");
  BOOST_CHECK_EQUAL(written(std::numeric_limits<double>::denorm_min()), "5e-324");
  std::mt19937_64 random = seeded<std::mt19937_64>(seed);
  int numbers = 0;
  while (numbers < 1000) {
    // every fourth a subnormal number, every fourth a short one
    std::uint64_t bits = random();
    if (numbers % 4 == 0) bits &= ~(std::uint64_t(0x7FF) << 52);
    if (numbers % 4 == 1) bits &= ~((std::uint64_t(1) << 42) - 1);
    const double x = from_bits(bits);
    if (!std::isfinite(x)) continue;
    ++numbers;
    const std::string text = written(x);
    BOOST_CHECK_MESSAGE(to_bits(GC::parse_number<double>(text)) == bits, text << " does not come back");
    const std::string other = shortest_with_exponent(x);
    BOOST_CHECK_MESSAGE(text.size() <= other.size(), text << " is longer than " << other);
  }
  for (double x : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    BOOST_CHECK_EQUAL(error_of([&] { written(x); }), "not_finite: write_number");
}

template <class FT> void check_exact_writing() {
  BOOST_CHECK_EQUAL(written(FT(0)), "0");
  BOOST_CHECK_EQUAL(written(FT(-12)), "-12");
  BOOST_CHECK_EQUAL(written(FT(FT(1) / FT(3))), "1/3");
  BOOST_CHECK_EQUAL(written(FT(FT(-1) / FT(10))), "-1/10");
  const std::string huge = std::string(300, '7') + "/1" + std::string(300, '0');
  BOOST_CHECK_EQUAL(written(GC::parse_number<FT>(huge)), huge);
  BOOST_CHECK_EQUAL(written(GC::parse_number<FT>("-" + huge)), "-" + huge);
}

BOOST_AUTO_TEST_CASE(exact_numbers_are_written_as_fractions) {
  check_exact_writing<Q>();
  check_exact_writing<Epeck::FT>(); // whose operator<< writes a double
  check_exact_writing<boost::multiprecision::cpp_rational>();
  check_exact_writing<CGAL::Quotient<boost::multiprecision::cpp_int>>();
  check_exact_writing<Archetype>();
#ifdef CGAL_USE_GMP
  check_exact_writing<CGAL::Gmpq>(); // whose operator<< writes a denominator 1
  check_exact_writing<CGAL::Quotient<CGAL::Gmpz>>();
  const auto quotient = [](int p, int q) { return CGAL::Quotient<CGAL::Gmpz>(CGAL::Gmpz(p), CGAL::Gmpz(q)); };
  BOOST_CHECK_EQUAL(written(quotient(4, 6)), "4/6");
  BOOST_CHECK_EQUAL(written(quotient(4, -6)), "-4/6");
  BOOST_CHECK_EQUAL(written(quotient(-4, -6)), "4/6");
  BOOST_CHECK_EQUAL(written(quotient(4, -1)), "-4");
#endif
  // operator<< writes 0.1/3 and 1.23457e+08/1, which is refused rather than written
  typedef CGAL::Quotient<CGAL::MP_Float> Approximate;
  BOOST_CHECK_EQUAL(written(Approximate(1, 3)), "1/3");
  BOOST_CHECK_EQUAL(error_of([] { written(Approximate(CGAL::MP_Float(0.1), CGAL::MP_Float(3))); }),
                    "cannot_write_file: the number type does not print exact numbers: '0.1/3'");
  BOOST_CHECK(contains(error_of([] { written(Approximate(123456789)); }), "does not print exact numbers"));
}

BOOST_AUTO_TEST_CASE(streams_and_locales_do_not_change_what_is_written) {
  const Global_locale global(continental());
  std::ostringstream os; // in the global locale
  os << std::hex << std::showpos << std::showbase << std::scientific << std::setprecision(2) << std::setfill('*');
  os << std::setw(20);
  GC::write_number(os, 12345.678);
  os.put(' ');
  os << std::setw(20);
  GC::write_number(os, Q(Q(1234567) / 10));
  os.put(' ');
  GC::write_number(os, Epeck::FT(1234567));
  os.put(' ');
  GC::write_number(os, CGAL::Quotient<int>(-1234567, 1000)); // printed by the stream
  BOOST_CHECK_EQUAL(os.str(), "12345.678 1234567/10 1234567 -1234567/1000");
  BOOST_CHECK_EQUAL(GC::parse_number<double>("12345.678"), 12345.678);

  std::ostringstream curves;
  curves << std::hex << std::showpos << std::setw(50);
  std::vector<Exact_2::Point> points(1001, Exact_2::Point(1000, 2000));
  GC::write_g2(curves, GC::Bezier_curve<Exact_2>(points.begin(), points.end()));
  BOOST_CHECK_EQUAL(curves.str().substr(0, 32), "100 1 0 0\n2 0\n1001 1001\n0 0 0 0 ");
  BOOST_CHECK(contains(curves.str(), "\n1000 2000\n"));
  std::istringstream is(cubic_text);
  BOOST_CHECK_EQUAL(GC::read_g2_curves<Exact_2>(is, "f.g2").size(), 1u);
}

// curves

BOOST_AUTO_TEST_CASE(curves_are_read) {
  const std::vector<GC::Bezier_curve<Exact_2>> curves = read<Exact_2>(cubic_text + line_text);
  BOOST_REQUIRE_EQUAL(curves.size(), 2u);
  typedef Exact_2::Point P;
  BOOST_CHECK(curves[0] == (GC::Bezier_curve<Exact_2>{P(721, 339), P(721, 543), P(570, 705), P(388, 705)}));
  BOOST_CHECK(curves[1] == (GC::Bezier_curve<Exact_2>{P(349, 388), P(221, 419)}));
  // the same layout is written
  BOOST_CHECK_EQUAL(g2_text(curves[0]) + g2_text(curves[1]), cubic_text + line_text);
}

BOOST_AUTO_TEST_CASE(white_space_auxiliary_values_and_number_formats) {
  const std::string text = "\r\n\t 100 1 0 4 255 -1 0 255 2\v0 2\f2 1/2 0.5\r\n7 7 .1 1/3 1e2 -4";
  const std::vector<GC::Bezier_curve<Exact_2>> curves = read<Exact_2>(text);
  BOOST_REQUIRE_EQUAL(curves.size(), 1u);
  const Exact_2::Point points[] = {{Q(1) / 10, Q(1) / 3}, {100, -4}};
  BOOST_CHECK(curves[0] == GC::Bezier_curve<Exact_2>(points, points + 2, Q(1) / 2, 7));
}

BOOST_AUTO_TEST_CASE(all_dimensions_and_degrees) {
  // a constant curve
  const std::vector<GC::Bezier_curve<Exact_3>> constant = read<Exact_3>("100 1 0 0 3 0 1 1 -1 5 1 2 3");
  BOOST_REQUIRE_EQUAL(constant.size(), 1u);
  BOOST_CHECK_EQUAL(constant[0].degree(), 0);
  BOOST_CHECK(constant[0].domain() == (std::pair<Q, Q>(-1, 5)));
  BOOST_CHECK(constant[0].control_point(0) == Exact_3::Point(1, 2, 3));
  // dimension 5
  const std::vector<GC::Bezier_curve<Exact_d>> five = read<Exact_d>("100 1 0 0 5 0 2 2 0 0 1 1 1 2 3 4 5 6 7 8 9 1/7");
  BOOST_REQUIRE_EQUAL(five.size(), 1u);
  BOOST_CHECK_EQUAL(five[0].dimension(), 5);
  BOOST_CHECK(five[0].coordinates(1)[4] == Q(1) / 7);
  BOOST_CHECK(five[0].coordinates(0)[2] == Q(3));
  BOOST_CHECK_EQUAL(g2_text(five[0]), "100 1 0 0\n5 0\n2 2\n0 0 1 1\n1 2 3 4 5\n6 7 8 9 1/7\n\n");
  // the highest order, and the highest dimension
  std::string text = "100 1 0 0\n16 0\n128 128\n";
  for (int i = 0; i < 256; ++i) text += i < 128 ? "0 " : "1 ";
  for (int i = 0; i < 16 * 128; ++i) text += std::to_string(i) + " ";
  const std::vector<GC::Bezier_curve<Exact_d>> high = read<Exact_d>(text);
  BOOST_REQUIRE_EQUAL(high.size(), 1u);
  BOOST_CHECK_EQUAL(high[0].degree(), 127);
  BOOST_CHECK(high[0].coordinates(127)[15] == Q(2047));
  // a degree known at compile time
  typedef Exact_2::Point P;
  const GC::Bezier_curve<Exact_2, 1> line{P(349, 388), P(221, 419)};
  BOOST_CHECK_EQUAL(g2_text(line), line_text);
}

// Curves of numbers with some 300 digits are written and read without loss; returns the text of the
// last one.
template <class Traits> std::string check_round_trip() {
  typedef typename Traits::FT FT;
  std::mt19937_64 random = seeded<std::mt19937_64>(seed);
  const auto number = [&random] {
    Q p(1), q(1);
    for (int i = 0; i < 20; ++i) {
      p = p * Q(1 << 30) + Q(static_cast<int>(random() >> 34));
      q = q * Q(1 << 30) + Q(static_cast<int>(random() >> 34));
    }
    return random() % 2 == 0 ? FT(Q(p / q)) : FT(Q(-p / q));
  };
  std::vector<GC::Bezier_curve<Traits>> curves;
  for (int order = 1; order <= 8; ++order) {
    std::vector<typename Traits::Point> points;
    for (int j = 0; j < order; ++j) points.push_back({number(), number(), number()});
    const FT a = number();
    curves.emplace_back(points.begin(), points.end(), a, FT(a + FT(1) / FT(3)));
  }
  BOOST_CHECK(written(curves[0].domain().first).size() > 300);
  std::stringstream stream;
  GC::write_g2(stream, curves);
  BOOST_CHECK(GC::read_g2_curves<Traits>(stream, "f.g2") == curves);
  return g2_text(curves[7]);
}

BOOST_AUTO_TEST_CASE(exact_round_trip) { BOOST_CHECK_EQUAL(check_round_trip<Exact_3>(), check_round_trip<Epeck_3>()); }

BOOST_AUTO_TEST_CASE(nothing_is_written_when_a_number_cannot_be_written) {
  typedef CGAL::Quotient<CGAL::MP_Float> Approximate;
  typedef GC::Traits_2<CGAL::Simple_cartesian<Approximate>> Traits;
  const Traits::Point points[] = {{1, 2}, {3, Approximate(CGAL::MP_Float(0.1), CGAL::MP_Float(3))}};
  std::ostringstream os;
  const GC::Bezier_curve<Traits> curve(points, points + 2);
  BOOST_CHECK(contains(error_of([&] { GC::write_g2(os, curve); }), "cannot_write_file"));
  BOOST_CHECK_EQUAL(os.str(), "");
}

BOOST_AUTO_TEST_CASE(nothing_is_written_of_numbers_that_are_not_finite) {
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    const Double_2::Point points[] = {{0, 1}, {2, bad}};
    std::ostringstream os;
    CHECK_ERROR(GC::write_number(os, bad), not_finite);
    CHECK_ERROR(GC::write_g2(os, GC::Bezier_curve<Double_2>(points, points + 2)), not_finite);
    BOOST_CHECK_EQUAL(os.str(), "");
  }
}

BOOST_AUTO_TEST_CASE(texts_in_messages_are_quoted) {
  BOOST_CHECK(GC::is_utf8("") && GC::is_utf8("kr\xc3\xbcmmung") && !GC::is_utf8("n\xe8") && !GC::is_utf8("\xc3"));
  BOOST_CHECK_EQUAL(GC::quoted_token(""), "''");
  BOOST_CHECK_EQUAL(GC::quoted_token("a b"), "'a b'");
  BOOST_CHECK_EQUAL(GC::quoted_token("\n\x7f\xff"), "'\\x0A\\x7F\\xFF'");
  BOOST_CHECK_EQUAL(GC::quoted_token(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
  BOOST_CHECK_EQUAL(GC::quoted_token(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

// errors

// `text` in dimension 2 is refused, in every number type, with a message that begins and ends as
// said.
void check_g2_error(const std::string& text, int line, const std::string& reason) {
  const std::string expected = "malformed_input: f.g2:" + std::to_string(line) + ": " + reason;
  BOOST_CHECK_EQUAL(g2_error<Exact_2>(text), expected);
  BOOST_CHECK_EQUAL(g2_error<Double_2>(text), expected);
}

// The cubic with one of its lines replaced.
std::string with_line(int line, const std::string& replacement) {
  std::istringstream is(cubic_text);
  std::string result, old;
  for (int i = 1; std::getline(is, old); ++i) result += (i == line ? replacement : old) + "\n";
  return result;
}

// Refused is the cubic after another curve of eight lines, at the end of the replacement.
struct Refused {
  int line;
  std::string replacement, reason;
};
void check_refused(const std::vector<Refused>& rows) {
  for (const auto& [line, replacement, reason] : rows)
    check_g2_error("\n" + line_text + with_line(line, replacement),
                   8 + line + static_cast<int>(std::count(replacement.begin(), replacement.end(), '\n')), reason);
}

BOOST_AUTO_TEST_CASE(empty_files) {
  check_g2_error("", 1, "no curve");
  check_g2_error(" \n\n\t\n", 1, "no curve");
  std::istringstream is;
  GC::G2_curve_reader<Exact_2> reader(is, "f.g2");
  BOOST_CHECK_EQUAL(error_of([&] { reader.next(); }), "malformed_input: f.g2:1: no curve");
}

BOOST_AUTO_TEST_CASE(wrong_headers) {
  const std::string range = " where an integer from 0 to 2147483647 is expected";
  check_refused(
      {{1, "200 1 0 0", "200 (spline surface) where a curve (100) is expected"},
       {1, "700 1 0 0", "700 where a curve (100) is expected"},
       {1, "abc", "the class of the object is 'abc'" + range},
       {1, "100.0 1 0 0", "the class of the object is '100.0'" + range},
       {1, "100 2 0 0", "the major version is '2' where 1 is expected"},
       {1, "100 1 1 0", "the minor version is '1' where 0 is expected"},
       {1, "100 1 0 -4", "the number of auxiliary values is '-4'" + range},
       {1, "100 1 0 4000000000", "the number of auxiliary values is '4000000000'" + range},
       {1, "100 1 0 2 5 x", "an auxiliary value is 'x' where an integer from -2147483648 to 2147483647 is expected"},
       {9, "5", "5 where a curve (100) is expected"}});
  check_g2_error("200 1 0 0", 1, "200 (spline surface) where a curve (100) is expected");
  check_g2_error("100 1 0 2000000000 5\n 6", 2, "file ends after 2 of 2000000000 auxiliary values");
}

BOOST_AUTO_TEST_CASE(wrong_dimensions) {
  check_refused({{2, "3 0", "dimension 3 where 2 is expected"},
                 {2, "-2 0", "the dimension is '-2' where an integer from 0 to 2147483647 is expected"},
                 {2, "2 1", "a rational curve where a polynomial one is expected"},
                 {2, "2 2", "the rational flag is '2' where an integer from 0 to 1 is expected"}});
  const std::string range = " where an integer from 2 to 16 is expected";
  for (const std::string d : {"1", "17", "0", "-3", "2.0", "4000000000"})
    BOOST_CHECK_EQUAL(g2_error<Exact_d>("100 1 0 0\n" + d + " 0"),
                      "malformed_input: f.g2:2: the dimension is '" + d + "'" + range);
  BOOST_CHECK_EQUAL(g2_error<Exact_d>(line_text + "100 1 0 0\n3 0\n"),
                    "malformed_input: f.g2:9: dimension 3 after a curve of dimension 2");
  BOOST_CHECK_EQUAL(g2_error<Exact_d>(line_text + line_text), "no error");
}

BOOST_AUTO_TEST_CASE(absurd_counts) {
  const std::string points = " where an integer from 1 to 2147483647 is expected";
  const std::string order = " where an integer from 1 to 128 is expected";
  for (const std::string n : {"4000000000", "-4", "0", "4.0", "4e0", "four", "0x4", "99999999999999999999"})
    check_refused({{3, n + " 4", "the number of control points is '" + n + "'" + points},
                   {3, "4 " + n, "the order is '" + n + "'" + order}});
  const std::string inner = " control points and order 4: inner knots are not supported, only Bezier curves";
  check_refused({{3, "129 129", "the order is '129'" + order},
                 {3, "2147483647 4", "2147483647" + inner},
                 {3, "5 4", "5" + inner},
                 {3, "3 4", "3 control points and order 4: there must be as many control points as the order says"}});
}

BOOST_AUTO_TEST_CASE(wrong_knots) {
  const std::string not_clamped = "the knots are not clamped: knot ", end = " of 8 must be equal to the one before it";
  check_refused({{4, "0 0 0 1 1 1 1 1", not_clamped + "4" + end},
                 {4, "0 0 0 0 1 1 1\n2", not_clamped + "8" + end},
                 {4, "0 0 0 -1/2 1 1 1 1", "the knots decrease at '-1/2'"},
                 {4, "0 0 0 0 1 1 .5 1", "the knots decrease at '.5'"},
                 {4, "0 0 0 0 -1 -1 -1 -1", "the knots decrease at '-1'"},
                 {4, "3 3 3 3 3 3 3 3", "the first and the last knots are equal: empty domain"},
                 {4, "0 0 0 0 1 1 nan 1", "not a number: 'nan'"}});
  // equal numbers in different words are equal knots
  BOOST_CHECK_EQUAL(g2_error<Double_2>(with_line(4, ".1 1/10 1e-1 10e-2 1 1 1 1")), "no error");
}

BOOST_AUTO_TEST_CASE(knots_that_are_too_far_apart) {
  const std::string text = "100 1 0 0\n2 0\n2 2\n-1.7e308 -1.7e308\n1.7e308 1.7e308\n0 0\n1 1\n",
                    message = "malformed_input: f.g2:5: the difference of the knots is outside the range of "
                              "floating-point numbers";
  BOOST_CHECK_EQUAL(g2_error<Double_2>(text), message);
  std::istringstream is(text);
  BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_bsplines<Double_2>(is, "f.g2"); }), message);
  BOOST_CHECK_EQUAL(read<Exact_2>(text).size(), 1u);
}

BOOST_AUTO_TEST_CASE(wrong_coordinates) {
  check_refused({{6, "721 nan", "not a number: 'nan'"},
                 {6, "-inf 5", "not a number: '-inf'"},
                 {8, "5 1/0", "zero denominator: '1/0'"},
                 {8, "5 1e999999999", "decimal exponent beyond 4096: '1e999999999'"},
                 {8, "5 " + std::string(4096, 'x'), "not a number: '" + std::string(40, 'x') + "...'"},
                 {8, "5 " + std::string(100000, '1'),
                  "more than 4096 characters without a space: '" + std::string(40, '1') + "...'"},
                 {8, std::string("5 1\0", 4) + "\x7F\xFF", "not a number: '1\\x00\\x7F\\xFF'"}});
  BOOST_CHECK_EQUAL(g2_error<Double_2>(with_line(5, "1e309 0")),
                    "malformed_input: f.g2:5: outside the range of floating-point numbers: '1e309'");
  BOOST_CHECK_EQUAL(g2_error<Exact_2>(with_line(5, "1e309 0")), "no error");
  check_g2_error(std::string("\x7F") + "ELF\x02", 1,
                 "the class of the object is '\\x7FELF\\x02' where an integer from 0 to 2147483647 is expected");
}

// One word a line: what is missing before each.
BOOST_AUTO_TEST_CASE(truncated_files) {
  const std::vector<std::string> words = words_of("100 1 0 1 7 2 0 2 2 0 0 1 1 3 4 5 6");
  std::istringstream missing("before the major version, before the minor version, "
                             "before the number of auxiliary values, after 0 of 1 auxiliary values, "
                             "before the dimension, before the rational flag, before the number of control points, "
                             "before the order, after 0 of 4 knots, after 1 of 4 knots, after 2 of 4 knots, "
                             "after 3 of 4 knots, after 0 of 2 control points, after 0 of 2 control points, "
                             "after 1 of 2 control points, after 1 of 2 control points");
  std::string text, what;
  int line = 1;
  for (; std::getline(missing >> std::ws, what, ','); ++line) {
    text += words[line - 1] + "\n";
    check_g2_error(text, line, "file ends " + what);
  }
  BOOST_CHECK_EQUAL(g2_error<Exact_2>(text + words[line - 1]), "no error");
  check_g2_error(cubic_text.substr(0, cubic_text.find("388")), 7, "file ends after 3 of 4 control points");
}

// A stream buffer that repeats a text for ever and counts the characters that are taken.
class Endless : public std::streambuf {
  std::string text_;
  std::size_t taken_ = 0;
  char current_ = 0;

  int_type underflow() override {
    current_ = text_[taken_++ % text_.size()];
    setg(&current_, &current_, &current_ + 1);
    return traits_type::to_int_type(current_);
  }

public:
  explicit Endless(const std::string& text) : text_(text) {}
  std::size_t taken() const { return taken_; }
};

BOOST_AUTO_TEST_CASE(curves_are_read_one_after_the_other) {
  Endless endless(cubic_text);
  std::istream is(&endless);
  GC::G2_curve_reader<Exact_2> reader(is, "endless");
  const GC::Bezier_curve<Exact_2> cubic = read<Exact_2>(cubic_text)[0];
  for (int i = 1; i <= 100; ++i) {
    const std::optional<GC::Bezier_curve<Exact_2>> curve = reader.next();
    BOOST_REQUIRE(curve);
    BOOST_CHECK(*curve == cubic);
    BOOST_CHECK(endless.taken() <= i * cubic_text.size());
  }
  std::istringstream two(cubic_text + line_text);
  GC::G2_curve_reader<Exact_2> finite(two, "finite");
  BOOST_CHECK(finite.next());
  BOOST_CHECK(finite.next());
  BOOST_CHECK(!finite.next());
  BOOST_CHECK(!finite.next());
}

BOOST_AUTO_TEST_CASE(endless_words_are_not_accumulated) {
  Endless endless("9");
  std::istream is(&endless);
  BOOST_CHECK(contains(error_of([&] { GC::read_g2_curves<Exact_2>(is, "endless"); }),
                       "endless:1: more than 4096 characters without a space"));
  BOOST_CHECK_EQUAL(endless.taken(), GC::max_number_length + 1);
}

BOOST_AUTO_TEST_CASE(streams_that_cannot_be_read) {
  std::ifstream missing("/there is no such folder/missing.g2");
  BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_curves<Exact_2>(missing, "missing.g2"); }),
                    "cannot_read_file: missing.g2: the stream cannot be read");
  std::ifstream opened(fs::temp_directory_path()); // a folder, which some systems open
  BOOST_CHECK(contains(error_of([&] { GC::read_g2_curves<Exact_2>(opened, "folder"); }), "cannot_read_file: folder: "));
  std::istringstream nameless("101");
  BOOST_CHECK(contains(error_of([&] { GC::read_g2_curves<Exact_2>(nameless); }), "malformed_input: input:1: "));
}

BOOST_AUTO_TEST_CASE(byte_order_marks) {
  BOOST_CHECK(read<Exact_2>("\xEF\xBB\xBF" + cubic_text)[0] == read<Exact_2>(cubic_text)[0]);
}
