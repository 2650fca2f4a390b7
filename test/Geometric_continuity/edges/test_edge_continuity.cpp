// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The order of continuity of Bezier patches along edges, degenerate edges, and the angle between
// the normals.

#include "support/enclosures.h"
#include "support/nets.h"

#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

using enclosures::ulps;

// The angle between the normals of two surfaces with the edge v = v_0 in one direction, by
// floating-point arithmetic.
template <class K> double sampled_angle(const Patch<K>& a, const Patch<K>& b, const typename K::FT& u) {
  const auto m = a.normal(u, a.domain_v().first), n = b.normal(u, b.domain_v().first);
  const typename K::Vector_3 cross = CGAL::cross_product(m, n);
  return std::atan2(std::sqrt(CGAL::to_double(cross.squared_length())), -CGAL::to_double(m * n));
}

// The value of a number of any kernel.
template <class FT> Q exact(const FT& x) {
  if constexpr (std::is_same_v<FT, Q>)
    return x;
  else
    return Q(x.exact());
}

// A flat surface y >= 0 and others along the edge (x, 0, 0), 0 <= x <= 1.
const Curve x_axis{line(0, 1), constant(0), constant(0)};
const Curve y_direction{constant(0), constant(1), constant(0)};
Curve direction(const Polynomial& x, const Polynomial& y, const Polynomial& z) { return {x, y, z}; }

template <class K> auto edge_along_x(const Curve& t1, const Curve& t2) {
  const std::vector<Patch<K>> s = patches<K>({net_from_rows(x_axis, t1), net_from_rows(x_axis, t2)});
  return GC::edge_continuity(s[0], v0, s[1], v0);
}

// ---------------------------------------------------------------- order along an edge

