// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CHECKED_NUMBERS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CHECKED_NUMBERS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <boost/config.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

/// \file checked_numbers.h
/// Checks that refuse bad numbers of callers: negative counts, infinities and empty intervals, and
/// their conversion and sign.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

[[noreturn]] BOOST_NOINLINE inline void refuse_count(int n, const char* place) {
  throw Error(Error_code::negative_count, std::string(place) + ": " + std::to_string(n));
}

// Refuses a negative number of derivatives, of elevations, of halvings, ... `place` names the
// function. The message is put together out of line, so that the check is one comparison.
CGAL_GC_FORCEINLINE void check_count(int n, const char* place) {
  if (n < 0) refuse_count(n, place);
}

[[noreturn]] BOOST_NOINLINE inline void refuse_infinite(const char* place) {
  throw Error(Error_code::not_finite, place);
}

// Checked before an infinity or a NaN can reach a rational number or a result.
template <class FT> void check_finite(const FT& x, const char* place) {
  if constexpr (std::is_floating_point_v<FT>)
    if (!std::isfinite(x)) refuse_infinite(place);
}

// The ends and the length of a domain must be finite, and the length positive.
template <class FT> void check_interval(const std::pair<FT, FT>& interval, const char* place) {
  check_finite(interval.first, place);
  check_finite(interval.second, place);
  if (!(interval.first < interval.second)) throw Error(Error_code::empty_domain, place);
  check_finite(FT(interval.second - interval.first), place);
}

// The sign of a number. By comparisons only, which is all that the concept asks of a field.
template <class FT> int sign_of(const FT& x) { return FT(0) < x ? 1 : x < FT(0) ? -1 : 0; }

template <class Field, class FT> Field to_field(const FT& x) {
  if constexpr (std::is_same_v<Field, FT>)
    return x;
  else {
    check_finite(x, "conversion to an exact number");
    return Field(x);
  }
}

// A number of the field FT that a caller gives as a number of any type: an infinity or a NaN is
// refused before it is converted.
template <class FT> struct Convertible_number {
  FT value;

  template <class T, class = std::enable_if_t<std::is_constructible_v<FT, T&&>>>
  Convertible_number(T&& x) : value(convert(std::forward<T>(x))) {}

private:
  static const FT& convert(const FT& x) { return x; }
  static FT&& convert(FT&& x) { return std::move(x); }
  template <class T, class = std::enable_if_t<!std::is_same_v<std::decay_t<T>, FT>>> static FT convert(T&& x) {
    return to_field<FT>(x);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CHECKED_NUMBERS_H
