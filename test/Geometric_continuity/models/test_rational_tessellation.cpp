// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangles of rational surfaces: without cracks, on the surface, and nowhere farther from it than
// the tolerance.

#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>

BOOST_AUTO_TEST_SUITE(rational_tessellation)

// Returns whether the middle of each triangle and of each of its sides is within the distance of
// the point of the patch with the middle of the parameters.
void check_distance(const Patch<Exact>& s, double distance) {
  const GC::Tessellation<Exact> mesh = GC::tessellate(s, GC::Chord_tolerance{distance});
  const Q bound = Q(distance) * Q(distance);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 4; ++k) { // without one corner, or with all
      Q u(0), v(0), n(0);
      Exact::Vector sum(0, 0, 0);
      for (int i = 0; i < 3; ++i) {
        if (i == k) continue;
        const auto& place = mesh.places[t[i]];
        u += place.u;
        v += place.v;
        n += Q(1);
        sum = sum + (mesh.points[t[i]] - CGAL::ORIGIN);
        BOOST_CHECK(mesh.points[t[i]] == s(place.u, place.v));
      }
      const Exact::Vector difference = sum / n - (s(Q(u / n), Q(v / n)) - CGAL::ORIGIN);
      BOOST_CHECK(!(bound < difference.squared_length()));
    }
}

BOOST_AUTO_TEST_CASE(triangles_are_within_the_tolerance) {
  Random random;
  for (int round = 0; round < 4; ++round) {
    const int p = random.integer(1, 2), q = random.integer(1, 3);
    const auto net = net_of(p + 1, q + 1, [&](int i, int j) {
      const int x = 4 * i + random.integer(-1, 1), y = 4 * j + random.integer(-1, 1);
      return Exact::Point(x, y, random.integer(-3, 3));
    });
    const auto weights = net_of(p + 1, q + 1, [&](int, int) { return fraction(random.integer(2, 9), 3); });
    check_distance(Patch<Exact>(net, weights, {Q(-1), Q(2)}, {Q(0), Q(1)}), 2);
  }
  // three quarters of a turn, with a weight that is not positive, far from the origin
  typedef GC::Revolution_surface_3<GC::Bezier_curve<Exact>> Revolution;
  const Patch<Exact> ring =
      bezier_patch(Revolution(GC::Bezier_curve<Exact>({Exact::Point(1001, 0, 7), Exact::Point(1002, 0, 8)}),
                              Exact::Point(1000, 0, 0), Exact::Vector(0, 0, 1), {Q(-2), Q(2)}));
  BOOST_CHECK(ring.weight(0, 1) == Q(-3));
  check_distance(ring, 0.5);
  // a factor of all weights changes nothing, and the bound is not far from that of the polynomial
  // patch where it is one
  const GC::Bezier_patch<Exact> saddle(
      {{Exact::Point(0, 0, 0), Exact::Point(0, 1, 0)}, {Exact::Point(1, 0, 0), Exact::Point(1, 1, 1)}});
  const double bound = GC::Patch_flatness(saddle).distance({2, 4});
  for (int factor : {1, 1000})
    BOOST_CHECK_CLOSE_FRACTION(GC::Patch_flatness(with_factor(Patch<Exact>(saddle), Q(factor))).distance({2, 4}), bound,
                               1e-12);
}

