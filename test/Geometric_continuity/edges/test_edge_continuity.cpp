// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Bezier patches, their continuity along edges, models of patches, and .g2 surfaces.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE edges
#include <boost/test/unit_test.hpp>

#include "support/archetype.h"
#include "support/enclosures.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/IO/g2_surfaces.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>
#include <CGAL/Geometric_continuity/edges/Edge_conditions.h>
#include <CGAL/Geometric_continuity/edges/common_edges.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Epeck, CGAL::Epick, CGAL::Simple_cartesian<double>> All_kernels;

template <class K> using Patch = GC::Bezier_patch<GC::Traits_3<K>>;
using enclosures::ulps;
using GC::Edge_defect;
using GC::Patch_edge;
using GC::Sign_pattern;
constexpr Patch_edge u0 = Patch_edge::u0, u1 = Patch_edge::u1, v0 = Patch_edge::v0, v1 = Patch_edge::v1;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

namespace {

template <class FT> constexpr bool is_exact = !std::is_floating_point_v<FT>;

// ---------------------------------------------------------------- space curves with polynomial coordinates

typedef GC::Bernstein_polynomial<Q> Polynomial;
typedef std::array<Polynomial, 3> Curve;
typedef std::array<Q, 3> Column;
typedef std::vector<std::vector<Column>> Net;

Curve operator+(const Curve& a, const Curve& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Curve operator*(const Polynomial& p, const Curve& c) { return {p * c[0], p * c[1], p * c[2]}; }
Curve derivative(const Curve& c) { return {c[0].derivative(), c[1].derivative(), c[2].derivative()}; }
Curve elevated_to(const Curve& c, int n) {
  Curve r = c;
  for (Polynomial& p : r) p = p.elevated(n - p.degree());
  return r;
}
int degree(const Curve& c) { return std::max({c[0].degree(), c[1].degree(), c[2].degree()}); }
Polynomial constant(int x) { return Polynomial{Q(x)}; }
Polynomial line(int x, int y) { return Polynomial{Q(x), Q(y)}; }

// The net of a patch of degree 2 (or 1, without w) across its edge v = 0, with the rows c, t, w. Its degree along the edge
// is the largest of theirs, or n.
Net net_from_rows(const Curve& c, const Curve& t, const Curve* w = nullptr, int n = 0) {
  for (const Curve* x : {&c, &t, w})
    if (x) n = std::max(n, degree(*x));
  const Curve c_n = elevated_to(c, n), t_n = elevated_to(t, n), w_n = elevated_to(w ? *w : c, n);
  Net net(n + 1, std::vector<Column>(w ? 3 : 2));
  for (int i = 0; i <= n; ++i)
    for (int x = 0; x < 3; ++x) {
      net[i][0][x] = c_n[x][i];
      net[i][1][x] = Q(c_n[x][i] + t_n[x][i] / Q(w ? 2 : 1));
      if (w) net[i][2][x] = Q(Q(2) * net[i][1][x] - net[i][0][x] + w_n[x][i] / Q(2));
    }
  return net;
}
Net net_from_rows(const Curve& c, const Curve& t, const Curve& w, int n = 0) { return net_from_rows(c, t, &w, n); }

Q denominator_of(const Q& x) {
  CGAL::Fraction_traits<Q>::Numerator_type n;
  CGAL::Fraction_traits<Q>::Denominator_type d;
  CGAL::Fraction_traits<Q>::Decompose()(x, n, d);
  return Q(d);
}

// Nets in the coordinates of a kernel. Rounded kernels take all nets times a common denominator: whole numbers, which must
// be represented exactly.
template <class K> std::vector<Patch<K>> patches(const std::vector<Net>& nets) {
  typedef typename K::FT FT;
  Q scale(1);
  if constexpr (!is_exact<FT>)
    for (const Net& net : nets)
      for (const auto& row : net)
        for (const Column& b : row)
          for (const Q& x : b) scale *= denominator_of(Q(x * scale));
  const auto number = [&](const Q& x) {
    const Q scaled = x * scale;
    if constexpr (is_exact<FT>)
      return FT(scaled);
    else {
      const double rounded = CGAL::to_double(scaled);
      BOOST_REQUIRE(Q(rounded) == scaled);
      return rounded;
    }
  };
  std::vector<Patch<K>> result;
  for (const Net& net : nets) {
    std::vector<std::vector<typename K::Point_3>> points;
    for (const auto& row : net) {
      points.emplace_back();
      for (const Column& b : row)
        points.back().push_back(typename K::Point_3(number(b[0]), number(b[1]), number(b[2])));
    }
    result.emplace_back(points);
  }
  return result;
}

class Random {
  std::mt19937 engine_;

public:
  explicit Random(unsigned seed = 2026) : engine_(seed) {}
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  Polynomial polynomial(int degree, int low = -4, int high = 4) {
    std::vector<Q> c;
    for (int i = 0; i <= degree; ++i) c.push_back(Q(integer(low, high)));
    return Polynomial(c);
  }
  // a curve that goes roughly in a coordinate direction, so that two of them in different directions are independent
  Curve curve(int degree, int direction, int step) {
    Curve c{polynomial(degree, -1, 1), polynomial(degree, -1, 1), polynomial(degree, -1, 1)};
    std::vector<Q> x;
    for (int i = 0; i <= degree; ++i) x.push_back(Q(direction == 0 ? step * i : step));
    c[direction] = Polynomial(x);
    return c;
  }
};

// Two surfaces with the edge C: S1 with T1, W1, and S2 with T2 = p C' + q T1 and W2 = p^2 C'' + 2 p q T1' + q^2 W1 + r C' +
// s T1, which is all that G2 leaves free.
struct Connection {
  Curve c, t1, w1, t2 = c, w2 = c;

  Connection(Random& random, int degree)
      : c(random.curve(degree, 0, 9)), t1(random.curve(degree - 1, 1, 9)), w1(random.curve(degree - 1, 2, 3)) {
    connect(random.polynomial(1), constant(-random.integer(1, 2)), random.polynomial(1), random.polynomial(1));
  }

  void connect(const Polynomial& p, const Polynomial& q, const Polynomial& r, const Polynomial& s) {
    const Curve d = derivative(c);
    t2 = p * d + q * t1;
    w2 = (p * p) * derivative(d) + (constant(2) * (p * q)) * derivative(t1) + (q * q) * w1 + r * d + s * t1;
  }
  Net first() const { return net_from_rows(c, t1, w1); }
  Net second() const { return net_from_rows(c, t2, w2); }
};

// The angle between the normals of two surfaces with the edge v = v_0 in one direction, by floating-point arithmetic.
template <class K> double sampled_angle(const Patch<K>& a, const Patch<K>& b, const typename K::FT& u) {
  const auto m = a.normal(u, a.domain_v().first), n = b.normal(u, b.domain_v().first);
  const typename K::Vector_3 cross = CGAL::cross_product(m, n);
  return std::atan2(std::sqrt(CGAL::to_double(cross.squared_length())), -CGAL::to_double(m * n));
}

// The value of a number of any kernel.
template <class FT> Q exact(const FT& x) {
  if constexpr (std::is_same_v<FT, Q>)
    return x;
  else
    return Q(x.exact());
}

// A flat surface y >= 0 and others along the edge (x, 0, 0), 0 <= x <= 1.
const Curve x_axis{line(0, 1), constant(0), constant(0)};
const Curve y_direction{constant(0), constant(1), constant(0)};
Curve direction(const Polynomial& x, const Polynomial& y, const Polynomial& z) { return {x, y, z}; }

template <class K> auto edge_along_x(const Curve& t1, const Curve& t2) {
  const std::vector<Patch<K>> s = patches<K>({net_from_rows(x_axis, t1), net_from_rows(x_axis, t2)});
  return GC::edge_continuity(s[0], v0, s[1], v0);
}

} // namespace

// ---------------------------------------------------------------- patches

namespace {

template <class K> Patch<K> sample_patch() { // degree 3 x 2 on [1, 3] x [-1, 1]
  typedef typename K::FT FT;
  std::vector<std::vector<typename K::Point_3>> net(4, std::vector<typename K::Point_3>(3));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      net[i][j] = typename K::Point_3(FT(4 * i + j * j), FT(8 * j - i * j), FT((i * i * 5 + j * 3) % 7 * 2));
  return Patch<K>(net, {FT(1), FT(3)}, {FT(-1), FT(1)});
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(patch_evaluation, K, All_kernels) {
  typedef typename K::FT FT;
  const Patch<K> s = sample_patch<K>();
  BOOST_CHECK_EQUAL(s.degree_u(), 3);
  BOOST_CHECK_EQUAL(s.degree_v(), 2);
  BOOST_CHECK_EQUAL(s.dimension(), 3);
  for (const FT& u : {FT(1), FT(2), FT(FT(5) / FT(4)), FT(4)})
    for (const FT& v : {FT(-1), FT(FT(1) / FT(2)), FT(1)}) {
      // S = sum B_i(s) B_j(t) b_ij, and the chain rule for s = (u - 1)/2, t = (v + 1)/2
      const auto basis = [](int n, const FT& t, int k) { // the k-th derivatives of the basis functions
        std::vector<FT> values;
        for (int i = 0; i <= n; ++i) {
          std::vector<FT> unit(n + 1, FT(0));
          unit[i] = FT(1);
          GC::Bernstein_polynomial<FT> p(unit);
          for (int d = 0; d < k; ++d) p = p.derivative();
          values.push_back(FT(p(t) / FT(1 << k)));
        }
        return values;
      };
      const GC::Surface_jet<GC::Traits_3<K>> jet = s.jet(u, v, 4);
      BOOST_CHECK_EQUAL(jet.order(), 4);
      BOOST_CHECK(jet.point() == s(u, v));
      for (int k = 0; k <= 4; ++k)
        for (int l = 0; k + l <= 4; ++l) {
          const std::vector<FT> bu = basis(3, FT((u - FT(1)) / FT(2)), k), bv = basis(2, FT((v + FT(1)) / FT(2)), l);
          for (int x = 0; x < 3; ++x) {
            FT sum(0);
            for (int i = 0; i <= 3; ++i)
              for (int j = 0; j <= 2; ++j) sum += bu[i] * bv[j] * s.coordinates(i, j)[x];
            BOOST_CHECK(jet(k, l)[x] == sum); // dyadic: exact in all kernels
            if (k + l > 0) BOOST_CHECK(jet.partial(k, l)[x] == sum);
            if (k + l > 0) BOOST_CHECK(s.partial(u, v, k, l)[x] == sum);
          }
        }
      const typename K::Vector_3 n = CGAL::cross_product(jet.partial(1, 0), jet.partial(0, 1));
      BOOST_CHECK(s.normal(u, v) == n);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(patch_operations, K, All_kernels) {
  typedef typename K::FT FT;
  const Patch<K> s = sample_patch<K>();
  const FT u = FT(FT(3) / FT(2)), v = FT(FT(1) / FT(4));
  BOOST_CHECK(s == s);
  BOOST_CHECK(s.swap_parameters()(v, u) == s(u, v));
  BOOST_CHECK(s.swap_parameters().swap_parameters() == s);
  BOOST_CHECK(s.reverse_u()(FT(FT(4) - u), v) == s(u, v));
  BOOST_CHECK(s.reverse_v()(u, FT(-v)) == s(u, v));
  BOOST_CHECK(s.reverse_u() != s);
  BOOST_CHECK(s.reverse_u().reverse_u() == s);
  if (is_exact<FT>) { // elevation to degree 5 divides by 5
    const Patch<K> e = s.elevate(2, 3);
    BOOST_CHECK_EQUAL(e.degree_u(), 5);
    BOOST_CHECK_EQUAL(e.degree_v(), 5);
    BOOST_CHECK(e(u, v) == s(u, v));
    BOOST_CHECK(e.partial(u, v, 1, 2) == s.partial(u, v, 1, 2));
  }
  BOOST_CHECK(s.elevate(0, 0) == s);
  const std::pair<Patch<K>, Patch<K>> in_u = s.split_u(FT(2)), in_v = s.split_v(FT(0));
  BOOST_CHECK(in_u.first(u, v) == s(u, v));
  BOOST_CHECK(in_u.second(FT(FT(5) / FT(2)), v) == s(FT(FT(5) / FT(2)), v));
  BOOST_CHECK(in_u.first.domain_u() == std::make_pair(FT(1), FT(2)) && in_u.first.domain_v() == s.domain_v());
  BOOST_CHECK(in_u.second.domain_u() == std::make_pair(FT(2), FT(3)));
  BOOST_CHECK(in_v.first(u, FT(-v)) == s(u, FT(-v)));
  BOOST_CHECK(in_v.second(u, v) == s(u, v));
  BOOST_CHECK(in_v.second.domain_v() == std::make_pair(FT(0), FT(1)) && in_v.second.domain_u() == s.domain_u());
  CHECK_ERROR(s.split_u(FT(1)), parameter_outside_domain);
  CHECK_ERROR(s.split_v(FT(1)), parameter_outside_domain);
  const CGAL::Aff_transformation_3<K> shift(CGAL::TRANSLATION, typename K::Vector_3(FT(1), FT(2), FT(3)));
  BOOST_CHECK(s.transform([&](const typename K::Point_3& p) { return shift(p); })(u, v) == shift(s(u, v)));
  BOOST_CHECK(s.with_domain({FT(0), FT(2)}, {FT(0), FT(4)})(FT(u - FT(1)), FT(FT(2) * (v + FT(1)))) == s(u, v));
  BOOST_CHECK(s.bounding_box().first == typename K::Point_3(FT(0), FT(0), FT(0)));
  BOOST_CHECK(s.bounding_box().second == typename K::Point_3(FT(16), FT(16), FT(12)));
  BOOST_CHECK(s.bbox() == CGAL::Bbox_3(0, 0, 0, 16, 16, 12));
  BOOST_CHECK_EQUAL(std::distance(s.begin(), s.end()), 12);
  BOOST_CHECK(*(s.begin() + 1) == s.control_point(0, 1));
  std::ostringstream os;
  os << s;
  const std::string text = os.str();
  BOOST_CHECK_EQUAL(text.substr(0, text.find('\n')), "Bezier patch of degree 3 x 2 on [1, 3] x [-1, 1]:");
  BOOST_CHECK_EQUAL(text.substr(text.rfind('\n')), "\n(12, 0, 6) (13, 5, 12) (16, 10, 4)");
  BOOST_CHECK_EQUAL(std::count(text.begin(), text.end(), '\n'), 4);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(patch_edges, K, All_kernels) {
  typedef typename K::FT FT;
  const Patch<K> s = sample_patch<K>();
  for (Patch_edge e : GC::patch_edges) {
    const GC::Bezier_curve<GC::Traits_3<K>> c = s.boundary_curve(e);
    const std::pair<FT, FT> along = s.domain(e);
    BOOST_CHECK(c.domain() == along);
    for (const FT& t : {along.first, FT((along.first + along.second) / FT(2)), along.second}) {
      const FT u = e == u0 ? FT(1) : e == u1 ? FT(3) : t, v = e == v0 ? FT(-1) : e == v1 ? FT(1) : t;
      BOOST_CHECK(c(t) == s(u, v));
      for (bool backwards : {false, true}) {
        const Patch<K> r = s.oriented(e, backwards);
        BOOST_CHECK(r.domain_u() == along);
        const FT start = r.domain_v().first, s_along = backwards ? FT(along.first + along.second - t) : t;
        BOOST_CHECK(r(s_along, start) == s(u, v));
        // the first derivative across the edge points into the patch
        const FT h = FT(start + FT(1) / FT(2));
        const FT in_u = e == u0   ? FT(FT(3) / FT(2))
                        : e == u1 ? FT(FT(5) / FT(2))
                                  : t,
                 in_v = e == v0   ? FT(FT(-1) / FT(2))
                        : e == v1 ? FT(FT(1) / FT(2))
                                  : t;
        BOOST_CHECK(r(s_along, h) == s(in_u, in_v));
      }
      // rows: derivatives of the turned patch on the unit square
      const Patch<K> unit = s.oriented(e).with_domain({FT(0), FT(1)}, {FT(0), FT(1)});
      const auto rows = s.rows(e, 4);
      BOOST_CHECK_EQUAL(rows.size(), 5);
      for (int k = 0; k <= 4; ++k)
        for (int x = 0; x < 3; ++x) {
          std::vector<FT> coefficients;
          for (const auto& p : rows[k]) coefficients.push_back(p[x]);
          BOOST_CHECK_EQUAL(coefficients.size(), s.degree_along(e) + 1);
          const FT parameter = FT((t - along.first) / (along.second - along.first));
          BOOST_CHECK(GC::Bernstein_polynomial<FT>(coefficients)(parameter) == unit.jet(parameter, FT(0), k)(0, k)[x]);
        }
    }
  }
  BOOST_CHECK_EQUAL(to_string(u0) + to_string(u1) + to_string(v0) + to_string(v1), "u0u1v0v1");
}

BOOST_AUTO_TEST_CASE(patch_unit_normal_and_errors) {
  typedef CGAL::Epick K;
  typedef K::Point_3 P;
  const Patch<K> tiny({{P(0, 0, 0), P(0, 1e-200, 0)}, {P(1e-200, 0, 0), P(1e-200, 1e-200, 0)}});
  BOOST_REQUIRE(Patch<K>({{P(0, 0, 0), P(0, 3, 4)}, {P(2, 0, 0), P(2, 3, 4)}}).unit_normal(0.5, 0.5));
  BOOST_CHECK(*Patch<K>({{P(0, 0, 0), P(0, 3, 4)}, {P(2, 0, 0), P(2, 3, 4)}}).unit_normal(0.5, 0.5) ==
              K::Vector_3(0, -0.8, 0.6));
  BOOST_CHECK(!tiny.transform([](const P& p) { return P(p.x(), p.x(), p.x()); }).unit_normal(0.5, 0.5));
  const Patch<K> small({{P(0, 0, 0), P(0, 1e-150, 0)}, {P(1e-150, 0, 0), P(1e-150, 1e-150, 0)}});
  BOOST_CHECK(*small.unit_normal(0.5, 0.5) == K::Vector_3(0, 0, 1)); // its square underflows
  CHECK_ERROR(Patch<K>(std::vector<std::vector<P>>()), wrong_number_of_points);
  CHECK_ERROR(Patch<K>(std::vector<std::vector<P>>(2)), wrong_number_of_points);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}, {P(0, 0, 0), P(1, 0, 0)}}), wrong_number_of_points);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0), P(1, 0, 0)}, {P(0, 0, 0)}}), wrong_number_of_points);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}, {1, 1}), empty_domain);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}, {0, 1}, {1, 0}), empty_domain);
  CHECK_ERROR(Patch<K>({{P(0, 0, std::numeric_limits<double>::infinity())}}), not_finite);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}, {0, std::numeric_limits<double>::infinity()}), not_finite);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}).jet(0, 0, -1), jet_order_too_low);
  CHECK_ERROR(GC::normal(tiny.jet(0, 0, 0)), jet_order_too_low);

  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  const auto point = [](std::vector<int> x) { return Traits::Point(static_cast<int>(x.size()), x.begin(), x.end()); };
  typedef GC::Bezier_patch<Traits> Patch_d;
  CHECK_ERROR(Patch_d({{point({0, 0, 0}), point({0, 1})}}), dimension_mismatch);
  const Patch_d space({{point({0, 0, 0}), point({0, 1, 0})}, {point({1, 0, 0}), point({1, 1, 0})}}),
      flat({{point({0, 0}), point({0, 1})}, {point({1, 0}), point({1, 1})}});
  BOOST_CHECK(flat(Q(1), Q(0)) == point({1, 0}));
  CHECK_ERROR(flat.normal(Q(0), Q(0)), dimension_mismatch);
  CHECK_ERROR(GC::edge_continuity(space, v0, flat, v0), dimension_mismatch);
  CHECK_ERROR(GC::model_continuity(std::vector<Patch_d>{flat}), dimension_mismatch);
  BOOST_CHECK_EQUAL(GC::edge_continuity(space, v0, space, v0).defect, Edge_defect::fold);
  BOOST_CHECK_EQUAL(GC::edge_continuity(space, u0, space, v0).defect, Edge_defect::gap);
}

