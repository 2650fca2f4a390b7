// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rational patches and B-spline surfaces: what they evaluate, how they are cut and refined, and
// which weights they refuse.

#include "support/rational_surfaces.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>

BOOST_AUTO_TEST_SUITE(rational_surfaces)

// S of degree 1 x 1 by hand: ((1-u)(1-v) w00 b00 + ...) / (...).
template <class Traits> Patch<Traits> bilinear() {
  typedef typename Traits::Point P;
  typedef typename Traits::FT FT;
  return Patch<Traits>({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 1)}}, {{FT(1), FT(2)}, {FT(3), FT(2)}});
}

// Degree 2 x 2 with the weight w in the middle and 1 elsewhere.
template <class Traits> Patch<Traits> with_middle_weight(const typename Traits::FT& w) {
  typedef typename Traits::Point P;
  typedef typename Traits::FT FT;
  return Patch<Traits>(net_of(3, 3, [](int i, int j) { return P(i, j, i * j); }),
                       net_of(3, 3, [&](int i, int j) { return i == 1 && j == 1 ? w : FT(1); }));
}

int binomial(int n, int k) { return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k; }

// Returns whether S w = P holds for the derivatives up to the order k, by the product rule.
template <class Surface> bool is_quotient(const Surface& s, const Q& u, const Q& v, int k) {
  const auto x = s.jet(u, v, k);
  const auto p = s.homogeneous().jet(u, v, k);
  for (int i = 0; i <= k; ++i)
    for (int j = 0; i + j <= k; ++j)
      for (int c = 0; c < 3; ++c) {
        Q sum(0);
        for (int a = 0; a <= i; ++a)
          for (int b = 0; b <= j; ++b) sum += Q(binomial(i, a) * binomial(j, b)) * p(a, b)[3] * x(i - a, j - b)[c];
        if (sum != p(i, j)[c]) return false;
      }
  return true;
}

TEST_FOR_EACH(values_by_hand, Traits, All_traits) {
  typedef typename Traits::Point P;
  const Patch<Traits> s = bilinear<Traits>();
  const FT half = FT(FT(1) / FT(2));
  BOOST_CHECK(s(half, half) == P(FT(FT(5) / FT(8)), half, FT(FT(1) / FT(4))));
  BOOST_CHECK(s(FT(0), FT(0)) == P(0, 0, 0));
  // x = 3u/(1+2u) on v = 0, y = 2v/(1+v) on u = 0
  BOOST_CHECK(s.partial(FT(0), FT(0), 1, 0) == typename Traits::Vector(3, 0, 0));
  BOOST_CHECK(s.partial(FT(0), FT(0), 2, 0) == typename Traits::Vector(-12, 0, 0));
  BOOST_CHECK(s.partial(FT(0), FT(0), 0, 1) == typename Traits::Vector(0, 2, 0));
  BOOST_CHECK(s.normal(FT(0), FT(0)) == typename Traits::Vector(0, 0, 6));
  BOOST_CHECK(s.degree_u() == 1 && s.degree_v() == 1 && s.dimension() == 3);
  BOOST_CHECK(s.weight(1, 0) == FT(3) && s.weight(Patch_edge::u1, 0, 0) == FT(3) && s.weights().size() == 4);
  CHECK_ERROR(s.partial(FT(0), FT(0), -1, 0), negative_count);
  BOOST_CHECK_EQUAL(text(s),
                    "Rational Bezier patch of degree 1 x 1 on [0, 1] x [0, 1]:\n(0, 0, 0) (0, 1, 0)\n(1, 0, 0) "
                    "(1, 1, 1)\nweights:\n1 2\n3 2");
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_quotient) {
  Random random;
  for (int i = 0; i < 5; ++i) {
    const int p = random.integer(1, 3), q = random.integer(1, 3);
    const Patch<Exact> s = random_patch(random, p, q);
    const Q u = fraction(1, random.integer(2, 9)), v = fraction(1, random.integer(4, 99));
    BOOST_CHECK(is_quotient(s, u, v, 3));
    const Spline<Exact> t = Spline<Exact>(s).insert_u(u).insert_v(fraction(1, 5), 2);
    BOOST_CHECK(is_quotient(t, u, v, 3));
    for (int k = 0; k <= 2; ++k)
      for (int l = 0; k + l <= 2; ++l) BOOST_CHECK(t.jet(u, v, 2)(k, l) == s.jet(u, v, 2)(k, l));
  }
}

