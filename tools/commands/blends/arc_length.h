// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_ARC_LENGTH_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_ARC_LENGTH_H

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// Guaranteed enclosures of the arc length of a curve: it lies between the length of the chord and
// that of the control polygon where all weights are positive, and halves are halved until both are
// near each other.
class Arc_length {
  typedef CGAL::Interval_nt<false> Interval;
  typedef std::vector<std::vector<Interval>> Rows; // homogeneous points, the weight last

  static constexpr double precision = 0x1p-22; // of the polygon
  static constexpr int deepest = 20;           // halvings

  static Interval distance(const std::vector<Interval>& p, const std::vector<Interval>& q) {
    Interval sum(0);
    for (std::size_t i = 0; i + 1 < p.size(); ++i) sum += CGAL::square(q[i] / q.back() - p[i] / p.back());
    return CGAL::sqrt(sum);
  }

  // The rows are overwritten.
  static Interval length(Rows& rows, int depth) {
    const std::size_t m = rows.size() - 1;
    if (std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.back().inf() > 0; })) {
      const Interval chord = distance(rows.front(), rows.back());
      Interval polygon(0);
      for (std::size_t j = 0; j < m; ++j) polygon += distance(rows[j], rows[j + 1]);
      if (depth == deepest || polygon.sup() - chord.inf() <= precision * polygon.sup())
        return Interval(chord.inf(), (std::max)(chord.inf(), polygon.sup()));
    } else if (depth == deepest)
      return Interval(0, (std::numeric_limits<double>::infinity)());
    Rows left;
    for (std::size_t r = m + 1; r > 0; --r) { // de Casteljau
      left.push_back(rows.front());
      for (std::size_t j = 0; j + 1 < r; ++j)
        for (std::size_t i = 0; i < rows[j].size(); ++i) rows[j][i] = (rows[j][i] + rows[j + 1][i]) / 2;
    }
    const Interval before = length(left, depth + 1);
    return before + length(rows, depth + 1);
  }

  // Returns whether all control points lie on the chord, in order, and all weights are positive.
  static bool is_line(const Exact_curve& curve) {
    const int m = curve.degree();
    const auto chord = curve.coordinates(m) - curve.coordinates(0);
    const Exact square = dot(chord, chord);
    if (square == Exact(0)) return false;
    for (int j = 0; j < m; ++j) {
      const auto side = curve.coordinates(j + 1) - curve.coordinates(j);
      const Exact along = dot(side, chord);
      if (along < Exact(0) || square * side != along * chord) return false;
    }
    for (int j = 0; j <= m; ++j)
      if (!(Exact(0) < Exact(curve.weight(j) * curve.weight(0)))) return false;
    return true;
  }

public:
  static GC::Enclosure of(const Exact_curve& curve) {
    const int m = curve.degree();
    if (is_line(curve)) {
      const auto chord = curve.coordinates(m) - curve.coordinates(0);
      return GC::sqrt_enclosure(Exact(dot(chord, chord)));
    }
    const auto interval = [](const Exact& x) { return Interval(CGAL::to_interval(x)); };
    Rows rows;
    for (int j = 0; j <= m; ++j) {
      const Exact weight = Exact(curve.weight(j) / curve.weight(0));
      auto point = curve.coordinates(j); // a direction where the weight is 0
      if (weight != 0) point -= curve.coordinates(0);
      rows.emplace_back();
      for (int i = 0; i < curve.dimension(); ++i)
        rows.back().push_back(interval(weight == 0 ? point[i] : Exact(weight * point[i])));
      rows.back().push_back(interval(weight));
    }
    const CGAL::Protect_FPU_rounding<true> upward;
    const Interval result = length(rows, 0);
    return {result.inf(), result.sup()};
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_ARC_LENGTH_H
