// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins of rational curves: what is decided on control points and weights agrees with what is
// decided on jets in an exact field, for parts of one curve in other rational parameters, and with
// one control point or weight altered.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

BOOST_AUTO_TEST_SUITE(rational_joins)

typedef std::tuple<Exact_2, Exact_3, Double_2, Epick_3, GC::Traits_3<CGAL::Simple_cartesian<float>>> All;

constexpr unsigned seed = 2026;
std::mt19937 engine(seed);

int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }

// Multiples of 1/64, so that halving a polynomial curve of doubles is exact.
template <class Traits> typename Traits::Point point() {
  GC::Coordinates<Traits> x(GC::dimension_v<Traits>);
  for (int i = 0; i < x.dimension(); ++i) x[i] = typename Traits::FT((below(2001) - 1000) / 64.);
  return GC::to_point<Traits>(x);
}

// Counts how often an answer is yes, besides the comparison.
struct Counts {
  int g1 = 0, g2 = 0, g3 = 0, f3 = 0, curvature = 0, torsion = 0;
};

// The predicates against the decision on the exact jets, which the curves are converted to here.
template <class Traits, class Left, class Right> void compare(const Left& left, const Right& right, Counts& n) {
  constexpr int N = GC::dimension_v<Traits>;
  typedef Q Field;
  const GC::Coordinate_jet<Field, N> x = left.template end_jet_over<Field>(3),
                                     y = right.template start_jet_over<Field>(3);
  typedef std::conditional_t<N == 2, Exact_2, Exact_3> Exact;
  const auto join = GC::continuity(GC::Curve_jet<Exact>(x), GC::Curve_jet<Exact>(y), 3);
  const bool g1 = GC::is_g1_join(left, right), g2 = GC::is_g2_join(left, right), g3 = GC::is_g3_join(left, right),
             f3 = GC::is_f3_join(left, right);
  BOOST_CHECK_EQUAL(g1, join.g_order >= 1);
  BOOST_CHECK_EQUAL(g2, join.g_order >= 2);
  BOOST_CHECK_EQUAL(g3, join.g_order >= 3);
  BOOST_CHECK_EQUAL(f3, join.f_order >= 3);
  BOOST_CHECK(GC::has_equal_curvature_vector(left, right) == join.curvature_vector_equal);
  BOOST_CHECK(GC::has_equal_torsion(left, right) == join.torsion_equal);
  BOOST_CHECK_EQUAL(GC::is_c_join<0>(left, right), join.c_order >= 0);
  BOOST_CHECK_EQUAL(GC::is_c_join<2>(left, right), join.c_order >= 2);
  n.g1 += g1;
  n.g2 += g2;
  n.g3 += g3;
  n.f3 += f3;
  n.curvature += join.curvature_vector_equal.value_or(false);
  n.torsion += join.torsion_equal.value_or(false);
}

TEST_FOR_EACH(points_and_weights_decide_as_jets_do, Traits, All) {
  typedef GC::Rational_bezier_curve<Traits> Curve;
  std::cout << "seed " << seed << '\n';
  Counts n;
  for (int i = 0; i < 300; ++i) {
    const int m = 1 + below(5), altered = below(6);
    std::vector<typename Traits::Point> p;
    for (int j = 0; j <= m; ++j) p.push_back(point<Traits>());
    std::vector<FT> w(m + 1, FT(1));
    // doubles have to be those of a polynomial curve at first
    if (std::is_same_v<FT, Q> && i % 2 == 0)
      for (FT& x : w) x = FT((1 + below(64)) / 16.);
    const auto parts = Curve(p.begin(), p.end(), w.begin(), w.end()).split(FT(0.5));
    const Curve other = parts.second.reparametrised(FT(std::ldexp(1., below(7) - 3)));
    std::vector<typename Traits::Point> q(other.begin(), other.end());
    std::vector<FT> v(other.weights().begin(), other.weights().end());
    if (altered >= 1 && altered <= (std::min)(m, 3)) q[altered] = point<Traits>();
    if (altered >= 4) v[(std::min)(m, altered - 2)] *= FT(1.25);
    const Curve right(q.begin(), q.end(), v.begin(), v.end(), FT(0.5), FT(1 + below(2)));
    compare<Traits>(parts.first.reparametrised(FT(2)), right, n);
    compare<Traits>(GC::Rational_bspline_curve<Traits>(parts.first), GC::Rational_bspline_curve<Traits>(right), n);
    if (parts.first.is_polynomial()) compare<Traits>(*parts.first.polynomial(), right, n);
  }
  // both answers are common
  BOOST_CHECK_GT(n.g1, 300);
  BOOST_CHECK_GT(n.g2, 200);
  BOOST_CHECK_GT(n.g2, n.g3);
  BOOST_CHECK_GT(n.g3, 100);
  BOOST_CHECK_GE(n.curvature, n.g2);
  if (GC::dimension_v<Traits> == 3) BOOST_CHECK(n.f3 > 100 && n.torsion >= n.f3 / 2);
}

