// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Swept surfaces: their jets and normals, where their normals vanish, and how smoothly they join. The roots of polynomials.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE swept
#include <boost/test/unit_test.hpp>

#include "support/archetype.h"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/edges/sweep_defects.h>
#include <CGAL/Geometric_continuity/edges/swept_continuity.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double;
typedef GC::Traits_3<CGAL::Epick> Epick;
typedef GC::Traits_3<CGAL::Epeck> Epeck;
typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Exact_d;
typedef std::tuple<Double, Epick, Epeck> Other_kernels;
typedef std::tuple<Exact, Double, Epeck> Deciding_kernels;
typedef std::tuple<Exact, Epick, Epeck, Double> All_kernels;
typedef std::tuple<Epick, Double> Double_kernels;
typedef GC::Coordinate_vector<Q, 3> Column;
typedef GC::Bezier_curve<Exact> Curve;
typedef GC::Revolution_surface_3<Curve> Revolution;
typedef GC::Extrusion_surface_3<Curve> Extrusion;
typedef Exact::Point Point;
typedef Exact::Vector Vector;
using GC::Edge_defect;
using GC::Sign_pattern;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

namespace {

class Random {
  std::mt19937 engine_;

public:
  Random() {
    const char* text = std::getenv("GEOMETRIC_CONTINUITY_SEED");
    const unsigned seed = text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 2026;
    BOOST_TEST_MESSAGE("seed " << seed);
    engine_.seed(seed);
  }
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  Q rational() { return Q(Q(integer(-999999, 999999)) / Q(integer(1, 999999))); }
  Q positive() { return Q(Q(integer(1, 99999)) / Q(integer(1, 99999))); }
  Column column() {
    Column x(3);
    for (int i = 0; i < 3; ++i) x[i] = rational();
    return x;
  }
  Point point() { return GC::to_point<Exact>(column()); }
  Vector vector() { return GC::to_vector<Exact>(column()); }
  Curve curve(int degree) {
    std::vector<Point> points;
    for (int i = 0; i <= degree; ++i) points.push_back(point());
    const Q a = rational();
    return Curve(points.begin(), points.end(), a, Q(a + positive()));
  }
};

template <class Traits, class P> Column column(const P& p) { return GC::coordinates<Traits, Q>(p); }
Column column(const Point& p) { return column<Exact>(p); }
Column column(const Vector& v) { return column<Exact>(v); }
Column vec(int x, int y, int z) {
  Column c(3);
  c[0] = Q(x), c[1] = Q(y), c[2] = Q(z);
  return c;
}

// The curve on [0, 1] with a given 2-jet at its start, or at its end.
Curve curve_from(const Column& x, const Column& d1, const Column& d2, bool at_end = false) {
  const Q s = at_end ? Q(-1) : Q(1);
  const Column b1 = x + Q(s / Q(2)) * d1, b2 = Q(2) * b1 - x + Q(Q(1) / Q(2)) * d2;
  std::vector<Point> p;
  for (const Column& b : {x, b1, b2}) p.push_back(GC::to_point<Exact>(b));
  const Curve c(p.begin(), p.end());
  return at_end ? c.reverse() : c;
}

template <class Traits> GC::Bezier_curve<Traits> int_curve(std::initializer_list<std::array<int, 3>> rows) {
  std::vector<typename Traits::Point> p;
  for (const std::array<int, 3>& x : rows) p.emplace_back(x[0], x[1], x[2]);
  return GC::Bezier_curve<Traits>(p.begin(), p.end());
}

Q binomial(int n, int k) { return GC::binomial_coefficients<Q>(n)[k]; }

// A user's curve: the quarter of the unit circle in the plane y = 0 about (2, 0, 0), by a rational parameter in [0, 1].
struct Quarter_circle {
  typedef Exact Traits;
  std::pair<Q, Q> domain() const { return {Q(0), Q(1)}; }
  GC::Curve_jet<Exact> jet(const Q& u, int k) const {
    // cos + i sin = (1 + iu) / (1 - iu) = 2w - 1 with w = 1 / (1 - iu), of which each derivative is a power
    const Q D = Q(Q(1) + u * u), x = Q(Q(1) / D), y = Q(u / D);
    Q re = Q(Q(2) * x), im = Q(Q(2) * y); // of 2 j! i^j w^(j+1)
    GC::Curve_jet<Exact> jet(3, k);
    for (int j = 0; j <= k; ++j) {
      jet[j][0] = Q(re + (j == 0 ? Q(1) : Q(0))); // 2 + cosine
      jet[j][2] = im;
      const Q before = re;
      re = Q(Q(-(j + 1)) * (re * y + im * x));
      im = Q(Q(j + 1) * (before * x - im * y));
    }
    return jet;
  }
};

} // namespace

