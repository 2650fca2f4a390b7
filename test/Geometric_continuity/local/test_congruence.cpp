// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hagen 1.7 (a): jets with the same invariants are moved onto each other by one isometry.

#include "support/jets.h"

BOOST_AUTO_TEST_CASE(a_moved_jet_gives_back_the_motion) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    for (int k = d; k <= d + 2; ++k)
      for (int round = 0; round < 3; ++round) {
        const Jet<Traits> x = random.template jet<Traits>(d, k);
        const GC::Isometry<Traits> motion = random.template isometry<Traits>(d);
        const std::optional<GC::Isometry<Traits>> found = GC::congruence(x, motion(x));
        BOOST_REQUIRE(found);
        BOOST_CHECK(same_map<Traits>(*found, motion));
        BOOST_CHECK((*found)(x) == motion(x));
        const typename Traits::Point p = GC::to_point<Traits>(random.template column<Traits>(d));
        BOOST_CHECK((*found)(p) == motion(p));
        BOOST_CHECK((*found)(x.derivative(1)) == motion(x).derivative(1));
        // it is the identity on the same jet
        BOOST_CHECK((*GC::congruence(x, x))(p) == p);
      }
  });
}

BOOST_AUTO_TEST_CASE(the_motion_is_orthogonal_with_determinant_1) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    // jets of order n-1 do not see the last curvature, so that mirrored ones are congruent
    const Jet<Traits> x = random.template jet<Traits>(d, d - 1);
    for (const Jet<Traits>& y : {random.template isometry<Traits>(d)(x), mirrored<Traits>(x)}) {
      const std::optional<GC::Isometry<Traits>> b = GC::congruence(x, y);
      BOOST_REQUIRE(b);
      BOOST_CHECK((*b)(x) == y);
      for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j) {
          Q sum(0);
          for (int l = 0; l < d; ++l) sum += b->entry(i, l) * b->entry(j, l);
          BOOST_CHECK_EQUAL(sum, Q(i == j ? 1 : 0));
        }
      BOOST_CHECK_EQUAL(GC::determinant<Q>(d, [&](int i, int j) { return b->entry(i, j); }), Q(1));
    }
  });
}

BOOST_AUTO_TEST_CASE(other_jets_are_not_congruent) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    for (int k = d; k <= d + 2; ++k) {
      const Jet<Traits> x = random.template jet<Traits>(d, k), y = random.template isometry<Traits>(d)(x);
      // the last curvature of a mirrored curve is the opposite: Hagen's "unique isometry" preserves
      // orientation
      BOOST_CHECK(!GC::congruence(x, mirrored<Traits>(y)));
      BOOST_CHECK(GC::congruence(x, truncated<Traits>(mirrored<Traits>(y), d - 1)));
      for (int j = 1; j <= k; ++j)
        for (int i = 0; i < d; ++i) {
          Jet<Traits> z = y;
          z[j][i] += ratio<Q>(1, 1000000007);
          BOOST_CHECK(!GC::congruence(x, z));
          if (j >= d) BOOST_CHECK(GC::congruence(x, truncated<Traits>(z, j - 1)));
        }
      // with the same products of the first derivative and the others, but another speed
      if (d == 2) {
        Jet<Traits> z = y;
        for (int j = 1; j <= k; ++j) z[j] *= j == 1 ? Q(2) : Q(1, 2);
        BOOST_CHECK(!GC::congruence(x, z));
      }
      for (int j = d; j <= k; ++j) { // with the same determinants, but other dot products
        Jet<Traits> z = y;
        z[j] += y[1];
        BOOST_CHECK(!GC::congruence(x, z));
      }
      const Column<Traits> normal = GC::frenet_frame(y)->coordinates(d);
      for (int j = d; j <= k; ++j) { // with the same dot products, but another determinant
        Jet<Traits> z = y;
        z[j] -= Q(2 * dot(y[j], normal) / dot(normal, normal)) * normal;
        BOOST_CHECK(!GC::congruence(x, z));
      }
      // equal invariants with another speed
      Jet<Traits> fast = y;
      Q factor(1);
      for (int j = 0; j <= k; ++j) {
        fast[j] *= factor;
        factor *= Q(2);
      }
      BOOST_CHECK(!GC::congruence(x, fast));
    }
    if (d > 2) { // derivatives of equal lengths at other angles
      const Jet<Traits> x = random.template jet<Traits>(d, d - 1);
      Jet<Traits> y = x;
      y[2] = random.template isometry<Traits>(d)(x)[2];
      BOOST_CHECK(!GC::congruence(x, y));
    }
    // a mirrored curve in a hyperplane is congruent: its last curvature is 0
    Jet<Traits> flat = random.template jet<Traits>(d, d - 1);
    for (int j = 0; j < d; ++j) flat[j][d - 1] = Q(0);
    if (GC::gram_determinants(flat, d - 1).back() != Q(0)) {
      Jet<Traits> x = zero_jet<Traits>(d, d);
      for (int j = 0; j < d; ++j) x[j] = flat[j];
      x[d] = flat[1];
      Jet<Traits> y = x;
      for (int j = 0; j <= d; ++j) y[j][0] *= Q(-1);
      BOOST_CHECK((*GC::congruence(x, y))(x) == y);
    }
  });
}

BOOST_AUTO_TEST_CASE(jets_that_are_refused) {
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    Random random;
    const Jet<Traits> x = random.template jet<Traits>(d, d);
    Jet<Traits> line = x;
    for (int j = 2; j <= d; ++j) line[j] = Q(j) * x[1];
    Jet<Traits> point = x;
    point[1] = Column<Traits>(d);
    if (d > 2) { // in the plane the tangent alone is the frame
      CHECK_ERROR(GC::congruence(line, line), singular_frame);
      CHECK_ERROR(GC::congruence(x, line), singular_frame);
      CHECK_ERROR(GC::congruence(line, x), singular_frame);
    } else
      BOOST_CHECK(GC::congruence(line, line));
    CHECK_ERROR(GC::congruence(point, x), singular_frame);
    CHECK_ERROR(GC::congruence(x, point), singular_frame);
    CHECK_ERROR(GC::congruence(x, truncated<Traits>(x, d - 2)), jet_order_too_low);
    CHECK_ERROR(GC::congruence(truncated<Traits>(x, d - 2), x), jet_order_too_low);
    CHECK_ERROR(GC::congruence(Jet<Traits>(), Jet<Traits>()), jet_order_too_low);
  });
  CHECK_ERROR(GC::congruence(jet<Exact_d>(3, {{0}, {1}, {0, 1}}), jet<Exact_d>(2, {{0}, {1}, {0, 1}})),
              dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(output_of_an_isometry) {
  BOOST_CHECK_EQUAL(text(*GC::congruence(jet<Exact_2>(2, {{0, 0}, {1, 0}}), jet<Exact_2>(2, {{3, 5}, {0, 1}}))),
                    "0 -1 3\n1 0 5\n");
}
