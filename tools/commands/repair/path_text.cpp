// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/path_text.h"

#include "commands/repair/grid_number.h"

#include <algorithm>
#include <utility>

namespace {

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_relative(char letter) { return upper(letter) != letter; }

// The letter of numbers that follow a command without another letter.
char repeated(char letter) { return letter == 'M' ? 'L' : letter == 'm' ? 'l' : letter; }

std::size_t end_of_numbers(const GC::Svg_path_places& places, std::size_t command) {
  return command + 1 < places.commands.size() ? places.commands[command + 1].first_number : places.numbers.size();
}

Drawing_traits::FT power_of_ten(int exponent) {
  Drawing_traits::FT power(1);
  for (; exponent > 0; --exponent) power *= 10;
  return power;
}

// Puts edits together: numbers may follow each other without a space where they cannot be taken for
// one, which depends on how they begin.
class Edit_list {
  const std::string_view data_;
  Path_decimals& decimals_;
  std::size_t last_end_ = 0; // of the number before; 0 behind a letter
  bool last_changed_ = false;

public:
  std::vector<Text_edit> edits;

  Edit_list(std::string_view data, Path_decimals& decimals) : data_(data), decimals_(decimals) {}

  void letter(const GC::Text_range& range, const std::optional<std::string>& replacement) {
    if (replacement) edits.push_back({range, *replacement});
    last_end_ = 0;
    last_changed_ = false;
  }

  void number(const GC::Text_range& range, std::optional<std::string> replacement) {
    if (replacement) keep_grid(range, *replacement);
    const char first = replacement ? (*replacement)[0] : data_[range.begin];
    const bool adjoins = range.begin == last_end_ && range.begin > 0;
    const bool separate = adjoins && (last_changed_ || replacement) && first != '-' && first != '+';
    if (replacement)
      edits.push_back({range, (separate ? " " : "") + *replacement});
    else if (separate)
      edits.push_back({{range.begin, range.begin}, " "});
    last_end_ = range.end;
    last_changed_ = replacement.has_value();
  }

private:
  static int decimals(std::string_view number) { return Grid_number::read(number)->decimals; }

  void keep_grid(const GC::Text_range& range, std::string& number) {
    if (decimals_.most == 0) return;
    if (decimals(data_.substr(range.begin, range.end - range.begin)) == decimals_.most) --decimals_.finest;
    if (decimals_.finest == 0) {
      if (decimals(number) == 0) number += '.';
      while (decimals(number) < decimals_.most) number += '0';
    }
    decimals_.finest += decimals(number) == decimals_.most;
  }
};

} // namespace

void Path_decimals::add(std::string_view data, const GC::Svg_path_places& places) {
  for (std::size_t i = 0; i < places.commands.size(); ++i) {
    const GC::Svg_command& command = places.commands[i];
    const std::size_t end = end_of_numbers(places, i);
    for (std::size_t k = command.first_number + (upper(command.letter) == 'A' ? 5 : 0); k < end; ++k) {
      const std::string_view number =
          data.substr(places.numbers[k].begin, places.numbers[k].end - places.numbers[k].begin);
      const std::optional<Grid_number> x = Grid_number::read(number);
      if (!x || x->decimals > Grid_number::max_decimals)
        refusal = "a number has too many digits: " + std::string(number.substr(0, 30));
      else {
        if (x->decimals > most) finest = 0;
        most = (std::max)(most, x->decimals);
        finest += x->decimals == most;
      }
    }
  }
}

void Path_text::forget() {
  if (places_.commands.empty()) return;
  const long long last = places_.first_command + static_cast<long long>(places_.commands.size()) - 1;
  // the M that ends a subpath begins the next
  places_.forget_before(upper(places_.commands.back().letter) == 'M' ? last : last + 1);
}

bool Path_text::next() {
  forget();
  std::optional<Drawing_subpath> subpath = reader_.next();
  if (!subpath) return false;
  subpath_ = *std::move(subpath);
  subpath_.leave_out_points();
  if (is_filled_) subpath_.join_ends();
  return true;
}

