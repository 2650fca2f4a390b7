// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Variable fonts that are written byte by byte: what is read is what was written, exactly; and what
// is malformed is refused.

#define BOOST_TEST_MODULE variable_font
#include "support/test.h"

#include "tools/formats/font/variable_fonts.h"

#include "formats/font/Variable_font.h"
#include "formats/font/glyph_parts.h"

#include <list>

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
      for (std::size_t p = 0; p < glyph.points.size(); ++p)
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
    BOOST_CHECK(weight.range().lowest == -1 && weight.range().highest == 1 && width.range().lowest == -1 &&
                width.range().highest == 0);
    BOOST_CHECK(weight.user_value(-1) == 100 && weight.user_value(0) == 400 && weight.user_value(1) == 900);
    // by 'avar'
    BOOST_CHECK(weight.user_value(Q(1) / 4) == 650 && weight.user_value(Q(1) / 8) == 525);
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
  // short and positive; short and negative, off; both the same, off
  packed.bytes += std::string("\x36\x06\x30", 3);
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
    BOOST_CHECK_EQUAL(font.glyph(1).components.size(), 2u);
    BOOST_CHECK(font.glyph(1).points.empty());
    BOOST_CHECK(font.glyph(2).points.empty() && font.glyph(2).components.empty());
    BOOST_CHECK_EQUAL(font.glyph(0).points.size(), 4u);
  }
}

