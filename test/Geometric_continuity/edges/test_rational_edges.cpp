// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Continuity along edges of rational surfaces, of all types and mixes.

#include "support/limited.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/swept_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>

BOOST_AUTO_TEST_SUITE(rational_edges)

using GC::Edge_defect;

// The weights w_ij c^j: another rational parameter in v.
Patch<Exact> with_other_parameter(const Patch<Exact>& s, const Q& c) {
  auto weights = net_weights(s);
  for (std::vector<Q>& row : weights) {
    Q power(1);
    for (Q& w : row) {
      w *= power;
      power *= c;
    }
  }
  return Patch<Exact>(net_points(s), weights, s.domain_u(), s.domain_v());
}

// With one control point of the layer j next to v = 0 moved.
Patch<Exact> with_moved_layer(const Patch<Exact>& s, int layer, const Q& distance) {
  auto net = net_points(s);
  net[1][layer] = net[1][layer] + Exact::Vector(0, 0, distance);
  return Patch<Exact>(net, net_weights(s), s.domain_u(), s.domain_v());
}

// The answers of all three predicates must be those of the order.
template <class A, class B> int order(const A& a, Patch_edge ea, const B& b, Patch_edge eb) {
  const auto edge = edge_continuity(a, ea, b, eb);
  BOOST_CHECK_EQUAL(is_g0_edge(a, ea, b, eb), edge.g_order >= 0 && edge.whole_a && edge.whole_b);
  if (edge.g_order < 0 || (edge.whole_a && edge.whole_b)) {
    BOOST_CHECK_EQUAL(is_g1_edge(a, ea, b, eb), edge.g_order >= 1);
    BOOST_CHECK_EQUAL(is_g2_edge(a, ea, b, eb), edge.g_order >= 2);
  }
  return edge.g_order;
}

// A quarter of the cylinder of radius 1 about the y-axis, from (0, 0, 1) to (1, 0, 0), for y in [0,
// 1].
template <class Traits> Patch<Traits> quarter_cylinder(int factor = 1, int y = 1) {
  typedef typename Traits::Point P;
  typedef typename Traits::FT FT;
  const FT f(factor), g(2 * factor);
  return Patch<Traits>({{P(0, 0, 1), P(0, y, 1)}, {P(1, 0, 1), P(1, y, 1)}, {P(1, 0, 0), P(1, y, 0)}},
                       {{f, f}, {f, f}, {g, g}});
}

// An eighth of the unit sphere with the pole (0, 0, z) at v = 1; the signs tell which.
template <class Traits> Patch<Traits> octant(int x, int y, int z, int factor) {
  typedef typename Traits::Point P;
  typedef typename Traits::FT FT;
  const auto w = [&](int i) { return FT(factor * i); };
  return Patch<Traits>({{P(x, 0, 0), P(x, 0, z), P(0, 0, z)},
                        {P(x, y, 0), P(x, y, z), P(0, 0, z)},
                        {P(0, y, 0), P(0, y, z), P(0, 0, z)}},
                       {{w(1), w(1), w(2)}, {w(1), w(1), w(2)}, {w(2), w(2), w(4)}});
}

