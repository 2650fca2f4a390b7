// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Models of Bezier patches.

#include "support/archetype.h"
#include "support/nets.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <list>

// A biquadratic patch over the square [x, x+1] x [y, y+1], with the control points (x + i/2, y +
// j/2, h(2x+i, 2y+j)).
template <class Height> Net height_net(int x, int y, Height h) {
  return net_of(3, 3, [&](int i, int j) {
    return Column{Q(Q(2 * x + i) / Q(2)), Q(Q(2 * y + j) / Q(2)), Q(h(2 * x + i, 2 * y + j))};
  });
}

template <class Model>
const typename decltype(Model::edges)::value_type* find_edge(const Model& model, std::size_t patch, Patch_edge edge) {
  for (const auto& e : model.edges)
    if ((e.patch_a == patch && e.edge_a == edge) || (e.patch_b == patch && e.edge_b == edge)) return &e;
  return nullptr;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(model_of_a_grid, K, All_kernels) {
  // 3 x 3 patches of a plane, but for a bump in the middle: a crease around it, where one control
  // point of each edge moves
  const auto flat = [](int, int) { return 0; };
  // G1 with the plane, and of order 2 nowhere
  const auto bump = [](int i, int j) { return i == 3 && j == 3 ? 1 : 0; };
  const auto tilt = [](int i, int) { return i == 1 ? 1 : 0; };
  std::vector<Net> nets;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) nets.push_back(x == 1 && y == 1 ? height_net(x, y, bump) : height_net(x, y, flat));
  std::vector<Patch<K>> p = patches<K>(nets);
  const auto creased = GC::model_continuity(p);
  BOOST_CHECK_EQUAL(text(creased.summary), "8 G2, 0 G1, 4 G0 (4 creases), 12 boundary, 0 collapsed");
  BOOST_CHECK_EQUAL(creased.failing(1).size(), 4);
  const auto orders = GC::model_continuity(
      p, [](std::size_t) {}, GC::Crease_angles::omitted);
  BOOST_CHECK_EQUAL(text(orders.summary), text(creased.summary));
  BOOST_CHECK(find_edge(creased, 1, u1)->continuity.deviation && !find_edge(orders, 1, u1)->continuity.deviation);
  BOOST_CHECK_EQUAL(creased.failing(3).size(), 12);
  // in any orientation, from a list, with other degrees and domains
  Random random;
  std::list<Patch<K>> turned;
  for (const Patch<K>& s : p) {
    const auto all = placements<K>(s);
    Patch<K> t = all[random.integer(0, 7)].first;
    // of degree 4: dyadic weights
    if (random.integer(0, 1)) t = t.elevate(is_exact<typename K::FT> ? 1 : 2, 2);
    turned.push_back(t.with_domain({typename K::FT(2), typename K::FT(7)}, {typename K::FT(-1), typename K::FT(0)}));
  }
  const auto again = GC::model_continuity(turned);
  BOOST_CHECK_EQUAL(text(again.summary), text(creased.summary));
  // each edge of each patch is in exactly one row, and the rows are sorted
  std::set<std::pair<std::size_t, Patch_edge>> seen;
  for (std::size_t i = 0; i < again.edges.size(); ++i) {
    const auto& e = again.edges[i];
    BOOST_CHECK(seen.emplace(e.patch_a, e.edge_a).second);
    BOOST_CHECK_EQUAL(e.patch_b.has_value(), e.kind == GC::Model_edge_kind::shared);
    if (e.patch_b) BOOST_CHECK(seen.emplace(*e.patch_b, *e.edge_b).second && e.patch_a < *e.patch_b);
    if (i > 0)
      BOOST_CHECK(std::make_pair(again.edges[i - 1].patch_a, again.edges[i - 1].edge_a) <
                  std::make_pair(e.patch_a, e.edge_a));
  }
  BOOST_CHECK_EQUAL(seen.size(), 36);
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 0, u0)), "0 u0: boundary");
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 1, u0)), "1 u0: boundary");
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 0, u1)), "0 u1 - 3 u0: G2");
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 1, u1)).substr(0, 35), "1 u1 - 4 u0: G0 (crease), angle <= ");
  // a patch that meets another along a part of its edge only
  const std::vector<Patch<K>> halves = {p[0].split_v(typename K::FT(typename K::FT(1) / typename K::FT(2))).first,
                                        p[3]};
  BOOST_CHECK_EQUAL(text(GC::model_continuity(halves).summary), "0 G2, 0 G1, 0 G0, 8 boundary, 0 collapsed");
  const std::vector<Patch<K>> g1 =
      patches<K>({height_net(0, 0, flat), height_net(1, 0, [](int i, int) { return i == 4; })});
  BOOST_CHECK_EQUAL(text(GC::model_continuity(g1).summary), "0 G2, 1 G1, 0 G0, 6 boundary, 0 collapsed");
  const std::vector<Patch<K>> folded = patches<K>({height_net(0, 0, flat), height_net(0, 0, tilt)});
  BOOST_CHECK_EQUAL(GC::model_continuity(folded).summary.g0, 2);
  BOOST_CHECK_EQUAL(text(GC::model_continuity(std::vector<Patch<K>>()).summary),
                    "0 G2, 0 G1, 0 G0, 0 boundary, 0 collapsed");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(model_with_poles, K, All_kernels) {
  // a cap of four patches around a pole, with smooth meridians, over a ring of four patches
  std::vector<Net> nets;
  const int circle[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  const int radius[3] = {0, 2, 2}, height[3] = {4, 4, 2}, lower_radius[3] = {2, 2, 6}, lower_height[3] = {2, 0, 0};
  for (bool lower : {false, true})
    for (int k = 0; k < 4; ++k) {
      Net net(3, std::vector<Column>(3));
      for (int j = 0; j < 3; ++j) {
        const int r = lower ? lower_radius[j] : radius[j], z = lower ? lower_height[j] : height[j];
        const int *from = circle[k], *to = circle[k + 1];
        net[0][j] = {Q(r * from[0]), Q(r * from[1]), Q(z)};
        net[1][j] = {Q(r * (from[0] + to[0])), Q(r * (from[1] + to[1])), Q(z)};
        net[2][j] = {Q(r * to[0]), Q(r * to[1]), Q(z)};
      }
      nets.push_back(net);
    }
  const std::vector<Patch<K>> p = patches<K>(nets);
  const auto model = GC::model_continuity(p);
  BOOST_CHECK_EQUAL(text(model.summary), "4 G2, 4 G1, 4 G0 (4 vanishing normals), 4 boundary, 4 collapsed");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 0, u0)), "0 u0 - 3 u1: G0 (vanishing_normal)");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 0, v0)), "0 v0: collapsed");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 6, v0)), "2 v1 - 6 v0: G1 (curvature)");
  const auto meridian = GC::edge_continuity(p[0], u0, p[3], u1);
  BOOST_CHECK(meridian.vanishing && meridian.vanishing->first == 0 && meridian.vanishing->second == 0);

  // one patch that closes up along a meridian
  const int ring[5][2] = {{1, 0}, {1, 4}, {-4, 0}, {1, -4}, {1, 0}};
  const Net tube = net_of(5, 2, [&](int i, int j) { return Column{Q(ring[i][0]), Q(ring[i][1]), Q(j)}; });
  const auto closed = GC::model_continuity(patches<K>({tube}));
  BOOST_CHECK_EQUAL(text(*find_edge(closed, 0, u0)), "0 u0 - 0 u1: G2");
  BOOST_CHECK_EQUAL(text(closed.summary), "1 G2, 0 G1, 0 G0, 2 boundary, 0 collapsed");
  const std::vector<Patch<K>> twice = patches<K>({tube, tube});
  BOOST_CHECK_EQUAL(GC::common_edges(twice[0], twice[0]).size(), 1); // u0 and u1
  // these with each other, v0 with v0, v1 with v1
  BOOST_CHECK_EQUAL(GC::common_edges(twice[0], twice[1]).size(), 6);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(non_manifold_model, K, All_kernels) {
  const auto flat = [](int, int) { return 0; };
  // upright on the edge x = 1 of the first two
  const Net wall = net_of(3, 2, [](int i, int j) { return Column{Q(1), Q(Q(2 - i) / Q(2)), Q(j)}; });
  const std::vector<Patch<K>> p = patches<K>({height_net(0, 0, flat), height_net(1, 0, flat), wall});
  const auto model = GC::model_continuity(p);
  BOOST_CHECK_EQUAL(text(model.summary), "1 G2, 0 G1, 1 G0 (1 creases), 9 boundary, 0 collapsed, 2 non-manifold");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 0, u1)), "0 u1 - 1 u0: G2, non-manifold");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 2, v0)).substr(0, 34), "1 u0 - 2 v0: G0 (crease), reversed");
  // the same patch twice
  BOOST_CHECK_EQUAL(text(GC::model_continuity(std::vector<Patch<K>>{p[0], p[0]}).summary),
                    "0 G2, 0 G1, 4 G0 (4 folds), 0 boundary, 0 collapsed");
}