BOOST_AUTO_TEST_CASE(operations_keep_the_points) {
  Random random;
  const Patch<Exact> s = random_patch(random, 2, 3);
  const Q a(-1), b(2), c(0), d = fraction(1, 3), u = fraction(1, 7), v = fraction(2, 9);
  const Exact::Point p = s(u, v);
  BOOST_CHECK(s.elevate(2, 1)(u, v) == p);
  BOOST_CHECK(s.elevate(2, 1).degree_u() == 4);
  BOOST_CHECK(s.split_u(u).first(u, v) == p && s.split_u(u).second(u, v) == p);
  BOOST_CHECK(s.split_v(v).first(u, v) == p && s.split_v(v).second(u, v) == p);
  BOOST_CHECK(s.swap_parameters()(v, u) == p);
  BOOST_CHECK(s.reverse_u()(Q(a + b - u), v) == p);
  BOOST_CHECK(s.reverse_v()(u, Q(c + d - v)) == p);
  BOOST_CHECK(s.reverse_v().reverse_v() == s && s.swap_parameters().swap_parameters() == s && s.reverse_u() != s);
  BOOST_CHECK(s.with_domain({Q(0), Q(1)}, {Q(0), Q(1)})(Q((u - a) / (b - a)), Q(v / d)) == p);
  BOOST_CHECK(with_factor(s, fraction(7, 3))(u, v) == p && with_factor(s, fraction(7, 3)) != s);
  BOOST_CHECK(Patch<Exact>(s.homogeneous()) == s);
  const CGAL::Aff_transformation_3<CGAL::Simple_cartesian<Q>> map(Q(1), Q(2), Q(0), Q(5), Q(0), Q(1), Q(3), Q(7), Q(1),
                                                                  Q(0), Q(1), Q(-4));
  BOOST_CHECK(s.transform(map)(u, v) == map(p));
  BOOST_CHECK(s.oriented(u0)(v, a) == s(a, v) && s.oriented(u1)(v, a) == s(b, v));
  BOOST_CHECK(s.oriented(v0)(u, c) == s(u, c) && s.oriented(v1)(u, c) == s(u, d));
  for (Patch_edge edge : GC::patch_edges) {
    const auto curve = boundary_curve(s, edge);
    const auto spline_curve = boundary_curve(Spline<Exact>(s).insert_u(u).insert_v(v), edge);
    const Q t = GC::runs_along_u(edge) ? u : v, at = edge == u0 ? a : edge == u1 ? b : edge == v0 ? c : d;
    const Exact::Point point = GC::runs_along_u(edge) ? s(t, at) : s(at, t);
    BOOST_CHECK(curve(t) == point && spline_curve(t) == point);
    const auto rows = s.rows(edge, 1); // the derivative into the patch on the unit square
    BOOST_CHECK(rows.size() == 2 && rows[0][0].dimension() == 4);
  }

  const Spline<Exact> t = Spline<Exact>(s).insert_u(u).insert_v(v, 2);
  BOOST_CHECK(t(u, v) == p && t.elevate(1, 2)(u, v) == p && t.swap_parameters()(v, u) == p);
  BOOST_CHECK(t.reverse_u()(Q(a + b - u), v) == p && t.reverse_v()(u, Q(c + d - v)) == p);
  BOOST_CHECK(t.clamp() == t && t.refine(t.knots_u(), t.knots_v()) == t && t.transform(map)(u, v) == map(p));
  const std::vector<Patch<Exact>> pieces = t.bezier_patches();
  BOOST_REQUIRE_EQUAL(pieces.size(), 4u);
  for (const Patch<Exact>& piece : pieces) BOOST_CHECK(piece(u, v) == p); // extended
  BOOST_CHECK(Spline<Exact>(t.homogeneous()) == t);
}

