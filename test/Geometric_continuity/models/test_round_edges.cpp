// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Models with rounded edges: boxes, also with bent faces.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/models/round_edges.h>

BOOST_AUTO_TEST_SUITE(rounded_models)

// The eight corners of a box, the number x + 2y + 4z.
template <class Traits> std::vector<typename Traits::Point> corners_of_box(int x, int y, int z) {
  std::vector<typename Traits::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i % 2 * x, i / 2 % 2 * y, i / 4 * z});
  return corners;
}
// Its faces, bilinear ones; the last one is the top.
template <class Traits> std::vector<Bezier<Traits>> faces(const std::vector<typename Traits::Point>& c) {
  std::vector<Bezier<Traits>> faces;
  for (const std::array<int, 4>& f :
       {std::array<int, 4>{0, 1, 2, 3}, {0, 1, 4, 5}, {2, 3, 6, 7}, {4, 0, 6, 2}, {1, 3, 5, 7}, {7, 6, 5, 4}})
    faces.push_back(Bezier<Traits>({{c[f[0]], c[f[1]]}, {c[f[2]], c[f[3]]}}));
  return faces;
}
template <class Surface, class Traits> std::vector<Surface> converted(const std::vector<Bezier<Traits>>& patches) {
  std::vector<Surface> surfaces;
  for (const Bezier<Traits>& s : patches)
    if constexpr (std::is_constructible_v<Surface, const Bspline<Traits>&>)
      surfaces.push_back(Surface(Bspline<Traits>(s)));
    else
      surfaces.push_back(Surface(s));
  return surfaces;
}

template <class Surface> auto continuity_of(const GC::Rounded_model<Surface>& model) {
  std::vector<Surface> all = model.surfaces;
  for (const auto& b : model.blends) all.push_back(b.surface);
  return GC::model_continuity(all).summary;
}

template <class Surface> void check_box(const std::vector<Surface>& box) {
  const auto r = GC::round_edges(box, {1});
  BOOST_CHECK_EQUAL(r.surfaces.size(), 6u);
  BOOST_CHECK_EQUAL(r.blends.size(), 12u);
  BOOST_CHECK(r.is_g2());
  BOOST_CHECK_EQUAL(r.meant + r.slight + r.not_rounded, 0u);
  BOOST_REQUIRE_EQUAL(r.corners.size(), 8u);
  for (const auto& c : r.corners) {
    BOOST_CHECK_EQUAL(c.patches.size(), 3u);
    BOOST_CHECK_EQUAL(c.blends.size(), 3u);
  }
  for (const auto& b : r.blends) {
    BOOST_CHECK(!b.fold);
    BOOST_CHECK(80 < b.angle.lower && b.angle.upper < 100);
    BOOST_CHECK_EQUAL(whole_edge_order(r.surfaces[b.patch_a], b.edge_a, b.surface, v0), 2);
    BOOST_CHECK_EQUAL(whole_edge_order(b.surface, v1, r.surfaces[b.patch_b], b.edge_b), 2);
  }
  const auto summary = continuity_of(r);
  BOOST_CHECK_EQUAL(summary.g2, 24u);
  BOOST_CHECK_EQUAL(summary.g1 + summary.g0, 0u);
  BOOST_CHECK_EQUAL(summary.boundary, 24u); // of eight holes
}

BOOST_AUTO_TEST_CASE_TEMPLATE(box, Traits, All_traits) { check_box(faces<Traits>(corners_of_box<Traits>(8, 16, 32))); }
BOOST_AUTO_TEST_CASE(box_of_other_types) {
  const auto patches = faces<Exact>(corners_of_box<Exact>(8, 16, 32));
  check_box(converted<Bspline<Exact>>(patches));
  check_box(converted<Patch<Exact>>(patches));
  check_box(converted<Spline<Exact>>(patches));
}

// Corners are moved by numbers of 64 bits, so that no face is plane.
BOOST_AUTO_TEST_CASE(bent_box) {
  Random_surfaces random;
  std::vector<Exact::Point> corners = corners_of_box<Exact>(8, 8, 8);
  const Q small = Q(1) / Q(1 << 30) / Q(16);
  for (Exact::Point& p : corners)
    p = Exact::Point(p.x() + small * random.number(), p.y() + small * random.number(), p.z() + small * random.number());
  check_box(faces<Exact>(corners));
}

// Without a top: the upright edges end at the boundary.
BOOST_AUTO_TEST_CASE(open_box) {
  auto patches = faces<Exact>(corners_of_box<Exact>(8, 8, 8));
  patches.pop_back();
  const auto r = GC::round_edges(patches, {2});
  BOOST_CHECK_EQUAL(r.blends.size(), 8u);
  BOOST_REQUIRE_EQUAL(r.corners.size(), 4u);
  for (const auto& c : r.corners) BOOST_CHECK_EQUAL(c.point.z(), Q(0));
  BOOST_CHECK_EQUAL(r.surfaces[0].domain_u().first, fraction(1, 4));
  BOOST_CHECK_EQUAL(r.surfaces[0].domain_u().second, fraction(3, 4));
}

