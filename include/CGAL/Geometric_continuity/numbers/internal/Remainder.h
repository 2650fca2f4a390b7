// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_REMAINDER_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_REMAINDER_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/Binary_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

/// \file Remainder.h
/// Decides if integers of any length are zero, without such integers, by the remainders of a number
/// modulo several moduli without common divisors are all zero if and only if their product divides
/// it, so that it is zero when it is smaller than the product.

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The moduli are 2^64 - c with these c: each is the least for which the modulus has no common
// divisor with those before it. Their product has 28160 bits.
constexpr std::uint16_t remainder_moduli[] = {
    0,    1,    3,    5,    9,    15,   17,   33,   39,   45,   47,   53,   57,   59,   63,   75,   77,   83,   87,
    89,   95,   99,   105,  113,  117,  119,  125,  129,  143,  147,  153,  155,  165,  173,  179,  183,  189,  195,
    197,  209,  215,  243,  249,  255,  257,  267,  279,  287,  293,  297,  299,  309,  323,  327,  329,  339,  347,
    353,  363,  365,  377,  389,  395,  399,  405,  407,  413,  417,  425,  437,  447,  453,  455,  465,  479,  483,
    503,  509,  519,  537,  539,  563,  573,  585,  593,  603,  609,  615,  623,  629,  635,  645,  657,  669,  675,
    677,  689,  693,  699,  707,  717,  725,  735,  743,  747,  755,  759,  767,  773,  785,  803,  813,  825,  827,
    833,  839,  843,  845,  855,  869,  873,  875,  879,  897,  899,  917,  927,  935,  945,  957,  963,  983,  993,
    1007, 1023, 1025, 1037, 1049, 1065, 1077, 1079, 1103, 1107, 1109, 1125, 1137, 1139, 1167, 1169, 1187, 1197, 1203,
    1209, 1235, 1253, 1257, 1263, 1265, 1275, 1295, 1299, 1305, 1319, 1323, 1335, 1337, 1343, 1365, 1373, 1377, 1379,
    1383, 1397, 1415, 1425, 1427, 1439, 1443, 1449, 1467, 1469, 1475, 1487, 1505, 1509, 1515, 1517, 1527, 1553, 1557,
    1559, 1569, 1583, 1587, 1595, 1607, 1617, 1629, 1635, 1649, 1665, 1673, 1679, 1683, 1709, 1713, 1715, 1733, 1737,
    1739, 1749, 1755, 1767, 1799, 1805, 1833, 1835, 1839, 1859, 1863, 1865, 1877, 1883, 1887, 1889, 1895, 1925, 1929,
    1935, 1937, 1949, 1965, 1977, 1989, 1995, 2003, 2009, 2015, 2033, 2037, 2045, 2049, 2063, 2079, 2085, 2087, 2097,
    2103, 2127, 2133, 2157, 2159, 2163, 2169, 2175, 2219, 2223, 2225, 2229, 2243, 2253, 2255, 2267, 2285, 2289, 2303,
    2307, 2309, 2325, 2327, 2345, 2349, 2357, 2367, 2379, 2393, 2399, 2405, 2409, 2427, 2433, 2439, 2463, 2475, 2477,
    2493, 2505, 2507, 2519, 2523, 2537, 2549, 2555, 2567, 2595, 2597, 2607, 2615, 2625, 2633, 2643, 2649, 2673, 2675,
    2679, 2693, 2699, 2709, 2717, 2723, 2727, 2729, 2745, 2757, 2765, 2769, 2783, 2805, 2807, 2813, 2817, 2825, 2847,
    2853, 2859, 2885, 2897, 2903, 2913, 2919, 2969, 2985, 2987, 2999, 3003, 3015, 3017, 3029, 3059, 3087, 3105, 3113,
    3119, 3125, 3135, 3143, 3153, 3155, 3179, 3183, 3189, 3219, 3225, 3237, 3245, 3263, 3267, 3293, 3297, 3303, 3329,
    3335, 3339, 3345, 3353, 3363, 3375, 3377, 3413, 3423, 3429, 3447, 3455, 3465, 3477, 3497, 3515, 3543, 3549, 3555,
    3563, 3573, 3575, 3587, 3603, 3609, 3633, 3645, 3647, 3659, 3683, 3687, 3689, 3693, 3699, 3713, 3717, 3729, 3743,
    3753, 3777, 3783, 3795, 3797, 3807, 3813, 3819, 3839, 3849, 3863, 3875, 3885, 3909, 3923, 3927, 3933, 3935, 3947,
    3959, 3975, 3977, 3989, 4005, 4019, 4023, 4029, 4049, 4065, 4079, 4089, 4095, 4107, 4109, 4127, 4133, 4143, 4145,
    4155, 4173, 4179};

