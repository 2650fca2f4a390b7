// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CREASE_ON_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CREASE_ON_GRID_H

#include <CGAL/Geometric_continuity/edges/Spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/Fixed_largest_measure.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_layers.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_on_grid.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cmath>
#include <optional>

/// \file crease_on_grid.h
/// What Edge_decision answers for most creases, in integers of fixed length.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The verdict on [0, 1] along two edges that are the same curve in one direction, where the tangent planes differ somewhere but
// nowhere by a right angle or more, so that no normal vanishes. Empty if numbers of fixed length do not prove that, or the meter
// does not allow to look for the largest angle.
//
// The normals N and n2 are those of Edge_on_grid, with coefficients below 2^121; see Edge_measure for the polynomials p and s. For
// degrees n <= 5 the coefficients of N.n2 are at most 12 * 2^216 C(18,9) < 2^236, four limbs, and those of p at most
// 144 * 2^432 C(36,18) < 2^474, eight limbs.
template <class Field>
std::optional<Edge_continuity<Field>> crease_on_grid(const Edge_layers& a, const Edge_layers& b, Work_meter& work) {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  constexpr int most_along = 5;
  if constexpr (Common_denominator<Field>::clears) {
    const double size = (std::max)(size_of(a), size_of(b));
    if (a.along > most_along || is_collapsed(a) || !std::isfinite(size)) return std::nullopt;
    Grid grid(size);
    if (!grid.valid()) return std::nullopt;
    const Grid_layers x = on_grid(a, grid), y = on_grid(b, grid);
    if (!grid.valid()) return std::nullopt;
    const Edge_on_grid edge(x, y);
    const Short_vector<2> n1 = edge.normal(), n2 = edge.second_normal();
    const Short_polynomial<4> side = product(n1, n2);
    if (side.strict_sign() >= 0) return std::nullopt;
    const Short_polynomial<8> p = product(product(n1, n1), product(n2, n2));
    Short_polynomial<8> s = p;
    s.template add_product<true>(side, side);
    if (s.vanishes()) return std::nullopt;
    Edge_continuity<Field> e;
    e.deviation = Fixed_largest_measure<Field, Short_polynomial<8>>(s, p, work)();
    if (!e.deviation) return std::nullopt;
    e.g_order = 0;
    e.defect = Edge_defect::crease;
    e.side = Sign_pattern::negative;
    return e;
  }
#endif
  return std::nullopt;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CREASE_ON_GRID_H
