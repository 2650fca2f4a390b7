// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_AUTOMATIC_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_AUTOMATIC_SHAPE_H

#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/MP_Float.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>
#include <utility>

/// \file automatic_shape.h
/// The shape parameters of a blend for which the caller gives none: as long a tangent at both ends as the chord.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// A ratio of lengths with few digits, so that it is the same on every kernel and exact numbers stay short.
constexpr int ratio_digits = 8;
constexpr int largest_ratio_exponent = 100; // the ratio lies between 2^-100 and 2^100

// The number i of the short numbers in increasing order: those from 2^e to 2^(e+1) have the numbers 128 e to 128 e + 127.
inline double short_ratio(int i) {
  constexpr int steps = 1 << (ratio_digits - 1);
  const int e = i >= 0 ? i / steps : -((steps - 1 - i) / steps);
  return std::ldexp(static_cast<double>(steps + (i - e * steps)), e - (ratio_digits - 1));
}

// The short number nearest to the square root of x/y, or of two the larger one; 1 when there is none below. For exact numbers
// of any size: by bisection.
template <class ET> double short_root_of_ratio(const ET& x, const ET& y) {
  constexpr int most = largest_ratio_exponent << (ratio_digits - 1);
  // whether the root is not below the middle of the short numbers i - 1 and i
  const auto reaches = [&](int i) {
    const double middle = (short_ratio(i - 1) + short_ratio(i)) / 2; // exact
    const ET m = short_number_in<ET>(middle);
    return !(x < ET(m * m) * y);
  };
  if (!reaches(-most)) return 1;
  int low = -most, high = most + 1; // reaches(low), and not high
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (reaches(middle) ? low : high) = middle;
  }
  return short_ratio(low);
}

template <class ET, class FT, int N>
ET exact_squared_distance(const Coordinate_vector<FT, N>& a, const Coordinate_vector<FT, N>& b) {
  ET sum(0);
  for (int i = 0; i < a.dimension(); ++i) {
    const ET difference = to_field<ET>(b[i]) - to_field<ET>(a[i]);
    sum += difference * difference;
  }
  return sum;
}

// The ratio |a2 - a1| / |d| of a chord and a tangent as a short number, decided exactly: in floating-point numbers with a
// bound of the error, and in exact numbers when that leaves two choices.
template <class FT, int N> class Chord_ratio {
  typedef std::conditional_t<std::is_floating_point_v<FT>, MP_Float, FT> ET; // no quotients are needed
  typedef Coordinate_vector<FT, N> Vector;

  const Vector &a1_, &a2_;
  double square_ = 0, error_ = 0; // of the chord: the square of the length, and a bound for the error of the length

  // A number as a double, and a bound for the error that this makes.
  static std::pair<double, double> rounded(const FT& x) {
    if constexpr (std::is_floating_point_v<FT>)
      return {static_cast<double>(x), 0};
    else if constexpr (!has_interval_v<FT>)
      return {0, 0}; // nothing is known
    else {
      const std::pair<double, double> i = CGAL::to_interval(x);
      return {i.first, i.second - i.first};
    }
  }

public:
  Chord_ratio(const Vector& a1, const Vector& a2) : a1_(a1), a2_(a2) {
    for (int i = 0; i < a1.dimension(); ++i) {
      const std::pair<double, double> x = rounded(a1[i]), y = rounded(a2[i]);
      const double difference = y.first - x.first;
      square_ += difference * difference;
      error_ += x.second + y.second;
    }
  }

  double operator()(const Vector& d) const {
    double square = 0, error = 0;
    for (const FT& x : d) {
      const std::pair<double, double> y = rounded(x);
      square += y.first * y.first;
      error += y.second;
    }
    constexpr double least = 0x1p-900, largest = 0x1p900, rounding = 0x1p-40; // the sums have far fewer than 2^10 terms
    if (least < square_ && square_ < largest && least < square && square < largest) {
      const double chord = std::sqrt(square_), tangent = std::sqrt(square), ratio = chord / tangent,
                   doubt = 2 * (error_ / chord + error / tangent) + rounding;
      if (doubt < 0.125 && std::abs(std::ilogb(ratio)) < largest_ratio_exponent) {
        const double low = short_double<ratio_digits>(ratio * (1 - doubt)),
                     high = short_double<ratio_digits>(ratio * (1 + doubt));
        if (low == high) return low;
      }
    }
    return short_root_of_ratio<ET>(exact_squared_distance<ET>(a1_, a2_),
                                   exact_squared_distance<ET>(Vector(d.dimension()), d));
  }
};

template <class FT, int N>
Shape_parameters<FT> automatic_shape(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi) {
  const Chord_ratio<FT, N> ratio(phi[0], psi[0]);
  return {short_number_in<FT>(ratio(phi[1])), short_number_in<FT>(ratio(psi[1]))};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape parameters of a blend from the end of a curve, with the jet `phi`, to the start of another one, with the jet
/// `psi`, that make its tangents at both ends as long as its chord: \f$ \beta = |\psi(0)-\varphi(1)| / |\varphi'(1)| \f$ and
/// \f$ \eta = |\psi(0)-\varphi(1)| / |\psi'(0)| \f$, each rounded to eight binary digits. `blend()` takes them when it is
/// given none.
///
/// The rounding is decided exactly, so that equal jets have the same shape parameters on every kernel. Scaling both curves,
/// moving and turning them, and exchanging and reversing them leaves the shape as it is. The ratio lies between \f$ 2^{-100} \f$ and
/// \f$ 2^{100} \f$; where the chord is zero or shorter, the parameter is 1.
///
/// \throws Error `dimension_mismatch` when the dimensions differ, `jet_order_too_low` without a first derivative
/// \throws Error `zero_tangent` when a first derivative is zero
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class Traits>
Shape_parameters<typename Traits::FT> automatic_shape(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi) {
  if (phi.dimension() != psi.dimension()) throw Error(Error_code::dimension_mismatch, "automatic_shape");
  if (phi.order() < 1 || psi.order() < 1) throw Error(Error_code::jet_order_too_low, "automatic_shape");
  if (is_zero(phi[1])) throw Error(Error_code::zero_tangent, "automatic_shape: end of the first curve");
  if (is_zero(psi[1])) throw Error(Error_code::zero_tangent, "automatic_shape: start of the second curve");
  return internal::automatic_shape<typename Traits::FT, dimension_v<Traits>>(phi, psi);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_AUTOMATIC_SHAPE_H
