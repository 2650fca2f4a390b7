// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/random.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/clothoid_blend.h>

// Three clothoids between any two ends: curvatures equal exactly, gaps and kinks as small as
// rounding allows.

GC::Alignment_end end_at(const Q& x, const Q& y, const Q& heading, const Q& curvature) {
  return {GC::Enclosed_point(x, y), GC::Heading(heading), GC::End_curvature(curvature)};
}

void check_joins(const GC::Clothoid_blend& blend, double bound) {
  for (const GC::Alignment_join& join : blend.joins) {
    BOOST_CHECK(join.same_curvature);
    BOOST_CHECK_LE(join.gap.upper, bound);
    BOOST_CHECK_LE(join.kink.upper, 5.2e-16);
  }
  for (std::size_t i = 0; i < 3; ++i) BOOST_CHECK(blend.segments[i].length() > 0);
  BOOST_CHECK(blend.segments[0].end_curvature() == blend.segments[1].start_curvature());
}

BOOST_AUTO_TEST_CASE(random_ends_on_a_unit_chord) {
  Random_integers<std::mt19937> random;
  const auto decimal = [&](int size) { return Q(Q(random.integer(-1000000 * size, 1000000 * size)) / 1000000); };
  for (int i = 0; i < 60; ++i) {
    const GC::Alignment_end start = end_at(Q(0), Q(0), decimal(2), decimal(4)),
                            end = end_at(Q(1), Q(0), decimal(2), decimal(4));
    const GC::Clothoid_blend blend = GC::clothoid_blend(start, end);
    check_joins(blend, 5.2e-16);
    BOOST_CHECK(blend.joins[0].same_point && blend.joins[0].same_heading);
  }
}

BOOST_AUTO_TEST_CASE(far_from_the_origin_rounding_is_coarse) {
  const GC::Clothoid_blend blend = GC::clothoid_blend(end_at(Q(4000000), Q(5000000), Q(1), Q(1) / 100),
                                                      end_at(Q(4000100), Q(5000050), Q(0), Q(-1) / 50));
  check_joins(blend, 2e-9);
  BOOST_CHECK(blend.joins[1].g0 != GC::Verdict::undecided);
}

BOOST_AUTO_TEST_CASE(enclosed_ends) { // of other pieces, also with a direction that is a vector
  const GC::Clothoid_segment arc(Q(0), Q(0), Q(0), Q(1) / 10, Q(1) / 10, Q(3));
  const GC::Parametric_cubic cubic(Q(7), Q(2), Q(Q(1) / 4), {Q(0), Q(10), Q(0), Q(0)}, {Q(0), Q(3), Q(2), Q(0)}, Q(1));
  const GC::Clothoid_blend blend = GC::clothoid_blend(arc.end(), cubic.start());
  for (const GC::Alignment_join& join : blend.joins) {
    BOOST_CHECK_LE(join.gap.upper, 4e-15);
    BOOST_CHECK_LE(join.kink.upper, 1e-15);
    BOOST_CHECK_LE(join.jump->upper, 1e-16); // the curvature of the cubic is a root
  }
}

BOOST_AUTO_TEST_CASE(special_data) {
  const GC::Clothoid_blend line = GC::clothoid_blend(end_at(Q(0), Q(0), Q(0), Q(0)), end_at(Q(5), Q(0), Q(0), Q(0)));
  check_joins(line, 2e-15);
  BOOST_CHECK(line.segments[1].start_curvature() == 0 && line.segments[1].end_curvature() == 0);
  // there and back, with both headings turned round
  check_joins(GC::clothoid_blend(end_at(Q(0), Q(0), Q(3), Q(0)), end_at(Q(1), Q(0), Q(3), Q(0))), 2e-15);
  const auto to_the_same_point = [&] {
    GC::clothoid_blend(end_at(Q(1), Q(2), Q(0), Q(0)), end_at(Q(1), Q(2), Q(1), Q(0)));
  };
  CHECK_ERROR((to_the_same_point(), 0), zero_direction);
  GC::Alignment_end stop = end_at(Q(1), Q(2), Q(0), Q(0));
  stop.curvature = std::nullopt;
  CHECK_ERROR(GC::clothoid_blend(end_at(Q(0), Q(0), Q(0), Q(0)), stop), jet_order_too_low);
}
