// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_CONVEX_WEIGHTS_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_CONVEX_WEIGHTS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file convex_weights.h
/// Whether a point is in the convex hull of others, with weights that prove it: the first phase
/// of the simplex algorithm.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The first phase of the simplex algorithm: w >= 0 with A w = b, for b >= 0. The pivots are those of Bland's rule, with
// which it ends although nearly all of b is zero here.
template <class Field> class Feasible_solution {
  typedef std::vector<Field> Row;
  std::vector<Row> rows_;  // [A | b], transformed so that the columns basis_[i] of the chosen w are unit vectors
  Row cost_;               // minus the sum of the rows whose w is not chosen yet
  std::vector<int> basis_; // the w of each row; n where there is none yet
  int n_;

public:
  Feasible_solution(std::vector<Row> rows, int n) : rows_(std::move(rows)), cost_(n + 1, Field(0)), n_(n) {
    basis_.assign(rows_.size(), n_);
    for (const Row& row : rows_)
      for (int j = 0; j <= n_; ++j) cost_[j] -= row[j];
  }

  std::optional<Row> operator()() {
    for (int column = entering(); column < n_; column = entering()) pivot(leaving(column), column);
    if (!(cost_[n_] == Field(0))) return std::nullopt;
    Row w(n_, Field(0));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (basis_[i] < n_) w[basis_[i]] = rows_[i][n_];
    return w;
  }

private:
  int entering() const {
    int j = 0;
    while (j < n_ && !(cost_[j] < Field(0))) ++j;
    return j;
  }

  // the row of the least quotient; of several, that of the first w, and those without come last
  int leaving(int column) const {
    int best = -1;
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
      if (!(Field(0) < rows_[i][column])) continue;
      if (best >= 0) {
        const Field here = rows_[i][n_] * rows_[best][column], there = rows_[best][n_] * rows_[i][column];
        if (there < here || (here == there && basis_[best] <= basis_[i])) continue;
      }
      best = i;
    }
    return best;
  }

  void pivot(int row, int column) {
    const Field p = rows_[row][column];
    for (Field& x : rows_[row]) x /= p;
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i)
      if (i != row) eliminate(rows_[i], rows_[row], column);
    eliminate(cost_, rows_[row], column);
    basis_[row] = column;
  }

  static void eliminate(Row& x, const Row& row, int column) {
    const Field factor = x[column];
    if (factor == Field(0)) return;
    for (std::size_t j = 0; j < x.size(); ++j) x[j] -= factor * row[j];
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Computes weights \f$ w_i \ge 0 \f$ with \f$ \sum_i w_i = 1 \f$ and \f$ \sum_i w_i q_i = p \f$: they prove that `p`
/// is in the convex hull of the points `q`. At most one more of them than the dimension is not zero. Empty if and only
/// if `p` is outside. Exact in any dimension: floating-point coordinates are taken as the rational numbers they are. By
/// the simplex algorithm with Bland's rule; fast in practice.
/// \throws Error `dimension_mismatch` when the points differ in dimension
/// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
template <class FT, int N>
std::optional<std::vector<typename Exact_field<FT>::type>>
convex_weights(const std::vector<Coordinate_vector<FT, N>>& q, const Coordinate_vector<FT, N>& p) {
  typedef typename Exact_field<FT>::type Field;
  const int n = static_cast<int>(q.size()), d = p.dimension();
  std::vector<std::vector<Field>> rows(d + 1, std::vector<Field>(n + 1, Field(0)));
  for (int j = 0; j < n; ++j) {
    if (q[j].dimension() != d)
      throw Error(Error_code::dimension_mismatch, "convex_weights: point " + std::to_string(j));
    for (int i = 0; i < d; ++i) rows[i][j] = internal::to_field<Field>(q[j][i]) - internal::to_field<Field>(p[i]);
    rows[d][j] = Field(1);
  }
  rows[d][n] = Field(1);
  return internal::Feasible_solution<Field>(rows, n)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_CONVEX_WEIGHTS_H
