// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BLENDED_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BLENDED_CURVE_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/cubic_bases.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Field, int N> using Cubic_columns = std::array<Coordinate_vector<Field, N>, 4>;

template <class Traits, class Field>
Cubic_columns<Field, dimension_v<Traits>> geometry_columns(const std::array<typename Traits::Point, 4>& p) {
  return {coordinates<Traits, Field>(p[0]), coordinates<Traits, Field>(p[1]), coordinates<Traits, Field>(p[2]),
          coordinates<Traits, Field>(p[3])};
}
template <class Traits, class Field>
Cubic_columns<Field, dimension_v<Traits>> geometry_columns(const Hermite_geometry<Traits>& g) {
  return {coordinates<Traits, Field>(g.p1), coordinates<Traits, Field>(g.p4), coordinates<Traits, Field>(g.r1),
          coordinates<Traits, Field>(g.r4)};
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
/// A cubic curve \f$ Q(t) = G\,M\,[t^3\ t^2\ t\ 1]^T \f$ on [0, 1] with the geometry `G`, four columns that are points or vectors,
/// and the matrix `M` of a basis. Lecture slides, "Blended curves".
///
/// \code{.cpp}
/// Cubic_blended_curve<Traits, Hermite_basis> q({p1, p4, r1, r4});   // points and vectors
/// Cubic_blended_curve<Traits, Cardinal_basis<FT>> s({p0, p1, p2, p3}, {FT(1) / FT(2)});
/// \endcode
///
/// `continuity()` reads the geometry and the matrix in the field of the predicate: with
/// `Exact_predicates_inexact_constructions_kernel` the joins of blended curves with `double` points are decided exactly, before
/// any constructed point is rounded.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Basis a model of `CubicBasis`
/// \models ParametricCurve
template <class Traits_, class Basis_> class Cubic_blended_curve {
public:
  typedef Traits_ Traits;                                     ///< the traits class
  typedef Basis_ Basis;                                       ///< the basis
  typedef typename Traits::FT FT;                             ///< the field
  typedef typename Traits::Point Point;                       ///< the points of the kernel
  typedef typename Traits::Vector Vector;                     ///< the vectors of the kernel
  typedef typename Basis::template Geometry<Traits> Geometry; ///< four points, or points and vectors
  static constexpr int N = dimension_v<Traits>;               ///< the dimension, or 0 when it is known at run time only

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

  /// Returns the jet of order `k` at the finite parameter `t`, which may lie outside of the domain; derivatives of order 4 and
  /// more are zero. \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> jet(const FT& t, int k) const { return Curve_jet<Traits>(jet_over<FT>(t, k)); }

  /// Returns the jet of order `k` at the start in another field, to which the geometry is converted first.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const { return jet_over<Field>(Field(0), k); }
  /// Returns the jet of order `k` at the end in another field, to which the geometry is converted first.
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
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when a floating-point number overflows
  Bezier_curve<Traits, 3> bezier(const FT& a = FT(0), const FT& b = FT(1)) const {
    return bezier(basis_conversion<FT>(basis_, Bezier_basis()), a, b);
  }

  /// Returns this curve as a Bézier curve on [a, b], by the matrix `basis_conversion<FT>(basis(), Bezier_basis())`, which many
  /// curves of one basis can share.
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when a floating-point number overflows
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
      for (int p = 3; p >= j; --p) { // Horner: the j-th derivative of t^p is p (p-1) ... (p-j+1) t^(p-j)
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

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_CUBIC_BLENDED_CURVE_H
