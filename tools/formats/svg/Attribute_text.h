// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_ATTRIBUTE_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_ATTRIBUTE_TEXT_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Where the characters of the value of an attribute stand in the text of a file, in which some are
// written as references to characters, and ends of lines are spaces in the value.
class Attribute_text {
  std::string_view raw_;  // what stands between the quotation marks
  std::size_t begin_ = 0; // in the file
  std::string refusal_;
  // of each character in `raw_`, and of the end; none where they are those of the value
  std::vector<std::size_t> positions_;

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  // The value of an attribute as it is written in a tag; without data when there is none.
  static std::string_view raw_attribute(std::string_view tag, std::string_view name) {
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

  // Returns the character of a reference; other references do not stand for numbers and letters.
  static char character(std::string_view name) {
    if (name.size() < 2 || name[0] != '#') return '&';
    const bool hexadecimal = name[1] == 'x';
    const long code =
        std::strtol(std::string(name.substr(hexadecimal ? 2 : 1)).c_str(), nullptr, hexadecimal ? 16 : 10);
    return 0 < code && code < 128 ? static_cast<char>(code) : '&';
  }

public:
  // Finds the attribute in the text of a tag, which begins there in the file. The tag must outlive
  // this object.
  Attribute_text(std::string_view tag, std::size_t tag_begin, std::string_view name, std::string_view value) {
    if (tag.empty() || tag[0] != '<') {
      refusal_ = "it stands in an entity";
      return;
    }
    raw_ = raw_attribute(tag, name);
    if (raw_.data() == nullptr) {
      refusal_ = "its data is a default value of the document type";
      return;
    }
    begin_ = tag_begin + static_cast<std::size_t>(raw_.data() - tag.data());
    if (raw_ == value) return;
    std::string read;
    for (std::size_t i = 0; i < raw_.size();) {
      positions_.push_back(i);
      const std::size_t end = raw_[i] == '&' ? (std::min)(raw_.find(';', i), raw_.size() - 1) : i;
      read += is_space(raw_[i]) ? ' ' : raw_[i] == '&' ? character(raw_.substr(i + 1, end - i - 1)) : raw_[i];
      i = end + 1;
      if (raw_[end] == '\r' && i < raw_.size() && raw_[i] == '\n') ++i; // one end of a line
    }
    positions_.push_back(raw_.size());
    if (read != value) refusal_ = "its data is given by an entity";
  }

  // Why the places are not known; empty when they are.
  const std::string& refusal() const { return refusal_; }

  // Returns where a character of the value, or its end, stands in the file. \pre the places are
  // known
  std::size_t operator[](std::size_t i) const { return begin_ + (positions_.empty() ? i : positions_[i]); }
};

// The lines of a file on which the characters of the value of an attribute stand, as far as they
// are asked for.
class Attribute_lines {
  const std::string_view tag_, name_, value_;
  const long long first_line_; // of the tag
  std::optional<Attribute_text> text_;
  std::size_t known_ = 0; // in the tag: the line of this character is known
  long long line_;

public:
  Attribute_lines(std::string_view tag, long long first_line, std::string_view name, std::string_view value)
      : tag_(tag), name_(name), value_(value), first_line_(first_line), line_(first_line) {}

  // Returns the line; that of the tag where the place is not known. Linear in all when the places
  // ascend.
  long long operator[](std::size_t i) {
    if (!text_) text_.emplace(tag_, 0, name_, value_);
    if (!text_->refusal().empty()) return first_line_;
    const std::size_t place = (*text_)[i];
    if (place < known_) {
      known_ = 0;
      line_ = first_line_;
    }
    line_ += std::count(tag_.begin() + static_cast<std::ptrdiff_t>(known_),
                        tag_.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    known_ = place;
    return line_;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_ATTRIBUTE_TEXT_H
