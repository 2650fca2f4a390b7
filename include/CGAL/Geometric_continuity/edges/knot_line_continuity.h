// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_KNOT_LINE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_KNOT_LINE_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A line of a B-spline surface on which one parameter is an inner knot, and what was decided about the two parts of the
/// surface along it.
/// \tparam FT the field in which it was decided
template <class FT> struct Knot_line {
  bool constant_u;  ///< the knot is one of `u`, and `v` varies on the line; otherwise the reverse
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

// What knot_line_continuity() returns; report() is called after each line.
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
/// Decides the continuity of a B-spline surface across its knot lines, exactly, along each line as a whole and with every
/// kernel: for each inner knot of a multiplicity that does not make the surface twice continuously differentiable, i.e.
/// greater than degree - 2, first those of `u` and then those of `v`. As for edges, nothing is sampled, a knot with
/// multiplicity degree can be \f$ G^2 \f$, and points where the normal vanishes are reported.
///
/// Linear in the number of control points of the lines. The limit is one for each line.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Traits>
std::vector<Knot_line<Edge_field<Traits>>> knot_line_continuity(const Bspline_surface<Traits>& surface) {
  return internal::knot_lines(surface, [] {});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of a rational B-spline surface across its knot lines, see the function for `Bspline_surface`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Traits>
std::vector<Knot_line<Edge_field<Traits>>> knot_line_continuity(const Rational_bspline_surface<Traits>& surface) {
  return internal::knot_lines(surface, [] {});
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_KNOT_LINE_CONTINUITY_H
