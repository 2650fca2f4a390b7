// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_H

/// \file IO/g2.h
/// Curves and surfaces in SINTEF's text format `.g2`, read and written without loss. A text holds objects one after the
/// other, each a sequence of words separated by white space.
///
/// A curve has the words
/// - `100`, the class of spline curves, the version `1 0`, the number of auxiliary integers, and these, which are
///   skipped;
/// - the dimension, and 0 because the curve is not rational;
/// - the number of control points, the order (degree + 1), and the knots, as many as both together;
/// - the control points.
///
/// A surface has the class `200`, and in place of the third line the same numbers for `u` and then for `v`. Its control
/// points are \f$ b_{00}, b_{10}, \dots, b_{m-1,0}, b_{01}, \dots, b_{m-1,n-1} \f$: the index that belongs to `u` runs
/// fastest.
///
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction `p/q`.

#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>
#include <CGAL/Geometric_continuity/IO/internal/g2_text.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
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
/// Reads curves one after the other from a text in the `.g2` format, in memory that does not depend on the length of
/// the text. A B-spline curve needs at least as many control points as its order, and knots as `Knot_vector` does. A
/// Bézier curve has as many control points as its order, and two knots `a < b`, each repeated as often as the order
/// says; its domain is [a, b]. All curves of a text have one dimension, which is that of `Traits` or, when `Traits`
/// leaves it open, lies between 2 and `max_g2_dimension`. The order is at most `max_g2_order`.
/// A byte order mark of UTF-8 is skipped; UTF-16 is refused.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Curve `Bezier_curve<Traits>` (curves with inner knots are refused) or `Bspline_curve<Traits>`
template <class Traits, class Curve = Bezier_curve<Traits>> class G2_curve_reader {
  static constexpr bool bezier = std::is_same_v<Curve, Bezier_curve<Traits>>;
  static_assert(bezier || std::is_same_v<Curve, Bspline_curve<Traits>>);
  static constexpr internal::G2_shape shape = bezier ? internal::G2_shape::bezier : internal::G2_shape::spline;

  typedef typename Traits::FT FT;

  internal::G2_parser<Traits> parser_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_curve_reader(std::istream& is, std::string name) : parser_(is, std::move(name), internal::g2_curves) {}

  /// Returns the next curve, or nothing at the end of the text. After an error the reader cannot be used any more.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is no curve of the format, and
  ///   for a text without any curve; `cannot_read_file` when reading fails for another reason
  std::optional<Curve> next() {
    if (!parser_.next_object()) return std::nullopt;
    internal::G2_direction<FT> u = parser_.read_direction(shape);
    std::vector<typename Traits::Point> points;
    for (int j = 0; j < u.points; ++j) points.push_back(parser_.read_point(j, u.points));
    if constexpr (bezier)
      return Curve(points.begin(), points.end(), u.knots.front(), u.knots.back());
    else
      return Curve(points.begin(), points.end(), Knot_vector<FT>(u.order - 1, std::move(u.knots)));
  }
};

/// \ingroup PkgGeometricContinuityIO
/// The reader of B-spline curves.
template <class Traits> using G2_bspline_reader = G2_curve_reader<Traits, Bspline_curve<Traits>>;

