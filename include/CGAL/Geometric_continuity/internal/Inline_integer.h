// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_INLINE_INTEGER_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_INLINE_INTEGER_H

#include <CGAL/Exact_rational.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <memory>
#include <type_traits>

#ifdef CGAL_USE_GMP
#include <CGAL/Gmpq.h>

#include <boost/multiprecision/gmp.hpp>
#endif
#ifdef CGAL_USE_GMPXX
#include <CGAL/gmpxx.h>
#endif

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An integer of any size that allocates no memory up to 1024 bits: an exact construction has many short-lived integers.
typedef boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>
    Inline_integer;

inline bool is_one(const Inline_integer& x) {
  return x.sign() > 0 && x.backend().size() == 1 && x.backend().limbs()[0] == 1;
}

// Makes x odd; returns the exponent of the power of two that was taken away. 0 stays.
inline long remove_twos(Inline_integer& x) {
  if (x.is_zero() || (x.backend().limbs()[0] & 1) != 0) return 0;
  const bool negative = x.sign() < 0;
  if (negative) x.backend().negate();
  const long twos = static_cast<long>(lsb(x));
  x >>= twos;
  if (negative) x.backend().negate();
  return twos;
}

// Whether d divides x; if so, q = x / d.
inline bool divides(const Inline_integer& d, const Inline_integer& x, Inline_integer& q) {
  if (is_one(d)) {
    q = x;
    return true;
  }
  Inline_integer r;
  divide_qr(x, d, q, r);
  return r.is_zero();
}

// How a rational number type is taken apart and put together: value is false for other number types.
//   split(x, n, d): x = n / d in lowest terms, d > 0
//   make(n, d, k): the reduced number n / (d 2^k), d > 0
template <class FT> struct Rational_parts : std::false_type {};

template <boost::multiprecision::expression_template_option expressions>
struct Rational_parts<boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, expressions>>
    : std::true_type {
  typedef boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, expressions> Rational;
  typedef typename boost::multiprecision::component_type<Rational>::type Integer;

  static void split(const Rational& x, Inline_integer& n, Inline_integer& d) {
    n = Inline_integer(Integer(numerator(x)));
    d = Inline_integer(Integer(denominator(x)));
  }
  static Rational make(const Inline_integer& n, const Inline_integer& d, long k) {
    if (n.is_zero()) return Rational(0);
    Integer num(n), den(d);
    if (k > 0) den <<= k;
    if (k < 0) num <<= -k;
    return Rational(num, den);
  }
};

#ifdef CGAL_USE_GMP
inline mpq_srcptr gmp_rational(const Gmpq& x) { return x.mpq(); }
inline mpq_ptr gmp_rational(Gmpq& x) { return x.mpq(); }
template <boost::multiprecision::expression_template_option expressions>
mpq_srcptr gmp_rational(const boost::multiprecision::number<boost::multiprecision::gmp_rational, expressions>& x) {
  return x.backend().data();
}
template <boost::multiprecision::expression_template_option expressions>
mpq_ptr gmp_rational(boost::multiprecision::number<boost::multiprecision::gmp_rational, expressions>& x) {
  return x.backend().data();
}
#ifdef CGAL_USE_GMPXX
inline mpq_srcptr gmp_rational(const mpq_class& x) { return x.get_mpq_t(); }
inline mpq_ptr gmp_rational(mpq_class& x) { return x.get_mpq_t(); }
#endif

// Limbs of both libraries have one size, except where the compiler has no 128-bit integer.
template <class Rational>
struct Gmp_rational_parts : std::bool_constant<sizeof(boost::multiprecision::limb_type) == sizeof(mp_limb_t)> {
  static void split(const Rational& x, Inline_integer& n, Inline_integer& d) {
    copy(mpq_numref(gmp_rational(x)), n);
    copy(mpq_denref(gmp_rational(x)), d);
  }
  static Rational make(const Inline_integer& n, const Inline_integer& d, long k) {
    Rational x;
    const mpq_ptr q = gmp_rational(x);
    copy(n, mpq_numref(q));
    if (!is_one(d)) {
      copy(d, mpq_denref(q));
      mpq_canonicalize(q);
    }
    if (k > 0) mpq_div_2exp(q, q, k);
    if (k < 0) mpq_mul_2exp(q, q, -k);
    return x;
  }

private:
  static void copy(mpz_srcptr z, Inline_integer& x) {
    const unsigned size = static_cast<unsigned>(mpz_size(z));
    if (size == 0)
      x = 0;
    else {
      x.backend().resize(size, size);
      std::copy_n(mpz_limbs_read(z), size, x.backend().limbs());
      x.backend().sign(mpz_sgn(z) < 0);
    }
  }
  static void copy(const Inline_integer& x, mpz_ptr z) {
    const mp_size_t size = x.backend().size();
    std::copy_n(x.backend().limbs(), size, mpz_limbs_write(z, size));
    mpz_limbs_finish(z, x.backend().sign() ? -size : size);
  }
};

template <> struct Rational_parts<Gmpq> : Gmp_rational_parts<Gmpq> {};
template <boost::multiprecision::expression_template_option expressions>
struct Rational_parts<boost::multiprecision::number<boost::multiprecision::gmp_rational, expressions>>
    : Gmp_rational_parts<boost::multiprecision::number<boost::multiprecision::gmp_rational, expressions>> {};
#ifdef CGAL_USE_GMPXX
template <> struct Rational_parts<mpq_class> : Gmp_rational_parts<mpq_class> {};
#endif
#endif // CGAL_USE_GMP

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_INLINE_INTEGER_H