BOOST_AUTO_TEST_CASE_TEMPLATE(connected_surfaces, K, All_kernels) {
  Random random;
  for (int round = 0; round < 12; ++round) {
    Connection s(random, round % 3 == 0 ? 2 : 3);
    const std::vector<Patch<K>> g2 = patches<K>({s.first(), s.second()});
    const auto both = GC::edge_continuity(g2[0], v0, g2[1], v0);
    BOOST_CHECK_EQUAL(both.g_order, 2);
    BOOST_CHECK_EQUAL(both.defect, Edge_defect::none);
    BOOST_CHECK(both.coplanar && !both.reversed && !both.collapsed && !both.normal_vanishes && !both.vanishing);
    BOOST_CHECK_EQUAL(both.side, Sign_pattern::negative);
    BOOST_REQUIRE(both.deviation);
    BOOST_CHECK(both.deviation->lower == 0 && both.deviation->upper == 0);
    BOOST_CHECK_EQUAL(both.deviation->largest_angle(), 0);

    // the second derivative out of the tangent plane: no longer G2
    Connection bent = s;
    bent.w2 = bent.w2 + direction(constant(0), constant(0), Polynomial{Q(0), Q(0), Q(1)});
    const std::vector<Patch<K>> g1 = patches<K>({bent.first(), bent.second()});
    const auto curvature = GC::edge_continuity(g1[0], v0, g1[1], v0);
    BOOST_CHECK_EQUAL(curvature.g_order, 1);
    BOOST_CHECK_EQUAL(curvature.defect, Edge_defect::curvature);
    BOOST_CHECK(curvature.deviation && curvature.deviation->upper == 0);
    const auto exchanged = GC::edge_continuity(g1[1], v0, g1[0], v0);
    BOOST_CHECK_EQUAL(exchanged.g_order, 1);

    // each term of the identity counts: its neighbours with other functions fail
    for (int part = 0; part < 3; ++part) {
      Connection other = s;
      const Curve d = derivative(s.c);
      const Curve term = part == 0 ? derivative(d) : part == 1 ? derivative(s.t1) : s.w1;
      other.w2 = other.w2 + term;
      const std::vector<Patch<K>> p = patches<K>({other.first(), other.second()});
      const auto e = GC::edge_continuity(p[0], v0, p[1], v0);
      BOOST_CHECK(e.g_order == 1 || (part == 0 && degree(s.c) < 3));
    }

    // one control point moved by 1/1000: no longer G1
    Net moved = s.second();
    moved[random.integer(0, static_cast<int>(moved.size()) - 1)][1][2] += Q(1) / Q(1000);
    const std::vector<Patch<K>> g0 = patches<K>({s.first(), moved});
    const auto crease = GC::edge_continuity(g0[0], v0, g0[1], v0);
    BOOST_CHECK_EQUAL(crease.g_order, 0);
    BOOST_CHECK_EQUAL(crease.defect, Edge_defect::crease);
    BOOST_CHECK(!crease.coplanar && !crease.normal_vanishes);
    BOOST_REQUIRE(crease.deviation);
    BOOST_CHECK(crease.deviation->upper > 0 && crease.deviation->largest_angle() < 0.1);

    // a control point of the edge moved: no common edge
    Net gap = s.second();
    gap[1][0][0] += Q(1) / Q(1000);
    const std::vector<Patch<K>> no = patches<K>({s.first(), gap});
    const auto none = GC::edge_continuity(no[0], v0, no[1], v0);
    BOOST_CHECK_EQUAL(none.g_order, -1);
    BOOST_CHECK_EQUAL(none.defect, Edge_defect::gap);
    BOOST_CHECK(!none.deviation && !none.vanishing);
    BOOST_CHECK(GC::common_edges(no[0], no[1]).empty());
    CHECK_ERROR(GC::edge_continuity(no[0], no[1]), curves_do_not_meet);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(determinant_and_side, K, All_kernels) {
  Random random;
  const Connection s(random, 3);
  Net moved = s.second();
  moved[1][1][2] += Q(1);
  const std::vector<Patch<K>> p = patches<K>({s.first(), moved});
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  const GC::Edge_conditions<Field> conditions(GC::edge_rows(p[0], v0), GC::edge_rows(p[1], v0));
  BOOST_CHECK(!conditions.coplanar() && !conditions.g1() && !conditions.g2() && !conditions.second_order());
  const GC::Bernstein_polynomial<Field> det = conditions.determinant(), side = conditions.side();
  for (int k = 0; k <= 8; ++k) {
    const Field t = Field(Field(k) / Field(8));
    Field c[3], t1[3], t2[3], n1[3], n2[3];
    for (int x = 0; x < 3; ++x) {
      const auto value = [&](const Patch<K>& patch, int row, bool derivative) {
        std::vector<Field> b;
        const auto rows = patch.template rows<Field>(v0, 1);
        for (const auto& point : rows[row]) b.push_back(point[x]);
        const GC::Bernstein_polynomial<Field> q(b);
        return derivative ? q.derivative()(t) : q(t);
      };
      c[x] = value(p[0], 0, true);
      t1[x] = value(p[0], 1, false);
      t2[x] = value(p[1], 1, false);
    }
    Field expected_det(0), expected_side(0);
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      n1[x] = c[y] * t1[z] - c[z] * t1[y];
      n2[x] = c[y] * t2[z] - c[z] * t2[y];
      expected_det += n1[x] * t2[x];
      expected_side += n1[x] * n2[x];
    }
    BOOST_CHECK(det(t) == expected_det);
    BOOST_CHECK(side(t) == expected_side);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_orientations, K, All_kernels) {
  Random random;
  Connection s(random, 3);
  Connection bent = s;
  bent.w2 = bent.w2 + direction(constant(0), constant(0), constant(3));
  Net moved = s.second();
  moved[2][1][1] += Q(5);
  const std::vector<Patch<K>> p = patches<K>({s.first(), s.second(), bent.second(), moved});
  const Edge_defect defects[] = {Edge_defect::none, Edge_defect::curvature, Edge_defect::crease};
  int reversed = 0;
  for (const auto& [a, edge_a] : placements<K>(p[0]))
    for (int kind = 0; kind < 3; ++kind)
      for (const auto& [b, edge_b] : placements<K>(p[1 + kind])) {
        const auto e = GC::edge_continuity(a, edge_a, b, edge_b);
        BOOST_CHECK_EQUAL(e.defect, defects[kind]);
        BOOST_CHECK_EQUAL(e.g_order, 2 - kind);
        const bool backwards = GC::boundary_curve(a, edge_a) != GC::boundary_curve(b, edge_b);
        BOOST_CHECK_EQUAL(e.reversed, backwards);
        reversed += backwards;
        const std::vector<GC::Common_edge> common = GC::common_edges(a, b);
        BOOST_REQUIRE_EQUAL(common.size(), 1);
        BOOST_CHECK(common[0].edge_a == edge_a && common[0].edge_b == edge_b && common[0].reversed == backwards);
        const auto found = GC::edge_continuity(a, b);
        BOOST_CHECK(found.g_order == e.g_order && found.reversed == backwards && found.part_a == e.part_a);
      }
  BOOST_CHECK_EQUAL(reversed, 3 * 32);
}

// The common edge is looked for: a part of an edge, one of a spline, and one of several.
BOOST_AUTO_TEST_CASE(common_edges_are_found) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Traits;
  typedef Traits::Point Point;
  typedef GC::Bezier_patch<Traits> Square;
  const auto square = [](int x, Q y, int z) {
    return Square{{Point(x, 0, 0), Point(x, y, 0)}, {Point(x + 1, 0, z), Point(x + 1, y, z)}};
  };
  const Square a = square(0, 1, 0), b = square(1, 1, 1), half = square(1, Q(1) / Q(2), 0);
  BOOST_CHECK_EQUAL(GC::edge_continuity(a, b).g_order, 0);
  const auto part = GC::edge_continuity(a, half);
  BOOST_CHECK(part.g_order == 2 && !part.whole_a && part.whole_b);
  BOOST_CHECK(GC::edge_continuity(GC::Bspline_surface<Traits>(half), a).g_order == 2);
  // both ends of a strip, which meet; a surface and its copy; a surface that does not close
  const Square strip{{Point(0, 0, 0), Point(0, 1, 0)},
                     {Point(2, 0, 0), Point(2, 1, 0)},
                     {Point(-2, 0, 0), Point(-2, 1, 0)},
                     {Point(0, 0, 0), Point(0, 1, 0)}};
  BOOST_CHECK_EQUAL(GC::edge_continuity(strip, strip).g_order, 2);
  CHECK_ERROR(GC::edge_continuity(a, Square(a)), several_common_edges);
  CHECK_ERROR(GC::edge_continuity(a, a), curves_do_not_meet);
  BOOST_CHECK(GC::is_g0_edge(a, b) && !GC::is_g1_edge(a, b));
  BOOST_CHECK(GC::is_g1_edge(a, half) && GC::is_g2_edge(a, half));
  BOOST_CHECK(GC::is_g3_edge(a, square(1, 1, 0)) && !GC::is_g0_edge(a, square(2, 1, 0)));
  CHECK_ERROR(GC::is_g2_edge(a, Square(a)), several_common_edges);
  // edges that are one point do not count
  const Square pole{{Point(0, 0, 0), Point(0, 0, 0)}, {Point(1, 0, 0), Point(0, 1, 0)}},
      opposite{{Point(0, 0, 0), Point(0, 0, 0)}, {Point(-1, 0, 0), Point(0, -1, 0)}};
  CHECK_ERROR(GC::edge_continuity(pole, opposite), curves_do_not_meet);
}

TEST_FOR_EACH(unequal_degrees_and_domains, K, All_kernels) {
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  Random random;
  const Connection s(random, 2);
  Net first = net_from_rows(s.c, s.t1, s.w1, 2), second = net_from_rows(s.c, s.t2, s.w2, 6), moved = second;
  moved[3][1][2] += Q(1);
  const std::vector<Patch<K>> p = patches<K>({first, second, moved});
  BOOST_CHECK(p[0].degree_u() < p[1].degree_u());
  for (const Patch<K>& a : {p[0], p[0].oriented(v0).reverse_u()}) {
    BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, p[1], v0).g_order, 2);
    BOOST_CHECK_EQUAL(GC::edge_continuity(p[1], v0, a, v0).g_order, 2);
    BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, p[2], v0).g_order, 0);
    BOOST_CHECK_EQUAL(GC::edge_continuity(p[2], v0, a, v0).g_order, 0);
    BOOST_CHECK_EQUAL(GC::common_edges(a, p[1]).size(), 1);
  }
  // another domain changes the parameters of the answer and nothing else
  const Patch<K> a = p[0].with_domain({FT(10), FT(26)}, {FT(-3), FT(5)}),
                 b = p[2].with_domain({FT(-1), FT(0)}, {FT(7), FT(9)});
  const auto unit = GC::edge_continuity(p[0], v0, p[2], v0), e = GC::edge_continuity(a, v0, b, v0);
  BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, p[1], v0).g_order, 2);
  BOOST_REQUIRE(e.deviation && unit.deviation);
  BOOST_CHECK(e.deviation->upper == unit.deviation->upper);
  BOOST_CHECK(e.deviation->begin == Field(Field(10) + Field(16) * unit.deviation->begin));
  BOOST_CHECK(e.deviation->end == Field(Field(10) + Field(16) * unit.deviation->end));
  BOOST_CHECK(e.deviation->begin < e.deviation->end);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(folds_are_not_smooth, K, All_kernels) {
  Random random;
  // both sides of the edge: angles of tangent planes, folded to [0, 90] degrees, are all zero
  Connection s(random, 3);
  const Polynomial along = random.polynomial(1), second_along = random.polynomial(1);
  s.connect(along, constant(1), second_along, random.polynomial(1));
  const std::vector<Patch<K>> p = patches<K>({s.first(), s.second()});
  const auto fold = GC::edge_continuity(p[0], v0, p[1], v0);
  BOOST_CHECK_EQUAL(fold.g_order, 0);
  BOOST_CHECK_EQUAL(fold.defect, Edge_defect::fold);
  BOOST_CHECK(fold.coplanar && !fold.normal_vanishes);
  BOOST_CHECK_EQUAL(fold.side, Sign_pattern::positive);
  BOOST_REQUIRE(fold.deviation);
  BOOST_CHECK(fold.deviation->lower == 2 && fold.deviation->upper == 2);
  BOOST_CHECK_GT(fold.deviation->largest_angle(), 3.14159265358979);
  // opposite normals with equal curvatures: the identity of second order holds
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  const GC::Edge_conditions<Field> conditions(GC::edge_rows(p[0], v0), GC::edge_rows(p[1], v0));
  BOOST_CHECK(conditions.coplanar() && conditions.second_order() && !conditions.g1() && !conditions.g2());
}

