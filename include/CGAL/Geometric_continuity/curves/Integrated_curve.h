// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTEGRATED_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTEGRATED_CURVE_H

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/end_control_points.h>
#include <CGAL/Geometric_continuity/local/Frenet_frame.h>

#include <cstddef>
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
  /// \throws Error `dimension_mismatch` unless the frame has at least 2 vectors and there is a curvature
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

  /// How far the last point, and with it every sample, is at most from the exact curve, as far as the error estimate
  /// of the integrator can be trusted, up to rounding and terms of second order.
  FT error_bound;

  /// Returns the segmented Bézier curve of degree 5 on [0, length] whose knots are the arc lengths of the samples and which has
  /// there their points and their first two derivatives \f$ e_1 \f$ and \f$ \kappa_1 e_2 \f$. Up to rounding its joins are
  /// \f$ C^2 \f$, hence \f$ G^2 \f$, and in a segment of length `h` it is at most \f$ \frac{h^6}{46080} \max |x^{(6)}| \f$
  /// from the curve that it interpolates (Hermite).
  /// \throws Error `wrong_number_of_points` with fewer than 2 samples, `empty_domain` unless their arc lengths increase
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

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTEGRATED_CURVE_H