BOOST_AUTO_TEST_CASE(untouched_points_move_by_exact_fractions) {
  // points 0 and 2 are touched: 1 lies between them in x, at 5 as point 2 in y; 3 between them in x
  // and below both in y
  const Tuple tuple{{one}, {7, 0}, {-2, 30}, {{0, 2}}};
  GC::Variable_outline glyph = open(one_axis({tuple}).font()).glyph(0);
  BOOST_REQUIRE_EQUAL(glyph.shifts.size(), 1u);
  BOOST_CHECK(is(glyph.shifts[0][0], 7, -2) && is(glyph.shifts[0][2], 0, 30));
  BOOST_CHECK(is(glyph.shifts[0][1], Q(7) - Q(21) / 10, 30));
  BOOST_CHECK(is(glyph.shifts[0][3], Q(7) - Q(28) / 10, -2));
  BOOST_CHECK(is(glyph.point(1, {Q(1) / 3}), Q(3) + Q(49) / 30, 15));
  BOOST_CHECK(is(glyph.point(1, {-1}), 3, 5));
  // one touched point moves all; another contour does not move, and neither do the points behind
  // the outline
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
  // the points 0 and 3, of two contours
  BOOST_CHECK(is(second.shifts[0][0], 5, 1) && is(second.shifts[0][2], 5, 1));
  BOOST_CHECK(is(second.shifts[0][3], -5, 2) && is(second.shifts[0][4], -5, 2));
  const GC::Variation_region &shared = second.regions[0], &middle = second.regions[1];
  BOOST_CHECK(shared.scalar({Q(1), Q(-1) / 4}) == Q(1) / 4 && shared.scalar({Q(0), Q(0)}) == 0);
  BOOST_CHECK(middle.scalar({Q(1) / 2, -1}) == 1 && middle.scalar({Q(1) / 4, -1}) == 0);
  BOOST_CHECK(middle.scalar({Q(3) / 8, -1}) == Q(1) / 2 && middle.scalar({Q(5) / 8, Q(-1) / 3}) == Q(1) / 4);
  BOOST_CHECK(middle.scalar({Q(1), -1}) == 0 && middle.scalar({Q(1) / 2, 0}) == 0);
  // axes that do not count: no peak, not in order, of two signs
  for (const GC::Region_axis& axis : {GC::Region_axis{-1, 0, 1}, {1, 0.5, 1}, {-1, 0.5, 1}}) {
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

BOOST_AUTO_TEST_CASE(joins_of_a_font) {
  // 0 on, 1 control, 2 on with a kink between the masters, 3 control, 4 on; 5 and 6 coincide with 4
  // and 0
  Font_writer w;
  w.axes = {{"wght", 100, 100, 900}};
  Font_writer::Glyph glyph{{{{0, -50}, {0, 0, false}, {100, 0}, {200, 0, false}, {200, -50}, {200, -50, false}}}};
  Font_writer::Tuple tuple{{one}, {0, 0, 0, 200, 0, 0, 0, 0, 0, 0}, {0, -20, 0, 60, 0, 0, 0, 0, 0, 0}};
  glyph.tuples = {tuple};
  w.glyphs = {glyph};
  const std::string bytes = w.font();
  const GC::Variable_font font{GC::Font_tables(bytes)};
  const GC::Variable_outline outline = font.glyph(0);
  const std::vector<GC::Outline_join> joins = GC::outline_joins(outline);
  BOOST_REQUIRE_EQUAL(joins.size(), 3u); // at 0, 2 and 5, which is 4
  BOOST_CHECK(joins[0].point == 0 && joins[1].point == 2 && joins[2].point == 5);
  const std::vector<Q> initial{Q(0)};
  BOOST_CHECK(*GC::is_corner(joins[0].join, initial, GC::Corner_threshold()));
  BOOST_CHECK(!*GC::is_corner(joins[1].join, initial, GC::Corner_threshold()));
  for (int i = 0; i <= 4; ++i) { // the legs (100, 20 t) and (100 + 200 t, 60 t)
    const Q t = Q(i) / 4;
    const std::pair<Q, Q> expected{Q(100 * 60 * t - 20 * t * (100 + 200 * t)), Q(100 * (100 + 200 * t) + 1200 * t * t)};
    BOOST_CHECK(joins[1].join.products(GC::region_scalars(outline.regions, {t})) == expected);
  }
  // two control points that coincide across the end of the contour are a point on the curve
  w.glyphs[0] = {{{{0, 0, false}, {100, 0}, {100, 100}, {0, 0, false}}}};
  const std::string round = w.font();
  const GC::Variable_outline closed = GC::Variable_font(GC::Font_tables(round)).glyph(0);
  BOOST_REQUIRE_EQUAL(GC::outline_joins(closed).size(), 3u);
  BOOST_CHECK(*GC::is_corner(GC::outline_joins(closed)[0].join, {}, GC::Corner_threshold()));
  // of one cubic curve they are not: there is no point on the curve between them
  GC::Variable_outline cubic{true, {{0, 0, true}, {50, 50, false}, {50, 50, false}, {100, 0, true}}, {4}};
  BOOST_REQUIRE_EQUAL(GC::outline_joins(cubic).size(), 2u);
  BOOST_CHECK(GC::outline_joins(cubic)[1].point == 3);
  cubic.points[1] = {0, 0, false}; // a retracted handle is at the node
  BOOST_REQUIRE_EQUAL(GC::outline_joins(cubic).size(), 2u);
  BOOST_CHECK(GC::outline_joins(cubic)[0].join.outgoing.constant == (GC::Outline_vector{50, 50}));
  // a leg without length at one instance only
  GC::Variable_join join = joins[1].join;
  join.incoming.constant = {0, 0};
  BOOST_CHECK(!GC::is_corner(join, initial, GC::Corner_threshold()));
  BOOST_CHECK(GC::is_corner(join, {Q(1)}, GC::Corner_threshold()).has_value());
}

namespace {

// Operators of charstrings.
enum { hstem = 1001, vmove = 1004, line = 1005, hline = 1006, vline = 1007, curve = 1008, subroutine = 1010 };
enum { set = 1015, blend = 1016, hintmask = 1019, move = 1021, hmove = 1022, curve_line = 1024, line_curve = 1025 };
enum { vvcurve = 1026, hhcurve = 1027, global = 1029, vhcurve = 1030, hvcurve = 1031 };
enum { hflex = 1000 + 0x0c22, flex = 1000 + 0x0c23, hflex1 = 1000 + 0x0c24, flex1 = 1000 + 0x0c25 };

Font_writer cubic_font(const std::vector<std::vector<int>>& glyphs) {
  Font_writer w;
  w.axes = {{"wght", 100, 100, 900}, {"opsz", 8, 12, 72}};
  w.region_peaks = {{one, 0}, {one / 2, -one}};
  for (const std::vector<int>& glyph : glyphs) w.charstrings.push_back(Font_writer::charstring(glyph));
  return w;
}

} // namespace

BOOST_AUTO_TEST_CASE(operators_of_cubic_outlines) {
  typedef std::vector<std::pair<int, int>> Points; // of control points with 1000 taken from y
  const auto off = [](int x, int y) { return std::make_pair(x, y - 1000); };
  const std::vector<std::pair<std::vector<int>, Points>> cases{
      {{}, {}},
      {{10, 20, move, 1, 2, 3, 4, line}, {{10, 20}, {11, 22}, {14, 26}}},
      {{5, hmove, 1, 2, 3, hline}, {{5, 0}, {6, 0}, {6, 2}, {9, 2}}},
      {{5, vmove, 1, 2, 3, vline}, {{0, 5}, {0, 6}, {2, 6}, {2, 9}}},
      {{0, hmove, 1, 2, 3, 4, 5, 6, curve}, {{0, 0}, off(1, 2), off(4, 6), {9, 12}}},
      {{0, hmove, 1, 2, 3, 4, 5, 6, 7, 8, curve_line}, {{0, 0}, off(1, 2), off(4, 6), {9, 12}, {16, 20}}},
      {{0, hmove, 7, 8, 1, 2, 3, 4, 5, 6, line_curve}, {{0, 0}, {7, 8}, off(8, 10), off(11, 14), {16, 20}}},
      {{0, hmove, 9, 1, 2, 3, 4, vvcurve}, {{0, 0}, off(9, 1), off(11, 4), {11, 8}}},
      {{0, hmove, 9, 1, 2, 3, 4, 1, 2, 3, 4, hhcurve},
       {{0, 0}, off(1, 9), off(3, 12), {7, 12}, off(8, 12), off(10, 15), {14, 15}}},
      {{0, hmove, 1, 2, 3, 4, 9, hvcurve}, {{0, 0}, off(1, 0), off(3, 3), {12, 7}}},
      {{0, hmove, 1, 2, 3, 4, 1, 2, 3, 4, 9, vhcurve},
       {{0, 0}, off(0, 1), off(2, 4), {6, 4}, off(7, 4), off(9, 7), {18, 11}}},
      {{0, hmove, 1, 2, 3, 4, 5, 6, 7, hflex}, {{0, 0}, off(1, 0), off(3, 3), {7, 3}, off(12, 3), off(18, 0), {25, 0}}},
      {{0, hmove, 1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 50, flex},
       {{0, 0}, off(1, 2), off(4, 6), {9, 12}, off(10, 14), off(13, 18), {18, 24}}},
      {{0, hmove, 1, 2, 3, 4, 5, 6, 7, 8, 9, hflex1},
       {{0, 0}, off(1, 2), off(4, 6), {9, 6}, off(15, 6), off(22, 14), {31, 0}}},
      {{0, hmove, 1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 9, flex1},
       {{0, 0}, off(1, 2), off(4, 6), {9, 12}, off(10, 14), off(13, 18), {0, 27}}},
      {{0, hmove, 9, 2, 9, 4, 9, 6, 1, 2, 3, 4, 9, flex1},
       {{0, 0}, off(9, 2), off(18, 6), {27, 12}, off(28, 14), off(31, 18), {40, 0}}},
      // hints, and subroutines that call each other
      {{1, 2, 3, 4, hstem, 5, 6, hintmask, 1000 + 0xe0, 7, hmove, -107, subroutine}, {{7, 0}, {8, 2}, {8, 5}}},
      {{7, hmove, -106, global}, {{7, 0}, {8, 2}, {8, 5}}},
  };
  std::vector<std::vector<int>> glyphs;
  for (const auto& c : cases) glyphs.push_back(c.first);
  Font_writer w = cubic_font(glyphs);
  w.local_subroutines = {Font_writer::charstring({1, 2, line, -107, global})};
  w.global_subroutines = {Font_writer::charstring({3, vline}), Font_writer::charstring({-107, subroutine})};
  const std::string bytes = w.font();
  const GC::Variable_font font = open(bytes);
  BOOST_CHECK_EQUAL(font.units_per_em(), 1000);
  BOOST_REQUIRE_EQUAL(font.glyph_count(), static_cast<int>(cases.size()));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const GC::Variable_outline glyph = font.glyph(static_cast<int>(i));
    const Points& expected = cases[i].second;
    BOOST_CHECK(glyph.cubic);
    BOOST_REQUIRE_EQUAL(glyph.points.size(), expected.size());
    BOOST_CHECK(glyph.contour_ends == (expected.empty() ? std::vector<int>{} : std::vector<int>{int(expected.size())}));
    for (std::size_t p = 0; p < expected.size(); ++p) {
      const bool on_curve = expected[p].second > -500;
      BOOST_CHECK_EQUAL(glyph.points[p].x, expected[p].first);
      BOOST_CHECK_EQUAL(glyph.points[p].y, expected[p].second + (on_curve ? 0 : 1000));
      BOOST_CHECK_EQUAL(glyph.points[p].on_curve, on_curve);
    }
  }
  CHECK_ERROR(font.glyph(static_cast<int>(cases.size())), parameter_outside_domain);
}

BOOST_AUTO_TEST_CASE(cubic_outlines_vary) {
  // the first point by (20, -6) in the first region and (0, 5) in the second; the second point by
  // what is added to that
  Font_writer w = cubic_font({{10, 0, 20, 0, -6, 5, 2, blend, move, 30, 4, 8, 1, blend, 40, line},
                              {0, set, 1, 0, 0, 1, blend, hmove, 0, set}});
  w.charstrings[0] += std::string("\xff\0\1\x80\0", 5) + Font_writer::charstring({hline}); // 1.5
  const GC::Variable_font font = open(w.font());
  const GC::Variable_outline glyph = font.glyph(0);
  BOOST_REQUIRE_EQUAL(glyph.points.size(), 3u);
  const auto at = [&](std::size_t i, const Q& weight, const Q& size) { return glyph.point(i, {weight, size}); };
  BOOST_CHECK(is(at(0, 0, 0), 10, 0) && is(at(1, 0, 0), 40, 40) && is(at(2, 0, 0), Q(83) / 2, 40));
  BOOST_CHECK(is(at(0, 1, 0), 30, -6) && is(at(1, 1, 0), 64, 34));
  BOOST_CHECK(is(at(0, Q(1) / 2, -1), 20, 2) && is(at(1, Q(1) / 2, -1), 60, 42));
  BOOST_CHECK(is(at(2, Q(1) / 4, Q(-1) / 2), Q(83) / 2 + 6 + 2, Q(40) - Q(3) / 2 + Q(5) / 4));
  CHECK_ERROR(font.glyph(1), malformed_input); // other regions after a blend
}

BOOST_AUTO_TEST_CASE(cubic_outlines_that_are_malformed) {
  const auto says = [](const std::vector<int>& glyph, const std::string& expected) {
    Font_writer w = cubic_font({glyph});
    w.local_subroutines = {Font_writer::charstring({-107, subroutine})};
    const std::string error = outline_error(w.font());
    BOOST_CHECK_MESSAGE(error.find("table 'CFF2', glyph 0: charstring: " + expected) != std::string::npos,
                        error + " does not say: " + expected);
  };
  says({1, move}, "operands are missing");
  says({0, hmove, 1, 2, 3, line}, "operands are missing");
  says({1, 2, 3, 4, blend}, "operands of a blend are missing");
  says({1, 2, 3, 1, blend, 4, 5, 1, blend}, "a blend of blends");
  says({7, set}, "there is no set 7");
  says({5, subroutine}, "there is no such subroutine");
  says({-107, subroutine}, "subroutines call each other more than 10 times");
  BOOST_CHECK(outline_error(cubic_font({{1014}}).font()).find("not covered: the operator 14 of its charstring") !=
              std::string::npos);
  says(std::vector<int>(514, 1), "more than 513 operands");
  says({0, hmove, 1, 2, 3, 4, 5, 6, 1, 2, 3, 7, 0, 0, 1, blend, 9, flex1}, "a number that varies, where it must not");
  // ten subroutines that call the next one a hundred times
  Font_writer w = cubic_font({{-107, subroutine}});
  for (int i = 0; i < 9; ++i) {
    std::string calls;
    for (int n = 0; n < 100; ++n) calls += Font_writer::charstring({i - 106, subroutine});
    w.local_subroutines.push_back(calls);
  }
  w.local_subroutines.push_back("");
  BOOST_CHECK(outline_error(w.font()).find("malformed_input: table 'CFF2', glyph 0: charstring: more operators than") ==
              0);
}

BOOST_AUTO_TEST_CASE(parts_of_composite_glyphs) {
  // glyph 2 is glyph 1 turned by a quarter; that is glyph 0 twice, once stretched
  const auto composite = [](const std::vector<int>& words) {
    Glyph glyph;
    Font_writer::put16(glyph.bytes, -1);
    glyph.bytes.append(8, '\0');
    Font_writer::put16(glyph.bytes, words);
    return glyph;
  };
  Font_writer w = one_axis({Tuple{{one}, {8}, {6}, {{2}}}});
  w.glyphs.push_back(composite({1 + 0x20, 0, 300, 0, 1 + 0x40, 0, 0, 0, one / 2, one}));
  w.glyphs.push_back(composite({1 + 0x80, 1, 0, 0, 0, one, -one, 0}));
  GC::Variable_font font = open(w.font());
  std::vector<Glyph_part> parts = GC::glyph_parts(font, font.components(2));
  BOOST_REQUIRE_EQUAL(parts.size(), 2u);
  int stretched = 0;
  for (const Glyph_part& part : parts) {
    BOOST_CHECK_EQUAL(part.glyph, 0);
    const GC::Variable_join join{{{3, 5}, {{8, 6}}}, {{7, -2}, {{1, 0}}}}, moved = GC::join_of_part(part, join);
    if (GC::is_stretched(part)) ++stretched;
    // (x, y) becomes (-y, x / 2) or (-y, x)
    const Q half = GC::is_stretched(part) ? Q(1) / 2 : Q(1);
    BOOST_CHECK(is(moved.incoming.constant, -5, 3 * half) && is(moved.incoming.shifts[0], -6, 8 * half));
    BOOST_CHECK(is(moved.outgoing.constant, 2, 7 * half) && is(moved.outgoing.shifts[0], 0, half));
  }
  BOOST_CHECK_EQUAL(stretched, 1);
  w.glyphs[1] = composite({1, 2, 0, 0}); // glyphs that consist of each other
  font = open(w.font());
  CHECK_ERROR(GC::glyph_parts(font, font.components(1)), work_limit);
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
  std::mt19937 engine = seeded(seed);
  const std::string whole = rich_font().font();
  BOOST_CHECK_EQUAL(outline_error(whole), "no error");
  std::size_t refused = 0;
  // a string of its own, so that reading behind it shows
  for (std::size_t size = 0; size < whole.size(); ++size)
    refused += outline_error(std::string(whole.data(), size)) != "no error";
  BOOST_CHECK_EQUAL(refused, whole.size()); // the last table is read to its last byte
  for (int i = 0; i < 3000; ++i) {
    std::string s = i % 2 == 0 ? whole : rich_font().collection();
    for (unsigned n = engine() % 3 + 1; n > 0; --n) s[engine() % s.size()] = static_cast<char>(engine());
    refused += outline_error(s) != "no error";
  }
  BOOST_CHECK_GT(refused, whole.size() + 1000);
  const std::string cubic = cubic_font({{10, 0, 20, 0, -6, 5, 2, blend, move, 30, 4, 8, 1, blend, 40, line}}).font();
  BOOST_CHECK_EQUAL(outline_error(cubic), "no error");
  for (std::size_t size = 0; size < cubic.size(); ++size) outline_error(std::string(cubic.data(), size));
  for (int i = 0; i < 3000; ++i) {
    std::string s = cubic;
    for (unsigned n = engine() % 3 + 1; n > 0; --n) s[engine() % s.size()] = static_cast<char>(engine());
    outline_error(s);
  }
}
