// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/svg/svg_drawing.h"

#include "files/input.h"
#include "formats/svg/Drawing_attributes.h"
#include "formats/svg/Unpacked_bytes.h"
#include "formats/svg/Xml_entities.h"

#include "formats/svg/Svg_transform.h"
#include "formats/svg/read_svg_path.h"
#include "formats/svg/svg_shapes.h"
#include <CGAL/Geometric_continuity/IO/text.h>

#define XML_DTD // declares what Expat offers against entities that expand to more and more text
#include <expat.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace {

typedef GC::Svg_transform<Drawing_traits> Transform;

constexpr std::size_t max_depth = 256;
constexpr int first_block = 1 << 16, last_block = 1 << 28; // bytes

// Entities may expand to this many bytes, and a file that is longer to this many times its length.
constexpr unsigned long long free_expansion = 1 << 20;
constexpr float max_expansion = 10;

// Elements that are drawn by reference or not at all, with everything in them.
const std::set<std::string> skipped{"defs",     "symbol", "clipPath",       "mask",           "marker",
                                    "pattern",  "style",  "linearGradient", "radialGradient", "filter",
                                    "script",   "title",  "desc",           "metadata",       "foreignObject",
                                    "flowRoot", "font",   "text",           "image"};

// The largest number of digits behind the point, when exponents are written out.
int most_decimals(std::string_view text) {
  int most = 0;
  const char *p = text.data(), *const end = p + text.size();
  const auto digit = [&] { return p != end && '0' <= *p && *p <= '9'; };
  while (p != end) {
    if (!digit() && *p != '.') {
      ++p;
      continue;
    }
    int decimals = 0, exponent = 0;
    while (digit()) ++p;
    if (p != end && *p == '.')
      for (++p; digit(); ++p) ++decimals;
    if (p != end && (*p == 'e' || *p == 'E')) {
      ++p;
      if (p != end && *p == '+') ++p;
      p = std::from_chars(p, end, exponent).ptr;
    }
    most = (std::max)(most, decimals - exponent);
  }
  return most;
}

// Reads a drawing with Expat: keeps the transforms of the open elements, and hands on the subpaths of each.
class Drawing_reader {
  const std::string file_;
  Drawing_handler& handler_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::vector<Transform> transforms_;        // of the open elements that are read
  std::size_t depth_ = 0, skipped_from_ = 0; // the depth of the element that is skipped with all in it, or 0
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

  // Refuses what is not well-formed. Expat does not name the entity, which is the first one that is not known.
  [[noreturn]] void refuse_error(XML_Error error) const {
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    if (error == XML_ERROR_UNDEFINED_ENTITY || error == XML_ERROR_ATTRIBUTE_EXTERNAL_ENTITY_REF)
      refuse_if(entities_.refusal_in(rest()));
    refuse(XML_ErrorString(error));
  }

  void refuse_if(const std::optional<std::string>& reason) const {
    if (reason) refuse(*reason);
  }

  // What has been read of the file from the place on to which the current call refers.
  std::string_view rest() const {
    int offset = 0, size = 0;
    const char* const context = XML_GetInputContext(parser_.get(), &offset, &size);
    if (context == nullptr || size < offset) return std::string_view();
    return std::string_view(context + offset, static_cast<std::size_t>(size - offset));
  }

