// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The certified deviation along edges: the enclosures contain the exact value, are at most four
// units in the last place wide on well-scaled numbers, and lead to honest verdicts.

#include "support/enclosures.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

BOOST_AUTO_TEST_SUITE(edge_deviation)

typedef CGAL::Exact_rational Exact;
using enclosures::angle_is;
using enclosures::encloses_root;
using enclosures::ulps;
using GC::Verdict;

typedef GC::Bernstein_polynomial<Exact> Polynomial;
typedef GC::Edge_rows<Exact> Rows;
constexpr GC::Patch_edge v0 = GC::Patch_edge::v0;

const Polynomial zero{Exact(0)}, one{Exact(1)}, t{Exact(0), Exact(1)};
Polynomial constant(const Exact& x) { return Polynomial{x}; }
Polynomial operator*(const Exact& x, const Polynomial& p) { return constant(x) * p; }

Rows::Row row(const Polynomial& x, const Polynomial& y, const Polynomial& z) {
  const int n = std::max({x.degree(), y.degree(), z.degree()});
  const Polynomial c[3] = {x.elevated(n - x.degree()), y.elevated(n - y.degree()), z.elevated(n - z.degree())};
  Rows::Row r;
  for (int i = 0; i <= n; ++i) {
    r.emplace_back(3);
    for (int k = 0; k < 3; ++k) r.back()[k] = c[k][i];
  }
  return r;
}

// A surface with the edge (t, 0, 0), or another one, and the cross derivative (0, y, z).
Rows surface(const Polynomial& y, const Polynomial& z, const Rows::Row& edge = row(t, zero, zero)) {
  return {edge, row(zero, y, z), row(zero, zero, zero)};
}
const Rows flat = surface(one, zero);

// Returns whether the largest angle is that with the squared sine, beyond the right angle if
// `obtuse`.
void check_largest_angle(const Rows& a, const Rows& b, const Exact& sine_squared, bool obtuse = false) {
  const auto e = GC::edge_continuity(a, b);
  BOOST_REQUIRE(e.deviation);
  const Exact measure = obtuse ? Exact(2 - sine_squared) : sine_squared;
  BOOST_CHECK(e.deviation->lower <= measure && measure <= e.deviation->upper);
  const GC::Enclosure angle = e.deviation->angle();
  BOOST_CHECK_LE(ulps(angle), 4);
  const Exact product = obtuse ? -1 : 1; // with the tangent of the angle
  if (sine_squared < 1) {
    const Exact lengths = 1 / (1 - sine_squared);
    BOOST_CHECK(angle_is(true, angle.lower, product, lengths));
    BOOST_CHECK(angle_is(false, angle.upper, product, lengths));
  }
  // the same from the deviation of the edges, in both orders and directions
  for (const GC::Edge_deviation& d :
       {GC::deviation(a, b), GC::deviation(b, a), GC::deviation(a.reversed(), b.reversed())}) {
    BOOST_CHECK_EQUAL(d.gap, (GC::Enclosure{0, 0}));
    BOOST_REQUIRE(d.normal_angle);
    BOOST_CHECK(d.normal_angle->lower <= angle.upper && angle.lower <= d.normal_angle->upper);
    BOOST_CHECK_LE(ulps(*d.normal_angle), 4);
    BOOST_CHECK(!d.reversed);
    BOOST_CHECK_EQUAL(d.normal_vanishes, e.normal_vanishes);
  }
  BOOST_CHECK(GC::deviation(a, b.reversed()).reversed);
}

// The slope h of the second surface has its largest value at an irrational parameter.
BOOST_AUTO_TEST_CASE(largest_angle_along_an_edge) {
  const Polynomial minus = constant(-1), g = t - t * t * t; // at most sqrt(4/27), at sqrt(1/3)
  const Polynomial w = constant(2) * t * t - one;           // zero at sqrt(1/2)
  const Polynomial flat_bump = one - w * w * w * w, waves = one - t * t * w * w * (one - t) * (one - t);
  for (const Exact& c : {Exact(1), Exact(1e-6), Exact(1000), Exact(1e-25), Exact(1.0 / 3)}) {
    check_largest_angle(flat, surface(minus, c * g), Exact(c * c * 4) / (27 + c * c * 4));
    // of order 4 at the largest value, and the same value at three places
    check_largest_angle(flat, surface(minus, c * flat_bump), Exact(c * c) / (1 + c * c));
    check_largest_angle(flat, surface(minus, c * waves), Exact(c * c) / (1 + c * c));
    check_largest_angle(flat, surface(minus, c * one), Exact(c * c) / (1 + c * c)); // constant
    // slightly curved: the largest value is at the end
    const Exact d = c * (1 + Exact(1e-18));
    check_largest_angle(flat, surface(minus, c * one + constant(Exact(c * Exact(1e-18))) * t),
                        Exact(d * d) / (1 + d * d));
    // on the same side: the largest angle belongs to the least slope, 23/27 c
    const Exact m = c * Exact(23) / 27;
    check_largest_angle(flat, surface(one, c * (one - g * g)), Exact(m * m) / (1 + m * m), true);
    check_largest_angle(flat, surface(one, c * g), 0, true);
    // from one side to the other, through the right angle at sqrt(1/2): largest at the end
    check_largest_angle(flat, surface(w, c * one), Exact(c * c) / (1 + c * c), true);
    // touching the right angle
    check_largest_angle(flat, surface(minus * w * w, c * one), 1);
  }
}

