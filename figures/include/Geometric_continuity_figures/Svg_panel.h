// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_SVG_PANEL_H
#define GEOMETRIC_CONTINUITY_FIGURES_SVG_PANEL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// The role of a curve in a picture.
enum class Svg_role {
  /// a curve that was there before, drawn dark; "given curve" in the legend unless it has a name
  given,
  /// a curve that was computed, highlighted; "result" in the legend unless it has a name
  result,
  /// a line of a geometric construction, drawn dashed; "construction" in the legend unless it has a
  /// name
  construction
};

/// \ingroup PkgGeometricContinuityIO
/// How a curve is drawn, and what the legend calls it.
struct Svg_style {
  Svg_role role = Svg_role::given; ///< the colour and width of the line
  bool control_polygon = false;    ///< with its control points, thin
  bool curvature_comb = false;     ///< with teeth as long as the curvature, see `Svg_figure`
  /// plain text in UTF-8 for the legend; empty: the name of the role
  std::string name = std::string();
  /// in the plot of the curvature against the arc length below the panel
  bool curvature_plot = false;
  /// the frame and the scales follow it; otherwise it may leave the panel
  bool in_frame = true;
};

namespace internal {

typedef Coordinate_vector<double, 3> Svg_point; // z = 0 for a planar curve

// The Bezier points and the style of a curve.
struct Svg_curve {
  std::vector<Svg_point> points;
  std::vector<Svg_point> polygon; // of control points, if it is drawn
  bool continues;                 // it is the next part of the curve before it
  Svg_style style;
  int samples = 0; // parts in which a figure looks at it
};

// A join, or a text, at the end of the curve with this index.
struct Svg_join {
  std::size_t curve;
  std::string label;
  bool is_marked; // by a ring
};

// Tells whether the elements of a range are curves.
template <class Range, class = void> struct Is_range_of_curves : std::false_type {};
template <class Range>
struct Is_range_of_curves<
    Range, std::void_t<typename std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>::Traits>>
    : std::true_type {};

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// One picture of an `Svg_figure`: curves, marked joins and a caption. A chain is written as it
/// runs: `panel.add(phi).join("G2").add(gamma, highlighted).join("G2").add(psi)`.
class Svg_panel {
public:
  /// Constructs a panel without curves. Captions and labels are plain text in UTF-8. Long captions
  /// are broken into lines.
  explicit Svg_panel(std::string caption = std::string()) : caption_(std::move(caption)) {}

  /// Adds a Bézier curve of dimension 2 or 3 over any kernel. The coordinates are rounded to
  /// `double` for the drawing.
  /// \tparam Curve a `Bezier_curve`, or a class with its `Traits`, `dimension()`, `degree()`,
  ///   `begin()`, `end()` and `coordinates(j)`; or a range of such curves, e.g. `bezier_pieces()`
  ///   of a B-spline curve, which are added one after the other
  /// \throws Error `dimension_mismatch` in dimension 1 or above 3
  /// \throws Error `wrong_number_of_points` unless there are `degree() + 1` control points
  /// \throws Error `not_finite` for a coordinate beyond the range of `double`, with the number of
  ///   the curve in the panel
  template <class Curve> Svg_panel& add(const Curve& curve, const Svg_style& style = Svg_style()) {
    if constexpr (internal::Is_range_of_curves<Curve>::value) {
      for (const auto& piece : curve) add(piece, style);
      return *this;
    } else {
      check_dimension(curve.dimension());
      if (std::distance(curve.begin(), curve.end()) != curve.degree() + 1)
        throw Error(Error_code::wrong_number_of_points,
                    "Svg_panel: only Bézier curves can be drawn; of a B-spline curve add its bezier_pieces()");
      std::vector<Coordinate_vector<double, 0>> rows;
      for (int j = 0; j <= curve.degree(); ++j) rows.push_back(to_double(curve.coordinates(j)));
      return add_rows(rows, rows, false, style);
    }
  }

