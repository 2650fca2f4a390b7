// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <iomanip>

BOOST_AUTO_TEST_SUITE(json)

typedef GC::Bezier_curve<Exact_2> Curve;
typedef Exact_2::Point Point;

template <class... T> std::string json(const T&... x) {
  return written_by([&](std::ostream& os) { GC::write_json(os, x...); });
}

template <class... T> std::string members(const T&... x) {
  return written_by([&](std::ostream& os) { GC::write_json_members(os, x...); });
}

// f(os) throws `not_finite` and writes nothing.
template <class F> void check_not_finite(F f) {
  std::ostringstream os;
  CHECK_ERROR(f(os), not_finite);
  BOOST_CHECK_EQUAL(os.str(), "");
}

BOOST_AUTO_TEST_CASE(texts) {
  BOOST_CHECK_EQUAL(json(""), "\"\"");
  BOOST_CHECK_EQUAL(json("true"), "\"true\""); // a text, not a flag
  BOOST_CHECK_EQUAL(json(std::string("a\"b\\c/d")), "\"a\\\"b\\\\c/d\"");
  BOOST_CHECK_EQUAL(json(std::string_view("\n\t\0\x1f\x7f", 5)), "\"\\u000a\\u0009\\u0000\\u001f\x7f\"");
  BOOST_CHECK_EQUAL(json("\xc3\xa9"), "\"\xc3\xa9\"");
}

BOOST_AUTO_TEST_CASE(texts_that_are_not_utf_8) {
  const std::string r = "\xef\xbf\xbd"; // U+FFFD
  const auto check = [](const std::string& text, const std::string& expected) {
    BOOST_CHECK_EQUAL(json(text), '"' + expected + '"');
  };
  // the least and the largest character of each length, what surrounds the surrogates, and
  // noncharacters stay
  for (const char* text : {"\x7f", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                           "\xef\xbf\xbe", "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"})
    check(text, text);
  check("a\x80z\xffz\xfe", 'a' + r + 'z' + r + 'z' + r); // no first bytes
  check("\xc0\xaf\xc1\xbf", r + r + r + r);              // overlong: no beginning of a character
  check("\xe0\x9f\xbf\xf0\x8f\xbf\xbf", r + r + r + r + r + r + r);
  check("\xed\xa0\x80\xed\xbf\xbf", r + r + r + r + r + r); // surrogates
  check("\xf4\x90\x80\x80\xf5\x80", r + r + r + r + r + r); // beyond U+10FFFF
  check("\xe2\x82", r);                                     // cut off
  check("\xe2\x82z\xf0\x9f\x98\"", r + 'z' + r + "\\\"");
  check("\xf0\x90\xe2\x82\xac\xe2", r + "\xe2\x82\xac" + r);
}

BOOST_AUTO_TEST_CASE(flags) {
  BOOST_CHECK_EQUAL(json(std::optional<bool>()), "null");
  BOOST_CHECK_EQUAL(json(std::optional<bool>(true)), "true");
  BOOST_CHECK_EQUAL(json(std::optional<bool>(false)), "false");
  BOOST_CHECK_EQUAL(json(false), "false");
}

BOOST_AUTO_TEST_CASE(enclosures) {
  BOOST_CHECK_EQUAL(json(std::optional<GC::Enclosure>()), "null");
  BOOST_CHECK_EQUAL(json(GC::Enclosure{0.1, 1e100}), "[0.1,1e+100]");
  BOOST_CHECK_EQUAL(json(GC::Enclosure{2, infinity}), "[2,null]");
  const double nan = std::nan("");
  for (const GC::Enclosure& bad : {GC::Enclosure{0, nan}, {nan, 1}, {0, -infinity}, {-infinity, 1}, {infinity, 1}})
    check_not_finite([&](std::ostream& os) { GC::write_json(os, bad); });
}

