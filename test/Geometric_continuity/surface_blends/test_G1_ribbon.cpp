// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The G1 ribbon. With exact numbers all is compared with ==. The
// numbers of a ribbon that are not control points are exact with every kernel, and compared with ==
// there, too.

#include "support/exact_splines.h"

#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

typedef GC::Bernstein_polynomial<Q> Polynomial;
typedef GC::G1_ribbon<GC::Traits_3<Exact>> Ribbon;
using GC::Edge_defect;
using GC::Sign_pattern;

// The input: C and both neighbours.
struct Input {
  Curve<Exact> c, c1, c2;
  Ribbon ribbon(const Q& bulge = Q(0)) const { return GC::connect_g1(c, c1, c2, bulge); }
};

Input random_input(Random& random, const Knots& knots) {
  return {random_curve(random, knots), random_curve(random, knots), random_curve(random, knots)};
}

// The values and derivatives of alpha and beta at an end.
struct Demand {
  Q alpha, alpha_derivative, beta, beta_derivative;
};

// Curves whose cross derivatives and twists at the ends lie in the plane of D and C': C1 - C is D
// alpha + C' beta there, with its derivative, and anything between. `off` is added to the value and
// the derivative of C1 and of C2 at the start.
Input planar_input(Random& random, const Knots& knots, const Demand& start, const Demand& end,
                   const std::pair<Vector, Vector>& off = {Vector(3), Vector(3)}) {
  const Curve<Exact> c = random_curve(random, knots), d = random_curve(random, knots);
  const int n = knots.number_of_coefficients();
  std::vector<Vector> e = random.vectors(n), x1, x2;
  const auto value_and_derivative = [](const auto& cj, const auto& dj, const Demand& at) {
    return std::pair<Vector, Vector>(at.alpha * dj[0] + at.beta * cj[1],
                                     at.alpha_derivative * dj[0] + at.alpha * dj[1] + at.beta_derivative * cj[1] +
                                         at.beta * cj[2]);
  };
  auto first = value_and_derivative(c.start_jet(2), d.start_jet(1), start);
  const auto last = value_and_derivative(c.end_jet(2), d.end_jet(1), end);
  first.first += off.first;
  first.second += off.second;
  const Q a = knots.domain().first, b = knots.domain().second;
  e[0] = first.first;
  e[1] = first.first + Q((knots[4] - a) / Q(3)) * first.second;
  e[n - 1] = last.first;
  e[n - 2] = last.first - Q((b - knots[n - 1]) / Q(3)) * last.second;
  for (int i = 0; i < n; ++i) {
    x1.push_back(c.coordinates(i) + e[i]);
    x2.push_back(c.coordinates(i) + e[i] - Q(2) * d.coordinates(i));
  }
  return {c, curve(knots, x1), curve(knots, x2)};
}

// A parameter of the domain as one of [0, 1].
Q unit(const Knots& knots, const Q& u) {
  return Q((u - knots.domain().first) / (knots.domain().second - knots.domain().first));
}
// The derivative of a polynomial on [0, 1] with respect to the parameter of the domain.
Q derivative(const Polynomial& p, const Knots& knots, const Q& t) {
  return Q(p.derivative()(t) / (knots.domain().second - knots.domain().first));
}

// ---------------------------------------------------------------- what all ribbons have in common