// The test takes lines, for which only the ratio of two weights counts, on domains of such lengths,
// and a degree for which no factor is exact.
BOOST_AUTO_TEST_CASE(weights_and_domains_beyond_all_filters) {
  typedef GC::Traits_3<CGAL::Epick> Traits;
  typedef GC::Rational_bezier_curve<Traits> Curve;
  Counts n;
  const std::vector<Traits::Point> p{{-2, 4, 1}, {0, 0, 0}}, q{{0, 0, 0}, {1, -2, -0.5}};
  const std::vector<double> ones{1, 1}, four{1, 1, 1, 1};
  for (int e : {-600, -200, -30, 30, 200, 600})
    for (double length : {1., std::ldexp(1., -600), std::ldexp(1., 600)}) {
      const std::vector<double> w{std::ldexp(1., -e / 2), std::ldexp(1., e / 2)};
      const Curve left(p.begin(), p.end(), w.begin(), w.end(), 0, length),
          right(q.begin(), q.end(), w.begin(), w.end(), 0, length);
      compare<Traits>(left, Curve(q, ones), n);
      compare<Traits>(Curve(p, ones), right, n);
      compare<Traits>(left, right, n);
    }
  BOOST_CHECK_EQUAL(n.g1, 54);
  const std::vector<Traits::Point> x{{-3, 5, 2}, {-2, 1, 1}, {-1, 0, 0}, {0, 0, 0}},
      y{{0, 0, 0}, {1, 0, 0}, {2, 1, 1}, {3, 5, -2}};
  for (int e : {-30, 30})
    for (int j : {2, 3}) {
      std::vector<double> w(4, 1.);
      w[j] = std::ldexp(1., e);
      const Curve right(y.begin(), y.end(), w.begin(), w.end()), left(x.begin(), x.end(), w.rbegin(), w.rend());
      compare<Traits>(left, Curve(y, four), n);
      compare<Traits>(left, right, n);
    }
  std::vector<Traits::Point> high(y);
  for (int j = 4; j <= 1001; ++j) high.emplace_back(j, j % 5, 0);
  std::vector<double> w(high.size(), 1.);
  w[1] = 2;
  const Curve right(high.begin(), high.end(), w.begin(), w.end());
  compare<Traits>(Curve(x, four), right, n);
  compare<Traits>(right, right, n);
}

