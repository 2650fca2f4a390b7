// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_QUARTER_TURNS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_QUARTER_TURNS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// An angle in degrees as a number of quarter turns, whose sines and cosines are rational, and the rest.
template <class FT> struct Quarter_turns {
  int count; ///< the quarter turns, from 0 to 3: full turns are left out
  FT rest;   ///< the exact rest in degrees, from -45 to 45 up to rounding

  /// The largest angle that is taken, in degrees.
  static constexpr int max_degrees = 1000000000;

  /// Returns whether an angle of so many degrees is not too large.
  static bool is_allowed(const FT& degrees) { return !(FT(max_degrees) < degrees) && !(degrees < FT(-max_degrees)); }

  /// Splits an angle in degrees.
  /// \throws Error `parameter_outside_domain` unless `is_allowed(degrees)`
  explicit Quarter_turns(const FT& degrees) {
    if (!is_allowed(degrees)) throw Error(Error_code::parameter_outside_domain, "angle beyond 10^9 degrees");
    const int turns = static_cast<int>(std::lround(CGAL::to_double(degrees) / 90));
    rest = FT(degrees - FT(90) * FT(turns));
    count = (turns % 4 + 4) % 4;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_QUARTER_TURNS_H
