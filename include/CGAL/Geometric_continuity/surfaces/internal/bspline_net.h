// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BSPLINE_NET_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BSPLINE_NET_H

#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/internal/Control_net.h>
#include <CGAL/Geometric_continuity/surfaces/internal/tensor_product_jet.h>

#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file bspline_net.h
/// The algorithms of `Bspline_surface`: those of spline functions, applied to the rows and columns
/// of a control net.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT> void check_number_of_points(int number, const Knot_vector<FT>& knots, const char* what) {
  const int needed = knots.number_of_coefficients();
  if (number != needed)
    throw Error(Error_code::wrong_number_of_points, "Bspline_surface: " + std::to_string(number) + ' ' + what +
                                                        " where the knots need " + std::to_string(needed));
}

// The net of a range of ranges, with as many rows and columns as the knots need.
template <class Traits, class Points>
Control_net<Traits> spline_net(const Points& net, const Knot_vector<typename Traits::FT>& knots_u,
                               const Knot_vector<typename Traits::FT>& knots_v) {
  if constexpr (is_net<Points>) { // otherwise Control_net refuses it
    for (const auto& row : net)
      check_number_of_points(static_cast<int>(std::distance(std::begin(row), std::end(row))), knots_v,
                             "points in a row");
    check_number_of_points(static_cast<int>(std::distance(std::begin(net), std::end(net))), knots_u, "rows");
  }
  return Control_net<Traits>(net, "Bspline_surface");
}

// Refuses a call of the constructor of a surface.
template <class Surface> Surface refused_surface() {
  static_assert(
      !std::is_same_v<Surface, Surface>,
      "Bspline_surface takes the control net and for u and for v the knots with the degree before them, as "
      "in Bspline_surface<Traits>(net, {2, knots_u}, {3, knots_v}), where the net is a range of rows of points");
  throw Error(Error_code::wrong_number_of_points, "Bspline_surface"); // unreachable: does not compile
}

template <class FT> void check_insertion(const Knot_vector<FT>& knots, int times) {
  check_count(times, "Bspline_surface: copies of a knot");
  if (times > knots.degree() + 1) throw Error(Error_code::knot_multiplicity, "Bspline_surface: copies of a knot");
}

// The jet of order k at (u, v), from the spans to the right of the parameters: first the
// derivatives in v of the control points of all rows that matter, then those in u. coordinate(i, j,
// x) is the coordinate number x < d of a control point.
template <class Traits, class Coordinate>
Surface_jet<Traits> bspline_jet(int d, const Knot_vector<typename Traits::FT>& knots_u,
                                const Knot_vector<typename Traits::FT>& knots_v, const typename Traits::FT& u,
                                const typename Traits::FT& v, int k, Coordinate coordinate) {
  typedef typename Traits::FT FT;
  Surface_jet<Traits> jet(d, k);
  const int p = knots_u.degree(), q = knots_v.degree(), span_u = knots_u.span(u), span_v = knots_v.span(v);
  write_derivatives(
      Derivative_table<FT>(knots_u, p, span_u, u, k), Derivative_table<FT>(knots_v, q, span_v, v, k),
      [&](int i, int j, int x) { return coordinate(span_u - p + i, span_v - q + j, x); }, jet);
  return jet;
}

// The rows 0 to k at a parameter line, see `Bspline_surface::rows_at()`. point(i, j) is the control
// point, in `Field`, with d coordinates.
template <class Field, int N, class FT, class Point>
std::vector<std::vector<Coordinate_vector<Field, N>>>
bspline_rows_at(const Knot_vector<FT>& knots_u, const Knot_vector<FT>& knots_v, int d, Parameter_line line,
                const FT& parameter, Line_side side, int k, Point point) {
  typedef Coordinate_vector<Field, N> Vector;
  check_count(k, "Bspline_surface: rows");
  const bool along_u = line == Parameter_line::along_u, below = side == Line_side::smaller_parameters;
  const Knot_vector<FT>& across = along_u ? knots_v : knots_u;
  const int q = across.degree(), m = (along_u ? knots_u : knots_v).number_of_coefficients(),
            span = below ? across.left_span(parameter) : across.span(parameter);
  std::vector<Field> knots; // next to the line, with the control points that belong to them
  for (int j = span - q; j <= span + q; ++j) knots.push_back(to_field<Field>(across[j]));
  std::vector<std::vector<Vector>> points(m);
  for (int i = 0; i < m; ++i)
    for (int j = span - q; j <= span; ++j) points[i].push_back(along_u ? point(i, j) : point(j, i));
  std::vector<std::vector<Vector>> rows(k + 1, std::vector<Vector>(m, Vector(d)));
  derivative_weights(knots, q, q, to_field<Field>(parameter), k, [&](int r, const Span_weights<Field>& weights) {
    const Field sign(below && r % 2 == 1 ? -1 : 1);
    for (int i = 0; i < m; ++i) rows[r][i] = sign * weights(points[i]);
  });
  return rows;
}

// The surface as one spline function of u, whose values are the coordinates of all columns, one
// after the other.
template <class Traits>
using Spline_of_rows = Bspline_function<typename Traits::FT, Coordinate_vector<typename Traits::FT, 0>>;

template <class Traits>
Spline_of_rows<Traits> spline_of_rows(const Control_net<Traits>& net, const Knot_vector<typename Traits::FT>& knots_u) {
  const int n = net.columns(), d = net.dimension();
  std::vector<Coordinate_vector<typename Traits::FT, 0>> rows;
  for (int i = 0; i < net.rows(); ++i) {
    rows.emplace_back(n * d);
    for (int j = 0; j < n; ++j) {
      const Coordinates<Traits> x = net.coordinates(i, j);
      for (int l = 0; l < d; ++l) rows.back()[j * d + l] = x[l];
    }
  }
  return Spline_of_rows<Traits>(knots_u, std::move(rows));
}

template <class Traits> Control_net<Traits> net_of(const Spline_of_rows<Traits>& spline, int columns, int d) {
  std::vector<typename Traits::Point> points;
  for (const auto& row : spline.coefficients())
    for (int j = 0; j < columns; ++j) {
      Coordinates<Traits> x(d);
      for (int l = 0; l < d; ++l) x[l] = row[j * d + l];
      points.push_back(to_point<Traits>(x));
    }
  return Control_net<Traits>(static_cast<int>(spline.coefficients().size()), columns, std::move(points),
                             "Bspline_surface");
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BSPLINE_NET_H