// An integer modulo 2^64 - c. It brings its modulus along: small constants need not know it, and
// have c = 0.
class Remainder {
  std::uint64_t r_, c_; // r < 2^64 - c

public:
  Remainder() = default; // unspecified
  // \pre r < 2^64 - c
  CGAL_GC_FORCEINLINE explicit Remainder(std::uint64_t r, std::uint64_t c = 0) : r_(r), c_(c) {}
  // As 2^64 is c modulo 2^64 - c, the upper half of a long number is multiplied by c, and the few
  // bits beyond 2^64 once more.
  static CGAL_GC_FORCEINLINE Remainder of(Unsigned_128 x, std::uint64_t c) {
    const Unsigned_128 folded =
        static_cast<Unsigned_128>(static_cast<std::uint64_t>(x >> 64)) * c + static_cast<std::uint64_t>(x);
    const std::uint64_t low = static_cast<std::uint64_t>(folded),
                        sum = low + static_cast<std::uint64_t>(folded >> 64) * c;
    return {sum, c, sum < low};
  }

  friend BOOST_NOINLINE Remainder operator+(Remainder x, Remainder y) {
    const std::uint64_t c = x.c_ | y.c_, sum = x.r_ + y.r_;
    return {sum, c, sum < x.r_};
  }
  friend BOOST_NOINLINE Remainder operator-(Remainder x, Remainder y) {
    const std::uint64_t c = x.c_ | y.c_;
    return Remainder(x.r_ - y.r_ - (x.r_ < y.r_ ? c : 0), c);
  }
  friend BOOST_NOINLINE Remainder operator*(Remainder x, Remainder y) {
    return of(static_cast<Unsigned_128>(x.r_) * y.r_, x.c_ | y.c_);
  }
  friend CGAL_GC_FORCEINLINE bool operator==(Remainder x, Remainder y) { return x.r_ == y.r_; }

private:
  // Takes r + 2^64 carry, which is less than twice the modulus. For c = 0 nothing is added.
  CGAL_GC_FORCEINLINE Remainder(std::uint64_t r, std::uint64_t c, bool carry)
      : r_(carry || r >= 0 - c ? r + c : r), c_(c) {}
};

// Floating-point numbers of any size as multiples of the largest power of two of which all that
// have been included are: their remainders by one modulus after the other.
class Remainder_scale {
  // exponents
  int unit_ = (std::numeric_limits<int>::max)(), length_ = (std::numeric_limits<int>::min)();
  std::uint64_t c_ = 0;
  std::array<Remainder, 34> powers_; // of 2^64

public:
  typedef Binary_parts Number;
  typedef Remainder Ring;
  static constexpr bool exact = false;

  template <class FT> static Number number(const FT& x) { return Number(x); }

  BOOST_NOINLINE void include(const Number& x) {
    if (x.odd_part == 0) return;
    unit_ = (std::min)(unit_, x.exponent);
    length_ = (std::max)(length_, x.exponent + x.length());
  }
  // The numbers are less than 2^bits() units.
  int bits() const { return unit_ < length_ ? length_ - unit_ : 0; }

  // So many moduli have a product of more than 2^bits. \pre bits < 28160
  static int moduli(int bits) { return bits / 64 + 1; }
  BOOST_NOINLINE void take_modulus(int i) {
    c_ = remainder_moduli[i];
    powers_[0] = Remainder(1, c_);
    for (int k = 1; 64 * k <= bits(); ++k) powers_[k] = powers_[k - 1] * Remainder(c_, c_);
  }
  // Returns the remainder by the modulus that has been taken. \pre x has been included
  BOOST_NOINLINE Ring numerator(const Number& x) const {
    if (x.odd_part == 0) return Ring(0, c_);
    const int shift = x.exponent - unit_;
    Ring y = Ring::of(static_cast<Unsigned_128>(x.odd_part) << shift % 64, c_);
    if (shift >= 64) y = y * powers_[shift / 64];
    return x.negative ? Ring(0, c_) - y : y;
  }
  // Returns 1 with this modulus.
  Ring one() const { return Ring(1, c_); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_REMAINDER_H
