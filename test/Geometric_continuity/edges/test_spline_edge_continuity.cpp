// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Continuity of B-spline surfaces along edges, parts of edges and knot lines.

#include "support/spline_surfaces.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>

// The spans with their orders, e.g. "0 G2 1 G0 3".
template <class FT> std::string spans(const GC::Spline_edge_continuity<FT>& e) {
  std::ostringstream os;
  for (const auto& span : e.spans)
    os << span.begin << (span.continuity.g_order < 0 ? " - " : " G") << std::max(0, span.continuity.g_order) << ' ';
  if (!e.spans.empty()) os << e.spans.back().end;
  return os.str();
}

template <class FT> std::string parts(const GC::Spline_edge_continuity<FT>& e) {
  return text(e.part_a.first, "..", e.part_a.second, (e.whole_a ? " whole, " : ", "), e.part_b.first, "..",
              e.part_b.second, (e.whole_b ? " whole" : ""));
}

// ---------------------------------------------------------------- whole edges

BOOST_AUTO_TEST_CASE_TEMPLATE(knots_degrees_directions_and_domains, K, Kernels) {
  const S low = spline(wave, knots(0, 4, {1, 2, 2}), knots(0, 1)),
          high = spline(wave, knots(0, 4, {2, 3}), knots(1, 3, {2}));
  const auto e = edge_continuity(in<K>(low), v1, in<K>(high), v0);
  BOOST_CHECK_EQUAL(e.g_order, 2);
  BOOST_CHECK_EQUAL(e.defect, Edge_defect::none);
  BOOST_CHECK_EQUAL(e.side, GC::Sign_pattern::negative);
  BOOST_CHECK(e.coplanar && !e.reversed && !e.collapsed && !e.normal_vanishes);
  BOOST_CHECK_EQUAL(spans(e), "0 G2 1 G2 2 G2 3 G2 4");
  BOOST_CHECK_EQUAL(parts(e), "0..4 whole, 0..4 whole");
  BOOST_CHECK_EQUAL(text(e), "G2");

  const auto backwards = edge_continuity(in<K>(low), v1, in<K>(high.reverse_u().swap_parameters()), u0);
  BOOST_CHECK(backwards.g_order == 2 && backwards.reversed);
  BOOST_CHECK_EQUAL(spans(backwards), "0 G2 1 G2 2 G2 3 G2 4");
  BOOST_CHECK_EQUAL(edge_continuity(in<K>(low.reverse_v()), v0, in<K>(high), v0).g_order, 2);
  BOOST_CHECK_EQUAL(edge_continuity(in<K>(low), v1, in<K>(high.reverse_v()), v1).g_order, 2);

  const auto longer = edge_continuity(in<K>(low), v1, in<K>(with_knots(high, 2, -7)), v0);
  BOOST_CHECK_EQUAL(spans(longer), "0 G2 1 G2 2 G2 3 G2 4");
  BOOST_CHECK_EQUAL(parts(longer), "0..4 whole, -7..1 whole");
  const auto shorter = edge_continuity(in<K>(with_knots(high.reverse_u(), 2, -7)), v0, in<K>(low), v1);
  BOOST_CHECK_EQUAL(spans(shorter), "-7 G2 -5 G2 -3 G2 -1 G2 1");
  BOOST_CHECK(shorter.reversed);

  BOOST_CHECK_EQUAL(edge_continuity(in<K>(low), v0, in<K>(high), v0).g_order, -1);
  BOOST_CHECK(edge_continuity(in<K>(low), v0, in<K>(high), v0).spans.empty());
  BOOST_CHECK_EQUAL(edge_continuity(in<K>(low), v1, in<K>(low), v1).defect, Edge_defect::fold);
}