  /// Adds a rational Bézier curve of dimension 2 or 3. Where its weights differ, it is drawn as
  /// eight polynomial curves that have its first and second derivatives at their ends: far closer
  /// to it than a line is wide.
  /// \throws Error as for a Bézier curve
  template <class Traits, int Degree>
  Svg_panel& add(const Rational_bezier_curve<Traits, Degree>& curve, const Svg_style& style = Svg_style()) {
    if (curve.is_polynomial()) return add(*curve.polynomial(), style);
    typedef typename Traits::FT FT;
    constexpr int parts = 8, degree = 5;
    check_dimension(curve.dimension());
    const FT a = curve.domain().first, h = FT(FT(curve.domain().second - a) / FT(parts));
    const auto points_at = [&](int i, double step) {
      const Curve_jet<Traits> x = curve.jet(FT(a + FT(i) * h), 2);
      Coordinate_jet<double, 0> jet(x.dimension(), 2);
      FT factor(1);
      for (int k = 0; k <= 2; ++k, factor *= h) jet[k] = to_double(factor * x[k]);
      return internal::points_from_jet(jet, degree, step);
    };
    std::vector<Coordinate_vector<double, 0>> polygon;
    for (int j = 0; j <= curve.degree(); ++j)
      if (curve.weight(j) != FT(0)) polygon.push_back(to_double(curve.coordinates(j)));
    for (int i = 0; i < parts; ++i) {
      std::vector<Coordinate_vector<double, 0>> rows = points_at(i, 1);
      const std::vector<Coordinate_vector<double, 0>> back = points_at(i + 1, -1);
      rows.insert(rows.end(), back.rbegin(), back.rend());
      add_rows(rows, polygon, i > 0, style);
      polygon.clear();
    }
    return *this;
  }

  /// Marks the end of the curve added last as a join, with a short label such as "G2" beside it.
  /// \throws Error `wrong_number_of_points` in a panel without curves
  Svg_panel& join(std::string label = std::string()) { return add_label(std::move(label), true); }

  /// Writes a short text beside the end of the curve added last, which is not marked.
  /// \throws Error `wrong_number_of_points` in a panel without curves
  Svg_panel& label(std::string text) { return add_label(std::move(text), false); }

private:
  friend class Svg_figure;

  Svg_panel& add_label(std::string label, bool is_marked) {
    if (curves_.empty()) throw Error(Error_code::wrong_number_of_points, "Svg_panel: a join before the first curve");
    joins_.push_back({curves_.size() - 1, std::move(label), is_marked});
    return *this;
  }

  static void check_dimension(int d) {
    if (d != 2 && d != 3)
      throw Error(Error_code::dimension_mismatch,
                  "Svg_panel: curves of dimension 2 or 3 can be drawn, not " + std::to_string(d));
  }

  template <class FT, int N> static Coordinate_vector<double, 0> to_double(const Coordinate_vector<FT, N>& x) {
    Coordinate_vector<double, 0> y(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) y[i] = CGAL::to_double(x[i]);
    return y;
  }

  typedef std::vector<Coordinate_vector<double, 0>> Rows;

  std::vector<internal::Svg_point> points_of(const Rows& rows) const {
    std::vector<internal::Svg_point> points;
    for (const Coordinate_vector<double, 0>& row : rows) {
      points.emplace_back(3);
      for (int i = 0; i < row.dimension(); ++i) {
        if (!std::isfinite(row[i]))
          throw Error(Error_code::not_finite, "Svg_panel: curve " + std::to_string(curves_.size()) +
                                                  ": control point " + std::to_string(points.size() - 1) +
                                                  " is too far away to be drawn");
        points.back()[i] = row[i];
      }
    }
    return points;
  }

  Svg_panel& add_rows(const Rows& rows, const Rows& polygon, bool continues, const Svg_style& style) {
    curves_.push_back({points_of(rows), points_of(style.control_polygon ? polygon : Rows()), continues, style, 0});
    spatial_ = spatial_ || rows.front().dimension() == 3;
    return *this;
  }

  std::string caption_;
  std::vector<internal::Svg_curve> curves_;
  std::vector<internal::Svg_join> joins_;
  bool spatial_ = false;
};

/// \ingroup PkgGeometricContinuityIO
/// How the faces of surfaces are painted.
enum class Svg_shading {
  /// in strips of equal angles of the normal and the light: where the strips have a kink the
  /// surface is not \f$ G^2 \f$, where they break it is not \f$ G^1 \f$
  isophotes,
  smooth ///< by the angle of the normal and the light
};

/// \ingroup PkgGeometricContinuityIO
/// How surfaces are drawn.
struct Svg_surface_style {
  Svg_shading shading = Svg_shading::isophotes; ///< the faces
  /// where the viewer is: degrees around the z-axis from the x-axis
  double azimuth = -60;
  double elevation = 22; ///< where the viewer is: degrees above the ground
  std::string title;     ///< plain text in UTF-8
  /// of the drawing without its margins, in pixels, at least 100
  double width = 900;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_SVG_PANEL_H
