// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_CSS_TRANSFORM_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_CSS_TRANSFORM_H

/// Transforms as style sheets write them, with units and commas, and their origins.

#include "formats/svg/Svg_scanner.h"
#include "formats/svg/Svg_transform.h"
#include "formats/svg/Svg_viewport.h"
#include "formats/svg/svg_shapes.h"
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

inline std::string in_small_letters(std::string_view text) {
  std::string s(text);
  for (char& c : s)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return s;
}

// Tells whether lengths may be without a unit, as they may in attributes of SVG.
enum class Css_units { needed, optional };

// Reads a length of CSS, which has a unit or is zero.
template <class FT>
FT parse_css_length(std::string_view text, const std::string& name, const std::optional<FT>& whole,
                    Css_units units = Css_units::needed) {
  const std::optional<FT> length = parse_svg_length<FT>(text, name, whole);
  const std::string shown = quoted_token(text);
  if (!length)
    throw Error(Error_code::malformed_input, name + ": " + shown + " is relative to something that is not known here");
  const char last = text[text.find_last_not_of(" \t\r\n\f")];
  const bool has_unit = !('0' <= last && last <= '9') && last != '.';
  if (units == Css_units::needed && !has_unit && *length != FT(0))
    throw Error(Error_code::malformed_input, name + ": " + shown + " has no unit, as lengths of CSS have");
  return *length;
}

// Reads a list of transforms of CSS.
template <class Traits> class Css_transform_reader {
  typedef typename Traits::FT FT;
  typedef std::vector<std::string> Arguments;

  std::string_view rest_;
  const std::string name_;
  const Svg_viewport<FT> viewport_;
  Svg_transform_product<Traits> product_;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, name_ + ": " + reason);
  }

  static std::string_view trimmed(std::string_view s) {
    const char* const space = " \t\r\n\f";
    const std::size_t begin = s.find_first_not_of(space);
    return begin == std::string_view::npos ? std::string_view()
                                           : s.substr(begin, s.find_last_not_of(space) + 1 - begin);
  }

  // A number, or one in percent.
  FT number(const std::string& text) const {
    Svg_scanner scanner(text, name_);
    const FT x = scanner.template leading_number<FT>();
    const std::string_view unit = scanner.rest();
    if (unit.empty()) return x;
    if (unit != "%") refuse(quoted_token(text) + " is not a number");
    return FT(x / FT(100));
  }

  // An angle in degrees. One in radians is rounded to double, as rotations are in any case.
  FT angle(const std::string& text) const {
    Svg_scanner scanner(text, name_);
    const FT x = scanner.template leading_number<FT>();
    const std::string unit = in_small_letters(scanner.rest());
    FT degrees = x;
    if (unit == "turn")
      degrees = FT(x * FT(360));
    else if (unit == "grad")
      degrees = FT(x * FT(9) / FT(10));
    else if (unit == "rad")
      degrees = FT(CGAL::to_double(x) * (180 / std::acos(-1.0)));
    else if (unit != "deg" && !(unit.empty() && x == FT(0)))
      refuse(quoted_token(text) + " is not an angle with a unit");
    if (!Quarter_turns<FT>::is_allowed(degrees)) refuse("an angle beyond 10^9 degrees");
    return degrees;
  }

  // Takes the name of a function and what stands between its parentheses, split at commas.
  std::string take_function(Arguments& arguments) {
    const std::size_t open = rest_.find('(');
    const std::size_t close = open == std::string_view::npos ? open : rest_.find_first_of("()", open + 1);
    if (close == std::string_view::npos) refuse(quoted_token(rest_.substr(0, 40)) + " is not a transform");
    const std::string function = in_small_letters(rest_.substr(0, open));
    if (rest_[close] == '(') refuse("a function in '" + function + "()' is not read");
    std::string_view inner = rest_.substr(open + 1, close - open - 1);
    for (std::size_t comma; (comma = inner.find(',')) != std::string_view::npos; inner.remove_prefix(comma + 1))
      arguments.emplace_back(trimmed(inner.substr(0, comma)));
    arguments.emplace_back(trimmed(inner));
    rest_ = trimmed(rest_.substr(close + 1));
    return function;
  }

  // A function, what its arguments are, and how many there are at least: x and y are lengths, n are
  // numbers, a are angles.
  struct Function {
    std::string_view name, arguments;
    std::size_t least;
  };
  static const Function* function(std::string_view name) {
    static const Function functions[] = {{"matrix", "nnnnnn", 6}, {"translate", "xy", 1}, {"translatex", "x", 1},
                                         {"translatey", "y", 1},  {"scale", "nn", 1},     {"scalex", "n", 1},
                                         {"scaley", "n", 1},      {"rotate", "a", 1},     {"skew", "aa", 1},
                                         {"skewx", "a", 1},       {"skewy", "a", 1}};
    for (const Function& f : functions)
      if (f.name == name) return &f;
    return nullptr;
  }

  FT argument(char kind, const std::string& text) const {
    if (kind == 'a') return angle(text);
    return kind == 'n' ? number(text)
                       : parse_css_length<FT>(text, name_, kind == 'x' ? viewport_.width : viewport_.height);
  }

  void read_transform() {
    Arguments arguments;
    const std::string name = take_function(arguments);
    const Function* const f = function(name);
    const std::size_t n = arguments.size();
    if (f == nullptr || n < f->least || f->arguments.size() < n)
      refuse("'" + name + "()' with " + std::to_string(n) + (n == 1 ? " argument" : " arguments") +
             " is not a transform in the plane");
    std::vector<FT> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back(argument(f->arguments[i], arguments[i]));
    try {
      add(name, x);
    } catch (const Error& error) {
      if (error.code() == Error_code::not_finite) throw;
      refuse(svg_reason(error));
    }
  }

  void add(const std::string& f, const std::vector<FT>& x) {
    const FT none(0), one(1), second = x.size() > 1 ? x[1] : none;
    if (f == "matrix") return product_.multiply(Svg_transform<Traits>({x[0], x[1], x[2], x[3], x[4], x[5]}));
    if (f == "translate" || f == "translatex") return product_.translate(x[0], second);
    if (f == "translatey") return product_.translate(none, x[0]);
    if (f == "scale") return product_.scale(x[0], x.back());
    if (f == "scalex") return product_.scale(x[0], one);
    if (f == "scaley") return product_.scale(one, x[0]);
    if (f == "rotate") return product_.rotate(x[0], none, none);
    if (f == "skewy") return product_.skew(none, x[0]);
    product_.skew(x[0], second);
  }

