// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <initializer_list>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Writes an object of a class in the `.g2` format, with an empty line after it: one knot vector for each parameter, and
// `points` control points, of which the j-th has the coordinates coordinates(j). The text is complete before any of it is
// written.
template <class FT, class Coordinates_of>
void write_g2_text(std::ostream& os, int object_class, int dimension,
                   std::initializer_list<const Knot_vector<FT>*> directions, int points, Coordinates_of coordinates) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const auto write_line = [&text](const auto& numbers) {
    const char* separator = "";
    for (const FT& x : numbers) {
      text << separator;
      write_number(text, x);
      separator = " ";
    }
    text << '\n';
  };
  text << object_class << " 1 0 0\n" << dimension << " 0\n";
  for (const Knot_vector<FT>* knots : directions) {
    text << knots->number_of_coefficients() << ' ' << knots->degree() + 1 << '\n';
    write_line(*knots);
  }
  for (int j = 0; j < points; ++j) write_line(coordinates(j));
  text << '\n';
  const std::string characters = text.str();
  os.write(characters.data(), static_cast<std::streamsize>(characters.size()));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