BOOST_AUTO_TEST_CASE(degrees_and_unclamped_knots) {
  const S low = spline(wave, knots(0, 4, {1}), knots(0, 1)),
          high = spline(wave, Knots(3, {-3, -2, -1, 0, 2, 4, 5, 6, 9}), Knots(3, {-1, 0, 0, 1, 3, 4, 5, 7}));
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, high, v0)), "0 G2 1 G2 2 G2 4");
  BOOST_CHECK_EQUAL(spans(edge_continuity(low.elevate(2, 1), v1, high, v0)), "0 G2 1 G2 2 G2 4");
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, high.elevate(1, 0), v0)), "0 G2 1 G2 2 G2 4");
  // a Bezier patch on either side
  const Patch<Exact> patch = spline(wave, knots(0, 4), knots(1, 2)).bezier_patches()[0];
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, patch, v0)), "0 G2 1 G2 4");
  BOOST_CHECK_EQUAL(spans(edge_continuity(patch, v0, low, v1)), "0 G2 1 G2 4");
  BOOST_CHECK_EQUAL(spans(edge_continuity(patch.reverse_u(), v0, patch, v0)), "0 G0 4");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(one_verdict_for_each_span, K, Kernels) {
  const S low = spline(wave, knots(0, 5, {1, 2, 3, 4}), knots(0, 1)),
          high = spline(wave, knots(0, 5, {1, 2, 3, 4}), knots(1, 2));
  // the control points (0, l) belong to the first span only, those of (2, l) to the first three
  const auto crease = edge_continuity(in<K>(low), v1, in<K>(lifted(high, 0, 1)), v0);
  BOOST_CHECK_EQUAL(spans(crease), "0 G0 1 G2 2 G2 3 G2 4 G2 5");
  BOOST_CHECK_EQUAL(crease.g_order, 0);
  BOOST_CHECK_EQUAL(crease.defect, Edge_defect::crease);
  BOOST_CHECK_EQUAL(crease.worst, 0);
  BOOST_CHECK(!crease.coplanar);
  BOOST_REQUIRE(crease.deviation);
  BOOST_CHECK(crease.deviation->upper == crease.spans[0].continuity.deviation->upper);
  BOOST_CHECK(crease.deviation->upper > Q(0) && crease.deviation->end <= Q(1));
  BOOST_CHECK_EQUAL(text(crease).substr(0, 11), "G0 (crease)");
  BOOST_CHECK(contains(text(crease), ", worst of 5 spans on [0, 1]"));

  const auto curvature = edge_continuity(in<K>(low), v1, in<K>(lifted(high, 2, 2)), v0);
  BOOST_CHECK_EQUAL(spans(curvature), "0 G1 1 G1 2 G1 3 G2 4 G2 5");
  BOOST_CHECK_EQUAL(curvature.defect, Edge_defect::curvature);
  BOOST_CHECK(curvature.coplanar && curvature.deviation && curvature.deviation->upper == Q(0));

  const auto both = edge_continuity(in<K>(lifted(low, 0, 1)), v1, in<K>(lifted(lifted(high, 7, 1), 6, 1)), v0);
  BOOST_CHECK_EQUAL(spans(both), "0 G1 1 G2 2 G2 3 G0 4 G0 5");
  BOOST_CHECK(both.worst >= 3);
  const auto& worst = both.spans[both.worst];
  BOOST_CHECK(both.deviation->upper == worst.continuity.deviation->upper);
  BOOST_CHECK(worst.begin <= both.deviation->begin && both.deviation->end <= worst.end);
}

// The verdict of each span is that of the Bezier patches on it.
BOOST_AUTO_TEST_CASE(spans_are_bezier_patches) {
  std::mt19937_64 random = seeded();
  const auto number = [&] { return Q(Q(int(random() % 2000001) - 1000000) / Q(1 + int(random() % 1000))); };
  for (int round = 0; round < 6; ++round) {
    const Knots u(3, {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}), v = knots(0, 1, {Q(1) / 3});
    S a = spline(wave, u, v), b = spline(wave, u, knots(1, 2));
    const int order = round % 3; // of the rows that are changed
    const auto change = [&](const S& s, int row) {
      const int n = s.number_of_points_v();
      return with_points(s, [&, n, row](int, int j, const Exact::Point_3& p) {
        const bool changed = row == 0 ? j > order : j < n - 1 - order;
        return changed ? Exact::Point_3{number(), number(), number()} : p;
      });
    };
    a = change(a, 1);
    b = change(b, 0);
    const auto e = edge_continuity(a, v1, b, v0);
    BOOST_REQUIRE_EQUAL(e.spans.size(), 3);
    const std::vector<Patch<Exact>> pa = a.bezier_patches(), pb = b.bezier_patches();
    for (int i = 0; i < 3; ++i) {
      const auto piece = edge_continuity(pa[2 * i + 1], v1, pb[i], v0);
      BOOST_CHECK_EQUAL(text(piece), text(e.spans[i].continuity));
      BOOST_CHECK(piece.side == e.spans[i].continuity.side && piece.vanishing == e.spans[i].continuity.vanishing);
      BOOST_CHECK(piece.deviation.has_value() == e.spans[i].continuity.deviation.has_value());
      if (!piece.deviation) continue;
      BOOST_CHECK(piece.deviation->begin == e.spans[i].continuity.deviation->begin);
      BOOST_CHECK(piece.deviation->upper == e.spans[i].continuity.deviation->upper);
      BOOST_CHECK(piece.deviation->upper <= e.deviation->upper);
    }
  }
}