TEST_FOR_EACH(one_unit_in_the_last_place, K, All_kernels) {
  Random random;
  const Connection s(random, 3);
  const std::vector<Patch<K>> p = patches<K>({s.first(), s.second()});
  BOOST_REQUIRE_EQUAL(GC::edge_continuity(p[0], v0, p[1], v0).g_order, 2);
  for (int layer = 0; layer < 3; ++layer)
    for (int i = 0; i <= p[1].degree_u(); ++i) {
      auto net = net_of(p[1].degree_u() + 1, 3, [&](int k, int j) { return p[1].control_point(k, j); });
      typename K::Point_3& b = net[i][layer];
      FT z = b.z();
      if constexpr (is_exact<FT>)
        z += FT(Q(1) / Q(1000000000) / Q(1000000000) / Q(1000000000));
      else
        z = std::nextafter(z, 1e300);
      b = typename K::Point_3(b.x(), b.y(), z);
      const auto e = GC::edge_continuity(p[0], v0, Patch<K>(net), v0);
      BOOST_CHECK_EQUAL(e.g_order, layer - 1);
      if (layer == 1) {
        BOOST_REQUIRE(e.deviation);
        BOOST_CHECK_GT(e.deviation->smallest_angle(), 0);
        BOOST_CHECK_LT(e.deviation->largest_angle(), 1e-12);
      }
    }
}

