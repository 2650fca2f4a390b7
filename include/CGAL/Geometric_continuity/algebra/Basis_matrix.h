// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BASIS_MATRIX_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BASIS_MATRIX_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/number_utils.h>

#include <array>
#include <ostream>
#include <type_traits>
#include <vector>

/// \file Basis_matrix.h
/// The 4 x 4 matrices of cubic curves, how one changes into another, and those of Hermite, Bézier,
/// B-spline and cardinal curves. The functions with which the points of a curve are weighted, and
/// whether the curve stays in the convex hull of its points: \f$ \sum_i f_i = 1 \f$ and
/// \f$ f_i \ge 0 \f$. Lecture slides, "Blended curves", "Bézier curves III".

namespace CGAL {
namespace Geometric_continuity {

template <class FT> class Basis_matrix;

namespace internal {

template <class FT> Basis_matrix<typename Exact_field<FT>::type> exact_matrix(const Basis_matrix<FT>& m) {
  typedef typename Exact_field<FT>::type Field;
  typename Basis_matrix<Field>::Rows r;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) r[i][j] = to_field<Field>(m(i, j));
  return Basis_matrix<Field>(r);
}

// Each entry is rounded once if FT is a floating-point type, and left alone if not.
template <class FT> Basis_matrix<FT> rounded_matrix(const Basis_matrix<typename Exact_field<FT>::type>& m) {
  if constexpr (!std::is_floating_point_v<FT>)
    return m;
  else {
    typename Basis_matrix<FT>::Rows r;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        r[i][j] = FT(CGAL::to_double(m(i, j)));
        check_finite(r[i][j], "Basis_matrix");
      }
    return Basis_matrix<FT>(r);
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The basis matrix `M` of a cubic curve \f$ Q(t) = G\,M\,[t^3\ t^2\ t\ 1]^T \f$: a 4 x 4 matrix
/// whose row `i` is the blending function of the `i`-th column of the geometry `G`, with the
/// columns \f$ t^3, t^2, t, 1 \f$. Lecture slides, "Blended curves".
///
/// All members can be used at compile time, if the number type can.
///
/// \tparam FT a field number type, or `int` for matrices of whole numbers
template <class FT_> class Basis_matrix {
public:
  typedef FT_ FT;                                ///< the number type
  typedef std::array<std::array<FT, 4>, 4> Rows; ///< the rows of a matrix

  /// Constructs a matrix from its rows.
  constexpr explicit Basis_matrix(const Rows& rows) : m_(rows) {}

  /// Returns the entry in row `i` and column `j`, `0 <= i, j < 4`.
  constexpr const FT& operator()(int i, int j) const { return m_[i][j]; }

  /// Returns the same matrix over another number type.
  template <class Other> constexpr Basis_matrix<Other> over() const {
    typename Basis_matrix<Other>::Rows r{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) r[i][j] = Other(m_[i][j]);
    return Basis_matrix<Other>(r);
  }

  /// Returns the product of two matrices, with 64 multiplications.
  friend constexpr Basis_matrix operator*(const Basis_matrix& a, const Basis_matrix& b) {
    Rows r{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        r[i][j] = FT(a(i, 0) * b(0, j));
        for (int k = 1; k < 4; ++k) r[i][j] += FT(a(i, k) * b(k, j));
      }
    return Basis_matrix(r);
  }

  /// Returns the product of a number and a matrix.
  friend constexpr Basis_matrix operator*(const FT& s, const Basis_matrix& a) {
    Rows r{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) r[i][j] = FT(s * a(i, j));
    return Basis_matrix(r);
  }

  /// Returns the determinant, by expansion along the first row.
  constexpr FT determinant() const {
    FT sum(0);
    for (int j = 0; j < 4; ++j) sum += FT(m_[0][j] * cofactor(0, j));
    return sum;
  }

  /// Returns the inverse, as the matrix of cofactors divided by the determinant. Its existence is
  /// decided exactly, and the inverse of a matrix of floating-point numbers is exact up to one
  /// rounding of each entry, by `CGAL::to_double()`.
  /// \throws Error `singular_frame` when the determinant is zero, and for whole numbers unless it
  ///   is 1 or -1
  /// \throws Error `not_finite` for an infinite or undefined entry, and when the inverse overflows
  constexpr Basis_matrix inverse() const {
    if constexpr (std::is_floating_point_v<FT>)
      return internal::rounded_matrix<FT>(internal::exact_matrix(*this).inverse());
    else {
      const FT d = determinant();
      if (d == FT(0) || (std::is_integral_v<FT> && d != FT(1) && d != FT(-1)))
        throw Error(Error_code::singular_frame, "Basis_matrix::inverse");
      Rows r{};
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) r[i][j] = FT(cofactor(j, i) / d);
      return Basis_matrix(r);
    }
  }

  /// Decides whether all entries are equal.
  friend constexpr bool operator==(const Basis_matrix& a, const Basis_matrix& b) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (a(i, j) != b(i, j)) return false;
    return true;
  }
  /// Decides whether an entry is different.
  friend constexpr bool operator!=(const Basis_matrix& a, const Basis_matrix& b) { return !(a == b); }

