// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_CORNER_THRESHOLD_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_CORNER_THRESHOLD_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>

/// \file Corner_threshold.h
/// The look of a join of two plane curves, and the angles that are intended corners: decided
/// exactly, for any bound in degrees.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The arc tangent of 1/k for k >= 5 in units of 2^-w. Each term 1/((2i+1) k^(2i+1)) is rounded
// downwards twice and wrong by less than 2 units, and there are less than w/4 + 1 of them that are
// not zero.
template <class Integer> Integer arc_tangent_of_inverse(int k, int w) {
  Integer power = Integer(1) << w, sum(0);
  power /= k;
  for (int i = 0; 0 < power; ++i) {
    const Integer term = power / (2 * i + 1);
    if (i % 2 == 0)
      sum += term;
    else
      sum -= term;
    power /= k * k;
  }
  return sum;
}

// cos(a) and sin(a) for the angle a of p/q degrees, 0 <= p/q < 180, in units of 2^-w, w >= 128,
// wrong by less than `error` units.
//
// Pi = 16 atan(1/5) - 4 atan(1/239), by Machin, is wrong by less than 20 (2 (w/4 + 1)) units, and a
// by one more. The error of sin(a)/a is multiplied by a < 3.2, and the product rounded: with the
// error of a that is less than 10 w + 41 + 3.2 (w + 8) + 1 < 14 w.
template <class Integer> struct Rotation_bounds {
  Integer cosine, sine;
  const int error;

  Rotation_bounds(const std::pair<Integer, Integer>& fraction, int w) : error(14 * w) {
    const auto& [p, q] = fraction;
    const Integer pi = 16 * arc_tangent_of_inverse<Integer>(5, w) - 4 * arc_tangent_of_inverse<Integer>(239, w),
                  angle = pi * p / (180 * q);
    const Cosine_and_sinc<Integer> c(Integer(angle * angle >> w), w);
    cosine = c.cosine;
    sine = c.sinc * angle >> w;
  }
};

// The numerator and the denominator of a rational number.
template <class FT> using Numerator = typename Fraction_traits<FT>::Numerator_type;
template <class FT> std::pair<Numerator<FT>, Numerator<FT>> long_fraction(const FT& x) {
  Numerator<FT> p;
  typename Fraction_traits<FT>::Denominator_type q;
  typename Fraction_traits<FT>::Decompose()(x, p, q);
  return {p, Numerator<FT>(q)};
}

// A long integer in a field, by parts that the field makes of an `int`.
template <class NT, class Integer> NT from_long_integer(const Integer& x) {
  constexpr int part = 1 << 30;
  if (x == 0) return NT(0);
  const Integer high = x / part, low = x - high * part;
  return NT(from_long_integer<NT>(high) * NT(part)) + NT(static_cast<int>(CGAL::to_double(low)));
}

// An integer of any width as an exact number, by parts that floating-point numbers have.
template <class Field, class Integer> Field from_integer(Integer x) {
  constexpr std::int64_t part = std::int64_t(1) << 50;
  if (x == 0) return Field(0);
  return Field(from_integer<Field>(x / part) * Field(static_cast<double>(part))) + Field(static_cast<double>(x % part));
}

