// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Swept surfaces: their jets and normals.

#include "support/archetype.h"
#include "support/swept_surfaces.h"

#include <CGAL/Geometric_continuity/edges/swept_continuity.h>

BOOST_AUTO_TEST_CASE(extrusion_is_linear) {
  Random random;
  for (int run = 0; run < 10; ++run) {
    const Curve c = random.curve(3);
    const Vector w = random.vector();
    const Extrusion s(c, w);
    const Q u = random.rational(), v = random.rational();
    BOOST_CHECK(s(u, v) == c(u) + v * w);
    const GC::Surface_jet<Exact> jet = s.jet(u, v, 3);
    for (int i = 0; i <= 3; ++i)
      for (int j = 0; i + j <= 3; ++j)
        if (i + j > 0) {
          const Column expected = j == 0 ? c.jet(u, 3)[i] : i == 0 && j == 1 ? column(w) : vec(0, 0, 0);
          BOOST_CHECK(jet(i, j) == expected);
        }
    const Vector n = s.normal(u, v);
    BOOST_CHECK(n == CGAL::cross_product(c.jet(u, 1).derivative(1), w));
    BOOST_CHECK(n * jet.partial(1, 0) == 0 && n * jet.partial(0, 1) == 0);
    // the same as a patch
    const GC::Bezier_patch<Exact> patch = bezier_patch(Extrusion(c, w, {Q(-2), Q(5)}));
    BOOST_CHECK(patch(u, v) == s(u, v) && patch.normal(u, v) == n);
    BOOST_CHECK(patch.domain_u() == c.domain() && patch.domain_v() == std::make_pair(Q(-2), Q(5)));
  }
}

BOOST_AUTO_TEST_CASE(revolution_of_a_point_is_the_known_circle) {
  // (1 - v^2) / (1 + v^2) = 1 - 2v^2 + 2v^4 - ..., 2v / (1 + v^2) = 2v - 2v^3 + 2v^5 - ...
  const Revolution s(Curve{Point(1, 0, 0)}, Point(0, 0, 0), Vector(0, 0, 1));
  const GC::Surface_jet<Exact> jet = s.jet(Q(0), Q(0), 5);
  const std::array<Column, 6> expected = {vec(1, 0, 0),   vec(0, 2, 0),  vec(-4, 0, 0),
                                          vec(0, -12, 0), vec(48, 0, 0), vec(0, 240, 0)};
  for (int j = 0; j <= 5; ++j) BOOST_CHECK(jet(0, j) == expected[j]);
  for (int j = 0; j < 5; ++j) BOOST_CHECK(is_zero(jet(1, j)));
  BOOST_CHECK(s(Q(0), Q(1)) == Point(0, 1, 0));
  BOOST_CHECK(s(Q(0), Q(Q(1) / Q(2))) == Point(Q(Q(3) / Q(5)), Q(Q(4) / Q(5)), 0));
}

BOOST_AUTO_TEST_CASE(revolution_keeps_height_and_distance) {
  Random random;
  for (int run = 0; run < 10; ++run) {
    const int k = 5;
    const Curve c = random.curve(3);
    const Point a = random.point();
    const Vector axis = random.vector();
    const Revolution s(c, a, axis);
    const Column w = column(axis);
    const Q W = dot(w, w), u = random.rational(), v = random.rational(), D = Q(Q(1) + v * v * W);
    GC::Surface_jet<Exact> jet = s.jet(u, v, k);
    const GC::Curve_jet<Exact> profile = c.jet(u, k);
    const Column x = profile[0] - column(a);
    jet(0, 0) -= column(a);
    // all derivatives of the height w.S and of |S - a|^2 in v vanish; in u they are those of the
    // profile
    for (int i = 0; i <= k; ++i)
      for (int j = 0; i + j <= k; ++j) {
        BOOST_CHECK(dot(w, jet(i, j)) == (j > 0 ? Q(0) : dot(w, i == 0 ? x : profile[i])));
        Q square(0), expected(0);
        for (int p = 0; p <= i; ++p)
          for (int q = 0; q <= j; ++q) square += binomial(i, p) * binomial(j, q) * dot(jet(p, q), jet(i - p, j - q));
        if (j == 0)
          for (int p = 0; p <= i; ++p)
            expected += binomial(i, p) * dot(p == 0 ? x : profile[p], p == i ? x : profile[i - p]);
        BOOST_CHECK(square == expected);
      }
    // (1 + v^2 W) S_v = 2 w x (S - a), in the positive direction
    BOOST_CHECK(D * jet(0, 1) == Q(2) * cross_product(w, jet(0, 0)));
    // two rotations one after the other: their quaternions are multiplied
    const Q v2 = random.rational(), both = Q((v + v2) / (Q(1) - v * v2 * W));
    const Curve turned{s(u, v)};
    BOOST_CHECK(Revolution(turned, a, axis)(Q(0), v2) == s(u, both));
  }
}

