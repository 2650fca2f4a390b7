// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_RANGE_OF_POINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_RANGE_OF_POINTS_H

#include <iterator>
#include <type_traits>
#include <utility>

/// \file Range_of_points.h
/// Tells the ranges of control points, which make curves, from curves, which have control points.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class T, class = void> struct Has_traits : std::false_type {};
template <class T> struct Has_traits<T, std::void_t<typename T::Traits>> : std::true_type {};

// Void if the points of a range are those of a curve. A curve is no range: its control points alone
// are not all of it.
template <class Range, class Point>
using Range_of_points = std::enable_if_t<
    std::is_convertible_v<typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::reference,
                          const Point&> &&
    !Has_traits<Range>::value>;

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_RANGE_OF_POINTS_H
