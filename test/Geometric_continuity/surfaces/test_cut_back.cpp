// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Surfaces of all types without a strip along an edge.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/surfaces/cut_back.h>

BOOST_AUTO_TEST_SUITE(surfaces_trimmed_back)

template <class Surface> std::pair<Q, Q> across(const Surface& s, Patch_edge edge) {
  return runs_along_u(edge) ? s.domain_v() : s.domain_u();
}

// The strip and the rest have the points of the surface, at their own parameters.
template <class Surface> void check_parts(const Surface& s, const Surface& part, Random& random) {
  const auto between = [&](const std::pair<Q, Q>& domain) {
    return Q(domain.first + Q(random.integer(0, 1000)) * (domain.second - domain.first) / Q(1000));
  };
  for (int i = 0; i < 12; ++i) {
    const Q u = between(part.domain_u()), v = between(part.domain_v());
    BOOST_CHECK(part(u, v) == s(u, v));
  }
}

template <class Surface> void check_trimmed(Random_surfaces& random) {
  for (int i = 0; i < 4; ++i) {
    const Surface s = random.surface<Surface>();
    for (Patch_edge edge : GC::patch_edges) {
      const std::pair<Q, Q> domain = across(s, edge);
      const Q length = domain.second - domain.first, distance = length * fraction(random.integer(1, 999), 1000);
      const Surface t = cut_back(s, edge, distance);
      check_parts(s, t, random);
      BOOST_CHECK(runs_along_u(edge) ? t.domain_u() == s.domain_u() : t.domain_v() == s.domain_v());
      BOOST_CHECK(across(t, edge) == (at_upper_end(edge) ? std::make_pair(domain.first, Q(domain.second - distance))
                                                         : std::make_pair(Q(domain.first + distance), domain.second)));
      BOOST_CHECK(t.degree_u() == s.degree_u() && t.degree_v() == s.degree_v());
      // the strip: it continues the rest
      const Patch_edge other = edge == u0 ? u1 : edge == u1 ? u0 : edge == v0 ? v1 : v0;
      const Surface strip = cut_back(s, other, Q(length - distance));
      check_parts(s, strip, random);
      BOOST_CHECK_EQUAL(whole_edge_order(t, edge, strip, other), 2);
      for (const Q& bad : {Q(0), Q(-distance), length, Q(length + distance)})
        CHECK_ERROR(cut_back(s, edge, bad), parameter_outside_domain);
    }
  }
}

// The distance of the last knot line before an edge, or of the opposite edge.
template <class Surface> Q span_at(const Surface& s, Patch_edge edge) {
  if constexpr (std::is_same_v<Surface, Bspline<Exact>> || std::is_same_v<Surface, Spline<Exact>>) {
    const auto& knots = runs_along_u(edge) ? s.knots_v() : s.knots_u();
    const std::vector<Q> distinct = [&] {
      std::vector<Q> t{knots.domain().first};
      for (const auto& knot : knots.inner_knots()) t.push_back(knot.value);
      t.push_back(knots.domain().second);
      return t;
    }();
    const std::size_t n = distinct.size();
    return at_upper_end(edge) ? distinct[n - 1] - distinct[n - 2] : distinct[1] - distinct[0];
  } else
    return across(s, edge).second - across(s, edge).first;
}

// Along a curve: on each line across the edge the part is the surface up to the curve, in
// proportion from the last knot line on.
template <class Surface> void check_along_curve(Random_surfaces& random, int degree) {
  typedef GC::Bernstein_polynomial<Q> Function;
  const Surface s = random.surface<Surface>();
  for (Patch_edge edge : GC::patch_edges) {
    const std::pair<Q, Q> domain = across(s, edge), along = runs_along_u(edge) ? s.domain_u() : s.domain_v();
    const Q length = domain.second - domain.first, span = span_at(s, edge);
    std::vector<Q> c;
    for (int i = 0; i <= degree; ++i) c.push_back(span * fraction(random.integer(1, 99), 100));
    const Function f(c);
    const Surface t = cut_back(s, edge, f);
    BOOST_CHECK(t.domain_u() == s.domain_u() && t.domain_v() == s.domain_v());
    const bool along_u = runs_along_u(edge);
    BOOST_CHECK_EQUAL(t.degree_u(), s.degree_u() + (along_u ? degree * s.degree_v() : 0));
    BOOST_CHECK_EQUAL(t.degree_v(), s.degree_v() + (along_u ? 0 : degree * s.degree_u()));
    for (int i = 0; i < 12; ++i) {
      const Q x = fraction(random.integer(0, 100), 100), y = fraction(random.integer(0, 100), 100);
      const Q u = along.first + x * (along.second - along.first), v = domain.first + y * length,
              knot = at_upper_end(edge) ? Q(domain.second - span) : Q(domain.first + span);
      const bool in_span = at_upper_end(edge) ? knot < v : v < knot;
      const Q w = in_span ? Q(knot + (v - knot) * (span - f(x)) / span) : v;
      BOOST_CHECK(runs_along_u(edge) ? t(u, v) == s(u, w) : t(v, u) == s(w, u));
    }
    for (const Q& bad : {Q(0), Q(-1), span, length}) {
      c.back() = bad;
      CHECK_ERROR(cut_back(s, edge, Function(c)), parameter_outside_domain);
    }
  }
}

