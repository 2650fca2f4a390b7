// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LEAF_PARTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LEAF_PARTS_H

#include "formats/font/Font_error.h"
#include "formats/font/Glyph_outline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

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

  // The product. Throws Font_error where it needs more digits than outlines have.
  Part_matrix operator*(const Part_matrix& m) const {
    if (shift + m.shift > Glyph_outline::max_shift - 1)
      throw Font_error("not covered: a component that is scaled too often");
    return Part_matrix{xx * m.xx + xy * m.yx, xx * m.xy + xy * m.yy, yx * m.xx + yy * m.yx, yx * m.xy + yy * m.yy,
                       shift + m.shift}
        .reduced();
  }
  Glyph_point operator()(const Glyph_point& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
};

// Where a part stands, in units of the font over a power of two.
struct Part_offset {
  std::int64_t x = 0, y = 0;
  int shift = 0;
};

// A glyph as a part of another one. Its offset is nothing where it is not known: where a point of the part is put on one of the glyph, or where
// the length of the offset is scaled by a matrix that does more than scale.
struct Glyph_part {
  int glyph;
  Part_matrix matrix = {};
  std::optional<Part_offset> offset = std::nullopt;

  // The part of a part.
  Glyph_part operator*(const Glyph_part& inner) const {
    Glyph_part result{inner.glyph, matrix * inner.matrix};
    if (!offset || !inner.offset) return result;
    const Glyph_point at = matrix({inner.offset->x, inner.offset->y});
    const int added = matrix.shift + inner.offset->shift, shift = (std::max)(offset->shift, added);
    const std::int64_t own = std::int64_t(1) << (shift - offset->shift), more = std::int64_t(1) << (shift - added);
    result.offset = Part_offset{own * offset->x + more * at.x, own * offset->y + more * at.y, shift};
    return result;
  }
};

// How many parts a glyph may have, those of its parts included.
constexpr std::size_t max_glyph_parts = 1000;

// Returns the parts without parts of which a glyph with these parts consists in the end, in their order. `parts_of(glyph)` are those of
// a glyph, if it has some. Throws Font_error when there are too many, as of a glyph that contains itself.
template <class Parts_of> std::vector<Glyph_part> leaf_parts(const std::vector<Glyph_part>& parts, Parts_of parts_of) {
  std::vector<Glyph_part> open(parts.rbegin(), parts.rend()), leaves;
  for (std::size_t number = 0; !open.empty(); ++number) {
    if (number == max_glyph_parts) throw Font_error("more components than any letter needs");
    const Glyph_part outer = open.back();
    open.pop_back();
    const std::optional<std::vector<Glyph_part>> inner = parts_of(outer.glyph);
    if (!inner) {
      leaves.push_back(outer);
      continue;
    }
    for (auto part = inner->rbegin(); part != inner->rend(); ++part) open.push_back(outer * *part);
  }
  return leaves;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LEAF_PARTS_H
