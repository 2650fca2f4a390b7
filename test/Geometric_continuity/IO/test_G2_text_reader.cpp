// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers with their places, wherever the blocks of the text end.
#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>

#include "support/test.h"

BOOST_AUTO_TEST_SUITE(G2_text_reader)

BOOST_AUTO_TEST_CASE(places) {
  const std::string text =
      "\xEF\xBB\xBF\61"
      "00 1 0 0\n2 0\n2 2\n0 0 1 1\n0 1.50\n-3e2\t1/3\n\n100 1 0 0\n2 1\n2 2\n0 0 1 1\n7 8 1\n9 10 2";
  std::istringstream is(text);
  GC::G2_text_reader reader(is, "text");
  GC::G2_curve_text curve;
  std::string found;
  for (int i = 0; i < 2; ++i) {
    BOOST_REQUIRE(reader.next(curve));
    BOOST_TEST(curve.dimension == 2);
    BOOST_TEST(curve.points == 2);
    BOOST_TEST(curve.order == 2);
    BOOST_TEST(curve.rational == (i == 1));
    BOOST_TEST(!curve.is_line);
    for (const GC::G2_curve_text::Written_number& x : curve.coordinates) {
      const std::string word = text.substr(x.begin, x.end - x.begin);
      BOOST_TEST((x.value == GC::Decimal(word)));
      found += word + ' ';
    }
  }
  BOOST_TEST(!reader.next(curve));
  BOOST_TEST(found == "0 1.50 -3e2 1/3 7 8 1 9 10 2 ");
}

BOOST_AUTO_TEST_CASE(long_texts_and_lines) {
  std::string text = "120 1 0 0\n2\n0 0\n1 0\n1\n0 1\n";
  for (int i = 0; i < 40000; ++i)
    text += "100 1 0 0\n2 0\n2 2\n0 0 1 1\n" + std::to_string(i) +
            std::string(static_cast<std::size_t>(i % 7 + 1), ' ') + std::to_string(7 * i) + "\n1 2\n";
  std::istringstream is(text);
  GC::G2_text_reader reader(is, "text");
  GC::G2_curve_text curve;
  BOOST_REQUIRE(reader.next(curve));
  BOOST_TEST(curve.is_line);
  BOOST_TEST(curve.coordinates.empty());
  for (int i = 0; i < 40000; ++i) {
    BOOST_REQUIRE(reader.next(curve));
    const GC::G2_curve_text::Written_number &x = curve.coordinates[0], &y = curve.coordinates[1];
    BOOST_REQUIRE(text.substr(x.begin, x.end - x.begin) == std::to_string(i));
    BOOST_REQUIRE(text.substr(y.begin, y.end - y.begin) == std::to_string(7 * i));
  }
  BOOST_TEST(!reader.next(curve));
}

BOOST_AUTO_TEST_CASE(errors) {
  std::istringstream is("100 1 0 0\n2 0\n2 2\n0 0 1 1\n0 x\n1 1\n");
  GC::G2_text_reader reader(is, "text");
  GC::G2_curve_text curve;
  CHECK_ERROR(reader.next(curve), malformed_input);
}

BOOST_AUTO_TEST_SUITE_END()
