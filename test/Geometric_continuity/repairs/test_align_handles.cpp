// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Kinks are repaired on the grid: no pair of parallel vectors is nearer, for random and for special
// legs.

#include "support/decided_joins.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

BOOST_AUTO_TEST_SUITE(align_handles)

typedef GC::Grid_vector Vector;
// the squares of the larger and of the smaller move
typedef std::pair<std::int64_t, std::int64_t> Cost;

Cost cost(const Vector& a, const Vector& b, const Vector& x, const Vector& y) {
  const std::int64_t left = squared_length(x - a), right = squared_length(y - b);
  return {(std::max)(left, right), (std::min)(left, right)};
}

bool have_one_direction(const Vector& x, const Vector& y) { return cross(x, y) == 0 && dot(x, y) > 0; }

template <class Action> void for_each_near(const Vector& v, int r, Action f) {
  for (std::int64_t i = -r; i <= r; ++i)
    for (std::int64_t j = -r; j <= r; ++j)
      if (i * i + j * j <= r * r) f(Vector{v.x + i, v.y + j});
}

// The least cost of all pairs that move by at most r units.
Cost least_cost(const Vector& a, const Vector& b, int r) {
  Cost best(std::int64_t(1) << 60, 0);
  for_each_near(a, r, [&](const Vector& x) {
    for_each_near(b, r, [&](const Vector& y) {
      if (have_one_direction(x, y)) best = (std::min)(best, cost(a, b, x, y));
    });
  });
  return best;
}

bool is_kink(const Vector& a, const Vector& b) {
  const Vector zero{0, 0};
  return a != zero && b != zero && dot(a, b) >= (std::abs)(cross(a, b));
}

// The convergents of the direction of v, and those between them.
std::vector<Vector> convergents(const Vector& v) {
  std::vector<Vector> result;
  Vector low{v.x < 0 ? -1 : 1, 0}, high{0, v.y < 0 ? -1 : 1};
  const auto add = [&](Vector& changed, const Vector& other) { // as long as v is not passed
    const std::int64_t rest = (std::abs)(cross(changed, v)), by = (std::abs)(cross(other, v));
    const std::int64_t steps = by == 0 ? 1 : rest / by;
    for (const std::int64_t k : {std::int64_t(1), steps / 2, steps})
      if (k > 0) result.push_back(changed + k * other);
    changed = changed + steps * other;
    return rest != 0 && by != 0;
  };
  while (add(low, high) && add(high, low) && result.size() < 200) {
  }
  return result;
}

// The multiple of d that is nearest to v.
Vector nearest(const Vector& v, const Vector& d) {
  const std::int64_t k = std::llround(static_cast<double>(dot(v, d)) / static_cast<double>(squared_length(d)));
  return (std::max)(std::int64_t(1), k) * d;
}

// The result is a pair of one direction, and none is nearer as far as r units.
void check(const Vector& a, const Vector& b, int r) {
  const std::optional<GC::Aligned_handles> handles = GC::align_handles(a, b);
  BOOST_REQUIRE(handles);
  const Cost found = cost(a, b, handles->left, handles->right);
  BOOST_CHECK_MESSAGE(have_one_direction(handles->left, handles->right), a << ' ' << b);
  const Cost best = least_cost(a, b, (std::min)(r, 1 + static_cast<int>(std::sqrt(found.first))));
  BOOST_CHECK_MESSAGE(found <= best, a << ' ' << b << " -> " << handles->left << ' ' << handles->right);
  const std::optional<GC::Aligned_handles> mirrored = GC::align_handles(b, a);
  BOOST_CHECK(cost(b, a, mirrored->left, mirrored->right) == found);
}

BOOST_AUTO_TEST_CASE(random_kinks_against_all_pairs) {
  std::mt19937 random = seeded(20817);
  int checked = 0;
  while (checked < 400) {
    const int size = std::uniform_int_distribution<int>(1, 70)(random);
    std::uniform_int_distribution<int> coordinate(-size, size), near(-2, 2);
    std::uniform_real_distribution<double> ratio(0.1, 3);
    const Vector a{coordinate(random), coordinate(random)};
    const double f = ratio(random);
    const auto scaled = [&](std::int64_t x) { return std::llround(f * static_cast<double>(x)) + near(random); };
    const Vector b =
        checked % 2 == 0 ? Vector{scaled(a.x), scaled(a.y)} : Vector{coordinate(random), coordinate(random)};
    if (!is_kink(a, b)) continue;
    check(a, b, 3);
    ++checked;
  }
}

BOOST_AUTO_TEST_CASE(vectors_on_the_grid) {
  BOOST_CHECK_EQUAL(text(GC::Grid_vector{-3, 7}), "(-3, 7)");
  BOOST_CHECK((primitive(GC::Grid_vector{0, 0}) == GC::Grid_vector{0, 0}));
}

