// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Continuity of B-spline surfaces along edges, parts of edges and knot lines, and models of them.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE bspline_edges
#include <boost/test/unit_test.hpp>

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef CGAL::Simple_cartesian<Q> Exact;
typedef std::tuple<Exact, CGAL::Epick, CGAL::Simple_cartesian<double>> Kernels;

template <class K> using Surface = GC::Bspline_surface<GC::Traits_3<K>>;
template <class K> using Patch = GC::Bezier_patch<GC::Traits_3<K>>;
typedef Surface<Exact> S;
typedef GC::Knot_vector<Q> Knots;
using GC::Edge_defect;
using GC::Patch_edge;
constexpr Patch_edge u0 = Patch_edge::u0, u1 = Patch_edge::u1, v0 = Patch_edge::v0, v1 = Patch_edge::v1;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

namespace {

// ---------------------------------------------------------------- surfaces

// A polynomial surface: the coefficients of u^i v^j, i, j <= 3.
typedef std::array<std::array<std::array<int, 4>, 4>, 3> Map;

Map graph(const std::array<std::array<int, 4>, 4>& z) {
  Map f{};
  f[0][1][0] = 1;
  f[1][0][1] = 1;
  f[2] = z;
  return f;
}

// x = u, y = v, z = 2 u^3 v - u v^2 + 3 u^2 - u^2 v^3
const Map wave = graph({{{0, 0, 0, 0}, {0, 0, -1, 0}, {3, 0, 0, -1}, {0, 2, 0, 0}}});

// The blossom of u^k in degree 3 at the knots j+1, j+2, j+3.
Q blossom(const Knots& t, int j, int k) {
  const Q &a = t[j + 1], &b = t[j + 2], &c = t[j + 3];
  if (k == 0) return Q(1);
  if (k == 1) return Q((a + b + c) / 3);
  return k == 2 ? Q((a * b + b * c + c * a) / 3) : Q(a * b * c);
}

// Over cubic knots, with the coordinates times 9, so that whole knots give whole coordinates.
S spline(const Map& f, const Knots& u, const Knots& v) {
  std::vector<std::vector<Exact::Point_3>> net(u.number_of_coefficients());
  for (int i = 0; i < u.number_of_coefficients(); ++i)
    for (int j = 0; j < v.number_of_coefficients(); ++j) {
      Q x[3];
      for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 4; ++k)
          for (int l = 0; l < 4; ++l) x[c] += 9 * f[c][k][l] * blossom(u, i, k) * blossom(v, j, l);
      net[i].emplace_back(x[0], x[1], x[2]);
    }
  return S(net, u, v);
}

// With control points and knots moved.
template <class Point_map, class Knot_map> S changed(const S& s, Point_map point, Knot_map knot) {
  std::vector<std::vector<Exact::Point_3>> net(s.number_of_points_u());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) net[i].push_back(point(i, j, s.control_point(i, j)));
  std::vector<Q> u;
  for (const Q& t : s.knots_u()) u.push_back(knot(t));
  return S(net, Knots(s.degree_u(), u), s.knots_v());
}
template <class Point_map> S with_points(const S& s, Point_map point) {
  return changed(s, point, [](const Q& t) { return t; });
}
S lifted(const S& s, int i, int j) {
  return with_points(s, [&](int k, int l, const Exact::Point_3& p) {
    return k == i && l == j ? Exact::Point_3(p.x(), p.y(), p.z() + 1) : p;
  });
}
S with_knots(const S& s, const Q& scale, const Q& shift) {
  return changed(
      s, [](int, int, const Exact::Point_3& p) { return p; }, [&](const Q& t) { return Q(scale * t + shift); });
}

// The part on [a, b] of the domain of u.
S part(const S& s, const Q& a, const Q& b) {
  const int order = s.degree_u() + 1;
  S r = s.clamp();
  for (const Q& t : {a, b}) r = r.insert_u(t, order - r.knots_u().multiplicity(t));
  std::vector<Q> u;
  std::vector<std::vector<Exact::Point_3>> net;
  for (int i = 0; i < r.knots_u().size(); ++i) {
    if (r.knots_u()[i] < a || b < r.knots_u()[i]) continue;
    u.push_back(r.knots_u()[i]);
    if (!(r.knots_u()[i] < b)) continue;
    net.emplace_back();
    for (int j = 0; j < r.number_of_points_v(); ++j) net.back().push_back(r.control_point(i, j));
  }
  return S(net, Knots(order - 1, u), r.knots_v());
}