BOOST_AUTO_TEST_CASE(joins) {
  const Curve left{Point(0, 0), Point(1, 0)}, right{Point(1, 0), Point(Q(4, 3), 0)}, gap{Point(2, 0), Point(3, 0)};
  const auto join = GC::continuity(left, right);
  const std::string all = "\"left\":7,\"right\":12345,\"c_order\":0,\"g_order\":3,\"f_order\":2,\"betas\":[\"1/3\","
                          "\"0\",\"0\"],\"regular\":true,\"tangent_equal\":true,\"curvature_equal\":true,"
                          "\"curvature_vector_equal\":true,\"torsion_equal\":null";
  BOOST_CHECK_EQUAL(json(join, 7, 12345), '{' + all + '}');
  BOOST_CHECK_EQUAL(members(join, 7, 12345), all);
  const std::string of_two = "\"left\":0,\"right\":1" + all.substr(all.find(",\"c_order\""));
  BOOST_CHECK_EQUAL(json(join), '{' + of_two + '}');
  BOOST_CHECK_EQUAL(members(join), of_two);
  BOOST_CHECK_EQUAL(members(GC::continuity(left, gap), 0, 1),
                    "\"left\":0,\"right\":1,\"c_order\":-1,\"g_order\":-1,\"f_order\":-1,\"betas\":[],\"regular\":true,"
                    "\"tangent_equal\":true,\"curvature_equal\":true,\"curvature_vector_equal\":true,"
                    "\"torsion_equal\":null");
}

BOOST_AUTO_TEST_CASE(orders_within_a_tolerance) {
  const Curve left{Point(0, 0), Point(1, 0)}, right{Point(1, 0), Point(2, 0)};
  GC::Order_within within = GC::order_within(left, right, {});
  const std::string all = "\"within\":[\"proved\",\"proved\",\"proved\",\"undecided\"],\"gap\":[0,0],"
                          "\"tangent_angle\":[0,0],\"curvature_jump\":[0,0],\"torsion_jump\":null,"
                          "\"angle_degrees\":[0,0],\"curvature_percent\":[0,0]";
  within.verdicts[3] = GC::Verdict::undecided;
  within.deviation.torsion_jump.reset();
  BOOST_CHECK_EQUAL(json(within), '{' + all + '}');
  BOOST_CHECK_EQUAL(members(within), all);
  within.deviation.curvature_jump = GC::Enclosure{0.25, 0.5};
  within.deviation.tangent_angle.reset();
  BOOST_CHECK_EQUAL(members(within.deviation),
                    "\"gap\":[0,0],\"tangent_angle\":null,\"curvature_jump\":[0.25,0.5],\"torsion_jump\":null,"
                    "\"angle_degrees\":null,\"curvature_percent\":[25,50]");
  within.deviation.curvature_jump.reset();
  BOOST_CHECK_EQUAL(members(within.deviation),
                    "\"gap\":[0,0],\"tangent_angle\":null,\"curvature_jump\":null,\"torsion_jump\":null,"
                    "\"angle_degrees\":null,\"curvature_percent\":null");
  within.deviation.torsion_jump = GC::Enclosure{0, std::nan("")};
  check_not_finite([&](std::ostream& os) { GC::write_json(os, within); });
  check_not_finite([&](std::ostream& os) { GC::write_json_members(os, within); });
}

BOOST_AUTO_TEST_CASE(streams_and_locales_do_not_matter) {
  const Curve left{Point(0, 0), Point(1, 0)}, gap{Point(2, 0), Point(3, 0)};
  const auto join = GC::continuity(left, gap);
  const std::locale old = std::locale::global(continental());
  std::ostringstream os; // has the global locale
  os << std::hex << std::showpos << std::setw(200);
  GC::write_json(os, join, 12345, 1234567);
  os << std::setw(200);
  GC::write_json(os, GC::Enclosure{1234.5, 1234567});
  std::locale::global(old);
  BOOST_CHECK_EQUAL(os.str().substr(0, 31), "{\"left\":12345,\"right\":1234567,\"");
  BOOST_CHECK_EQUAL(os.str().substr(os.str().find('}')), "}[1234.5,1234567]");
}

BOOST_AUTO_TEST_SUITE_END()
