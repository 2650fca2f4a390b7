// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H

#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/number_utils.h>

#include <mpfr.h>
#include <ostream>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A guaranteed enclosure of a real number by two floating-point numbers. For numbers that are neither tiny nor huge the
/// functions below give enclosures of at most four units in the last place.
struct Enclosure {
  double lower; ///< not larger than the number; finite
  double upper; ///< not less than the number; infinite when the number is larger than all floating-point numbers

  friend bool operator==(const Enclosure& x, const Enclosure& y) { return x.lower == y.lower && x.upper == y.upper; }
  friend bool operator!=(const Enclosure& x, const Enclosure& y) { return !(x == y); }

  /// Writes `[lower, upper]`, or the number when both are the same.
  friend std::ostream& operator<<(std::ostream& os, const Enclosure& x) {
    if (x.lower == x.upper) return os << x.lower;
    return os << '[' << x.lower << ", " << x.upper << ']';
  }
};

namespace internal {

// A number of MPFR, with enough digits that its rounding does not show in a double.
class Mpfr_number {
  mpfr_t x_;

public:
  explicit Mpfr_number(double x = 0) {
    mpfr_init2(x_, 128);
    mpfr_set_d(x_, x, MPFR_RNDN); // exact
  }
  Mpfr_number(const Mpfr_number&) = delete;
  Mpfr_number& operator=(const Mpfr_number&) = delete;
  ~Mpfr_number() { mpfr_clear(x_); }

  mpfr_ptr get() { return x_; }
  double below() const { return mpfr_get_d(x_, MPFR_RNDD); }
  double above() const { return mpfr_get_d(x_, MPFR_RNDU); }
};

// The closest interval of a number, also of one that is evaluated on demand.
template <class FT> std::pair<double, double> exact_interval(const FT& x) {
  return CGAL::to_interval(Exact_number<FT>::of(x));
}

// arctan(sqrt(x)), or pi/2 - that for the complement, or pi - that when obtuse; rounded in one direction.
inline void arctangent_of_root(Mpfr_number& x, bool complement, bool obtuse, mpfr_rnd_t direction) {
  const mpfr_rnd_t opposite = direction == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
  const mpfr_rnd_t inner = complement != obtuse ? opposite : direction; // each subtraction turns the direction
  mpfr_sqrt(x.get(), x.get(), inner);
  mpfr_atan(x.get(), x.get(), inner);
  if (!complement && !obtuse) return;
  // pi/2 - x, pi - x, and pi - (pi/2 - x) = pi/2 + x
  Mpfr_number angle;
  mpfr_const_pi(angle.get(), direction);
  if (complement) mpfr_div_2ui(angle.get(), angle.get(), 1, direction);
  if (complement != obtuse)
    mpfr_sub(x.get(), angle.get(), x.get(), direction);
  else
    mpfr_add(x.get(), angle.get(), x.get(), direction);
}

// The angle in [0, pi] whose squared sine and cosine have this ratio; not both are zero.
template <class FT> Enclosure angle_of_squares(const FT& sine_squared, const FT& cosine_squared, bool obtuse) {
  const bool complement = cosine_squared < sine_squared;
  // the squared tangent, or cotangent, at most 1
  const std::pair<double, double> i =
      exact_interval(complement ? FT(cosine_squared / sine_squared) : FT(sine_squared / cosine_squared));
  Mpfr_number x(i.first < 0 ? 0 : i.first), y(i.second);
  const bool falling = complement != obtuse;
  arctangent_of_root(x, complement, obtuse, falling ? MPFR_RNDU : MPFR_RNDD);
  arctangent_of_root(y, complement, obtuse, falling ? MPFR_RNDD : MPFR_RNDU);
  if (falling) return {y.below(), x.above()};
  return {x.below(), y.above()};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// An enclosure of a number. \tparam FT a number type with `CGAL::to_interval()`
template <class FT> Enclosure enclosure(const FT& x) {
  const std::pair<double, double> i = internal::exact_interval(x);
  return {i.first, i.second};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// An enclosure of \f$ \sqrt{x} \f$. \pre `x >= 0` \tparam FT a number type with `CGAL::to_interval()`
template <class FT> Enclosure root_enclosure(const FT& x) {
  const std::pair<double, double> i = internal::exact_interval(x);
  internal::Mpfr_number low(i.first < 0 ? 0 : i.first), high(i.second);
  mpfr_sqrt(low.get(), low.get(), MPFR_RNDD);
  mpfr_sqrt(high.get(), high.get(), MPFR_RNDU);
  return {low.below(), high.above()};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// An enclosure, in radians, of the angle in \f$ [0, \pi] \f$ whose cosine has the sign of `cosine` and whose sine and cosine
/// have the squares \f$ s / (s + c^2) \f$ and \f$ c^2 / (s + c^2) \f$ with `s = sine_squared` and `c = cosine`. It is exact
/// for parallel vectors of one direction.
/// \pre `sine_squared >= 0`, and not both are zero \tparam FT a field number type with `CGAL::to_interval()`
template <class FT> Enclosure angle_enclosure(const FT& sine_squared, const FT& cosine) {
  return internal::angle_of_squares(sine_squared, FT(cosine * cosine), cosine < FT(0));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H
