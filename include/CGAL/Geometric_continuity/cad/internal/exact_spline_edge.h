// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_SPLINE_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_SPLINE_EDGE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/internal/decide_surfaces.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/change_knots.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/internal/bspline_net.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

/// \file exact_spline_edge.h
/// Continuity along edges that are parameter lines of spline surfaces, by the rows of coefficients
/// along these lines.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A parameter line of a spline surface that an edge runs along, and on which side of it the face
// lies.
struct Edge_on_parameter_line {
  const Cad_spline_surface* surface;
  Parameter_line line;
  Linear_function along; // the parameter on the line, as a function of that of the edge
  Model_number across;
  Line_side part;
  // 1 when the oriented normal of the face is a positive multiple of C' x T, with T into the part;
  // otherwise -1
  int orientation;
};

// Empty unless an edge is such a line within the domain, and the part of the surface is known, or
// does not matter.
inline std::optional<Edge_on_parameter_line> edge_on_parameter_line(const Edge_side& side, double first, double last) {
  const auto* s = std::get_if<Cad_spline_surface>(side.surface.get());
  if (!s) return std::nullopt;
  const std::optional<std::array<Linear_function, 2>> curve = straight_line(*side.curve);
  if (!curve) return std::nullopt;
  const Model_number zero(0);
  const bool along_u = (*curve)[1].slope == zero;
  const Linear_function& along = (*curve)[along_u ? 0 : 1];
  if (along.slope == zero || (*curve)[along_u ? 1 : 0].slope != zero) return std::nullopt;
  const Model_number across = (*curve)[along_u ? 1 : 0].constant;
  const Knot_vector<Model_number> u = given_knots(s->u_degree, s->u_knots), v = given_knots(s->v_degree, s->v_knots);
  const Knot_vector<Model_number>&knots_along = along_u ? u : v, &knots_across = along_u ? v : u;
  const auto [begin, end] = knots_across.domain();
  if (!knots_across.contains(across)) return std::nullopt;
  for (double t : {first, last})
    if (!knots_along.contains(Model_number(along.constant + along.slope * Model_number(t)))) return std::nullopt;
  // the left side of the edge is that of larger v along growing u, and that of smaller u along
  // growing v
  const int forward = along.slope > zero ? 1 : -1, left = along_u ? forward : -forward;
  int into = across == begin ? 1 : across == end ? -1 : left * side.face_side;
  if (into == 0) {
    if (knots_across.multiplicity(across) > 0) return std::nullopt;
    into = 1;
  }
  return Edge_on_parameter_line{s,
                                along_u ? Parameter_line::along_u : Parameter_line::along_v,
                                along,
                                across,
                                into > 0 ? Line_side::larger_parameters : Line_side::smaller_parameters,
                                left * into * (is_flipped(side) ? -1 : 1)};
}

// The rows over the part [first, last] of the edge, in its parameter, of the placed surface.
template <int N>
Spline_edge_rows<Model_number, N> rows_on_part(const Edge_on_parameter_line& edge, const Cad_placement& placement,
                                               double first, double last) {
  typedef Coordinate_vector<Model_number, N> Point;
  const Cad_spline_surface& s = *edge.surface;
  const Knot_vector<Model_number> u = given_knots(s.u_degree, s.u_knots), v = given_knots(s.v_degree, s.v_knots);
  const Cad_map map(placement);
  const auto point = [&](int i, int j) {
    const std::size_t k = static_cast<std::size_t>(i) * s.v_points() + j;
    Coordinate_vector<Model_number, 3> x;
    for (int r = 0; r < 3; ++r) {
      x[r] = map.shift(r);
      for (int c = 0; c < 3; ++c) x[r] += map(r, c) * Model_number(s.points[k][c]);
    }
    if constexpr (N == 4)
      return homogeneous_point(x, s.weights.empty() ? Model_number(1) : Model_number(s.weights[k]));
    else
      return x;
  };
  const std::vector<std::vector<Point>> rows =
      bspline_rows_at<Model_number, N>(u, v, N, edge.line, edge.across, edge.part, 2, point);

  const Knot_vector<Model_number>& knots = edge.line == Parameter_line::along_u ? u : v;
  const auto parameter = [&](double t) {
    return Model_number(edge.along.constant + edge.along.slope * Model_number(t));
  };
  const bool backwards = edge.along.slope < Model_number(0);
  const Model_number begin = parameter(backwards ? last : first), end = parameter(backwards ? first : last);
  std::vector<typename Knot_vector<Model_number>::Knot> inner;
  for (const auto& knot : knots.inner_knots())
    if (begin < knot.value && knot.value < end) inner.push_back(knot);
  const Knot_vector<Model_number> part(knots.degree(), begin, end, inner);
  std::vector<Model_number> t;
  for (const Model_number& x : part)
    t.push_back(Model_number(Model_number(x - edge.along.constant) / edge.along.slope));
  std::array<std::vector<Point>, 3> c;
  for (int r = 0; r < 3; ++r) c[r] = change_knots<Model_number>(knots, rows[r], part);
  if (backwards) {
    std::reverse(t.begin(), t.end());
    for (std::vector<Point>& row : c) std::reverse(row.begin(), row.end());
  }
  return {Knot_vector<Model_number>(knots.degree(), std::move(t)), {std::move(c[0]), std::move(c[1]), std::move(c[2])}};
}

