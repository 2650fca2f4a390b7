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

// A point of a glyph in halves of the units of its font, so that the points between two control points, which TrueType leaves
// out, are integers as well.
struct Glyph_point {
  std::int32_t x, y;
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

// The closed contours of a glyph. Segments of no length are left out, and contours without segments.
class Glyph_outline {
  std::vector<Glyph_segment> segments_;
  std::vector<std::size_t> ends_; // of the contours

public:
  void clear() {
    segments_.clear();
    ends_.clear();
  }

  void add(const Glyph_segment& segment) {
    if (!segment.has_no_length()) segments_.push_back(segment);
  }

  // Ends a contour, whose last segment leads to its first point.
  void end_contour() {
    if (segments_.size() > (ends_.empty() ? 0 : ends_.back())) ends_.push_back(segments_.size());
  }

  std::size_t contours() const { return ends_.size(); }
  const Glyph_segment* begin(std::size_t contour) const {
    return segments_.data() + (contour == 0 ? 0 : ends_[contour - 1]);
  }
  const Glyph_segment* end(std::size_t contour) const { return segments_.data() + ends_[contour]; }

  // The number of segments, and of joins.
  std::size_t size() const { return segments_.size(); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_OUTLINE_H