TEST_FOR_EACH(polynomial_surfaces, Traits, All_traits) {
  typedef typename Traits::Point P;
  const GC::Bezier_patch<Traits> s({{P(0, 0, 0), P(0, 4, 1)}, {P(4, 0, 8), P(4, 4, 0)}, {P(8, 0, 0), P(8, 4, 2)}});
  const Patch<Traits> r = s;
  BOOST_CHECK(r.is_polynomial() && *r.polynomial() == s);
  BOOST_CHECK(*with_factor(r, FT(3)).polynomial() == s);
  BOOST_CHECK(!bilinear<Traits>().is_polynomial() && !bilinear<Traits>().polynomial());
  const FT u = FT(FT(1) / FT(4)), v = FT(FT(1) / FT(2));
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j) BOOST_CHECK(r.jet(u, v, 3)(i, j) == s.jet(u, v, 3)(i, j));
  const GC::Bspline_surface<Traits> t = GC::Bspline_surface<Traits>(s).insert_u(u);
  const Spline<Traits> q = t;
  BOOST_CHECK(*q.polynomial() == t && !Spline<Traits>(bilinear<Traits>()).polynomial());
  BOOST_CHECK(q.normal(u, v) == t.normal(u, v));
}

TEST_FOR_EACH(denominators, Traits, All_traits) {
  typedef typename Traits::Point P;
  const auto weight = [](int p, int q) { return FT(FT(p) / FT(q)); };
  // the denominator in the middle is (12 + 4 w) / 16
  for (const FT& w : {weight(0, 1), weight(-1, 1), weight(-23, 8)}) {
    const Patch<Traits> s = with_middle_weight<Traits>(w);
    for (const Patch<Traits>& part : s.positive_parts())
      for (const FT& x : part.weights()) BOOST_CHECK(FT(0) < x);
    const auto box = s.bbox();
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const auto b = s(weight(i, 8), weight(j, 8)).bbox();
        for (int k = 0; k < 3; ++k) BOOST_CHECK(box.min(k) <= b.max(k) && b.min(k) <= box.max(k));
      }
    BOOST_CHECK(Spline<Traits>(s).insert_u(weight(1, 4)).number_of_points_u() == 4);
  }
  // zero in the middle, which is found on the way; less than zero in the middle only; and a bit
  // beside it
  CHECK_ERROR(with_middle_weight<Traits>(weight(-3, 1)), zero_weight);
  CHECK_ERROR(with_middle_weight<Traits>(weight(-4, 1)), zero_weight);
  CHECK_ERROR(Patch<Traits>({{P(0, 0, 0)}, {P(1, 0, 0)}, {P(2, 0, 0)}}, {{FT(4)}, {FT(-2)}, {FT(1)}}), zero_weight);
  CHECK_ERROR(Patch<Traits>({{P(0, 0, 0), P(1, 0, 0), P(2, 0, 0)}}, {{FT(4), FT(-2), FT(1)}}), zero_weight);
  CHECK_ERROR(Patch<Traits>({{P(0, 0, 0), P(0, 0, 0)}}, {{FT(0), FT(1)}}), zero_weight);
  CHECK_ERROR(Patch<Traits>({{P(0, 0, 0), P(0, 0, 0)}}, {{FT(1), FT(-1)}}), zero_weight);
  // ((3u-1)^2 + (3v-1)^2) / 9 is zero at u = v = 1/3 only, inside of ever smaller rectangles
  std::vector<std::vector<P>> net(3, std::vector<P>(3, P(0, 0, 0)));
  const FT square[] = {FT(1), FT(-2), FT(4)};
  const auto touching = net_of(3, 3, [&](int i, int j) { return FT(square[i] + square[j]); });
  CHECK_ERROR(Patch<Traits>(net, touching), zero_weight);
  // (u-v)^2 + epsilon needs the more rectangles the smaller epsilon is, along the whole diagonal
  const auto near_diagonal = [&](const FT& epsilon) {
    return Patch<Traits>(
        net, net_of(3, 3, [&](int i, int j) { return FT(FT((i == 2) + (j == 2)) - FT(i * j) / FT(2) + epsilon); }));
  };
  BOOST_CHECK(!near_diagonal(weight(1, 1024)).is_polynomial());
  CHECK_ERROR(near_diagonal(weight(0, 1)), zero_weight);
  CHECK_ERROR(near_diagonal(FT(weight(1, 1 << 30) * weight(1, 1 << 30))), work_limit);
  CHECK_ERROR(near_diagonal(FT(-weight(1, 1 << 30) * weight(1, 1 << 30))), zero_weight);
  // knots: the denominator of the second span only is negative
  typedef GC::Knot_vector<FT> Knots;
  const Knots two(1, {FT(0), FT(0), FT(1), FT(2), FT(2)}), one(1, {FT(0), FT(0), FT(1), FT(1)});
  const std::vector<std::vector<P>> three(3, std::vector<P>(2, P(0, 0, 0)));
  const std::vector<std::vector<FT>> good{{FT(1), FT(1)}, {FT(1), FT(1)}, {FT(1), FT(2)}},
      bad{{FT(1), FT(1)}, {FT(1), FT(1)}, {FT(1), FT(-2)}};
  BOOST_CHECK(Spline<Traits>(three, good, two, one).weight(2, 1) == FT(2));
  CHECK_ERROR(Spline<Traits>(three, bad, two, one), zero_weight);
}