// Where a normal vanishes the angle has limits on both sides; the sign of the cosine changes with a
// factor of odd multiplicity only.
BOOST_AUTO_TEST_CASE(largest_angle_beside_vanishing_normals) {
  const Polynomial minus = constant(-1), w = constant(2) * t * t - one, g = t - t * t * t;
  for (const Exact& c : {Exact(1), Exact(0.001)}) {
    const Exact largest = Exact(c * c * 4) / (27 + c * c * 4);
    check_largest_angle(flat, surface(minus * w * w, c * (g * w * w)), largest);
    check_largest_angle(surface(w * w * t, zero), surface(minus * (one - t), c * (g * (one - t))), largest);
    check_largest_angle(surface(w, zero), surface(minus * w * w * w, c * (g * w * w * w)), largest);
    // on one side for t < sqrt(1/2), then on the other: largest beyond the right angle where the
    // slope is least, t = 0 or 1
    check_largest_angle(surface(w, zero), surface(one, c * g), 0, true);
    check_largest_angle(surface(w, zero), surface(w * w, c * (g * w * w)), 0, true);
    // the least slope where the side changes, sqrt(1/2): the angle is a limit from one side
    const Polynomial h = constant(Exact(0.125)) + w * w;
    const Exact square = c * c / 64;
    for (int sign : {-1, 1})
      check_largest_angle(surface(constant(sign) * w, zero), surface(minus * w * w, c * (h * w * w)),
                          square / (1 + square), true);
  }
}

BOOST_AUTO_TEST_CASE(random_edges) {
  const unsigned seed = 2027;
  std::mt19937_64 random(seed);
  const auto number = [&] { return std::ldexp(double(random() >> 11), -52) - 1; };
  int inside = 0;
  for (int i = 0; i < 60; ++i) {
    const int n = 1 + i % 4;
    const double tilt = i % 3 == 0 ? 1e-6 : i % 3 == 1 ? 1 : 30;
    Rows rows[2];
    for (int k = 0; k <= n; ++k) {
      GC::Coordinate_vector<Exact, 3> c(3), a(3), b(3);
      c[0] = 10 * k + number(), c[1] = number(), c[2] = number();
      a[0] = number(), a[1] = 10 + number(), a[2] = number();
      b[0] = number(), b[1] = (i % 5 == 0 ? 8 : -10) + number(), b[2] = tilt * number();
      for (Rows& r : rows) {
        r.edge.push_back(c);
        r.second_cross.emplace_back(3);
      }
      rows[0].cross.push_back(a);
      rows[1].cross.push_back(b);
    }
    const auto e = GC::edge_continuity(rows[0], rows[1]);
    BOOST_REQUIRE(e.deviation);
    BOOST_CHECK_LE(ulps(e.deviation->angle()), 4);
    inside += 0 < e.deviation->begin && e.deviation->end < 1;
    // at samples, and next to the place that was found: 1 - cos |cos|
    const auto value = [](const Rows::Row& r, const Exact& x, bool derivative) {
      GC::Coordinate_vector<Exact, 3> v(3);
      for (int k = 0; k < 3; ++k) {
        std::vector<Exact> c;
        for (const auto& p : r) c.push_back(p[k]);
        v[k] = derivative ? Polynomial(c).derivative()(x) : Polynomial(c)(x);
      }
      return v;
    };
    const auto measure = [&](const Exact& x) {
      const auto d = value(rows[0].edge, x, true), t1 = value(rows[0].cross, x, false),
                 t2 = value(rows[1].cross, x, false);
      // (d x t1).(d x t2) = d.d t1.t2 - d.t1 d.t2
      const Exact dd = dot(d, d), d1 = dot(d, t1), d2 = dot(d, t2), side = dd * dot(t1, t2) - d1 * d2,
                  square = (dd * dot(t1, t1) - d1 * d1) * (dd * dot(t2, t2) - d2 * d2);
      return Exact(1 + (side < 0 ? -1 : 1) * side * side / square);
    };
    for (int k = 0; k <= 64; ++k) BOOST_CHECK(measure(Exact(k) / 64) <= e.deviation->upper);
    const Exact found = std::max(measure(e.deviation->begin), measure(e.deviation->end));
    BOOST_CHECK_MESSAGE(found <= e.deviation->upper && e.deviation->lower <= e.deviation->upper, "seed " << seed);
    BOOST_CHECK(Exact(e.deviation->upper - found) <= Exact(1e-6) * e.deviation->upper);
  }
  BOOST_CHECK_GT(inside, 10);
}