  // The bytes of the file to which the current call refers, such as a tag.
  std::size_t length() const { return static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get())); }
  std::string_view piece() const { return rest().substr(0, length()); }

  // The name without the namespace of SVG; other namespaces are left in front. Drawings without any namespace are read.
  static std::string local_name(const std::string& name) {
    const std::string svg = "http://www.w3.org/2000/svg ";
    return name.compare(0, svg.size(), svg) == 0 ? name.substr(svg.size()) : name;
  }

  void start(const std::string& full_name, const char** pairs) {
    const std::string name = local_name(full_name);
    ++depth_;
    if (has_doctype_) refuse_if(entities_.refusal_in(piece())); // in attributes, Expat skips them in silence
    if (depth_ > max_depth) refuse("elements are nested deeper than " + std::to_string(max_depth));
    if (skipped_from_ != 0) return define(name, pairs);
    if (depth_ == 1 && name != "svg") refuse("the root element is " + GC::quoted_token(name) + ", not svg");
    if (skipped.count(name) != 0 || name.find(' ') != std::string::npos) {
      skipped_from_ = depth_;
      return;
    }
    Drawing_element element{file_, name, "", line()};
    const Drawing_attributes attributes = read(element, pairs);
    transforms_.push_back(transforms_.empty() ? Transform() : transforms_.back());
    if (attributes.has("transform") && attributes.text("transform") != "none") transform(attributes);
    element.transform = transforms_.back();
    for (const char* numbers : {"d", "points"})
      if (attributes.has(numbers)) element.decimals = most_decimals(attributes.text(numbers));
    try {
      draw(element, attributes);
    } catch (const Relative_length& length) {
      handler_.not_read(element, length.text + " is relative to something that is not known here");
    } catch (const GC::Error& error) {
      if (error.code() != GC::Error_code::work_limit) throw;
      throw GC::Error(error.code(), attributes.place() + ": " + GC::svg_reason(error));
    }
  }

  // The attributes of an element, and its id.
  Drawing_attributes read(Drawing_element& element, const char** pairs) const {
    for (const char** p = pairs; *p != nullptr && element.id.empty(); p += 2)
      if (std::string_view(*p) == "id") element.id = p[1];
    return Drawing_attributes(pairs, file_ + ':' + std::to_string(element.line) + ": " + element.name +
                                         (element.id.empty() ? "" : " \"" + element.id + '"'));
  }

  // An element that is defined and not drawn.
  void define(const std::string& name, const char** pairs) {
    if (name != "path" || !handler_.takes_paths()) return;
    Drawing_element element{file_, name, "", line()};
    const Drawing_attributes attributes = read(element, pairs);
    if (attributes.has("d")) hand_on(element, attributes, attributes.text("d"), false);
  }

  void hand_on(const Drawing_element& element, const Drawing_attributes& attributes, const std::string& value,
               bool is_drawn) const {
    const Attribute_text text(piece(), static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())), "d", value);
    handler_.path(element, {value, attributes.place("d"), text, is_drawn});
  }

  void transform(const Drawing_attributes& attributes) {
    const std::string place = attributes.place("transform");
    const Transform inner = GC::parse_svg_transform<Drawing_traits>(attributes.text("transform"), place);
    try {
      transforms_.back() = transforms_.back() * inner;
    } catch (const GC::Error& error) {
      throw GC::Error(error.code(), place + ", with the groups around: " + GC::svg_reason(error));
    }
  }

  void end() {
    if (skipped_from_ == 0)
      transforms_.pop_back();
    else if (skipped_from_ == depth_)
      skipped_from_ = 0;
    --depth_;
  }

  void draw(const Drawing_element& element, const Drawing_attributes& a) {
    const std::string& name = element.name;
    if (name == "path")
      draw_path(element, a);
    else if (name == "line")
      draw(element, 1, GC::svg_line<Drawing_traits>(a.length("x1"), a.length("y1"), a.length("x2"), a.length("y2")));
    else if (name == "polyline" || name == "polygon")
      draw(element, 1,
           name == "polygon" ? GC::read_svg_polygon<Drawing_traits>(a.text("points"), a.place("points"))
                             : GC::read_svg_polyline<Drawing_traits>(a.text("points"), a.place("points")));
    else if (name == "circle")
      draw(element, 1, GC::svg_ellipse<Drawing_traits>(a.length("cx"), a.length("cy"), a.size("r"), a.size("r")));
    else if (name == "ellipse")
      draw(element, 1, GC::svg_ellipse<Drawing_traits>(a.length("cx"), a.length("cy"), a.size("rx"), a.size("ry")));
    else if (name == "rect")
      draw_rectangle(element, a);
    else if (name == "use")
      handler_.not_read(element, "the element that it repeats is not followed");
  }

  void draw_path(Drawing_element element, const Drawing_attributes& a) {
    const std::string value = a.text("d");
    if (handler_.takes_paths()) {
      if (a.has("d")) hand_on(element, a, value, transforms_.back().determinant() != 0);
      return;
    }
    Attribute_lines lines(piece(), element.line, "d", value);
    element.lines = &lines;
    GC::Svg_path_reader<Drawing_traits> reader(value, a.place("d"));
    int number = 0;
    while (std::optional<Drawing_subpath> subpath = reader.next()) draw(element, ++number, *std::move(subpath));
  }

  // When one radius is missing, it is equal to the other one.
  void draw_rectangle(const Drawing_element& element, const Drawing_attributes& a) {
    const auto given = [&](const char* radius) { return a.has(radius) && a.text(radius) != "auto"; };
    const char *const rx = given("rx") ? "rx" : "ry", *const ry = given("ry") ? "ry" : "rx";
    const bool rounded = given(rx);
    draw(element, 1,
         GC::svg_rectangle<Drawing_traits>(a.length("x"), a.length("y"), a.size("width"), a.size("height"),
                                           rounded ? a.size(rx) : Drawing_number(0),
                                           rounded ? a.size(ry) : Drawing_number(0)));
  }

  void draw(const Drawing_element& element, int number, Drawing_subpath subpath) {
    subpath.leave_out_points();
    if (subpath.segments.empty() && subpath.left_out == 0) return;
    const Transform& map = transforms_.back();
    if (map.matrix() == Transform().matrix())
      handler_.subpath(element, number, subpath);
    else if (map.determinant() != 0)
      handler_.subpath(element, number, subpath.transform(map));
    else if (number == 1)
      handler_.not_read(element, "it is not drawn, because its transform is not invertible");
  }

public:
  Drawing_reader(const std::string& file, Drawing_handler& handler)
      : file_(file), handler_(handler), parser_(XML_ParserCreateNS(nullptr, ' '), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
    XML_SetEntityDeclHandler(parser_.get(), on_entity);
    XML_SetAttlistDeclHandler(parser_.get(), on_default_value);
    XML_SetSkippedEntityHandler(parser_.get(), on_skipped_entity);
    XML_SetExternalEntityRefHandler(parser_.get(), on_external_entity);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(parser_.get(), free_expansion);
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(parser_.get(), max_expansion);
  }

  void read(std::istream& stream) {
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
      // a tag that is longer than a block is scanned again with the next one: longer blocks keep that linear
      const XML_Index before = std::exchange(position, XML_GetCurrentByteIndex(parser_.get()));
      const bool stuck = position == before;
      if (stuck && size == last_block) refuse("a tag is longer than 256 MiB");
      size = stuck ? 2 * size : first_block;
    }
  }
};

} // namespace

std::string Drawing_element::text() const {
  return name + (id.empty() ? "" : " \"" + id + '"') + " (line " + std::to_string(line) + ')';
}

void read_svg_drawing(std::istream& stream, const std::string& name, Drawing_handler& handler) {
  Drawing_reader(name, handler).read(stream);
}

void read_svg_drawing(const std::string& file, Drawing_handler& handler) {
  Input stream(file);
  read_svg_drawing(stream, input_name(file), handler);
}
