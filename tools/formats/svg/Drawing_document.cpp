// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/svg/Drawing_document.h"

#include "formats/xml/Xml_reader.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <set>
#include <utility>

namespace {

// The attributes that are kept, of all elements.
const std::set<std::string_view> kept_attributes{"id",
                                                 "fill",
                                                 "class",
                                                 "d",
                                                 "points",
                                                 "x",
                                                 "y",
                                                 "width",
                                                 "height",
                                                 "x1",
                                                 "y1",
                                                 "x2",
                                                 "y2",
                                                 "cx",
                                                 "cy",
                                                 "r",
                                                 "rx",
                                                 "ry",
                                                 "style",
                                                 "viewBox",
                                                 "preserveAspectRatio",
                                                 "transform",
                                                 "href",
                                                 "transform-origin",
                                                 "transform-box",
                                                 "attributeName",
                                                 "type"};

// Reads a drawing.
class Drawing_reader : public Xml_reader {
  const Drawing_tags tags_;
  Drawing_document document_;
  std::vector<std::size_t> open_; // the numbers of the open elements
  std::string sheet_;             // the text of the style sheet that is open

  // The name without the namespace of SVG; other namespaces are left in front. Drawings without any
  // namespace are read.
  static std::string local_name(const std::string& name) {
    const std::string svg = "http://www.w3.org/2000/svg ";
    return name.compare(0, svg.size(), svg) == 0 ? name.substr(svg.size()) : name;
  }

  bool is_in_sheet() const { return !open_.empty() && document_.nodes[open_.back()].name == "style"; }

  void start(const std::string& full_name, const char** pairs) override {
    std::vector<Drawing_node>& nodes = document_.nodes;
    const std::size_t number = nodes.size();
    Drawing_node node;
    node.name = document_.name(local_name(full_name));
    if (open_.empty() && node.name != "svg") refuse("the root element is " + GC::quoted_token(node.name) + ", not svg");
    node.line = line();
    node.parent = open_.empty() ? number : open_.back();
    node.bytes_before = document_.bytes;
    read_attributes(node.attributes, pairs);
    if (node.name == "path" || tags_ == Drawing_tags::all) read_tag(node);
    if (node.name == "style") sheet_.clear();
    document_.bytes += sizeof(Drawing_node) + node.attributes.size();
    nodes.push_back(std::move(node));
    open_.push_back(number);
  }

  static void read_attributes(Drawing_attributes& attributes, const char** pairs) {
    const std::string_view xlink_href = "http://www.w3.org/1999/xlink href";
    for (; *pairs != nullptr; pairs += 2) {
      const std::string_view name = pairs[0], value = pairs[1];
      if (name == xlink_href) {
        if (!attributes.has("href")) attributes.set("href", std::string(value));
      } else if (name == "style") {
        const std::string text = Style_text::without_comments(value);
        if (may_change_outlines(text)) attributes.set("style", text);
        for (const Style_declaration& d : style_declarations(text))
          if (d.name == "fill") attributes.set("style fill", d.value);
      } else if (const auto kept = kept_attributes.find(name); kept != kept_attributes.end())
        attributes.set(*kept, std::string(value));
    }
  }

  // Returns whether one of the declarations may; most of those that editors write do not, and are
  // not kept.
  static bool may_change_outlines(const std::string& style) {
    for (const Style_declaration& d : style_declarations(style))
      for (const char* element : {"path", "circle", "rect"})
        if (style_effect(d.name, element) != Style_effect::none) return true;
    return false;
  }

  void read_tag(Drawing_node& node) const {
    const std::string_view tag = piece();
    node.tag_begin = byte();
    if (tags_ == Drawing_tags::all || tag.find('\n') != std::string_view::npos) node.tag = tag;
  }

  void text(std::string_view text) override {
    if (is_in_sheet()) sheet_.append(text);
  }
  void instruction(std::string_view target) override {
    if (target == "xml-stylesheet") document_.outside_sheets.push_back(line());
  }

  void end() override {
    Drawing_node& node = document_.nodes[open_.back()];
    if (node.name == "style") {
      const std::string& type = node.attributes.text("type");
      if (type.empty() || type == "text/css") document_.sheets.add(sheet_, node.line);
    }
    if (node.name == "style") document_.sheets_set_fill |= sheet_.find("fill") != std::string::npos;
    node.end = document_.nodes.size();
    open_.pop_back();
  }

public:
  Drawing_reader(const std::string& file, Drawing_tags tags) : Xml_reader(file), tags_(tags) {}

  Drawing_document document(std::istream& stream) {
    read(stream);
    return std::move(document_);
  }
};

// Does the animation move the outlines of the element that contains it, or to which it refers?
bool moves_outlines(const Drawing_node& node) {
  if (node.name == "animateMotion" || node.name == "animateTransform") return true;
  if (node.name != "animate" && node.name != "set") return false;
  static const std::set<std::string_view> moving{
      "d",         "points", "x",     "y",     "width",   "height",    "x1",
      "y1",        "x2",     "y2",    "cx",    "cy",      "r",         "rx",
      "ry",        "href",   "style", "class", "viewBox", "transform", "preserveAspectRatio",
      "xlink:href"};
  return moving.count(node.attributes.text("attributeName")) != 0;
}

} // namespace

void Drawing_document::mark_animated(std::size_t i) {
  const Drawing_node& node = nodes[i];
  if (!moves_outlines(node)) return;
  const std::size_t moved = node.attributes.has("href") ? find(reference(node)) : node.parent;
  if (moved != nodes.size() && nodes[moved].animated_in_line == 0) nodes[moved].animated_in_line = node.line;
}

bool is_skipped_in_drawings(std::string_view name) {
  static const std::set<std::string_view> skipped{
      "defs",           "symbol",         "clipPath", "mask",   "marker", "pattern", "style",
      "linearGradient", "radialGradient", "filter",   "script", "title",  "desc",    "metadata",
      "foreignObject",  "flowRoot",       "font",     "text",   "image"};
  return skipped.count(name) != 0 || name.find(' ') != std::string_view::npos;
}

Drawing_document read_drawing_document(std::istream& stream, const std::string& name, Drawing_tags tags) {
  Drawing_document document = Drawing_reader(name, tags).document(stream);
  document.finish();
  return document;
}
