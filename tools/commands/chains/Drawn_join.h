// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DRAWN_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DRAWN_JOIN_H

#include "commands/chains/join_report.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

// How a join is drawn of which a tangent is zero, as by a handle of length 0: by the directions of
// the first derivatives that are not.
struct Drawn_join {
  GC::Visual_class grade; // corner, kink, or G1
  GC::Enclosure angle;    // in radians

  bool is_smooth() const { return grade >= GC::Visual_class::g1; }

  // E.g. ", drawn as kink of 2.045 degrees".
  std::string text() const {
    std::string s = std::string(", drawn as ") + to_string(grade);
    if (!is_smooth()) append(s, " of ", rounded(GC::in_degrees(angle).upper, 4), " degrees");
    return s;
  }

  // Writes `,"drawn":"kink","drawn_angle_degrees":[…,…]`.
  friend void write_json_members(std::ostream& os, const Drawn_join& drawn) {
    os << ",\"drawn\":\"" << drawn.grade << "\",\"drawn_angle_degrees\":";
    GC::write_json(os, std::optional<GC::Enclosure>(GC::in_degrees(drawn.angle)));
  }
};

// How many joins have a zero tangent, and how many of them are drawn as G1.
struct Drawn_counts {
  std::size_t all = 0, smooth = 0;

  void add(const Drawn_join& drawn) {
    ++all;
    if (drawn.is_smooth()) ++smooth;
  }
  Drawn_counts& operator+=(const Drawn_counts& x) {
    all += x.all;
    smooth += x.smooth;
    return *this;
  }
};

// The first derivative that is not zero, in the direction in which the curve runs; nothing where
// all of the jet are.
inline std::optional<GC::Coordinate_vector<Exact, 0>> direction(const GC::Curve_jet<Program_traits<Exact>>& jet,
                                                                GC::Curve_end end) {
  for (int k = 1; k <= jet.order(); ++k)
    if (!is_zero(jet[k])) return end == GC::Curve_end::end && k % 2 == 0 ? Exact(-1) * jet[k] : jet[k];
  return std::nullopt;
}

// From the jets at the join. Nothing where the ends do not meet, where both tangents tell, or where
// a curve has no direction. Of `join` the flag `regular` is read only where it is G0.
inline std::optional<Drawn_join> drawn_join(const Join& join, const GC::Curve_jet<Program_traits<Exact>>& left,
                                            const GC::Curve_jet<Program_traits<Exact>>& right,
                                            const GC::Corner_threshold& bound) {
  if (join.g_order != 0 || join.regular) return std::nullopt;
  const auto a = direction(left, GC::Curve_end::end), b = direction(right, GC::Curve_end::start);
  if (!a || !b) return std::nullopt;
  const Exact ab = dot(*a, *b), sine_squared = dot(*a, *a) * dot(*b, *b) - ab * ab;
  if (sine_squared == 0 && ab > 0) return Drawn_join{GC::Visual_class::g1, {0, 0}};
  return Drawn_join{exceeds(bound, *a, *b) ? GC::Visual_class::corner : GC::Visual_class::kink,
                    GC::angle_enclosure(sine_squared, ab)};
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DRAWN_JOIN_H
