// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/svg/Drawing_document.h"

#include "formats/svg/Unpacked_bytes.h"
#include "formats/svg/Xml_entities.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#define XML_DTD // declares what Expat offers against entities that expand to more and more text
#include <expat.h>

#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace {

constexpr std::size_t max_depth = 256;
constexpr int first_block = 1 << 16, last_block = 1 << 28; // bytes

// Entities may expand to this many bytes, and a file that is longer to this many times its length.
constexpr unsigned long long free_expansion = 1 << 20;
constexpr float max_expansion = 10;

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

// Reads a drawing with Expat.
class Drawing_reader {
  const std::string file_;
  const Drawing_tags tags_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  Drawing_document document_;
  std::vector<std::size_t> open_; // the numbers of the open elements
  std::string sheet_;             // the text of the style sheet that is open
  Xml_entities entities_;
  bool has_doctype_ = false;
  std::exception_ptr error_;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw GC::Error(GC::Error_code::malformed_input, file_ + ':' + std::to_string(line()) + ": " + reason);
  }
  long long line() const { return static_cast<long long>(XML_GetCurrentLineNumber(parser_.get())); }

  // No exception may pass through the parser, which is written in C.
  template <class Action> static void guarded(void* self, Action action) {
    Drawing_reader& reader = *static_cast<Drawing_reader*>(self);
    if (reader.error_) return;
    try {
      action(reader);
    } catch (...) {
      reader.error_ = std::current_exception();
      XML_StopParser(reader.parser_.get(), XML_FALSE);
    }
  }

  static void on_start(void* self, const XML_Char* name, const XML_Char** attributes) {
    guarded(self, [&](Drawing_reader& reader) { reader.start(name, attributes); });
  }
  static void on_end(void* self, const XML_Char*) {
    guarded(self, [](Drawing_reader& reader) { reader.end(); });
  }
  static void on_text(void* self, const XML_Char* text, int length) {
    guarded(self, [&](Drawing_reader& reader) {
      if (reader.is_in_sheet()) reader.sheet_.append(text, static_cast<std::size_t>(length));
    });
  }
  static void on_instruction(void* self, const XML_Char* target, const XML_Char*) {
    guarded(self, [&](Drawing_reader& reader) {
      if (std::string_view(target) == "xml-stylesheet") reader.document_.outside_sheets.push_back(reader.line());
    });
  }
  static void on_doctype(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    static_cast<Drawing_reader*>(self)->has_doctype_ = true;
  }
  static void on_entity(void* self, const XML_Char* name, int is_parameter, const XML_Char* value, int length,
                        const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
    if (is_parameter != 0) return; // references to these are not followed
    guarded(self, [&](Drawing_reader& reader) {
      if (value == nullptr) return reader.entities_.declare_external(name);
      reader.refuse_if(reader.entities_.declare(name, std::string_view(value, static_cast<std::size_t>(length))));
    });
  }
  // Called before the value is passed.
  static void on_default_value(void* self, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char* value,
                               int) {
    guarded(self, [&](Drawing_reader& reader) {
      const std::string_view rest = reader.rest();
      if (value == nullptr || rest.size() < reader.length()) return;
      reader.refuse_if(reader.entities_.refusal_in_quoted(rest.substr(reader.length())));
    });
  }
  static void on_skipped_entity(void* self, const XML_Char* name, int) {
    guarded(self, [&](Drawing_reader& reader) { reader.refuse_if(reader.entities_.refusal(name)); });
  }
  static int on_external_entity(XML_Parser parser, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
    guarded(XML_GetUserData(parser), [](Drawing_reader& reader) {
      reader.refuse_if(reader.entities_.refusal_in(reader.piece()));
      reader.refuse("an entity stands in another file, which is not read");
    });
    return XML_STATUS_ERROR;
  }

  // Refuses what is not well-formed. Expat does not name the entity, which is the first one that is
  // not known.
  [[noreturn]] void refuse_error(XML_Error error) const {
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    if (error == XML_ERROR_UNDEFINED_ENTITY || error == XML_ERROR_ATTRIBUTE_EXTERNAL_ENTITY_REF)
      refuse_if(entities_.refusal_in(rest()));
    refuse(XML_ErrorString(error));
  }

  void refuse_if(const std::optional<std::string>& reason) const {
    if (reason) refuse(*reason);
  }

  // Returns the bytes that have been read from the place of the current call on.
  std::string_view rest() const {
    int offset = 0, size = 0;
    const char* const context = XML_GetInputContext(parser_.get(), &offset, &size);
    if (context == nullptr || size < offset) return std::string_view();
    return std::string_view(context + offset, static_cast<std::size_t>(size - offset));
  }

  // The bytes of the file to which the current call refers, such as a tag.
  std::size_t length() const { return static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get())); }
  std::string_view piece() const { return rest().substr(0, length()); }

  // The name without the namespace of SVG; other namespaces are left in front. Drawings without any
  // namespace are read.
  static std::string local_name(const std::string& name) {
    const std::string svg = "http://www.w3.org/2000/svg ";
    return name.compare(0, svg.size(), svg) == 0 ? name.substr(svg.size()) : name;
  }

  bool is_in_sheet() const { return !open_.empty() && document_.nodes[open_.back()].name == "style"; }

  void start(const std::string& full_name, const char** pairs) {
    std::vector<Drawing_node>& nodes = document_.nodes;
    const std::size_t number = nodes.size();
    // in attributes, Expat skips them in silence
    if (has_doctype_) refuse_if(entities_.refusal_in(piece()));
    if (open_.size() == max_depth) refuse("elements are nested deeper than " + std::to_string(max_depth));
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
    node.tag_begin = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get()));
    if (tags_ == Drawing_tags::all || tag.find('\n') != std::string_view::npos) node.tag = tag;
  }

  void end() {
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
  Drawing_reader(const std::string& file, Drawing_tags tags)
      : file_(file), tags_(tags), parser_(XML_ParserCreateNS(nullptr, ' '), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetProcessingInstructionHandler(parser_.get(), on_instruction);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
    XML_SetEntityDeclHandler(parser_.get(), on_entity);
    XML_SetAttlistDeclHandler(parser_.get(), on_default_value);
    XML_SetSkippedEntityHandler(parser_.get(), on_skipped_entity);
    XML_SetExternalEntityRefHandler(parser_.get(), on_external_entity);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(parser_.get(), free_expansion);
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(parser_.get(), max_expansion);
  }

  Drawing_document read(std::istream& stream) {
    Unpacked_bytes bytes(stream, file_);
    int size = first_block;
    XML_Index position = -1; // of the last tag that was begun
    for (bool last = false; !last;) {
      void* const block = XML_GetBuffer(parser_.get(), size);
      if (block == nullptr) throw std::bad_alloc();
      const std::size_t read = bytes.read(static_cast<char*>(block), static_cast<std::size_t>(size));
      last = read < static_cast<std::size_t>(size);
      const XML_Status status = XML_ParseBuffer(parser_.get(), static_cast<int>(read), last);
      if (error_) std::rethrow_exception(error_);
      if (status != XML_STATUS_OK) refuse_error(XML_GetErrorCode(parser_.get()));
      // a tag that is longer than a block is scanned again with the next one: longer blocks keep
      // that linear
      const XML_Index before = std::exchange(position, XML_GetCurrentByteIndex(parser_.get()));
      const bool stuck = position == before;
      if (stuck && size == last_block) refuse("a tag is longer than 256 MiB");
      size = stuck ? 2 * size : first_block;
    }
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
  Drawing_document document = Drawing_reader(name, tags).read(stream);
  document.finish();
  return document;
}
