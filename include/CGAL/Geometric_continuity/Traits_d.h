// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRAITS_D_H
#define CGAL_GEOMETRIC_CONTINUITY_TRAITS_D_H

#include <CGAL/Dimension.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <type_traits>

namespace CGAL {

// A type of CGAL that is declared here and not defined, so that Eigen is not needed. It does not name its exact field.
template <class Dimension> struct Epick_d;

namespace Geometric_continuity {

namespace internal {
template <class K> struct Is_filtered_d : std::false_type {};
template <class Dimension> struct Is_filtered_d<Epick_d<Dimension>> : std::true_type {};
} // namespace internal

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for curves whose dimension is known at run time, over a dD kernel such as
/// `Cartesian_d<FT>`, `Epick_d<Dynamic_dimension_tag>` or `Epeck_d<Dynamic_dimension_tag>` (the last two
/// need Eigen).
///
/// With `Epick_d` predicates are decided in `Exact_field<double>::type` on the coordinates as given; with every
/// other kernel they are decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel_d`
/// \cgalModels{GeometricContinuityTraits}
template <class K> class Traits_d {
public:
  typedef K Kernel;                        ///< the kernel
  typedef typename K::FT FT;               ///< its numbers, in which constructions are made
  typedef typename K::Point_d Point;       ///< its points
  typedef typename K::Vector_d Vector;     ///< its vectors
  typedef Dynamic_dimension_tag Dimension; ///< the dimension of the space
  /// The field in which predicates are decided.
  typedef std::conditional_t<internal::Is_filtered_d<K>::value, typename Exact_field<FT>::type, FT> Predicate_FT;

  /// Returns the number of coordinates of a point or a vector.
  struct Compute_dimension {
    int operator()(const Point& p) const { return static_cast<int>(p.dimension()); }
    int operator()(const Vector& v) const { return static_cast<int>(v.dimension()); }
  };
  /// Returns the coordinate number `i` of a point or a vector.
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return p[i]; }
    FT operator()(const Vector& v, int i) const { return v[i]; }
  };
  /// Constructs a point from a range of coordinates.
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int d, RandomAccessIterator first, RandomAccessIterator last) const {
      return Point(d, first, last);
    }
  };
  /// Constructs a vector from a range of coordinates.
  struct Construct_vector {
    template <class RandomAccessIterator>
    Vector operator()(int d, RandomAccessIterator first, RandomAccessIterator last) const {
      return Vector(d, first, last);
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

#endif // CGAL_GEOMETRIC_CONTINUITY_TRAITS_D_H
