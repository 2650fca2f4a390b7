// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/random.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>

// The ends of pieces of alignments: exact headings and curvatures, enclosed points.

typedef GC::Curvature_law Law;

bool meet(const GC::Enclosure& x, const GC::Enclosure& y) { return x.lower <= y.upper && y.lower <= x.upper; }

BOOST_AUTO_TEST_CASE(exact_ends) {
  const GC::Clothoid_segment s(Q(1), Q(2), Q(3), Q(1) / 100, Q(-1) / 50, Q(40));
  BOOST_CHECK(s.end_heading().angle() == Q(3) - Q(1) / 5);
  BOOST_CHECK(s.end_curvature() == Q(-1) / 50 && s.start_curvature() == Q(1) / 100);
  const GC::Clothoid_segment none(Q(1), Q(2), Q(3), Q(1) / 100, Q(-1) / 50, Q(0));
  BOOST_CHECK(none.end_heading().angle() == 3 && none.end_curvature() == Q(1) / 100);
  BOOST_CHECK((none.end_point().rational() == std::pair<Q, Q>(1, 2)));
  const GC::Clothoid_segment line(Q(1), Q(2), GC::Heading(Q(0), Q(3), Q(4)), Q(0), Q(0), Q(10));
  BOOST_CHECK((line.end_point().rational() == std::pair<Q, Q>(7, 10))); // the direction has a rational length
  BOOST_CHECK(!GC::Clothoid_segment(Q(0), Q(0), Q(1), Q(0), Q(0), Q(1)).end_point().rational());
  CHECK_ERROR(GC::Clothoid_segment(Q(0), Q(0), Q(0), Q(0), Q(0), Q(-1)), parameter_outside_domain);
}

