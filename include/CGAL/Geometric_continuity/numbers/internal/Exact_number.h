// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_EXACT_NUMBER_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_EXACT_NUMBER_H

#include <CGAL/config.h>

#include <boost/version.hpp>

#if !defined(CGAL_USE_GMP) && !defined(CGAL_USE_LEDA) && BOOST_VERSION <= 107800
#include <CGAL/boost_mp.h>
#define CGAL_GEOMETRIC_CONTINUITY_EXACT_FIELD_OF_BOOST
#endif

#include <type_traits>
#include <utility>

/// \file Exact_number.h
/// What is said of exact numbers without a header of theirs: those take longer to compile than a kernel.

namespace CGAL {

namespace internal {
template <typename> struct Exact_field_selector; // of CGAL; its header comes with each kernel that filters predicates
} // namespace internal

namespace Geometric_continuity {
namespace internal {

// The exact field of a floating-point type, to be named where CGAL's header of exact numbers is included.
template <class FT> struct Exact_field_of_floating_point {
#ifdef CGAL_GEOMETRIC_CONTINUITY_EXACT_FIELD_OF_BOOST
  // Here `Exact_rational` is a `Quotient`, which some versions of CGAL never cancel, so that numbers grow with each
  // operation.
  typedef boost::multiprecision::cpp_rational type;
#else
  // that is, Exact_rational
  typedef
      typename CGAL::internal::Exact_field_selector<std::enable_if_t<std::is_floating_point_v<FT>, double>>::Type type;
#endif
};

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

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_EXACT_NUMBER_H
