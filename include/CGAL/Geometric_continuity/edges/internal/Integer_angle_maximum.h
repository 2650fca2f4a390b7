// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_INTEGER_ANGLE_MAXIMUM_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_INTEGER_ANGLE_MAXIMUM_H

#include <CGAL/Geometric_continuity/algebra/internal/Bounded_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Rounded_polynomial.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

/// \file Integer_angle_maximum.h
/// The search of Largest_measure for acute angles in integers of fixed length.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The coefficients of the homogeneous form in a ring.
template <class Ring> const Ring& coefficient_in(const Homogeneous_polynomial<Ring>& p, int k) { return p[k]; }
template <class Ring, int degree, int bits> Ring coefficient_in(const Bounded_polynomial<degree, bits>& p, int k) {
  constexpr int limbs = Bounded_polynomial<degree, bits>::limbs;
  const Ring half_word(0x1p32);
  Ring x(static_cast<double>(p.c[k].top() >> 32));
  for (int i = 2 * limbs - 2; i >= 0; --i)
    x = Ring(x * half_word + Ring(static_cast<double>(p.c[k].limb[i / 2] >> (i % 2 * 32) & 0xffffffff)));
  return x;
}

// Branch and bound as in Largest_measure, where all angles are acute, so that their measure is s/p:
// all pieces that may have the largest angle are halved until the bounds of it are close enough.
// They are rounded outwards to 62 digits; at an end of the edge they are exact.
template <class Field, class S, class P = S> class Integer_angle_maximum {
  typedef typename Common_denominator<Field>::Ring Ring;
  typedef typename Common_denominator<Field>::Exact Exact;

  struct Piece { // of length 2^-level, from 2^-level * index on
    Rounded_polynomial s, p;
    std::int64_t index;
    double upper;      // of 2^-shift s/p
    bool largest_at_0; // of the whole edge: there s/p is larger than elsewhere on the piece
    bool largest_at_1;
  };

  static constexpr int least_level = 5; // as in Largest_measure
  static constexpr int most_level = 50, last_level_of_place = 16;
  static constexpr std::size_t most_pieces = 32;

  const S& exact_s_;
  const P& exact_p_;
  std::vector<Piece> pieces_;
  int level_ = 0, shift_ = 0;
  double lower_ = 0, steps_ = 0;

public:
  // Takes polynomials of one degree.
  Integer_angle_maximum(const S& s, const P& p) : exact_s_(s), exact_p_(p) {}

  // Returns nothing where it does not get on, or the meter does not allow more.
  std::optional<Normal_deviation<Field>> operator()() {
    const std::optional<Rounded_polynomial> s = Rounded_polynomial::of(exact_s_), p = Rounded_polynomial::of(exact_p_);
    if (!s || !p) return std::nullopt;
    shift_ = s->exponent - p->exponent;
    add({*s, *p, 0, 0, false, false});
    if (!is_at_an_end(pieces_[0]) && upper() <= lower_ * (1 + 0x1p-40))
      return std::nullopt; // constant, or nearly: the bounds come close only slowly
    while (level_ < most_level) {
      if (!halve()) return std::nullopt;
      if (level_ < least_level) continue;
      if (std::all_of(pieces_.begin(), pieces_.end(), is_at_an_end)) return at_ends();
      // equivalent [<= -> <, 1]: one more halving where they are the same
      if (upper() <= lower_ * (1 + 0x1p-47))
        if (const std::optional<Normal_deviation<Field>> result = rounded()) return result;
    }
    return std::nullopt;
  }

private:
  static double to_double(Signed_128 x) {
    constexpr std::int64_t mask = (std::numeric_limits<std::int64_t>::max)();
    return static_cast<double>(static_cast<std::int64_t>(x >> 63)) * 0x1p63 +
           static_cast<double>(static_cast<std::int64_t>(x) & mask);
  }

  // A number that is not less than 2^-shift s/p for the coefficients number k, and one that is not
  // larger, for a positive divisor: three to five roundings by 2^-52.
  static double ratio_above(const Rounded_polynomial& s, const Rounded_polynomial& p, int k) {
    return to_double(s.c[k] + s.error) / to_double(p.c[k]) * (1 + 0x1p-49);
  }
  static double ratio_below(const Rounded_polynomial& s, const Rounded_polynomial& p, int k) {
    return to_double(s.c[k]) / to_double(p.c[k] + p.error) * (1 - 0x1p-49);
  }

  static bool is_at_an_end(const Piece& x) { return x.largest_at_0 || x.largest_at_1; }

  double upper() const {
    double most = 0;
    for (const Piece& x : pieces_) most = (std::max)(most, x.upper);
    return most;
  }

  bool halve() {
    const double n = pieces_[0].p.degree + 1, steps = 4 * n * n * static_cast<double>(pieces_.size());
    if (!work_meter().allows_search(steps_, steps)) return false;
    steps_ += steps;
    std::vector<Piece> pieces;
    pieces.swap(pieces_);
    ++level_;
    for (Piece& x : pieces) {
      Piece right{x.s.split(), x.p.split(), 2 * x.index + 1, 0, false, false};
      x.index *= 2;
      add(x);
      add(right);
    }
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), [&](const Piece& x) { return x.upper < lower_; }),
                  pieces_.end());
    // and not empty: one has the point to which lower_ belongs
    return pieces_.size() <= most_pieces;
  }

  // Adds a piece with its bounds.
  void add(Piece x) {
    const int n = x.p.degree;
    const bool at_0 = x.index == 0, at_1 = x.index + 1 == std::int64_t(1) << level_;
    double inside = 0, ends[2] = {0, 0};
    if (std::any_of(x.p.c, x.p.c + n + 1, [](Signed_128 y) { return y <= 0; }))
      inside = std::numeric_limits<double>::infinity();
    for (int k : {0, n})
      if (x.s.c[k] > 0 && x.p.c[k] > 0) lower_ = (std::max)(lower_, ratio_below(x.s, x.p, k));
    if (inside == 0) {
      for (int k = at_0; k <= n - at_1; ++k) inside = (std::max)(inside, ratio_above(x.s, x.p, k));
      if (at_0) ends[0] = ratio_above(x.s, x.p, 0);
      if (at_1) ends[1] = ratio_above(x.s, x.p, n);
    }
    x.upper = (std::max)({inside, ends[0], ends[1]});
    x.largest_at_0 = at_0 && (std::max)(inside, ends[1]) < ratio_below(x.s, x.p, 0);
    // equivalent [< -> <=, 1]: an end has the largest angle also where another point has the same
    x.largest_at_1 = at_1 && (std::max)(inside, ends[0]) < ratio_below(x.s, x.p, n);
    pieces_.push_back(x);
  }

  // Where no other points of the edge may have the largest angle.
  Normal_deviation<Field> at_ends() const {
    const Piece* best = nullptr;
    Exact largest(0);
    for (const Piece& x : pieces_) {
      const int k = x.largest_at_0 ? 0 : x.p.degree;
      const Exact measure = Exact(Exact(coefficient_in<Ring>(exact_s_, k)) / Exact(coefficient_in<Ring>(exact_p_, k)));
      if (best != nullptr && !(largest < measure)) continue;
      best = &x;
      largest = measure;
    }
    return result(Field(largest), Field(largest), *best);
  }

  // Bounds in units of 2^-m, between 2^61 and 2^63, if they determine the angle, see
  // Largest_measure::accurate().
  std::optional<Normal_deviation<Field>> rounded() const {
    const double most = upper();
    const int m = 61 - std::ilogb(most) - shift_;
    if (!(62 <= m && m <= 900)) return std::nullopt; // a right angle, or almost none
    Largest_quotient low(m + shift_), high(m + shift_);
    for (const Piece& x : pieces_) {
      const int n = x.p.degree;
      for (int k : {0, n})
        if (x.s.c[k] > 0) low.include(x.s.c[k], x.p.c[k] + x.p.error);
      for (int k = 0; k <= n; ++k) high.include(x.s.c[k] + x.s.error, x.p.c[k]);
    }
    ++high.value; // it was rounded downwards
    // otherwise the measure is less than a half
    const std::int64_t one = m == 62 ? std::int64_t(1) << 62 : 0;
    const double width = static_cast<double>(high.value - low.value) * 0x1p53;
    for (std::int64_t x : {low.value, high.value}) {
      const double cosine_squared = one == 0 ? 0.5 : static_cast<double>(one - x) * 0x1p-62;
      if (!(width <= 0.99 * static_cast<double>(x) * cosine_squared)) return std::nullopt;
    }
    return result(scaled(low.value, m), scaled(high.value, m), pieces_[0]);
  }

  // The largest of several quotients, in units of 2^-m and rounded downwards.
  struct Largest_quotient {
    int m;
    std::int64_t value = 0;
    // in units of 2^63; their quotient is not larger than the largest one
    std::uint64_t dividend = 0, divisor = 1;

    explicit Largest_quotient(int digits) : m(digits) {}

    // \pre the divisor is positive
    void include(Signed_128 x, Signed_128 y) {
      if (x <= 0) return;
      const std::uint64_t high_x = static_cast<std::uint64_t>(x >> 63), high_y = static_cast<std::uint64_t>(y >> 63);
      if (static_cast<Unsigned_128>(high_x + 1) * divisor <= static_cast<Unsigned_128>(dividend) * high_y) return;
      const std::int64_t quotient = quotient_in_units(x, y);
      if (quotient < value) return;
      value = quotient;
      dividend = high_x;
      divisor = high_y + 1;
    }

    // The quotient 2^m x/y rounded downwards, which must be less than 2^63: a long division bit by
    // bit. \pre 0 <= x and 0 < y
    std::int64_t quotient_in_units(Signed_128 x, Signed_128 y) const {
      if (m < 0) x = -m < 128 ? x >> -m : 0;
      Unsigned_128 rest = static_cast<Unsigned_128>(x % y);
      std::uint64_t quotient = static_cast<std::uint64_t>(x / y);
      for (int i = 0; i < m; ++i) {
        rest *= 2;
        const bool one = static_cast<Unsigned_128>(y) <= rest;
        if (one) rest -= static_cast<Unsigned_128>(y);
        quotient = 2 * quotient + one;
      }
      return static_cast<std::int64_t>(quotient);
    }
  };

  static Field scaled(std::int64_t x, int m) {
    const Ring half_word(0x1p31), high(static_cast<double>(x >> 31)), low(static_cast<double>(x & 0x7fffffff));
    return Field(Exact(Exact(Ring(high * half_word + low)) / Exact(Ring(std::ldexp(1.0, m)))));
  }

  // The place is a longer interval, so that it does not depend on roundings where several short
  // ones are equally good.
  Normal_deviation<Field> result(const Field& lower, const Field& upper, const Piece& place) const {
    const int level = (std::min)(level_, last_level_of_place);
    const std::int64_t index = place.index >> (level_ - level);
    const Field parts(1 << level);
    return {lower, upper, Field(Field(static_cast<int>(index)) / parts),
            Field(Field(static_cast<int>(index + 1)) / parts)};
  }
};

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_INTEGER_ANGLE_MAXIMUM_H