// Three faces of a roof and a wall: angles of 90, 45 and about 1.8 degrees, and 0.
BOOST_AUTO_TEST_CASE(angles) {
  typedef Exact::Point P;
  std::vector<Bezier<Exact>> strips;
  const std::vector<std::array<int, 2>> profile = {{0, 0}, {0, 8}, {8, 16}, {16, 16}, {48, 15}, {80, 14}};
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const auto &a = profile[i - 1], &b = profile[i];
    strips.push_back(Bezier<Exact>({{P(a[0], 0, a[1]), P(a[0], 8, a[1])}, {P(b[0], 0, b[1]), P(b[0], 8, b[1])}}));
  }
  const auto count = [&](double least, double greatest) {
    const auto r = GC::round_edges(strips, {1, least, greatest});
    BOOST_CHECK(r.is_g2() && r.corners.empty() && r.not_rounded == 0);
    return std::array<std::size_t, 3>{r.blends.size(), r.slight, r.meant};
  };
  BOOST_CHECK((count(5, 180) == std::array<std::size_t, 3>{2, 1, 0}));
  BOOST_CHECK((count(0, 180) == std::array<std::size_t, 3>{3, 0, 0}));
  BOOST_CHECK((count(46, 180) == std::array<std::size_t, 3>{0, 3, 0}));
  BOOST_CHECK((count(0, 44) == std::array<std::size_t, 3>{1, 0, 2}));
}

// A wall on a floor, which leans to the one side and then to the other one: its two halves have
// blends of different shapes, which meet all the same. Each of the four surfaces is given in all
// ways.
BOOST_AUTO_TEST_CASE(edges_that_go_on) {
  typedef Exact::Point P;
  const Bezier<Exact> floor({{P(0, 0, 0), P(0, 8, 0)}, {P(16, 0, 0), P(16, 8, 0)}}),
      wall({{P(0, 0, 0), P(0, -2, 8)}, {P(16, 0, 0), P(16, 2, 8)}});
  const auto floors = floor.split_u(fraction(1, 2)), walls = wall.split_u(fraction(1, 2));
  for (int turns = 0; turns < 16; ++turns) {
    std::vector<Bezier<Exact>> model = {floors.first, walls.first, walls.second, floors.second};
    for (int i = 0; i < 4; ++i)
      if (turns >> i & 1) model[i] = i % 2 == 0 ? model[i].reverse_u() : model[i].swap_parameters();
    if (turns % 3 == 0) std::reverse(model.begin(), model.end());
    const auto r = GC::round_edges(model, {2});
    BOOST_REQUIRE_EQUAL(r.blends.size(), 2u);
    BOOST_CHECK(r.is_g2() && r.corners.empty());
    const auto summary = continuity_of(r);
    BOOST_CHECK_EQUAL(summary.g2, 6u); // with the floor, with the wall, and the seams of these
    BOOST_CHECK_EQUAL(summary.g1, 1u); // of the blends
  }
  const auto in_one_order =
      GC::round_edges(std::vector<Bezier<Exact>>{floors.first, walls.first, floors.second, walls.second}, {2});
  BOOST_CHECK(in_one_order.blends.size() == 2 && in_one_order.is_g2() && in_one_order.corners.empty());
  auto not_g2 = in_one_order;
  not_g2.blends[1].with_b.g_order = 1;
  BOOST_CHECK(!not_g2.is_g2());
  not_g2.blends[0].with_a.g_order = 1;
  BOOST_CHECK(!not_g2.is_g2());
  const auto splines =
      converted<Spline<Exact>>(std::vector<Bezier<Exact>>{floors.first, walls.first, walls.second, floors.second});
  const auto summary = continuity_of(GC::round_edges(splines, {2}));
  BOOST_CHECK(summary.g2 == 6 && summary.g1 == 1);
}

// There is a slight kink between the halves, and a part of it is left at the new edges: both blends
// are G2 with the surfaces in any case.
BOOST_AUTO_TEST_CASE(edges_that_go_on_with_a_kink) {
  typedef Exact::Point P;
  std::size_t open = 0, meeting = 0;
  for (const int of_floor : {0, 1, -1})
    for (const int of_wall : {0, 1, -1})
      for (const int lean : {0, 2}) {
        const Q f = fraction(of_floor, 8), w = fraction(of_wall, 8);
        const std::vector<Bezier<Exact>> model = {
            Bezier<Exact>({{P(0, 0, 0), P(0, 8, 0)}, {P(8, 0, 0), P(8, 8, 0)}}),
            Bezier<Exact>({{P(0, 0, 0), P(0, -lean, 8)}, {P(8, 0, 0), P(8, 0, 8)}}),
            Bezier<Exact>({{P(8, 0, 0), P(8, 8, 0)}, {P(16, 0, 0), P(Q(16), Q(8), f)}}),
            Bezier<Exact>({{P(8, 0, 0), P(8, 0, 8)}, {P(16, 0, 0), P(Q(16), w, Q(8))}})};
        const auto r = GC::round_edges(model, {2, 30});
        BOOST_REQUIRE_EQUAL(r.blends.size(), 2u);
        BOOST_CHECK(r.is_g2());
        ++(r.corners.empty() ? meeting : open);
        for (const auto& c : r.corners) BOOST_CHECK(c.patches.size() == 4 && c.blends.size() == 2);
      }
  BOOST_CHECK(meeting > 0 && open > 0);
}

