// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The analysis of chains and of segmented curves.

#include "support/composite_curves.h"

#include <CGAL/Geometric_continuity/curves/bezier_properties.h>

// ------------------------------------------------------------------------------------------ chains

// Curves of which each starts where the one before it ends but for some gaps, with joins of all
// kinds.
template <class Traits, class FT = typename Traits::FT>
std::vector<Bezier<Traits>> random_chain(Random& random, int n) {
  std::vector<Bezier<Traits>> chain(1, random.curve<Traits>(3, 1).segment(0));
  while (static_cast<int>(chain.size()) < n) {
    const Bezier<Traits>& last = chain.back();
    std::vector<Column<Traits>> b;
    for (int i = 0; i < 4; ++i) b.push_back(random.column<Traits>());
    const int order = random.integer(-1, 3);
    const FT beta(random.integer(1, 2)), c0(random.integer(0, 9));
    const Column<Traits> p = last.coordinates(3) - last.coordinates(2);
    if (order >= 0) b[0] = last.coordinates(3);
    if (order >= 1) b[1] = b[0] + beta * p;
    if (order >= 2) b[2] = b[0] + FT(beta * beta) * (last.coordinates(1) - b[0]) + c0 * p;
    std::vector<typename Traits::Point> points;
    for (const Column<Traits>& x : b) points.push_back(GC::to_point<Traits>(x));
    chain.push_back(Bezier<Traits>(points.begin(), points.end()));
  }
  return chain;
}

template <class Join> bool same_join(const Join& x, const Join& y) {
  return x.c_order == y.c_order && x.g_order == y.g_order && x.f_order == y.f_order && x.betas() == y.betas() &&
         x.curvature_equal == y.curvature_equal && x.torsion_equal == y.torsion_equal;
}

// A curve that counts its copies.
struct Counted_curve : Bezier<Double_2> {
  static int alive, most;
  static void count(int n) { most = std::max(most, alive += n); }
  explicit Counted_curve(const Bezier<Double_2>& c) : Bezier<Double_2>(c) { count(1); }
  Counted_curve(const Counted_curve& c) : Bezier<Double_2>(c) { count(1); }
  Counted_curve& operator=(const Counted_curve&) = default;
  ~Counted_curve() { count(-1); }
};
int Counted_curve::alive = 0, Counted_curve::most = 0;

BOOST_AUTO_TEST_CASE_TEMPLATE(a_chain_is_its_joins, Traits, All_traits) {
  typedef GC::Chain_join<Bezier<Traits>> Chain_join;
  Random random;
  for (bool closed : {false, true})
    for (int max_order : {0, 2, 4}) {
      const std::vector<Bezier<Traits>> chain = random_chain<Traits>(random, 30);
      std::size_t n = 0;
      std::map<int, std::size_t> c, g, f;
      const GC::Closure closure = closed ? GC::Closure::closed : GC::Closure::open;
      const auto joins = GC::chain_joins(chain, max_order, closure);
      GC::Chain_accumulator<Bezier<Traits>> analysis(max_order);
      const auto report = [&](const Chain_join& join) {
        BOOST_CHECK_EQUAL(join.left, n);
        BOOST_CHECK_EQUAL(join.right, n == 29 ? 0 : n + 1);
        BOOST_CHECK(join.left_curve == chain[join.left]);
        BOOST_CHECK(join.right_curve == chain[join.right]);
        const auto expected = GC::continuity(chain[join.left], chain[join.right], max_order);
        BOOST_CHECK(same_join(join.continuity, expected));
        BOOST_CHECK(same_join(joins.at(n), expected));
        ++c[expected.c_order];
        ++g[expected.g_order];
        ++f[expected.f_order];
        ++n;
      };
      for (const Bezier<Traits>& curve : chain) analysis.add(curve, report);
      if (closed) analysis.close(report);
      const GC::Chain_summary& summary = analysis.summary();
      BOOST_CHECK_EQUAL(joins.size(), n);
      BOOST_CHECK_EQUAL(n, closed ? 30 : 29);
      BOOST_CHECK_EQUAL(summary.joins(), n);
      BOOST_CHECK(summary.counts(Kind::C) == c);
      BOOST_CHECK(summary.counts(Kind::G) == g);
      BOOST_CHECK(summary.counts(Kind::F) == f);
      BOOST_CHECK(max_order == 0 || g.size() > 2); // the test sees joins of several orders
      BOOST_CHECK_EQUAL(*summary.g_order(), g.begin()->first);
      BOOST_CHECK_EQUAL(summary.failing(Kind::C, 1), c[-1] + c[0]);
      BOOST_CHECK_EQUAL(summary.failing(Kind::F, 0), f[-1]);
      BOOST_CHECK(GC::chain_continuity(chain.begin(), chain.end(), max_order, closure).counts(Kind::C) == c);
      BOOST_CHECK(GC::chain_continuity(chain, max_order, closure).counts(Kind::F) == f);
    }
}

