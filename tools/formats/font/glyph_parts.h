// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_PARTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_PARTS_H

#include "formats/font/Variable_font.h"
#include "formats/font/leaf_parts.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The glyphs with outlines of which a composite glyph of a variable font consists in the end.

namespace CGAL {
namespace Geometric_continuity {

/// Returns whether the transform of a part changes angles: it is no similarity.
inline bool is_stretched(const Glyph_part& part) {
  const Part_matrix& m = part.matrix;
  const bool turns = m.xx == m.yy && m.yx == -m.xy, mirrors = m.xx == -m.yy && m.yx == m.xy;
  return !(turns || mirrors) || (m.xx == 0 && m.yx == 0);
}

/// Returns a join of the part as it is in the whole glyph.
inline Variable_join join_of_part(const Glyph_part& part, Variable_join join) {
  typedef Variable_vector::FT FT;
  const Part_matrix& m = part.matrix;
  const auto number = [&m](std::int64_t x) {
    return FT(static_cast<double>(x) / static_cast<double>(std::int64_t(1) << m.shift)); // exact
  };
  const FT xx = number(m.xx), xy = number(m.xy), yx = number(m.yx), yy = number(m.yy);
  const auto transform = [&](Outline_vector& v) { v = {FT(xx * v[0] + xy * v[1]), FT(yx * v[0] + yy * v[1])}; };
  for (Variable_vector* side : {&join.incoming, &join.outgoing}) {
    transform(side->constant);
    for (Outline_vector& shift : side->shifts) transform(shift);
  }
  return join;
}

/// Returns the parts of a composite glyph, those of its components included.
/// \throws Error `malformed_input`, `work_limit` for more than `max_glyph_parts`, as of a glyph
///   that contains itself
inline std::vector<Glyph_part> glyph_parts(const Variable_font& font, const std::vector<Glyph_component>& components) {
  std::vector<Glyph_part> parts;
  try {
    append_leaf_parts(
        components, parts, [&](int glyph) { return font.components(glyph); },
        [](const Glyph_component&, std::size_t, std::size_t) { return Part_offset{}; });
    return parts;
  } catch (const Font_error& e) {
    throw Error(Error_code::work_limit, e.what());
  }
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_PARTS_H
