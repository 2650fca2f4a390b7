// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Edge_rows.h
/// All that continuity along an edge depends on: the edge and the first two derivatives across it, as rows of coefficients.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What a polynomial surface `S(u, v)` contributes to its continuity along the edge `v = 0`, `u` in [0, 1]: the edge
/// \f$ C(u) = S(u, 0) \f$ and the cross derivatives \f$ T(u) = S_v(u, 0) \f$ and \f$ W(u) = S_{vv}(u, 0) \f$, where `v`
/// grows into the surface. Each row holds Bernstein coefficients; the rows may differ in degree.
/// \tparam FT a field number type
template <class FT_> struct Edge_rows {
  typedef FT_ FT;                                    ///< the type of the coordinates
  typedef std::vector<Coordinate_vector<FT, 3>> Row; ///< one point or vector for each coefficient

  Row edge;         ///< the coefficients of \f$ C \f$, the control points of the edge
  Row cross;        ///< the coefficients of \f$ T \f$
  Row second_cross; ///< the coefficients of \f$ W \f$

  /// Returns the rows of \f$ S(1-u, v) \f$.
  Edge_rows reversed() const {
    Edge_rows r = *this;
    for (Row* row : {&r.edge, &r.cross, &r.second_cross}) std::reverse(row->begin(), row->end());
    return r;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// What a B-spline surface contributes to its continuity along an edge: `Edge_rows` whose coefficients are those of splines
/// over the knots of the edge.
/// \tparam FT a field number type
template <class FT_> struct Spline_edge_rows {
  typedef FT_ FT; ///< the type of knots and coordinates

  Knot_vector<FT> knots; ///< along the edge
  Edge_rows<FT> rows;    ///< each with `knots.number_of_coefficients()` coefficients
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The field in which the continuity of surfaces is decided: that of the predicates of the traits class, or
/// `Exact_rational` if those are floating-point numbers. The decision is exact with every kernel.
template <class Traits> using Edge_field = typename Exact_field<Predicate_FT<Traits>>::type;

namespace internal {

// How the second of two edges runs that are the same curve.
enum class Edge_direction { same, opposite };

template <class Surface> void require_space(const Surface& surface, const char* function) {
  static_assert(Surface::N == 0 || Surface::N == 3, "surfaces are compared in dimension 3");
  if (surface.dimension() != 3)
    throw Error(Error_code::dimension_mismatch, std::string(function) + ": surfaces are compared in dimension 3");
}

template <class Surface_a, class Surface_b>
void require_space(const Surface_a& a, const Surface_b& b, const char* function) {
  static_assert(std::is_same_v<typename Surface_a::Traits, typename Surface_b::Traits>,
                "both surfaces must have the same traits class");
  require_space(a, function);
  require_space(b, function);
}

template <class Field, class Row> typename Edge_rows<Field>::Row row_in_space(const Row& row) {
  typename Edge_rows<Field>::Row result;
  result.reserve(row.size());
  for (const auto& x : row) {
    result.emplace_back(3);
    for (int i = 0; i < 3; ++i) result.back()[i] = to_field<Field>(x[i]);
  }
  return result;
}

// From the rows 0, 1 and 2.
template <class Field, class Rows> Edge_rows<Field> edge_rows_in_space(const Rows& rows) {
  return {row_in_space<Field>(rows[0]), row_in_space<Field>(rows[1]), row_in_space<Field>(rows[2])};
}

template <class Field, class FT> Knot_vector<Field> knots_over(const Knot_vector<FT>& knots) {
  std::vector<Field> u;
  for (const FT& x : knots) u.push_back(to_field<Field>(x));
  return Knot_vector<Field>(knots.degree(), std::move(u));
}

// The domain of an edge.
template <class Field, class Traits>
std::pair<Field, Field> edge_domain(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  const typename Bezier_patch<Traits>::Interval domain = patch.domain(edge);
  return {to_field<Field>(domain.first), to_field<Field>(domain.second)};
}
template <class Field, class Traits>
std::pair<Field, Field> edge_domain(const Bspline_surface<Traits>& surface, Patch_edge edge) {
  const typename Bspline_surface<Traits>::Interval domain = surface.knots_along(edge).domain();
  return {to_field<Field>(domain.first), to_field<Field>(domain.second)};
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, with the patch taken on the unit square and turned so that the edge is
/// at `v = 0`. Continuity does not depend on the lengths of the domain. The control points are converted to `Field` before
/// anything is computed. `3 (p + 1)` coefficients for an edge of degree `p`, in as many operations.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Field, class Traits>
Edge_rows<Field> edge_rows_over(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  internal::require_space(patch, "edge_rows");
  return internal::edge_rows_in_space<Field>(patch.template rows<Field>(edge, 2));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, see `edge_rows_over()`, in the field in which continuity is decided.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits> Edge_rows<Edge_field<Traits>> edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  return edge_rows_over<Edge_field<Traits>>(patch, edge);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, see `edge_rows()`, as splines over the domain of the edge.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  typedef Edge_field<Traits> Field;
  const std::pair<Field, Field> domain = internal::edge_domain<Field>(patch, edge);
  return {Knot_vector<Field>(patch.degree_along(edge), domain.first, domain.second), edge_rows(patch, edge)};
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a B-spline surface along one of its edges, over the knots of the edge, in the field in which
/// continuity is decided. Derivatives are those with respect to the parameter that grows into the surface. Control points
/// and knots are converted before anything is computed. Linear in the number of knots.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bspline_surface<Traits>& surface, Patch_edge edge) {
  typedef Edge_field<Traits> Field;
  internal::require_space(surface, "spline_edge_rows");
  return {internal::knots_over<Field>(surface.knots_along(edge)),
          internal::edge_rows_in_space<Field>(surface.template rows<Field>(edge, 2))};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H
