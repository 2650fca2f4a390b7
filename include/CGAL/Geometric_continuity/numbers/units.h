// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_UNITS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_UNITS_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cmath>

/// \file units.h
/// Guaranteed enclosures in the units of designers, and of tolerances that are given in them: degrees and percent. See also
/// `in_degrees()`.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// pi/180 = 0.017453292519943295769236... lies between these numbers.
struct Radians_of_degree {
  Exact_rational lower, upper;
  Radians_of_degree() {
    const Exact_rational billion(1e9), unit = Exact_rational(1) / (Exact_rational(1e20)); // both are exact
    lower = (Exact_rational(1745329251.) * billion + Exact_rational(994329576.)) * unit;
    upper = lower + unit;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure, in radians, of an angle of so many degrees.
inline Enclosure in_radians(const Exact_rational& degrees) {
  const internal::Radians_of_degree one;
  const bool negative = degrees < 0;
  return {enclosure(Exact_rational(degrees * (negative ? one.upper : one.lower))).lower,
          enclosure(Exact_rational(degrees * (negative ? one.lower : one.upper))).upper};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure of a ratio in percent.
/// \throws Error `not_finite` when the lower bound is infinite or not a number
inline Enclosure in_percent(const Enclosure& ratio) {
  const auto times_100 = [](double x) { return enclosure(Exact_rational(Exact_rational(x) * Exact_rational(100))); };
  if (!std::isfinite(ratio.lower)) throw Error(Error_code::not_finite, "in_percent");
  return {times_100(ratio.lower).lower, std::isfinite(ratio.upper) ? times_100(ratio.upper).upper : ratio.upper};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_UNITS_H
