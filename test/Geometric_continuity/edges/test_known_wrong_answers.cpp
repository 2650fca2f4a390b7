// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins and edges that other programs are known to judge wrongly. Each test writes down the rule
// that is led astray, shows that it is, and checks the exact answer.

#include "support/decided_joins.h"
#include "support/net_of.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>

BOOST_AUTO_TEST_SUITE(known_wrong_answers)

typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Epick> Kernels;

template <class K> using Curve2 = GC::Bezier_curve<GC::Traits_2<K>>;
template <class K> using Curve3 = GC::Bezier_curve<GC::Traits_3<K>>;
template <class K> using Patch = GC::Bezier_patch<GC::Traits_3<K>>;
typedef GC::Bernstein_polynomial<Q> Polynomial;
using GC::Edge_defect;
using GC::Sign_pattern;
constexpr GC::Patch_edge v0 = GC::Patch_edge::v0;
const double pi = std::acos(-1.0), tolerance = 1e-6; // what the rules use

// The patch C(u) + v T(u) + v^2 W(u), where the coordinates are polynomials with coefficients that
// every kernel can represent.
typedef std::array<Polynomial, 3> Column;
template <class K, class FT = typename K::FT> Patch<K> patch(const Column& c, const Column& t, const Column& w) {
  int n = 0;
  for (const Column* x : {&c, &t, &w})
    for (const Polynomial& p : *x) n = std::max(n, p.degree());
  return Patch<K>(net_of(n + 1, 3, [&](int i, int j) {
    FT b[3];
    for (int x = 0; x < 3; ++x) {
      const auto at = [&](const Column& a) { return a[x].elevated(n - a[x].degree())[i]; };
      b[x] = exactly<FT>(Q(at(c) + Q(j) / Q(2) * at(t) + Q(j == 2) * at(w)));
    }
    return typename K::Point_3(b[0], b[1], b[2]);
  }));
}

Polynomial constant(int x) { return Polynomial{Q(x)}; }
const Column x_axis{Polynomial{Q(0), Q(1)}, constant(0), constant(0)}, zero{constant(0), constant(0), constant(0)};
Column direction(const Polynomial& x, const Polynomial& y, const Polynomial& z) { return {x, y, z}; }
Column direction(int x, int y, int z) { return {constant(x), constant(y), constant(z)}; }

// The angle between two vectors in floating-point arithmetic.
template <class Vector> double angle_of(const Vector& a, const Vector& b) {
  const double x = CGAL::to_double(a * b), l = CGAL::to_double(a * a), m = CGAL::to_double(b * b);
  return std::acos(std::max(-1.0, std::min(1.0, x / std::sqrt(l * m))));
}

// The angle between the normals of two patches with the edge v = 0.
template <class K> double normal_angle(const Patch<K>& a, const Patch<K>& b, const typename K::FT& u) {
  return angle_of(a.normal(u, typename K::FT(0)), b.normal(u, typename K::FT(0)));
}

// Angles of lines: those beyond 90 degrees are folded back, which is right for lines and wrong for
// tangents and normals.
double folded(double angle) { return std::min(angle, pi - angle); }

// ---------------------------------------------------------------- angles modulo pi

// Wrong: "the tangents are parallel". The second curve runs back.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_cusp_is_not_g1, K, Kernels) {
  typedef typename K::Point_2 P;
  const Curve2<K> in{P(0, 0), P(2, 0), P(4, 2)}, back{P(4, 2), P(2, 0), P(3, -5)}, on{P(4, 2), P(6, 4), P(9, 0)};
  const auto tangent_angle = [](const Curve2<K>& a, const Curve2<K>& b) {
    const auto x = a.end_jet(1).derivative(1), y = b.start_jet(1).derivative(1);
    return angle_of(x, y);
  };
  BOOST_CHECK_LT(folded(tangent_angle(in, back)), tolerance); // accepted
  BOOST_CHECK_LT(folded(tangent_angle(in, on)), tolerance);
  const auto cusp = GC::continuity(in, back), smooth = GC::continuity(in, on);
  BOOST_CHECK_EQUAL(cusp.c_order, 0);
  BOOST_CHECK_EQUAL(cusp.g_order, 0);
  BOOST_CHECK_EQUAL(cusp.f_order, 0);
  BOOST_CHECK(cusp.tangent_equal && !*cusp.tangent_equal);
  BOOST_CHECK(smooth.g_order >= 1 && *smooth.tangent_equal);
}

