// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_INTERPOLATE_UNTOUCHED_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_INTERPOLATE_UNTOUCHED_H

#include "formats/font/Glyph_variations.h"
#include "formats/font/True_type_outlines.h"
#include "formats/font/Variable_outline.h"
#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <utility>
#include <vector>

/// How points move of which a variation does not say it: between their neighbours along the
/// contour. OpenType specification, table 'gvar', "Inferred deltas for un-referenced point
/// numbers".

namespace CGAL {
namespace Geometric_continuity {

// The movement of a coordinate x between those of the touched points at a and b, which move by p
// and q: linear between them, and that of the nearer one outside. Where both are at one place and
// do not move alike, no movement.
inline CGAL::Exact_rational interpolated_shift(int x, int a, int b, int p, int q) {
  if (b < a) {
    std::swap(a, b);
    std::swap(p, q);
  }
  if (a == b) return CGAL::Exact_rational(p == q ? p : 0);
  if (x <= a) return CGAL::Exact_rational(p);
  if (b <= x) return CGAL::Exact_rational(q);
  return CGAL::Exact_rational(p) +
         CGAL::Exact_rational(x - a) * CGAL::Exact_rational(q - p) / CGAL::Exact_rational(b - a);
}

/// Returns how each point of an outline moves by one variation: as that says, or in each coordinate
/// linearly between the touched points before and behind it on the contour. The result is exact;
/// rasterisers round it. \f$ O(n) \f$
/// \throws Error `malformed_input` when the variation has not one movement for each of its points
inline std::vector<Outline_vector> interpolate_untouched(const True_type_outline& outline,
                                                         const Tuple_variation& variation) {
  const std::size_t n = outline.points.size(),
                    moved = variation.points ? variation.points->size() : variation.dx.size();
  if (variation.dx.size() != moved || variation.dy.size() != moved || (!variation.points && moved < n))
    throw Error(Error_code::malformed_input, "interpolate_untouched: the number of movements");
  std::vector<int> place(n, -1); // of the movement of each point
  for (std::size_t i = 0; i < moved; ++i) {
    const std::size_t point = variation.points ? static_cast<std::size_t>((*variation.points)[i]) : i;
    if (point < n) place[point] = static_cast<int>(i);
  }
  std::vector<Outline_vector> shifts(n);
  std::size_t begin = 0;
  for (int contour_end : outline.contour_ends) {
    const std::size_t end = static_cast<std::size_t>(contour_end);
    std::vector<std::size_t> touched;
    for (std::size_t i = begin; i < end; ++i)
      if (place[i] >= 0) {
        touched.push_back(i);
        const std::size_t j = static_cast<std::size_t>(place[i]);
        shifts[i] = {variation.dx[j], variation.dy[j]};
      }
    // from a touched point to the next one, which may be itself
    for (std::size_t t = 0; t < touched.size(); ++t) {
      const std::size_t first = touched[t], second = touched[(t + 1) % touched.size()];
      const Outline_point &a = outline.points[first], &b = outline.points[second];
      const std::size_t p = static_cast<std::size_t>(place[first]), q = static_cast<std::size_t>(place[second]);
      for (std::size_t i = first + 1 == end ? begin : first + 1; i != second; i = i + 1 == end ? begin : i + 1)
        shifts[i] = {interpolated_shift(outline.points[i].x, a.x, b.x, variation.dx[p], variation.dx[q]),
                     interpolated_shift(outline.points[i].y, a.y, b.y, variation.dy[p], variation.dy[q])};
    }
    begin = end;
  }
  return shifts;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_INTERPOLATE_UNTOUCHED_H
