// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The fairness of blends at fixed nodes against that of their curves to a precision.

#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>

BOOST_AUTO_TEST_SUITE(fairness_quadrature)

typedef CGAL::Simple_cartesian<double> K;

constexpr unsigned seed = 2026;
std::mt19937 engine(seed);
double number() { return (static_cast<int>(engine() % 2001) - 1000) / 1000.; }

template <int M> GC::Coordinate_vector<double, M> vector(double x, double jitter) {
  GC::Coordinate_vector<double, M> v(M);
  for (int i = 0; i < M; ++i) v[i] = (i == 0 ? x : 0) + jitter * number();
  return v;
}

// Blends of ends that roughly face each other, with some tangents.
template <GC::internal::Blend_kind kind, class Traits> void compare() {
  constexpr int M = GC::dimension_v<Traits>;
  typedef GC::internal::Fair_family<kind, M> Family;
  for (int run = 0; run < 20; ++run) {
    Family family{vector<M>(1, 0.3), {{}, 1}, {{}, -1}};
    for (int k = 0; k < Family::order; ++k) {
      family.start.d[k] = vector<M>(k == 0 ? 1 : 0, 0.5);
      family.end.d[k] = vector<M>(k == 0 ? 1 : 0, 0.5);
    }
    typename Family::Unknowns x;
    for (double& y : x) y = 0.3 * number();
    GC::internal::Fairness_quadrature<kind, M, 96> quadrature(family);
    const double fixed = quadrature.value(x);
    std::vector<typename Traits::Point> points{GC::to_point<Traits>(GC::Coordinate_vector<double, M>(M))};
    for (const auto& p : family.points(x)) points.push_back(GC::to_point<Traits>(p));
    const double precise = GC::fairness(GC::Bezier_curve<Traits>(points.begin(), points.end()));
    BOOST_TEST_CONTEXT("run " << run << ", E = " << precise)
    BOOST_CHECK(std::abs(fixed - precise) <= 1e-6 * precise);
  }
}

BOOST_AUTO_TEST_CASE(quintic_blends) {
  BOOST_TEST_MESSAGE("seed " << seed);
  compare<GC::internal::Blend_kind::g2, GC::Traits_2<K>>();
  compare<GC::internal::Blend_kind::g2, GC::Traits_3<K>>();
}

BOOST_AUTO_TEST_CASE(septic_blends) { compare<GC::internal::Blend_kind::g3, GC::Traits_2<K>>(); }

BOOST_AUTO_TEST_SUITE_END()
