// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Limits of the work: what is too much is refused by a typed error that names the place, and what
// is enclosed stays enclosed.

#include "support/fractions.h"
#include "support/limited.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>

BOOST_AUTO_TEST_SUITE(work_limits)

typedef CGAL::Simple_cartesian<Q> Kernel;
typedef GC::Traits_3<Kernel> Space;
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Bezier_patch<Space> Patch;
typedef Space::Point Point;

constexpr GC::Patch_edge v0 = GC::Patch_edge::v0;
const GC::Work_limit one_step(1);

// Two bilinear patches with the edge v = 0 from (0, 0, 0) to (1, 0, 0), which end at these points.
std::vector<Patch> two(const Point& a0, const Point& a1, const Point& b0, const Point& b1) {
  return {Patch({{Point(0, 0, 0), a0}, {Point(1, 0, 0), a1}}), Patch({{Point(0, 0, 0), b0}, {Point(1, 0, 0), b1}})};
}
std::vector<Patch> crease() { return two(Point(0, 1, 1), Point(1, 1, 3), Point(0, -1, 2), Point(1, -1, 1)); }

// Squares over [x, x + 1] x [y, y + 1], with corners moved at random by multiples of 2^-20.
Patch square(int x, int y, std::mt19937& random) {
  const auto corner = [&](int i, int j) {
    const auto shift = [&] { return Q(Q(static_cast<int>(random() % 5)) * power_of_two<Q>(-20)); };
    return Point{Q(Q(x + i) + shift()), Q(Q(y + j) + shift()), shift()};
  };
  return Patch({{corner(0, 0), corner(0, 1)}, {corner(1, 0), corner(1, 1)}});
}

BOOST_AUTO_TEST_CASE(one_step_is_too_few) {
  const std::vector<Patch> model = crease();
  const GC::Edge_rows<Q> rows = GC::edge_rows(model[0], v0), other = GC::edge_rows(model[1], v0);
  const GC::Bernstein_polynomial<Q> polynomial{Q(1), Q(-5), Q(1)};
  CHECK_ERROR(limited(one_step, [&] { return GC::edge_continuity(model[0], v0, model[1], v0); }), work_limit);
  CHECK_ERROR(limited(one_step, [&] { return GC::deviation(model[0], v0, model[1], v0); }), work_limit);
  CHECK_ERROR(limited(one_step, [&] { return GC::order_within(model[0], v0, model[1], v0, {1, 1}); }), work_limit);
  CHECK_ERROR(limited(one_step, [&] { return GC::common_edges(model[0], model[1]); }), work_limit);
  CHECK_ERROR(limited(one_step, [&] { return GC::edge_continuity(rows, other); }), work_limit);
  CHECK_ERROR(limited(one_step, [&] { return GC::sign_pattern(polynomial); }), work_limit);
  BOOST_CHECK_EQUAL(error_of([&] { limited(one_step, [&] { return GC::model_continuity(model); }); }),
                    "work_limit: patch 0 v0 - patch 1 v0: edge_continuity: more than 1 steps of work");
  BOOST_CHECK_EQUAL(GC::model_continuity(model).summary.creases, 1u);
}

BOOST_AUTO_TEST_CASE(a_search_that_is_stopped_still_encloses) {
  const std::vector<Patch> model = crease();
  const GC::Edge_continuity<Q> best = GC::edge_continuity(model[0], v0, model[1], v0);
  BOOST_CHECK_LT(best.deviation->largest_angle() - best.deviation->smallest_angle(), 1e-14);
  bool wider = false;
  for (int steps = 2000; steps < 2000000; steps *= 2) {
    try {
      const GC::Edge_continuity<Q> e =
          limited(GC::Work_limit(steps), [&] { return GC::edge_continuity(model[0], v0, model[1], v0); });
      BOOST_CHECK(e.defect == best.defect && e.coplanar == best.coplanar && e.side == best.side);
      BOOST_CHECK(e.deviation->lower <= best.deviation->lower && best.deviation->upper <= e.deviation->upper);
      wider = wider || best.deviation->upper < e.deviation->upper;
    } catch (const GC::Error& error) {
      BOOST_CHECK(error.code() == GC::Error_code::work_limit);
    }
  }
  BOOST_CHECK(wider);
}

// The angle changes at scales down to 2^-12000 of the edge, or in numbers of as many digits.
BOOST_AUTO_TEST_CASE(numbers_of_very_different_sizes) {
  const Q huge = power_of_two<Q>(12000), tiny = power_of_two<Q>(-12000);
  const std::vector<Patch> model =
      two(Point(tiny, huge, -1), Point(3, tiny, huge), Point(Q(-tiny), 1, huge), Point(huge, Q(-huge), tiny));
  const auto decided = GC::model_continuity(model);
  BOOST_CHECK_EQUAL(decided.summary.creases, 1u);
  const GC::Enclosure angle =
      decided.edges[2].continuity.deviation ? decided.edges[2].continuity.deviation->angle() : GC::Enclosure{0, 0};
  BOOST_CHECK(angle.lower <= angle.upper);
  for (double gap : {5e-324, 1.0, 1e308})
    for (const GC::Nearly_coincident_edges& e : GC::nearly_coincident_edges(model, decided, {1e308, gap})) {
      BOOST_CHECK(e.within(0) != GC::Verdict::refuted);
      BOOST_CHECK(e.within.deviation.gap.lower <= gap);
    }
}

