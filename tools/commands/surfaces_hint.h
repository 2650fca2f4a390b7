// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_SURFACES_HINT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_SURFACES_HINT_H

#include "commands/commands.h"
#include "files/input.h"

#include <algorithm>
#include <stdexcept>
#include <string>

// Returns whether a file of the format .g2 begins with a surface: with the number of their
// class, 200.
inline bool holds_surfaces(const std::string& file) {
  const std::string text = beginning_of_text(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text.compare(first, 3, "200") == 0;
}

// Returns work(), which reads the curves of the files. Where these hold surfaces, its error names
// the option for them.
template <class Work> int with_hint_of_surfaces(const Arguments& files, Work work) {
  const bool surfaces = std::any_of(files.begin(), files.end(), holds_surfaces);
  try {
    return work();
  } catch (const GC::Error& e) {
    if (!surfaces || e.code() != GC::Error_code::malformed_input) throw;
    throw std::invalid_argument(std::string(e.what()) + "; surfaces are read with --surfaces");
  }
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_SURFACES_HINT_H
