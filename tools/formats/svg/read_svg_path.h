// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_READ_SVG_PATH_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_READ_SVG_PATH_H

#include "formats/svg/Svg_path_builder.h"
#include "formats/svg/Svg_scanner.h"
#include "formats/svg/svg_size.h"
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// One command of path data, and where it stands.
struct Svg_command {
  /// that is in force; that of L and l for what follows a point of M and m
  char letter;
  /// whether the letter is written, as the first character of the command
  bool is_given;
  std::size_t begin;        ///< where the command begins
  std::size_t first_number; ///< the index of its first number in `Svg_path_places::numbers`
};

/// Where the commands of path data and their numbers stand.
struct Svg_path_places {
  long long first_command = 1; ///< the number of the first one of `commands`
  std::vector<Svg_command> commands;
  std::vector<Text_range> numbers; ///< of these commands; flags are numbers, too

  /// Forgets the commands before the one of this number.
  void forget_before(long long command) {
    const auto end = commands.begin() + static_cast<std::ptrdiff_t>(command - first_command);
    const std::size_t used = end == commands.end() ? numbers.size() : end->first_number;
    commands.erase(commands.begin(), end);
    numbers.erase(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(used));
    for (Svg_command& c : commands) c.first_number -= used;
    first_command = command;
  }
};

