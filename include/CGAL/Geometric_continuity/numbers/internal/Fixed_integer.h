// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FIXED_INTEGER_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FIXED_INTEGER_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <cstdint>

// Without a 128-bit product of the compiler everything is decided in multi-precision.
#ifdef __SIZEOF_INT128__
#define CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The carry flag, where the compiler has functions for it.
#if defined __has_builtin && defined __x86_64__
#if __has_builtin(__builtin_ia32_sbb_u64) && __has_builtin(__builtin_ia32_addcarryx_u64)
#define CGAL_GEOMETRIC_CONTINUITY_X86_CARRY
#endif
#endif

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

__extension__ typedef __int128 Signed_128;
__extension__ typedef unsigned __int128 Unsigned_128;

// x + y + carry modulo 2^64, and x - y - borrow, with the carry or borrow that goes out. Other ways
// to write this make some compilers branch on the carry.
typedef unsigned char Carry;
CGAL_GC_FORCEINLINE std::uint64_t add_with_carry(std::uint64_t x, std::uint64_t y, Carry& carry) {
  unsigned long long sum;
#ifdef CGAL_GEOMETRIC_CONTINUITY_X86_CARRY
  // unreachable: the compiler of GNU has these functions
  carry = __builtin_ia32_addcarryx_u64(carry, x, y, &sum);
#else
  const bool first = __builtin_add_overflow(x, y, &sum), second = __builtin_add_overflow(sum, carry, &sum);
  carry = first | second;
#endif
  return sum;
}
CGAL_GC_FORCEINLINE std::uint64_t subtract_with_borrow(std::uint64_t x, std::uint64_t y, Carry& borrow) {
  unsigned long long difference;
#ifdef CGAL_GEOMETRIC_CONTINUITY_X86_CARRY
  // unreachable: the compiler of GNU has these functions
  borrow = __builtin_ia32_sbb_u64(borrow, x, y, &difference);
#else
  const bool first = __builtin_sub_overflow(x, y, &difference),
             second = __builtin_sub_overflow(difference, borrow, &difference);
  borrow = first | second;
#endif
  return difference;
}

// An integer of `limbs` times 64 bits, two's complement, least significant limb first. A product
// has as many limbs as its factors together, so it never overflows, but not more than `most`:
// beyond them it is taken modulo 2^(64 most). A sum does not grow: the caller leaves it room,
// unless it has `most` limbs.
//
// The loops over limbs are recursions, which are unrolled at every level of optimisation.
constexpr int unlimited = 1 << 16;
template <int limbs, int most = unlimited> struct Fixed_integer {
  static_assert(1 <= limbs && limbs <= most);
  std::uint64_t limb[limbs];

  Fixed_integer() = default;
  CGAL_GC_FORCEINLINE Fixed_integer(std::int64_t x) { fill<0>(x); }

  CGAL_GC_FORCEINLINE std::int64_t top() const { return static_cast<std::int64_t>(limb[limbs - 1]); }

  // all ones when negative, otherwise 0
  CGAL_GC_FORCEINLINE std::uint64_t sign_mask() const { return static_cast<std::uint64_t>(top() >> 63); }

  friend CGAL_GC_FORCEINLINE bool is_zero(const Fixed_integer& x) { return x.template any<0>() == 0; }

  friend CGAL_GC_FORCEINLINE Fixed_integer operator+(const Fixed_integer& x, const Fixed_integer& y) {
    Fixed_integer sum;
    sum.template add<0>(x, y, 0);
    return sum;
  }
  friend CGAL_GC_FORCEINLINE Fixed_integer operator-(const Fixed_integer& x, const Fixed_integer& y) {
    Fixed_integer difference;
    difference.template subtract<0>(x, y, 0);
    return difference;
  }

private:
  template <int k> CGAL_GC_FORCEINLINE void fill(std::int64_t x) {
    limb[k] = static_cast<std::uint64_t>(k == 0 ? x : x >> 63);
    if constexpr (k + 1 < limbs) fill<k + 1>(x);
  }
  template <int k> CGAL_GC_FORCEINLINE std::uint64_t any() const {
    if constexpr (k + 1 < limbs)
      return limb[k] | any<k + 1>();
    else
      return limb[k];
  }
  template <int k> CGAL_GC_FORCEINLINE void add(const Fixed_integer& x, const Fixed_integer& y, Carry carry) {
    limb[k] = add_with_carry(x.limb[k], y.limb[k], carry);
    if constexpr (k + 1 < limbs) add<k + 1>(x, y, carry);
  }
  template <int k> CGAL_GC_FORCEINLINE void subtract(const Fixed_integer& x, const Fixed_integer& y, Carry borrow) {
    limb[k] = subtract_with_borrow(x.limb[k], y.limb[k], borrow);
    if constexpr (k + 1 < limbs) subtract<k + 1>(x, y, borrow);
  }
};

// x y for 0 <= x < 2^64, which is in absolute value at most 2^127 - 2^63
CGAL_GC_FORCEINLINE Signed_128 unsigned_times_signed(std::uint64_t x, std::int64_t y) {
  const Unsigned_128 product = static_cast<Unsigned_128>(x) * static_cast<std::uint64_t>(y);
  // y stands for y + 2^64 when negative
  const std::uint64_t excess = x & static_cast<std::uint64_t>(y >> 63);
  return static_cast<Signed_128>(product - (static_cast<Unsigned_128>(excess) << 64));
}

// The product of numbers of m and n limbs.
template <int m, int n, int most> using Fixed_product = Fixed_integer<(m + n < most ? m + n : most), most>;

