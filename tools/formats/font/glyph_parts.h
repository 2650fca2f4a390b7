// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_PARTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_PARTS_H

#include "formats/font/Variable_font.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// The glyphs of which a composite glyph consists in the end.

namespace CGAL {
namespace Geometric_continuity {

/// A glyph with an outline as a part of another one, and the product of the matrices with which it is transformed.
struct Glyph_part {
  typedef Variable_leg::FT FT; ///< the number type

  int glyph;
  std::array<FT, 4> matrix; ///< as those of `Glyph_component`, in units of 1

  /// Returns whether the transform changes angles: it is no similarity.
  bool is_stretched() const {
    const std::array<FT, 4>& m = matrix;
    const bool turns = m[0] == m[3] && m[1] == -m[2], mirrors = m[0] == -m[3] && m[1] == m[2];
    return !(turns || mirrors) || (m[0] == FT(0) && m[1] == FT(0));
  }

  /// Returns a join of the glyph as it is in the other one.
  Variable_join operator()(Variable_join join) const {
    for (Variable_leg* leg : {&join.incoming, &join.outgoing}) {
      transform(leg->constant);
      for (Outline_vector& shift : leg->shifts) transform(shift);
    }
    return join;
  }

private:
  void transform(Outline_vector& v) const {
    v = {FT(matrix[0] * v[0] + matrix[2] * v[1]), FT(matrix[1] * v[0] + matrix[3] * v[1])};
  }
};

/// How many components a glyph may have, those of its components included.
constexpr std::size_t max_glyph_parts = 1000;

/// Returns the parts of a composite glyph, those of its components included.
/// \throws Error `malformed_input`, `work_limit` for more than `max_glyph_parts`, as of a glyph that contains itself
inline std::vector<Glyph_part> glyph_parts(const Variable_font& font, const std::vector<Glyph_component>& components) {
  typedef Glyph_part::FT FT;
  const auto part = [](const Glyph_component& c) {
    Glyph_part p{c.glyph, {}};
    for (std::size_t i = 0; i < 4; ++i) p.matrix[i] = FT(static_cast<double>(c.matrix[i]) / 0x4000); // exact
    return p;
  };
  std::vector<Glyph_part> open, parts;
  for (const Glyph_component& c : components) open.push_back(part(c));
  for (std::size_t number = 0; !open.empty(); ++number) {
    if (number == max_glyph_parts) throw Error(Error_code::work_limit, "more components than any letter needs");
    const Glyph_part outer = open.back();
    open.pop_back();
    const std::vector<Glyph_component> inner = font.components(outer.glyph);
    if (inner.empty()) parts.push_back(outer);
    for (const Glyph_component& c : inner) {
      Glyph_part p = part(c);
      const std::array<FT, 4> m = p.matrix, &o = outer.matrix;
      p.matrix = {FT(o[0] * m[0] + o[2] * m[1]), FT(o[1] * m[0] + o[3] * m[1]), FT(o[0] * m[2] + o[2] * m[3]),
                  FT(o[1] * m[2] + o[3] * m[3])};
      open.push_back(p);
    }
  }
  return parts;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_PARTS_H
