// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/entity_lines.h"

#include "formats/cad/cad_file.h"

#include <cstddef>
#include <fstream>

namespace {

typedef std::unordered_map<std::string, long long> Lines;

bool is_digit(char c) { return '0' <= c && c <= '9'; }

// Finds the names before signs of equality, outside of texts 'it''s' and of comments, which may go
// over many lines.
class Step_scanner {
  Lines lines_;
  bool in_text_ = false, in_comment_ = false;
  std::string name_; // "#123", which may be followed by blanks
  bool is_whole_ = false;
  long long line_of_name_ = 0;

public:
  void read(const std::string& line, long long number) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i], next = i + 1 < line.size() ? line[i + 1] : '\0';
      if (in_comment_) {
        in_comment_ = !(c == '*' && next == '/');
        if (!in_comment_) ++i;
      } else if (c == '\'' || in_text_)
        in_text_ = in_text_ != (c == '\'');
      else if (c == '/' && next == '*') {
        in_comment_ = true;
        ++i;
      } else
        take(c, number);
    }
    take(' ', number);
  }

  Lines lines() && { return std::move(lines_); }

private:
  void take(char c, long long number) {
    if (c == '#') {
      name_ = c;
      is_whole_ = false;
      line_of_name_ = number;
    } else if (!name_.empty() && is_digit(c) && !is_whole_)
      name_ += c;
    else if (c == ' ' || c == '\t' || c == '\r')
      is_whole_ = !name_.empty();
    else {
      if (c == '=' && name_.size() > 1) lines_.emplace(name_, line_of_name_);
      name_.clear();
    }
  }
};

// The last columns of a line are the letter of its section and the number of the line in it.
void add_iges_line(const std::string& line, long long number, Lines& lines) {
  constexpr std::size_t column = 72;
  if (line.size() <= column || line[column] != 'D') return;
  const std::size_t first = line.find_first_not_of(" 0", column + 1);
  if (first == std::string::npos || !is_digit(line[first])) return;
  std::size_t end = first;
  while (end < line.size() && is_digit(line[end])) ++end;
  lines.emplace('D' + line.substr(first, end - first), number);
}

} // namespace

Lines entity_lines(const std::string& file) {
  const std::optional<Cad_format> format = cad_format(file);
  if (!format || *format == Cad_format::brep) return {};
  std::ifstream stream(file, std::ios::binary);
  Lines iges;
  Step_scanner step;
  long long number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (*format == Cad_format::step)
      step.read(line, number);
    else
      add_iges_line(line, number, iges);
  }
  return *format == Cad_format::step ? std::move(step).lines() : iges;
}