// The same in another kernel; it must be represented exactly.
template <class K> Surface<K> in(const S& s) {
  typedef typename K::FT FT;
  const auto number = [](const Q& x) {
    if constexpr (std::is_same_v<FT, Q>)
      return x;
    else {
      BOOST_REQUIRE(Q(CGAL::to_double(x)) == x);
      return FT(CGAL::to_double(x));
    }
  };
  std::vector<FT> u, v;
  for (const Q& t : s.knots_u()) u.push_back(number(t));
  for (const Q& t : s.knots_v()) v.push_back(number(t));
  std::vector<std::vector<typename K::Point_3>> net(s.number_of_points_u());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      const Exact::Point_3& p = s.control_point(i, j);
      net[i].emplace_back(number(p.x()), number(p.y()), number(p.z()));
    }
  return Surface<K>(net, GC::Knot_vector<FT>(s.degree_u(), u), GC::Knot_vector<FT>(s.degree_v(), v));
}

Knots knots(const Q& a, const Q& b, const std::vector<Q>& inner = {}) {
  std::vector<Q> u(4, a);
  u.insert(u.end(), inner.begin(), inner.end());
  u.insert(u.end(), 4, b);
  return Knots(3, u);
}

// ---------------------------------------------------------------- results

template <class T> std::string text(const T& x) {
  std::ostringstream os;
  os << x;
  return os.str();
}

// The spans with their orders, e.g. "0 G2 1 G0 3".
template <class FT> std::string spans(const GC::Spline_edge_continuity<FT>& e) {
  std::ostringstream os;
  for (const auto& span : e.spans)
    os << span.begin << (span.continuity.g_order < 0 ? " - " : " G") << std::max(0, span.continuity.g_order) << ' ';
  if (!e.spans.empty()) os << e.spans.back().end;
  return os.str();
}

template <class FT> std::string parts(const GC::Spline_edge_continuity<FT>& e) {
  std::ostringstream os;
  os << e.part_a.first << ".." << e.part_a.second << (e.whole_a ? " whole, " : ", ") << e.part_b.first << ".."
     << e.part_b.second << (e.whole_b ? " whole" : "");
  return os.str();
}

std::mt19937_64 seeded() {
  constexpr unsigned seed = 20260721;
  BOOST_TEST_MESSAGE("seed " << seed);
  return std::mt19937_64(seed);
}

} // namespace

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
  BOOST_CHECK(text(crease).find(", worst of 5 spans on [0, 1]") != std::string::npos);

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
        return changed ? Exact::Point_3(number(), number(), number()) : p;
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
  const auto r = edge_continuity(in<K>(low), v1, in<K>(right), v0);
  BOOST_CHECK_EQUAL(spans(r), "1 G2 2 G2 4");
  BOOST_CHECK_EQUAL(parts(r), "1..4, 2..8 whole");
  BOOST_CHECK(r.reversed);
  const auto long_one = edge_continuity(in<K>(right), v0, in<K>(low), v1);
  BOOST_CHECK_EQUAL(spans(long_one), "2 G2 6 G2 8");
  BOOST_CHECK_EQUAL(parts(long_one), "2..8 whole, 1..4");
  BOOST_CHECK_EQUAL(edge_continuity(in<K>(left), v0, in<K>(right), v0).g_order, -1); // one point in common
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
        return Exact::Point_3(int(random() % 1000), int(random() % 1000), int(random() % 1000));
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
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, with_knots(high, 3, 1), v0)), "0 G0 1 G2 2"); // C' = 0 at 0
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, high, v0).defect, Edge_defect::vanishing_normal);
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, part(high, 0, 1), v0).defect, Edge_defect::gap);
}

BOOST_AUTO_TEST_CASE(collapsed_edges_and_spans) {
  const auto collapse = [](const S& s, int last) { // the control points (0, 0), ..., (last, 0) become one
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
    std::vector<std::vector<K::Point_3>> net(high.number_of_points_u());
    for (int k = 0; k < high.number_of_points_u(); ++k)
      for (int l = 0; l < high.number_of_points_v(); ++l) {
        const K::Point_3& p = high.control_point(k, l);
        net[k].emplace_back(p.x(), p.y(), k == i && l == j ? std::nextafter(p.z(), 1e9) : p.z());
      }
    return Surface<K>(net, high.knots_u(), high.knots_v());
  };
  BOOST_CHECK_EQUAL(edge_continuity(low, v1, high, v0).g_order, 2);
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, moved(4, 0), v0)), "0 G2 1"); // different on the last span
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, moved(4, 1), v0)), "0 G2 1 G0 4");
  BOOST_CHECK_EQUAL(spans(edge_continuity(low, v1, moved(4, 2), v0)), "0 G2 1 G1 4");
  // a knot that is one unit in the last place away
  const Surface<K> near(std::vector<std::vector<K::Point_3>>{{K::Point_3(0, 0, 0), K::Point_3(0, 1, 0)},
                                                             {K::Point_3(1, 0, 0), K::Point_3(1, 1, 0)},
                                                             {K::Point_3(2, 0, 1), K::Point_3(2, 1, 1)}},
                        GC::Knot_vector<double>(1, {0, 0, std::nextafter(0.1, 1.0), 1, 1}),
                        GC::Knot_vector<double>(1, {0, 0, 1, 1}));
  const Surface<K> exact({{K::Point_3(0, 0, 0), K::Point_3(0, 1, 0)},
                          {K::Point_3(1, 0, 0), K::Point_3(1, 1, 0)},
                          {K::Point_3(2, 0, 1), K::Point_3(2, 1, 1)}},
                         GC::Knot_vector<double>(1, {0, 0, 0.1, 1, 1}), GC::Knot_vector<double>(1, {0, 0, 1, 1}));
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
  CHECK_ERROR(s.rows_at(true, 2, false, 1), parameter_outside_domain);
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

  // u: 0 0 0 0 2 2 4 4 4 4; the control points 2 and 3 are next to the knot 2, on both sides of the plane C' of the line
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
                      return Exact::Point_3(int(random() % 2000001) - 1000000, int(random() % 2000001) - 1000000,
                                            int(random() % 2000001) - 1000000);
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

