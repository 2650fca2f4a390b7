// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ERROR_H
#define CGAL_GEOMETRIC_CONTINUITY_ERROR_H

#include <stdexcept>
#include <string>

/// \file Error.h
/// What the package refuses: bad input, by a typed exception, and compiler options with which it would decide wrongly.

// The stages of a decision that are made in floating-point arithmetic rest on the rounding of each operation, as IEEE
// 754 defines it, and on the recognition of infinite and undefined numbers. -fno-math-errno and -frounding-math leave
// both alone.
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
  zero_weight,              ///< the denominator of a rational curve or surface is not positive somewhere
  wrong_number_of_points,   ///< too few or too many control points
  dimension_mismatch,       ///< points, vectors or curves of different dimensions meet
  jet_order_too_low,        ///< a jet has fewer derivatives than the construction reads
  not_finite,               ///< a floating-point coordinate is infinite or not a number
  curves_do_not_meet,       ///< a curve does not start where the one before it ends
  incompatible_corner,      ///< what is given along a side of a blend contradicts a surface at a corner
  already_smooth,           ///< an edge that is to be rounded has the continuity already
  nonpositive_curvature,    ///< a curvature that must be positive is not
  unreachable_tolerance,    ///< a tolerance is not positive, or cannot be kept in floating-point arithmetic
  not_a_manifold,           ///< triangles do not meet two by two along their edges, in one orientation
  negative_count,           ///< a number of times, points, knots, cells or derivatives is negative
  work_limit,               ///< the answer would cost more work than is allowed, see `Work_limit`
  not_representable,        ///< no floating-point numbers with the demanded property exist
  malformed_input,          ///< the text of a file or of a number is not what it should be
  cannot_read_file,         ///< a file cannot be opened or read, for a reason of the system
  cannot_write_file         ///< a file, or a number in it, cannot be written
};

/// \ingroup PkgGeometricContinuityErrors
/// Returns the name of a reason, as spelled in the enumeration.
inline std::string to_string(Error_code code) {
  // A string for each case: with less code the constructor of Error is inlined, and g++ does not vectorise batches any more.
  switch (code) {
  case Error_code::zero_tangent: return "zero_tangent";
  case Error_code::nonpositive_beta: return "nonpositive_beta";
  case Error_code::singular_frame: return "singular_frame";
  case Error_code::zero_direction: return "zero_direction";
  case Error_code::knot_multiplicity: return "knot_multiplicity";
  case Error_code::too_many_knots: return "too_many_knots";
  case Error_code::parameter_outside_domain: return "parameter_outside_domain";
  case Error_code::empty_domain: return "empty_domain";
  case Error_code::zero_weight: return "zero_weight";
  case Error_code::wrong_number_of_points: return "wrong_number_of_points";
  case Error_code::dimension_mismatch: return "dimension_mismatch";
  case Error_code::jet_order_too_low: return "jet_order_too_low";
  case Error_code::not_finite: return "not_finite";
  case Error_code::curves_do_not_meet: return "curves_do_not_meet";
  case Error_code::incompatible_corner: return "incompatible_corner";
  case Error_code::already_smooth: return "already_smooth";
  case Error_code::nonpositive_curvature: return "nonpositive_curvature";
  case Error_code::unreachable_tolerance: return "unreachable_tolerance";
  case Error_code::not_a_manifold: return "not_a_manifold";
  case Error_code::negative_count: return "negative_count";
  case Error_code::work_limit: return "work_limit";
  case Error_code::not_representable: return "not_representable";
  case Error_code::malformed_input: return "malformed_input";
  case Error_code::cannot_read_file: return "cannot_read_file";
  case Error_code::cannot_write_file: return "cannot_write_file";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuityErrors
/// The exception with which all functions of the package refuse bad input. It is thrown before
/// anything has been changed, in release builds as well.
class Error : public std::runtime_error {
public:
  /// Constructs an exception; `place` says where the input is wrong, e.g. "blend: end of the first curve".
  Error(Error_code code, const std::string& place) : std::runtime_error(to_string(code) + ": " + place), code_(code) {}

  /// Returns the reason, for programs.
  Error_code code() const { return code_; }

private:
  Error_code code_;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ERROR_H
