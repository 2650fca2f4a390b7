// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ERROR_H
#define CGAL_GEOMETRIC_CONTINUITY_ERROR_H

#include <boost/config.hpp>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>

/// \file Error.h
/// The package refuses bad input, by a typed exception, and compiler options with which it would
/// decide wrongly.

// The stages of a decision that are made in floating-point arithmetic rest on the rounding of each
// operation, as IEEE 754 defines it, and on the recognition of infinite and undefined numbers.
// -fno-math-errno and -frounding-math leave both alone.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Geometric_continuity: with -ffast-math or -Ofast exact predicates would be wrong; -fno-math-errno is allowed."
#endif

#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "Geometric_continuity: C++17 is the least that it is written in (-std=c++17)."
#endif

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityErrors
/// The reasons for which input is refused.
enum class Error_code {
  zero_tangent,             ///< the first derivative at an end is zero
  nonpositive_beta,         ///< a shape parameter \f$ \beta_1 \f$ (or \f$ \eta \f$) is not positive
  singular_frame,           ///< the vectors that must span a frame are linearly dependent
  zero_direction,           ///< a direction, an axis or a normal is the zero vector
  knot_multiplicity,        ///< a knot is repeated too often
  too_many_knots,           ///< the result would have more knots than are allowed
  parameter_outside_domain, ///< a parameter lies outside the domain
  empty_domain,             ///< a parameter interval has no positive length
  /// the denominator of a rational curve or surface is not positive somewhere
  zero_weight,
  wrong_number_of_points, ///< too few or too many control points
  dimension_mismatch,     ///< points, vectors or curves of different dimensions meet
  jet_order_too_low,      ///< a jet has fewer derivatives than the construction reads
  not_finite,             ///< a floating-point coordinate is infinite or not a number
  curves_do_not_meet,     ///< a curve does not start where the one before it ends
  several_common_edges,   ///< two surfaces have more than one edge in common
  /// what is given along a side of a blend contradicts a surface at a corner
  incompatible_corner,
  already_smooth,        ///< an edge that is to be rounded has the continuity already
  nonpositive_curvature, ///< a curvature that must be positive is not
  /// a tolerance is not positive, or cannot be kept in floating-point arithmetic
  unreachable_tolerance,
  /// triangles do not meet two by two along their edges, in one orientation
  not_a_manifold,
  negative_count,    ///< a number of times, points, knots, cells or derivatives is negative
  work_limit,        ///< the answer would cost more work than is allowed, see `Work_limit`
  not_representable, ///< no floating-point numbers with the demanded property exist
  malformed_input,   ///< the text of a file or of a number is not what it should be
  cannot_read_file,  ///< a file cannot be opened or read, for a reason of the system
  cannot_write_file  ///< a file, or a number in it, cannot be written
};

/// \ingroup PkgGeometricContinuityErrors
/// Returns the name of a reason, as spelled in the enumeration.
inline std::string to_string(Error_code code) {
  // in the order of the enumeration
  static constexpr const char* names[] = {"zero_tangent",
                                          "nonpositive_beta",
                                          "singular_frame",
                                          "zero_direction",
                                          "knot_multiplicity",
                                          "too_many_knots",
                                          "parameter_outside_domain",
                                          "empty_domain",
                                          "zero_weight",
                                          "wrong_number_of_points",
                                          "dimension_mismatch",
                                          "jet_order_too_low",
                                          "not_finite",
                                          "curves_do_not_meet",
                                          "several_common_edges",
                                          "incompatible_corner",
                                          "already_smooth",
                                          "nonpositive_curvature",
                                          "unreachable_tolerance",
                                          "not_a_manifold",
                                          "negative_count",
                                          "work_limit",
                                          "not_representable",
                                          "malformed_input",
                                          "cannot_read_file",
                                          "cannot_write_file"};
  static_assert(std::size(names) == static_cast<std::size_t>(Error_code::cannot_write_file) + 1);
  const std::size_t i = static_cast<std::size_t>(code);
  // unreachable: every value has a name
  return i < std::size(names) ? names[i] : "unknown";
}

/// \ingroup PkgGeometricContinuityErrors
/// The exception with which all functions of the package refuse bad input. It is thrown before
/// anything has been changed, in release builds as well.
class Error : public std::runtime_error {
public:
  /// Constructs an exception; `place` says where the input is wrong, e.g. "blend: end of the first
  /// curve". Compiled apart, so that functions that refuse something stay short.
  BOOST_NOINLINE Error(Error_code code, const std::string& place)
      : std::runtime_error(to_string(code).append(": ").append(place)), code_(code) {}

  /// Returns the reason, for programs.
  Error_code code() const { return code_; }

private:
  Error_code code_;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ERROR_H