// ---------------------------------------------------------------- roots

namespace {

typedef GC::Bernstein_polynomial<Q> Polynomial;
Polynomial factor(const Q& root) { return Polynomial{Q(-root), Q(Q(1) - root)}; } // t - root
typedef std::vector<GC::Isolated_root<Q>> Roots;

bool is(const GC::Isolated_root<Q>& r, const Q& x, int multiplicity) {
  return r.begin == x && r.end == x && r.multiplicity == multiplicity;
}
bool holds(const GC::Isolated_root<Q>& r, const Q& x, int multiplicity, const Q& width = Q(Q(1) / Q(1024))) {
  return r.begin < x && x < r.end && Q(r.end - r.begin) <= width && r.multiplicity == multiplicity;
}

} // namespace

BOOST_AUTO_TEST_CASE(roots_of_products_of_linear_factors) {
  const Q third = Q(Q(1) / Q(3)), half = Q(Q(1) / Q(2)), near = Q(half + Q(1) / Q(100000));
  Roots r = isolate_roots(factor(third));
  BOOST_REQUIRE_EQUAL(r.size(), 1u);
  BOOST_CHECK(is(r[0], third, 1)); // linear: exact
  r = isolate_roots(factor(third) * factor(third) * factor(third));
  BOOST_REQUIRE_EQUAL(r.size(), 1u);
  BOOST_CHECK(is(r[0], third, 3));
  r = isolate_roots(factor(Q(0)) * factor(third) * factor(Q(1)) * factor(Q(1)));
  BOOST_REQUIRE_EQUAL(r.size(), 3u);
  BOOST_CHECK(is(r[0], Q(0), 1) && is(r[1], third, 1) && is(r[2], Q(1), 2));
  // bisection meets 1/2; the intervals of its neighbours must not end there
  r = isolate_roots(factor(third) * factor(half) * factor(half) * factor(near) * factor(near) * factor(near));
  BOOST_REQUIRE_EQUAL(r.size(), 3u);
  BOOST_CHECK(is(r[1], half, 2));
  BOOST_CHECK(r[0].begin < third && third < r[0].end && r[0].multiplicity == 1);
  BOOST_CHECK(half < r[2].begin && r[2].begin <= near && near <= r[2].end && r[2].multiplicity == 3);
  // none inside: outside, complex, constant, zero
  BOOST_CHECK(isolate_roots(factor(Q(2)) * factor(Q(-1))).empty());
  BOOST_CHECK(isolate_roots(factor(half) * factor(half) + Polynomial{Q(Q(1) / Q(1000000))}).empty());
  BOOST_CHECK(isolate_roots(Polynomial{Q(5)}).empty());
  BOOST_CHECK(isolate_roots(Polynomial{Q(0), Q(0), Q(0)}).empty());
  CHECK_ERROR(isolate_roots(factor(half), Q(0)), empty_domain);
}

