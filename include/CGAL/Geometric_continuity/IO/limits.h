// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_LIMITS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_LIMITS_H

/// \file IO/limits.h
/// What the readers refuse, so that a few characters of a text cannot fill the memory.

#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// The longest text, in characters, that is read as a number.
constexpr std::size_t max_number_length = 4096;

/// \ingroup PkgGeometricContinuityIO
/// The largest absolute value of the exponent of a decimal.
constexpr int max_decimal_exponent = 4096;

/// \ingroup PkgGeometricContinuityIO
/// The highest order (degree + 1) of a curve or surface that is read from a `.g2` file.
constexpr int max_g2_order = 128;

/// \ingroup PkgGeometricContinuityIO
/// The highest dimension of a curve or surface that is read from a `.g2` file.
constexpr int max_g2_dimension = 16;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_LIMITS_H
