// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H
#define CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H

#include <CGAL/Geometric_continuity/numbers/internal/kernel_access.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for curves of dimension 3 over a CGAL kernel, with the types and functions of `GeometricContinuityTraits`.
///
/// With `Exact_predicates_inexact_constructions_kernel` predicates are decided in `Exact_field<double>::type` on
/// the coordinates as given; with every other kernel they are decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel`
/// \cgalModels{GeometricContinuityTraits}
template <class K> class Traits_3 : public internal::Kernel_traits<K, typename K::Point_3, typename K::Vector_3, 3> {};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_TRAITS_3_H
