// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rounded edges of surfaces of all types and mixes. That they are G2 along the new edges is decided
// by edge_continuity().

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/models/round_edges.h>

BOOST_AUTO_TEST_SUITE(rounded_edges)

typedef std::vector<std::vector<Exact::Point>> Net;

struct Numbers : Random_surfaces {
  // Bends upwards from the edge or, turned by a right angle, sideways: the edge v = 0 are the given
  // points.
  Net net_at(const std::vector<Exact::Point>& edge, int layers, bool turned) {
    Net net = Random_surfaces::net(static_cast<int>(edge.size()), layers);
    for (std::size_t i = 0; i < net.size(); ++i) {
      if (turned)
        for (Exact::Point& p : net[i]) p = Exact::Point(p.x(), p.z(), p.y());
      net[i][0] = edge[i];
    }
    return net;
  }
  std::vector<Exact::Point> points_of_edge(int n) {
    std::vector<Exact::Point> edge;
    for (int i = 0; i < n; ++i) edge.push_back({number() + Q(4 * i) * Q(4294967296.0), number(), number()});
    return edge;
  }
  std::vector<std::vector<Q>> weights_at(const std::vector<Q>& edge, int layers) {
    auto w = weights(static_cast<int>(edge.size()), layers);
    for (std::size_t i = 0; i < edge.size(); ++i) w[i][0] = edge[i];
    return w;
  }
  // A surface of the type with the curve of these points at v = 0.
  template <class Surface> Surface surface_at(const std::vector<Exact::Point>& edge, bool turned) {
    const std::vector<Q> ones(edge.size(), Q(1));
    if constexpr (std::is_same_v<Surface, Bezier<Exact>>)
      return Surface(net_at(edge, integer(2, 4), turned), domain(), domain());
    else if constexpr (std::is_same_v<Surface, Patch<Exact>>) {
      const int layers = integer(2, 4);
      return Surface(net_at(edge, layers, turned), weights_at(ones, layers), domain(), domain());
    } else {
      // knots that the curve does not need
      const std::pair<Q, Q> u = domain();
      const Bezier<Exact> patch(net_at(edge, 4, turned), u, domain());
      const Bspline<Exact> s = Bspline<Exact>(patch).insert_u(Q(u.first + (u.second - u.first) * fraction(1, 3)));
      std::vector<Exact::Point> points;
      for (int i = 0; i < s.number_of_points_u(); ++i) points.push_back(s.control_point(i, 0));
      const Knots v = knots();
      const int layers = v.number_of_coefficients();
      if constexpr (std::is_same_v<Surface, Bspline<Exact>>)
        return Surface(net_at(points, layers, turned), s.knots_u(), v);
      else
        return Surface(net_at(points, layers, turned), weights_at(std::vector<Q>(points.size(), Q(1)), layers),
                       s.knots_u(), v);
    }
  }
};

// Turned so that the edge v0 is at another one, forwards or backwards.
template <class Surface> Surface turned(Surface s, Patch_edge edge, Edge_direction direction) {
  if (direction == Edge_direction::opposite) s = s.reverse_u();
  if (at_upper_end(edge)) s = s.reverse_v();
  return runs_along_u(edge) ? s : s.swap_parameters();
}
template <class Surface> Q width(const Surface& s, Patch_edge edge, const Q& part) {
  const std::pair<Q, Q> d = runs_along_u(edge) ? s.domain_v() : s.domain_u();
  return part * (d.second - d.first);
}

template <class A, class B, class... Strategy>
void check_rounded(const A& a, Patch_edge ea, const B& b, Patch_edge eb, Edge_direction direction, const Q& part_a,
                   const Q& part_b, const Strategy&... strategy) {
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, b, eb), 0);
  const Q wa = width(a, ea, part_a), wb = width(b, eb, part_b);
  const GC::Rounded_edge<A, B> r = round_edge(a, ea, b, eb, wa, wb, strategy...);
  BOOST_CHECK(r.first == cut_back(a, ea, wa));
  BOOST_CHECK(r.second == cut_back(b, eb, wb));
  BOOST_CHECK(r.direction == direction);
  BOOST_CHECK_EQUAL(whole_edge_order(r.first, ea, r.blend, v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(r.blend, v1, r.second, eb), 2);
  BOOST_CHECK(!r.fold);
  BOOST_CHECK_EQUAL(whole_edge_order(r.first, ea, moved(r.blend, 1, 2), v0), 1);
  BOOST_CHECK_EQUAL(whole_edge_order(moved(r.blend, 1, 3), v1, r.second, eb), 1);
  BOOST_CHECK_EQUAL(whole_edge_order(moved(r.blend, 1, 4), v1, r.second, eb), 0);
}

