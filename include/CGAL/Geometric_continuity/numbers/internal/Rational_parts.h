// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_RATIONAL_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_RATIONAL_PARTS_H

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <CGAL/config.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/numbers/internal/Inline_integer.h>
#endif

#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// How a rational number type is taken apart and put together: value is false for other number
// types.
//   split(x, n, d): x = n / d in lowest terms, d > 0
//   make(n, d, k): the reduced number n / (d 2^k), d > 0
//   make_short(n, d): the reduced number n / d, d > 0
//   short_parts(x, n, d): as split(), if both are below 2^60 in absolute value, otherwise false
// The types are known by their members, so that none of their headers is needed here. Without GMP
// there are none.
template <class FT, class = void> struct Rational_parts : std::false_type {};

#ifdef CGAL_USE_GMP

// Numbers that were not cancelled until now count in a Work_scope with all that was done before;
// short ones do not.
inline void charge_cancellation(std::size_t words, std::size_t other_words) {
  constexpr std::size_t few = 8;
  if (words + other_words > few)
    if (Work_meter* const work = Work_meter::scope()) work->charge_fractions(0.6, words, other_words);
}

// The number of GMP in a Gmpq, in an mpq_class, and in a gmp_rational of Boost.
template <class FT> auto gmp_rational(FT& x) -> decltype(mpq_ptr(x.mpq())) { return x.mpq(); }
template <class FT> auto gmp_rational(const FT& x) -> decltype(mpq_srcptr(x.mpq())) { return x.mpq(); }
template <class FT> auto gmp_rational(FT& x) -> decltype(mpq_ptr(x.get_mpq_t())) { return x.get_mpq_t(); }
template <class FT> auto gmp_rational(const FT& x) -> decltype(mpq_srcptr(x.get_mpq_t())) { return x.get_mpq_t(); }
template <class FT> auto gmp_rational(FT& x) -> decltype(mpq_ptr(x.backend().data())) { return x.backend().data(); }
template <class FT> auto gmp_rational(const FT& x) -> decltype(mpq_srcptr(x.backend().data())) {
  return x.backend().data();
}

template <class FT>
struct Rational_parts<FT, std::void_t<decltype(internal::gmp_rational(std::declval<const FT&>()))>> : std::true_type {
  static void split(const FT& x, Inline_integer& n, Inline_integer& d) {
    const mpq_srcptr q = internal::gmp_rational(x);
    copy(mpq_numref(q), n);
    copy(mpq_denref(q), d);
  }
  static FT make(const Inline_integer& n, const Inline_integer& d, long k) {
    FT x;
    const mpq_ptr q = internal::gmp_rational(x);
    charge_cancellation(n.size(), d.size());
    copy(n, mpq_numref(q));
    if (!d.is_one()) {
      copy(d, mpq_denref(q));
      mpq_canonicalize(q);
    }
    if (k > 0) mpq_div_2exp(q, q, k);
    if (k < 0) mpq_mul_2exp(q, q, -k);
    return x;
  }

  static FT make_short(std::int64_t n, std::int64_t d) {
    FT x;
    const mpq_ptr q = internal::gmp_rational(x);
    const std::int64_t common = d == 1 ? 1 : std::gcd(n % d, d); // most are shorter than n
    copy_short(n / common, mpq_numref(q));
    if (d != common) copy_short(d / common, mpq_denref(q));
    return x;
  }
  static bool short_parts(const FT& x, std::int64_t& n, std::int64_t& d) {
    const mpq_srcptr q = internal::gmp_rational(x);
    return short_integer(mpq_numref(q), n) && short_integer(mpq_denref(q), d);
  }

private:
  static void copy_short(std::int64_t x, mpz_ptr z) {
    static_assert(sizeof(mp_limb_t) == sizeof x);
    if (x != 0) *mpz_limbs_write(z, 1) = static_cast<mp_limb_t>(x < 0 ? -x : x);
    mpz_limbs_finish(z, x < 0 ? -1 : x > 0);
  }
  static bool short_integer(mpz_srcptr z, std::int64_t& x) {
    if (mpz_size(z) > 1) return false;
    const mp_limb_t size = mpz_getlimbn(z, 0);
    if (size >> 60 != 0) return false;
    x = mpz_sgn(z) < 0 ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
    return true;
  }
  static void copy(mpz_srcptr z, Inline_integer& x) { x.assign(mpz_limbs_read(z), mpz_size(z), mpz_sgn(z) < 0); }
  static void copy(const Inline_integer& x, mpz_ptr z) {
    const mp_size_t size = static_cast<mp_size_t>(x.size());
    if (size != 0) x.copy_limbs(mpz_limbs_write(z, size));
    mpz_limbs_finish(z, x.sign() < 0 ? -size : size);
  }
};

// A cpp_rational of Boost, whose integers have the limbs of GMP except where the compiler has no
// 128-bit integer.
template <class FT>
struct Rational_parts<
    FT, std::enable_if_t<sizeof(*numerator(std::declval<const FT&>()).backend().limbs()) == sizeof(mp_limb_t)>>
    : std::true_type {
  typedef std::decay_t<decltype(numerator(std::declval<const FT&>()))> Integer;

  static void split(const FT& x, Inline_integer& n, Inline_integer& d) {
    copy(numerator(x), n);
    copy(denominator(x), d);
  }
  static FT make(const Inline_integer& n, const Inline_integer& d, long k) {
    Integer num = integer(n), den = integer(d);
    if (num.is_zero()) return FT(0);
    charge_cancellation(n.size(), d.size());
    if (k > 0) den <<= k;
    if (k < 0) num <<= -k;
    return FT(num, den);
  }

  static FT make_short(std::int64_t n, std::int64_t d) { return FT(Integer(n), Integer(d)); }
  static bool short_parts(const FT& x, std::int64_t& n, std::int64_t& d) {
    return short_integer(numerator(x), n) && short_integer(denominator(x), d);
  }

private:
  static bool short_integer(const Integer& z, std::int64_t& x) {
    if (z.backend().size() > 1) return false;
    const mp_limb_t size = z.backend().limbs()[0];
    if (size >> 60 != 0) return false;
    x = z.sign() < 0 ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
    return true;
  }
  static void copy(const Integer& z, Inline_integer& x) {
    x.assign(z.backend().limbs(), z.backend().size(), z.sign() < 0);
  }
  static Integer integer(const Inline_integer& x) {
    Integer z(0);
    if (x.is_zero()) return z;
    const unsigned size = static_cast<unsigned>(x.size());
    z.backend().resize(size, size);
    x.copy_limbs(z.backend().limbs());
    z.backend().sign(x.sign() < 0);
    return z;
  }
};

#endif // CGAL_USE_GMP

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_RATIONAL_PARTS_H
