// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_ATTRIBUTES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_ATTRIBUTES_H

#include "formats/svg/Svg_viewport.h"
#include "formats/svg/svg_shapes.h"
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Drawing_number;
typedef GC::Svg_viewport<Drawing_number> Drawing_viewport;

// Thrown for an element that is not covered, with the reason.
struct Not_covered {
  std::string reason;
};

// The attributes of one element of a drawing. Their names are constants.
class Drawing_attributes {
  std::vector<std::pair<std::string_view, std::string>> values_;

public:
  // Adds an attribute, or changes its value. The text of the name must outlive this object.
  void set(std::string_view name, std::string value) {
    for (auto& attribute : values_)
      if (attribute.first == name) {
        attribute.second = std::move(value);
        return;
      }
    values_.emplace_back(name, std::move(value));
  }

  bool has(std::string_view name) const { return find(name) != nullptr; }

  // Returns the value, which is empty when the attribute is not given.
  const std::string& text(std::string_view name) const {
    static const std::string nothing;
    const std::string* const value = find(name);
    return value == nullptr ? nothing : *value;
  }

  // The length of all values in bytes.
  std::size_t size() const {
    std::size_t n = 0;
    for (const auto& attribute : values_) n += attribute.second.size();
    return n;
  }

  // Returns whether a value ends as percentages do.
  bool has_percentages() const {
    return std::any_of(values_.begin(), values_.end(), [](const auto& attribute) {
      return !attribute.second.empty() && attribute.second.back() == '%';
    });
  }

private:
  const std::string* find(std::string_view name) const {
    for (const auto& attribute : values_)
      if (attribute.first == name) return &attribute.second;
    return nullptr;
  }
};

// The lengths among the attributes of an element, in user units of its viewport.
class Drawing_lengths {
  const Drawing_attributes& attributes_;
  const Drawing_viewport& viewport_;

  // A length that is given; percentages are parts of `whole`.
  Drawing_number length(const char* name, const std::optional<Drawing_number>& whole) const {
    const std::string& text = attributes_.text(name);
    const std::optional<Drawing_number> length = GC::parse_svg_length<Drawing_number>(text, name, whole);
    if (!length)
      throw Not_covered{std::string(name) + "=\"" + text + "\" is relative to something that is not known here"};
    return *length;
  }
  Drawing_number length_or_zero(const char* name, const std::optional<Drawing_number>& whole) const {
    return attributes_.has(name) ? length(name, whole) : Drawing_number(0);
  }

  std::optional<Drawing_number> size(const char* name, const std::optional<Drawing_number>& whole) const {
    if (!is_given(name)) return std::nullopt;
    const Drawing_number x = length(name, whole);
    if (x < 0) throw Not_covered{std::string(name) + ": negative"};
    return x;
  }

public:
  // The lengths of the attributes refer to both objects, which must outlive this one.
  Drawing_lengths(const Drawing_attributes& attributes, const Drawing_viewport& viewport)
      : attributes_(attributes), viewport_(viewport) {}

  // Returns whether a size is given, and is not `auto`.
  bool is_given(const char* name) const { return attributes_.has(name) && attributes_.text(name) != "auto"; }

  // Horizontal and vertical coordinates; 0 when they are not given.
  Drawing_number x(const char* name) const { return length_or_zero(name, viewport_.width); }
  Drawing_number y(const char* name) const { return length_or_zero(name, viewport_.height); }

  // Sizes, which are not negative; nothing when they are not given, or `auto`.
  std::optional<Drawing_number> width(const char* name) const { return size(name, viewport_.width); }
  std::optional<Drawing_number> height(const char* name) const { return size(name, viewport_.height); }
  std::optional<Drawing_number> radius(const char* name) const { return size(name, viewport_.diagonal()); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_ATTRIBUTES_H
