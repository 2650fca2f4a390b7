// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lengths of handles are changed so that curvatures agree: exactly where the grid has such
// lengths, otherwise nearly.

#include "support/decided_joins.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

BOOST_AUTO_TEST_SUITE(harmonise_handles)

typedef GC::Grid_vector Vector;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Bezier_curve<Traits> Curve;
const std::int64_t unbounded = std::int64_t(1) << 50;

// A curve of this degree away from the node (0, 0); what lies beyond the far leg has no influence
// on its curvature there.
Curve curve(const GC::Handle_side& side, const Vector& leg, int sign) {
  std::vector<Vector> points{{0, 0}, sign * leg, sign * side.second};
  for (int i = 3; i <= side.degree; ++i) points.push_back(sign * Vector{900 + i * i, 50 - 7 * i});
  std::vector<Traits::Point> p;
  for (const Vector& v : points) p.emplace_back(static_cast<double>(v.x), static_cast<double>(v.y));
  if (sign < 0) return Curve(p.rbegin(), p.rend());
  return Curve(p.begin(), p.end());
}

struct Result {
  GC::Aligned_handles handles;
  bool g1, g2;
  double jump; // an upper bound
};

Result harmonised(const GC::Handle_side& left, const GC::Handle_side& right, std::int64_t bound = unbounded) {
  const std::optional<GC::Aligned_handles> handles = GC::harmonise_handles(left, right, bound);
  BOOST_REQUIRE(handles);
  const Curve x = curve(left, handles->left, -1), y = curve(right, handles->right, 1);
  return {*handles, decide_g1_join(x, y), decide_g2_join(x, y), GC::deviation(x, y).curvature_jump->upper};
}

BOOST_AUTO_TEST_CASE(exactly_where_the_ratio_is_a_square) {
  // curvatures as 30 / m^2 and 120 / n^2: n = 2 m
  const GC::Handle_side left{{50, 0}, {90, -30}, 3, true}, right{{80, 0}, {130, 120}, 3, true};
  const Result r = harmonised(left, right);
  BOOST_CHECK(r.g2);
  BOOST_CHECK((r.handles.left == Vector{43, 0} && r.handles.right == Vector{86, 0}));
  const Result fixed = harmonised({left.handle, left.second, 3, false}, right);
  BOOST_CHECK(fixed.g2);
  BOOST_CHECK((fixed.handles.left == left.handle && fixed.handles.right == Vector{100, 0}));
  const Result other = harmonised(left, {right.handle, right.second, 3, false});
  BOOST_CHECK(other.g2);
  BOOST_CHECK((other.handles.left == Vector{40, 0} && other.handles.right == right.handle));
}

BOOST_AUTO_TEST_CASE(nearest_exact_lengths) { // the same ratio
  const auto lengths = [](std::int64_t m, std::int64_t n) {
    const Result r = harmonised({{m, 0}, {90, -30}, 3, true}, {{n, 0}, {130, 120}, 3, true}, 0);
    return std::make_pair(r.handles.left.x, r.handles.right.x);
  };
  // as they are, within any bound
  BOOST_CHECK((lengths(43, 86) == std::pair<std::int64_t, std::int64_t>(43, 86)));
  const Result r = harmonised({{43, 0}, {90, -30}, 3, true}, {{88, 0}, {130, 120}, 3, true});
  BOOST_CHECK(r.g2);
  // by one unit, not two
  BOOST_CHECK((r.handles.left == Vector{44, 0} && r.handles.right == Vector{88, 0}));
}

BOOST_AUTO_TEST_CASE(handles_of_one_unit) { // the same ratio
  const GC::Handle_side left{{1, 0}, {90, -30}, 3, true}, right{{3, 0}, {130, 120}, 3, true};
  const Result r = harmonised(left, right), mirrored = harmonised(right, left);
  BOOST_CHECK(r.g2 && mirrored.g2);
  BOOST_CHECK((r.handles.left == Vector{1, 0} && r.handles.right == Vector{2, 0}));
  BOOST_CHECK((mirrored.handles.left == Vector{2, 0} && mirrored.handles.right == Vector{1, 0}));
}

BOOST_AUTO_TEST_CASE(for_different_degrees) {
  // 2/3 * 27 / m^2 and 1/2 * 16 / n^2: n : m = 2 : 3
  const Result r = harmonised({{0, -31}, {-27, -40}, 3, true}, {{0, -20}, {16, -50}, 2, true});
  BOOST_CHECK(r.g2);
  BOOST_CHECK((r.handles.left == Vector{0, -30} && r.handles.right == Vector{0, -20}));
}