template <class A, class B> void check_random_edges(Numbers& random) {
  const std::vector<Exact::Point> edge = random.points_of_edge(random.integer(2, 4));
  const Patch_edge ea = random.edge(), eb = random.edge();
  const Edge_direction da = random.direction(), db = random.direction();
  const A a = turned(random.surface_at<A>(edge, false), ea, da);
  const B b = turned(random.surface_at<B>(edge, true), eb, db);
  check_rounded(a, ea, b, eb, da == db ? Edge_direction::same : Edge_direction::opposite,
                fraction(random.integer(1, 4), 10), fraction(random.integer(1, 4), 10));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_types, A, Surface_types) {
  Numbers random;
  for_each_surface_type([&](auto b) { check_random_edges<A, typename decltype(b)::type>(random); });
}

// Edges with different weights, which are those of the other one times 3; by other strategies.
BOOST_AUTO_TEST_CASE(weights_along_the_edge) {
  Numbers random;
  const std::vector<Exact::Point> edge = random.points_of_edge(3);
  const Patch<Exact> a(random.net_at(edge, 3, false), random.weights_at({Q(2), Q(1), Q(3)}, 3)),
      b(random.net_at(edge, 4, true), random.weights_at({Q(6), Q(3), Q(9)}, 4));
  check_rounded(a, v0, b, v0, Edge_direction::same, fraction(1, 4), fraction(1, 3));
  check_rounded(a, v0, b, v0, Edge_direction::same, fraction(1, 4), fraction(1, 3), GC::Fair());
  check_rounded(a, v0, b, v0, Edge_direction::same, fraction(1, 4), fraction(1, 3), GC::Matching_second_derivative());
}

