// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

BOOST_AUTO_TEST_SUITE(continuity)

// Rounded kernels join small whole numbers. Exact predicates on them are exact for every order;
// plain double arithmetic stays exact up to order 3: with coordinates up to 2 in dimension 5, g <=
// 20, |Y'''| <= 44, |g^4 Y''' - ...| < 2^27, and the Gram determinant for F3 is below 2^52.
constexpr int max_order = !cancels ? 3 : exact_predicates ? 6 : 3;

template <class Traits> using Join = decltype(GC::continuity(std::declval<Jet<Traits>>(), std::declval<Jet<Traits>>()));

template <class Number> void check_orders(const GC::Join_continuity<Number>& join, int c, int g, int f) {
  BOOST_CHECK_EQUAL(join.c_order, c);
  BOOST_CHECK_EQUAL(join.g_order, g);
  BOOST_CHECK_EQUAL(join.f_order, f);
  BOOST_CHECK_EQUAL(static_cast<int>(join.betas().size()), std::max(g, 0));
}

template <class Number, class Other>
void check_betas(const GC::Join_continuity<Number>& join, const std::vector<Other>& betas) {
  BOOST_REQUIRE(join.betas().size() <= betas.size());
  for (std::size_t j = 0; j < join.betas().size(); ++j) BOOST_CHECK(join.betas()[j] == in_field<Number>(betas[j]));
}

inline std::vector<FT> random_betas(Random& random, int k) {
  std::vector<FT> betas(1, random.positive_whole());
  while (static_cast<int>(betas.size()) < k) betas.push_back(random.whole());
  return betas;
}

// The C order of a jet with non-zero tangent and its reparametrisation.
inline int c_order(const std::vector<FT>& betas) {
  int c = 0;
  while (c < static_cast<int>(betas.size()) && betas[c] == FT(c == 0 ? 1 : 0)) ++c;
  return c;
}

// A number by which a join with whole coordinates can be disturbed without rounding.
inline FT tiny() {
  return exact ? power(ratio(1, 10), cancels ? 30 : 1) : exact_predicates ? power(ratio(1, 2), 30) : FT(1);
}

// ---------------------------------------------------------------- joins of known order

TEST_WITH_RANDOM_INPUT(known_parameters) {
  for (int k = 1; k <= max_order; ++k) {
    const Jet<Traits> x = random_jet<Traits>(random, d, k);
    std::vector<FT> betas = random_betas(random, k);
    const Join<Traits> join = GC::continuity(x, reparametrised(x, betas));
    check_orders(join, c_order(betas), k, std::min(k, d));
    check_betas(join, betas);
    BOOST_CHECK(join.regular && *join.tangent_equal);
    BOOST_CHECK_EQUAL(bool(join.curvature_vector_equal), k >= 2);
    if (k >= 2) BOOST_CHECK(*join.curvature_equal && *join.curvature_vector_equal);
    BOOST_CHECK_EQUAL(bool(join.torsion_equal), k >= 3 && d == 3);
    if (join.torsion_equal) BOOST_CHECK(*join.torsion_equal);

    betas.assign(k, FT(0));
    betas[0] = FT(1);
    const Join<Traits> same = GC::continuity(x, x);
    check_orders(same, k, k, std::min(k, d));
    check_betas(same, betas);
    betas[k - 1] += FT(1); // C^(k-1) and G^k
    const Join<Traits> almost = GC::continuity(x, reparametrised(x, betas));
    check_orders(almost, k - 1, k, std::min(k, d));
    check_betas(almost, betas);
    for (int limit = 0; limit <= k; ++limit)
      check_orders(GC::continuity(x, x, limit), limit, limit, std::min(limit, d));
  }
}

// One coordinate of one derivative is disturbed, in a join of parameters betas.
template <class Traits> void check_disturbed(const Jet<Traits>& x, const std::vector<FT>& betas) {
  const int k = x.order(), d = x.dimension();
  const Jet<Traits> y = reparametrised(x, betas);
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i < d; ++i) {
      Jet<Traits> z = y;
      z[j][i] += tiny();
      const Join<Traits> join = GC::continuity(x, z);
      // F^j does not see what lies in the span of x', ..., x^(j-1)
      std::vector<Column<Traits>> span;
      for (int l = 1; l < j; ++l) span.push_back(x[l]);
      span.push_back(Column<Traits>(d));
      span.back()[i] = FT(1);
      const bool visible = j <= 1 || (j <= d && !(GC::gram_determinant(span) == FT(0)));
      check_orders(join, std::min(c_order(betas), j - 1), j - 1, visible ? j - 1 : std::min(k, d));
      check_betas(join, betas);
    }
  // along the tangent: only beta_j changes, but then order j + 1 fails
  for (int j = 2; j < k; ++j) {
    Jet<Traits> z = y;
    z[j] += tiny() * x[1];
    std::vector<FT> changed = betas;
    changed[j - 1] += tiny();
    const Join<Traits> join = GC::continuity(x, z);
    check_orders(join, std::min(c_order(changed), j), j, std::min(k, d));
    check_betas(join, changed);
  }
}

