// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SHAPES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SHAPES_H

/// The basic shapes of SVG as paths, by the equivalent commands that SVG gives, and the lengths in
/// their attributes.

#include "formats/svg/Svg_path_builder.h"
#include "formats/svg/Svg_scanner.h"
#include "formats/svg/svg_size.h"
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

// The path of a basic shape of SVG, by the equivalent commands that SVG gives.
template <class Traits> class Svg_shape_builder {
  typedef typename Traits::FT FT;
  typedef Coordinate_vector<FT, 2> Coordinates;

  Svg_path_builder<Traits> builder_;

  static Coordinates point(const FT& x, const FT& y) {
    Coordinates p(2);
    p[0] = x;
    p[1] = y;
    for (int i = 0; i < 2; ++i) check_svg_finite(p[i], "shape of SVG");
    return p;
  }

public:
  void move_to(const FT& x, const FT& y) {
    builder_.begin_command('M', 0);
    builder_.move_to(point(x, y));
  }
  void line_to(const FT& x, const FT& y) {
    builder_.begin_command('L', 0);
    builder_.line_to(point(x, y));
  }
  // Draws a quarter of an ellipse, with growing angle.
  void quarter_to(const FT& rx, const FT& ry, const FT& x, const FT& y) {
    builder_.begin_command('A', 0);
    builder_.arc_to({rx, ry, FT(0), false, true}, point(x, y));
  }
  Svg_subpath<Traits> close() {
    builder_.begin_command('Z', 0);
    builder_.close();
    return *builder_.take_complete();
  }
  Svg_subpath<Traits> end() {
    builder_.end();
    return builder_.take_complete().value_or(Svg_subpath<Traits>());
  }
};

template <class FT> void require_not_negative(const FT& x, const char* what) {
  check_svg_finite(x, what);
  if (x < FT(0)) throw Error(Error_code::malformed_input, std::string("negative ") + what);
}

enum class Svg_outline { open, closed };

// The path of a list of points. Where `error` is given, the path up to an error, which is open, is
// returned with the reason.
template <class Traits>
Svg_subpath<Traits> read_svg_points(std::string_view points, Svg_outline outline, const std::string& name,
                                    std::string* error) {
  typedef typename Traits::FT FT;
  Svg_scanner scanner(points, name);
  Svg_shape_builder<Traits> path;
  bool empty = true;
  try {
    scanner.skip_space();
    for (; scanner.at_number(); empty = false) {
      const FT x = scanner.number<FT>(), y = scanner.number<FT>();
      if (empty)
        path.move_to(x, y);
      else
        path.line_to(x, y);
    }
    scanner.refuse_comma();
    if (!scanner.at_end()) scanner.refuse(scanner.found() + " where a number is expected");
  } catch (const Error& e) {
    if (error == nullptr) throw;
    *error = svg_reason(e);
    return path.end();
  }
  return outline == Svg_outline::closed && !empty ? path.close() : path.end();
}

/// Returns a length, the text of an attribute such as `width`, in user units: a number as
/// `parse_number()` reads it, directly followed by nothing or by one of CSS's units `px`, `in`,
/// `cm`, `mm`, `q`, `pt` and `pc`, in capital or small letters, of which 96 `px` are one `in`, or
/// by `%`, of which 100 are the length `whole`; white space may surround both. The result is empty
/// for a length other than 0 that has no meaning without a viewport or a font: in `%` where `whole`
/// is not given, `em`, `ex`, `ch`, `ic`, `rem`, `lh`, `vw`, `vh`, `vi`, `vb`, `vmin` or `vmax`.
/// \throws Error `malformed_input` with a text `name, character N: reason`; in an exact field for a
///   number of more than `max_svg_number_bits` bits, too
template <class FT>
std::optional<FT> parse_svg_length(std::string_view text, const std::string& name = "length",
                                   const std::optional<FT>& whole = std::nullopt) {
  Svg_scanner scanner(text, name);
  scanner.skip_space();
  const FT x = scanner.leading_number<FT>();
  const std::string given(scanner.rest());
  std::string unit = given;
  for (char& c : unit)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto scaled = [&](int numerator, int denominator) -> FT {
    const FT length = FT(FT(x * FT(numerator)) / FT(denominator));
    if constexpr (std::is_floating_point_v<FT>)
      if (!std::isfinite(length)) scanner.refuse("a length outside the range of floating-point numbers");
    return length;
  };
  if (unit.empty() || unit == "px") return x;
  if (unit == "in") return scaled(96, 1);
  if (unit == "cm") return scaled(9600, 254);
  if (unit == "mm") return scaled(960, 254);
  if (unit == "q") return scaled(240, 254);
  if (unit == "pt") return scaled(4, 3);
  if (unit == "pc") return scaled(16, 1);
  if (unit == "%" && whole) return FT(FT(x * *whole) / FT(100));
  for (const char* relative : {"%", "em", "ex", "ch", "ic", "rem", "lh", "vw", "vh", "vi", "vb", "vmin", "vmax"})
    if (unit == relative) return x == FT(0) ? std::optional<FT>(x) : std::nullopt;
  scanner.refuse(quoted_token(given) + " is not a unit of length");
}

