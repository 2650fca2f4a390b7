// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_IS_RATIONAL_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_IS_RATIONAL_H

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Whether a curve has weights.
template <class Curve, class = void> struct Is_rational : std::false_type {};
template <class Curve> struct Is_rational<Curve, std::void_t<typename Curve::Homogeneous>> : std::true_type {};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_IS_RATIONAL_H