BOOST_AUTO_TEST_CASE(largest_gap_between_edges) {
  const Polynomial g = t - t * t * t, minus = constant(-1); // at most sqrt(4/27)
  for (const Exact& c : {Exact(1), Exact(1e-12), Exact(123.456)}) {
    const Rows a = surface(one, zero), b = surface(minus, zero, row(t, c * g, zero));
    for (const GC::Edge_deviation& d : {GC::deviation(a, b), GC::deviation(b, a), GC::deviation(a.reversed(), b)}) {
      BOOST_CHECK(encloses_root(d.gap, Exact(c * c * 4) / 27));
      BOOST_CHECK_LE(ulps(d.gap), 4);
      BOOST_REQUIRE(d.normal_angle);
      BOOST_CHECK_EQUAL(*d.normal_angle, (GC::Enclosure{0, 0})); // both in the plane z = 0
    }
    BOOST_CHECK(GC::deviation(a.reversed(), b).reversed && !GC::deviation(a, b).reversed);
    // lifted by a constant
    const GC::Edge_deviation up = GC::deviation(a, surface(minus, zero, row(t, zero, constant(c))));
    BOOST_CHECK(encloses_root(up.gap, Exact(c * c)));
    BOOST_CHECK_LE(ulps(up.gap), 2);
  }
  // without normals on one side
  const GC::Edge_deviation none = GC::deviation(flat, surface(zero, zero));
  BOOST_CHECK(!none.normal_angle && none.normal_vanishes);
  BOOST_CHECK_EQUAL(GC::order_within(none, {4, 1})(1), Verdict::refuted);
}

