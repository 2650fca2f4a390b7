// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_STYLE_DECLARATIONS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_STYLE_DECLARATIONS_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// One `name: value` of a style sheet or of an attribute `style`; the name is in small letters.
struct Style_declaration {
  std::string name, value;
};

// Walks through the text of a style sheet: knows what is quoted, in parentheses, or in a comment.
class Style_text {
  std::string_view text_;

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

  // Where what begins there ends: a quoted text, one in parentheses or brackets, an escaped
  // character, or another one.
  static std::size_t behind(std::string_view s, std::size_t i) {
    const char c = s[i];
    if (c == '\\') return (std::min)(i + 2, s.size());
    if (c == '"' || c == '\'') {
      for (++i; i < s.size() && s[i] != c && s[i] != '\n'; ++i)
        if (s[i] == '\\') ++i;
      return (std::min)(i + 1, s.size());
    }
    if (c != '(' && c != '[') return i + 1;
    std::string open(1, c == '(' ? ')' : ']'); // what closes the parentheses that are open
    for (++i; i < s.size() && !open.empty();) {
      if (s[i] == open.back())
        open.pop_back();
      else if (s[i] == '(' || s[i] == '[') {
        open += s[i] == '(' ? ')' : ']';
        ++i;
        continue;
      } else if (s[i] == '\\' || s[i] == '"' || s[i] == '\'') {
        i = behind(s, i);
        continue;
      }
      ++i;
    }
    return i;
  }

public:
  explicit Style_text(std::string_view text) : text_(text) {}

  bool at_end() const { return text_.empty(); }
  std::string_view rest() const { return text_; }

  // Takes what is before one of these characters, and the character; all where there is none.
  std::string_view take_until(std::string_view characters, char& found) {
    std::size_t i = 0;
    while (i < text_.size() && characters.find(text_[i]) == std::string_view::npos) i = behind(text_, i);
    const std::string_view result = text_.substr(0, i);
    found = i < text_.size() ? text_[i] : '\0';
    text_.remove_prefix((std::min)(i + 1, text_.size()));
    return result;
  }

  // Takes what is in a block, behind its opening brace, and its closing one.
  std::string_view take_block() {
    std::size_t i = 0, depth = 1;
    for (; i < text_.size(); i = behind(text_, i)) {
      if (text_[i] == '{') ++depth;
      if (text_[i] == '}' && --depth == 0) break;
    }
    const std::string_view result = text_.substr(0, i);
    text_.remove_prefix((std::min)(i + 1, text_.size()));
    return result;
  }

  static std::string_view trimmed(std::string_view s) {
    while (!s.empty() && is_space(s.front())) s.remove_prefix(1);
    while (!s.empty() && is_space(s.back())) s.remove_suffix(1);
    return s;
  }

  // The text with a space in place of each comment.
  static std::string without_comments(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      if (text.substr(i, 2) == "/*") {
        const std::size_t end = text.find("*/", i + 2);
        result += ' ';
        i = end == std::string_view::npos ? text.size() : end + 2;
        continue;
      }
      const std::size_t end = text[i] == '"' || text[i] == '\'' ? behind(text, i) : i + 1;
      result.append(text, i, end - i);
      i = end;
    }
    return result;
  }
};

// The declarations of a text without comments, in their order.
inline std::vector<Style_declaration> style_declarations(std::string_view text) {
  std::vector<Style_declaration> result;
  for (Style_text rest(text); !rest.at_end();) {
    char end;
    const std::string_view declaration = rest.take_until(";", end);
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) continue;
    Style_declaration d{std::string(Style_text::trimmed(declaration.substr(0, colon))), ""};
    for (char& c : d.name)
      if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    std::string_view value = Style_text::trimmed(declaration.substr(colon + 1));
    const std::size_t mark = value.rfind('!');
    if (mark != std::string_view::npos && Style_text::trimmed(value.substr(mark + 1)) == "important")
      value = Style_text::trimmed(value.substr(0, mark));
    d.value = value;
    result.push_back(std::move(d));
  }
  return result;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_STYLE_DECLARATIONS_H