BOOST_AUTO_TEST_CASE(roots_of_random_products) {
  Random random;
  for (int run = 0; run < 20; ++run) {
    std::vector<std::pair<Q, int>> expected;
    Polynomial p{Q(random.positive())};
    for (int i = 1; i <= 4; ++i) { // roots in (i/5, (i+1)/5), one of them outside
      const Q x = Q((Q(i + (i == 4 ? 1 : 0)) + Q(random.integer(1, 9998)) / Q(9999)) / Q(5));
      const int multiplicity = random.integer(1, 3);
      for (int k = 0; k < multiplicity; ++k) p = p * factor(x);
      if (i < 4) expected.push_back({x, multiplicity});
    }
    const Q width = Q(Q(1) / Q(1 << 20));
    const Roots r = isolate_roots(p, width);
    BOOST_REQUIRE_EQUAL(r.size(), expected.size());
    for (std::size_t i = 0; i < r.size(); ++i)
      BOOST_CHECK(holds(r[i], expected[i].first, expected[i].second, width) ||
                  is(r[i], expected[i].first, expected[i].second));
  }
}

BOOST_AUTO_TEST_CASE(roots_with_double_coefficients) {
  // t^2 - 1/2 with coefficients that doubles represent; the root is irrational
  const Roots r = isolate_roots(GC::Bernstein_polynomial<double>{-0.5, -0.5, 0.5});
  BOOST_REQUIRE_EQUAL(r.size(), 1u);
  BOOST_CHECK(Q(r[0].begin * r[0].begin) < Q(0.5) && Q(0.5) < Q(r[0].end * r[0].end));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_ERROR(isolate_roots(GC::Bernstein_polynomial<double>{-1., infinity}), not_finite);
}

// ---------------------------------------------------------------- jets

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
    // all derivatives of the height w.S and of |S - a|^2 in v vanish; in u they are those of the profile
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

// Other number types do the same operations. With double every intermediate number below is dyadic and small: W = 1, v = 1.
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
      p.emplace_back(number(), number(), number());
      q.emplace_back(p[i].x(), p[i].y(), p[i].z());
    }
    const Double::Vector w(number(), number(), 1 + std::abs(number()));
    const double u = random.integer(0, 1000) / 1000.0, v = number();
    const GC::Revolution_surface_3<GC::Bezier_curve<Double>> s(GC::Bezier_curve<Double>(p.begin(), p.end()), p[0], w);
    const Revolution t(Curve(q.begin(), q.end()), q[0], Vector(w.x(), w.y(), w.z()));
    // |x| <= 28, |w| <= 15: the terms of the rotation are at most 2|x|, of w x (w x x) with its factor as well; the jet
    // takes fewer than 100 roundings of numbers below 28 * 15 * 15 * 2 / W <= 2^14
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

  // a user's circle makes a torus: (|S|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), and its unit normal points away from the
  // circle in the middle
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
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
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

// ---------------------------------------------------------------- where the normal vanishes

