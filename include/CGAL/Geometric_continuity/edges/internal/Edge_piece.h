// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_PIECE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_PIECE_H

#include <CGAL/Geometric_continuity/algebra/Power_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/splines/bspline_knots.h>

#include <cstddef>
#include <utility>
#include <vector>

/// \file Edge_piece.h
/// The rows along an edge of a piecewise polynomial surface, one Bernstein form for each span of the knots.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Takes note of the conversion of a row to powers, and of as many operations again: about n^2 for n coefficients, with their
// common denominator.
template <class Field, class Row> void charge_powers(const Row& row, Work_meter& work) {
  Common_denominator<Field> denominator;
  for (const auto& p : row)
    for (const Field& x : p) {
      denominator.include(x);
      work.charge_products(1, denominator.words(), number_words(x));
    }
  const double n = static_cast<double>(row.size());
  work.charge_products(n * n, denominator.words());
}

// The rows on an interval on which they are polynomials, in Bernstein form.
template <class Field> struct Edge_piece {
  Field begin, end;
  Edge_rows<Field> rows;

  Field length() const { return Field(end - begin); }
};

// On each span of the knots, in an exact field. \throws Error `wrong_number_of_points`, `not_finite`
template <class Field, class FT>
std::vector<Edge_piece<Field>> edge_pieces(const Spline_edge_rows<FT>& edge, Work_meter& work) {
  typedef typename Edge_rows<Field>::Row Row;
  const Knot_vector<Field> knots = knots_over<Field>(edge.knots);
  const std::vector<int> spans = knots.spans();
  std::vector<Edge_piece<Field>> pieces;
  for (int k : spans) pieces.push_back({knots[k], knots[k + 1], {}});
  const auto add_row = [&](const typename Edge_rows<FT>::Row& row, Row Edge_rows<Field>::*member) {
    check_number_of_coefficients(knots, row, "edge_pieces");
    const Row b = bernstein_pieces(knots, row_in_space<Field>(row), work);
    const std::size_t n = b.size() / pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      (pieces[i].rows.*member).assign(b.begin() + i * n, b.begin() + (i + 1) * n);
  };
  add_row(edge.rows.edge, &Edge_rows<Field>::edge);
  add_row(edge.rows.cross, &Edge_rows<Field>::cross);
  add_row(edge.rows.second_cross, &Edge_rows<Field>::second_cross);
  return pieces;
}

// Of an edge of a surface. A patch has one piece, which needs no knots.
template <class Traits>
std::vector<Edge_piece<Edge_field<Traits>>> edge_pieces(const Bezier_patch<Traits>& patch, Patch_edge edge,
                                                        Work_meter&) {
  typedef Edge_field<Traits> Field;
  const std::pair<Field, Field> domain = edge_domain<Field>(patch, edge);
  return {{domain.first, domain.second, edge_rows(patch, edge)}};
}
template <class Traits>
std::vector<Edge_piece<Edge_field<Traits>>> edge_pieces(const Bspline_surface<Traits>& surface, Patch_edge edge,
                                                        Work_meter& work) {
  return edge_pieces<Edge_field<Traits>>(spline_edge_rows(surface, edge), work);
}

// The coefficients on [x, y], x < y and 0 < y, of a polynomial with Bernstein coefficients on [0, 1], which need not contain
// x and y.
template <class Field, class Row> Row restricted(Row row, const Field& x, const Field& y) {
  const int n = static_cast<int>(row.size()) - 1;
  Row part = row;
  if (y != Field(1)) { // to [0, y]
    bernstein_split(row, n, y, part);
    row.swap(part);
  }
  if (x != Field(0)) bernstein_split(row, n, Field(x / y), part);
  return row;
}

// The rows on a part [begin, end] of a piece.
template <class Field> Edge_rows<Field> rows_on(const Edge_piece<Field>& piece, const Field& begin, const Field& end) {
  const Field length = piece.length(), x = Field(begin - piece.begin) / length, y = Field(end - piece.begin) / length;
  return {restricted(piece.rows.edge, x, y), restricted(piece.rows.cross, x, y),
          restricted(piece.rows.second_cross, x, y)};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_PIECE_H
