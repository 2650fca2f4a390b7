// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_WRITE_FONT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_WRITE_FONT_H

#include <string>
#include <vector>

// A font that fontTools has written.
struct Written_font {
  std::string bytes, messages;
};

// Returns a font, given by its bytes, with the moves of repair_font(): fontTools writes it, in
// Python, in the format of names with this ending. `file` stands for the font in messages. Throws
// std::runtime_error where there is no fontTools, with the commands that do the same, and
// GC::Error `malformed_input` where it refuses the font.
Written_font font_with_moves(const std::string& bytes, const std::string& moves, const std::string& ending,
                             const std::string& file);

// Returns a variable font with masters that are mended together, as font_with_moves() does. The
// options are the angle of kinks in degrees and, where it is bounded, the longest move.
Written_font font_with_mended_masters(const std::string& bytes, const std::vector<std::string>& options,
                                      const std::string& ending, const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_WRITE_FONT_H
