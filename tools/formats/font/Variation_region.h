// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_REGION_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_REGION_H

#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <cstddef>
#include <utility>
#include <vector>

/// The axes of a family of shapes, and the parts of the space of its instances in which points
/// move. OpenType specification, "Algorithm for interpolation of instance values".

namespace CGAL {
namespace Geometric_continuity {

/// The values of an axis, among which 0 is the default. They are taken as they are, with all their
/// bits.
struct Variation_range {
  double lowest = -1; ///< at most 0
  double highest = 1; ///< at least 0
};

/// How a region lies along one axis: its scalar rises linearly from 0 at `start` to 1 at `peak` and
/// falls to 0 at `end`.
struct Region_axis {
  double start, peak, end;

  /// Returns whether the scalar depends on the axis: not when the peak is 0 or the three are not in
  /// order or not of one sign.
  bool counts() const { return peak != 0 && start <= peak && peak <= end && (start >= 0 || end <= 0); }
};

/// A region of the space of instances. The scalar with which it moves points is the product of
/// those along its axes, \f$ s(v) = (v - start) / (peak - start) \f$ before and
/// \f$ (end - v) / (end - peak) \f$ behind the peak, hence piecewise multi-affine.
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

  /// Returns the factor of axis `k` at `v`, by the linear function that it is on `[lower, upper]`,
  /// where that lies between successive ones of the numbers `start`, `peak` and `end`.
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

/// Returns the scalars of regions at an instance.
inline std::vector<Variation_region::FT> region_scalars(const std::vector<Variation_region>& regions,
                                                        const std::vector<Variation_region::FT>& instance) {
  std::vector<Variation_region::FT> scalars;
  scalars.reserve(regions.size());
  for (const Variation_region& region : regions) scalars.push_back(region.scalar(instance));
  return scalars;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_REGION_H
