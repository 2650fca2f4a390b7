// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FRACTION_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FRACTION_H

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The constant p/q in the field FT. With floating-point numbers it is divided by the compiler, also under
// -frounding-math.
template <class FT, int p, int q> FT fraction() {
  if constexpr (std::is_floating_point_v<FT>) {
    constexpr FT value = FT(p) / FT(q);
    return value;
  } else
    return FT(FT(p) / FT(q));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FRACTION_H
