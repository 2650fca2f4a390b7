// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/random.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>

// Joins of alignments: inclusive tolerances, exact answers, and refinement until a verdict.

Q decimal(const std::string& s) { return GC::parse_number<Q>(s); }

GC::Clothoid_segment piece(const std::string& x, const std::string& y, const std::string& heading,
                           const std::string& k0, const std::string& k1, const std::string& length) {
  return GC::Clothoid_segment(decimal(x), decimal(y), decimal(heading), decimal(k0), decimal(k1), decimal(length));
}

// The numbers are enclosed, not too widely.
void check_enclosure(const GC::Enclosure& x, double lower, double upper) {
  BOOST_CHECK_LE(x.lower, upper);
  BOOST_CHECK_GE(x.upper, lower);
  BOOST_CHECK_LE(x.upper - x.lower, 1e-12);
}

const GC::Clothoid_segment first_line = piece("0", "0", "0", "0", "0", "10");

BOOST_AUTO_TEST_CASE(lines_on_the_axis) {
  const auto join_at = [&](const std::string& x, const std::string& heading) {
    return GC::alignment_join(first_line.end(), piece(x, "0", heading, "0", "0", "10").start());
  };
  const GC::Alignment_join exact = join_at("10", "0");
  BOOST_CHECK(exact.same_point && exact.same_heading && exact.same_curvature && exact.order() == 2);
  BOOST_CHECK(
      (exact.gap == GC::Enclosure{0, 0} && exact.kink == GC::Enclosure{0, 0} && exact.jump == GC::Enclosure{0, 0}));
  BOOST_CHECK(join_at("10.001", "0").order() == 2 && !join_at("10.001", "0").same_point);
  BOOST_CHECK(join_at("10.001000000001", "0").order() == -1);
  BOOST_CHECK(join_at("10", "0.001").order() == 2 && join_at("10", "-0.001").order() == 2);
  BOOST_CHECK(join_at("10", "0.00100000000000000000001").order() == 0);
  const GC::Alignment_join wraps = join_at("10", "6.283185307179586");
  BOOST_CHECK(!wraps.same_heading && wraps.order() == 2);
  check_enclosure(wraps.kink, 4.769252867665589e-16, 4.769252867665591e-16);
  const GC::Alignment_join reversed = join_at("10", "3.141592653589793");
  BOOST_CHECK(reversed.order() == 0 && reversed.same_curvature);
  check_enclosure(reversed.kink, 3.1415926535897927, 3.1415926535897936);
  check_enclosure(join_at("10", "-3.9").kink, 2.3831853071795859, 2.3831853071795865);
}

BOOST_AUTO_TEST_CASE(arcs_and_spirals) {
  const GC::Clothoid_segment arc = piece("20", "0", "0", "0.01", "0.01", "10");
  const GC::Alignment_join after_line = GC::alignment_join(piece("0", "0", "0", "0", "0", "20").end(), arc.start());
  BOOST_CHECK(after_line.order() == 1 && after_line.same_heading && after_line.same_point &&
              !after_line.same_curvature);
  check_enclosure(*after_line.jump, 0.01, 0.01);
  const GC::Alignment_join spelled =
      GC::alignment_join(arc.end(), piece("29.98334166468", "0.49958347220", "1e-1", "1.0e-2", "1.0e-2", "5").start());
  BOOST_CHECK(spelled.same_curvature && spelled.same_heading && !spelled.same_point && spelled.order() == 2);
  BOOST_CHECK(spelled.gap.lower > 0 && spelled.gap.upper < 1e-10);
  // a spiral that turns 30 radians one way and back: x, y from an independent integration
  const GC::Clothoid_segment turns = piece("0", "0", "0", "0", "0.5", "120");
  const auto end = turns.end_point().enclosure();
  const GC::Clothoid_segment back(Q(end[0].lower), Q(end[1].lower), Q(30), decimal("0.5"), Q(0), Q(120));
  BOOST_CHECK(GC::alignment_join(turns.end(), back.start()).gap.upper < 1e-14);
  const GC::Alignment_join home = GC::alignment_join(turns.end(), piece("0", "0", "30", "0.500001", "0.5", "1").start(),
                                                     {Q(1000), Q(0), decimal("0.000001")});
  BOOST_CHECK(home.order() == 2 && home.same_heading);
}

BOOST_AUTO_TEST_CASE(parametric_cubics) {
  const GC::Parametric_cubic cubic(Q(0), Q(0), Q(0), {Q(0), Q(10), Q(0), Q(0)}, {Q(0), Q(0), Q(2), Q(0)}, Q(1));
  const auto join_at = [&](const std::string& heading) {
    return GC::alignment_join(cubic.end(), piece("10", "2", heading, "0", "0", "10").start());
  };
  const GC::Alignment_join join = join_at("0.380506377112365");
  BOOST_CHECK(join.same_point && !join.same_heading && !join.same_curvature && join.order() == 1);
  check_enclosure(*join.jump, 0.032016437616733076, 0.03201643761673309);
  check_enclosure(join_at("0").kink, 0.38050637711236489, 0.3805063771123649);
  // atan(0.4) to 40 digits, and tolerances that are as near to the kink
  const Q angle = decimal("0.3805063771123648863035879168104331045");
  const auto within = [&](const Q& tolerance) {
    return GC::alignment_join(cubic.end(), piece("10", "2", "0", "0", "0", "10").start(), {Q(0), tolerance, Q(0)}).g1;
  };
  BOOST_CHECK(within(Q(angle - decimal("1e-34"))) == GC::Verdict::refuted);
  BOOST_CHECK(within(Q(angle + decimal("1e-34"))) == GC::Verdict::proved);
  // an arc with the curvature of the cubic at its start; and a stop
  BOOST_CHECK(GC::alignment_join(piece("0", "0", "0", "0.04", "0.04", "0").end(), cubic.start()).order() == 2);
  const GC::Parametric_cubic stop(Q(10), Q(0), Q(0), {Q(0), Q(0), Q(10), Q(0)}, {Q(0), Q(0), Q(0), Q(0)}, Q(1));
  const GC::Alignment_join undefined = GC::alignment_join(first_line.end(), stop.start());
  BOOST_CHECK(!undefined.jump && undefined.g2 == GC::Verdict::undecided && !undefined.order() &&
              undefined.same_heading);
}