BOOST_AUTO_TEST_CASE(all_small_legs) {
  const auto for_each = [](auto f) { for_each_near(Vector{0, 0}, 4, f); };
  for_each([&](const Vector& a) {
    for_each([&](const Vector& b) {
      if (a.x >= 0 && a.y >= 0 && is_kink(a, b)) check(a, b, 3);
    });
  });
}

// A node on the long side of which only one direction is near: the first leg is a multiple of a
// long primitive vector.
BOOST_AUTO_TEST_CASE(long_primitive_directions) {
  const Vector d{987, 610};
  for (const std::int64_t sign : {1, -1})
    for (int turn = 0; turn < 2; ++turn) {
      const Vector base = turn == 0 ? sign * d : sign * Vector{-d.y, d.x};
      const Vector a = 1000 * base, b = 1307 * base + Vector{1, 0};
      const std::optional<GC::Aligned_handles> handles = GC::align_handles(a, b);
      BOOST_REQUIRE(handles);
      BOOST_CHECK(handles->left == a && handles->right == 1307 * base);
    }
  check({1000, 1}, {1000, 0}, 3);
  check({12345, 6789}, {12344, 6790}, 3);
}

BOOST_AUTO_TEST_CASE(a_short_handle_beside_a_long_one) {
  check({1, 0}, {20, 1}, 3);
  check({3, 1}, {250, 70}, 5);
  // the best direction is short, and found at once
  for (const std::int64_t n : {1000, 100000, 100000000}) {
    const std::optional<GC::Aligned_handles> handles = GC::align_handles({2, 1}, {2 * n, n + 1});
    BOOST_REQUIRE(handles);
    BOOST_CHECK(cost({2, 1}, {2 * n, n + 1}, handles->left, handles->right).first <= 1);
  }
}

// The search takes as many steps as the shorter leg admits, however long the other one is: an hour
// would not do if not.
BOOST_AUTO_TEST_CASE(short_handles_beside_the_longest_ones) {
  const std::int64_t n = GC::max_handle_coordinate;
  check({10, 0}, {n, n - 1}, 8);
  check({-7, 3}, {-n, 5}, 6);
  std::mt19937 random = seeded(60461);
  for (int checked = 0; checked < 300;) {
    const std::int64_t size = std::int64_t(1) << std::uniform_int_distribution<int>(5, 28)(random);
    std::uniform_int_distribution<std::int64_t> small(-12, 12), large(-size, size);
    const Vector a{small(random), small(random)}, b{large(random), large(random)};
    if (!is_kink(a, b)) continue;
    check(a, b, 6);
    ++checked;
  }
  // of all lengths and angles: not worse than the legs that a continued fraction of the direction
  // in the middle gives
  for (int checked = 0; checked < 2000;) {
    const auto leg = [&] {
      const std::int64_t size = std::int64_t(1) << std::uniform_int_distribution<int>(1, 28)(random);
      std::uniform_int_distribution<std::int64_t> coordinate(-size, size);
      return Vector{coordinate(random), coordinate(random)};
    };
    const Vector a = leg(), b = leg();
    if (!is_kink(a, b)) continue;
    const std::optional<GC::Aligned_handles> handles = GC::align_handles(a, b);
    BOOST_REQUIRE(handles);
    BOOST_CHECK(have_one_direction(handles->left, handles->right));
    const std::int64_t moved = cost(a, b, handles->left, handles->right).first;
    for (const Vector& d : convergents(a + b)) BOOST_CHECK_LE(moved, cost(a, b, nearest(a, d), nearest(b, d)).first);
    ++checked;
  }
}

// A bound changes nothing but whether there is a result.
BOOST_AUTO_TEST_CASE(allowed_moves) {
  std::mt19937 random = seeded(3391);
  int within = 0, beyond = 0;
  while (within < 300 || beyond < 300) {
    const std::int64_t size = std::int64_t(1) << std::uniform_int_distribution<int>(2, 28)(random);
    std::uniform_int_distribution<std::int64_t> coordinate(-size, size), step(-size / 8, size / 8);
    const Vector a{coordinate(random), coordinate(random)}, b{a.x + step(random), a.y + step(random)};
    if (!is_kink(a, b) || cross(a, b) == 0 || (std::max)((std::abs)(b.x), (std::abs)(b.y)) > GC::max_handle_coordinate)
      continue;
    const GC::Aligned_handles best = GC::align_handles(a, b).value();
    const std::int64_t moved = cost(a, b, best.left, best.right).first;
    const std::int64_t bound = std::uniform_int_distribution<std::int64_t>(moved - moved / 8 - 2, moved + 2)(random);
    const std::optional<GC::Aligned_handles> bounded = GC::align_handles(a, b, bound);
    BOOST_REQUIRE_EQUAL(bounded.has_value(), moved <= bound);
    if (bounded) BOOST_CHECK(cost(a, b, bounded->left, bounded->right) == cost(a, b, best.left, best.right));
    ++(bounded ? within : beyond);
  }
  BOOST_CHECK(!GC::align_handles({5, 1}, {5, 2}, 0) && !GC::align_handles({5, 1}, {5, 2}, -1));
  BOOST_CHECK(GC::align_handles({5, 1}, {5, 1}, 0));
}

