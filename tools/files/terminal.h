// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_TERMINAL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_TERMINAL_H

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

// Returns how many columns a table may have: as many as the environment variable COLUMNS says, or the terminal to which standard output
// leads; without limit elsewhere.
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

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_TERMINAL_H