// Weights that differ very much: each part is halved three times, and no further.
BOOST_AUTO_TEST_CASE(weights_of_different_sizes) {
  typedef Exact::Point P;
  const Q large(1 << 20);
  const Patch<Exact> s({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0)}}, {{Q(1), large}, {Q(1), large}});
  // of the eighth by the eighth at the corner, where the denominators are smallest: x and w y are
  // its sides, w y of weighted points
  const double w = 1 + ((1 << 20) - 1) / 8., x = 0.125, y = (1 << 20) / 8. / w, r = std::hypot(x, y);
  const double sv = std::hypot((w - 1) * x, w * y) + (w - 1) * r, uv = (w - 1) * x + (w - 1) * w * x,
               vv = 2 * (w - 1) * sv;
  BOOST_CHECK_CLOSE_FRACTION(GC::Patch_flatness(s).distance({1, 1}), 64 * (2 * uv + vv) / 8, 1e-12);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(closed_surfaces_are_manifolds, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef typename Traits::Vector V;
  typedef typename Traits::FT FT;
  const P o(0, 0, 0);
  const V x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto edges = [](const auto& surface) {
    const auto mesh = GC::tessellate(surface, GC::Chord_tolerance{0.25});
    BOOST_CHECK(mesh.triangles.size() > 16);
    return GC::mesh_edges(mesh.triangles);
  };
  for (const Spline<Traits>& s :
       {GC::ellipsoid<Traits>(o, x, y, z), GC::torus<Traits>(o, x, y, z, FT(FT(1) / FT(4)))}) {
    const GC::Mesh_edges whole = edges(s);
    BOOST_CHECK(whole.boundary == 0 && whole.irregular == 0);
    std::vector<Patch<Traits>> patches = s.bezier_patches();
    int factor = 1;
    for (Patch<Traits>& patch : patches) patch = with_factor(patch, FT(factor++));
    const GC::Mesh_edges pieces = edges(patches);
    if constexpr (!std::is_floating_point_v<FT>) BOOST_CHECK(pieces.boundary == 0 && pieces.irregular == 0);
  }
  const GC::Mesh_edges tube = edges(GC::cylinder<Traits>(o, x, y, z));
  BOOST_CHECK(tube.boundary > 0 && tube.irregular == 0);
  const auto sphere = GC::tessellate(GC::ellipsoid<Traits>(o, x, y, z), GC::Uniform_grid{3});
  for (const P& p : sphere.points) {
    const double square = CGAL::to_double((p - o).squared_length());
    BOOST_CHECK(std::abs(square - 1) < 1e-14);
    if constexpr (!std::is_floating_point_v<FT>) BOOST_CHECK((p - o).squared_length() == FT(1));
  }
}

BOOST_AUTO_TEST_CASE(counts_of_edges) {
  typedef std::vector<std::array<std::size_t, 3>> Triangles;
  BOOST_CHECK_EQUAL(text(GC::mesh_edges(Triangles{{0, 1, 2}, {0, 2, 1}})), "3 edges, watertight");
  BOOST_CHECK_EQUAL(text(GC::mesh_edges(Triangles{{0, 1, 2}, {2, 1, 3}})), "5 edges, 4 on the boundary");
  BOOST_CHECK_EQUAL(text(GC::mesh_edges(Triangles{{0, 1, 2}, {1, 2, 3}})), "5 edges, 4 on the boundary, 1 irregular");
  BOOST_CHECK_EQUAL(text(GC::mesh_edges(Triangles{{0, 1, 2}, {0, 2, 1}, {0, 1, 2}, {0, 2, 1}})),
                    "3 edges, 3 irregular");
}

BOOST_AUTO_TEST_CASE(refused_tessellations) {
  const Exact::Point o(0, 0, 0);
  const Exact::Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Spline<Exact> s = GC::ellipsoid<Exact>(o, x, y, z);
  CHECK_ERROR(GC::tessellate(s, GC::Chord_tolerance{0}), unreachable_tolerance);
  CHECK_ERROR(GC::tessellate(s, GC::Chord_tolerance{1e-9}), work_limit);
  CHECK_ERROR(GC::tessellate(s, GC::Chord_tolerance{1e-30}), work_limit);
  CHECK_ERROR(GC::tessellate(s, GC::Uniform_grid{0}), wrong_number_of_points);
  // second derivatives that overflow
  typedef Double::Point P;
  const Patch<Double> huge({{P(0, 0, 0), P(0, 1, 0)}, {P(4e307, 0, 0), P(0, 4e307, 1)}, {P(0, 0, 4e307), P(2, 1, 0)}},
                           {{1, 1}, {2, 1}, {1, 1}});
  CHECK_ERROR(GC::tessellate(huge, GC::Chord_tolerance{1}), unreachable_tolerance);
}

