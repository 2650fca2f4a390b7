// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_OUTLINE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_OUTLINE_H

#include "formats/font/True_type_outlines.h"
#include "formats/font/Variable_join.h"

#include <cstddef>
#include <utility>
#include <vector>

/// An outline of a variable font, as a function of the axes, and its joins.

namespace CGAL {
namespace Geometric_continuity {

/// A vector of an outline in units of the font.
typedef Variable_vector::Vector Outline_vector;

/// A point at the default instance, in units of the font: the numbers of the file, which doubles
/// have.
struct Variable_point {
  double x, y;
  bool on_curve; ///< otherwise a control point
};

/// An outline that depends on the instance: point `i` is `points[i]` and the sum of `shifts[r][i]`
/// times the scalar of `regions[r]` over all regions.
struct Variable_outline {
  bool
      /// whether two control points in succession belong to one curve; otherwise their midpoint is
      /// on the curve
      cubic;
  std::vector<Variable_point> points;
  std::vector<int> contour_ends;                ///< the points of a contour end before this one
  std::vector<Glyph_component> components = {}; ///< of a composite glyph, which has no points
  std::vector<Variation_region> regions = {};
  std::vector<std::vector<Outline_vector>> shifts = {};

  /// Returns a point at an instance, which is given by its normalised values, exactly.
  /// \f$ O(rk) \f$ for `r` regions and `k` axes
  Outline_vector point(std::size_t i, const std::vector<Variable_vector::FT>& instance) const {
    Variable_vector point{{Variable_vector::FT(points[i].x), Variable_vector::FT(points[i].y)}, {}};
    for (const std::vector<Outline_vector>& shift : shifts) point.shifts.push_back(shift[i]);
    return point(region_scalars(regions, instance));
  }
};

/// A join at a point that is on the curve: the numbers in the outline, from 0.
struct Outline_join {
  int contour, point;
  Variable_join join;
};

inline Variable_vector variable_vector(const Variable_outline& glyph, std::size_t from, std::size_t to) {
  typedef Variable_vector::FT FT;
  const Variable_point &p = glyph.points[from], &q = glyph.points[to];
  Variable_vector side{{FT(q.x) - FT(p.x), FT(q.y) - FT(p.y)}, {}};
  side.shifts.reserve(glyph.shifts.size());
  for (const std::vector<Outline_vector>& shift : glyph.shifts)
    side.shifts.push_back({shift[to][0] - shift[from][0], shift[to][1] - shift[from][1]});
  return side;
}

/// Returns the joins of an outline at all points that are on the curve. Points that coincide at
/// every instance are one point: then a handle is retracted or a segment has no length, and the
/// side beyond has the direction of the image. It is on the curve if one of them is, or if they are
/// control points of quadratic curves. The joins between two control points in succession of such
/// curves are not among them: there the tangent is the line through both, in every instance.
/// \f$ O(nr) \f$ for `n` points and `r` regions
inline std::vector<Outline_join> outline_joins(const Variable_outline& glyph) {
  std::vector<Outline_join> joins;
  std::size_t begin = 0;
  for (std::size_t contour = 0; contour < glyph.contour_ends.size(); ++contour) {
    const std::size_t end = static_cast<std::size_t>(glyph.contour_ends[contour]);
    // the sides that are not zero, from each of these points to the next, and which points are on
    // the curve
    std::vector<std::size_t> points;
    std::vector<bool> on_curve;
    std::vector<Variable_vector> sides;
    bool merged_on = false; // one of the points that coincide with this one is on the curve
    for (std::size_t i = begin; i < end; ++i) {
      Variable_vector side = variable_vector(glyph, i, i + 1 == end ? begin : i + 1);
      const bool zero = side.is_zero(), on = merged_on || glyph.points[i].on_curve || (zero && !glyph.cubic);
      if (!zero) {
        points.push_back(i);
        on_curve.push_back(on);
        sides.push_back(std::move(side));
      } else if (i + 1 == end && !on_curve.empty() && on)
        on_curve.front() = true; // the last points coincide with the first one
      merged_on = zero && on;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      if (on_curve[i])
        joins.push_back({static_cast<int>(contour),
                         static_cast<int>(points[i]),
                         {sides[i == 0 ? points.size() - 1 : i - 1], sides[i]}});
    begin = end;
  }
  return joins;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_OUTLINE_H