BOOST_AUTO_TEST_CASE(infinite_control_points) {
  // half a circle, extruded: the middle points are infinite
  typedef Patch<Exact>::Homogeneous::Point H;
  const auto point = [](int x, int y, int z, int w) {
    H p(4);
    const int c[] = {x, y, z, w};
    for (int i = 0; i < 4; ++i) p[i] = Q(c[i]);
    return p;
  };
  const Patch<Exact>::Homogeneous h({{point(1, 0, 0, 1), point(1, 0, 1, 1)},
                                     {point(0, 1, 0, 0), point(0, 1, 0, 0)},
                                     {point(-1, 0, 0, 1), point(-1, 0, 1, 1)}});
  const Patch<Exact> s(h);
  BOOST_CHECK(s.weight(1, 0) == Q(0) && s.control_point(1, 0) == Exact::Point(0, 1, 0));
  BOOST_CHECK(s.homogeneous() == h && s(fraction(1, 2), Q(0)) == Exact::Point(0, 1, 0));
  const Exact::Point p = s(fraction(1, 5), fraction(1, 3));
  BOOST_CHECK(p.x() * p.x() + p.y() * p.y() == Q(1) && p.z() == fraction(1, 3));
  const CGAL::Aff_transformation_3<CGAL::Simple_cartesian<Q>> shift(CGAL::TRANSLATION, Exact::Vector(1, 2, 3));
  BOOST_CHECK(s.transform(shift)(fraction(1, 5), fraction(1, 3)) == shift(p));
  BOOST_CHECK(s.reverse_u().reverse_u() == s && s.swap_parameters()(fraction(1, 3), fraction(1, 5)) == p);
  BOOST_CHECK(s.bbox().ymax() >= 1 && s.bbox().ymax() < 3);
  // given with a weight 0 they contribute nothing
  const Patch<Exact> t({{Exact::Point(1, 0, 0)}, {Exact::Point(7, 7, 7)}, {Exact::Point(-1, 0, 0)}},
                       {{Q(1)}, {Q(0)}, {Q(1)}});
  BOOST_CHECK(t.control_point(1, 0) == Exact::Point(0, 0, 0) && t(fraction(1, 2), Q(0)) == Exact::Point(0, 0, 0));
}