// ---------------------------------------------------------------- order along an edge

BOOST_AUTO_TEST_CASE_TEMPLATE(connected_surfaces, K, All_kernels) {
  Random random;
  for (int round = 0; round < 12; ++round) {
    Connection s(random, round % 3 == 0 ? 2 : 3);
    const std::vector<Patch<K>> g2 = patches<K>({s.first(), s.second()});
    const auto both = GC::edge_continuity(g2[0], v0, g2[1], v0);
    BOOST_CHECK_EQUAL(both.g_order, 2);
    BOOST_CHECK_EQUAL(both.defect, Edge_defect::none);
    BOOST_CHECK(both.coplanar && !both.reversed && !both.collapsed && !both.normal_vanishes && !both.vanishing);
    BOOST_CHECK_EQUAL(both.side, Sign_pattern::negative);
    BOOST_REQUIRE(both.deviation);
    BOOST_CHECK(both.deviation->lower == 0 && both.deviation->upper == 0);
    BOOST_CHECK_EQUAL(both.deviation->largest_angle(), 0);

    // the second derivative out of the tangent plane: no longer G2
    Connection bent = s;
    bent.w2 = bent.w2 + direction(constant(0), constant(0), Polynomial{Q(0), Q(0), Q(1)});
    const std::vector<Patch<K>> g1 = patches<K>({bent.first(), bent.second()});
    const auto curvature = GC::edge_continuity(g1[0], v0, g1[1], v0);
    BOOST_CHECK_EQUAL(curvature.g_order, 1);
    BOOST_CHECK_EQUAL(curvature.defect, Edge_defect::curvature);
    BOOST_CHECK(curvature.deviation && curvature.deviation->upper == 0);
    const auto exchanged = GC::edge_continuity(g1[1], v0, g1[0], v0);
    BOOST_CHECK_EQUAL(exchanged.g_order, 1);

    // each term of the identity counts: its neighbours with other functions fail
    for (int part = 0; part < 3; ++part) {
      Connection other = s;
      const Curve d = derivative(s.c);
      const Curve term = part == 0 ? derivative(d) : part == 1 ? derivative(s.t1) : s.w1;
      other.w2 = other.w2 + term;
      const std::vector<Patch<K>> p = patches<K>({other.first(), other.second()});
      const auto e = GC::edge_continuity(p[0], v0, p[1], v0);
      BOOST_CHECK(e.g_order == 1 || (part == 0 && degree(s.c) < 3));
    }

    // one control point moved by 1/1000: no longer G1
    Net moved = s.second();
    moved[random.integer(0, static_cast<int>(moved.size()) - 1)][1][2] += Q(1) / Q(1000);
    const std::vector<Patch<K>> g0 = patches<K>({s.first(), moved});
    const auto crease = GC::edge_continuity(g0[0], v0, g0[1], v0);
    BOOST_CHECK_EQUAL(crease.g_order, 0);
    BOOST_CHECK_EQUAL(crease.defect, Edge_defect::crease);
    BOOST_CHECK(!crease.coplanar && !crease.normal_vanishes);
    BOOST_REQUIRE(crease.deviation);
    BOOST_CHECK(crease.deviation->upper > 0 && crease.deviation->largest_angle() < 0.1);

    // a control point of the edge moved: no common edge
    Net gap = s.second();
    gap[1][0][0] += Q(1) / Q(1000);
    const std::vector<Patch<K>> no = patches<K>({s.first(), gap});
    const auto none = GC::edge_continuity(no[0], v0, no[1], v0);
    BOOST_CHECK_EQUAL(none.g_order, -1);
    BOOST_CHECK_EQUAL(none.defect, Edge_defect::gap);
    BOOST_CHECK(!none.deviation && !none.vanishing);
    BOOST_CHECK(GC::common_edges(no[0], no[1]).empty());
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(determinant_and_side, K, All_kernels) {
  Random random;
  const Connection s(random, 3);
  Net moved = s.second();
  moved[1][1][2] += Q(1);
  const std::vector<Patch<K>> p = patches<K>({s.first(), moved});
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  const GC::Edge_conditions<Field> conditions(GC::edge_rows(p[0], v0), GC::edge_rows(p[1], v0));
  BOOST_CHECK(!conditions.coplanar() && !conditions.g1() && !conditions.g2() && !conditions.second_order());
  const GC::Bernstein_polynomial<Field> det = conditions.determinant(), side = conditions.side();
  for (int k = 0; k <= 8; ++k) {
    const Field t = Field(Field(k) / Field(8));
    Field c[3], t1[3], t2[3], n1[3], n2[3];
    for (int x = 0; x < 3; ++x) {
      const auto value = [&](const Patch<K>& patch, int row, bool derivative) {
        std::vector<Field> b;
        const auto rows = patch.template rows<Field>(v0, 1);
        for (const auto& point : rows[row]) b.push_back(point[x]);
        const GC::Bernstein_polynomial<Field> q(b);
        return derivative ? q.derivative()(t) : q(t);
      };
      c[x] = value(p[0], 0, true);
      t1[x] = value(p[0], 1, false);
      t2[x] = value(p[1], 1, false);
    }
    Field expected_det(0), expected_side(0);
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      n1[x] = c[y] * t1[z] - c[z] * t1[y];
      n2[x] = c[y] * t2[z] - c[z] * t2[y];
      expected_det += n1[x] * t2[x];
      expected_side += n1[x] * n2[x];
    }
    BOOST_CHECK(det(t) == expected_det);
    BOOST_CHECK(side(t) == expected_side);
  }
}

// The 8 ways to put a net on the unit square, and the edge that becomes of v0.
template <class K> std::vector<std::pair<Patch<K>, Patch_edge>> placements(const Patch<K>& s) {
  std::vector<std::pair<Patch<K>, Patch_edge>> result;
  for (bool swapped : {false, true})
    for (bool in_u : {false, true})
      for (bool in_v : {false, true}) {
        Patch<K> r = s;
        if (in_u) r = r.reverse_u();
        if (in_v) r = r.reverse_v();
        result.emplace_back(swapped ? r.swap_parameters() : r, swapped ? (in_v ? u1 : u0) : (in_v ? v1 : v0));
      }
  return result;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_orientations, K, All_kernels) {
  Random random;
  Connection s(random, 3);
  Connection bent = s;
  bent.w2 = bent.w2 + direction(constant(0), constant(0), constant(3));
  Net moved = s.second();
  moved[2][1][1] += Q(5);
  const std::vector<Patch<K>> p = patches<K>({s.first(), s.second(), bent.second(), moved});
  const Edge_defect defects[] = {Edge_defect::none, Edge_defect::curvature, Edge_defect::crease};
  int reversed = 0;
  for (const auto& [a, edge_a] : placements<K>(p[0]))
    for (int kind = 0; kind < 3; ++kind)
      for (const auto& [b, edge_b] : placements<K>(p[1 + kind])) {
        const auto e = GC::edge_continuity(a, edge_a, b, edge_b);
        BOOST_CHECK_EQUAL(e.defect, defects[kind]);
        BOOST_CHECK_EQUAL(e.g_order, 2 - kind);
        const bool backwards = a.boundary_curve(edge_a) != b.boundary_curve(edge_b);
        BOOST_CHECK_EQUAL(e.reversed, backwards);
        reversed += backwards;
        const std::vector<GC::Common_edge> common = GC::common_edges(a, b);
        BOOST_REQUIRE_EQUAL(common.size(), 1);
        BOOST_CHECK(common[0].edge_a == edge_a && common[0].edge_b == edge_b && common[0].reversed == backwards);
      }
  BOOST_CHECK_EQUAL(reversed, 3 * 32);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(unequal_degrees_and_domains, K, All_kernels) {
  typedef typename K::FT FT;
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  Random random;
  const Connection s(random, 2);
  Net first = net_from_rows(s.c, s.t1, s.w1, 2), second = net_from_rows(s.c, s.t2, s.w2, 6), moved = second;
  moved[3][1][2] += Q(1);
  const std::vector<Patch<K>> p = patches<K>({first, second, moved});
  BOOST_CHECK(p[0].degree_u() < p[1].degree_u());
  for (const Patch<K>& a : {p[0], p[0].oriented(v0, true)}) {
    BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, p[1], v0).g_order, 2);
    BOOST_CHECK_EQUAL(GC::edge_continuity(p[1], v0, a, v0).g_order, 2);
    BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, p[2], v0).g_order, 0);
    BOOST_CHECK_EQUAL(GC::edge_continuity(p[2], v0, a, v0).g_order, 0);
    BOOST_CHECK_EQUAL(GC::common_edges(a, p[1]).size(), 1);
  }
  // another domain changes the parameters of the answer and nothing else
  const Patch<K> a = p[0].with_domain({FT(10), FT(26)}, {FT(-3), FT(5)}),
                 b = p[2].with_domain({FT(-1), FT(0)}, {FT(7), FT(9)});
  const auto unit = GC::edge_continuity(p[0], v0, p[2], v0), e = GC::edge_continuity(a, v0, b, v0);
  BOOST_CHECK_EQUAL(GC::edge_continuity(a, v0, p[1], v0).g_order, 2);
  BOOST_REQUIRE(e.deviation && unit.deviation);
  BOOST_CHECK(e.deviation->upper == unit.deviation->upper);
  BOOST_CHECK(e.deviation->begin == Field(Field(10) + Field(16) * unit.deviation->begin));
  BOOST_CHECK(e.deviation->end == Field(Field(10) + Field(16) * unit.deviation->end));
  BOOST_CHECK(e.deviation->begin < e.deviation->end);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(folds_are_not_smooth, K, All_kernels) {
  Random random;
  // both sides of the edge: angles of tangent planes, folded to [0, 90] degrees, are all zero
  Connection s(random, 3);
  s.connect(random.polynomial(1), constant(1), random.polynomial(1), random.polynomial(1));
  const std::vector<Patch<K>> p = patches<K>({s.first(), s.second()});
  const auto fold = GC::edge_continuity(p[0], v0, p[1], v0);
  BOOST_CHECK_EQUAL(fold.g_order, 0);
  BOOST_CHECK_EQUAL(fold.defect, Edge_defect::fold);
  BOOST_CHECK(fold.coplanar && !fold.normal_vanishes);
  BOOST_CHECK_EQUAL(fold.side, Sign_pattern::positive);
  BOOST_REQUIRE(fold.deviation);
  BOOST_CHECK(fold.deviation->lower == 2 && fold.deviation->upper == 2);
  BOOST_CHECK_GT(fold.deviation->largest_angle(), 3.14159265358979);
  // opposite normals with equal curvatures: the identity of second order holds
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  const GC::Edge_conditions<Field> conditions(GC::edge_rows(p[0], v0), GC::edge_rows(p[1], v0));
  BOOST_CHECK(conditions.coplanar() && conditions.second_order() && !conditions.g1() && !conditions.g2());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(one_unit_in_the_last_place, K, All_kernels) {
  typedef typename K::FT FT;
  Random random;
  const Connection s(random, 3);
  const std::vector<Patch<K>> p = patches<K>({s.first(), s.second()});
  BOOST_REQUIRE_EQUAL(GC::edge_continuity(p[0], v0, p[1], v0).g_order, 2);
  for (int layer = 0; layer < 3; ++layer)
    for (int i = 0; i <= p[1].degree_u(); ++i) {
      std::vector<std::vector<typename K::Point_3>> net;
      for (int k = 0; k <= p[1].degree_u(); ++k) {
        net.emplace_back();
        for (int j = 0; j <= 2; ++j) net.back().push_back(p[1].control_point(k, j));
      }
      typename K::Point_3& b = net[i][layer];
      FT z = b.z();
      if constexpr (is_exact<FT>)
        z += FT(Q(1) / Q(1000000000) / Q(1000000000) / Q(1000000000));
      else
        z = std::nextafter(z, 1e300);
      b = typename K::Point_3(b.x(), b.y(), z);
      const auto e = GC::edge_continuity(p[0], v0, Patch<K>(net), v0);
      BOOST_CHECK_EQUAL(e.g_order, layer - 1);
      if (layer == 1) {
        BOOST_REQUIRE(e.deviation);
        BOOST_CHECK_GT(e.deviation->smallest_angle(), 0);
        BOOST_CHECK_LT(e.deviation->largest_angle(), 1e-12);
      }
    }
}

// ---------------------------------------------------------------- degenerate edges

BOOST_AUTO_TEST_CASE_TEMPLATE(collapsed_edges, K, All_kernels) {
  const Curve point{constant(2), constant(3), constant(5)};
  const std::vector<Patch<K>> p =
      patches<K>({net_from_rows(point, direction(line(-1, 1), constant(1), constant(0))),
                  net_from_rows(point, direction(line(1, -1), constant(-1), constant(0)), nullptr, 3)});
  const auto e = GC::edge_continuity(p[0], v0, p[1], v0);
  BOOST_CHECK_EQUAL(e.g_order, 0);
  BOOST_CHECK_EQUAL(e.defect, Edge_defect::collapsed);
  BOOST_CHECK(e.collapsed && !e.deviation && !e.vanishing);
  BOOST_CHECK(GC::common_edges(p[0], p[1]).empty());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(vanishing_normals, K, All_kernels) {
  typedef GC::Edge_field<GC::Traits_3<K>> Field;
  const auto cross = [](const Polynomial& y) { return direction(constant(0), constant(-1) * y, constant(0)); };
  const auto check = [](const auto& e, const Field& from, const Field& to) {
    BOOST_CHECK_EQUAL(e.g_order, 0);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::vanishing_normal);
    BOOST_CHECK_EQUAL(e.side, Sign_pattern::nonpositive);
    BOOST_CHECK(e.normal_vanishes && e.coplanar && !e.collapsed);
    BOOST_REQUIRE(e.vanishing);
    BOOST_CHECK(e.vanishing->first == from && e.vanishing->second == to);
    BOOST_CHECK(e.deviation && e.deviation->upper == 0);
  };
  const Field half = Field(Field(1) / Field(2));
  check(edge_along_x<K>(y_direction, cross(line(0, 1))), Field(0), Field(0));
  check(edge_along_x<K>(y_direction, cross(line(1, 0))), Field(1), Field(1));
  check(edge_along_x<K>(y_direction, cross(line(-1, 1) * line(-1, 1))), half, half);
  check(edge_along_x<K>(direction(constant(0), line(-1, 1) * line(-1, 1), constant(0)), cross(constant(1))), half,
        half);
  // on both sides: the side changes twice, the patches continue each other elsewhere
  check(edge_along_x<K>(direction(constant(0), line(-1, 1), constant(0)), cross(line(-1, 1))), half, half);

  // an irrational double zero: (x^2 - 1/2)^2
  const Polynomial square = Polynomial{Q(-1), Q(-1), Q(1)};
  const auto irrational = edge_along_x<K>(y_direction, cross(square * square));
  BOOST_CHECK_EQUAL(irrational.defect, Edge_defect::vanishing_normal);
  BOOST_REQUIRE(irrational.vanishing);
  const Q from = exact(irrational.vanishing->first), to = exact(irrational.vanishing->second);
  BOOST_CHECK(Q(from * from) < Q(1) / Q(2) && Q(1) / Q(2) < Q(to * to) && Q(to - from) <= Q(1) / Q(1000));
  // nearly
  BOOST_CHECK_EQUAL(edge_along_x<K>(y_direction, cross(square * square + Polynomial{Q(1) / Q(1024)})).g_order, 2);

  // the edge stops: C = (x^2, 0, 0)
  const Curve slow{Polynomial{Q(0), Q(0), Q(1)}, constant(0), constant(0)};
  const std::vector<Patch<K>> p =
      patches<K>({net_from_rows(slow, y_direction), net_from_rows(slow, cross(constant(1)))});
  check(GC::edge_continuity(p[0], v0, p[1], v0), Field(0), Field(0));

  // no normal at all on one side
  for (const Curve& t :
       {direction(constant(0), constant(0), constant(0)), direction(constant(1), constant(0), constant(0))}) {
    const auto e = edge_along_x<K>(y_direction, t);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::vanishing_normal);
    BOOST_CHECK_EQUAL(e.side, Sign_pattern::zero);
    BOOST_REQUIRE(e.vanishing);
    BOOST_CHECK(e.vanishing->first == 0 && e.vanishing->second == 1);
    BOOST_CHECK(!e.deviation);
  }

  // a crease whose normal vanishes at an end, where the angle has a limit; and inside, where it has none
  const auto end = edge_along_x<K>(y_direction, direction(constant(0), line(0, -1), line(0, 1)));
  BOOST_CHECK_EQUAL(end.defect, Edge_defect::crease);
  BOOST_CHECK(end.normal_vanishes && end.vanishing && end.vanishing->second == 0);
  BOOST_REQUIRE(end.deviation);
  BOOST_CHECK(Q(exact(end.deviation->lower)) == Q(1) / Q(2) &&
              end.deviation->upper == end.deviation->lower); // 45 degrees
  const auto inside =
      edge_along_x<K>(y_direction, direction(constant(0), constant(-1) * line(-1, 1) * line(-1, 1), line(-1, 1)));
  BOOST_CHECK_EQUAL(inside.defect, Edge_defect::crease);
  BOOST_CHECK(inside.normal_vanishes && inside.vanishing && inside.vanishing->second == half);
  BOOST_REQUIRE(inside.deviation);
  BOOST_CHECK(exact(inside.deviation->upper) == Q(1)); // a right angle, as a limit
  BOOST_CHECK_LE(ulps(inside.deviation->angle()), 4);
  // perpendicular normals do not vanish
  const auto right = edge_along_x<K>(y_direction, direction(constant(0), constant(0), constant(1)));
  BOOST_CHECK_EQUAL(right.defect, Edge_defect::crease);
  BOOST_CHECK(!right.normal_vanishes && !right.vanishing);
  BOOST_CHECK_EQUAL(right.side, Sign_pattern::zero);
  BOOST_CHECK(right.deviation && right.deviation->lower == 1 && right.deviation->upper == 1);
}

