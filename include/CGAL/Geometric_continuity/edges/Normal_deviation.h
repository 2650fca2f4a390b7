// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_NORMAL_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_NORMAL_DEVIATION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// A guaranteed enclosure of the largest angle \f$ \theta \in [0, \pi] \f$ between the normals of two surfaces along their
/// common edge, both turned so that \f$ \theta = 0 \f$ where the surfaces continue each other and \f$ \theta = \pi \f$ where
/// they fold back. Points where a normal vanishes are left out; limits at them count.
///
/// The angle is given without roots by its measure \f$ 1 - \cos\theta\,|\cos\theta| \f$, which grows with it from 0 over 1 for
/// a right angle to 2: it is \f$ \sin^2\theta \f$ up to the right angle and \f$ 2 - \sin^2\theta \f$ beyond. The measure is so
/// accurate that `angle()` is at most four units in the last place wide, unless the angle varies at scales near the limits
/// of floating-point numbers.
/// \tparam FT a field number type
template <class FT> struct Normal_deviation {
  FT lower; ///< the measure of an angle that occurs on the edge, or as a limit
  FT upper; ///< the measure of an angle that is not exceeded anywhere on the edge
  FT begin; ///< the sub-interval of the parameters of the edge
  FT end;   ///< where the angle is largest

  /// Returns an enclosure of the largest angle, in radians. It needs `CGAL::to_interval()` of `FT`.
  Enclosure angle() const { return {smallest_angle(), largest_angle()}; }
  /// Returns the lower bound of `angle()`.
  double smallest_angle() const { return angle(lower).lower; }
  /// Returns the upper bound of `angle()`.
  double largest_angle() const { return angle(upper).upper; }

  /// Returns an enclosure of the angle that has a measure between 0 and 2, in radians. It needs `CGAL::to_interval()`.
  /// \throws Error `parameter_outside_domain` for another measure
  static Enclosure angle(const FT& measure) {
    if (measure < FT(0) || FT(2) < measure)
      throw Error(Error_code::parameter_outside_domain, "Normal_deviation::angle: a measure is between 0 and 2");
    const bool obtuse = FT(1) < measure;
    const FT sine_squared = obtuse ? FT(FT(2) - measure) : measure;
    return internal::angle_of_squares(sine_squared, FT(FT(1) - sine_squared), obtuse);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_NORMAL_DEVIATION_H
