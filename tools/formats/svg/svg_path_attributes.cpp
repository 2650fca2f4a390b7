// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/svg/svg_path_attributes.h"

#include <CGAL/Geometric_continuity/Error.h>

#include <expat.h>

#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The value of the attribute with this name in a tag, and where it begins in the tag; a length of npos when there is none.
std::string_view raw_attribute(std::string_view tag, std::string_view name) {
  std::size_t i = 0;
  while (i < tag.size() && !is_space(tag[i])) ++i; // the name of the element
  for (;;) {
    while (i < tag.size() && is_space(tag[i])) ++i;
    const std::size_t begin = i;
    while (i < tag.size() && !is_space(tag[i]) && tag[i] != '=') ++i;
    const std::string_view found = tag.substr(begin, i - begin);
    i = tag.find_first_of("\"'", i);
    if (i == std::string_view::npos) return {};
    const std::size_t end = tag.find(tag[i], i + 1);
    if (end == std::string_view::npos) return {};
    if (found == name) return tag.substr(i + 1, end - i - 1);
    i = end + 1;
  }
}

class Path_finder {
  const std::string& text_;
  const std::string file_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::vector<Svg_path_attribute> found_;
  std::exception_ptr error_;

  static void on_start(void* self, const XML_Char* name, const XML_Char** attributes) {
    Path_finder& finder = *static_cast<Path_finder*>(self);
    if (finder.error_) return;
    try {
      finder.start(name, attributes);
    } catch (...) {
      finder.error_ = std::current_exception();
      XML_StopParser(finder.parser_.get(), XML_FALSE);
    }
  }

  void start(std::string_view name, const XML_Char** attributes) {
    if (name != "http://www.w3.org/2000/svg path" && name != "path") return;
    Svg_path_attribute path{
        {file_, "path", "", static_cast<long long>(XML_GetCurrentLineNumber(parser_.get()))}, "", "", {}};
    const char* value = nullptr;
    for (; *attributes != nullptr; attributes += 2) {
      if (std::string_view(attributes[0]) == "d") value = attributes[1];
      if (std::string_view(attributes[0]) == "id") path.element.id = attributes[1];
    }
    if (value == nullptr) return;
    locate(path);
    if (path.refusal.empty() && path.value != value) path.refusal = "its data is given by an entity";
    found_.push_back(std::move(path));
  }

  // Finds the attribute in the text of the tag.
  void locate(Svg_path_attribute& path) const {
    const std::size_t size = static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get())),
                      tag = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get()));
    if (size == 0 || text_[tag] != '<') {
      path.refusal = "it stands in an entity";
      return;
    }
    const std::string_view raw = raw_attribute(std::string_view(text_).substr(tag, size), "d");
    if (raw.data() == nullptr) {
      path.refusal = "its data is a default value of the document type";
      return;
    }
    const std::size_t begin = static_cast<std::size_t>(raw.data() - text_.data());
    for (std::size_t i = 0; i < raw.size();) {
      path.position.push_back(begin + i);
      const std::size_t end = raw[i] == '&' ? raw.find(';', i) : i;
      path.value += is_space(raw[i]) ? ' ' : raw[i] == '&' ? character(raw.substr(i + 1, end - i - 1)) : raw[i];
      i = end + 1;
      if (raw[end] == '\r' && i < raw.size() && raw[i] == '\n') ++i; // one end of a line
    }
    path.position.push_back(begin + raw.size());
  }

  // What a reference to a character stands for; others are not those of numbers and letters.
  static char character(std::string_view name) {
    if (name.size() < 2 || name[0] != '#') return '&';
    const bool hexadecimal = name[1] == 'x';
    const long code =
        std::strtol(std::string(name.substr(hexadecimal ? 2 : 1)).c_str(), nullptr, hexadecimal ? 16 : 10);
    return 0 < code && code < 128 ? static_cast<char>(code) : '&';
  }

public:
  Path_finder(const std::string& text, const std::string& file)
      : text_(text), file_(file), parser_(XML_ParserCreateNS(nullptr, ' '), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetStartElementHandler(parser_.get(), on_start);
  }

  std::vector<Svg_path_attribute> find() {
    constexpr std::size_t block = std::size_t(1) << 24;
    for (std::size_t done = 0; done < text_.size() || done == 0;) {
      const std::size_t size = (std::min)(block, text_.size() - done);
      done += size;
      const XML_Status status =
          XML_Parse(parser_.get(), text_.data() + done - size, static_cast<int>(size), done == text_.size());
      if (error_) std::rethrow_exception(error_);
      if (status != XML_STATUS_OK)
        throw GC::Error(GC::Error_code::malformed_input,
                        file_ + ": " + XML_ErrorString(XML_GetErrorCode(parser_.get())));
      if (done == text_.size()) break;
    }
    return std::move(found_);
  }
};

} // namespace

std::vector<Svg_path_attribute> svg_path_attributes(const std::string& text, const std::string& file) {
  return Path_finder(text, file).find();
}
