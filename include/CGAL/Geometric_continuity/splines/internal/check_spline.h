// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHECK_SPLINE_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHECK_SPLINE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_multiply.h>

#include <string>
#include <type_traits>
#include <vector>

/// \file check_spline.h
/// What the functions on splines check of their arguments.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// \throws Error `wrong_number_of_points` unless there are as many coefficients as the knots need
template <class FT, class Coefficients>
void check_number_of_coefficients(const Knot_vector<FT>& u, const Coefficients& c, const char* place) {
  if (static_cast<int>(c.size()) != u.number_of_coefficients())
    throw Error(Error_code::wrong_number_of_points, std::string(place) + ": " + std::to_string(c.size()) +
                                                        " coefficients where the knots need " +
                                                        std::to_string(u.number_of_coefficients()));
}

// Without a branch for each number.
// \throws Error `dimension_mismatch` when the coefficients differ in dimension, `not_finite`
template <class FT, class Value> void check_coefficients(const std::vector<Value>& c, const char* place) {
  const int d = number_of_coordinates(c[0]);
  bool same = true, finite = true;
  for (const Value& x : c) same &= number_of_coordinates(x) == d;
  if (!same) throw Error(Error_code::dimension_mismatch, place);
  if constexpr (std::is_floating_point_v<FT>)
    for (const Value& x : c) {
      if constexpr (std::is_same_v<FT, Value>)
        finite &= is_finite(x);
      else
        for (const FT& xi : x) finite &= is_finite(xi);
    }
  if (!finite) throw Error(Error_code::not_finite, place);
}

// \throws Error `parameter_outside_domain` unless k is the number of a span
template <class FT> void check_span(const Knot_vector<FT>& u, int k, const char* place) {
  if (k < u.degree() || u.number_of_coefficients() <= k || !(u[k] < u[k + 1]))
    throw Error(Error_code::parameter_outside_domain, std::string(place) + ": " + std::to_string(k) + " is not a span");
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHECK_SPLINE_H