TEST_WITH_RANDOM_INPUT(disturbed_joins) {
  // no coordinate of x' is 0: no e_i is parallel to it
  const Jet<Traits> x = random_jet<Traits>(random, d, max_order);
  std::vector<FT> betas(max_order, FT(0));
  betas[0] = FT(1);
  check_disturbed(x, betas);
  check_disturbed(x, random_betas(random, max_order));
}

// The orders are those of the curves, however they are parametrised and wherever they are.
TEST_WITH_RANDOM_INPUT_IF(invariance, exact) {
  const int k = std::min(max_order, 5);
  const Jet<Traits> x = random_jet<Traits>(random, d, k);
  Jet<Traits> y = reparametrised(x, random_betas(random, k));
  const int broken = random.integer(1, k + 1);
  if (broken <= k) y[broken][0] += FT(1);
  const Join<Traits> join = GC::continuity(x, y);

  const Similarity<Traits> map(random, d, random.positive_rational());
  const Join<Traits> moved = GC::continuity(map(x), map(y));
  check_orders(moved, join.c_order, join.g_order, join.f_order);
  check_betas(moved, join.betas());

  const std::vector<FT> p = random_betas(random, k), q = random_betas(random, k);
  const Join<Traits> other = GC::continuity(reparametrised(x, p), reparametrised(y, q));
  check_orders(other, other.c_order, join.g_order, join.f_order);
  typedef typename std::decay_t<decltype(join)>::Number Field;
  if (join.g_order >= 1)
    BOOST_CHECK(other.betas()[0] == Field(join.betas()[0] * in_field<Field>(q[0]) / in_field<Field>(p[0])));

  const Join<Traits> backwards = GC::continuity(reversed(y), reversed(x));
  check_orders(backwards, join.c_order, join.g_order, join.f_order);
  if (join.g_order >= 1) BOOST_CHECK(backwards.betas()[0] == Field(Field(1) / join.betas()[0]));
}

// Each order against its own definition, on jets with so few values that all kinds of joins occur.
BOOST_AUTO_TEST_CASE(consistency) {
  int seen[5] = {0, 0, 0, 0, 0};
  with_random_input(
      [&](auto traits, int d, Random& random) {
        typedef decltype(traits) Traits;
        const auto few = [&](Jet<Traits>& z) {
          for (int j = 1; j <= 3; ++j)
            for (int i = 0; i < d; ++i) z[j][i] = FT(random.integer(0, 2) == 0 ? random.integer(-1, 1) : 0);
        };
        Jet<Traits> x(d, 3), y(d, 3);
        few(x);
        if (random.integer(0, 5) == 0)
          few(y);
        else
          y = reparametrised(x, random_betas(random, 3));
        if (random.integer(0, 1) == 0) y[random.integer(1, 3)][random.integer(0, d - 1)] += FT(random.integer(-1, 1));
        const Join<Traits> join = GC::continuity(x, y);
        ++seen[join.g_order];
        BOOST_CHECK_EQUAL(join.regular, !is_zero(x[1]) && !is_zero(y[1]));
        BOOST_CHECK_EQUAL(bool(join.tangent_equal), join.regular);
        BOOST_CHECK_EQUAL(bool(join.curvature_equal), join.regular);
        BOOST_CHECK_EQUAL(bool(join.curvature_vector_equal), join.regular);
        if (!join.regular) {
          check_orders(join, join.c_order, 0, 0);
          return;
        }
        const auto kx = GC::curvature_vector(x), ky = GC::curvature_vector(y);
        const Column<Traits> curvature_x = column<Traits>(*kx), curvature_y = column<Traits>(*ky);
        if constexpr (exact) BOOST_CHECK_EQUAL(*join.curvature_vector_equal, curvature_x == curvature_y);
        if constexpr (exact)
          BOOST_CHECK_EQUAL(*join.curvature_equal, GC::curvature_squared(x) == GC::curvature_squared(y));
        BOOST_CHECK_EQUAL(join.g_order >= 1, *join.tangent_equal);
        BOOST_CHECK_EQUAL(join.g_order >= 2, *join.tangent_equal && *join.curvature_vector_equal);
        BOOST_CHECK_EQUAL(join.f_order >= 2, join.g_order >= 2);
        BOOST_CHECK(join.g_order >= join.c_order);
        BOOST_CHECK(join.f_order >= std::min(join.g_order, d));
        BOOST_CHECK(join.f_order <= d);
        if (d == 3 && join.torsion_equal)
          BOOST_CHECK_EQUAL(join.f_order == 3, join.f_order >= 2 && *join.torsion_equal);
        if (d != 3) BOOST_CHECK(!join.torsion_equal);
      },
      cancels ? 300 : 30);
  for (int g = 0; g <= 3; ++g) BOOST_CHECK_GT(seen[g], 0);
}