// ---------------------------------------------------------------- the angle between the normals

BOOST_AUTO_TEST_CASE_TEMPLATE(the_angle_is_enclosed, K, All_kernels) {
  typedef typename K::FT FT;
  Random random;
  double widest = 0, narrowest = 4;
  for (int round = 0; round < 30; ++round) {
    Connection s(random, 3);
    // T2 turned out of the plane, from slightly to far beyond the right angle
    const int q = round % 3 - 1; // on the other side, nowhere, on the same side
    s.connect(random.polynomial(1), constant(q), constant(0), constant(0));
    const Curve t2 = constant(4) * s.t2 + direction(constant(0), constant(0), random.polynomial(2, 1, 4 * round + 1));
    const std::vector<Patch<K>> p = patches<K>({s.first(), net_from_rows(s.c, t2)});
    const auto e = GC::edge_continuity(p[0], v0, p[1], v0);
    BOOST_CHECK_EQUAL(e.defect, Edge_defect::crease);
    BOOST_REQUIRE(e.deviation);
    const double lower = e.deviation->smallest_angle(), upper = e.deviation->largest_angle();
    const double begin = CGAL::to_double(e.deviation->begin), end = CGAL::to_double(e.deviation->end);
    double largest = 0, inside = 0;
    const int samples = 256;
    for (int k = 0; k <= samples; ++k) {
      const double t = double(k) / samples, angle = sampled_angle<K>(p[0], p[1], FT(t));
      largest = std::max(largest, angle);
      if (begin <= t && t <= end) inside = std::max(inside, angle);
    }
    BOOST_CHECK_LE(lower, upper);
    BOOST_CHECK_LE(upper, 3.1415926535897936);
    BOOST_CHECK_LE(ulps(e.deviation->angle()), 4);
    BOOST_CHECK_LE(largest, upper * (1 + 1e-12));
    BOOST_CHECK_LE(upper, largest * 1.002);
    if (begin <= 0 || end >= 1) BOOST_CHECK_GE(inside, largest * (1 - 1e-12)); // else no sample need be inside
    // the angle at the place that is found
    const double found = sampled_angle<K>(p[0], p[1], FT((begin + end) / 2));
    if (0 < begin && end < 1) BOOST_CHECK_CLOSE(found, upper, 1e-6);
    BOOST_CHECK_LE(end - begin, 1.0 / 32);
    widest = std::max(widest, largest);
    narrowest = std::min(narrowest, largest);
  }
  BOOST_CHECK_GT(widest, 2.5);
  BOOST_CHECK_LT(narrowest, 0.5);
}