  /// Writes the rows, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Basis_matrix& a) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) os << a(i, j) << (j < 3 ? ' ' : '\n');
    return os;
  }

private:
  Rows m_;

  // the determinant of the matrix without row i and column j, with the sign of a chessboard
  constexpr FT cofactor(int i, int j) const {
    const int r[] = {i < 1 ? 1 : 0, i < 2 ? 2 : 1, i < 3 ? 3 : 2}, c[] = {j < 1 ? 1 : 0, j < 2 ? 2 : 1, j < 3 ? 3 : 2};
    FT sum(0);
    for (int k = 0; k < 3; ++k) {
      const int l = c[(k + 1) % 3], n = c[(k + 2) % 3];
      sum += FT(m_[r[0]][c[k]] * FT(m_[r[1]][l] * m_[r[2]][n] - m_[r[1]][n] * m_[r[2]][l]));
    }
    return (i + j) % 2 == 0 ? sum : FT(-sum);
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the matrix \f$ A = M_{from} M_{to}^{-1} \f$ that changes the geometry of a curve in one
/// basis into that of the same curve in another one: \f$ G_{to} = G_{from} A \f$. Exact; the matrix
/// for floating-point numbers is exact up to one rounding of each entry.
/// \throws Error `singular_frame`, `not_finite` when the basis `to` cannot be inverted
template <class FT>
constexpr Basis_matrix<FT> change_of_basis(const Basis_matrix<FT>& from, const Basis_matrix<FT>& to) {
  if constexpr (std::is_floating_point_v<FT>)
    return internal::rounded_matrix<FT>(internal::exact_matrix(from) * internal::exact_matrix(to).inverse());
  else
    return from * to.inverse();
}

namespace internal {

// Row by row the values at 0 and 1 and the derivatives at 0 and 1 of t^3, t^2, t, 1 stand in the
// columns.
constexpr Basis_matrix<int> hermite_constraints({{{0, 1, 0, 3}, {0, 1, 0, 2}, {0, 1, 1, 1}, {1, 1, 0, 0}}});
constexpr Basis_matrix<int> hermite_matrix = hermite_constraints.inverse();
// equivalent [0 -> 1, 2]: computed by the compiler, which also asserts that it is inverted by the
//   other matrix
constexpr Basis_matrix<int> hermite_from_bezier_matrix({{{1, 0, -3, 0}, {0, 0, 3, 0}, {0, 0, 0, -3}, {0, 1, 0, 3}}});
constexpr Basis_matrix<int> bezier_matrix = hermite_from_bezier_matrix * hermite_matrix;
constexpr Basis_matrix<int> bspline_matrix({{{-1, 3, -3, 1}, {3, -6, 0, 4}, {-3, 3, 3, 1}, {1, 0, 0, 0}}});

static_assert(hermite_matrix == Basis_matrix<int>({{{2, -3, 0, 1}, {-2, 3, 0, 0}, {1, -2, 1, 0}, {1, -1, 0, 0}}}));
static_assert(bezier_matrix == Basis_matrix<int>({{{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}}));

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the matrix of the four conditions on a Hermite curve: \f$ G_H = G_H M_H\,\cdot \f$ this
/// matrix, the columns of which are \f$ [t^3\ t^2\ t\ 1]^T \f$ at 0 and 1 and its derivatives at 0
/// and 1. Lecture slides, corrected.
template <class FT> Basis_matrix<FT> hermite_constraint_matrix() {
  return internal::hermite_constraints.template over<FT>();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns \f$ M_H \f$, the inverse of `hermite_constraint_matrix()`, taken at compile time. The
/// rows stand for the end points \f$ P_1, P_4 \f$ and the derivatives \f$ R_1, R_4 \f$ there.
/// Lecture slides, corrected.
template <class FT> Basis_matrix<FT> hermite_matrix() { return internal::hermite_matrix.template over<FT>(); }

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns \f$ M_{HB} \f$ with \f$ G_H = G_B M_{HB} \f$: \f$ R_1 = 3 (P_2 - P_1) \f$ and
/// \f$ R_4 = 3 (P_4 - P_3) \f$. Lecture slides.
template <class FT> Basis_matrix<FT> hermite_from_bezier_matrix() {
  return internal::hermite_from_bezier_matrix.template over<FT>();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns \f$ M_B = M_{HB} M_H \f$, the rows of which are the Bernstein polynomials of degree 3.
/// Lecture slides, corrected.
template <class FT> Basis_matrix<FT> bezier_matrix() { return internal::bezier_matrix.template over<FT>(); }

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the matrix of the uniform cubic B-spline: the curve of four neighbours is near the
/// second and the third.
template <class FT> Basis_matrix<FT> bspline_matrix() {
  return FT(FT(1) / FT(6)) * internal::bspline_matrix.template over<FT>();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the matrix of the cardinal spline: the curve of four neighbours leads from the second to
/// the third, with derivatives \f$ \frac{1-c}{2} (P_3 - P_1) \f$ and
/// \f$ \frac{1-c}{2} (P_4 - P_2) \f$ for the tension `c`. Tension 0 is Catmull-Rom; tension 1 has
/// zero derivatives and a singular matrix.
template <class FT> Basis_matrix<FT> cardinal_matrix(const FT& tension) {
  const FT o(0), e(1), s = FT(FT(FT(1) - tension) / FT(2)), r = FT(-s);
  return Basis_matrix<FT>({{{o, o, r, o}, {e, o, o, r}, {o, e, s, o}, {o, o, o, s}}}) * hermite_matrix<FT>();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the matrix of the spline of Catmull and Rom, `cardinal_matrix(0)`.
template <class FT> Basis_matrix<FT> catmull_rom_matrix() { return cardinal_matrix<FT>(FT(0)); }

namespace internal {

template <class FT> std::vector<Bernstein_polynomial<FT>> rows_as_polynomials(const Basis_matrix<FT>& c) {
  std::vector<Bernstein_polynomial<FT>> functions;
  for (int i = 0; i < 4; ++i) functions.push_back({c(i, 0), c(i, 1), c(i, 2), c(i, 3)});
  return functions;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the four blending functions of a cubic basis: polynomials of degree 3 on [0, 1], with
/// which the columns of the geometry are weighted. Lecture slides, "Blended curves".
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> std::vector<Bernstein_polynomial<FT>> blending_functions(const Basis_matrix<FT>& basis) {
  return internal::rows_as_polynomials(change_of_basis(basis, bezier_matrix<FT>()));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the Bernstein polynomials \f$ B_0^n, \dots, B_n^n \f$, the blending functions of the
/// Bézier curves of degree `n >= 0`.
/// \throws Error `negative_count` when `n` is negative
template <class FT> std::vector<Bernstein_polynomial<FT>> bernstein_polynomials(int n) {
  if (n < 0) throw Error(Error_code::negative_count, "bernstein_polynomials: degree");
  std::vector<Bernstein_polynomial<FT>> functions;
  for (int i = 0; i <= n; ++i) {
    std::vector<FT> c(n + 1, FT(0));
    c[i] = FT(1);
    functions.push_back(Bernstein_polynomial<FT>(c));
  }
  return functions;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides whether the functions sum to 1 everywhere, so that the curve moves with its points.
/// Exact for the coefficients as given: floating-point numbers are taken as the rational numbers
/// they are. Lecture slides, "Bézier curves III".
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> bool is_partition_of_unity(const std::vector<Bernstein_polynomial<FT>>& functions) {
  typedef typename Exact_field<FT>::type Field;
  Bernstein_polynomial<Field> sum{Field(0)};
  for (const Bernstein_polynomial<FT>& f : functions) {
    std::vector<Field> c;
    for (const FT& x : f.coefficients()) c.push_back(internal::to_field<Field>(x));
    sum = sum + Bernstein_polynomial<Field>(c);
  }
  for (const Field& x : sum.coefficients())
    if (x != Field(1)) return false;
  return true;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides whether `p` is nowhere negative on [0, 1]. Exact, see `sign_pattern()`.
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> bool is_nonnegative(const Bernstein_polynomial<FT>& p) {
  const Sign_pattern signs = sign_pattern(p);
  return signs == Sign_pattern::positive || signs == Sign_pattern::nonnegative || signs == Sign_pattern::zero;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides whether every curve that has these blending functions stays in the convex hull of its
/// points for `t` in [0, 1]: the functions sum to 1 and are nonnegative there. This is so for
/// Bézier curves and B-splines, but not for Catmull-Rom splines. Lecture slides, "Bézier curves
/// III", corrected.
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> bool has_convex_hull_property(const std::vector<Bernstein_polynomial<FT>>& functions) {
  for (const Bernstein_polynomial<FT>& f : functions)
    if (!is_nonnegative(f)) return false;
  return is_partition_of_unity(functions);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BASIS_MATRIX_H
