// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_FAIR_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_FAIR_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_minimum.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <type_traits>
#include <vector>

/// \file Fair.h
/// Strategies for blends that look as if they were drawn: the least variation of curvature among
/// all blends whose joins are of one kind. The functional is that of Moreton and Séquin,
/// \f[ E = L^3 \int_0^L \left| \left(\tfrac{dK}{ds}\right)^{\perp} \right|^2 ds,\qquad
///     \left(\tfrac{dK}{ds}\right)^{\perp} = \frac{1}{|d_1|^3}\Bigl(d_3^\perp - 3\,\tfrac{d_1\cdot d_2}{d_1\cdot d_1}\, d_2^\perp\Bigr), \f]
/// with the curvature vector `K`, the length `L` and the derivatives \f$ d_1, d_2, d_3 \f$. It
/// depends neither on the scale nor on the parameter. In the plane it is \f$ L^3\int \kappa'^2 \f$,
/// in space \f$ L^3\int \kappa'^2+\kappa^2\tau^2 \f$.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The family of blends of two jets, in floating-point numbers: moved to the origin, scaled so that
// the chord has a length near 1, and in a dimension of at most 7. None of this changes what is
// fair.

// The dimension: 2 and 3 are as they are. In other dimensions the vectors that are given, 2 order +
// 1, span the space that is needed.
template <int N, int order> constexpr int fair_dimension = N == 2 || N == 3 ? N : 2 * order + 1;

// The coordinates of vectors with respect to an orthonormal basis of the space that they span, by
// the method of Gram and Schmidt.
template <int M, int N, std::size_t n>
std::array<Coordinate_vector<double, M>, n>
orthonormal_coordinates(std::array<Coordinate_vector<double, N>, n> vectors) {
  std::array<Coordinate_vector<double, M>, n> result;
  std::vector<Coordinate_vector<double, N>> basis;
  for (std::size_t k = 0; k < n; ++k) {
    Coordinate_vector<double, N>& v = vectors[k];
    result[k] = Coordinate_vector<double, M>(M);
    const double length = std::sqrt(dot(v, v));
    for (int repetition = 0; repetition < 2; ++repetition) // once more for what rounding has left
      for (std::size_t j = 0; j < basis.size(); ++j) {
        const double c = dot(v, basis[j]);
        result[k][static_cast<int>(j)] += c;
        v -= c * basis[j];
      }
    const double rest = std::sqrt(dot(v, v));
    if (!(rest > 1e-12 * length)) continue;
    result[k][static_cast<int>(basis.size())] = rest;
    basis.push_back(v / rest);
  }
  return result;
}

