// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_VERIFY_ROADS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_VERIFY_ROADS_H

#include "commands/chains/curvature_bound.h"
#include "commands/commands.h"

#include <CGAL/Geometric_continuity/joins/alignment_join.h>

#include <optional>
#include <string>

// The demands on road networks.
struct Road_demand {
  CGAL::Geometric_continuity::Alignment_tolerance tolerance = {};
  std::string gap = "0.001", kink = "0.001", curvature = "0.000001"; // as they are written
  int order = 1;                                                     // of the reference lines
  bool borders = false;                                              // of lanes are to have this order, too
  std::optional<Curvature_bound> bound = {};                         // of the curvature of reference lines
};

// Runs `verify` for road networks: prints all that is decided about them, and returns the exit
// code.
int verify_roads(const Arguments& files, const Report_mode& mode, const Road_demand& demand);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_VERIFY_ROADS_H
