// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// How the edges of a model are recognised: groups of those that are the same.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE edge_groups
#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/edges/edge_predicates.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Space;
typedef Space::Point Point;
typedef GC::Bspline_surface<Space> Surface;
typedef GC::Bezier_patch<Space> Patch;
typedef GC::Knot_vector<Q> Knots;
using GC::Patch_edge;

namespace {

std::mt19937_64 seeded() {
  constexpr unsigned seed = 20260721;
  BOOST_TEST_MESSAGE("seed " << seed);
  return std::mt19937_64(seed);
}

Knots cubic(const std::vector<Q>& inner) {
  std::vector<Q> u(4, Q(0));
  u.insert(u.end(), inner.begin(), inner.end());
  u.insert(u.end(), 4, Q(4));
  return Knots(3, u);
}

template <class Engine> Surface random_surface(Engine& random, const Knots& u, const Knots& v) {
  std::vector<std::vector<Point>> net(u.number_of_coefficients());
  for (auto& row : net)
    for (int j = 0; j < v.number_of_coefficients(); ++j)
      row.emplace_back(int(random() % 7), int(random() % 7), int(random() % 7));
  return Surface(net, u, v);
}

Surface over(const Surface& s, const Q& scale, const Q& shift) {
  std::vector<Q> u;
  for (const Q& t : s.knots_u()) u.push_back(Q(scale * t + shift));
  std::vector<std::vector<Point>> net(s.number_of_points_u());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) net[i].push_back(s.control_point(i, j));
  return Surface(net, Knots(s.degree_u(), u), s.knots_v());
}

Surface lifted(const Surface& s, int k, int l) {
  std::vector<std::vector<Point>> net(s.number_of_points_u());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      const Point& p = s.control_point(i, j);
      net[i].push_back(i == k && j == l ? Point(p.x(), p.y(), p.z() + 1) : p);
    }
  return Surface(net, s.knots_u(), s.knots_v());
}