// ---------------------------------------------------------------- parts of edges

BOOST_AUTO_TEST_CASE_TEMPLATE(one_long_edge_meets_several, K, Kernels) {
  const S low = spline(wave, knots(0, 4), knots(0, 1)), left = spline(wave, knots(0, 1), knots(1, 2)),
          right = with_knots(spline(wave, knots(1, 4, {2}), knots(1, 2)).reverse_u(), 2, 0);
  const auto l = edge_continuity(in<K>(low), v1, in<K>(left), v0);
  BOOST_CHECK_EQUAL(spans(l), "0 G2 1");
  BOOST_CHECK_EQUAL(parts(l), "0..1, 0..1 whole");
  BOOST_CHECK_EQUAL(text(l), "G2, a part of the first edge");
  BOOST_CHECK_EQUAL(text(edge_continuity(in<K>(left), v0, in<K>(low), v1)), "G2, a part of the second edge");
  BOOST_CHECK_EQUAL(text(edge_continuity(in<K>(left), v0, in<K>(left), v0)), "G0 (fold), angle <= 180 degrees");
  const auto r = edge_continuity(in<K>(low), v1, in<K>(right), v0);
  BOOST_CHECK_EQUAL(spans(r), "1 G2 2 G2 4");
  BOOST_CHECK_EQUAL(parts(r), "1..4, 2..8 whole");
  BOOST_CHECK(r.reversed);
  const auto long_one = edge_continuity(in<K>(right), v0, in<K>(low), v1);
  BOOST_CHECK_EQUAL(spans(long_one), "2 G2 6 G2 8");
  BOOST_CHECK_EQUAL(parts(long_one), "2..8 whole, 1..4");
  // one point in common
  BOOST_CHECK_EQUAL(edge_continuity(in<K>(left), v0, in<K>(right), v0).g_order, -1);
  BOOST_CHECK_EQUAL(edge_continuity(in<K>(lifted(low, 0, 2)), v1, in<K>(left), v0).g_order, 0);
}

BOOST_AUTO_TEST_CASE(overlapping_straight_edges) {
  const Map plane = graph({});
  const S low = spline(plane, knots(0, 3), knots(0, 1)), high = spline(plane, knots(2, 7), knots(1, 2));
  const auto e = edge_continuity(low, v1, high, v0);
  BOOST_CHECK_EQUAL(spans(e), "2 G2 3");
  BOOST_CHECK_EQUAL(parts(e), "2..3, 2..3");
  BOOST_CHECK_EQUAL(text(e), "G2, a part of both edges");
  // as points: the parameters differ by an affine map
  BOOST_CHECK_EQUAL(parts(edge_continuity(low.elevate(1, 0), v1, with_knots(high.reverse_u(), Q(1) / 3, 5), v0)),
                    "2..3, " + text(Q(5 + Q(6) / 3)) + ".." + text(Q(5 + Q(7) / 3)));
  for (int a : {3, 4}) // a point, nothing
    BOOST_CHECK_EQUAL(edge_continuity(low, v1, spline(plane, knots(a, 7), knots(1, 2)), v0).defect, Edge_defect::gap);
  // the same straight edge, run through at another pace
  Map uneven = plane;
  uneven[0] = {{{0}, {2}, {1}, {0}}};
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, spline(uneven, knots(0, 1), knots(1, 2)), v0).defect, Edge_defect::gap);
  BOOST_CHECK_EQUAL(
      edge_continuity(spline(uneven, knots(0, 1), knots(0, 1)), v1, spline(uneven, knots(0, 1), knots(1, 2)), v0)
          .g_order,
      2);
}

