// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_SEGMENT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_SEGMENT_H

#include <CGAL/Geometric_continuity/IO/svg/Svg_arc.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <variant>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// One segment of an SVG path, and the command that draws it.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> struct Svg_segment {
  typedef typename Traits::Point Point;

  std::variant<Bezier_curve<Traits>, Svg_arc<Traits>> curve; ///< a line is a Bézier curve of degree 1
  long long command; ///< the number of the command in the path data, from 1 on; each implicit repetition counts
  char letter;       ///< the letter of the command, as written

  /// The arc, or a null pointer for a Bézier curve.
  const Svg_arc<Traits>* arc() const { return std::get_if<Svg_arc<Traits>>(&curve); }

  /// The Bézier curve, or a null pointer for an arc.
  const Bezier_curve<Traits>* bezier() const { return std::get_if<Bezier_curve<Traits>>(&curve); }

  Point start() const { return arc() ? arc()->start() : bezier()->control_point(0); }
  Point end() const { return arc() ? arc()->end() : bezier()->control_point(bezier()->degree()); }

  /// The image under an affine map of points.
  template <class Transformation> Svg_segment transform(const Transformation& map) const {
    if (arc()) return {arc()->transform(map), command, letter};
    return {bezier()->transform(map), command, letter};
  }
};

/// \ingroup PkgGeometricContinuityIO
/// What a path draws from one command M, or from the end of a closed subpath, to the next.
template <class Traits> struct Svg_subpath {
  std::vector<Svg_segment<Traits>> segments; ///< each starts where the one before it ends
  bool closed = false;                       ///< by the command Z: the end of the last one is the start of the first

  /// The image under an affine map of points.
  template <class Transformation> Svg_subpath transform(const Transformation& map) const {
    Svg_subpath r;
    r.closed = closed;
    for (const Svg_segment<Traits>& segment : segments) r.segments.push_back(segment.transform(map));
    return r;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_SEGMENT_H