// ---------------------------------------------------------------- degenerate joins

TEST_IN_EVERY_SPACE(irregular_joins) {
  const Jet<Traits> good = jet<Traits>(d, {{1, 2}, {1, 1}, {0, 2}, {3, 0}}),
                    stop = jet<Traits>(d, {{1, 2}, {0}, {0, 2}, {3, 0}});
  for (const auto& xy : {std::make_pair(good, stop), std::make_pair(stop, good), std::make_pair(stop, stop)}) {
    const Join<Traits> join = GC::continuity(xy.first, xy.second);
    check_orders(join, xy.first == xy.second ? 3 : 0, 0, 0); // two stops may be C3
    BOOST_CHECK(!join.regular);
    BOOST_CHECK(!join.tangent_equal && !join.curvature_equal && !join.curvature_vector_equal && !join.torsion_equal);
  }
  // a cusp: the tangent is reversed
  const Join<Traits> cusp = GC::continuity(good, reversed(good));
  check_orders(cusp, 0, 0, 0);
  BOOST_CHECK(cusp.regular && !*cusp.tangent_equal && *cusp.curvature_vector_equal);
  // a corner
  const Join<Traits> corner = GC::continuity(good, jet<Traits>(d, {{1, 2}, {1, -1}, {0, 2}, {3, 0}}));
  check_orders(corner, 0, 0, 0);
  BOOST_CHECK(corner.regular && !*corner.tangent_equal);
  // a gap, where the derivatives agree
  Jet<Traits> elsewhere = good;
  elsewhere[0][d - 1] += tiny();
  const Join<Traits> gap = GC::continuity(good, elsewhere);
  check_orders(gap, -1, -1, -1);
  BOOST_CHECK(gap.regular && *gap.tangent_equal && *gap.curvature_vector_equal);
  // points only, and jets of different orders
  const Join<Traits> points = GC::continuity(truncated(good, 0), truncated(good, 0));
  check_orders(points, 0, 0, 0);
  BOOST_CHECK(!points.regular && !points.tangent_equal);
  check_orders(GC::continuity(truncated(good, 1), good), 1, 1, 1);
  check_orders(GC::continuity(good, truncated(good, 2), 5), 2, 2, 2);
  // a lower order than asked for still reports the curvatures
  const Join<Traits> first = GC::continuity(good, good, 1);
  check_orders(first, 1, 1, 1);
  BOOST_CHECK(*first.curvature_vector_equal);

  CHECK_ERROR(GC::continuity(Jet<Traits>(), Jet<Traits>()), jet_order_too_low);
  if constexpr (Curve<Traits>::N == 0)
    CHECK_ERROR(GC::continuity(good, jet<Traits>(d + 1, {{1, 2}, {1, 1}})), dimension_mismatch);
}

// Curvature 0 on both sides, and on one side
TEST_IN_EVERY_SPACE(straight_joins) {
  const Jet<Traits> line = jet<Traits>(d, {{0}, {1}, {0}, {0}}), fast = jet<Traits>(d, {{0}, {2}, {3}, {5}}),
                    bent = jet<Traits>(d, {{0}, {1}, {0, 2}, {0}});
  const Join<Traits> both = GC::continuity(line, fast);
  check_orders(both, 0, 3, std::min(3, d));
  check_betas(both, std::vector<FT>{FT(2), FT(3), FT(5)});
  BOOST_CHECK(*both.curvature_equal && *both.curvature_vector_equal && !both.torsion_equal);
  for (const Join<Traits>& one : {GC::continuity(line, bent), GC::continuity(bent, line)}) {
    check_orders(one, 1, 1, 1);
    BOOST_CHECK(!*one.curvature_equal && !*one.curvature_vector_equal && !one.torsion_equal);
  }
}

