// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The factors by which degrees enter, where their products are longer than any integer of the
// machine: curves of the user's own of which only the points next to the end exist.

#include "support/test.h"

#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

BOOST_AUTO_TEST_SUITE(huge_degrees)

// The four control points at the end of a curve of any degree, from the join inwards.
template <class Kernel> struct End_of_curve {
  typedef GC::Traits_2<Kernel> Traits;
  typedef typename Kernel::FT FT;
  typedef typename Traits::Point Point;

  int m;
  GC::Curve_end end;
  std::array<Point, 4> points;
  std::array<FT, 4> weights = {FT(1), FT(1), FT(1), FT(1)};

  int degree() const { return m; }
  std::size_t number(int i) const { return static_cast<std::size_t>(end == GC::Curve_end::end ? m - i : i); }
  const Point& control_point(int i) const { return points[number(i)]; }
  const FT& weight(int i) const { return weights[number(i)]; }
  std::pair<FT, FT> domain() const { return {FT(0), FT(1)}; }
};
template <class Kernel> struct Weighted_end : End_of_curve<Kernel> {};
typedef CGAL::Simple_cartesian<Q> Exact_kernel;

BOOST_AUTO_TEST_SUITE_END()

namespace CGAL {
namespace Geometric_continuity {
template <class FT> struct Curve_ends<huge_degrees::End_of_curve<FT>> : Bezier_ends<huge_degrees::End_of_curve<FT>> {};
template <class FT> struct Curve_ends<huge_degrees::Weighted_end<FT>> : Bezier_ends<huge_degrees::Weighted_end<FT>> {
  static constexpr bool have_weights = true;
  static bool has_polygon(const huge_degrees::Weighted_end<FT>&, Curve_end) { return false; }
  static bool has_weighted_polygon(const huge_degrees::Weighted_end<FT>&, Curve_end) { return true; }
};
} // namespace Geometric_continuity
} // namespace CGAL

BOOST_AUTO_TEST_SUITE(huge_degrees)

// The coefficients of 1, s, s^2 and s^3.
typedef std::array<Q, 4> Series;

Series product(const Series& x, const Series& y) {
  Series z;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j <= k; ++j) z[k] += x[j] * y[k - j];
  return z;
}

// C(m, i)
std::array<Q, 4> binomials(int m) {
  const Q n(m);
  return {Q(1), n, Q(n * Q(n - 1) / 2), Q(n * Q(n - 1) * Q(n - 2) / 6)};
}

// The end of degree m, with these weights w_i / w_0, of the curve x(s): in s = t / (1-t) it is
// sum_i C(m, i) w_i b_i s^i over sum_i C(m, i) w_i s^i.
template <class End>
End end_of(const std::array<Series, 2>& x, int m, GC::Curve_end end, const std::array<Q, 4>& weights) {
  const std::array<Q, 4> c = binomials(m);
  Series denominator;
  for (std::size_t i = 0; i < 4; ++i) denominator[i] = c[i] * weights[i];
  const Series p = product(x[0], denominator), q = product(x[1], denominator);
  End result;
  result.m = m;
  result.end = end;
  result.weights = weights;
  for (std::size_t i = 0; i < 4; ++i) result.points[i] = {Q(p[i] / denominator[i]), Q(q[i] / denominator[i])};
  return result;
}

// x(beta_1 s + beta_2 s^2 + beta_3 s^3)
std::array<Series, 2> reparametrised(const std::array<Series, 2>& x, const Q& b1, const Q& b2, const Q& b3) {
  const Series r{Q(0), b1, b2, b3}, r2 = product(r, r), r3 = product(r, r2);
  std::array<Series, 2> y;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      y[i][k] = (k == 0 ? x[i][0] : Q(0)) + x[i][1] * r[k] + x[i][2] * r2[k] + x[i][3] * r3[k];
  return y;
}

const int largest = (std::numeric_limits<int>::max)();
const std::pair<int, int> degrees[] = {
    {3, 4},         {1000, 1001},           {55109, 55110},        {55109, 60000},
    {55110, 55110}, {715827884, 715827884}, {715827884, 3},        {715827883, 715827884},
    {largest, 5},   {largest, largest},     {largest, largest - 1}};