BOOST_AUTO_TEST_CASE(parts_of_splines) {
  std::mt19937_64 random = seeded();
  const S a =
      with_points(spline(wave, knots(0, 5, {1, 2, 3, 3, 4}), knots(0, 1)), [&](int, int, const Exact::Point_3&) {
        return Exact::Point_3{int(random() % 1000), int(random() % 1000), int(random() % 1000)};
      });
  const S b = with_knots(part(a, 1, 4), Q(1) / 7, -2);
  const auto e = edge_continuity(a, v1, b, v1); // it lies on the same side
  BOOST_CHECK_EQUAL(spans(e), "1 G0 2 G0 3 G0 4");
  BOOST_CHECK_EQUAL(e.defect, Edge_defect::fold);
  BOOST_CHECK(e.whole_b && !e.whole_a);
  BOOST_CHECK_EQUAL(spans(edge_continuity(part(a, 0, 3), v1, part(a, 2, 5).reverse_u(), v1)), "2 G0 3");
  // parts that end inside a span
  BOOST_CHECK_EQUAL(spans(edge_continuity(a, v1, part(a, Q(1) / 2, Q(7) / 2), v1)), "1/2 G0 1 G0 2 G0 3 G0 7/2");
  // which leave each other before the end: the last control points belong to the last span
  const S leaves = lifted(part(a, 1, 4), part(a, 1, 4).number_of_points_u() - 1, 3);
  BOOST_CHECK_EQUAL(parts(edge_continuity(a, v1, leaves, v1)), "1..3, 1..3");
  BOOST_CHECK_EQUAL(edge_continuity(a, v1, leaves, v0).g_order, -1);
}

// x = t^2, z = t^4: the parameter cannot be found from the coefficients without roots.
BOOST_AUTO_TEST_CASE(edges_in_a_power_of_the_parameter) {
  Map even{};
  even[0] = {{{0}, {0}, {1}, {0}}};
  even[1] = {{{0, 1}}};
  const S low = spline(even, knots(0, 2), knots(0, 1)), high = spline(even, knots(0, 2, {1}), knots(1, 2));
  // C' = 0 at 0
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, with_knots(high, 3, 1), v0)), "0 G0 1 G2 2");
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, high, v0).defect, Edge_defect::vanishing_normal);
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, part(high, 0, 1), v0).defect, Edge_defect::gap);
}

BOOST_AUTO_TEST_CASE(collapsed_edges_and_spans) {
  // the control points (0, 0), ..., (last, 0) become one
  const auto collapse = [](const S& s, int last) {
    return with_points(s, [&, last](int i, int j, const Exact::Point_3& p) {
      return j == 0 && i <= last ? s.control_point(0, 0) : p;
    });
  };
  const S high = spline(wave, knots(0, 3, {1, 1, 1, 2}), knots(1, 2));
  const int all = high.number_of_points_u() - 1;
  const auto point = edge_continuity(collapse(high, all), v0, with_knots(collapse(high, all), 2, 0), v0);
  BOOST_CHECK(point.g_order == 0 && point.collapsed && point.defect == Edge_defect::collapsed && point.whole_a);
  const auto some = edge_continuity(collapse(high, 3), v0, collapse(high, 3).reverse_u(), v0);
  BOOST_CHECK(!some.collapsed && some.reversed && some.spans[0].continuity.collapsed);
  BOOST_CHECK_EQUAL(some.defect, Edge_defect::fold);
  BOOST_CHECK_EQUAL(some.spans[0].continuity.defect, Edge_defect::collapsed);
}