// The bounds of a gap are drawn together, by a verdict each time, to far more digits than
// floating-point numbers have.
BOOST_AUTO_TEST_CASE(refinement) {
  Random_integers<std::mt19937> random;
  for (int i = 0; i < 5; ++i) {
    const GC::Enclosed_point p =
        GC::Clothoid_segment(Q(0), Q(0), random.fraction_of<Q>(-3, 3, 7, 7), random.fraction_of<Q>(-9, 9, 20, 40),
                             random.fraction_of<Q>(1, 9, 20, 40), random.fraction_of<Q>(1, 9, 1, 2))
            .end_point();
    const GC::Enclosure gap = GC::point_distance(p, GC::Enclosed_point(), Q(0)).distance;
    Q low(gap.lower - 1e-12), high(gap.upper + 1e-12);
    for (int k = 0; k < 100; ++k) { // 2^-140
      const Q middle = Q((low + high) / 2);
      const GC::Decided_distance d = GC::point_distance(p, GC::Enclosed_point(), middle);
      BOOST_REQUIRE(d.within != GC::Verdict::undecided);
      (d.within == GC::Verdict::proved ? high : low) = middle;
    }
    BOOST_CHECK(GC::point_distance(p, GC::Enclosed_point(), Q(low - decimal("1e-40"))).within == GC::Verdict::refuted);
    BOOST_CHECK(GC::point_distance(p, GC::Enclosed_point(), Q(high + decimal("1e-40"))).within == GC::Verdict::proved);
  }
}

BOOST_AUTO_TEST_CASE(large_coordinates) { // what two ends have in common does not make the gap vague
  const GC::Clothoid_segment a = piece("691608.123456", "5334765.654321", "1", "0.01", "0.02", "80");
  const auto end = a.end_point().enclosure();
  const GC::Clothoid_segment b(Q(end[0].lower), Q(end[1].lower), Q(0), Q(0), Q(0), Q(1));
  const GC::Alignment_join join = GC::alignment_join(a.end(), b.start());
  BOOST_CHECK(join.g0 == GC::Verdict::proved && join.gap.upper < 2e-9 && join.gap.upper - join.gap.lower < 1e-12);
}

BOOST_AUTO_TEST_CASE(borders) {
  const GC::Alignment_end end = first_line.end();
  const GC::Border_point flat(end, decimal("3.5")), banked(end, decimal("3.5"), decimal("0.2")),
      raised(end, decimal("3.5"), decimal("0.2"), decimal("1"));
  const GC::Decided_distance plan = GC::point_distance(flat.plan, banked.plan, decimal("0.001")),
                             height = GC::height_distance(flat, banked, decimal("0.001"));
  check_enclosure(plan.distance, 0.06976697755565428, 0.06976697755565431);
  check_enclosure(height.distance, 0.6953426577827141, 0.6953426577827143);
  BOOST_CHECK(plan.within == GC::Verdict::refuted && height.within == GC::Verdict::refuted);
  const GC::Decided_distance step = GC::height_distance(raised, banked, Q(1));
  BOOST_CHECK((step.distance == GC::Enclosure{1, 1}) && step.within == GC::Verdict::proved);
  // a road in the other direction, the border on its right
  const GC::Clothoid_segment back = piece("10", "0", "3.5", "0", "0", "10");
  const GC::Alignment_end flipped = back.start().reversed();
  check_enclosure(GC::alignment_join(end, flipped).kink, 0.35840734641020677, 0.3584073464102068);
  BOOST_CHECK(GC::point_distance(GC::Border_point(end, Q(0)).plan, GC::Border_point(flipped, Q(0)).plan, Q(0)).is_zero);
}

BOOST_AUTO_TEST_CASE(refused) {
  const GC::Alignment_tolerance negative{Q(0), Q(-1), Q(0)};
  CHECK_ERROR(GC::alignment_join(first_line.end(), first_line.start(), negative), parameter_outside_domain);
  const GC::Clothoid_segment long_way = piece("0", "0", "0", "0", "1000", "10");
  const GC::Work_scope few(GC::Work_limit(1000));
  const auto hard = [&] {
    return GC::point_distance(long_way.end_point(), GC::Enclosed_point(),
                              Q(GC::point_distance(long_way.end_point(), GC::Enclosed_point(), Q(0)).distance.lower));
  };
  CHECK_ERROR(hard(), work_limit);
}
