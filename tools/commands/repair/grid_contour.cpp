// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/grid_contour.h"

#include <algorithm>
#include <cstdlib>

namespace {

// Whether products of the coordinates are exact.
bool is_short(const GC::Grid_vector& v) {
  return (std::max)((std::abs)(v.x), (std::abs)(v.y)) <= std::int64_t(1) << 28;
}

} // namespace

Grid_bezier grid_bezier(const std::vector<GC::Grid_vector>& points) {
  std::vector<Grid_bezier::Traits::Point> p;
  for (const GC::Grid_vector& v : points) p.emplace_back(static_cast<double>(v.x), static_cast<double>(v.y));
  return Grid_bezier(p.begin(), p.end());
}

bool is_line(const std::vector<GC::Grid_vector>& points) {
  const GC::Grid_vector chord = points.back() - points.front();
  std::int64_t before = 0;
  for (const GC::Grid_vector& p : points) {
    if (!is_short(p - points.front())) return points.size() == 2;
    const std::int64_t along = dot(p - points.front(), chord);
    if (cross(p - points.front(), chord) != 0 || along < before) return false;
    before = along;
  }
  return true;
}

std::string Grid_contour::text(std::int64_t coordinate) const {
  std::string digits = std::to_string((std::abs)(coordinate));
  const std::size_t behind = static_cast<std::size_t>(decimals);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  if (behind > 0) {
    digits.insert(digits.size() - behind, ".");
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
  }
  return (coordinate < 0 ? "-" : "") + digits;
}

std::optional<GC::Join_grade> grade(const Grid_contour& contour, std::size_t join, const GC::Kink_bound& bound) {
  const std::vector<GC::Grid_vector>&left = contour.curves[join].points,
        &right = contour.curves[(join + 1) % contour.curves.size()].points;
  if (left.empty() || right.empty()) return std::nullopt;
  return GC::join_grade(grid_bezier(left), grid_bezier(right), bound);
}

Grade_counts grades(const Grid_contour& contour, const GC::Kink_bound& bound) {
  Grade_counts counts;
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
    if (const std::optional<GC::Join_grade> g = grade(contour, j, bound)) ++counts[*g];
  return counts;
}