BOOST_AUTO_TEST_CASE(all_types) {
  Random_surfaces random;
  check_trimmed<Bezier<Exact>>(random);
  check_trimmed<Bspline<Exact>>(random);
  check_trimmed<Patch<Exact>>(random);
  check_trimmed<Spline<Exact>>(random);
}

// At knots of any multiplicity, where the surface may jump, and with knots outside of the domain.
BOOST_AUTO_TEST_CASE(at_knots) {
  Random_surfaces random;
  for (int multiplicity = 0; multiplicity <= 3; ++multiplicity) {
    std::vector<Q> u = {-2, -1, 0, 7, 8, 8};
    u.insert(u.begin() + 3, static_cast<std::size_t>(multiplicity), Q(3));
    const Knots knots(2, u), v(2, Q(0), Q(1));
    const Bspline<Exact> s(random.net(knots.number_of_coefficients(), 3), knots, v);
    const Bspline<Exact> left = cut_back(s, u1, Q(4)), right = cut_back(s, u0, Q(3));
    BOOST_CHECK(left.knots_u() == Knots(2, {-2, -1, 0, 3, 3, 3}));
    BOOST_CHECK(right.knots_u() == Knots(2, {3, 3, 3, 7, 8, 8}));
    BOOST_CHECK_EQUAL(whole_edge_order(left, u1, right, u0), multiplicity == 0   ? 2
                                                             : multiplicity == 3 ? -2
                                                             : multiplicity == 2 ? 0
                                                                                 : 1);
    for (const Q& t : {Q(0), fraction(1, 3), Q(1)}) {
      BOOST_CHECK(right(3, t) == s(3, t));
      BOOST_CHECK(right(7, t) == s(7, t));
      BOOST_CHECK(left(0, t) == s(0, t));
      BOOST_CHECK(left(2, t) == s(2, t));
    }
  }
}

TEST_FOR_EACH(kernels, Traits, All_traits) {
  typedef typename Traits::Point P;
  const Bezier<Traits> s({{P(0, 0, 0), P(0, 4, 0), P(0, 8, 8)}, {P(8, 0, 0), P(8, 4, 0), P(8, 8, 16)}}, {FT(0), FT(2)},
                         {FT(1), FT(3)});
  const Bezier<Traits> t({{P(0, 0, 0), P(0, 2, 0), P(0, 4, 2)}, {P(8, 0, 0), P(8, 2, 0), P(8, 4, 4)}}, {FT(0), FT(2)},
                         {FT(1), FT(2)});
  BOOST_CHECK(cut_back(s, v1, FT(1)) == t);
  BOOST_CHECK(cut_back(Bspline<Traits>(s), v1, FT(1)) == Bspline<Traits>(t));
  BOOST_CHECK(cut_back(Patch<Traits>(s), v1, FT(1)) == Patch<Traits>(t));
  BOOST_CHECK(cut_back(Spline<Traits>(Bspline<Traits>(s)), v1, FT(1)) == Spline<Traits>(Bspline<Traits>(t)));
  BOOST_CHECK_EQUAL(error_of([&] { cut_back(s, u0, FT(2)); }),
                    "parameter_outside_domain: cut_back: the distance from the edge u0 does not lie between 0 and the "
                    "other edge");
  if constexpr (std::is_floating_point_v<FT>) {
    CHECK_ERROR(cut_back(s, v1, std::numeric_limits<FT>::quiet_NaN()), parameter_outside_domain);
    // nothing that can be told from 0
    CHECK_ERROR(cut_back(s, v1, FT(1e-300)), parameter_outside_domain);
  }
}

// Where the surface jumps along the knot line, both sides stay as they are.
BOOST_AUTO_TEST_CASE(along_curves_behind_knots) {
  Random_surfaces random;
  const GC::Bernstein_polynomial<Q> f{fraction(1, 2), fraction(1, 3)};
  for (int multiplicity = 1; multiplicity <= 3; ++multiplicity) {
    const Knots u(1, Q(0), Q(1)), v(2, Q(0), Q(3), {{Q(2), multiplicity}});
    const Bspline<Exact> s(random.net(2, v.number_of_coefficients()), u, v), t = cut_back(s, v1, f);
    BOOST_CHECK(t.knots_v() == Knots(2, Q(0), Q(3), {{Q(2), (std::max)(multiplicity, 2)}}));
    for (const Q& x : {Q(0), fraction(1, 5), Q(1)}) {
      BOOST_CHECK(t(x, fraction(3, 2)) == s(x, fraction(3, 2)));
      BOOST_CHECK(t(x, Q(2)) == s(x, Q(2)));
      BOOST_CHECK(t(x, Q(3)) == s(x, Q(3) - f(x)));
    }
  }
}

BOOST_AUTO_TEST_CASE(along_curves) {
  Random_surfaces random;
  for (int degree : {0, 1, 3}) {
    check_along_curve<Bezier<Exact>>(random, degree);
    check_along_curve<Patch<Exact>>(random, degree);
    check_along_curve<Bspline<Exact>>(random, degree);
    check_along_curve<Spline<Exact>>(random, degree);
  }
}

BOOST_AUTO_TEST_SUITE_END()
