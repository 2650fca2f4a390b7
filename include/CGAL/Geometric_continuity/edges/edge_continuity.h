// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>
#include <CGAL/Geometric_continuity/edges/internal/decide_surfaces.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_certificates_on.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file edge_continuity.h
/// The continuity of two surfaces along an edge of each, decided exactly on the whole closed edge;
/// for every mix of surface types, and for rows of coefficients. See `Edge_conditions` for the
/// conditions that are decided. `edge_continuity()` tells the order, the reason and the place,
/// `is_g0_edge()`, `is_g1_edge()`, `is_g2_edge()` and `is_g3_edge()` answer one question each,
/// `knot_line_continuity()` looks inside a surface, and `common_edges()` finds the edges that two
/// patches share.
///
/// The answers of the predicates are those of `edge_continuity()`, without its reasons and places.
/// Two surfaces without inner knots whose coordinates are `double`, of whatever kernel, or rational
/// numbers with short numerators, and the spans of other surfaces, are decided in stages: control
/// points that differ are a gap; values at the ends that exceed their proven rounding errors
/// refute; integers of fixed length on a grid decide nearly all other edges of degree 7 or less;
/// and multi-precision numbers the rest.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The polynomials that decide the continuity of two surfaces \f$ S_1, S_2 \f$ whose edges are the
/// same curve in the same direction. With the rows \f$ C, T_1, W_1 \f$ and \f$ C, T_2, W_2 \f$ and
/// \f$ N = C' \times T_1 \f$:
///
/// - \f$ G^1 \f$: \f$ \det(C', T_1, T_2) \equiv 0 \f$ and
///   \f$ (C' \times T_1) \cdot (C' \times T_2) < 0 \f$ on the whole closed interval;
/// - \f$ G^2 \f$: in addition, with \f$ n_2 = C' \times T_2 \f$ and \f$ n_3 = T_2 \times T_1 \f$,
///   for each coordinate `i`
///   \f$ N_i^2 (N \cdot W_2) \equiv n_{3,i}^2 (N \cdot C'') + 2 n_{3,i} n_{2,i} (N \cdot T_1') + n_{2,i}^2 (N \cdot W_1) \f$.
///
/// For \f$ T_2 = p\,C' + q\,T_1 \f$ this is the equality of the second fundamental forms:
/// \f$ n_2 = qN \f$, \f$ n_3 = pN \f$.
///
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
template <class FT> class Edge_conditions {
public:
  /// The field of the answers: `FT`, or `Exact_rational` for floating-point numbers.
  typedef typename Exact_field<FT>::type Field;

  /// Takes the rows of two surfaces with the same edge in the same direction, which is not checked.
  /// The degrees may differ. Costs a number of ring operations that is quadratic in the degree.
  /// \param a, b the rows
  /// \throws Error `wrong_number_of_points` for an empty row, `not_finite`, `work_limit`: here and
  ///   in each question
  Edge_conditions(const Edge_rows<FT>& a, const Edge_rows<FT>& b)
      : Edge_conditions(a, b, internal::Work_guard(place)) {}

  /// Returns \f$ \det(C', T_1, T_2) \f$. With rows of degrees `p` (the lower of the two edges), `l`
  /// and `m` it has the coefficients
  /// \f$ \binom{p+l+m-1}{k}^{-1} \sum_{i+j+h=k} \binom{p-1}{i} \binom{l}{j} \binom{m}{h} \det(p\,\Delta C_i, T_{1,j}, T_{2,h}) \f$.
  Bernstein_polynomial<Field> determinant() const { return bernstein(normals_.det, 3); }

  /// Returns \f$ (C' \times T_1) \cdot (C' \times T_2) \f$: negative where the surfaces lie on
  /// different sides of the edge.
  Bernstein_polynomial<Field> side() const { return bernstein(normals_.side, 4); }

  /// Returns whether the determinant vanishes identically: the tangent planes agree wherever there
  /// are any.
  bool coplanar() const { return normals_.coplanar(); }

  /// Returns the signs of `side()` on the closed interval.
  Sign_pattern side_pattern() const {
    const internal::Work_guard work(place);
    return normals_.side_signs();
  }

  /// Returns whether a normal vanishes somewhere on the closed interval.
  bool normal_vanishes() const {
    const internal::Work_guard work(place);
    return normals_.normal_vanishes(side_pattern());
  }

  /// Returns whether `coplanar()` holds and the identity of \f$ G^2 \f$, which alone does not see
  /// on which sides the surfaces lie.
  bool second_order() const {
    const internal::Work_guard work(place);
    return coplanar() && normals_.second_order(sides_);
  }

  /// Returns whether the surfaces are \f$ G^1 \f$ along the whole closed edge.
  bool g1() const { return coplanar() && side_pattern() == Sign_pattern::negative; }
  /// Returns whether the surfaces are \f$ G^2 \f$ along the whole closed edge.
  bool g2() const { return g1() && second_order(); }

private:
  static constexpr const char* place = "Edge_conditions";
  internal::Edge_sides<Field> sides_;
  internal::Edge_normals<Field> normals_;

  Edge_conditions(const Edge_rows<FT>& a, const Edge_rows<FT>& b, internal::Work_guard&&)
      : sides_(a, b), normals_(sides_) {}

  template <class Polynomial> Bernstein_polynomial<Field> bernstein(const Polynomial& p, int power) const {
    typedef typename internal::Common_denominator<Field>::Exact Exact;
    const Bernstein_polynomial<Exact> scaled = p.template bernstein<Exact>();
    std::vector<Field> b;
    for (const Exact& x : scaled.coefficients()) b.push_back(sides_.denominator.divided(x, power));
    return Bernstein_polynomial<Field>(std::move(b));
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of two surfaces along their edges `v = 0`, exactly and on the whole
/// closed edge, see `Edge_conditions`. The edges are the same when their points and their
/// parametrisations are, after exact elevation to one degree; the second one may run backwards. (An
/// affine reparametrisation that maps an edge as a whole to itself is the identity or the
/// reversal.) Where the normal of one side vanishes there is no tangent plane, hence no
/// \f$ G^1 \f$; this is reported as such. All parameters in the result are those of the first edge,
/// in [0, 1].
///
/// When the surfaces are not \f$ G^1 \f$, the largest angle between their normals
/// \f$ n_i = C' \times T_i \f$ is enclosed by branch and bound on the Bernstein coefficients of
/// \f$ \sin^2\theta = 1 - (n_1 \cdot n_2)^2 / (|n_1|^2 |n_2|^2) \f$, in integers of fixed length
/// that are rounded outwards or, where these do not suffice, in exact arithmetic. Where the limit
/// of the work does not suffice for a close enclosure, it is a wider one; the answer is exact, or
/// refused by an error.
///
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
/// \throws Error `wrong_number_of_points` for an empty row, `not_finite`, `work_limit`
template <class FT>
Edge_continuity<typename Exact_field<FT>::type> edge_continuity(const Edge_rows<FT>& a, const Edge_rows<FT>& b) {
  typedef typename Exact_field<FT>::type Field;
  const internal::Work_guard work("edge_continuity");
  internal::Edge_sides<Field> sides(a, b);
  const std::optional<bool> reversed = sides.align();
  if (!reversed) return {};
  Edge_continuity<Field> edge = internal::Edge_decision<Field>()(sides);
  edge.reversed = *reversed;
  return edge;
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of two piecewise polynomial surfaces along the part that their edges have
/// in common, exactly, on each closed span of the knots of both, see the function for `Edge_rows`.
///
/// The edges may differ in degree, in knots and in domain. First they are compared as a whole: they
/// are the same when the affine map of the one domain to the other, forwards or backwards, makes
/// them the same curve. Otherwise the longest part is found on which some affine map of the
/// parameters does and which contains the first or the last span of one of the edges: all of one
/// edge where several patches meet one long edge, or where the edges overlap. (One case is not
/// found: a part that is not all of both edges and whose polynomial depends only on a power
/// \f$ (t - c)^g \f$, `g > 1`, of the parameter.)
///
/// Only the rows are restricted to common spans; no surface is refined. For edges that are the same
/// as a whole the number of operations is linear in the number of knots, otherwise it is at most
/// quadratic. On each span rational numbers with short numerators are decided with integers of
/// fixed length, as for surfaces.
///
/// Rows of homogeneous points, `N = 4`, are those of rational surfaces. Then edges are the same
/// curve where their homogeneous points differ by a constant factor on each span, and the
/// conditions are those of the tangent planes in homogeneous space, with
/// \f$ C \wedge C' \wedge T \f$ in place of \f$ C' \times T \f$. Edges that are the same points in
/// another rational parametrisation, or with a factor that is not constant, are not recognised as
/// the same, unless they are collapsed. With one degree and the same knots this happens where the
/// weights of one edge are those of the other times \f$ c^i \f$, and where the homogeneous points
/// of both have been multiplied by different polynomials: both curves are then of less degree than
/// they seem.
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
/// \tparam N the number of coordinates: 3, or 4 for homogeneous points
/// \throws Error `wrong_number_of_points` when the rows do not fit the knots, `not_finite`,
///   `work_limit`; `zero_weight` where a denominator is zero
template <class FT, int N>
Spline_edge_continuity<typename Exact_field<FT>::type> edge_continuity(const Spline_edge_rows<FT, N>& a,
                                                                       const Spline_edge_rows<FT, N>& b) {
  return internal::decide_rows<typename Exact_field<FT>::type>(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of two surfaces along an edge of each, exactly, on the whole closed edge
/// and with every kernel: control points and knots are taken as they are given. The edge of `b` may
/// run backwards, and degrees, knots and domains may differ. When the edges are not the same, the
/// part that they have in common is decided, e.g. where several surfaces meet one long edge;
/// members of the result say which part of each edge it is. The result has a verdict for each span
/// of the knots of both edges; see the function for `Spline_edge_rows`.
///
/// All parameters in the result are those of the domain of the edge of `a`, without rounding. For
/// two edges of one surface that closes up, `a` and `b` are the same surface.
/// `knot_line_continuity()` decides the continuity at knots across the edge inside one of the
/// surfaces. For the two sides of a ribbon pass `G1_ribbon::side1` and `G1_ribbon::side2`; swept
/// surfaces have `extrusion_continuity()` and `revolution_continuity()`.
///
/// Smooth edges of degree 7 or less are proved with integers of fixed length where the coordinates
/// are `double`, or rational numbers with short numerators over one denominator; see above. So are
/// most creases of degree 5 or less, and with `double` also edges of B-spline surfaces over inner
/// knots where the derivatives across them are the same but for the speed of the parameter.
/// Otherwise a number of operations with integers
/// that is quadratic in the degree and linear in the number of knots, plus the search for the
/// largest angle where the surfaces are not \f$ G^1 \f$. Smooth edges of rational patches, and of
/// spans of rational B-spline surfaces, are proved with integers of fixed length where points and
/// weights are `double`, or homogeneous points rational numbers of at most 105 bits.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, in any combination, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface_a, class Surface_b>
auto edge_continuity(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b)
    -> Spline_edge_continuity<Edge_field<typename Surface_a::Traits>> {
  return internal::decide_surfaces(a, edge_a, b, edge_b, [](const auto& pieces_a, const auto& pieces_b) {
    return internal::common_edge_part(pieces_a, pieces_b);
  });
}

namespace internal {

// A pair of edges and the verdict on them.
template <class FT> struct Verdict_on_edges {
  Patch_edge edge_a, edge_b;
  Spline_edge_continuity<FT> verdict;
};

// The verdict on the one edge that two surfaces have in common, if there is one: the only pair of
// edges that have more than a point in common, first of those that are the same as a whole, then of
// which a part is the same. The edges of one surface are paired with each other.
template <class Surface_a, class Surface_b>
std::optional<Verdict_on_edges<Edge_field<typename Surface_a::Traits>>> verdict_on_common_edge(const Surface_a& a,
                                                                                               const Surface_b& b) {
  const bool same = static_cast<const void*>(&a) == static_cast<const void*>(&b);
  for (bool whole : {true, false}) {
    std::string names;
    std::vector<Verdict_on_edges<Edge_field<typename Surface_a::Traits>>> verdicts;
    for (Patch_edge edge_a : patch_edges)
      for (Patch_edge edge_b : patch_edges) {
        if ((same && !(edge_a < edge_b)) || (whole && !edge_has_order<0>(a, edge_a, b, edge_b))) continue;
        auto verdict = edge_continuity(a, edge_a, b, edge_b);
        if (verdict.g_order < 0 || verdict.collapsed) continue;
        names += std::string(verdicts.empty() ? "" : ", ") + to_string(edge_a) + " and " + to_string(edge_b);
        verdicts.push_back({edge_a, edge_b, std::move(verdict)});
      }
    if (verdicts.size() == 1) return std::move(verdicts[0]);
    if (verdicts.size() > 1)
      throw Error(Error_code::several_common_edges, "edge_continuity: " + names +
                                                        "; name one pair, as in edge_continuity(a, Patch_edge::u1, b, "
                                                        "Patch_edge::u0)");
  }
  return std::nullopt;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of two surfaces along the edge that they have in common. It is looked for
/// among all pairs of edges: first one that is the same as a whole, then one of which a part is the
/// same. Edges that are a single point do not count. See the function for given edges, and
/// `common_edges()`.
/// \tparam Surface_a, Surface_b as for given edges; where both are the same object, two of its
///   edges are the common one
/// \throws Error `curves_do_not_meet` when there is none, `several_common_edges` when there are
///   several, with their names; `dimension_mismatch` unless in dimension 3, `work_limit` for a pair
template <class Surface_a, class Surface_b>
auto edge_continuity(const Surface_a& a, const Surface_b& b)
    -> Spline_edge_continuity<Edge_field<typename Surface_a::Traits>> {
  if (auto found = internal::verdict_on_common_edge(a, b)) return std::move(found->verdict);
  throw Error(Error_code::curves_do_not_meet,
              "edge_continuity: no edge of one surface is an edge of the other, or a part of it, exactly; deviation() "
              "of two named edges tells how far apart they are");
}

namespace internal {

template <int order, class Surface_a, class Surface_b>
bool common_edge_has_order(const Surface_a& a, const Surface_b& b) {
  const auto found = verdict_on_common_edge(a, b);
  if constexpr (order < 3)
    return found && found->verdict.g_order >= order;
  else
    return found && edge_has_order<order>(a, found->edge_a, b, found->edge_b);
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the edges are the same curve, whole, with the same parametrisation up to an
/// affine map, in either direction.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3; `not_finite` when the answer depends
///   on a coordinate that is infinite or not a number; `work_limit`
template <class Surface_a, class Surface_b>
bool is_g0_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<0>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^0 \f$ along the edge that they have in common, as
/// `edge_continuity(a, b)` finds it; false where they have none.
/// \throws Error `several_common_edges` with their names, and as for given edges
template <class Surface_a, class Surface_b> bool is_g0_edge(const Surface_a& a, const Surface_b& b) {
  return internal::common_edge_has_order<0>(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the edges are the same, see `is_g0_edge()`, the tangent planes agree along the
/// whole closed edge and the surfaces lie on different sides of it. Decides the signs of forms of
/// degree 3 and 4. False where a normal vanishes.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`, `work_limit`
template <class Surface_a, class Surface_b>
bool is_g1_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<1>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^1 \f$ along the edge that they have in common, as
/// `edge_continuity(a, b)` finds it; false where they have none.
/// \throws Error `several_common_edges` with their names, and as for given edges
template <class Surface_a, class Surface_b> bool is_g1_edge(const Surface_a& a, const Surface_b& b) {
  return internal::common_edge_has_order<1>(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^1 \f$ along the edges, see `is_g1_edge()`, and their
/// curvatures agree, see `Edge_conditions`. Decides whether a form of degree 7 vanishes.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`, `work_limit`
template <class Surface_a, class Surface_b>
bool is_g2_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<2>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^2 \f$ along the edge that they have in common, as
/// `edge_continuity(a, b)` finds it; false where they have none.
/// \throws Error `several_common_edges` with their names, and as for given edges
template <class Surface_a, class Surface_b> bool is_g2_edge(const Surface_a& a, const Surface_b& b) {
  return internal::common_edge_has_order<2>(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^2 \f$ along the edges, see `is_g2_edge()`, and agree to
/// third order: the one is, to third order and on each span of the knots, the other one in other
/// parameters. Decides whether a form of degree 11 vanishes, by multi-precision where the surfaces
/// are \f$ G^2 \f$.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`, `work_limit`
template <class Surface_a, class Surface_b>
bool is_g3_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<3>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^3 \f$ along the edge that they have in common, as
/// `edge_continuity(a, b)` finds it; false where they have none.
/// \throws Error `several_common_edges` with their names, and as for given edges
template <class Surface_a, class Surface_b> bool is_g3_edge(const Surface_a& a, const Surface_b& b) {
  return internal::common_edge_has_order<3>(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// A line of a B-spline surface on which one parameter is an inner knot, and the decision about the
/// two parts of the surface along it.
/// \tparam FT the field in which it was decided
template <class FT> struct Knot_line {
  bool constant_u;  ///< the knot is one of `u`, and `v` varies on the line; otherwise the reverse
  FT knot;          ///< the constant parameter
  int multiplicity; ///< the multiplicity of the knot
  /// The first surface is the part at smaller parameters, the second the part at larger ones.
  /// Parameters are those along the line. On spans where the surface jumps the order is -1.
  Spline_edge_continuity<FT> continuity;

  /// Writes the line and the verdict, e.g. `u = 1/2: G1 (curvature)`.
  friend std::ostream& operator<<(std::ostream& os, const Knot_line& line) {
    return os << (line.constant_u ? 'u' : 'v') << " = " << line.knot << ": " << line.continuity;
  }
};

namespace internal {

template <class Surface> const Knot_vector<typename Surface::FT>& knots_across(const Surface& s, Parameter_line line) {
  return line == Parameter_line::along_u ? s.knots_v() : s.knots_u();
}

// The rows of the surface on one side of a knot line, along it.
template <class Surface>
Spline_edge_rows<Edge_field<typename Surface::Traits>, row_dimension<Surface>>
knot_line_rows(const Surface& s, Parameter_line line, const typename Surface::FT& knot, Line_side side) {
  typedef Edge_field<typename Surface::Traits> Field;
  return {knots_over<Field>(line == Parameter_line::along_u ? s.knots_u() : s.knots_v()),
          edge_rows_in_space<Field, row_dimension<Surface>>(s.template rows_at<Field>(line, knot, side, 2))};
}

template <class Surface, class Report>
void add_knot_lines(const Surface& s, Parameter_line line,
                    std::vector<Knot_line<Edge_field<typename Surface::Traits>>>& lines, Report& report) {
  typedef Edge_field<typename Surface::Traits> Field;
  const Knot_vector<typename Surface::FT>& across = knots_across(s, line);
  for (const auto& knot : across.inner_knots()) {
    if (knot.multiplicity <= across.degree() - 2) continue; // twice continuously differentiable
    lines.push_back({line == Parameter_line::along_v, to_field<Field>(knot.value), knot.multiplicity,
                     continuity_at_same_parameters(knot_line_rows(s, line, knot.value, Line_side::smaller_parameters),
                                                   knot_line_rows(s, line, knot.value, Line_side::larger_parameters))});
    report();
  }
}

// Returns the result of knot_line_continuity(); report() is called after each line.
template <class Surface, class Report>
std::vector<Knot_line<Edge_field<typename Surface::Traits>>> knot_lines(const Surface& surface, Report report) {
  require_space(surface, "knot_line_continuity");
  std::vector<Knot_line<Edge_field<typename Surface::Traits>>> lines;
  add_knot_lines(surface, Parameter_line::along_v, lines, report);
  add_knot_lines(surface, Parameter_line::along_u, lines, report);
  return lines;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of a B-spline surface across its knot lines, exactly, along each line as
/// a whole and with every kernel: for each inner knot of a multiplicity that does not make the
/// surface twice continuously differentiable, i.e. greater than degree - 2, first those of `u` and
/// then those of `v`. As for edges, nothing is sampled, a knot with multiplicity degree can be
/// \f$ G^2 \f$, and points where the normal vanishes are reported.
///
/// Linear in the number of control points of the lines. The limit is one for each line.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Traits>
std::vector<Knot_line<Edge_field<Traits>>> knot_line_continuity(const Bspline_surface<Traits>& surface) {
  return internal::knot_lines(surface, [] {});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of a rational B-spline surface across its knot lines, see the function
/// for `Bspline_surface`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Traits>
std::vector<Knot_line<Edge_field<Traits>>> knot_line_continuity(const Rational_bspline_surface<Traits>& surface) {
  return internal::knot_lines(surface, [] {});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// An edge of one patch and an edge of another that are the same curve.
struct Common_edge {
  Patch_edge edge_a; ///< the edge of the first patch
  Patch_edge edge_b; ///< the edge of the second patch
  bool reversed;     ///< they run in opposite directions
};

namespace internal {

// Returns whether two edges that are not single points are the same curve, and whether the second
// runs backwards.
template <class Traits>
std::optional<bool> common_edge_reversed(const Bezier_patch<Traits>& a, Patch_edge edge_a,
                                         const Bezier_patch<Traits>& b, Patch_edge edge_b) {
  Edge_sides<Edge_field<Traits>> sides(edge_rows(a, edge_a), edge_rows(b, edge_b));
  return sides.collapsed() ? std::nullopt : sides.align();
}
template <class Traits>
std::optional<bool> common_edge_reversed(const Rational_bezier_patch<Traits>& a, Patch_edge edge_a,
                                         const Rational_bezier_patch<Traits>& b, Patch_edge edge_b) {
  typedef Edge_field<Traits> Field;
  const std::vector<Edge_piece<Field, 4>> pieces_a = edge_pieces(a, edge_a), pieces_b = edge_pieces(b, edge_b);
  if (Edge_sides<Field, 4>(pieces_a[0].rows, pieces_b[0].rows).collapsed()) return std::nullopt;
  const std::optional<Edge_match<Field>> match = Common_edge_part<Field, 4>(pieces_a, pieces_b).whole();
  return match ? std::optional<bool>(match->map.reverses()) : std::nullopt;
}

template <class Patch> std::vector<Common_edge> all_common_edges(const Patch& a, const Patch& b) {
  std::vector<Common_edge> result;
  for (Patch_edge edge_a : patch_edges)
    for (Patch_edge edge_b : patch_edges) {
      if (&a == &b && !(edge_a < edge_b)) continue;
      const Work_guard work("common_edges");
      if (const std::optional<bool> reversed = common_edge_reversed(a, edge_a, b, edge_b))
        result.push_back({edge_a, edge_b, *reversed});
    }
  return result;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns all pairs of edges of `a` and `b` that are the same curve, and not a single point. The
/// points of the edges and their parametrisations, after exact elevation to one degree, are
/// compared exactly; 16 pairs are tried. Two edges of the same patch `a = b` are listed once; an
/// edge is not paired with itself. For many patches see `model_continuity()`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit` for one pair
template <class Traits>
std::vector<Common_edge> common_edges(const Bezier_patch<Traits>& a, const Bezier_patch<Traits>& b) {
  return internal::all_common_edges(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns all pairs of edges of two rational patches that are the same curve, and not a single
/// point, see the function for `Bezier_patch`. The weights may differ by a constant factor.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit` for one pair
template <class Traits>
std::vector<Common_edge> common_edges(const Rational_bezier_patch<Traits>& a, const Rational_bezier_patch<Traits>& b) {
  return internal::all_common_edges(a, b);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what certifies the verdict on two edges that are the same curve as a whole, for each of
/// its spans; computed anew from the surfaces, so that it shows when the verdict is wrong. Each
/// span costs a number of operations that is quadratic in the degrees.
/// \param a, edge_a, b, edge_b the edges
/// \param verdict what `model_continuity()` or `edge_continuity()` has decided about them
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface>
std::vector<Edge_certificate<Edge_field<typename Surface::Traits>>>
edge_certificates(const Surface& a, Patch_edge edge_a, const Surface& b, Patch_edge edge_b,
                  const Spline_edge_continuity<Edge_field<typename Surface::Traits>>& verdict) {
  const internal::Work_guard work("edge_certificates");
  return internal::edge_certificates_on(internal::edge_pieces_in<4>(a, edge_a), internal::edge_pieces_in<4>(b, edge_b),
                                        verdict.reversed ? Edge_direction::opposite : Edge_direction::same, verdict);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what certifies the verdict on a knot line of a surface, for each of its spans; see
/// `edge_certificates()`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface>
std::vector<Edge_certificate<Edge_field<typename Surface::Traits>>>
knot_line_certificates(const Surface& surface, const Knot_line<Edge_field<typename Surface::Traits>>& line) {
  typedef Edge_field<typename Surface::Traits> Field;
  static_assert(std::is_same_v<Field, typename Surface::FT>,
                "certificates of knot lines are for surfaces over an exact field");
  const internal::Work_guard work("knot_line_certificates");
  const Parameter_line along = line.constant_u ? Parameter_line::along_v : Parameter_line::along_u;
  const auto pieces = [&](Line_side side) {
    return internal::homogeneous(
        internal::edge_pieces<Field>(internal::knot_line_rows(surface, along, line.knot, side)));
  };
  return internal::edge_certificates_on(pieces(Line_side::smaller_parameters), pieces(Line_side::larger_parameters),
                                        Edge_direction::same, line.continuity);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H
