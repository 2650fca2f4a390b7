// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Variable_join.h
/// Joins in the plane that move with the axes of a family of shapes, as the nodes of a variable font do: the axes, the parts of
/// the space of the instances in which points move, and the sides of a join. OpenType specification, "Algorithm for
/// interpolation of instance values".

namespace CGAL {
namespace Geometric_continuity {

/// The values of an axis, among which 0 is the default. They are taken as they are, with all their bits.
struct Variation_range {
  double lowest = -1; ///< at most 0
  double highest = 1; ///< at least 0
};

/// How a region lies along one axis: its scalar rises linearly from 0 at `start` to 1 at `peak` and falls to 0 at `end`.
struct Region_axis {
  double start, peak, end;

  /// Returns whether the scalar depends on the axis: not when the peak is 0 or the three are not in order or not of one sign.
  bool counts() const { return peak != 0 && start <= peak && peak <= end && (start >= 0 || end <= 0); }
};

/// A region of the space of instances. The scalar with which it moves points is the product of those along its axes,
/// \f$ s(v) = (v - start) / (peak - start) \f$ before and \f$ (end - v) / (end - peak) \f$ behind the peak, hence piecewise
/// multi-affine.
class Variation_region {
public:
  typedef Exact_field<double>::type FT; ///< the number type

  /// Constructs a region from its axes.
  explicit Variation_region(std::vector<Region_axis> axes) : axes_(std::move(axes)) {}

  /// Returns the axes.
  const std::vector<Region_axis>& axes() const { return axes_; }

  /// Returns the scalar at an instance, which is given by its value on each axis, exactly.
  FT scalar(const std::vector<FT>& instance) const {
    FT product(1);
    for (std::size_t k = 0; k < axes_.size() && product != FT(0); ++k)
      product *= factor(k, instance[k], instance[k], instance[k]);
    return product;
  }

  /// Returns the factor of axis `k` at `v`, by the linear function that it is on `[lower, upper]`, where that lies between
  /// successive ones of the numbers `start`, `peak` and `end`.
  /// \tparam NT exact numbers, or intervals \tparam Bound exact numbers, or `double`
  template <class NT, class Bound> NT factor(std::size_t k, const NT& v, const Bound& lower, const Bound& upper) const {
    const Region_axis& axis = axes_[k];
    const Bound start(axis.start), peak(axis.peak), end(axis.end);
    if (!axis.counts() || (lower == peak && upper == peak)) return NT(1);
    if (upper <= start || end <= lower) return NT(0);
    return upper <= peak ? NT((v - NT(axis.start)) / (NT(axis.peak) - NT(axis.start)))
                         : NT((NT(axis.end) - v) / (NT(axis.end) - NT(axis.peak)));
  }

private:
  std::vector<Region_axis> axes_;
};

/// The vector along a handle or a line at a join: `constant` and the sum of `shifts[r]` times the scalar of region `r`.
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

  /// Returns \f$ a \times b \f$ and \f$ a \cdot b \f$ of the incoming and the outgoing side where the regions have these scalars. Both are zero
  /// where a side has no length.
  std::pair<FT, FT> products(const std::vector<FT>& scalars) const {
    const Variable_vector::Vector a = incoming(scalars), b = outgoing(scalars);
    return {FT(a[0] * b[1] - a[1] * b[0]), FT(a[0] * b[0] + a[1] * b[1])};
  }
};

/// Returns the scalars of regions at an instance.
inline std::vector<Variation_region::FT> region_scalars(const std::vector<Variation_region>& regions,
                                                        const std::vector<Variation_region::FT>& instance) {
  std::vector<Variation_region::FT> scalars;
  scalars.reserve(regions.size());
  for (const Variation_region& region : regions) scalars.push_back(region.scalar(instance));
  return scalars;
}

/// Decides whether a join is a corner at an instance, which is given by the scalars of the regions; empty when a side has no
/// length there. The decision is exact.
inline std::optional<bool> is_corner(const Variable_join& join, const std::vector<Variable_join::FT>& scalars,
                                     const Corner_threshold& bound) {
  const std::pair<Variable_join::FT, Variable_join::FT> products = join.products(scalars);
  if (products.first == 0 && products.second == 0) return std::nullopt;
  return bound.is_exceeded(products.first, products.second);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_JOIN_H
