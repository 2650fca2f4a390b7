// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Where the normals of swept surfaces vanish, and how smoothly swept surfaces join.

#include "support/decided_joins.h"
#include "support/swept_surfaces.h"

#include <CGAL/Geometric_continuity/edges/swept_continuity.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>

// ---------------------------------------------------------------- where the normal vanishes

template <class FT> bool is_at(const GC::Sweep_defect<FT>& p, const FT& begin, const FT& end) {
  return p.begin == begin && p.end == end;
}

// The one defect at a parameter, with all that is told about it.
template <class Surface, class FT> void check_defect(const Surface& s, const FT& at, const std::string& expected) {
  const auto d = sweep_defects(s);
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  const auto& p = d.points[0];
  BOOST_CHECK(is_at(p, at, at) && !d.degenerate);
  BOOST_CHECK_EQUAL(text(p.multiplicity, p.on_axis ? ", on axis" : "", p.zero_tangent ? ", zero tangent" : "",
                         p.smooth_pole ? ", smooth pole" : "", p.normal_flips ? ", flips" : ""),
                    expected);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(defects_of_revolution, Traits, Deciding_kernels) {
  typedef GC::Bezier_curve<Traits> C;
  typedef GC::Edge_field<Traits> Field;
  const auto revolve = [&](std::initializer_list<std::array<int, 3>> rows) {
    return GC::Revolution_surface_3<C>(int_curve<Traits>(rows), typename Traits::Point(0, 0, 0),
                                       typename Traits::Vector(0, 0, 2));
  };
  const Field third = Field(Field(1) / Field(3)), half = Field(Field(1) / Field(2)), one(1);

  // a cone through its tip, in the plane x = y: r = 1 - 3t
  auto s = revolve({{1, 1, 0}, {-2, -2, 5}});
  check_defect(s, third, "1, on axis, flips");
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::mixed);
  BOOST_CHECK((*signed_radius(s))(third) == Field(0));
  // on either side of the tip the normal is opposite
  if constexpr (std::is_same_v<Traits, Exact>) BOOST_CHECK(s.normal(Q(0), Q(1)) * s.normal(Q(1), Q(1)) < 0);
  // the tip at the end: nothing flips
  check_defect(revolve({{3, 0, 0}, {0, 0, 5}}), one, "1, on axis");
  // ends on the axis at a right angle, in a plane and not; a disc; on the axis without a tangent
  check_defect(revolve({{3, 0, 0}, {3, 0, 3}, {0, 0, 3}}), one, "1, on axis, smooth pole");
  check_defect(revolve({{1, 2, 0}, {1, 1, 3}, {0, 0, 3}}), one, "1, on axis, smooth pole");
  check_defect(revolve({{1, 0, 3}, {0, 0, 3}}), one, "1, on axis, smooth pole");
  check_defect(revolve({{3, 0, 0}, {0, 0, 3}, {0, 0, 3}}), one, "3, on axis, zero tangent");
  // a vase, no defect
  s = revolve({{2, 0, 0}, {5, 0, 1}, {1, 0, 3}, {2, 0, 4}});
  BOOST_CHECK(!sweep_defects(s).degenerate && sweep_defects(s).points.empty());
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::positive);
  // r = (1 - 2t)^2 touches the axis: r' vanishes there, c' does not, and the normal keeps its side
  s = revolve({{0, 1, 0}, {0, -1, 1}, {0, 1, 2}});
  check_defect(s, half, "2, on axis");
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::nonnegative);
  // a skew line through the axis at its middle is no line in a plane through it, unless it meets
  // it: here it does
  check_defect(revolve({{1, 2, 0}, {-1, -2, 3}}), half, "1, on axis, flips");
  // a skew line makes a hyperboloid: no defect, no signed radius
  s = revolve({{1, 2, 0}, {1, -2, 3}});
  BOOST_CHECK(sweep_defects(s).points.empty() && !signed_radius(s));
  // a profile that is not planar and crosses the axis: x = 1 - 2t, y = (1 - 2t)^2
  s = revolve({{1, 1, 0}, {0, -1, 1}, {-1, 1, 2}});
  check_defect(s, half, "1, on axis, flips");
  BOOST_CHECK(!signed_radius(s));
  // tangent to a parallel: z = (1 - 2t)^2, (x, y) runs along (1, 1 - 2t)
  check_defect(revolve({{1, 1, 1}, {1, 0, -1}, {1, -1, 1}}), half, "1, flips");
  // a cusp off the axis, one on it: (1 - 2t)^2 (1, 0, 1)
  check_defect(revolve({{2, 0, 0}, {3, 0, 4}, {2, 0, 0}}), half, "1, zero tangent, flips");
  check_defect(revolve({{1, 0, 1}, {-1, 0, -1}, {1, 0, 1}}), half, "3, on axis, zero tangent, flips");
  // nothing but defects: on the axis, a point off it
  for (const auto& profile :
       {revolve({{0, 0, 1}, {0, 0, 3}, {0, 0, 4}}), revolve({{1, 2, 3}}), revolve({{1, 2, 3}, {1, 2, 3}})}) {
    BOOST_CHECK(sweep_defects(profile).degenerate && sweep_defects(profile).points.empty());
    BOOST_CHECK(signed_radius(profile).has_value());
  }
  BOOST_CHECK(sign_pattern(*signed_radius(revolve({{0, 0, 1}, {0, 0, 3}}))) == Sign_pattern::zero);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(defects_of_extrusion, Traits, Deciding_kernels) {
  typedef GC::Bezier_curve<Traits> C;
  typedef GC::Edge_field<Traits> Field;
  const auto extrude = [&](std::initializer_list<std::array<int, 3>> rows) {
    return GC::Extrusion_surface_3<C>(int_curve<Traits>(rows), typename Traits::Vector(0, 0, 3));
  };
  const Field half = Field(Field(1) / Field(2));
  BOOST_CHECK(sweep_defects(extrude({{0, 0, 0}, {1, 2, 3}, {4, 0, 0}})).points.empty());
  // x = (1 - 2t)^2: folds at 1/2, where c' = (0, 0, c) is parallel to w; x = (1 - 2t)^3: no fold
  check_defect(extrude({{1, 0, 0}, {-1, 0, 1}, {1, 0, 2}}), half, "1, flips");
  check_defect(extrude({{1, 0, 0}, {-1, 0, 1}, {1, 0, 2}, {-1, 0, 3}}), half, "2");
  // both ends, and a zero tangent
  const auto d = sweep_defects(extrude({{1, 0, 0}, {1, 0, 1}, {2, 0, 5}, {2, 0, 5}}));
  BOOST_REQUIRE_EQUAL(d.points.size(), 2u);
  BOOST_CHECK(is_at(d.points[0], Field(0), Field(0)) && !d.points[0].zero_tangent && !d.points[0].normal_flips);
  BOOST_CHECK(is_at(d.points[1], Field(1), Field(1)) && d.points[1].zero_tangent && !d.points[1].normal_flips);
  // nothing but defects: along w, a point
  BOOST_CHECK(sweep_defects(extrude({{1, 1, 0}, {1, 1, 4}, {1, 1, 2}})).degenerate);
  BOOST_CHECK(sweep_defects(extrude({{1, 1, 0}})).degenerate);
}

