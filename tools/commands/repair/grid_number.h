// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_NUMBER_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_NUMBER_H

#include "commands/repair/grid_contour.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

// A decimal of a file: digits * 10^-decimals, with the digits behind the point as they are written.
struct Grid_number {
  static constexpr int max_decimals = 15;

  std::int64_t digits;
  int decimals; // may be negative

  // Reads a decimal; nothing for fractions and for numbers of more digits than a contour can hold.
  static std::optional<Grid_number> read(std::string_view text) {
    Grid_number x{0, 0};
    std::size_t i = 0;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    bool behind_point = false;
    for (; i < text.size() && (text[i] == '.' || ('0' <= text[i] && text[i] <= '9')); ++i)
      if (text[i] == '.')
        behind_point = true;
      else {
        x.digits = 10 * x.digits + (text[i] - '0');
        x.decimals += behind_point;
        if (max_grid_coordinate < x.digits) return std::nullopt;
      }
    if (i < text.size()) {
      if (text[i] != 'e' && text[i] != 'E') return std::nullopt;
      const std::string exponent(text.substr(i + 1));
      if (exponent.size() > 4) return std::nullopt;
      x.decimals -= std::atoi(exponent.c_str());
    }
    if (negative) x.digits = -x.digits;
    return x;
  }

  // The number in units of a grid with at least as many decimals; nothing when it is too large.
  std::optional<std::int64_t> on_grid(int grid_decimals) const {
    std::int64_t x = digits;
    for (int i = decimals; i < grid_decimals && x != 0; ++i) {
      x *= 10;
      if ((std::abs)(x) > max_grid_coordinate) return std::nullopt;
    }
    return x;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_NUMBER_H
