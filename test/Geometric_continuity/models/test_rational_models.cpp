// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Models of rational surfaces: spheres, tori, fillets; and the patches from which they are made.

#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>

BOOST_AUTO_TEST_SUITE(rational_models)

template <class Surface> std::string summary(const std::vector<Surface>& surfaces) {
  return text(GC::model_continuity(surfaces).summary);
}

// Each patch with another factor of its weights.
template <class Traits> std::vector<Patch<Traits>> with_factors(std::vector<Patch<Traits>> patches) {
  int factor = 1;
  for (Patch<Traits>& s : patches) s = with_factor(s, typename Traits::FT(factor++));
  return patches;
}

template <class Traits> struct Space {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point P;
  typedef typename Traits::Vector V;
  static V x(int a = 1) { return V(a, 0, 0); }
  static V y(int a = 1) { return V(0, a, 0); }
  static V z(int a = 1) { return V(0, 0, a); }
};

BOOST_AUTO_TEST_CASE_TEMPLATE(closed_surfaces, Traits, All_traits) {
  typedef Space<Traits> S;
  typedef typename Traits::FT FT;
  const typename S::P o(1, 2, 3);
  const auto pieces = [](const Spline<Traits>& s) { return with_factors<Traits>(s.bezier_patches()); };
  const auto whole = [](const Spline<Traits>& s) { return std::vector<Spline<Traits>>{s}; };
  // a sphere is G2 but for the meridians, whose normals vanish in the poles
  const Spline<Traits> sphere = GC::ellipsoid<Traits>(o, S::x(3), S::y(3), S::z(3));
  BOOST_CHECK_EQUAL(summary(pieces(sphere)), "4 G2, 0 G1, 8 G0 (8 vanishing normals), 0 boundary, 8 collapsed");
  BOOST_CHECK_EQUAL(summary(whole(sphere)), "0 G2, 0 G1, 1 G0 (1 vanishing normals), 0 boundary, 2 collapsed; "
                                            "knot lines: 1 G2, 0 G1, 3 G0");
  BOOST_CHECK_EQUAL(summary(pieces(GC::ellipsoid<Traits>(o, typename S::V(1, 1, 0), S::y(3), typename S::V(1, 0, 7)))),
                    summary(pieces(sphere)));
  const Spline<Traits> cylinder = GC::cylinder<Traits>(o, S::x(), S::y(), S::z(5));
  BOOST_CHECK_EQUAL(summary(pieces(cylinder)), "4 G2, 0 G1, 0 G0, 8 boundary, 0 collapsed");
  BOOST_CHECK_EQUAL(summary(whole(cylinder)),
                    "1 G2, 0 G1, 0 G0, 2 boundary, 0 collapsed; knot lines: 3 G2, 0 G1, 0 G0");
  BOOST_CHECK_EQUAL(summary(pieces(GC::cone<Traits>(o, S::x(), S::y(), S::z(), FT(0)))),
                    "0 G2, 0 G1, 4 G0 (4 vanishing normals), 4 boundary, 4 collapsed");
  const Spline<Traits> torus = GC::torus<Traits>(o, S::x(), S::y(), S::z(), FT(FT(1) / FT(4)));
  BOOST_CHECK_EQUAL(summary(pieces(torus)), "32 G2, 0 G1, 0 G0, 0 boundary, 0 collapsed");
  BOOST_CHECK_EQUAL(summary(whole(torus)), "2 G2, 0 G1, 0 G0, 0 boundary, 0 collapsed; knot lines: 6 G2, 0 G1, 0 G0");
  BOOST_CHECK_EQUAL(text(GC::model_continuity(pieces(sphere)).edges[0]).substr(0, 3), "0 u");
}

