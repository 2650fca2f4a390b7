// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_ROUND_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_ROUND_DRAWING_H

#include "commands/command_line.h"
#include "commands/commands.h"

// Rounds the corners of a drawing in place, by cubics with continuous curvature: `blend DRAWING.svg
// --corners all --distance D -o OUT.svg`. Only path data changes, and polygons, polylines and
// rectangles with corners become paths; all else stays byte for byte.
//
// Between two lines the cut points are short decimals, and one cubic with both handles in the
// corner is exactly G2 with both. Where curves meet, they are cut, and one or two cubics are
// exactly G1 with what is left of them, and G2 up to the decimals that are written.
Exit_code round_drawing(const Command_line& line);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_ROUND_DRAWING_H