BOOST_AUTO_TEST_CASE(angles_of_measures) {
  typedef GC::Normal_deviation<Q> Deviation;
  const double pi = std::acos(-1.0);
  for (int k = 0; k <= 200; ++k) {
    const double angle = k * pi / 200, cosine = std::cos(angle);
    const GC::Enclosure e = Deviation::angle(Q(1 - cosine * std::abs(cosine)));
    BOOST_CHECK_SMALL(e.lower - angle, 1e-7);
    BOOST_CHECK_SMALL(e.upper - angle, 1e-7);
    BOOST_CHECK_LE(e.lower, e.upper);
    BOOST_CHECK_LE(ulps(e), 4);
  }
  BOOST_CHECK((Deviation::angle(Q(0)) == GC::Enclosure{0, 0}));
  BOOST_CHECK(Deviation::angle(Q(2)).lower <= pi && pi < Deviation::angle(Q(2)).upper);
  BOOST_CHECK(Deviation::angle(Q(1)).lower <= pi / 2 && pi / 2 < Deviation::angle(Q(1)).upper);
  // tiny angles keep their accuracy
  const GC::Enclosure tiny = Deviation::angle(Q(Q(1) / Q(1e40)));
  BOOST_CHECK_CLOSE(tiny.lower, 1e-20, 1e-13);
  BOOST_CHECK_LE(ulps(tiny), 4);
}

