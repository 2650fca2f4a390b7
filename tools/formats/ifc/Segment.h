// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_SEGMENT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_SEGMENT_H

#include "formats/ifc/File.h"

#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/models/Road_network.h>

#include <cstdint>
#include <optional>
#include <string>

namespace ifc {

// A segment of a curve, or of a layer of the design.
struct Segment {
  std::uint64_t id = 0;
  long long line = 0;
  std::string claim; // the Transition
  std::string shape; // the type of its curve
  std::optional<GC::Alignment_end> start, end;
  std::optional<Q> length; // 0 or more, where it is known
  bool rounded = false;    // directions and curvatures have pi or roots in them
  bool rounded_points = false;
  // The heading of the end is measured from the direction of a graph at an arc length.
  struct Place_on_graph {
    GC::Parametric_cubic::Coefficients graph;
    Q length;
  };
  std::optional<Place_on_graph> turned_from;
  std::optional<GC::Road_geometry> bend; // a piece with the same curvatures
  std::string not_covered;
};

// Sets the ends and the length to those of a curve.
inline void set_ends(Segment& s, const GC::Clothoid_segment& c) {
  s.start = c.start();
  s.end = c.end();
  s.length = c.length();
}
inline void set_ends(Segment& s, const GC::Parametric_cubic& c, const Q& length) {
  s.start = c.start();
  s.end = c.end();
  s.length = length;
}

// A piece whose curvature goes from one number to another, and only rises or falls.
inline GC::Road_geometry bend_between(const Q& k0, const Q& k1) {
  GC::Road_geometry g;
  g.shape = k0 == k1 ? (k0 == 0 ? GC::Road_shape::line : GC::Road_shape::arc) : GC::Road_shape::spiral;
  if (k0 != k1)
    g.parameters = {k0, k1};
  else if (k0 != 0)
    g.parameters = {k0};
  return g;
}

// A graph over a distance, or of a length.
inline GC::Road_geometry bend_of_graph(const GC::Parametric_cubic::Coefficients& v, const Q& size, bool by_length) {
  GC::Road_geometry g;
  g.length = size;
  g.parameters.assign(v.begin(), v.end());
  g.shape = by_length ? GC::Road_shape::poly3 : GC::Road_shape::param_poly3;
  g.range = GC::Road_parameter_range::arc_length;
  if (!by_length) g.parameters.insert(g.parameters.begin(), {Q(0), Q(1), Q(0), Q(0)});
  return g;
}

} // namespace ifc

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_SEGMENT_H