// Joins G3 with a reparametrisation by big rationals, and the same with the last point moved, which
// are G2.
template <class End> void check_g3(bool weighted) {
  std::mt19937_64 generator(20);
  std::cout << "seed 20\n";
  const auto number = [&] {
    return Q(Q(static_cast<double>(static_cast<std::int32_t>(generator()))) /
             Q(static_cast<double>(1 + (generator() & 0xffff))));
  };
  for (const auto& [m, n] : degrees)
    for (int repetition = 0; repetition < 3; ++repetition) {
      std::array<Series, 2> x;
      for (Series& coordinate : x)
        for (Q& c : coordinate) c = number();
      std::array<Q, 4> w{Q(1), Q(1), Q(1), Q(1)}, v = w;
      if (weighted)
        for (std::size_t i = 1; i < 4; ++i) w[i] = abs(number()) + 1, v[i] = abs(number()) + 1;
      // inwards on the left is backwards
      const Q b1 = -(abs(number()) + 1);
      const std::array<Series, 2> y = reparametrised(x, b1, number(), number());
      const End left = end_of<End>(x, m, GC::Curve_end::end, w);
      End right = end_of<End>(y, n, GC::Curve_end::start, v);
      BOOST_TEST_CONTEXT("degrees " << m << " and " << n) {
        BOOST_CHECK(GC::is_g3_join(left, right));
        if (!weighted) BOOST_CHECK_EQUAL(GC::continuity(left, right, 3).g_order, 3);
        right.points[3] = {right.points[3].x(), Q(right.points[3].y() + Q(1) / 7)};
        BOOST_CHECK(!GC::is_g3_join(left, right));
        BOOST_CHECK(GC::is_g2_join(left, right));
        if (!weighted) BOOST_CHECK_EQUAL(GC::continuity(left, right, 3).g_order, 2);
      }
    }
}

BOOST_AUTO_TEST_CASE(polynomials) { check_g3<End_of_curve<Exact_kernel>>(false); }
BOOST_AUTO_TEST_CASE(with_weights) { check_g3<Weighted_end<Exact_kernel>>(true); }

// On doubles: b_2 = a_2 + (m-2) a_1 and b_3 = a_3 + 3 (m-1) a_2 for the differences of two ends of
// degree m make y' = x', y'' = x'' + (m-1)(m-2) x' and y''' = x''' + 3 (m-1)(m-2) x''.
BOOST_AUTO_TEST_CASE(on_doubles) {
  typedef End_of_curve<CGAL::Epick> End;
  for (const int m : {1001, 55110, 715827883, 715827884, largest}) {
    const double x[4][2] = {{0, 0}, {1, 0}, {3, 2}, {2, 9}}; // differences along the curve
    double y[4][2];
    for (int i = 0; i < 2; ++i) {
      y[0][i] = x[0][i];
      y[1][i] = x[1][i];
      y[2][i] = x[2][i] + (m - 2.) * x[1][i];
      y[3][i] = x[3][i] + 3 * (m - 1.) * x[2][i];
    }
    End left{m, GC::Curve_end::end, {}}, right{m, GC::Curve_end::start, {}};
    for (std::size_t j = 0; j < 4; ++j) {
      const double c[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
      double p[2] = {0, 0}, q[2] = {0, 0};
      for (std::size_t k = 0; k < 4; ++k)
        for (int i = 0; i < 2; ++i) {
          p[i] += c[j][k] * (k % 2 == 0 ? 1 : -1) * x[k][i];
          q[i] += c[j][k] * y[k][i];
        }
      left.points[j] = {p[0], p[1]};
      right.points[j] = {q[0], q[1]};
    }
    BOOST_TEST_CONTEXT("degree " << m) {
      BOOST_CHECK(GC::is_g3_join(left, right));
      BOOST_CHECK_EQUAL(GC::continuity(left, right, 3).g_order, 3);
      right.points[3] = {right.points[3].x(), right.points[3].y() + 1};
      BOOST_CHECK(!GC::is_g3_join(left, right));
      BOOST_CHECK_EQUAL(GC::continuity(left, right, 3).g_order, 2);
      // it turns back
      const auto join = GC::continuity(left, End{m, GC::Curve_end::start, left.points}, 3);
      BOOST_CHECK_EQUAL(join.g_order, 0);
      BOOST_CHECK(*join.curvature_equal);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