// ---------------------------------------------------------------- degenerate edges

BOOST_AUTO_TEST_CASE_TEMPLATE(collapsed_edges, K, All_kernels) {
  const Curve point{constant(2), constant(3), constant(5)};
  const std::vector<Patch<K>> p =
      patches<K>({net_from_rows(point, direction(line(-1, 1), constant(1), constant(0))),
                  net_from_rows(point, direction(line(1, -1), constant(-1), constant(0)), nullptr, 3)});
  const auto e = GC::edge_continuity(p[0], v0, p[1], v0);
  BOOST_CHECK_EQUAL(e.g_order, 0);
  BOOST_CHECK_EQUAL(e.defect, Edge_defect::collapsed);
  BOOST_CHECK(e.collapsed && !e.deviation && !e.vanishing);
  BOOST_CHECK(GC::common_edges(p[0], p[1]).empty());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(vanishing_normals, K, All_kernels) {
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  const auto cross = [](const Polynomial& y) { return direction(constant(0), constant(-1) * y, constant(0)); };
  const auto check = [](const auto& e, const Field& from, const Field& to) {
    BOOST_CHECK_EQUAL(e.g_order, 0);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::vanishing_normal);
    BOOST_CHECK_EQUAL(e.side, Sign_pattern::nonpositive);
    BOOST_CHECK(e.normal_vanishes && e.coplanar && !e.collapsed);
    BOOST_REQUIRE(e.vanishing);
    BOOST_CHECK(e.vanishing->first == from && e.vanishing->second == to);
    BOOST_CHECK(e.deviation && e.deviation->upper == 0);
  };
  const Field half = Field(Field(1) / Field(2));
  check(edge_along_x<K>(y_direction, cross(line(0, 1))), Field(0), Field(0));
  check(edge_along_x<K>(y_direction, cross(line(1, 0))), Field(1), Field(1));
  check(edge_along_x<K>(y_direction, cross(line(-1, 1) * line(-1, 1))), half, half);
  check(edge_along_x<K>(direction(constant(0), line(-1, 1) * line(-1, 1), constant(0)), cross(constant(1))), half,
        half);
  // on both sides: the side changes twice, the patches continue each other elsewhere
  check(edge_along_x<K>(direction(constant(0), line(-1, 1), constant(0)), cross(line(-1, 1))), half, half);

  // an irrational double zero: (x^2 - 1/2)^2
  const Polynomial square = Polynomial{Q(-1), Q(-1), Q(1)};
  const auto irrational = edge_along_x<K>(y_direction, cross(square * square));
  BOOST_CHECK_EQUAL(irrational.defect, Edge_defect::vanishing_normal);
  BOOST_REQUIRE(irrational.vanishing);
  const Q from = exact(irrational.vanishing->first), to = exact(irrational.vanishing->second);
  BOOST_CHECK(Q(from * from) < Q(1) / Q(2) && Q(1) / Q(2) < Q(to * to) && Q(to - from) <= Q(1) / Q(1000));
  // nearly
  BOOST_CHECK_EQUAL(edge_along_x<K>(y_direction, cross(square * square + Polynomial{Q(1) / Q(1024)})).g_order, 2);

  // the edge stops: C = (x^2, 0, 0)
  const Curve slow{Polynomial{Q(0), Q(0), Q(1)}, constant(0), constant(0)};
  const std::vector<Patch<K>> p =
      patches<K>({net_from_rows(slow, y_direction), net_from_rows(slow, cross(constant(1)))});
  check(GC::edge_continuity(p[0], v0, p[1], v0), Field(0), Field(0));

  // no normal at all on one side
  for (const Curve& t :
       {direction(constant(0), constant(0), constant(0)), direction(constant(1), constant(0), constant(0))}) {
    const auto e = edge_along_x<K>(y_direction, t);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::vanishing_normal);
    BOOST_CHECK_EQUAL(e.side, Sign_pattern::zero);
    BOOST_REQUIRE(e.vanishing);
    BOOST_CHECK(e.vanishing->first == 0 && e.vanishing->second == 1);
    BOOST_CHECK(!e.deviation);
  }

  // a crease whose normal vanishes at an end, where the angle has a limit; and inside, where it has
  // none
  const auto end = edge_along_x<K>(y_direction, direction(constant(0), line(0, -1), line(0, 1)));
  BOOST_CHECK_EQUAL(end.defect, Edge_defect::crease);
  BOOST_CHECK(end.normal_vanishes && end.vanishing && end.vanishing->second == 0);
  BOOST_REQUIRE(end.deviation);
  BOOST_CHECK(Q(exact(end.deviation->lower)) == Q(1) / Q(2) &&
              end.deviation->upper == end.deviation->lower); // 45 degrees
  const auto inside =
      edge_along_x<K>(y_direction, direction(constant(0), constant(-1) * line(-1, 1) * line(-1, 1), line(-1, 1)));
  BOOST_CHECK_EQUAL(inside.defect, Edge_defect::crease);
  BOOST_CHECK(inside.normal_vanishes && inside.vanishing && inside.vanishing->second == half);
  BOOST_REQUIRE(inside.deviation);
  BOOST_CHECK(exact(inside.deviation->upper) == Q(1)); // a right angle, as a limit
  BOOST_CHECK_LE(ulps(inside.deviation->angle()), 4);
  // perpendicular normals do not vanish
  const auto right = edge_along_x<K>(y_direction, direction(constant(0), constant(0), constant(1)));
  BOOST_CHECK_EQUAL(right.defect, Edge_defect::crease);
  BOOST_CHECK(!right.normal_vanishes && !right.vanishing);
  BOOST_CHECK_EQUAL(right.side, Sign_pattern::zero);
  BOOST_CHECK(right.deviation && right.deviation->lower == 1 && right.deviation->upper == 1);
}

