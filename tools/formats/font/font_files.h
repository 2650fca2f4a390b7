// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FILES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FILES_H

#include <cstdint>
#include <string>
#include <vector>

// Returns whether the name of a file ends as those of fonts do, or its first bytes are those of a
// font.
bool is_font_file(const std::string& file);

// Returns whether the arguments are fonts and folders. Throws std::invalid_argument when there are
// fonts and other files.
bool are_fonts(const std::vector<std::string>& arguments);

// A file that is to be read as a font.
struct Font_file {
  std::string name;
  bool from_folder;         // otherwise it is an argument
  std::uintmax_t bytes = 0; // 0 if not known
};

// A file that could not be read, and the reason.
struct Unread_file {
  std::string name, reason;
};

// Returns the files that the arguments name, and those with the endings of fonts in the folders
// that they name and in all folders of these, in alphabetical order and each once. What cannot be
// looked into is appended to `not_read`, with the reason. Throws GC::Error when an argument cannot
// be read, or is a folder without fonts.
std::vector<Font_file> font_files(const std::vector<std::string>& arguments, std::vector<Unread_file>& not_read);

// Returns the bytes of a file, or of standard input. Throws GC::Error with the reason when it
// cannot be read, or has more bytes than a font needs.
std::string read_bytes(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FILES_H
