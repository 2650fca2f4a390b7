// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends of splines.

#include "support/splines.h"

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

TEST_FOR_EACH(splines_are_blended_and_joined, K, Kernels) {
  repeat<FT>(10, [](Random<FT>& random) {
    const Curve3<K> phi = random.template curve<Traits3<K>>(random.knots(3, 2, !exact_v<FT>), 3),
                    psi = random.template curve<Traits3<K>>(random.knots(random.integer(2, 4), 2), 3);
    const std::vector<FT> x = random.numbers(9);
    const Bezier3<K> bezier({typename K::Point_3(x[0], x[1], x[2]), typename K::Point_3(x[3], x[4], x[5]),
                             typename K::Point_3(x[6], x[7], x[8])});
    const auto quintic = blend(phi, psi);
    const auto mixed = blend(bezier, psi, GC::Minimal_second_derivative());
    const auto septic = blend(phi, psi, GC::Sequential_g3());
    BOOST_CHECK(quintic.start_jet(0)[0] == phi.end_jet(0)[0]);
    BOOST_CHECK(quintic.end_jet(0)[0] == psi.start_jet(0)[0]);
    if constexpr (exact_v<FT>) {
      BOOST_CHECK_EQUAL(continuity(phi, quintic, 2).g_order, 2);
      BOOST_CHECK_EQUAL(continuity(quintic, psi, 2).g_order, 2);
      BOOST_CHECK_EQUAL(continuity(mixed, psi, 2).g_order, 2);
      BOOST_CHECK_EQUAL(continuity(phi, septic, 3).g_order, 3);
      BOOST_CHECK_EQUAL(continuity(septic, psi, 3).g_order, 3);
      // splines that continue each other
      const std::vector<Bezier3<K>> pieces = phi.bezier_pieces();
      for (std::size_t i = 1; i < pieces.size(); ++i)
        BOOST_CHECK_EQUAL(continuity(Curve3<K>(pieces[i - 1]), Curve3<K>(pieces[i]), 3).c_order,
                          3 - phi.knots().multiplicity(pieces[i].domain().first));
    } else if constexpr (exact_predicates_v<K>)
      // the clamped end point is a control point, taken over without rounding
      BOOST_CHECK(continuity(phi.clamp(), blend(phi.clamp(), psi), 2).c_order >= 0);
  });
}
