// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_SOLVE_POSITIVE_DEFINITE_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_SOLVE_POSITIVE_DEFINITE_H

#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// x with A x = b for a symmetric positive definite matrix: Gaussian elimination, which needs no
// pivoting. Matrix: a container of rows, each a Column; Column: a random-access container of field
// elements.
template <class Matrix, class Column> Column solve_positive_definite(Matrix a, Column b) {
  typedef typename Column::value_type FT;
  const std::size_t n = b.size();
  Work_meter* const work = scope_of<FT>();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      if constexpr (is_rational_v<FT>)
        if (a[i][k] == FT(0)) continue;
      const FT factor = a[i][k] / a[k][k];
      if (work) work->charge_fractions(2. * static_cast<double>(n - k), number_words(factor), number_words(a[k][k]));
      for (std::size_t j = k + 1; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    if (work) work->charge_fractions(static_cast<double>(n - k), number_words(b[k]), number_words(a[k][k]));
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_SOLVE_POSITIVE_DEFINITE_H
