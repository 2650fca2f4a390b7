// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H

#include <CGAL/Exact_rational.h>

#include <type_traits>

/// \file Exact_field.h
/// The numbers in which the package decides.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTraits
/// The field in which numbers of type `FT` are decided exactly: `Exact_rational` for floating-point numbers, every other field
/// itself.
template <class FT> struct Exact_field {
  /// The exact field.
  typedef std::conditional_t<std::is_floating_point_v<FT>, Exact_rational, FT> type;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