// Four faces of a pyramid meet at its tip, and all their edges are rounded.
BOOST_AUTO_TEST_CASE(tip_of_a_pyramid) {
  typedef Exact::Point P;
  const int x[] = {8, 0, -8, 0, 8}, y[] = {0, 8, 0, -8, 0};
  std::vector<Bezier<Exact>> sides;
  for (int i = 0; i < 4; ++i)
    sides.push_back(Bezier<Exact>(
        {{P(0, 0, 8), P(x[i], y[i], 0)}, {P(x[i + 1], y[i + 1], 0), P(x[i] + x[i + 1], y[i] + y[i + 1], -8)}}));
  const auto r = GC::round_edges(sides, {1});
  BOOST_CHECK(r.blends.size() == 4 && r.is_g2());
  BOOST_REQUIRE_EQUAL(r.corners.size(), 1u);
  BOOST_CHECK(r.corners[0].point == P(0, 0, 8) && r.corners[0].patches.size() == 4 && r.corners[0].blends.size() == 4);
}

// A closed wall on a floor: the one blend ends where it starts.
BOOST_AUTO_TEST_CASE(closed_edge) {
  typedef Exact::Point P;
  const std::vector<std::array<int, 2>> ring = {{8, 0},   {8, 8},  {0, 8},  {-8, 8}, {-8, 0},
                                                {-8, -8}, {0, -8}, {8, -8}, {8, 0}};
  std::vector<std::vector<P>> wall, floor;
  for (const auto& p : ring) {
    wall.push_back({P(p[0], p[1], 0), P(p[0], p[1], 8)});
    floor.push_back({P(p[0], p[1], 0), P(2 * p[0], 2 * p[1], 0)});
  }
  const Knots u(2, Q(0), Q(4), {{Q(1), 2}, {Q(2), 2}, {Q(3), 2}}), v(1, Q(0), Q(1));
  const auto r = GC::round_edges(std::vector<Bspline<Exact>>{{wall, u, v}, {floor, u, v}}, {2});
  BOOST_REQUIRE_EQUAL(r.blends.size(), 1u);
  BOOST_CHECK(r.is_g2() && r.corners.empty());
  BOOST_CHECK(r.blends[0].surface(Q(0), fraction(1, 3)) == r.blends[0].surface(Q(4), fraction(1, 3)));
}

BOOST_AUTO_TEST_CASE(what_is_not_rounded) {
  typedef Exact::Point P;
  // three squares at one edge
  const auto square = [](const P& p) { return Bezier<Exact>({{P(0, 0, 0), p}, {P(0, 0, 8), P(p.x(), p.y(), 8)}}); };
  const std::vector<Bezier<Exact>> star = {square(P(8, 0, 0)), square(P(0, 8, 0)), square(P(-8, -8, 0))};
  const auto r = GC::round_edges(star, {1});
  BOOST_CHECK_EQUAL(r.not_rounded, 2u);
  BOOST_CHECK(r.blends.empty() && r.surfaces == star);
  // a normal that vanishes at an end of the edge, or along all of it
  const auto wall = square(P(8, 0, 0));
  for (const P& tip : {P(0, 0, 0), P(0, 8, 0)}) {
    const Bezier<Exact> other =
        tip == P(0, 0, 0) ? Bezier<Exact>({{P(0, 0, 0), tip}, {P(0, 0, 8), P(0, 8, 8)}})
                          : Bezier<Exact>({{P(0, 0, 0), P(0, 0, 0), tip}, {P(0, 0, 8), P(0, 0, 8), P(0, 8, 8)}});
    const auto singular = GC::round_edges(std::vector<Bezier<Exact>>{wall, other}, {1});
    BOOST_CHECK(singular.not_rounded == 1 && singular.blends.empty());
  }
  // no room
  const auto box = faces<Exact>(corners_of_box<Exact>(8, 16, 32));
  CHECK_ERROR(GC::round_edges(box, {4}), parameter_outside_domain);
  BOOST_CHECK_EQUAL(
      error_of([&] { GC::round_edges(box, {20}); }),
      "parameter_outside_domain: patch 0 u0: set_back_parameter: the distance 20.000000 from the edge u0 is "
      "not less than that of the opposite edge");
  CHECK_ERROR(GC::round_edges(box, {0}), parameter_outside_domain);
  BOOST_CHECK(GC::round_edges(std::vector<Bezier<Exact>>(), {1}).surfaces.empty());
}

BOOST_AUTO_TEST_SUITE_END()
