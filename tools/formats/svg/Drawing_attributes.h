// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_ATTRIBUTES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_ATTRIBUTES_H

#include "formats/svg/svg_shapes.h"
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Drawing_number;

// Thrown for a length that has no meaning without a viewport or a font.
struct Relative_length {
  std::string text;
};

// The attributes of one element of a drawing.
class Drawing_attributes {
  std::map<std::string, std::string> values_;
  std::string place_; // of the element, for messages

public:
  Drawing_attributes(const char** pairs, std::string place) : place_(std::move(place)) {
    for (; *pairs != nullptr; pairs += 2) values_.emplace(pairs[0], pairs[1]);
  }

  bool has(const std::string& name) const { return values_.count(name) != 0; }
  std::string text(const std::string& name) const { return has(name) ? values_.at(name) : std::string(); }
  std::string place() const { return place_; }
  std::string place(const std::string& name) const { return place_ + ", " + name; }

  // A length in user units; 0 when it is not given.
  Drawing_number length(const std::string& name) const {
    if (!has(name)) return Drawing_number(0);
    const std::optional<Drawing_number> length = GC::parse_svg_length<Drawing_number>(text(name), place(name));
    if (!length) throw Relative_length{name + "=\"" + text(name) + '"'};
    return *length;
  }

  // A length that is not negative.
  Drawing_number size(const std::string& name) const {
    const Drawing_number x = length(name);
    if (x < 0) throw GC::Error(GC::Error_code::malformed_input, place(name) + ": negative");
    return x;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_ATTRIBUTES_H
