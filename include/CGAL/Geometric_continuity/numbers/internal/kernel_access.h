// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_KERNEL_ACCESS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_KERNEL_ACCESS_H

#include <CGAL/Dimension.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Tells whether a kernel keeps the coordinates of a point or a vector in an array.
template <class Point_or_vector, class = void> constexpr bool has_array_of_coordinates = false;
template <class Point_or_vector>
constexpr bool has_array_of_coordinates<
    Point_or_vector,
    std::enable_if_t<std::is_pointer_v<decltype(std::declval<const Point_or_vector&>().cartesian_begin())>>> = true;

// The i-th coordinate of a point or a vector of a kernel. A kernel that keeps them in an array is
// read there, without the branches of cartesian(i), which would keep a compiler from computing
// several coordinates at a time.
template <class FT, class Point_or_vector> FT kernel_coordinate(const Point_or_vector& p, int i) {
  if constexpr (has_array_of_coordinates<Point_or_vector>)
    return p.cartesian_begin()[i];
  else
    return p.cartesian(i);
}

// Returns f(x) for the i-th coordinate x of a point of a traits class: where the kernel keeps it,
// not a copy, if it has an array.
template <class Traits, class Point, class Function>
decltype(auto) with_coordinate(const Point& p, int i, const Function& f) {
  if constexpr (has_array_of_coordinates<Point>)
    return f(p.cartesian_begin()[i]);
  else
    return f(typename Traits::FT(Traits().compute_coordinate_object()(p, i)));
}

// The field in which predicates are decided: the exact field of the numbers of a kernel that
// filters predicates on floating-point numbers, as Exact_predicates_inexact_constructions_kernel
// does; otherwise that of the kernel.
template <class K, bool filtered = (K::Has_filtered_predicates && std::is_floating_point_v<typename K::FT>)>
struct Kernel_predicate_field {
  typedef typename K::FT type;
};
template <class K> struct Kernel_predicate_field<K, true> {
  typedef typename Exact_field_of<typename K::FT>::type type;
};

// The traits class for points and vectors of a kernel with d coordinates, 2 or 3: see
// GeometricContinuityTraits.
template <class K, class Point_, class Vector_, int d> class Kernel_traits {
  static_assert(d == 2 || d == 3, "points have two or three coordinates");

  template <class Result, class Iterator> static Result constructed(Iterator x) {
    if constexpr (d == 2)
      return Result(x[0], x[1]);
    else
      return Result(x[0], x[1], x[2]);
  }

public:
  typedef K Kernel;
  typedef typename K::FT FT;
  typedef Point_ Point;
  typedef Vector_ Vector;
  typedef Dimension_tag<d> Dimension;
  typedef typename Kernel_predicate_field<K>::type Predicate_FT;

  struct Compute_dimension {
    int operator()(const Point&) const { return d; }
    int operator()(const Vector&) const { return d; }
  };
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return kernel_coordinate<FT>(p, i); }
    FT operator()(const Vector& v, int i) const { return kernel_coordinate<FT>(v, i); }
  };
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int, RandomAccessIterator first, RandomAccessIterator) const {
      return constructed<Point>(first);
    }
  };
  struct Construct_vector {
    template <class RandomAccessIterator>
    Vector operator()(int, RandomAccessIterator first, RandomAccessIterator) const {
      return constructed<Vector>(first);
    }
  };

  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  Construct_point construct_point_object() const { return Construct_point(); }
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_KERNEL_ACCESS_H
