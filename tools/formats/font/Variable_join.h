// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H

#include "formats/font/Variable_font.h"
#include <CGAL/Geometric_continuity/joins/Kink_bound.h>

#include <cstddef>
#include <optional>
#include <vector>

/// The joins of a glyph of a variable font as functions of the axes.

namespace CGAL {
namespace Geometric_continuity {

/// The vector from a point of an outline to another one: `constant` and the sum of `shifts[r]` times the scalar of region `r`.
struct Variable_leg {
  typedef CGAL::Exact_rational FT; ///< the number type

  Outline_vector constant;
  std::vector<Outline_vector> shifts;

  /// Returns whether it is the zero vector at every instance whatever the regions are.
  bool is_zero() const {
    for (const Outline_vector& v : shifts)
      if (v[0] != FT(0) || v[1] != FT(0)) return false;
    return constant[0] == FT(0) && constant[1] == FT(0);
  }

  /// Returns the vector where the regions have these scalars.
  Outline_vector operator()(const std::vector<FT>& scalars) const {
    Outline_vector v = constant;
    for (std::size_t r = 0; r < shifts.size(); ++r)
      if (scalars[r] != FT(0))
        for (std::size_t c = 0; c < 2; ++c) v[c] += scalars[r] * shifts[r][c];
    return v;
  }
};

/// A join at a point that is on the curve: the legs that lead to it and away from it, along a handle or a line.
struct Variable_join {
  int contour, point; ///< the numbers in the glyph's outline, from 0
  Variable_leg incoming, outgoing;
};

inline Variable_leg variable_leg(const Variable_outline& glyph, std::size_t from, std::size_t to) {
  const Outline_point &p = glyph.outline.points[from], &q = glyph.outline.points[to];
  Variable_leg leg{{q.x - p.x, q.y - p.y}, {}};
  leg.shifts.reserve(glyph.shifts.size());
  for (const std::vector<Outline_vector>& shift : glyph.shifts)
    leg.shifts.push_back({shift[to][0] - shift[from][0], shift[to][1] - shift[from][1]});
  return leg;
}

/// Returns the joins of an outline at all points that are on the curve. Points that coincide at every instance are one
/// point, on the curve: then a handle is retracted or a segment has no length, and the leg beyond has the direction of the
/// image. The joins between two control points in succession are not among them: there the tangent is the line through both, in
/// every instance. \f$ O(nr) \f$ for `n` points and `r` regions
inline std::vector<Variable_join> variable_joins(const Variable_outline& glyph) {
  std::vector<Variable_join> joins;
  std::size_t begin = 0;
  for (std::size_t contour = 0; contour < glyph.outline.contour_ends.size(); ++contour) {
    const std::size_t end = static_cast<std::size_t>(glyph.outline.contour_ends[contour]);
    // the legs that are not zero, from each of these points to the next, and which points are on the curve
    std::vector<std::size_t> points;
    std::vector<bool> on_curve;
    std::vector<Variable_leg> legs;
    bool merged = false;
    for (std::size_t i = begin; i < end; ++i) {
      Variable_leg leg = variable_leg(glyph, i, i + 1 == end ? begin : i + 1);
      const bool zero = leg.is_zero(), on = merged || zero || glyph.outline.points[i].on_curve;
      if (!zero) {
        points.push_back(i);
        on_curve.push_back(on);
        legs.push_back(std::move(leg));
      } else if (i + 1 == end && !on_curve.empty())
        on_curve.front() = true; // the last points coincide with the first one
      merged = zero;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      if (on_curve[i])
        joins.push_back({static_cast<int>(contour), static_cast<int>(points[i]),
                         legs[i == 0 ? points.size() - 1 : i - 1], legs[i]});
    begin = end;
  }
  return joins;
}

/// Decides whether a join is a corner at an instance, which is given by the scalars of the regions; empty when a leg has no
/// length there. The decision is exact.
inline std::optional<bool> is_corner(const Variable_join& join, const std::vector<Variable_leg::FT>& scalars,
                                     const Kink_bound& bound) {
  const Outline_vector a = join.incoming(scalars), b = join.outgoing(scalars);
  const Variable_leg::FT cross = a[0] * b[1] - a[1] * b[0], dot = a[0] * b[0] + a[1] * b[1];
  if (cross == 0 && dot == 0) return std::nullopt;
  return bound.is_exceeded(cross, dot);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H
