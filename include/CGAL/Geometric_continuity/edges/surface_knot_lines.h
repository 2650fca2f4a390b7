// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SURFACE_KNOT_LINES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SURFACE_KNOT_LINES_H

#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCadEdges
/// A parameter line on which the formula of a surface changes, so that it may have a crease there.
struct Surface_knot_line {
  bool constant_u; ///< the knot is one of `u`, and `v` varies on the line; otherwise the reverse
  double knot;     ///< the constant parameter
};

namespace internal {

// The inner knots where a spline need not be continuously differentiable so many times.
inline void append_rough_knots(const std::vector<double>& knots, int degree, int times, std::vector<double>& result) {
  const auto begin = knots.begin() + degree + 1, end = knots.end() - degree - 1;
  for (auto i = begin; i < end;) {
    const auto next = std::upper_bound(i, end, *i);
    if (*i > knots[static_cast<std::size_t>(degree)] && *i < *end && next - i > degree - times) result.push_back(*i);
    i = next;
  }
}
inline void append_rough_knots(const Cad_curve<3>& curve, int times, std::vector<double>& result) {
  if (const auto* offset = std::get_if<Cad_offset_curve<3>>(&curve))
    append_rough_knots(*offset->basis, times + 1, result);
  if (const auto* spline = std::get_if<Cad_spline_curve<3>>(&curve))
    append_rough_knots(spline->knots, spline->degree, times, result);
}
inline void append_rough_knots(const Cad_surface& surface, int times, std::vector<double>& u, std::vector<double>& v) {
  if (const auto* offset = std::get_if<Cad_offset_surface>(&surface))
    append_rough_knots(*offset->basis, times + 1, u, v);
  if (const auto* extrusion = std::get_if<Cad_extrusion>(&surface)) append_rough_knots(extrusion->profile, times, u);
  if (const auto* revolution = std::get_if<Cad_revolution>(&surface)) append_rough_knots(revolution->profile, times, v);
  if (const auto* s = std::get_if<Cad_spline_surface>(&surface)) {
    append_rough_knots(s->u_knots, s->u_degree, times, u);
    append_rough_knots(s->v_knots, s->v_degree, times, v);
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCadEdges
/// Returns the lines inside of the domain of a surface where it need not be `order` times continuously differentiable: at inner knots of a
/// multiplicity greater than the degree minus `order`, of offsets one less; first those of `u` and then those of `v`. The two sides of such a
/// line are two `Edge_side`s of one surface and one curve, with `Edge_side::face_side` 1 and -1. \pre the numbers of the splines fit
inline std::vector<Surface_knot_line> surface_knot_lines(const Cad_surface& surface, int order) {
  std::vector<double> u, v;
  internal::append_rough_knots(surface, order, u, v);
  std::vector<Surface_knot_line> lines;
  for (double knot : u) lines.push_back({true, knot});
  for (double knot : v) lines.push_back({false, knot});
  return lines;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SURFACE_KNOT_LINES_H
