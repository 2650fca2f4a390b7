// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_FRAME_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_FRAME_H

#include "formats/svg/Css_transform.h"
#include "formats/svg/Drawing_document.h"
#include "formats/svg/Svg_viewport.h"
#include "formats/svg/svg_drawing.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

typedef GC::Svg_transform<Drawing_traits> Drawing_map;

// The coordinates in which what stands in an element is written: the map to those of the drawing,
// and the nearest viewport.
struct Drawing_frame {
  Drawing_map map;
  Drawing_viewport viewport;
  bool is_filled = true; // as elements are where nothing else is said

  // Returns the frame of which the coordinates are mapped to those of this one. Throws GC::Error
  // when the product of the maps is not possible.
  Drawing_frame inner(const Drawing_map& inner_map) const { return {map * inner_map, viewport, is_filled}; }
};

// The size that a use element gives to the viewport that it repeats.
struct Repeated_size {
  std::optional<Drawing_number> width, height;
};

// Returns whether an element has a transform of its own, by its attribute or its style.
inline bool has_transform(const Drawing_attributes& a) {
  const std::string& text = a.has("style transform") ? a.text("style transform") : a.text("transform");
  return !text.empty() && text != "none";
}

// Returns the attributes of an element with what its own style sets in their place; transforms in a
// style have names of their own. Throws GC::Error and Not_covered for what is not decided.
inline Drawing_attributes styled_attributes(const Drawing_node& node, const Style_sheets& sheets, bool is_outermost) {
  Drawing_attributes attributes = node.attributes;
  const std::vector<Style_declaration> style = style_declarations(node.attributes.text("style"));
  const bool has_transforms =
      has_transform(attributes) || std::any_of(style.begin(), style.end(), [](const Style_declaration& d) {
        return d.name.find("transform", d.name.size() < 9 ? 0 : d.name.size() - 9) != std::string::npos;
      });
  for (const Style_declaration& d : style) {
    if (!sheets.changes(d, is_outermost ? std::string_view() : node.name, has_transforms)) continue;
    const std::string place = "style, " + d.name;
    const std::string name = d.name.compare(0, 8, "-webkit-") == 0 ? d.name.substr(8) : d.name;
    // others are read in many ways
    const bool is_shape = node.name == "rect" || node.name == "circle" || node.name == "ellipse";
    const auto length = [&](const char* property) {
      if (name != property || !is_shape) return false;
      if (d.value != "auto") GC::parse_css_length<Drawing_number>(d.value, place, Drawing_number(1));
      attributes.set(property, d.value);
      return true;
    };
    if (name == "transform")
      attributes.set("style transform", d.value == "initial" || d.value == "unset" ? "none" : d.value);
    else if (name == "transform-origin")
      attributes.set("style transform-origin", d.value);
    else if (name == "transform-box")
      attributes.set("style transform-box", d.value);
    else if (name == "d" && d.value == "none")
      attributes.set("d", d.value);
    else if (!length("cx") && !length("cy") && !length("r") && !length("rx") && !length("ry") && !length("x") &&
             !length("y") && !length("width") && !length("height") && d.value != "none")
      throw Not_covered{place + " is not read"};
  }
  return attributes;
}

// The map of the transform of an element, of which the attributes are styled_attributes(). Throws
// GC::Error and Not_covered.
inline Drawing_map own_transform(const Drawing_attributes& a, const Drawing_viewport& viewport) {
  if (!has_transform(a)) return Drawing_map();
  const Drawing_map map =
      a.has("style transform")
          ? GC::parse_css_transform<Drawing_traits>(a.text("style transform"), "style, transform", viewport)
          : GC::parse_svg_transform<Drawing_traits>(a.text("transform"));
  const bool styled_box = a.has("style transform-box"), styled_origin = a.has("style transform-origin");
  const std::string& box = a.text(styled_box ? "style transform-box" : "transform-box");
  if (!box.empty() && box != "view-box") throw Not_covered{"transform-box: " + box + " is not read"};
  if (!styled_origin && !a.has("transform-origin")) return map;
  const std::array<Drawing_number, 2> origin = GC::parse_css_origin<Drawing_number>(
      a.text(styled_origin ? "style transform-origin" : "transform-origin"), "transform-origin", viewport,
      styled_origin ? GC::Css_units::needed : GC::Css_units::optional);
  typedef GC::Svg_transform_product<Drawing_traits> Product;
  return Product::translation(origin[0], origin[1]) * map *
         Product::translation(Drawing_number(-origin[0]), Drawing_number(-origin[1]));
}

// The viewport of the outermost element svg, in the coordinates of its contents.
inline Drawing_viewport outermost_viewport(const Drawing_attributes& a) {
  const auto known = [](auto read) -> std::optional<Drawing_number> {
    try {
      return read();
    } catch (const GC::Error&) { // then it is as if it were not given
      return std::nullopt;
    }
  };
  if (a.has("viewBox")) {
    const auto box = [&] { return GC::parse_svg_view_box<Drawing_number>(a.text("viewBox")); };
    return {known([&] { return box().width; }), known([&] { return box().height; })};
  }
  const auto length = [&](const char* name) {
    return known([&] { return a.has("style") ? std::nullopt : GC::parse_svg_length<Drawing_number>(a.text(name)); });
  };
  return {length("width"), length("height")};
}

// The frame of what stands in an inner element svg, or in a symbol that is repeated. Throws
// GC::Error and Not_covered.
inline Drawing_frame inner_frame(const Drawing_frame& outer, const Drawing_attributes& a, const Repeated_size& given) {
  const Drawing_lengths lengths(a, outer.viewport);
  const auto size = [](const std::optional<Drawing_number>& given_size, const std::optional<Drawing_number>& own,
                       const std::optional<Drawing_number>& whole) {
    return given_size ? given_size : own ? own : whole;
  };
  const std::optional<Drawing_number> width = size(given.width, lengths.width("width"), outer.viewport.width),
                                      height = size(given.height, lengths.height("height"), outer.viewport.height);
  if ((width && *width == 0) || (height && *height == 0))
    throw Not_covered{"it is not drawn, because its viewport has no area"};
  Drawing_frame frame =
      outer.inner(GC::Svg_transform_product<Drawing_traits>::translation(lengths.x("x"), lengths.y("y")));
  frame.viewport = {width, height};
  if (!a.has("viewBox")) return frame;
  const auto box = GC::parse_svg_view_box<Drawing_number>(a.text("viewBox"));
  if (box.width == 0 || box.height == 0) throw Not_covered{"it is not drawn, because its view box has no area"};
  if (!width || !height) throw Not_covered{"the size of its viewport is not known here"};
  const GC::Svg_aspect_ratio ratio =
      a.has("preserveAspectRatio") ? GC::parse_svg_aspect_ratio(a.text("preserveAspectRatio")) : GC::Svg_aspect_ratio();
  frame = frame.inner(GC::svg_view_box_map<Drawing_traits>(box, ratio, *width, *height));
  frame.viewport = {box.width, box.height};
  return frame;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_FRAME_H