BOOST_AUTO_TEST_CASE(equations_of_elementary_surfaces) {
  typedef Space<Exact> S;
  const Exact::Point o(0, 0, 0);
  const Q r = fraction(2, 3);
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const Q v = fraction(j, 5);
      const auto on = [&](const Spline<Exact>& s, const Q& u, auto equation) {
        const Exact::Point p = s(u, v);
        return equation(p.x(), p.y(), p.z()) == Q(0);
      };
      BOOST_CHECK(on(GC::ellipsoid<Exact>(o, S::x(3), S::y(3), S::z(3)), fraction(i, 10),
                     [](const Q& x, const Q& y, const Q& z) { return Q(x * x + y * y + z * z - Q(9)); }));
      BOOST_CHECK(on(GC::cylinder<Exact>(o, S::x(3), S::y(3), S::z(3)), fraction(i, 20),
                     [](const Q& x, const Q& y, const Q&) { return Q(x * x + y * y - Q(9)); }));
      BOOST_CHECK(on(GC::cone<Exact>(o, S::x(), S::y(), S::z(), fraction(1, 2)), fraction(i, 20),
                     [](const Q& x, const Q& y, const Q& z) {
                       const Q radius = Q(1) - z / Q(2);
                       return Q(x * x + y * y - radius * radius);
                     }));
      BOOST_CHECK(on(GC::torus<Exact>(o, S::x(), S::y(), S::z(), r), fraction(i, 5),
                     // (x^2+y^2+z^2+1-r^2)^2 = 4 (x^2+y^2)
                     [&](const Q& x, const Q& y, const Q& z) {
                       const Q a = x * x + y * y + z * z + Q(1) - r * r;
                       return Q(a * a - Q(4) * (x * x + y * y));
                     }));
    }
  // points of a kernel tell their traits class
  const Exact::Vector x = S::x(2), y = S::y(), z = S::z(3);
  BOOST_CHECK(GC::parallelogram(o, x, y) == GC::parallelogram<Exact>(o, x, y));
  BOOST_CHECK(GC::parallelogram<Exact>(CGAL::ORIGIN, x, y) == GC::parallelogram(Exact::Point(0, 0, 0), x, y));
  BOOST_CHECK(GC::cone(o, x, y, z, fraction(1, 2)) == GC::cone<Exact>(o, x, y, z, fraction(1, 2)));
  BOOST_CHECK(GC::cylinder(o, x, y, z) == GC::cylinder<Exact>(o, x, y, z));
  BOOST_CHECK(GC::ellipsoid(o, x, y, z) == GC::ellipsoid<Exact>(o, x, y, z));
  BOOST_CHECK(GC::torus(o, x, y, z, fraction(1, 2)) == GC::torus<Exact>(o, x, y, z, fraction(1, 2)));
  CHECK_ERROR(GC::torus<Exact>(o, S::x(), S::y(), S::z(), Q(0)), empty_domain);
  CHECK_ERROR(GC::ellipsoid<Exact>(o, S::x(0), S::y(), S::z()), zero_direction);
  BOOST_CHECK(GC::parallelogram<Exact>(o, S::x(2), S::y(3))(fraction(1, 2), fraction(1, 3)) == Exact::Point(1, 1, 0));
}

// A box with two edges and the corner between them rounded with the radius 1: planes, quarters of
// cylinders and tori, and a cylinder that ends in another one.
BOOST_AUTO_TEST_CASE_TEMPLATE(fillets, Traits, All_traits) {
  typedef Space<Traits> S;
  typedef typename S::P P;
  typedef typename S::V V;
  typedef typename S::FT FT;
  typedef GC::Rational_bezier_curve<Traits> Curve;
  // planes z = 1 and x = 1 with the quarter of a cylinder about the y-axis between them
  const Curve arc({P(0, 0, 1), P(1, 0, 1), P(1, 0, 0)}, {FT(1), FT(1), FT(2)});
  const Patch<Traits> fillet = bezier_patch(GC::Extrusion_surface_3<Curve>(arc, S::y(2)));
  const Patch<Traits> top = GC::parallelogram<Traits>(P(-3, 0, 1), S::x(3), S::y(2)),
                      side = GC::parallelogram<Traits>(P(1, 0, -4), S::z(4), S::y(2));
  BOOST_CHECK_EQUAL(summary(with_factors<Traits>({top, fillet, side})), "0 G2, 2 G1, 0 G0, 8 boundary, 0 collapsed");
  // ends in a quarter of a torus about the axis x = -2, y = 0, parallel to z; where the profile
  // turns, planes go on as rings. The cylinder and the torus have other curvatures along the arc.
  typedef GC::Revolution_surface_3<Curve> Revolution;
  const auto turned = [](const Curve& c) {
    return bezier_patch(Revolution(c, P(-2, 0, 0), V(0, 0, 1), {FT(-1), FT(0)}));
  };
  const Patch<Traits> corner = turned(arc);
  const Patch<Traits> ring = turned(Curve({P(-1, 0, 1), P(0, 0, 1)}, {FT(1), FT(1)})),
                      wall = turned(Curve({P(1, 0, 0), P(1, 0, -4)}, {FT(1), FT(1)}));
  const std::vector<GC::Common_edge> common = GC::common_edges(with_factor(fillet, FT(3)), corner);
  BOOST_REQUIRE_EQUAL(common.size(), 1u);
  BOOST_CHECK(common[0].edge_a == v0 && common[0].edge_b == v1 && !common[0].reversed);
  BOOST_CHECK(GC::common_edges(fillet, fillet).empty() && GC::common_edges(fillet.reverse_u(), corner)[0].reversed);
  const auto model = GC::model_continuity(with_factors<Traits>({fillet, corner, ring, wall, side}));
  BOOST_CHECK_EQUAL(text(model.summary), "0 G2, 5 G1, 0 G0, 10 boundary, 0 collapsed");
  BOOST_CHECK(model.has_order(1) && !model.has_order(2));
  // the axis of the torus moved by a little: a crease on the arc is none, but the ring no longer
  // meets the plane
  const Patch<Traits> lifted =
      corner.transform([](const P& p) { return P(p.x(), p.y(), FT(p.z() + FT(1) / FT(1024))); });
  const std::vector<Patch<Traits>> broken{fillet, lifted};
  const auto apart = GC::model_continuity(broken);
  BOOST_CHECK_EQUAL(text(apart.summary), "0 G2, 0 G1, 0 G0, 8 boundary, 0 collapsed");
  const auto near = nearly_coincident_edges(broken, apart, {0.01, 0.001});
  BOOST_REQUIRE_EQUAL(near.size(), 1u);
  BOOST_CHECK(near[0].within.deviation.gap.lower <= 1. / 1024 && 1. / 1024 <= near[0].within.deviation.gap.upper);
  BOOST_CHECK(nearly_coincident_edges(broken, apart, {0.01, 0.0009}).empty());
}

