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

// Puts edits together: numbers may follow each other without a space where they cannot be taken for
// one, which depends on how they begin.
class Edit_list {
  const std::string_view data_;
  Path_decimals& decimals_;
  const bool keeps_grid_;
  std::size_t last_end_ = 0; // of the number before; 0 behind a letter
  bool last_changed_ = false;

public:
  std::vector<Text_edit> edits;

  Edit_list(std::string_view data, Path_decimals& decimals, bool keeps_grid)
      : data_(data), decimals_(decimals), keeps_grid_(keeps_grid) {}

  void letter(const GC::Text_range& range, const std::optional<std::string>& replacement) {
    if (replacement) edits.push_back({range, *replacement});
    last_end_ = 0;
    last_changed_ = false;
  }

  void number(const GC::Text_range& range, std::optional<std::string> replacement, bool is_coordinate) {
    if (replacement && keeps_grid_ && is_coordinate) keep_grid(range, *replacement);
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
        fit = false;
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
  if (segment.arc()) return arc(segment, decimals_.most);
  Grid_curve result;
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

std::string_view Path_text::number(std::size_t index) const {
  return data_.substr(places_.numbers[index].begin, places_.numbers[index].end - places_.numbers[index].begin);
}

Grid_curve Path_text::arc(const GC::Svg_segment<Drawing_traits>& segment, int decimals) const {
  const Drawing_traits::FT unit = power_of_ten(decimals), zero(0);
  Grid_curve result;
  result.arc = std::make_shared<const Exact_segment>(
      static_cast<const Exact_segment&>(segment).transform(Drawing_transform({unit, zero, zero, unit, zero, zero})));
  result.reason = "an arc of a rotated ellipse";
  const std::size_t first =
      places_.commands[static_cast<std::size_t>(segment.command - places_.first_command)].first_number;
  const auto value = [&](std::size_t k) { return GC::parse_number<Drawing_traits::FT>(number(first + k)); };
  result.written = {Drawing_traits::FT(value(0) * unit), Drawing_traits::FT(value(1) * unit), value(2), value(3) != 0,
                    value(4) != 0};
  return result;
}

template <class Curve> Grid_contour Path_text::contour_of(int decimals, Curve curve) const {
  Grid_contour result;
  result.closed = subpath_.closed;
  result.decimals = decimals;
  result.map = map_;
  result.curves.reserve(subpath_.segments.size());
  for (const auto& segment : subpath_.segments) result.curves.push_back(curve(segment));
  if (subpath_.closed || subpath_.segments.empty()) return result;
  // ends that are written once, and on which nothing else depends
  const std::size_t first = static_cast<std::size_t>(subpath_.segments.front().command - places_.first_command),
                    last = static_cast<std::size_t>(subpath_.segments.back().command - places_.first_command);
  const auto is_move = [&](std::size_t i) { return places_.commands[i].letter == 'M'; };
  result.has_free_start = first > 0 && (is_move(first - 1) || (places_.first_command == 1 && first == 1)) &&
                          places_.commands[first].is_given;
  result.has_free_end = last + 1 == places_.commands.size() || is_move(last + 1);
  return result;
}

Grid_contour Path_text::contour() const {
  return contour_of(decimals_.most, [&](const auto& segment) { return curve(segment); });
}

Grid_contour Path_text::contour_beside_grid(int decimals) const {
  Grid_contour result = contour_of(decimals, [&](const auto& segment) {
    if (segment.arc()) return arc(segment, decimals);
    return curve_beside_grid({segment.bezier()->begin(), segment.bezier()->end()}, decimals);
  });
  result.is_beside_grid = true;
  return result;
}

int Path_text::coarser_decimals(std::int64_t longest) const {
  std::vector<Drawing_traits::Point> nodes;
  for (const auto& segment : subpath_.segments) {
    nodes.push_back(segment.start());
    nodes.push_back(segment.end());
  }
  return ::coarser_decimals(nodes, longest);
}

std::string Path_text::moved_text(std::size_t index, const Drawing_traits::FT& by, const Grid_contour& contour) const {
  return contour.text(
      Drawing_traits::FT(GC::parse_number<Drawing_traits::FT>(number(index)) * power_of_ten(contour.decimals) + by));
}

std::vector<Text_edit> Path_text::edits(const Grid_contour& from, const Grid_contour& to) {
  Edit_list list(data_, decimals_, !from.is_beside_grid);
  Grid_offset moved(0, 0); // by which the handle that a shorthand reflects has moved
  long long moved_by = 0;  // the command that draws its curve
  char in_force = '\0';    // the letter that numbers without one would repeat
  std::size_t segment = 0;
  for (std::size_t i = 0; i < places_.commands.size(); ++i) {
    const GC::Svg_command& command = places_.commands[i];
    const long long number = places_.first_command + static_cast<long long>(i);
    const std::size_t begin = command.first_number, end = end_of_numbers(places_, i);
    char letter = command.letter;
    std::vector<std::optional<std::string>> values(end - begin);
    std::string inserted; // in front of the numbers
    bool is_arc = false;
    if (segment == 0 && !from.curves.empty() && upper(letter) == 'M' && from.curves[0].arc &&
        subpath_.segments[0].command == number + 1) {
      const Drawing_traits::Point p = to.curves[0].arc->start();
      const Grid_offset v = p - from.curves[0].arc->start();
      if (v.x() != 0) values[0] = moved_text(begin, v.x(), to);
      if (v.y() != 0) values[1] = moved_text(begin + 1, v.y(), to);
    }
    if (segment < subpath_.segments.size() && subpath_.segments[segment].command == number) {
      if (from.curves[segment].arc) {
        is_arc = true;
        const Grid_curve &x = from.curves[segment], &y = to.curves[segment];
        if (x.written->rx != y.written->rx) values[0] = to.text(y.written->rx);
        if (x.written->ry != y.written->ry) values[1] = to.text(y.written->ry);
        Grid_offset v = y.arc->end() - x.arc->end();
        if (is_relative(letter)) v = v - (y.arc->start() - x.arc->start());
        if (v.x() != 0) values[5] = moved_text(begin + 5, v.x(), to);
        if (v.y() != 0) values[6] = moved_text(begin + 6, v.y(), to);
      }
      const Grid_curve &old = from.curves[segment], &p = to.curves[segment];
      const char kind = upper(letter);
      if (p.points.size() > 2) {
        const auto text = [&](std::size_t k) -> std::pair<std::string, std::string> {
          const GC::Grid_vector x = is_relative(letter) ? p.points[k] - p.points[0] : p.points[k];
          if (!to.is_beside_grid) return {to.text(x.x), to.text(x.y)};
          const Grid_offset y = exact_point(p, k) - (is_relative(letter) ? exact_point(p, 0) : CGAL::ORIGIN);
          return {to.text(y.x()), to.text(y.y())};
        };
        const auto move = [&](std::size_t k) { return exact_point(p, k) - exact_point(old, k); };
        const bool implied = kind == 'S' || kind == 'T';
        // the first control point with numbers of its own
        const std::size_t written = implied ? 2 : 1;
        for (std::size_t k = written; k + 1 < p.points.size(); ++k) {
          const Grid_offset v = move(k);
          if (v == CGAL::NULL_VECTOR) continue;
          const auto [x, y] = text(k);
          if (v.x() != 0) values[2 * (k - written)] = x;
          if (v.y() != 0) values[2 * (k - written) + 1] = y;
        }
        const char before = i > 0 && moved_by == number - 1 ? upper(places_.commands[i - 1].letter) : '\0';
        const bool reflects = kind == 'S' ? before == 'C' || before == 'S' : before == 'Q' || before == 'T';
        if (implied && move(1) != (reflects ? -moved : Grid_offset(0, 0))) { // the full command
          const auto [x, y] = text(1);
          letter = static_cast<char>(letter + (kind == 'S' ? 'C' - 'S' : 'Q' - 'T'));
          inserted = x + ' ' + y + ' ';
        }
        moved = move(p.points.size() - 2);
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
    for (std::size_t k = begin; k < end; ++k)
      list.number(places_.numbers[k], values[k - begin], !is_arc || k - begin >= 5);
    in_force = letter;
  }
  return std::move(list.edits);
}