// The curvature, but not its direction: (t, t^2, 0) | (t, 0, t^2), and (t, t^2) | (t, -t^2) in the
// plane
BOOST_AUTO_TEST_CASE(equal_magnitudes) {
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    const Jet<Traits> x = jet<Traits>(d, {{0}, {1}, {0, 2}, {0}}), y = d == 2
                                                                           ? jet<Traits>(d, {{0}, {1}, {0, -2}, {0}})
                                                                           : jet<Traits>(d, {{0}, {1}, {0, 0, 2}, {0}});
    const Join<Traits> join = GC::continuity(x, y);
    check_orders(join, 1, 1, 1);
    BOOST_CHECK(*join.tangent_equal && *join.curvature_equal && !*join.curvature_vector_equal);
    BOOST_CHECK_EQUAL(bool(join.torsion_equal), d == 3);
    if (d == 3) BOOST_CHECK(*join.torsion_equal); // 0 on both sides
  });
  // (t, t^4, 0) | (t, 0, t^4): planar curves in different planes, C3
  const Jet<Traits3> x = jet<Traits3>(3, {{0}, {1}, {0}, {0}, {0, 24}}),
                     y = jet<Traits3>(3, {{0}, {1}, {0}, {0}, {0, 0, 24}});
  check_orders(GC::continuity(x, y), 3, 3, 3);
  BOOST_CHECK(*GC::continuity(x, y).curvature_equal && !GC::continuity(x, y).torsion_equal);
}

// (t, t^2/2, t^3/6) continued with other third derivatives
BOOST_AUTO_TEST_CASE(torsion_continuity) {
  const Jet<Traits3> x = jet<Traits3>(3, {{0}, {1}, {0, 1}, {0, 0, 1}});
  struct Case {
    Row third;
    int c, g, f;
    bool torsion_equal;
  };
  // F3, not G3: kappa' jumps
  const Case cases[] = {{{0, 0, 1}, 3, 3, 3, true},
                        {{0, 1, 1}, 2, 2, 3, true},
                        {{1, 0, 1}, 2, 3, 3, true},  // beta_3 = 1
                        {{7, 5, 1}, 2, 2, 3, true},  // both
                        {{0, 0, 2}, 2, 2, 2, false}, // another torsion
                        // of the same modulus
                        {{0, 0, -1}, 2, 2, 2, false},
                        {{0, 0, 0}, 2, 2, 2, false}};
  for (const Case& c : cases) {
    Jet<Traits3> y = x;
    y[3] = column<Traits3>(3, c.third);
    const Join<Traits3> join = GC::continuity(x, y);
    check_orders(join, c.c, c.g, c.f);
    BOOST_CHECK(*join.curvature_vector_equal);
    BOOST_CHECK_EQUAL(*join.torsion_equal, c.torsion_equal);
  }
  // with beta = 2, beta_2 = 1: G3 needs mu = 3 beta beta_2 = 6
  Jet<Traits3> y = reparametrised(x, {FT(2), FT(1), FT(4)});
  check_orders(GC::continuity(x, y), 0, 3, 3);
  BOOST_CHECK(y[3][1] == FT(6));
  y[3][1] = FT(5);
  check_orders(GC::continuity(x, y), 0, 2, 3);
}

BOOST_AUTO_TEST_CASE(output) {
  if constexpr (Is_streamable<FT>::value) {
    const Jet<Traits2> x = jet<Traits2>(2, {{0}, {1, 1}, {0, 1}, {1}});
    BOOST_CHECK_EQUAL(text(GC::continuity(x, x)).substr(0, 18), "C3 G3 F2, beta = (");
    const Join<Traits2> join = GC::continuity(x, reparametrised(x, {FT(2), FT(-3)}), 2);
    BOOST_CHECK_EQUAL(text(join), text("C0 G2 F2, beta = (", join.betas()[0], ", ", join.betas()[1], ")"));
    BOOST_CHECK_EQUAL(text(GC::continuity(x, reversed(x))), "C0 G0 F0");
    BOOST_CHECK_EQUAL(text(GC::continuity(x, jet<Traits2>(2, {{1}}))), "gap");
  }
}

// ---------------------------------------------------------------- joins of curves

