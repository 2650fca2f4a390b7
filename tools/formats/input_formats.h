// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_INPUT_FORMATS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_INPUT_FORMATS_H

#include "commands/commands.h"

#include <string>

// Looks at the files of a command before it reads them: their names and their first bytes tell the
// formats. Throws std::invalid_argument for a file that the command does not read, with what it is,
// what the command reads, and the nearest way. Files that cannot be opened, and text that may be
// damaged, are left to the command.
void check_input_formats(const std::string& command, const Arguments& files);

// Returns whether a name is that of a source of a font which the Python module reads: a folder
// .ufo, .glyphs or .designspace.
bool is_font_source(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_INPUT_FORMATS_H
