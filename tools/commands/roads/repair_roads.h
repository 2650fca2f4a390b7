// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_REPAIR_ROADS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_REPAIR_ROADS_H

#include "commands/commands.h"
#include "commands/roads/verify_roads.h"

#include <string>

// The demands of `repair` on road networks.
struct Road_repair {
  Road_demand demand = {};
  double max_move = 0.05; // metres; joins that are farther apart stay
  double max_kink = 0.1;  // radians; joins with a larger kink stay
};

// Repairs the reference lines of a road network, and tells on the stream what was done: each piece
// that starts off the end before is moved there if the rest of its road may move, and otherwise it
// becomes three clothoids. Returns the text with the changes; the exit code is 1 when joins of
// reference lines are left that are not as demanded.
std::string repaired_roads(const std::string& text, const std::string& name, const Road_repair& repair,
                           const Report_mode& mode, std::ostream& os, int& exit_code);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_REPAIR_ROADS_H