std::optional<GC::Grid_vector> Path_text::on_grid(const Drawing_traits::Point& point) const {
  const Drawing_traits::FT unit = power_of_ten(decimals_.most);
  const double x = CGAL::to_double(Drawing_traits::FT(point.x() * unit)),
               y = CGAL::to_double(Drawing_traits::FT(point.y() * unit));
  if (!((std::max)(std::abs(x), std::abs(y)) <= static_cast<double>(max_grid_coordinate))) return std::nullopt;
  return GC::Grid_vector{static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
}

Grid_curve Path_text::curve(const GC::Svg_segment<Drawing_traits>& segment) const {
  Grid_curve result;
  if (segment.arc()) {
    const Drawing_traits::FT unit = power_of_ten(decimals_.most), zero(0);
    result.arc = std::make_shared<const Exact_segment>(
        static_cast<const Exact_segment&>(segment).transform(Drawing_transform({unit, zero, zero, unit, zero, zero})));
    result.reason = "an arc of a rotated ellipse";
    return result;
  }
  for (const Drawing_traits::Point& p : *segment.bezier())
    if (const std::optional<GC::Grid_vector> v = on_grid(p))
      result.points.push_back(*v);
    else {
      result.points.clear();
      result.reason = "a coordinate is too large for its decimals";
      break;
    }
  return result;
}

Grid_contour Path_text::contour() const {
  Grid_contour result;
  result.closed = subpath_.closed;
  result.decimals = decimals_.most;
  result.map = map_;
  result.curves.reserve(subpath_.segments.size());
  for (const auto& segment : subpath_.segments) result.curves.push_back(curve(segment));
  return result;
}

std::vector<Text_edit> Path_text::edits(const Grid_contour& from, const Grid_contour& to) {
  typedef GC::Grid_vector Vector;
  Edit_list list(data_, decimals_);
  Vector moved{0, 0};     // by which the handle that a shorthand reflects has moved
  long long moved_by = 0; // the command that draws its curve
  char in_force = '\0';   // the letter that numbers without one would repeat
  std::size_t segment = 0;
  for (std::size_t i = 0; i < places_.commands.size(); ++i) {
    const GC::Svg_command& command = places_.commands[i];
    const long long number = places_.first_command + static_cast<long long>(i);
    const std::size_t begin = command.first_number, end = end_of_numbers(places_, i);
    char letter = command.letter;
    std::vector<std::optional<std::string>> values(end - begin);
    std::string inserted; // in front of the numbers
    if (segment < subpath_.segments.size() && subpath_.segments[segment].command == number) {
      const std::vector<Vector>&old = from.curves[segment].points, &p = to.curves[segment].points;
      const char kind = upper(letter);
      if (p.size() > 2) {
        const auto text = [&](const Vector& v) -> std::pair<std::string, std::string> {
          const Vector x = is_relative(letter) ? v - p[0] : v;
          return {from.text(x.x), from.text(x.y)};
        };
        const bool implied = kind == 'S' || kind == 'T';
        // the first control point with numbers of its own
        const std::size_t written = implied ? 2 : 1;
        for (std::size_t k = written; k + 1 < p.size(); ++k) {
          const auto [x, y] = text(p[k]);
          if (p[k].x != old[k].x) values[2 * (k - written)] = x;
          if (p[k].y != old[k].y) values[2 * (k - written) + 1] = y;
        }
        const char before = i > 0 && moved_by == number - 1 ? upper(places_.commands[i - 1].letter) : '\0';
        const bool reflects = kind == 'S' ? before == 'C' || before == 'S' : before == 'Q' || before == 'T';
        if (implied && p[1] != (reflects ? old[1] - moved : old[1])) { // the full command
          const auto [x, y] = text(p[1]);
          letter = static_cast<char>(letter + (kind == 'S' ? 'C' - 'S' : 'Q' - 'T'));
          inserted = x + ' ' + y + ' ';
        }
        moved = p[p.size() - 2] - old[p.size() - 2];
        moved_by = number;
      }
      ++segment;
    }
    const std::size_t first = begin < end ? places_.numbers[begin].begin : command.begin;
    const bool letter_needed = command.is_given || repeated(in_force) != letter;
    if (command.is_given) {
      const bool changes = letter != command.letter || !inserted.empty();
      list.letter({command.begin, command.begin + 1},
                  changes ? std::optional<std::string>(letter + inserted) : std::nullopt);
    } else if (letter_needed || !inserted.empty())
      list.letter({first, first}, (letter_needed ? std::string(1, letter) : std::string(" ")) + inserted);
    for (std::size_t k = begin; k < end; ++k) list.number(places_.numbers[k], values[k - begin]);
    in_force = letter;
  }
  return std::move(list.edits);
}
