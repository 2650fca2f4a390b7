// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SCANNER_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SCANNER_H

#include "formats/svg/svg_size.h"
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

// A piece of a text, from one character to behind another one.
struct Text_range {
  std::size_t begin, end;
};

/// Returns the text of an error without its code.
inline std::string svg_reason(const Error& error) {
  return std::string(error.what()).substr(to_string(error.code()).size() + 2);
}

// Reads numbers, flags and names from the text of an attribute, by the grammar of SVG: white space
// and one comma may separate numbers, and need not where the next number cannot be a part of the
// one before. The text must outlive it.
class Svg_scanner {
  std::string_view text_;
  std::string name_;
  std::size_t position_ = 0, token_ = 0; // of what comes next and of what was read last
  Text_range number_{0, 0};              // the number or the flag that was read last
  bool comma_ = false;                   // a comma has been skipped, so that something must follow

  static bool is_digit(char c) { return '0' <= c && c <= '9'; }
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\f' || c == '\r'; }
  static bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

  bool take(char c) {
    if (peek() != c || at_end()) return false;
    ++position_;
    return true;
  }
  void take_digits() {
    while (!at_end() && is_digit(peek())) ++position_;
  }

  // The longest beginning of the rest that is a number: an exponent is a part of it only when it
  // has a digit.
  void skip_number() {
    if (!take('+')) take('-');
    take_digits();
    if (take('.')) take_digits();
    const std::size_t mantissa = position_;
    if (!take('e')) take('E');
    if (position_ == mantissa) return;
    if (!take('+')) take('-');
    if (at_end() || !is_digit(peek()))
      position_ = mantissa;
    else
      take_digits();
  }

public:
  // Messages begin with `name`, e.g. "path data".
  Svg_scanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  // Where the next character stands, and the number or the flag that was read last.
  std::size_t position() const { return position_; }
  Text_range last_number() const { return number_; }

  bool at_end() const { return position_ == text_.size(); }

  // The next character, 0 at the end.
  char peek() const { return at_end() ? '\0' : text_[position_]; }

  void skip_space() {
    while (!at_end() && is_space(peek())) ++position_;
  }

  // Skips white space and at most one comma.
  void skip_separator() {
    skip_space();
    comma_ = peek() == ',';
    if (!comma_) return;
    token_ = position_++;
    skip_space();
  }

  // Refuses a comma between what was read last and what comes next.
  void refuse_comma() const {
    if (comma_) refuse("a comma where a number is expected");
  }

  bool at_number() const {
    const char c = peek();
    return !at_end() && (is_digit(c) || c == '+' || c == '-' || c == '.');
  }

  // Reads a number and nothing behind it.
  template <class FT> FT leading_number() {
    token_ = position_;
    if (!at_number()) refuse(found() + " where a number is expected");
    skip_number();
    number_ = {token_, position_};
    const std::string_view token = text_.substr(token_, position_ - token_);
    const FT value = parsed<FT>(token);
    if (!has_short_parts<max_svg_number_bits>(value))
      refuse("number of more than " + std::to_string(max_svg_number_bits) + " bits: " + quoted_token(token));
    return value;
  }

private:
  template <class FT> FT parsed(std::string_view token) const {
    try {
      return parse_number<FT>(token);
    } catch (const Error& error) {
      refuse(svg_reason(error));
    }
  }

public:
  // Reads a number and what separates it from the next one.
  template <class FT> FT number() {
    const FT value = leading_number<FT>();
    skip_separator();
    return value;
  }

  // Reads a number of degrees.
  template <class FT> FT angle() {
    const FT degrees = number<FT>();
    if (!Quarter_turns<FT>::is_allowed(degrees)) refuse("an angle beyond 10^9 degrees");
    return degrees;
  }

  // Reads a single 0 or 1, which needs no separator.
  bool flag() {
    token_ = position_;
    if (at_end() || (peek() != '0' && peek() != '1')) refuse(found() + " where a flag, 0 or 1, is expected");
    const bool value = text_[position_++] == '1';
    number_ = {token_, position_};
    skip_separator();
    return value;
  }

  // Reads a letter; the caller says what is expected when there is none.
  char letter(const char* expected) {
    token_ = position_;
    if (!is_letter(peek())) refuse(found() + " where " + expected + " is expected");
    const char c = text_[position_++];
    skip_space();
    return c;
  }

  // Reads a word of letters, which may be empty.
  std::string_view word() {
    token_ = position_;
    while (is_letter(peek())) ++position_;
    return text_.substr(token_, position_ - token_);
  }

  void expect(char c) {
    skip_space();
    if (!take(c)) {
      token_ = position_;
      refuse(found() + " where '" + c + "' is expected");
    }
    skip_space();
  }

  // Takes all that is left, without white space at its end. A message still refers to what was read
  // before.
  std::string_view rest() {
    std::string_view rest = text_.substr(position_);
    while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
    position_ = text_.size();
    return rest;
  }

  // The next character, for messages.
  std::string found() const { return at_end() ? "the end" : quoted_token(text_.substr(position_, 1)); }

  // Refuses what was read last.
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, name_ + ", character " + std::to_string(token_ + 1) + ": " + reason);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SCANNER_H
