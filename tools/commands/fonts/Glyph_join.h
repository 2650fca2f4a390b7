// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H

#include "formats/font/Glyph_outline.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/joins/Join_grade.h>
#include <CGAL/Geometric_continuity/joins/Kink_size.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace GC = CGAL::Geometric_continuity;

// The joins of a glyph, graded as GC::join_grade() does, whose text is for all curves and numbers. This one is for the integers of
// a font, none of which is larger than 2^21: a test compares both.

// A vector in halves of the units of the font.
struct Glyph_leg {
  std::int64_t x, y;

  bool is_zero() const { return x == 0 && y == 0; }
  double length() const { return std::hypot(static_cast<double>(x), static_cast<double>(y)); }
};
inline Glyph_leg operator-(const Glyph_point& p, const Glyph_point& q) { return {p.x - q.x, p.y - q.y}; }
inline std::int64_t cross(const Glyph_leg& a, const Glyph_leg& b) { return a.x * b.y - a.y * b.x; }
inline std::int64_t dot(const Glyph_leg& a, const Glyph_leg& b) { return a.x * b.x + a.y * b.y; }

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

  // Whether the first control point lies on the node, so that the direction is that of a later one.
  bool is_retracted() const { return leg_ > 1; }

  // Whether all control points lie on the chord, in order: the segment is drawn as that line.
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
  std::int64_t bend() const {
    return segment_.degree == 1 ? 0 : (segment_.degree - 1) * cross(point(1) - point(0), point(2) - point(1));
  }

private:
  Glyph_segment_end(const Glyph_segment& segment, int node, int step) : segment_(segment), node_(node), step_(step) {
    while (point(leg_) == point(0)) ++leg_; // a segment has a length
  }
};

// Two segments that meet at a node.
class Glyph_join {
  __extension__ typedef __int128 Integer;
  const Glyph_segment_end left_, right_;
  const Glyph_leg a_, b_; // the directions in which the left one arrives, and the right one leaves

  static Glyph_leg reversed(const Glyph_leg& a) { return {-a.x, -a.y}; }
  static Integer cube(std::int64_t x) { return Integer(x) * x * x; }

  // Parallel directions with |b| / |a| = b_i / a_i make the curvatures comparable without roots. Below 2^45 * 6 * 2^66.
  bool curvatures_agree() const {
    const bool by_x = a_.x != 0;
    const Integer a = cube(std::abs(by_x ? a_.x : a_.y)), b = cube(std::abs(by_x ? b_.x : b_.y));
    const std::int64_t left = left_.is_retracted() ? 0 : -left_.bend(),
                       right = right_.is_retracted() ? 0 : right_.bend();
    return b * left * right_.degree() == a * right * left_.degree();
  }

public:
  Glyph_join(const Glyph_segment& left, const Glyph_segment& right)
      : left_(Glyph_segment_end::end(left)), right_(Glyph_segment_end::start(right)), a_(reversed(left_.handle())),
        b_(right_.handle()) {}

  const Glyph_point& node() const { return right_.node(); }
  std::int64_t sine() const { return cross(a_, b_); } // times the lengths of the handles
  std::int64_t cosine() const { return dot(a_, b_); }

  GC::Join_grade grade(const GC::Kink_bound& bound) const {
    if (sine() != 0 || cosine() < 0)
      return bound.is_exceeded(sine(), cosine()) ? GC::Join_grade::corner : GC::Join_grade::kink;
    const auto has_no_curvature = [](const Glyph_segment_end& end) { return end.is_retracted() && !end.is_line(); };
    if (has_no_curvature(left_) || has_no_curvature(right_)) return GC::Join_grade::g1;
    return curvatures_agree() ? GC::Join_grade::g2 : GC::Join_grade::g1;
  }

  // Whether a handle is off by more than one unit of the font, see GC::Kink_size: too much to come from rounding alone.
  bool is_off_by_more_than_one_unit() const {
    const std::int64_t aa = dot(a_, a_), bb = dot(b_, b_);
    if (cosine() <= 0) return (std::min)(aa, bb) > 4;
    return Integer(sine()) * sine() > Integer(4) * (std::max)(aa, bb);
  }

  // The angle, the offset of a handle and the severity, enclosed, in halves of units.
  GC::Kink_size size() const {
    typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Kernel;
    const auto line = [](const Glyph_leg& a) {
      return GC::Bezier_curve<GC::Traits_2<Kernel>, 1>(
          {Kernel::Point_2(0, 0), Kernel::Point_2(static_cast<double>(a.x), static_cast<double>(a.y))});
    };
    return *GC::kink_size(line(a_), line(b_));
  }

  // What the eye sees of a kink, in units of the font: the angle in radians times the shorter handle.
  double severity() const {
    const double angle = std::atan2(static_cast<double>(std::abs(sine())), static_cast<double>(cosine()));
    return angle * (std::min)(a_.length(), b_.length()) / 2;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GLYPH_JOIN_H
