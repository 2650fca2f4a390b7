// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_H

#include <CGAL/Geometric_continuity/IO/g2_parser.h>
#include <CGAL/Geometric_continuity/IO/internal/g2_text.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>

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
/// Reads curves one after the other from a text in SINTEF's `.g2` format, in memory that does not depend on the
/// length of the text.
///
/// Each curve has the words, separated by white space:
/// - `100`, the class of spline curves, the version `1 0`, the number of auxiliary integers, and these, which are
///   skipped;
/// - the dimension, and 0 because the curve is not rational;
/// - the number of control points and the order (degree + 1);
/// - the knots, as many as both together;
/// - the control points.
///
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction `p/q`. A B-spline curve
/// needs at least as many control points as its order, and knots as `Knot_vector` does. A Bézier curve has as many
/// control points as its order, and two knots `a < b`, each repeated as often as the order says; its domain is [a, b].
/// All curves of a text have one dimension, which is that of `Traits` or, when `Traits` leaves it open, lies between 2
/// and `max_g2_dimension`. The order is at most `max_g2_order`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Curve `Bezier_curve<Traits>` (curves with inner knots are refused) or `Bspline_curve<Traits>`
template <class Traits, class Curve = Bezier_curve<Traits>> class G2_curve_reader {
  static constexpr bool bezier = std::is_same_v<Curve, Bezier_curve<Traits>>;
  static_assert(bezier || std::is_same_v<Curve, Bspline_curve<Traits>>);

  typedef typename Traits::FT FT;

  internal::G2_parser<Traits> parser_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_curve_reader(std::istream& is, std::string name) : parser_(is, std::move(name), internal::g2_curves) {}

  /// The next curve, or nothing at the end of the text.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is not described above, and
  ///         for a text without any curve. After an error the reader cannot be used any more.
  /// \throws Error `cannot_read_file` when reading fails for another reason
  std::optional<Curve> next() {
    if (!parser_.next_object()) return std::nullopt;
    internal::G2_direction<FT> u = parser_.read_direction(bezier);
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
                                    [&](int j) { return curve.coordinates(j); });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// All curves of a text in the `.g2` format, which are Bézier curves, see `G2_curve_reader`.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bezier_curve<Traits>> read_g2_curves(std::istream& is, const std::string& name) {
  return internal::read_all<Bezier_curve<Traits>>(G2_curve_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// All curves of a text in the `.g2` format as B-spline curves, see `G2_curve_reader`.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bspline_curve<Traits>> read_g2_bsplines(std::istream& is, const std::string& name) {
  return internal::read_all<Bspline_curve<Traits>>(G2_bspline_reader<Traits>(is, name));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a curve in the `.g2` format without loss, see `write_number()`, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports
/// them.
/// \throws Error as `write_number()` does
template <class Traits, int Degree> void write_g2(std::ostream& os, const Bezier_curve<Traits, Degree>& curve) {
  const std::pair<typename Traits::FT, typename Traits::FT> domain = curve.domain();
  internal::write_g2_curve(os, curve, Knot_vector<typename Traits::FT>(curve.degree(), domain.first, domain.second));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline curve in the same way.
template <class Traits> void write_g2(std::ostream& os, const Bspline_curve<Traits>& curve) {
  internal::write_g2_curve(os, curve, curve.knots());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