// Limb by limb with a signed carry: -2^127 <= x_k y + carry < 2^127. The last limb of a product
// that is not longer than x is taken modulo 2^64.
template <int k, int m, int n, int most>
CGAL_GC_FORCEINLINE void multiply(const Fixed_integer<m, most>& x, std::int64_t y, Signed_128 carry,
                                  Fixed_integer<n, most>& product) {
  if constexpr (k + 1 == n)
    product.limb[k] = x.limb[k] * static_cast<std::uint64_t>(y) + static_cast<std::uint64_t>(carry);
  else if constexpr (k + 1 < m) {
    carry += unsigned_times_signed(x.limb[k], y);
    product.limb[k] = static_cast<std::uint64_t>(carry);
    multiply<k + 1>(x, y, carry >> 64, product);
  } else {
    carry += static_cast<Signed_128>(x.top()) * y;
    product.limb[k] = static_cast<std::uint64_t>(carry);
    product.limb[k + 1] = static_cast<std::uint64_t>(carry >> 64);
  }
}

template <int m, int most>
CGAL_GC_FORCEINLINE Fixed_product<m, 1, most> operator*(const Fixed_integer<m, most>& x,
                                                        const Fixed_integer<1, most>& y) {
  Fixed_product<m, 1, most> product;
  multiply<0>(x, y.top(), 0, product);
  return product;
}

// Limbs i, i + 1, ... of the sum become those of sum + x y_i; in the first row the sum is 0.
template <int i, int k, int m, int n, int most>
CGAL_GC_FORCEINLINE void add_row(const Fixed_integer<m, most>& x, std::uint64_t y, std::uint64_t carry,
                                 Fixed_integer<n, most>& sum) {
  if constexpr (i + k + 1 == n) { // modulo 2^(64 n)
    const std::uint64_t last = x.limb[k] * y + carry;
    if constexpr (i > 0)
      sum.limb[i + k] += last;
    else
      sum.limb[i + k] = last;
  } else {
    Unsigned_128 t = static_cast<Unsigned_128>(x.limb[k]) * y + carry;
    if constexpr (i > 0) t += sum.limb[i + k];
    sum.limb[i + k] = static_cast<std::uint64_t>(t);
    if constexpr (k + 1 < m)
      add_row<i, k + 1>(x, y, static_cast<std::uint64_t>(t >> 64), sum);
    else
      sum.limb[i + m] = static_cast<std::uint64_t>(t >> 64);
  }
}
template <int i, int m, int n, int most, int l>
CGAL_GC_FORCEINLINE void add_rows(const Fixed_integer<m, most>& x, const Fixed_integer<n, most>& y,
                                  Fixed_integer<l, most>& sum) {
  add_row<i, 0>(x, y.limb[i], 0, sum);
  if constexpr (i + 1 < n) add_rows<i + 1>(x, y, sum);
}

// x - (y and mask) 2^(64 i), modulo 2^(64 m)
template <int i, int k, int m, int n, int most>
CGAL_GC_FORCEINLINE void subtract_masked(Fixed_integer<m, most>& x, const Fixed_integer<n, most>& y, std::uint64_t mask,
                                         Carry borrow) {
  if constexpr (k < n && i + k < m) {
    x.limb[i + k] = subtract_with_borrow(x.limb[i + k], y.limb[k] & mask, borrow);
    subtract_masked<i, k + 1>(x, y, mask, borrow);
  }
}

// The product of the limbs read as nonnegative numbers, corrected: a negative x stands for x +
// 2^(64 m).
template <int m, int n, int most>
CGAL_GC_FORCEINLINE Fixed_product<m, n, most> operator*(const Fixed_integer<m, most>& x,
                                                        const Fixed_integer<n, most>& y) {
  Fixed_product<m, n, most> product;
  add_rows<0>(x, y, product);
  subtract_masked<m, 0>(product, y, x.sign_mask(), 0);
  subtract_masked<n, 0>(product, x, y.sign_mask(), 0);
  return product;
}

// x w, which must fit, or modulo 2^(64 m)
template <int m, int most>
CGAL_GC_FORCEINLINE Fixed_integer<m, most> scaled(const Fixed_integer<m, most>& x, std::int64_t w) {
  Fixed_integer<m, most> product;
  multiply<0>(x, w, 0, product);
  return product;
}

// Returns the number with at least as many limbs.
template <int l, int m> CGAL_GC_FORCEINLINE Fixed_integer<l> extended(const Fixed_integer<m>& x) {
  static_assert(m <= l);
  Fixed_integer<l> result(static_cast<std::int64_t>(x.sign_mask()));
  for (int k = 0; k < m; ++k) result.limb[k] = x.limb[k];
  return result;
}
template <int l> CGAL_GC_FORCEINLINE Fixed_integer<l> from_128_bits(Signed_128 x) {
  Fixed_integer<l> result(static_cast<std::int64_t>(x >> 127));
  result.limb[0] = static_cast<std::uint64_t>(x);
  if constexpr (l > 1) result.limb[1] = static_cast<std::uint64_t>(x >> 64);
  return result;
}

// The product modulo 2^(64 l), or all of it in l limbs. \pre l is not less than the lengths of the
// factors, nor more than their sum
template <int l, int m, int n>
CGAL_GC_FORCEINLINE Fixed_integer<l> product_in(const Fixed_integer<m>& x, const Fixed_integer<n>& y) {
  static_assert(m <= l && n <= l && l <= m + n);
  if constexpr (l == m + n)
    return x * y;
  else {
    Fixed_integer<l> product;
    add_rows<0>(x, y, product);
    subtract_masked<m, 0>(product, y, x.sign_mask(), 0);
    subtract_masked<n, 0>(product, x, y.sign_mask(), 0);
    return product;
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // __SIZEOF_INT128__

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FIXED_INTEGER_H
