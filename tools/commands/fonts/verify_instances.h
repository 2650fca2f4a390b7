// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_VERIFY_INSTANCES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_VERIFY_INSTANCES_H

#include "commands/commands.h"
#include "commands/fonts/Instance_kinks.h"
#include "formats/font/Glyph_selection.h"

#include <cstddef>
#include <string>

// The demands on all instances of variable fonts.
struct Instance_demand {
  Glyph_selection glyphs;
  Instance_bounds bounds;
  std::string max_kink; // the bound in degrees, as it is written
  bool required;        // every join must be proved to stay within it
  std::size_t worst;    // how many joins to show of each font, in JSON of each glyph
};

// Encloses the largest kink of each join over all instances of variable fonts, which are files and
// those in folders, prints a report and returns the exit code. Fonts of other kinds are named as
// not covered.
int verify_instances(const Arguments& files, const Report_mode& mode, const Instance_demand& demand);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_VERIFY_INSTANCES_H
