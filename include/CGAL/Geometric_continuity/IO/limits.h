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

/// \ingroup PkgGeometricContinuityIO
/// The longest numerator or denominator, in bits, of a number or a coordinate in the path data, lengths and transforms
/// of SVG. Every finite `double` is shorter.
constexpr int max_svg_number_bits = 1280;

/// \ingroup PkgGeometricContinuityIO
/// The longest numerator or denominator, in bits, of the ratio of the radii of an arc of SVG.
constexpr int max_svg_ratio_bits = 640;

/// \ingroup PkgGeometricContinuityIO
/// The longest numerator or denominator, in bits, of the number `Svg_arc::radicand()` of an arc of SVG.
constexpr int max_svg_radicand_bits = 1536;

/// \ingroup PkgGeometricContinuityIO
/// The longest numerator or denominator, in bits, in an exact product of transforms of SVG; see `Svg_transform`.
constexpr int max_svg_transform_bits = 1024;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_LIMITS_H
