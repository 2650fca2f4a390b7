// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Edge_rows.h
/// The input and the result of a decision along an edge. All that continuity depends on are the
/// edge and the first two derivatives across it, as rows of coefficients. The answer of
/// `edge_continuity()` is the order of continuity, why it is not higher, and where. A certificate
/// has the polynomials from which anybody can see that.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The data that a polynomial surface `S(u, v)` contributes to its continuity along the edge
/// `v = 0`, `u` in [0, 1]: the edge \f$ C(u) = S(u, 0) \f$ and the cross derivatives
/// \f$ T(u) = S_v(u, 0) \f$ and \f$ W(u) = S_{vv}(u, 0) \f$, where `v` grows into the surface. Each
/// row holds Bernstein coefficients; the rows may differ in degree. For a rational surface they are
/// the rows of its homogeneous points. Only order 3 needs \f$ X(u) = S_{vvv}(u, 0) \f$, too.
/// \tparam FT a field number type
/// \tparam N the number of coordinates: 3, or 4 for homogeneous points
template <class FT_, int N = 3> struct Edge_rows {
  typedef FT_ FT;                                    ///< the type of the coordinates
  typedef std::vector<Coordinate_vector<FT, N>> Row; ///< one point or vector for each coefficient

  Row edge;             ///< the coefficients of \f$ C \f$, the control points of the edge
  Row cross;            ///< the coefficients of \f$ T \f$
  Row second_cross;     ///< the coefficients of \f$ W \f$
  Row third_cross = {}; ///< the coefficients of \f$ X \f$, or none

  /// Returns the rows of \f$ S(1-u, v) \f$.
  Edge_rows reversed() const {
    Edge_rows r = *this;
    for (Row* row : {&r.edge, &r.cross, &r.second_cross, &r.third_cross}) std::reverse(row->begin(), row->end());
    return r;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The data that a B-spline surface contributes to its continuity along an edge: `Edge_rows` whose
/// coefficients are those of splines over the knots of the edge.
/// \tparam FT a field number type
/// \tparam N the number of coordinates: 3, or 4 for homogeneous points
template <class FT_, int N = 3> struct Spline_edge_rows {
  typedef FT_ FT; ///< the type of knots and coordinates

  Knot_vector<FT> knots; ///< along the edge
  Edge_rows<FT, N> rows; ///< each with `knots.number_of_coefficients()` coefficients
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The field in which the continuity of surfaces is decided: that of the predicates of the traits
/// class, or `Exact_rational` if those are floating-point numbers. The decision is exact with every
/// kernel.
template <class Traits> using Edge_field = typename Exact_field<Predicate_FT<Traits>>::type;

namespace internal {

// Tells whether a surface is one patch, without knots.
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

// From the rows 0, 1, 2 and, where it is there, 3.
template <class Field, int N = 3, class Rows> Edge_rows<Field, N> edge_rows_in_space(const Rows& rows) {
  Edge_rows<Field, N> r{row_in_space<Field, N>(rows[0]), row_in_space<Field, N>(rows[1]),
                        row_in_space<Field, N>(rows[2])};
  if (rows.size() > 3) r.third_cross = row_in_space<Field, N>(rows[3]);
  return r;
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
Spline_edge_rows<Edge_field<typename Patch::Traits>, row_dimension<Patch>>
spline_rows_of_patch(const Patch& patch, Patch_edge edge, int order) {
  typedef Edge_field<typename Patch::Traits> Field;
  const std::pair<Field, Field> domain = edge_domain<Field>(patch, edge);
  return {Knot_vector<Field>(patch.degree_along(edge), domain.first, domain.second), edge_rows(patch, edge, order)};
}

// The rows of a surface over knots.
template <class Surface>
Spline_edge_rows<Edge_field<typename Surface::Traits>, row_dimension<Surface>>
spline_rows_of_surface(const Surface& surface, Patch_edge edge, int order) {
  typedef Edge_field<typename Surface::Traits> Field;
  require_space(surface, "spline_edge_rows");
  return {knots_over<Field>(surface.knots_along(edge)),
          edge_rows_in_space<Field, row_dimension<Surface>>(surface.template rows<Field>(edge, order))};
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, with the patch taken on the unit square and
/// turned so that the edge is at `v = 0`. Continuity does not depend on the lengths of the domain.
/// The control points are converted to `Field` before anything is computed. `(order + 1) (p + 1)`
/// coefficients for an edge of degree `p`, in as many operations.
/// \param order 2, or 3 for all rows
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Field, class Traits>
Edge_rows<Field> edge_rows_over(const Bezier_patch<Traits>& patch, Patch_edge edge, int order = 2) {
  internal::require_space(patch, "edge_rows");
  return internal::edge_rows_in_space<Field>(patch.template rows<Field>(edge, order));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, see `edge_rows_over()`, in the field in
/// which continuity is decided.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Edge_rows<Edge_field<Traits>> edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge, int order = 2) {
  return edge_rows_over<Edge_field<Traits>>(patch, edge, order);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of the homogeneous points of a rational patch along one of its edges, in the
/// field in which continuity is decided; see the function for `Bezier_patch`.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Edge_rows<Edge_field<Traits>, 4> edge_rows(const Rational_bezier_patch<Traits>& patch, Patch_edge edge, int order = 2) {
  internal::require_space(patch, "edge_rows");
  return internal::edge_rows_in_space<Edge_field<Traits>, 4>(patch.template rows<Edge_field<Traits>>(edge, order));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a patch along one of its edges, see `edge_rows()`, as splines over the
/// domain of the edge.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge,
                                                      int order = 2) {
  return internal::spline_rows_of_patch(patch, edge, order);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a rational patch along one of its edges, see `edge_rows()`, as splines over
/// the domain of the edge.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>, 4> spline_edge_rows(const Rational_bezier_patch<Traits>& patch, Patch_edge edge,
                                                         int order = 2) {
  return internal::spline_rows_of_patch(patch, edge, order);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of a B-spline surface along one of its edges, over the knots of the edge, in
/// the field in which continuity is decided. Derivatives are those with respect to the parameter
/// that grows into the surface. Control points and knots are converted before anything is computed.
/// Linear in the number of knots.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bspline_surface<Traits>& surface, Patch_edge edge,
                                                      int order = 2) {
  return internal::spline_rows_of_surface(surface, edge, order);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the rows of the homogeneous points of a rational B-spline surface along one of its
/// edges, see the function for `Bspline_surface`.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>, 4> spline_edge_rows(const Rational_bspline_surface<Traits>& surface,
                                                         Patch_edge edge, int order = 2) {
  return internal::spline_rows_of_surface(surface, edge, order);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Why two surfaces are not smoother along an edge than they are.
enum class Edge_defect {
  none,      ///< they have the highest order that is decided, \f$ G^2 \f$
  gap,       ///< the edges are different curves
  collapsed, ///< the edge is a single point
  /// the tangent planes agree wherever there are any, but the normal of one side vanishes somewhere
  vanishing_normal,
  crease, ///< the tangent planes differ somewhere
  /// the tangent planes agree, but somewhere both surfaces lie on the same side of the edge
  fold,
  curvature ///< the tangent planes agree, the curvatures do not
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the name of a defect, as spelled in the enumeration.
inline std::string to_string(Edge_defect defect) {
  // unreachable: every value has a case
  switch (defect) {
  case Edge_defect::none: return "none";
  case Edge_defect::gap: return "gap";
  case Edge_defect::collapsed: return "collapsed";
  case Edge_defect::vanishing_normal: return "vanishing_normal";
  case Edge_defect::crease: return "crease";
  case Edge_defect::fold: return "fold";
  case Edge_defect::curvature: return "curvature";
  }
  // unreachable: every value has a case
  return "unknown";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes the name of a defect.
inline std::ostream& operator<<(std::ostream& os, Edge_defect defect) { return os << to_string(defect); }

/// \ingroup PkgGeometricContinuityContinuity
/// Returns how severe a defect is, from 0 for none to 6 for a gap: it decides which of several
/// spans is called the worst. In increasing severity: none, curvature, collapsed, vanishing normal,
/// fold, crease, gap.
inline int severity(Edge_defect defect) {
  // unreachable: every value has a case
  switch (defect) {
  case Edge_defect::none: return 0;
  case Edge_defect::curvature: return 1;
  case Edge_defect::collapsed: return 2;
  case Edge_defect::vanishing_normal: return 3;
  case Edge_defect::fold: return 4;
  case Edge_defect::crease: return 5;
  case Edge_defect::gap: return 6;
  }
  // unreachable: every value has a case
  return 7;
}

/// \ingroup PkgGeometricContinuityContinuity
/// The questions about creases. Finding the largest angle takes most of the time of a crease.
enum class Crease_angles {
  enclosed, ///< the largest angle, too
  omitted   ///< orders and defects only: `Edge_continuity::deviation` may be empty
};

/// \ingroup PkgGeometricContinuityContinuity
/// A guaranteed enclosure of the largest angle \f$ \theta \in [0, \pi] \f$ between the normals of
/// two surfaces along their common edge, both turned so that \f$ \theta = 0 \f$ where the surfaces
/// continue each other and \f$ \theta = \pi \f$ where they fold back. Points where a normal
/// vanishes are left out; limits at them count.
///
/// The angle is given without roots by its measure \f$ 1 - \cos\theta\,|\cos\theta| \f$, which
/// grows with it from 0 over 1 for a right angle to 2: it is \f$ \sin^2\theta \f$ up to the right
/// angle and \f$ 2 - \sin^2\theta \f$ beyond. The measure is so accurate that `angle()` is at most
/// four units in the last place wide, unless the angle varies at scales near the limits of
/// floating-point numbers.
/// \tparam FT a field number type
template <class FT> struct Normal_deviation {
  FT lower; ///< the measure of an angle that occurs on the edge, or as a limit
  FT upper; ///< the measure of an angle that is not exceeded anywhere on the edge
  FT begin; ///< the sub-interval of the parameters of the edge
  FT end;   ///< where the angle is largest

  /// Returns an enclosure of the largest angle, in radians. It needs `CGAL::to_interval()` of `FT`.
  Enclosure angle() const { return {smallest_angle(), largest_angle()}; }
  /// Returns the lower bound of `angle()`.
  double smallest_angle() const { return angle(lower).lower; }
  /// Returns the upper bound of `angle()`.
  double largest_angle() const { return angle(upper).upper; }

  /// Returns an enclosure of the angle that has a measure between 0 and 2, in radians. It needs
  /// `CGAL::to_interval()`.
  /// \throws Error `parameter_outside_domain` for another measure
  static Enclosure angle(const FT& measure) {
    if (measure < FT(0) || FT(2) < measure)
      throw Error(Error_code::parameter_outside_domain, "Normal_deviation::angle: a measure is between 0 and 2");
    const bool obtuse = FT(1) < measure;
    const FT sine_squared = obtuse ? FT(FT(2) - measure) : measure;
    return internal::angle_of_squares(sine_squared, FT(FT(1) - sine_squared), obtuse);
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The decision about two surfaces along an edge.
/// \tparam FT the field in which it was decided
template <class FT> struct Edge_continuity {
  /// -1 when the edges differ, 0 when they are the same curve, 1 when the tangent planes agree
  /// along the whole closed edge and the surfaces lie on different sides of it, 2 when the
  /// curvatures agree as well.
  int g_order = -1;
  Edge_defect defect = Edge_defect::gap; ///< why the order is not higher
  bool reversed = false;                 ///< the second edge runs backwards
  bool coplanar = false;                 ///< \f$ \det(C', T_1, T_2) \equiv 0 \f$
  /// The signs of \f$ (C' \times T_1) \cdot (C' \times T_2) \f$: `negative` where the surfaces
  /// continue each other.
  Sign_pattern side = Sign_pattern::zero;
  bool collapsed = false;       ///< the edge is a single point
  bool normal_vanishes = false; ///< a normal vanishes somewhere on the closed edge
  /// The sub-interval of the parameters of the first edge, at most 1/32 of it, in which a normal
  /// vanishes: a point when it was found exactly. Empty where no normal vanishes or the edge is
  /// collapsed.
  std::optional<std::pair<FT, FT>> vanishing;
  /// The enclosure of the largest angle between the normals and the place of a crease or fold, in
  /// the parameters of the first edge. Empty without a common edge, where one normal vanishes
  /// identically, and possibly at creases with `Crease_angles::omitted`.
  std::optional<Normal_deviation<FT>> deviation;

  /// \cond SKIP_IN_MANUAL
  CGAL_GEOMETRIC_CONTINUITY_NO_ORDERS("edge_continuity(a, b).g_order is the order along an edge, without parentheses; "
                                      "is_g2_edge(a, b) is true or false")
  /// \endcond

  /// Writes the order, the defect and the upper bound of the angle in degrees, rounded upwards to
  /// the precision of the stream, e.g. `G1 (curvature)` or `G0 (crease), angle <= 17.2 degrees`.
  friend std::ostream& operator<<(std::ostream& os, const Edge_continuity& e) {
    if (e.g_order < 0) return os << "gap";
    os << 'G' << e.g_order;
    if (e.defect != Edge_defect::none) os << " (" << e.defect << ')';
    if (e.reversed) os << ", reversed";
    if (e.deviation && FT(0) < e.deviation->upper) {
      const double largest = e.deviation->largest_angle();
      os << ", angle <= "
         << internal::decimal_above(in_degrees({largest, largest}).upper, static_cast<int>(os.precision()))
         << " degrees";
    }
    return os;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The decision about two surfaces along an interval of their common edge on which both are
/// polynomials.
/// \tparam FT the field in which it was decided
template <class FT> struct Edge_span {
  FT begin; ///< the parameter of the first edge
  FT end;   ///< where the span ends, in the same parameter
  /// on the closed span; all parameters in it are those of the first edge
  Edge_continuity<FT> continuity;
};

/// \ingroup PkgGeometricContinuityContinuity
/// The decision about two piecewise polynomial surfaces along the part that their edges have in
/// common, on each span of the knots of both. The members of the base class hold for the whole
/// part:
///
/// - `g_order` is the least order of all spans, and `defect` belongs to `worst`;
/// - `coplanar` and `collapsed` hold when they do on all spans, `normal_vanishes` when it does on
///   one, with the first sub-interval in `vanishing`; `side` has the signs of all spans;
/// - `deviation` encloses the largest angle of all spans.
///
/// All parameters are those of the first edge, unless stated otherwise. Without a common part there
/// are no spans, and the order is -1.
/// \tparam FT the field in which it was decided
template <class FT> struct Spline_edge_continuity : Edge_continuity<FT> {
  std::vector<Edge_span<FT>> spans; ///< in the order of the parameters of the first edge
  /// the number of the span that has the most severe defect, see `severity()`
  std::size_t worst = 0;
  std::pair<FT, FT> part_a{FT(0), FT(0)}; ///< the part of the first edge that is common
  std::pair<FT, FT> part_b{FT(0), FT(0)}; ///< the same part of the second edge, in its parameters
  bool whole_a = false;                   ///< the common part is all of the first edge
  bool whole_b = false;                   ///< the common part is all of the second edge

  // This refuses the verdict in the place of a number.
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>> operator Number() const {
    static_assert(!std::is_same_v<Number, Number>, "the order along an edge is .g_order; is_g2_edge(a, b) is true or "
                                                   "false");
    return Number();
  }

  /// Writes the whole, then the place of the worst of several spans, and the part if it is not all
  /// of both edges; e.g. `G1 (curvature), worst of 3 spans on [0, 1/2]` or
  /// `G2, a part of the second edge`.
  friend std::ostream& operator<<(std::ostream& os, const Spline_edge_continuity& e) {
    os << static_cast<const Edge_continuity<FT>&>(e);
    if (e.spans.size() > 1 && e.defect != Edge_defect::none)
      os << ", worst of " << e.spans.size() << " spans on [" << e.spans[e.worst].begin << ", " << e.spans[e.worst].end
         << ']';
    if (!e.spans.empty() && !(e.whole_a && e.whole_b))
      os << ", a part of " << (e.whole_b ? "the first edge" : e.whole_a ? "the second edge" : "both edges");
    return os;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// A certificate of the order of two surfaces along a span of an edge, which anybody can check by
/// multiplying polynomials. All points are homogeneous, of polynomial surfaces with the weight 1;
/// `P(u)` is the edge, `u` in [0, 1], and \f$ P_u, P_v, Q_v, P_{vv}, \dots \f$ are derivatives of
/// the first surface `P` and of the second one `Q`, where `v` grows into each surface. With the
/// planes \f$ \pi \f$ and \f$ \rho \f$, \f$ \pi \cdot x = \det(x, P, P_u, P_v) \f$ and
/// \f$ \rho \cdot x = \det(x, P, P_u, Q_v) \f$, and coordinates `i` of planes:
///
/// - \f$ G^1 \f$ holds if \f$ \pi \cdot Q_v \equiv 0 \f$, which is the determinant, and
///   \f$ \pi_1\rho_1 + \pi_2\rho_2 + \pi_3\rho_3 < 0 \f$ on the closed interval, where the first
///   three coordinates are normals;
/// - then \f$ Q_v = a P + \frac{m}{d} P_u + \frac{n}{d} P_v \f$ with the factors \f$ d = \pi_i \f$,
///   \f$ m = \det(e_i, P, Q_v, P_v) \f$ and \f$ n = \rho_i \f$, where `i` is the first coordinate
///   with \f$ \pi_i \not\equiv 0 \f$;
/// - \f$ G^2 \f$ holds if
///   \f$ d^2 (\pi \cdot Q_{vv}) - m^2 (\pi \cdot P_{uu}) - 2 m n (\pi \cdot P_{uv}) - n^2 (\pi \cdot P_{vv}) \equiv 0 \f$,
///   too.
/// \tparam FT an exact field
template <class FT> struct Edge_certificate {
  typedef Power_polynomial<FT> Polynomial; ///< in the parameter `u`

  FT begin;           ///< the parameter of the first edge
  FT end;             ///< where the span ends
  int g_order;        ///< the same as `Edge_continuity::g_order`
  Edge_rows<FT, 4> a; ///< \f$ P, P_v, P_{vv} \f$
  /// \f$ Q, Q_v, Q_{vv} \f$, in the direction of the first edge, with the weight of `P` where the
  /// span begins
  Edge_rows<FT, 4> b;
  std::optional<Polynomial> determinant; ///< empty where the edges are different curves
  /// the scalar product of the normals; empty where the edges are different curves
  std::optional<Polynomial> side;
  std::vector<Polynomial> factors; ///< `d`, `m`, `n` for an order of 1 or 2
  /// the difference of both sides of the identity of \f$ G^2 \f$, for an order of 1 or 2
  std::optional<Polynomial> second_order;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ROWS_H
