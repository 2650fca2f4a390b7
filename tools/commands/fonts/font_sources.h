// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_SOURCES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_SOURCES_H

#include "commands/command_line.h"

// Verifies sources of fonts, or repairs one, by the Python module; returns the exit code. Throws
// std::invalid_argument for options that do not fit, and std::runtime_error where the module is not
// installed.
int verify_font_sources(const Command_line& line);
int repair_font_source(const Command_line& line);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_SOURCES_H