// ---------------------------------------------------------------- models

namespace {

// A biquadratic patch over the square [x, x+1] x [y, y+1], with the control points (x + i/2, y + j/2, h(2x+i, 2y+j)).
template <class Height> Net height_net(int x, int y, Height h) {
  Net net(3, std::vector<Column>(3));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      net[i][j] = {Q(Q(2 * x + i) / Q(2)), Q(Q(2 * y + j) / Q(2)), Q(h(2 * x + i, 2 * y + j))};
  return net;
}

template <class Model, class... Arguments>
const typename decltype(Model::edges)::value_type* find_edge(const Model& model, std::size_t patch, Patch_edge edge) {
  for (const auto& e : model.edges)
    if ((e.patch_a == patch && e.edge_a == edge) || (e.patch_b == patch && e.edge_b == edge)) return &e;
  return nullptr;
}

template <class FT> std::string text(const GC::Model_edge<FT>& e) {
  std::ostringstream os;
  os << e;
  return os.str();
}

std::string text(const GC::Model_summary& s) {
  std::ostringstream os;
  os << s;
  return os.str();
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(model_of_a_grid, K, All_kernels) {
  // 3 x 3 patches of a plane, but for a bump in the middle: a crease around it, where one control point of each edge moves
  const auto flat = [](int, int) { return 0; };
  const auto bump = [](int i, int j) { return i == 3 && j == 3 ? 1 : 0; }; // G1 with the plane, and of order 2 nowhere
  const auto tilt = [](int i, int) { return i == 1 ? 1 : 0; };
  std::vector<Net> nets;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) nets.push_back(x == 1 && y == 1 ? height_net(x, y, bump) : height_net(x, y, flat));
  std::vector<Patch<K>> p = patches<K>(nets);
  const auto creased = GC::model_continuity(p);
  BOOST_CHECK_EQUAL(text(creased.summary), "8 G2, 0 G1, 4 G0 (4 creases), 12 boundary, 0 collapsed");
  BOOST_CHECK_EQUAL(creased.failing(1).size(), 4);
  BOOST_CHECK_EQUAL(creased.failing(3).size(), 12);
  // in any orientation, from a list, with other degrees and domains
  Random random;
  std::list<Patch<K>> turned;
  for (const Patch<K>& s : p) {
    const auto all = placements<K>(s);
    Patch<K> t = all[random.integer(0, 7)].first;
    if (random.integer(0, 1)) t = t.elevate(is_exact<typename K::FT> ? 1 : 2, 2); // of degree 4: dyadic weights
    turned.push_back(t.with_domain({typename K::FT(2), typename K::FT(7)}, {typename K::FT(-1), typename K::FT(0)}));
  }
  const auto again = GC::model_continuity(turned);
  BOOST_CHECK_EQUAL(text(again.summary), text(creased.summary));
  // each edge of each patch is in exactly one row, and the rows are sorted
  std::set<std::pair<std::size_t, Patch_edge>> seen;
  for (std::size_t i = 0; i < again.edges.size(); ++i) {
    const auto& e = again.edges[i];
    BOOST_CHECK(seen.emplace(e.patch_a, e.edge_a).second);
    BOOST_CHECK_EQUAL(e.patch_b.has_value(), e.kind == GC::Model_edge_kind::shared);
    if (e.patch_b) BOOST_CHECK(seen.emplace(*e.patch_b, *e.edge_b).second && e.patch_a < *e.patch_b);
    if (i > 0)
      BOOST_CHECK(std::make_pair(again.edges[i - 1].patch_a, again.edges[i - 1].edge_a) <
                  std::make_pair(e.patch_a, e.edge_a));
  }
  BOOST_CHECK_EQUAL(seen.size(), 36);
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 0, u0)), "0 u0: boundary");
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 1, u0)), "1 u0: boundary");
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 0, u1)), "0 u1 - 3 u0: G2");
  BOOST_CHECK_EQUAL(text(*find_edge(creased, 1, u1)).substr(0, 35), "1 u1 - 4 u0: G0 (crease), angle <= ");
  // a patch that meets another along a part of its edge only
  const std::vector<Patch<K>> halves = {p[0].split_v(typename K::FT(typename K::FT(1) / typename K::FT(2))).first,
                                        p[3]};
  BOOST_CHECK_EQUAL(text(GC::model_continuity(halves).summary), "0 G2, 0 G1, 0 G0, 8 boundary, 0 collapsed");
  const std::vector<Patch<K>> g1 =
      patches<K>({height_net(0, 0, flat), height_net(1, 0, [](int i, int) { return i == 4; })});
  BOOST_CHECK_EQUAL(text(GC::model_continuity(g1).summary), "0 G2, 1 G1, 0 G0, 6 boundary, 0 collapsed");
  const std::vector<Patch<K>> folded = patches<K>({height_net(0, 0, flat), height_net(0, 0, tilt)});
  BOOST_CHECK_EQUAL(GC::model_continuity(folded).summary.g0, 2);
  BOOST_CHECK_EQUAL(text(GC::model_continuity(std::vector<Patch<K>>()).summary),
                    "0 G2, 0 G1, 0 G0, 0 boundary, 0 collapsed");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(model_with_poles, K, All_kernels) {
  // a cap of four patches around a pole, with smooth meridians, over a ring of four patches
  std::vector<Net> nets;
  const int circle[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  const int radius[3] = {0, 2, 2}, height[3] = {4, 4, 2}, lower_radius[3] = {2, 2, 6}, lower_height[3] = {2, 0, 0};
  for (bool lower : {false, true})
    for (int k = 0; k < 4; ++k) {
      Net net(3, std::vector<Column>(3));
      for (int j = 0; j < 3; ++j) {
        const int r = lower ? lower_radius[j] : radius[j], z = lower ? lower_height[j] : height[j];
        const int *from = circle[k], *to = circle[k + 1];
        net[0][j] = {Q(r * from[0]), Q(r * from[1]), Q(z)};
        net[1][j] = {Q(r * (from[0] + to[0])), Q(r * (from[1] + to[1])), Q(z)};
        net[2][j] = {Q(r * to[0]), Q(r * to[1]), Q(z)};
      }
      nets.push_back(net);
    }
  const std::vector<Patch<K>> p = patches<K>(nets);
  const auto model = GC::model_continuity(p);
  BOOST_CHECK_EQUAL(text(model.summary), "4 G2, 4 G1, 4 G0 (4 vanishing normals), 4 boundary, 4 collapsed");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 0, u0)), "0 u0 - 3 u1: G0 (vanishing_normal)");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 0, v0)), "0 v0: collapsed");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 6, v0)), "2 v1 - 6 v0: G1 (curvature)");
  const auto meridian = GC::edge_continuity(p[0], u0, p[3], u1);
  BOOST_CHECK(meridian.vanishing && meridian.vanishing->first == 0 && meridian.vanishing->second == 0);

  // one patch that closes up along a meridian
  Net tube(5, std::vector<Column>(2));
  const int ring[5][2] = {{1, 0}, {1, 4}, {-4, 0}, {1, -4}, {1, 0}};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 2; ++j) tube[i][j] = {Q(ring[i][0]), Q(ring[i][1]), Q(j)};
  const auto closed = GC::model_continuity(patches<K>({tube}));
  BOOST_CHECK_EQUAL(text(*find_edge(closed, 0, u0)), "0 u0 - 0 u1: G2");
  BOOST_CHECK_EQUAL(text(closed.summary), "1 G2, 0 G1, 0 G0, 2 boundary, 0 collapsed");
  const std::vector<Patch<K>> twice = patches<K>({tube, tube});
  BOOST_CHECK_EQUAL(GC::common_edges(twice[0], twice[0]).size(), 1); // u0 and u1
  BOOST_CHECK_EQUAL(GC::common_edges(twice[0], twice[1]).size(), 6); // these with each other, v0 with v0, v1 with v1
}

