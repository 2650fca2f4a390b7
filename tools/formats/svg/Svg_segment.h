// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SEGMENT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SEGMENT_H

#include "formats/svg/Svg_arc.h"
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// One segment of an SVG path, and the command that draws it.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> struct Svg_segment {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  std::variant<Bezier_curve<Traits>, Svg_arc<Traits>> curve; ///< a line is a Bézier curve of degree 1
  long long command; ///< the number of the command in the path data, from 1 on; each implicit repetition counts
  char letter;       ///< the letter of the command, as written

  /// Returns the arc, or a null pointer for a Bézier curve.
  const Svg_arc<Traits>* arc() const { return std::get_if<Svg_arc<Traits>>(&curve); }

  /// Returns the Bézier curve, or a null pointer for an arc.
  const Bezier_curve<Traits>* bezier() const { return std::get_if<Bezier_curve<Traits>>(&curve); }

  /// Returns the point where the segment starts.
  Point start() const { return arc() ? arc()->start() : bezier()->control_point(0); }

  /// Returns the point where the segment ends.
  Point end() const { return arc() ? arc()->end() : bezier()->control_point(bezier()->degree()); }

  /// Returns whether the derivatives at the ends are known: not those of an ellipse with an irrational rotation.
  bool is_known() const { return !arc() || arc()->is_known(); }

  /// Returns the number whose square root appears in the derivatives, see `Svg_arc::radicand()`; 0 for a Bézier curve.
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
  template <class Transformation> Svg_segment transform(const Transformation& map) const {
    if (arc()) return {arc()->transform(map), command, letter};
    return {bezier()->transform(map), command, letter};
  }

private:
  static int checked(int order) {
    if (order < 0) throw Error(Error_code::negative_count, "Svg_segment: order " + std::to_string(order));
    return order;
  }

  template <class Field> static Coordinate_jet<Field, 2> converted(const Coordinate_jet<FT, 2>& rational) {
    Coordinate_jet<Field, 2> jet(2, rational.order());
    for (int j = 0; j <= rational.order(); ++j)
      for (int i = 0; i < 2; ++i) jet[j][i] = Field(rational[j][i]);
    return jet;
  }
};

/// What a path draws from one command M, or from the end of a closed subpath, to the next.
template <class Traits> struct Svg_subpath {
  std::vector<Svg_segment<Traits>> segments; ///< each starts where the one before it ends
  bool closed = false;                       ///< by the command Z: the end of the last one is the start of the first

  /// Returns the image under an invertible affine map of points.
  template <class Transformation> Svg_subpath transform(const Transformation& map) const {
    Svg_subpath r;
    r.closed = closed;
    for (const Svg_segment<Traits>& segment : segments) r.segments.push_back(segment.transform(map));
    return r;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SEGMENT_H
