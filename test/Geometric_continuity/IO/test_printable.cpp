// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/text.h>

BOOST_AUTO_TEST_SUITE(printable)

BOOST_AUTO_TEST_CASE(what_can_be_shown_stays) {
  for (const char* text : {"", "a\\n \"b\" ~", "caf\xc3\xa9", "\xe2\x82\xac\xf0\x9f\x98\x80", "\xc2\xa0\xe2\x80\x8b"})
    BOOST_CHECK_EQUAL(GC::printable(text), text);
}

BOOST_AUTO_TEST_CASE(controls_are_escaped) {
  BOOST_CHECK_EQUAL(GC::printable("a\nb\r\tc"), "a\\nb\\r\\tc");
  BOOST_CHECK_EQUAL(GC::printable(std::string_view("\0\x1b[2J\x7f", 6)), "\\x00\\x1b[2J\\x7f");
  // which some terminals obey
  BOOST_CHECK_EQUAL(GC::printable("\xc2\x80\xc2\x9b\xc2\x9f"), "\\u0080\\u009b\\u009f");
  BOOST_CHECK_EQUAL(GC::printable("\xe2\x80\xa8\xe2\x80\xa9"), "\\u2028\\u2029");
  BOOST_CHECK_EQUAL(GC::printable("\xe2\x80\xaa\xe2\x80\xae"), "\\u202a\\u202e");
  BOOST_CHECK_EQUAL(GC::printable("\xe2\x81\xa6\xe2\x81\xa9"), "\\u2066\\u2069");
  BOOST_CHECK_EQUAL(GC::printable("\xe2\x80\x8e\xe2\x80\x8f\xd8\x9c"), "\\u200e\\u200f\\u061c");
}

BOOST_AUTO_TEST_CASE(bytes_that_are_no_characters_are_escaped) {
  BOOST_CHECK_EQUAL(GC::printable("a\xff\x80z\xe2\x82"), "a\\xff\\x80z\\xe2\\x82");
  BOOST_CHECK_EQUAL(GC::printable("\xc0\x8a\xed\xa0\x80"), "\\xc0\\x8a\\xed\\xa0\\x80");
}

BOOST_AUTO_TEST_CASE(random_bytes) {
  std::cout << "seed 2028\n";
  std::mt19937 random(2028);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (std::size_t n = random() % 12; n > 0; --n)
      text += static_cast<char>(random() % 2 == 0 ? random() % 256 : 0xE0 + random() % 16);
    const std::string shown = GC::printable(text);
    for (char c : shown) BOOST_CHECK(static_cast<unsigned char>(c) >= ' ' && c != '\x7f');
    BOOST_CHECK_EQUAL(GC::printable(shown), shown);
    BOOST_CHECK((shown == text) == (shown.size() == text.size()));
  }
}

BOOST_AUTO_TEST_SUITE_END()
