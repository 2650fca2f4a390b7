// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_DOCUMENT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_DOCUMENT_H

#include "formats/svg/Drawing_attributes.h"
#include "formats/svg/Style_sheets.h"

#include <cstddef>
#include <istream>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

// An element of a drawing as it is written, with the attributes that matter for outlines.
struct Drawing_node {
  std::string_view name; // without the namespace of SVG; other namespaces are left in front
  long long line = 0;
  std::size_t parent = 0;         // the number of the element that holds it; its own of the root
  std::size_t end = 0;            // the number behind the last element that it holds
  std::size_t bytes_before = 0;   // a measure of what is written before it
  long long animated_in_line = 0; // where an element stands that moves it; 0 where there is none
  Drawing_attributes attributes;
  // as it is written: of a path where that is needed for its lines, otherwise with
  // Drawing_tags::all
  std::string tag;
  std::size_t tag_begin = 0; // in the file
};

// The parts of a drawing that are kept besides its elements.
enum class Drawing_tags { with_lines, all };

// The elements of a drawing, in the order of the file: an element stands before those that it
// holds.
class Drawing_document {
  std::set<std::string> names_;                           // of elements
  std::unordered_map<std::string_view, std::size_t> ids_; // of the first element of each id

public:
  std::vector<Drawing_node> nodes;
  std::vector<long long> outside_sheets; // the lines that refer to style sheets in other files
  Style_sheets sheets;
  bool sheets_set_fill = false; // one of them gives the property `fill` to something
  std::size_t bytes = 0;        // a measure of all that is written

  // Returns the number of the element with an id, or nodes.size().
  std::size_t find(std::string_view id) const {
    const auto found = ids_.find(id);
    return found == ids_.end() ? nodes.size() : found->second;
  }

  // Returns a name of elements that outlives them.
  std::string_view name(const std::string& text) { return *names_.insert(text).first; }

  // Tells that all elements have been added.
  void finish() {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].attributes.has("id")) ids_.emplace(nodes[i].attributes.text("id"), i);
    for (std::size_t i = 0; i < nodes.size(); ++i) mark_animated(i);
  }

  // Returns the id to which an element refers, with the attribute `href`; empty where it refers to
  // another file or to nothing.
  static std::string_view reference(const Drawing_node& node) {
    const std::string_view text = Style_text::trimmed(node.attributes.text("href"));
    return text.substr(0, 1) == "#" ? text.substr(1) : std::string_view();
  }

private:
  void mark_animated(std::size_t i);
};

// Returns whether an element is drawn by reference, or not at all, with everything in it.
bool is_skipped_in_drawings(std::string_view name);

// Reads all elements of a drawing, as read_svg_drawing() says.
Drawing_document read_drawing_document(std::istream& stream, const std::string& name, Drawing_tags tags);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_DRAWING_DOCUMENT_H
