// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H

#include <CGAL/Geometric_continuity/IO/internal/G2_weighted_points.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <initializer_list>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Writes an object of a class in the `.g2` format, with an empty line after it: one knot vector for each parameter, and
// `points` control points, of which row(j) has the words. The text is complete before any of it is written.
template <class FT, class Row_of>
void write_g2_text(std::ostream& os, int object_class, int dimension, bool rational,
                   std::initializer_list<const Knot_vector<FT>*> directions, long long points, Row_of row) {
  std::string text =
      std::to_string(object_class) + " 1 0 0\n" + std::to_string(dimension) + (rational ? " 1\n" : " 0\n");
  const auto add_line = [&text](const auto& words) {
    const char* separator = "";
    for (const auto& word : words) {
      text += separator;
      if constexpr (std::is_same_v<std::decay_t<decltype(word)>, std::string>)
        text += word;
      else
        text += number_text(word);
      separator = " ";
    }
    text += '\n';
  };
  for (const Knot_vector<FT>* knots : directions) {
    text += std::to_string(knots->number_of_coefficients()) + ' ' + std::to_string(knots->degree() + 1) + '\n';
    add_line(*knots);
  }
  for (long long j = 0; j < points; ++j) add_line(row(j));
  text += '\n';
  write_text(os, text);
}

// The words of a control point with its weight.
template <class FT, int N> std::vector<std::string> weighted_row(const Coordinate_vector<FT, N>& x, const FT& w) {
  std::vector<std::string> words;
  for (const FT& xi : x) words.push_back(w == FT(0) ? number_text(xi) : product_text(xi, w));
  words.push_back(number_text(w));
  return words;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
