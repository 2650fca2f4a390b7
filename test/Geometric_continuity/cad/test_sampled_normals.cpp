// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Verdicts along edges of rational patches against exact normals at many parameters: the surfaces
// are G1 exactly where all normals of both sides have the same direction.

#define BOOST_TEST_MODULE sampled_normals

#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

// Homogeneous points (w x, w), a row of them for each layer from the edge v = 0 into the patch.
typedef std::array<Q, 4> Row_point;
typedef std::vector<Row_point> Row;

Patch<Exact> patch_of(const std::vector<Row>& rows) {
  std::vector<std::vector<Exact::Point>> net(rows[0].size());
  std::vector<std::vector<Q>> weights(net.size());
  for (std::size_t i = 0; i < net.size(); ++i)
    for (const Row& row : rows) {
      const Row_point& h = row[i];
      net[i].emplace_back(Q(h[0] / h[3]), Q(h[1] / h[3]), Q(h[2] / h[3]));
      weights[i].push_back(h[3]);
    }
  return Patch<Exact>(net, weights);
}

Row random_row(Random& random, int p, int y) {
  Row row;
  for (int i = 0; i <= p; ++i) {
    const Q w = fraction(random.integer(20, 30), 10);
    const Q x = Q(i) + fraction(random.integer(-3, 3), 10), z = fraction(random.integer(-9, 9), 10);
    row.push_back({Q(w * x), Q(w * y), Q(w * z), w});
  }
  return row;
}

// The row with which a patch continues the plane of the homogeneous rows `edge`, `layer` and the
// derivative of `edge`: tangent planes agree, (edge + next difference) = edge - lambda (layer -
// edge) + mu edge' + nu edge.
Row tangent_row(const Row& edge, const Row& layer, const Q& lambda, const Q& mu, const Q& nu) {
  const int p = static_cast<int>(edge.size()) - 1;
  Row row = edge;
  for (int i = 0; i <= p; ++i)
    for (int x = 0; x < 4; ++x) {
      Q derivative(0); // of degree p-1, elevated to p
      if (i > 0) derivative += Q(i) * (edge[i][x] - edge[i - 1][x]);
      if (i < p) derivative += Q(p - i) * (edge[i + 1][x] - edge[i][x]);
      row[i][x] += Q(Q(nu * edge[i][x]) + Q(mu * derivative) - Q(lambda * Q(layer[i][x] - edge[i][x])));
    }
  return row;
}

bool same_direction(const Exact::Vector& a, const Exact::Vector& b) {
  return CGAL::cross_product(a, b) == CGAL::NULL_VECTOR && a * b > Q(0);
}

// In homogeneous coordinates the condition is the vanishing of det(edge, edge', one layer, other
// layer), which has a degree of at most 4p - 2 <= 10: it holds at 20 parameters only if it holds at
// all.
template <class A, class B> bool normals_agree(const A& a, const B& b) {
  for (int l = 0; l < 20; ++l) {
    const Q u = fraction(2 * l + 1, 40);
    if (!same_direction(a.normal(u, Q(0)), -b.normal(u, Q(0)))) return false;
  }
  return true;
}

BOOST_AUTO_TEST_CASE(tangent_and_altered_patches) {
  Random random;
  int smooth = 0, not_smooth = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    const int p = random.integer(2, 3);
    const Row edge = random_row(random, p, 0), layer = random_row(random, p, 1);
    const int k[] = {random.integer(5, 10), random.integer(-2, 2), random.integer(-2, 2)};
    Row other = tangent_row(edge, layer, fraction(k[0], 10), fraction(k[1], 20), fraction(k[2], 10));
    // the last row matters for G2 only
    const Row end = random_row(random, p, 2), other_end = random_row(random, p, -2);
    switch (repeat % 3) { // one number altered, by much or by little
    case 1: other[random.integer(0, p)][random.integer(0, 3)] += fraction(1, 3); break;
    case 2: other[random.integer(0, p)][random.integer(0, 3)] += fraction(1, 1000000) / Q(1000000000); break;
    default: break;
    }
    const Patch<Exact> a = patch_of({edge, layer, end}), b = patch_of({edge, other, other_end});
    const bool agree = normals_agree(a, b);
    (agree ? smooth : not_smooth) += 1;
    BOOST_CHECK_EQUAL(GC::is_g1_edge(a, v0, b, v0), agree);
    BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, b, v0).g_order >= 1, agree);
    // another factor of the weights on one side, a higher degree, and splines with knots
    const Patch<Exact> c = with_factor(b, fraction(7, 3)).elevate(1, 0);
    BOOST_CHECK_EQUAL(GC::is_g1_edge(a, v0, c, v0), agree);
    const Spline<Exact> d = Spline<Exact>(b).insert_u(fraction(1, 2));
    BOOST_CHECK_EQUAL(normals_agree(a, d), agree);
    BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, d, v0).g_order >= 1, agree);
  }
  BOOST_CHECK_GE(smooth, 15);
  BOOST_CHECK_GE(not_smooth, 30);
  std::cout << smooth << " smooth edges, " << not_smooth << " others\n";
}
