// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SHORT_DOUBLE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SHORT_DOUBLE_H

#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The number with so many binary digits nearest to x, or of two the one farther from 0, in every rounding mode: the other
// digits are cut off from the bits of x, which is not subnormal, and far below the largest number.
template <int digits> double short_double(double x) {
  static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
  constexpr int dropped = 53 - digits;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  bits = (bits + (std::uint64_t(1) << (dropped - 1))) >> dropped << dropped;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SHORT_DOUBLE_H
