// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/grid_contour.h"

#include "commands/repair/decimal_text.h"
#include "commands/repair/grid_vectors.h"

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace {

typedef CGAL::Fraction_traits<Grid_fraction> Parts;

Grid_fraction absolute(const Grid_fraction& x) { return x < 0 ? Grid_fraction(-x) : x; }

bool is_line_on_grid(const std::vector<GC::Grid_vector>& points) {
  const GC::Grid_vector chord = points.back() - points.front();
  std::int64_t before = 0;
  for (const GC::Grid_vector& p : points) {
    const std::int64_t along = dot(p - points.front(), chord);
    if (cross(p - points.front(), chord) != 0 || along < before) return false;
    before = along;
  }
  return true;
}

} // namespace

Grid_fraction power_of_ten(int exponent) {
  Grid_fraction power(1);
  for (int i = 0; i < (std::abs)(exponent); ++i) power *= 10;
  return exponent < 0 ? Grid_fraction(1 / power) : power;
}

Grid_offset offset(const Grid_curve& curve, std::size_t point) {
  return curve.offsets.empty() ? Grid_offset(0, 0) : curve.offsets[point];
}

Drawing_traits::Point exact_point(const Grid_curve& curve, std::size_t point) {
  const GC::Grid_vector& p = curve.points[point];
  return Drawing_traits::Point(exact_number(p.x), exact_number(p.y)) + offset(curve, point);
}

std::optional<std::int64_t> on_grid(const Grid_fraction& x) {
  Parts::Numerator_type p;
  Parts::Denominator_type q;
  Parts::Decompose()(Grid_fraction(absolute(x) + Grid_fraction(1) / 2), p, q);
  const double size = CGAL::to_double(Grid_fraction(Parts::Numerator_type(p / q)));
  if (!(size <= static_cast<double>(max_grid_coordinate))) return std::nullopt;
  return static_cast<std::int64_t>(x < 0 ? -size : size);
}

Grid_curve curve_beside_grid(const std::vector<Drawing_traits::Point>& points, int decimals) {
  Grid_curve curve;
  const Grid_fraction scale = power_of_ten(decimals);
  std::vector<Drawing_traits::Point> p;
  for (const Drawing_traits::Point& x : points) p.emplace_back(x.x() * scale, x.y() * scale);
  const std::size_t n = p.size() - 1;
  const auto node_of = [n](std::size_t k) { return k + 1 < n || n == 2 ? 0 : n; };
  const auto rounded = [](const Grid_offset& v) -> std::optional<GC::Grid_vector> {
    const std::optional<std::int64_t> x = on_grid(v.x()), y = on_grid(v.y());
    return x && y ? std::optional<GC::Grid_vector>({*x, *y}) : std::nullopt;
  };
  const std::optional<GC::Grid_vector> first = rounded(p[0] - CGAL::ORIGIN), last = rounded(p[n] - CGAL::ORIGIN);
  for (std::size_t k = 0; k <= n && first && last; ++k) {
    const std::size_t node = k == 0 || k == n ? k : node_of(k);
    const std::optional<GC::Grid_vector> v = rounded(p[k] - p[node]);
    if (!v) break;
    const GC::Grid_vector q = (node == 0 ? *first : *last) + *v;
    curve.points.push_back(q);
    curve.offsets.push_back(p[k] - Drawing_traits::Point(exact_number(q.x), exact_number(q.y)));
  }
  if (curve.points.size() == p.size()) return curve;
  curve.points.clear();
  curve.offsets.clear();
  curve.reason = "a coordinate is longer than 2^50 units of the grid";
  return curve;
}

int coarser_decimals(const std::vector<Drawing_traits::Point>& nodes, std::int64_t longest) {
  Grid_fraction size(0), largest(0);
  for (const Drawing_traits::Point& p : nodes) {
    const Grid_offset v = p - nodes.front();
    for (const Grid_fraction& x : {v.x(), v.y()}) size = (std::max)(size, absolute(x));
    for (const Grid_fraction& x : {p.x(), p.y()}) largest = (std::max)(largest, absolute(x));
  }
  const Grid_fraction longest_size = exact_number(longest), largest_number = exact_number(max_grid_coordinate / 16);
  int decimals = 0;
  const auto fits = [&](int n) {
    const Grid_fraction scale = power_of_ten(n);
    return size * scale <= longest_size && largest * scale <= largest_number;
  };
  constexpr int finest = 320;
  while (decimals > -finest && !fits(decimals)) --decimals;
  while (decimals < finest && fits(decimals + 1)) ++decimals;
  return decimals;
}

