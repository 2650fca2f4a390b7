// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_IS_SHARP_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_IS_SHARP_EDGE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/Edge_enclosure.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/numbers/Verdict.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCadEdges
/// Decides whether the angle between the oriented normals of two faces is larger than `bound`, in radians, on the *whole* edge, as it is
/// along an edge that is meant to be sharp: proved, refuted when it is not on some part, or undecided. Points where a normal is proved to
/// vanish are left out, as by `edge_enclosure()`; so many parts of the range are evaluated at most as for one of its
/// three numbers.
/// \throws Error as `edge_enclosure()`
inline Verdict is_sharp_edge(const Edge_side& a, const Edge_side& b, double first, double last, const Bound& bound,
                             const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "is_sharp_edge: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Edge_bounds bounds(a, b, first, last, Edge_quantity::angle);
  const std::vector<double>& ends = bounds.ends();
  Oldest_first<Range> parts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) parts.add({ends[i], ends[i + 1]});
  if (ends.size() == 1) parts.add({first, last});
  const double ranges =
      (std::min)(double(precision.most_boxes), precision.boxes + 8 * static_cast<double>(ends.size()));
  bool defined = false, settled = true, small = false;
  int undefined_halvings = 0;
  double evaluated = 0;
  const bool finished = subdivide(parts, [&](const Range& part) {
    if (evaluated++ >= ranges) return After_part::stop;
    const Bounds_on_range square = bounds(part.lower, part.upper, Edge_quantity::angle, 0);
    if (square.defined) {
      const Verdict is_small =
          at_most({angle_of_chord_square(square.least).lower, angle_of_chord_square(square.upper).upper}, bound);
      small = is_small == Verdict::proved;
      if (small) return After_part::stop;
      defined = true;
      if (is_small == Verdict::refuted) return After_part::drop;
    }
    if (!square.defined && (!part.is_divisible() || part.length() <= (last - first) * 0x1p-20) &&
        bounds.is_undefined(part.lower, part.upper, Edge_quantity::angle))
      return After_part::drop; // without a normal
    if (!part.is_divisible() || part.length() <= (last - first) * (square.defined ? 0x1p-32 : 0x1p-48)) {
      settled = settled && square.defined && square.knots; // on a fold of a surface itself
      return After_part::drop;
    }
    return !square.defined && ++undefined_halvings > ranges / 8 ? After_part::stop : After_part::divide;
  });
  if (small) return Verdict::refuted;
  return finished && defined && settled ? Verdict::proved : Verdict::undecided;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_IS_SHARP_EDGE_H
