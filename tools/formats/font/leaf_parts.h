// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LEAF_PARTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LEAF_PARTS_H

#include "formats/font/Font_error.h"
#include "formats/font/Glyph_outline.h"
#include "formats/font/True_type_outlines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// A product of numbers that outlines have.
__extension__ typedef __int128 Wide_integer;

// A matrix of integers over a power of two: (x, y) becomes (xx x + xy y, yx x + yy y) / 2^shift.
struct Part_matrix {
  std::int64_t xx = 1, xy = 0, yx = 0, yy = 1;
  int shift = 0;

  bool is_identity() const { return xx == 1 && xy == 0 && yx == 0 && yy == 1 && shift == 0; }

  bool is_diagonal() const { return xy == 0 && yx == 0; }

  Part_matrix reduced() const {
    Part_matrix m = *this;
    for (; m.shift > 0 && ((m.xx | m.xy | m.yx | m.yy) & 1) == 0; --m.shift)
      m = {m.xx / 2, m.xy / 2, m.yx / 2, m.yy / 2, m.shift};
    return m;
  }

  // Throws Font_error where numbers over such a power of two, or factors, are longer than those of
  // outlines.
  static void check(int shift, bool is_short = true) {
    if (!is_short || shift > Glyph_outline::max_shift - 1)
      throw Font_error("not covered: a component that is scaled too often");
  }

  // The product. Throws Font_error where it needs more digits than outlines have.
  Part_matrix operator*(const Part_matrix& m) const {
    const auto sum = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) -> Wide_integer {
      return Wide_integer(a) * b + Wide_integer(c) * d;
    };
    std::array<Wide_integer, 4> x{sum(xx, m.xx, xy, m.yx), sum(xx, m.xy, xy, m.yy), sum(yx, m.xx, yy, m.yx),
                                  sum(yx, m.xy, yy, m.yy)};
    int digits = shift + m.shift;
    for (; digits > 0 && ((x[0] | x[1] | x[2] | x[3]) & 1) == 0; --digits)
      for (Wide_integer& entry : x) entry /= 2;
    check(digits);
    const Wide_integer most = Wide_integer(1 << 11) << digits;
    for (const Wide_integer& entry : x) check(digits, -most <= entry && entry <= most);
    const auto short_integer = [&x](std::size_t i) { return static_cast<std::int64_t>(x[i]); };
    return {short_integer(0), short_integer(1), short_integer(2), short_integer(3), digits};
  }
  Glyph_point operator()(const Glyph_point& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
};

// A point, or where a part stands, in units of the font over a power of two.
struct Part_offset {
  std::int64_t x = 0, y = 0;
  int shift = 0;

  // Returns the point over the least power of two. Throws Font_error for what no outline has.
  static Part_offset reduced(Wide_integer x, Wide_integer y, int shift) {
    for (; shift > 0 && ((x | y) & 1) == 0; --shift) {
      x /= 2;
      y /= 2;
    }
    Part_matrix::check(shift);
    const Wide_integer most = Glyph_outline::max_coordinate << shift;
    if (x < -most || most < x || y < -most || most < y) refuse_coordinate(Glyph_outline::max_coordinate);
    return {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), shift};
  }
};

// A glyph as a part of another one.
struct Glyph_part {
  int glyph;
  Part_matrix matrix = {};
  Part_offset offset = {};

  // A point of the part, as it is in the whole.
  Part_offset operator()(const Part_offset& p) const {
    typedef Wide_integer Wide;
    const int own = matrix.shift + p.shift, common = (std::max)(own, offset.shift);
    const Wide more = Wide(1) << (common - own), unit = Wide(1) << (common - offset.shift);
    const auto sum = [&](std::int64_t a, std::int64_t b, std::int64_t at) -> Wide {
      return more * (Wide(a) * p.x + Wide(b) * p.y) + unit * at;
    };
    return Part_offset::reduced(sum(matrix.xx, matrix.xy, offset.x), sum(matrix.yx, matrix.yy, offset.y), common);
  }

  // The part of a part.
  Glyph_part operator*(const Glyph_part& inner) const {
    const Part_matrix product = matrix * inner.matrix;
    return {inner.glyph, product, (*this)(inner.offset)};
  }
};

// How many parts a glyph may have, those of its parts included.
constexpr std::size_t max_glyph_parts = 1000;

// The matrix of a component.
inline Part_matrix part_matrix(const CGAL::Geometric_continuity::Glyph_component& component) {
  const auto& m = component.matrix;
  return Part_matrix{m[0], m[2], m[1], m[3], 14}.reduced();
}

// Appends the parts without parts of which these components consist in the end, in their order.
// `visit(glyph)` returns the components of a glyph, none for a part without parts;
// `place(component, first, begin)` tells where one stands whose own parts have been appended from
// `begin` on, and those of the components before it from `first` on. Throws Font_error when there
// are more than `max_glyph_parts`, as of a glyph that contains itself; `number` of them are known.
template <class Visit, class Place>
void append_leaf_parts(const std::vector<CGAL::Geometric_continuity::Glyph_component>& components,
                       std::vector<Glyph_part>& leaves, std::size_t& number, Visit& visit, Place& place) {
  const std::size_t first = leaves.size();
  for (const auto& component : components) {
    if (number++ == max_glyph_parts) throw Font_error("more components than any letter needs");
    const std::size_t begin = leaves.size();
    const auto inner = visit(component.glyph);
    if (inner.empty())
      leaves.push_back({component.glyph});
    else
      append_leaf_parts(inner, leaves, number, visit, place);
    const Glyph_part outer{component.glyph, part_matrix(component), place(component, first, begin)};
    for (std::size_t i = begin; i < leaves.size(); ++i) leaves[i] = outer * leaves[i];
  }
}

// Appends the parts without parts of a glyph with these components.
template <class Visit, class Place>
void append_leaf_parts(const std::vector<CGAL::Geometric_continuity::Glyph_component>& components,
                       std::vector<Glyph_part>& leaves, Visit visit, Place place) {
  std::size_t number = 0;
  append_leaf_parts(components, leaves, number, visit, place);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LEAF_PARTS_H
