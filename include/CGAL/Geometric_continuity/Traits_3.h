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
/// With `Exact_predicates_inexact_constructions_kernel` predicates are decided in `Exact_rational` on the
/// coordinates as given; with every other kernel they are decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel`
/// \models GeometricContinuityTraits
template <class K> class Traits_3 {
public:
  typedef K Kernel;
  typedef typename K::FT FT;
  typedef typename K::Point_3 Point;
  typedef typename K::Vector_3 Vector;
  typedef Dimension_tag<3> Dimension;
  typedef typename internal::Kernel_predicate_field<K>::type Predicate_FT;

  struct Compute_dimension {
    int operator()(const Point&) const { return 3; }
    int operator()(const Vector&) const { return 3; }
  };
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return internal::kernel_coordinate<FT>(p, i); }
    FT operator()(const Vector& v, int i) const { return internal::kernel_coordinate<FT>(v, i); }
  };
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int, RandomAccessIterator first, RandomAccessIterator) const {
      return Point(first[0], first[1], first[2]);
    }
  };
  struct Construct_vector {
    template <class RandomAccessIterator>
    Vector operator()(int, RandomAccessIterator first, RandomAccessIterator) const {
      return Vector(first[0], first[1], first[2]);
    }
  };

  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  Construct_point construct_point_object() const { return Construct_point(); }
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H
