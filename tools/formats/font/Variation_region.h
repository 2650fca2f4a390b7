// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_REGION_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_REGION_H

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <utility>
#include <vector>

/// The part of the space of all instances in which some points of a glyph move. OpenType specification, "Algorithm for
/// interpolation of instance values".

namespace CGAL {
namespace Geometric_continuity {

/// How a region lies along one axis, in units of \f$ 2^{-14} \f$ of the normalised values: the scalar rises linearly from 0
/// at `start` to 1 at `peak` and falls to 0 at `end`.
struct Region_axis {
  int start, peak, end;

  /// Returns whether the scalar depends on the axis: not when the peak is 0 or the three are not in order or not of one sign.
  bool counts() const { return peak != 0 && start <= peak && peak <= end && (start >= 0 || end <= 0); }
};

/// A region of the space of instances. The scalar with which it moves points is the product of those along its axes,
/// \f$ s(v) = (v - start) / (peak - start) \f$ before and \f$ (end - v) / (end - peak) \f$ behind the peak, hence piecewise
/// multi-affine.
class Variation_region {
public:
  typedef CGAL::Exact_rational FT; ///< the number type

  /// Constructs a region from its axes.
  explicit Variation_region(std::vector<Region_axis> axes) : axes_(std::move(axes)) {}

  /// Returns the axes.
  const std::vector<Region_axis>& axes() const { return axes_; }

  /// Returns the scalar of an instance, which is given by its normalised values, one for each axis.
  FT scalar(const std::vector<FT>& instance) const {
    FT product(1);
    for (std::size_t k = 0; k < axes_.size() && product != FT(0); ++k)
      product *= scalar(k, instance[k], instance[k], instance[k]);
    return product;
  }

  /// Returns the factor of axis `k` at `v`, by the linear function that it is on `[lower, upper]`, where that lies between
  /// successive ones of the numbers `start`, `peak` and `end`.
  FT scalar(std::size_t k, const FT& v, const FT& lower, const FT& upper) const {
    const Region_axis& axis = axes_[k];
    if (!axis.counts()) return FT(1);
    const FT start = value(axis.start), peak = value(axis.peak), end = value(axis.end);
    if (lower == peak && upper == peak) return FT(1);
    if (upper <= start || end <= lower) return FT(0);
    return upper <= peak ? FT((v - start) / (peak - start)) : FT((end - v) / (end - peak));
  }

  /// Returns a normalised value from its units.
  static FT value(int units) { return FT(static_cast<double>(units) / 0x4000); } // exact

private:
  std::vector<Region_axis> axes_;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_REGION_H
