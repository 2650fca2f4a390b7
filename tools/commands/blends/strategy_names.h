// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_STRATEGY_NAMES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_STRATEGY_NAMES_H

#include "commands/commands.h"

// The strategies of order 2 and 3 but for free, as --strategy names them.
const Arguments quintic_names = {"c2", "normal", "min_second", "near_line", "energy2", "energy3", "fair"};
const Arguments septic_names = {"c3", "seq_g3", "seq_f3", "joint_g3", "energy3_g3", "energy4_g3", "fair_g3", "fair_f3"};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_STRATEGY_NAMES_H
