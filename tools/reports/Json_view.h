// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_JSON_VIEW_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_JSON_VIEW_H

#include <CGAL/Geometric_continuity/Error.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

// A value in a JSON text, which stays where it is: what reads reports again. Its parts are found by
// reading over what is before them.
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

  static std::optional<char32_t> hexadecimal(std::string_view digits) {
    std::uint32_t code = 0;
    const std::from_chars_result end = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 4 || end.ec != std::errc() || end.ptr != digits.data() + 4) return std::nullopt;
    return code;
  }

  static void append_utf8(std::string& bytes, char32_t code) {
    if (code < 0x80) {
      bytes += static_cast<char>(code);
      return;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr char32_t leads[] = {0, 0xC0, 0xE0, 0xF0};
    bytes += static_cast<char>(leads[more] | code >> (6 * more));
    for (int i = more - 1; i >= 0; --i) bytes += static_cast<char>(0x80 | (code >> (6 * i) & 0x3F));
  }

public:
  // Takes a text that is one value, and must live on. Throws Error `malformed_input` for what is
  // none, here and when a part is asked for.
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
    for_members([&](std::string_view k, const Json_view& value) {
      if (k == key) found = value;
      return !found;
    });
    return found;
  }

  // Calls f(key, value) for the members of an object, with the keys as they are written, until it
  // returns false.
  template <class Function> void for_members(Function f) const {
    for_each('{', [&](std::string_view k, const Json_view& value) { return f(k.substr(1, k.size() - 2), value); });
  }

  // Calls f for each element of an array; not at all for anything else.
  template <class Function> void for_elements(Function f) const {
    for_each('[', [&](std::string_view, const Json_view& value) {
      f(value);
      return true;
    });
  }

  // The characters of a string as they are written, which is the same for the same string of one
  // writer; nothing for anything else.
  std::optional<std::string_view> string() const {
    if (text_[0] != '"') return std::nullopt;
    return text_.substr(1, text_.size() - 2);
  }

  // The bytes for which a string stands, with escapes read; nothing for anything else, and for
  // escapes that stand for no character.
  std::optional<std::string> decoded() const {
    const std::optional<std::string_view> written = string();
    if (!written) return std::nullopt;
    std::string bytes;
    char32_t first = 0; // of two halves of a character
    for (std::size_t i = 0; i < written->size(); ++i) {
      const char c = (*written)[i];
      if (c == '\\' && i + 1 < written->size() && (*written)[i + 1] == 'u') {
        const std::optional<char32_t> code = hexadecimal(written->substr(i + 2, 4));
        if (!code) return std::nullopt;
        i += 5;
        const bool is_first = 0xD800 <= *code && *code < 0xDC00, is_second = 0xDC00 <= *code && *code < 0xE000;
        if (is_second != (first != 0)) return std::nullopt;
        if (is_first)
          first = *code;
        else
          append_utf8(bytes,
                      is_second ? 0x10000 + ((std::exchange(first, 0) - 0xD800) << 10) + (*code - 0xDC00) : *code);
        continue;
      }
      if (first != 0) return std::nullopt;
      if (c != '\\') {
        bytes += c;
        continue;
      }
      const std::size_t escape = std::string_view("\"\\/bfnrt").find((*written)[++i]);
      if (escape == std::string_view::npos) return std::nullopt;
      bytes += "\"\\/\b\f\n\r\t"[escape];
    }
    return first == 0 ? std::optional<std::string>(std::move(bytes)) : std::nullopt;
  }

  // Any number; nothing for what is none.
  std::optional<double> number() const {
    double x = 0;
    const std::from_chars_result end = std::from_chars(text_.data(), text_.data() + text_.size(), x);
    if (end.ec != std::errc() || end.ptr != text_.data() + text_.size()) return std::nullopt;
    return x;
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
