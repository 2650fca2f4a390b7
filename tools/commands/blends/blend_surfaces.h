// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_SURFACES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_SURFACES_H

#include "commands/command_line.h"

// Runs `blend --surfaces`: leads from an edge of one surface to an edge of another one, decides the
// continuity along both edges, prints it and writes the blend. Returns whether it has the order
// along both.
Exit_code blend_surfaces(const Command_line& line);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_SURFACES_H