// Returns whether the points at one parameter differ.
template <int N>
bool differ_at(const Spline_edge_rows<Model_number, N>& a, const Spline_edge_rows<Model_number, N>& b,
               const Model_number& t) {
  Coordinate_vector<Model_number, N> x = bspline_value<Model_number>(a.knots, a.rows.edge, t),
                                     y = bspline_value<Model_number>(b.knots, b.rows.edge, t);
  if constexpr (N == 4) {
    const Model_number w = x[3];
    x *= y[3];
    y *= w;
  }
  return x != y;
}

template <int N>
std::optional<Edge_continuity<Model_number>> exact_spline_edge(const Spline_edge_rows<Model_number, N>& a,
                                                               const Spline_edge_rows<Model_number, N>& b) {
  const auto [first, last] = a.knots.domain();
  for (int i = 0; i <= 4; ++i) // most gaps are found at once
    if (differ_at(a, b, Model_number(first + Model_number(last - first) * Model_number(i) / Model_number(4))))
      return Edge_continuity<Model_number>();
  const Spline_edge_continuity<Model_number> e = decide_rows<Model_number>(a, b);
  // equivalent [&& e.whole_b -> nothing, 1]: of edges with the same ends at the same parameters,
  //   neither or both are whole
  if (e.g_order >= 0 && e.whole_a && e.whole_b)
    return e.reversed ? std::nullopt : std::optional<Edge_continuity<Model_number>>(e);
  // polynomial edges that are the same at equal parameters would have been found; rational ones may
  // be the same nevertheless
  return N == 3 ? std::optional<Edge_continuity<Model_number>>(Edge_continuity<Model_number>()) : std::nullopt;
}

// The verdict where points at equal parameters are compared and angles are those of the oriented
// normals. That the faces lie on different sides of the edge is the same, if their orientations are
// opposite with respect to it; otherwise the normal of one of them is turned, and the surface
// continued beyond the edge in place of the face.
template <int N>
std::optional<Edge_continuity<Model_number>> exact_spline_edge(const Edge_side& a, const Edge_on_parameter_line& on_a,
                                                               const Edge_side& b, const Edge_on_parameter_line& on_b,
                                                               double first, double last) {
  const Spline_edge_rows<Model_number, N> x = rows_on_part<N>(on_a, a.placement, first, last);
  Spline_edge_rows<Model_number, N> y = rows_on_part<N>(on_b, b.placement, first, last);
  if (on_a.orientation == on_b.orientation)
    for (Coordinate_vector<Model_number, N>& t : y.rows.cross) t *= Model_number(-1);
  return exact_spline_edge(x, y);
}

inline std::optional<Edge_continuity<Model_number>> exact_spline_edge(const Edge_side& a, const Edge_side& b,
                                                                      double first, double last) {
  if (!(first < last)) return std::nullopt;
  const std::optional<Edge_on_parameter_line> on_a = edge_on_parameter_line(a, first, last);
  if (!on_a) return std::nullopt;
  const std::optional<Edge_on_parameter_line> on_b = edge_on_parameter_line(b, first, last);
  if (!on_b) return std::nullopt;
  return are_equal(on_a->surface->weights) && are_equal(on_b->surface->weights)
             ? exact_spline_edge<3>(a, *on_a, b, *on_b, first, last)
             : exact_spline_edge<4>(a, *on_a, b, *on_b, first, last);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_SPLINE_EDGE_H
