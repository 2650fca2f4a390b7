// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Splines that are extended and closed.

#include "support/splines.h"

#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

// Clamped or not, and with inner knots of any multiplicity: the last span decides.
TEST_FOR_EACH(splines_are_extended, K, Kernels) {
  repeat<FT>(6, [](Random<FT>& random) {
    const int p = random.integer(3, 4);
    const Curve3<K> c = random.template curve<Traits3<K>>(random.knots(p, p), 3), clamped = c.clamp();
    const Bezier3<K> last = clamped.bezier_pieces().back();
    const FT beta = ratio<FT>(random.integer(1, 9), 4);
    const std::vector<FT> x = random.numbers(3);
    const typename K::Point_3 wished(x[0], x[1], x[2]);
    for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion})
      for (bool toward : {false, true}) {
        const GC::Extension_parameters<FT> parameters{beta, random.number(), random.number(), random.number()};
        const Curve3<K> longer = toward ? GC::extend_toward(c, order, wished, beta) : GC::extend(c, order, parameters);
        const Bezier3<K> next =
            toward ? GC::extend_toward(last, order, wished, beta) : GC::extend(last, order, parameters);
        // the old control points, then those of the new segment
        BOOST_REQUIRE_EQUAL(longer.number_of_points(), clamped.number_of_points() + p);
        for (int i = 0; i < clamped.number_of_points(); ++i)
          BOOST_CHECK(longer.control_point(i) == clamped.control_point(i));
        for (int i = 1; i <= p; ++i)
          BOOST_CHECK(longer.control_point(clamped.number_of_points() - 1 + i) == next.control_point(i));
        // the old knots, a join of multiplicity p, and the end of the new segment
        std::vector<Knot<FT>> inner = clamped.knots().inner_knots();
        inner.push_back({c.domain().second, p});
        BOOST_CHECK(longer.knots() == GC::Knot_vector<FT>(p, c.domain().first, next.domain().second, inner));
        if (toward && static_cast<int>(order) < p) BOOST_CHECK(longer(longer.domain().second) == wished);
        if constexpr (exact_v<FT>) {
          BOOST_CHECK(longer.bezier_pieces().back() == next);
          for (const FT& u : ::parameters(c.knots(), random)) BOOST_CHECK(longer.left_jet(u, p) == c.left_jet(u, p));
          BOOST_CHECK_GE(knot_continuity(longer, c.domain().second).f_order, static_cast<int>(order));
        } else if constexpr (exact_predicates_v<K>)
          BOOST_CHECK_GE(knot_continuity(longer, c.domain().second).c_order, 0);
      }
    // without parameters the last polynomial goes on, and the join is no knot at all
    if constexpr (exact_v<FT>) {
      const Curve3<K> on = GC::extend(c, GC::Frenet_order::torsion, {beta, {}, {}, {}});
      BOOST_CHECK_EQUAL(on.function().smoothness(c.domain().second), p);
      BOOST_CHECK(on.remove_superfluous_knots().knots().inner_knots().size() == c.knots().inner_knots().size());
    }
    CHECK_ERROR(GC::extend(c, GC::Frenet_order::tangent, {FT(0), {}, {}, {}}), nonpositive_beta);
    CHECK_ERROR(GC::extend_toward(c, GC::Frenet_order::tangent, wished, FT(-1)), nonpositive_beta);
  });
  typedef typename K::Point_3 P;
  // only the last span is asked whether it can be extended: its points are equal, then those before
  // it
  const GC::Knot_vector<FT> knots(1, FT(0), FT(2), {{FT(1), 1}});
  const std::vector<P> stops{P(0, 0, 0), P(1, 0, 0), P(1, 0, 0)}, starts{P(1, 0, 0), P(1, 0, 0), P(2, 0, 0)};
  CHECK_ERROR(GC::extend(Curve3<K>(stops.begin(), stops.end(), knots), GC::Frenet_order::tangent), zero_tangent);
  const Curve3<K> line = GC::extend(Curve3<K>(starts.begin(), starts.end(), knots), GC::Frenet_order::tangent);
  BOOST_CHECK(line(FT(3)) == P(3, 0, 0));
  CHECK_ERROR(GC::extend(line, GC::Frenet_order::curvature), wrong_number_of_points);
  // the segment that closes a spline, from its own ends
  const std::vector<P> arch{P(0, 0, 0), P(0, 4, 0), P(4, 4, 4), P(4, 0, 0)};
  const Curve3<K> open(arch.begin(), arch.end(), GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}));
  const Bezier3<K> closing = GC::close(open, open, GC::Frenet_order::tangent);
  BOOST_CHECK(closing.control_point(0) == P(4, 0, 0) && closing.control_point(3) == P(0, 0, 0));
  if constexpr (exact_v<FT>) {
    BOOST_CHECK_EQUAL(continuity(open, closing, 1).g_order, 1);
    BOOST_CHECK_EQUAL(continuity(closing, open, 1).g_order, 1);
  }
}