BOOST_AUTO_TEST_CASE(defects_of_random_profiles) {
  // x' and y' have the common factor (t - p)(t - q) and no other
  Random random;
  for (int run = 0; run < 10; ++run) {
    const Q p = Q(Q(random.integer(1, 499)) / Q(1000)), q = Q(Q(random.integer(501, 999)) / Q(1000));
    const Polynomial common = factor(p) * factor(q), x = (common * factor(Q(2))).antiderivative(),
                     y = (common * factor(Q(-1))).antiderivative(), z = Polynomial{Q(0), Q(0), Q(0), Q(0), Q(1)};
    std::vector<Point> points;
    for (int i = 0; i <= 4; ++i) points.push_back(Point(x[i], y[i], z[i]));
    const Curve c(points.begin(), points.end(), Q(10), Q(14));
    const auto d = sweep_defects(Extrusion(c, Vector(0, 0, 1)));
    BOOST_REQUIRE_EQUAL(d.points.size(), 2u);
    for (int i = 0; i < 2; ++i) {
      const Q u = Q(Q(10) + Q(4) * (i == 0 ? p : q));
      BOOST_CHECK(d.points[i].begin <= u && u <= d.points[i].end && d.points[i].normal_flips);
      BOOST_CHECK(Q(d.points[i].end - d.points[i].begin) <= Q(Q(4) / Q(1024)));
      BOOST_CHECK(Extrusion(c, Vector(0, 0, 1)).normal(u, Q(0)) == CGAL::NULL_VECTOR);
    }
    // the same numbers as the radius of a profile: x on the axis where it is its own root
    std::vector<Point> radius;
    const Polynomial r = common * factor(Q(3));
    for (int i = 0; i <= 3; ++i) radius.push_back(Point(r[i], Q(Q(2) * r[i]), Q(i)));
    const Revolution s(Curve(radius.begin(), radius.end()), Point(0, 0, -5), Vector(0, 0, 7));
    const auto e = sweep_defects(s);
    BOOST_REQUIRE_EQUAL(e.points.size(), 2u);
    BOOST_CHECK(e.points[0].begin <= p && p <= e.points[0].end && e.points[0].on_axis && e.points[0].normal_flips);
    BOOST_CHECK(e.points[1].begin <= q && q <= e.points[1].end && e.points[1].on_axis && e.points[1].normal_flips);
    BOOST_CHECK((*signed_radius(s))(p) == 0 && (*signed_radius(s))(q) == 0);
  }
}