BOOST_AUTO_TEST_CASE(grids) {
  typedef GC::Surface_grid<double> Grid;
  Random random;
  for (int p : {1, 2, 7}) { // unrolled and not
    const auto net = net_of(p + 1, p + 1, [&](int i, int j) { return Double::Point(i, j, random.integer(-9, 9)); });
    const auto weights = net_of(p + 1, p + 1, [&](int, int) { return random.integer(1, 9) / 4.; });
    const Patch<Double> patch(net, weights, {1, 3}, {0, 2});
    const std::vector<double> u{1, 1.25, 2, 3}, v{0, 0.3, 1, 1.7, 2};
    const auto compare = [&](const auto& surface) {
      Grid unit, plain;
      evaluate_grid(surface, u, v, unit);
      GC::evaluate_grid<GC::Grid_normals::unnormalised>(surface, u, v, plain);
      for (std::size_t i = 0; i < u.size(); ++i)
        for (std::size_t j = 0; j < v.size(); ++j) {
          const std::size_t at = i * v.size() + j;
          const Double::Point x = surface(u[i], v[j]);
          const Double::Vector normal = surface.normal(u[i], v[j]), direction = *surface.unit_normal(u[i], v[j]);
          for (int k = 0; k < 3; ++k) {
            BOOST_CHECK_SMALL(plain.points(k)[at] - x[k], 1e-12);
            BOOST_CHECK_SMALL(plain.normals(k)[at] - normal[k], 1e-9);
            BOOST_CHECK_SMALL(unit.normals(k)[at] - direction[k], 1e-12);
          }
        }
    };
    compare(patch);
    compare(Spline<Double>(patch).insert_u(1.5).insert_v(0.3).insert_v(1, std::min(p, 2)));
  }
}

TEST_FOR_EACH(refused_input, Traits, All_traits) {
  typedef typename Traits::Point P;
  const std::vector<std::vector<P>> net{{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0)}};
  typedef std::vector<std::vector<FT>> Weights;
  const Weights weights(2, std::vector<FT>(2, FT(1)));
  CHECK_ERROR(Patch<Traits>(net, Weights(1, std::vector<FT>(2, FT(1)))), wrong_number_of_points);
  CHECK_ERROR(Patch<Traits>(net, Weights(3, std::vector<FT>(2, FT(1)))), wrong_number_of_points);
  CHECK_ERROR(Patch<Traits>(net, Weights(2, std::vector<FT>(3, FT(1)))), wrong_number_of_points);
  CHECK_ERROR(Patch<Traits>(std::vector<std::vector<P>>(), Weights()), wrong_number_of_points);
  CHECK_ERROR(Patch<Traits>(net, weights, {FT(1), FT(1)}), empty_domain);
  CHECK_ERROR(Patch<Traits>(net, weights).with_domain({FT(0), FT(1)}, {FT(1), FT(0)}), empty_domain);
  CHECK_ERROR(Patch<Traits>(net, weights).split_u(FT(1)), parameter_outside_domain);
  BOOST_CHECK(error_of([&] { Patch<Traits>(net, Weights(2, std::vector<FT>(3, FT(1)))); }) ==
              "wrong_number_of_points: Rational_bezier_patch: 3 weights in row 0");
  const GC::Knot_vector<FT> knots(1, FT(0), FT(1)), more(2, FT(0), FT(1));
  CHECK_ERROR(Spline<Traits>(net, weights, knots, more), wrong_number_of_points);
  CHECK_ERROR(Spline<Traits>(net, weights, knots, knots)(FT(2), FT(0)), parameter_outside_domain);
  // zero outside of the domain: (1 - 2 t) at t = 1/2
  const Patch<Traits> s({{P(0, 0, 0)}, {P(1, 0, 0)}}, {{FT(2)}, {FT(1)}});
  CHECK_ERROR(s(FT(2), FT(0)), zero_weight);
  if constexpr (std::is_floating_point_v<FT>) {
    const FT nan = std::numeric_limits<FT>::quiet_NaN(), infinity = std::numeric_limits<FT>::infinity();
    for (const FT& x : {nan, infinity}) {
      CHECK_ERROR(Patch<Traits>(net, Weights{{FT(1), x}, {FT(1), FT(1)}}), not_finite);
      CHECK_ERROR(Spline<Traits>(net, Weights{{FT(1), x}, {FT(1), FT(1)}}, knots, knots), not_finite);
    }
    const FT most = (std::numeric_limits<FT>::max)();
    const Patch<Traits> big({{P(most, 0, 0)}, {P(1, 0, 0)}}, {{FT(2)}, {FT(1)}});
    CHECK_ERROR(big.homogeneous(), not_finite);
  }
}

BOOST_AUTO_TEST_SUITE_END()