BOOST_AUTO_TEST_CASE_TEMPLATE(non_manifold_model, K, All_kernels) {
  const auto flat = [](int, int) { return 0; };
  Net wall(3, std::vector<Column>(2)); // upright on the edge x = 1 of the first two
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) wall[i][j] = {Q(1), Q(Q(2 - i) / Q(2)), Q(j)};
  const std::vector<Patch<K>> p = patches<K>({height_net(0, 0, flat), height_net(1, 0, flat), wall});
  const auto model = GC::model_continuity(p);
  BOOST_CHECK_EQUAL(text(model.summary), "1 G2, 0 G1, 1 G0 (1 creases), 9 boundary, 0 collapsed, 2 non-manifold");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 0, u1)), "0 u1 - 1 u0: G2, non-manifold");
  BOOST_CHECK_EQUAL(text(*find_edge(model, 2, v0)).substr(0, 34), "1 u0 - 2 v0: G0 (crease), reversed");
  // the same patch twice
  BOOST_CHECK_EQUAL(text(GC::model_continuity(std::vector<Patch<K>>{p[0], p[0]}).summary),
                    "0 G2, 0 G1, 4 G0 (4 folds), 0 boundary, 0 collapsed");
}

BOOST_AUTO_TEST_CASE(model_on_an_archetype) {
  typedef archetype::Traits<CGAL::Dimension_tag<3>> Traits;
  typedef archetype::Number FT;
  const auto point = [](int x, int y, int z) {
    const FT c[] = {FT(x), FT(y), FT(z)};
    return Traits().construct_point_object()(3, c, c + 3);
  };
  typedef GC::Bezier_patch<Traits> Patch_a;
  const Patch_a a({{point(0, 0, 0), point(0, 2, 0)}, {point(2, 0, 0), point(2, 2, 0)}}),
      b({{point(0, 2, 0), point(0, 3, 0)}, {point(2, 2, 0), point(2, 3, 0)}}),
      c({{point(0, 2, 0), point(0, 3, 1)}, {point(2, 2, 0), point(2, 3, 2)}});
  const auto smooth = GC::edge_continuity(a, v1, b, v0), crease = GC::edge_continuity(a, v1, c, v0);
  BOOST_CHECK_EQUAL(smooth.g_order, 2);
  BOOST_CHECK_EQUAL(crease.g_order, 0);
  BOOST_REQUIRE(crease.deviation);
  BOOST_CHECK(crease.deviation->upper == FT(4) / FT(5)); // sin^2 of the angle with slope 2
  const auto model = GC::model_continuity(std::vector<Patch_a>{a, b, c});
  BOOST_CHECK_EQUAL(model.summary.non_manifold, 2);
  BOOST_CHECK_EQUAL(model.summary.boundary, 9);
  a.elevate(1, 2).split_u(FT(1) / FT(3)).first.swap_parameters().jet(FT(2), FT(1), 3);
  a.normal(FT(0), FT(1));
  a.bounding_box();
}

