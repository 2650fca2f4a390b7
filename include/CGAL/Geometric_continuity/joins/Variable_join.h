// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_VARIABLE_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_VARIABLE_JOIN_H

#include <CGAL/Geometric_continuity/joins/Kink_bound.h>
#include <CGAL/Geometric_continuity/joins/Variation_region.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Variable_join.h
/// Joins in the plane that move with the axes of a family of shapes, as the nodes of a variable font do.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The vector along a handle or a line at a join: `constant` and the sum of `shifts[r]` times the scalar of region `r`.
struct Variable_leg {
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

/// \ingroup PkgGeometricContinuityContinuity
/// A join: the legs that lead to it and away from it, in the same regions.
struct Variable_join {
  typedef Variable_leg::FT FT; ///< the number type

  Variable_leg incoming, outgoing;

  /// Returns \f$ a \times b \f$ and \f$ a \cdot b \f$ of the incoming and the outgoing leg where the regions have these scalars. Both are zero
  /// where a leg has no length.
  std::pair<FT, FT> products(const std::vector<FT>& scalars) const {
    const Variable_leg::Vector a = incoming(scalars), b = outgoing(scalars);
    return {FT(a[0] * b[1] - a[1] * b[0]), FT(a[0] * b[0] + a[1] * b[1])};
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the scalars of regions at an instance.
inline std::vector<Variation_region::FT> region_scalars(const std::vector<Variation_region>& regions,
                                                        const std::vector<Variation_region::FT>& instance) {
  std::vector<Variation_region::FT> scalars;
  scalars.reserve(regions.size());
  for (const Variation_region& region : regions) scalars.push_back(region.scalar(instance));
  return scalars;
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides whether a join is a corner at an instance, which is given by the scalars of the regions; empty when a leg has no
/// length there. The decision is exact.
inline std::optional<bool> is_corner(const Variable_join& join, const std::vector<Variable_join::FT>& scalars,
                                     const Kink_bound& bound) {
  const std::pair<Variable_join::FT, Variable_join::FT> products = join.products(scalars);
  if (products.first == 0 && products.second == 0) return std::nullopt;
  return bound.is_exceeded(products.first, products.second);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_VARIABLE_JOIN_H
