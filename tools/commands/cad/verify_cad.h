// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_VERIFY_CAD_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_VERIFY_CAD_H

#include "commands/cad/Cad_verdict.h"
#include "commands/commands.h"

#include <optional>

// Runs `verify` for CAD models, whose edges are sewn if a distance is given: prints the verdicts on all edges, and returns the exit code.
int verify_cad(const Arguments& files, const Report_mode& mode, const Cad_demand& demand, std::optional<double> sewing);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_VERIFY_CAD_H