Grid_bezier grid_bezier(const std::vector<GC::Grid_vector>& points) {
  std::vector<Grid_bezier::Traits::Point> p;
  for (const GC::Grid_vector& v : points) p.emplace_back(static_cast<double>(v.x), static_cast<double>(v.y));
  return Grid_bezier(p.begin(), p.end());
}

Exact_bezier exact_bezier(const Grid_curve& curve) {
  std::vector<Drawing_traits::Point> p;
  for (std::size_t k = 0; k < curve.points.size(); ++k) p.push_back(exact_point(curve, k));
  return Exact_bezier(p.begin(), p.end());
}

bool is_line(const Grid_curve& curve) {
  const std::vector<GC::Grid_vector>& points = curve.points;
  if (points.size() == 2) return true;
  const auto is_near = [&](const GC::Grid_vector& p) { return is_short(p - points.front()); };
  if (curve.offsets.empty() && std::all_of(points.begin(), points.end(), is_near)) return is_line_on_grid(points);
  const Grid_offset chord = exact_vector(curve, 0, points.size() - 1);
  Grid_fraction before(0);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Grid_offset v = exact_vector(curve, 0, k);
    const Grid_fraction along = v * chord;
    if (v.x() * chord.y() != v.y() * chord.x() || along < before) return false;
    before = along;
  }
  return true;
}

std::optional<GC::Grid_vector> primitive_direction(const Grid_offset& v) {
  const bool steep = v.x() == 0;
  Parts::Numerator_type p;
  Parts::Denominator_type q;
  Parts::Decompose()(steep ? Grid_fraction(0) : Grid_fraction(v.y() / v.x()), p, q);
  const double along = CGAL::to_double(q), up = CGAL::to_double(p); // exact where they are short
  if ((std::max)(std::abs(along), std::abs(up)) > static_cast<double>(GC::max_handle_coordinate)) return std::nullopt;
  GC::Grid_vector d{static_cast<std::int64_t>(along), static_cast<std::int64_t>(up)};
  if (steep) d = {0, 1};
  return (steep ? v.y() < 0 : v.x() < 0) ? -1 * d : d;
}

std::string Grid_contour::text(std::int64_t coordinate) const {
  if (decimals < 0) return text(exact_number(coordinate));
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

std::string Grid_contour::text(const Grid_fraction& coordinate) const {
  const Grid_fraction x = coordinate * power_of_ten(-decimals);
  constexpr int most_decimals = 1200;
  if (const std::optional<std::string> decimal = decimal_text(x, most_decimals)) return *decimal;
  std::ostringstream fraction;
  fraction << x;
  return fraction.str();
}

std::string Grid_contour::text(const GC::Grid_vector& point, const Grid_offset& offset) const {
  if (offset == CGAL::NULL_VECTOR) return text(point);
  return '(' + text(Grid_fraction(exact_number(point.x) + offset.x())) + ", " +
         text(Grid_fraction(exact_number(point.y) + offset.y())) + ')';
}

std::string Grid_contour::unit() const { return *decimal_text(power_of_ten(-decimals), decimals < 0 ? 0 : decimals); }

std::optional<GC::Grid_vector> arc_direction(const Exact_segment& arc, bool at_end) {
  if (!arc.arc()->is_rational()) return std::nullopt;
  const auto jet = at_end ? arc.arc()->end_jet(1) : arc.arc()->start_jet(1);
  return primitive_direction(Grid_offset((*jet)[1][0], (*jet)[1][1]));
}

Exact_segment grid_segment(const Grid_curve& curve) {
  return curve.arc ? *curve.arc : Exact_segment{exact_bezier(curve)};
}

std::optional<GC::Visual_class> grade(const Grid_contour& contour, std::size_t join,
                                      const GC::Corner_threshold& bound) {
  const Grid_curve &left = contour.curves[join], &right = contour.curves[contour.next(join)];
  const bool beziers = !left.points.empty() && !right.points.empty();
  if (beziers && !contour.map)
    return contour.is_beside_grid ? segment_class(exact_bezier(left), exact_bezier(right), bound)
                                  : segment_class(grid_bezier(left.points), grid_bezier(right.points), bound);
  if (!beziers && ((left.points.empty() && !left.arc) || (right.points.empty() && !right.arc))) return std::nullopt;
  const Exact_segment x = grid_segment(left), y = grid_segment(right);
  return contour.map ? segment_class(x.transform(*contour.map), y.transform(*contour.map), bound)
                     : segment_class(x, y, bound);
}

Grade_counts grades(const Grid_contour& contour, const GC::Corner_threshold& bound) {
  Grade_counts counts;
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
    if (const std::optional<GC::Visual_class> g = grade(contour, j, bound)) ++counts[*g];
  return counts;
}
