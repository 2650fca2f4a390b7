// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segmented curves that are extended and closed.

#include "support/composite_curves.h"

#include <CGAL/Geometric_continuity/extensions/extend.h>

// A curve keeps its segments when it is extended or closed, and the new joins have the order that
// was asked for.
BOOST_AUTO_TEST_CASE(extended_and_closed) {
  Random random;
  typedef GC::Composite_bezier_curve<Exact_3> Composite;
  for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion}) {
    const int f_order = static_cast<int>(order);
    const Composite curve = random.curve<Exact_3>(4, 2);
    const Composite longer = GC::extend(curve, order, {Q(1, 3), Q(2), Q(5), Q(-1)});
    BOOST_REQUIRE_EQUAL(longer.number_of_segments(), 3);
    BOOST_CHECK(longer.segment_range(0, 2) == curve);
    BOOST_CHECK(longer.lambda(2) == longer.lambda(1) / 3);
    BOOST_CHECK_GE(GC::chain_continuity(longer).joins[1].continuity.f_order, f_order);

    const Exact_3::Point wished(Q(7), Q(-3, 5), Q(11));
    const Composite toward = GC::extend_toward(curve, order, wished, Q(2));
    BOOST_REQUIRE_EQUAL(toward.number_of_segments(), 3);
    BOOST_CHECK(toward.segment_range(0, 2) == curve);
    BOOST_CHECK(toward.segment(2) == GC::extend_toward(curve.segment(1), order, wished, Q(2)));

    const Composite closed = GC::close(curve, order);
    BOOST_REQUIRE_EQUAL(closed.number_of_segments(), 3);
    BOOST_REQUIRE(closed.is_closed());
    const GC::Composite_continuity<Exact_3> report = GC::chain_continuity(closed);
    BOOST_CHECK_GE(report.joins[1].continuity.f_order, f_order);
    BOOST_CHECK_GE(report.joins[2].continuity.f_order, f_order);
    for (int l = 0; l < 2; ++l)
      BOOST_CHECK(closed.segment(l) == curve.segment(l).elevate(closed.degree() - curve.degree()));
  }
}
