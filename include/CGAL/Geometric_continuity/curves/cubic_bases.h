// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BASES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BASES_H

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/algebra/blending_functions.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <vector>

/// \file cubic_bases.h
/// Models of `CubicBasis`: what the four columns of the geometry of a `Cubic_blended_curve` are, and the basis matrix in any
/// field. So a predicate over rational numbers sees 1/6, and not the `double` next to it.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// The geometry of a Hermite curve: where it starts and ends, and the derivatives there with respect to `t` in [0, 1].
template <class Traits> struct Hermite_geometry {
  typename Traits::Point p1;  ///< the start
  typename Traits::Point p4;  ///< the end
  typename Traits::Vector r1; ///< the first derivative at the start
  typename Traits::Vector r4; ///< the first derivative at the end
};

/// \ingroup PkgGeometricContinuityCurves
/// End points and end derivatives. \models CubicBasis
struct Hermite_basis {
  /// Two points and two vectors.
  template <class Traits> using Geometry = Hermite_geometry<Traits>;
  /// Returns `hermite_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return hermite_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// The control points of a Bézier curve. \models CubicBasis
struct Bezier_basis {
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `bezier_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return bezier_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four neighbouring points of a spline of Catmull and Rom. \models CubicBasis
struct Catmull_rom_basis {
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `catmull_rom_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return catmull_rom_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four neighbouring points of a cardinal spline. \models CubicBasis
template <class Number> struct Cardinal_basis {
  Number tension; ///< 0 is Catmull-Rom, 1 has zero tangents; any number will do
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `cardinal_matrix()`.
  /// \throws Error `not_finite` for an infinite or undefined tension
  template <class FT> Basis_matrix<FT> matrix() const {
    internal::check_finite(tension, "Cardinal_basis: tension");
    return cardinal_matrix<FT>(internal::to_field<FT>(tension));
  }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four neighbouring control points of a uniform cubic B-spline. \models CubicBasis
struct Uniform_bspline_basis {
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `bspline_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return bspline_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four points and a matrix of your own. The curve moves with its points if and only if the blending functions sum to 1, see
/// `is_partition_of_unity()`; nothing else depends on it. \models CubicBasis
template <class Number> struct Matrix_basis {
  Basis_matrix<Number> m; ///< the matrix
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns the matrix, over another field. \throws Error `not_finite` for an infinite or undefined entry
  template <class FT> Basis_matrix<FT> matrix() const {
    typename Basis_matrix<FT>::Rows r;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        internal::check_finite(m(i, j), "Matrix_basis");
        r[i][j] = internal::to_field<FT>(m(i, j));
      }
    return Basis_matrix<FT>(r);
  }
};

/// \ingroup PkgGeometricContinuityCurves
/// Returns the matrix that changes geometry in one basis into that in another one, see `change_of_basis()`.
/// \tparam FT the field number type of the result
/// \tparam From, To models of `CubicBasis`
/// \throws Error `singular_frame` when the matrix of `to` has no inverse
template <class FT, class From, class To> Basis_matrix<FT> basis_conversion(From from, To to) {
  typedef typename Exact_field<FT>::type Field;
  return internal::rounded_matrix<FT>(change_of_basis(from.template matrix<Field>(), to.template matrix<Field>()));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the four blending functions of a basis, see `blending_functions()` of a matrix. Coefficients of floating-point type are
/// rounded once each.
/// \tparam FT the field number type of the result
/// \tparam Basis a model of `CubicBasis`
template <class FT, class Basis> std::vector<Bernstein_polynomial<FT>> blending_functions(const Basis& basis) {
  return internal::rows_as_polynomials(basis_conversion<FT>(basis, Bezier_basis()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BASES_H
