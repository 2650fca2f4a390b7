// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H

#include <CGAL/Exact_rational.h>

#include <boost/version.hpp>

#if !defined(CGAL_USE_GMP) && !defined(CGAL_USE_LEDA) && BOOST_VERSION <= 107800
#include <CGAL/boost_mp.h>
#define CGAL_GEOMETRIC_CONTINUITY_EXACT_FIELD_OF_BOOST
#endif

#include <type_traits>
#include <utility>

/// \file Exact_field.h
/// The numbers in which the package decides.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_EXACT_FIELD_OF_BOOST
// Here `Exact_rational` is a `Quotient`, which some versions of CGAL never cancel, so that numbers grow with each
// operation.
typedef boost::multiprecision::cpp_rational Exact_field_of_doubles;
#else
typedef Exact_rational Exact_field_of_doubles;
#endif

} // namespace internal

/// \ingroup PkgGeometricContinuityTraits
/// The field in which numbers of type `FT` are decided exactly: `Exact_rational` for floating-point numbers, every
/// other field itself. Without GMP and LEDA, and with Boost up to 1.78, it is `boost::multiprecision::cpp_rational` for
/// floating-point numbers.
template <class FT> struct Exact_field {
  /// The exact field.
  typedef std::conditional_t<std::is_floating_point_v<FT>, internal::Exact_field_of_doubles, FT> type;
};

namespace internal {

// The type of the exact values of a field, and how to read them: numbers that are evaluated on demand, which have a
// member exact(), are evaluated; all others are exact themselves.
template <class Field, class = void> struct Exact_number {
  typedef Field type;
  static const type& of(const Field& x) { return x; }
};
template <class Field> struct Exact_number<Field, std::void_t<decltype(std::declval<const Field&>().exact())>> {
  typedef std::decay_t<decltype(std::declval<const Field&>().exact())> type;
  static const type& of(const Field& x) { return x.exact(); }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
