// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_WORDS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_WORDS_H

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Rational numbers that are not evaluated on demand.
template <class FT>
constexpr bool is_rational_v = Common_denominator<FT>::clears&& std::is_same_v<typename Exact_number<FT>::type, FT>;

// The meter of the Work_scope of this thread for numbers whose work is counted, if there is one.
template <class FT> Work_meter* scope_of() {
  if constexpr (is_rational_v<FT>)
    return Work_meter::scope();
  else
    return nullptr;
}

// How many words the coordinates of vectors have over their common denominator, by which the work
// on them can be told in advance; 0 for numbers of another type, whose work is not counted.
template <class FT, class Vectors> std::size_t common_words(const Vectors& vectors) {
  if constexpr (!is_rational_v<FT>)
    return 0;
  else {
    Common_denominator<FT> denominator;
    std::size_t longest = 0;
    for (const auto& v : vectors)
      for (const FT& x : v) {
        denominator.include(x);
        longest = (std::max)(longest, number_words(x));
        work_meter().charge_divisors(1, denominator.words(), number_words(x));
      }
    return longest + denominator.words();
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_WORDS_H
