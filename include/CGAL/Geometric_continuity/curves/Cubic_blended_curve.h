// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BLENDED_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BLENDED_CURVE_H

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Cubic_blended_curve.h
/// Cubic curves in any basis: models of `CubicBasis`, which say what the four columns of the
/// geometry are and give the basis matrix in any field, so that a predicate over rational numbers
/// sees 1/6, and not the `double` next to it; one curve; and curves through or near many points.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// The geometry of a Hermite curve: where it starts and ends, and the derivatives there with
/// respect to `t` in [0, 1].
template <class Traits> struct Hermite_geometry {
  typename Traits::Point p1;  ///< the start
  typename Traits::Point p4;  ///< the end
  typename Traits::Vector r1; ///< the first derivative at the start
  typename Traits::Vector r4; ///< the first derivative at the end
};

/// \ingroup PkgGeometricContinuityCurves
/// End points and end derivatives. \cgalModels{CubicBasis}
struct Hermite_basis {
  /// Two points and two vectors.
  template <class Traits> using Geometry = Hermite_geometry<Traits>;
  /// Returns `hermite_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return hermite_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// The control points of a Bézier curve. \cgalModels{CubicBasis}
struct Bezier_basis {
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `bezier_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return bezier_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four neighbouring points of a spline of Catmull and Rom. \cgalModels{CubicBasis}
struct Catmull_rom_basis {
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `catmull_rom_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return catmull_rom_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four neighbouring points of a cardinal spline. \cgalModels{CubicBasis}
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
/// Four neighbouring control points of a uniform cubic B-spline. \cgalModels{CubicBasis}
struct Uniform_bspline_basis {
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns `bspline_matrix()`.
  template <class FT> Basis_matrix<FT> matrix() const { return bspline_matrix<FT>(); }
};

/// \ingroup PkgGeometricContinuityCurves
/// Four points and a matrix of your own. The curve moves with its points if and only if the
/// blending functions sum to 1, see `is_partition_of_unity()`; nothing else depends on it.
/// \cgalModels{CubicBasis}
template <class Number> struct Matrix_basis {
  Basis_matrix<Number> m; ///< the matrix
  /// Four points.
  template <class Traits> using Geometry = std::array<typename Traits::Point, 4>;
  /// Returns the matrix, over another field. \throws Error `not_finite` for an infinite or
  /// undefined entry
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
/// Returns the matrix that changes geometry in one basis into that in another one, see
/// `change_of_basis()`.
/// \tparam FT the field number type of the result
/// \tparam From, To models of `CubicBasis`
/// \throws Error `singular_frame` when the matrix of `to` has no inverse
template <class FT, class From, class To> Basis_matrix<FT> basis_conversion(From from, To to) {
  typedef typename Exact_field<FT>::type Field;
  return internal::rounded_matrix<FT>(change_of_basis(from.template matrix<Field>(), to.template matrix<Field>()));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the four blending functions of a basis, see `blending_functions()` of a matrix.
/// Coefficients of floating-point type are rounded once each.
/// \tparam FT the field number type of the result
/// \tparam Basis a model of `CubicBasis`
template <class FT, class Basis> std::vector<Bernstein_polynomial<FT>> blending_functions(const Basis& basis) {
  return internal::rows_as_polynomials(basis_conversion<FT>(basis, Bezier_basis()));
}

namespace internal {

template <class Field, int N> using Cubic_columns = std::array<Coordinate_vector<Field, N>, 4>;

template <class Traits, class Field>
Cubic_columns<Field, dimension_v<Traits>> geometry_columns(const std::array<typename Traits::Point, 4>& p) {
  return {
      Geometric_continuity::coordinates<Traits, Field>(p[0]), Geometric_continuity::coordinates<Traits, Field>(p[1]),
      Geometric_continuity::coordinates<Traits, Field>(p[2]), Geometric_continuity::coordinates<Traits, Field>(p[3])};
}
template <class Traits, class Field>
Cubic_columns<Field, dimension_v<Traits>> geometry_columns(const Hermite_geometry<Traits>& g) {
  return {
      Geometric_continuity::coordinates<Traits, Field>(g.p1), Geometric_continuity::coordinates<Traits, Field>(g.p4),
      Geometric_continuity::coordinates<Traits, Field>(g.r1), Geometric_continuity::coordinates<Traits, Field>(g.r4)};
}

template <class Traits, class Geometry, class Columns> Geometry geometry_from_columns(const Columns& c) {
  if constexpr (std::is_same_v<Geometry, Hermite_geometry<Traits>>)
    return {to_point<Traits>(c[0]), to_point<Traits>(c[1]), to_vector<Traits>(c[2]), to_vector<Traits>(c[3])};
  else
    return {to_point<Traits>(c[0]), to_point<Traits>(c[1]), to_point<Traits>(c[2]), to_point<Traits>(c[3])};
}

// G A
template <class FT, int N>
Cubic_columns<FT, N> blended_columns(const Cubic_columns<FT, N>& g, const Basis_matrix<FT>& a) {
  Cubic_columns<FT, N> r;
  for (int j = 0; j < 4; ++j) {
    r[j] = a(0, j) * g[0];
    for (int i = 1; i < 4; ++i) r[j] += a(i, j) * g[i];
  }
  return r;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// A cubic curve \f$ Q(t) = G\,M\,[t^3\ t^2\ t\ 1]^T \f$ on [0, 1] with the geometry `G`, four
/// columns that are points or vectors, and the matrix `M` of a basis. Lecture slides, "Blended
/// curves".
///
/// \code{.cpp}
/// Cubic_blended_curve<Traits, Hermite_basis> q({p1, p4, r1, r4});   // points and vectors
/// Cubic_blended_curve<Traits, Cardinal_basis<FT>> s({p0, p1, p2, p3}, {FT(1) / FT(2)});
/// \endcode
///
/// `continuity()` reads the geometry and the matrix in the field of the predicate: with
/// `Exact_predicates_inexact_constructions_kernel` the joins of blended curves with `double` points
/// are decided exactly, before any constructed point is rounded.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Basis a model of `CubicBasis`
/// \cgalModels{ParametricCurve}
template <class Traits_, class Basis_> class Cubic_blended_curve {
public:
  typedef Traits_ Traits;                 ///< the traits class
  typedef Basis_ Basis;                   ///< the basis
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel
  /// four points, or points and vectors
  typedef typename Basis::template Geometry<Traits> Geometry;
  /// the dimension, or 0 when it is known at run time only
  static constexpr int N = dimension_v<Traits>;

  /// Takes the geometry.
  /// \throws Error `dimension_mismatch` when its columns differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  explicit Cubic_blended_curve(const Geometry& geometry, const Basis& basis = Basis())
      : geometry_(geometry), basis_(basis) {
    const auto g = columns<FT>();
    for (int i = 0; i < 4; ++i) {
      if (g[i].dimension() != g[0].dimension())
        throw Error(Error_code::dimension_mismatch, "Cubic_blended_curve: column " + std::to_string(i));
      for (const FT& x : g[i]) internal::check_finite(x, "Cubic_blended_curve: geometry");
    }
  }

  /// Converts a Bézier curve of degree at most 3, the domain of which becomes [0, 1].
  /// \throws Error `wrong_number_of_points` for a higher degree
  /// \throws Error `singular_frame` when the matrix of the basis has no inverse
  template <int Degree>
  explicit Cubic_blended_curve(const Bezier_curve<Traits, Degree>& curve, const Basis& basis = Basis())
      : Cubic_blended_curve(Cubic_blended_curve<Traits, Bezier_basis>(cubic_points(curve)).in_basis(basis)) {}

  /// Returns the geometry.
  const Geometry& geometry() const { return geometry_; }
  /// Returns the basis.
  const Basis& basis() const { return basis_; }
  /// Returns the dimension of the points.
  int dimension() const { return columns<FT>()[0].dimension(); }

  /// Returns the domain [0, 1].
  std::pair<FT, FT> domain() const { return {FT(0), FT(1)}; }

  /// Returns the point at the finite parameter `t`, which may lie outside of the domain.
  Point operator()(const FT& t) const { return Geometric_continuity::to_point<Traits>(jet_over<FT>(t, 0)[0]); }

  /// Returns the jet of order `k` at the finite parameter `t`, which may lie outside of the domain;
  /// derivatives of order 4 and more are zero. \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> jet(const FT& t, int k) const { return Curve_jet<Traits>(jet_over<FT>(t, k)); }

  /// Returns the jet of order `k` at the start in another field, to which the geometry is converted
  /// first.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const { return jet_over<Field>(Field(0), k); }
  /// Returns the jet of order `k` at the end in another field, to which the geometry is converted
  /// first.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const { return jet_over<Field>(Field(1), k); }

  /// Returns this curve in another basis: \f$ G_{to} = G M M_{to}^{-1} \f$.
  /// \throws Error `singular_frame` when the matrix of the other basis has no inverse
  template <class Other> Cubic_blended_curve<Traits, Other> in_basis(const Other& other = Other()) const {
    typedef Cubic_blended_curve<Traits, Other> Result;
    const internal::Cubic_columns<FT, N> g =
        internal::blended_columns<FT, N>(columns<FT>(), basis_conversion<FT>(basis_, other));
    return Result(internal::geometry_from_columns<Traits, typename Result::Geometry>(g), other);
  }

  /// Returns this curve as a Bézier curve on [a, b].
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when a floating-point number
  ///   overflows
  Bezier_curve<Traits, 3> bezier(const FT& a = FT(0), const FT& b = FT(1)) const {
    return bezier(basis_conversion<FT>(basis_, Bezier_basis()), a, b);
  }

  /// Returns this curve as a Bézier curve on [a, b], by the matrix
  /// `basis_conversion<FT>(basis(), Bezier_basis())`, which many curves of one basis can share.
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when a floating-point number
  ///   overflows
  Bezier_curve<Traits, 3> bezier(const Basis_matrix<FT>& to_bezier, const FT& a, const FT& b) const {
    const internal::Cubic_columns<FT, N> g = internal::blended_columns<FT, N>(columns<FT>(), to_bezier);
    const auto p = internal::geometry_from_columns<Traits, std::array<Point, 4>>(g);
    return Bezier_curve<Traits, 3>(p.begin(), p.end(), a, b);
  }

private:
  Geometry geometry_;
  Basis basis_;

  template <class Field> internal::Cubic_columns<Field, N> columns() const {
    return internal::geometry_columns<Traits, Field>(geometry_);
  }

  template <class Field> Coordinate_jet<Field, N> jet_over(const Field& t, int k) const {
    const internal::Cubic_columns<Field, N> c =
        internal::blended_columns<Field, N>(columns<Field>(), basis_.template matrix<Field>());
    Coordinate_jet<Field, N> jet(c[0].dimension(), k);
    for (int j = 0; j <= k && j <= 3; ++j)
      // Horner: the j-th derivative of t^p is p (p-1) ... (p-j+1) t^(p-j)
      for (int p = 3; p >= j; --p) {
        Field factor(1);
        for (int i = 0; i < j; ++i) factor *= Field(p - i);
        jet[j] = t * jet[j] + factor * c[3 - p];
      }
    return jet;
  }

  template <int Degree> static std::array<Point, 4> cubic_points(const Bezier_curve<Traits, Degree>& curve) {
    if (curve.degree() > 3)
      throw Error(Error_code::wrong_number_of_points,
                  "Cubic_blended_curve: a curve of degree " + std::to_string(curve.degree()));
    const Bezier_curve<Traits> c = curve.elevate(3 - curve.degree());
    return {c.control_point(0), c.control_point(1), c.control_point(2), c.control_point(3)};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve through or near many points: each four neighbours are the geometry of one
/// cubic segment. `n` points make `n - 3` segments, or `n` if the curve is closed, with the knots
/// 0, 1, 2, ...
///
/// - `Catmull_rom_basis`, `Cardinal_basis`: through all points (an open one from the second to the
///   last but one), \f$ C^1 \f$;
/// - `Uniform_bspline_basis`: near the points, \f$ C^2 \f$.
///
/// `chain_continuity()` proves these orders, with an exact kernel. It also finds where the order G
/// is less because points coincide: that is no error here. With rounded numbers the joins are
/// smooth up to rounding only.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \tparam Basis a model of `CubicBasis` with four points
/// \throws Error `wrong_number_of_points` for fewer than 4 points, or 3 if closed
/// \throws Error `curves_do_not_meet` for a basis of your own whose neighbouring segments do not
///   meet
/// \throws Error `dimension_mismatch` when the points differ in dimension
/// \throws Error `not_finite` for an infinite or undefined floating-point number, and when a result
///   overflows
///
/// \f$ O(n) \f$
template <class Traits, class Basis, class InputIterator>
Composite_bezier_curve<Traits, 3> piecewise_cubic(InputIterator first, InputIterator last, const Basis& basis,
                                                  Closure closure = Closure::open) {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  const bool closed = closure == Closure::closed;
  const std::vector<Point> p(first, last);
  const int n = static_cast<int>(p.size()), segments = closed ? n : n - 3;
  if (n < (closed ? 3 : 4))
    throw Error(Error_code::wrong_number_of_points, "piecewise_cubic: " + std::to_string(n) + " points");
  const Basis_matrix<FT> to_bezier = basis_conversion<FT>(basis, Bezier_basis());
  std::vector<Bezier_curve<Traits, 3>> pieces;
  for (int i = 0; i < segments; ++i) {
    const std::array<Point, 4> geometry{p[i], p[(i + 1) % n], p[(i + 2) % n], p[(i + 3) % n]};
    pieces.push_back(Cubic_blended_curve<Traits, Basis>(geometry, basis).bezier(to_bezier, FT(i), FT(i + 1)));
  }
  return Composite_bezier_curve<Traits, 3>(pieces.begin(), pieces.end());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve through or near the points of a range, such as a `std::vector`.
template <class Traits, class Basis, class Range>
Composite_bezier_curve<Traits, 3> piecewise_cubic(const Range& points, const Basis& basis,
                                                  Closure closure = Closure::open) {
  return piecewise_cubic<Traits>(std::begin(points), std::end(points), basis, closure);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve through the given points with the given first derivatives, at the knots 0, 1,
/// 2, ...; a closed one returns to the first point. It is \f$ C^1 \f$, and \f$ G^1 \f$ where the
/// derivative is not zero. A zero derivative is no error: `chain_continuity()` tells its effect on
/// the join.
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam PointIterator, VectorIterator their value types are `Traits::Point` and `Traits::Vector`
/// \throws Error `wrong_number_of_points` for fewer than 2 points, and unless there are as many
///   derivatives as points
/// \throws Error `dimension_mismatch` when points and derivatives differ in dimension
/// \throws Error `not_finite` for an infinite or undefined floating-point number, and when a result
///   overflows
///
/// \f$ O(n) \f$
template <class Traits, class PointIterator, class VectorIterator>
Composite_bezier_curve<Traits, 3> piecewise_hermite(PointIterator first_point, PointIterator last_point,
                                                    VectorIterator first_derivative, VectorIterator last_derivative,
                                                    Closure closure = Closure::open) {
  typedef typename Traits::FT FT;
  const std::vector<typename Traits::Point> p(first_point, last_point);
  const std::vector<typename Traits::Vector> r(first_derivative, last_derivative);
  const int n = static_cast<int>(p.size());
  if (n < 2 || p.size() != r.size())
    throw Error(Error_code::wrong_number_of_points,
                "piecewise_hermite: " + std::to_string(n) + " points, " + std::to_string(r.size()) + " derivatives");
  const Basis_matrix<FT> to_bezier = basis_conversion<FT>(Hermite_basis(), Bezier_basis());
  std::vector<Bezier_curve<Traits, 3>> pieces;
  for (int i = 0; i < (closure == Closure::closed ? n : n - 1); ++i) {
    const int j = (i + 1) % n;
    pieces.push_back(
        Cubic_blended_curve<Traits, Hermite_basis>({p[i], p[j], r[i], r[j]}).bezier(to_bezier, FT(i), FT(i + 1)));
  }
  return Composite_bezier_curve<Traits, 3>(pieces.begin(), pieces.end());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve through the points of a range with the first derivatives of another one, such
/// as two `std::vector`s.
template <class Traits, class Points, class Vectors>
Composite_bezier_curve<Traits, 3> piecewise_hermite(const Points& points, const Vectors& derivatives,
                                                    Closure closure = Closure::open) {
  return piecewise_hermite<Traits>(std::begin(points), std::end(points), std::begin(derivatives), std::end(derivatives),
                                   closure);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BLENDED_CURVE_H
