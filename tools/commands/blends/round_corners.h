// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_ROUND_CORNERS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_ROUND_CORNERS_H

#include "commands/command_line.h"

// Runs `blend --corner` or `blend --corners`: rounds one corner of a chain, or all, by fair blends,
// prints a table and writes the files. Returns whether both joins of every blend are G2.
Exit_code round_corners(const Command_line& line);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_ROUND_CORNERS_H