BOOST_AUTO_TEST_CASE(short_chains) {
  Random random;
  const std::vector<Bezier<Exact_3>> chain = random_chain<Exact_3>(random, 2);
  const auto joins = [&](int n, bool closed) {
    const GC::Closure closure = closed ? GC::Closure::closed : GC::Closure::open;
    BOOST_CHECK_EQUAL(GC::chain_joins(chain.begin(), chain.begin() + n, 3, closure).size(),
                      n - (closed || n == 0 ? 0 : 1));
    return GC::chain_continuity(chain.begin(), chain.begin() + n, 3, closure);
  };
  BOOST_CHECK_EQUAL(joins(0, false).joins(), 0);
  BOOST_CHECK_EQUAL(joins(0, true).joins(), 0);
  BOOST_CHECK_EQUAL(joins(1, false).joins(), 0);
  BOOST_CHECK_EQUAL(joins(1, true).joins(), 1);
  BOOST_CHECK_EQUAL(joins(2, false).joins(), 1);
  BOOST_CHECK_EQUAL(joins(2, true).joins(), 2);
  BOOST_CHECK(!joins(1, false).c_order());
  BOOST_CHECK_EQUAL(joins(0, true).failing(Kind::C, 3), 0);
}

// The summaries of two parts of a chain that have a curve in common are together that of the chain.
BOOST_AUTO_TEST_CASE(summaries_of_parts) {
  Random random;
  const std::vector<Bezier<Exact_3>> chain = random_chain<Exact_3>(random, 40);
  const GC::Chain_summary whole = GC::chain_continuity(chain, 3);
  for (int k : {0, 1, 17, 39}) {
    GC::Chain_summary sum = GC::chain_continuity(chain.begin(), chain.begin() + k + 1, 3);
    sum += GC::chain_continuity(chain.begin() + k, chain.end(), 3);
    BOOST_CHECK_EQUAL(sum.joins(), whole.joins());
    for (Kind kind : {Kind::C, Kind::G, Kind::F}) BOOST_CHECK(sum.counts(kind) == whole.counts(kind));
  }
}

// Tells whether a chain is closed is told by an enumeration: a bool would be taken for the order.
template <class... Argument> using Continuity = decltype(GC::chain_continuity(std::declval<Argument>()...));
template <class... Argument> using Joins = decltype(GC::chain_joins(std::declval<Argument>()...));
template <template <class...> class Call, class Arguments, class = void> constexpr bool compiles = false;
template <template <class...> class Call, class... Argument>
constexpr bool compiles<Call, void(Argument...), std::void_t<Call<Argument...>>> = true;

BOOST_AUTO_TEST_CASE(a_flag_is_no_order) {
  typedef std::vector<Bezier<Double_2>> Chain;
  typedef Chain::const_iterator Iterator;
  static_assert(compiles<Continuity, void(Iterator, Iterator, int)> && compiles<Joins, void(Iterator, Iterator, int)>);
  static_assert(!compiles<Continuity, void(Iterator, Iterator, bool)> &&
                !compiles<Joins, void(Iterator, Iterator, bool)>);
  static_assert(!compiles<Continuity, void(Iterator, Iterator, int, bool)>);
  static_assert(compiles<Continuity, void(Chain, int, GC::Closure)> && compiles<Joins, void(Chain)>);
  static_assert(!compiles<Continuity, void(Chain, bool)> && !compiles<Joins, void(Chain, bool)>);
  static_assert(!compiles<Continuity, void(Bezier<Double_2>)>); // its points are no curves
}

template <class Curve> using Segments = decltype(std::declval<Curve>().segments());

BOOST_AUTO_TEST_CASE(segments_of_a_temporary_curve_are_refused) {
  static_assert(compiles<Segments, void(const Composite<Double_2>&)>);
  static_assert(!compiles<Segments, void(Composite<Double_2>)>);
}