// Along an edge the surfaces lie on one side, as the two halves of a folded sheet do.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_folded_sheet_is_not_g1, K, Kernels) {
  const Patch<K> a = patch<K>(x_axis, direction(0, 1, 0), zero), b = patch<K>(x_axis, direction(1, 2, 0), zero),
                 c = patch<K>(x_axis, direction(1, -2, 0), zero);
  for (int k = 0; k <= 4; ++k) {
    const typename K::FT u = typename K::FT(typename K::FT(k) / typename K::FT(4));
    BOOST_CHECK_LT(folded(normal_angle<K>(a, b, u)), tolerance); // accepted
    BOOST_CHECK_LT(folded(normal_angle<K>(a, c, u)), tolerance);
  }
  const auto fold = GC::edge_continuity(a, v0, b, v0);
  BOOST_CHECK_EQUAL(fold.g_order, 0);
  BOOST_CHECK_EQUAL(fold.defect, Edge_defect::fold);
  BOOST_CHECK(fold.coplanar && !fold.normal_vanishes);
  BOOST_CHECK_EQUAL(fold.side, Sign_pattern::positive);
  BOOST_REQUIRE(fold.deviation);
  BOOST_CHECK(fold.deviation->lower == 2 && fold.deviation->upper == 2);
  BOOST_CHECK_GT(fold.deviation->largest_angle(), 3.14159265358979);
  BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, c, v0).g_order, 2);
  // a patch with itself
  BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, a, v0).defect, Edge_defect::fold);

  // on the other side on three quarters of the edge, then on the same side
  const Patch<K> mixed = patch<K>(x_axis, direction(constant(0), Polynomial{Q(-3), Q(1)}, constant(0)), zero);
  const auto turning = GC::edge_continuity(a, v0, mixed, v0);
  BOOST_CHECK_EQUAL(turning.g_order, 0);
  BOOST_CHECK_EQUAL(turning.defect, Edge_defect::fold);
  BOOST_CHECK_EQUAL(turning.side, Sign_pattern::mixed);
  BOOST_CHECK(turning.normal_vanishes);
  BOOST_REQUIRE(turning.vanishing);
  BOOST_CHECK(Q(turning.vanishing->first) == Q(3) / Q(4) && turning.vanishing->first == turning.vanishing->second);
  BOOST_REQUIRE(turning.deviation);
  BOOST_CHECK(turning.deviation->upper == 2 && Q(turning.deviation->end) > Q(3) / Q(4));
}

// ---------------------------------------------------------------- opposite normals

// Wrong: "tangents agree, curvatures are equal". The curves bend to opposite sides, or in
// perpendicular planes.
BOOST_AUTO_TEST_CASE_TEMPLATE(opposite_principal_normals_are_not_g2, K, Kernels) {
  typedef typename K::Point_3 P;
  const Curve3<K> in{P(-2, 2, 0), P(-1, 0, 0), P(0, 0, 0)}, up{P(0, 0, 0), P(1, 0, 0), P(2, 2, 0)},
      down{P(0, 0, 0), P(1, 0, 0), P(2, -2, 0)}, aside{P(0, 0, 0), P(1, 0, 0), P(2, 0, 2)};
  for (const Curve3<K>& out : {up, down, aside}) {
    const auto x = in.end_jet(2), y = out.start_jet(2);
    BOOST_CHECK_LT(angle_of(x.derivative(1), y.derivative(1)), tolerance);
    BOOST_CHECK(*GC::curvature_squared(x) == *GC::curvature_squared(y)); // accepted
    const auto join = GC::continuity(in, out);
    BOOST_CHECK(*join.curvature_equal && *join.tangent_equal);
    const bool same = out == up;
    BOOST_CHECK_EQUAL(*join.curvature_vector_equal, same);
    BOOST_CHECK_EQUAL(join.g_order >= 2, same);
    BOOST_CHECK(join.g_order >= 1);
  }
}

// ---------------------------------------------------------------- differences with a sign

// Wrong: "difference < tolerance", without a modulus: what decreases is always accepted.
BOOST_AUTO_TEST_CASE_TEMPLATE(differences_have_no_sign, K, Kernels) {
  typedef typename K::Point_2 P;
  const Curve2<K> in{P(-2, 4), P(-1, 0), P(0, 0)}, flatter{P(0, 0), P(1, 0), P(2, 2)}, same{P(0, 0), P(1, 0), P(2, 4)};
  const auto squared = [](const auto& jet) { return CGAL::to_double(*GC::curvature_squared(jet)); };
  const double left = squared(in.end_jet(2)), right = squared(flatter.start_jet(2));
  BOOST_CHECK_LT(right - left, tolerance); // accepted
  BOOST_CHECK_GT(left - right, 1);
  BOOST_CHECK_EQUAL(GC::continuity(in, flatter).g_order, 1);
  BOOST_CHECK_EQUAL(GC::continuity(flatter.reverse(), in.reverse()).g_order, 1);
  BOOST_CHECK(GC::continuity(in, same).g_order >= 2);
  // det(C', T1, T2) negative, positive, and of both signs
  const Patch<K> a = patch<K>(x_axis, direction(0, 1, 0), zero);
  for (const Polynomial& z :
       {constant(-1), constant(1), Polynomial{Q(-1), Q(1)}, Polynomial{Q(0), Q(-1), Q(0)}, Polynomial{Q(-1), Q(0)}}) {
    const auto e = GC::edge_continuity(a, v0, patch<K>(x_axis, direction(constant(0), constant(-1), z), zero), v0);
    BOOST_CHECK_EQUAL(e.g_order, 0);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::crease);
  }
}

// --------------------------------------------------------- cross derivatives that are not parallel