void check_ribbon(const Input& in, const Ribbon& r, Random& random) {
  const Knots& knots = in.c.knots();
  // alpha_1 - alpha_2 = 2, beta_1 = beta_2
  BOOST_CHECK((r.alpha - r.alpha2 == Polynomial{Q(2), Q(2), Q(2), Q(2)}));
  BOOST_CHECK(r.beta == r.beta2);
  BOOST_CHECK_EQUAL(r.side1.degree_u(), 6);
  BOOST_CHECK_EQUAL(r.side1.degree_v(), 1);
  BOOST_CHECK(r.side1.knots_v() == GC::Knot_vector<Q>(1, Q(0), Q(1)));
  BOOST_CHECK(r.side2.knots_u() == r.side1.knots_u() && r.side2.knots_v() == r.side1.knots_v());
  for (const Q& u : parameters(knots, random)) {
    const Q t = unit(knots, u);
    const auto c = in.c.jet(u, 1), c1 = in.c1.jet(u, 0), c2 = in.c2.jet(u, 0);
    const Vector d = (c1[0] - c2[0]) / Q(2);
    for (const auto* side : {&r.side1, &r.side2}) {
      const Polynomial &alpha = side == &r.side1 ? r.alpha : r.alpha2, &beta = side == &r.side1 ? r.beta : r.beta2;
      const Vector t_k = alpha(t) * d + beta(t) * c[1];
      BOOST_CHECK(column((*side)(u, Q(0))) == c[0]);
      BOOST_CHECK(column((*side)(u, Q(1))) == c[0] + t_k);
      BOOST_CHECK(column((*side)(u, ratio(1, 3))) == c[0] + ratio(1, 3) * t_k);
    }
    // T_1 - T_2 = C_1 - C_2
    BOOST_CHECK(column(r.side1(u, Q(1))) - column(r.side2(u, Q(1))) == c1[0] - c2[0]);
  }
  // knots of multiplicity m become m + 4, and no more than needed
  const std::vector<Knots::Knot> old = knots.inner_knots(), all = r.side1.knots_u().inner_knots();
  BOOST_CHECK(r.side1.knots_u().is_clamped() && r.side1.knots_u().domain() == knots.domain());
  BOOST_REQUIRE_EQUAL(old.size(), all.size());
  const Curve<Exact> across = GC::boundary_curve(r.side1, Patch_edge::v1);
  for (std::size_t i = 0; i < old.size(); ++i) {
    BOOST_CHECK(old[i].value == all[i].value);
    BOOST_CHECK_EQUAL(old[i].multiplicity + 4, all[i].multiplicity);
    BOOST_CHECK_EQUAL(across.function().smoothness(old[i].value), 2 - old[i].multiplicity);
  }
  BOOST_CHECK(GC::boundary_curve(r.side1, Patch_edge::v0) == in.c.elevate(3).refine(r.side1.knots_u()));

  // the coordinates in the plane of D and C' are those of the nearest vectors
  const auto check_end = [&](const GC::Ribbon_end<Q>& report, const Q& t, const auto& c, const auto& c1,
                             const auto& c2) {
    const Vector d = (c1[0] - c2[0]) / Q(2), dd = (c1[1] - c2[1]) / Q(2), x = c1[0] - c[0], xx = c1[1] - c[1];
    const Vector rest = x - (r.alpha(t) * d + r.beta(t) * c[1]),
                 twist = xx - (derivative(r.alpha, knots, t) * d + r.alpha(t) * dd +
                               derivative(r.beta, knots, t) * c[1] + r.beta(t) * c[2]);
    BOOST_CHECK(dot(rest, d) == Q(0) && dot(rest, c[1]) == Q(0));
    BOOST_CHECK(dot(twist, d) == Q(0) && dot(twist, c[1]) == Q(0));
    BOOST_CHECK(report.position_residual == dot(rest, rest));
    BOOST_CHECK(report.twist_residual == dot(twist, twist));
    // F(e) = det(C1 - C + e (C1 - C)', ...) is a cubic in e
    const Vector y = c2[0] - c[0], yy = c2[1] - c[1];
    const auto f = [&](int e) { return det(x + Q(e) * xx, y + Q(e) * yy, c[1] + Q(e) * c[2]); };
    BOOST_CHECK(report.determinant == f(0));
    BOOST_CHECK(report.determinant_derivative == Q((Q(8) * (f(1) - f(-1)) - (f(2) - f(-2))) / Q(12)));
    // the demands can be met if and only if F = 0, and then F' = 0
    BOOST_CHECK_EQUAL(report.position_residual == Q(0), report.determinant == Q(0));
    if (report.determinant == Q(0))
      BOOST_CHECK_EQUAL(report.twist_residual == Q(0), report.determinant_derivative == Q(0));
  };
  check_end(r.start, Q(0), in.c.start_jet(2), in.c1.start_jet(1), in.c2.start_jet(1));
  check_end(r.end, Q(1), in.c.end_jet(2), in.c1.end_jet(1), in.c2.end_jet(1));
  BOOST_CHECK_EQUAL(r.position_coplanar(), r.start.determinant == Q(0) && r.end.determinant == Q(0));
  if (r.position_coplanar())
    BOOST_CHECK_EQUAL(r.twist_coplanar(),
                      r.start.determinant_derivative == Q(0) && r.end.determinant_derivative == Q(0));

  // no fold if and only if 0 < alpha_1 < 2; each span is G1 exactly where that holds on it
  BOOST_CHECK(r.alpha_signs() == GC::sign_pattern(r.alpha));
  BOOST_CHECK(r.two_minus_alpha_signs() == GC::sign_pattern(Polynomial{Q(0)} - r.alpha2));
  const std::vector<GC::Edge_continuity<Q>> continuity = r.continuity();
  BOOST_REQUIRE_EQUAL(continuity.size(), old.size() + 1);
  bool all_g1 = true;
  for (std::size_t i = 0; i < continuity.size(); ++i) {
    const Q a = i == 0 ? knots.domain().first : old[i - 1].value,
            b = i < old.size() ? old[i].value : knots.domain().second;
    const Q s = unit(knots, a), t = unit(knots, b);
    const bool g1 = GC::sign_pattern(r.alpha.restricted(s, t)) == Sign_pattern::positive &&
                    GC::sign_pattern(r.alpha2.restricted(s, t)) == Sign_pattern::negative;
    BOOST_CHECK(continuity[i].coplanar && !continuity[i].reversed);
    BOOST_CHECK_EQUAL(continuity[i].g_order >= 1, g1);
    BOOST_CHECK_EQUAL(continuity[i].side == Sign_pattern::negative, g1);
    for (const auto& place : {continuity[i].vanishing})
      if (place) BOOST_CHECK(a <= place->first && place->first <= place->second && place->second <= b);
    if (continuity[i].deviation) BOOST_CHECK(a <= continuity[i].deviation->begin && continuity[i].deviation->end <= b);
    all_g1 = all_g1 && g1;
  }
  BOOST_CHECK_EQUAL(r.g1(), all_g1);
  BOOST_CHECK_EQUAL(r.folds(), !all_g1);
}

