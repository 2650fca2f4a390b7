// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_PROGRAM_TEXTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_PROGRAM_TEXTS_H

#include "commands/commands.h"

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

// An installation of the program also has these texts, made of the descriptions that --help prints.

// The options whose values are words, by their names without "--".
std::map<std::string, Arguments> option_words();

// Writes the manual page geometric_continuity(1) in the language of troff. `usage` is that of the
// program.
void write_manual_page(std::ostream& os, const std::string& usage, const std::vector<const Command*>& commands);

// Writes a script for bash that completes commands, options, the values of options that are words,
// and names of files.
void write_bash_completion(std::ostream& os, const std::vector<const Command*>& commands);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_PROGRAM_TEXTS_H
