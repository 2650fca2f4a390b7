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
template <class Field, class Row> void charge_powers(const Row& row) {
  Common_denominator<Field> denominator;
  for (const auto& p : row)
    for (const Field& x : p) {
      denominator.include(x);
      work_meter().charge_divisors(1, denominator.words(), number_words(x));
    }
  const double n = static_cast<double>(row.size());
  work_meter().charge_products(n * n, denominator.words());
}

// The rows on an interval on which they are polynomials, in Bernstein form.
template <class Field, int N = 3> struct Edge_piece {
  Field begin, end;
  Edge_rows<Field, N> rows;

  Field length() const { return Field(end - begin); }
};

// On each span of the knots, in an exact field. \throws Error `wrong_number_of_points`, `not_finite`
template <class Field, class FT, int N>
std::vector<Edge_piece<Field, N>> edge_pieces(const Spline_edge_rows<FT, N>& edge) {
  typedef typename Edge_rows<Field, N>::Row Row;
  const Knot_vector<Field> knots = knots_over<Field>(edge.knots);
  const std::vector<int> spans = knots.spans();
  std::vector<Edge_piece<Field, N>> pieces;
  for (int k : spans) pieces.push_back({knots[k], knots[k + 1], {}});
  const auto add_row = [&](const typename Edge_rows<FT, N>::Row& row, Row Edge_rows<Field, N>::*member) {
    check_number_of_coefficients(knots, row, "edge_pieces");
    const Row b = bernstein_pieces(knots, row_in_space<Field, N>(row));
    const std::size_t n = b.size() / pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      (pieces[i].rows.*member).assign(b.begin() + i * n, b.begin() + (i + 1) * n);
  };
  add_row(edge.rows.edge, &Edge_rows<Field, N>::edge);
  add_row(edge.rows.cross, &Edge_rows<Field, N>::cross);
  add_row(edge.rows.second_cross, &Edge_rows<Field, N>::second_cross);
  return pieces;
}

// From points to homogeneous points, with the weight 1.
template <class Field>
typename Edge_rows<Field, 4>::Row lifted(const typename Edge_rows<Field>::Row& row, const Field& weight) {
  typename Edge_rows<Field, 4>::Row result(row.size(), Coordinate_vector<Field, 4>(4));
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (int x = 0; x < 3; ++x) result[i][x] = row[i][x];
    result[i][3] = weight;
  }
  return result;
}
template <class Field> std::vector<Edge_piece<Field, 4>> lifted(const std::vector<Edge_piece<Field>>& pieces) {
  std::vector<Edge_piece<Field, 4>> result;
  for (const Edge_piece<Field>& piece : pieces)
    result.push_back({piece.begin,
                      piece.end,
                      {lifted<Field>(piece.rows.edge, Field(1)), lifted<Field>(piece.rows.cross, Field(0)),
                       lifted<Field>(piece.rows.second_cross, Field(0))}});
  return result;
}

// Of an edge of a surface. A patch has one piece, which needs no knots.
template <class Surface>
std::vector<Edge_piece<Edge_field<typename Surface::Traits>, row_dimension<Surface>>>
edge_pieces(const Surface& surface, Patch_edge edge) {
  typedef Edge_field<typename Surface::Traits> Field;
  if constexpr (Is_patch<Surface>::value) {
    const std::pair<Field, Field> domain = edge_domain<Field>(surface, edge);
    return {{domain.first, domain.second, edge_rows(surface, edge)}};
  } else
    return edge_pieces<Field>(spline_edge_rows(surface, edge));
}

// With N coordinates, 3 or 4.
template <int N, class Surface>
std::vector<Edge_piece<Edge_field<typename Surface::Traits>, N>> edge_pieces_in(const Surface& surface,
                                                                                Patch_edge edge) {
  if constexpr (N == row_dimension<Surface>)
    return edge_pieces(surface, edge);
  else
    return lifted(edge_pieces(surface, edge));
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
template <class Field, int N>
Edge_rows<Field, N> rows_on(const Edge_piece<Field, N>& piece, const Field& begin, const Field& end) {
  const Field length = piece.length(), x = Field(begin - piece.begin) / length, y = Field(end - piece.begin) / length;
  return {restricted(piece.rows.edge, x, y), restricted(piece.rows.cross, x, y),
          restricted(piece.rows.second_cross, x, y)};
}

// The rows of two homogeneous edges, the second divided by a factor so that their first points have equal weights: then edges
// that are the same curve have the same coefficients. Rows of points stay as they are.
template <class Field, int N>
std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>> with_equal_weights(Edge_rows<Field, N> a, Edge_rows<Field, N> b) {
  if constexpr (N == 4) {
    for (const Edge_rows<Field, N>* rows : {&a, &b}) require_denominator(rows->edge[0][3], "edge_continuity");
    const Field factor = Field(a.edge[0][3] / b.edge[0][3]);
    if (factor != Field(1))
      for (auto* row : {&b.edge, &b.cross, &b.second_cross})
        for (Coordinate_vector<Field, N>& x : *row) x *= factor;
  }
  return {std::move(a), std::move(b)};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_PIECE_H
