// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Continuity at the knots of splines, and of chains of them.

#include "support/splines.h"

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>

TEST_FOR_EACH(continuity_at_knots, K, Kernels) {
  // in the kernel without exact predicates there is no certain answer
  if constexpr (exact_predicates_v<K>)
    repeat<FT>(25, [](Random<FT>& random) {
      const int p = random.integer(0, 4);
      Curve3<K> c = random.template curve<Traits3<K>>(random.knots(p, p + 1), 3);
      // numbers with all digits
      if constexpr (!exact_v<FT>) c = c.reverse().refine(c.knots().reverse().clamp());
      const auto all = knot_continuities(c, p + 1);
      const std::vector<Knot<FT>> knots = c.knots().inner_knots();
      BOOST_REQUIRE_EQUAL(all.size(), knots.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        const int m = knots[i].multiplicity;
        BOOST_CHECK(all[i].knot == knots[i].value);
        BOOST_CHECK_EQUAL(all[i].multiplicity, m);
        BOOST_CHECK_EQUAL(all[i].join.c_order, p - m);
        BOOST_CHECK_EQUAL(knot_continuity(c, knots[i].value, 1).c_order, std::min(p - m, 1));
        BOOST_CHECK_EQUAL(c.function().smoothness(knots[i].value), p - m);
        if (m < p) BOOST_CHECK(all[i].join.g_order >= std::min(p - m, 1));
      }
      const FT u = random.between(c.domain().first, c.domain().second);
      if (c.knots().multiplicity(u) == 0) BOOST_CHECK_EQUAL(knot_continuity(c, u, 7).c_order, 7);
      CHECK_ERROR(knot_continuity(c, c.domain().first), parameter_outside_domain);
      CHECK_ERROR(knot_continuity(c, c.domain().second), parameter_outside_domain);
      CHECK_ERROR(knot_continuity(c, FT(c.domain().second + FT(1))), parameter_outside_domain);
    });
  // whole numbers: a corner, a curve that is G1 and not C1, and one with the same curvature on both
  // sides
  typedef typename K::Point_2 Point;
  typedef GC::Bspline_curve<GC::Traits_2<K>> Curve;
  const auto join = [](std::vector<Point> points, int multiplicity) {
    return knot_continuity(
        Curve(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), multiplicity}})), FT(2));
  };
  const auto corner = join({Point(0, 0), Point(2, 0), Point(4, 0), Point(4, 2), Point(4, 4)}, 2);
  BOOST_CHECK_EQUAL(corner.c_order, 0);
  BOOST_CHECK_EQUAL(corner.g_order, 0);
  const auto smooth = join({Point(0, 4), Point(0, 0), Point(2, 0), Point(6, 0), Point(8, 8)}, 2);
  BOOST_CHECK_EQUAL(smooth.c_order, 0);
  BOOST_CHECK(smooth.g_order >= 1);
  BOOST_CHECK_EQUAL(smooth.betas()[0], FT(2));
  const auto simple = join({Point(0, 0), Point(2, 4), Point(6, 4), Point(9, 0)}, 1);
  BOOST_CHECK_EQUAL(simple.c_order, 1);
  const auto jump = join({Point(0, 0), Point(2, 4), Point(6, 4), Point(8, 0), Point(9, 9), Point(10, 3)}, 3);
  BOOST_CHECK_EQUAL(jump.c_order, -1);
}

// A chain of splines and their blends.
BOOST_AUTO_TEST_CASE(chains_of_splines) {
  typedef CGAL::Simple_cartesian<Q> K;
  repeat<Q>(5, [](Random<Q>& random) {
    const Curve3<K> phi = random.curve<Traits3<K>>(random.knots(3, 2), 3),
                    psi = random.curve<Traits3<K>>(random.knots(4, 2), 3);
    const std::vector<Curve3<K>> chain{phi, Curve3<K>(blend(phi, psi)), psi,
                                       Curve3<K>(blend(psi, phi, GC::Sequential_g3()))};
    const GC::Chain_summary summary = GC::chain_continuity(chain, 3, GC::Closure::closed);
    BOOST_CHECK_EQUAL(*summary.g_order(), 2);
    BOOST_CHECK_EQUAL(summary.counts(GC::Continuity_kind::G).at(3), 2u);
    // the pieces as a segmented curve, and back
    const std::vector<Bezier3<K>> pieces = phi.bezier_pieces();
    const GC::Composite_bezier_curve<Traits3<K>> segmented(pieces.begin(), pieces.end());
    BOOST_CHECK(Curve3<K>(segmented.segments().begin(), segmented.segments().end()).remove_superfluous_knots() ==
                phi.clamp());
    const auto joins = GC::chain_continuity(segmented).joins;
    const auto knots = knot_continuities(phi);
    BOOST_REQUIRE_EQUAL(joins.size(), knots.size());
    for (std::size_t i = 0; i < joins.size(); ++i)
      BOOST_CHECK_EQUAL(joins[i].continuity.c_order, knots[i].join.c_order);
  });
}
