// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_EXACT_NUMBER_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_EXACT_NUMBER_H

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
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

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_EXACT_NUMBER_H