// ---------------------------------------------------------------- continuity

// A right profile that continues the surface s, and not necessarily its profile: y(t) = s(u(t),
// v(t)), as far as the second derivative shows, plus `normal` times the normal.
Curve continued(const Revolution& s, Random& random, const Q& p, const Q& normal) {
  const GC::Surface_jet<Exact> j = s.jet(s.domain_u().second, Q(0), 2);
  const Q b = random.positive(), c = random.rational(), q = random.rational();
  const Column d1 = b * j(1, 0) + p * j(0, 1);
  const Column d2 = Q(b * b) * j(2, 0) + Q(Q(2) * b * p) * j(1, 1) + Q(p * p) * j(0, 2) + c * j(1, 0) + q * j(0, 1) +
                    normal * column(s.normal(s.domain_u().second, Q(0)));
  return curve_from(j(0, 0), d1, d2);
}

// The order that the meridian has: (r^2, h), which is a smooth map of the distance r > 0 and the
// height.
int meridian_order(const Curve& left, const Curve& right, const Point& a, const Vector& w) {
  typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Plane;
  const auto meridian = [&](const GC::Curve_jet<Exact>& c) {
    Column m[3];
    for (int j = 0; j < 3; ++j) m[j] = cross_product(column(w), j == 0 ? c[0] - column(a) : c[j]);
    GC::Curve_jet<Plane> jet(2, 2);
    jet[0][0] = dot(m[0], m[0]);
    jet[1][0] = Q(2) * dot(m[0], m[1]);
    jet[2][0] = Q(2) * dot(m[1], m[1]) + Q(2) * dot(m[0], m[2]);
    for (int j = 0; j < 3; ++j) jet[j][1] = dot(column(w), j == 0 ? c[0] - column(a) : c[j]);
    return jet;
  };
  return continuity(meridian(left.end_jet(2)), meridian(right.start_jet(2))).g_order;
}

