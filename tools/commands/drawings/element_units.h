// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_ELEMENT_UNITS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_ELEMENT_UNITS_H

#include "formats/svg/svg_drawing.h"

#include <array>
#include <optional>

// Returns the map from the drawing to the coordinates of the element in units of their last
// decimal; nothing where there are no decimals, or more than 18. (x, y) -> (ax + cy + e, bx + dy +
// f) is inverted by Cramer's rule.
inline std::optional<GC::Svg_transform<Drawing_traits>> to_units(const Drawing_element& element) {
  typedef Drawing_traits::FT Number;
  constexpr int most_units = 18;
  if (element.decimals < 0 || most_units < element.decimals) return std::nullopt;
  const std::array<Number, 6>& m = element.transform.matrix();
  Number det = element.transform.determinant();
  for (int i = 0; i < element.decimals; ++i) det /= 10;
  const Number a = m[3] / det, b = -m[1] / det, c = -m[2] / det, d = m[0] / det;
  return GC::Svg_transform<Drawing_traits>({a, b, c, d, Number(-a * m[4] - c * m[5]), Number(-b * m[4] - d * m[5])});
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_ELEMENT_UNITS_H