// ---------------------------------------------------------------- the angle between the normals

TEST_FOR_EACH(the_angle_is_enclosed, K, All_kernels) {
  Random random;
  double widest = 0, narrowest = 4;
  for (int round = 0; round < 30; ++round) {
    Connection s(random, 3);
    // T2 turned out of the plane, from slightly to far beyond the right angle
    const int q = round % 3 - 1; // on the other side, nowhere, on the same side
    s.connect(random.polynomial(1), constant(q), constant(0), constant(0));
    const Curve t2 = constant(4) * s.t2 + direction(constant(0), constant(0), random.polynomial(2, 1, 4 * round + 1));
    const std::vector<Patch<K>> p = patches<K>({s.first(), net_from_rows(s.c, t2)});
    const auto e = GC::edge_continuity(p[0], v0, p[1], v0);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::crease);
    BOOST_REQUIRE(e.deviation);
    const double lower = e.deviation->smallest_angle(), upper = e.deviation->largest_angle();
    const double begin = CGAL::to_double(e.deviation->begin), end = CGAL::to_double(e.deviation->end);
    double largest = 0, inside = 0;
    const int samples = 256;
    for (int k = 0; k <= samples; ++k) {
      const double t = double(k) / samples, angle = sampled_angle<K>(p[0], p[1], FT(t));
      largest = std::max(largest, angle);
      if (begin <= t && t <= end) inside = std::max(inside, angle);
    }
    BOOST_CHECK_LE(lower, upper);
    BOOST_CHECK_LE(upper, 3.1415926535897936);
    BOOST_CHECK_LE(ulps(e.deviation->angle()), 4);
    BOOST_CHECK_LE(largest, upper * (1 + 1e-12));
    BOOST_CHECK_LE(upper, largest * 1.002);
    // else no sample need be inside
    if (begin <= 0 || end >= 1) BOOST_CHECK_GE(inside, largest * (1 - 1e-12));
    // the angle at the place that is found
    const double found = sampled_angle<K>(p[0], p[1], FT((begin + end) / 2));
    if (0 < begin && end < 1) BOOST_CHECK_CLOSE(found, upper, 1e-6);
    BOOST_CHECK_LE(end - begin, 1.0 / 32);
    widest = std::max(widest, largest);
    narrowest = std::min(narrowest, largest);
  }
  BOOST_CHECK_GT(widest, 2.5);
  BOOST_CHECK_LT(narrowest, 0.5);
}

