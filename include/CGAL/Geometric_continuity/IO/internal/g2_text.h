// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <initializer_list>
#include <ostream>
#include <string>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Writes an object of a class in the `.g2` format, with an empty line after it: one knot vector for each parameter, and
// `points` control points, of which the j-th has the coordinates coordinates(j). The text is complete before any of it
// is written.
template <class FT, class Coordinates_of>
void write_g2_text(std::ostream& os, int object_class, int dimension,
                   std::initializer_list<const Knot_vector<FT>*> directions, long long points,
                   Coordinates_of coordinates) {
  std::string text = std::to_string(object_class) + " 1 0 0\n" + std::to_string(dimension) + " 0\n";
  const auto add_line = [&text](const auto& numbers) {
    const char* separator = "";
    for (const FT& x : numbers) {
      text += separator;
      text += number_text(x);
      separator = " ";
    }
    text += '\n';
  };
  for (const Knot_vector<FT>* knots : directions) {
    text += std::to_string(knots->number_of_coefficients()) + ' ' + std::to_string(knots->degree() + 1) + '\n';
    add_line(*knots);
  }
  for (long long j = 0; j < points; ++j) add_line(coordinates(j));
  text += '\n';
  write_text(os, text);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