// An integer rounded; most fit into 64 bits, for which no function is called.
template <class Integer> double rounded_integer(Integer x) {
  if constexpr (sizeof(Integer) > sizeof(std::int64_t)) {
    const std::int64_t low = static_cast<std::int64_t>(x);
    if (low == x) return static_cast<double>(low);
  }
  return static_cast<double>(x);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The largest angle between two tangents that is a *kink*; a larger angle is a *corner*, which is
/// intended.
///
/// With \f$ B \f$ for the bound and \f$ c = |a \times b| \f$, \f$ d = a \cdot b \f$ of two vectors
/// in the plane, their angle is larger than the bound if and only if
/// \f$ c \cos B - d \sin B > 0 \f$. This is decided exactly: by floating-point numbers with a bound
/// of their error, otherwise by enclosures of \f$ \cos B \f$ and \f$ \sin B \f$ whose precision is
/// doubled until they decide. They cannot where the angle is the bound. This is possible for few
/// bounds only: the tangent of \f$ 180 m/n \f$ degrees, in lowest terms, is rational for `n <= 2`
/// and `n = 4` only, and in a field with two square roots for `n <= 24` (I. Niven, *Irrational
/// Numbers*, 1956, theorem 3.11). For these \f$ (d + ic)^n \f$ is real where the angles agree.
class Corner_threshold {
public:
  /// Exact numbers.
  typedef typename Exact_field<double>::type Field;

  /// Makes the bound of this many degrees, as an exact number: 5 unless another one is given. (The
  /// `double` 0.1 is not the decimal 0.1.) With 0 every angle is larger.
  /// \throws Error `parameter_outside_domain` unless the angle is at least 0 and less than 180
  ///   degrees, `not_finite`
  explicit Corner_threshold(const internal::Convertible_number<Field>& degrees = 5) : degrees_(degrees.value) {
    if (degrees_ < Field(0) || !(degrees_ < Field(180)))
      throw Error(Error_code::parameter_outside_domain,
                  "Corner_threshold: an angle that is not between 0 and 180 degrees");
    const Rotation rotation = rotation_bounds(128);
    cosine_ = rounded(rotation.cosine);
    sine_ = rounded(rotation.sine);
  }

  /// Returns the bound in degrees.
  const Field& degrees() const { return degrees_; }

  /// Decides whether the angle of two vectors in the plane is larger than the bound, given their
  /// cross product, whose sign does not matter, and their dot product.
  /// \tparam NT an integer or floating-point type, whose numbers are taken as they are, or an exact
  ///   ordered field: the rational numbers, possibly with one or two square roots
  /// \throws Error `zero_direction` when both products are zero, `not_finite`
  template <class NT> bool is_exceeded(const NT& cross, const NT& dot) const {
    std::optional<bool> answer;
    if constexpr (std::is_integral_v<NT>)
      answer = is_exceeded(internal::rounded_integer(cross), internal::rounded_integer(dot), 0);
    else if constexpr (std::is_arithmetic_v<NT>)
      answer = is_exceeded(static_cast<double>(cross), static_cast<double>(dot), 0);
    else {
      const std::pair<double, double> c = CGAL::to_interval(cross), d = CGAL::to_interval(dot);
      answer = is_exceeded(c.first, d.first, (c.second - c.first) + (d.second - d.first));
    }
    if (answer) return *answer;
    if constexpr (std::is_integral_v<NT>)
      return is_exceeded_exactly(internal::from_integer<Field>(cross), internal::from_integer<Field>(dot));
    else if constexpr (std::is_arithmetic_v<NT>)
      return is_exceeded_exactly(internal::to_field<Field>(cross), internal::to_field<Field>(dot));
    else
      return is_exceeded_exactly(internal::Exact_number<NT>::of(cross), internal::Exact_number<NT>::of(dot));
  }

  /// Decides the same from rounded products whose errors are, in sum, at most `error`; empty where
  /// that does not tell.
  std::optional<bool> is_exceeded(double cross, double dot, double error) const {
    // The products as rounded, cosine and sine, and each operation are wrong by 2^-52, cosine and
    // sine by 2^-51: 5 * 2^-52 in sum, in every rounding mode. Below the normal numbers nothing is
    // decided.
    const double c = std::abs(cross), excess = c * cosine_ - dot * sine_;
    // equivalent [< -> <=, 1]: the excess is not zero here
    if (std::abs(excess) > 0x1p-49 * (c + std::abs(dot)) + 1.001 * error + 0x1p-900) return 0 < excess;
    return std::nullopt;
  }

private:
  typedef internal::Numerator<Field> Integer;
  typedef internal::Rotation_bounds<Integer> Rotation;

  Field degrees_;
  double cosine_, sine_; // of the bound, rounded: wrong by less than 2^-52

  Rotation rotation_bounds(int bits) const { return Rotation(internal::long_fraction(degrees_), bits); }

  // A number of at most 1 that is given in units of 2^-128.
  static double rounded(const Integer& x) {
    const Integer size = CGAL::abs(x) >> 66;
    const double y = std::ldexp(CGAL::to_double(size), -62);
    return x < 0 ? -y : y;
  }

  // The least n such that the bound is a multiple of 180/n degrees; 0 when it is larger than 24.
  int part_of_half_turn() const {
    const std::pair<Integer, Integer> f = internal::long_fraction(degrees_);
    for (int n = 2; n <= 24; ++n)
      if ((f.first * n) % (f.second * 180) == 0) return n;
    return 0;
  }

  template <class NT> bool is_exceeded_exactly(const NT& cross, const NT& dot) const {
    const NT zero(0), c = cross < zero ? NT(-cross) : cross;
    if (c == zero && dot == zero)
      throw Error(Error_code::zero_direction, "Corner_threshold: the angle of a vector of no length");
    if (c == zero) return dot < zero; // an angle of 0 or of 180 degrees
    if (degrees_ == Field(0)) return true;
    const NT size = c + (dot < zero ? NT(-dot) : dot);
    for (int bits = 128;; bits *= 2) {
      const Rotation r = rotation_bounds(bits);
      const NT excess = NT(c * internal::from_long_integer<NT>(r.cosine)) -
                        NT(dot * internal::from_long_integer<NT>(r.sine)),
               error = size * NT(r.error);
      if (error < excess) return true;
      if (excess < NT(-error)) return false;
      // of which only the bound itself is so near
      if (bits == 128 && is_part_of_half_turn(c, dot)) return false;
    }
  }

  // Returns whether the angle is a multiple of the same 180/n degrees, n <= 24, as the bound.
  template <class NT> bool is_part_of_half_turn(const NT& cross, const NT& dot) const {
    const int n = part_of_half_turn();
    NT x = dot, y = cross; // (dot + i cross)^k
    for (int k = 1; k < n; ++k) {
      const NT real = NT(x * dot) - NT(y * cross);
      y = NT(x * cross) + NT(y * dot);
      x = real;
    }
    return n != 0 && y == NT(0);
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The look of a join of two plane curves, from the roughest to the smoothest.
enum class Visual_class {
  gap,    ///< the second curve does not start where the first one ends
  corner, ///< the angle between the tangents is larger than a `Corner_threshold`
  kink,   ///< the tangents differ, by no more than the bound
  g1,     ///< one tangent, while the curvature jumps, or is not defined where a handle is retracted
  g2      ///< \f$ G^2 \f$ or more: one tangent and one curvature
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns `gap`, `corner`, `kink`, `G1` or `G2`.
inline std::string to_string(Visual_class grade) {
  // unreachable: every value has a case
  switch (grade) {
  case Visual_class::gap: return "gap";
  case Visual_class::corner: return "corner";
  case Visual_class::kink: return "kink";
  case Visual_class::g1: return "G1";
  case Visual_class::g2: return "G2";
  }
  // unreachable: every value has a case
  return "unknown";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes `to_string(grade)`.
inline std::ostream& operator<<(std::ostream& os, Visual_class grade) { return os << to_string(grade); }

/// \ingroup PkgGeometricContinuityContinuity
/// How large a kink is: guaranteed enclosures. With `a` and `b` for the handles at the node, from
/// the control point before it and to the one behind it:
struct Kink_size {
  Enclosure angle; ///< the angle between `a` and `b`, in radians, in \f$ [0, \pi] \f$
  /// By how much a handle is off, in units of the coordinates: how far the tip of one of them must
  /// move at least to make their directions equal, \f$ |a \times b| / \max(|a|, |b|) \f$; from a
  /// right angle on \f$ \min(|a|, |b|) \f$. On a grid, about one unit is rounding.
  Enclosure handle_offset;
  /// How much the eye sees: the angle times the length of the shorter handle, in units of the
  /// coordinates. Compare it to the size of what is drawn, an em or a drawing.
  Enclosure severity;

  /// Writes e.g. `angle [0.0499583, 0.0499584], handle off by 1, severity [0.999166, 0.999167]`.
  friend std::ostream& operator<<(std::ostream& os, const Kink_size& k) {
    return os << "angle " << k.angle << ", handle off by " << k.handle_offset << ", severity " << k.severity;
  }
};

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
using Kink_bound CGAL_DEPRECATED = Corner_threshold;
using Join_grade CGAL_DEPRECATED = Visual_class;
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_CORNER_THRESHOLD_H
