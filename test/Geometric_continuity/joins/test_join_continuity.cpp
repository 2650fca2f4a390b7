// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The remarks of Hagen after 2.1: what continuity of derivatives says about that of the invariants,
// and conversely.

#include "support/jets.h"

#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

typedef std::tuple<Exact_3, Double_3, Epick_3> Spaces;
typedef std::tuple<Exact_2, Exact_3> Exact_dimensions;

// Two cubics over the knots 0, 1, 1 + ratio. The second continues the first by b1 = b0 + beta p,
// b2 = b0 + beta^2 (b_{-2} - b0) + c0 p, b3 = b0 + beta^3 (b_{-2} - b_{-3}) + c1 p + c2 r.
template <class Traits> struct Two_cubics {
  typedef typename Traits::FT FT;
  FT beta, c0, c1, c2;

  Composite<Traits> operator()(const FT& lambda) const {
    std::vector<Column<Traits>> b = {column<Traits>(3, {1, 2, 0}), column<Traits>(3, {0, -1, 2}),
                                     column<Traits>(3, {2, 1, 1}), column<Traits>(3, {3, 3, 2})};
    const Column<Traits> p = b[3] - b[2], r = b[1] - b[2], s = b[1] - b[0], origin = b[3];
    b.push_back(origin + beta * p);
    b.push_back(origin + FT(beta * beta) * (b[1] - origin) + c0 * p);
    b.push_back(origin + FT(beta * beta * beta) * s + c1 * p + c2 * r);
    std::vector<typename Traits::Point> points;
    for (const Column<Traits>& x : b) points.push_back(GC::to_point<Traits>(x));
    return Composite<Traits>(points.begin(), points.end(), {FT(0), FT(1), FT(FT(1) + lambda)});
  }
};

// The C^3 member for a ratio of the intervals.
template <class Traits, class FT = typename Traits::FT> Two_cubics<Traits> c3_member(const typename Traits::FT& beta) {
  const FT b2 = beta * beta, b3 = b2 * beta;
  return {beta, FT(FT(2) * b2 + FT(2) * beta), FT(b3 + FT(3) * b2 + FT(3) * beta), FT(FT(2) * b3 + FT(3) * b2)};
}

template <class Traits> GC::Join_continuity<GC::Predicate_FT<Traits>> join_of(const Composite<Traits>& c) {
  return GC::chain_continuity(c).joins.at(0).continuity;
}

template <class FT> std::vector<FT> dyadic_ratios() { return {ratio<FT>(1, 2), FT(1), FT(2), FT(4)}; }

TEST_FOR_EACH(parametric_continuity_implies_that_of_the_invariants, Traits, Spaces) {
  for (const FT& beta : dyadic_ratios<FT>()) {
    Two_cubics<Traits> cubics = c3_member<Traits>(beta);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 3);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).f_order, 3);
    BOOST_CHECK(*join_of<Traits>(cubics(beta)).torsion_equal);
    // C3 => torsion continuity: the converse is false, and so is torsion continuity => G3
    cubics.c1 += FT(1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).g_order, 3);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).f_order, 3);
    cubics.c2 += FT(1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).g_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).f_order, 3);
    // C2 => curvature continuity: the converse is false
    cubics.c0 += FT(1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).g_order, 2);
    BOOST_CHECK_GE(join_of<Traits>(cubics(beta)).f_order, 2);
    BOOST_CHECK(*join_of<Traits>(cubics(beta)).curvature_vector_equal);
    // over other knots not even C1
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(FT(FT(2) * beta))).c_order, 0);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(FT(FT(2) * beta))).g_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(FT(FT(2) * beta))).betas()[0], ratio<FT>(1, 2));
  }
}