// ---------------------------------------------------------------- .g2 surfaces

namespace {

typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_3;

template <class Traits = Exact_3> std::vector<GC::Bezier_patch<Traits>> read(const std::string& text) {
  std::istringstream is(text);
  return GC::read_g2_surfaces<Traits>(is, "file.g2");
}

const std::string good = "200 1 0 0\n3 0\n3 3\n0 0 0 2 2 2\n2 2\n-1 -1 .5 .5\n"
                         "0 0 0\n1 0 0.1\n2 0 0\n0 1 1/3\n1 1 0\n2 1 1e-1\n";

// `good` with the first occurrence of `what` replaced must be refused with this message
void check_refused(const std::string& what, const std::string& by, const std::string& message) {
  std::string altered = good;
  const std::size_t position = altered.find(what);
  BOOST_REQUIRE(position != std::string::npos);
  altered.replace(position, what.size(), by);
  BOOST_CHECK_EXCEPTION(read(altered), GC::Error, [&](const GC::Error& e) {
    BOOST_CHECK_EQUAL(e.what(), "malformed_input: file.g2:" + message);
    return e.code() == GC::Error_code::malformed_input;
  });
}

} // namespace

BOOST_AUTO_TEST_CASE(g2_surfaces_are_read) {
  const std::vector<GC::Bezier_patch<Exact_3>> s = read(good + "\n" + good);
  BOOST_REQUIRE_EQUAL(s.size(), 2);
  BOOST_CHECK(s[0] == s[1]);
  BOOST_CHECK_EQUAL(s[0].degree_u(), 2);
  BOOST_CHECK_EQUAL(s[0].degree_v(), 1);
  BOOST_CHECK(s[0].domain_u() == std::make_pair(Q(0), Q(2)));
  BOOST_CHECK(s[0].domain_v() == std::make_pair(Q(-1), Q(Q(1) / Q(2))));
  typedef Exact_3::Point P;
  BOOST_CHECK(s[0].control_point(1, 0) == P(1, 0, Q(Q(1) / Q(10)))); // u runs fastest; exact decimals
  BOOST_CHECK(s[0].control_point(0, 1) == P(0, 1, Q(Q(1) / Q(3))));
  BOOST_CHECK(s[0].control_point(2, 1) == P(2, 1, Q(Q(1) / Q(10))));
  // auxiliary values and other white space
  BOOST_CHECK(read("200\t1 0 2 7 -8 \r\n" + good.substr(good.find('\n')))[0] == s[0]);
  // written and read again
  for (const GC::Bezier_patch<Exact_3>& patch : {s[0], s[0].swap_parameters().elevate(1, 2)}) {
    std::ostringstream os;
    GC::write_g2(os, patch);
    const std::vector<GC::Bezier_patch<Exact_3>> back = read(os.str());
    BOOST_REQUIRE_EQUAL(back.size(), 1);
    BOOST_CHECK(back[0] == patch);
  }
  std::ostringstream os;
  GC::write_g2(os, s[0]);
  BOOST_CHECK_EQUAL(os.str(), "200 1 0 0\n3 0\n3 3\n0 0 0 2 2 2\n2 2\n-1 -1 1/2 1/2\n"
                              "0 0 0\n1 0 1/10\n2 0 0\n0 1 1/3\n1 1 0\n2 1 1/10\n\n");
  const GC::Bezier_patch<GC::Traits_3<CGAL::Epick>> rounded = read<GC::Traits_3<CGAL::Epick>>(good)[0];
  BOOST_CHECK_EQUAL(rounded.control_point(1, 0).z(), 0.1);
  std::ostringstream of_rounded;
  GC::write_g2(of_rounded, rounded);
  BOOST_CHECK(read<GC::Traits_3<CGAL::Epick>>(of_rounded.str())[0] == rounded);
  // a reader gives one patch at a time
  std::istringstream is(good + good);
  GC::G2_surface_reader<Exact_3> reader(is, "file.g2");
  BOOST_CHECK(reader.next());
  BOOST_CHECK(reader.next());
  BOOST_CHECK(!reader.next());
}

