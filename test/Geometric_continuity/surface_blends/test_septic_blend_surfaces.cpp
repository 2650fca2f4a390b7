// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends of surfaces of degree 7: G3 along whole edges. is_g3_edge() decides it. It is compared
// with the Taylor expansion of a surface, composed with that of the reparametrisation at more
// parameters than polynomials that agree there can have as zeros.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"
#include "support/series.h"
#include "support/translated_curves.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>

BOOST_AUTO_TEST_SUITE(septic_blend_surfaces)

typedef GC::Edge_function<Q> Function;
typedef GC::Surface_blend_shape<Q> Shape;

struct Numbers : Random_surfaces {
  Function function(const Q& size, int least = -99) {
    std::vector<Q> b;
    for (int i = integer(0, 2); i >= 0; --i) b.push_back(size * fraction_of<Q>(least, 99, 1, 99));
    return GC::Bernstein_polynomial<Q>(b);
  }
  template <class Reparametrisation> void choose(Reparametrisation& r, const Q& size) {
    for (Function* f : {&r.alpha, &r.alpha2, &r.alpha3, &r.delta, &r.delta3}) *f = function(size);
    r.beta = function(size, 1);
    if constexpr (std::is_base_of_v<GC::Rational_edge_reparametrisation<Q>, Reparametrisation>) {
      r.lambda = fraction(integer(1, 9), 7);
      for (Function* f : {&r.lambda1, &r.lambda2, &r.lambda3}) *f = function(size);
    }
  }
};

template <class S> constexpr bool is_patch_v = std::is_same_v<S, Bezier<Exact>> || std::is_same_v<S, Patch<Exact>>;

// Parameters in [0, 1] along the edges, more in each span of the blend than its rows of homogeneous
// points have degree.
template <class Surface> std::vector<Q> parameters(const Surface& s) {
  std::vector<Q> u;
  const std::pair<Q, Q> domain = s.domain_u();
  const auto add = [&](const Q& from, const Q& to, int n) {
    for (int i = 1; i <= n; ++i)
      u.push_back((from + fraction(i, n + 1) * (to - from) - domain.first) / (domain.second - domain.first));
  };
  const int n = 2 * s.degree_u() + 1; // S - L times both denominators
  if constexpr (is_patch_v<Surface>)
    add(domain.first, domain.second, n);
  else
    for (int k : s.knots_u().spans()) add(s.knots_u()[k], s.knots_u()[k + 1], n);
  return u;
}

// Returns whether S has at its edge v = `at` the third-order expansion of the surface L in the
// parameters of the shape, everywhere.
template <class L, class S, class Reparametrisation>
bool has_contact(const L& l, Patch_edge edge, Edge_direction direction, const S& s, int at,
                 const Reparametrisation& r) {
  const auto along = runs_along_u(edge) ? l.domain_u() : l.domain_v(),
             across = runs_along_u(edge) ? l.domain_v() : l.domain_u();
  const auto domain = s.domain_u();
  const bool upper = at_upper_end(edge), opposite = direction == Edge_direction::opposite;
  // the derivatives of the parameters of L with respect to those in which the shape is given
  const Q unit_along = Q(opposite ? -1 : 1) * (along.second - along.first) / (domain.second - domain.first);
  const Q unit_across(upper == (at == 0) ? 1 : -1);
  for (const Q& t : parameters(s)) {
    const Q on_l = opposite ? Q(along.second - t * (along.second - along.first))
                            : Q(along.first + t * (along.second - along.first)),
            on_edge = upper ? across.second : across.first;
    const auto jet = runs_along_u(edge) ? l.jet(on_l, on_edge, 3) : l.jet(on_edge, on_l, 3);
    const Series x = {Q(0), unit_along * r.alpha(t), unit_along * r.alpha2(t) / Q(2), unit_along * r.alpha3(t) / Q(6)},
                 y = {Q(0), unit_across * r.beta(t), unit_across * r.delta(t) / Q(2), unit_across * r.delta3(t) / Q(6)};
    const auto blend = s.jet(domain.first + t * (domain.second - domain.first), Q(at), 3);
    for (int c = 0; c < 3; ++c) {
      Series sum = {Q(0), Q(0), Q(0), Q(0)}, power_x = {Q(1), Q(0), Q(0), Q(0)};
      const int factorial[] = {1, 1, 2, 6};
      for (int i = 0; i <= 3; ++i, power_x = product(power_x, x)) {
        Series term = power_x;
        for (int j = 0; i + j <= 3; ++j, term = product(term, y))
          for (int k = 0; k <= 3; ++k)
            sum[k] += term[k] * (runs_along_u(edge) ? jet(i, j) : jet(j, i))[c] / Q(factorial[i] * factorial[j]);
      }
      for (int k = 0; k <= 3; ++k)
        if (blend(0, k)[c] != sum[k] * Q(factorial[k])) return false;
    }
  }
  return true;
}

