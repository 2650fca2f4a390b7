// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_BSPLINE_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_BSPLINE_SURFACES_H

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

#include <locale>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline surface in SINTEF's `.g2` format, class 200, without loss, see `write_number()`, with an empty line
/// after it: the dimension; for `u` and then for `v` the number of control points, the order (degree + 1) and all knots; and
/// the control points, of which the index that belongs to `u` runs fastest. Nothing is written when an error is thrown.
/// Failures of the stream are seen in its state; `write_file_atomically()` reports them. Linear in the number of control
/// points.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bspline_surface<Traits>& surface) {
  typedef typename Traits::FT FT;
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
  text << "200 1 0 0\n" << surface.dimension() << " 0\n";
  for (const Knot_vector<FT>* knots : {&surface.knots_u(), &surface.knots_v()}) {
    text << knots->number_of_coefficients() << ' ' << knots->degree() + 1 << '\n';
    write_line(*knots);
  }
  for (int j = 0; j < surface.number_of_points_v(); ++j)
    for (int i = 0; i < surface.number_of_points_u(); ++i) write_line(surface.coordinates(i, j));
  text << '\n';
  const std::string characters = text.str();
  os.write(characters.data(), static_cast<std::streamsize>(characters.size()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_BSPLINE_SURFACES_H
