// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHECK_SPLINE_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHECK_SPLINE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

/// \file check_spline.h
/// Decides if numbers are the knots of B-splines, and if coefficients are those of a spline over
/// them; the reason if not.

namespace CGAL {
namespace Geometric_continuity {

template <class FT> class Knot_vector;

namespace internal {

template <class FT> bool is_finite(const FT& x) {
  if constexpr (std::is_floating_point_v<FT>)
    return std::isfinite(x);
  else
    return true;
}

// \throws Error `wrong_number_of_points` for a negative degree
inline void check_degree(int p) {
  if (p < 0) throw Error(Error_code::wrong_number_of_points, "Knot_vector: degree " + std::to_string(p));
}

// Checks without a branch for each knot. Nothing is less than an undefined number, and what lies
// between ends at a finite distance is finite, as all distances are.
template <class FT> bool are_knots(int p, const std::vector<FT>& u) {
  if (u.size() < 2 * (static_cast<std::size_t>(p) + 1)) return false;
  const int n = static_cast<int>(u.size());
  std::ptrdiff_t good = 0;
  for (int i = 1; i < n; ++i) good += u[i] < u[i - 1] ? 0 : 1;
  for (int i = p + 1; i < n; ++i) good += u[i - p - 1] < u[i] ? 1 : 0;
  if (good != 2 * n - p - 2 || !(u[p] < u[n - p - 1])) return false;
  if constexpr (std::is_floating_point_v<FT>) return is_finite(FT(u.back() - u.front()));
  return true;
}

// The reason why they are not. \throws Error
template <class FT> void refuse_knots(int p, const std::vector<FT>& u) {
  const std::string place = "Knot_vector: ";
  const int n = static_cast<int>(u.size());
  if (u.size() < 2 * (static_cast<std::size_t>(p) + 1))
    throw Error(Error_code::wrong_number_of_points,
                place + std::to_string(n) + " knots are too few for degree " + std::to_string(p));
  for (const FT& x : u) check_finite(x, "Knot_vector");
  for (int i = 1; i < n; ++i)
    if (u[i] < u[i - 1])
      throw Error(Error_code::empty_domain, place + "knot " + std::to_string(i) + " is less than the one before it");
  if (!(u[p] < u[n - p - 1])) throw Error(Error_code::empty_domain, place + "the ends of the domain are equal");
  for (int i = p + 1; i < n; ++i)
    if (u[i - p - 1] == u[i])
      throw Error(Error_code::knot_multiplicity,
                  place + "knot " + std::to_string(i) + " is repeated more than " + std::to_string(p + 1) + " times");
  throw Error(Error_code::not_finite, place + "the distance of the first and the last knot overflows");
}

// \throws Error see the constructor of `Knot_vector`
template <class FT> void check_knots(int p, const std::vector<FT>& u) {
  check_degree(p);
  if (!are_knots(p, u)) refuse_knots(p, u);
}

// \throws Error `wrong_number_of_points` unless there are as many coefficients as the knots need
template <class FT, class Coefficients>
void check_number_of_coefficients(const Knot_vector<FT>& u, const Coefficients& c, const char* place) {
  if (static_cast<int>(c.size()) != u.number_of_coefficients())
    throw Error(Error_code::wrong_number_of_points, std::string(place) + ": " + std::to_string(c.size()) +
                                                        " coefficients where the knots need " +
                                                        std::to_string(u.number_of_coefficients()));
}

template <class FT> int number_of_coordinates(const FT&) { return 1; }
template <class FT, int N> int number_of_coordinates(const Coordinate_vector<FT, N>& c) { return c.dimension(); }

// Checks without a branch for each number. \throws Error `dimension_mismatch` when the coefficients
// differ in dimension, `not_finite`
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
