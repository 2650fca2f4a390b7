// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_SET_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_SET_H

#include <ostream>
#include <string>

/// \file Sign_set.h
/// The signs that a function takes on an interval: one by one, and all together as a pattern.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The sign of a number. By comparisons only, which is all that the concept asks of a field.
template <class FT> int sign_of(const FT& x) { return FT(0) < x ? 1 : x < FT(0) ? -1 : 0; }

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The signs that a function takes on a closed interval.
enum class Sign_pattern {
  positive,    ///< only +
  negative,    ///< only -
  nonnegative, ///< + and 0
  nonpositive, ///< - and 0
  mixed,       ///< both + and -
  zero         ///< only 0
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the name of a pattern, as spelled in the enumeration.
inline std::string to_string(Sign_pattern pattern) {
  switch (pattern) {
  case Sign_pattern::positive: return "positive";
  case Sign_pattern::negative: return "negative";
  case Sign_pattern::nonnegative: return "nonnegative";
  case Sign_pattern::nonpositive: return "nonpositive";
  case Sign_pattern::mixed: return "mixed";
  case Sign_pattern::zero: return "zero";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Writes the name of a pattern.
inline std::ostream& operator<<(std::ostream& os, Sign_pattern pattern) { return os << to_string(pattern); }

/// \ingroup PkgGeometricContinuityAlgebra
/// A set of signs, from which a pattern is made.
class Sign_set {
  bool negative_ = false, zero_ = false, positive_ = false;

public:
  /// Adds the sign of a number: negative, zero or positive.
  void add(int sign) { (sign < 0 ? negative_ : sign > 0 ? positive_ : zero_) = true; }

  /// Adds all signs of a pattern; `Sign_pattern::mixed` counts as + and -.
  void add(Sign_pattern pattern) {
    negative_ = negative_ || pattern == Sign_pattern::negative || pattern == Sign_pattern::nonpositive ||
                pattern == Sign_pattern::mixed;
    zero_ = zero_ || pattern == Sign_pattern::zero || pattern == Sign_pattern::nonnegative ||
            pattern == Sign_pattern::nonpositive;
    positive_ = positive_ || pattern == Sign_pattern::positive || pattern == Sign_pattern::nonnegative ||
                pattern == Sign_pattern::mixed;
  }

  /// Decides whether both + and - are in the set.
  bool is_mixed() const { return negative_ && positive_; }

  /// Returns the pattern of the signs in the set. An empty set gives `Sign_pattern::zero`.
  Sign_pattern pattern() const {
    if (is_mixed()) return Sign_pattern::mixed;
    if (positive_) return zero_ ? Sign_pattern::nonnegative : Sign_pattern::positive;
    if (negative_) return zero_ ? Sign_pattern::nonpositive : Sign_pattern::negative;
    return Sign_pattern::zero;
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the pattern of the signs of two functions together, or of one function on two intervals.
inline Sign_pattern joint_pattern(Sign_pattern a, Sign_pattern b) {
  Sign_set signs;
  signs.add(a);
  signs.add(b);
  return signs.pattern();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_SET_H
