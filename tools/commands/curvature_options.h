// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CURVATURE_OPTIONS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CURVATURE_OPTIONS_H

#include "commands/chains/curvature_bound.h"
#include "commands/command_line.h"

#include <optional>
#include <stdexcept>
#include <string>

inline void describe_curvature_bound(po::options_description_easy_init add) {
  add("max-curvature", po::value<std::string>(),
      "K >= 0, the largest curvature that a curve may have, in one over the unit of the coordinates");
  add("min-radius", po::value<std::string>(),
      "R > 0, the least radius of curvature that a curve may have, in the unit of the coordinates: the same as "
      "--max-curvature 1/R");
}

// The bound that --max-curvature or --min-radius gives, if one is given.
inline std::optional<Curvature_bound> curvature_bound(const Command_line& line) {
  const std::string curvature = line.text("max-curvature"), radius = line.text("min-radius");
  if (line.has("max-curvature") && line.has("min-radius"))
    throw std::invalid_argument("--max-curvature and --min-radius: one of them");
  if (line.has("min-radius")) {
    const Exact r = line.number<Exact>("min-radius", Exact(0));
    if (!(Exact(0) < r)) throw std::invalid_argument("--min-radius: " + radius + " is not a positive length");
    return Curvature_bound{Exact(1) / r, "bent by at most the radius " + radius};
  }
  if (!line.has("max-curvature")) return std::nullopt;
  const Exact k = line.number<Exact>("max-curvature", Exact(0));
  if (k < Exact(0))
    throw std::invalid_argument("--max-curvature: " + curvature + " is negative; it bounds the absolute value");
  return Curvature_bound{k, "bent by at most the curvature " + curvature};
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CURVATURE_OPTIONS_H
