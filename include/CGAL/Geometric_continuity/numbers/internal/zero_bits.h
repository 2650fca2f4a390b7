// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ZERO_BITS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ZERO_BITS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <cstdint>

/// \file zero_bits.h
/// The zero bits at both ends of a word that is not zero: by one instruction where the compiler has
/// a function for it.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Counts by halves: the zero bits end in the half that is not zero.
constexpr int trailing_zero_bits_by_halves(std::uint64_t x) {
  int n = 0;
  for (int half = 32; half > 0; half /= 2)
    if ((x & ((std::uint64_t(1) << half) - 1)) == 0) {
      x >>= half;
      n += half;
    }
  return n;
}
constexpr int leading_zero_bits_by_halves(std::uint64_t x) {
  int n = 0;
  for (int half = 32; half > 0; half /= 2)
    if (x >> (64 - half) == 0) {
      x <<= half;
      n += half;
    }
  return n;
}

// \pre x is not zero
#if defined(__GNUC__)
CGAL_GC_FORCEINLINE int trailing_zero_bits(std::uint64_t x) { return __builtin_ctzll(x); }
CGAL_GC_FORCEINLINE int leading_zero_bits(std::uint64_t x) { return __builtin_clzll(x); }
#else
CGAL_GC_FORCEINLINE int trailing_zero_bits(std::uint64_t x) { return trailing_zero_bits_by_halves(x); }
CGAL_GC_FORCEINLINE int leading_zero_bits(std::uint64_t x) { return leading_zero_bits_by_halves(x); }
#endif

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ZERO_BITS_H
