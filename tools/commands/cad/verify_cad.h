// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_VERIFY_CAD_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_VERIFY_CAD_H

#include "commands/cad/Cad_verdict.h"
#include "commands/commands.h"
#include "formats/cad/Cad_reading.h"

// Runs `verify` for CAD models, read as `reading` says: prints the verdicts on all edges, and
// returns the exit code.
int verify_cad(const Arguments& files, const Report_mode& mode, const Cad_demand& demand, const Cad_reading& reading);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_VERIFY_CAD_H
