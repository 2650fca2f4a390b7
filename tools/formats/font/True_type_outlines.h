// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TRUE_TYPE_OUTLINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TRUE_TYPE_OUTLINES_H

#include "formats/font/Font_tables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The outlines of TrueType glyphs, as they are written. OpenType specification, tables 'head',
/// 'maxp', 'loca' and 'glyf'.

namespace CGAL {
namespace Geometric_continuity {

/// A point of an outline in units of the font: on the curve, or the control point of a quadratic
/// curve.
struct Outline_point {
  int x, y;      ///< the coordinates
  bool on_curve; ///< between two control points in succession their midpoint is on the curve

  /// Decides whether both are equal.
  friend bool operator==(const Outline_point& p, const Outline_point& q) {
    return p.x == q.x && p.y == q.y && p.on_curve == q.on_curve;
  }
};

/// Another glyph of which a composite glyph consists, how it is transformed and where it stands.
struct Glyph_component {
  int glyph;
  /// `(x, y)` becomes `(m[0] x + m[2] y, m[1] x + m[3] y)`, in units of 2^-14
  std::array<int, 4> matrix;
  /// otherwise point `y` of the component is put on point `x` of those before it
  bool has_offset;
  bool scales_offset; ///< by the lengths of the rows of the matrix
  int x, y;
};

/// The outline of a glyph. That of a composite glyph is not resolved: it has no points.
struct True_type_outline {
  std::vector<Outline_point> points;
  std::vector<int> contour_ends;           ///< the points of a contour end before this one
  std::vector<Glyph_component> components; ///< of a composite glyph
};

inline std::vector<Glyph_component> read_components(Font_bytes& bytes) {
  enum { words = 1, has_offset = 2, scale = 8, more = 0x20, two_scales = 0x40, matrix = 0x80, scales_offset = 0x800 };
  std::vector<Glyph_component> components;
  for (int flags = more; (flags & more) != 0;) {
    flags = bytes.u16();
    Glyph_component component{
        bytes.u16(), {0x4000, 0, 0, 0x4000}, (flags & has_offset) != 0, (flags & scales_offset) != 0, 0, 0};
    for (int* x : {&component.x, &component.y}) {
      *x = (flags & words) != 0 ? bytes.u16() : bytes.u8();
      const int sign = (flags & words) != 0 ? 0x8000 : 0x80;
      if (component.has_offset) *x = (*x ^ sign) - sign;
    }
    std::array<int, 4>& m = component.matrix;
    if ((flags & scale) != 0)
      m[0] = m[3] = bytes.i16();
    else if ((flags & two_scales) != 0)
      for (std::size_t i : {0, 3}) m[i] = bytes.i16();
    else if ((flags & matrix) != 0)
      for (int& x : m) x = bytes.i16();
    components.push_back(component);
  }
  return components;
}

inline void read_points(Font_bytes& bytes, int contours, True_type_outline& outline) {
  for (int i = 0, before = 0; i < contours; ++i) {
    const int end = bytes.u16() + 1;
    if (end <= before) bytes.refuse("contour " + std::to_string(i) + " ends before it begins");
    outline.contour_ends.push_back(before = end);
  }
  if (contours == 0) return;
  bytes.skip(static_cast<std::size_t>(bytes.u16())); // instructions
  const std::size_t count = static_cast<std::size_t>(outline.contour_ends.back());
  enum { on_curve = 1, short_x = 2, short_y = 4, repeated = 8, same_x = 16, same_y = 32 };
  std::vector<unsigned char> flags;
  flags.reserve(count + 255);
  while (flags.size() < count) {
    const int flag = bytes.u8();
    flags.push_back(static_cast<unsigned char>(flag));
    if ((flag & repeated) != 0) flags.resize(flags.size() + static_cast<std::size_t>(bytes.u8()), flags.back());
  }
  if (flags.size() != count) bytes.refuse("there are more flags than points");
  const auto coordinates = [&](int short_flag, int same_flag, auto set) {
    int x = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const bool same = (flags[i] & same_flag) != 0;
      if ((flags[i] & short_flag) != 0)
        x += same ? bytes.u8() : -bytes.u8();
      else if (!same)
        x += bytes.i16();
      set(i, x); // of at most 65536 points
    }
  };
  outline.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) outline.points[i].on_curve = (flags[i] & on_curve) != 0;
  coordinates(short_x, same_x, [&](std::size_t i, int x) { outline.points[i].x = x; });
  coordinates(short_y, same_y, [&](std::size_t i, int y) { outline.points[i].y = y; });
}

