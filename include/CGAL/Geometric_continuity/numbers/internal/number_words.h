// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_NUMBER_WORDS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_NUMBER_WORDS_H

#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>

#include <CGAL/config.h>

#ifdef CGAL_USE_GMP
#include <gmp.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// This stands for std::void_t, which makes all specialisations the same for some versions of clang.
template <class...> struct Void { typedef void type; };

// How many machine words a number has: the longer of numerator and denominator. Types are known by
// their members, as in Rational_parts; for one that is not known, it is 1.
template <class NT, class = void> struct Number_words {
  static std::size_t of(const NT&) { return 1; }
};

#ifdef CGAL_USE_GMP

inline std::size_t words_of(mpz_srcptr z) { return mpz_size(z); }
inline std::size_t words_of(mpq_srcptr q) { return (std::max)(mpz_size(mpq_numref(q)), mpz_size(mpq_denref(q))); }

// The number of words of a Gmpz and a Gmpq, an mpz_class and an mpq_class, a gmp_int and a
// gmp_rational of Boost.
template <class NT> auto gmp_words(const NT& x) -> decltype(internal::words_of(x.mpz())) { return words_of(x.mpz()); }
template <class NT> auto gmp_words(const NT& x) -> decltype(internal::words_of(x.mpq())) { return words_of(x.mpq()); }
template <class NT> auto gmp_words(const NT& x) -> decltype(internal::words_of(x.get_mpz_t())) {
  return words_of(x.get_mpz_t());
}
template <class NT> auto gmp_words(const NT& x) -> decltype(internal::words_of(x.get_mpq_t())) {
  return words_of(x.get_mpq_t());
}
template <class NT> auto gmp_words(const NT& x) -> decltype(internal::words_of(x.backend().data())) {
  return words_of(x.backend().data());
}

template <class NT>
struct Number_words<NT, typename Void<decltype(internal::gmp_words(std::declval<const NT&>()))>::type> {
  static std::size_t of(const NT& x) { return gmp_words(x); }
};

#endif // CGAL_USE_GMP

// A cpp_int and a cpp_rational of Boost.
template <class NT>
struct Number_words<NT, typename Void<decltype(std::declval<const NT&>().backend().limbs())>::type> {
  static std::size_t of(const NT& x) { return x.backend().size(); }
};
template <class NT>
struct Number_words<NT, typename Void<decltype(numerator(std::declval<const NT&>()).backend().limbs())>::type> {
  static std::size_t of(const NT& x) {
    return (std::max)(std::size_t(numerator(x).backend().size()), std::size_t(denominator(x).backend().size()));
  }
};

template <class Field> std::size_t number_words(const Field& x);

// A Sqrt_extension.
template <class NT>
struct Number_words<
    NT, typename Void<decltype(std::declval<const NT&>().a0()), decltype(std::declval<const NT&>().a1())>::type> {
  static std::size_t of(const NT& x) { return (std::max)(number_words(x.a0()), number_words(x.a1())); }
};

template <class Field> std::size_t number_words(const Field& x) {
  typedef typename Exact_number<Field>::type Exact;
  return Number_words<Exact>::of(Exact_number<Field>::of(x));
}

// The longest of several.
template <class Range> std::size_t most_words(const Range& numbers) {
  std::size_t words = 1;
  for (const auto& x : numbers) words = (std::max)(words, number_words(x));
  return words;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_NUMBER_WORDS_H