template <class A, class B> void check_random_blend(Numbers& random) {
  const A a = random.surface<A>();
  const B b = random.surface<B>();
  const Patch_edge ea = random.edge(), eb = random.edge();
  const Edge_direction direction = random.direction();
  GC::Septic_surface_blend_shape<GC::Blend_surface_shape<A, B>> shape;
  constexpr bool rational = std::is_base_of_v<GC::Rational_edge_reparametrisation<Q>, decltype(shape.start)>;
  const Q size = rational ? fraction(1, 10000) : Q(1); // so that the denominator stays positive
  random.choose(shape.start, size);
  random.choose(shape.end, size);
  if constexpr (rational) shape.start.lambda = shape.end.lambda = Q(1);
  // third derivatives jump at knots
  if constexpr (!is_patch_v<A>) shape.start.alpha = Function{Q(0)};
  if constexpr (!is_patch_v<B>) shape.end.alpha = Function{Q(0)};
  const auto s = blend(a, ea, b, eb, shape, direction);
  BOOST_CHECK_EQUAL(s.degree_v(), 7);
  BOOST_CHECK(has_contact(a, ea, Edge_direction::same, s, 0, shape.start));
  BOOST_CHECK(has_contact(b, eb, direction, s, 1, shape.end));
  BOOST_CHECK(is_g3_edge(a, ea, s, v0));
  BOOST_CHECK(is_g3_edge(s, v1, b, eb));
  // a moved point of the last layers that matter
  for (int layer : {3, 4}) {
    const auto m = moved(s, 1, layer);
    BOOST_CHECK_EQUAL(has_contact(a, ea, Edge_direction::same, m, 0, shape.start), layer == 4);
    BOOST_CHECK_EQUAL(has_contact(b, eb, direction, m, 1, shape.end), layer == 3);
    BOOST_CHECK_EQUAL(is_g3_edge(a, ea, m, v0), layer == 4);
    BOOST_CHECK_EQUAL(is_g3_edge(m, v1, b, eb), layer == 3);
    BOOST_CHECK(is_g2_edge(a, ea, m, v0) && is_g2_edge(m, v1, b, eb));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_types, A, Surface_types) {
  Numbers random;
  for_each_surface_type([&](auto b) { check_random_blend<A, typename decltype(b)::type>(random); });
}

// A shape of order 2 has third derivatives that are 0; the part between two parts of one surface is
// the blend of them.
TEST_FOR_EACH(a_part_of_one_surface, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef GC::Surface_blend_shape<FT> Given;
  std::vector<std::vector<P>> net;
  for (int i = 0; i < 3; ++i) net.push_back({P(i, 0, i * i), P(i, 4, 1), P(i, 8, 2 * i), P(i, 12, 5)});
  const Bezier<Traits> s(net), lower = s.split_v(FT(0.25)).first, upper = s.split_v(FT(0.5)).second,
                               middle = s.split_v(FT(0.25)).second.split_v(FT(0.5)).first;
  Given shape;
  shape.start.beta = shape.end.beta = GC::Bernstein_polynomial<FT>{FT(0.25)};
  const Bezier<Traits> septic = blend(lower, v1, upper, v0, GC::Septic_surface_blend_shape<Given>(shape)),
                       expected = middle.elevate(0, 4);
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; j <= 7; ++j)
      for (int c = 0; c < 3; ++c) {
        const FT difference = septic.coordinates(i, j)[c] - expected.coordinates(i, j)[c];
        if constexpr (std::is_floating_point_v<FT>)
          BOOST_CHECK_SMALL(difference, 1e-13);
        else
          BOOST_CHECK(difference == FT(0));
      }
  shape.end.beta = GC::Bernstein_polynomial<FT>{FT(-1)};
  CHECK_ERROR(blend(lower, v1, upper, v0, GC::Septic_surface_blend_shape<Given>(shape)), nonpositive_beta);
}

// Parts of a spline are G3 along a parameter line that is no knot, and G2 along a simple knot of
// degree 3.
BOOST_AUTO_TEST_CASE(parts_of_a_spline) {
  Numbers random;
  const Knots u(3, Q(0), Q(1), {{fraction(1, 3), 1}}), v(3, Q(0), Q(1), {{fraction(1, 2), 1}});
  const Bspline<Exact> s(random.net(5, 5), u, v);
  const Spline<Exact> r(random.net(5, 5), random.weights(5, 5), u, v);
  for (const Q& cut : {fraction(1, 2), fraction(2, 3)}) {
    const auto parts = s.split_v(cut);
    BOOST_CHECK(is_g2_edge(parts.first, v1, parts.second, v0));
    BOOST_CHECK_EQUAL(is_g3_edge(parts.first, v1, parts.second, v0), cut != fraction(1, 2));
    BOOST_CHECK_EQUAL(is_g3_edge(parts.second.reverse_u().swap_parameters(), u0, parts.first, v1),
                      cut != fraction(1, 2));
    const auto rational = r.split_v(cut);
    BOOST_CHECK(is_g2_edge(rational.first, v1, rational.second, v0));
    BOOST_CHECK_EQUAL(is_g3_edge(rational.first, v1, rational.second, v0), cut != fraction(1, 2));
  }
  const Patch<Exact> patch(random.net(3, 4), random.weights(3, 4));
  const auto parts = patch.split_v(fraction(2, 3));
  BOOST_CHECK(is_g3_edge(with_factor(parts.first, Q(3)), v1, parts.second, v0));
  BOOST_CHECK(!is_g3_edge(with_factor(parts.first, Q(3)), v1, moved(parts.second, 1, 3), v0));
}

