// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H

#include "formats/font/Variation_region.h"

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Variable_join.h
/// Joins in the plane that move with the axes of a family of shapes, as the nodes of a variable
/// font do.

namespace CGAL {
namespace Geometric_continuity {

/// The vector along a handle or a line at a join: `constant` and the sum of `shifts[r]` times the
/// scalar of region `r`.
struct Variable_vector {
  typedef Variation_region::FT FT;  ///< the number type
  typedef std::array<FT, 2> Vector; ///< a vector in the plane

  Vector constant;
  std::vector<Vector> shifts; ///< one for each region

  /// Returns whether it is the zero vector at every instance whatever the regions are.
  bool is_zero() const {
    for (const Vector& v : shifts)
      if (v[0] != FT(0) || v[1] != FT(0)) return false;
    return constant[0] == FT(0) && constant[1] == FT(0);
  }

  /// Returns the vector where the regions have these scalars. \f$ O(r) \f$ for `r` regions
  Vector operator()(const std::vector<FT>& scalars) const {
    Vector v = constant;
    for (std::size_t r = 0; r < shifts.size(); ++r)
      if (scalars[r] != FT(0))
        for (std::size_t c = 0; c < 2; ++c) v[c] += scalars[r] * shifts[r][c];
    return v;
  }
};

/// A join: the sides that lead to it and away from it, in the same regions.
struct Variable_join {
  typedef Variable_vector::FT FT; ///< the number type

  Variable_vector incoming, outgoing;

  /// Returns \f$ a \times b \f$ and \f$ a \cdot b \f$ of the incoming and the outgoing side where
  /// the regions have these scalars. Both are zero where a side has no length.
  std::pair<FT, FT> products(const std::vector<FT>& scalars) const {
    const Variable_vector::Vector a = incoming(scalars), b = outgoing(scalars);
    return {FT(a[0] * b[1] - a[1] * b[0]), FT(a[0] * b[0] + a[1] * b[1])};
  }
};

/// Decides whether a join is a corner at an instance, which is given by the scalars of the regions;
/// empty when a side has no length there. The decision is exact.
inline std::optional<bool> is_corner(const Variable_join& join, const std::vector<Variable_join::FT>& scalars,
                                     const Corner_threshold& bound) {
  const std::pair<Variable_join::FT, Variable_join::FT> products = join.products(scalars);
  if (products.first == 0 && products.second == 0) return std::nullopt;
  return bound.is_exceeded(products.first, products.second);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H