// ---------------------------------------------------------------- models

// As many bicubic patches of one smooth surface as a test may take: the number of edges of each kind is known.
BOOST_AUTO_TEST_CASE(model_of_a_large_grid) {
  constexpr int n = 15;
  std::vector<Patch<Exact>> patches;
  std::vector<S> surfaces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      surfaces.push_back(spline(wave, knots(i, i + 1), knots(j, j + 1)));
      patches.push_back(surfaces.back().bezier_patches()[0]);
    }
  for (const GC::Model_summary& s : {GC::model_continuity(patches).summary, GC::model_continuity(surfaces).summary})
    BOOST_CHECK_EQUAL(text(s), "420 G2, 0 G1, 0 G0, 60 boundary, 0 collapsed");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(model_of_splines, K, Kernels) {
  // one above the other, in any direction, degree and domain; the last one meets half an edge only
  const std::vector<S> exact = {spline(wave, knots(0, 4, {1, 2, 2}), knots(0, 1)),
                                with_knots(spline(wave, knots(0, 4, {3}), knots(1, 2)).reverse_u(), 4, 1),
                                lifted(spline(wave, knots(0, 4, {1, 3}), knots(2, 3)), 5, 1).swap_parameters(),
                                spline(wave, knots(0, 2), knots(3, 4))};
  std::vector<Surface<K>> s;
  for (const S& x : exact) s.push_back(in<K>(x));
  const auto model = GC::model_continuity(s);
  BOOST_CHECK_EQUAL(text(model.summary),
                    "1 G2, 0 G1, 1 G0 (1 creases), 12 boundary, 0 collapsed; knot lines: 1 G2, 0 G1, 0 G0");
  BOOST_REQUIRE_EQUAL(model.edges.size(), 14);
  std::vector<std::string> shared;
  for (const auto& e : model.edges)
    if (e.kind == GC::Model_edge_kind::shared) shared.push_back(text(e));
  BOOST_REQUIRE_EQUAL(shared.size(), 2);
  BOOST_CHECK_EQUAL(shared[0], "0 v1 - 1 v0: G2, reversed");
  BOOST_CHECK_EQUAL(shared[1].substr(0, 24), "1 v1 - 2 u0: G0 (crease)");
  BOOST_REQUIRE_EQUAL(model.knot_lines.size(), 1);
  BOOST_CHECK_EQUAL(text(model.knot_lines[0]), "0 u = 2: G2");
  BOOST_CHECK_EQUAL(model.failing(1).size(), 1);
  BOOST_CHECK(model.has_order(0) && !model.has_order(1));
}

BOOST_AUTO_TEST_CASE(closed_surface_with_a_pole) {
  // a band around a square: linear in u and closed, and a lid of triangles to one point, which is collapsed
  typedef Exact::Point_3 P;
  const Knots u(1, {0, 0, 1, 2, 3, 4, 4}), v(1, {0, 0, 1, 1});
  const P square[] = {P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0), P(0, 0, 0)};
  std::vector<std::vector<P>> band, lid;
  for (const P& p : square) {
    band.push_back({p, P(p.x(), p.y(), 1)});
    lid.push_back({P(p.x(), p.y(), 1), P(Q(1) / 2, Q(1) / 2, 1)});
  }
  const auto model = GC::model_continuity(std::vector<S>{S(band, u, v), S(lid, u, v)});
  // the seams: a corner of the band is a right angle, that of the lid is flat but its normal vanishes at the pole
  BOOST_CHECK_EQUAL(text(model.summary), "0 G2, 0 G1, 3 G0 (2 creases, 1 vanishing normals), 1 boundary, 1 collapsed; "
                                         "knot lines: 0 G2, 0 G1, 6 G0");
  for (const auto& l : model.failing_knot_lines(1)) {
    BOOST_CHECK_EQUAL(l.line.continuity.defect, l.patch == 0 ? Edge_defect::crease : Edge_defect::vanishing_normal);
    if (l.patch == 0) BOOST_CHECK(l.line.continuity.deviation->upper == Q(1)); // a right angle
  }
}