// Two squares at a right angle: all numbers near the planes are exact with every kernel.
TEST_FOR_EACH(kernels, Traits, All_traits) {
  typedef typename Traits::Point P;
  const Bezier<Traits> floor({{P(0, 0, 0), P(0, 8, 0)}, {P(8, 0, 0), P(8, 8, 0)}}),
      wall({{P(0, 0, 0), P(8, 0, 0)}, {P(0, 0, 8), P(8, 0, 8)}});
  const FT quarter = FT(1) / FT(4);
  const auto r = round_edge(floor, v0, wall, u0, quarter, quarter);
  BOOST_CHECK(r.first == cut_back(floor, v0, quarter));
  BOOST_CHECK(r.second == cut_back(wall, u0, quarter));
  BOOST_CHECK_EQUAL(whole_edge_order(r.first, v0, r.blend, v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(r.blend, v1, r.second, u0), 2);
  BOOST_CHECK(r.blend.control_point(1, 0) == P(8, 2, 0));
  BOOST_CHECK(r.blend.control_point(1, 5) == P(8, 0, 2));
  BOOST_CHECK(!r.fold);
  BOOST_CHECK(r.direction == Edge_direction::same);
  // widths of a length
  BOOST_CHECK(set_back_parameter(floor, v0, 2) == quarter);
  const double near = CGAL::to_double(set_back_parameter(floor, v1, 3.3)) * 8;
  BOOST_CHECK(3.3 <= near && near <= 3.3 * 1.01);
  const auto on_3_to_7 = floor.with_domain({FT(0), FT(1)}, {FT(3), FT(7)});
  BOOST_CHECK(set_back_parameter(on_3_to_7, v1, 2) == FT(1));
  BOOST_CHECK(set_back_parameter(Bspline<Traits>(on_3_to_7), v0, 2) == FT(1));
  BOOST_CHECK(set_back_parameter(Patch<Traits>(floor), u1, 1) == FT(1) / FT(8));
  // exactly where the surface is linear across: 8 long, and 5 along (3, 4)
  const auto is_of = [](const auto& x, int n, int d) {
    return !CGAL::Algebraic_structure_traits<FT>::Is_exact::value || x == FT(n) / FT(d);
  };
  BOOST_CHECK(is_of(set_back_parameter(floor, v0, 3), 3, 8));
  BOOST_CHECK(is_of(set_back_parameter(Bspline<Traits>(floor), v1, 3), 3, 8));
  const Bezier<Traits> slanted({{P(0, 0, 0), P(3, 4, 0)}, {P(0, 0, 1), P(3, 4, 1)}});
  BOOST_CHECK(is_of(set_back_parameter(slanted, v0, 1), 1, 5) && is_of(set_back_parameter(slanted, v1, 2), 2, 5));
  for (double bad : {0., -1., 8.1, std::numeric_limits<double>::quiet_NaN()})
    CHECK_ERROR(set_back_parameter(floor, v0, bad), parameter_outside_domain);
}

TEST_FOR_EACH(errors, Traits, All_traits) {
  typedef typename Traits::Point P;
  const auto wall = [](const P& p, const P& q) {
    return Bezier<Traits>({{p, P(p.x(), p.y(), 8)}, {q, P(q.x(), q.y(), 8)}});
  };
  const Bezier<Traits> floor({{P(0, 0, 0), P(0, 8, 0)}, {P(8, 0, 0), P(8, 8, 0)}});
  const P a(0, 0, 0), b(8, 0, 0);
  const FT quarter = FT(1) / FT(4);
  const auto text = [&](const auto& s, Patch_edge edge, const FT& width = FT(1) / FT(4)) {
    return error_of([&] { round_edge(floor, v0, s, edge, FT(1) / FT(4), width); });
  };
  BOOST_CHECK_EQUAL(text(wall(a, b), v0), "no error");
  BOOST_CHECK_EQUAL(
      text(wall(a, P(9, 1, 0)), v0),
      "curves_do_not_meet: round_edge: the edge v0 of the first surface and the edge v0 of the second one are "
      "different curves");
  CHECK_ERROR(round_edge(floor, v0, wall(a, b), v1, quarter, quarter), curves_do_not_meet);
  BOOST_CHECK_EQUAL(
      text(wall(P(4, 0, 0), b), v0),
      "curves_do_not_meet: round_edge: the edge v0 of the first surface and the edge v0 of the second one have "
      "only a part in common, from 0.500000 to 1.000000 of the first one");
  // one point
  const Bezier<Traits> pole_of_floor({{P(0, 0, 0), P(0, 8, 0)}, {P(0, 0, 0), P(8, 8, 0)}}),
      pole_of_wall({{P(0, 0, 0), P(0, 0, 8)}, {P(0, 0, 0), P(8, 0, 8)}});
  BOOST_CHECK_EQUAL(
      error_of([&] { round_edge(pole_of_floor, v0, pole_of_wall, v0, quarter, quarter); }),
      "zero_tangent: round_edge: the edge v0 of the first surface and the edge v0 of the second one are a "
      "single point");
  CHECK_ERROR(round_edge(wall(P(4, 0, 0), b), v0, floor, v0, quarter, quarter), curves_do_not_meet);
  // smooth, but for the curvature, and smooth
  const Bezier<Traits> plane({{P(0, 0, 0), P(0, -8, 0)}, {P(8, 0, 0), P(8, -8, 0)}});
  BOOST_CHECK_EQUAL(text(plane, v0),
                    "already_smooth: round_edge: the edge v0 of the first surface and the edge v0 of the "
                    "second one are G2 along each other");
  const Bezier<Traits> bent({{P(0, 0, 0), P(0, -4, 0), P(0, -8, 8)}, {P(8, 0, 0), P(8, -4, 0), P(8, -8, 8)}});
  BOOST_CHECK_EQUAL(whole_edge_order(floor, v0, bent, v0), 1);
  BOOST_CHECK_EQUAL(text(bent, v0), "no error");
  // widths
  for (const FT& width : {FT(0), FT(-quarter), FT(1), FT(2)}) {
    CHECK_ERROR(round_edge(floor, v0, wall(a, b), v0, width, quarter), parameter_outside_domain);
    CHECK_ERROR(round_edge(floor, v0, wall(a, b), v0, quarter, width), parameter_outside_domain);
  }
  // a normal that vanishes at the new edge: a pole, or one point
  const std::string place =
      "singular_frame: round_edge: at the new edge v0 of the second surface: the normal vanishes ";
  const Bezier<Traits> pole({{P(0, 0, 0), P(0, 0, 8)}, {P(8, 0, 0), P(-8, 0, 8)}});
  BOOST_CHECK_EQUAL(text(pole, v0, FT(1) / FT(2)), place + "everywhere");
  const Bezier<Traits> point({{P(0, 0, 0), P(0, 0, 4), P(0, 0, 8)}, {P(8, 0, 0), P(8, 0, 8), P(8, 0, 0)}});
  BOOST_CHECK_EQUAL(text(point, v0, FT(1) / FT(2)), place + "near the parameter 1.000000");
  BOOST_CHECK_EQUAL(text(point, v0, quarter), "no error");
  // a blend that bulges out so far that it turns back
  const auto folded = round_edge(floor, v0, wall(a, b), v0, quarter, quarter, GC::Given_parameters<double>{20, 20});
  BOOST_CHECK(folded.fold);
  BOOST_CHECK_EQUAL(whole_edge_order(folded.first, v0, folded.blend, v0), 2);
}

BOOST_AUTO_TEST_SUITE_END()