BOOST_AUTO_TEST_CASE(normals_of_revolution) {
  Random random;
  for (int run = 0; run < 10; ++run) {
    const Curve c = random.curve(4);
    const Point a = random.point();
    const Vector w = random.vector();
    const Revolution s(c, a, w);
    const Q u = random.rational(), v = random.rational(), factor = Q(Q(2) / (Q(1) + v * v * (w * w)));
    const GC::Surface_jet<Exact> jet = s.jet(u, v, 1);
    const Vector n = s.normal(u, v), at_0 = s.normal(u, Q(0));
    BOOST_CHECK(n * jet.partial(1, 0) == 0 && n * jet.partial(0, 1) == 0);
    BOOST_CHECK(GC::normal(jet) == factor * n);
    BOOST_CHECK(jet.partial(0, 1) == factor * s.angular_derivative(u, v));
    BOOST_CHECK(at_0 == CGAL::cross_product(c.jet(u, 1).derivative(1), CGAL::cross_product(w, c(u) - a)));
    // it turns with the profile
    BOOST_CHECK(Revolution(Curve{a + at_0}, a, w)(Q(0), v) == a + n);
    // neither another point on the axis nor the length of the axis matters, but for the scale
    const Q scale = random.positive();
    const Revolution same(c, a + random.rational() * w, scale * w);
    BOOST_CHECK(same(u, Q(v / scale)) == s(u, v));
    BOOST_CHECK(same.normal(u, Q(v / scale)) == scale * n);
  }
}

BOOST_AUTO_TEST_CASE(complement_closes_the_turn) {
  Random random;
  for (int run = 0; run < 5; ++run) {
    const Curve c = random.curve(2);
    const Point a = random.point();
    const Vector w = random.vector();
    const Revolution s(c, a, w, {Q(-random.positive()), random.positive()}), rest = s.complement();
    const Q u = random.rational();
    BOOST_CHECK(rest(u, rest.domain_v().first) == s(u, s.domain_v().second));
    BOOST_CHECK(rest(u, rest.domain_v().second) == s(u, s.domain_v().first));
    BOOST_CHECK(rest.normal(u, rest.domain_v().first) == s.normal(u, s.domain_v().second));
    const Vector middle = CGAL::midpoint(s(u, Q(0)), rest(u, Q(0))) - a;
    BOOST_CHECK(CGAL::cross_product(w, middle) == CGAL::NULL_VECTOR); // opposite points
    const Revolution again = rest.complement();
    BOOST_CHECK(again.domain_v() == s.domain_v() && !again.opposite() && rest.opposite());
    BOOST_CHECK(again(u, Q(1)) == s(u, Q(1)));
  }
  const Curve c{Point(1, 0, 0)};
  CHECK_ERROR(Revolution(c, Point(0, 0, 0), Vector(0, 0, 1), {Q(0), Q(1)}).complement(), parameter_outside_domain);
  CHECK_ERROR(Revolution(c, Point(0, 0, 0), Vector(0, 0, 1), {Q(-1), Q(0)}).complement(), parameter_outside_domain);
}

