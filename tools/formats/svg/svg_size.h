// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SIZE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SIZE_H

#include <CGAL/Geometric_continuity/Error.h>

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

/// The longest numerator or denominator, in bits, of a number or a coordinate in the path data,
/// lengths and transforms of SVG. Every finite `double` is shorter.
constexpr int max_svg_number_bits = 1280;

/// The longest numerator or denominator, in bits, of the ratio of the radii of an arc of SVG.
constexpr int max_svg_ratio_bits = 640;

/// The longest numerator or denominator, in bits, of the number `Elliptical_arc::radicand()` of an
/// arc of SVG.
constexpr int max_svg_radicand_bits = 1536;

/// The longest numerator or denominator, in bits, in an exact product of transforms of SVG; see
/// `Svg_transform`.
constexpr int max_svg_transform_bits = 1024;

/// Refuses an infinity and what is no number, before it can reach a result.
/// \throws Error `not_finite` with the name of the place
template <class FT> void check_svg_finite(const FT& x, const char* place) {
  if constexpr (std::is_floating_point_v<FT>)
    if (!std::isfinite(x)) throw Error(Error_code::not_finite, place);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SIZE_H