BOOST_AUTO_TEST_CASE(laws) {
  for (const Law& f : {Law::linear(), Law::bloss(), Law::cosine_curve(), Law::sine_curve(), Law::viennese_bend()}) {
    BOOST_CHECK(f.at_start() == 0 && f.at_end() == 1 && f.mean() == Q(1) / 2);
    const Law k = Law::between(Q(2), Q(-5), f);
    BOOST_CHECK(k.at_start() == 2 && k.at_end() == -5 && k.mean() == Q(-3) / 2);
  }
  // numbers of an independent quadrature with 25 digits: k from 0 to 1/4 on a length of 150
  const std::array<Law, 5> all = {Law::linear(), Law::bloss(), Law::cosine_curve(), Law::sine_curve(),
                                  Law::viennese_bend()};
  const double expected[5][2] = {{21.20624714059491300149, 17.74663025881205121466},
                                 {35.20134116337215371434, 18.19795652347019770326},
                                 {36.54411024355528478157, 18.21183802720368288626},
                                 {45.07092639711688900726, 16.73121292976410254489},
                                 {48.28845977664289295291, 15.75997673871306865955}};
  for (std::size_t i = 0; i < 5; ++i) {
    const GC::Clothoid_segment s(Q(0), Q(0), Q(0), Law::between(Q(0), Q(1) / 4, all[i]), Q(150));
    const std::array<GC::Enclosure, 2> p = s.end_point().enclosure();
    for (std::size_t c = 0; c < 2; ++c) {
      BOOST_CHECK_SMALL(p[c].lower - expected[i][c], 1e-13);
      BOOST_CHECK_LE(p[c].upper - p[c].lower, 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(parts_make_the_whole) { // a polynomial law, cut anywhere
  Random_integers<std::mt19937> random;
  for (int i = 0; i < 50; ++i) {
    const Q k0 = random.fraction_of<Q>(-9, 9, 1, 20), k1 = random.fraction_of<Q>(-9, 9, 1, 20),
            cut = random.fraction_of<Q>(1, 19, 20, 20), length = random.fraction_of<Q>(1, 60, 1, 3),
            heading = random.fraction_of<Q>(-30, 30, 7, 7);
    const GC::Clothoid_segment whole(Q(0), Q(0), heading, k0, k1, length);
    const Q k = Q(k0 + cut * (k1 - k0));
    const GC::Clothoid_segment first(Q(0), Q(0), heading, k0, k, Q(cut * length)),
        second(Q(0), Q(0), first.end_heading(), k, k1, Q((1 - cut) * length));
    BOOST_CHECK(second.end_heading().angle() == whole.end_heading().angle());
    const auto p = first.end_point().enclosure(), d = second.end_point().enclosure(), q = whole.end_point().enclosure();
    for (std::size_t c = 0; c < 2; ++c)
      BOOST_CHECK(meet({p[c].lower + d[c].lower - 1e-14, p[c].upper + d[c].upper + 1e-14}, q[c]));
  }
}

BOOST_AUTO_TEST_CASE(parametric_cubics) {
  const GC::Parametric_cubic c(Q(10), Q(0), Q(0), {Q(0), Q(10), Q(0), Q(0)}, {Q(0), Q(0), Q(2), Q(0)}, Q(1));
  BOOST_CHECK((c.end().point.rational() == std::pair<Q, Q>(20, 2)));
  BOOST_CHECK((c.end().heading.vector() == std::pair<Q, Q>(10, 4)));
  BOOST_CHECK(c.start().curvature->rational() == Q(4) / 100);
  BOOST_CHECK(*c.end().curvature == GC::End_curvature(1, Q(1600) / (Q(116) * 116 * 116)));
  BOOST_CHECK(!c.end().curvature->rational());
  // (10 / 0.8) (0.4 sqrt(1.16) + asinh(0.4))
  BOOST_CHECK(meet(c.length(), {10.2606063042684, 10.2606063042685}));
  BOOST_CHECK(c.length_error(Q(102606) / 10000, Q(1) / 1000).second == GC::Verdict::proved);
  BOOST_CHECK(c.length_error(Q(105) / 10, Q(1) / 1000).second == GC::Verdict::refuted);

  // at a stop the second derivative gives the tangent, backwards at the end
  const GC::Parametric_cubic stop(Q(0), Q(0), Q(0), {Q(0), Q(0), Q(3), Q(0)}, {Q(0), Q(0), Q(4), Q(0)}, Q(1)),
      late(Q(0), Q(0), Q(0), {Q(0), Q(2), Q(-1), Q(0)}, {Q(0), Q(0), Q(0), Q(0)}, Q(1));
  BOOST_CHECK((stop.start().heading.vector() == std::pair<Q, Q>(6, 8)) && !stop.start().curvature);
  BOOST_CHECK(meet(stop.length(), {5, 5}) && stop.is_near_stop(Q(5)) && !c.is_near_stop(Q(10)));
  BOOST_CHECK((late.end().heading.vector() == std::pair<Q, Q>(2, 0)) && !late.end().curvature);
  const auto make = [](int slope, int range) {
    return GC::Parametric_cubic(Q(0), Q(0), Q(0), {Q(1), Q(slope), Q(0), Q(0)}, {Q(1), Q(0), Q(0), Q(0)}, Q(range));
  };
  CHECK_ERROR(make(0, 1), zero_tangent);
  CHECK_ERROR(make(1, -1), parameter_outside_domain);
}

BOOST_AUTO_TEST_CASE(graphs_of_a_length) {
  // v = u^2 / 50 has the length 10.260606304268446... at u = 10
  const auto g = GC::Parametric_cubic::graph(Q(0), Q(0), Q(0), {Q(0), Q(0), Q(1) / 50, Q(0)},
                                             Q("10260606304268446") / Q("1000000000000000"));
  const GC::Alignment_end end = g.end();
  BOOST_CHECK(!end.heading.is_exact() && !end.curvature->is_exact());
  BOOST_CHECK_SMALL(end.point.enclosure()[0].lower - 10, 1e-13);
  BOOST_CHECK_SMALL(end.point.enclosure()[1].upper - 2, 1e-13);
  BOOST_CHECK_SMALL(end.heading.enclosure().lower - std::atan(0.4), 1e-13);
  BOOST_CHECK_SMALL(end.curvature->enclosure().lower - 0.04 / std::pow(1.16, 1.5), 1e-13);
  BOOST_CHECK_SMALL(end.reversed().curvature->enclosure().lower + 0.04 / std::pow(1.16, 1.5), 1e-13);
  const auto line = GC::Parametric_cubic::graph(Q(0), Q(0), Q(0), {Q(1), Q(3) / 4, Q(0), Q(0)}, Q(5));
  BOOST_CHECK((line.end().point.rational() == std::pair<Q, Q>(4, 4)));
}

BOOST_AUTO_TEST_CASE(hostile_numbers) {
  const GC::Clothoid_segment wild(Q(0), Q(0), Q(0), Q(0), Q(1000000000), Q(100));
  CHECK_ERROR(wild.end_point().enclosure(), parameter_outside_domain);
  BOOST_CHECK(wild.end_heading().angle() == Q("50000000000"));
  const GC::Heading far(Q(1000000007), Q(1), Q(1));
  BOOST_CHECK(far.enclosure().lower <= 1000000007.7853982 && 1000000007.7853981 <= far.enclosure().upper);
  CHECK_ERROR(GC::Heading(Q(0), Q(0), Q(0)), zero_direction);
}