/// Reads the subpaths of SVG path data, the attribute `d`, one after the other: the commands M, L,
/// H, V, C, S, Q, T, A and Z, absolute and relative, with implicit repetitions, and numbers with as
/// few separators as the grammar of SVG allows.
///
/// Coordinates are read by `parse_number()`, so that in an exact field the decimals are taken
/// exactly, and sums of relative coordinates are exact too. Arcs stay arcs of ellipses, see
/// `Elliptical_arc`. As SVG says, an arc with a zero radius is a line, one with equal ends is
/// omitted, and Z draws a line unless the subpath is already at its start.
///
/// A cubic or a quadratic with a handle at its node has a zero tangent there. When all its control
/// points lie between its ends, this is how editors write a line, and it is read as a line. A
/// segment of no length is kept; its tangents are zero.
///
/// Where SVG asks a viewer to draw what comes before an error, this reader throws, and then gives
/// that by `before_error()`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2 whose `FT` is accepted by
///   `parse_number()`
template <class Traits> class Svg_path_reader {
  typedef typename Traits::FT FT;
  typedef Coordinate_vector<FT, 2> Coordinates;

  Svg_scanner scanner_;
  Svg_path_builder<Traits> builder_;
  const Coordinates zero_{2};
  char letter_ = '\0';
  bool ended_ = false;
  Svg_path_places* const places_;

public:
  /// Reads `text`, which must outlive the reader. Error messages begin with `name`. Each command
  /// that is read is added to `places`.
  explicit Svg_path_reader(std::string_view text, std::string name = "path data", Svg_path_places* places = nullptr)
      : scanner_(text, std::move(name)), places_(places) {
    scanner_.skip_space();
  }

  /// Returns the next subpath, or nothing at the end. A subpath without segments is left out unless
  /// it is closed. After an error only `before_error()` can be called.
  /// \throws Error `malformed_input` with a text `name, character N: reason`, where `N` counts from
  ///   1, for everything that is no path data, for numbers that `double` cannot hold or
  ///   `Elliptical_arc` refuses, and in an exact field for numbers and coordinates of more than
  ///   `max_svg_number_bits` bits and for arcs with a ratio of the radii of more than
  ///   `max_svg_ratio_bits` or an `Elliptical_arc::radicand()` of more than `max_svg_radicand_bits`
  std::optional<Svg_subpath<Traits>> next() {
    while (!ended_) {
      if (scanner_.at_end()) {
        scanner_.refuse_comma();
        builder_.end();
        ended_ = true;
      } else {
        const std::size_t begin = scanner_.position();
        const bool repeated = is_repeated();
        execute(repeated ? repeated_letter() : next_letter(), begin, !repeated);
      }
      if (std::optional<Svg_subpath<Traits>> subpath = builder_.take_complete()) return subpath;
    }
    return std::nullopt;
  }

  /// Returns, after an error, what its subpath draws before the command with the error, if that is
  /// anything.
  std::optional<Svg_subpath<Traits>> before_error() {
    builder_.end();
    return builder_.take_complete();
  }

private:
  static char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

  // Numbers behind a command repeat it, and those behind M are lines.
  bool is_repeated() const { return letter_ != '\0' && upper(letter_) != 'Z' && scanner_.at_number(); }
  char repeated_letter() const { return letter_ == 'M' ? 'L' : letter_ == 'm' ? 'l' : letter_; }

  char next_letter() {
    scanner_.refuse_comma();
    const char letter = scanner_.letter(letter_ == '\0' ? "the command M" : "a command");
    if (letter_ == '\0' && upper(letter) != 'M') scanner_.refuse("the path does not begin with the command M");
    if (std::string_view("MLHVCSQTAZ").find(upper(letter)) == std::string_view::npos)
      scanner_.refuse(std::string("'") + letter + "' is not a command");
    return letter;
  }

  void execute(char letter, std::size_t begin, bool is_given) {
    const bool relative = upper(letter) != letter;
    letter_ = letter;
    builder_.begin_command(letter, begin);
    if (places_ != nullptr) places_->commands.push_back({letter, is_given, begin, places_->numbers.size()});
    const Coordinates& origin = relative ? builder_.current() : zero_;
    switch (upper(letter)) {
    case 'M': return builder_.move_to(point(origin));
    case 'L': return builder_.line_to(point(origin));
    case 'H': return builder_.line_to(coordinate(0, origin));
    case 'V': return builder_.line_to(coordinate(1, origin));
    case 'C': return builder_.curve_to(points(origin, std::nullopt, 3));
    case 'S': return builder_.curve_to(points(origin, reflected(3), 2));
    case 'Q': return builder_.curve_to(points(origin, std::nullopt, 2));
    case 'T': return builder_.curve_to(points(origin, reflected(2), 1));
    case 'A': return arc(origin);
    default: return builder_.close();
    }
  }

  // The next number, whose place is noted.
  FT number() {
    const FT x = scanner_.template number<FT>();
    note_place();
    return x;
  }
  bool flag() {
    const bool x = scanner_.flag();
    note_place();
    return x;
  }
  void note_place() {
    if (places_ != nullptr) places_->numbers.push_back(scanner_.last_number());
  }

  Coordinates point(const Coordinates& origin) {
    Coordinates x;
    read_point(origin, x);
    return x;
  }
  void read_point(const Coordinates& origin, Coordinates& x) {
    for (int i = 0; i < 2; ++i) x[i] = moved(origin[i]);
  }

  // The next number, added to a coordinate of the origin.
  FT moved(const FT& origin) {
    const FT x = short_sum(origin, number());
    check(x);
    return x;
  }

  void check(const FT& x) const {
    if constexpr (std::is_floating_point_v<FT>)
      if (!std::isfinite(x)) scanner_.refuse("a coordinate outside the range of floating-point numbers");
    if (!has_short_parts<max_svg_number_bits>(x))
      scanner_.refuse("a coordinate of more than " + std::to_string(max_svg_number_bits) + " bits");
  }

  // The handle of the last command of this degree, reflected at the current point.
  Coordinates reflected(int degree) const {
    const Coordinates x = builder_.reflected_control(degree);
    for (int i = 0; i < 2; ++i) check(x[i]);
    return x;
  }

  // The current point with one coordinate changed.
  Coordinates coordinate(int i, const Coordinates& origin) {
    Coordinates x = builder_.current();
    x[i] = moved(origin[i]);
    return x;
  }

  // The current point, possibly a reflected handle, and the points that follow.
  std::vector<Coordinates> points(const Coordinates& origin, std::optional<Coordinates> handle, int more) {
    std::vector<Coordinates> result;
    result.reserve(4);
    result.push_back(builder_.current());
    if (handle) result.push_back(std::move(*handle));
    for (int j = 0; j < more; ++j) read_point(origin, result.emplace_back());
    return result;
  }

  void arc(const Coordinates& origin) {
    Elliptical_arc_parameters<FT> parameters;
    parameters.rx = number();
    parameters.ry = number();
    parameters.rotation = scanner_.template angle<FT>();
    note_place();
    parameters.large = flag();
    parameters.sweep = flag();
    const Coordinates end = point(origin);
    try {
      builder_.arc_to(parameters, end);
    } catch (const Error& error) { // sizes that differ too much
      scanner_.refuse(error.what());
    }
  }
};

/// Returns all subpaths of SVG path data.
/// \throws Error as `Svg_path_reader` does
template <class Traits>
std::vector<Svg_subpath<Traits>> read_svg_path(std::string_view text, const std::string& name = "path data") {
  Svg_path_reader<Traits> reader(text, name);
  std::vector<Svg_subpath<Traits>> subpaths;
  while (std::optional<Svg_subpath<Traits>> subpath = reader.next()) subpaths.push_back(*std::move(subpath));
  return subpaths;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_READ_SVG_PATH_H
