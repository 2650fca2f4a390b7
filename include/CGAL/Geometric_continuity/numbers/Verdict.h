// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_VERDICT_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_VERDICT_H

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The answer to a question about a real number of which an enclosure is known.
enum class Verdict {
  proved,    ///< true
  refuted,   ///< false
  undecided, ///< the enclosure does not tell
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns `proved`, `refuted` or `undecided`.
inline std::string to_string(Verdict verdict) {
  return verdict == Verdict::proved ? "proved" : verdict == Verdict::refuted ? "refuted" : "undecided";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes `to_string(verdict)`.
inline std::ostream& operator<<(std::ostream& os, Verdict verdict) { return os << to_string(verdict); }

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether both are true: refuted if one of them is, proved if both are.
inline Verdict operator&&(Verdict x, Verdict y) {
  if (x == Verdict::refuted || y == Verdict::refuted) return Verdict::refuted;
  return x == Verdict::proved && y == Verdict::proved ? Verdict::proved : Verdict::undecided;
}

/// \ingroup PkgGeometricContinuityContinuity
/// A bound of a tolerance: a floating-point number, or a real number of which an enclosure is known, such as a decimal or an
/// angle that is given in degrees, see `in_radians()`.
class Bound {
  Enclosure value_;

public:
  /// Makes a bound of a number, 0 if none is given.
  Bound(double value = 0) : value_{value, value} {}
  /// Makes a bound of the number in an enclosure.
  Bound(const Enclosure& value) : value_(value) {}

  /// Returns a number that is not larger than the bound.
  double lower() const { return value_.lower; }
  /// Returns a number that is not less than the bound.
  double upper() const { return value_.upper; }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the number in an enclosure is at most `bound`. Neither answer can be wrong: the enclosure is compared with the
/// lower end of the bound to prove it, and with the upper end to refute it.
inline Verdict at_most(const Enclosure& x, const Bound& bound) {
  return x.upper <= bound.lower() ? Verdict::proved : bound.upper() < x.lower ? Verdict::refuted : Verdict::undecided;
}

namespace internal {

// Refuses a tolerance that is negative or not a number.
inline void check_bound(const Bound& bound) {
  if (!(0 <= bound.lower() && bound.lower() <= bound.upper()))
    throw Error(Error_code::unreachable_tolerance, "order_within: " + std::to_string(bound.lower()));
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_VERDICT_H