// Other number types do the same operations. With double every intermediate number below is dyadic
// and small: W = 1, v = 1.
BOOST_AUTO_TEST_CASE_TEMPLATE(other_kernels, Traits, Other_kernels) {
  typedef GC::Bezier_curve<Traits> C;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point P;
  typedef typename Traits::Vector V;
  const auto rows = {std::array<int, 3>{1, 2, 0}, std::array<int, 3>{4, -3, 5}, std::array<int, 3>{2, 8, 1}};
  const C c = int_curve<Traits>(rows);
  const Curve d = int_curve<Exact>(rows);
  for (int v : {-1, 0, 1}) {
    const GC::Revolution_surface_3<C> s(c, P(3, 1, -2), V(0, 1, 0));
    const Revolution t(d, Point(3, 1, -2), Vector(0, 1, 0));
    const GC::Surface_jet<Traits> x = s.jet(FT(0.25), FT(v), 3);
    const GC::Surface_jet<Exact> y = t.jet(Q(0.25), Q(v), 3);
    for (int i = 0; i <= 3; ++i)
      for (int j = 0; i + j <= 3; ++j)
        for (int k = 0; k < 3; ++k) BOOST_CHECK(x(i, j)[k] == FT(CGAL::to_double(y(i, j)[k])));
    BOOST_CHECK(column<Exact>(t.normal(Q(0.25), Q(v)))[1] == Q(CGAL::to_double(s.normal(FT(0.25), FT(v)).y())));
    BOOST_CHECK(s.complement().domain_v().first == FT(-1));
    const GC::Extrusion_surface_3<C> e(c, V(1, -2, 3));
    const Extrusion f(d, Vector(1, -2, 3));
    BOOST_CHECK(e(FT(0.5), FT(v)).y() == FT(CGAL::to_double(f(Q(0.5), Q(v)).y())));
    BOOST_CHECK(e.normal(FT(0.5), FT(v)).z() == FT(CGAL::to_double(f.normal(Q(0.5), Q(v)).z())));
  }
}

BOOST_AUTO_TEST_CASE(rounding_stays_small) {
  Random random;
  for (int run = 0; run < 20; ++run) {
    const auto number = [&] { return random.integer(-8000, 8000) / 1000.0; };
    std::vector<Double::Point> p;
    std::vector<Point> q;
    for (int i = 0; i < 4; ++i) {
      p.push_back({number(), number(), number()});
      q.emplace_back(p[i].x(), p[i].y(), p[i].z());
    }
    const Double::Vector w{number(), number(), 1 + std::abs(number())};
    const double u = random.integer(0, 1000) / 1000.0, v = number();
    const GC::Revolution_surface_3<GC::Bezier_curve<Double>> s(GC::Bezier_curve<Double>(p.begin(), p.end()), p[0], w);
    const Revolution t(Curve(q.begin(), q.end()), q[0], Vector(w.x(), w.y(), w.z()));
    // |x| <= 28, |w| <= 15: the terms of the rotation are at most 2|x|, of w x (w x x) with its
    // factor as well; the jet takes fewer than 100 roundings of numbers below 28 * 15 * 15 * 2 /
    // W <= 2^14
    for (int k = 0; k < 3; ++k)
      BOOST_CHECK_SMALL(CGAL::to_double(Q(Q(s(u, v)[k]) - t(Q(u), Q(v))[k])), 100 * 0x1p-53 * 0x1p14);
  }
}

