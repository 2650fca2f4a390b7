// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/grid_contour.h"

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

// Returns whether products of the coordinates are exact.
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

std::optional<GC::Grid_vector> arc_direction(const Exact_segment& arc, bool at_end) {
  typedef Drawing_traits::FT Number;
  typedef CGAL::Fraction_traits<Number> Fraction;
  if (!arc.arc()->is_rational()) return std::nullopt;
  const auto jet = at_end ? arc.arc()->end_jet(1) : arc.arc()->start_jet(1);
  const Number x = (*jet)[1][0], y = (*jet)[1][1];
  const bool steep = x == 0;
  Fraction::Numerator_type p;
  Fraction::Denominator_type q;
  Fraction::Decompose()(steep ? Number(0) : Number(y / x), p, q);
  const double along = CGAL::to_double(q), up = CGAL::to_double(p); // exact where they are short
  if ((std::max)(std::abs(along), std::abs(up)) > static_cast<double>(GC::max_handle_coordinate)) return std::nullopt;
  GC::Grid_vector d{static_cast<std::int64_t>(along), static_cast<std::int64_t>(up)};
  if (steep) d = {0, 1};
  return (steep ? y < 0 : x < 0) ? -1 * d : d;
}

namespace {

Exact_segment exact_segment(const Grid_curve& curve) {
  if (curve.arc) return *curve.arc;
  std::vector<Drawing_traits::Point> p;
  for (const GC::Grid_vector& v : curve.points) p.emplace_back(static_cast<double>(v.x), static_cast<double>(v.y));
  return {GC::Bezier_curve<Drawing_traits>(p.begin(), p.end())};
}

} // namespace

std::optional<GC::Visual_class> grade(const Grid_contour& contour, std::size_t join,
                                      const GC::Corner_threshold& bound) {
  const Grid_curve &left = contour.curves[join], &right = contour.curves[contour.next(join)];
  const bool beziers = !left.points.empty() && !right.points.empty();
  if (beziers && !contour.map) return segment_class(grid_bezier(left.points), grid_bezier(right.points), bound);
  if (!beziers && ((left.points.empty() && !left.arc) || (right.points.empty() && !right.arc))) return std::nullopt;
  const Exact_segment x = exact_segment(left), y = exact_segment(right);
  return contour.map ? segment_class(x.transform(*contour.map), y.transform(*contour.map), bound)
                     : segment_class(x, y, bound);
}

Grade_counts grades(const Grid_contour& contour, const GC::Corner_threshold& bound) {
  Grade_counts counts;
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
    if (const std::optional<GC::Visual_class> g = grade(contour, j, bound)) ++counts[*g];
  return counts;
}
