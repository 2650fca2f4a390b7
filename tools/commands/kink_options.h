// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_KINK_OPTIONS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_KINK_OPTIONS_H

#include "commands/command_line.h"
#include "commands/fonts/Glyph_join.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <stdexcept>

// Returns the value of --kink-angle, the largest angle of a kink.
inline GC::Corner_threshold corner_threshold(const Command_line& line) {
  const CGAL::Exact_rational degrees = line.number("kink-angle", CGAL::Exact_rational(5));
  if (!(0 < degrees && degrees < 180))
    throw std::invalid_argument("--kink-angle: " + line.text("kink-angle") + " is not between 0 and 180 degrees");
  return GC::Corner_threshold(degrees);
}

// Reads --off-by: by how many units of a font a handle may be off because of rounding.
inline Handle_rounding rounding_bound(const Command_line& line) {
  const CGAL::Exact_rational units = line.number("off-by", CGAL::Exact_rational(1));
  if (units < CGAL::Exact_rational(0)) throw std::invalid_argument("--off-by: " + line.text("off-by") + " is negative");
  return Handle_rounding(units);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_KINK_OPTIONS_H