BOOST_AUTO_TEST_CASE(every_profile_curve) {
  const Point a(0, 0, 0);
  const Vector w(0, 0, 1);
  // a B-spline, and the same curve segmented
  const std::vector<Point> points{Point(1, 0, 0), Point(3, 1, 1), Point(2, 5, 2), Point(4, 0, 3), Point(1, 1, 5)};
  typedef GC::Knot_vector<Q>::Knot Knot;
  const GC::Bspline_curve<Exact> spline(points.begin(), points.end(),
                                        GC::Knot_vector<Q>(3, Q(0), Q(2), std::vector<Knot>{{Q(1), 1}}));
  const auto pieces = spline.bezier_pieces();
  const GC::Composite_bezier_curve<Exact> segmented(pieces.begin(), pieces.end());
  const GC::Revolution_surface_3<GC::Bspline_curve<Exact>> s(spline, a, w);
  const GC::Revolution_surface_3<GC::Composite_bezier_curve<Exact>> t(segmented, a, w);
  BOOST_CHECK(s.domain_u() == std::make_pair(Q(0), Q(2)));
  for (int i = 0; i <= 4; ++i) {
    const Q u = Q(Q(i) / Q(2)), v = Q(Q(i - 2) / Q(3));
    BOOST_CHECK(s(u, v) == t(u, v) && s.normal(u, v) == t.normal(u, v));
    BOOST_CHECK(s(u, v) == Revolution(pieces[i / 2 == 2 ? 1 : i / 2], a, w)(u, v));
  }
  CHECK_ERROR(s(Q(3), Q(0)), parameter_outside_domain); // what the profile throws

  // a user's circle makes a torus: (|S|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), and its unit normal
  // points away from the circle in the middle
  const GC::Revolution_surface_3<Quarter_circle> torus(Quarter_circle(), a, w);
  for (int i = 0; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      const Point p = torus(Q(Q(i) / Q(3)), Q(j));
      const Q rr = Q(p.x() * p.x() + p.y() * p.y()), sum = Q(rr + p.z() * p.z() + Q(3));
      BOOST_CHECK(Q(sum * sum) == Q(Q(16) * rr));
      const Vector n = torus.normal(Q(Q(i) / Q(3)), Q(j));
      const Q radius = Q((sum) / Q(4)); // the distance from the axis, rational on this circle
      const Vector outwards(Q(p.x() * (Q(1) - Q(2) / radius)), Q(p.y() * (Q(1) - Q(2) / radius)), p.z());
      BOOST_CHECK(CGAL::cross_product(n, outwards) == CGAL::NULL_VECTOR && n * outwards < 0);
    }

  // in a traits class whose dimension is known at run time
  typedef Exact_d::Point Point_d;
  const std::vector<Point_d> in_space{Point_d(1, 2, 3, 1), Point_d(4, 5, 6, 1)},
      planar{Point_d(1, 2, 1), Point_d(3, 4, 1)};
  const GC::Bezier_curve<Exact_d> c(in_space.begin(), in_space.end()), flat(planar.begin(), planar.end());
  const Exact_d::Vector z(0, 0, 1, 1);
  const GC::Revolution_surface_3<GC::Bezier_curve<Exact_d>> sd(c, Point_d(0, 0, 0, 1), z);
  BOOST_CHECK(sd(Q(0), Q(1)) == Point_d(-2, 1, 3, 1));
  CHECK_ERROR((GC::Revolution_surface_3<GC::Bezier_curve<Exact_d>>(c, planar[0], z)), dimension_mismatch);
  CHECK_ERROR((GC::Revolution_surface_3<GC::Bezier_curve<Exact_d>>(flat, in_space[0], z).jet(Q(0), Q(0), 1)),
              dimension_mismatch);
  CHECK_ERROR(sweep_defects(GC::Extrusion_surface_3<GC::Bezier_curve<Exact_d>>(flat, z)), dimension_mismatch);
  CHECK_ERROR(bezier_patch(GC::Extrusion_surface_3<GC::Bezier_curve<Exact_d>>(flat, z)), dimension_mismatch);
  CHECK_ERROR(extrusion_continuity(flat, flat, z), dimension_mismatch);
  BOOST_CHECK_EQUAL(extrusion_continuity(c, c.reverse(), z).g_order, 0);
}

