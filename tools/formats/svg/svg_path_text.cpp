// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/svg/svg_path_text.h"

#include "commands/repair/grid_number.h"

#include <algorithm>
#include <utility>

namespace {

typedef GC::Grid_vector Vector;

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_relative(char letter) { return upper(letter) != letter; }
bool is_digit(char c) { return '0' <= c && c <= '9'; }

std::size_t number_of_arguments(char letter) {
  switch (upper(letter)) {
  case 'C': return 6;
  case 'S':
  case 'Q': return 4;
  case 'A': return 7;
  case 'H':
  case 'V': return 1;
  case 'Z': return 0;
  default: return 2;
  }
}

// The letter of numbers that follow a command without another letter.
char repeated(char letter) { return letter == 'M' ? 'L' : letter == 'm' ? 'l' : letter; }

} // namespace

Svg_path_text::Svg_path_text(std::string text) : text_(std::move(text)) {
  split();
  find_grid();
  if (refusal_.empty()) draw();
}

void Svg_path_text::split() {
  std::size_t i = 0;
  const auto skip_digits = [&] {
    while (i < text_.size() && is_digit(text_[i])) ++i;
  };
  const auto skip_sign = [&] { i += i < text_.size() && (text_[i] == '-' || text_[i] == '+'); };
  while (i < text_.size()) {
    const char c = text_[i];
    if (('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z')) {
      commands_.push_back({c, Token{i, i + 1}, {}});
      ++i;
    } else if (is_digit(c) || c == '-' || c == '+' || c == '.') {
      if (commands_.back().numbers.size() == number_of_arguments(commands_.back().letter))
        commands_.push_back({repeated(commands_.back().letter), std::nullopt, {}});
      Command& command = commands_.back();
      const std::size_t begin = i, index = command.numbers.size();
      if (upper(command.letter) == 'A' && (index == 3 || index == 4))
        ++i; // a flag
      else {
        skip_sign();
        skip_digits();
        if (i < text_.size() && text_[i] == '.') {
          ++i;
          skip_digits();
        }
        const std::size_t mantissa = i;
        if (i < text_.size() && (text_[i] == 'e' || text_[i] == 'E')) {
          ++i;
          skip_sign();
          if (i < text_.size() && is_digit(text_[i]))
            skip_digits();
          else
            i = mantissa;
        }
      }
      command.numbers.push_back({begin, i});
    } else
      ++i;
  }
}

void Svg_path_text::find_grid() {
  for (const Command& command : commands_)
    for (std::size_t k = upper(command.letter) == 'A' ? 5 : 0; k < command.numbers.size(); ++k) {
      const std::optional<Grid_number> x = Grid_number::read(number(command.numbers[k]));
      if (!x || x->decimals > Grid_number::max_decimals)
        refusal_ = "a number has too many digits: " + number(command.numbers[k]).substr(0, 30);
      else
        decimals_ = (std::max)(decimals_, x->decimals);
    }
}

void Svg_path_text::draw() {
  Vector start{0, 0}, current{0, 0}, control{0, 0};
  int control_degree = 1;
  Grid_contour subpath;
  subpath.decimals = decimals_;
  const auto finish = [&](bool closed) {
    subpath.closed = closed;
    if (!subpath.curves.empty()) subpaths_.push_back(subpath);
    subpath.curves.clear();
  };
  for (std::size_t index = 0; index < commands_.size(); ++index) {
    const Command& command = commands_[index];
    const char kind = upper(command.letter);
    const Vector origin = is_relative(command.letter) ? current : Vector{0, 0};
    const auto coordinate = [&](std::size_t k) {
      const std::optional<std::int64_t> x = Grid_number::read(number(command.numbers[k]))->on_grid(decimals_);
      if (!x) refusal_ = "a coordinate is too large for its decimals: " + number(command.numbers[k]).substr(0, 30);
      return x.value_or(0);
    };
    const auto point = [&](std::size_t k) { return origin + Vector{coordinate(2 * k), coordinate(2 * k + 1)}; };
    const auto add = [&](std::vector<Vector> points, std::string reason = "") {
      const bool has_length = std::count(points.begin(), points.end(), current) != static_cast<long>(points.size());
      const Vector end = points.back();
      if (points.size() > 2) origins_.push_back({subpaths_.size(), subpath.curves.size(), index, current});
      if (!reason.empty()) points.clear();
      if (has_length)
        subpath.curves.push_back({points, reason, false});
      else if (points.size() > 2)
        origins_.pop_back();
      current = end;
    };
    int degree = 1;
    switch (kind) {
    case 'M':
      finish(false);
      current = start = point(0);
      break;
    case 'L': add({current, point(0)}); break;
    case 'H': add({current, Vector{origin.x + coordinate(0), current.y}}); break;
    case 'V': add({current, Vector{current.x, origin.y + coordinate(0)}}); break;
    case 'C':
    case 'S': {
      const bool smooth = kind == 'S';
      const Vector first = !smooth ? point(0) : control_degree == 3 ? 2 * current - control : current;
      degree = 3;
      control = point(smooth ? 0 : 1);
      add({current, first, control, point(smooth ? 1 : 2)});
      break;
    }
    case 'Q':
    case 'T':
      control = kind == 'Q' ? point(0) : control_degree == 2 ? 2 * current - control : current;
      degree = 2;
      add({current, control, point(kind == 'Q' ? 1 : 0)});
      break;
    case 'A': {
      const Vector end = origin + Vector{coordinate(5), coordinate(6)};
      const auto is_zero = [&](std::size_t k) {
        return number(command.numbers[k]).find_first_of("123456789") >=
               (std::min)(number(command.numbers[k]).find_first_of("eE"), std::string::npos);
      };
      add({current, end}, is_zero(0) || is_zero(1) ? "" : "an arc");
      break;
    }
    default: add({current, start}); finish(true);
    }
    control_degree = degree;
    const auto size = (std::max)((std::abs)(current.x), (std::abs)(current.y));
    if (size > max_grid_coordinate) refusal_ = "the coordinates become too large for their decimals";
    if (!refusal_.empty()) return;
  }
  finish(false);
}