// A polygon and its mirror image: the curvatures agree where the weights do. Those of the left end
// have the last 52 bits of those of the right end, but one more before them.
BOOST_AUTO_TEST_CASE(weights_below_the_normal_numbers) {
  typedef GC::Traits_3<CGAL::Epick> Traits;
  typedef GC::Rational_bezier_curve<Traits> Curve;
  const std::vector<Traits::Point> left{{-3, 2, 1}, {-2, 1, 0}, {-1, 0, 0}, {0, 0, 0}},
      right{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 2, -1}};
  std::vector<double> w, v;
  for (double x : {0.75, 0.5, 0.75, 0.75}) {
    v.push_back(std::ldexp(x, -1022));
    w.push_back(1 + x);
  }
  const Curve y(right.begin(), right.end(), v.begin(), v.end());
  Counts n;
  compare<Traits>(Curve(left.begin(), left.end(), w.rbegin(), w.rend()), y, n);
  BOOST_CHECK_EQUAL(n.g1, 1);
  BOOST_CHECK_EQUAL(n.g2, 0);
  compare<Traits>(Curve(left.begin(), left.end(), v.rbegin(), v.rend()), y, n);
  BOOST_CHECK_EQUAL(n.g2, 1);
}

// A derivative with the factor 1/3, which no floating-point number is.
TEST_FOR_EACH(c1_join_with_a_rounded_factor, Traits, All) {
  typedef GC::Rational_bezier_curve<Traits> Curve;
  const auto on_axis = [](int x) {
    GC::Coordinates<Traits> c(GC::dimension_v<Traits>);
    c[0] = FT(x);
    return GC::to_point<Traits>(c);
  };
  const std::vector<typename Traits::Point> p{on_axis(-3), on_axis(0)}, q{on_axis(0), on_axis(1)};
  const std::vector<FT> w{FT(1), FT(3)}, v{FT(1), FT(1)};
  const Curve left(p.begin(), p.end(), w.begin(), w.end()), right(q.begin(), q.end(), v.begin(), v.end());
  BOOST_CHECK(GC::is_c_join<1>(left, right) && !GC::is_c_join<2>(left, right) && GC::is_g3_join(left, right));
}

// Other ends than those of four positive weights are read by their jets.
BOOST_AUTO_TEST_CASE(other_ends) {
  Counts n;
  std::vector<Exact_3::Point> p;
  for (int j = 0; j <= 4; ++j) p.push_back(point<Exact_3>());
  for (const std::vector<Q>& w : {std::vector<Q>{1, 1, 1, Q(-1) / 8, 1}, {1, 1, 1, 0, 1}, {2, 3, 4, 5, 6}}) {
    const auto parts = GC::Rational_bezier_curve<Exact_3>(p.begin(), p.end(), w.begin(), w.end()).split(Q(7) / 8);
    compare<Exact_3>(parts.first, parts.second.reparametrised(Q(3)), n);
    compare<Exact_3>(parts.second, parts.first, n);
    // an unclamped end
    const std::vector<Q> knots = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    const GC::Rational_bspline_curve<Exact_3> spline(p.begin(), p.end(), w.begin(), w.end(),
                                                     GC::Knot_vector<Q>(3, knots));
    compare<Exact_3>(spline, spline.reverse(), n);
    BOOST_CHECK(GC::knot_continuity(spline, Q(4)).c_order == 2);
    const GC::Rational_bezier_curve<Exact_3> positive(p.begin(), p.end(), w.begin(), w.end());
    compare<Exact_3>(spline, positive, n);
    compare<Exact_3>(positive, spline, n);
    // the second one may be negative where there is no zero
    for (const Q& weight : {Q(1), Q(Q(-1) / Q(16))}) {
      const std::vector<Q> v{1, weight, 1, 1, 1};
      const GC::Rational_bezier_curve<Exact_3> dent(p.begin(), p.end(), v.begin(), v.end());
      compare<Exact_3>(dent.reverse(), dent, n);
      compare<Exact_3>(dent.reverse(), positive, n);
      compare<Exact_3>(positive.reverse(), dent, n);
      // unclamped, with the weights of a polynomial curve
      compare<Exact_3>(GC::Rational_bspline_curve<Exact_3>(
                           GC::Bspline_curve<Exact_3>(p.begin(), p.end(), GC::Knot_vector<Q>(3, knots))),
                       dent, n);
    }
  }
  BOOST_CHECK_GE(n.g3, 3);
}

BOOST_AUTO_TEST_SUITE_END()
