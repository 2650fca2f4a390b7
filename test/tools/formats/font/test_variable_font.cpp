// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Variable fonts that are written byte by byte: what is read is what was written, exactly; and what is malformed is refused.

#define BOOST_TEST_MODULE variable_font
#define BOOST_TEST_DYN_LINK
#include <boost/test/unit_test.hpp>

#include "support/errors.h"
#include "tools/formats/font/variable_fonts.h"

#include "formats/font/Variable_font.h"

#include <cstddef>
#include <iostream>
#include <list>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Q;
typedef Font_writer::Tuple Tuple;
typedef Font_writer::Glyph Glyph;

namespace {

constexpr unsigned seed = 20261122;
constexpr int one = 0x4000; // 1 in normalised values

// A font whose bytes are kept.
GC::Variable_font open(std::string bytes) {
  static std::list<std::string> kept;
  kept.push_back(std::move(bytes));
  return GC::Variable_font(GC::Font_tables(kept.back()));
}

// Reads everything in a font.
void read_all(const std::string& bytes) {
  for (std::size_t face = 0; face < GC::Font_tables::face_count(bytes); ++face) {
    const GC::Variable_font font(GC::Font_tables(bytes, face));
    for (int i = 0; i < font.glyph_count(); ++i) {
      const GC::Variable_outline glyph = font.glyph(i);
      for (std::size_t p = 0; p < glyph.outline.points.size(); ++p)
        glyph.point(p, std::vector<Q>(font.axes().size(), Q(1) / 3));
    }
  }
}

std::string outline_error(const std::string& bytes) {
  return error_of([&] { read_all(bytes); });
}

bool is(const GC::Outline_vector& p, const Q& x, const Q& y) { return p[0] == x && p[1] == y; }

// A contour of four points, and its glyph with one tuple along one axis.
Font_writer one_axis(std::vector<Tuple> tuples) {
  Font_writer w;
  w.axes = {{"wght", 100, 400, 900}};
  w.glyphs = {Glyph{{{{0, 0}, {3, 5}, {10, 5}, {4, -2}}}, std::move(tuples)}};
  return w;
}

// Everything that the writer can write, in small.
Font_writer rich_font() {
  Font_writer w = one_axis({Tuple{{one, 0}, {1, 2, 3, 300, 0, 0, 0, 0}, {4, 0, 0, 7, 0, 0, 0, 0}}});
  w.axes = {{"wght", 100, 400, 900, {{-one, -one}, {0, 0}, {one / 2, one / 4}, {one, one}}}, {"wdth", 50, 100, 100}};
  w.shared_peaks = {{one, 0}, {0, -one}};
  Tuple shared{{}, {5, -5}, {1, 2}}, middle{{one / 2, -one}, {9}, {-300}, {{1}}, {one / 4, -one}, {one, 0}};
  shared.shared = 1;
  shared.uses_shared_points = true;
  w.glyphs.push_back({{{{0, 0}, {0, 50, false}, {50, 50}}, {{7, 7}, {8, 9}}}, {shared, middle}, {0, 3}});
  w.glyphs.push_back({});
  return w;
}

} // namespace

BOOST_AUTO_TEST_CASE(axes_and_their_user_values) {
  Font_writer w = rich_font();
  const std::string bytes = w.font(), collection = w.collection();
  for (const std::string& s : {bytes, collection}) {
    BOOST_CHECK_EQUAL(GC::Font_tables::face_count(s), 1u);
    const GC::Variable_font font = open(s);
    BOOST_REQUIRE_EQUAL(font.axes().size(), 2u);
    BOOST_CHECK_EQUAL(font.glyph_count(), 3);
    BOOST_CHECK_EQUAL(font.units_per_em(), 1000);
    const GC::Variation_axis &weight = font.axes()[0], &width = font.axes()[1];
    BOOST_CHECK(weight.tag == "wght" && weight.minimum == 100 && weight.initial == 400 && weight.maximum == 900);
    BOOST_CHECK(weight.lowest() == -1 && weight.highest() == 1 && width.lowest() == -1 && width.highest() == 0);
    BOOST_CHECK(weight.user_value(-1) == 100 && weight.user_value(0) == 400 && weight.user_value(1) == 900);
    BOOST_CHECK(weight.user_value(Q(1) / 4) == 650 && weight.user_value(Q(1) / 8) == 525); // by 'avar'
    BOOST_CHECK(weight.user_value(Q(5) / 8) == 775 && weight.user_value(Q(-1) / 3) == 300);
    BOOST_CHECK(width.user_value(Q(-1) / 2) == 75);
  }
  CHECK_ERROR(GC::Font_tables(bytes, 1), parameter_outside_domain);
  CHECK_ERROR(GC::Font_tables(collection, 1), parameter_outside_domain);
  CHECK_ERROR(open(bytes).glyph(3), parameter_outside_domain);
  w.axes[0].map = {{-one, -one}, {one, one}}; // without 0 it has no effect
  BOOST_CHECK(open(w.font()).axes()[0].user_value(Q(1) / 4) == 525);
}