BOOST_AUTO_TEST_CASE(smooth_legs_stay) {
  const std::optional<GC::Aligned_handles> handles = GC::align_handles({6, -4}, {-3 * -5, -10});
  BOOST_REQUIRE(handles);
  BOOST_CHECK((handles->left == Vector{6, -4} && handles->right == Vector{15, -10}));
}

BOOST_AUTO_TEST_CASE(corners_and_bad_legs) {
  BOOST_CHECK(!GC::align_handles({5, 0}, {5, 6}));
  BOOST_CHECK(!GC::align_handles({5, 0}, {-5, 0}));
  BOOST_CHECK(GC::align_handles({5, 0}, {5, 5}));
  CHECK_ERROR(GC::align_handles({0, 0}, {1, 0}), zero_tangent);
  CHECK_ERROR(GC::align_handles({1, 0}, {GC::max_handle_coordinate + 1, 0}), work_limit);
  CHECK_ERROR(GC::align_handle({1, -GC::max_handle_coordinate - 1}, {1, 0}), work_limit);
  for (const std::int64_t x : {-GC::max_handle_coordinate - 1, GC::max_handle_coordinate + 1})
    for (const Vector& v : {Vector{x, 1}, Vector{1, x}}) {
      CHECK_ERROR(GC::align_handles(v, {1, 0}), work_limit);
      CHECK_ERROR(GC::align_handles({1, 0}, v), work_limit);
    }
  CHECK_ERROR(GC::align_handle({1, 1}, {0, 0}), zero_tangent);
}

BOOST_AUTO_TEST_CASE(the_longest_legs) {
  const std::int64_t n = GC::max_handle_coordinate;
  for (const auto& [a, b] : {std::pair(Vector{n, n - 1}, Vector{n - 3, n}),
                             {Vector{-n, 17}, Vector{-n, 12345}},
                             {Vector{n / 3, -n}, Vector{n / 3 + 1000, -n}},
                             {Vector{n, n}, Vector{n - n / 8, n}}}) {
    const std::optional<GC::Aligned_handles> handles = GC::align_handles(a, b);
    BOOST_REQUIRE(handles);
    BOOST_CHECK(have_one_direction(handles->left, handles->right));
    const double moved = std::sqrt(static_cast<double>(cost(a, b, handles->left, handles->right).first)),
                 least = (std::abs)(static_cast<double>(cross(a, b))) / std::sqrt(double(squared_length(a + b)));
    BOOST_CHECK_GE(moved, least * (1 - 1e-12));
    BOOST_CHECK_LE(moved, least + 60); // the grid costs little
  }
}

BOOST_AUTO_TEST_CASE(one_handle_is_fixed) {
  BOOST_CHECK((GC::align_handle({7, 1}, {300, 0}) == Vector{7, 0}));
  BOOST_CHECK((GC::align_handle({-7, 1}, {-20, -10}) == Vector{-6, -3} ||
               GC::align_handle({-7, 1}, {-20, -10}) == Vector{-4, -2}));
  // the nearest that points there
  BOOST_CHECK((GC::align_handle({1, 0}, {-13, 0}) == Vector{-1, 0}));
  BOOST_CHECK((GC::align_handle({10, 9}, {101, 97}) == Vector{101, 97}));
  std::mt19937 random = seeded(4711);
  std::uniform_int_distribution<int> coordinate(-40, 40);
  for (int i = 0; i < 2000; ++i) {
    const Vector leg{coordinate(random), coordinate(random)}, d{coordinate(random), coordinate(random)};
    if (leg == Vector{0, 0} || d == Vector{0, 0}) continue;
    const Vector x = GC::align_handle(leg, d), unit = GC::primitive(d);
    BOOST_CHECK(have_one_direction(x, d));
    for (std::int64_t k = 1; k <= 60; ++k) BOOST_CHECK_LE(squared_length(x - leg), squared_length(k * unit - leg));
  }
}

// Cubics with the legs are G1 by the predicate of joins.
BOOST_AUTO_TEST_CASE(joins_become_smooth) {
  typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;
  typedef Traits::Point Point;
  const auto point = [](const Vector& v) { return Point(static_cast<double>(v.x), static_cast<double>(v.y)); };
  const auto smooth = [&](const Vector& a, const Vector& b) {
    const Vector node{431, 250};
    const Point left[] = {Point(0, 0), Point(100, 30), point(node - a), point(node)},
                right[] = {point(node), point(node + b), Point(700, 300), Point(800, 250)};
    return decide_g1_join(GC::Bezier_curve<Traits>(left, left + 4), GC::Bezier_curve<Traits>(right, right + 4));
  };
  const Vector a{97, 31}, b{143, 44};
  const std::optional<GC::Aligned_handles> handles = GC::align_handles(a, b);
  BOOST_REQUIRE(handles);
  BOOST_CHECK(!smooth(a, b));
  BOOST_CHECK(smooth(handles->left, handles->right));
}

BOOST_AUTO_TEST_SUITE_END()
