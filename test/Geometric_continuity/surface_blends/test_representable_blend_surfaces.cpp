// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blend surfaces whose control points are floating-point numbers, which edge_continuity() proves to
// be G2 along both whole edges: it decides the numbers as they are.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/representable_blend_surfaces.h>

BOOST_AUTO_TEST_SUITE(representable_blend_surfaces)

typedef std::tuple<Double, Filtered> Rounded_traits;

struct Numbers : Random_integers<> {
  // 53 random digits, or 21 of them
  double full() {
    return std::ldexp(integer(-2147483647, 2147483647) + std::ldexp(integer(0, (1 << 21) - 1), -21), -31);
  }
  double on_grid() { return std::ldexp(integer(-(1 << 20), 1 << 20), -20); }

  template <class Traits>
  std::vector<std::vector<typename Traits::Point>> net(int m, int n, int from, bool short_ones) {
    const auto number = [&] { return short_ones ? on_grid() : full(); };
    return net_of(m, n, [&](int i, int j) {
      const double x = 4 * i + number(), y = 4 * (from + j) + number();
      return typename Traits::Point(x, y, number());
    });
  }
  std::pair<double, double> domain() {
    const double a = full();
    return {a, a + 1 + full() / 2};
  }
  Edge_direction direction() { return coin() ? Edge_direction::same : Edge_direction::opposite; }
};

// With the edge v = v0 as another one: turned, so that the edge is u = u0, u1 or v1.
template <class Surface> std::pair<Surface, Patch_edge> turned(const Surface& s, bool swapped, bool upper) {
  const Surface r = upper ? s.reverse_v() : s;
  if (swapped) return {r.swap_parameters(), upper ? u1 : u0};
  return {r, upper ? v1 : v0};
}

template <class Traits> Bezier<Traits> next_to(const Bezier<Traits>& s, int i, int j) {
  std::vector<typename Traits::Point> points(s.begin(), s.end());
  typename Traits::Point& p = points[static_cast<std::size_t>(i * (s.degree_v() + 1) + j)];
  p = typename Traits::Point(p.x(), p.y(), std::nextafter(p.z(), 1e300));
  return Bezier<Traits>(s.degree_u(), s.degree_v(), points, s.domain_u(), s.domain_v());
}
template <class Traits> Bspline<Traits> next_to(const Bspline<Traits>& s, int i, int j) {
  auto net = net_points(s);
  const typename Traits::Point p = net[i][j];
  net[i][j] = typename Traits::Point(p.x(), p.y(), std::nextafter(p.z(), 1e300));
  return Bspline<Traits>(net, s.knots_u(), s.knots_v());
}

// Both edges are G2, and not when the last digit of a coordinate changes.
template <class Surface, class Blend>
void check_g2(const Surface&, Patch_edge ea, Patch_edge eb, const Blend& r, Edge_direction direction) {
  BOOST_CHECK_EQUAL(r.blend.degree_v(), 5);
  BOOST_CHECK_EQUAL(whole_edge_order(r.first, ea, r.blend, v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(r.blend, v1, r.second, eb), 2);
  BOOST_CHECK(!edge_continuity(r.first, ea, r.blend, v0).reversed);
  BOOST_CHECK_EQUAL(edge_continuity(r.blend, v1, r.second, eb).reversed, direction == Edge_direction::opposite);
  BOOST_CHECK_EQUAL(whole_edge_order(r.first, ea, next_to(r.blend, 1, 2), v0), 1);
  BOOST_CHECK_EQUAL(whole_edge_order(next_to(r.blend, 1, 3), v1, r.second, eb), 1);
}

// The layers next to the edge moved by at most what is told and half a unit of the grid, the others
// not.
template <class Surface, class Join>
void check_moves(const Surface& given, const Surface& result, const Join& join, Patch_edge edge) {
  const Surface a = runs_along_u(edge) ? given : given.swap_parameters(),
                b = runs_along_u(edge) ? result : result.swap_parameters();
  const int n = static_cast<int>(join.grid.dimension()) / 3,
            layers = static_cast<int>(std::distance(a.begin(), a.end())) / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < layers; ++j)
      for (int x = 0; x < 3; ++x) {
        const double change = std::abs(b.coordinates(i, j)[x] - a.coordinates(i, j)[x]);
        const int layer = at_upper_end(edge) ? layers - 1 - j : j;
        if (layer > 2)
          BOOST_CHECK_EQUAL(change, 0);
        else {
          const double unit = (std::max)(join.grid[3 * i + x], join.grid[3 * (n - 1 - i) + x]);
          BOOST_CHECK_LE(change, unit / 2);
          BOOST_CHECK_LE(change, join.moved);
        }
      }
}

