// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_VIEWPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_VIEWPORT_H

/// Viewports of SVG: their sizes, and how the attributes `viewBox` and `preserveAspectRatio` map
/// into them.

#include "formats/svg/Svg_scanner.h"
#include "formats/svg/Svg_transform.h"
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace CGAL {
namespace Geometric_continuity {

// The size of the nearest viewport in its own units, as far as it is known: percentages are parts
// of it.
template <class FT> struct Svg_viewport {
  std::optional<FT> width, height;

  // Returns the size for lengths that are neither horizontal nor vertical, if the square root is
  // rational.
  std::optional<FT> diagonal() const {
    if (!width || !height) return std::nullopt;
    if (*width == *height) return width;
    return rational_square_root(FT((*width * *width + *height * *height) / FT(2)));
  }
};

template <class FT> struct Svg_view_box { FT x, y, width, height; };

/// Reads the attribute `viewBox`.
/// \throws Error `malformed_input` with a text `name, character N: reason`, also for a negative
///   size
template <class FT> Svg_view_box<FT> parse_svg_view_box(std::string_view text, const std::string& name = "viewBox") {
  Svg_scanner scanner(text, name);
  scanner.skip_space();
  Svg_view_box<FT> box;
  for (FT* x : {&box.x, &box.y, &box.width, &box.height}) {
    *x = scanner.template number<FT>();
    if ((x == &box.width || x == &box.height) && *x < FT(0)) scanner.refuse("negative");
  }
  scanner.refuse_comma();
  if (!scanner.at_end()) scanner.refuse(scanner.found() + " behind the four numbers");
  return box;
}

/// How a view box is placed in a viewport, the attribute `preserveAspectRatio`.
struct Svg_aspect_ratio {
  bool is_kept = true, fills = false; ///< fills: `slice`, the viewport is filled, instead of `meet`
  int x = 1, y = 1;                   ///< the halves of the room that are in front: 0, 1 or 2
};

/// Reads the attribute `preserveAspectRatio`.
/// \throws Error `malformed_input` with a text `name, character N: reason`
inline Svg_aspect_ratio parse_svg_aspect_ratio(std::string_view text, const std::string& name = "preserveAspectRatio") {
  Svg_scanner scanner(text, name);
  const auto word = [&] {
    scanner.skip_space();
    return std::string(scanner.word());
  };
  const std::string align = word();
  Svg_aspect_ratio result;
  result.is_kept = align != "none";
  if (result.is_kept) {
    const auto halves = [&](std::string_view part) {
      if (part != "Min" && part != "Mid" && part != "Max") scanner.refuse("'" + align + "' is not an alignment");
      return part == "Min" ? 0 : part == "Mid" ? 1 : 2;
    };
    const std::string_view view(align);
    if (view.size() != 8 || view[0] != 'x' || view[4] != 'Y') scanner.refuse("'" + align + "' is not an alignment");
    result.x = halves(view.substr(1, 3));
    result.y = halves(view.substr(5, 3));
  }
  const std::string scale = word();
  if (!scale.empty() && scale != "meet" && scale != "slice") scanner.refuse("'" + scale + "' is not meet or slice");
  result.fills = scale == "slice";
  scanner.skip_space();
  if (!scanner.at_end()) scanner.refuse(scanner.found() + " where the end is expected");
  return result;
}

/// Returns the map from a view box into a viewport of this size, whose corner is the origin.
/// \pre neither size of the box is zero
template <class Traits>
Svg_transform<Traits> svg_view_box_map(const Svg_view_box<typename Traits::FT>& box, const Svg_aspect_ratio& ratio,
                                       const typename Traits::FT& width, const typename Traits::FT& height) {
  typedef typename Traits::FT FT;
  FT x = FT(width / box.width), y = FT(height / box.height);
  if (ratio.is_kept) x = y = ratio.fills ? (std::max)(x, y) : (std::min)(x, y);
  const auto room = [&](const FT& outer, const FT& inner, int halves) -> FT {
    return ratio.is_kept ? FT((outer - inner) * FT(halves) / FT(2)) : FT(0);
  };
  return Svg_transform<Traits>({x, FT(0), FT(0), y, FT(room(width, FT(x * box.width), ratio.x) - x * box.x),
                                FT(room(height, FT(y * box.height), ratio.y) - y * box.y)});
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_VIEWPORT_H
