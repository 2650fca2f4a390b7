// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_JSON_VIEW_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_JSON_VIEW_H

#include <CGAL/Geometric_continuity/Error.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// A value in a JSON text, which stays where it is: what reads reports again. Its parts are found by reading over what is before them.
class Json_view {
  std::string_view text_; // of the value, without space around it

  [[noreturn]] static void refuse() {
    throw CGAL::Geometric_continuity::Error(CGAL::Geometric_continuity::Error_code::malformed_input, "no JSON");
  }
  explicit Json_view(std::string_view text) : text_(text) {}

  static void skip_space(std::string_view text, std::size_t& i) {
    while (i < text.size() && (text[i] == ' ' || text[i] == '\n' || text[i] == '\r' || text[i] == '\t')) ++i;
  }
  static void skip_string(std::string_view text, std::size_t& i) {
    for (++i; i < text.size() && text[i] != '"'; ++i)
      if (text[i] == '\\') ++i;
    if (i >= text.size()) refuse();
    ++i;
  }
  // Takes the value that begins at i. Brackets are counted, so that deep texts need no stack.
  static std::string_view take(std::string_view text, std::size_t& i) {
    skip_space(text, i);
    const std::size_t begin = i;
    if (i == text.size()) refuse();
    if (text[i] == '"')
      skip_string(text, i);
    else if (text[i] == '{' || text[i] == '[') {
      std::string open;
      do {
        if (i >= text.size()) refuse();
        const char c = text[i];
        if (c == '"') {
          skip_string(text, i);
          continue;
        }
        if (c == '{' || c == '[') open += c;
        if (c == '}' || c == ']') {
          if (open.empty() || open.back() != (c == '}' ? '{' : '[')) refuse();
          open.pop_back();
        }
        ++i;
      } while (!open.empty());
    } else
      while (i < text.size() && std::string_view(",]} \n\r\t").find(text[i]) == std::string_view::npos) ++i;
    if (i == begin) refuse();
    return text.substr(begin, i - begin);
  }

  // Calls f(key, value), where elements of an array have no key, until it returns false.
  template <class Function> void for_each(char open, Function f) const {
    if (text_[0] != open) return;
    std::size_t i = 1;
    const char close = open == '{' ? '}' : ']';
    for (bool is_first = true;; is_first = false) {
      skip_space(text_, i);
      if (i < text_.size() && text_[i] == close) return;
      if (!is_first) {
        if (i >= text_.size() || text_[i] != ',') refuse();
        ++i;
      }
      std::string_view key;
      if (open == '{') {
        key = take(text_, i);
        if (key[0] != '"') refuse();
        skip_space(text_, i);
        if (i >= text_.size() || text_[i] != ':') refuse();
        ++i;
      }
      const Json_view value(take(text_, i));
      if (!f(key, value)) return;
    }
  }

public:
  // Takes a text that is one value, and must live on. Throws Error `malformed_input` for what is none, here and when a part is asked for.
  static Json_view of(std::string_view text) {
    std::size_t i = 0;
    const Json_view value(take(text, i));
    skip_space(text, i);
    if (i != text.size()) refuse();
    return value;
  }

  std::string_view text() const { return text_; }

  // The member of an object, of a key without escapes.
  std::optional<Json_view> member(std::string_view key) const {
    std::optional<Json_view> found;
    for_each('{', [&](std::string_view k, const Json_view& value) {
      if (k.substr(1, k.size() - 2) == key) found = value;
      return !found;
    });
    return found;
  }

  // Calls f for each element of an array; not at all for anything else.
  template <class Function> void for_elements(Function f) const {
    for_each('[', [&](std::string_view, const Json_view& value) {
      f(value);
      return true;
    });
  }

  // The characters of a string as they are written, which is the same for the same string of one writer; nothing for anything else.
  std::optional<std::string_view> string() const {
    if (text_[0] != '"') return std::nullopt;
    return text_.substr(1, text_.size() - 2);
  }

  // A number that is not negative.
  std::optional<std::uint64_t> count() const {
    std::uint64_t n = 0;
    if (text_.size() > 18) return std::nullopt;
    for (const char c : text_) {
      if (c < '0' || '9' < c) return std::nullopt;
      n = 10 * n + static_cast<std::uint64_t>(c - '0');
    }
    return n;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_JSON_VIEW_H
