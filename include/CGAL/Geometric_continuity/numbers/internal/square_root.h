// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SQUARE_ROOT_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SQUARE_ROOT_H

#include <CGAL/number_utils.h>

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The square root of a number whose type has one; for others one message of the compiler instead of
// those of CGAL.
template <class FT> FT square_root(const FT& x) {
  constexpr bool exists = !std::is_same_v<typename Algebraic_structure_traits<FT>::Sqrt, Null_functor>;
  static_assert(exists,
                "unit vectors, lengths and curvatures need a number type that has a square root, such as double: "
                "rational numbers have none");
  if constexpr (exists)
    return FT(CGAL::sqrt(x));
  else
    return x;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SQUARE_ROOT_H
