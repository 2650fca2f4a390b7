// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_ATTRIBUTES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_ATTRIBUTES_H

#include "formats/svg/svg_drawing.h"

#include <cstddef>
#include <string>
#include <vector>

// The attribute d of a path in the text of a drawing.
struct Svg_path_attribute {
  Drawing_element element;
  std::string refusal;               // why it cannot be changed; empty when it can
  std::string value;                 // without references to characters
  std::vector<std::size_t> position; // in the text, of each character of the value and of what follows
};

// Returns the paths of a drawing, also those that are defined and not drawn, in order. Expects a text that read_svg_drawing() accepts.
std::vector<Svg_path_attribute> svg_path_attributes(const std::string& text, const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_ATTRIBUTES_H