BOOST_AUTO_TEST_CASE(angles_of_measures) {
  typedef GC::Normal_deviation<Q> Deviation;
  const double pi = std::acos(-1.0);
  for (int k = 0; k <= 200; ++k) {
    const double angle = k * pi / 200, cosine = std::cos(angle);
    const GC::Enclosure e = Deviation::angle(Q(1 - cosine * std::abs(cosine)));
    BOOST_CHECK_SMALL(e.lower - angle, 1e-7);
    BOOST_CHECK_SMALL(e.upper - angle, 1e-7);
    BOOST_CHECK_LE(e.lower, e.upper);
    BOOST_CHECK_LE(ulps(e), 4);
  }
  BOOST_CHECK((Deviation::angle(Q(0)) == GC::Enclosure{0, 0}));
  BOOST_CHECK(Deviation::angle(Q(2)).lower <= pi && pi < Deviation::angle(Q(2)).upper);
  BOOST_CHECK(Deviation::angle(Q(1)).lower <= pi / 2 && pi / 2 < Deviation::angle(Q(1)).upper);
  for (const Q& outside : {Q(Q(-1) / 8), Q(Q(17) / 8)})
    CHECK_ERROR(Deviation::angle(outside), parameter_outside_domain);
  // tiny angles keep their accuracy
  const GC::Enclosure tiny = Deviation::angle(Q(Q(1) / Q(1e40)));
  BOOST_CHECK_CLOSE(tiny.lower, 1e-20, 1e-13);
  BOOST_CHECK_LE(ulps(tiny), 4);
}
