// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SUBPATH_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SUBPATH_H

#include <CGAL/Geometric_continuity/curves/Path_segment.h>

#include <algorithm>
#include <cstddef>
#include <deque>

namespace CGAL {
namespace Geometric_continuity {

/// One segment of an SVG path, and the command that draws it.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> struct Svg_segment : Path_segment<Traits> {
  /// the number of the command in the path data, from 1 on; each implicit repetition counts
  long long command;
  char letter; ///< the letter of the command, as written
  /// where the command begins in the path data: its letter, or the first number of a repetition
  std::size_t place;

  /// Returns the image under an invertible affine map of points.
  template <class Transformation> Svg_segment transform(const Transformation& map) const {
    return {Path_segment<Traits>::transform(map), command, letter, place};
  }
};

/// The curve that a path draws from one command M, or from the end of a closed subpath, to the
/// next.
template <class Traits> struct Svg_subpath {
  std::deque<Svg_segment<Traits>> segments; ///< each starts where the one before it ends
  /// the end of the last one is the start of the first, and they join: by Z, or join_ends()
  bool closed = false;
  std::size_t left_out = 0; ///< the number of segments that leave_out_points() has removed

  /// Returns the number of joins: that behind the last segment is one if the subpath is closed.
  std::size_t joins() const { return segments.empty() || closed ? segments.size() : segments.size() - 1; }

  /// Removes the segments of no length, which have no direction: what is before and behind them
  /// meets.
  void leave_out_points() {
    const auto end = std::remove_if(segments.begin(), segments.end(),
                                    [](const Svg_segment<Traits>& segment) { return !segment.has_length(); });
    left_out += static_cast<std::size_t>(segments.end() - end);
    segments.erase(end, segments.end());
  }

  /// Makes a join where the end is the start, as the outline of what is filled has it, with the
  /// command Z or without it.
  void join_ends() { closed = closed || (!segments.empty() && segments.back().end() == segments.front().start()); }

  /// Returns the image under an invertible affine map of points.
  template <class Transformation> Svg_subpath transform(const Transformation& map) const {
    Svg_subpath r;
    r.closed = closed;
    r.left_out = left_out;
    for (const Svg_segment<Traits>& segment : segments) r.segments.push_back(segment.transform(map));
    return r;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SUBPATH_H
