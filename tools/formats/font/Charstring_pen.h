// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CHARSTRING_PEN_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CHARSTRING_PEN_H

#include "formats/font/Font_error.h"
#include "formats/font/Glyph_outline.h"

#include <cstddef>
#include <cstdint>

// A letter and its accent, as charstrings may draw them: codes of Adobe's standard encoding, and
// where the accent is.
struct Accented_letter {
  std::int64_t letter, accent;
  Glyph_point at; // in 2^-16 units
};

// Draws the outline of a glyph with cubic curves as a charstring says it, relative to the point
// where it is. Numbers are those of charstrings, multiples of 2^-16 units, and their sums are
// exact.
class Charstring_pen {
  Glyph_outline& outline_;
  Glyph_point start_{0, 0}, at_{0, 0};

  void move_by(std::int64_t dx, std::int64_t dy) {
    constexpr std::int64_t most = Glyph_outline::max_coordinate << shift;
    at_ = {at_.x + dx, at_.y + dy};
    if (at_.x < -most || most < at_.x || at_.y < -most || most < at_.y)
      refuse_coordinate(Glyph_outline::max_coordinate);
  }

public:
  static constexpr int shift = 16;

  // Numbers, of which the default instance of a variable font leaves out by how much they vary.
  typedef std::int64_t Number;
  static Number number(std::int64_t x) { return x; }
  static std::int64_t value(Number x) { return x; }
  static void blend(Number&, const Number*, std::size_t) {}

  explicit Charstring_pen(Glyph_outline& outline) : outline_(outline) {}

  const Glyph_point& position() const { return at_; }

  // Ends a contour and begins another one.
  void move(std::int64_t dx, std::int64_t dy) {
    close();
    move_by(dx, dy);
    start_ = at_;
  }
  void line(std::int64_t dx, std::int64_t dy) {
    const Glyph_point from = at_;
    move_by(dx, dy);
    outline_.add({1, {from, at_}});
  }
  void curve(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, std::int64_t cx, std::int64_t cy) {
    Glyph_segment segment{3, {at_}};
    move_by(ax, ay);
    segment.points[1] = at_;
    move_by(bx, by);
    segment.points[2] = at_;
    move_by(cx, cy);
    segment.points[3] = at_;
    outline_.add(segment);
  }

  // Ends a contour with a line to its start. The position stays.
  void close() {
    if (!(at_ == start_)) outline_.add({1, {at_, start_}});
    outline_.end_contour();
    start_ = at_;
  }
  void jump(const Glyph_point& to) {
    at_ = {0, 0};
    move_by(to.x, to.y);
    start_ = at_;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CHARSTRING_PEN_H
