// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_CURVE_FROM_CURVATURES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_CURVE_FROM_CURVATURES_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/square_root.h>
#include <CGAL/number_utils.h>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A point of a curve that is parametrised by arc length, with its Frenet frame.
template <class Traits> struct Framed_point {
  typedef typename Traits::FT FT; ///< the field

  FT s;                         ///< the arc length from the start of the curve
  typename Traits::Point point; ///< the point
  Frenet_frame<Traits> frame;   ///< orthonormal
  std::vector<FT> curvatures;   ///< \f$ \kappa_1(s), \dots, \kappa_{n-1}(s) \f$

  /// Returns the jet \f$ (x, x', x'') = (x, e_1, \kappa_1 e_2) \f$ with respect to arc length.
  /// \throws Error `dimension_mismatch` unless the frame has at least 2 vectors and there is a
  ///   curvature
  Curve_jet<Traits> jet() const {
    if (frame.dimension() < 2 || curvatures.empty()) throw Error(Error_code::dimension_mismatch, "Framed_point::jet");
    Curve_jet<Traits> x(Coordinate_jet<FT, dimension_v<Traits>>(frame.dimension(), 2));
    x[0] = Geometric_continuity::coordinates<Traits>(point);
    x[1] = frame.coordinates(1);
    x[2] = curvatures[0] * frame.coordinates(2);
    return x;
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// A curve that was computed from its curvatures: what `curve_from_curvatures()` returns.
template <class Traits> struct Integrated_curve {
  typedef typename Traits::FT FT; ///< the field

  std::vector<Framed_point<Traits>> samples; ///< in order, at the ends of all steps

  /// A bound of the distance of the last point, and of every sample, from the exact curve. It
  /// relies on the error estimate of the integrator, and holds up to rounding and terms of second
  /// order.
  FT error_bound;

  /// Returns the segmented Bézier curve of degree 5 on [0, length] whose knots are the arc lengths
  /// of the samples and which has there their points and their first two derivatives \f$ e_1 \f$
  /// and \f$ \kappa_1 e_2 \f$. Up to rounding its joins are \f$ C^2 \f$, hence \f$ G^2 \f$, and in
  /// a segment of length `h` it is at most \f$ \frac{h^6}{46080} \max |x^{(6)}| \f$ from the curve
  /// that it interpolates (Hermite).
  /// \throws Error `wrong_number_of_points` with fewer than 2 samples, `empty_domain` unless their
  ///   arc lengths increase
  Composite_bezier_curve<Traits, 5> bezier_curve() const {
    if (samples.size() < 2) throw Error(Error_code::wrong_number_of_points, "Integrated_curve::bezier_curve");
    std::vector<typename Traits::Point> points(1, samples[0].point);
    std::vector<FT> knots(1, samples[0].s);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const FT h = samples[i].s - samples[i - 1].s;
      const std::vector<typename Traits::Point> start = start_control_points(samples[i - 1].jet(), 5, h),
                                                end = end_control_points(samples[i].jet(), 5, h);
      points.insert(points.end(), start.begin() + 1, start.end());
      points.insert(points.end(), end.begin(), end.end());
      knots.push_back(samples[i].s);
    }
    return Composite_bezier_curve<Traits, 5>(points.begin(), points.end(), std::move(knots));
  }
};

namespace internal {

// The values of all curvatures at s: of one function that returns a number or a range, or of a
// range of functions.
template <class FT, class Curvatures> std::vector<FT> curvature_values(const Curvatures& kappa, FT s) {
  std::vector<FT> values;
  if constexpr (!std::is_invocable_v<const Curvatures&, FT>)
    for (const auto& k : kappa) values.push_back(k(s));
  else if constexpr (std::is_convertible_v<std::invoke_result_t<const Curvatures&, FT>, FT>)
    values.push_back(kappa(s));
  else
    for (const auto& k : kappa(s)) values.push_back(k);
  return values;
}

// The Frenet equations (1.6) at unit speed for the rows x, e_1, ..., e_n of n coordinates each.
template <class FT, class Curvatures> class Frenet_system {
  const Curvatures& kappa_;
  const int n_;
  const FT length_;

public:
  typedef std::vector<FT> State;

  Frenet_system(const Curvatures& kappa, int n, FT length) : kappa_(kappa), n_(n), length_(length) {}

  State curvatures(FT s) const {
    // rounding must not leave their domain
    State k = curvature_values<FT>(kappa_, (std::min)(s, length_));
    if (static_cast<int>(k.size()) != n_ - 1)
      throw Error(Error_code::dimension_mismatch, "curve_from_curvatures: " + std::to_string(k.size()) +
                                                      " curvatures in dimension " + std::to_string(n_));
    for (int i = 0; i < n_ - 1; ++i) {
      check_finite(k[i], "curve_from_curvatures: curvatures");
      if (i < n_ - 2 && !(k[i] > FT(0)))
        throw Error(Error_code::nonpositive_curvature,
                    "curve_from_curvatures: curvature " + std::to_string(i + 1) + " at " + std::to_string(s));
    }
    return k;
  }

  void operator()(const State& x, State& derivative, FT s) const {
    const State k = curvatures(s);
    for (int j = 0; j < n_; ++j) {
      derivative[j] = x[n_ + j];
      for (int i = 1; i <= n_; ++i)
        derivative[i * n_ + j] =
            (i < n_ ? k[i - 1] * x[(i + 1) * n_ + j] : FT(0)) - (i > 1 ? k[i - 2] * x[(i - 1) * n_ + j] : FT(0));
    }
  }
};

// The rows e_1, ..., e_n of a state.
template <class Traits> std::vector<Coordinates<Traits>> frame_rows(const std::vector<typename Traits::FT>& x, int n) {
  std::vector<Coordinates<Traits>> e(n, Coordinates<Traits>(n));
  for (int i = 0; i < n; ++i) std::copy_n(x.begin() + (i + 1) * n, n, &e[i][0]);
  return e;
}

// Replaces the rows e_1, ..., e_n of a state by the orthonormal ones of Gram and Schmidt.
template <class Traits> void orthonormalise(std::vector<typename Traits::FT>& x, int n) {
  typedef typename Traits::FT FT;
  std::vector<Coordinates<Traits>> q;
  for (const Coordinates<Traits>& row : frame_rows<Traits>(x, n)) {
    q.push_back(orthogonal_component(row, q));
    q.back() /= square_root(FT(dot(q.back(), q.back())));
    std::copy(q.back().begin(), q.back().end(), x.begin() + n * static_cast<int>(q.size()));
  }
}

// The orthonormal frame with positive orientation of the first n-1 vectors.
template <class Traits> Frenet_frame<Traits> initial_frame(const Frenet_frame<Traits>& frame) {
  const int n = frame.dimension();
  Curve_jet<Traits> jet(Coordinate_jet<typename Traits::FT, dimension_v<Traits>>(n, n - 1));
  for (int i = 1; i < n; ++i) jet[i] = frame.coordinates(i);
  const std::optional<Frenet_frame<Traits>> e = frenet_frame(jet);
  if (!e) throw Error(Error_code::singular_frame, "curve_from_curvatures: initial frame");
  return e->normalized();
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The largest number of steps of `curve_from_curvatures()`.
constexpr int max_integration_steps = 1000000;

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve of the given length in \f$ E^n \f$, \f$ n \ge 2 \f$, that is parametrised by
/// arc length, starts at `start` with the Frenet frame `frame`, and has the curvatures
/// \f$ \kappa_1(s), \dots, \kappa_{n-1}(s) \f$. Hagen 1.7 (b).
///
/// The Frenet equations (1.6) for the point and the frame are integrated by the method of Dormand
/// and Prince of order 5 with step control (`boost::numeric::odeint`). No step is longer than 1/16
/// of the curve. The frame is made orthonormal again after every step, which changes it by no more
/// than the error of this step.
///
/// `tolerance` bounds the estimated error \f$ \varepsilon \f$ of each coordinate of the point and
/// of the frame in one step. Errors of the frame are carried on by rotations and so add up without
/// being amplified: after `k` steps it is at most \f$ \sqrt 2\, k n \varepsilon \f$, and the error
/// of the point at most \f$ k \varepsilon (\sqrt n + \sqrt 2\, n\, length) \f$, which is reported
/// as `error_bound`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is a floating-point type
/// \tparam Curvatures a range of `n - 1` functions `FT(FT)`, or a function of `FT` that returns the
///   range of the `n - 1` values, or, for `n == 2`, the value. They are called with arguments in
///   [0, length].
/// \param frame its first `n - 1` vectors are orthonormalised in this order; the last follows from
///   the orientation
/// \throws Error `nonpositive_curvature` where one of \f$ \kappa_1, \dots, \kappa_{n-2} \f$ is not
///   positive, `not_finite` where a curvature is not a number or infinite, or the result overflows
/// \throws Error `dimension_mismatch` when the numbers of curvatures, vectors and coordinates do
///   not fit, `singular_frame` when the first `n - 1` vectors are linearly dependent,
///   `empty_domain` unless the length is positive
/// \throws Error `unreachable_tolerance` unless the tolerance is at least the machine epsilon, and
///   when more than `max_integration_steps` or vanishing steps would be needed; `not_finite` for an
///   infinite or undefined length or tolerance
template <class Traits, class Curvatures>
Integrated_curve<Traits> curve_from_curvatures(const Curvatures& kappa, const typename Traits::Point& start,
                                               const Frenet_frame<Traits>& frame, typename Traits::FT length,
                                               typename Traits::FT tolerance = 1e-10) {
  typedef typename Traits::FT FT;
  static_assert(std::is_floating_point_v<FT>, "the curve is integrated numerically");
  typedef internal::Frenet_system<FT, Curvatures> System;
  typedef typename System::State State;
  namespace odeint = boost::numeric::odeint;
  const Geometric_continuity::Coordinates<Traits> origin = Geometric_continuity::coordinates<Traits>(start);
  const int n = frame.dimension();
  if (n < 2 || origin.dimension() != n)
    throw Error(Error_code::dimension_mismatch, "curve_from_curvatures: frame of " + std::to_string(n) + " vectors");
  internal::check_finite(length, "curve_from_curvatures: length");
  if (!(length > FT(0))) throw Error(Error_code::empty_domain, "curve_from_curvatures: length");
  if (!(tolerance >= std::numeric_limits<FT>::epsilon()))
    throw Error(Error_code::unreachable_tolerance, "curve_from_curvatures");
  internal::check_finite(tolerance, "curve_from_curvatures: tolerance");

  const System system(kappa, n, length);
  const Frenet_frame<Traits> initial = internal::initial_frame(frame);
  State x(origin.begin(), origin.end());
  for (int i = 1; i <= n; ++i) x.insert(x.end(), initial.coordinates(i).begin(), initial.coordinates(i).end());

  Integrated_curve<Traits> curve;
  const auto sample = [&](FT s) {
    Geometric_continuity::Coordinates<Traits> p(n);
    std::copy_n(x.begin(), n, &p[0]);
    for (const FT& c : x) internal::check_finite(c, "curve_from_curvatures: the result overflows");
    curve.samples.push_back({s, Geometric_continuity::to_point<Traits>(p),
                             Frenet_frame<Traits>(internal::frame_rows<Traits>(x, n)), system.curvatures(s)});
  };
  sample(FT(0));
  auto stepper = odeint::make_controlled(tolerance, FT(0), odeint::runge_kutta_dopri5<State, FT>());
  FT s(0), step = length;
  while (s < length) {
    const FT rest = length - s;
    step = (std::min)(step, length / 16);
    if (rest < 2 * step) step = rest <= step ? rest : rest / 2; // no tiny step at the end
    const bool last = step == rest;
    if (s + step == s || static_cast<int>(curve.samples.size()) > max_integration_steps)
      throw Error(Error_code::unreachable_tolerance, "curve_from_curvatures at " + std::to_string(s));
    if (stepper.try_step(system, x, s, step) == odeint::fail) continue;
    if (last) s = length;
    internal::orthonormalise<Traits>(x, n);
    stepper.reset(); // its derivative was that of the rows before
    sample(s);
  }
  const FT steps(curve.samples.size() - 1);
  curve.error_bound = steps * tolerance * (internal::square_root(FT(n)) + internal::square_root(FT(2)) * n * length);
  return curve;
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve of the given length and curvatures that starts at the origin with the standard
/// basis of \f$ E^n \f$ as its frame, where `n - 1` is the number of the curvatures.
/// \throws Error `dimension_mismatch` without curvatures, and what the function with a given frame
///   throws
template <class Traits, class Curvatures>
Integrated_curve<Traits> curve_from_curvatures(const Curvatures& kappa, typename Traits::FT length,
                                               typename Traits::FT tolerance = 1e-10) {
  typedef typename Traits::FT FT;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const int n = static_cast<int>(internal::curvature_values<FT>(kappa, FT(0)).size()) + 1;
  std::vector<Coordinates> e(n, Coordinates(n));
  for (int i = 0; i < n; ++i) e[i][i] = FT(1);
  return curve_from_curvatures<Traits>(kappa, Geometric_continuity::to_point<Traits>(Coordinates(n)),
                                       Frenet_frame<Traits>(e), length, tolerance);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_CURVE_FROM_CURVATURES_H