BOOST_AUTO_TEST_CASE(outlines) {
  Font_writer w = one_axis({});
  // flags: on, repeated twice more; short x and y, positive and negative; the same x, the same y
  Glyph packed;
  packed.bytes = std::string("\0\1", 2) + std::string(8, '\0') + std::string("\0\5\0\0", 4) + "\x01";
  packed.bytes.back() = 1 + 8;
  packed.bytes += '\2';
  packed.bytes += std::string("\x36\x06\x30", 3); // short and positive; short and negative, off; both the same, off
  const std::vector<int> words{100, -50, 7, 200, 1000, -7};
  std::string x, y;
  for (std::size_t i = 0; i < 3; ++i) {
    Font_writer::put16(x, words[i]);
    Font_writer::put16(y, words[i + 3]);
  }
  packed.bytes += x + "\x05\x06" + y + std::string("\x07\xff", 2);
  w.glyphs.push_back(packed);
  const std::string bytes = w.font();
  const GC::True_type_outlines outlines{GC::Font_tables(bytes)};
  const std::vector<GC::Outline_point> expected{{100, 200, true},  {50, 1200, true}, {57, 1193, true},
                                                {62, 1200, false}, {56, 945, false}, {56, 945, false}};
  const GC::True_type_outline glyph = outlines.glyph(1);
  BOOST_CHECK(glyph.points == expected);
  BOOST_CHECK(glyph.contour_ends == std::vector<int>{6});
  // two components: with words and a matrix, and with bytes
  Glyph composite;
  Font_writer::put16(composite.bytes, -1);
  composite.bytes.append(8, '\0');
  Font_writer::put16(composite.bytes, {1 + 0x20 + 0x80, 0, 300, 0, 0x4000, 0, 0, 0x4000, 0, 0, 0x0102});
  w.glyphs = {one_axis({}).glyphs[0], composite, {}};
  for (bool long_places : {true, false}) {
    w.long_places = long_places;
    const GC::Variable_font font = open(w.font());
    BOOST_CHECK_EQUAL(font.glyph(1).outline.components, 2);
    BOOST_CHECK(font.glyph(1).outline.points.empty());
    BOOST_CHECK(font.glyph(2).outline.points.empty() && font.glyph(2).outline.components == 0);
    BOOST_CHECK_EQUAL(font.glyph(0).outline.points.size(), 4u);
  }
}

