// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The certificate of the order along an edge is checked: the polynomials vanish where it says so,
// and the factors are those of the construction.

#include "support/nets.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

BOOST_AUTO_TEST_SUITE(edge_certificates)

typedef CGAL::Simple_cartesian<Q> Kernel;
typedef GC::Edge_certificate<Q> Certificate;

Q value(const GC::Power_polynomial<Q>& p, const Q& u) {
  Q sum(0);
  for (int k = p.degree(); k >= 0; --k) sum = Q(sum * u + p[k]);
  return sum;
}

Curve sum(const std::vector<std::pair<Q, Curve>>& terms) {
  Curve r{constant(0), constant(0), constant(0)};
  for (const auto& [factor, c] : terms)
    for (int i = 0; i < 3; ++i) r[i] = r[i] + Polynomial{factor} * c[i];
  return r;
}

// The certificate of the only span of two patches with these rows.
Certificate certificate(const Net& a, const Net& b, int order) {
  const std::vector<Patch<Kernel>> p = patches<Kernel>({a, b});
  const auto verdict = GC::edge_continuity(p[0], v0, p[1], v0);
  BOOST_REQUIRE(verdict.g_order == order);
  const std::vector<Certificate> c = GC::edge_certificates(p[0], v0, p[1], v0, verdict);
  BOOST_REQUIRE(c.size() == 1);
  BOOST_CHECK(c[0].g_order == order && c[0].begin == Q(0) && c[0].end == Q(1));
  return c[0];
}

// The second surface is S(u + alpha v + alpha2 v^2/2, beta v + delta v^2/2) up to second order, and
// then moved away from that.
BOOST_AUTO_TEST_CASE(constructed_edges) {
  Random random;
  for (int i = 0; i < 10; ++i) {
    const Curve c = random.curve(3, 0, 9), t = random.curve(2, 1, 9), w = random.curve(2, 2, 1);
    const Q alpha(random.integer(-3, 3)), beta(-random.integer(1, 3)), alpha2(random.integer(-3, 3)),
        delta(random.integer(-3, 3));
    const Curve c1 = derivative(c), tq = sum({{alpha, c1}, {beta, t}}),
                wq = sum({{alpha * alpha, derivative(c1)},
                          {Q(2 * alpha * beta), derivative(t)},
                          {beta * beta, w},
                          {alpha2, c1},
                          {delta, t}});
    const Net a = net_from_rows(c, t, w);
    const Certificate smooth = certificate(a, net_from_rows(c, tq, wq), 2);
    BOOST_CHECK(smooth.determinant->is_zero() && smooth.second_order->is_zero());
    BOOST_REQUIRE(smooth.factors.size() == 3);
    for (const Q& u : {Q(0), Q(Q(1) / Q(3)), Q(1)}) {
      const Q d = value(smooth.factors[0], u);
      BOOST_CHECK(value(smooth.factors[1], u) == Q(alpha * d) && value(smooth.factors[2], u) == Q(beta * d));
      BOOST_CHECK(value(*smooth.side, u) < Q(0));
    }
    // the second edge backwards: the same polynomials
    const std::vector<Patch<Kernel>> p = patches<Kernel>({a, net_from_rows(c, tq, wq)});
    const Patch<Kernel> backwards = p[1].reverse_u();
    const auto verdict = GC::edge_continuity(p[0], v0, backwards, v0);
    BOOST_REQUIRE(verdict.g_order == 2 && verdict.reversed);
    const std::vector<Certificate> reversed = GC::edge_certificates(p[0], v0, backwards, v0, verdict);
    BOOST_REQUIRE(reversed.size() == 1 && reversed[0].factors.size() == 3);
    BOOST_CHECK(reversed[0].determinant->is_zero() && reversed[0].second_order->is_zero());
    for (int k = 0; k < 3; ++k) BOOST_CHECK(value(reversed[0].factors[k], Q(2)) == value(smooth.factors[k], Q(2)));
    const Curve away{constant(0), constant(0), constant(1)};
    const Certificate g1 = certificate(a, net_from_rows(c, tq, sum({{Q(1), wq}, {Q(1), away}})), 1);
    BOOST_CHECK(g1.determinant->is_zero() && !g1.second_order->is_zero() && g1.factors.size() == 3);
    const Certificate crease = certificate(a, net_from_rows(c, sum({{Q(1), tq}, {Q(1), away}}), wq), 0);
    BOOST_CHECK(!crease.determinant->is_zero() && crease.side && crease.factors.empty() && !crease.second_order);
  }
}

