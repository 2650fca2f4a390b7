// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_DENOMINATOR_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_DENOMINATOR_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT, class = void> struct Has_integer_parts : std::false_type {};
template <class FT>
struct Has_integer_parts<FT, std::enable_if_t<Fraction_traits<FT>::Is_fraction::value>>
    : std::is_convertible<
          typename Algebraic_structure_traits<typename Fraction_traits<FT>::Numerator_type>::Algebraic_category,
          Euclidean_ring_tag> {};

template <class FT, bool fraction> struct Numerators { typedef FT type; };
template <class FT> struct Numerators<FT, true> { typedef typename Fraction_traits<FT>::Numerator_type type; };

// The ring in which signs of homogeneous expressions in numbers of a field are decided, after all
// these numbers have been multiplied by their common denominator: integers for rational numbers,
// which need not be cancelled after each operation; otherwise the field itself.
template <class Field> class Common_denominator {
public:
  typedef typename Exact_number<Field>::type Exact;
  static constexpr bool clears = Has_integer_parts<Exact>::value;
  typedef typename Numerators<Exact, clears>::type Ring;

  explicit Common_denominator(Ring multiple_of = Ring(1)) : d_(std::move(multiple_of)) {}

  static Ring denominator_of(const Field& x) { return parts(x).second; }

  // Makes the denominator a multiple of that of x.
  void include(const Field& x) {
    if constexpr (clears) {
      const std::pair<Ring, Ring> f = parts(x);
      const Ring common = CGAL::gcd(d_, f.second);
      d_ *= Ring(CGAL::integral_division(f.second, common));
    }
  }

  // x times the denominator. \pre x has been included
  Ring numerator(const Field& x) const {
    if constexpr (clears) {
      const std::pair<Ring, Ring> f = parts(x);
      return Ring(f.first * Ring(CGAL::integral_division(d_, f.second)));
    } else
      return Exact_number<Field>::of(x);
  }

  // x divided by the k-th power of the denominator
  Field divided(const Exact& x, int k) const {
    if constexpr (clears) {
      Ring power(1);
      for (int i = 0; i < k; ++i) power *= d_;
      return Field(Exact(x / Exact(power)));
    } else
      return Field(x);
  }

  const Ring& value() const { return d_; }
  std::size_t words() const { return number_words(d_); }

private:
  Ring d_;

  static std::pair<Ring, Ring> parts(const Field& x) {
    std::pair<Ring, Ring> f;
    typename Fraction_traits<Exact>::Decompose()(Exact_number<Field>::of(x), f.first, f.second);
    return f;
  }
};

// The numbers of an exact field in a common unit, in which they have numerators.
template <class Field> class Field_scale : Common_denominator<Field> {
public:
  static constexpr bool exact = true;
  typedef Field Number;
  typedef typename Common_denominator<Field>::Ring Ring;
  using Common_denominator<Field>::include;
  using Common_denominator<Field>::numerator;

  template <class FT> static Number number(const FT& x) { return to_field<Field>(x); }

  // Remainder_scale has this member as well.
  int bits() const { return 0; }
  static int moduli(int) { return 1; }
  void take_modulus(int) {}
  static Ring one() { return Ring(1); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_DENOMINATOR_H