// The two parts of a curve, the second one on another domain; fixed and dynamic degrees mixed
TEST_WITH_RANDOM_INPUT(curves) {
  const std::vector<Point<Traits>> p = random_points<Traits>(random, d, 4, &Random::whole);
  const std::pair<Curve<Traits>, Curve<Traits>> parts = Curve<Traits>(p.begin(), p.end()).split(ratio(1, 2));
  const GC::Bezier_curve<Traits, 3> left = parts.first;
  if (is_zero(left.end_jet(1)[1])) return;
  check_orders(GC::continuity(left, parts.second), 3, 3, std::min(3, d)); // order 3 unless told
  for (int k = 0; k <= max_order; ++k) check_orders(GC::continuity(left, parts.second, k), k, k, std::min(k, d));
  // [1/2, 1] becomes [0, 1]: beta_1 = 1/2
  const Join<Traits> slow = GC::continuity(left, parts.second.with_domain(FT(0), FT(1)));
  check_orders(slow, 0, 3, std::min(3, d));
  check_betas(slow, std::vector<FT>{ratio(1, 2), FT(0), FT(0)});
  check_orders(GC::continuity(parts.second.reverse(), left.reverse()), 3, 3, std::min(3, d));
  if constexpr (Curve<Traits>::N == 0)
    CHECK_ERROR(GC::continuity(left, curve<Traits>(d + 1, {{1}, {2}})), dimension_mismatch);
}

// A curve of the user's own on either side. In rounded kernels Taylor polynomials up to degree 2
// are exact.
TEST_WITH_RANDOM_INPUT(user_curves) {
  const int k = exact ? 3 : 2;
  const Jet<Traits> x = random_jet<Traits>(random, d, k);
  const Taylor_curve<Traits> left(x, FT(0), FT(1)), right(left.jet(FT(1), k), FT(5), FT(6));
  if (is_zero(left.jet(FT(1), 1)[1])) return;
  check_orders(GC::continuity(left, right), 3, 3, std::min(3, d));
  const std::vector<Point<Traits>> p = GC::start_control_points(left.jet(FT(1), k), k, FT(2));
  const Curve<Traits> c(p.begin(), p.end(), FT(0), FT(2));
  check_orders(GC::continuity(left, c), 3, 3, std::min(3, d));
  check_orders(GC::continuity(c.reverse(), c), 0, 0, 0);
  const std::vector<Point<Traits>> q = GC::end_control_points(x, k, FT(1));
  check_orders(GC::continuity(Curve<Traits>(q.begin(), q.end()), left, 2), 2, 2, 2);
}

// A parabola phi with dyadic control points and a quintic that starts with B = A + c p, C = 2B -
// A + 5/8 c^2 q + e p, where p and q are the last first and second differences of phi: beta = 5c/2
// and beta_2 = 10e, without rounding. The next double in place of any coordinate refutes that.
TEST_WITH_RANDOM_INPUT_IF(last_bit, exact_predicates) {
  std::vector<Point<Traits>> phi, gamma;
  Column<Traits> p, q, a;
  do {
    phi = random_points<Traits>(random, d, 3, &Random::number);
    a = column<Traits>(phi[2]);
    p = a - column<Traits>(phi[1]);
    q = p - (column<Traits>(phi[1]) - column<Traits>(phi[0]));
  } while (std::any_of(p.begin(), p.end(), [](const FT& x) { return x == FT(0); }) ||
           GC::gram_determinant(std::vector<Column<Traits>>{p, q}) == FT(0));
  const FT c = ratio(3, 8), e = ratio(random.integer(-8, 8), 16);
  const Column<Traits> b = a + c * p, third = FT(2) * b - a + FT(ratio(5, 8) * c * c) * q + e * p;
  gamma = random_points<Traits>(random, d, 6);
  gamma[0] = phi[2];
  gamma[1] = point<Traits>(b);
  gamma[2] = point<Traits>(third);
  const GC::Bezier_curve<Traits, 2> left(phi.begin(), phi.end());
  const auto join = GC::continuity(left, GC::Bezier_curve<Traits, 5>(gamma.begin(), gamma.end()), 2);
  check_orders(join, 0, 2, 2);
  check_betas(join, std::vector<FT>{FT(ratio(5, 2) * c), FT(FT(10) * e)});
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i < d; ++i) {
      std::vector<Point<Traits>> off = gamma;
      Column<Traits> x = column<Traits>(gamma[j]);
      x[i] = next_to(x[i]);
      off[j] = point<Traits>(x);
      check_orders(GC::continuity(left, Curve<Traits>(off.begin(), off.end()), 2), j == 0 ? -1 : 0, j - 1, j - 1);
    }
  // lengths of domains that make every derivative a rounded number
  const Join<Traits> thirds =
      GC::continuity(left.with_domain(FT(0), FT(7)), Curve<Traits>(gamma.begin(), gamma.end(), FT(1), FT(4)), 2);
  check_orders(thirds, 0, 2, 2);
  typedef typename std::decay_t<decltype(thirds)>::Number Field;
  BOOST_CHECK(thirds.betas()[0] == Field(in_field<Field>(FT(ratio(5, 2) * c)) * Field(7) / Field(3)));
}

BOOST_AUTO_TEST_SUITE_END()