// ---------------------------------------------------------------- exact ribbons

BOOST_AUTO_TEST_CASE(generic_ribbons) {
  int folds = 0;
  repeat(3, [&](Random& random) {
    const Input in = random_input(random, random.knots(3, 2));
    const Ribbon r = in.ribbon();
    check_ribbon(in, r, random);
    BOOST_CHECK(!r.position_coplanar() && !r.twist_coplanar()); // by least squares only
    BOOST_CHECK_EQUAL(r.alpha.degree(), 3);
    BOOST_CHECK_EQUAL(r.beta.degree(), 3);
    folds += r.folds();
  });
  BOOST_CHECK(0 < folds);
}

BOOST_AUTO_TEST_CASE(demands_in_the_plane_are_met) {
  repeat(12, [](Random& random) {
    const Knots knots = random.knots(3, 2);
    const Q length = knots.domain().second - knots.domain().first;
    const auto demand = [&] { // 0 < alpha < 2 at the ends and at the control points between them
      return Demand{random.between(Q(1), ratio(3, 2)), Q(random.between(Q(-2), Q(1)) / length), random.number(),
                    random.number()};
    };
    const Demand start = demand(), end = demand();
    const Input in = planar_input(random, knots, start, end);
    const Ribbon r = in.ribbon();
    check_ribbon(in, r, random);
    BOOST_CHECK(r.position_coplanar() && r.twist_coplanar());
    BOOST_CHECK(r.start.determinant == Q(0) && r.start.determinant_derivative == Q(0));
    BOOST_CHECK(r.end.determinant == Q(0) && r.end.determinant_derivative == Q(0));
    for (const auto& [at, t] : {std::make_pair(start, Q(0)), {end, Q(1)}}) {
      BOOST_CHECK(r.alpha(t) == at.alpha && derivative(r.alpha, knots, t) == at.alpha_derivative);
      BOOST_CHECK(r.beta(t) == at.beta && derivative(r.beta, knots, t) == at.beta_derivative);
    }
    // the cross derivatives and twists of the surfaces are those of the curves
    for (const Q& u : {knots.domain().first, knots.domain().second}) {
      const auto c = in.c.jet(u, 1), c1 = in.c1.jet(u, 1), c2 = in.c2.jet(u, 1);
      for (const Q& v : {Q(0), Q(1)}) {
        BOOST_CHECK(column(r.side1.partial(u, v, 0, 1)) == c1[0] - c[0]);
        BOOST_CHECK(column(r.side2.partial(u, v, 0, 1)) == c2[0] - c[0]);
        BOOST_CHECK(column(r.side1.partial(u, v, 1, 1)) == c1[1] - c[1]);
        BOOST_CHECK(column(r.side2.partial(u, v, 1, 1)) == c2[1] - c[1]);
      }
    }
  });
}