/// Reads a glyph from its bytes. Takes memory in proportion to them only. \throws Error
/// `malformed_input`
inline True_type_outline read_true_type_outline(Font_bytes bytes) {
  True_type_outline outline;
  const int contours = bytes.i16();
  bytes.skip(8); // a bounding box
  if (contours < 0)
    outline.components = read_components(bytes);
  else
    read_points(bytes, contours, outline);
  return outline;
}

/// The outlines of a TrueType font. It refers to the bytes of the font.
class True_type_outlines {
  std::string_view glyphs_, places_;
  bool long_places_;
  int units_per_em_;
  int count_;

public:
  /// Reads what all glyphs have in common. \throws Error `malformed_input`, also when the font has
  /// no TrueType outlines
  explicit True_type_outlines(const Font_tables& font) : glyphs_(font.table("glyf")), places_(font.table("loca")) {
    Font_bytes head(font.table("head"), "table 'head'"), profile(font.table("maxp"), "table 'maxp'"),
        places(places_, "table 'loca'");
    units_per_em_ = head.seek(18).u16();
    if (units_per_em_ == 0) head.refuse("the em has no units");
    const int format = head.seek(50).u16();
    if (format > 1) head.refuse("the format " + std::to_string(format) + " of the table 'loca' is unknown");
    long_places_ = format == 1;
    count_ = profile.seek(4).u16();
    if (places.size() / (long_places_ ? 4 : 2) < static_cast<std::size_t>(count_) + 1)
      places.refuse("it is too short for " + std::to_string(count_) + " glyphs");
  }

  /// Returns the number of glyphs.
  int glyph_count() const { return count_; }
  /// Returns the number of units of which the em consists.
  int units_per_em() const { return units_per_em_; }

  /// Reads a glyph; one without an outline has no points. Takes memory in proportion to the glyph's
  /// bytes only.
  /// \throws Error `malformed_input`, `parameter_outside_domain` when there is no such glyph
  True_type_outline glyph(int index) const {
    if (index < 0 || count_ <= index)
      throw Error(Error_code::parameter_outside_domain, "there is no glyph " + std::to_string(index));
    const std::string name = "table 'glyf', glyph " + std::to_string(index);
    const std::size_t begin = place(index), next = place(index + 1);
    // FreeType, which unpacks WOFF2, may write a wrong end of the last glyph, and reads to the end
    // of the table itself
    const std::size_t end = index + 1 == count_ ? (std::min)(next, glyphs_.size()) : next;
    Font_bytes whole(glyphs_, name);
    if (end < begin || glyphs_.size() < end) whole.refuse("it lies outside of the table");
    if (begin == end) return {};
    True_type_outline outline = read_true_type_outline({glyphs_.substr(begin, end - begin), name});
    const auto is_long = [](int x) { return x < -0x8000 || 0x7fff < x; };
    for (std::size_t i = 0; i < outline.points.size(); ++i)
      if (is_long(outline.points[i].x) || is_long(outline.points[i].y))
        whole.refuse("point " + std::to_string(i) + " has more than 16 bits");
    return outline;
  }

private:
  std::size_t place(int index) const {
    Font_bytes bytes(places_, "table 'loca'");
    const std::size_t i = static_cast<std::size_t>(index);
    return long_places_ ? bytes.seek(4 * i).u32() : 2 * static_cast<std::size_t>(bytes.seek(2 * i).u16());
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TRUE_TYPE_OUTLINES_H
