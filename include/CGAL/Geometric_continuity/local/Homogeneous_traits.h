// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_TRAITS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_TRAITS_H

#include <CGAL/Geometric_continuity/local/coordinates.h>

#include <type_traits>

/// \file Homogeneous_traits.h
/// Homogeneous points \f$ (w x, w) \f$, of one dimension more: rational curves and surfaces are polynomial ones of such points.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for the homogeneous points of another one: columns \f$ (w x_1, \dots, w x_n, w) \f$. A polynomial curve or
/// surface over it is the numerator and the denominator of a rational one over `Traits`, and so every algorithm for polynomials
/// serves both.
///
/// \tparam Traits_ a model of `GeometricContinuityTraits`
/// \models GeometricContinuityTraits
template <class Traits_> class Homogeneous_traits {
  static constexpr int N = dimension_v<Traits_>;

public:
  typedef Traits_ Affine_traits;                             ///< the traits class of the points \f$ x \f$
  typedef typename Traits_::FT FT;                           ///< its numbers
  typedef Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> Point; ///< a homogeneous point
  typedef Point Vector;                                      ///< a difference or a derivative of such points
  /// One dimension more than that of the points \f$ x \f$.
  typedef std::conditional_t<N == 0, Dynamic_dimension_tag, Dimension_tag<N + 1>> Dimension;
  /// The field in which predicates are decided.
  typedef Geometric_continuity::Predicate_FT<Traits_> Predicate_FT;

  /// Returns the number of coordinates.
  struct Compute_dimension {
    int operator()(const Point& p) const { return p.dimension(); }
  };
  /// Returns the coordinate number `i`.
  struct Compute_coordinate {
    const FT& operator()(const Point& p, int i) const { return p[i]; }
  };
  /// Constructs a column from a range of coordinates.
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int d, RandomAccessIterator first, RandomAccessIterator) const {
      Point p(d);
      for (int i = 0; i < d; ++i) p[i] = first[i];
      return p;
    }
  };
  typedef Construct_point Construct_vector; ///< constructs a column, too

  /// Returns the function object `Compute_dimension`.
  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  /// Returns the function object `Compute_coordinate`.
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  /// Returns the function object `Construct_point`.
  Construct_point construct_point_object() const { return Construct_point(); }
  /// Returns the function object `Construct_vector`.
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

/// \ingroup PkgGeometricContinuityTraits
/// Returns the homogeneous point \f$ (w x, w) \f$, or \f$ (x, 0) \f$ for the weight 0: the infinite point in the direction
/// \f$ x \f$. \tparam N the dimension of `x`, or 0
template <class FT, int N>
Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> homogeneous_point(const Coordinate_vector<FT, N>& x, const FT& w) {
  const int n = x.dimension();
  Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> p(n + 1);
  const bool infinite = w == FT(0);
  for (int i = 0; i < n; ++i) p[i] = infinite ? x[i] : FT(w * x[i]);
  p[n] = w;
  return p;
}

/// \ingroup PkgGeometricContinuityTraits
/// Returns \f$ x \f$ of a homogeneous point \f$ (w x, w) \f$, or of an infinite point \f$ (x, 0) \f$; the weight is its last
/// coordinate. \tparam M the dimension of `p`, one more than that of `x`, or 0
template <class FT, int M> Coordinate_vector<FT, (M == 0 ? 0 : M - 1)> affine_point(const Coordinate_vector<FT, M>& p) {
  const int n = p.dimension() - 1;
  Coordinate_vector<FT, (M == 0 ? 0 : M - 1)> x(n);
  const bool as_it_is = p[n] == FT(0) || p[n] == FT(1);
  for (int i = 0; i < n; ++i) x[i] = as_it_is ? p[i] : FT(p[i] / p[n]);
  return x;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_TRAITS_H
