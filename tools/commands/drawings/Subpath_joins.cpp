// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/Subpath_joins.h"

#include "commands/drawings/element_units.h"
#include "commands/drawings/segment_joins.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

typedef Drawing_traits::FT Number;
typedef Drawing_traits::Point Point;
typedef GC::Svg_transform<Drawing_traits> Transform;
typedef Subpath_joins::Segment Segment;

// The square of 57.3, of which the inverse is the tangent of a degree.
const Number& square_of_long() {
  static const Number square(3284);
  return square;
}

// The rectangle around points, in units.
class Unit_box {
  std::array<Number, 2> least_, most_;
  bool is_empty_ = true;

public:
  void add(const Segment& bezier) {
    for (const Point& p : *bezier.bezier()) {
      const std::array<Number, 2> x{p.x(), p.y()};
      for (std::size_t i = 0; i < 2; ++i) {
        if (is_empty_ || x[i] < least_[i]) least_[i] = x[i];
        if (is_empty_ || most_[i] < x[i]) most_[i] = x[i];
      }
      is_empty_ = false;
    }
  }
  bool fits_into_unit() const { return most_[0] - least_[0] <= 1 && most_[1] - least_[1] <= 1; }
};

// Finds the segments of a subpath that are rounding.
class Rounding_finder {
  const Drawing_subpath& path_;
  const Transform to_units_;
  std::array<double, 4> m_; // of this map, rounded

public:
  std::vector<bool> result; // empty where there are none

  Rounding_finder(const Drawing_subpath& path, const Transform& to_units) : path_(path), to_units_(to_units) {
    for (std::size_t i = 0; i < 4; ++i) m_[i] = CGAL::to_double(to_units.matrix()[i]);
    std::vector<std::size_t> small;
    std::array<double, 2> start{}, end{};
    const std::size_t n = path.segments.size();
    for (std::size_t i = 0; i < n; ++i, start = end) {
      const Segment& s = path.segments[i];
      if (i == 0) start = rounded(s.start());
      end = rounded(s.end());
      if (may_be_small(start, end) && s.bezier() && fits_into_unit({i})) small.push_back(i);
    }
    if (small.empty() || small.size() == n) return;
    std::vector<std::size_t> run;
    const std::size_t first = wrapped_begin(small);
    for (std::size_t k = 0; k < small.size(); ++k) {
      const std::size_t i = small[(first + k) % small.size()];
      if (!run.empty() && (run.back() + 1) % n != i) take(run);
      run.push_back(i);
    }
    take(run);
  }

private:
  std::array<double, 2> rounded(const Point& p) const { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

  // Returns whether the chord may be that of a small segment, from rounded coordinates.
  bool may_be_small(const std::array<double, 2>& p, const std::array<double, 2>& q) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const double chord = std::abs(m_[i] * (q[0] - p[0]) + m_[i + 2] * (q[1] - p[1])),
                   size = std::abs(m_[i]) * (std::abs(p[0]) + std::abs(q[0])) +
                          std::abs(m_[i + 2]) * (std::abs(p[1]) + std::abs(q[1]));
      if (1 + 0x1p-40 * size < chord) return false;
    }
    return true;
  }

  bool fits_into_unit(const std::vector<std::size_t>& segments) const {
    Unit_box box;
    for (const std::size_t i : segments) box.add(path_.segments[i].transform(to_units_));
    return box.fits_into_unit();
  }

  // Where in the list the first run begins that does not begin before the start of a closed
  // subpath.
  std::size_t wrapped_begin(const std::vector<std::size_t>& small) const {
    if (!path_.closed || small.back() + 1 != path_.segments.size() || small.front() != 0) return 0;
    std::size_t k = small.size() - 1;
    while (small[k - 1] + 1 == small[k]) --k;
    return k;
  }

  // Marks the segments of a run if they are rounding, and empties it.
  void take(std::vector<std::size_t>& run) {
    const std::size_t n = path_.segments.size(), left = (run.front() + n - 1) % n, right = (run.back() + 1) % n;
    const bool has_neighbours = path_.closed || (run.front() != 0 && run.back() + 1 != n);
    if (has_neighbours && fits_into_unit(run) && is_long(path_.segments[left]) && is_long(path_.segments[right]) &&
        adds_no_turn(left, run, right)) {
      result.resize(n);
      for (const std::size_t i : run) result[i] = true;
    }
    run.clear();
  }

  // A Bezier curve by its control points, an arc by the diameter of its ellipse along its chord.
  bool is_long(const Segment& given) const {
    const GC::Path_segment<Drawing_traits> s = GC::Path_segment<Drawing_traits>(given).transform(to_units_).rounded();
    if (s.arc()) return square_of_long() <= (s.end() - s.start()).squared_length() * (1 + s.radicand());
    const Point node = s.start();
    return std::any_of(s.bezier()->begin(), s.bezier()->end(),
                       [&](const Point& p) { return square_of_long() <= (p - node).squared_length(); });
  }

  // Returns whether the segments turn to and fro between their neighbours, or not at all.
  bool adds_no_turn(std::size_t left, const std::vector<std::size_t>& run, std::size_t right) const {
    GC::Enclosure sum{0, 0};
    std::size_t before = left;
    const auto add = [&](std::size_t i) {
      const GC::Enclosure angle = *segment_angle(path_.segments[before], path_.segments[i]);
      sum.lower += angle.lower;
      sum.upper += angle.upper;
      before = i;
    };
    for (const std::size_t i : run) add(i);
    add(right);
    const double rounding = 1e-15 * static_cast<double>(run.size() + 1) * sum.lower;
    const double turn = segment_angle(path_.segments[left], path_.segments[right])->upper;
    return turn < sum.lower - rounding || (sum.upper == 0 && turn == 0);
  }
};

} // namespace

Subpath_joins::Subpath_joins(const Drawing_element& element, const Drawing_subpath& path) : path_(path) {
  if (path.segments.size() < 2) return;
  if (const std::optional<Transform> units = to_units(element)) is_rounding_ = Rounding_finder(path, *units).result;
}

std::size_t Subpath_joins::rounding() const {
  return static_cast<std::size_t>(std::count(is_rounding_.begin(), is_rounding_.end(), true));
}

Segment Subpath_joins::moved(const Segment& segment, const Point& start) {
  const auto v = start - segment.start();
  return segment.transform(Transform({1, 0, 0, 1, v.x(), v.y()}));
}