BOOST_AUTO_TEST_CASE(numbers_are_taken_as_they_are) {
  typedef CGAL::Epick K;
  const Surface<K> low = in<K>(spline(wave, knots(0, 4, {1}), knots(0, 1))),
                   high = in<K>(spline(wave, knots(0, 4, {1}), knots(1, 2)));
  const auto moved = [&](int i, int j) {
    const auto point = [&](int k, int l) {
      const K::Point_3& p = high.control_point(k, l);
      return K::Point_3(p.x(), p.y(), k == i && l == j ? std::nextafter(p.z(), 1e9) : p.z());
    };
    return Surface<K>(net_of(high.number_of_points_u(), high.number_of_points_v(), point), high.knots_u(),
                      high.knots_v());
  };
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, high, v0).g_order, 2);
  // different on the last span
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, moved(4, 0), v0)), "0 G2 1");
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, moved(4, 1), v0)), "0 G2 1 G0 4");
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, moved(4, 2), v0)), "0 G2 1 G1 4");
  // a knot that is one unit in the last place away
  const auto with_knot = [](double t) {
    return Surface<K>(net_of(3, 2, [](int i, int j) { return K::Point_3(i, j, i == 2); }),
                      GC::Knot_vector<double>(1, {0, 0, t, 1, 1}), GC::Knot_vector<double>(1, {0, 0, 1, 1}));
  };
  const Surface<K> exact = with_knot(0.1), near = with_knot(std::nextafter(0.1, 1.0));
  BOOST_CHECK(edge_continuity(exact, v0, exact, v0).whole_a);
  BOOST_CHECK(!edge_continuity(near, v0, exact, v0).whole_a);
}

BOOST_AUTO_TEST_CASE(wrong_input) {
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  const Q c[] = {1, 2, 3, 4};
  const auto flat = [&](int d) {
    const Traits::Point p = Traits().construct_point_object()(d, c, c + d);
    return GC::Bspline_surface<Traits>(GC::Bezier_patch<Traits>({{p}}));
  };
  CHECK_ERROR(edge_continuity(flat(3), v0, flat(2), v0), dimension_mismatch);
  CHECK_ERROR(knot_line_continuity(flat(4)), dimension_mismatch);
  CHECK_ERROR(GC::model_continuity(std::vector<GC::Bspline_surface<Traits>>{flat(2)}), dimension_mismatch);
  BOOST_CHECK_EQUAL(edge_continuity(flat(3), v0, flat(3), u1).defect, Edge_defect::collapsed);
  GC::Spline_edge_rows<Q> rows = GC::spline_edge_rows(spline(wave, knots(0, 1), knots(0, 1)), v0);
  rows.rows.cross.pop_back();
  CHECK_ERROR(edge_continuity(rows, rows), wrong_number_of_points);
  const S s = spline(wave, knots(0, 1), knots(0, 1));
  CHECK_ERROR(s.rows_at(GC::Parameter_line::along_u, 2, GC::Line_side::larger_parameters, 1), parameter_outside_domain);
}

// ---------------------------------------------------------------- knot lines