std::size_t Svg_path_text::command(std::size_t subpath, std::size_t curve) const {
  const auto found = std::lower_bound(origins_.begin(), origins_.end(), std::pair(subpath, curve),
                                      [](const Origin& origin, const std::pair<std::size_t, std::size_t>& place) {
                                        return std::pair(origin.subpath, origin.curve) < place;
                                      });
  const bool is_curve = found != origins_.end() && found->subpath == subpath && found->curve == curve;
  return is_curve ? found->command + 1 : 0;
}

std::vector<Svg_path_text::Edit> Svg_path_text::edits(const std::vector<Grid_contour>& subpaths) const {
  std::vector<Edit> edits;
  // Numbers may follow each other without a space where they cannot be taken for one. That depends on how they begin.
  std::size_t last_end = 0; // of the number before
  bool last_changed = false;
  const auto emit = [&](const Token& token, std::optional<std::string> replacement) {
    const bool adjoins = token.begin == last_end && token.begin > 0;
    const std::string text = replacement ? *replacement : number(token);
    const bool separate = adjoins && (last_changed || replacement) && text[0] != '-' && text[0] != '+';
    if (replacement)
      edits.push_back({token.begin, token.end, (separate ? " " : "") + text});
    else if (separate)
      edits.push_back({token.begin, token.begin, " "});
    last_end = token.end;
    last_changed = replacement.has_value();
  };
  Vector control{0, 0};     // the last handle, as it will be
  std::size_t previous = 0; // the command that has drawn it, from 1 on
  char in_force = '\0';     // the letter that numbers without one would repeat
  auto origin = origins_.begin();
  for (std::size_t index = 0; index < commands_.size(); ++index) {
    const Command& command = commands_[index];
    char letter = command.letter;
    std::vector<std::optional<std::string>> values(command.numbers.size());
    std::string inserted; // in front of the numbers
    if (origin != origins_.end() && origin->command == index) {
      const std::vector<Vector>&old = subpaths_[origin->subpath].curves[origin->curve].points,
            &p = subpaths[origin->subpath].curves[origin->curve].points;
      const Vector zero = is_relative(letter) ? origin->start : Vector{0, 0};
      const char kind = upper(letter);
      const bool implied = kind == 'S' || kind == 'T';
      const bool reflects =
          implied && previous == index && index > 0 &&
          (kind == 'S' ? std::string_view("CS") : std::string_view("QT")).find(upper(commands_[index - 1].letter)) !=
              std::string_view::npos;
      const auto text = [&](std::int64_t x) { return subpaths_[origin->subpath].text(x); };
      const std::size_t written = implied ? 2 : 1; // the first control point with numbers of its own
      for (std::size_t k = written; k + 1 < p.size(); ++k) {
        const std::size_t n = 2 * (k - written);
        if (p[k].x != old[k].x) values[n] = text(p[k].x - zero.x);
        if (p[k].y != old[k].y) values[n + 1] = text(p[k].y - zero.y);
      }
      const Vector reflected = reflects ? 2 * p[0] - control : p[0];
      if (implied && p[1] != reflected) { // the full command
        letter = static_cast<char>(letter + (kind == 'S' ? 'C' - 'S' : 'Q' - 'T'));
        inserted = text(p[1].x - zero.x) + ' ' + text(p[1].y - zero.y) + ' ';
      }
      control = p[p.size() - 2];
      previous = index + 1;
      ++origin;
    }
    const bool letter_needed = command.given || repeated(in_force) != letter;
    if (command.given) {
      if (letter != command.letter || !inserted.empty())
        edits.push_back({command.given->begin, command.given->end, letter + inserted});
      last_end = command.given->end;
      last_changed = false;
      if (!inserted.empty()) last_end = 0;
    } else if (letter_needed || !inserted.empty()) {
      edits.push_back({command.numbers[0].begin, command.numbers[0].begin,
                       (letter_needed ? std::string(1, letter) : std::string(" ")) + inserted});
      last_end = 0;
    }
    if (command.given) last_end = 0; // a letter separates
    for (std::size_t k = 0; k < values.size(); ++k) emit(command.numbers[k], values[k]);
    in_force = letter;
  }
  return edits;
}
