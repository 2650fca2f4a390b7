// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_TERMINAL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_TERMINAL_H

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

// Returns how many columns a table may have: as many as the environment variable COLUMNS says, or
// the terminal to which standard output leads; without limit elsewhere. A call of the system: asked
// once for a report.
inline std::size_t output_columns() {
  if (const char* text = std::getenv("COLUMNS")) {
    const std::string_view digits(text);
    std::size_t columns = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), columns).ptr == digits.data() + digits.size() &&
        columns > 0)
      return columns;
  }
  winsize size{};
  if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return (std::numeric_limits<std::size_t>::max)();
}

// Returns lines that are broken at spaces where they are longer than so many columns, and go on
// indented. Characters of UTF-8 are counted.
inline std::string within_columns(const std::string& lines, std::size_t columns) {
  if (lines.size() <= columns) return lines;
  const std::string indent(4, ' ');
  std::istringstream is(lines);
  std::string result;
  for (std::string line; std::getline(is, line); result += line + '\n')
    for (;;) {
      const std::size_t words = line.find_first_not_of(' ');
      std::size_t end = 0, n = 0; // of the characters that there is room for
      for (; end < line.size() && n <= columns; ++end) n += (static_cast<unsigned char>(line[end]) & 0xC0) != 0x80;
      if (n <= columns) break;
      std::size_t space = line.rfind(' ', end - 1);
      // behind a word that is too long
      if (space == std::string::npos || space < words) space = line.find(' ', words);
      const std::size_t rest = line.find_first_not_of(' ', space);
      if (rest == std::string::npos) break;
      result += line.substr(0, line.find_last_not_of(' ', space) + 1) + '\n';
      line = indent + line.substr(rest);
    }
  return result;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_TERMINAL_H