BOOST_AUTO_TEST_CASE_TEMPLATE(knot_lines, K, Kernels) {
  // superfluous knots: all lines are G2, the simple knots are not listed
  const S smooth = spline(wave, knots(0, 4, {1, 2, 2, 3, 3, 3}), knots(0, 6, {2, 4, 4, 4, 4}));
  const auto lines = knot_line_continuity(in<K>(smooth));
  BOOST_REQUIRE_EQUAL(lines.size(), 3);
  BOOST_CHECK_EQUAL(text(lines[0]), "u = 2: G2");
  BOOST_CHECK_EQUAL(text(lines[1]), "u = 3: G2");
  BOOST_CHECK_EQUAL(text(lines[2]), "v = 4: G2");
  BOOST_CHECK_EQUAL(lines[1].multiplicity, 3);
  BOOST_CHECK_EQUAL(spans(lines[0].continuity), "0 G2 2 G2 4 G2 6");
  BOOST_CHECK_EQUAL(spans(lines[2].continuity), "0 G2 1 G2 2 G2 3 G2 4");
  BOOST_CHECK(lines[0].constant_u && !lines[2].constant_u && lines[2].knot == 4);

  // u: 0 0 0 0 2 2 4 4 4 4; the control points 2 and 3 are next to the knot 2, on both sides of the
  // plane C' of the line
  const S twice = spline(graph({}), knots(0, 4, {2, 2}), knots(0, 2, {1}));
  BOOST_CHECK_EQUAL(spans(knot_line_continuity(in<K>(lifted(twice, 1, 0)))[0].continuity), "0 G1 1 G2 2");
  BOOST_CHECK_EQUAL(spans(knot_line_continuity(in<K>(lifted(twice, 5, 4)))[0].continuity), "0 G2 1 G2 2");
  // u: 2 thrice
  const S thrice = spline(graph({}), knots(0, 4, {2, 2, 2}), knots(0, 2, {1}));
  BOOST_CHECK_EQUAL(spans(knot_line_continuity(in<K>(lifted(thrice, 2, 4)))[0].continuity), "0 G2 1 G0 2");
  BOOST_CHECK_EQUAL(spans(knot_line_continuity(in<K>(lifted(thrice, 1, 2)))[0].continuity), "0 G1 1 G1 2");
  // u: 2 four times: the surface may jump
  const S four = spline(graph({}), knots(0, 4, {2, 2, 2, 2}), knots(0, 2, {1}));
  const auto jump = knot_line_continuity(in<K>(lifted(four, 3, 4)));
  BOOST_REQUIRE_EQUAL(jump.size(), 1);
  BOOST_CHECK_EQUAL(spans(jump[0].continuity), "0 G2 1 - 0 2");
  BOOST_CHECK(jump[0].continuity.g_order == -1 && jump[0].continuity.defect == Edge_defect::gap);
  BOOST_CHECK_EQUAL(jump[0].continuity.worst, 1);
}

// G1 by geometry only: the parts on both sides of the knot run at different paces.
BOOST_AUTO_TEST_CASE(knot_lines_with_a_change_of_pace) {
  const S s = spline(wave, knots(0, 4, {2, 2, 2}), knots(0, 1));
  const S slow = changed(
      s, [](int, int, const Exact::Point_3& p) { return p; }, [](const Q& t) { return t > 2 ? Q(2 * t - 2) : t; });
  BOOST_CHECK_EQUAL(slow.knots_u().domain().second, 6);
  BOOST_CHECK_EQUAL(knot_line_continuity(slow)[0].continuity.g_order, 2);
}

// A line turned backwards by a jump is not the same line.
BOOST_AUTO_TEST_CASE(knot_lines_are_compared_at_equal_parameters) {
  const S s = spline(graph({}), knots(0, 4, {2, 2, 2, 2}), knots(0, 2));
  const S turned =
      with_points(s, [&](int i, int j, const Exact::Point_3& p) { return i < 4 ? p : s.control_point(i, 3 - j); });
  BOOST_CHECK_EQUAL(knot_line_continuity(turned)[0].continuity.g_order, -1);
}

// Compared with the edges of the two parts.
BOOST_AUTO_TEST_CASE(knot_lines_are_edges_of_parts) {
  std::mt19937_64 random = seeded();
  for (int multiplicity : {2, 3}) {
    const S s =
        with_points(spline(wave, knots(0, 3, std::vector<Q>(multiplicity, Q(1))), knots(0, 2, {1})),
                    [&](int, int, const Exact::Point_3&) {
                      return Exact::Point_3{int(random() % 2000001) - 1000000, int(random() % 2000001) - 1000000,
                                            int(random() % 2000001) - 1000000};
                    });
    const auto e = edge_continuity(part(s, 0, 1), u1, part(s, 1, 3), u0);
    const auto u = knot_line_continuity(s)[0], v = knot_line_continuity(s.swap_parameters())[0];
    BOOST_CHECK(u.constant_u && !v.constant_u && u.knot == 1);
    for (const auto& line : {u, v}) {
      BOOST_CHECK_EQUAL(text(line.continuity), text(e));
      BOOST_CHECK_EQUAL(spans(line.continuity), spans(e));
      BOOST_CHECK(line.continuity.deviation->upper == e.deviation->upper);
    }
    BOOST_CHECK_EQUAL(e.g_order, multiplicity == 3 ? 0 : 1 - int(e.normal_vanishes));
  }
}
