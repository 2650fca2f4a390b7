// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_FONT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_FONT_H

#include "commands/fonts/Glyph_join.h"
#include "commands/repair/repair_contour.h"
#include "formats/font/Glyph_outline.h"
#include "reports/Claims.h"

#include <cstddef>
#include <string>

// A contour of a glyph on the grid of the font. Where TrueType leaves out nodes between two
// handles, these may lie on halves of a unit, and move with the handles: with halves, which are
// five tenths, all curves are fixed.
Grid_contour grid_contour(const Glyph_outline& outline, std::size_t contour);

// The result of the repair of the fonts of a file.
struct Font_repair {
  // {"moves":[…],"not_repaired":[…],"before":{…},"after":{…}}, the moves of handles in units of
  // the font
  std::string moves;
  std::string text; // the summary for people
  // the joins before and after the moves, as members of JSON
  std::string before, after;
  Claims claims;
};

// Repairs all glyphs of a font, given the bytes of its file, but does not change it. Joins have the
// grades of verify, with the same bound of rounding, in each glyph in which they are drawn. Throws
// GC::Error `malformed_input` for what is no font with outlines.
Font_repair repair_font(const std::string& bytes, const std::string& name, const Repair_options& options,
                        const Handle_rounding& rounding);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_FONT_H
