// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_READ_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_READ_DRAWING_H

#include "files/input.h"
#include "formats/gcode/toolpath.h"
#include "formats/svg/svg_drawing.h"

#include <istream>
#include <string>

// Paths in the plane are read from drawings and from programs for machines.

inline bool is_drawing_file(const std::string& file) { return is_svg_file(file) || is_toolpath_file(file); }

// Reads a file that has been opened, as read_svg_drawing() or read_toolpath() does.
inline void read_drawing(const std::string& file, bool is_toolpath, std::istream& input, Drawing_handler& handler) {
  if (is_toolpath)
    read_toolpath(input, input_name(file), handler);
  else
    read_svg_drawing(input, input_name(file), handler);
}

// Returns the letter of a command, or its code, e.g. G2.
inline std::string letter_text(const GC::Svg_segment<Drawing_traits>& segment) {
  const bool is_code = '0' <= segment.letter && segment.letter <= '9';
  return std::string(is_code ? "G" : "") + segment.letter;
}

// Returns a command as reports write it: its number and letter, or its line and code.
inline std::string command_text(const GC::Svg_segment<Drawing_traits>& segment) {
  return std::to_string(segment.command) + ' ' + letter_text(segment);
}

// Returns what the numbers of commands count.
inline const char* command_words(const GC::Svg_segment<Drawing_traits>& segment) {
  return '0' <= segment.letter && segment.letter <= '9' ? "lines" : "commands";
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_READ_DRAWING_H
