// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/step_entities.h"

#include <algorithm>
#include <cstddef>

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z') || c == '_'; }

class Step_parser {
  std::string_view text_;
  std::size_t at_ = 0;

  // Skips blanks, and comments.
  void skip() {
    while (at_ < text_.size()) {
      if (text_.substr(at_, 2) == "/*")
        at_ = (std::min)(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      else if (static_cast<unsigned char>(text_[at_]) <= ' ')
        ++at_;
      else
        return;
    }
  }

  bool is_at(char c) {
    skip();
    return at_ < text_.size() && text_[at_] == c;
  }

  // The number behind the sign #, 0 if there is none.
  std::uint64_t id() {
    ++at_;
    std::uint64_t result = 0;
    for (; at_ < text_.size() && is_digit(text_[at_]); ++at_)
      result = 10 * result + static_cast<std::uint64_t>(text_[at_] - '0');
    return result;
  }

  std::string_view word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Reads to the end of a statement. A text 'it''s' is two for this purpose.
  void statement(Step_entity* entity) {
    int depth = 0;
    const bool is_composed = is_at('(');
    while (at_ < text_.size()) {
      skip();
      if (at_ >= text_.size()) return;
      const char c = text_[at_];
      if (c == ';') {
        ++at_;
        return;
      }
      if (c == '\'' || c == '"')
        at_ = (std::min)(text_.find(c, at_ + 1), text_.size() - 1) + 1;
      else if (c == '#') {
        const std::uint64_t reference = id();
        if (entity != nullptr && reference != 0) entity->references.push_back(reference);
      } else if (c == '.' && at_ + 1 < text_.size() && is_letter(text_[at_ + 1])) {
        ++at_; // a word of an enumeration
        word();
      } else if (is_letter(c)) {
        const std::string_view name = word();
        if (entity == nullptr || depth != (is_composed ? 1 : 0)) continue;
        if (!entity->type.empty()) entity->type += ' ';
        entity->type += name;
      } else {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        ++at_;
      }
    }
  }

public:
  explicit Step_parser(std::string_view text) : text_(text) {}

  std::vector<Step_entity> read() {
    std::vector<Step_entity> result;
    for (skip(); at_ < text_.size(); skip()) {
      Step_entity entity;
      if (is_at('#')) entity.id = id();
      const bool is_entity = entity.id != 0 && is_at('=');
      if (is_entity) ++at_;
      statement(is_entity ? &entity : nullptr);
      if (!is_entity) continue;
      std::transform(entity.type.begin(), entity.type.end(), entity.type.begin(),
                     [](char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
      result.push_back(std::move(entity));
    }
    return result;
  }
};

} // namespace

std::vector<Step_entity> step_entities(std::string_view text) { return Step_parser(text).read(); }
