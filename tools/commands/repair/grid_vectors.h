// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_VECTORS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_VECTORS_H

#include "commands/repair/grid_contour.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

// The integer as a number; it is at most 2^51.
inline Grid_fraction exact_number(std::int64_t x) { return Grid_fraction(static_cast<double>(x)); }

inline Grid_offset exact_vector(const GC::Grid_vector& v) { return Grid_offset(exact_number(v.x), exact_number(v.y)); }

// The vector between two points that lie beside the grid by these offsets.
inline Grid_offset difference(const GC::Grid_vector& p, const Grid_offset& p_offset, const GC::Grid_vector& q,
                              const Grid_offset& q_offset) {
  return exact_vector(q - p) + (q_offset - p_offset);
}

inline CGAL::Exact_rational cross_product(const Grid_offset& u, const Grid_offset& v) {
  return CGAL::Exact_rational(u.x() * v.y() - u.y() * v.x());
}

// The larger coordinate, without its sign.
inline std::int64_t largest_coordinate(const GC::Grid_vector& v) {
  return (std::max)((std::abs)(v.x), (std::abs)(v.y));
}

// Returns whether a vector may be a handle, so that products of the coordinates are exact.
inline bool is_short(const GC::Grid_vector& v) { return largest_coordinate(v) <= GC::max_handle_coordinate; }

// Returns numbers that distinguish handles that are no mirror images of each other, whichever way
// the contour is run through.
inline std::pair<std::int64_t, std::int64_t> rank(const GC::Grid_vector& v) {
  return {squared_length(v), largest_coordinate(v)};
}

// The multiple of a whole vector, at least itself, that is nearest to a handle.
inline GC::Grid_vector nearest(const Grid_offset& handle, const GC::Grid_vector& d) {
  const Grid_offset direction = exact_vector(d);
  const std::optional<std::int64_t> k = on_grid(CGAL::Exact_rational(handle * direction / direction.squared_length()));
  const std::int64_t most = max_grid_coordinate / largest_coordinate(d);
  return (std::min)((std::max)(k.value_or(most), std::int64_t(1)), (std::max)(most, std::int64_t(1))) * d;
}

// The decimal multiple of a direction that is nearest to a handle, in steps that are no longer
// than a unit; zero where it would be none.
inline Grid_offset along(const Grid_offset& handle, const Grid_offset& direction) {
  const double t = CGAL::to_double(CGAL::Exact_rational(handle * direction / direction.squared_length())),
               size = (std::max)(std::abs(CGAL::to_double(direction.x())), std::abs(CGAL::to_double(direction.y())));
  const int digits = (std::max)(0, static_cast<int>(std::ceil(std::log10(size))));
  const CGAL::Exact_rational scale = power_of_ten(digits);
  const double steps = std::round(t * CGAL::to_double(scale));
  if (!(1 <= steps && steps <= static_cast<double>(max_grid_coordinate))) return Grid_offset(0, 0);
  return CGAL::Exact_rational(CGAL::Exact_rational(steps) / scale) * direction;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_VECTORS_H
