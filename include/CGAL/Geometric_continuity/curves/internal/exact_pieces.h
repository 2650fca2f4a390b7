// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_EXACT_PIECES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_EXACT_PIECES_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/decision_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/bspline_knots.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Calls f(rows, a, b) for each of the Bezier curves that a curve is made of, in order: the coordinates of its control points and
// its domain, as exact values from the points and knots as they are given.
template <class Traits, int Degree, class Function>
void for_each_exact_piece(const Bezier_curve<Traits, Degree>& curve, Function f) {
  f(decision_rows<Traits>(curve), decision_number<Traits>(curve.domain().first),
    decision_number<Traits>(curve.domain().second));
}
template <class Traits, int Degree, class Function>
void for_each_exact_piece(const Composite_bezier_curve<Traits, Degree>& curve, Function f) {
  for (int l = 0; l < curve.number_of_segments(); ++l) for_each_exact_piece(curve.segment(l), f);
}
template <class Traits, class Curve, class Rows, class Function>
void for_each_exact_piece_of_rows(const Curve& curve, const Rows& all, Function f) {
  typedef Decision_number<Traits> NT;
  std::vector<NT> values;
  for (const typename Traits::FT& knot : curve.knots()) values.push_back(decision_number<Traits>(knot));
  const Knot_vector<NT> knots(curve.degree(), values);
  const Rows rows = bspline_bezier<NT>(knots, all);
  auto first = rows.begin();
  for (int k : knots.spans()) {
    f(Rows(first, first + curve.degree() + 1), knots[k], knots[k + 1]);
    first += curve.degree() + 1;
  }
}
template <class Traits, class Function> void for_each_exact_piece(const Bspline_curve<Traits>& curve, Function f) {
  for_each_exact_piece_of_rows<Traits>(curve, decision_rows<Traits>(curve), f);
}

// Of rational curves, with the rows in homogeneous coordinates.
template <class Traits, class Curve>
std::vector<Coordinate_vector<Decision_number<Traits>, (dimension_v<Traits> == 0 ? 0 : dimension_v<Traits> + 1)>>
homogeneous_decision_rows(const Curve& curve) {
  std::vector<Coordinate_vector<Decision_number<Traits>, (dimension_v<Traits> == 0 ? 0 : dimension_v<Traits> + 1)>>
      rows;
  auto w = curve.weights().begin();
  for (const Coordinate_vector<Decision_number<Traits>, dimension_v<Traits>>& x : decision_rows<Traits>(curve))
    rows.push_back(homogeneous_point(x, decision_number<Traits>(*w++)));
  return rows;
}
template <class Traits, int Degree, class Function>
void for_each_exact_piece(const Rational_bezier_curve<Traits, Degree>& curve, Function f) {
  f(homogeneous_decision_rows<Traits>(curve), decision_number<Traits>(curve.domain().first),
    decision_number<Traits>(curve.domain().second));
}
template <class Traits, class Function>
void for_each_exact_piece(const Rational_bspline_curve<Traits>& curve, Function f) {
  for_each_exact_piece_of_rows<Traits>(curve, homogeneous_decision_rows<Traits>(curve), f);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_EXACT_PIECES_H
