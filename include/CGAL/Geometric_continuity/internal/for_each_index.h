// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// f(0), ..., f(n-1), written out: then a compiler keeps the elements of an array in registers.
template <class Function, std::size_t... i>
CGAL_GC_FORCEINLINE void for_each_index(const Function& f, std::index_sequence<i...>) {
  (f(static_cast<int>(i)), ...);
}
template <int n, class Function> CGAL_GC_FORCEINLINE void for_each_index(const Function& f) {
  for_each_index(f, std::make_index_sequence<n>());
}
// Calls the function for each index, where n is 0 when the number is known at run time only.
template <int n, class Function> CGAL_GC_FORCEINLINE void for_each_index(int number, const Function& f) {
  if constexpr (n == 0)
    for (int i = 0; i < number; ++i) f(i);
  else
    for_each_index<n>(f);
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_INDEX_H
