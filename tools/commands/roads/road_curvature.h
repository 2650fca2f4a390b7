// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_CURVATURE_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_CURVATURE_H

#include "commands/chains/curvature_bound.h"
#include "commands/roads/Road_claims.h"

#include <optional>
#include <string>

// The decision about a piece: whether it meets a bound on the curvature, and its largest curvature
// where that is known, with the place.
struct Bend {
  Claim claim = Claim::met;
  std::optional<GC::Enclosure> curvature = {};
  std::string at = {};

  // The words behind those for the shape of the piece; with the unit of curvatures.
  std::string words(const Curvature_bound& bound, const char* unit) const;
};
Bend bend(const GC::Road_geometry& piece, const Curvature_bound& bound);

// Decides whether a piece of the reference line of a road exceeds a bound on the curvature. Lines,
// arcs and spirals have it in closed form, and polynomials are decided exactly; only where a poly3
// ends is enclosed, since its arc length is given.
Road_claim decide_curvature(const GC::Road& road, const GC::Road_geometry& piece, const Curvature_bound& bound);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_CURVATURE_H
