// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_ENDS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_ENDS_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/Double_scale.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

/// \file blend_ends.h
/// The input and the choices of a strategy for blends, and how its kind is found: everything that
/// your own model of `BlendStrategy` needs. The formulas of the control points are here, for blends
/// of degree 5 (Portnov (5), (10), (15), corrected, with \f$ \beta \f$ and \f$ \eta \f$) and of
/// degree 7, and the shape parameters for which the caller gives none: as long a tangent at both
/// ends as the chord.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The constant p/q in the field FT. With floating-point numbers it is divided by the compiler, also
// under -frounding-math.
template <class FT, int p, int q> CGAL_GC_FORCEINLINE FT fraction() {
  if constexpr (std::is_floating_point_v<FT>) {
    constexpr FT value = FT(p) / FT(q);
    return value;
  } else
    return FT(FT(p) / FT(q));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The shape parameters of a blend: its first derivatives are \f$ \beta\varphi'(1) \f$ at the start
/// and \f$ \eta\psi'(0) \f$ at the end. Both must be positive. Portnov has
/// \f$ \beta = \eta = 1 \f$.
/// \tparam FT a field number type
template <class FT> struct Shape_parameters {
  FT beta = FT(1); ///< \f$ \beta \f$, at the end of the first curve
  FT eta = FT(1);  ///< \f$ \eta \f$, at the start of the second curve

  /// Sets \f$ \beta = \eta = 1 \f$.
  Shape_parameters() = default;
  /// Takes numbers of any type from which `FT` can be made.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a
  ///   number
  Shape_parameters(internal::Convertible_number<FT> given_beta, internal::Convertible_number<FT> given_eta)
      : beta(std::move(given_beta.value)), eta(std::move(given_eta.value)) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The choices of a strategy for a quintic blend.
/// \tparam FT a field number type
template <class FT> struct Quintic_parameters {
  FT s1 = FT(0); ///< \f$ \gamma''(0) = 20 (d n_1 + s_1 u) \f$
  FT s2 = FT(0); ///< \f$ \gamma''(1) = 20 (d n_2 + s_2 v) \f$
  /// whether the strategy is undefined at the start and chose by another rule
  bool fallback_start = false;
  /// whether the strategy is undefined at the end and chose by another rule
  bool fallback_end = false;

  /// Returns these parameters with `f(s)` in the place of each scalar `s`, called in the order of
  /// the members.
  template <class To, class Function> Quintic_parameters<To> transform(const Function& f) const {
    return {f(s1), f(s2), fallback_start, fallback_end};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// The input of a quintic strategy for a blend \f$ \gamma \f$ of degree 5: all but the two scalars
/// that it chooses.
/// \tparam FT a field number type \tparam N the dimension, or 0 when it is known at run time only
template <class FT, int N> struct Quintic_ends {
  typedef Coordinate_vector<FT, N> Vector;
  typedef Quintic_parameters<FT> Parameters; ///< what the strategy chooses
  static constexpr int degree = 5;           ///< the degree of the blend
  static constexpr int order = 2;            ///< the order of the jets that are read

  Vector a1; ///< the start \f$ A_1 = \gamma(0) \f$
  Vector a2; ///< the end \f$ A_2 = \gamma(1) \f$
  Vector u;  ///< the tangent at the start, \f$ u = \gamma'(0) = \beta\varphi'(1) \f$
  Vector v;  ///< the tangent at the end, \f$ v = \gamma'(1) = \eta\psi'(0) \f$
  Vector w1; ///< the scaled second derivative \f$ \beta^2\varphi''(1) \f$
  Vector w2; ///< the scaled second derivative \f$ \eta^2\psi''(0) \f$

  /// the tangential part of `w1` in units of `u`, \f$ (w_1 \cdot u) / (u \cdot u) \f$
  FT tangential1;
  /// the tangential part of `w2` in units of `v`, \f$ (w_2 \cdot v) / (v \cdot v) \f$
  FT tangential2;

  /// Takes the six vectors. `u` and `v` must not be zero.
  CGAL_GC_FORCEINLINE Quintic_ends(const Vector& given_a1, const Vector& given_a2, const Vector& given_u,
                                   const Vector& given_v, const Vector& given_w1, const Vector& given_w2)
      : a1(given_a1), a2(given_a2), u(given_u), v(given_v), w1(given_w1), w2(given_w2),
        tangential1(dot(w1, u) / dot(u, u)), tangential2(dot(w2, v) / dot(v, v)) {}

  /// Computes the vectors from the jets at the end of \f$ \varphi \f$ and at the start of
  /// \f$ \psi \f$: `phi[j]` and `psi[j]` are the derivatives of order `j`, 0 to 2. The tangents
  /// must not be zero.
  template <class Jet>
  CGAL_GC_FORCEINLINE Quintic_ends(const Jet& phi, const Jet& psi, const Shape_parameters<FT>& shape)
      : Quintic_ends(phi[0], psi[0], shape.beta * phi[1], shape.eta * psi[1], FT(shape.beta * shape.beta) * phi[2],
                     FT(shape.eta * shape.eta) * psi[2]) {}

  /// Returns the vector `d n` of Portnov (15) at the start, without a root: \f$ w_1^\perp / 20 \f$.
  CGAL_GC_FORCEINLINE Vector dn1() const { return internal::fraction<FT, 1, 20>() * (w1 - tangential1 * u); }
  /// Returns the vector `d n` at the end: \f$ w_2^\perp / 20 \f$.
  CGAL_GC_FORCEINLINE Vector dn2() const { return internal::fraction<FT, 1, 20>() * (w2 - tangential2 * v); }

  /// Returns \f$ B_1 = A_1 + u/5 \f$. Portnov (10)
  CGAL_GC_FORCEINLINE Vector b1() const { return a1 + internal::fraction<FT, 1, 5>() * u; }
  /// Returns \f$ B_2 = A_2 - v/5 \f$. Portnov (10)
  CGAL_GC_FORCEINLINE Vector b2() const { return a2 - internal::fraction<FT, 1, 5>() * v; }

  /// Returns \f$ C_1 = A_1 + (2/5 + s_1) u + d n_1 \f$.
  CGAL_GC_FORCEINLINE Vector c1(const FT& s1) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return a1 + FT(internal::fraction<FT, 2, 5>() + s1 - c * tangential1) * u + c * w1;
  }
  /// Returns \f$ C_2 = A_2 - (2/5 - s_2) v + d n_2 \f$.
  CGAL_GC_FORCEINLINE Vector c2(const FT& s2) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return a2 - FT(internal::fraction<FT, 2, 5>() - s2 + c * tangential2) * v + c * w2;
  }

  /// Returns the control points between the first and the last, \f$ B_1, C_1, C_2, B_2 \f$, for
  /// what the strategy chose.
  std::array<Vector, 4> inner_points(const Parameters& p) const { return {b1(), c1(p.s1), c2(p.s2), b2()}; }
  /// Returns the control points \f$ A_1, B_1, C_1, C_2, B_2, A_2 \f$ for what the strategy chose.
  CGAL_GC_FORCEINLINE std::array<Vector, 6> control_points(const Parameters& p) const {
    return {a1, b1(), c1(p.s1), c2(p.s2), b2(), a2};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// The free scalars at one end of a septic blend: \f$ \gamma'' = \beta^2 d_2 + \beta_2 d_1 \f$,
/// \f$ \gamma''' = \beta^3 d_3 + \mu d_2 + \beta_3 d_1 \f$. The join is \f$ F^3 \f$ for all values
/// and \f$ G^3 \f$ if and only if \f$ \mu = 3\beta\beta_2 \f$ (or the curvature is zero).
/// \tparam FT a field number type
template <class FT> struct Septic_end_parameters {
  FT beta2 = FT(0); ///< \f$ \beta_2 \f$
  FT mu = FT(0);    ///< \f$ \mu \f$
  FT beta3 = FT(0); ///< \f$ \beta_3 \f$

  /// Sets all to 0.
  Septic_end_parameters() = default;
  /// Takes numbers of any type from which `FT` can be made.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a
  ///   number
  Septic_end_parameters(internal::Convertible_number<FT> given_beta2, internal::Convertible_number<FT> given_mu,
                        internal::Convertible_number<FT> given_beta3)
      : beta2(std::move(given_beta2.value)), mu(std::move(given_mu.value)), beta3(std::move(given_beta3.value)) {}

  /// Returns whether all scalars are equal.
  friend bool operator==(const Septic_end_parameters& p, const Septic_end_parameters& q) {
    return p.beta2 == q.beta2 && p.mu == q.mu && p.beta3 == q.beta3;
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// The choices of a strategy for a septic blend.
/// \tparam FT a field number type
template <class FT> struct Septic_parameters {
  Septic_end_parameters<FT> start; ///< the scalars at the start
  Septic_end_parameters<FT> end;   ///< the scalars at the end
  /// whether the strategy is undefined at the start and chose by another rule
  bool fallback_start = false;
  /// whether the strategy is undefined at the end and chose by another rule
  bool fallback_end = false;

  /// Returns these parameters with `f(s)` in the place of each scalar `s`, called in the order of
  /// the members.
  template <class To, class Function> Septic_parameters<To> transform(const Function& f) const {
    return {Septic_end_parameters<To>{f(start.beta2), f(start.mu), f(start.beta3)},
            Septic_end_parameters<To>{f(end.beta2), f(end.mu), f(end.beta3)}, fallback_start, fallback_end};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// One end of a septic blend: the point, the derivatives of the given curve, and the shape
/// parameter.
/// \tparam FT a field number type \tparam N the dimension, or 0 when it is known at run time only
template <class FT, int N> struct Septic_end {
  typedef Coordinate_vector<FT, N> Vector;

  Vector x;      ///< the end point
  Vector d1;     ///< the first derivative of the given curve, not zero
  Vector d2;     ///< the second derivative of the given curve
  Vector d3;     ///< the third derivative of the given curve
  FT beta;       ///< the shape parameter \f$ \beta \f$ or \f$ \eta \f$ of the join
  int direction; ///< 1 at the start of the blend, -1 at its end

  /// Returns \f$ \gamma' \f$.
  Vector first() const { return beta * d1; }
  /// Returns \f$ \gamma'' \f$.
  Vector second(const Septic_end_parameters<FT>& p) const { return FT(beta * beta) * d2 + p.beta2 * d1; }
  /// Returns \f$ \gamma''' \f$.
  Vector third(const Septic_end_parameters<FT>& p) const {
    return FT(beta * beta * beta) * d3 + p.mu * d2 + p.beta3 * d1;
  }

  /// Returns the three control points next to the end point \f$ b_0 \f$, from there inwards:
  /// \f$ b_1 = b_0 + \gamma'/7 \f$, \f$ b_2 = b_0 + 2\gamma'/7 + \gamma''/42 \f$,
  /// \f$ b_3 = b_0 + 3\gamma'/7 + \gamma''/14 + \gamma'''/210 \f$; at the end of the blend the odd
  /// derivatives change sign.
  std::array<Vector, 3> inner_points(const Septic_end_parameters<FT>& p) const {
    const Vector g1 = FT(direction) * first(), g2 = second(p), g3 = FT(direction) * third(p);
    return {x + g1 / FT(7), x + FT(2) * g1 / FT(7) + g2 / FT(42), x + FT(3) * g1 / FT(7) + g2 / FT(14) + g3 / FT(210)};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// The input of a septic strategy for a blend \f$ \gamma \f$ of degree 7: all but the three scalars
/// at each end.
/// \tparam FT a field number type \tparam N the dimension, or 0 when it is known at run time only
template <class FT, int N> struct Septic_ends {
  typedef Coordinate_vector<FT, N> Vector;
  typedef Septic_parameters<FT> Parameters; ///< what the strategy chooses
  static constexpr int degree = 7;          ///< the degree of the blend
  static constexpr int order = 3;           ///< the order of the jets that are read

  Septic_end<FT, N> start; ///< the start of the blend, at the end of \f$ \varphi \f$
  Septic_end<FT, N> end;   ///< the end of the blend, at the start of \f$ \psi \f$

  /// Takes the jets at the end of \f$ \varphi \f$ and at the start of \f$ \psi \f$: `phi[j]` and
  /// `psi[j]` are the derivatives of order `j`, 0 to 3. The tangents must not be zero.
  template <class Jet>
  Septic_ends(const Jet& phi, const Jet& psi, const Shape_parameters<FT>& shape)
      : start{phi[0], phi[1], phi[2], phi[3], shape.beta, 1}, end{psi[0], psi[1], psi[2], psi[3], shape.eta, -1} {}

  /// Returns the six control points between the first and the last for what the strategy chose.
  std::array<Vector, 6> inner_points(const Parameters& p) const {
    const std::array<Vector, 3> s = start.inner_points(p.start), e = end.inner_points(p.end);
    return {s[0], s[1], s[2], e[2], e[1], e[0]};
  }
  /// Returns the eight control points for what the strategy chose.
  std::array<Vector, 8> control_points(const Parameters& p) const {
    const std::array<Vector, 6> b = inner_points(p);
    return {start.x, b[0], b[1], b[2], b[3], b[4], b[5], end.x};
  }
};

namespace internal {

template <class Strategy, class = void> struct Works_in_every_field : std::false_type {};
template <class Strategy>
struct Works_in_every_field<Strategy, std::void_t<typename Strategy::Works_in_every_field>>
    : std::bool_constant<Strategy::Works_in_every_field::value> {};

} // namespace internal

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that may be called in other fields than that of the traits class, which
/// makes exact blends faster: the value of `Strategy::Works_in_every_field`, see `BlendStrategy`;
/// `false` when there is no such type. It may be specialised for a strategy that cannot be changed.
template <class Strategy> constexpr bool works_in_every_field_v = internal::Works_in_every_field<Strategy>::value;

/// \ingroup PkgGeometricContinuityStrategies
/// True for a quintic strategy, which can be called with the `Quintic_ends` of a traits class. It
/// then makes blends of degree 5 from jets of order 2, even if it could be called with
/// `Septic_ends` too.
template <class Strategy, class Traits>
constexpr bool is_quintic_strategy_v =
    std::is_invocable_v<const Strategy&, const Quintic_ends<typename Traits::FT, dimension_v<Traits>>&>;

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that can be called with the `Septic_ends` of a traits class. If it is not
/// quintic, it makes blends of degree 7 from jets of order 3.
template <class Strategy, class Traits>
constexpr bool is_septic_strategy_v =
    std::is_invocable_v<const Strategy&, const Septic_ends<typename Traits::FT, dimension_v<Traits>>&>;

namespace internal {

// A ratio of lengths with few digits, so that it is the same on every kernel and exact numbers stay
// short.
constexpr int ratio_digits = 8;
constexpr int largest_ratio_exponent = 100; // the ratio lies between 2^-100 and 2^100

// The number i of the short numbers in increasing order: those from 2^e to 2^(e+1) have the numbers
// 128 e to 128 e + 127.
inline double short_ratio(int i) {
  constexpr int steps = 1 << (ratio_digits - 1);
  const int e = i >= 0 ? i / steps : -((steps - 1 - i) / steps);
  return std::ldexp(static_cast<double>(steps + (i - e * steps)), e - (ratio_digits - 1));
}

// The short number nearest to a number, of which `is_below(m)` says whether it is less than m, or
// of two the larger one; 1 when there is none below. By bisection.
template <class Function> double nearest_short_ratio(const Function& is_below) {
  constexpr int most = largest_ratio_exponent << (ratio_digits - 1);
  // whether the number is not below the middle of the short numbers i - 1 and i, which is exact
  const auto reaches = [&](int i) { return !is_below((short_ratio(i - 1) + short_ratio(i)) / 2); };
  if (!reaches(-most)) return 1;
  int low = -most, high = most + 1; // reaches(low), and not high
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (reaches(middle) ? low : high) = middle;
  }
  return short_ratio(low);
}

// Finds the ratio |a2 - a1| / |d| by exact numbers of any size, from the sign of |a2 - a1|^2 -
// m^2 |d|^2. Coordinates of floating-point type are integers in one unit, and m is a fraction of
// such integers.
template <class FT, int N>
double exact_chord_ratio(const Coordinate_vector<FT, N>& a1, const Coordinate_vector<FT, N>& a2,
                         const Coordinate_vector<FT, N>& d) {
  if constexpr (std::is_floating_point_v<FT>) {
    typedef Double_scale::Ring Ring;
    Double_scale scale;
    for (const Coordinate_vector<FT, N>* v : {&a1, &a2, &d})
      for (const FT& x : *v) scale.include(Double_scale::number(x));
    const auto numerator = [&](const FT& x) { return scale.numerator(Double_scale::number(x)); };
    Ring chord(0), tangent(0);
    for (int i = 0; i < d.dimension(); ++i) {
      const Ring x(numerator(a2[i]) - numerator(a1[i])), y(numerator(d[i]));
      chord += Ring(x * x);
      tangent += Ring(y * y);
    }
    return nearest_short_ratio([&](double m) {
      Double_scale fraction;
      for (const double x : {m, 1.}) fraction.include(Double_scale::number(x));
      const Ring p(fraction.numerator(Double_scale::number(m))), q(fraction.numerator(Double_scale::number(1.)));
      return Ring(Ring(q * q) * chord) < Ring(Ring(p * p) * tangent);
    });
  } else {
    const Coordinate_vector<FT, N> difference = a2 - a1;
    const FT chord = dot(difference, difference), tangent = dot(d, d);
    return nearest_short_ratio([&](double m) {
      const FT x = short_number_in<FT>(m);
      return chord < FT(x * x) * tangent;
    });
  }
}

// The ratio |a2 - a1| / |d| of a chord and a tangent as a short number, decided exactly: in
// floating-point numbers with a bound of the error, and in exact numbers when that leaves two
// choices.
template <class FT, int N> class Chord_ratio {
  typedef Coordinate_vector<FT, N> Vector;

  const Vector &a1_, &a2_;
  // of the chord: the square of the length, and a bound for the error of the length
  double square_ = 0, error_ = 0;

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
    // the sums have far fewer than 2^10 terms
    constexpr double least = 0x1p-900, largest = 0x1p900, rounding = 0x1p-40;
    if (least < square_ && square_ < largest && least < square && square < largest) {
      const double chord = std::sqrt(square_), tangent = std::sqrt(square), ratio = chord / tangent,
                   doubt = 2 * (error_ / chord + error / tangent) + rounding;
      // unreachable: differences are rounded once, which leaves little doubt
      // equivalent [< -> <=, 2]: a limit beyond which the ratio is computed exactly
      if (doubt < 0.125 && std::abs(std::ilogb(ratio)) < largest_ratio_exponent) {
        const double low = short_double<ratio_digits>(ratio * (1 - doubt)),
                     high = short_double<ratio_digits>(ratio * (1 + doubt));
        if (low == high) return low;
      }
    }
    return exact_chord_ratio(a1_, a2_, d);
  }
};

template <class FT, int N>
Shape_parameters<FT> automatic_shape(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi) {
  const Chord_ratio<FT, N> ratio(phi[0], psi[0]);
  return {short_number_in<FT>(ratio(phi[1])), short_number_in<FT>(ratio(psi[1]))};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape parameters of a blend from the end of a curve, with the jet `phi`, to the
/// start of another one, with the jet `psi`, that make its tangents at both ends as long as its
/// chord: \f$ \beta = |\psi(0)-\varphi(1)| / |\varphi'(1)| \f$ and
/// \f$ \eta = |\psi(0)-\varphi(1)| / |\psi'(0)| \f$, each rounded to eight binary digits. `blend()`
/// takes them when it is given none.
///
/// The rounding is decided exactly, so that equal jets have the same shape parameters on every
/// kernel. Scaling both curves, moving and turning them, and exchanging and reversing them leaves
/// the shape as it is. The ratio lies between \f$ 2^{-100} \f$ and \f$ 2^{100} \f$; where the chord
/// is zero or shorter, the parameter is 1. It is a formula and no optimum: other shape parameters,
/// `{1, 1}` as well, can have the lower `fairness()`; `Fair` looks for them.
///
/// \throws Error `dimension_mismatch` when the dimensions differ, `jet_order_too_low` without a
///   first derivative
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

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_ENDS_H
