// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends of surfaces of degree 7: G3 along whole edges. The Taylor expansion of a surface is composed with that of the
// reparametrisation at more parameters than polynomials that agree there can have as zeros.

#include <boost/test/unit_test.hpp>

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/edges/blend_surfaces.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(septic_blend_surfaces)

namespace {

typedef GC::Bernstein_polynomial<Q> Function;
typedef GC::Surface_blend_shape<Q> Shape;
typedef std::array<Q, 4> Series; // the coefficients of 1, v, v^2, v^3

Series product(const Series& a, const Series& b) {
  Series c = {Q(0), Q(0), Q(0), Q(0)};
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j) c[i + j] += a[i] * b[j];
  return c;
}

struct Numbers : Random_surfaces {
  Function function(const Q& size) {
    std::vector<Q> b;
    for (int i = integer(0, 2); i >= 0; --i) b.push_back(size * fraction_of<Q>(-99, 99, 1, 99));
    return Function(b);
  }
  Function positive_function(const Q& size) {
    std::vector<Q> b;
    for (int i = integer(0, 2); i >= 0; --i) b.push_back(size * fraction_of<Q>(1, 99, 1, 99));
    return Function(b);
  }
  template <class Reparametrisation> void choose(Reparametrisation& r, const Q& size) {
    for (Function* f : {&r.alpha, &r.alpha2, &r.alpha3, &r.delta, &r.delta3}) *f = function(size);
    r.beta = positive_function(size);
    if constexpr (std::is_base_of_v<GC::Rational_edge_reparametrisation<Q>, Reparametrisation>) {
      r.lambda = fraction(integer(1, 9), 7);
      for (Function* f : {&r.lambda1, &r.lambda2, &r.lambda3}) *f = function(size);
    }
  }
};

template <class S> constexpr bool is_patch_v = std::is_same_v<S, Bezier<Exact>> || std::is_same_v<S, Patch<Exact>>;

// Parameters in [0, 1] along the edges, more in each span of the blend than its rows of homogeneous points have degree.
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

// Whether S has at its edge v = `at` the third-order expansion of the surface L in the parameters of the shape, everywhere.
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
  if constexpr (!is_patch_v<A>) shape.start.alpha = Function{Q(0)}; // third derivatives jump at knots
  if constexpr (!is_patch_v<B>) shape.end.alpha = Function{Q(0)};
  const auto s = blend(a, ea, b, eb, shape, direction);
  BOOST_CHECK_EQUAL(s.degree_v(), 7);
  BOOST_CHECK(has_contact(a, ea, Edge_direction::same, s, 0, shape.start));
  BOOST_CHECK(has_contact(b, eb, direction, s, 1, shape.end));
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, s, v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(s, v1, b, eb), 2);
  // a moved point of each of the layers, at both ends
  for (int layer = 0; layer <= 7; ++layer) {
    const auto m = moved(s, 1, layer);
    BOOST_CHECK_EQUAL(has_contact(a, ea, Edge_direction::same, m, 0, shape.start), layer > 3);
    BOOST_CHECK_EQUAL(has_contact(b, eb, direction, m, 1, shape.end), layer < 4);
  }
}
template <class A> void check_random_blends_of(Numbers& random) {
  check_random_blend<A, Bezier<Exact>>(random);
  check_random_blend<A, Bspline<Exact>>(random);
  check_random_blend<A, Patch<Exact>>(random);
  check_random_blend<A, Spline<Exact>>(random);
}

} // namespace

BOOST_AUTO_TEST_CASE(patches) {
  Numbers random;
  check_random_blends_of<Bezier<Exact>>(random);
}
BOOST_AUTO_TEST_CASE(rational_patches) {
  Numbers random;
  check_random_blends_of<Patch<Exact>>(random);
}

// A shape of order 2 has third derivatives that are 0; the part between two parts of one surface is the blend of them.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_part_of_one_surface, Traits, All_traits) {
  typedef typename Traits::FT FT;
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

// What a shift along the edge multiplies must not jump.
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
