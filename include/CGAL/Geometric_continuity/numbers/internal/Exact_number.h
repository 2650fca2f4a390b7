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
/// Facts about exact numbers without their headers, which take longer to compile than a kernel.

namespace CGAL {

namespace internal {
// CGAL defines it; its header comes with each kernel that filters predicates
template <typename> struct Exact_field_selector;
} // namespace internal

namespace Geometric_continuity {
namespace internal {

template <class T, class = void> struct Is_complete : std::false_type {};
template <class T> struct Is_complete<T, std::void_t<decltype(sizeof(T))>> : std::true_type {};

// See Exact_field. For floating-point numbers it is named only where CGAL's header of exact numbers
// is included.
template <class FT, bool = std::is_floating_point_v<FT>> struct Exact_field_of { typedef FT type; };
template <class FT> struct Exact_field_of<FT, true> {
#ifdef CGAL_GEOMETRIC_CONTINUITY_EXACT_FIELD_OF_BOOST
  // Here `Exact_rational` is a `Quotient`, which some versions of CGAL never cancel, so that
  // numbers grow with each operation.
  typedef boost::multiprecision::cpp_rational type;
#else
  typedef CGAL::internal::Exact_field_selector<std::enable_if_t<std::is_floating_point_v<FT>, double>> Selector;
  static_assert(Is_complete<Selector>::value, "these curves are decided by exact numbers, which their kernel does not "
                                              "bring: include CGAL/Geometric_continuity/numbers/Exact_field.h");
  typedef typename Selector::Type type; // that is, Exact_rational
#endif
};

// The type of the exact values of a field, and how to read them: numbers that are evaluated on
// demand, which have a member exact(), are evaluated; all others are exact themselves.
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
