// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_CURVES_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_CURVES_H

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Traits, int Degree>
std::vector<Bezier_curve<Traits>> segments_of(const Composite_bezier_curve<Traits, Degree>& curve) {
  std::vector<Bezier_curve<Traits>> segments;
  for (int l = 0; l < curve.number_of_segments(); ++l) segments.push_back(curve.segment(l));
  return segments;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The segmented curve with one more segment, which `extend()` makes from the last one. In the global parameter \f$ \beta \f$ is
/// the ratio of the lengths of the two parameter intervals. \throws Error like `extend()` of a segment
template <class Traits, int Degree>
Composite_bezier_curve<Traits, Degree> extend(const Composite_bezier_curve<Traits, Degree>& curve, Frenet_order order,
                                              const Extension_parameters<typename Traits::FT>& parameters = {}) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(extend(segments.back(), order, parameters));
  return Composite_bezier_curve<Traits, Degree>(segments.begin(), segments.end());
}

/// \ingroup PkgGeometricContinuityConstruction
/// The same with the segment that `extend_toward()` makes. \throws Error like `extend_toward()` of a segment
template <class Traits, int Degree>
Composite_bezier_curve<Traits, Degree> extend_toward(const Composite_bezier_curve<Traits, Degree>& curve,
                                                     Frenet_order order, const typename Traits::Point& wished,
                                                     const typename Traits::FT& beta = typename Traits::FT(1)) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(extend_toward(segments.back(), order, wished, beta));
  return Composite_bezier_curve<Traits, Degree>(segments.begin(), segments.end());
}

/// \ingroup PkgGeometricContinuityConstruction
/// The closed curve with one more segment, which `close()` makes from the last one to the first. It takes a parameter
/// interval of length 1; all segments get the highest degree. \throws Error like `close()` of two curves
template <class Traits, int Degree>
Composite_bezier_curve<Traits> close(const Composite_bezier_curve<Traits, Degree>& curve, Frenet_order order,
                                     const Shape_parameters<typename Traits::FT>& shape = {}) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(close(segments.back(), segments.front(), order, shape));
  return Composite_bezier_curve<Traits>(segments.begin(), segments.end());
}

namespace internal {

// The curve over the knots of both, with the end of the curve repeated p times. The segment starts where the clamped curve ends.
template <class Traits>
Bspline_curve<Traits> with_segment(const Bspline_curve<Traits>& clamped, const Bezier_curve<Traits>& segment) {
  typedef typename Traits::FT FT;
  std::vector<typename Traits::Point> points(clamped.begin(), clamped.end());
  points.insert(points.end(), segment.begin() + 1, segment.end());
  std::vector<FT> knots(clamped.knots().begin(), clamped.knots().end() - 1);
  knots.insert(knots.end(), clamped.degree() + 1, segment.domain().second);
  return {points.begin(), points.end(), Knot_vector<FT>(clamped.degree(), std::move(knots))};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The B-spline curve with one more segment, which `extend()` makes from the Bézier curve on the last span. It is clamped; its
/// domain \f$ [a, b] \f$ grows by \f$ \beta \f$ times the length of that span. The inner knots stay, and the join at `b` becomes a
/// knot of multiplicity `p`, because a join with geometric continuity is in general no smoother in the parameter;
/// `Bspline_curve::remove_superfluous_knots()` leaves those that are needed. A clamped curve keeps its control points. For
/// the Bézier curve on the last span \f$ O(n p^3) \f$.
/// \throws Error like `extend()` of a segment
template <class Traits>
Bspline_curve<Traits> extend(const Bspline_curve<Traits>& curve, Frenet_order order,
                             const Extension_parameters<typename Traits::FT>& parameters = {}) {
  const Bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend(clamped.bezier_pieces().back(), order, parameters));
}

/// \ingroup PkgGeometricContinuityConstruction
/// The same with the segment that `extend_toward()` makes. \throws Error like `extend_toward()` of a segment
template <class Traits>
Bspline_curve<Traits> extend_toward(const Bspline_curve<Traits>& curve, Frenet_order order,
                                    const typename Traits::Point& wished,
                                    const typename Traits::FT& beta = typename Traits::FT(1)) {
  const Bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend_toward(clamped.bezier_pieces().back(), order, wished, beta));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_CURVES_H
