// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_ANGLE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_ANGLE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

constexpr int max_svg_angle = 1000000000; // degrees

template <class FT> bool is_svg_angle(const FT& degrees) {
  return !(FT(max_svg_angle) < degrees) && !(degrees < FT(-max_svg_angle));
}

// An angle in degrees as quarter turns, from 0 to 3, and the exact rest, from -45 to 45 up to rounding.
template <class FT> struct Quarter_turns {
  int count;
  FT rest;

  explicit Quarter_turns(const FT& degrees) {
    if (!is_svg_angle(degrees)) throw Error(Error_code::parameter_outside_domain, "angle beyond 10^9 degrees");
    const int turns = static_cast<int>(std::lround(CGAL::to_double(degrees) / 90));
    rest = FT(degrees - FT(90) * FT(turns));
    count = (turns % 4 + 4) % 4;
  }
};

inline double svg_radians(double degrees) { return degrees * (std::acos(-1.0) / 180); }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_ANGLE_H