// Wrong: "T1 and T2 are parallel", or the control points across the edge collinear. Both may have a
// part along the edge.
template <class K, class FT = typename K::FT> bool parallel_cross_derivatives(const Patch<K>& a, const Patch<K>& b) {
  for (int k = 0; k <= 4; ++k) {
    const FT u = FT(FT(k) / FT(4));
    if (CGAL::cross_product(a.partial(u, FT(0), 0, 1), b.partial(u, FT(0), 0, 1)) != CGAL::NULL_VECTOR) return false;
  }
  return true;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(skew_coplanar_parallelograms_are_smooth, K, Kernels) {
  const Patch<K> a = patch<K>(x_axis, direction(7, 1, 0), zero);
  for (int skew : {-5, 0, 3}) {
    const Patch<K> b = patch<K>(x_axis, direction(skew, -2, 0), zero);
    BOOST_CHECK(!parallel_cross_derivatives<K>(a, b)); // refused
    const auto e = GC::edge_continuity(a, v0, b, v0);
    BOOST_CHECK_EQUAL(e.g_order, 2);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::none);
  }
  // with any polynomial as the part along the edge
  const Patch<K> c = patch<K>(x_axis, direction(Polynomial{Q(3), Q(-8), Q(1)}, constant(1), constant(0)), zero),
                 d = patch<K>(x_axis, direction(Polynomial{Q(-2), Q(5)}, constant(-2), constant(0)), zero);
  BOOST_CHECK(!parallel_cross_derivatives<K>(c, d));
  BOOST_CHECK_EQUAL(GC::edge_continuity(c, v0, d, v0).g_order, 2);
}

BOOST_AUTO_TEST_CASE(ribbons_with_a_part_along_the_edge_are_smooth) {
  typedef CGAL::Simple_cartesian<Q> K;
  typedef K::Point_3 P;
  typedef GC::Bspline_curve<GC::Traits_3<K>> Curve;
  const auto curve = [](const std::vector<P>& p) {
    return Curve(p.begin(), p.end(), GC::Knot_vector<Q>(3, Q(0), Q(1)));
  };
  // C1 - C = D + C', C2 - C = -D + C' at the ends: beta = 1
  const Curve c = curve({P(0, 0, 0), P(1, 0, 1), P(2, 0, 1), P(3, 0, 0)}),
              c1 = curve({P(3, 1, 3), P(4, 2, 2), P(5, 2, 0), P(6, 1, -3)}),
              c2 = curve({P(3, -1, 3), P(4, 0, 1), P(5, 0, 1), P(6, -1, -3)});
  const auto ribbon = GC::connect_g1(c, c1, c2);
  BOOST_CHECK(ribbon.position_coplanar());
  BOOST_CHECK(ribbon.beta(Q(0)) == Q(1) && ribbon.beta(Q(1)) == Q(1));
  const Patch<K> s1 = ribbon.side1.bezier_patches()[0], s2 = ribbon.side2.bezier_patches()[0];
  BOOST_CHECK(!parallel_cross_derivatives<K>(s1, s2)); // refused
  BOOST_CHECK(!ribbon.folds());
  BOOST_CHECK(ribbon.g1());
  BOOST_CHECK_GE(GC::edge_continuity(s1, v0, s2, v0).g_order, 1);
}

// ---------------------------------------------------------------- samples

// Wrong: "the normals agree at n + 1 parameters". The surfaces bend away from each other between
// them.
TEST_FOR_EACH(bumps_between_samples, K, Kernels) {
  for (int samples : {5, 21}) {
    if (samples == 21 && !std::is_same_v<FT, Q>) continue; // its coefficients are no doubles
    const int n = samples - 1;
    Polynomial bump{Q(4)}; // zero at k/n only
    for (int k = 0; k <= n; ++k) bump = bump * Polynomial{Q(Q(-k) / Q(n)), Q(Q(n - k) / Q(n))};
    // all coefficients are doubles for 5 samples
    const Column edge{Polynomial{Q(0), Q(n + 1)}, constant(0), constant(0)};
    const Patch<K> a = patch<K>(edge, direction(0, 1, 0), zero),
                   b = patch<K>(edge, direction(constant(0), constant(-1), constant(10) * bump), zero);
    const auto accepted = [&](int parts) {
      for (int k = 0; k <= parts; ++k)
        if (pi - normal_angle<K>(a, b, FT(FT(k) / FT(parts))) > tolerance) return false;
      return true;
    };
    BOOST_CHECK(accepted(n));
    BOOST_CHECK(n > 4 || !accepted(n + 1));
    const auto e = GC::edge_continuity(a, v0, b, v0);
    BOOST_CHECK_EQUAL(e.g_order, 0);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::crease);
    BOOST_REQUIRE(e.deviation);
    BOOST_CHECK_GT(e.deviation->smallest_angle(), 0);
    // the largest bump is next to an end
    BOOST_CHECK(Q(e.deviation->end) <= Q(1) / Q(n) || Q(e.deviation->begin) >= Q(n - 1) / Q(n));
  }
}

BOOST_AUTO_TEST_SUITE_END()
