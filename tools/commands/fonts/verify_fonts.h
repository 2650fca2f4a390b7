// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_VERIFY_FONTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_VERIFY_FONTS_H

#include "commands/chains/curvature_bound.h"
#include "commands/commands.h"
#include "commands/fonts/Graded_joins.h"
#include "formats/font/Glyph_selection.h"

#include <cstddef>
#include <optional>
#include <string>

// The demands on the joins of fonts, and on their curves, in units of the font.
struct Font_demand {
  Glyph_selection glyphs;
  Join_rule rule;
  std::string off_by = "1", max_kink = {}; // of the rule, as they were given
  // how many joins to show of each font, in JSON of each glyph
  std::size_t worst = 0;
  // so that findings are no more than these; otherwise they are all
  bool is_worst_given = false;
  std::optional<Curvature_bound> bound = {};
};

// Grades the joins of all glyphs of fonts, which are files and those in folders, prints a report
// and returns the exit code. Only one font is in memory at a time.
int verify_fonts(const Arguments& files, const Report_mode& mode, const Font_demand& demand);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_VERIFY_FONTS_H
