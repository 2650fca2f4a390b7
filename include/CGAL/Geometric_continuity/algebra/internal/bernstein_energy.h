// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_BERNSTEIN_ENERGY_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_BERNSTEIN_ENERGY_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// \file bernstein_energy.h
/// The energy of a polynomial curve: the integral of the square of one of its derivatives.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The integral over [0, 1] of |x(t)|^2 for the vectors c_0, ..., c_n of a Bernstein polynomial x:
//
//   1/(2n+1) sum_ij w_ij c_i . c_j,   w_ij = C(n,i) C(n,j) / C(2n,i+j),
//
// by the product of Bernstein polynomials and the mean of its coefficients. The binomials overflow
// in high degrees, but their quotients are probabilities, not more than 1. They are reckoned from
// each other, along the diagonal, where they are large, and from the diagonal outwards, where they
// become smaller.
template <class FT, int N> FT squared_norm(const std::vector<Coordinate_vector<FT, N>>& c) {
  const int n = static_cast<int>(c.size()) - 1;
  Work_meter* const work = scope_of<FT>();
  std::size_t words = 1;
  if (work)
    for (const Coordinate_vector<FT, N>& x : c)
      for (const FT& y : x) words = (std::max)(words, number_words(y));
  FT sum(0), diagonal(1); // w_ii
  for (int i = 0; i <= n; ++i) {
    sum += diagonal * dot(c[i], c[i]);
    FT w = diagonal, row(0);
    for (int j = i; j < n; ++j) { // from w_ij to w_i,j+1
      w *= FT(FT(n - j) * FT(i + j + 1)) / FT(FT(j + 1) * FT(2 * n - i - j));
      if (w == FT(0)) break; // by underflow
      if (work) work->charge_fractions(c[i].dimension() + 1., number_words(row), 2 * words);
      row += w * dot(c[i], c[j + 1]);
      if (j == i) diagonal = w; // w_i,i+1 for the moment
    }
    if (work) work->charge_fractions(2, number_words(sum), number_words(row));
    sum += FT(2) * row;
    if (i < n) diagonal *= FT(FT(2) * FT(n - i)) / FT(2 * n - 2 * i - 1);
  }
  return FT(sum / FT(2 * n + 1));
}

// The integral over an interval of length h of the squared derivative of order k of the polynomial
// curve with these rows.
template <class FT, int N> FT energy_of_rows(std::vector<Coordinate_vector<FT, N>> rows, int k, const FT& h) {
  const int m = static_cast<int>(rows.size()) - 1;
  if (k > m) return FT(0);
  for (int j = 0; j < k; ++j) {
    if (Work_meter* const work = scope_of<FT>())
      for (const Coordinate_vector<FT, N>& row : rows)
        for (const FT& x : row) work->charge_fractions(2, number_words(x));
    difference_step(rows, m - j);
    rows.pop_back();
    const FT factor = FT(m - j) / h;
    for (Coordinate_vector<FT, N>& row : rows) row *= factor;
  }
  return FT(h * squared_norm<FT, N>(rows));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_BERNSTEIN_ENERGY_H
