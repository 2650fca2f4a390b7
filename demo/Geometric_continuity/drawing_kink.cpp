// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "drawing_kink.h"

#include "join_report.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/svg/svg_grade.h>
#include <CGAL/Geometric_continuity/joins/Kink_size.h>

#include <CGAL/Fraction_traits.h>

#include <array>
#include <sstream>

namespace {

typedef GC::Svg_segment<Drawing_traits> Segment;
typedef GC::Svg_transform<Drawing_traits> Transform;
typedef Drawing_traits::FT Number;

constexpr int most_decimals = 18;

// By how much a handle is off; empty for arcs, which have none.
std::optional<GC::Enclosure> handle_offset(const Segment& left, const Segment& right) {
  if (!left.bezier() || !right.bezier()) return std::nullopt;
  return GC::kink_size(*left.bezier(), *right.bezier())->handle_offset;
}

bool is_integer(const Number& x) {
  typedef CGAL::Fraction_traits<Number> Traits;
  Traits::Numerator_type numerator;
  Traits::Denominator_type denominator;
  Traits::Decompose()(x, numerator, denominator);
  return denominator == 1;
}

} // namespace

std::string four_certain_digits(const GC::Enclosure& x) {
  const std::string text = rounded(x.lower, 4);
  if (text == rounded(x.upper, 4)) return text;
  std::ostringstream both;
  both.precision(4);
  both << x;
  return both.str();
}

std::string Drawing_kink::text(const Segment& left, const Segment& right, GC::Join_grade grade) const {
  if (grade != GC::Join_grade::corner && grade != GC::Join_grade::kink) return to_string(grade);
  const std::optional<GC::Enclosure> radians = GC::tangent_angle(left, right);
  const std::string degrees = four_certain_digits(GC::in_degrees(*radians)) + " degrees";
  if (grade == GC::Join_grade::corner) return "corner of " + degrees;
  std::string s = "kink of " + degrees;
  const std::optional<GC::Enclosure> offset = handle_offset(left, right);
  if (!offset) return s;
  s += ", a handle is off by " + four_certain_digits(*offset);
  if (decimals() < 0) return s;
  Number unit(1);
  for (int i = 0; i < decimals(); ++i) unit *= 10;
  const Transform map = to_own_coordinates(unit);
  const GC::Enclosure units = *handle_offset(left.transform(map), right.transform(map));
  return s + " (" + four_certain_digits(units) + (units.upper == 1 ? " unit" : " units") + " of the last decimal)";
}

void Drawing_kink::write_json(std::ostream& os, const Segment& left, const Segment& right,
                              const std::optional<GC::Join_grade>& grade) const {
  if (!grade) {
    os << ",\"grade\":null,\"angle_degrees\":null";
    return;
  }
  os << ",\"grade\":\"" << *grade << "\",\"angle_degrees\":";
  if (*grade == GC::Join_grade::g1 || *grade == GC::Join_grade::g2) {
    os << "[0,0]";
    return;
  }
  GC::write_json(os, std::optional<GC::Enclosure>(GC::in_degrees(*GC::tangent_angle(left, right))));
  if (*grade == GC::Join_grade::kink)
    if (const std::optional<GC::Enclosure> offset = handle_offset(left, right))
      GC::write_json(os << ",\"handle_offset\":", offset);
}

// (x, y) -> (ax + cy + e, bx + dy + f) is inverted by Cramer's rule.
Transform Drawing_kink::to_own_coordinates(const Number& unit) const {
  const std::array<Number, 6>& m = element_.transform.matrix();
  const Number det = element_.transform.determinant() / unit;
  const Number a = m[3] / det, b = -m[1] / det, c = -m[2] / det, d = m[0] / det;
  return Transform({a, b, c, d, Number(-a * m[4] - c * m[5]), Number(-b * m[4] - d * m[5])});
}

int Drawing_kink::decimals() const {
  if (decimals_) return *decimals_;
  const Transform map = to_own_coordinates(Number(1));
  Number unit(1);
  int& count = decimals_.emplace(0);
  const auto include = [&](const Drawing_traits::Point& p) {
    const Drawing_traits::Point own = map(p);
    for (int i = 0; i < 2; ++i)
      for (; 0 <= count && !is_integer(Number(own[i] * unit)); unit *= 10)
        if (++count > most_decimals) count = -1;
  };
  for (const Segment& segment : path_.segments) {
    include(segment.start());
    if (segment.bezier())
      for (const Drawing_traits::Point& p : *segment.bezier()) include(p);
  }
  return count;
}
