// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SURFACE_DENOMINATOR_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SURFACE_DENOMINATOR_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/surfaces/internal/zeros_on_square.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// \file surface_denominator.h
/// Decides if the denominator of a rational surface is positive on the whole rectangle of its
/// parameters.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The Bernstein coefficients of a polynomial in two variables, a row for each coefficient in u.
template <class Field> using Bernstein_rows = std::vector<Coordinate_vector<Field, 0>>;

template <class Field> Bernstein_rows<Field> transposed(const Bernstein_rows<Field>& b) {
  const int m = static_cast<int>(b.size()), n = b[0].dimension();
  Bernstein_rows<Field> r(n, Coordinate_vector<Field, 0>(m));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) r[j][i] = b[i][j];
  return r;
}

// has_zero_on_square() for such a polynomial. \throws Error `work_limit`
template <class Field> bool has_zero_inside(const Bernstein_rows<Field>& b) {
  typedef typename Exact_number<Field>::type Exact;
  // it is easier with the lower degree in v
  const bool turned = static_cast<int>(b.size()) < b[0].dimension();
  const Bernstein_rows<Field> powers_of_u = powers_from_bernstein<Field>(turned ? transposed<Field>(b) : b),
                              powers = powers_from_bernstein<Field>(transposed<Field>(powers_of_u));
  std::vector<std::vector<Exact>> coefficients(powers[0].dimension());
  for (const Coordinate_vector<Field, 0>& row : powers)
    for (int i = 0; i < row.dimension(); ++i) coefficients[i].push_back(Exact_number<Field>::of(row[i]));
  return has_zero_on_square(coefficients);
}

// Decides exactly whether such a polynomial is positive on the closed unit square. On the boundary
// this is decided as for curves. Inside, the coefficients of ever smaller rectangles are taken
// until all are positive, or a corner is not. This ends unless the polynomial is zero somewhere
// inside and negative nowhere, and is given up after 64 halvings, as in
// add_positive_parts_of_patch(), or when no rectangle is left of the number that is allowed for a
// whole surface. Then it is decided whether there is a zero; if not, it is still too close to zero
// for all that is to be done with the surface.
// \throws Error `zero_weight` if it is not positive, `work_limit` when it comes too close to zero
template <class Field> void require_positive(const Bernstein_rows<Field>& b, int& allowed, const char* place) {
  // Each corner inside is the last one of the rectangle that comes first of those that meet there.
  const auto last_corner_positive = [](const Bernstein_rows<Field>& r) {
    return Field(0) < r.back()[r[0].dimension() - 1];
  };
  const auto positive_coefficients = [](const Bernstein_rows<Field>& r) {
    return std::all_of(r.begin(), r.end(), [](const auto& row) { return all_positive(row); });
  };
  if (positive_coefficients(b)) return;
  for (const Bernstein_rows<Field>& r : {b, transposed<Field>(b)})
    for (const auto* row : {&r.front(), &r.back()})
      check_denominator<Field>(std::vector<Field>(row->begin(), row->end()), place);
  std::vector<Bernstein_rows<Field>> rectangles(1, b);
  for (int halvings = 0; !rectangles.empty(); ++halvings) {
    std::vector<Bernstein_rows<Field>> halves;
    for (const Bernstein_rows<Field>& r : rectangles) {
      if (!last_corner_positive(r)) throw Error(Error_code::zero_weight, place);
      if (positive_coefficients(r)) continue;
      if (halvings == 64 || --allowed < 0) {
        if (has_zero_inside(b)) throw Error(Error_code::zero_weight, place);
        throw Error(Error_code::work_limit, std::string(place) + ": the denominator is too close to zero");
      }
      Bernstein_rows<Field> right = transposed<Field>(r), left = right; // u and v take turns
      bernstein_split(right, static_cast<int>(right.size()) - 1, Field(Field(1) / Field(2)), left);
      halves.push_back(std::move(left));
      halves.push_back(std::move(right));
    }
    rectangles.swap(halves);
  }
}
constexpr int most_halved_rectangles = 4096;

// Rows of weights, in the exact field.
template <class Field, class FT>
Bernstein_rows<Field> exact_weights(const std::vector<FT>& weights, int rows, int columns) {
  Bernstein_rows<Field> b(rows, Coordinate_vector<Field, 0>(columns));
  auto w = weights.begin();
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) b[i][j] = to_field<Field>(*w++);
  return b;
}

// The weights of a Bezier patch.
template <class FT>
void check_surface_denominator(int rows, int columns, const std::vector<FT>& weights, const char* place) {
  typedef typename Exact_field<FT>::type Field;
  if (all_positive(weights)) return;
  int allowed = most_halved_rectangles;
  require_positive<Field>(exact_weights<Field>(weights, rows, columns), allowed, place);
}

// The weights of a B-spline surface, on each rectangle of two spans.
template <class FT>
void check_surface_denominator(const std::vector<FT>& weights, const Knot_vector<FT>& knots_u,
                               const Knot_vector<FT>& knots_v, const char* place) {
  typedef typename Exact_field<FT>::type Field;
  if (all_positive(weights)) return;
  const auto exact = [](const Knot_vector<FT>& knots) {
    std::vector<Field> u;
    for (const FT& x : knots) u.push_back(to_field<Field>(x));
    return Knot_vector<Field>(knots.degree(), std::move(u));
  };
  const Bernstein_rows<Field> w =
      exact_weights<Field>(weights, knots_u.number_of_coefficients(), knots_v.number_of_coefficients());
  const Bernstein_rows<Field> strips = bspline_bezier<Field>(exact(knots_u), w);
  const Bernstein_rows<Field> pieces =
      transposed<Field>(bspline_bezier<Field>(exact(knots_v), transposed<Field>(strips)));
  const int m = knots_u.degree() + 1, n = knots_v.degree() + 1;
  int allowed = most_halved_rectangles;
  for (int i = 0; i < static_cast<int>(pieces.size()); i += m)
    for (int j = 0; j < pieces[0].dimension(); j += n) {
      Bernstein_rows<Field> b(m, Coordinate_vector<Field, 0>(n));
      for (int k = 0; k < m; ++k)
        for (int l = 0; l < n; ++l) b[k][l] = pieces[i + k][j + l];
      require_positive<Field>(b, allowed, place);
    }
}

// Halves a rational patch, in u and v in turn, until all weights are positive, see
// add_positive_parts().
template <class Patch> void add_positive_parts_of_patch(const Patch& s, int halvings, std::vector<Patch>& parts) {
  typedef typename Patch::FT FT;
  if (all_positive(s.weights())) return parts.push_back(s);
  // unreachable: by rounding only: exact weights that need so many halvings are refused before
  if (halvings == 0) throw Error(Error_code::work_limit, "positive_parts: the denominator is too close to zero");
  const bool in_u = halvings % 2 == 0;
  const typename Patch::Interval domain = in_u ? s.domain_u() : s.domain_v();
  const FT middle = FT(FT(domain.first + domain.second) / FT(2));
  const std::pair<Patch, Patch> halves = in_u ? s.split_u(middle) : s.split_v(middle);
  add_positive_parts_of_patch(halves.first, halvings - 1, parts);
  add_positive_parts_of_patch(halves.second, halvings - 1, parts);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SURFACE_DENOMINATOR_H