BOOST_AUTO_TEST_CASE(revolution_is_as_smooth_as_the_meridian) {
  Random random;
  int smooth = 0;
  for (int run = 0; run < 15; ++run) {
    const Curve left = random.curve(3);
    const Point a = random.point();
    const Vector w = random.vector();
    const Revolution s(left, a, w);
    for (const Q& p : {Q(0), random.rational()})
      for (const Q& normal : {Q(0), random.rational()}) {
        const Curve right = continued(s, random, p, normal);
        const auto edge = revolution_continuity(left, right, a, w);
        BOOST_CHECK_EQUAL(edge.g_order, normal == 0 ? 2 : 1);
        BOOST_CHECK_EQUAL(edge.g_order, meridian_order(left, right, a, w));
        BOOST_CHECK(edge.defect == (normal == 0 ? Edge_defect::none : Edge_defect::curvature));
        smooth += edge.g_order == 2;
        // the profile itself has a crease unless p = 0
        BOOST_CHECK_EQUAL(continuity(left, right).g_order, p != 0 ? 0 : normal == 0 ? 1 : 1);
        // the right profile may be turned about the axis first
        const Q turn = random.rational();
        const Revolution t(right, a, w);
        std::vector<Point> turned;
        for (const Point& b : right) turned.push_back(Revolution(Curve{b}, a, w)(Q(0), turn));
        const auto again = revolution_continuity(left, Curve(turned.begin(), turned.end()), a, w);
        BOOST_CHECK_EQUAL(again.g_order, edge.g_order);
        // backwards it folds
        BOOST_CHECK(revolution_continuity(left, left.reverse(), a, w).defect == Edge_defect::fold);
        BOOST_CHECK_EQUAL(meridian_order(left, left.reverse(), a, w), 0);
      }
    // random tangents: a crease, with the measured angle of the normals
    const auto first = random.column(), second = random.column();
    const Curve right = curve_from(column(left.control_point(3)), first, second);
    const auto edge = revolution_continuity(left, right, a, w);
    const Vector m = s.normal(left.domain().second, Q(0)), n = Revolution(right, a, w).normal(Q(0), Q(0));
    const double angle =
        std::atan2(std::sqrt(CGAL::to_double(CGAL::cross_product(m, n).squared_length())), CGAL::to_double(m * n));
    BOOST_CHECK(edge.defect == Edge_defect::crease && edge.g_order == 0);
    BOOST_REQUIRE(edge.deviation.has_value());
    BOOST_CHECK_CLOSE(edge.deviation->largest_angle(), angle,
                      1e-6); // percent; asin near a right angle halves the digits
  }
  BOOST_CHECK_EQUAL(smooth, 30);
}