/// Returns the path M L of a line.
/// \throws Error `not_finite` for a coordinate that is not finite
template <class Traits>
Svg_subpath<Traits> svg_line(const typename Traits::FT& x1, const typename Traits::FT& y1,
                             const typename Traits::FT& x2, const typename Traits::FT& y2) {
  Svg_shape_builder<Traits> path;
  path.move_to(x1, y1);
  path.line_to(x2, y2);
  return path.end();
}

/// Returns the path M L ... of a polyline, from the text of the attribute `points`. Where `error`
/// is given, it receives the text of an error, and the path up to there is returned.
/// \throws Error `malformed_input` with a text `name, character N: reason`, unless `error` is given
template <class Traits>
Svg_subpath<Traits> read_svg_polyline(std::string_view points, const std::string& name = "points",
                                      std::string* error = nullptr) {
  return read_svg_points<Traits>(points, Svg_outline::open, name, error);
}

/// Returns the path M L ... Z of a polygon, as `read_svg_polyline()` does; the path up to an error
/// is not closed.
/// \throws Error `malformed_input` with a text `name, character N: reason`, unless `error` is given
template <class Traits>
Svg_subpath<Traits> read_svg_polygon(std::string_view points, const std::string& name = "points",
                                     std::string* error = nullptr) {
  return read_svg_points<Traits>(points, Svg_outline::closed, name, error);
}

/// Returns the path of an ellipse, or of a circle: M, four quarters A, Z, from the point with the
/// largest `x` on. It is empty when a radius is zero.
/// \throws Error `malformed_input` for a negative radius; `not_finite` for a number that is not
///   finite
template <class Traits>
Svg_subpath<Traits> svg_ellipse(const typename Traits::FT& cx, const typename Traits::FT& cy,
                                const typename Traits::FT& rx, const typename Traits::FT& ry) {
  typedef typename Traits::FT FT;
  require_not_negative(rx, "radius");
  require_not_negative(ry, "radius");
  if (rx == FT(0) || ry == FT(0)) return Svg_subpath<Traits>();
  Svg_shape_builder<Traits> path;
  path.move_to(FT(cx + rx), cy);
  path.quarter_to(rx, ry, cx, FT(cy + ry));
  path.quarter_to(rx, ry, FT(cx - rx), cy);
  path.quarter_to(rx, ry, cx, FT(cy - ry));
  path.quarter_to(rx, ry, FT(cx + rx), cy);
  return path.close();
}

/// Returns the path of a rectangle, M L A ... Z, whose corners are rounded by quarters of ellipses
/// unless a radius is zero. Radii of more than half the size are reduced to that. It is empty when
/// the width or the height is zero.
/// \throws Error `malformed_input` for a negative size or radius; `not_finite` for a number that is
///   not finite
template <class Traits>
Svg_subpath<Traits> svg_rectangle(const typename Traits::FT& x, const typename Traits::FT& y,
                                  const typename Traits::FT& width, const typename Traits::FT& height,
                                  const typename Traits::FT& corner_x, const typename Traits::FT& corner_y) {
  typedef typename Traits::FT FT;
  require_not_negative(width, "width");
  require_not_negative(height, "height");
  require_not_negative(corner_x, "radius");
  require_not_negative(corner_y, "radius");
  if (width == FT(0) || height == FT(0)) return Svg_subpath<Traits>();
  const bool sharp = corner_x == FT(0) || corner_y == FT(0);
  const FT right = FT(x + width), bottom = FT(y + height);
  const FT rx = sharp ? FT(0) : (std::min)(corner_x, FT(width / FT(2)));
  const FT ry = sharp ? FT(0) : (std::min)(corner_y, FT(height / FT(2)));
  const FT x1 = FT(x + rx), x2 = FT(right - rx), y1 = FT(y + ry), y2 = FT(bottom - ry);
  Svg_shape_builder<Traits> path;
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

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SHAPES_H