// Moved out of the plane at one end, by a vector or with a derivative normal to it: the residual is
// its square.
BOOST_AUTO_TEST_CASE(demands_out_of_the_plane_are_not_met) {
  repeat(4, [](Random& random) {
    const Knots knots = random.knots(3, 2);
    const Demand start{Q(1), random.number(), random.number(), random.number()},
        end{random.number(), random.number(), random.number(), random.number()};
    Random same = random;
    const Input planar = planar_input(random, knots, start, end);
    const Vector normal =
        ratio(1, 1000000) * cross(planar.c1.start_jet(0)[0] - planar.c2.start_jet(0)[0], planar.c.start_jet(1)[1]);
    const Q square = dot(normal, normal);

    Random again = same;
    const Input moved = planar_input(again, knots, start, end, {normal, Vector(3)});
    const Ribbon position = moved.ribbon();
    check_ribbon(moved, position, random);
    BOOST_CHECK(!position.position_coplanar());
    BOOST_CHECK(position.start.determinant != Q(0));
    BOOST_CHECK(position.start.position_residual == square);
    BOOST_CHECK(position.end.position_residual == Q(0) && position.end.twist_residual == Q(0));

    again = same;
    const Input turned = planar_input(again, knots, start, end, {Vector(3), normal});
    const Ribbon twist = turned.ribbon();
    check_ribbon(turned, twist, random);
    BOOST_CHECK(twist.position_coplanar() && !twist.twist_coplanar());
    BOOST_CHECK(twist.start.determinant == Q(0) && twist.start.determinant_derivative != Q(0));
    BOOST_CHECK(twist.start.position_residual == Q(0) && twist.start.twist_residual == square);
    BOOST_CHECK(twist.end.twist_residual == Q(0));
    BOOST_CHECK(twist.alpha == planar.ribbon().alpha && twist.beta == planar.ribbon().beta);
  });
}

// ---------------------------------------------------------------- folds

// The ribbon with a given cubic alpha, on [0, 1] with inner knots at the quarters.
Ribbon with_alpha(Random& random, const Polynomial& alpha) {
  const Knots knots(3, Q(0), Q(1), {{ratio(1, 4), 1}, {ratio(1, 2), 2}, {ratio(3, 4), 1}});
  const auto demand = [&](int t) {
    return Demand{alpha(Q(t)), alpha.derivative()(Q(t)), random.number(), random.number()};
  };
  const Demand start = demand(0), end = demand(1);
  const Input in = planar_input(random, knots, start, end);
  const Ribbon r = in.ribbon();
  BOOST_CHECK(r.alpha == alpha);
  check_ribbon(in, r, random);
  return r;
}