BOOST_AUTO_TEST_CASE(a_surface_cut_in_two) {
  Random random;
  for (int i = 0; i < 6; ++i) {
    const int p = random.integer(1, 3), q = random.integer(2, 3);
    const Patch<Exact> s = random_patch(random, p, q);
    const std::pair<Patch<Exact>, Patch<Exact>> parts = s.split_v(fraction(1, random.integer(4, 9)));
    const Patch<Exact>& a = parts.first;
    const Patch<Exact> b = with_factor(parts.second, random.positive());
    BOOST_CHECK_EQUAL(order(a, v1, b, v0), 2);
    BOOST_CHECK_EQUAL(order(a, v1, with_other_parameter(b, random.positive()), v0), 2);
    BOOST_CHECK_EQUAL(order(a.reverse_u(), v1, b, v0), 2);
    BOOST_CHECK_EQUAL(order(a.swap_parameters(), u1, b.reverse_v(), v1), 2);
    BOOST_CHECK_EQUAL(order(a.elevate(1, 0), v1, b.elevate(0, 1), v0), 2);
    BOOST_CHECK_EQUAL(order(a.with_domain({Q(5), Q(6)}, {Q(0), Q(1)}), v1, b, v0), 2);
    const Q little = Q(1) / Q(random.integer(1000, 100000000)) / Q(100000000);
    BOOST_CHECK_EQUAL(order(a, v1, with_moved_layer(b, 2, little), v0), 1);
    BOOST_CHECK_EQUAL(order(a, v1, with_moved_layer(b, 1, little), v0), 0);
    BOOST_CHECK_EQUAL(order(a, v1, with_moved_layer(b, 0, little), v0), -1);
    // as splines with different knots
    const Spline<Exact> c = Spline<Exact>(a).insert_u(Q(0)), d = Spline<Exact>(b).insert_u(fraction(1, 2), 2);
    BOOST_CHECK_EQUAL(order(c, v1, d, v0), 2);
    BOOST_CHECK_EQUAL(order(c, v1, b, v0), 2);
    BOOST_CHECK_EQUAL(edge_continuity(c, v1, d, v0).spans.size(), 3u);
    BOOST_CHECK_EQUAL(order(c, v1, with_moved_layer(b, 2, little), v0), 1);
    // a part of the edge
    const auto part = edge_continuity(a, v1, b.split_u(fraction(3, 7)).first, v0);
    BOOST_CHECK_EQUAL(part.g_order, 2);
    BOOST_CHECK(!part.whole_a && part.whole_b && part.part_a.second == fraction(3, 7));
    const auto of_many =
        edge_continuity(b.split_u(fraction(3, 7)).first, v0, c.insert_u(fraction(1, 2)).insert_u(Q(1)), v1);
    BOOST_CHECK(of_many.g_order == 2 && of_many.whole_a && !of_many.whole_b);
    const auto turned = edge_continuity(a.split_u(fraction(1, 3)).second, v1, b.reverse_u(), v0);
    BOOST_CHECK(turned.g_order == 2 && turned.reversed && turned.whole_a && !turned.whole_b);
  }
}

// Edges that have the middle of their polynomials in common only, collapsed edges, and surfaces in
// one point.
BOOST_AUTO_TEST_CASE_TEMPLATE(edges_with_little_in_common, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef typename Traits::FT FT;
  // t^2 / (1 + t^2) along two axes
  const auto along = [](const P& end) {
    const P o(0, 0, 0), up(0, 0, 1);
    return Patch<Traits>({{o, up}, {o, up}, {P(end.x() / 2, end.y() / 2, end.z() / 2), up}},
                         {{FT(1), FT(1)}, {FT(1), FT(1)}, {FT(2), FT(1)}});
  };
  const Patch<Traits> x = along(P(1, 0, 0)), y = along(P(0, 1, 0));
  BOOST_CHECK_EQUAL(order(x, v0, y, v0), -1);
  BOOST_CHECK_EQUAL(order(Spline<Traits>(x), v0, y, v0), -1);
  BOOST_CHECK_EQUAL(order(x, v0, along(P(-1, 0, 0)), v0), -1);
  // a point, with any weights, and what is none
  const auto lid = [](const P& end, int weight) {
    return Patch<Traits>({{P(0, 0, 0), P(0, 1, 0)}, {end, P(1, 1, 0)}}, {{FT(1), FT(1)}, {FT(weight), FT(1)}});
  };
  const Patch<Traits> pole = lid(P(0, 0, 0), 1), other = lid(P(0, 0, 0), 2), open = lid(P(1, 0, 0), 2);
  for (const Patch<Traits>& s : {pole, other}) {
    BOOST_CHECK_EQUAL(order(s, v0, other, v0), 0);
    BOOST_CHECK_EQUAL(order(s, v0, open, v0), -1);
    BOOST_CHECK_EQUAL(order(open, v0, s, v0), -1);
    for (const GC::Common_edge& edge : common_edges(s, other)) BOOST_CHECK(edge.edge_a != v0 && edge.edge_b != v0);
    BOOST_CHECK_EQUAL(common_edges(s, other).size(), s == other ? 3u : 2u);
  }
  const Patch<Traits> origin({{P(0, 0, 0), P(0, 0, 0)}, {P(0, 0, 0), P(0, 0, 0)}}, {{FT(1), FT(2)}, {FT(3), FT(4)}});
  BOOST_CHECK_EQUAL(order(origin, v0, origin, v1), 0);
  // degrees that numbers of fixed length do not hold, across the second edge only
  const Patch<Traits> cylinder = quarter_cylinder<Traits>(), next = quarter_cylinder<Traits>(3, -1);
  BOOST_CHECK_EQUAL(is_g2_edge(cylinder, v0, next.elevate(0, 12), v0), is_g2_edge(cylinder, v0, next, v0));
}