BOOST_AUTO_TEST_CASE(memory_does_not_grow_with_a_chain) {
  Random random;
  const Counted_curve curve(random.curve<Double_2>(3, 1).segment(0));
  const auto most = [&](int n) {
    GC::Chain_accumulator<Counted_curve> chain(2);
    Counted_curve::most = Counted_curve::alive;
    for (int i = 0; i < n; ++i) chain.add(curve);
    chain.close();
    BOOST_CHECK_EQUAL(chain.size(), n);
    BOOST_CHECK_EQUAL(chain.summary().joins(), n);
    return Counted_curve::most;
  };
  BOOST_CHECK_EQUAL(most(1000), most(3));
  BOOST_CHECK_EQUAL(Counted_curve::alive, 1);
}

BOOST_AUTO_TEST_CASE(a_refused_curve_does_not_change_the_chain) {
  typedef Exact_d::Point Point;
  const std::vector<Q> x = {Q(0), Q(1), Q(2)};
  const Point p(2, x.begin(), x.begin() + 2), q(3, x.begin(), x.end());
  const Bezier<Exact_d> plane{p, p}, space{q, q};
  typedef GC::Chain_join<Bezier<Exact_d>> Chain_join;
  GC::Chain_accumulator<Bezier<Exact_d>> chain;
  chain.add(plane);
  CHECK_ERROR(chain.add(space), dimension_mismatch);
  BOOST_CHECK_THROW(chain.add(plane, [](const Chain_join&) { throw std::runtime_error("report"); }),
                    std::runtime_error);
  BOOST_CHECK_EQUAL(chain.size(), 1);
  BOOST_CHECK_EQUAL(chain.summary().joins(), 0);
  chain.add(plane);
  BOOST_CHECK_EQUAL(chain.summary().joins(), 1);
  CHECK_ERROR(GC::Chain_accumulator<Bezier<Exact_d>>(-1), negative_count);
}

// ------------------------------------------------------------------- analysis of a segmented curve