namespace {

template <class FT> bool is_at(const GC::Sweep_defect<FT>& p, const FT& begin, const FT& end) {
  return p.begin == begin && p.end == end;
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(defects_of_revolution, Traits, Deciding_kernels) {
  typedef GC::Bezier_curve<Traits> C;
  typedef GC::Edge_field<Traits> Field;
  const typename Traits::Point a(0, 0, 0);
  const typename Traits::Vector w(0, 0, 2);
  const auto revolve = [&](std::initializer_list<std::array<int, 3>> rows) {
    return GC::Revolution_surface_3<C>(int_curve<Traits>(rows), a, w);
  };
  const Field third = Field(Field(1) / Field(3)), half = Field(Field(1) / Field(2));

  // a cone through its tip, in the plane x = y: r = 1 - 3t
  auto s = revolve({{1, 1, 0}, {-2, -2, 5}});
  auto d = sweep_defects(s);
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], third, third) && d.points[0].on_axis && !d.points[0].zero_tangent &&
              !d.points[0].smooth_pole && d.points[0].multiplicity == 1 && d.points[0].normal_flips && !d.degenerate);
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::mixed);
  BOOST_CHECK((*signed_radius(s))(third) == Field(0));
  // on either side of the tip the normal is opposite
  if constexpr (std::is_same_v<Traits, Exact>) BOOST_CHECK(s.normal(Q(0), Q(1)) * s.normal(Q(1), Q(1)) < 0);

  // the tip at the end: nothing flips
  d = sweep_defects(revolve({{3, 0, 0}, {0, 0, 5}}));
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], Field(1), Field(1)) && d.points[0].on_axis && !d.points[0].normal_flips);

  // ends on the axis at a right angle, in a plane and not; a disc
  for (const auto& dome : {revolve({{3, 0, 0}, {3, 0, 3}, {0, 0, 3}}), revolve({{1, 2, 0}, {1, 1, 3}, {0, 0, 3}}),
                           revolve({{1, 0, 3}, {0, 0, 3}})}) {
    d = sweep_defects(dome);
    BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
    BOOST_CHECK(is_at(d.points[0], Field(1), Field(1)) && d.points[0].on_axis && d.points[0].smooth_pole);
  }
  d = sweep_defects(revolve({{3, 0, 0}, {0, 0, 3}, {0, 0, 3}})); // on the axis without a tangent
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(d.points[0].on_axis && d.points[0].zero_tangent && !d.points[0].smooth_pole);

  // a vase, no defect
  s = revolve({{2, 0, 0}, {5, 0, 1}, {1, 0, 3}, {2, 0, 4}});
  d = sweep_defects(s);
  BOOST_CHECK(!d.degenerate && d.points.empty());
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::positive);

  // r = (1 - 2t)^2 touches the axis: r' vanishes there, c' does not, and the normal keeps its side
  s = revolve({{0, 1, 0}, {0, -1, 1}, {0, 1, 2}});
  d = sweep_defects(s);
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], half, half) && d.points[0].on_axis && d.points[0].multiplicity == 2 &&
              !d.points[0].normal_flips);
  BOOST_CHECK(sign_pattern(*signed_radius(s)) == Sign_pattern::nonnegative);

  // a skew line through the axis at its middle is no line in a plane through it, unless it meets it: here it does
  d = sweep_defects(revolve({{1, 2, 0}, {-1, -2, 3}}));
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], half, half));
  // a skew line makes a hyperboloid: no defect, no signed radius
  s = revolve({{1, 2, 0}, {1, -2, 3}});
  BOOST_CHECK(sweep_defects(s).points.empty() && !signed_radius(s));

  // a profile that is not planar and crosses the axis: x = 1 - 2t, y = (1 - 2t)^2
  s = revolve({{1, 1, 0}, {0, -1, 1}, {-1, 1, 2}});
  d = sweep_defects(s);
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], half, half) && d.points[0].on_axis && d.points[0].normal_flips);
  BOOST_CHECK(!signed_radius(s));

  // tangent to a parallel: z = (1 - 2t)^2, (x, y) runs along (1, 1 - 2t)
  d = sweep_defects(revolve({{1, 1, 1}, {1, 0, -1}, {1, -1, 1}}));
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], half, half) && !d.points[0].on_axis && !d.points[0].zero_tangent &&
              d.points[0].normal_flips);

  // a cusp off the axis, one on it
  d = sweep_defects(revolve({{2, 0, 0}, {3, 0, 4}, {2, 0, 0}}));
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], half, half) && !d.points[0].on_axis && d.points[0].zero_tangent &&
              d.points[0].normal_flips);
  d = sweep_defects(revolve({{1, 0, 1}, {-1, 0, -1}, {1, 0, 1}})); // (1 - 2t)^2 (1, 0, 1)
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(d.points[0].on_axis && d.points[0].zero_tangent && d.points[0].multiplicity == 3 &&
              d.points[0].normal_flips);

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
    return sweep_defects(GC::Extrusion_surface_3<C>(int_curve<Traits>(rows), typename Traits::Vector(0, 0, 3)));
  };
  const Field half = Field(Field(1) / Field(2));
  BOOST_CHECK(extrude({{0, 0, 0}, {1, 2, 3}, {4, 0, 0}}).points.empty());
  // x = (1 - 2t)^2: folds at 1/2, where c' = (0, 0, c) is parallel to w
  auto d = extrude({{1, 0, 0}, {-1, 0, 1}, {1, 0, 2}});
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(is_at(d.points[0], half, half) && !d.points[0].on_axis && !d.points[0].zero_tangent &&
              d.points[0].normal_flips);
  // x = (1 - 2t)^3: parallel to w, but no fold
  d = extrude({{1, 0, 0}, {-1, 0, 1}, {1, 0, 2}, {-1, 0, 3}});
  BOOST_REQUIRE_EQUAL(d.points.size(), 1u);
  BOOST_CHECK(d.points[0].multiplicity == 2 && !d.points[0].normal_flips);
  // both ends, and a zero tangent
  d = extrude({{1, 0, 0}, {1, 0, 1}, {2, 0, 5}, {2, 0, 5}});
  BOOST_REQUIRE_EQUAL(d.points.size(), 2u);
  BOOST_CHECK(is_at(d.points[0], Field(0), Field(0)) && !d.points[0].zero_tangent && !d.points[0].normal_flips);
  BOOST_CHECK(is_at(d.points[1], Field(1), Field(1)) && d.points[1].zero_tangent && !d.points[1].normal_flips);
  // nothing but defects: along w, a point
  BOOST_CHECK(extrude({{1, 1, 0}, {1, 1, 4}, {1, 1, 2}}).degenerate);
  BOOST_CHECK(extrude({{1, 1, 0}}).degenerate);
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