TEST_FOR_EACH(natural_spline_condition_of_cubics, Traits, Spaces) {
  // A C1 join of cubics is C2 if and only if the legs before and after it, prolonged in the ratio
  // of the intervals, meet in one point: the natural splines (Boehm). They are one member of the
  // line of curvature continuous alternatives.
  for (const FT& beta : dyadic_ratios<FT>())
    for (int i = -3; i <= 3; ++i) {
      Two_cubics<Traits> cubics = c3_member<Traits>(beta);
      cubics.c0 += FT(i);
      const Composite<Traits> c = cubics(beta);
      const auto b = [&](int j) { return c.coordinates(3 + j); };
      const Column<Traits> before = b(-1) + beta * (b(-1) - b(-2)), after = b(1) + FT(FT(1) / beta) * (b(1) - b(2));
      const auto join = join_of<Traits>(c);
      BOOST_CHECK_EQUAL(join.c_order >= 2, i == 0);
      BOOST_CHECK_EQUAL(before == after, i == 0);
      BOOST_CHECK_GE(join.f_order, 2);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(arc_length_and_torsion_continuity, Traits, Spaces) {
  // With respect to arc length x' = e1, x'' = k e2, x''' = -k^2 e1 + k' e2 + k t e3. Continuous
  // curvature then implies C2. Continuous torsion does not imply C3, as Hagen's remark 4 has it,
  // because k' may jump.
  const auto at = [](int k, int dk, int t) { return jet<Traits>(3, {{0}, {1}, {0, k}, {-k * k, dk, k * t}}); };
  for (int k : {1, 2})
    for (int t : {-3, 0, 2})
      for (int dk : {-1, 0, 4}) {
        const auto join = GC::continuity(at(k, 0, t), at(k, dk, t));
        BOOST_CHECK_EQUAL(join.f_order, 3);
        BOOST_CHECK(*join.torsion_equal);
        BOOST_CHECK_EQUAL(join.c_order, dk == 0 ? 3 : 2);
        BOOST_CHECK_EQUAL(join.g_order, dk == 0 ? 3 : 2);
        const auto other = GC::continuity(at(k, dk, t), at(k, dk, t + 1));
        BOOST_CHECK_EQUAL(other.f_order, 2);
        BOOST_CHECK_EQUAL(other.c_order, 2);
      }
  BOOST_CHECK_EQUAL(GC::continuity(at(1, 0, 0), at(2, 0, 0)).c_order, 1);
}

TEST_FOR_EACH(curvature_vector_of_barsky_and_beatty, Traits, Spaces) {
  typedef GC::Predicate_FT<Traits> Field;
  // second-degree geometric continuity is the continuity of K = kappa e_2, and of the tangent
  for (const FT& beta : dyadic_ratios<FT>()) {
    Two_cubics<Traits> cubics = c3_member<Traits>(beta);
    cubics.c0 += FT(3);
    const Composite<Traits> c = cubics(FT(1));
    const auto x = c.segment(0).template end_jet_over<Field>(2), y = c.segment(1).template start_jet_over<Field>(2);
    const auto kx = *GC::curvature_vector(x), ky = *GC::curvature_vector(y);
    if constexpr (std::is_same_v<Field, Q>)
      BOOST_CHECK(kx == ky);
    else
      // division by |x'|^2, few roundings below 1
      for (int i = 0; i < 3; ++i) BOOST_CHECK_SMALL(kx[i] - ky[i], 1e-15);
    BOOST_CHECK_EQUAL(dot(kx, x[1]), 0);
    BOOST_CHECK_EQUAL(join_of<Traits>(c).g_order, 2);
  }
  // (t, t^2, 0) | (t, 0, t^2): the tangent and the number kappa are continuous, the vector is not
  std::vector<typename Traits::Point> points;
  for (const Column<Traits>& p : {column<Traits>(3, {-2, 4, 0}), column<Traits>(3, {-1, 0, 0}), column<Traits>(3, {0}),
                                  column<Traits>(3, {1, 0, 0}), column<Traits>(3, {2, 0, 4})})
    points.push_back(GC::to_point<Traits>(p));
  const auto join =
      GC::chain_continuity(Composite<Traits>(points.begin(), points.end(), {FT(-2), FT(0), FT(2)})).joins[0];
  BOOST_CHECK(*join.continuity.tangent_equal);
  BOOST_CHECK(join.left_side.curvature == join.right_side.curvature);
  BOOST_CHECK_EQUAL(join.left_side.curvature->square, Field(4));
  BOOST_CHECK(join.left_side.torsion == join.right_side.torsion);
  BOOST_CHECK(!*join.continuity.curvature_vector_equal);
  BOOST_CHECK_EQUAL(join.continuity.g_order, 1);
  BOOST_CHECK_EQUAL(join.continuity.f_order, 1);
}

// Equal jets need no forms, and have the answers of a right jet with another parameter, for which
// they are computed.
BOOST_AUTO_TEST_CASE_TEMPLATE(equal_jets, Traits, Exact_dimensions) {
  std::mt19937 random = seeded(20261122);
  constexpr int N = GC::dimension_v<Traits>;
  for (int i = 0; i < 300; ++i) {
    const int order = i % 7, max_order = static_cast<int>(random() % 8), least = (std::min)(order, max_order);
    GC::Coordinate_jet<Q, N> x(N, order), y(N, order);
    for (int j = 0; j <= order; ++j)
      for (int d = 0; d < N; ++d) {
        x[j][d] = Q(static_cast<int>(random() % 3) - 1);
        y[j][d] = Q(1 << j) * x[j][d];
      }
    const GC::Curve_jet<Traits> left(x), right(y);
    const auto equal = GC::continuity(left, left, max_order), other = GC::continuity(left, right, max_order);
    BOOST_CHECK_EQUAL(equal.c_order, least);
    BOOST_CHECK_EQUAL(equal.g_order, other.g_order);
    BOOST_CHECK_EQUAL(equal.f_order, other.f_order);
    BOOST_CHECK_EQUAL(equal.regular, other.regular);
    BOOST_CHECK(equal.tangent_equal == other.tangent_equal);
    BOOST_CHECK(equal.curvature_equal == other.curvature_equal);
    BOOST_CHECK(equal.curvature_vector_equal == other.curvature_vector_equal);
    BOOST_CHECK(equal.torsion_equal == other.torsion_equal);
    std::vector<Q> betas(equal.regular ? least : 0, Q(0));
    if (!betas.empty()) betas[0] = Q(1);
    BOOST_CHECK(equal.betas() == betas);
  }
}
