// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_READ_POINTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_READ_POINTS_H

#include "formats/g2_text/curves.h"

#include <algorithm>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

// Reads points from a text: in each line the coordinates of one, decimals or fractions p/q, with
// blanks, commas or semicolons between them. Empty lines are skipped, and what follows #. All have
// one dimension. Throws GC::Error with name, line and reason: `malformed_input`,
// `dimension_mismatch`.
template <class FT>
std::vector<typename Program_traits<FT>::Point> read_points(std::istream& is, const std::string& name) {
  std::vector<typename Program_traits<FT>::Point> points;
  std::vector<FT> x;
  long long number = 0;
  for (std::string line; std::getline(is, line);) {
    ++number;
    const std::string place = name + ":" + std::to_string(number) + ": ";
    x.clear();
    const std::size_t end = (std::min)(line.find('#'), line.size());
    for (std::size_t begin = 0; begin < end;) {
      begin = line.find_first_not_of(" \t\r,;", begin);
      if (begin >= end) break;
      const std::size_t behind = (std::min)(line.find_first_of(" \t\r,;", begin), end);
      try {
        x.push_back(GC::parse_number<FT>(std::string_view(line).substr(begin, behind - begin)));
      } catch (const GC::Error& e) {
        const std::string code = to_string(e.code()) + ": ", text = e.what();
        throw GC::Error(e.code(), place + text.substr(code.size()));
      }
      begin = behind;
    }
    if (x.empty()) continue;
    if (!points.empty() && static_cast<int>(x.size()) != points[0].dimension())
      throw GC::Error(GC::Error_code::dimension_mismatch, place + std::to_string(x.size()) + " coordinates, and " +
                                                              std::to_string(points[0].dimension()) + " before");
    if (x.size() == 1)
      throw GC::Error(GC::Error_code::dimension_mismatch,
                      place + "1 coordinate; a point of a curve needs 2 or more, with a blank or a comma between them");
    points.emplace_back(static_cast<int>(x.size()), x.begin(), x.end());
  }
  return points;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_READ_POINTS_H
