// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_PLANE_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_PLANE_EDGE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_cad_geometry.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_spline_edge.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

/// \file exact_plane_edge.h
/// Continuity along edges between a plane, in which the edge may be any spline, and a parameter
/// line of a spline surface.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The plane o + u x + v y of a face, placed.
struct Placed_plane {
  typedef Coordinate_vector<Model_number, 3> Vector;
  Vector origin, x, y;

  static std::optional<Placed_plane> of(const Edge_side& side) {
    const auto vector = [](const Cad_point<3>& p) {
      Vector v;
      for (int i = 0; i < 3; ++i) v[i] = Model_number(p[i]);
      return v;
    };
    Placed_plane plane;
    if (const auto* s = std::get_if<Cad_elementary_surface>(side.surface.get())) {
      if (s->kind != Cad_elementary_surface::Kind::plane) return std::nullopt;
      plane = {vector(s->frame.origin), vector(s->frame.x_axis), vector(s->frame.y_axis)};
    } else if (const auto* b = std::get_if<Cad_spline_surface>(side.surface.get())) {
      // a parallelogram
      if (b->u_degree != 1 || b->v_degree != 1 || b->points.size() != 4 || !are_equal(b->weights)) return std::nullopt;
      const Vector p = vector(b->points[0]), u = vector(b->points[2]) - p, v = vector(b->points[1]) - p;
      if (vector(b->points[3]) - p != u + v) return std::nullopt;
      const Model_number u0(b->u_knots[1]), u1(b->u_knots[2]), v0(b->v_knots[1]), v1(b->v_knots[2]);
      plane.x = u / Model_number(u1 - u0);
      plane.y = v / Model_number(v1 - v0);
      plane.origin = p - u0 * plane.x - v0 * plane.y;
    } else
      return std::nullopt;
    const Cad_map map(side.placement);
    const auto placed = [&](const Vector& p, bool is_point) {
      Vector q;
      for (int i = 0; i < 3; ++i) {
        q[i] = is_point ? map.shift(i) : Model_number(0);
        for (int j = 0; j < 3; ++j) q[i] += map(i, j) * p[j];
      }
      return q;
    };
    return Placed_plane{placed(plane.origin, true), placed(plane.x, false), placed(plane.y, false)};
  }
};

// Returns whether the edge in a plane and a row along it are the same points at all parameters:
// both are polynomials between knots.
inline bool is_same_edge(const Placed_plane& plane, const Cad_curve<2>& curve,
                         const Spline_edge_rows<Model_number, 3>& rows) {
  typedef Coordinate_vector<Model_number, 2> Parameters;
  const auto [first, last] = rows.knots.domain();
  std::vector<Model_number> ends{first, last};
  for (const auto& knot : rows.knots.inner_knots()) ends.push_back(knot.value);
  int degree = rows.knots.degree();
  std::optional<Knot_vector<Model_number>> knots;
  std::vector<Parameters> points;
  const std::optional<std::array<Linear_function, 2>> line = straight_line(curve);
  if (!line) {
    const auto* spline = std::get_if<Cad_spline_curve<2>>(&curve);
    if (!spline || !are_equal(spline->weights)) return false;
    knots = given_knots(spline->degree, spline->knots);
    if (!knots->contains(first) || !knots->contains(last)) return false;
    for (const Cad_point<2>& p : spline->points) {
      points.emplace_back();
      for (int i = 0; i < 2; ++i) points.back()[i] = Model_number(p[i]);
    }
    for (const auto& knot : knots->inner_knots())
      if (first < knot.value && knot.value < last) ends.push_back(knot.value);
    degree = (std::max)(degree, spline->degree);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (int k = 0; k <= degree; ++k) {
      const Model_number t = ends[i - 1] + Model_number(ends[i] - ends[i - 1]) * Model_number(k) / Model_number(degree);
      Parameters p;
      if (line)
        for (int j = 0; j < 2; ++j) p[j] = (*line)[j].constant + (*line)[j].slope * t;
      else
        p = bspline_value<Model_number>(*knots, points, t);
      if (plane.origin + p[0] * plane.x + p[1] * plane.y != bspline_value<Model_number>(rows.knots, rows.rows.edge, t))
        return false;
    }
  return true;
}

// G2, or nothing. The plane is continued across the edge by the surface C - w T, where T is the
// derivative of the other surface across it; if T is in the plane, so is this.
inline std::optional<Edge_continuity<Model_number>> exact_plane_edge(const Edge_side& flat, const Edge_side& other,
                                                                     double first, double last) {
  typedef Coordinate_vector<Model_number, 3> Vector;
  if (!(first < last)) return std::nullopt;
  const std::optional<Placed_plane> plane = Placed_plane::of(flat);
  if (!plane) return std::nullopt;
  const std::optional<Edge_on_parameter_line> line = edge_on_parameter_line(other, first, last);
  if (!line || !are_equal(line->surface->weights)) return std::nullopt;
  const Spline_edge_rows<Model_number, 3> x = rows_on_part<3>(*line, other.placement, first, last);
  const Vector normal = cross_product(plane->x, plane->y);
  const auto is_parallel = [&](const Vector& v) { return dot(normal, v) == Model_number(0); };
  if (!std::all_of(x.rows.cross.begin(), x.rows.cross.end(), is_parallel) ||
      !std::all_of(x.rows.second_cross.begin(), x.rows.second_cross.end(), is_parallel) ||
      !is_same_edge(*plane, *flat.curve, x))
    return std::nullopt;
  Spline_edge_rows<Model_number, 3> y = x;
  for (Vector& v : y.rows.cross) v *= Model_number(-1);
  for (Vector& v : y.rows.second_cross) v = Vector(3);
  // the oriented normal of the plane as a multiple of C' x T, at one point of the edge: that does
  // not vanish where the order is 2
  const Model_number middle = Model_number(x.knots.domain().first + x.knots.domain().second) / Model_number(2);
  const Bspline_function<Model_number, Vector> edge(x.knots, y.rows.edge), cross(x.knots, y.rows.cross);
  const Model_number product =
      dot(normal, cross_product(edge.derivative()(middle), cross(middle))) * Model_number(is_flipped(flat) ? -1 : 1);
  if (product == Model_number(0)) return std::nullopt;
  if ((product > Model_number(0) ? 1 : -1) == line->orientation)
    for (Vector& v : y.rows.cross) v *= Model_number(-1);
  const std::optional<Edge_continuity<Model_number>> verdict = exact_spline_edge(x, y);
  return verdict && verdict->g_order >= 2 ? verdict : std::nullopt;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_PLANE_EDGE_H