// Numbers, points and vectors that offer what the concept asks for, and nothing more.
BOOST_AUTO_TEST_CASE(archetype_of_the_concept) {
  typedef archetype::Traits<CGAL::Dimension_tag<3>> Traits;
  typedef archetype::Number Number;
  typedef GC::Bezier_curve<Traits> C;
  const auto make = [](auto construct, int x, int y, int z) {
    const std::array<Number, 3> c{Number(x), Number(y), Number(z)};
    return construct(3, c.begin(), c.end());
  };
  const auto point = [&](int x, int y, int z) { return make(Traits().construct_point_object(), x, y, z); };
  const C c{point(1, 0, 0), point(-1, 0, 2)};
  const Traits::Vector w = make(Traits().construct_vector_object(), 0, 0, 1);
  const GC::Revolution_surface_3<C> s(c, point(0, 0, 0), w);
  const GC::Extrusion_surface_3<C> e(c, w);
  const auto x = GC::coordinates<Traits>(s.complement()(Number(0), Number(1)));
  BOOST_CHECK(x[0] == Number(0) && x[1] == Number(-1) && x[2] == Number(0));
  BOOST_CHECK(GC::coordinates<Traits>(s.normal(Number(0), Number(1)))[2] == Number(-2));
  BOOST_CHECK(GC::coordinates<Traits>(e.normal(Number(0), Number(1)))[1] == Number(2));
  BOOST_CHECK(sweep_defects(s).points.size() == 1 && sweep_defects(e).points.empty());
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::mixed);
  BOOST_CHECK(revolution_continuity(c, c.reverse(), point(0, 0, 0), w).defect == Edge_defect::fold);
  BOOST_CHECK(extrusion_continuity(c, c.reverse(), w).defect == Edge_defect::fold);
}

BOOST_AUTO_TEST_CASE(bad_input) {
  const Curve c{Point(1, 0, 0), Point(2, 0, 1)};
  const Point a(0, 0, 0);
  const Vector zero(0, 0, 0), z(0, 0, 1);
  CHECK_ERROR(Extrusion(c, zero), zero_direction);
  CHECK_ERROR(Revolution(c, a, zero), zero_direction);
  CHECK_ERROR(extrusion_continuity(c, c, zero), zero_direction);
  CHECK_ERROR(revolution_continuity(c, c, a, zero), zero_direction);
  CHECK_ERROR(Extrusion(c, z, {Q(1), Q(1)}), empty_domain);
  CHECK_ERROR(Revolution(c, a, z, {Q(1), Q(-1)}), empty_domain);
  CHECK_ERROR(Revolution(c, a, z).jet(Q(0), Q(0), -1), jet_order_too_low);
  CHECK_ERROR(Extrusion(c, z).jet(Q(0), Q(0), -1), jet_order_too_low);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const GC::Bezier_curve<Double> d = int_curve<Double>({{1, 0, 0}, {2, 0, 1}});
  typedef GC::Revolution_surface_3<GC::Bezier_curve<Double>> Rounded;
  CHECK_ERROR(Rounded(d, Double::Point(0, nan, 0), Double::Vector(0, 0, 1)), not_finite);
  CHECK_ERROR(Rounded(d, Double::Point(0, 0, 0), Double::Vector(0, 0, infinity)), not_finite);
  CHECK_ERROR(Rounded(d, Double::Point(0, 0, 0), Double::Vector(0, 0, 1), {0, infinity}), not_finite);
  CHECK_ERROR(GC::Extrusion_surface_3<GC::Bezier_curve<Double>>(d, Double::Vector(0, nan, 1)), not_finite);
  CHECK_ERROR(revolution_continuity(d, d, Double::Point(0, nan, 0), Double::Vector(0, 0, 1)), not_finite);
  CHECK_ERROR(Rounded(d, Double::Point(0, 0, 0), Double::Vector(0, 0, 1))(0.5, 1e200), not_finite);
  CHECK_ERROR(Rounded(d, Double::Point(0, 0, 0), Double::Vector(0, 0, 1e200))(0.5, 0), not_finite);
  CHECK_ERROR(Rounded(d, Double::Point(0, 0, 0), Double::Vector(0, 0, 1e-200)).complement(), not_finite);
  BOOST_CHECK_EQUAL(GC::to_string(GC::Error_code::zero_direction), "zero_direction");
}
