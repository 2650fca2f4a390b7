// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Jets and knot insertion of rational B-spline curves of doubles, and those of SISL and OpenCASCADE
// where they were found: all agree with the exact results up to roundings.

#define BOOST_TEST_MODULE peers_of_rational_curves

#include "support/peer_agreement.h"

namespace {

template <class Traits> using Curve = GC::Rational_bspline_curve<Traits>;

constexpr int number_of_curves = 240;

Curve<Double> random_curve(int degree) {
  const GC::Knot_vector<double> knots = random_knots(degree);
  std::vector<Double::Point> points;
  std::vector<double> weights;
  for (int i = 0; i < knots.number_of_coefficients(); ++i) {
    points.push_back(random_point());
    weights.push_back(random_weight());
  }
  return Curve<Double>(points.begin(), points.end(), weights.begin(), weights.end(), knots);
}

Curve<Exact> exact(const Curve<Double>& c) {
  std::vector<Exact::Point> points;
  for (const Double::Point& p : c) points.push_back(::exact(p));
  const std::vector<Q> weights(c.weights().begin(), c.weights().end());
  return Curve<Exact>(points.begin(), points.end(), weights.begin(), weights.end(), ::exact(c.knots()));
}

// The start of the domain, and parameters inside.
std::vector<double> random_parameters(const Curve<Double>& c) {
  std::vector<double> u{c.domain().first};
  for (int i = 0; i < 3; ++i) u.push_back(between(c.domain().first, c.domain().second));
  return u;
}

} // namespace

BOOST_AUTO_TEST_CASE(jets) {
  std::cout << "seed " << seed << '\n';
  Largest_error ours("jets"), bezier("jets of rational Bezier curves"), sisl("jets, SISL"), occt("jets, OpenCASCADE");
  for (int i = 0; i < number_of_curves; ++i) {
    const Curve<Double> c = random_curve(2 + i % 4);
    const Curve<Exact> e = exact(c);
    const std::vector<GC::Rational_bezier_curve<Double>> pieces = c.bezier_pieces();
    for (double u : random_parameters(c)) {
      const GC::Curve_jet<Exact> x = e.jet(Q(u), 3);
      const Peer_bound bound(c.degree(), length_of_span(c.knots(), u));
      const auto compare = [&](Largest_error& error, auto coordinate) {
        for (int k = 0; k <= 3; ++k)
          for (int l = 0; l < 3; ++l) error.compare(coordinate(k, l), x[k][l], bound(k));
      };
      for (int k = 0; k <= 3; ++k) {
        const GC::Curve_jet<Double> jet = c.jet(u, k);
        for (int j = 0; j <= k; ++j)
          for (int l = 0; l < 3; ++l) ours.compare(jet[j][l], x[j][l], bound(j));
      }
      for (const GC::Rational_bezier_curve<Double>& piece : pieces)
        if (piece.domain().first <= u && u < piece.domain().second) {
          const GC::Curve_jet<Double> jet = piece.jet(u, 3);
          compare(bezier, [&](int k, int l) { return jet[k][l]; });
        }
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
      double derivatives[12];
      int left = 0, status = 0;
      s1221(peers::sisl_curve(c).get(), 3, u, &left, derivatives, &status);
      BOOST_REQUIRE_EQUAL(status, 0);
      compare(sisl, [&](int k, int l) { return derivatives[3 * k + l]; });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
      gp_Pnt p;
      gp_Vec d[3];
      peers::occt_curve(c)->D3(u, p, d[0], d[1], d[2]);
      compare(occt, [&](int k, int l) { return k == 0 ? p.Coord(l + 1) : d[k - 1].Coord(l + 1); });
#endif
    }
  }
}

BOOST_AUTO_TEST_CASE(knot_insertion) {
  Largest_error ours("insertion"), sisl("insertion, SISL"), occt("insertion, OpenCASCADE");
  for (int i = 0; i < number_of_curves; ++i) {
    const Curve<Double> c = random_curve(2 + i % 4);
    const double u = between(c.domain().first, c.domain().second);
    const int times = 1 + below(c.degree());
    const Curve<Exact> e = exact(c).insert(Q(u), times);
    // convex combinations, and their quotients
    const Peer_bound bound(c.degree(), 1);
    const auto compare = [&](Largest_error& error, int n, auto point, auto weight) {
      BOOST_REQUIRE_EQUAL(n, e.number_of_points());
      for (int j = 0; j < n; ++j) {
        error.compare(weight(j), e.weight(j), bound(0));
        for (int l = 0; l < 3; ++l) error.compare(point(j, l), e.control_point(j)[l], bound(0));
      }
    };
    const Curve<Double> r = c.insert(u, times);
    BOOST_CHECK(exact(r).knots() == e.knots());
    compare(
        ours, r.number_of_points(), [&](int j, int l) { return r.control_point(j)[l]; },
        [&](int j) { return r.weight(j); });
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
    std::vector<double> copies(times, u);
    SISLCurve* result = nullptr;
    int status = 0;
    s1018(peers::sisl_curve(c).get(), copies.data(), times, &result, &status);
    BOOST_REQUIRE_EQUAL(status, 0);
    const peers::Sisl_curve refined(result);
    compare(
        sisl, refined->in, [&](int j, int l) { return refined->rcoef[4 * j + l] / refined->rcoef[4 * j + 3]; },
        [&](int j) { return refined->rcoef[4 * j + 3]; });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
    const Handle(Geom_BSplineCurve) curve = peers::occt_curve(c);
    curve->InsertKnot(u, times, 0);
    compare(
        occt, curve->NbPoles(), [&](int j, int l) { return curve->Pole(j + 1).Coord(l + 1); },
        [&](int j) { return curve->Weight(j + 1); });
#endif
  }
}
