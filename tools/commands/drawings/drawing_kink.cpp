// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/drawing_kink.h"

#include "commands/chains/join_report.h"
#include "commands/drawings/element_units.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/joins/path_continuity.h>

#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace {

typedef GC::Svg_transform<Drawing_traits> Transform;
typedef Drawing_traits::FT Number;
typedef CGAL::Interval_nt<false> Interval;

// The numbers of a kink, as enclosures.
struct Kink_numbers {
  GC::Enclosure degrees;
  std::optional<GC::Enclosure> offset,
      units; // of the handle: not at corners, not of arcs, and not where there are no decimals
};

Kink_numbers exact_numbers(const std::optional<Transform>& to_units, const Drawing_join& join, GC::Visual_class grade) {
  const auto &left = join.left(), &right = join.right();
  Kink_numbers n{GC::in_degrees(*segment_angle(left, right)), {}, {}};
  if (grade == GC::Visual_class::corner || !left.bezier() || !right.bezier()) return n;
  const auto offset = [](const auto& x, const auto& y) {
    return segment_kink(*x.bezier(), *y.bezier())->handle_offset;
  };
  n.offset = offset(left, right);
  if (to_units) n.units = offset(left.transform(*to_units), right.transform(*to_units));
  return n;
}

struct Enclosed_vector {
  Interval x, y;
};
Interval cross(const Enclosed_vector& a, const Enclosed_vector& b) { return a.x * b.y - a.y * b.x; }
Interval dot(const Enclosed_vector& a, const Enclosed_vector& b) { return a.x * b.x + a.y * b.y; }

// |a x b| / max(|a|, |b|), for an acute angle.
GC::Enclosure enclosed_offset(const Enclosed_vector& a, const Enclosed_vector& b) {
  const Interval offset = CGAL::abs(cross(a, b)) / CGAL::sqrt((CGAL::max)(dot(a, a), dot(b, b)));
  return {offset.inf(), offset.sup()};
}

GC::Enclosure enclosed_degrees(const Enclosed_vector& a, const Enclosed_vector& b) {
  const Interval sine = CGAL::abs(cross(a, b)), cosine = dot(a, b);
  const double degree = 57.29577951308232, rounding = 1e-14; // of atan2() in any rounding mode
  // the angle falls with the cosine; with the sine it grows up to a right angle, and falls beyond
  const double low = std::atan2(cosine.sup() < 0 ? sine.sup() : sine.inf(), cosine.sup()),
               high = std::atan2(cosine.inf() < 0 ? sine.inf() : sine.sup(), cosine.inf());
  return {low * degree * (1 - rounding), high * degree * (1 + rounding)};
}

// Computes the numbers from enclosures of the jets, where both segments are short Bezier curves
// whose handles are not parallel, at a kink with an acute angle.
std::optional<Kink_numbers> enclosed_numbers(const std::array<Interval, 4>* to_units, const Drawing_join& join,
                                             GC::Visual_class grade) {
  std::optional<Kink_numbers> numbers;
  GC::visit_enclosures(join, [&](const auto& x, const auto& y) {
    const Interval m(join.left().bezier()->degree()), n(join.right().bezier()->degree());
    const Enclosed_vector a{x[1][0] / m, x[1][1] / m}, b{y[1][0] / n, y[1][1] / n};
    if (!(0 < CGAL::abs(cross(a, b)).inf())) return;
    if (grade == GC::Visual_class::kink && !(0 < dot(a, b).inf())) return;
    numbers = Kink_numbers{enclosed_degrees(a, b), {}, {}};
    if (grade == GC::Visual_class::corner) return;
    numbers->offset = enclosed_offset(a, b);
    if (!to_units) return;
    const auto image = [&m = *to_units](const Enclosed_vector& v) -> Enclosed_vector {
      return {m[0] * v.x + m[2] * v.y, m[1] * v.x + m[3] * v.y};
    };
    numbers->units = enclosed_offset(image(a), image(b));
  });
  return numbers;
}

// The number where four digits of it are known, otherwise nothing.
std::optional<std::string> certain_text(const GC::Enclosure& x) {
  std::string text = rounded(x.lower, 4);
  return text == rounded(x.upper, 4) ? std::optional<std::string>(std::move(text)) : std::nullopt;
}

std::string text(const GC::Enclosure& x) {
  if (const std::optional<std::string> certain = certain_text(x)) return *certain;
  std::ostringstream bounds;
  bounds.precision(4);
  bounds << x;
  return bounds.str();
}

// Returns the words with the texts text(number) of the numbers, or nothing if one of them is empty.
template <class Text> std::optional<std::string> words(const Kink_numbers& numbers, GC::Visual_class grade, Text text) {
  std::string s;
  s.reserve(128);
  s = to_string(grade);
  const auto add = [&](const char* before, const GC::Enclosure& x) {
    const std::optional<std::string> x_text = text(x);
    if (x_text) append(s, before, *x_text);
    return x_text;
  };
  if (!add(" of ", numbers.degrees)) return std::nullopt;
  s += " degrees";
  if (numbers.offset && !add(", a handle is off by ", *numbers.offset)) return std::nullopt;
  if (!numbers.units) return s;
  const std::optional<std::string> units = add(" (", *numbers.units);
  if (!units) return std::nullopt;
  append(s, *units == "1" ? " unit" : " units", " of the last decimal)");
  return s;
}

} // namespace

Drawing_kink_words::Drawing_kink_words(const Drawing_element& element) : to_units_(to_units(element)) {
  if (!to_units_) return;
  for (int i = 0; i < 4; ++i) enclosed_to_units_[i] = Interval(CGAL::to_interval(to_units_->matrix()[i]));
}

std::string Drawing_kink_words::operator()(const Drawing_join& join, GC::Visual_class grade) const {
  if (grade != GC::Visual_class::corner && grade != GC::Visual_class::kink) return to_string(grade);
  const auto enclosed = enclosed_numbers(to_units_ ? &enclosed_to_units_ : nullptr, join, grade);
  if (enclosed)
    if (const std::optional<std::string> certain = words(*enclosed, grade, certain_text)) return *certain;
  return *words(exact_numbers(to_units_, join, grade), grade,
                [](const GC::Enclosure& x) { return std::optional<std::string>(text(x)); });
}

std::optional<GC::Enclosure> angle_bounds(const GC::Path_segment<Drawing_traits>& left,
                                          const GC::Path_segment<Drawing_traits>& right) {
  const std::optional<GC::Enclosure> angle = segment_angle(left, right);
  return angle ? std::optional<GC::Enclosure>(GC::in_degrees(*angle)) : std::nullopt;
}

void write_drawing_kink(std::ostream& os, const GC::Svg_segment<Drawing_traits>& left,
                        const GC::Svg_segment<Drawing_traits>& right, const std::optional<GC::Visual_class>& grade) {
  if (!grade) {
    GC::write_json(os << ",\"grade\":null,\"angle_degrees\":", angle_bounds(left, right));
    return;
  }
  os << ",\"grade\":\"" << *grade << "\",\"angle_degrees\":";
  if (*grade == GC::Visual_class::g1 || *grade == GC::Visual_class::g2) {
    os << "[0,0]";
    return;
  }
  GC::write_json(os, angle_bounds(left, right));
  if (*grade == GC::Visual_class::kink && left.bezier() && right.bezier())
    GC::write_json(os << ",\"handle_offset\":",
                   std::optional<GC::Enclosure>(segment_kink(*left.bezier(), *right.bezier())->handle_offset));
}