BOOST_AUTO_TEST_CASE(malformed_g2_surfaces_are_refused) {
  check_refused(good, "", "1: no surface");
  check_refused("200", "100", "1: 100 (spline curve) where a surface (200) is expected");
  check_refused("200", "210", "1: 210 where a surface (200) is expected");
  check_refused("200", "2x0", "1: the class of the object is '2x0' where an integer from 0 to 2147483647 is expected");
  check_refused("200 1", "200 2", "1: the major version is '2' where 1 is expected");
  check_refused("200 1 0", "200 1 1", "1: the minor version is '1' where 0 is expected");
  check_refused("200 1 0 0", "200 1 0 -1",
                "1: the number of auxiliary values is '-1' where an integer from 0 to 2147483647 is expected");
  check_refused("200 1 0 0", "200 1 0 1 1.5",
                "1: an auxiliary value is '1.5' where an integer from -2147483648 to 2147483647 is expected");
  check_refused(good, "200 1 0 3 1 2", "1: file ends after 2 of 3 auxiliary values");
  check_refused("\n3 0\n", "\n2 0\n", "2: dimension 2 where 3 is expected");
  check_refused("\n3 0\n", "\n3 1\n", "2: rational surfaces are not supported");
  check_refused("\n3 3\n", "\n0 3\n",
                "3: the number of control points in u is '0' where an integer from 1 to 2147483647 is expected");
  check_refused("\n3 3\n", "\n3 129\n", "3: the order in u is '129' where an integer from 1 to 128 is expected");
  check_refused("\n3 3\n", "\n2 3\n",
                "3: 2 control points and order 3 in u: there must be as many control points as the order says");
  check_refused("\n2 2\n", "\n3 2\n",
                "5: 3 control points and order 2 in v: inner knots are not supported, only Bezier patches");
  check_refused("0 0 0 2 2 2", "0 0 1 2 2 2",
                "4: the knots in u are not clamped: knot 3 of 6 must be equal to the one before it");
  check_refused("0 0 0 2 2 2", "0 0 0 2 2 3",
                "4: the knots in u are not clamped: knot 6 of 6 must be equal to the one before it");
  check_refused("0 0 0 2 2 2", "0 0 0 2 1 2", "4: the knots in u decrease at '1'");
  check_refused("0 0 0 2 2 2", "0 0 0 -2 -2 -2", "4: the knots in u decrease at '-2'");
  check_refused("-1 -1 .5 .5", "1 1 1 1", "6: the first and the last knots in v are equal: empty domain");
  check_refused("1/3", "1/0", "10: zero denominator: '1/0'");
  check_refused("1/3", "nan", "10: not a number: 'nan'");
  check_refused("2 1 1e-1", "2 1", "12: file ends after 5 of 6 control points");
  check_refused("2 1 1e-1", "2 1 1e-1 5", "12: 5 where a surface (200) is expected");
  check_refused("\n2 1 1e-1\n", "", "11: file ends after 5 of 6 control points");
  check_refused(good, "200 1 0 0 3 0 3 3 0 0 0 2", "1: file ends after 4 of 6 knots in u");
  check_refused(good, "200 1 0 0 3 0 3", "1: file ends before the order in u");
  check_refused("\n2 1 1e-1\n", "\n2 1 1e-1\n200 1 0 0\n4 0\n", "14: dimension 4 where 3 is expected");
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  CHECK_ERROR(read<Traits>(good + "200 1 0 0\n4 0\n"), malformed_input);
  BOOST_CHECK_EQUAL(read<Traits>(good)[0].dimension(), 3);
  std::istringstream bad(good);
  bad.setstate(std::ios::failbit);
  CHECK_ERROR(GC::read_g2_surfaces<Exact_3>(bad, "file.g2"), cannot_read_file);
  std::ostringstream os;
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
  const Double_3::Point huge(1e308, 0, 0);
  const GC::Bezier_patch<Double_3> patch({{huge, huge}, {huge, huge}});
  const auto overflow = [](const Double_3::Point& p) { return Double_3::Point(p.x() * 10, 0, 0); };
  CHECK_ERROR(GC::write_g2(os, patch.transform(overflow)), not_finite);
  BOOST_CHECK(os.str().empty());
}