BOOST_AUTO_TEST_CASE(folds_are_detected_exactly) {
  repeat(1, [](Random& random) {
    const Q tiny = Q(Q(1) / Q(1000000000) / Q(1000000000) / Q(1000000000));
    const auto both = [&](const Polynomial& alpha, Sign_pattern expected, const std::vector<Edge_defect>& defects) {
      // alpha against 0, and its mirror image against 2, with the sides exchanged
      const Ribbon r = with_alpha(random, alpha), mirrored = with_alpha(random, Polynomial{Q(2)} - alpha);
      BOOST_CHECK_EQUAL(r.alpha_signs(), expected);
      BOOST_CHECK_EQUAL(mirrored.two_minus_alpha_signs(), expected);
      BOOST_CHECK_EQUAL(r.folds(), expected != Sign_pattern::positive);
      BOOST_CHECK_EQUAL(mirrored.folds(), r.folds());
      for (const Ribbon& x : {r, mirrored}) {
        const std::vector<GC::Edge_continuity<Q>> spans = x.continuity();
        BOOST_REQUIRE_EQUAL(spans.size(), 4u);
        for (int i = 0; i < 4; ++i) BOOST_CHECK_EQUAL(spans[i].defect, defects[i]);
      }
      return r;
    };
    const Edge_defect good = Edge_defect::curvature, fold = Edge_defect::fold, zero = Edge_defect::vanishing_normal;
    // 4 (t - 1/2)^2 touches 0 inside, at the double knot; a little above it does not, a little
    // below it crosses
    const Polynomial touching = Polynomial{Q(1), Q(-1), Q(1)}.elevated();
    const Ribbon touch = both(touching, Sign_pattern::nonnegative, {good, zero, zero, good});
    const std::vector<GC::Edge_continuity<Q>> spans = touch.continuity();
    BOOST_REQUIRE(spans[1].vanishing && spans[2].vanishing);
    BOOST_CHECK(spans[1].vanishing->first == ratio(1, 2) && spans[2].vanishing->second == ratio(1, 2));
    both(touching + Polynomial{tiny}, Sign_pattern::positive, {good, good, good, good});
    both(touching - Polynomial{tiny}, Sign_pattern::mixed, {good, fold, fold, good});
    // inside a span: 16/9 (t - 5/8)^2
    const Polynomial inside =
        (Polynomial{ratio(-5, 8), ratio(3, 8)} * Polynomial{ratio(-10, 9), ratio(6, 9)}).elevated();
    const Ribbon once = both(inside, Sign_pattern::nonnegative, {good, good, zero, good});
    BOOST_REQUIRE(once.continuity()[2].vanishing);
    BOOST_CHECK(once.continuity()[2].vanishing->first == ratio(5, 8));
    // crossing at 3/4, a knot; at an irrational parameter in the last span: 3/2 - 2 t^2
    both(Polynomial{ratio(3, 2), ratio(-1, 2)}.elevated(2), Sign_pattern::mixed, {good, good, zero, fold});
    both(Polynomial{ratio(3, 2), ratio(3, 2), ratio(-1, 2)}.elevated(), Sign_pattern::mixed, {good, good, good, fold});
    // 0 at an end: C1 - C is a multiple of C' there
    both(Polynomial{Q(0), Q(1)}.elevated(2), Sign_pattern::nonnegative, {zero, good, good, good});
    // never positive, and nowhere
    both(Polynomial{Q(-1), Q(-2)}.elevated(2), Sign_pattern::negative, {fold, fold, fold, fold});
    both(Polynomial{Q(0)}.elevated(3), Sign_pattern::zero, {zero, zero, zero, zero});
    // control points outside (0, 2) and values inside
    both(Polynomial{Q(1), ratio(-1, 10), ratio(-1, 10), Q(1)}, Sign_pattern::positive, {good, good, good, good});
  });
}

// ------------------------------------------------------------- other parameters, orders and shapes

// Knots that are not clamped describe the same curves.
BOOST_AUTO_TEST_CASE(knots_outside_the_domain) {
  repeat(2, [](Random& random) {
    std::vector<Q> u;
    for (int i = 0; i < 9; ++i) u.push_back(Q((i == 0 ? Q(-5) : u.back()) + (i == 5 ? Q(0) : ratio(i + 1, 3))));
    const Knots knots(3, u); // one inner knot, of multiplicity 2
    const Input in = random_input(random, knots);
    BOOST_REQUIRE(!knots.is_clamped());
    const Ribbon r = in.ribbon(), clamped = GC::connect_g1(in.c.clamp(), in.c1.clamp(), in.c2.clamp());
    BOOST_CHECK(r.side1 == clamped.side1 && r.side2 == clamped.side2);
    BOOST_CHECK(r.alpha == clamped.alpha && r.beta == clamped.beta);
    check_ribbon(in, r, random);
  });
}