template <class Surface>
void check_random_blend(Numbers& random, const Surface& given_a, const Surface& given_b, bool stays) {
  const auto [a, ea] = turned(given_a, random.coin(), random.coin());
  const auto [b, eb] = turned(given_b, random.coin(), random.coin());
  const Edge_direction direction = random.direction();
  const auto r = representable_blend(a, ea, b, eb, GC::Minimal_energy<3>(), direction);
  check_g2(a, ea, eb, r, direction);
  check_moves(a, r.first, r.start_join, ea);
  check_moves(b, r.second, r.end_join, eb);
  BOOST_CHECK_EQUAL(r.first == a && r.second == b, stays);
  BOOST_CHECK_EQUAL(!r.start_join.is_moved() && !r.end_join.is_moved(), stays);
}

// Blends of every degree: coordinates of 21 digits stay, those of 53 digits move.
BOOST_AUTO_TEST_CASE_TEMPLATE(patches, Traits, Rounded_traits) {
  Numbers random;
  for (int m = 2; m <= 4; ++m)
    for (int n = 1; n <= 7; ++n)
      for (bool stays : {true, false}) {
        const Bezier<Traits> a(random.net<Traits>(m, n + 1, 0, stays), random.domain(), random.domain()),
            b(random.net<Traits>(m, 1 + n % 4, 12, stays), random.domain(), random.domain());
        if (b.degree_v() > 0) check_random_blend(random, a, b, stays);
      }
}

// Over inner knots along the edges, clamped or not, and across, where the ratio of their distances
// is a power of two, 2 / 3, 4 / 5 and 5 / 6.
BOOST_AUTO_TEST_CASE_TEMPLATE(splines, Traits, Rounded_traits) {
  typedef GC::Knot_vector<double> Knots;
  Numbers random;
  const Knots even(3, 0., 8., {{3., 1}, {5., 1}}), uneven(3, 0., 8., {{3., 1}, {5., 2}}),
      backwards(3, -1., 0., {{-0.625, 2}, {-0.375, 1}}), loose(2, {-1, 0, 1, 2, 3, 4, 5}),
      loose_twice(2, {-2, 0, 2, 4, 6, 8, 10});
  const std::vector<Knots> across = {Knots(3, 0., 3., {{1., 1}, {2., 1}}), Knots(2, 0., 1., {{0.5, 1}}),
                                     Knots(3, 0., 7., {{2., 1}, {3., 1}}), Knots(3, 0., 11., {{5., 1}, {6., 1}}),
                                     Knots(3, 0., 1., {{0.25, 3}}),        Knots(1, 0., 3., {{1., 1}})};
  const auto surface = [&](const Knots& u, const Knots& v, int from, bool stays) {
    return Bspline<Traits>(random.net<Traits>(u.number_of_coefficients(), v.number_of_coefficients(), from, stays), u,
                           v);
  };
  for (const Knots& v : across)
    for (const Knots& w : {across[0], across[2]})
      for (bool stays : {true, false}) {
        check_random_blend(random, surface(even, v, 0, stays), surface(even.on_domain(0, 1), w, 12, stays), stays);
        check_random_blend(random, surface(loose, v, 0, stays), surface(loose_twice, w, 12, stays), stays);
      }
  const Bspline<Traits> a = surface(uneven, across[0], 0, true), b = surface(backwards, across[1], 12, true);
  check_g2(a, v1, v0, representable_blend(a, v1, b, v0, GC::Minimal_energy<3>(), Edge_direction::opposite),
           Edge_direction::opposite);
  CHECK_ERROR(representable_blend(a, v1, b, v0, GC::Minimal_energy<3>(), Edge_direction::same), not_representable);
}

