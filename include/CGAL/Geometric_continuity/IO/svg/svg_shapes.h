// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_SHAPES_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_SHAPES_H

#include <CGAL/Geometric_continuity/IO/svg/internal/Svg_path_builder.h>
#include <CGAL/Geometric_continuity/IO/svg/internal/Svg_scanner.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The path of a basic shape of SVG, by the equivalent commands that SVG gives.
template <class Traits> class Svg_shape_builder {
  typedef typename Traits::FT FT;
  typedef Coordinate_vector<FT, 2> Coordinates;

  Svg_path_builder<Traits> builder_;

  static Coordinates point(const FT& x, const FT& y) {
    Coordinates p(2);
    p[0] = x;
    p[1] = y;
    return p;
  }

public:
  void move_to(const FT& x, const FT& y) {
    builder_.begin_command('M');
    builder_.move_to(point(x, y));
  }
  void line_to(const FT& x, const FT& y) {
    builder_.begin_command('L');
    builder_.line_to(point(x, y));
  }
  // a quarter of an ellipse, with growing angle
  void quarter_to(const FT& rx, const FT& ry, const FT& x, const FT& y) {
    builder_.begin_command('A');
    builder_.arc_to({rx, ry, FT(0), false, true}, point(x, y));
  }
  Svg_subpath<Traits> close() {
    builder_.begin_command('Z');
    builder_.close();
    return *builder_.take_complete();
  }
  Svg_subpath<Traits> end() {
    builder_.end();
    return builder_.take_complete().value_or(Svg_subpath<Traits>());
  }
};

template <class FT> void require_not_negative(const FT& x, const char* what) {
  if (x < FT(0)) throw Error(Error_code::malformed_input, std::string("negative ") + what);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// The path M L of a line.
template <class Traits>
Svg_subpath<Traits> svg_line(const typename Traits::FT& x1, const typename Traits::FT& y1,
                             const typename Traits::FT& x2, const typename Traits::FT& y2) {
  internal::Svg_shape_builder<Traits> path;
  path.move_to(x1, y1);
  path.line_to(x2, y2);
  return path.end();
}

/// \ingroup PkgGeometricContinuityIO
/// The path M L ... of a polyline or, with Z, of a polygon, from the attribute `points`.
/// \throws Error `malformed_input` with a text `name, character N: reason`
template <class Traits>
Svg_subpath<Traits> read_svg_polyline(std::string_view points, bool closed, const std::string& name = "points") {
  typedef typename Traits::FT FT;
  internal::Svg_scanner scanner(points, name);
  internal::Svg_shape_builder<Traits> path;
  scanner.skip_space();
  bool empty = true;
  for (; scanner.at_number(); empty = false) {
    const FT x = scanner.number<FT>(), y = scanner.number<FT>();
    if (empty)
      path.move_to(x, y);
    else
      path.line_to(x, y);
  }
  scanner.refuse_comma();
  if (!scanner.at_end()) scanner.refuse(scanner.found() + " where a number is expected");
  if (closed && !empty) return path.close();
  return path.end();
}

/// \ingroup PkgGeometricContinuityIO
/// The path of an ellipse, or of a circle: M, four quarters A, Z, from the point with the largest `x` on. Empty without
/// a radius. \throws Error `malformed_input` for a negative radius
template <class Traits>
Svg_subpath<Traits> svg_ellipse(const typename Traits::FT& cx, const typename Traits::FT& cy,
                                const typename Traits::FT& rx, const typename Traits::FT& ry) {
  typedef typename Traits::FT FT;
  internal::require_not_negative(rx, "radius");
  internal::require_not_negative(ry, "radius");
  if (rx == FT(0) || ry == FT(0)) return Svg_subpath<Traits>();
  internal::Svg_shape_builder<Traits> path;
  path.move_to(FT(cx + rx), cy);
  path.quarter_to(rx, ry, cx, FT(cy + ry));
  path.quarter_to(rx, ry, FT(cx - rx), cy);
  path.quarter_to(rx, ry, cx, FT(cy - ry));
  path.quarter_to(rx, ry, FT(cx + rx), cy);
  return path.close();
}

/// \ingroup PkgGeometricContinuityIO
/// The path of a rectangle, M L A ... Z, whose corners are rounded by quarters of ellipses unless a radius is zero. The
/// radii are at most half the size. Empty without a width or a height.
/// \throws Error `malformed_input` for a negative size or radius
template <class Traits>
Svg_subpath<Traits> svg_rectangle(const typename Traits::FT& x, const typename Traits::FT& y,
                                  const typename Traits::FT& width, const typename Traits::FT& height,
                                  const typename Traits::FT& corner_x, const typename Traits::FT& corner_y) {
  typedef typename Traits::FT FT;
  internal::require_not_negative(width, "width");
  internal::require_not_negative(height, "height");
  internal::require_not_negative(corner_x, "radius");
  internal::require_not_negative(corner_y, "radius");
  if (width == FT(0) || height == FT(0)) return Svg_subpath<Traits>();
  const bool sharp = corner_x == FT(0) || corner_y == FT(0);
  const FT right = FT(x + width), bottom = FT(y + height);
  const FT rx = sharp ? FT(0) : std::min(corner_x, FT(width / FT(2)));
  const FT ry = sharp ? FT(0) : std::min(corner_y, FT(height / FT(2)));
  const FT x1 = FT(x + rx), x2 = FT(right - rx), y1 = FT(y + ry), y2 = FT(bottom - ry);
  internal::Svg_shape_builder<Traits> path;
  const auto side = [&](const FT& from, const FT& to, const FT& u, const FT& v) {
    if (from != to) path.line_to(u, v);
  };
  path.move_to(x1, y);
  side(x1, x2, x2, y);
  if (!sharp) path.quarter_to(rx, ry, right, y1);
  side(y1, y2, right, y2);
  if (!sharp) path.quarter_to(rx, ry, x2, bottom);
  side(x1, x2, x1, bottom);
  if (!sharp) path.quarter_to(rx, ry, x, y2);
  if (!sharp) side(y1, y2, x, y1);
  if (!sharp) path.quarter_to(rx, ry, x1, y);
  return path.close();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_SVG_SVG_SHAPES_H
