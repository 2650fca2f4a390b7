// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BROWSER_EXACT_RATIONAL_H
#define GEOMETRIC_CONTINUITY_BROWSER_EXACT_RATIONAL_H

#include <CGAL/Number_types/internal/Exact_type_selector.h>

/// \file exact_rational.h
/// `CGAL::Exact_rational` where there is no GMP: the rational numbers of Boost, in lowest terms.
/// Without this header, which is included first by an option of the compiler, CGAL takes quotients
/// that are never cancelled with the Boost of Debian.

#if !defined(CGAL_USE_GMP) && BOOST_VERSION <= 107800
namespace CGAL {
namespace internal {

template <> struct Exact_field_selector<double> { typedef boost::multiprecision::cpp_rational Type; };

} // namespace internal
} // namespace CGAL
#endif

#endif // GEOMETRIC_CONTINUITY_BROWSER_EXACT_RATIONAL_H
