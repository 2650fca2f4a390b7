// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_H

/// \file IO/g2.h
/// Curves and surfaces in SINTEF's text format `.g2`, read and written without loss. A text holds
/// objects one after the other, each a sequence of words separated by white space.
///
/// A curve has the words
/// - `100`, the class of spline curves, the version `1 0`, the number of auxiliary integers, and
///   these, which are skipped;
/// - the dimension, and the rational flag: 0, or 1 for a curve with weights;
/// - the number of control points, the order (degree + 1), and the knots, as many as both together;
/// - the control points; with the flag 1 the products \f$ w x \f$ of the coordinates and the
///   weight, and then the weight \f$ w \f$.
///
/// A line, `120`, with its dimension, location, direction, 1 and the parameters of its two ends, is
/// read as a curve of degree 1. A plane, `250`, with its dimension 3, location, normal, axis, 1 and
/// the bounds of both parameters, is read as a surface of degree 1 by 1 if its normal and its axis
/// are orthogonal and have rational lengths, by which they are divided; so are planes with the flag
/// 11, the bounds and the domain, and those with the flag, 0 or 1, that says whether the parameters
/// change places. Circles, cylinders and other elementary classes are refused: their angles in
/// radians are not exact numbers. As rational splines they are.
///
/// A surface has the class `200`, and in place of the third line the same numbers for `u` and then
/// for `v`. Its control points are
/// \f$ b_{00}, b_{10}, \dots, b_{m-1,0}, b_{01}, \dots, b_{m-1,n-1} \f$: the index that belongs to
/// `u` runs fastest.
///
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction
/// `p/q`.

#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>
#include <CGAL/Geometric_continuity/IO/internal/g2_text.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// A rational Bezier or B-spline curve from what has been read.
template <class Curve, class Points, class Direction> Curve rational_g2_curve(const Points& w, const Direction& u) {
  typedef typename Curve::Homogeneous Homogeneous;
  const std::vector<typename Homogeneous::Point> rows =
      w.infinite() ? w.rows() : std::vector<typename Homogeneous::Point>();
  if constexpr (std::is_same_v<Curve, Rational_bspline_curve<typename Curve::Traits>>) {
    const Knot_vector<typename Curve::FT> knots(u.order - 1, u.knots);
    if (w.infinite()) return Curve(Homogeneous(rows.begin(), rows.end(), knots));
    return Curve(w.points.begin(), w.points.end(), w.weights.begin(), w.weights.end(), knots);
  } else {
    if (w.infinite()) return Curve(Homogeneous(rows.begin(), rows.end(), u.knots.front(), u.knots.back()));
    return Curve(w.points.begin(), w.points.end(), w.weights.begin(), w.weights.end(), u.knots.front(), u.knots.back());
  }
}

// The control points that have been read one after the other, in rows of constant i.
template <class T, class Direction>
std::vector<std::vector<T>> g2_net(const std::vector<T>& points, const Direction& u) {
  std::vector<std::vector<T>> rows(u.points);
  for (std::size_t k = 0; k < points.size(); ++k) rows[k % static_cast<std::size_t>(u.points)].push_back(points[k]);
  return rows;
}

