// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H

#include "formats/font/Glyph_outline.h"

#include <CGAL/Geometric_continuity/joins/Visual_join.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace GC = CGAL::Geometric_continuity;

// The grades of a join of a glyph, from the worst to the best. The angle between the tangents is
// larger than a bound at a corner, which is intended, and smaller at the next three.
enum class Glyph_grade {
  corner,
  kink,     // a handle is off
  bend,     // between two straight lines, where no handle can be off
  rounding, // a handle, or a line, is off by no more than rounding explains
  g1,
  g2
};

inline std::string to_string(Glyph_grade grade) {
  static const char* const names[] = {"corner", "kink", "bend", "rounding", "G1", "G2"};
  return names[static_cast<std::size_t>(grade)];
}

// Returns whether a handle or a line is off.
inline bool is_off(Glyph_grade grade) {
  return grade == Glyph_grade::kink || grade == Glyph_grade::bend || grade == Glyph_grade::rounding;
}

// Returns whether it is off by more than rounding explains.
inline bool is_defect(Glyph_grade grade) { return is_off(grade) && grade != Glyph_grade::rounding; }

__extension__ typedef __int128 Glyph_integer;
typedef GC::Visual_join<Glyph_point, Glyph_integer> Glyph_integer_join;

// Returns whether doubles of these magnitudes tell which one is larger, if both are right up to
// 2^-48; empty if they do not.
inline std::optional<bool> is_surely_larger(double x, double y) {
  if (std::abs(x - y) <= 0x1p-46 * (std::abs(x) + std::abs(y))) return std::nullopt;
  return x > y;
}

// By how many units of the font a handle may be off because of rounding.
class Handle_rounding {
  typedef Glyph_integer_join Numbers;
  typedef Numbers::Field FT;
  FT units_;
  double value_;

public:
  explicit Handle_rounding(const FT& units = FT(1)) : units_(units), value_(CGAL::to_double(units)) {}

  const FT& units() const { return units_; }

  // Returns whether numerator^2 / denominator, in steps of which a unit has so many, is larger than
  // the square of the bound.
  bool is_exceeded(Glyph_integer numerator, Glyph_integer denominator, std::int64_t steps) const {
    const double n = Numbers::rounded(numerator), bound = value_ * static_cast<double>(steps);
    if (const auto answer = is_surely_larger(n * n, bound * bound * Numbers::rounded(denominator))) return *answer;
    constexpr Glyph_integer small = Glyph_integer(1) << 60;
    if (value_ == 1 && -small < numerator && numerator < small && denominator < small && steps == 2)
      return numerator * numerator > 4 * denominator;
    const FT x = Numbers::exact(numerator), y = units_ * FT(static_cast<double>(steps));
    return FT(y * y) * Numbers::exact(denominator) < FT(x * x);
  }
};

// Two segments that meet at a node. They have a length.
class Glyph_join {
  typedef Glyph_integer Integer;
  const Glyph_integer_join join_;
  const Glyph_point& node_;
  const std::int64_t steps_;

  static Integer square(const Glyph_integer_join::Vector& v) { return Integer(v[0]) * v[0] + Integer(v[1]) * v[1]; }
  static double length(const Glyph_integer_join::Vector& v) {
    return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]));
  }

public:
  // A unit of the font has so many steps.
  Glyph_join(const Glyph_segment& left, const Glyph_segment& right, std::int64_t steps)
      : join_(left.points.data(), left.degree, right.points.data(), right.degree), node_(right.start()), steps_(steps) {
  }

  const Glyph_point& node() const { return node_; }

  // The join on the grid of the glyph.
  const Glyph_integer_join& on_grid() const { return join_; }

  // Returns whether the angle of the tangents is larger than a bound.
  bool exceeds(const GC::Corner_threshold& bound) const { return join_.exceeds(bound); }

  Glyph_grade grade(const GC::Corner_threshold& bound, const Handle_rounding& rounding) const {
    switch (*join_.visual_class(bound)) {
    case GC::Visual_class::g2: return Glyph_grade::g2;
    case GC::Visual_class::g1: return Glyph_grade::g1;
    case GC::Visual_class::kink: break;
    default: return Glyph_grade::corner;
    }
    if (!is_off_by_more_than(rounding)) return Glyph_grade::rounding;
    return join_.is_of_lines() ? Glyph_grade::bend : Glyph_grade::kink;
  }

  // Returns whether a handle is off by more than that, see GC::Kink_size.
  bool is_off_by_more_than(const Handle_rounding& rounding) const {
    const Integer aa = square(join_.incoming()), bb = square(join_.outgoing());
    if (join_.dot() > 0) return rounding.is_exceeded(join_.cross(), (std::max)(aa, bb), steps_);
    const Glyph_integer_join::Field bound = rounding.units() * Glyph_integer_join::exact(steps_);
    return bound * bound < Glyph_integer_join::exact((std::min)(aa, bb));
  }

  // By how many units of the font a handle is off, rounded.
  double units_off() const {
    const double a = length(join_.incoming()), b = length(join_.outgoing()), steps = static_cast<double>(steps_);
    if (join_.dot() <= 0) return (std::min)(a, b) / steps;
    return std::abs(join_.rounded(join_.cross())) / (std::max)(a, b) / steps;
  }

  // Returns the visible size of a kink, in units of the font: the angle in radians times the
  // shorter handle.
  double severity() const {
    const double angle = std::atan2(std::abs(join_.rounded(join_.cross())), join_.rounded(join_.dot()));
    return angle * (std::min)(length(join_.incoming()), length(join_.outgoing())) / static_cast<double>(steps_);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H
