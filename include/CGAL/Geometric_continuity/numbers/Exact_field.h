// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>

#include <type_traits>

/// \file Exact_field.h
/// The numbers in which the package decides.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {
typedef Exact_field_of_floating_point<double>::type Exact_field_of_doubles;
} // namespace internal

/// \ingroup PkgGeometricContinuityTraits
/// The field in which numbers of type `FT` are decided exactly: `Exact_rational` for floating-point numbers, every
/// other field itself. Without GMP and LEDA, and with Boost up to 1.78, it is `boost::multiprecision::cpp_rational` for
/// floating-point numbers.
template <class FT> struct Exact_field {
  /// The exact field.
  typedef std::conditional_t<std::is_floating_point_v<FT>, internal::Exact_field_of_doubles, FT> type;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
