// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_KERNEL_COORDINATE_H
#define CGAL_GEOMETRIC_CONTINUITY_KERNEL_COORDINATE_H

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The i-th coordinate of a point or a vector of a kernel. A kernel that keeps them in an array is read there, without the
// branches of cartesian(i), which would keep a compiler from computing several coordinates at a time.
template <class FT, class Point_or_vector> FT kernel_coordinate(const Point_or_vector& p, int i) {
  if constexpr (std::is_pointer_v<decltype(p.cartesian_begin())>)
    return p.cartesian_begin()[i];
  else
    return p.cartesian(i);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_KERNEL_COORDINATE_H