BOOST_AUTO_TEST_CASE(swept_patches) {
  typedef GC::Rational_bezier_curve<Exact> Curve;
  typedef GC::Rational_bspline_curve<Exact> Spline_curve;
  typedef Exact::Point P;
  const Curve c({P(1, 0, 0), P(2, 1, 1), P(1, 3, 2)}, {Q(1), fraction(2, 3), Q(2)});
  const Spline_curve d = Spline_curve(c).insert(fraction(1, 3));
  const Exact::Point a(1, 2, 3);
  const Exact::Vector w(1, 2, -1);
  const auto same = [](const auto& surface, const auto& patch) {
    BOOST_CHECK(surface.domain_v() == patch.domain_v() && surface.domain_u() == patch.domain_u());
    for (const Q& u : {Q(0), fraction(1, 3), fraction(3, 4)})
      for (int i = 0; i <= 4; ++i) {
        const Q v = surface.domain_v().first + (surface.domain_v().second - surface.domain_v().first) * fraction(i, 4);
        const auto x = surface.jet(u, v, 2), y = patch.jet(u, v, 2);
        for (int k = 0; k <= 2; ++k)
          for (int l = 0; k + l <= 2; ++l) BOOST_CHECK(x(k, l) == y(k, l));
      }
  };
  for (const std::pair<Q, Q>& v : {std::make_pair(fraction(-1, 3), fraction(5, 2)), std::make_pair(Q(1), Q(2))}) {
    const GC::Revolution_surface_3<Curve> s(c, a, w, v);
    same(s, bezier_patch(s));
    if (v.first < Q(0)) same(s.complement(), bezier_patch(s.complement()));
    const GC::Revolution_surface_3<Spline_curve> t(d, a, w, v);
    same(t, bspline_surface(t));
    const GC::Extrusion_surface_3<Curve> e(c, w, v);
    same(e, bezier_patch(e));
    const GC::Extrusion_surface_3<Spline_curve> f(d, w, v);
    same(f, bspline_surface(f));
  }
  const GC::Revolution_surface_3<GC::Bezier_curve<Exact>> polynomial(GC::Bezier_curve<Exact>({P(1, 0, 0), P(2, 1, 1)}),
                                                                     a, w);
  same(polynomial, bezier_patch(polynomial));

  // full turns: all control points of the curve on the axis of the first parallel, and G2 all
  // around, for any axis
  for (const Exact::Vector& axis :
       {w, Exact::Vector(0, 0, 1), Exact::Vector(Q(1) / Q(1000), 0, Q(1) / Q(3000)), Exact::Vector(500, 3, 777)}) {
    const Spline<Exact> full = full_revolution(d, a, axis);
    BOOST_CHECK(full(fraction(1, 5), Q(0)) == c(fraction(1, 5)) && full(fraction(1, 5), Q(4)) == c(fraction(1, 5)));
    const Exact::Point opposite = full(fraction(1, 5), Q(2));
    const Exact::Vector chord = opposite - c(fraction(1, 5));
    BOOST_CHECK(chord * axis == Q(0));
    BOOST_CHECK(cross_product(CGAL::midpoint(opposite, c(fraction(1, 5))) - a, axis) == CGAL::NULL_VECTOR);
    BOOST_CHECK_EQUAL(summary(std::vector<Spline<Exact>>{full}),
                      "1 G2, 0 G1, 0 G0, 2 boundary, 0 collapsed; knot lines: 4 G2, 0 G1, 0 G0");
  }
  CHECK_ERROR(full_revolution(d, a, Exact::Vector(0, 0, 0)), zero_direction);
}

BOOST_AUTO_TEST_SUITE_END()
