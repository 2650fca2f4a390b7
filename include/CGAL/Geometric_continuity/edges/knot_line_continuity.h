// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_KNOT_LINE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_KNOT_LINE_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/bspline_edge_continuity.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A line of a B-spline surface on which one parameter is an inner knot, and what was decided about the two parts of the
/// surface along it.
/// \tparam FT the field in which it was decided
template <class FT> struct Knot_line {
  bool constant_u;  ///< the knot is one of `u`, and the line is run through by `v`; otherwise the reverse
  FT knot;          ///< the constant parameter
  int multiplicity; ///< of the knot
  /// The first surface is the part at smaller parameters, the second the part at larger ones. Parameters are those along the
  /// line. On spans where the surface jumps the order is -1.
  Spline_edge_continuity<FT> continuity;

  /// Writes the line and the verdict, e.g. `u = 1/2: G1 (curvature)`.
  friend std::ostream& operator<<(std::ostream& os, const Knot_line& line) {
    return os << (line.constant_u ? 'u' : 'v') << " = " << line.knot << ": " << line.continuity;
  }
};

namespace internal {

// The rows of the surface on one side of a knot line, along it.
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> knot_line_rows(const Bspline_surface<Traits>& s, bool constant_u,
                                                    const typename Traits::FT& knot, bool from_below) {
  typedef Edge_field<Traits> Field;
  return {knots_over<Field>(constant_u ? s.knots_v() : s.knots_u()),
          edge_rows_in_space<Field>(
              s.template rows_at<Field>(constant_u ? Parameter_line::along_v : Parameter_line::along_u, knot,
                                        from_below ? Line_side::smaller_parameters : Line_side::larger_parameters, 2))};
}

template <class Traits>
void add_knot_lines(const Bspline_surface<Traits>& s, bool constant_u,
                    std::vector<Knot_line<Edge_field<Traits>>>& lines) {
  typedef Edge_field<Traits> Field;
  const Knot_vector<typename Traits::FT>& across = constant_u ? s.knots_u() : s.knots_v();
  for (const auto& knot : across.inner_knots()) {
    if (knot.multiplicity <= across.degree() - 2) continue; // twice continuously differentiable
    lines.push_back({constant_u, to_field<Field>(knot.value), knot.multiplicity,
                     continuity_at_same_parameters(knot_line_rows(s, constant_u, knot.value, true),
                                                   knot_line_rows(s, constant_u, knot.value, false))});
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of a B-spline surface across its knot lines, exactly, along each line as a whole and with every
/// kernel: for each inner knot of a multiplicity that does not make the surface twice continuously differentiable, i.e.
/// greater than degree - 2, first those of `u` and then those of `v`. As for edges, nothing is sampled, a knot with
/// multiplicity degree can be \f$ G^2 \f$, and points where the normal vanishes are reported.
///
/// Linear in the number of control points of the lines. \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
std::vector<Knot_line<Edge_field<Traits>>> knot_line_continuity(const Bspline_surface<Traits>& surface) {
  internal::require_space(surface, "knot_line_continuity");
  std::vector<Knot_line<Edge_field<Traits>>> lines;
  internal::add_knot_lines(surface, true, lines);
  internal::add_knot_lines(surface, false, lines);
  return lines;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_KNOT_LINE_CONTINUITY_H