// A quartic beta: the freedom that all demands leave.
BOOST_AUTO_TEST_CASE(bulges) {
  repeat(6, [](Random& random) {
    const Knots knots = random.knots(3, 2);
    const auto demand = [&] { return Demand{Q(1), Q(0), random.number(), random.number()}; };
    const Demand start = demand(), end = demand();
    const Input in = planar_input(random, knots, start, end);
    const Q bulge = random.number();
    const Ribbon flat = in.ribbon(), bulged = in.ribbon(bulge);
    check_ribbon(in, bulged, random);
    BOOST_CHECK(bulged.alpha == flat.alpha);
    BOOST_CHECK((bulged.beta - flat.beta == Polynomial{Q(0), Q(0), bulge, Q(0), Q(0)}));
    BOOST_CHECK(bulged.position_coplanar() && bulged.twist_coplanar());
    BOOST_CHECK(bulged.side1.knots_u() == flat.side1.knots_u());
    BOOST_CHECK(bulged.side1 != flat.side1 && bulged.g1() && flat.g1());
    // values and twists at the ends do not change
    for (const Q& u : {knots.domain().first, knots.domain().second})
      for (int i = 0; i <= 1; ++i)
        BOOST_CHECK(bulged.side1.partial(u, Q(0), i, 1) == flat.side1.partial(u, Q(0), i, 1));
  });
}

// ---------------------------------------------------------------- bad input

template <class K> Curve<K> whole_curve(const std::vector<std::vector<int>>& x, int a = 0, int b = 1) {
  typedef typename K::FT FT;
  std::vector<typename K::Point_3> points;
  for (const std::vector<int>& p : x) points.emplace_back(FT(p[0]), FT(p[1]), FT(p[2]));
  return Curve<K>(points.begin(), points.end(), GC::Knot_vector<FT>(3, FT(a), FT(b)));
}
// At these heights over 0, 1, 2 and 3.
Curve<Exact> at_heights(int y0, int y1, int y2, int y3) {
  return whole_curve<Exact>({{0, y0, 0}, {1, y1, 0}, {2, y2, 0}, {3, y3, 0}});
}