/// \ingroup PkgGeometricContinuityIO
/// Reads surfaces one after the other from a text in the `.g2` format, in memory that does not depend on the length of
/// the text. A B-spline surface needs, in both directions, at least as many control points as the order says, and knots
/// as `Knot_vector` does. A Bézier patch has as many control points as the orders say, and in both directions two
/// knots, each repeated as often as the order says, which are its domain. All surfaces of a text have one dimension,
/// which is that of `Traits` or, when `Traits` leaves it open, lies between 2 and `max_g2_dimension`. The orders are at
/// most `max_g2_order`.
/// A byte order mark is treated as for curves.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Surface `Bezier_patch<Traits>` (surfaces with inner knots are refused) or `Bspline_surface<Traits>`
template <class Traits, class Surface = Bezier_patch<Traits>> class G2_surface_reader {
  static constexpr bool bezier = std::is_same_v<Surface, Bezier_patch<Traits>>;
  static_assert(bezier || std::is_same_v<Surface, Bspline_surface<Traits>>);
  static constexpr internal::G2_shape shape = bezier ? internal::G2_shape::bezier : internal::G2_shape::spline;

  typedef typename Traits::FT FT;
  typedef internal::G2_direction<FT> Direction;

  internal::G2_parser<Traits> parser_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_surface_reader(std::istream& is, std::string name) : parser_(is, std::move(name), internal::g2_surfaces) {}

  /// Returns the next surface, or nothing at the end of the text. After an error the reader cannot be used any more.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is no surface of the format,
  ///   and for a text without any surface; `cannot_read_file` when reading fails for another reason
  std::optional<Surface> next() {
    if (!parser_.next_object()) return std::nullopt;
    Direction u = parser_.read_direction(shape, " in u"), v = parser_.read_direction(shape, " in v");
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

namespace internal {

// All objects that a reader finds.
template <class Object, class Reader> std::vector<Object> read_all(Reader reader) {
  std::vector<Object> objects;
  while (std::optional<Object> object = reader.next()) objects.push_back(*std::move(object));
  return objects;
}

// A curve over all its knots.
template <class Curve>
void write_g2_curve(std::ostream& os, const Curve& curve, const Knot_vector<typename Curve::FT>& knots) {
  write_g2_text<typename Curve::FT>(os, g2_curves.number, curve.dimension(), {&knots}, knots.number_of_coefficients(),
                                    [&](long long j) { return curve.coordinates(static_cast<int>(j)); });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Returns all curves of a text in the `.g2` format, which are Bézier curves.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bezier_curve<Traits>> read_g2_curves(std::istream& is, const std::string& name) {
  return internal::read_all<Bezier_curve<Traits>>(G2_curve_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all curves of a text in the `.g2` format as B-spline curves.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bspline_curve<Traits>> read_g2_bsplines(std::istream& is, const std::string& name) {
  return internal::read_all<Bspline_curve<Traits>>(G2_bspline_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all surfaces of a text in the `.g2` format, which are Bézier patches.
/// \throws Error as `G2_surface_reader` does
template <class Traits> std::vector<Bezier_patch<Traits>> read_g2_surfaces(std::istream& is, const std::string& name) {
  return internal::read_all<Bezier_patch<Traits>>(G2_surface_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all surfaces of a text in the `.g2` format as B-spline surfaces.
/// \throws Error as `G2_surface_reader` does
template <class Traits>
std::vector<Bspline_surface<Traits>> read_g2_bspline_surfaces(std::istream& is, const std::string& name) {
  return internal::read_all<Bspline_surface<Traits>>(G2_bspline_surface_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a Bézier curve in the `.g2` format without loss, with an empty line after it. Nothing is written when an
/// error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports them.
/// \throws Error as `write_number()` does
template <class Traits, int Degree> void write_g2(std::ostream& os, const Bezier_curve<Traits, Degree>& curve) {
  const std::pair<typename Traits::FT, typename Traits::FT> domain = curve.domain();
  internal::write_g2_curve(os, curve, Knot_vector<typename Traits::FT>(curve.degree(), domain.first, domain.second));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline curve in the `.g2` format without loss, with an empty line after it. Nothing is written when an
/// error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports them.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bspline_curve<Traits>& curve) {
  internal::write_g2_curve(os, curve, curve.knots());
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline surface in the `.g2` format without loss, with an empty line after it. Nothing is written when an
/// error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports them.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bspline_surface<Traits>& surface) {
  const long long m = surface.number_of_points_u(), n = surface.number_of_points_v();
  internal::write_g2_text<typename Traits::FT>(
      os, internal::g2_surfaces.number, surface.dimension(), {&surface.knots_u(), &surface.knots_v()}, m * n,
      [&](long long k) { return surface.coordinates(static_cast<int>(k % m), static_cast<int>(k / m)); });
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a Bézier patch in the `.g2` format without loss, with an empty line after it. Nothing is written when an
/// error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports them.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bezier_patch<Traits>& patch) {
  write_g2(os, Bspline_surface<Traits>(patch));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