// From the jets at the end of the first and at the start of the second curve, and the shape
// parameters for which a = 0.
template <Blend_kind kind, class FT, int N, class Jet>
Fair_family<kind, fair_dimension<N, Fair_end<kind, 2>::order>> fair_family(const Jet& phi, const Jet& psi, double beta,
                                                                           double eta) {
  constexpr int order = Fair_end<kind, 2>::order, M = fair_dimension<N, order>;
  const int dimension = phi[0].dimension();
  typedef Coordinate_vector<double, N> Given;
  std::array<Given, 2 * order + 1> v; // the chord, the derivatives of phi, those of psi
  v.fill(Given(dimension));
  // Returns the largest coordinate of the chord and of both tangents.
  const auto take = [&](const FT& scale) {
    double largest = 0;
    for (int i = 0; i < dimension; ++i) {
      v[0][i] = rounded_number(FT(FT(psi[0][i] - phi[0][i]) * scale));
      double power_of_beta = 1, power_of_eta = 1;
      for (int k = 1; k <= order; ++k) {
        v[k][i] = rounded_number(FT(phi[k][i] * scale)) * (power_of_beta *= beta);
        v[order + k][i] = rounded_number(FT(psi[k][i] * scale)) * (power_of_eta *= eta);
      }
      for (int k : {0, 1, order + 1}) largest = (std::max)(largest, std::abs(v[k][i]));
    }
    return largest;
  };
  double largest = take(FT(1));
  if constexpr (!std::is_floating_point_v<FT>)
    if (!(1e-100 < largest && largest < 1e100)) { // exact numbers of any size
      FT sum(0);
      const auto add = [&](const FT& y) { sum += y < FT(0) ? FT(-y) : y; };
      for (int i = 0; i < dimension; ++i) {
        add(FT(psi[0][i] - phi[0][i]));
        add(FT(short_number_in<FT>(beta) * phi[1][i]));
      }
      largest = take(FT(FT(1) / sum));
    }
  if (largest > 0 && largest <= (std::numeric_limits<double>::max)())
    for (Given& x : v)
      for (int i = 0; i < dimension; ++i) x[i] = std::ldexp(x[i], -std::ilogb(largest));
  std::array<Coordinate_vector<double, M>, 2 * order + 1> x;
  if constexpr (M == N)
    x = v;
  else
    x = orthonormal_coordinates<M>(v);
  Fair_family<kind, M> family{x[0], {{}, 1}, {{}, -1}};
  for (int k = 0; k < order; ++k) {
    family.start.d[k] = x[1 + k];
    family.end.d[k] = x[1 + order + k];
  }
  if constexpr (order == 2) // the second derivative without its tangential part, which is free
    for (Fair_end<kind, M>* end : {&family.start, &family.end})
      end->d[1] -= (dot(end->d[1], end->d[0]) / dot(end->d[0], end->d[0])) * end->d[0];
  return family;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityStrategies
/// A report of the search for a fair blend.
struct Fair_report {
  int iterations = 0; ///< how many steps were tried
  /// `E` of the blend of least energy with the automatic shape, where the search starts; where that
  /// has almost a cusp, as much of it as a quadrature sees
  double automatic_fairness = 0;
  double fairness = 0;    ///< `E` of the blend that was found; never more than `automatic_fairness`
  bool converged = false; ///< whether the search ended in a local minimum

  /// Writes the fairness and the steps, e.g. `E = 158.925, from 176.371 in 7 steps`, and
  /// `, not converged` if it has not converged.
  friend std::ostream& operator<<(std::ostream& os, const Fair_report& report) {
    return os << "E = " << report.fairness << ", from " << report.automatic_fairness << " in " << report.iterations
              << " steps" << (report.converged ? "" : ", not converged");
  }
};

namespace internal {

// A free number with at most 12 binary digits behind the point and 20 in all: products with shape
// parameters are exact.
inline double short_scalar(double x) {
  return std::abs(x) < 256 ? std::floor(x * 4096 + 0.5) / 4096 : short_double<20>(x);
}

// The numbers of a fair blend, in floating-point numbers that are short, so that they are the same
// in every field.
template <Blend_kind kind> struct Fair_numbers {
  typedef typename Fair_end<kind, 2>::Unknowns End;
  double beta, eta;
  End start, end; // with the logarithm, that is not needed
  Fair_report report;
};

// Minimises over the free numbers, and rounds them, in the same way whatever rounding mode the
// caller has set. `beta` and `eta` are the given shape, or where the search starts.
template <Blend_kind kind, class FT, int N, class Jet>
Fair_numbers<kind> fair_numbers(const Jet& phi, const Jet& psi, double beta, double eta, Shape_choice shape) {
  constexpr int M = fair_dimension<N, Fair_end<kind, 2>::order>, second = Fair_end<kind, M>::unknowns;
  typedef Fair_family<kind, M> Family;
  const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  const Family family = fair_family<kind, FT, N>(phi, psi, beta, eta);
  const auto shape_parameter = [&](double given, double logarithm) {
    return shape == Shape_choice::given ? given : short_double<ratio_digits + 2>(given * std::exp(logarithm));
  };
  const auto rounded = [&](typename Family::Unknowns x) {
    for (int k = 0; k < Family::unknowns; ++k)
      if (k == 0 || k == second)
        x[k] = std::log(shape_parameter(k == 0 ? beta : eta, x[k]) / (k == 0 ? beta : eta));
      else
        x[k] = kind == Blend_kind::g2 ? 20 * short_scalar(x[k] / 20) : short_scalar(x[k]);
    return x;
  };
  const Fair_minimum<kind, M> minimum(family, shape, rounded);
  for (const double x : minimum.x)
    check_finite(x, "fair blend: derivatives that are too large or too small for the chord");
  return {shape_parameter(beta, minimum.x[0]),
          shape_parameter(eta, minimum.x[second]),
          Family::start_of(minimum.x),
          Family::end_of(minimum.x),
          {minimum.iterations, minimum.before, minimum.after, minimum.converged}};
}

// A strategy that also chooses the shape returns this.
template <class FT, class Strategy> struct Fair_choice {
  Shape_parameters<FT> shape;
  Strategy strategy; // for this shape
  Fair_report report;
};

// The numbers of a strategy that a fair blend chooses: short, and of the field where it cannot be
// made of them.
template <class FT> using Fair_scalar = std::conditional_t<has_interval_v<FT>, double, FT>;

template <class FT> Given_parameters<FT> fair_scalars(const Fair_numbers<Blend_kind::g2>& x, const FT&, const FT&) {
  return {short_number_in<FT>(short_scalar(x.start[1] / 20)), short_number_in<FT>(short_scalar(x.end[1] / 20))};
}

// The scalars of one end with the shape parameter beta: beta tau, beta^2 nu, beta sigma, and mu = 3
// beta beta_2 for G3.
template <Blend_kind kind, class FT>
Septic_end_parameters<FT> fair_end_scalars(const typename Fair_end<kind, 2>::Unknowns& x, const FT& beta) {
  const FT beta2 = beta * short_number_in<FT>(x[1]), beta3 = beta * short_number_in<FT>(x[2]);
  if constexpr (kind == Blend_kind::g3)
    return {beta2, FT(FT(3) * beta * beta2), beta3};
  else
    return {beta2, FT(beta * beta * short_number_in<FT>(x[3])), beta3};
}
template <class FT, Blend_kind kind>
Given_end_parameters<FT> fair_scalars(const Fair_numbers<kind>& x, const FT& beta, const FT& eta) {
  return {fair_end_scalars<kind, FT>(x.start, beta), fair_end_scalars<kind, FT>(x.end, eta)};
}

// A strategy for one kind of joins.
template <Blend_kind kind> struct Fair_strategy {
  /// Chooses the shape parameters and the free scalars for two jets.
  template <class FT, int N> auto choose(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi) const {
    const Shape_parameters<FT> automatic = internal::automatic_shape(phi, psi);
    const Fair_numbers<kind> x = fair_numbers<kind, FT, N>(phi, psi, rounded_number(automatic.beta),
                                                           rounded_number(automatic.eta), Shape_choice::free);
    typedef Fair_scalar<FT> Scalar;
    const auto strategy = fair_scalars<Scalar>(x, short_number_in<Scalar>(x.beta), short_number_in<Scalar>(x.eta));
    return Fair_choice<FT, std::decay_t<decltype(strategy)>>{
        {short_number_in<FT>(x.beta), short_number_in<FT>(x.eta)}, strategy, x.report};
  }
};

template <Blend_kind kind> struct Fair_septic_strategy : Fair_strategy<kind> {
  /// Chooses the free scalars at both ends for given shape parameters.
  template <class FT, int N> Septic_parameters<FT> operator()(const Septic_ends<FT, N>& e) const {
    return fair_scalars<FT>(fair_numbers<kind, FT, N>(scaled(e.start), scaled(e.end), 1, 1, Shape_choice::given),
                            e.start.beta, e.end.beta)(e);
  }

private:
  template <class FT, int N> static std::array<Coordinate_vector<FT, N>, 4> scaled(const Septic_end<FT, N>& e) {
    return {e.x, e.beta * e.d1, FT(e.beta * e.beta) * e.d2, FT(e.beta * e.beta * e.beta) * e.d3};
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the fairest blend of degree 5 with \f$ G^2 \f$ joins: the least `E` over
/// \f$ \beta, \eta, s_1, s_2 \f$, near the blend of least energy with the automatic shape, and with
/// \f$ \beta, \eta \f$ within a factor of 4 of it (or shorter tangents, where the diameter of the
/// circle of curvature is less than the chord). Where `E` is more than 400 there, the search starts
/// again from four blends with long tangents, and where it is more than 5000 even then, which
/// nobody would draw, from the best four of a coarse grid of blends. Where the caller gives the
/// shape parameters, over \f$ s_1, s_2 \f$ only.
///
/// The search is made in floating-point numbers. The result is rounded to short binary fractions,
/// and the blend is constructed with them in the field of the kernel. With an exact kernel its
/// joins are exactly \f$ G^2 \f$, whatever was found, and the blend is the same in every rounding
/// mode. Before this rounding `E` is at most that of the blend of least energy with the automatic
/// shape. Where both ends lie on one line, one after the other, the blend is a part of that line.
/// Ends whose blends all have a cusp get the automatic shape, or one with tangents no longer than
/// the diameters of the circles of curvature, which is reported as not converged. Exact derivatives
/// that leave no doubles next to the chord are refused: `not_finite`.
///
/// About ten steps, at most 100 from each start, with 24 to 96 nodes of Gauss's quadrature; nothing
/// is allocated in dimensions 2 and 3.
/// \cgalModels{BlendStrategy}
struct Fair : internal::Fair_strategy<internal::Blend_kind::g2> {
  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$ for given shape parameters.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
    const std::array<Coordinate_vector<FT, N>, 3> phi = {e.a1, e.u, e.w1}, psi = {e.a2, e.v, e.w2};
    typedef internal::Fair_scalar<FT> Scalar;
    return internal::fair_scalars<Scalar>(
        internal::fair_numbers<internal::Blend_kind::g2, FT, N>(phi, psi, 1, 1, internal::Shape_choice::given),
        Scalar(1), Scalar(1))(e);
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the fairest blend of degree 7 with \f$ G^3 \f$ joins: the least `E` over
/// \f$ \beta, \beta_2, \beta_3 \f$ at both ends, near the blend of `Fair` or that of least energy
/// \f$ \int |\gamma^{(4)}|^2 \f$. All else as for `Fair`. \cgalModels{BlendStrategy}
struct Fair_g3 : internal::Fair_septic_strategy<internal::Blend_kind::g3> {};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the fairest blend of degree 7 with \f$ F^3 \f$ joins: the least `E` over
/// \f$ \beta, \beta_2, \mu, \beta_3 \f$ at both ends, near the blend of `Fair_g3`. In the plane the
/// joins are \f$ G^2 \f$. All else as for `Fair_g3`. \cgalModels{BlendStrategy}
struct Fair_f3 : internal::Fair_septic_strategy<internal::Blend_kind::f3> {};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_FAIR_H
