// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_PANEL_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_PANEL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// What a curve is in a picture.
enum class Svg_role {
  given,       ///< a curve that was there before, drawn dark; "given curve" in the legend unless it has a name
  result,      ///< a curve that was computed, highlighted; "result" in the legend unless it has a name
  construction ///< a line of a geometric construction, drawn dashed; "construction" in the legend unless it has a name
};

/// \ingroup PkgGeometricContinuityIO
/// How a curve is drawn, and what the legend calls it.
struct Svg_style {
  Svg_role role = Svg_role::given;  ///< the colour and width of the line
  bool control_polygon = false;     ///< with its control points, thin
  bool curvature_comb = false;      ///< with teeth as long as the curvature, see `Svg_figure`
  std::string name = std::string(); ///< plain text in UTF-8 for the legend; empty: the name of the role
};

namespace internal {

typedef Coordinate_vector<double, 3> Svg_point; // z = 0 for a planar curve

// The Bezier points and the style of a curve.
struct Svg_curve {
  std::vector<Svg_point> points;
  Svg_style style;
  int samples = 0; // parts in which a figure looks at it
};

// A join at the end of the curve with this index.
struct Svg_join {
  std::size_t curve;
  std::string label;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// One picture of an `Svg_figure`: curves, marked joins and a caption. A chain is written as it runs:
/// `panel.add(phi).join("G2").add(gamma, highlighted).join("G2").add(psi)`.
class Svg_panel {
public:
  /// Constructs a panel without curves. Captions and labels are plain text in UTF-8. Long captions are broken into lines.
  explicit Svg_panel(std::string caption = std::string()) : caption_(std::move(caption)) {}

  /// Adds a Bézier curve of dimension 2 or 3 over any kernel. The coordinates are rounded to `double` for the drawing.
  /// \tparam Curve a `Bezier_curve`, or a class with its `Traits`, `dimension()`, `degree()`, `begin()`, `end()` and
  ///   `coordinates(j)`
  /// \throws Error `dimension_mismatch` in dimension 1 or above 3
  /// \throws Error `wrong_number_of_points` unless there are `degree() + 1` control points (of a B-spline curve, add
  ///   the Bézier segments)
  /// \throws Error `not_finite` for a coordinate beyond the range of `double`, with the number of the curve in the panel
  template <class Curve> Svg_panel& add(const Curve& curve, const Svg_style& style = Svg_style()) {
    const int d = curve.dimension();
    if (d != 2 && d != 3)
      throw Error(Error_code::dimension_mismatch,
                  "Svg_panel: curves of dimension 2 or 3 can be drawn, not " + std::to_string(d));
    if (std::distance(curve.begin(), curve.end()) != curve.degree() + 1)
      throw Error(Error_code::wrong_number_of_points, "Svg_panel: only Bézier curves can be drawn");
    internal::Svg_curve drawn{std::vector<internal::Svg_point>(curve.degree() + 1, internal::Svg_point(3)), style, 0};
    for (int j = 0; j <= curve.degree(); ++j) {
      const Geometric_continuity::Coordinates<typename Curve::Traits> x = curve.coordinates(j);
      for (int i = 0; i < d; ++i) {
        drawn.points[j][i] = CGAL::to_double(x[i]);
        if (!std::isfinite(drawn.points[j][i]))
          throw Error(Error_code::not_finite, "Svg_panel: curve " + std::to_string(curves_.size() + 1) +
                                                  ": control point " + std::to_string(j + 1) +
                                                  " is too far away to be drawn");
      }
    }
    curves_.push_back(std::move(drawn));
    spatial_ = spatial_ || d == 3;
    return *this;
  }

  /// Marks the end of the curve added last as a join, with a short label such as "G2" beside it.
  /// \throws Error `wrong_number_of_points` in a panel without curves
  Svg_panel& join(std::string label = std::string()) {
    if (curves_.empty()) throw Error(Error_code::wrong_number_of_points, "Svg_panel: a join before the first curve");
    joins_.push_back({curves_.size() - 1, std::move(label)});
    return *this;
  }

private:
  friend class Svg_figure;

  std::string caption_;
  std::vector<internal::Svg_curve> curves_;
  std::vector<internal::Svg_join> joins_;
  bool spatial_ = false;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_PANEL_H
