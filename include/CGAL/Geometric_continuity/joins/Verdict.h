// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_VERDICT_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_VERDICT_H

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
/// Returns whether the number in an enclosure is at most `bound`.
inline Verdict at_most(const Enclosure& x, double bound) {
  return x.upper <= bound ? Verdict::proved : bound < x.lower ? Verdict::refuted : Verdict::undecided;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_VERDICT_H
