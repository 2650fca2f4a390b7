// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Jets and knot insertion of rational B-spline surfaces of doubles, and those of SISL and
// OpenCASCADE where they were found: all agree with the exact results up to roundings.

#define BOOST_TEST_MODULE peers_of_rational_surfaces

#include "support/peer_agreement.h"

namespace {

template <class Traits> using Surface = GC::Rational_bspline_surface<Traits>;

constexpr int number_of_surfaces = 120;

Surface<Double> random_surface(int p, int q) {
  const GC::Knot_vector<double> u = random_knots(p), v = random_knots(q);
  std::vector<std::vector<Double::Point>> net(u.number_of_coefficients());
  std::vector<std::vector<double>> weights(net.size());
  for (std::size_t i = 0; i < net.size(); ++i)
    for (int j = 0; j < v.number_of_coefficients(); ++j) {
      net[i].push_back(random_point());
      weights[i].push_back(random_weight());
    }
  return Surface<Double>(net, weights, u, v);
}

Surface<Exact> exact(const Surface<Double>& s) {
  std::vector<std::vector<Exact::Point>> net(s.number_of_points_u());
  std::vector<std::vector<Q>> weights(net.size());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      net[i].push_back(::exact(s.control_point(i, j)));
      weights[i].emplace_back(s.weight(i, j));
    }
  return Surface<Exact>(net, weights, ::exact(s.knots_u()), ::exact(s.knots_v()));
}

Surface<Double> random_surface(int number) { return random_surface(2 + number % 4, 2 + number / 4 % 4); }
double random_parameter(const std::pair<double, double>& domain) { return between(domain.first, domain.second); }

} // namespace

BOOST_AUTO_TEST_CASE(jets) {
  std::cout << "seed " << seed << '\n';
  Largest_error ours("jets"), bezier("jets of rational patches"), sisl("jets, SISL"), occt("jets, OpenCASCADE");
  for (int number = 0; number < number_of_surfaces; ++number) {
    const Surface<Double> s = random_surface(number);
    const Surface<Exact> e = exact(s);
    const std::vector<GC::Rational_bezier_patch<Double>> patches = s.bezier_patches();
    for (int repeat = 0; repeat < 2; ++repeat) {
      const double u = random_parameter(s.domain_u()), v = random_parameter(s.domain_v());
      const GC::Surface_jet<Exact> x = e.jet(Q(u), Q(v), 2);
      const Peer_bound bound(s.degree_u(), length_of_span(s.knots_u(), u), s.degree_v(),
                             length_of_span(s.knots_v(), v));
      const auto compare = [&](Largest_error& error, auto coordinate) {
        for (int i = 0; i <= 2; ++i)
          for (int j = 0; i + j <= 2; ++j)
            for (int l = 0; l < 3; ++l) error.compare(coordinate(i, j, l), x(i, j)[l], bound(i, j));
      };
      for (int k = 0; k <= 2; ++k) {
        const GC::Surface_jet<Double> jet = s.jet(u, v, k);
        for (int i = 0; i <= k; ++i)
          for (int j = 0; i + j <= k; ++j)
            for (int l = 0; l < 3; ++l) ours.compare(jet(i, j)[l], x(i, j)[l], bound(i, j));
      }
      for (const GC::Rational_bezier_patch<Double>& patch : patches)
        if (patch.domain_u().first <= u && u < patch.domain_u().second && patch.domain_v().first <= v &&
            v < patch.domain_v().second) {
          const GC::Surface_jet<Double> jet = patch.jet(u, v, 2);
          compare(bezier, [&](int i, int j, int l) { return jet(i, j)[l]; });
        }
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
      double derivatives[18], normal[3], parameters[2] = {u, v};
      int left_u = 0, left_v = 0, status = 0;
      s1421(peers::sisl_surface(s).get(), 2, parameters, &left_u, &left_v, derivatives, normal, &status);
      BOOST_REQUIRE_EQUAL(status, 0);
      compare(sisl, [&](int i, int j, int l) { return derivatives[3 * ((i + j) * (i + j + 1) / 2 + j) + l]; });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
      gp_Pnt p;
      gp_Vec d[3][3];
      peers::occt_surface(s)->D2(u, v, p, d[1][0], d[0][1], d[2][0], d[0][2], d[1][1]);
      compare(occt, [&](int i, int j, int l) { return i + j == 0 ? p.Coord(l + 1) : d[i][j].Coord(l + 1); });
#endif
    }
  }
}

BOOST_AUTO_TEST_CASE(knot_insertion) {
  Largest_error ours("insertion"), sisl("insertion, SISL"), occt("insertion, OpenCASCADE");
  for (int number = 0; number < number_of_surfaces; ++number) {
    const Surface<Double> s = random_surface(number);
    double u = random_parameter(s.domain_u()), v = random_parameter(s.domain_v());
    const Surface<Exact> e = exact(s).insert_u(Q(u)).insert_v(Q(v));
    // convex combinations, and their quotients
    const Peer_bound bound(s.degree_u(), 1, s.degree_v(), 1);
    const auto compare = [&](Largest_error& error, int m, int n, auto point, auto weight) {
      BOOST_REQUIRE_EQUAL(m, e.number_of_points_u());
      BOOST_REQUIRE_EQUAL(n, e.number_of_points_v());
      for (int i = 0; i < m; ++i)
        for (int j = 0; j < n; ++j) {
          error.compare(weight(i, j), e.weight(i, j), bound(0));
          for (int l = 0; l < 3; ++l) error.compare(point(i, j, l), e.control_point(i, j)[l], bound(0));
        }
    };
    const Surface<Double> r = s.insert_u(u).insert_v(v);
    compare(
        ours, r.number_of_points_u(), r.number_of_points_v(),
        [&](int i, int j, int l) { return r.control_point(i, j)[l]; }, [&](int i, int j) { return r.weight(i, j); });
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
    SISLSurf* result = nullptr;
    int status = 0;
    s1025(peers::sisl_surface(s).get(), &u, 1, &v, 1, &result, &status);
    BOOST_REQUIRE_EQUAL(status, 0);
    const peers::Sisl_surface refined(result);
    const auto number_at = [&](int i, int j, int l) { return refined->rcoef[4 * (j * refined->in1 + i) + l]; };
    compare(
        sisl, refined->in1, refined->in2, [&](int i, int j, int l) { return number_at(i, j, l) / number_at(i, j, 3); },
        [&](int i, int j) { return number_at(i, j, 3); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
    const Handle(Geom_BSplineSurface) surface = peers::occt_surface(s);
    surface->InsertUKnot(u, 1, 0);
    surface->InsertVKnot(v, 1, 0);
    compare(
        occt, surface->NbUPoles(), surface->NbVPoles(),
        [&](int i, int j, int l) { return surface->Pole(i + 1, j + 1).Coord(l + 1); },
        [&](int i, int j) { return surface->Weight(i + 1, j + 1); });
#endif
  }
}