namespace {

// A right profile that continues the surface s, and not necessarily its profile: y(t) = s(u(t), v(t)), as far as the second
// derivative shows, plus `normal` times the normal.
Curve continued(const Revolution& s, Random& random, const Q& p, const Q& normal) {
  const GC::Surface_jet<Exact> j = s.jet(s.domain_u().second, Q(0), 2);
  const Q b = random.positive(), c = random.rational(), q = random.rational();
  const Column d1 = b * j(1, 0) + p * j(0, 1);
  const Column d2 = Q(b * b) * j(2, 0) + Q(Q(2) * b * p) * j(1, 1) + Q(p * p) * j(0, 2) + c * j(1, 0) + q * j(0, 1) +
                    normal * column(s.normal(s.domain_u().second, Q(0)));
  return curve_from(j(0, 0), d1, d2);
}

// The order that the meridian has: (r^2, h), which is a smooth map of the distance r > 0 and the height.
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

} // namespace

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
    const Curve right = curve_from(column(left.control_point(3)), random.column(), random.column());
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
    const Curve kink = curve_from(x[0], random.column(), random.column());
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
  BOOST_CHECK(revolve(c, r({{3, 0, 3}, {4, 0, 4}})) == Edge_defect::gap);  // another height
  BOOST_CHECK(revolve(c, r({{3, 1, 2}, {4, 0, 4}})) == Edge_defect::gap);  // another radius
  BOOST_CHECK(extrude(c, r({{3, 0, 2}, {4, 0, 3}})) == Edge_defect::none); // a straight line goes on
  BOOST_CHECK(revolve(c, r({{3, 0, 2}, {4, 0, 3}})) == Edge_defect::none);
  BOOST_CHECK(revolve(c, r({{0, -3, 2}, {0, -4, 3}})) == Edge_defect::none); // on the other side
  BOOST_CHECK(revolve(c, r({{-3, 0, 2}, {-4, 0, 3}})) == Edge_defect::none); // at the opposite point
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
  // a B-spline of degree 3 with a double knot is C1 there; its pieces, and the curve as a whole, swept
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
