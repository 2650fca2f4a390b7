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
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

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
/// grows into the surface. Each row holds Bernstein coefficients; the rows may differ in degree. Of a rational surface they are
/// those of its homogeneous points.
/// \tparam FT a field number type
/// \tparam N the number of coordinates: 3, or 4 for homogeneous points
template <class FT_, int N = 3> struct Edge_rows {
  typedef FT_ FT;                                    ///< the type of the coordinates
  typedef std::vector<Coordinate_vector<FT, N>> Row; ///< one point or vector for each coefficient

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
/// \tparam N the number of coordinates: 3, or 4 for homogeneous points
template <class FT_, int N = 3> struct Spline_edge_rows {
  typedef FT_ FT; ///< the type of knots and coordinates

  Knot_vector<FT> knots; ///< along the edge
  Edge_rows<FT, N> rows; ///< each with `knots.number_of_coefficients()` coefficients
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The field in which the continuity of surfaces is decided: that of the predicates of the traits class, or
/// `Exact_rational` if those are floating-point numbers. The decision is exact with every kernel.
template <class Traits> using Edge_field = typename Exact_field<Predicate_FT<Traits>>::type;

namespace internal {

// Whether the rows of a surface are those of homogeneous points.
// Whether a surface is one patch, without knots.
template <class Surface> struct Is_patch : std::false_type {};
template <class Traits> struct Is_patch<Bezier_patch<Traits>> : std::true_type {};
template <class Traits> struct Is_patch<Rational_bezier_patch<Traits>> : std::true_type {};

// The number of coordinates in the rows of one or two surfaces.
template <class Surface_a, class Surface_b = Surface_a>
constexpr int row_dimension = Is_rational<Surface_a>::value || Is_rational<Surface_b>::value ? 4 : 3;

// Rational surfaces with equal weights are decided as polynomial ones, which is faster.
template <class Surface> bool has_equal_weights(const Surface& surface) {
  if constexpr (Is_rational<Surface>::value)
    return surface.is_polynomial();
  else
    return true;
}
template <class Surface> decltype(auto) without_weights(const Surface& surface) {
  if constexpr (Is_rational<Surface>::value)
    return std::decay_t<decltype(*surface.polynomial())>(*surface.polynomial());
  else
    return (surface);
}

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

template <class Field, int N = 3, class Row> typename Edge_rows<Field, N>::Row row_in_space(const Row& row) {
  typename Edge_rows<Field, N>::Row result;
  result.reserve(row.size());
  for (const auto& x : row) {
    result.emplace_back(N);
    for (int i = 0; i < N; ++i) result.back()[i] = to_field<Field>(x[i]);
  }
  return result;
}

// From the rows 0, 1 and 2.
template <class Field, int N = 3, class Rows> Edge_rows<Field, N> edge_rows_in_space(const Rows& rows) {
  return {row_in_space<Field, N>(rows[0]), row_in_space<Field, N>(rows[1]), row_in_space<Field, N>(rows[2])};
}

template <class Field, class FT> Knot_vector<Field> knots_over(const Knot_vector<FT>& knots) {
  std::vector<Field> u;
  for (const FT& x : knots) u.push_back(to_field<Field>(x));
  return Knot_vector<Field>(knots.degree(), std::move(u));
}

// The domain of an edge.
template <class Field, class Surface> std::pair<Field, Field> edge_domain(const Surface& surface, Patch_edge edge) {
  const typename Surface::Interval domain = runs_along_u(edge) ? surface.domain_u() : surface.domain_v();
  return {to_field<Field>(domain.first), to_field<Field>(domain.second)};
}

// The rows of a patch, as splines over the domain of the edge.
template <class Patch>
Spline_edge_rows<Edge_field<typename Patch::Traits>, row_dimension<Patch>> spline_rows_of_patch(const Patch& patch,
                                                                                                Patch_edge edge) {
  typedef Edge_field<typename Patch::Traits> Field;
  const std::pair<Field, Field> domain = edge_domain<Field>(patch, edge);
  return {Knot_vector<Field>(patch.degree_along(edge), domain.first, domain.second), edge_rows(patch, edge)};
}

// The rows of a surface over knots.
template <class Surface>
Spline_edge_rows<Edge_field<typename Surface::Traits>, row_dimension<Surface>>
spline_rows_of_surface(const Surface& surface, Patch_edge edge) {
  typedef Edge_field<typename Surface::Traits> Field;
  require_space(surface, "spline_edge_rows");
  return {knots_over<Field>(surface.knots_along(edge)),
          edge_rows_in_space<Field, row_dimension<Surface>>(surface.template rows<Field>(edge, 2))};
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
/// Returns the rows of the homogeneous points of a rational patch along one of its edges, in the field in which continuity is
/// decided; see the function for `Bezier_patch`.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Edge_rows<Edge_field<Traits>, 4> edge_rows(const Rational_bezier_patch<Traits>& patch, Patch_edge edge) {
  internal::require_space(patch, "edge_rows");
  return internal::edge_rows_in_space<Edge_field<Traits>, 4>(patch.template rows<Edge_field<Traits>>(edge, 2));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, see `edge_rows()`, as splines over the domain of the edge.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  return internal::spline_rows_of_patch(patch, edge);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a rational patch along one of its edges, see `edge_rows()`, as splines over the domain of the edge.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>, 4> spline_edge_rows(const Rational_bezier_patch<Traits>& patch, Patch_edge edge) {
  return internal::spline_rows_of_patch(patch, edge);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a B-spline surface along one of its edges, over the knots of the edge, in the field in which
/// continuity is decided. Derivatives are those with respect to the parameter that grows into the surface. Control points
/// and knots are converted before anything is computed. Linear in the number of knots.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bspline_surface<Traits>& surface, Patch_edge edge) {
  return internal::spline_rows_of_surface(surface, edge);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of the homogeneous points of a rational B-spline surface along one of its edges, see the function for
/// `Bspline_surface`.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>, 4> spline_edge_rows(const Rational_bspline_surface<Traits>& surface,
                                                         Patch_edge edge) {
  return internal::spline_rows_of_surface(surface, edge);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H