BOOST_AUTO_TEST_CASE(model_on_an_archetype) {
  typedef archetype::Traits<CGAL::Dimension_tag<3>> Traits;
  typedef archetype::Number FT;
  const auto point = [](int x, int y, int z) {
    const FT c[] = {FT(x), FT(y), FT(z)};
    return Traits().construct_point_object()(3, c, c + 3);
  };
  typedef GC::Bezier_patch<Traits> Patch_a;
  const Patch_a a({{point(0, 0, 0), point(0, 2, 0)}, {point(2, 0, 0), point(2, 2, 0)}}),
      b({{point(0, 2, 0), point(0, 3, 0)}, {point(2, 2, 0), point(2, 3, 0)}}),
      c({{point(0, 2, 0), point(0, 3, 1)}, {point(2, 2, 0), point(2, 3, 2)}});
  const auto smooth = GC::edge_continuity(a, v1, b, v0), crease = GC::edge_continuity(a, v1, c, v0);
  BOOST_CHECK_EQUAL(smooth.g_order, 2);
  BOOST_CHECK_EQUAL(crease.g_order, 0);
  BOOST_REQUIRE(crease.deviation);
  BOOST_CHECK(crease.deviation->upper == FT(4) / FT(5)); // sin^2 of the angle with slope 2
  const auto model = GC::model_continuity(std::vector<Patch_a>{a, b, c});
  BOOST_CHECK_EQUAL(model.summary.non_manifold, 2);
  BOOST_CHECK_EQUAL(model.summary.boundary, 9);
  a.elevate(1, 2).split_u(FT(1) / FT(3)).first.swap_parameters().jet(FT(2), FT(1), 3);
  a.normal(FT(0), FT(1));
  a.bounding_box();
}