// Every pair of edges: in one group if and only if they are the same, in the direction that is found.
template <class S> void check_groups(const std::vector<S>& model) {
  std::vector<const S*> pointers;
  for (const S& s : model) pointers.push_back(&s);
  const GC::internal::Edge_groups<S> groups(pointers);
  typedef std::pair<std::size_t, Patch_edge> Edge;
  std::vector<std::pair<Edge, std::pair<std::size_t, bool>>> uses; // with the number of the group, and backwards
  std::size_t number = 0;
  for (const auto& group : groups.edges()) {
    for (const auto& use : group) uses.push_back({{use.patch, use.edge}, {number, use.backwards}});
    BOOST_CHECK(!group[0].backwards);
    ++number;
  }
  BOOST_CHECK_EQUAL(uses.size() + groups.collapsed().size(), 4 * model.size());
  for (const auto& x : uses)
    for (const auto& y : uses) {
      const S &a = model[x.first.first], &b = model[y.first.first];
      const bool same = GC::is_g0_edge(a, x.first.second, b, y.first.second);
      BOOST_CHECK_EQUAL(same, x.second.first == y.second.first);
      if (same && x.second.first == y.second.first)
        BOOST_CHECK_EQUAL(GC::edge_continuity(a, x.first.second, b, y.first.second).reversed,
                          x.second.second != y.second.second);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(groups_of_edges) {
  std::mt19937_64 random = seeded();
  for (int i = 0; i < 3; ++i) {
    const Surface s = random_surface(random, cubic({1, 2}), cubic({}));
    const Patch p = random_surface(random, cubic({}), cubic({})).bezier_patches()[0];
    // one form: control points decide
    check_groups(std::vector<Surface>{s, s.reverse_u(), s.swap_parameters(), lifted(s, 2, 0),
                                      lifted(s, 2, 0).reverse_v(), over(s, 3, 1)});
    check_groups(std::vector<Patch>{p, p.reverse_u(), p.reverse_v(), p.swap_parameters()});
    // several forms
    check_groups(std::vector<Surface>{s, s.insert_u(3).reverse_u(), s.elevate(1, 1), lifted(s, 3, 0)});
    check_groups(std::vector<Patch>{p, p.elevate(1, 0), p.reverse_u().elevate(0, 1)});
  }
}

// Knots that are not clamped: the first control point of an edge is not its start.
BOOST_AUTO_TEST_CASE(groups_of_edges_that_are_not_clamped) {
  std::mt19937_64 random = seeded();
  const Surface s = random_surface(random, Knots(3, {-3, -2, -1, 0, 1, 2, 4, 5, 6, 7}), cubic({1}));
  check_groups(std::vector<Surface>{s, s.clamp().reverse_u(), s.swap_parameters(), lifted(s, 1, 0)});
}

// A closed edge over knots without symmetry, and the same curve over the mirrored knots: both begin at the same point.
BOOST_AUTO_TEST_CASE(closed_edges) {
  std::mt19937_64 random = seeded();
  for (int i = 0; i < 8; ++i) {
    std::vector<std::vector<Point>> net(4);
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 2; ++j)
        net[k].push_back(k % 3 == 0 ? Point(j, 0, 0) : Point(int(random() % 7), int(random() % 7), j));
    const Surface s{Patch(net)};
    const Surface early = s.insert_u(Q(1) / 4), late = s.insert_u(Q(3) / 4);
    check_groups(std::vector<Surface>{early, late, early.reverse_u()});
  }
}

BOOST_AUTO_TEST_CASE(collapsed_edges) {
  const Point pole(0, 0, 5);
  const Patch lid({{pole, Point(0, 0, 0)}, {pole, Point(1, 0, 0)}});
  const Surface s(lid);
  check_groups(std::vector<Patch>{lid, lid.elevate(1, 0), lid.reverse_u()});
  check_groups(std::vector<Surface>{s, s.insert_u(Q(1) / 2), s.elevate(1, 0)});
  std::vector<const Surface*> pointers{&s};
  BOOST_CHECK_EQUAL(GC::internal::Edge_groups<Surface>(pointers).collapsed().size(), 1);
}

// What a model says of a shared edge is what the verb for two surfaces says.
BOOST_AUTO_TEST_CASE(a_model_and_its_pairs) {
  std::mt19937_64 random = seeded();
  const Surface s = random_surface(random, cubic({1, 2}), cubic({1, 2, 3}));
  const Surface whole = s.insert_v(2, 2);
  const auto part = [&](int first, int last, const std::vector<Q>& knots) {
    std::vector<std::vector<Point>> net(whole.number_of_points_u());
    for (int i = 0; i < whole.number_of_points_u(); ++i)
      for (int j = first; j <= last; ++j) net[i].push_back(whole.control_point(i, j));
    return Surface(net, whole.knots_u(), Knots(3, knots));
  };
  const Surface low = part(0, 4, {0, 0, 0, 0, 1, 2, 2, 2, 2}), high = part(4, 8, {2, 2, 2, 2, 3, 4, 4, 4, 4});
  for (const std::vector<Surface>& model :
       {std::vector<Surface>{low, high}, std::vector<Surface>{low, high.reverse_u()},
        std::vector<Surface>{high.insert_u(3), low}, std::vector<Surface>{lifted(high, 2, 1), low},
        std::vector<Surface>{low, low, high.swap_parameters()}}) {
    int shared = 0;
    for (const auto& e : GC::model_continuity(model).edges) {
      if (e.kind != GC::Model_edge_kind::shared) continue;
      ++shared;
      const auto pair = GC::edge_continuity(model[e.patch_a], e.edge_a, model[*e.patch_b], *e.edge_b);
      const auto text = [](const auto& x) {
        std::ostringstream os;
        os << x << ' ' << x.side << ' ' << x.part_a.first << ' ' << x.part_a.second << ' ' << x.part_b.first << ' '
           << x.part_b.second << ' ' << x.whole_a << x.whole_b << ' ' << x.spans.size();
        return os.str();
      };
      BOOST_CHECK_EQUAL(text(e.continuity), text(pair));
    }
    BOOST_CHECK_GE(shared, 1);
  }
}