// By each strategy the blend is near to that of blend() with a shape that is chosen for as many
// curves; beta is within an eighth.
BOOST_AUTO_TEST_CASE_TEMPLATE(strategies, Traits, Rounded_traits) {
  Numbers random;
  const auto check = [&](const auto& strategy) {
    const Bezier<Traits> a(random.net<Traits>(2, 4, 0, true), random.domain(), random.domain()),
        b(random.net<Traits>(2, 3, 8, true), random.domain(), random.domain());
    const auto r = representable_blend(a, v1, b, v0, strategy, Edge_direction::same);
    check_g2(a, v1, v0, r, Edge_direction::same);
    const auto shape = automatic_surface_shape(a, v1, b, v0, strategy, Edge_direction::same);
    BOOST_CHECK_LE(std::abs(r.start_join.beta / shape.start.beta[0] - 1), 0.13);
    BOOST_CHECK_LE(std::abs(r.end_join.beta / shape.end.beta[0] - 1), 0.13);
  };
  check(GC::Minimal_energy<3>());
  check(GC::Minimal_energy<2>());
  check(GC::Matching_second_derivative());
  check(GC::Minimal_second_derivative());
  check(GC::Normal_offset());
  check(GC::Given_parameters<double>{0.25, -0.5});
  check(GC::Fair());
}

struct Choice {
  GC::Minimal_energy<3> strategy;
  GC::Shape_parameters<Q> shape;
};
typedef GC::Coordinate_jet<Q, 0> Jet;

// Remembers for which jets it is asked.
struct Remembering_strategy {
  std::vector<Jet>* asked;
  Choice choose(const Jet& left, const Jet& right) const {
    *asked = {left, right};
    return {{}, {Q(1), Q(1)}};
  }
};

// The strategy chooses for the jets of the surfaces: of splines for those of their pieces next to
// the edge.
BOOST_AUTO_TEST_CASE(jets_of_splines) {
  typedef Bspline<Double> S;
  Numbers random;
  const auto asked = [](const auto& a, const auto& b) {
    std::vector<Jet> jets;
    representable_blend(a, v1, b, v0, Remembering_strategy{&jets}, Edge_direction::same);
    BOOST_REQUIRE_EQUAL(jets.size(), 2u);
    return jets;
  };
  const GC::Knot_vector<double> along(2, 0., 1.), first(2, 0., 8., {{4., 1}, {6., 1}}),
      second(3, 0., 4., {{0.5, 1}, {1., 1}});
  const S a(random.net<Double>(3, 5, 0, true), along, first), b(random.net<Double>(3, 6, 12, true), along, second);
  const std::vector<Jet> of_splines = asked(a, b),
                         of_pieces = asked(a.bezier_patches().back(), b.bezier_patches().front());
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j <= 2; ++j) BOOST_CHECK(of_splines[i][j] == of_pieces[i][j]);
}