// Six times the volume inside.
Q volume(const GC::Tessellation<Exact>& mesh) {
  Q sum(0);
  for (const auto& t : mesh.triangles)
    sum += CGAL::determinant(mesh.points[t[0]] - CGAL::ORIGIN, mesh.points[t[1]] - CGAL::ORIGIN,
                             mesh.points[t[2]] - CGAL::ORIGIN);
  return sum;
}

// Closed surfaces are outside outwards, whatever the direction of their parameters; each part of a
// model by itself.
BOOST_AUTO_TEST_CASE(solids_are_turned_outwards) {
  typedef Exact::Point Point;
  typedef Exact::Vector Vector;
  typedef GC::Rational_bspline_surface<Exact> Surface;
  const GC::Uniform_grid grid{2};
  std::vector<Surface> model;
  Q sum(0);
  for (const int turn : {1, -1}) {
    const Vector x(turn, 0, 0), y(0, 2, 0), z(0, 0, 3);
    const std::vector<Point> ring = {Point(2, 0, 9 * turn), Point(3, 0, 9 * turn), Point(3, 0, 10 * turn),
                                     Point(2, 0, 9 * turn)};
    const GC::Bspline_curve<Exact> profile(ring, {1, {0, 0, 1, 2, 3, 3}});
    for (const Surface& surface : {GC::ellipsoid<Exact>(Point(20 * turn, 5, 0), x, y, z),
                                   GC::torus<Exact>(Point(20 * turn, 0, 30), x, y, z, Q(1) / 3),
                                   GC::full_revolution(profile, Point(0, 0, 0), Vector(0, 0, 1))}) {
      const GC::Tessellation<Exact> mesh = GC::tessellate(surface, grid);
      BOOST_CHECK(GC::mesh_edges(mesh.triangles).watertight());
      BOOST_CHECK(volume(mesh) > 0);
      model.push_back(surface);
      sum += volume(mesh);
    }
  }
  BOOST_CHECK(volume(GC::tessellate(model, grid)) == sum);
  // an open one stays as it is: its triangles turn from u to v, here about the axis, seen from
  // inside
  const GC::Tessellation<Exact> open =
      GC::tessellate(GC::cylinder<Exact>(Point(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)), grid);
  for (const auto& t : open.triangles) {
    const Vector n = CGAL::normal(open.points[t[0]], open.points[t[1]], open.points[t[2]]);
    BOOST_CHECK(n * (open.points[t[0]] - Point(0, 0, 0)) < 0);
  }
}

// Every profile makes a surface, the same where it is the same curve.
BOOST_AUTO_TEST_CASE(revolution_of_any_profile) {
  typedef Exact::Point Point;
  const Point a(0, 0, 0);
  const Exact::Vector w(0, 0, 1);
  const std::vector<Point> points = {Point(1, 0, 0), Point(2, 0, 1), Point(1, 0, 2)};
  const GC::Bezier_curve<Exact> bezier(points);
  const auto expected = GC::full_revolution(GC::Rational_bspline_curve<Exact>(GC::Bspline_curve<Exact>(bezier)), a, w);
  BOOST_CHECK(GC::full_revolution(bezier, a, w) == expected);
  BOOST_CHECK(GC::full_revolution(GC::Bezier_curve<Exact, 2>(bezier), a, w) == expected);
  BOOST_CHECK(GC::full_revolution(GC::Bspline_curve<Exact>(bezier), a, w) == expected);
  BOOST_CHECK(GC::full_revolution(GC::Rational_bezier_curve<Exact>(bezier), a, w) == expected);
  BOOST_CHECK(GC::full_revolution(GC::Composite_bezier_curve<Exact>(points, {0, 1}), a, w) == expected);
}

BOOST_AUTO_TEST_SUITE_END()