BOOST_AUTO_TEST_CASE(smooth_profiles_give_smooth_surfaces) {
  Random random;
  for (int run = 0; run < 10; ++run) {
    const Curve left = random.curve(3);
    const GC::Curve_jet<Exact> x = left.end_jet(2);
    const Q b = random.positive(), c = random.rational();
    const Column d1 = b * x[1], d2 = Q(b * b) * x[2] + c * x[1], jump = random.column();
    const Point a = random.point();
    const Vector w = random.vector();
    for (int order : {2, 1}) {
      const Curve right = curve_from(x[0], d1, order == 2 ? d2 : d2 + jump);
      BOOST_CHECK_EQUAL(continuity(left, right).g_order, order);
      BOOST_CHECK_EQUAL(extrusion_continuity(left, right, w).g_order, order);
      BOOST_CHECK_EQUAL(revolution_continuity(left, right, a, w).g_order, order);
      // the edge test on the patches, and on the model of both
      const GC::Bezier_patch<Exact> p = bezier_patch(Extrusion(left, w)), q = bezier_patch(Extrusion(right, w));
      BOOST_CHECK_EQUAL(edge_continuity(p, GC::Patch_edge::u1, q, GC::Patch_edge::u0).g_order, order);
      const auto summary = GC::model_continuity(std::vector<GC::Bezier_patch<Exact>>{p, q}).summary;
      BOOST_CHECK_EQUAL(summary.g2, order == 2 ? 1u : 0u);
      BOOST_CHECK_EQUAL(summary.g1, order == 1 ? 1u : 0u);
    }
    // creases of the profile that the extrusion does not see: the jumps lie in planes with w
    const Q p = random.rational(), q = random.rational();
    const Curve right = curve_from(x[0], d1 + p * column(w), d2 + q * column(w));
    BOOST_CHECK_EQUAL(continuity(left, right).g_order, 0);
    const auto edge = extrusion_continuity(left, right, w);
    BOOST_CHECK(edge.g_order == 2 && edge.defect == Edge_defect::none && edge.side == Sign_pattern::negative);
    // but the revolution does, about an axis that is not parallel to w
    BOOST_CHECK(revolution_continuity(left, right, a, random.vector()).defect == Edge_defect::crease);
    const GC::Bezier_patch<Exact> s = bezier_patch(Extrusion(left, w)), t = bezier_patch(Extrusion(right, w));
    BOOST_CHECK_EQUAL(edge_continuity(s, GC::Patch_edge::u1, t, GC::Patch_edge::u0).g_order, 2);
    // any crease: the same answer as on the patches
    const auto first = random.column(), second = random.column();
    const Curve kink = curve_from(x[0], first, second);
    const GC::Bezier_patch<Exact> k = bezier_patch(Extrusion(kink, w));
    const auto e = extrusion_continuity(left, kink, w);
    const auto f = edge_continuity(s, GC::Patch_edge::u1, k, GC::Patch_edge::u0);
    BOOST_CHECK(e.defect == Edge_defect::crease && f.defect == Edge_defect::crease);
    BOOST_CHECK(e.deviation->upper == f.deviation->upper && e.deviation->lower == f.deviation->lower);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(degenerate_joins, Traits, All_kernels) {
  const auto extrude = [](const auto& left, const auto& right) {
    return extrusion_continuity(left, right, typename Traits::Vector(0, 0, 1)).defect;
  };
  const auto revolve = [](const auto& left, const auto& right) {
    return revolution_continuity(left, right, typename Traits::Point(0, 0, 0), typename Traits::Vector(0, 0, 1)).defect;
  };
  const auto c = int_curve<Traits>({{1, 0, 0}, {2, 0, 1}, {3, 0, 2}});
  const auto r = [](std::initializer_list<std::array<int, 3>> rows) { return int_curve<Traits>(rows); };
  BOOST_CHECK(extrude(c, r({{3, 0, 3}, {4, 0, 4}})) == Edge_defect::gap);
  BOOST_CHECK(revolve(c, r({{3, 0, 3}, {4, 0, 4}})) == Edge_defect::gap); // another height
  BOOST_CHECK(revolve(c, r({{3, 1, 2}, {4, 0, 4}})) == Edge_defect::gap); // another radius
  // a straight line goes on
  BOOST_CHECK(extrude(c, r({{3, 0, 2}, {4, 0, 3}})) == Edge_defect::none);
  BOOST_CHECK(revolve(c, r({{3, 0, 2}, {4, 0, 3}})) == Edge_defect::none);
  BOOST_CHECK(revolve(c, r({{0, -3, 2}, {0, -4, 3}})) == Edge_defect::none); // on the other side
  // at the opposite point
  BOOST_CHECK(revolve(c, r({{-3, 0, 2}, {-4, 0, 3}})) == Edge_defect::none);
  BOOST_CHECK(revolve(c, r({{-3, 0, 2}, {-2, 0, 3}})) == Edge_defect::crease);
  BOOST_CHECK(extrude(c, r({{3, 0, 2}, {2, 0, 1}})) == Edge_defect::fold);
  BOOST_CHECK(revolve(c, r({{3, 0, 2}, {2, 0, 1}})) == Edge_defect::fold);
  // no tangent; a tangent along the ruling, along the parallel
  BOOST_CHECK(extrude(c, r({{3, 0, 2}, {3, 0, 2}, {9, 9, 9}})) == Edge_defect::vanishing_normal);
  BOOST_CHECK(revolve(c, r({{3, 0, 2}, {3, 0, 2}, {9, 9, 9}})) == Edge_defect::vanishing_normal);
  BOOST_CHECK(extrude(c, r({{3, 0, 2}, {3, 0, 5}, {9, 9, 9}})) == Edge_defect::vanishing_normal);
  BOOST_CHECK(revolve(c, r({{3, 0, 2}, {3, 5, 2}, {9, 9, 9}})) == Edge_defect::vanishing_normal);
  BOOST_CHECK(extrude(c, r({{3, 0, 2}})) == Edge_defect::vanishing_normal); // a point
  // a join on the axis, smooth or not, is undefined
  BOOST_CHECK(revolve(r({{1, 0, 0}, {0, 0, 0}}), r({{0, 0, 0}, {-1, 0, 0}})) == Edge_defect::collapsed);
  BOOST_CHECK(revolve(r({{1, 0, 0}, {0, 0, 0}}), r({{0, 0, 0}, {-1, 0, 5}})) == Edge_defect::collapsed);
  BOOST_CHECK(revolve(r({{0, 0, 1}, {0, 0, 0}}), r({{0, 0, 0}, {0, 0, -1}})) == Edge_defect::collapsed);
  // closed profiles: their own ends and starts. The extrusion lies in a plane.
  const auto ring = r({{3, 0, 0}, {4, 0, 1}, {3, 0, 2}, {0, 0, 0}, {2, 0, -1}, {3, 0, 0}});
  BOOST_CHECK(revolve(ring, ring) == Edge_defect::curvature);
  BOOST_CHECK(extrude(ring, ring) == Edge_defect::none);
  const auto smoother = r({{3, 0, 0}, {4, 0, 1}, {3, 0, 2}, {1, 0, 0}, {2, 0, -1}, {3, 0, 0}});
  BOOST_CHECK(revolve(smoother, smoother) == Edge_defect::none);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(decisions_on_doubles_are_exact, Traits, Double_kernels) {
  // the crease in the direction of w is of one unit in the last place of 0.1
  typedef GC::Bezier_curve<Traits> C;
  typedef typename Traits::Point P;
  const double x = 0.1, next = std::nextafter(x, 1.0);
  const C left{P(0, 0, 0), P(x, 1, x), P(2 * x, 2, 2 * x)}, right{P(2 * x, 2, 2 * x), P(4 * x, 4, 4 * x)},
      kink{P(2 * x, 2, 2 * x), P(4 * x, 4, 4 * next)};
  const typename Traits::Vector z(0, 0, 1), y(0, 1, 0);
  const P a(-1, 0, 0);
  BOOST_CHECK_EQUAL(extrusion_continuity(left, right, y).g_order, 2);
  BOOST_CHECK(extrusion_continuity(left, kink, y).defect == Edge_defect::crease);
  BOOST_CHECK_EQUAL(extrusion_continuity(left, kink, z).g_order, 2);
  BOOST_CHECK_EQUAL(revolution_continuity(left, right, a, z).g_order, 2);
  BOOST_CHECK(revolution_continuity(left, kink, a, z).defect == Edge_defect::crease);
  // the tip of a cone at t = 1/3, from numbers that are not dyadic in decimal
  const auto d = sweep_defects(GC::Revolution_surface_3<C>(C{P(x, 0, 0), P(-2 * x, 0, 1)}, P(0, 0, 0), z));
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(d.points[0].begin == Q(Q(1) / Q(3)) && d.points[0].end == d.points[0].begin);
}

BOOST_AUTO_TEST_CASE(other_profiles_join) {
  // a user's quarter of a circle goes on in the tangent at its top: only G1
  const Curve line{Point(2, 0, 1), Point(1, 0, 1), Point(-1, 0, 1)};
  const auto edge = revolution_continuity(Quarter_circle(), line, Point(0, 0, 0), Vector(0, 0, 1));
  BOOST_CHECK(edge.g_order == 1 && edge.defect == Edge_defect::curvature);
  // with the curvature 1 towards the centre it is G2: d1 = (-1, 0, 0), d2 = (0, 0, -1)
  const Curve bent = curve_from(vec(2, 0, 1), vec(-1, 0, 0), vec(0, 0, -1));
  BOOST_CHECK_EQUAL(revolution_continuity(Quarter_circle(), bent, Point(0, 0, 0), Vector(0, 0, 1)).g_order, 2);
  BOOST_CHECK_EQUAL(extrusion_continuity(Quarter_circle(), bent, Vector(0, 1, 0)).g_order, 2);
  // a B-spline of degree 3 with a double knot is C1 there; its pieces, and the curve as a whole,
  // swept
  const std::vector<Point> points{Point(2, 0, 0), Point(3, 0, 1), Point(2, 0, 3),
                                  Point(4, 0, 4), Point(1, 0, 6), Point(2, 0, 7)};
  typedef GC::Knot_vector<Q>::Knot Knot;
  const GC::Bspline_curve<Exact> spline(points.begin(), points.end(),
                                        GC::Knot_vector<Q>(3, Q(0), Q(2), std::vector<Knot>{{Q(1), 2}}));
  const auto pieces = spline.bezier_pieces();
  BOOST_CHECK_EQUAL(revolution_continuity(pieces[0], pieces[1], Point(0, 0, 0), Vector(0, 0, 1)).g_order, 1);
  const Curve more = curve_from(column(points[5]), spline.end_jet(2)[1], spline.end_jet(2)[2]);
  BOOST_CHECK_EQUAL(revolution_continuity(spline, more, Point(0, 0, 0), Vector(0, 0, 1)).g_order, 2);
  const GC::Composite_bezier_curve<Exact> segmented(pieces.begin(), pieces.end());
  BOOST_CHECK_EQUAL(extrusion_continuity(segmented, more, Vector(0, 1, 0)).g_order, 2);
}