// Where nothing is moved and the numbers are those of the shape, it is the blend with this shape.
BOOST_AUTO_TEST_CASE(a_blend_with_short_numbers) {
  Numbers random;
  const Bezier<Double> a(random.net<Double>(3, 2, 0, true)), b(random.net<Double>(3, 2, 6, true));
  const auto r = representable_blend(a, v1, b, v0);
  GC::Surface_blend_shape<Q> shape;
  shape.start.beta = {Q(r.start_join.beta)};
  shape.end.beta = {Q(r.end_join.beta)};
  // delta from one coordinate: of bilinear patches W = 0 and S_vv = delta T
  const Bezier<Exact> c = surface_exactly<Exact>(a), d = surface_exactly<Exact>(b), s = surface_exactly<Exact>(r.blend);
  const auto at = [](const Bezier<Exact>& surface, int i, int j) { return surface.coordinates(i, j)[1]; };
  shape.start.delta = {Q((Q(20) * (at(s, 0, 2) - Q(2) * at(s, 0, 1) + at(s, 0, 0))) / (at(c, 0, 1) - at(c, 0, 0)))};
  shape.end.delta = {Q((Q(20) * (at(s, 0, 3) - Q(2) * at(s, 0, 4) + at(s, 0, 5))) / (at(d, 0, 1) - at(d, 0, 0)))};
  BOOST_CHECK(blend(c, v1, d, v0, shape) == s);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(errors, Traits, Rounded_traits) {
  typedef typename Traits::Point P;
  typedef GC::Knot_vector<double> Knots;
  Numbers random;
  const auto patch = [&](int m, int n, int from) { return Bezier<Traits>(random.net<Traits>(m, n, from, true)); };
  const Bezier<Traits> a = patch(3, 3, 0), b = patch(4, 3, 8);
  const auto text = [](const auto& call) { return error_of(call); };
  const auto blended = [](const auto& s, Patch_edge es, const auto& t, Patch_edge et) {
    return representable_blend(s, es, t, et, GC::Minimal_energy<3>(), Edge_direction::same);
  };
  BOOST_CHECK_EQUAL(
      text([&] { blended(a, v1, b, v0); }),
      "not_representable: representable_blend: the edge v0 of the second surface: its degree or its knots "
      "are not those of the edge of the first surface");
  BOOST_CHECK_EQUAL(blended(a.elevate(1, 0), v1, b, v0).blend.degree_u(), 3);
  const Knots knots(2, 0., 1., {{0.5, 1}}), others(2, 0., 1., {{0.25, 1}}), loose(2, {-2, -1, 0, 1, 2, 3});
  const auto spline = [&](const Knots& u, const Knots& v, int from) {
    return Bspline<Traits>(random.net<Traits>(u.number_of_coefficients(), v.number_of_coefficients(), from, true), u,
                           v);
  };
  CHECK_ERROR(blended(spline(knots, knots, 0), v1, spline(others, knots, 8), v0), not_representable);
  CHECK_ERROR(blended(spline(knots, knots, 0), v1, spline(Knots(2, 0., 1.), knots, 8), v0), not_representable);
  // 1 - 2^-60 is no floating-point number
  const Knots narrow(2, 0x1p-60, 2., {{1., 1}});
  BOOST_CHECK_EQUAL(
      text([&] { blended(spline(knots, knots, 0), v1, spline(knots, narrow, 8), v0); }),
      "not_representable: representable_blend: the edge v0 of the second surface: the distance of knots next "
      "to it is no floating-point number");
  BOOST_CHECK_EQUAL(
      text([&] { blended(spline(knots, loose, 0), v1, spline(knots, knots, 8), v0); }),
      "not_representable: representable_blend: the edge v1 of the first surface: the knots across it are not "
      "clamped; clamp() makes them so");
  CHECK_ERROR(blended(patch(3, 1, 0), v1, a, v0), wrong_number_of_points);
  const Bezier<Traits> pole({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(0, 1, 0)}}),
      slow({{P(0, 0, 0), P(0, 1, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0), P(1, 1, 0)}}),
      // legs of one unit in the last place have no digits to spare
      stiff({{P(1, 1, 1), P(1, std::nextafter(1., 2.), 1)}, {P(2, 1, 1), P(2, std::nextafter(1., 2.), 1)}});
  const Bezier<Traits> line = patch(2, 2, 8);
  CHECK_ERROR(blended(pole, v1, line, v0), zero_tangent);
  CHECK_ERROR(blended(line, v0, pole, v1), zero_tangent);
  CHECK_ERROR(blended(slow, v1, line, v0), zero_tangent);
  BOOST_CHECK_EQUAL(
      text([&] { blended(line, v1, stiff, v0); }),
      "not_representable: representable_blend: the edge v0 of the second surface: the tangent is lost on each "
      "grid that leaves room for the blend");
}

BOOST_AUTO_TEST_CASE(other_dimensions) {
  typedef GC::Traits_d<CGAL::Cartesian_d<double>> Traits;
  const auto patch = [](int d, double from) {
    return Bezier<Traits>(net_of(2, 2, [&](int i, int j) {
      const double x[] = {1. * i, from + j, 0};
      return Traits::Point(d, x, x + d);
    }));
  };
  BOOST_CHECK_EQUAL(representable_blend(patch(2, 0), v1, patch(2, 3), v0).blend.dimension(), 2);
  CHECK_ERROR(representable_blend(patch(2, 0), v1, patch(3, 3), v0, GC::Minimal_energy<3>(), Edge_direction::same),
              dimension_mismatch);
}

BOOST_AUTO_TEST_SUITE_END()