BOOST_AUTO_TEST_CASE(untouched_points_move_by_exact_fractions) {
  // points 0 and 2 are touched: 1 lies between them in x, at 5 as point 2 in y; 3 between them in x and below both in y
  const Tuple tuple{{one}, {7, 0}, {-2, 30}, {{0, 2}}};
  GC::Variable_outline glyph = open(one_axis({tuple}).font()).glyph(0);
  BOOST_REQUIRE_EQUAL(glyph.shifts.size(), 1u);
  BOOST_CHECK(is(glyph.shifts[0][0], 7, -2) && is(glyph.shifts[0][2], 0, 30));
  BOOST_CHECK(is(glyph.shifts[0][1], Q(7) - Q(21) / 10, 30));
  BOOST_CHECK(is(glyph.shifts[0][3], Q(7) - Q(28) / 10, -2));
  BOOST_CHECK(is(glyph.point(1, {Q(1) / 3}), Q(3) + Q(49) / 30, 15));
  BOOST_CHECK(is(glyph.point(1, {-1}), 3, 5));
  // one touched point moves all; another contour does not move, and neither do the points behind the outline
  Font_writer w = one_axis({{{one}, {7, 9}, {-2, 9}, {{1, 6}}}});
  w.glyphs[0].contours.push_back({{100, 0}, {200, 0}});
  glyph = open(w.font()).glyph(0);
  for (std::size_t i = 0; i < 6; ++i) BOOST_CHECK(i < 4 ? is(glyph.shifts[0][i], 7, -2) : is(glyph.shifts[0][i], 0, 0));
  // touched points at one place: no movement unless they move alike
  w = one_axis({{{one}, {7, 8}, {3, 3}, {{0, 2}}}});
  w.glyphs[0].contours[0] = {{5, 5}, {6, 9}, {5, 5}, {4, 1}};
  glyph = open(w.font()).glyph(0);
  for (std::size_t i : {1, 3}) BOOST_CHECK(is(glyph.shifts[0][i], 0, 3));
}

BOOST_AUTO_TEST_CASE(regions) {
  const GC::Variable_font font = open(rich_font().font());
  const GC::Variable_outline first = font.glyph(0), second = font.glyph(1);
  BOOST_CHECK(is(first.shifts[0][3], 300, 7));
  BOOST_CHECK(is(first.point(3, {Q(1) / 2, -1}), 154, Q(3) / 2));
  BOOST_REQUIRE_EQUAL(second.regions.size(), 2u);
  BOOST_CHECK(is(second.shifts[0][0], 5, 1) && is(second.shifts[0][2], 5, 1)); // the points 0 and 3, of two contours
  BOOST_CHECK(is(second.shifts[0][3], -5, 2) && is(second.shifts[0][4], -5, 2));
  const GC::Variation_region &shared = second.regions[0], &middle = second.regions[1];
  BOOST_CHECK(shared.scalar({Q(1), Q(-1) / 4}) == Q(1) / 4 && shared.scalar({Q(0), Q(0)}) == 0);
  BOOST_CHECK(middle.scalar({Q(1) / 2, -1}) == 1 && middle.scalar({Q(1) / 4, -1}) == 0);
  BOOST_CHECK(middle.scalar({Q(3) / 8, -1}) == Q(1) / 2 && middle.scalar({Q(5) / 8, Q(-1) / 3}) == Q(1) / 4);
  BOOST_CHECK(middle.scalar({Q(1), -1}) == 0 && middle.scalar({Q(1) / 2, 0}) == 0);
  // axes that do not count: no peak, not in order, of two signs
  for (const GC::Region_axis& axis : {GC::Region_axis{-one, 0, one}, {one, one / 2, one}, {-one, one / 2, one}}) {
    BOOST_CHECK(!axis.counts());
    BOOST_CHECK(GC::Variation_region({axis}).scalar({Q(-1) / 5}) == 1);
  }
}

BOOST_AUTO_TEST_CASE(many_points) { // numbers of two bytes, and runs
  std::vector<Font_writer::Point> contour;
  std::vector<int> points, dx, dy;
  for (int i = 0; i < 1000; ++i) {
    contour.push_back({i, i % 7});
    if (i % 5 == 0 || i > 700) {
      points.push_back(i);
      dx.push_back(i % 3 == 0 ? 0 : i);
      dy.push_back(-i);
    }
  }
  Font_writer w = one_axis({Tuple{{one}, dx, dy, points}, Tuple{{-one}, {12}, {13}, {{999}}}});
  w.glyphs[0].contours = {contour};
  const GC::Variable_outline glyph = open(w.font()).glyph(0);
  for (std::size_t i = 0; i < points.size(); ++i)
    BOOST_CHECK(is(glyph.shifts[0][static_cast<std::size_t>(points[i])], dx[i], dy[i]));
  BOOST_CHECK(is(glyph.shifts[1][17], 12, 13));
}

