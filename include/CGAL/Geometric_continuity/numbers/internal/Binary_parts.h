// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_BINARY_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_BINARY_PARTS_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A floating-point number with its sign and the absolute value odd_part 2^exponent, or 0.
struct Binary_parts {
  std::uint64_t odd_part;
  int exponent; // the largest integer for 0
  bool negative;

  Binary_parts() = default; // unspecified
  template <class FT>
  BOOST_NOINLINE explicit Binary_parts(FT x)
      : odd_part(0), exponent((std::numeric_limits<int>::max)()), negative(x < 0) {
    constexpr int digits = std::numeric_limits<FT>::digits;
    static_assert(std::is_floating_point_v<FT> && digits <= 64);
    check_finite(x, "conversion to an exact number");
    if (x == 0) return;
    std::uint64_t n;
    if constexpr (digits <= 53) { // without the calls
      const double y = x;
      std::memcpy(&n, &y, sizeof n);
      // 0 for subnormal numbers, which have no leading 1
      const int e = static_cast<int>(n >> 52 & 2047);
      n = (n & ((std::uint64_t(1) << 52) - 1)) | std::uint64_t(e != 0) << 52;
      exponent = (std::max)(e, 1) - 1075;
    } else {
      // exact
      n = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(x), &exponent), digits));
      exponent -= digits;
    }
    const int zeros = trailing_zero_bits(n);
    odd_part = n >> zeros;
    exponent += zeros;
  }

  // The bits of the odd part. \pre the number is not 0
  int length() const { return 64 - leading_zero_bits(odd_part); }

  friend bool operator==(const Binary_parts& x, const Binary_parts& y) {
    return x.odd_part == y.odd_part && x.exponent == y.exponent && x.negative == y.negative;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_BINARY_PARTS_H
