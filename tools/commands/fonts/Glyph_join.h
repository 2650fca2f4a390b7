// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H

#include "formats/font/Glyph_outline.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace GC = CGAL::Geometric_continuity;

// The joins of a glyph, graded as GC::visual_class() does, whose text is for all curves and numbers. This one is for the integers of
// a font, which are below 2^22 unless the font has fractions: a test compares both.

// What a join of a glyph is, from the worst to the best. The angle between the tangents is larger than a bound where there is a
// corner, which is meant, and smaller at the next three.
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

// Of integers of 64 bits, which most are, without a call.
inline double as_double(Glyph_integer x) {
  const std::int64_t low = static_cast<std::int64_t>(x);
  return low == x ? static_cast<double>(low) : static_cast<double>(x);
}

// Returns whether doubles of these magnitudes tell which one is larger, if both are right up to 2^-48; empty if they do not.
inline std::optional<bool> is_surely_larger(double x, double y) {
  if (std::abs(x - y) <= 0x1p-46 * (std::abs(x) + std::abs(y))) return std::nullopt;
  return x > y;
}

inline CGAL::Exact_rational exact(Glyph_integer x) {
  typedef CGAL::Exact_rational FT;
  constexpr std::int64_t part = std::int64_t(1) << 50;
  if (x == 0) return FT(0);
  return FT(exact(x / part) * FT(static_cast<double>(part))) + FT(static_cast<double>(x % part));
}

// By how many units of the font a handle may be off because of rounding.
class Rounding_bound {
  typedef CGAL::Exact_rational FT;
  FT units_;
  double value_;

public:
  explicit Rounding_bound(const FT& units = FT(1)) : units_(units), value_(CGAL::to_double(units)) {}

  const FT& units() const { return units_; }

  // Returns whether numerator^2 / denominator, in steps of which a unit has so many, is larger than the square of the bound.
  bool is_exceeded(Glyph_integer numerator, Glyph_integer denominator, std::int64_t steps) const {
    const double n = as_double(numerator), bound = value_ * static_cast<double>(steps);
    if (const auto answer = is_surely_larger(n * n, bound * bound * as_double(denominator))) return *answer;
    constexpr Glyph_integer small = Glyph_integer(1) << 60;
    if (value_ == 1 && -small < numerator && numerator < small && denominator < small && steps == 2)
      return numerator * numerator > 4 * denominator;
    const FT x = exact(numerator), y = units_ * FT(static_cast<double>(steps));
    return FT(y * y) * exact(denominator) < FT(x * x);
  }
};

// A vector in steps of an outline.
struct Glyph_leg {
  std::int64_t x, y;

  bool is_zero() const { return x == 0 && y == 0; }
  double length() const { return std::hypot(static_cast<double>(x), static_cast<double>(y)); }
};
inline Glyph_leg operator-(const Glyph_point& p, const Glyph_point& q) { return {p.x - q.x, p.y - q.y}; }
inline Glyph_integer cross(const Glyph_leg& a, const Glyph_leg& b) {
  return Glyph_integer(a.x) * b.y - Glyph_integer(a.y) * b.x;
}
inline Glyph_integer dot(const Glyph_leg& a, const Glyph_leg& b) {
  return Glyph_integer(a.x) * b.x + Glyph_integer(a.y) * b.y;
}

// The end, or the start, of a segment: the way along its control points, from the node on.
class Glyph_segment_end {
  const Glyph_segment& segment_;
  const int node_, step_;
  int leg_ = 1; // the first control point on the way that is not the node

  const Glyph_point& point(int i) const { return segment_.points[static_cast<std::size_t>(node_ + i * step_)]; }

public:
  static Glyph_segment_end start(const Glyph_segment& s) { return Glyph_segment_end(s, 0, 1); }
  static Glyph_segment_end end(const Glyph_segment& s) { return Glyph_segment_end(s, s.degree, -1); }

  const Glyph_point& node() const { return point(0); }
  int degree() const { return segment_.degree; }

  // From the node to the first other control point.
  Glyph_leg handle() const { return point(leg_) - point(0); }

  // Returns whether the first control point lies on the node, so that the direction is that of a later one.
  bool is_retracted() const { return leg_ > 1; }

  // Returns whether all control points lie on the chord, in order: the segment is drawn as that line.
  bool is_line() const {
    Glyph_leg leg = handle();
    for (int i = leg_; i < segment_.degree; ++i) {
      const Glyph_leg next = point(i + 1) - point(i);
      if (next.is_zero()) continue;
      if (cross(leg, next) != 0 || dot(leg, next) < 0) return false;
      leg = next;
    }
    return true;
  }

  // With the legs a and b from the node on, the curvature is (1 - 1/degree) a x b / |a|^3, here without the last factor and times the
  // degree.
  Glyph_integer bend() const {
    return segment_.degree == 1 ? 0 : (segment_.degree - 1) * cross(point(1) - point(0), point(2) - point(1));
  }

private:
  Glyph_segment_end(const Glyph_segment& segment, int node, int step) : segment_(segment), node_(node), step_(step) {
    while (point(leg_) == point(0)) ++leg_; // a segment has a length
  }
};

// Two segments that meet at a node.
class Glyph_join {
  typedef Glyph_integer Integer;
  const Glyph_segment_end left_, right_;
  const Glyph_leg a_, b_; // the directions in which the left one arrives, and the right one leaves
  const std::int64_t steps_;

