// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

// Each kernel must be able to do this, once. Four kernels run the full suites: a rounded one, one
// with exact predicates, an exact one and the archetype. The others differ from these by their
// numbers and points alone.

BOOST_AUTO_TEST_SUITE(smoke)

TEST_WITH_RANDOM_INPUT(joins) {
  const Jet<Traits> x = random_jet<Traits>(random, d, 3);
  const std::vector<FT> betas = {random.positive_whole(), random.whole(), random.whole()};
  Jet<Traits> y = reparametrised(x, betas);
  const auto join = GC::continuity(x, y);
  BOOST_CHECK_EQUAL(join.g_order, 3);
  BOOST_CHECK_EQUAL(join.f_order, std::min(3, d));
  BOOST_REQUIRE_EQUAL(join.betas().size(), 3u);
  for (int j = 0; j < 3; ++j) {
    typedef std::decay_t<decltype(join.betas()[j])> Number;
    BOOST_CHECK(join.betas()[j] == in_field<Number>(betas[j]));
  }
  y[2][0] += FT(1); // x' has no coordinate that is zero
  BOOST_CHECK_EQUAL(GC::continuity(x, y).g_order, 1);
  y[0][0] += FT(1);
  BOOST_CHECK_EQUAL(GC::continuity(x, y).c_order, -1);
}

TEST_WITH_RANDOM_INPUT(blends) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 3);
  const auto quintic = input(GC::Minimal_energy<3>());
  BOOST_CHECK(quintic.coordinates(0) == input.phi[0] && quintic.coordinates(5) == input.psi[0]);
  if constexpr (exact) {
    BOOST_CHECK_EQUAL(GC::continuity(input.phi, quintic.start_jet(2)).g_order, 2);
    BOOST_CHECK_EQUAL(GC::continuity(quintic.end_jet(2), input.psi).g_order, 2);
  }
}

TEST_WITH_RANDOM_INPUT(curves) {
  const Curve<Traits> c = random_curve<Traits>(random, d, 4);
  const FT t = (c.domain().first + c.domain().second) / FT(2);
  const auto [left, right] = c.split(t);
  const Column<Traits> p = column<Traits>(c(t));
  BOOST_CHECK(left.coordinates(4) == p && right.coordinates(0) == p);
  BOOST_CHECK(c.jet(t, 1)[1] == c.derivative().jet(t, 0)[0]);
  BOOST_CHECK_EQUAL(GC::continuity(left.end_jet(3), right.start_jet(3)).c_order, 3);
  BOOST_CHECK(c == c.reverse().reverse() && !(c == c.transform([&](const Point<Traits>& q) {
                Column<Traits> moved = column<Traits>(q);
                moved[d - 1] += FT(1);
                return point<Traits>(moved);
              })));
}

BOOST_AUTO_TEST_SUITE_END()