BOOST_AUTO_TEST_CASE(refused_curves) {
  typedef Exact K;
  const Curve<K> c = at_heights(0, 0, 0, 0), c1 = at_heights(1, 1, 1, 1), c2 = at_heights(-1, -1, -1, -1);
  const auto error = [](const auto& x, const auto& x1, const auto& x2) {
    return error_of([&] { GC::connect_g1(x, x1, x2); });
  };
  BOOST_CHECK_EQUAL(error(c, c1, c2), "no error");
  // D = 0 at one end
  BOOST_CHECK_EQUAL(error(c, at_heights(-1, 1, 1, 1), c2), "singular_frame: connect_g1: D and C' at the start");
  BOOST_CHECK_EQUAL(error(c, at_heights(1, 1, 1, -1), c2), "singular_frame: connect_g1: D and C' at the end");
  CHECK_ERROR(GC::connect_g1(c, c1, c1), singular_frame);
  // D parallel to C', and C' = 0
  BOOST_CHECK_EQUAL(error(c, whole_curve<K>({{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {7, -1, 0}}), c2),
                    "singular_frame: connect_g1: D and C' at the end");
  BOOST_CHECK_EQUAL(error(whole_curve<K>({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {3, 0, 0}}), c1, c2),
                    "singular_frame: connect_g1: D and C' at the start");
  // inside, both are allowed; the normal vanishes there
  const GC::G1_ribbon<GC::Traits_3<K>> waist = GC::connect_g1(c, at_heights(1, -1, -1, 1), at_heights(-1, 1, 1, -1));
  BOOST_CHECK(!waist.folds() && !waist.g1());
  BOOST_CHECK_EQUAL(waist.continuity()[0].defect, Edge_defect::vanishing_normal);

  BOOST_CHECK_EQUAL(error(c.elevate(), c1.elevate(), c2.elevate()),
                    "wrong_number_of_points: connect_g1: the curves must be cubic, not of degree 4");
  CHECK_ERROR(GC::connect_g1(c, c1.elevate(), c2), wrong_number_of_points);
  BOOST_CHECK_EQUAL(error(c, whole_curve<K>({{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}}, 0, 2), c2),
                    "parameter_outside_domain: connect_g1: the domains of the curves differ");
  BOOST_CHECK_EQUAL(error(c, c1, c2.insert(ratio(1, 2))),
                    "knot_multiplicity: connect_g1: the curves must have the same knots");
  CHECK_ERROR(GC::connect_g1(c.insert(ratio(1, 2), 2), c1.insert(ratio(1, 2)), c2.insert(ratio(1, 2))),
              knot_multiplicity);
  const auto cut = [](const Curve<K>& x, int times) { return x.insert(ratio(1, 2), times); };
  BOOST_CHECK_EQUAL(error(cut(c, 2), cut(c1, 2), cut(c2, 2)), "no error");
  BOOST_CHECK_EQUAL(error(cut(c, 3), cut(c1, 3), cut(c2, 3)),
                    "knot_multiplicity: connect_g1: an inner knot is repeated 3 times, more than 2");

  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits_d;
  const auto any = [](int d) {
    std::vector<Traits_d::Point> points;
    for (int i = 0; i < 4; ++i) {
      std::vector<Q> x(d, Q(i));
      x[d - 1] = Q(i * i);
      points.emplace_back(d, x.begin(), x.end());
    }
    return GC::Bspline_curve<Traits_d>(points.begin(), points.end(), Knots(3, Q(0), Q(1)));
  };
  CHECK_ERROR(GC::connect_g1(any(2), any(2), any(2)), dimension_mismatch);
  CHECK_ERROR(GC::connect_g1(any(3), any(3), any(2)), dimension_mismatch);
  CHECK_ERROR(GC::connect_g1(any(4), any(4), any(4)), dimension_mismatch);
}

// ---------------------------------------------------------------- rounded kernels

BOOST_AUTO_TEST_CASE_TEMPLATE(decisions_of_rounded_kernels_are_exact, K, Rounded_kernels) {
  typedef GC::G1_ribbon<GC::Traits_3<K>> Rounded_ribbon;
  Random random;
  for (int round = 0; round < 8; ++round) {
    const GC::Knot_vector<double> knots(3, {-0.1, -0.1, -0.1, -0.1, 0.3, 0.7, 0.7, 1.1, 1.1, 1.1, 1.1});
    std::vector<Curve<K>> rounded;
    std::vector<Curve<Exact>> exact;
    for (int k = 0; k < 3; ++k) {
      std::vector<typename K::Point_3> points;
      std::vector<Vector> x;
      for (int i = 0; i < knots.number_of_coefficients(); ++i) {
        // C runs in the direction of x, D in that of y, so that the normal is far from zero
        const auto number = [&](double from) { return from + random.integer(-99999, 99999) / 999983.0; };
        const double c[] = {number(i), number(k == 0 ? 0 : k == 1 ? 1 : -1), number(0)};
        points.emplace_back(c[0], c[1], c[2]);
        x.emplace_back(3);
        for (int j = 0; j < 3; ++j) x.back()[j] = Q(c[j]);
      }
      rounded.emplace_back(points.begin(), points.end(), knots);
      exact.push_back(curve(Knots(3, std::vector<Q>(knots.begin(), knots.end())), x));
    }
    const Rounded_ribbon r = GC::connect_g1(rounded[0], rounded[1], rounded[2]);
    const Ribbon e = GC::connect_g1(exact[0], exact[1], exact[2]);
    static_assert(std::is_same_v<typename Rounded_ribbon::Field, Q>);
    BOOST_CHECK(r.alpha == e.alpha && r.beta == e.beta && r.alpha2 == e.alpha2 && r.beta2 == e.beta2);
    BOOST_CHECK(r.start.determinant == e.start.determinant && r.end.determinant == e.end.determinant);
    BOOST_CHECK(r.start.determinant_derivative == e.start.determinant_derivative);
    BOOST_CHECK(r.start.position_residual == e.start.position_residual);
    BOOST_CHECK(r.end.twist_residual == e.end.twist_residual);
    BOOST_CHECK(e.g1() && !e.folds() && !r.folds());
    // rounded control points are not exactly G1, which is not passed over in silence: a few hundred
    // roundings of numbers up to 10, of vectors that are not shorter than 1/2
    BOOST_CHECK(!r.g1());
    for (const GC::Edge_continuity<Q>& span : r.continuity()) {
      BOOST_CHECK_EQUAL(span.side, Sign_pattern::negative);
      BOOST_REQUIRE(span.deviation);
      BOOST_CHECK_LT(span.deviation->largest_angle(), 1e-11);
    }
    for (std::size_t i = 0; i < e.side1.knots_u().knots().size(); ++i)
      BOOST_CHECK(Q(r.side1.knots_u()[static_cast<int>(i)]) == e.side1.knots_u()[static_cast<int>(i)]);
    for (int i = 0; i < e.side2.number_of_points_u(); ++i)
      for (int j = 0; j < 2; ++j)
        for (int x = 0; x < 3; ++x)
          BOOST_CHECK_SMALL(r.side2.coordinates(i, j)[x] - CGAL::to_double(e.side2.coordinates(i, j)[x]), 1e-12);
  }
  // where no number is rounded, the ribbon is G1
  const Curve<K> c = whole_curve<K>({{0, 0, 0}, {20, 0, 0}, {40, 0, 0}, {60, 0, 0}}),
                 c1 = whole_curve<K>({{0, 60, 0}, {20, 60, 0}, {40, 60, 20}, {60, 60, 0}}),
                 c2 = whole_curve<K>({{0, -60, 0}, {20, -60, 0}, {40, -60, -20}, {60, -60, 0}});
  const Rounded_ribbon flat = GC::connect_g1(c, c1, c2);
  BOOST_CHECK(flat.g1() && flat.position_coplanar());
  // a fold of one unit in the last place
  BOOST_CHECK_EQUAL(flat.alpha_signs(), Sign_pattern::positive);
  const auto big = [](double x, double y) {
    const typename K::Point_3 p[] = {{x, y, 0}, {x + 1, y, 0}, {x + 2, y, 0}, {x + 3, y, 0}};
    return Curve<K>(p, p + 4, GC::Knot_vector<double>(3, 0, 1));
  };
  BOOST_CHECK(!GC::connect_g1(big(0, 0), big(0, 0x1p-52), big(0, -1)).folds());
  BOOST_CHECK(GC::connect_g1(big(0, 1), big(0, 1), big(0, -1)).folds());
  BOOST_CHECK(GC::connect_g1(big(0, 1), big(0, 1 - 0x1p-52), big(0, -1)).folds());
  BOOST_CHECK(!GC::connect_g1(big(0, 1), big(0, 1 + 0x1p-52), big(0, -1)).folds());
  const auto huge = [](double y) {
    const typename K::Point_3 p[] = {{0, y, 0}, {1e308, y, 0}, {-1e308, y, 0}, {1, y, 0}};
    return Curve<K>(p, p + 4, GC::Knot_vector<double>(3, 0, 1e-3));
  };
  CHECK_ERROR(GC::connect_g1(huge(0), huge(1), huge(-1)), not_finite);
}

BOOST_AUTO_TEST_CASE(output) {
  const Curve<Exact> c = at_heights(0, 0, 0, 0), c1 = at_heights(1, 1, 1, 1),
                     c2 = whole_curve<Exact>({{0, -1, 0}, {1, -1, 0}, {2, -1, 0}, {3, 3, 5}});
  // at the end: D = (0, -1, -5/2), x = (0, 1, 0)
  BOOST_CHECK_EQUAL(text(GC::connect_g1(c, c1, c2)),
                    "alpha: 1 1 -248/841 -4/29\n"
                    "beta: 0 0 0 0\n"
                    "start: F = 0, F' = 0, squared residuals: position 0, twist 0\n"
                    "end: F = 15, F' = 45, squared residuals: position 25/29, twist 3600/24389\n"
                    "first derivatives not attained, twists not attained\n"
                    "alpha is mixed, 2 - alpha is positive: fold");
  BOOST_CHECK_EQUAL(text(GC::connect_g1(c, c1, at_heights(-1, -1, -1, -1))),
                    "alpha: 1 1 1 1\n"
                    "beta: 0 0 0 0\n"
                    "start: F = 0, F' = 0, squared residuals: position 0, twist 0\n"
                    "end: F = 0, F' = 0, squared residuals: position 0, twist 0\n"
                    "first derivatives attained, twists attained\n"
                    "alpha is positive, 2 - alpha is positive: no fold");
}