BOOST_AUTO_TEST_CASE(what_is_malformed_is_named) {
  const auto says = [](const std::string& error, const std::string& expected) {
    BOOST_CHECK_MESSAGE(error.find(expected) != std::string::npos, error + " does not say: " + expected);
  };
  says(outline_error("a text"), "malformed_input: font: ");
  says(outline_error(""), "malformed_input: font: it ends at byte 0");
  Font_writer w = one_axis({Tuple{{one}, {1}, {1}, {{9}}}});
  says(outline_error(w.font()), "table 'gvar', glyph 0: there is no point 9");
  w = one_axis({Tuple{{one}, {1, 1}, {1, 1}, {{2, 2}}}});
  says(outline_error(w.font()), "table 'gvar', glyph 0: the numbers of points do not ascend");
  w = one_axis({Tuple{{one}, {1}, {}, {{2}}}});
  says(outline_error(w.font()), "table 'gvar', glyph 0: it ends at byte");
  w = one_axis({Tuple{{one}, {1}, {1, 2}, {{2}}}});
  says(outline_error(w.font()), "table 'gvar', glyph 0: a run of movements is too long");
  w = one_axis({Tuple{{}, {1}, {1}, {{2}}}});
  w.glyphs[0].tuples[0].shared = 3;
  says(outline_error(w.font()), "table 'gvar', glyph 0: there is no shared tuple 3");
  w = one_axis({});
  w.axes[0].initial = 50;
  says(outline_error(w.font()), "table 'fvar': the default of axis 0");
  w.axes[0] = {"wght", 0, 0, 1, {{0, 0}, {0, 1}}};
  says(outline_error(w.font()), "table 'avar': a map does not ascend");
  w = one_axis({});
  w.glyphs[0].contours[0][2].x = 30000;
  w.glyphs[0].contours[0][3].x = 40000;
  says(outline_error(w.font()), "table 'glyf', glyph 0: point 3 has more than 16 bits");
  w.glyphs[0].contours.push_back({});
  says(outline_error(w.font()), "table 'glyf', glyph 0: contour 1 ends before it begins");
  w.glyphs = {one_axis({}).glyphs[0]};
  w.units_per_em = 0;
  says(outline_error(w.font()), "table 'head'");
  std::string renamed = one_axis({}).font();
  renamed.replace(renamed.find("gvar"), 4, "gvax");
  says(outline_error(renamed), "the table 'gvar' is missing");
  BOOST_CHECK(!GC::Variable_font::is_variable(GC::Font_tables(renamed)));
}

BOOST_AUTO_TEST_CASE(few_bytes_do_not_fill_the_memory) {
  // 65 535 points and 4 000 regions that move all of them, by a few thousand bytes
  Font_writer w = one_axis({});
  std::string& glyph = w.glyphs[0].bytes;
  Font_writer::put16(glyph, 1);
  glyph.append(8, '\0');
  Font_writer::put16(glyph, {0xfffe, 0});
  for (int i = 0; i < 256; ++i) {
    glyph += '\x39';
    glyph += i < 255 ? '\xff' : '\xfe';
  }
  w.glyphs[0].tuples.assign(4000, Tuple{{one}, {}, {}});
  BOOST_CHECK(outline_error(w.font()).find("work_limit: table 'gvar', glyph 0: more than") == 0);
}

BOOST_AUTO_TEST_CASE(damaged_fonts) {
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  const std::string whole = rich_font().font();
  BOOST_CHECK_EQUAL(outline_error(whole), "no error");
  std::size_t refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) // a string of its own, so that reading behind it shows
    refused += outline_error(std::string(whole.data(), size)) != "no error";
  BOOST_CHECK_EQUAL(refused, whole.size()); // the last table is read to its last byte
  for (int i = 0; i < 3000; ++i) {
    std::string s = i % 2 == 0 ? whole : rich_font().collection();
    for (unsigned n = engine() % 3 + 1; n > 0; --n) s[engine() % s.size()] = static_cast<char>(engine());
    refused += outline_error(s) != "no error";
  }
  BOOST_CHECK_GT(refused, whole.size() + 1000);
}