// An edge about which nothing has been decided has no spans.
BOOST_AUTO_TEST_CASE(output_of_nothing) {
  BOOST_CHECK_EQUAL(text(GC::Spline_edge_continuity<Q>()), text(GC::Edge_continuity<Q>()));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cylinder_and_plane, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef typename Traits::Vector V;
  const Patch<Traits> cylinder = quarter_cylinder<Traits>();
  const GC::Bezier_patch<Traits> plane = GC::parallelogram<Traits>(P(0, 0, 1), V(-1, 0, 0), V(0, 1, 0));
  BOOST_CHECK_EQUAL(text(edge_continuity(plane, u0, cylinder, u0)), "G1 (curvature)");
  BOOST_CHECK_EQUAL(order(plane, u0, cylinder, u0), 1);
  BOOST_CHECK_EQUAL(order(cylinder, u0, plane, u0), 1);
  BOOST_CHECK_EQUAL(order(GC::Bspline_surface<Traits>(plane), u0, cylinder, u0), 1);
  BOOST_CHECK_EQUAL(order(plane, u0, Spline<Traits>(cylinder), u0), 1);
  BOOST_CHECK_EQUAL(order(Patch<Traits>(plane), u0, with_factor(cylinder, typename Traits::FT(5)), u0), 1);
  // the next piece of the cylinder, and the same backwards
  BOOST_CHECK_EQUAL(order(cylinder, v0, quarter_cylinder<Traits>(3, -1), v0), 2);
  BOOST_CHECK_EQUAL(order(cylinder, v0, quarter_cylinder<Traits>(3, -1).reverse_u(), v0), 2);
  // a patch and itself is a fold by 180 degrees; the lid a crease of 90 degrees
  const auto fold = edge_continuity(cylinder, v0, quarter_cylinder<Traits>(7), v0);
  BOOST_CHECK(fold.defect == Edge_defect::fold && fold.deviation->lower == 2);
  const Patch<Traits> lid({{P(0, 0, 1), P(0, 0, 0)}, {P(1, 0, 1), P(0, 0, 0)}, {P(1, 0, 0), P(0, 0, 0)}},
                          {{1, 1}, {1, 1}, {2, 2}});
  const auto crease = edge_continuity(cylinder, v0, lid, v0);
  BOOST_CHECK(crease.defect == Edge_defect::crease && crease.side == GC::Sign_pattern::zero);
  BOOST_CHECK(crease.deviation->lower == 1 && crease.deviation->upper == 1);
  // the cone with the slope 1: 45 degrees, sin^2 = 1/2
  const Patch<Traits> cone({{P(0, 0, 1), P(0, -1, 0)}, {P(1, 0, 1), P(0, -1, 0)}, {P(1, 0, 0), P(0, -1, 0)}},
                           {{1, 1}, {1, 1}, {2, 2}});
  const auto kink = edge_continuity(cylinder, v0, cone, v0);
  BOOST_CHECK(kink.defect == Edge_defect::crease && kink.deviation->lower * 2 == 1 && kink.deviation->upper * 2 == 1);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(polynomial_surfaces_as_rational_ones, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef typename Traits::FT FT;
  Random random;
  const auto net = [&](int sign, int tilt) {
    return net_of(4, 3, [&](int i, int j) {
      return P(4 * i, 4 * sign * j, j == 0 ? i * i % 3 : tilt * j + random.integer(-2, 2));
    });
  };
  for (int round = 0; round < 4; ++round) {
    const GC::Bezier_patch<Traits> a(net(1, round)), b(net(-1, -round));
    const auto expected = edge_continuity(a, v0, b, v0);
    // with another weight in the last row: otherwise they would be decided as polynomials
    const auto rational = [](const GC::Bezier_patch<Traits>& s, const FT& factor) {
      std::vector<std::vector<FT>> weights(4, std::vector<FT>(3, factor));
      weights[2][2] = FT(factor * FT(2));
      auto points = net_of(4, 3, [&](int i, int j) { return s.control_point(i, j); });
      points[2][2] = P(8, points[2][2].y(), points[2][2].z());
      return Patch<Traits>(points, weights);
    };
    const Patch<Traits> p = rational(a, FT(3)), q = rational(b, FT(FT(1) / FT(4)));
    BOOST_CHECK(!p.is_polynomial());
    const auto compare = [&](const auto& found) {
      BOOST_CHECK_EQUAL(found.g_order, expected.g_order);
      BOOST_CHECK(found.defect == expected.defect && found.side == expected.side &&
                  found.coplanar == expected.coplanar);
      BOOST_CHECK(found.deviation->lower <= expected.deviation->upper &&
                  expected.deviation->lower <= found.deviation->upper);
    };
    compare(edge_continuity(p, v0, q, v0));
    compare(edge_continuity(with_factor(Patch<Traits>(a), FT(5)), v0, q, v0));
    compare(edge_continuity(with_factor(Patch<Traits>(a), FT(5)), v0, Spline<Traits>(Patch<Traits>(b)), v0));
    compare(edge_continuity(a, v0, q, v0));
    compare(edge_continuity(Spline<Traits>(p), v0, GC::Bspline_surface<Traits>(b), v0));
    const GC::Edge_deviation x = deviation(a, v0, b, u0), y = deviation(p, v0, q, u0);
    BOOST_CHECK(x.gap.lower <= y.gap.upper && y.gap.lower <= x.gap.upper && x.reversed == y.reversed);
    BOOST_CHECK(x.normal_angle->lower <= y.normal_angle->upper && y.normal_angle->lower <= x.normal_angle->upper);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(collapsed_edges_and_vanishing_normals, Traits, All_traits) {
  const Patch<Traits> north = octant<Traits>(1, 1, 1, 1);
  // the same pole: homogeneous points that differ in a factor which is not constant
  const auto pole = edge_continuity(north, v1, octant<Traits>(-1, 1, 1, 5), v1);
  BOOST_CHECK(pole.g_order == 0 && pole.defect == Edge_defect::collapsed && pole.collapsed && pole.coplanar);
  BOOST_CHECK(pole.side == GC::Sign_pattern::zero && pole.normal_vanishes);
  BOOST_CHECK_EQUAL(order(north, v1, octant<Traits>(1, 1, -1, 1), v1), -1);
  BOOST_CHECK_EQUAL(order(north, v1, Spline<Traits>(north).reverse_u(), v1), 0);
  // the equator, and the meridians, which end in the pole
  BOOST_CHECK_EQUAL(order(north, v0, octant<Traits>(1, 1, -1, 3), v0), 2);
  const auto meridian = edge_continuity(north, u0, octant<Traits>(1, -1, 1, 3), u0);
  BOOST_CHECK(meridian.g_order == 0 && meridian.defect == Edge_defect::vanishing_normal);
  BOOST_CHECK(meridian.vanishing && meridian.vanishing->first == 1 && meridian.vanishing->second == 1);
  BOOST_CHECK(meridian.deviation->upper == 0);
  if constexpr (std::is_floating_point_v<typename Traits::FT>) return; // the parts are rounded
  const auto half = edge_continuity(north.split_v(typename Traits::FT(0.5)).first, u0, octant<Traits>(1, -1, 1, 3), u0);
  BOOST_CHECK(half.g_order == 2 && half.whole_a && !half.whole_b);
}

BOOST_AUTO_TEST_CASE(another_rational_parameter_along_the_edge) {
  // the same points, but other parameters: not recognised, and the distance of equal parameters is
  // enclosed
  const Patch<Exact> a = quarter_cylinder<Exact>();
  const Patch<Exact> b({{Exact::Point(0, 0, 1), Exact::Point(0, -1, 1)},
                        {Exact::Point(1, 0, 1), Exact::Point(1, -1, 1)},
                        {Exact::Point(1, 0, 0), Exact::Point(1, -1, 0)}},
                       {{Q(1), Q(1)}, {Q(2), Q(2)}, {Q(8), Q(8)}});
  BOOST_CHECK_EQUAL(order(a, v0, b, v0), -1);
  BOOST_CHECK(deviation(a, v0, b, v0).gap.lower > 0.1);
  // a factor that is not constant: elevated by a linear one in place of 1
  const Patch<Exact> c({{Exact::Point(0, 0, 0), Exact::Point(0, 1, 0)}, {Exact::Point(1, 0, 0), Exact::Point(1, 1, 0)}},
                       {{Q(1), Q(1)}, {Q(1), Q(1)}}),
      d({{Exact::Point(0, 0, 0), Exact::Point(0, -1, 0)},
         {Exact::Point(Q(1) / Q(3), 0, 0), Exact::Point(Q(1) / Q(3), -1, 0)},
         {Exact::Point(1, 0, 0), Exact::Point(1, -1, 0)}},
        {{Q(1), Q(1)}, {fraction(3, 2), fraction(3, 2)}, {Q(2), Q(2)}});
  BOOST_CHECK_EQUAL(order(c, v0, d, v0), -1);
  BOOST_CHECK(deviation(c, v0, d, v0).gap.lower == 0 && deviation(c, v0, d, v0).gap.upper == 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(deviations, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef typename Traits::Vector V;
  typedef typename Traits::FT FT;
  // circles of radius 1 and 2 in three quarters of a turn with a weight that is not positive, about
  // the same axis
  typedef GC::Revolution_surface_3<GC::Bezier_curve<Traits>> Revolution;
  const auto ring = [](int from, int to) {
    return bezier_patch(
        Revolution(GC::Bezier_curve<Traits>({P(from, 0, 0), P(to, 0, 0)}), P(0, 0, 0), V(0, 0, 1), {FT(-2), FT(3)}));
  };
  const Patch<Traits> inner = ring(1, 2), outer = ring(4, 5);
  BOOST_CHECK(!(FT(0) < inner.weight(0, 1)));
  const GC::Edge_deviation d = deviation(inner, u1, outer, u0);
  BOOST_CHECK(d.gap.lower <= 2 && 2 <= d.gap.upper && d.gap.upper - d.gap.lower < 1e-14);
  BOOST_CHECK(d.normal_angle->upper == 0 && !d.reversed && !d.normal_vanishes);
  BOOST_CHECK(deviation(inner, u1, ring(2, 3), u0).gap.upper == 0);
  BOOST_CHECK_EQUAL(order(inner, u1, ring(2, 3), u0), 2);
  BOOST_CHECK(order_within(inner, u1, outer, u0, {0.1, 2.001}).proved_order() == 1);
  BOOST_CHECK(order_within(inner, u1, outer, u0, {0.1, 1.999})(0) == GC::Verdict::refuted);
  BOOST_CHECK(order_within(inner, u1, ring(2, 3), u0, {0, 0}).proved_order() == 1);
  const GC::Edge_deviation mixed =
      deviation(quarter_cylinder<Traits>(), u0, GC::parallelogram<Traits>(P(0, 0, 2), V(-1, 0, 1), V(0, 1, 0)), u0);
  BOOST_CHECK(mixed.gap.lower == 1 && mixed.gap.upper == 1);
  BOOST_CHECK(mixed.normal_angle->lower < 0.78539817 && 0.7853981 < mixed.normal_angle->upper);
}

BOOST_AUTO_TEST_CASE(knot_lines) {
  Random random;
  const Spline<Exact> s = Spline<Exact>(random_patch(random, 3, 3)).insert_u(Q(0), 3).insert_v(fraction(1, 4), 2);
  const auto lines = knot_line_continuity(s);
  BOOST_REQUIRE_EQUAL(lines.size(), 2u);
  for (const auto& line : lines) BOOST_CHECK_EQUAL(line.continuity.g_order, 2);
  // of multiplicity degree + 1: the weights may jump by a factor, the points do not
  const std::vector<std::vector<Exact::Point>> net{{Exact::Point(0, 0, 0), Exact::Point(0, 1, 0)},
                                                   {Exact::Point(1, 0, 0), Exact::Point(1, 1, 0)},
                                                   {Exact::Point(1, 0, 0), Exact::Point(1, 1, 0)},
                                                   {Exact::Point(2, 0, 0), Exact::Point(2, 1, 0)}};
  const GC::Knot_vector<Q> knots(1, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)}), one(1, Q(0), Q(1));
  const auto jump = [&](const Q& w, const Q& height) {
    std::vector<std::vector<Exact::Point>> points = net;
    points[2][1] = Exact::Point(1, 1, height);
    return Spline<Exact>(points, std::vector<std::vector<Q>>{{Q(1), Q(1)}, {Q(1), Q(1)}, {Q(7), w}, {Q(7), Q(7)}},
                         knots, one);
  };
  BOOST_CHECK_EQUAL(knot_line_continuity(jump(Q(7), Q(0)))[0].continuity.g_order, 2);
  // other parameters
  BOOST_CHECK_EQUAL(knot_line_continuity(jump(Q(8), Q(0)))[0].continuity.g_order, -1);
  const Spline<Exact> gap = jump(Q(7), Q(2));
  BOOST_CHECK_EQUAL(knot_line_continuity(gap)[0].continuity.g_order, -1);
  const auto within = order_within(gap, knot_line_continuity(gap)[0], {0.1, 3});
  BOOST_CHECK(within.deviation.gap.lower == 2 && within.deviation.gap.upper == 2 && within(0) == GC::Verdict::proved);
  // all lines of a torus
  for (const auto& line :
       knot_line_continuity(GC::torus<Exact>(Exact::Point(1, 2, 3), Exact::Vector(2, 1, 0), Exact::Vector(0, 1, 1),
                                             Exact::Vector(1, 0, 5), fraction(2, 7))))
    BOOST_CHECK_EQUAL(line.continuity.g_order, 2);
}

BOOST_AUTO_TEST_CASE(revolutions_along_a_parallel) {
  // patches decide as the profiles do
  typedef GC::Bezier_curve<Exact> Curve;
  typedef GC::Revolution_surface_3<Curve> Revolution;
  typedef Exact::Point P;
  const Exact::Point a(1, -1, 2);
  const Exact::Vector w(1, 2, 2);
  const Curve left({P(4, 0, 0), P(5, 1, 2), P(6, 1, 4)});
  const std::pair<Curve, Curve> parts = left.split(fraction(1, 3));
  const Curve bent({P(6, 1, 4), P(8, 1, 8), P(9, 3, 3)}), kink({P(6, 1, 4), P(7, 1, 4)});
  const auto patch = [&](const Curve& c) { return bezier_patch(Revolution(c, a, w, {Q(-2), fraction(5, 3)})); };
  for (const std::pair<Curve, Curve>& join :
       {parts, std::make_pair(left, bent), std::make_pair(left, kink), std::make_pair(left, left.reverse())}) {
    const auto expected = revolution_continuity(join.first, join.second, a, w);
    const auto found = edge_continuity(patch(join.first), u1, patch(join.second), u0);
    BOOST_CHECK_EQUAL(found.g_order, expected.g_order);
    BOOST_CHECK(found.defect == expected.defect && found.side == expected.side);
    BOOST_CHECK(found.deviation->lower <= expected.deviation->upper &&
                expected.deviation->lower <= found.deviation->upper);
  }
}

BOOST_AUTO_TEST_CASE(bounded_work_and_bad_rows) {
  Random random;
  const Patch<Exact> s = random_patch(random, 3, 3);
  CHECK_ERROR(limited(GC::Work_limit{1}, [&] { return edge_continuity(s, u0, s, u0); }), work_limit);
  CHECK_ERROR(limited(GC::Work_limit{1}, [&] { return deviation(s, u0, s, u1); }), work_limit);
  auto rows = spline_edge_rows(s, u0);
  BOOST_CHECK_EQUAL(edge_continuity(rows, rows).g_order, 0);
  auto bad = rows;
  bad.rows.edge[0][3] = Q(0);
  BOOST_CHECK_EQUAL(edge_continuity(rows, bad).g_order, -1);
  CHECK_ERROR(deviation(rows, bad), zero_weight);
  bad.rows.edge[0][3] = Q(1);
  bad.rows.edge[1][3] = Q(-10);
  bad.rows.edge[2][3] = Q(-100000000);
  CHECK_ERROR(deviation(rows, bad), work_limit);
}

BOOST_AUTO_TEST_SUITE_END()
