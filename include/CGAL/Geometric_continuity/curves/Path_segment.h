// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_PATH_SEGMENT_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_PATH_SEGMENT_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Elliptical_arc.h>

#include <algorithm>
#include <string>
#include <variant>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// One segment of a path in the plane, as drawings have them: a line, another Bézier curve, or an arc of an ellipse.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> struct Path_segment {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  std::variant<Bezier_curve<Traits>, Elliptical_arc<Traits>> curve; ///< a line is a Bézier curve of degree 1

  /// Returns the arc, or a null pointer for a Bézier curve.
  const Elliptical_arc<Traits>* arc() const { return std::get_if<Elliptical_arc<Traits>>(&curve); }

  /// Returns the Bézier curve, or a null pointer for an arc.
  const Bezier_curve<Traits>* bezier() const { return std::get_if<Bezier_curve<Traits>>(&curve); }

  /// Returns whether the segment has a length: not a Bézier curve all of whose control points coincide.
  bool has_length() const {
    return arc() || std::count(bezier()->begin(), bezier()->end(), start()) <= bezier()->degree();
  }

  /// Returns the point where the segment starts.
  Point start() const { return arc() ? arc()->start() : bezier()->control_point(0); }

  /// Returns the point where the segment ends.
  Point end() const { return arc() ? arc()->end() : bezier()->control_point(bezier()->degree()); }

  /// Returns whether the derivatives at the ends are known: not those of an ellipse with an irrational rotation.
  bool is_known() const { return !arc() || arc()->is_known(); }

  /// Returns the number whose square root appears in the derivatives, see `Elliptical_arc::radicand()`; 0 for a Bézier curve.
  FT radicand() const { return arc() ? arc()->radicand() : FT(0); }

  /// Returns the jet at the start in a field, given the root of `radicand()` in it. An arc is taken with respect to the
  /// eccentric angle, a Bézier curve over its domain.
  /// \tparam Field a field that is constructible from `FT`
  /// \throws Error `negative_count` for a negative order; `parameter_outside_domain` unless `is_known()`
  template <class Field> Coordinate_jet<Field, 2> start_jet_over(int order, const Field& root) const {
    if (arc()) return arc()->template start_jet_over<Field>(order, root);
    return converted<Field>(bezier()->start_jet(checked(order)));
  }

  /// Returns the jet at the end in a field, given the root of `radicand()` in it; see `start_jet_over()`.
  /// \throws Error `negative_count` for a negative order; `parameter_outside_domain` unless `is_known()`
  template <class Field> Coordinate_jet<Field, 2> end_jet_over(int order, const Field& root) const {
    if (arc()) return arc()->template end_jet_over<Field>(order, root);
    return converted<Field>(bezier()->end_jet(checked(order)));
  }

  /// Returns the image under an invertible affine map of points.
  template <class Transformation> Path_segment transform(const Transformation& map) const {
    if (arc()) return {arc()->transform(map)};
    return {bezier()->transform(map)};
  }

private:
  static int checked(int order) {
    if (order < 0) throw Error(Error_code::negative_count, "Path_segment: order " + std::to_string(order));
    return order;
  }

  template <class Field> static Coordinate_jet<Field, 2> converted(const Coordinate_jet<FT, 2>& rational) {
    Coordinate_jet<Field, 2> jet(2, rational.order());
    for (int j = 0; j <= rational.order(); ++j)
      for (int i = 0; i < 2; ++i) jet[j][i] = Field(rational[j][i]);
    return jet;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_PATH_SEGMENT_H