public:
  Css_transform_reader(std::string_view text, std::string name, const Svg_viewport<FT>& viewport)
      : rest_(trimmed(text)), name_(std::move(name)), viewport_(viewport) {}

  Svg_transform<Traits> operator()() {
    if (rest_.empty()) refuse("nothing where a transform is expected");
    while (!rest_.empty()) read_transform();
    try {
      return product_();
    } catch (const Error& error) {
      if (error.code() == Error_code::not_finite) throw;
      refuse(svg_reason(error));
    }
  }
};

/// Returns the map of a list of transforms of CSS, the property `transform`: `matrix`, `translate`,
/// `scale`, `rotate`, `skew` and those of one axis, with lengths and angles in their units;
/// percentages are parts of the viewport. Angles are those of `parse_svg_transform()`.
/// \throws Error `malformed_input` with a text `name: reason`, also for transforms in space and
///   functions such as `calc()`
template <class Traits>
Svg_transform<Traits> parse_css_transform(std::string_view text, const std::string& name,
                                          const Svg_viewport<typename Traits::FT>& viewport) {
  return Css_transform_reader<Traits>(text, name, viewport)();
}

/// Reads the property `transform-origin`, a point of the viewport: two lengths, percentages or
/// names of sides, or one of these.
/// \throws Error `malformed_input` with a text `name: reason`
template <class FT>
std::array<FT, 2> parse_css_origin(std::string_view text, const std::string& name, const Svg_viewport<FT>& viewport,
                                   Css_units units) {
  std::vector<std::string> words(1);
  for (const char c : in_small_letters(text))
    if (c != ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  if (words.back().empty()) words.pop_back();
  const auto is_horizontal = [](const std::string& w) { return w == "left" || w == "right"; };
  const auto is_vertical = [](const std::string& w) { return w == "top" || w == "bottom"; };
  if (words.size() == 3 && (words[2] == "0" || words[2] == "0px")) words.pop_back(); // in space
  if (words.size() == 1) words.emplace_back("center");
  if (words.size() == 2 && (is_vertical(words[0]) || is_horizontal(words[1]))) std::swap(words[0], words[1]);
  if (words.size() != 2 || is_vertical(words[0]) || is_horizontal(words[1]))
    throw Error(Error_code::malformed_input, name + ": " + quoted_token(text) + " is not a point in the plane");
  const auto coordinate = [&](const std::string& w, const std::optional<FT>& whole) {
    const bool begins = w == "left" || w == "top", ends = w == "right" || w == "bottom";
    return parse_css_length<FT>(begins ? "0%" : ends ? "100%" : w == "center" ? "50%" : w, name, whole, units);
  };
  return {coordinate(words[0], viewport.width), coordinate(words[1], viewport.height)};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_CSS_TRANSFORM_H
