// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_H

#include <CGAL/Geometric_continuity/Error.h>

#include <type_traits>
#include <vector>

/// \file bernstein.h
/// Algorithms on Bernstein coefficients \f$ c_0, \dots, c_n \f$ of \f$ \sum_i c_i B_i^n(t) \f$ in
/// random-access containers `c`, by field arithmetic only. Curves run them on coordinates and on vectors of
/// coordinates; `Bernstein_polynomial` wraps them for scalar polynomials. The algorithms are de Casteljau's; see Farin,
/// "Curves and Surfaces for CAGD", chapters 5 and 6.
///
/// They run in the innermost loops and do not check their arguments: it is the caller's duty that `c` has the `n + 1`
/// elements and, where this is said, the room that is needed, and that `n` and `k` are not negative.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the row \f$ \binom{n}{0}, \dots, \binom{n}{n} \f$ of Pascal's triangle, `n >= 0`. \f$ O(n) \f$
/// \throws Error `negative_count` when `n` is negative
template <class FT> std::vector<FT> binomial_coefficients(int n) {
  if (n < 0) throw Error(Error_code::negative_count, "binomial_coefficients");
  std::vector<FT> row(1, FT(1));
  for (int i = 0; i < n; ++i) row.push_back(FT(row.back() * FT(n - i) / FT(i + 1)));
  return row;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Does one step of de Casteljau's algorithm at `t`: overwrites \f$ c_0, \dots, c_n \f$ by the `n` coefficients
/// \f$ (1-t) c_i + t c_{i+1} \f$ in the first places.
template <class FT, class Coefficients> void de_casteljau_step(Coefficients& c, int n, const FT& t) {
  const FT s = FT(1) - t;
  for (int i = 0; i < n; ++i) c[i] = s * c[i] + t * c[i + 1];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Overwrites \f$ c_0, \dots, c_n \f$ by the forward differences \f$ c_{i+1} - c_i \f$ in the first `n` places.
template <class Coefficients> void difference_step(Coefficients& c, int n) {
  for (int i = 0; i < n; ++i) c[i] = c[i + 1] - c[i];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the value at `t` by de Casteljau's algorithm; `c` is overwritten. \f$ O(n^2) \f$
template <class FT, class Coefficients> auto bernstein_value(Coefficients& c, int n, const FT& t) {
  for (; n > 0; --n) de_casteljau_step(c, n, t);
  return c[0];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Computes the derivatives of order 0 to `k` at `t`, with respect to `t`: `out(j, value)` is called for each
/// `j`, in this order; `c` is overwritten. The coefficients are numbers or vectors of the same dimension.
/// \f$ O(n^2 + k^3) \f$
template <class FT, class Coefficients, class Output>
void bernstein_derivatives(Coefficients& c, int n, const FT& t, int k, Output out) {
  typedef std::decay_t<decltype(c[0])> Coefficient;
  const int last = k < n ? k : n;
  int m = n;
  for (; m > last; --m) de_casteljau_step(c, m, t);
  // now c holds last+1 coefficients whose j-th differences, evaluated at t, are the j-th
  // derivatives up to the factor n!/(n-j)!
  FT factor(1);
  Coefficients row = c;
  for (int j = 0; j <= last; ++j) {
    for (int i = 0; i <= m; ++i) row[i] = c[i];
    out(j, Coefficient(factor * bernstein_value(row, m, t)));
    difference_step(c, m--);
    factor *= FT(n - j);
  }
  for (int j = last + 1; j <= k; ++j)
    if constexpr (std::is_same_v<Coefficient, FT>)
      out(j, FT(0));
    else
      out(j, Coefficient(c[0].dimension()));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Computes the derivatives of order 0 to `k` at `t = 0` from the first `k + 1` coefficients, in `c`, which is
/// overwritten, and calls `out(j, value)` for each `j`, in this order: \f$ \frac{n!}{(n-j)!} \Delta^j c_0 \f$. The
/// coefficients in reverse order give the derivatives at `t = 1` up to the sign \f$ (-1)^j \f$. \f$ O(k^2) \f$
template <class FT, class Coefficients, class Output>
void bernstein_end_derivatives(Coefficients& c, int n, int k, Output out) {
  const int last = k < n ? k : n;
  FT factor(1);
  for (int j = 0; j <= last; ++j) {
    out(j, FT(factor * c[0]));
    difference_step(c, last - j);
    factor *= FT(n - j);
  }
  for (int j = last + 1; j <= k; ++j) out(j, FT(0));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Overwrites \f$ c_0, \dots, c_n \f$ by the coefficients on \f$ [t, 1] \f$ and writes those on \f$ [0, t] \f$ to
/// `left`, which has room for `n + 1`. \f$ O(n^2) \f$
template <class FT, class Coefficients> void bernstein_split(Coefficients& c, int n, const FT& t, Coefficients& left) {
  // curves/internal/bernstein_jet.h has the same for a degree known at compile time; after i steps, c[0] is the next coefficient of the left part
  const FT s = FT(1) - t;
  left[0] = c[0];
  for (int i = 1; i <= n; ++i) {
    for (int j = 0; j <= n - i; ++j) c[j] = s * c[j] + t * c[j + 1];
    left[i] = c[0];
  }
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Raises the degree from `n` to `n + 1`; `c` has room for `n + 2` coefficients. \f$ O(n) \f$
template <class FT, class Coefficients> void bernstein_elevate(Coefficients& c, int n) {
  c[n + 1] = c[n];
  for (int i = n; i > 0; --i) c[i] = (FT(i) * c[i - 1] + FT(n + 1 - i) * c[i]) / FT(n + 1);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_H