BOOST_AUTO_TEST_CASE(edge_verdicts) {
  typedef GC::Spline_edge_rows<Exact> Spline_rows;
  const auto whole = [](const Rows& rows) { // elevated to degree 3, over [0, 1]
    const auto cubic = [](const Rows::Row& r) {
      Polynomial c[3] = {zero, zero, zero};
      for (int k = 0; k < 3; ++k) {
        std::vector<Exact> b;
        for (const auto& p : r) b.push_back(p[k]);
        c[k] = Polynomial(b).elevated(4 - static_cast<int>(b.size()));
      }
      return row(c[0], c[1], c[2]);
    };
    return Spline_rows{GC::Knot_vector<Exact>(3, Exact(0), Exact(1)),
                       {cubic(rows.edge), cubic(rows.cross), cubic(rows.second_cross)}};
  };
  const Polynomial minus = constant(-1), g = t - t * t * t;
  const Spline_rows a = whole(flat), b = whole(surface(minus, constant(Exact(1) / 8))),
                    c = whole(surface(minus, zero, row(t, constant(Exact(1) / 1024) * g, zero)));
  // a crease of arctan(1/8)
  const double angle = std::atan(0.125);
  BOOST_CHECK_EQUAL(GC::order_within(a, b, {angle * 1.001, 0}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(a, b, {angle * 0.999, 0}).proved_order(), 0);
  BOOST_CHECK_EQUAL(GC::order_within(a, b, {angle * 0.999, 0})(1), Verdict::refuted);
  BOOST_CHECK_EQUAL(text(GC::order_within(a, b, {angle * 0.999, 0})).substr(0, 35),
                    "order 0 proved, 1 refuted; gap 0, n");
  const GC::Enclosure e = *GC::deviation(a, b).normal_angle;
  BOOST_REQUIRE(e.lower < e.upper);
  BOOST_CHECK_EQUAL(GC::order_within(a, b, {e.lower, 0})(1), Verdict::undecided);
  BOOST_CHECK_EQUAL(GC::order_within(a, b, {e.upper, 0})(1), Verdict::proved);
  BOOST_CHECK_EQUAL(GC::order_within(a, b, {std::nextafter(e.lower, 0), 0})(1), Verdict::refuted);
  // a gap refutes everything, unless it is tolerated
  const GC::Enclosure gap = GC::deviation(a, c).gap;
  BOOST_REQUIRE(gap.lower < gap.upper);
  for (int order : {0, 1}) {
    BOOST_CHECK_EQUAL(GC::order_within(a, c, {1, 0})(order), Verdict::refuted);
    BOOST_CHECK_EQUAL(GC::order_within(a, c, {1, gap.lower})(order), Verdict::undecided);
    BOOST_CHECK_EQUAL(GC::order_within(a, c, {0, gap.upper})(order), Verdict::proved);
  }
  // what holds exactly is proved with the tolerance 0; a fold is far from it
  BOOST_CHECK_EQUAL(GC::order_within(a, whole(surface(minus, zero)), {}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(a, a, {3.14, 0})(1), Verdict::refuted);
  BOOST_CHECK_EQUAL(GC::order_within(a, a, {3.15, 0})(1), Verdict::proved);
  // no tangent plane, no order 1
  BOOST_CHECK_EQUAL(GC::order_within(a, whole(surface(minus * t, zero)), {4, 0})(1), Verdict::refuted);
  // only a part of the edge in common: the whole if it is near, otherwise the part
  Rows linear = surface(constant(-1).elevated(), constant(Exact(0.125)).elevated(), row(Exact(0.5) * t, zero, zero));
  linear.second_cross = row(zero, zero, zero.elevated());
  const Spline_rows half{GC::Knot_vector<Exact>(1, Exact(0), Exact(0.5)), linear};
  BOOST_CHECK_EQUAL(GC::order_within(a, half, {angle * 1.001, 0}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(a, half, {angle * 1.001, 0}).deviation.gap, (GC::Enclosure{0, 0}));
  BOOST_CHECK_EQUAL(GC::order_within(a, half, {angle * 1.001, 0.6}).deviation.gap, (GC::Enclosure{0.5, 0.5}));
  BOOST_CHECK_EQUAL(GC::order_within(half, a, {angle * 1.001, 0}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(half, a, {angle * 1.001, 0}).deviation.gap, (GC::Enclosure{0, 0}));

  for (int order : {-1, 2}) CHECK_ERROR(GC::order_within(a, b, {1, 1})(order), jet_order_too_low);
  for (const GC::Edge_tolerance& bad : {GC::Edge_tolerance{-1, 0}, GC::Edge_tolerance{0, -1},
                                        GC::Edge_tolerance{std::numeric_limits<double>::quiet_NaN(), 0}})
    CHECK_ERROR(GC::order_within(a, b, bad), unreachable_tolerance);
}

// Where a normal vanishes on a whole edge there is no angle.
BOOST_AUTO_TEST_CASE(edges_without_a_normal) {
  typedef GC::Bezier_patch<Epick_3> Patch;
  typedef Epick_3::Point Point;
  const Patch a({{Point(0, 0, 0), Point(0, 1, 0)}, {Point(1, 0, 0), Point(1, 1, 0)}}),
      folded({{Point(0, 0, 0), Point(0, 0, 0), Point(0, -1, 0)}, {Point(1, 0, 0), Point(1, 0, 0), Point(1, -1, 0)}}),
      pole({{Point(0, 0, 0), Point(0, -1, 0)}, {Point(1, 0, 0), Point(0, -1, 0)}});
  BOOST_CHECK_EQUAL(text(GC::deviation(a, v0, pole, v0)), "gap 0, normal angle 0 degrees");
  for (const auto& [x, y] : {std::pair{a, folded}, std::pair{folded, a}}) {
    BOOST_CHECK_EQUAL(text(GC::deviation(x, v0, y, v0)), "gap 0, a normal vanishes");
    const auto spans = GC::Bspline_surface<Epick_3>(x).insert_u(0.5);
    BOOST_CHECK_EQUAL(text(GC::deviation(spans, v0, y, v0)), "gap 0, a normal vanishes");
    const auto edge = GC::edge_continuity(x, v0, y, v0);
    BOOST_CHECK(edge.g_order == 0 && edge.normal_vanishes && !edge.deviation);
    for (const GC::Edge_order_within& within :
         {GC::order_within(edge, {4, 0}), GC::order_within(x, v0, y, v0, {4, 0}), GC::order_within(x, v0, y, v0, 4)}) {
      BOOST_CHECK(within(0) == Verdict::proved && within(1) == Verdict::refuted);
      BOOST_CHECK(!within.deviation.normal_angle && within.deviation.normal_vanishes);
    }
  }
}

BOOST_AUTO_TEST_CASE(rows_without_coefficients) {
  for (const auto member : {&Rows::edge, &Rows::cross, &Rows::second_cross}) {
    Rows bad = flat;
    (bad.*member).clear();
    for (const auto& [a, b] : {std::pair{bad, flat}, std::pair{flat, bad}})
      CHECK_ERROR((void)GC::edge_continuity(a, b), wrong_number_of_points);
  }
}

// In release builds too, in which preconditions are not checked.
BOOST_AUTO_TEST_CASE(edges_that_have_nothing_in_common) {
  typedef GC::Bezier_patch<Epick_3> Patch;
  typedef Epick_3::Point Point;
  const Patch a({{Point(0, 0, 0), Point(0, 1, 0)}, {Point(1, 0, 0), Point(1, 1, 0)}}),
      b({{Point(0, 0, 5), Point(0, -1, 5)}, {Point(1, 0, 5), Point(1, -1, 5)}});
  const auto none = GC::edge_continuity(a, v0, b, v0);
  BOOST_CHECK_EQUAL(none.g_order, -1);
  CHECK_ERROR(GC::order_within(none, {1, 1}), curves_do_not_meet);
  const GC::Edge_order_within apart = GC::order_within(a, v0, b, v0, {1, 1});
  BOOST_CHECK_EQUAL(apart(0), Verdict::refuted);
  BOOST_CHECK_EQUAL(apart(1), Verdict::refuted);
  BOOST_CHECK_EQUAL(apart.proved_order(), -1);
  BOOST_CHECK_EQUAL(apart.deviation.gap, (GC::Enclosure{5, 5}));
  // the gap is tolerated
  BOOST_CHECK_EQUAL(GC::order_within(a, v0, b, v0, {0, 5}).proved_order(), 1);
}

// A knot line with a jump is continuous within a tolerance.
BOOST_AUTO_TEST_CASE(knot_lines_within_a_tolerance) {
  typedef GC::Bspline_surface<Epick_3> Surface;
  const double unit = 0x1p-30;
  const auto surface = [](double jump, double slope) {
    const double x[4] = {0, 1, 1, 2}, z[4] = {0, 0, jump, jump + slope};
    std::vector<std::vector<Epick_3::Point>> net;
    for (int i = 0; i < 4; ++i) net.push_back({Epick_3::Point(x[i], 0, z[i]), Epick_3::Point(x[i], 1, z[i])});
    return Surface(net, GC::Knot_vector<double>(1, {0, 0, 1, 1, 2, 2}), GC::Knot_vector<double>(1, {0, 0, 1, 1}));
  };
  const Surface jump = surface(unit, 0), kink = surface(0, 0.125);
  const auto jumps = GC::knot_line_continuity(jump), kinks = GC::knot_line_continuity(kink);
  BOOST_REQUIRE(jumps.size() == 1 && kinks.size() == 1);
  BOOST_CHECK_EQUAL(jumps[0].continuity.g_order, -1);
  BOOST_CHECK_EQUAL(GC::order_within(jump, jumps[0], {0, unit}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(jump, jumps[0], {0, unit / 2})(0), Verdict::refuted);
  BOOST_CHECK_EQUAL(GC::order_within(kink, kinks[0], {0.125, 0}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(kink, kinks[0], {0.124, 0}).proved_order(), 0);
  // along the other parameter, behind another knot; and a line that is none
  const double x[5] = {0, 0.5, 1, 1, 2}, z[5] = {0, 0, 0, unit, unit};
  std::vector<std::vector<Epick_3::Point>> net(2);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 2; ++j) net[j].emplace_back(x[i], j, z[i]);
  const Surface other(net, GC::Knot_vector<double>(1, {0, 0, 1, 1}),
                      GC::Knot_vector<double>(1, {0, 0, 0.5, 1, 1, 2, 2}));
  const auto lines = GC::knot_line_continuity(other);
  BOOST_REQUIRE_EQUAL(lines.size(), 2u);
  BOOST_CHECK(lines[1].continuity.g_order == -1 && !lines[1].constant_u);
  BOOST_CHECK_EQUAL(GC::order_within(other, lines[1], {0, unit}).proved_order(), 1);
  BOOST_CHECK_EQUAL(GC::order_within(other, lines[1], {0, unit / 2})(0), Verdict::refuted);
  CHECK_ERROR(GC::order_within(other, jumps[0], {0, unit}), knot_multiplicity);
}

BOOST_AUTO_TEST_SUITE_END()