  static Glyph_leg reversed(const Glyph_leg& a) { return {-a.x, -a.y}; }

  // Parallel directions with |b| / |a| = b_i / a_i make the curvatures comparable without roots.
  bool curvatures_agree() const {
    const bool by_x = a_.x != 0;
    const std::int64_t a = std::abs(by_x ? a_.x : a_.y), b = std::abs(by_x ? b_.x : b_.y);
    const Integer left = left_.is_retracted() ? 0 : -left_.bend() * right_.degree(),
                  right = right_.is_retracted() ? 0 : right_.bend() * left_.degree();
    constexpr std::int64_t small = std::int64_t(1) << 23;
    constexpr Integer short_bend = Integer(1) << 56;
    if (a < small && b < small && -short_bend < left && left < short_bend && -short_bend < right && right < short_bend)
      return Integer(b) * b * b * left == Integer(a) * a * a * right;
    const double x = static_cast<double>(b), y = static_cast<double>(a);
    if (is_surely_larger(x * x * x * as_double(left), y * y * y * as_double(right))) return false;
    const auto product = [](std::int64_t leg, Integer bend) -> CGAL::Exact_rational {
      return CGAL::Exact_rational(exact(Integer(leg) * leg) * exact(leg)) * exact(bend);
    };
    return product(b, left) == product(a, right);
  }

public:
  // A unit of the font has so many steps.
  Glyph_join(const Glyph_segment& left, const Glyph_segment& right, std::int64_t steps)
      : left_(Glyph_segment_end::end(left)), right_(Glyph_segment_end::start(right)), a_(reversed(left_.handle())),
        b_(right_.handle()), steps_(steps) {}

  const Glyph_point& node() const { return right_.node(); }
  Integer sine() const { return cross(a_, b_); } // times the lengths of the handles
  Integer cosine() const { return dot(a_, b_); }

  // Returns whether the angle of the tangents is larger than a bound.
  bool exceeds(const GC::Corner_threshold& bound) const {
    const Integer c = sine(), d = cosine();
    const double x = as_double(c), y = as_double(d);
    constexpr Integer small = Integer(1) << 53; // what doubles have
    const bool is_exact = -small < c && c < small && -small < d && d < small;
    if (const auto answer = bound.is_exceeded(x, y, is_exact ? 0 : 0x1p-51 * (std::abs(x) + std::abs(y))))
      return *answer;
    return bound.is_exceeded(exact(c), exact(d));
  }

  // The grade of the library, for which all kinks are equal.
  GC::Visual_class grade(const GC::Corner_threshold& bound) const {
    if (sine() != 0 || cosine() < 0) return exceeds(bound) ? GC::Visual_class::corner : GC::Visual_class::kink;
    const auto has_no_curvature = [](const Glyph_segment_end& end) { return end.is_retracted() && !end.is_line(); };
    if (has_no_curvature(left_) || has_no_curvature(right_)) return GC::Visual_class::g1;
    return curvatures_agree() ? GC::Visual_class::g2 : GC::Visual_class::g1;
  }

  Glyph_grade grade(const GC::Corner_threshold& bound, const Rounding_bound& rounding) const {
    switch (grade(bound)) {
    case GC::Visual_class::g2: return Glyph_grade::g2;
    case GC::Visual_class::g1: return Glyph_grade::g1;
    case GC::Visual_class::kink: break;
    default: return Glyph_grade::corner;
    }
    if (!is_off_by_more_than(rounding)) return Glyph_grade::rounding;
    return left_.is_line() && right_.is_line() ? Glyph_grade::bend : Glyph_grade::kink;
  }

  // Returns whether a handle is off by more than that, see GC::Kink_size.
  bool is_off_by_more_than(const Rounding_bound& rounding) const {
    const Integer aa = dot(a_, a_), bb = dot(b_, b_);
    if (cosine() > 0) return rounding.is_exceeded(sine(), (std::max)(aa, bb), steps_);
    const Integer shorter = (std::min)(aa, bb);
    const CGAL::Exact_rational bound = rounding.units() * CGAL::Exact_rational(static_cast<double>(steps_));
    return bound * bound < exact(shorter);
  }

  // The angle, the offset of a handle and the severity, enclosed, in steps.
  GC::Kink_size size() const {
    typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Kernel;
    const auto line = [](const Glyph_leg& a) {
      return GC::Bezier_curve<GC::Traits_2<Kernel>, 1>(
          {Kernel::Point_2(0, 0), Kernel::Point_2(static_cast<double>(a.x), static_cast<double>(a.y))});
    };
    return *GC::kink_size(line(a_), line(b_));
  }

  // By how many units of the font a handle is off, rounded.
  double units_off() const {
    const double a = a_.length(), b = b_.length(), steps = static_cast<double>(steps_);
    if (cosine() <= 0) return (std::min)(a, b) / steps;
    return std::abs(as_double(sine())) / (std::max)(a, b) / steps;
  }

  // What the eye sees of a kink, in units of the font: the angle in radians times the shorter handle.
  double severity() const {
    const double angle = std::atan2(std::abs(as_double(sine())), as_double(cosine()));
    return angle * (std::min)(a_.length(), b_.length()) / static_cast<double>(steps_);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H
