// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_MESH_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_MESH_H

/// \file IO/mesh.h
/// Triangles of surfaces as files that other programs read.

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <limits>
#include <locale>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// The formats in which triangles are written, all of them as text.
enum class Mesh_format {
  off, ///< Object File Format
  obj, ///< Wavefront
  ply, ///< Polygon File Format
  stl  ///< stereolithography: the triangles have no common points
};

/// \ingroup PkgGeometricContinuityIO
/// Returns the format of a file by the last letters of its name, in upper or lower case.
/// \throws Error `cannot_write_file` for any other than `.off`, `.obj`, `.ply` and `.stl`
inline Mesh_format mesh_format(const std::string& path) {
  std::string extension = path.substr((std::min)(path.size(), path.find_last_of("./")));
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".off") return Mesh_format::off;
  if (extension == ".obj") return Mesh_format::obj;
  if (extension == ".ply") return Mesh_format::ply;
  if (extension == ".stl") return Mesh_format::stl;
  throw Error(Error_code::cannot_write_file, path + ": the name must end with .off, .obj, .ply or .stl");
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the points and triangles of a tessellation by the functions of \cgal for polygon soups.
/// Triangles keep the orientation that `tessellate()` gives them: outwards for closed solids.
/// Coordinates are rounded to `double` and written with 17 digits, so that nothing more is lost,
/// whatever the locale. Nothing is written when an error is thrown. Failures of the stream are seen
/// in its state.
/// \throws Error `dimension_mismatch` unless the points are in dimension 3; `not_finite` for
///   coordinates that are no finite `double`; `wrong_number_of_points` for a triangle with the
///   index of a point that does not exist
template <class Traits>
void write_mesh(std::ostream& os, const Tessellation<Traits>& tessellation, Mesh_format format) {
  std::vector<Simple_cartesian<double>::Point_3> points;
  points.reserve(tessellation.points.size());
  for (const typename Traits::Point& point : tessellation.points) {
    const Geometric_continuity::Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(point);
    if (x.dimension() != 3)
      throw Error(Error_code::dimension_mismatch, "write_mesh: points of dimension 3 are expected");
    double y[3];
    for (int i = 0; i < 3; ++i) internal::check_finite(y[i] = CGAL::to_double(x[i]), "write_mesh");
    points.emplace_back(y[0], y[1], y[2]);
  }
  for (const std::array<std::size_t, 3>& triangle : tessellation.triangles)
    for (std::size_t i : triangle)
      if (i >= points.size())
        throw Error(Error_code::wrong_number_of_points, "write_mesh: a triangle has the point " + std::to_string(i) +
                                                            " of " + std::to_string(points.size()));
  const std::locale locale = os.imbue(std::locale::classic());
  const std::streamsize precision = os.precision(std::numeric_limits<double>::max_digits10);
  CGAL::IO::set_ascii_mode(os);
  switch (format) {
  case Mesh_format::off: CGAL::IO::write_OFF(os, points, tessellation.triangles); break;
  case Mesh_format::obj: CGAL::IO::write_OBJ(os, points, tessellation.triangles); break;
  case Mesh_format::ply: CGAL::IO::write_PLY(os, points, tessellation.triangles); break;
  case Mesh_format::stl: CGAL::IO::write_STL(os, points, tessellation.triangles); break;
  }
  os.precision(precision);
  os.imbue(locale);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_MESH_H
