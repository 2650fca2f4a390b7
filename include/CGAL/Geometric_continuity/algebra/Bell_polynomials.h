// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BELL_POLYNOMIALS_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BELL_POLYNOMIALS_H

#include <vector>

/// \file Bell_polynomials.h
/// The derivatives of a composition of functions, of any order: Faà di Bruno's formula.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// The partial Bell polynomials \f$ B_{k,m}(x_1, x_2, \dots) \f$, the coefficients of Faà di Bruno's
/// formula: \f$ (X \circ \varphi)^{(k)} = \sum_m B_{k,m}(\varphi', \varphi'', \dots)\, X^{(m)} \f$.
///
/// The variables are appended one after the other, as a chain of joins determines them; each append
/// of the `k`-th variable costs \f$ O(k^2) \f$ products.
template <class FT> class Bell_polynomials {
  std::vector<FT> x_;                                                   // x_[j-1] = j-th variable
  std::vector<std::vector<FT>> rows_ = std::vector<std::vector<FT>>(1); // rows_[k][m-2] = B_{k,m} for m >= 2
  std::vector<FT> binomials_{FT(1)};                                    // row k-1 of Pascal's triangle

public:
  /// Returns \f$ B_{k,m} \f$ for `2 <= m <= k`. It depends on the first `k - m + 1` variables only, so it is known as
  /// soon as the first `k - 1` variables have been appended; that they have been, and the range of `m`, is the caller's
  /// duty.
  const FT& operator()(int k, int m) const { return rows_[k - 1][m - 2]; }

  /// Appends the next variable, \f$ x_{k-1} \f$, and so makes the row \f$ B_{k,\cdot} \f$ known.
  void append(const FT& x) {
    x_.push_back(x);
    const int k = static_cast<int>(x_.size()) + 1;
    binomials_.push_back(FT(1));
    for (int i = k - 2; i > 0; --i) binomials_[i] += binomials_[i - 1];
    std::vector<FT> row;
    for (int m = 2; m <= k; ++m) {
      FT sum(0);
      for (int i = 1; i <= k - m + 1; ++i)
        sum += binomials_[i - 1] * x_[i - 1] * (m == 2 ? x_[k - i - 1] : rows_[k - i - 1][m - 3]);
      row.push_back(sum);
    }
    rows_.push_back(row);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BELL_POLYNOMIALS_H
