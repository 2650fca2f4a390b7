// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/Spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/Cad_surface_jet.h>
#include <CGAL/Geometric_continuity/edges/internal/exact_analytic_edge.h>
#include <CGAL/Geometric_continuity/edges/internal/exact_spline_edge.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <optional>
#include <variant>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCadEdges
/// Decides the continuity of two faces along an edge that both have over the range `[first, last]` of their common parameter, exactly, on
/// the whole closed edge, where that is possible: points of both sides at equal parameters are compared, and the oriented normals there. The
/// numbers that describe curves and surfaces are taken as the rational numbers they are, the formulas of `Cad_geometry.h` as they
/// stand: a seam that a system has at `0` and at the floating-point number next to \f$ 2 \pi \f$ has a gap. Gaps and kinks of the size of
/// rounding errors are told as what they are; how large they are `edge_enclosure()` says.
///
/// Decided are
/// - two spline surfaces, rational or not, on each of which the edge is a parameter line, boundary or not, or a part of it, run through
///   linearly: as for whole edges;
/// - two elementary surfaces, extrusions or surfaces of revolution with lines or ellipses as profiles, where the curves in the parameter
///   planes are lines, or splines that are, on planes also ellipses. Then points and derivatives are sums of terms \f$ c\,t^n e^{i (w + f t)} \f$ with rational
///   numbers, and continuity means identities between such sums, which hold if and only if each coefficient agrees (Lindemann and
///   Weierstrass).
///
/// The defect is `fold` where the oriented normals are opposite on the whole edge, `gap` (with the order -1) when any two points differ.
/// `deviation` may be empty where the normals differ. All parameters in the result are those of the edge.
///
/// Returns nothing for an edge of another kind or without a length in the parameter; inside a spline surface, on a knot line, when
/// `Edge_side::face_side` is not known; for analytic surfaces also where a normal vanishes on the edge, and for rational ones when a common
/// factor that is not constant may hide that the edges are the same; and when the work on splines would exceed the limit. Sums of the
/// analytic surfaces have some hundred terms at most and take up to half a second, on ordinary models milliseconds.
/// \throws Error `not_finite`; `empty_domain` when `first` is larger than `last`; `wrong_number_of_points`, `knot_multiplicity` and
///   `empty_domain` for splines whose numbers do not fit; `zero_weight`; `singular_frame` when a placement is not invertible
inline std::optional<Edge_continuity<Exact_field<double>::type>> edge_continuity(const Edge_side& a, const Edge_side& b,
                                                                                 double first, double last) {
  internal::check_range(first, last, "edge_continuity: the range");
  for (const Edge_side* side : {&a, &b}) {
    std::visit(internal::Check_cad_surface(), *side->surface);
    std::visit(internal::Check_cad_curve<2>(), *side->curve);
    for (const auto& row : side->placement)
      for (double x : row) internal::check_finite({x}, "a placement");
  }
  try {
    if (const auto verdict = internal::exact_spline_edge(a, b, first, last)) return verdict;
    return internal::exact_analytic_edge(a, b, first, last);
  } catch (const Error& e) {
    if (e.code() != Error_code::work_limit) throw;
    return std::nullopt;
  }
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H
