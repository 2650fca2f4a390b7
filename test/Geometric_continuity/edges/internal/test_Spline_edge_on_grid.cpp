// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Edges of B-spline surfaces that are proved to be smooth on all spans at once.

#include "support/nets.h"

#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

BOOST_AUTO_TEST_CASE(parts_of_one_spline) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact;
  typedef GC::Traits_3<CGAL::Epick> Filtered;
  typedef GC::Bspline_surface<Exact> Surface;
  typedef GC::Bspline_surface<Filtered> Given;
  typedef GC::Knot_vector<Q> Knots;
  using GC::Edge_direction;

  Random random;
  const Knots u(3, Q(0), Q(10), {{Q(1), 1}, {Q(3), 1}, {Q(4), 1}, {Q(6), 1}}), v(3, Q(0), Q(3), {{Q(2), 1}});
  const Q unit(64 * 729 * 125 * 49); // so that all that is cut from the spline is whole
  const auto net = net_of(u.number_of_coefficients(), v.number_of_coefficients(), [&](int i, int j) {
    const int x = 20 * i + random.integer(0, 5), y = 20 * j + random.integer(0, 5);
    return Exact::Point(Q(unit * Q(x)), Q(unit * Q(y)), Q(unit * Q(random.integer(0, 9))));
  });
  const Surface whole = Surface(net, u, v).insert_u(Q(4), 2);
  // Control points first, ..., last over knots; one of them may be lifted, and knots be multiplied.
  const auto part = [&](int first, int last, const Knots& knots, int lifted, int factor) {
    const auto point = [&](int i, int j) {
      const Filtered::Point p = point_exactly<Filtered>(whole.control_point(first + i, j));
      return Filtered::Point(p.x(), p.y(), p.z() + (first + i == lifted && j == 2));
    };
    std::vector<Q> scaled;
    for (const Q& t : knots) scaled.push_back(Q(factor * t));
    return Given(net_of(last - first + 1, v.number_of_coefficients(), point), knots_exactly<double>(Knots(3, scaled)),
                 knots_exactly<double>(v));
  };
  const Knots before(3, Q(0), Q(4), {{Q(1), 1}, {Q(3), 1}}), after(3, Q(4), Q(10), {{Q(6), 1}});
  const auto left = [&](int lifted) { return part(0, 5, before, lifted, 1); };
  const Given right = part(5, 9, after, -1, 1), faster = part(5, 9, after, -1, 4);
  const auto found = [](const Given& a, Patch_edge edge_a, const Given& b, Patch_edge edge_b) {
    return GC::internal::smooth_spline_edge(a, edge_a, b, edge_b);
  };
  const auto order = [](const Given& a, Patch_edge edge_a, const Given& b, Patch_edge edge_b) {
    return GC::edge_continuity(a, edge_a, b, edge_b).g_order;
  };
  for (const Given& b : {right, faster}) {
    BOOST_CHECK(found(left(-1), u1, b, u0) == Edge_direction::same);
    BOOST_CHECK(found(b, u0, left(-1), u1) == Edge_direction::same);
    BOOST_CHECK(found(left(-1), u1, b.reverse_v(), u0) == Edge_direction::opposite);
    BOOST_CHECK(found(left(-1).reverse_u(), u0, b.swap_parameters(), v0) == Edge_direction::same);
    BOOST_CHECK_EQUAL(order(left(-1), u1, b, u0), 2);
    BOOST_CHECK(!found(left(5), u1, b, u0)); // another edge
    BOOST_CHECK(!found(left(4), u1, b, u0));
    BOOST_CHECK_EQUAL(order(left(4), u1, b, u0), 0);
    BOOST_CHECK(!found(left(3), u1, b, u0));
    BOOST_CHECK_EQUAL(order(left(3), u1, b, u0), 1);
    BOOST_CHECK(found(left(2), u1, b, u0) == Edge_direction::same); // beyond the second derivative
    BOOST_CHECK(!found(left(-1), u0, b, u0));
    BOOST_CHECK(!found(left(-1), u1, left(-1), u1)); // a fold
    const auto flat = [](const Filtered::Point& p) { return Filtered::Point(p.x(), 2 * p.x(), 0); };
    BOOST_CHECK(!found(left(-1).transform(flat), u1, b.transform(flat), u0)); // no normal
    const auto turned = [](const Filtered::Point& p) { return Filtered::Point(p.y(), p.z(), p.x()); };
    BOOST_CHECK(found(left(-1).transform(turned), u1, b.transform(turned), u0) == Edge_direction::same);
    const auto huge = [](const Filtered::Point& p) {
      return Filtered::Point(0x1p600 * p.x(), 0x1p600 * p.y(), 0x1p600 * p.z());
    };
    BOOST_CHECK(!found(left(-1).transform(huge), u1, b.transform(huge), u0)); // beyond the grid
    // another degree along the edge, more knots, other knots with the same points, and a knot with
    // a gap
    BOOST_CHECK(!found(left(-1), u1, b.elevate(0, 1), u0) && !found(left(-1), u1, b.insert_v(1), u0));
    const auto over = [](const Given& s, const GC::Knot_vector<double>& across, const GC::Knot_vector<double>& along) {
      return Given(
          net_of(s.number_of_points_u(), s.number_of_points_v(), [&](int i, int j) { return s.control_point(i, j); }),
          across, along);
    };
    BOOST_CHECK(!found(left(-1), u1, over(b, b.knots_u(), GC::Knot_vector<double>(3, 0., 3., {{1., 1}})), u0));
    const Given torn = b.insert_v(2, 3), torn_left = left(-1).insert_v(2, 3);
    BOOST_CHECK(torn.knots_v().multiplicity(2) == 4 && !found(torn_left, u1, torn, u0));
    // knots across that are not clamped; and distances of them whose ratios are no short numbers
    std::vector<double> loose(b.knots_u().begin(), b.knots_u().end()), long_ones = loose;
    loose.front() -= 1;
    for (double& t : long_ones) t *= 0.1;
    const GC::Knot_vector<double> unclamped(3, loose), rounded(3, long_ones);
    BOOST_CHECK(!found(left(-1), u1, over(b, unclamped, b.knots_v()), u0));
    BOOST_CHECK(!found(over(b, unclamped, b.knots_v()), u0, left(-1), u1));
    BOOST_CHECK(!found(left(-1), u1, over(b, rounded, b.knots_v()), u0));
    // one point along the edge
    const Given point(net_of(b.number_of_points_u(), 1, [&](int i, int) { return b.control_point(i, 0); }), b.knots_u(),
                      GC::Knot_vector<double>(0, {0., 1.}));
    BOOST_CHECK(!found(point, u0, point, u1));
    // an edge that is closed may be the same backwards
    const auto closed = [&](const Given& s, int edge) {
      const int n = s.number_of_points_v();
      return Given(net_of(s.number_of_points_u(), n,
                          [&](int i, int j) { return s.control_point(i, i == edge && j + 1 == n ? 0 : j); }),
                   s.knots_u(), s.knots_v());
    };
    BOOST_CHECK(!found(closed(left(-1), 5), u1, closed(b, 0), u0));
  }
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
