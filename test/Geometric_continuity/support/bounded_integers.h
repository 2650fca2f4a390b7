// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// Integers of fixed length of which only a bound is known. A form that is evaluated on them tells,
// at compile time, whether all its parts stay within their limbs.

// 2^n
constexpr double bound_of_bits(int n) { return n == 0 ? 1 : 2 * bound_of_bits(n - 1); }

// A bound of the absolute value of an integer of `bits` bits with its sign, and whether it and all
// from which it was computed fit into theirs. The margin is for the roundings of the bounds.
struct Integer_bound {
  double bound;
  bool fits;

  constexpr Integer_bound(double largest, int bits, bool parts_fit = true)
      : bound(largest), fits(parts_fit && largest < (1 - 0x1p-40) * bound_of_bits(bits - 1)) {}
};

// A factor of 64 bits.
struct Factor_bound : Integer_bound {
  constexpr Factor_bound(double largest, bool parts_fit = true) : Integer_bound(largest, 64, parts_fit) {}
  friend constexpr Factor_bound operator*(const Factor_bound& x, const Factor_bound& y) {
    return {x.bound * y.bound, x.fits && y.fits};
  }
};

// As Fixed_integer<limbs>: a product has as many limbs as its factors together, a sum and a scaled
// number as many as before.
template <int limbs> struct Bounded_integer : Integer_bound {
  constexpr Bounded_integer(double largest, bool parts_fit = true) : Integer_bound(largest, 64 * limbs, parts_fit) {}
  constexpr explicit Bounded_integer(const Factor_bound& x) : Bounded_integer(x.bound, x.fits) {}

  friend constexpr Bounded_integer operator+(const Bounded_integer& x, const Bounded_integer& y) {
    return {x.bound + y.bound, x.fits && y.fits};
  }
  friend constexpr Bounded_integer operator-(const Bounded_integer& x, const Bounded_integer& y) { return x + y; }
};
template <int m, int n>
constexpr Bounded_integer<m + n> operator*(const Bounded_integer<m>& x, const Bounded_integer<n>& y) {
  return {x.bound * y.bound, x.fits && y.fits};
}
template <int m> constexpr Bounded_integer<m> scaled(const Bounded_integer<m>& x, const Factor_bound& w) {
  return {x.bound * w.bound, x.fits && w.fits};
}