// In each coordinate plane, where two coordinates of the normal are zero; and of a wrong verdict on
// surfaces without a normal.
BOOST_AUTO_TEST_CASE(planes) {
  for (int x = 0; x < 3; ++x) {
    const auto patch = [&](int u, int v) {
      return Patch<Kernel>(net_of(2, 2, [&](int i, int j) {
        Q p[3] = {Q(0), Q(0), Q(0)};
        p[x] = Q(i * u);
        p[(x + 1) % 3] = Q(j * v);
        return Kernel::Point_3(p[0], p[1], p[2]);
      }));
    };
    const Patch<Kernel> a = patch(1, 1), b = patch(1, -2), line = patch(1, 0);
    const auto verdict = GC::edge_continuity(a, v0, b, v0);
    BOOST_REQUIRE(verdict.g_order == 2);
    const std::vector<Certificate> c = GC::edge_certificates(a, v0, b, v0, verdict);
    BOOST_REQUIRE(c.size() == 1 && c[0].factors.size() == 3);
    BOOST_CHECK(c[0].determinant->is_zero() && c[0].second_order->is_zero() && !c[0].factors[0].is_zero());
    BOOST_CHECK(value(c[0].factors[2], Q(0)) == Q(-2) * value(c[0].factors[0], Q(0)));
    const std::vector<Certificate> wrong = GC::edge_certificates(line, v0, line, v0, verdict);
    BOOST_REQUIRE(wrong.size() == 1 && wrong[0].factors.size() == 3);
    // which shows that it is wrong
    BOOST_CHECK(wrong[0].side->is_zero() && wrong[0].factors[0].is_zero());
  }
}

// A knot line at which the surface jumps has only rows; each span of the line has its own
// certificate.
BOOST_AUTO_TEST_CASE(knot_lines) {
  typedef GC::Bspline_surface<GC::Traits_3<Kernel>> Surface;
  typedef Kernel::Point_3 Point;
  const GC::Knot_vector<Q> u(1, {Q(0), Q(0), Q(1), Q(2), Q(2)});
  const auto surface = [&](const Q& z, const GC::Knot_vector<Q>& v, int points) {
    return Surface(net_of(3, points, [&](int i, int j) { return Point(Q(i), Q(j), j < 2 ? Q(0) : z); }), u, v);
  };
  const auto certificates = [&](const Surface& s) {
    for (const auto& line : GC::knot_line_continuity(s))
      if (!line.constant_u) return GC::knot_line_certificates(s, line);
    return std::vector<Certificate>();
  };
  const std::vector<Certificate> kink =
      certificates(surface(Q(1), GC::Knot_vector<Q>(1, {Q(0), Q(0), Q(1), Q(3), Q(3)}), 3));
  BOOST_REQUIRE(kink.size() == 2);
  for (const Certificate& c : kink) BOOST_CHECK(c.g_order == 0 && c.determinant && c.factors.empty());
  BOOST_CHECK(kink[1].begin == Q(1) && kink[1].end == Q(2));
  const std::vector<Certificate> jump =
      certificates(surface(Q(1), GC::Knot_vector<Q>(1, {Q(0), Q(0), Q(1), Q(1), Q(3), Q(3)}), 4));
  BOOST_REQUIRE(jump.size() == 2);
  for (const Certificate& c : jump) BOOST_CHECK(c.g_order == -1 && !c.determinant && !c.side && c.a.edge != c.b.edge);
  // lines of constant u, and with weights
  const Surface turned = surface(Q(1), GC::Knot_vector<Q>(1, {Q(0), Q(0), Q(1), Q(3), Q(3)}), 3).swap_parameters();
  const GC::Rational_bspline_surface<GC::Traits_3<Kernel>> rational(turned);
  const auto check = [](const auto& s) {
    int lines = 0;
    for (const auto& line : GC::knot_line_continuity(s)) {
      if (!line.constant_u) continue;
      ++lines;
      const std::vector<Certificate> c = GC::knot_line_certificates(s, line);
      BOOST_REQUIRE(c.size() == 2);
      for (const Certificate& x : c) BOOST_CHECK(x.g_order == 0 && x.determinant && x.factors.empty());
    }
    BOOST_CHECK_EQUAL(lines, 1);
  };
  check(turned);
  check(rational);
}

BOOST_AUTO_TEST_SUITE_END()
