// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_GCODE_GCODE_BLOCK_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_GCODE_GCODE_BLOCK_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/number.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// A letter and the number behind it, such as.
struct Gcode_word {
  char letter;                                // in capitals
  std::optional<CGAL::Exact_rational> number; // empty for a parameter or an expression
  int decimals;                               // behind the point
};

// A line of a program in G-code.
class Gcode_block {
  std::string text_; // without blanks and comments, in capitals
  std::size_t at_ = 0;

  bool at_end() const { return at_ == text_.size(); }
  char next() const { return at_end() ? '\0' : text_[at_]; }
  static bool is_letter(char c) { return 'A' <= c && c <= 'Z'; }

  // Appends the text of a line.
  void read_text(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (c == ';') break;
      if (c == '(') {
        i = line.find(')', i);
        if (i != std::string_view::npos) continue;
        error = "a comment without an end";
        return;
      }
      if (c == ' ' || c == '\t' || c == '\r') continue;
      text_ += 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
  }

  // Passes over what stands in brackets. Returns false where they do not close.
  bool skip_brackets() {
    int depth = 0;
    do {
      if (at_end()) return false;
      depth += next() == '[' ? 1 : next() == ']' ? -1 : 0;
      ++at_;
    } while (depth > 0);
    return true;
  }

  // Passes over a parameter, an expression or a function of one.
  bool skip_expression() {
    while (next() == '#' || is_letter(next()) || next() == '-' || next() == '+') ++at_;
    if (next() == '<') {
      const std::size_t end = text_.find('>', at_);
      if (end == std::string::npos) return false;
      at_ = end + 1;
    } else if (next() == '[') {
      if (!skip_brackets()) return false;
      if (text_.compare(at_, 2, "/[") == 0) { // the second argument of ATAN
        ++at_;
        return skip_brackets();
      }
    } else
      while ('0' <= next() && next() <= '9') ++at_;
    return true;
  }

  void read_word() {
    Gcode_word word{next(), std::nullopt, 0};
    if (!is_letter(word.letter)) {
      error = std::string("\"") + GC::printable(std::string(1, next())) + "\" where a letter is expected";
      return;
    }
    ++at_;
    const std::size_t begin = at_;
    while (!at_end() && std::string_view("+-.0123456789").find(next()) != std::string_view::npos) ++at_;
    if (at_ == begin || next() == '#' || next() == '[') {
      at_ = begin;
      if (next() != '#' && next() != '[' && next() != '-' && !(is_letter(next()) && has('['))) {
        error = std::string("the letter ") + word.letter + " without a number";
        return;
      }
      if (!skip_expression()) error = "an expression without an end";
    } else {
      const std::string number = text_.substr(begin, at_ - begin);
      const std::size_t point = number.find('.');
      if (point != std::string::npos) word.decimals = static_cast<int>(number.size() - point - 1);
      try {
        word.number = GC::parse_number<CGAL::Exact_rational>(number);
      } catch (const GC::Error& e) {
        error = e.what();
      }
    }
    words.push_back(std::move(word));
  }

  bool has(char c) const { return text_.find(c, at_) != std::string::npos; }

  bool has_m() const {
    return std::any_of(words.begin(), words.end(), [](const Gcode_word& w) { return w.letter == 'M' && w.number; });
  }

public:
  std::vector<Gcode_word> words;
  std::string error;        // why the line cannot be read
  bool is_optional = false; // it begins with a slash
  bool is_control = false;  // an O-word: a subprogram, a loop or a condition
  bool is_mark = false;     // the sign % at the beginning and at the end of a program

  explicit Gcode_block(std::string_view line) {
    read_text(line);
    is_mark = next() == '%';
    if (!error.empty() || is_mark) return;
    if (next() == '/') {
      is_optional = true;
      ++at_;
    }
    while (!at_end() && error.empty()) {
      if (next() == 'O') { // alone, the number of a program
        is_control = text_.find_first_not_of("0123456789", at_ + 1) != std::string::npos;
        return;
      }
      if (next() == '#' || next() == '*') return; // an assignment to a parameter, and a checksum
      read_word();
      if (error.empty() || !has_m()) continue;
      error.clear(); // the text of a message
      return;
    }
  }

  // Returns the last word with this letter, if there is one.
  const Gcode_word* word(char letter) const {
    const auto found =
        std::find_if(words.rbegin(), words.rend(), [&](const Gcode_word& w) { return w.letter == letter; });
    return found == words.rend() ? nullptr : &*found;
  }

  // Returns whether there is a word with one of these letters.
  bool has_any(std::string_view letters) const {
    return std::any_of(words.begin(), words.end(),
                       [&](const Gcode_word& w) { return letters.find(w.letter) != std::string_view::npos; });
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_GCODE_GCODE_BLOCK_H
