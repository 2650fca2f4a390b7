// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_KERNEL_ACCESS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_KERNEL_ACCESS_H

#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Whether a kernel keeps the coordinates of a point or a vector in an array.
template <class Point_or_vector, class = void> constexpr bool has_array_of_coordinates = false;
template <class Point_or_vector>
constexpr bool has_array_of_coordinates<
    Point_or_vector,
    std::enable_if_t<std::is_pointer_v<decltype(std::declval<const Point_or_vector&>().cartesian_begin())>>> = true;

// The i-th coordinate of a point or a vector of a kernel. A kernel that keeps them in an array is read there, without
// the branches of cartesian(i), which would keep a compiler from computing several coordinates at a time.
template <class FT, class Point_or_vector> FT kernel_coordinate(const Point_or_vector& p, int i) {
  if constexpr (has_array_of_coordinates<Point_or_vector>)
    return p.cartesian_begin()[i];
  else
    return p.cartesian(i);
}

// Returns f(x) for the i-th coordinate x of a point of a traits class: where the kernel keeps it, not a copy, if it has an array.
template <class Traits, class Point, class Function>
decltype(auto) with_coordinate(const Point& p, int i, const Function& f) {
  if constexpr (has_array_of_coordinates<Point>)
    return f(p.cartesian_begin()[i]);
  else
    return f(typename Traits::FT(Traits().compute_coordinate_object()(p, i)));
}

// The field in which predicates are decided: the exact field of the numbers of a kernel that filters predicates on
// floating-point numbers, as Exact_predicates_inexact_constructions_kernel does; otherwise that of the kernel.
template <class K, bool filtered = (K::Has_filtered_predicates && std::is_floating_point_v<typename K::FT>)>
struct Kernel_predicate_field {
  typedef typename K::FT type;
};
template <class K> struct Kernel_predicate_field<K, true> {
  typedef typename Exact_field_of_floating_point<typename K::FT>::type type;
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_KERNEL_ACCESS_H