BOOST_AUTO_TEST_CASE_TEMPLATE(every_join_is_that_of_two_curves, Traits, All_traits) {
  typedef GC::Predicate_FT<Traits> Field;
  Random random;
  for (bool closed : {false, true})
    for (int max_order : {1, 3, 4}) {
      const Composite<Traits> c = random.curve<Traits>(4, 3, closed);
      const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c, max_order);
      BOOST_REQUIRE_EQUAL(whole.joins.size(), closed ? 3 : 2);
      BOOST_CHECK_EQUAL(whole.summary.joins(), whole.joins.size());
      GC::Chain_summary summary;
      for (std::size_t i = 0; i < whole.joins.size(); ++i) {
        const GC::Composite_join<Traits>& join = whole.joins[i];
        BOOST_CHECK_EQUAL(join.left, i);
        BOOST_CHECK_EQUAL(join.right, (i + 1) % 3);
        BOOST_CHECK_EQUAL(join.knot, c.knots()[i + 1]);
        const Bezier<Traits> left = c.segment(join.left), right = c.segment(join.right);
        const auto expected = GC::continuity(left, right, max_order);
        BOOST_CHECK(same_join(join.continuity, expected));
        summary.add(expected);
        const auto x = left.template end_jet_over<Field>(3), y = right.template start_jet_over<Field>(3);
        if constexpr (test_dimension<Traits> == 2) {
          BOOST_CHECK(join.left_side.curvature == GC::signed_curvature(x));
          BOOST_CHECK(join.right_side.curvature == GC::signed_curvature(y));
        } else {
          BOOST_CHECK(join.left_side.curvature->square == *GC::curvature_squared(x));
          BOOST_CHECK(join.right_side.curvature->square == *GC::curvature_squared(y));
          BOOST_CHECK(join.left_side.curvature->sign == 1 && join.right_side.curvature->sign == 1);
        }
        if constexpr (is_exact<Traits>) { // from the legs of the polygon
          const auto before = GC::end_invariants(left), after = GC::start_invariants(right);
          BOOST_CHECK(join.left_side.curvature->square == *before.curvature_squared);
          BOOST_CHECK(join.right_side.curvature->square == *after.curvature_squared);
          BOOST_CHECK(join.left_side.torsion == before.torsion);
          BOOST_CHECK(join.right_side.torsion == after.torsion);
        }
        if constexpr (test_dimension<Traits> == 3) {
          BOOST_CHECK(join.left_side.torsion == GC::torsion(x));
          BOOST_CHECK(join.right_side.torsion == GC::torsion(y));
        } else
          BOOST_CHECK(!join.left_side.torsion && !join.right_side.torsion);
      }
      for (Kind kind : {Kind::C, Kind::G, Kind::F}) BOOST_CHECK(whole.summary.counts(kind) == summary.counts(kind));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(sides_of_a_join, Traits, All_traits) {
  typedef GC::Predicate_FT<Traits> Field;
  typedef GC::Signed_square<Field> Signed;
  // a left turn before the join and a right turn after it; at the ends of parabolas kappa = |p x r|
  // / (2 |p|^3)
  const auto whole = GC::chain_continuity(composite<Traits>({{0, 0}, {2, 0}, {2, 2}, {2, 4}, {8, 4}}, {0, 1, 2}));
  const bool plane = test_dimension<Traits> == 2;
  BOOST_CHECK(whole.joins[0].left_side.curvature == (Signed{1, Field(Field(1) / Field(16))}));
  BOOST_CHECK(whole.joins[0].right_side.curvature == (Signed{plane ? -1 : 1, Field(Field(9) / Field(16))}));
  // a zero leg has no curvature, a straight one the curvature 0 and no torsion
  const auto zero = GC::chain_continuity(composite<Traits>({{0, 0}, {2, 0}, {2, 0}, {2, 4}, {2, 8}}, {0, 1, 2}));
  BOOST_CHECK(!zero.joins[0].left_side.curvature && !zero.joins[0].left_side.torsion);
  BOOST_CHECK(zero.joins[0].right_side.curvature == (Signed{0, Field(0)}));
  BOOST_CHECK(!zero.joins[0].right_side.torsion);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(joins_that_fail, Traits, All_traits) {
  // four segments of a closed polygon: smooth, corner, smooth in direction only, closing corner
  const Composite<Traits> c =
      composite<Traits>({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {2, 4}, {2, 6}, {-1, 6}, {0, 0}}, {0, 1, 2, 3, 4});
  BOOST_REQUIRE(c.is_closed());
  const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c);
  const auto failing = [&](Kind kind, int order) {
    std::vector<int> left;
    for (const GC::Composite_join<Traits>& join : whole.failing(kind, order)) left.push_back(join.left);
    BOOST_CHECK_EQUAL(left.size(), whole.summary.failing(kind, order));
    return left;
  };
  BOOST_CHECK(failing(Kind::C, 0) == std::vector<int>());
  BOOST_CHECK(failing(Kind::C, 1) == std::vector<int>({0, 1, 2, 3}));
  BOOST_CHECK(failing(Kind::G, 1) == std::vector<int>({0, 2, 3}));
  BOOST_CHECK(failing(Kind::F, 1) == std::vector<int>({0, 2, 3}));
  BOOST_CHECK_EQUAL(*whole.summary.g_order(), 0);
  BOOST_CHECK(whole.joins[1].continuity.betas().size() >= 1 &&
              whole.joins[1].continuity.betas()[0] == GC::Predicate_FT<Traits>(2));
}

BOOST_AUTO_TEST_CASE(exact_predicates_read_points_and_knots_as_given) {
  typedef Epick_3::Point Point;
  // legs of length 1 + 1e-17 and 1: rounded subtraction makes them equal
  const std::vector<Point> b = {Point(-1, 0, 0), Point(1e-17, 0, 0), Point(1, 0, 0)};
  const Composite<Epick_3> c(b.begin(), b.end(), {0, 1, 2});
  const auto exact = GC::chain_continuity(c, 1).joins[0].continuity;
  BOOST_CHECK_EQUAL(exact.c_order, 0);
  BOOST_CHECK_EQUAL(exact.g_order, 1);
  BOOST_CHECK(exact.betas()[0] < 1);
  typedef Double_3::Point Rounded;
  const std::vector<Rounded> r = {Rounded(-1, 0, 0), Rounded(1e-17, 0, 0), Rounded(1, 0, 0)};
  BOOST_CHECK_EQUAL(
      GC::chain_continuity(Composite<Double_3>(r.begin(), r.end(), {0, 1, 2}), 1).joins[0].continuity.c_order, 1);
  // the same with knots: intervals of length 1 + 1e-17 and 1
  const std::vector<Point> p = {Point(-1, 0, 0), Point(0, 0, 0), Point(1, 0, 0)};
  BOOST_CHECK_EQUAL(
      GC::chain_continuity(Composite<Epick_3>(p.begin(), p.end(), {-1e-17, 1, 2}), 1).joins[0].continuity.c_order, 0);
  BOOST_CHECK_EQUAL(
      GC::chain_continuity(Composite<Epick_3>(p.begin(), p.end(), {0, 1, 2}), 1).joins[0].continuity.c_order, 1);
}