// The curve on both sides of a knot, in fractions: all orders hold, also above 3, where
// denominators are cleared.
BOOST_AUTO_TEST_CASE(joins_of_high_order) {
  std::mt19937 random(20261122);
  const int n = 8;
  std::vector<Plane::Point> points;
  const auto fraction = [&] {
    return Q(Q(static_cast<int>(random() % 1999) - 999) / Q(static_cast<int>(random() % 999) + 1));
  };
  for (int i = 0; i <= n; ++i) points.push_back({fraction(), fraction()});
  const GC::Bezier_curve<Plane> whole(points.begin(), points.end(), Q(0), Q(3));
  const auto [left, right] = whole.split(Q(Q(4) / Q(3)));
  const GC::Bezier_curve<Plane> slow(right.begin(), right.end(), Q(0), Q(Q(1) / Q(7)));
  for (int order = 4; order <= n; ++order) {
    const GC::Join_continuity<Q> join = GC::continuity(left, slow, order),
                                 on_jets = GC::continuity(left.end_jet(order), slow.start_jet(order), order);
    BOOST_CHECK_EQUAL(join.g_order, order);
    BOOST_CHECK_EQUAL(join.c_order, 0);
    BOOST_CHECK_EQUAL(join.f_order, 2);
    BOOST_CHECK(join.betas() == on_jets.betas());
    BOOST_CHECK_EQUAL(join.betas()[0], Q(Q(35) / Q(3))); // 3 - 4/3 by 1/7
    const GC::Work_scope each(one_step);
    CHECK_ERROR(GC::continuity(left, slow, order), work_limit);
  }
  GC::Chain_accumulator<GC::Bezier_curve<Plane>> chain(n);
  chain.add(left);
  CHECK_ERROR(limited(one_step, [&] { chain.add(slow); }), work_limit);
  BOOST_CHECK_EQUAL(chain.size(), 1u);
  BOOST_CHECK_EQUAL(GC::continuity(left, right, n).c_order, n);
}

// Near edges are those that all pairs give.
BOOST_AUTO_TEST_CASE(near_edges_are_found) {
  constexpr unsigned seed = 7;
  std::mt19937 random(seed);
  std::vector<Patch> model;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) model.push_back(square(x, y, random));
  const auto decided = GC::model_continuity(model);
  std::vector<std::pair<std::size_t, GC::Patch_edge>> boundary;
  for (const auto& e : decided.edges)
    if (e.kind == GC::Model_edge_kind::boundary) boundary.emplace_back(e.patch_a, e.edge_a);
  std::vector<decltype(GC::deviation(model[0], GC::Patch_edge::u0, model[0], GC::Patch_edge::u0))> deviations;
  for (std::size_t i = 0; i < boundary.size(); ++i)
    for (std::size_t j = i + 1; j < boundary.size(); ++j)
      deviations.push_back(
          GC::deviation(model[boundary[i].first], boundary[i].second, model[boundary[j].first], boundary[j].second));
  for (int units : {0, 1, 2, 3, 4, 5, 6, 7, 8, 2000000}) {
    const GC::Edge_tolerance tolerance{0, units * 0x1p-20};
    const std::vector<GC::Nearly_coincident_edges> found = GC::nearly_coincident_edges(model, decided, tolerance);
    std::size_t expected = 0, pair = 0;
    for (std::size_t i = 0; i < boundary.size(); ++i)
      for (std::size_t j = i + 1; j < boundary.size(); ++j) {
        const auto& [p, e] = boundary[i];
        const auto& [q, f] = boundary[j];
        if (GC::order_within(deviations[pair++], tolerance)(0) == GC::Verdict::refuted) continue;
        BOOST_REQUIRE_LT(expected, found.size());
        const GC::Nearly_coincident_edges& x = found[expected++];
        BOOST_CHECK_MESSAGE(x.patch_a == p && x.edge_a == e && x.patch_b == q && x.edge_b == f,
                            "pair " << expected << ", " << units << " units, seed " << seed);
      }
    BOOST_CHECK_EQUAL(found.size(), expected);
  }
  CHECK_ERROR(limited(one_step, [&] { return GC::nearly_coincident_edges(model, decided, {0, 1}); }), work_limit);
}

BOOST_AUTO_TEST_SUITE_END()