BOOST_AUTO_TEST_CASE(nearly_where_it_is_not) {
  const Result r = harmonised({{60, 20}, {90, 10}, 3, true}, {{90, 30}, {130, 91}, 3, true});
  BOOST_CHECK(r.g1);
  BOOST_CHECK(!r.g2);
  BOOST_CHECK_LT(r.jump, 0.05);
  const auto ratio_4_to = [](std::int64_t y) { // n : m = sqrt(y) / 2
    return harmonised({{60, 0}, {90, -4}, 3, true}, {{90, 0}, {130, y}, 3, true});
  };
  BOOST_CHECK(ratio_4_to(9).g2 && !ratio_4_to(3).g2 && !ratio_4_to(5).g2);
  for (std::int64_t y : {3, 5}) BOOST_CHECK_LT(ratio_4_to(y).jump, 0.05);
  // one that would be shorter than a unit
  const Result tiny = harmonised({{100, 0}, {90, -9000}, 3, true}, {{1, 0}, {130, 1}, 3, true});
  BOOST_CHECK(tiny.g1 && tiny.handles.right.x >= 1 && tiny.handles.left.x >= 1);
}

BOOST_AUTO_TEST_CASE(nearly_with_one_fixed_handle) {
  // curvatures as 30 / m^2 and 91 / n^2: n : m = 1.7416...
  const auto lengths = [](std::int64_t m, bool left_movable, std::int64_t n) {
    const Result r = harmonised({{m, 0}, {90, -30}, 3, left_movable}, {{n, 0}, {130, 91}, 3, !left_movable});
    return std::make_pair(r.handles.left.x, r.handles.right.x);
  };
  BOOST_CHECK((lengths(50, false, 160) == std::pair<std::int64_t, std::int64_t>(50, 87)));
  BOOST_CHECK((lengths(100, true, 80) == std::pair<std::int64_t, std::int64_t>(46, 80)));
}

BOOST_AUTO_TEST_CASE(exact_lengths_beyond_the_bound_are_not_taken) {
  const GC::Handle_side left{{50, 0}, {90, -10000}, 3, true},
      right{{50, 0}, {130, 10201}, 3, true}; // n : m = 101 : 100
  const Result far = harmonised(left, right, 51 * 51), near = harmonised(left, right, 51 * 51 - 1);
  BOOST_CHECK(far.g2);
  BOOST_CHECK((far.handles.left == Vector{100, 0} && far.handles.right == Vector{101, 0}));
  BOOST_CHECK(near.g1 && !near.g2);
  BOOST_CHECK_LE((std::abs)(near.handles.left.x - 50) + (std::abs)(near.handles.right.x - 50), 6);
}

BOOST_AUTO_TEST_CASE(no_lengths_for_an_inflection) {
  BOOST_CHECK(!GC::harmonise_handles({{5, 0}, {9, 3}, 3, true}, {{5, 0}, {9, 3}, 3, true}, unbounded));
  BOOST_CHECK(!GC::harmonise_handles({{5, 0}, {9, 0}, 3, true}, {{5, 0}, {9, -3}, 3, true}, unbounded));
  BOOST_CHECK(!GC::harmonise_handles({{5, 0}, {9, -3}, 3, true}, {{5, 0}, {9, -3}, 3, true}, unbounded));
  BOOST_CHECK(!GC::harmonise_handles({{5, 0}, {9, -3}, 3, true}, {{5, 0}, {9, 0}, 3, true}, unbounded));
  const Result straight = harmonised({{5, 0}, {9, 0}, 3, true}, {{7, 0}, {9, 0}, 3, true});
  BOOST_CHECK(straight.g2);
  BOOST_CHECK((straight.handles.left == Vector{5, 0} && straight.handles.right == Vector{7, 0}));
}

BOOST_AUTO_TEST_CASE(bad_sides) {
  const GC::Handle_side side{{5, 0}, {9, 3}, 3, true};
  const auto error = [&](const GC::Handle_side& other) {
    const std::string right = error_of([&] { GC::harmonise_handles(side, other, 1); }),
                      left = error_of([&] { GC::harmonise_handles(other, side, 1); });
    BOOST_CHECK_EQUAL(left.substr(0, left.find(':')), right.substr(0, right.find(':')));
    return right.substr(0, right.find(':'));
  };
  BOOST_CHECK_EQUAL(error({{0, 0}, {9, 3}, 3, true}), "zero_tangent");
  BOOST_CHECK_EQUAL(error({{5, 1}, {9, 3}, 3, true}), "zero_direction");
  BOOST_CHECK_EQUAL(error({{-5, 0}, {9, 3}, 3, true}), "zero_direction");
  BOOST_CHECK_EQUAL(error({{5, 0}, {GC::max_harmonised_coordinate + 1, 3}, 3, true}), "work_limit");
  BOOST_CHECK_EQUAL(error({{5, 0}, {9, -GC::max_harmonised_coordinate - 1}, 3, true}), "work_limit");
  BOOST_CHECK_EQUAL(error({{5, 0}, {9, 3}, 1, true}), "wrong_number_of_points");
  BOOST_CHECK_EQUAL(error({{5, 0}, {9, 3}, GC::max_harmonised_degree + 1, true}), "wrong_number_of_points");
}

BOOST_AUTO_TEST_SUITE_END()
