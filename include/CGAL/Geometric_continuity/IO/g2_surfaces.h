// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_SURFACES_H

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/g2_parser.h>
#include <CGAL/Geometric_continuity/IO/internal/g2_text.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Reads surfaces one after the other from a text in SINTEF's `.g2` format, in memory that does not depend on the
/// length of the text.
///
/// Each surface has the words, separated by white space:
/// - `200`, the class of spline surfaces, the version `1 0`, the number of auxiliary integers, and these, which are
///   skipped;
/// - the dimension, and 0 because the surface is not rational;
/// - for `u` and then for `v`: the number of control points, the order (degree + 1), and the knots, as many as both together;
/// - the control points \f$ b_{00}, b_{10}, \dots, b_{m-1,0}, b_{01}, \dots, b_{m-1,n-1} \f$: the index that belongs to `u`
///   runs fastest.
///
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction `p/q`. A B-spline surface needs,
/// in both directions, at least as many control points as the order says, and knots as `Knot_vector` does. A Bézier patch
/// has as many control points as the orders say, and in both directions two knots, each repeated as often, which are its
/// domain. All surfaces of a text have one dimension, which is that of `Traits` or, when `Traits` leaves it open, lies between
/// 2 and `max_g2_dimension`. The orders are at most `max_g2_order`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Surface `Bezier_patch<Traits>` (surfaces with inner knots are refused) or `Bspline_surface<Traits>`
template <class Traits, class Surface = Bezier_patch<Traits>> class G2_surface_reader {
  static constexpr bool bezier = std::is_same_v<Surface, Bezier_patch<Traits>>;
  static_assert(bezier || std::is_same_v<Surface, Bspline_surface<Traits>>);

  typedef typename Traits::FT FT;
  typedef internal::G2_direction<FT> Direction;

  internal::G2_parser<Traits> parser_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_surface_reader(std::istream& is, std::string name) : parser_(is, std::move(name), internal::g2_surfaces) {}

  /// The next surface, or nothing at the end of the text.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is not described above, and
  ///         for a text without any surface. After an error the reader cannot be used any more.
  /// \throws Error `cannot_read_file` when reading fails for another reason
  std::optional<Surface> next() {
    if (!parser_.next_object()) return std::nullopt;
    Direction u = parser_.read_direction(bezier, " in u"), v = parser_.read_direction(bezier, " in v");
    const long long all = static_cast<long long>(u.points) * v.points;
    std::vector<std::vector<typename Traits::Point>> net(u.points);
    for (long long k = 0; k < all; ++k) net[k % u.points].push_back(parser_.read_point(k, all));
    if constexpr (bezier)
      return Surface(net, {u.knots.front(), u.knots.back()}, {v.knots.front(), v.knots.back()});
    else
      return Surface(net, Knot_vector<FT>(u.order - 1, std::move(u.knots)),
                     Knot_vector<FT>(v.order - 1, std::move(v.knots)));
  }
};

/// \ingroup PkgGeometricContinuityIO
/// The reader of B-spline surfaces.
template <class Traits> using G2_bspline_surface_reader = G2_surface_reader<Traits, Bspline_surface<Traits>>;

/// \ingroup PkgGeometricContinuityIO
/// All surfaces of a text in the `.g2` format, which are Bézier patches, see `G2_surface_reader`.
/// \throws Error as `G2_surface_reader` does
template <class Traits> std::vector<Bezier_patch<Traits>> read_g2_surfaces(std::istream& is, const std::string& name) {
  return internal::read_all<Bezier_patch<Traits>>(G2_surface_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// All surfaces of a text in the `.g2` format as B-spline surfaces, see `G2_surface_reader`.
/// \throws Error as `G2_surface_reader` does
template <class Traits>
std::vector<Bspline_surface<Traits>> read_g2_bspline_surfaces(std::istream& is, const std::string& name) {
  return internal::read_all<Bspline_surface<Traits>>(G2_bspline_surface_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a surface in the `.g2` format without loss, see `write_number()`, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports
/// them. Linear in the number of control points.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bspline_surface<Traits>& surface) {
  const int m = surface.number_of_points_u(), n = surface.number_of_points_v();
  internal::write_g2_text<typename Traits::FT>(os, internal::g2_surfaces.number, surface.dimension(),
                                               {&surface.knots_u(), &surface.knots_v()}, m * n,
                                               [&](int k) { return surface.coordinates(k % m, k / m); });
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a Bézier patch in the same way.
template <class Traits> void write_g2(std::ostream& os, const Bezier_patch<Traits>& patch) {
  write_g2(os, Bspline_surface<Traits>(patch));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_SURFACES_H
