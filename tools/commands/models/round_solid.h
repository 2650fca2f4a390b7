// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_ROUND_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_ROUND_SOLID_H

#include "commands/command_line.h"
#include "formats/solids/Outlined_solid.h"
#include "formats/solids/Solid.h"

#include <cstddef>
#include <functional>
#include <string>

// The part of `round-edges` for solids. Edges are called by `edge_text(number)` in reports, e.g.
// "7" or "0 u0"; spaces and the colon do not matter where the user names one.
int round_solid(const Command_line& line, const Solid& solid, const std::function<std::string(std::size_t)>& edge_text);

// The part for solids with walls, edges of which have their numbers in the file.
int round_outlined_solid(const Command_line& line, const Outlined_solid& solid);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_ROUND_SOLID_H