// By every strategy of order 3; those for F3 choose another mu, which is not taken.
template <class A, class B, class Strategy> void check_automatic_blend(Numbers& random, const Strategy& strategy) {
  const A a = random.surface<A>();
  const B b = random.surface<B>();
  const Patch_edge ea = random.edge(), eb = random.edge();
  const auto s = blend(a, ea, b, eb, strategy);
  BOOST_CHECK_EQUAL(s.degree_v(), 7);
  BOOST_CHECK(is_g3_edge(a, ea, s, v0));
  BOOST_CHECK(is_g3_edge(s, v1, b, eb));
  BOOST_CHECK(!is_g3_edge(a, ea, moved(s, 1, 3), v0));
  BOOST_CHECK(!is_g3_edge(moved(s, 1, 4), v1, b, eb));
}
BOOST_AUTO_TEST_CASE(automatic_blends) {
  Numbers random;
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Minimal_energy_g3<4>());
  check_automatic_blend<Bezier<Exact>, Bspline<Exact>>(random, GC::Minimal_energy_g3<3>());
  check_automatic_blend<Bspline<Exact>, Patch<Exact>>(random, GC::Sequential_g3());
  check_automatic_blend<Patch<Exact>, Spline<Exact>>(random, GC::Minimal_energy_g3<4>());
  check_automatic_blend<Spline<Exact>, Spline<Exact>>(random, GC::Matching_third_derivative());
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Joint_g3());
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Fair_g3());
  check_automatic_blend<Patch<Exact>, Bezier<Exact>>(random, GC::Fair_g3());
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Sequential_f3());
}

// Where all curves u = const are the same but for a translation, the shape is that of the curves.
TEST_FOR_EACH(shape_of_translated_curves, Traits, All_traits) {
  const Translated_curves<Traits> given;
  const auto check = [&](const auto& strategy, double accuracy) {
    const auto gamma = given.blend_of_curves(strategy);
    const auto near = [&](const FT& x, const FT& y) {
      return std::abs(CGAL::to_double(x) - CGAL::to_double(y)) <= accuracy * std::abs(CGAL::to_double(y));
    };
    const auto shape = given.shape(strategy);
    BOOST_CHECK(near(shape.start.beta[0], gamma.shape.beta) && near(shape.end.beta[0], gamma.shape.eta));
    BOOST_CHECK(near(shape.start.delta[0], gamma.parameters.start.beta2));
    BOOST_CHECK(near(shape.start.delta3[0], gamma.parameters.start.beta3));
    BOOST_CHECK(near(shape.end.delta[0], gamma.parameters.end.beta2));
    BOOST_CHECK(near(shape.end.delta3[0], gamma.parameters.end.beta3));
    const auto rational = given.rational_shape(strategy);
    BOOST_CHECK(rational.start.delta3 == shape.start.delta3 && rational.end.delta3 == shape.end.delta3);
    BOOST_CHECK(rational.start.lambda3 == (GC::Bernstein_polynomial<FT>{FT(0)}));
    BOOST_CHECK_EQUAL(rational.start.lambda, FT(8));
  };
  check(GC::Minimal_energy_g3<4>(), 0x1p-8);
  check(GC::Fair_g3(), 0.05);
}

// The denominator of the blend of a surface whose weights grow stays near to a constant.
BOOST_AUTO_TEST_CASE(automatic_factors) {
  Numbers random;
  const auto grows = [&](int from, int to) {
    std::vector<Q> row;
    for (int j = 0; j <= 3; ++j) row.push_back(fraction(3 * from + j * (to - from), 3));
    return Patch<Exact>(random.net(2, 4), std::vector<std::vector<Q>>{row, row});
  };
  const Patch<Exact> a = grows(1, 2), b = grows(3, 1), s = blend(a, v1, b, v0, GC::Minimal_energy_g3<4>());
  for (int j = 0; j <= 7; ++j) {
    const double w = CGAL::to_double(Q(s.weight(0, j) / s.weight(0, 0)));
    BOOST_CHECK(0.98 < w && w < 1.02);
  }
  BOOST_CHECK(is_g3_edge(a, v1, s, v0));
}

// A row that a shift along the edge multiplies must not jump.
BOOST_AUTO_TEST_CASE(torn_blend) {
  Numbers random;
  const Knots u(3, Q(0), Q(1), {{fraction(1, 3), 1}}), v(3, Q(0), Q(1));
  const Bspline<Exact> s(random.net(5, 4), u, v);
  GC::Septic_surface_blend_shape<Shape> shape;
  BOOST_CHECK_EQUAL(blend(s, v1, s, v1, shape).degree_u(), 3);
  shape.end.alpha = Function{Q(1)}; // C''' jumps
  CHECK_ERROR(blend(s, v1, s, v1, shape), knot_multiplicity);
}

BOOST_AUTO_TEST_SUITE_END()
