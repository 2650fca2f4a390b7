// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// How the edges of a model are recognised: groups of those that are the same.

#include "support/spline_surfaces.h"

#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

template <class Engine> S random_surface(Engine& random, const Knots& u, const Knots& v) {
  const auto point = [&](int, int) { return Exact::Point_3{int(random() % 7), int(random() % 7), int(random() % 7)}; };
  return S(net_of(u.number_of_coefficients(), v.number_of_coefficients(), point), u, v);
}

// Every pair of edges: in one group if and only if they are the same, in the direction that is
// found.
template <class Model> void check_groups(const Model& model) {
  typedef typename Model::value_type Surface;
  std::vector<const Surface*> pointers;
  for (const Surface& s : model) pointers.push_back(&s);
  const GC::internal::Edge_groups<Surface> groups(pointers);
  typedef std::pair<std::size_t, Patch_edge> Edge;
  // with the number of the group, and backwards
  std::vector<std::pair<Edge, std::pair<std::size_t, bool>>> uses;
  std::size_t number = 0;
  for (const auto& group : groups.edges()) {
    for (const auto& use : group) uses.push_back({{use.patch, use.edge}, {number, use.backwards}});
    BOOST_CHECK(!group[0].backwards);
    ++number;
  }
  BOOST_CHECK_EQUAL(uses.size() + groups.collapsed().size(), 4 * model.size());
  for (const auto& x : uses)
    for (const auto& y : uses) {
      const Surface &a = model[x.first.first], &b = model[y.first.first];
      const bool same = GC::is_g0_edge(a, x.first.second, b, y.first.second);
      BOOST_CHECK_EQUAL(same, x.second.first == y.second.first);
      if (same && x.second.first == y.second.first)
        BOOST_CHECK_EQUAL(GC::edge_continuity(a, x.first.second, b, y.first.second).reversed,
                          x.second.second != y.second.second);
    }
}

BOOST_AUTO_TEST_CASE(groups_of_edges) {
  std::mt19937_64 random = seeded();
  for (int i = 0; i < 3; ++i) {
    const S s = random_surface(random, knots(0, 4, {1, 2}), knots(0, 4));
    const Patch<Exact> p = random_surface(random, knots(0, 4), knots(0, 4)).bezier_patches()[0];
    // one form: control points decide
    check_groups(std::vector<S>{s, s.reverse_u(), s.swap_parameters(), lifted(s, 2, 0), lifted(s, 2, 0).reverse_v(),
                                with_knots(s, 3, 1)});
    check_groups(std::vector<Patch<Exact>>{p, p.reverse_u(), p.reverse_v(), p.swap_parameters()});
    // several forms
    check_groups(std::vector<S>{s, s.insert_u(3).reverse_u(), s.elevate(1, 1), lifted(s, 3, 0)});
    check_groups(std::vector<Patch<Exact>>{p, p.elevate(1, 0), p.reverse_u().elevate(0, 1)});
  }
}

// Knots that are not clamped: the first control point of an edge is not its start.
BOOST_AUTO_TEST_CASE(groups_of_edges_that_are_not_clamped) {
  std::mt19937_64 random = seeded();
  const S s = random_surface(random, Knots(3, {-3, -2, -1, 0, 1, 2, 4, 5, 6, 7}), knots(0, 4, {1}));
  check_groups(std::vector<S>{s, s.clamp().reverse_u(), s.swap_parameters(), lifted(s, 1, 0)});
  check_groups(std::vector<S>{s.swap_parameters(), s.clamp()});
}

// A closed edge over knots without symmetry, and the same curve over the mirrored knots: both begin
// at the same point.
BOOST_AUTO_TEST_CASE(closed_edges) {
  std::mt19937_64 random = seeded();
  for (int i = 0; i < 8; ++i) {
    const S s{Patch<Exact>(net_of(4, 2, [&](int k, int j) {
      return k % 3 == 0 ? Exact::Point_3(j, 0, 0) : Exact::Point_3{int(random() % 7), int(random() % 7), j};
    }))};
    const S early = s.insert_u(Q(1) / 4), late = s.insert_u(Q(3) / 4);
    check_groups(std::vector<S>{early, late, early.reverse_u()});
  }
}