// A rational Bezier or B-spline surface from what has been read.
template <class Surface, class Points, class Direction>
Surface rational_g2_surface(const Points& w, const Direction& u, const Direction& v) {
  typedef typename Surface::FT FT;
  if constexpr (std::is_same_v<Surface, Rational_bspline_surface<typename Surface::Traits>>) {
    const Knot_vector<FT> a(u.order - 1, u.knots), b(v.order - 1, v.knots);
    if (w.infinite()) return Surface(typename Surface::Homogeneous(g2_net(w.rows(), u), a, b));
    return Surface(g2_net(w.points, u), g2_net(w.weights, u), a, b);
  } else {
    const std::pair<FT, FT> a(u.knots.front(), u.knots.back()), b(v.knots.front(), v.knots.back());
    if (w.infinite()) return Surface(typename Surface::Homogeneous(g2_net(w.rows(), u), a, b));
    return Surface(g2_net(w.points, u), g2_net(w.weights, u), a, b);
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Reads curves one after the other from a text in the `.g2` format, in memory that does not depend
/// on the length of the text. A B-spline curve needs at least as many control points as its order,
/// and knots as `Knot_vector` does. A Bézier curve has as many control points as its order, and two
/// knots `a < b`, each repeated as often as the order says; its domain is [a, b]. All curves of a
/// text have one dimension, which is that of `Traits` or, when `Traits` leaves it open, lies
/// between 2 and `max_g2_dimension`. The order is at most `max_g2_order`. A byte order mark of
/// UTF-8 is skipped; UTF-16 is refused.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Curve `Rational_bspline_curve<Traits>` or `Bspline_curve<Traits>`, or, for texts without
///   inner knots, `Rational_bezier_curve<Traits>` or `Bezier_curve<Traits>`. Curves with the
///   rational flag are refused where a polynomial type is read; polynomial curves are read as
///   rational ones with the weights 1
template <class Traits, class Curve = Bezier_curve<Traits>> class G2_curve_reader {
  static constexpr bool bezier =
      std::is_same_v<Curve, Bezier_curve<Traits>> || std::is_same_v<Curve, Rational_bezier_curve<Traits>>;
  static constexpr bool rational =
      std::is_same_v<Curve, Rational_bezier_curve<Traits>> || std::is_same_v<Curve, Rational_bspline_curve<Traits>>;
  static_assert(bezier || rational || std::is_same_v<Curve, Bspline_curve<Traits>>);
  static constexpr internal::G2_shape shape = bezier ? internal::G2_shape::bezier : internal::G2_shape::spline;

  typedef typename Traits::FT FT;

  internal::G2_parser<FT, dimension_v<Traits>> parser_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_curve_reader(std::istream& is, std::string name = "input")
      : parser_(is, std::move(name), internal::g2_curves,
                rational ? internal::G2_weights::allowed : internal::G2_weights::refused) {}

  /// Returns the next curve, or nothing at the end of the text. After an error the reader cannot be
  /// used any more.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is no
  ///   curve of the format, and for a text without any curve; `cannot_read_file` when reading fails
  ///   for another reason
  std::optional<Curve> next() {
    if (!parser_.next_object()) return std::nullopt;
    internal::G2_direction<FT> u = parser_.read_direction(shape);
    if constexpr (rational)
      if (parser_.rational()) return read_rational(u);
    std::vector<typename Traits::Point> points;
    for (int j = 0; j < u.points; ++j) points.push_back(to_point<Traits>(parser_.read_point(j, u.points)));
    if constexpr (bezier)
      return Curve(Bezier_curve<Traits>(points.begin(), points.end(), u.knots.front(), u.knots.back()));
    else
      return Curve(
          Bspline_curve<Traits>(points.begin(), points.end(), Knot_vector<FT>(u.order - 1, std::move(u.knots))));
  }

private:
  Curve read_rational(const internal::G2_direction<FT>& u) {
    internal::G2_weighted_points<Traits, typename Exact_field<FT>::type> w;
    for (int j = 0; j < u.points; ++j) {
      const auto row = parser_.read_homogeneous_point(j, u.points);
      parser_.checked([&] { w.push_back(row); });
    }
    return parser_.checked([&] { return internal::rational_g2_curve<Curve>(w, u); });
  }
};

/// \ingroup PkgGeometricContinuityIO
/// The reader of B-spline curves.
template <class Traits> using G2_bspline_reader = G2_curve_reader<Traits, Bspline_curve<Traits>>;

/// \ingroup PkgGeometricContinuityIO
/// Reads surfaces one after the other from a text in the `.g2` format, in memory that does not
/// depend on the length of the text. A B-spline surface needs, in both directions, at least as many
/// control points as the order says, and knots as `Knot_vector` does. A Bézier patch has as many
/// control points as the orders say, and in both directions two knots, each repeated as often as
/// the order says, which are its domain. All surfaces of a text have one dimension, which is that
/// of `Traits` or, when `Traits` leaves it open, lies between 2 and `max_g2_dimension`. The orders
/// are at most `max_g2_order`.
/// A byte order mark is treated as for curves.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Surface `Rational_bspline_surface<Traits>` or `Bspline_surface<Traits>`, or, for texts
///   without inner knots, `Rational_bezier_patch<Traits>` or `Bezier_patch<Traits>`. Surfaces with
///   the rational flag are refused where a polynomial type is read; polynomial surfaces are read as
///   rational ones with the weights 1
template <class Traits, class Surface = Bezier_patch<Traits>> class G2_surface_reader {
  static constexpr bool bezier =
      std::is_same_v<Surface, Bezier_patch<Traits>> || std::is_same_v<Surface, Rational_bezier_patch<Traits>>;
  static constexpr bool rational = std::is_same_v<Surface, Rational_bezier_patch<Traits>> ||
                                   std::is_same_v<Surface, Rational_bspline_surface<Traits>>;
  static_assert(bezier || rational || std::is_same_v<Surface, Bspline_surface<Traits>>);
  static constexpr internal::G2_shape shape = bezier ? internal::G2_shape::bezier : internal::G2_shape::spline;

  typedef typename Traits::FT FT;
  typedef internal::G2_direction<FT> Direction;

  internal::G2_parser<FT, dimension_v<Traits>> parser_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_surface_reader(std::istream& is, std::string name = "input")
      : parser_(is, std::move(name), internal::g2_surfaces,
                rational ? internal::G2_weights::allowed : internal::G2_weights::refused) {}

  /// Returns the next surface, or nothing at the end of the text. After an error the reader cannot
  /// be used any more.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is no
  ///   surface of the format, and for a text without any surface; `cannot_read_file` when reading
  ///   fails for another reason
  std::optional<Surface> next() {
    std::optional<Surface> result;
    visit_next([&](auto&& surface) { result.emplace(std::move(surface)); });
    return result;
  }

  /// Reads the next surface, and calls `f` with it: with a polynomial surface as a `Bezier_patch`
  /// or `Bspline_surface`, also where `Surface` is rational. Returns false, without a call, at the
  /// end of the text.
  /// \throws Error as `next()`
  template <class Function> bool visit_next(Function f) {
    if (!parser_.next_object()) return false;
    Direction u = parser_.read_direction(shape, " in u"), v = parser_.read_direction(shape, " in v");
    if constexpr (rational)
      if (parser_.rational()) {
        f(read_rational(u, v));
        return true;
      }
    const long long all = static_cast<long long>(u.points) * v.points;
    std::vector<std::vector<typename Traits::Point>> net(u.points);
    for (long long k = 0; k < all; ++k) net[k % u.points].push_back(to_point<Traits>(parser_.read_point(k, all)));
    if constexpr (bezier)
      f(Bezier_patch<Traits>(net, {u.knots.front(), u.knots.back()}, {v.knots.front(), v.knots.back()}));
    else
      f(Bspline_surface<Traits>(net, Knot_vector<FT>(u.order - 1, std::move(u.knots)),
                                Knot_vector<FT>(v.order - 1, std::move(v.knots))));
    return true;
  }

private:
  Surface read_rational(const Direction& u, const Direction& v) {
    const long long all = static_cast<long long>(u.points) * v.points;
    internal::G2_weighted_points<Traits, typename Exact_field<FT>::type> w;
    for (long long k = 0; k < all; ++k) {
      const auto row = parser_.read_homogeneous_point(k, all);
      parser_.checked([&] { w.push_back(row); });
    }
    return parser_.checked([&] { return internal::rational_g2_surface<Surface>(w, u, v); });
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

// Returns whether nothing is lost without the weights.
template <class Object> bool has_unit_weights(const Object& object) {
  typedef typename Object::FT FT;
  return std::all_of(object.weights().begin(), object.weights().end(), [](const FT& w) { return bool(w == FT(1)); });
}

// A curve over all its knots.
template <class Curve>
void write_g2_curve(std::ostream& os, const Curve& curve, const Knot_vector<typename Curve::FT>& knots) {
  write_g2_text<typename Curve::FT>(os, g2_curves.number, curve.dimension(), false, {&knots},
                                    knots.number_of_coefficients(),
                                    [&](long long j) { return curve.coordinates(static_cast<int>(j)); });
}

// A rational curve over all its knots; with the weights 1 as a polynomial one.
template <class Curve>
void write_rational_g2_curve(std::ostream& os, const Curve& curve, const Knot_vector<typename Curve::FT>& knots) {
  if (has_unit_weights(curve)) return write_g2_curve(os, curve, knots);
  write_g2_text<typename Curve::FT>(os, g2_curves.number, curve.dimension(), true, {&knots},
                                    knots.number_of_coefficients(), [&](long long j) {
                                      const int i = static_cast<int>(j);
                                      return weighted_row(curve.coordinates(i), curve.weight(i));
                                    });
}

// A surface over all its knots, with row(i, j) for each control point.
template <class Surface, class Row_of>
void write_g2_surface(std::ostream& os, const Surface& surface, bool rational, Row_of row) {
  const long long m = surface.number_of_points_u(), n = surface.number_of_points_v();
  write_g2_text<typename Surface::FT>(
      os, g2_surfaces.number, surface.dimension(), rational, {&surface.knots_u(), &surface.knots_v()}, m * n,
      [&](long long k) { return row(static_cast<int>(k % m), static_cast<int>(k / m)); });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Returns all curves of a text in the `.g2` format, which are Bézier curves. Error messages begin
/// with `name`.
/// \throws Error as `G2_curve_reader` does
template <class Traits>
std::vector<Bezier_curve<Traits>> read_g2_curves(std::istream& is, const std::string& name = "input") {
  return internal::read_all<Bezier_curve<Traits>>(G2_curve_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all curves of a text in the `.g2` format as B-spline curves.
/// \throws Error as `G2_curve_reader` does
template <class Traits>
std::vector<Bspline_curve<Traits>> read_g2_bsplines(std::istream& is, const std::string& name = "input") {
  return internal::read_all<Bspline_curve<Traits>>(G2_bspline_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all curves of a text in the `.g2` format, rational or not, as rational B-spline curves.
/// \throws Error as `G2_curve_reader` does
template <class Traits>
std::vector<Rational_bspline_curve<Traits>> read_g2_rational_bsplines(std::istream& is,
                                                                      const std::string& name = "input") {
  return internal::read_all<Rational_bspline_curve<Traits>>(
      G2_curve_reader<Traits, Rational_bspline_curve<Traits>>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all surfaces of a text in the `.g2` format, which are Bézier patches. Error messages
/// begin with `name`.
/// \throws Error as `G2_surface_reader` does
template <class Traits>
std::vector<Bezier_patch<Traits>> read_g2_surfaces(std::istream& is, const std::string& name = "input") {
  return internal::read_all<Bezier_patch<Traits>>(G2_surface_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all surfaces of a text in the `.g2` format as B-spline surfaces.
/// \throws Error as `G2_surface_reader` does
template <class Traits>
std::vector<Bspline_surface<Traits>> read_g2_bspline_surfaces(std::istream& is, const std::string& name = "input") {
  return internal::read_all<Bspline_surface<Traits>>(G2_bspline_surface_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Returns all surfaces of a text in the `.g2` format, rational or not, as rational B-spline
/// surfaces.
/// \throws Error as `G2_surface_reader` does
template <class Traits>
std::vector<Rational_bspline_surface<Traits>> read_g2_rational_bspline_surfaces(std::istream& is,
                                                                                const std::string& name = "input") {
  return internal::read_all<Rational_bspline_surface<Traits>>(
      G2_surface_reader<Traits, Rational_bspline_surface<Traits>>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a Bézier curve in the `.g2` format without loss, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state.
/// \throws Error as `write_number()` does
template <class Traits, int Degree> void write_g2(std::ostream& os, const Bezier_curve<Traits, Degree>& curve) {
  const std::pair<typename Traits::FT, typename Traits::FT> domain = curve.domain();
  internal::write_g2_curve(os, curve, Knot_vector<typename Traits::FT>(curve.degree(), domain.first, domain.second));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline curve in the `.g2` format without loss, with an empty line after it. Nothing
/// is written when an error is thrown. Failures of the stream are seen in its state.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bspline_curve<Traits>& curve) {
  internal::write_g2_curve(os, curve, curve.knots());
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a rational Bézier curve in the `.g2` format without loss, with an empty line after it:
/// the products \f$ w_i b_i \f$ and the weights \f$ w_i \f$, or a polynomial curve where all
/// weights are 1. A product of floating-point numbers is written with as many digits as give the
/// control point back when it is divided by the weight. Nothing is written when an error is thrown.
/// \throws Error as `write_number()` does
template <class Traits, int Degree>
void write_g2(std::ostream& os, const Rational_bezier_curve<Traits, Degree>& curve) {
  const std::pair<typename Traits::FT, typename Traits::FT> domain = curve.domain();
  internal::write_rational_g2_curve(os, curve,
                                    Knot_vector<typename Traits::FT>(curve.degree(), domain.first, domain.second));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a rational B-spline curve in the `.g2` format without loss, with an empty line after it,
/// as a rational Bézier curve.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Rational_bspline_curve<Traits>& curve) {
  internal::write_rational_g2_curve(os, curve, curve.knots());
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline surface in the `.g2` format without loss, with an empty line after it. Nothing
/// is written when an error is thrown. Failures of the stream are seen in its state.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bspline_surface<Traits>& surface) {
  internal::write_g2_surface(os, surface, false, [&](int i, int j) { return surface.coordinates(i, j); });
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a Bézier patch in the `.g2` format without loss, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bezier_patch<Traits>& patch) {
  write_g2(os, Bspline_surface<Traits>(patch));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a rational B-spline surface in the `.g2` format without loss, with an empty line after
/// it: the products \f$ w_{ij} b_{ij} \f$ and the weights, as for a rational curve, or a polynomial
/// surface where all weights are 1.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Rational_bspline_surface<Traits>& surface) {
  if (internal::has_unit_weights(surface))
    internal::write_g2_surface(os, surface, false, [&](int i, int j) { return surface.coordinates(i, j); });
  else
    internal::write_g2_surface(os, surface, true, [&](int i, int j) {
      return internal::weighted_row(surface.coordinates(i, j), surface.weight(i, j));
    });
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a rational Bézier patch in the `.g2` format without loss, as a rational B-spline surface.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Rational_bezier_patch<Traits>& patch) {
  write_g2(os, Rational_bspline_surface<Traits>(patch));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the curves or surfaces of a range, such as a `std::vector` or a `Rounded_chain`, one
/// after the other. Those before one that throws are written.
/// \throws Error as for one of them
template <class Range, class = typename std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>::Traits>
void write_g2(std::ostream& os, const Range& range) {
  for (const auto& object : range) write_g2(os, object);
}

/// \ingroup PkgGeometricContinuityIO
/// Writes the segments of a segmented Bézier curve, such as a `Fitted_curve`, one after the other.
/// \throws Error as for a Bézier curve
template <class Traits, int Degree>
void write_g2(std::ostream& os, const Composite_bezier_curve<Traits, Degree>& curve) {
  for (const auto& segment : curve.segments()) write_g2(os, segment);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
