// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H
#define CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H

#include <CGAL/Dimension.h>
#include <CGAL/Geometric_continuity/numbers/internal/kernel_access.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for curves of dimension 3 over a CGAL kernel.
///
/// With `Exact_predicates_inexact_constructions_kernel` predicates are decided in `Exact_field<double>::type` on
/// the coordinates as given; with every other kernel they are decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel`
/// \models GeometricContinuityTraits
template <class K> class Traits_3 {
public:
  typedef K Kernel;                    ///< the kernel
  typedef typename K::FT FT;           ///< its numbers, in which constructions are made
  typedef typename K::Point_3 Point;   ///< its points
  typedef typename K::Vector_3 Vector; ///< its vectors
  typedef Dimension_tag<3> Dimension;  ///< the dimension of the space
  /// The field in which predicates are decided.
  typedef typename internal::Kernel_predicate_field<K>::type Predicate_FT;

  /// Returns the number of coordinates of a point or a vector.
  struct Compute_dimension {
    int operator()(const Point&) const { return 3; }
    int operator()(const Vector&) const { return 3; }
  };
  /// Returns the coordinate number `i` of a point or a vector.
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return internal::kernel_coordinate<FT>(p, i); }
    FT operator()(const Vector& v, int i) const { return internal::kernel_coordinate<FT>(v, i); }
  };
  /// Constructs a point from a range of coordinates.
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int, RandomAccessIterator first, RandomAccessIterator) const {
      return Point(first[0], first[1], first[2]);
    }
  };
  /// Constructs a vector from a range of coordinates.
  struct Construct_vector {
    template <class RandomAccessIterator>
    Vector operator()(int, RandomAccessIterator first, RandomAccessIterator) const {
      return Vector(first[0], first[1], first[2]);
    }
  };

  /// Returns the function object `Compute_dimension`.
  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  /// Returns the function object `Compute_coordinate`.
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  /// Returns the function object `Construct_point`.
  Construct_point construct_point_object() const { return Construct_point(); }
  /// Returns the function object `Construct_vector`.
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H
