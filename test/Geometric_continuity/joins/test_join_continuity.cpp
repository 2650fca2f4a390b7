// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Equal jets, and the joins of jets with another parameter.

#include "support/jets.h"

#include <CGAL/Geometric_continuity/joins/join_continuity.h>

typedef std::tuple<Exact_2, Exact_3> Exact_dimensions;

// Equal jets need no forms, and have the answers of a right jet with another parameter, for which
// they are computed.
BOOST_AUTO_TEST_CASE_TEMPLATE(equal_jets, Traits, Exact_dimensions) {
  std::mt19937 random = seeded(20261122);
  constexpr int N = GC::dimension_v<Traits>;
  for (int i = 0; i < 300; ++i) {
    const int order = i % 7, max_order = static_cast<int>(random() % 8), least = (std::min)(order, max_order);
    GC::Coordinate_jet<Q, N> x(N, order), y(N, order);
    for (int j = 0; j <= order; ++j)
      for (int d = 0; d < N; ++d) {
        x[j][d] = Q(static_cast<int>(random() % 3) - 1);
        y[j][d] = Q(1 << j) * x[j][d];
      }
    const GC::Curve_jet<Traits> left(x), right(y);
    const auto equal = GC::continuity(left, left, max_order), other = GC::continuity(left, right, max_order);
    BOOST_CHECK_EQUAL(equal.c_order, least);
    BOOST_CHECK_EQUAL(equal.g_order, other.g_order);
    BOOST_CHECK_EQUAL(equal.f_order, other.f_order);
    BOOST_CHECK_EQUAL(equal.regular, other.regular);
    BOOST_CHECK(equal.tangent_equal == other.tangent_equal);
    BOOST_CHECK(equal.curvature_equal == other.curvature_equal);
    BOOST_CHECK(equal.curvature_vector_equal == other.curvature_vector_equal);
    BOOST_CHECK(equal.torsion_equal == other.torsion_equal);
    std::vector<Q> betas(equal.regular ? least : 0, Q(0));
    if (!betas.empty()) betas[0] = Q(1);
    BOOST_CHECK(equal.betas() == betas);
  }
}
