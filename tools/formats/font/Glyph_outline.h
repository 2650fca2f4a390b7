// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_OUTLINE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_OUTLINE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// A point of a glyph in steps of its outline.
struct Glyph_point {
  std::int64_t x, y;
  bool operator==(const Glyph_point& p) const { return x == p.x && y == p.y; }
};

// A line, or a Bezier curve of degree 2 or 3.
struct Glyph_segment {
  int degree;
  std::array<Glyph_point, 4> points; // the first degree + 1 count

  const Glyph_point& start() const { return points[0]; }
  const Glyph_point& end() const { return points[static_cast<std::size_t>(degree)]; }

  bool has_no_length() const {
    return std::all_of(points.begin() + 1, points.begin() + degree + 1,
                       [this](const Glyph_point& p) { return p == points[0]; });
  }
};

// The closed contours of a glyph. Segments of no length are left out, and contours without
// segments. Coordinates are integers: a unit of the font has two steps, so that the points between
// two control points, which TrueType leaves out, are integers as well; where the font has
// fractions, or scales a component, it has as many steps as that takes, a power of two.
class Glyph_outline {
  std::vector<Glyph_segment> segments_;
  std::vector<std::size_t> ends_; // of the contours
  std::vector<int> parts_;        // the glyphs whose contours they are
  int part_ = own;                // that of the next contours
  int shift_ = 1;                 // a unit of the font has 2^shift steps

public:
  // no part: what the glyph itself draws
  static constexpr int own = -1;
  static constexpr std::int64_t max_coordinate = std::int64_t(1) << 20; // in units of the font
  static constexpr int max_shift = 30;

  void clear() {
    segments_.clear();
    ends_.clear();
    parts_.clear();
    part_ = own;
    shift_ = 1;
  }

  // How many steps a unit of the font has.
  std::int64_t steps() const { return std::int64_t(1) << shift_; }
  int shift() const { return shift_; }

  // Says that coordinates are in 2^shift steps of a unit, and takes the longest steps, at most
  // halves of a unit, in which all of them are integers.
  void set_shift(int shift) {
    std::uint64_t bits = 0; // of all coordinates
    for (const Glyph_segment& s : segments_)
      for (std::size_t i = 0; i <= static_cast<std::size_t>(s.degree); ++i)
        bits |= static_cast<std::uint64_t>(s.points[i].x) | static_cast<std::uint64_t>(s.points[i].y);
    int zeros = 0; // at the end of all of them
    while (shift - zeros > 1 && (bits >> zeros & 1) == 0) ++zeros;
    shift_ = shift - zeros;
    if (zeros == 0) return;
    for (Glyph_segment& s : segments_)
      for (std::size_t i = 0; i <= static_cast<std::size_t>(s.degree); ++i)
        s.points[i] = {s.points[i].x >> zeros, s.points[i].y >> zeros};
  }

  // Says that the next contours are those of another glyph.
  void begin_part(int glyph) { part_ = glyph; }

  void add(const Glyph_segment& segment) {
    if (!segment.has_no_length()) segments_.push_back(segment);
  }

  // Ends a contour, whose last segment leads to its first point.
  void end_contour() {
    if (segments_.size() == (ends_.empty() ? 0 : ends_.back())) return;
    ends_.push_back(segments_.size());
    parts_.push_back(part_);
  }

  // Appends contours, each point of which move() moves.
  template <class Move> void append(const Glyph_outline& part, Move move) {
    for (std::size_t contour = 0; contour < part.contours(); ++contour) {
      for (const Glyph_segment* s = part.begin(contour); s != part.end(contour); ++s) {
        Glyph_segment moved = *s;
        for (std::size_t i = 0; i <= static_cast<std::size_t>(s->degree); ++i) moved.points[i] = move(s->points[i]);
        add(moved);
      }
      end_contour();
    }
  }

  std::size_t contours() const { return ends_.size(); }
  const Glyph_segment* begin(std::size_t contour) const {
    return segments_.data() + (contour == 0 ? 0 : ends_[contour - 1]);
  }
  const Glyph_segment* end(std::size_t contour) const { return segments_.data() + ends_[contour]; }

  // The number of the component whose contour it is, or `own`.
  int part(std::size_t contour) const { return parts_[contour]; }

  // The number of segments, and of joins.
  std::size_t size() const { return segments_.size(); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_OUTLINE_H