// Edges that are the same backwards but for their knots.
BOOST_AUTO_TEST_CASE(points_that_are_the_same_backwards) {
  const int x[] = {0, 1, 3, 1, 0};
  const auto spline_with_knot = [&](const Q& t) {
    const auto net = net_of(5, 2, [&](int i, int j) { return Exact::Point_3(x[i], x[i] * x[i] + j, j); });
    return S(net, Knots(3, Q(0), Q(1), {{t, 1}}), Knots(1, {0, 0, 1, 1}));
  };
  const S early = spline_with_knot(Q(1) / 4), late = spline_with_knot(Q(3) / 4);
  check_groups(std::vector<S>{early, late});
  check_groups(std::vector<S>{late, early, late.reverse_u()});
}

// Edges with the same ends, other points, other weights, and points at infinity: out to a
// direction, and back.
BOOST_AUTO_TEST_CASE(edges_with_weights) {
  typedef GC::Rational_bezier_patch<GC::Traits_3<Exact>> Rational;
  typedef Exact::Point_3 P;
  std::vector<Rational> model;
  for (const P& middle : {P(1, 1, 0), P(1, 2, 0)})
    for (const int weight : {1, 2, 3}) {
      model.push_back(Rational({{P(0, 0, 0), P(0, 0, 1)}, {middle, P(1, 1, 1)}, {P(2, 0, 0), P(2, 0, 1)}},
                               {{1, 1}, {weight, 1}, {1, 1}}));
      model.push_back(model.back().reverse_u());
    }
  check_groups(model);
  const auto closed = [](const P& direction, int weight) {
    return Rational({{P(0, 0, 0), P(0, 0, 1)}, {direction, P(1, 0, 1)}, {P(0, 0, 0), P(0, 0, 2)}},
                    {{1, 1}, {weight, 1}, {1, 1}});
  };
  for (const std::vector<Rational>& lids :
       {std::vector<Rational>{closed(P(1, 0, 0), 0), closed(P(1, 0, 0), 1)},
        std::vector<Rational>{closed(P(1, 0, 0), 0), closed(P(0, 1, 0), 0), closed(P(1, 0, 0), 0).reverse_u()},
        std::vector<Rational>{closed(P(0, 0, 0), 2), closed(P(0, 0, 0), 1)}})
    check_groups(lids);
}

BOOST_AUTO_TEST_CASE(collapsed_edges) {
  const Exact::Point_3 pole(0, 0, 5);
  const Patch<Exact> lid({{pole, Exact::Point_3(0, 0, 0)}, {pole, Exact::Point_3(1, 0, 0)}});
  const S s(lid);
  check_groups(std::vector<Patch<Exact>>{lid, lid.elevate(1, 0), lid.reverse_u()});
  check_groups(std::vector<S>{s, s.insert_u(Q(1) / 2), s.elevate(1, 0)});
  const std::vector<const S*> pointers{&s};
  BOOST_CHECK_EQUAL(GC::internal::Edge_groups<S>(pointers).collapsed().size(), 1);
  // over knots that are not clamped
  const S open({{pole, Exact::Point_3(0, 0, 0)}, {pole, Exact::Point_3(1, 0, 0)}}, Knots(1, {0, 0, 1, 1}),
               Knots(1, {-1, 0, 1, 2}));
  check_groups(std::vector<S>{open, open.reverse_u()});
  const std::vector<const S*> one{&open};
  BOOST_CHECK_EQUAL(GC::internal::Edge_groups<S>(one).collapsed().size(), 1);
}

// A model and the function for two surfaces give the same verdict on a shared edge.
BOOST_AUTO_TEST_CASE(a_model_and_its_pairs) {
  std::mt19937_64 random = seeded();
  const S s = random_surface(random, knots(0, 4, {1, 2, 3}), knots(0, 4, {1, 2}));
  const S low = part(s, 0, 2), high = part(s, 2, 4);
  for (const std::vector<S>& model :
       {std::vector<S>{low, high}, std::vector<S>{low, high.reverse_u()}, std::vector<S>{high.insert_v(3), low},
        std::vector<S>{lifted(high, 1, 2), low}, std::vector<S>{low, low, high.swap_parameters()}}) {
    int shared = 0;
    for (const auto& e : GC::model_continuity(model).edges) {
      if (e.kind != GC::Model_edge_kind::shared) continue;
      ++shared;
      const auto pair = GC::edge_continuity(model[e.patch_a], e.edge_a, model[*e.patch_b], *e.edge_b);
      const auto all_of = [](const auto& x) {
        return text(x, ' ', x.side, ' ', x.part_a.first, ' ', x.part_a.second, ' ', x.part_b.first, ' ',
                    x.part_b.second, ' ', x.whole_a, x.whole_b, ' ', x.spans.size());
      };
      BOOST_CHECK_EQUAL(all_of(e.continuity), all_of(pair));
    }
    BOOST_CHECK_GE(shared, 1);
  }
}
