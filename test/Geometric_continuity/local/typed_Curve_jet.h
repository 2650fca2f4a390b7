// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

#include <limits>

BOOST_AUTO_TEST_SUITE(jets)

typedef GC::Signed_square<FT> Signed_square;
typedef std::vector<std::optional<Signed_square>> Curvatures;

template <class Traits> std::optional<Column<Traits>> curvature_column(const Jet<Traits>& x) {
  const std::optional<Vector<Traits>> k = GC::curvature_vector(x);
  if (!k) return std::nullopt;
  return column<Traits>(*k);
}

// (1 or -1)^n
inline int parity(int sign, int n) { return n % 2 == 0 ? 1 : sign; }

// kappa_1, ..., kappa_{n-1} multiplied by `factor`, the last one also by the sign `last`.
inline Curvatures scaled(Curvatures kappa, const FT& factor, int last = 1) {
  for (std::optional<Signed_square>& k : kappa)
    if (k) k->square *= factor * factor;
  if (!kappa.empty() && kappa.back()) kappa.back()->sign *= last;
  return kappa;
}

TEST_IN_EVERY_SPACE(access) {
  const Point<Traits> p = point<Traits>(d, {3, -4});
  for (int k : {0, 1, 2, 5, 6, 9}) { // up to order 5 without memory from the heap
    std::vector<Vector<Traits>> derivatives;
    for (int j = 1; j <= k; ++j) derivatives.push_back(vector<Traits>(d, {j, j * j}));
    const Jet<Traits> x(p, derivatives);
    BOOST_CHECK_EQUAL(x.order(), k);
    BOOST_CHECK_EQUAL(x.dimension(), d);
    BOOST_CHECK(column<Traits>(x.point()) == column<Traits>(p));
    for (int j = 1; j <= k; ++j) {
      BOOST_CHECK(x[j] == column<Traits>(d, {j, j * j}));
      BOOST_CHECK(column<Traits>(x.derivative(j)) == x[j]);
    }
    Jet<Traits> y = x;
    BOOST_CHECK(y == x);
    y[k][d - 1] += FT(1);
    BOOST_CHECK(y != x);
    BOOST_CHECK(x[k] != y[k]);
    derivatives.push_back(vector<Traits>(d, {0}));
    BOOST_CHECK(Jet<Traits>(p, derivatives) != x);
  }
  const Jet<Traits> line(p, {vector<Traits>(d, {1, 2})});
  BOOST_CHECK((line == jet<Traits>(d, {{3, -4}, {1, 2}})));
  if constexpr (Is_streamable<typename Traits::FT>::value)
    BOOST_CHECK_EQUAL(text(truncated(line, 0)).substr(0, text(FT(3), ' ', FT(-4)).size()), text(FT(3), ' ', FT(-4)));

  BOOST_CHECK_EQUAL(Jet<Traits>().order(), -1);
  BOOST_CHECK(Jet<Traits>() == Jet<Traits>());
  BOOST_CHECK(Jet<Traits>() != line);
  if constexpr (Curve<Traits>::N == 0)
    CHECK_ERROR(Jet<Traits>(p, {vector<Traits>(d, {1}), vector<Traits>(d + 1, {1})}), dimension_mismatch);
  if constexpr (std::is_floating_point_v<typename Traits::FT>)
    for (const FT& bad : {std::numeric_limits<FT>::infinity(), std::numeric_limits<FT>::quiet_NaN()}) {
      Column<Traits> c(d);
      c[d - 1] = bad;
      CHECK_ERROR(Jet<Traits>(point<Traits>(c), {}), not_finite);
      CHECK_ERROR(Jet<Traits>(p, {vector<Traits>(c)}), not_finite);
    }
}

// ---------------------------------------------------------------- known curves

// (r cos t, r sin t) at 0 and at pi/2, run through both ways, in the plane of the first two
// coordinates
TEST_IN_EVERY_SPACE(circle) {
  const Jet<Traits> right = jet<Traits>(d, {{4, 0}, {0, 4}, {-4, 0}, {0, -4}, {4, 0}, {0, 4}}),
                    top = jet<Traits>(d, {{0, 4}, {-4, 0}, {0, -4}, {4, 0}, {0, 4}, {-4, 0}});
  for (const Jet<Traits>& x : {right, top, reversed(right), reversed(top)}) {
    BOOST_CHECK(GC::curvature_squared(x) == ratio(1, 16));
    BOOST_CHECK(curvature_column(x) == FT(ratio(-1, 16)) * x[0]);
    const Curvatures kappa = GC::frenet_curvatures(x);
    const int sign = x == right || x == top ? 1 : -1;
    BOOST_REQUIRE_EQUAL(static_cast<int>(kappa.size()), d - 1);
    for (int i = 1; i < d; ++i)
      if (i == 1)
        BOOST_CHECK(kappa[0] == (Signed_square{d == 2 ? sign : 1, ratio(1, 16)}));
      else if (i == 2)
        BOOST_CHECK(kappa[1] == (Signed_square{0, FT(0)}));
      else
        BOOST_CHECK(!kappa[i - 1]);
    if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 2)
      if (d == 2) BOOST_CHECK(GC::signed_curvature(x) == (Signed_square{sign, ratio(1, 16)}));
    if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3)
      if (d == 3) BOOST_CHECK(GC::torsion(x) == FT(0));
    BOOST_CHECK_EQUAL(bool(GC::frenet_frame(x)), d <= 3);
    if (d == 3) BOOST_CHECK(GC::frenet_frame(x)->coordinates(3) == column<Traits>(3, {0, 0, sign * 16}));
  }
}

// (2 cos t, 2 sin t, 2t): curvature and torsion 1/4; and its mirror image
BOOST_AUTO_TEST_CASE(helix) {
  for (int sign : {1, -1}) {
    const Jet<Traits3> x = jet<Traits3>(3, {{2, 0, 0}, {0, 2, sign * 2}, {-2, 0, 0}, {0, -2, 0}});
    for (const Jet<Traits3>& y : {x, reversed(x)}) {
      BOOST_CHECK(GC::curvature_squared(y) == ratio(1, 16));
      BOOST_CHECK(GC::torsion(y) == ratio(sign, 4));
      const Curvatures expected = {Signed_square{1, ratio(1, 16)}, Signed_square{sign, ratio(1, 16)}};
      BOOST_CHECK(GC::frenet_curvatures(y) == expected);
      BOOST_CHECK(curvature_column(y) == FT(ratio(1, 8)) * column<Traits3>(3, {-2, 0, 0}));
    }
  }
}

// (t, t^2, ..., t^n) at 0: kappa_i = i + 1
TEST_IN_EVERY_SPACE(moment_curve) {
  Jet<Traits> x(d, d);
  FT factorial(1);
  for (int j = 1; j <= d; ++j) x[j][j - 1] = factorial *= FT(j);
  for (int sign : {1, -1}) {
    const Curvatures kappa = GC::frenet_curvatures(x);
    for (int i = 1; i < d; ++i)
      BOOST_CHECK(kappa[i - 1] == (Signed_square{i == d - 1 ? sign : 1, FT((i + 1) * (i + 1))}));
    x[d][d - 1] = -x[d][d - 1]; // its mirror image
  }
  const auto frame = GC::frenet_frame(x);
  BOOST_REQUIRE(frame);
  for (int i = 1; i < d; ++i) BOOST_CHECK(frame->coordinates(i) == x[i]);
  BOOST_CHECK(FT(0) < frame->coordinates(d)[d - 1]);
}

BOOST_AUTO_TEST_CASE(lines_and_cusps) {
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    const Jet<Traits> line = jet<Traits>(d, {{1, 1}, {2, -2}, {-3, 3}, {5, -5}, {0}, {7, -7}});
    BOOST_CHECK(GC::curvature_squared(line) == FT(0));
    BOOST_CHECK(curvature_column(line) == Column<Traits>(d));
    Curvatures kappa = GC::frenet_curvatures(line);
    BOOST_CHECK(kappa[0] == (Signed_square{0, FT(0)}));
    for (int i = 2; i < d; ++i) BOOST_CHECK(!kappa[i - 1]);
    BOOST_CHECK_EQUAL(bool(GC::frenet_frame(line)), d == 2);

    const Jet<Traits> cusp = jet<Traits>(d, {{1, 1}, {0}, {2, 1}, {0, 1, 1}, {0}, {1}});
    BOOST_CHECK(!GC::curvature_squared(cusp));
    BOOST_CHECK(!GC::curvature_vector(cusp));
    kappa = GC::frenet_curvatures(cusp);
    BOOST_CHECK_EQUAL(static_cast<int>(kappa.size()), d - 1);
    for (const std::optional<Signed_square>& k : kappa) BOOST_CHECK(!k);
    BOOST_CHECK(!GC::frenet_frame(cusp));

    for (const Jet<Traits>& x : {line, cusp}) {
      if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 2)
        if (d == 2) BOOST_CHECK(bool(GC::signed_curvature(x)) == (x == line));
      if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3)
        if (d == 3) BOOST_CHECK(!GC::torsion(x));
    }
  });
  // (t, t^4, 0): the curvature vanishes at 0 only
  BOOST_CHECK(GC::curvature_squared(jet<Traits3>(3, {{0}, {1}, {0}, {0}})) == FT(0));
  BOOST_CHECK(!GC::torsion(jet<Traits3>(3, {{0}, {1}, {0}, {0}})));
  BOOST_CHECK(!GC::frenet_frame(jet<Traits3>(3, {{0}, {1}, {0}, {0}})));
  BOOST_CHECK(GC::frenet_frame(jet<Traits2>(2, {{0}, {0, 3}}))->coordinates(2) == column<Traits2>(2, {-3, 0}));
}

TEST_IN_EVERY_SPACE(refused_jets) {
  const Jet<Traits> tangent = jet<Traits>(d, {{0}, {1}});
  CHECK_ERROR(GC::curvature_vector(tangent), jet_order_too_low);
  CHECK_ERROR(GC::curvature_squared(tangent), jet_order_too_low);
  CHECK_ERROR(GC::gram_determinants(tangent, 2), jet_order_too_low);
  BOOST_CHECK_EQUAL(GC::gram_determinants(tangent, 1).size(), 2u);
  const Jet<Traits> full = jet<Traits>(d, {{0}, {1}, {0, 1}, {0, 0, 1}, {1, 2}, {3, 4}});
  CHECK_ERROR(GC::frenet_curvatures(truncated(full, d - 1)), jet_order_too_low);
  BOOST_CHECK_NO_THROW(GC::frenet_curvatures(truncated(full, d)));
  CHECK_ERROR(GC::frenet_frame(truncated(full, d - 2)), jet_order_too_low);
  BOOST_CHECK_NO_THROW(GC::frenet_frame(truncated(full, d - 1)));
  if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 2) {
    CHECK_ERROR(GC::signed_curvature(tangent), jet_order_too_low);
    if (d != 2) CHECK_ERROR(GC::signed_curvature(full), dimension_mismatch);
  }
  if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3) {
    CHECK_ERROR(GC::torsion(truncated(full, 2)), jet_order_too_low);
    if (d != 3) CHECK_ERROR(GC::torsion(full), dimension_mismatch);
  }
  CHECK_ERROR(GC::curvature_squared(Jet<Traits>()), jet_order_too_low);
}

BOOST_AUTO_TEST_CASE(signed_squares) {
  const Signed_square x{-1, FT(4)}, y{1, FT(4)}, z{-1, FT(9)};
  BOOST_CHECK(x == x && x != y && x != z);
  if constexpr (Is_streamable<FT>::value)
    BOOST_CHECK_EQUAL(text(x, ' ', y), text("-sqrt(", FT(4), ") sqrt(", FT(4), ")"));
}

// ---------------------------------------------------------------- random jets over exact numbers

// Curvatures do not change under t -> beta_1 t + beta_2 t^2/2 + ...; with beta_1 < 0 the signed
// ones may change sign.
TEST_WITH_RANDOM_INPUT_IF(reparametrisation, exact) {
  const Jet<Traits> x = random_jet<Traits>(random, d, std::max(d, 4));
  for (int sign : {1, -1}) {
    std::vector<FT> betas = random.numbers(x.order());
    betas[0] = FT(sign) * random.positive_rational();
    const Jet<Traits> y = reparametrised(x, betas);
    BOOST_CHECK(curvature_column(x) == curvature_column(y));
    BOOST_CHECK(GC::curvature_squared(x) == GC::curvature_squared(y));
    const Curvatures kappa = GC::frenet_curvatures(y);
    BOOST_CHECK(kappa == scaled(GC::frenet_curvatures(x), FT(1), parity(sign, d * (d + 1) / 2)));
    BOOST_REQUIRE(kappa[0]);
    BOOST_CHECK(kappa[0]->square == *GC::curvature_squared(x));
    if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 2)
      if (d == 2) BOOST_CHECK(GC::signed_curvature(y) == kappa[0]);
    if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3)
      if (d == 3) {
        const FT tau = *GC::torsion(x);
        BOOST_CHECK(GC::torsion(y) == tau);
        BOOST_CHECK(kappa[1]->square == FT(tau * tau));
        BOOST_CHECK_EQUAL(kappa[1]->sign, FT(0) < tau ? 1 : -1);
      }
  }
}

TEST_WITH_RANDOM_INPUT_IF(similarities, exact) {
  const Jet<Traits> x = random_jet<Traits>(random, d, d);
  const Similarity<Traits> map(random, d, random.positive_rational());
  const Jet<Traits> y = map(x);
  const FT inverse = FT(1) / map.scale;
  BOOST_CHECK(curvature_column(y) == FT(inverse * inverse) * map.linear(*curvature_column(x)));
  BOOST_CHECK(GC::curvature_squared(y) == FT(*GC::curvature_squared(x) * inverse * inverse));
  BOOST_CHECK(GC::frenet_curvatures(y) == scaled(GC::frenet_curvatures(x), inverse));
  if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3)
    if (d == 3) BOOST_CHECK(GC::torsion(y) == FT(*GC::torsion(x) * inverse));
  const auto ex = GC::frenet_frame(x), ey = GC::frenet_frame(y);
  BOOST_REQUIRE(ex && ey);
  for (int i = 1; i < d; ++i) BOOST_CHECK(ey->coordinates(i) == map.linear(ex->coordinates(i)));
  // e_n has the length of the volume that the others span
  BOOST_CHECK(ey->coordinates(d) == FT(power(map.scale, d - 2)) * map.linear(ex->coordinates(d)));

  Jet<Traits> mirror = x;
  for (int j = 0; j <= d; ++j) mirror[j][0] = -mirror[j][0];
  BOOST_CHECK(GC::frenet_curvatures(mirror) == scaled(GC::frenet_curvatures(x), FT(1), -1));
}

// kappa_i^2 G_i^2 G_1 = G_{i-1} G_{i+1}
TEST_WITH_RANDOM_INPUT_IF(curvatures_from_gram_determinants, exact) {
  const Jet<Traits> x = random_jet<Traits>(random, d, d + 1);
  const std::vector<FT> g = GC::gram_determinants(x, d + 1);
  BOOST_REQUIRE_EQUAL(static_cast<int>(g.size()), d + 2);
  BOOST_CHECK(g[0] == FT(1) && g[1] == dot(x[1], x[1]) && g[d + 1] == FT(0));
  const Curvatures kappa = GC::frenet_curvatures(x);
  for (int i = 1; i < d; ++i) {
    BOOST_REQUIRE(kappa[i - 1]);
    BOOST_CHECK(FT(kappa[i - 1]->square * g[i] * g[i] * g[1]) == FT(g[i - 1] * g[i + 1]));
    if (i < d - 1) BOOST_CHECK_EQUAL(kappa[i - 1]->sign, 1);
  }
}

TEST_WITH_RANDOM_INPUT_IF(frames, exact) {
  const Jet<Traits> x = random_jet<Traits>(random, d, d - 1);
  const auto frame = GC::frenet_frame(x);
  BOOST_REQUIRE(frame);
  BOOST_CHECK_EQUAL(frame->dimension(), d);
  std::vector<Column<Traits>> e, span;
  for (int i = 1; i <= d; ++i) {
    e.push_back(frame->coordinates(i));
    BOOST_CHECK(column<Traits>(frame->vector(i)) == e.back());
    for (int j = 1; j < i; ++j) BOOST_CHECK(dot(e[j - 1], e[i - 1]) == FT(0));
    if (i == d) break;
    // e_i lies in the span of x', ..., x^(i), on the side of x^(i)
    BOOST_CHECK(dot(e[i - 1], x[i]) == dot(e[i - 1], e[i - 1]));
    span.push_back(x[i]);
    span.push_back(e.back());
    BOOST_CHECK(GC::gram_determinant(span) == FT(0));
    span.pop_back();
  }
  const FT volume = GC::determinant<FT>(d, [&](int i, int j) -> const FT& { return e[i][j]; });
  BOOST_CHECK(FT(0) < volume);
  BOOST_CHECK(volume == dot(e.back(), e.back()));
}

// ---------------------------------------------------------------- rounded numbers

BOOST_AUTO_TEST_CASE(unit_frame) {
  if constexpr (std::is_floating_point_v<FT>) {
    // (2, 1, 2)/3, and normals
    const auto frame = GC::frenet_frame(jet<Traits3>(3, {{0}, {2, 1, 2}, {1, 2, -2}}));
    BOOST_REQUIRE(frame);
    const auto unit = frame->normalized();
    const Column<Traits3> expected[] = {column<Traits3>(3, {2, 1, 2}), column<Traits3>(3, {1, 2, -2}),
                                        column<Traits3>(3, {-2, 2, 1})};
    // root, division and comparison: 3 roundings of numbers of modulus at most 1
    for (int i = 1; i <= 3; ++i)
      for (int j = 0; j < 3; ++j) BOOST_CHECK(close(unit.coordinates(i)[j], FT(expected[i - 1][j] / FT(3)), FT(1), 3));
  }
}

// d2 - (d2.d1 / d1.d1) d1 is off by at most (3n+4) u |d2|, as dot products of dimension n are off
// by n u |x| |y|; dividing by d1.d1 adds (n+1) u. Here u = 2^-53, and 8n exceeds both. Determinants
// of order 3 are off by at most 16 u |d1| |d2| |d3|, G_2 by 16 u |d1|^2 |d2|^2.
TEST_WITH_RANDOM_INPUT_IF(rounded_curvatures, !exact) {
  const double u = 0x1p-53;
  const Jet<Traits> x = random_jet<Traits>(random, d, 3, &Random::rational);
  const Jet<Reference> y = rational_jet(x);
  const double g = std::pow(length(y[1]), 2), error = 8 * d * u * length(y[2]) / g;
  const Column<Reference> k = column<Reference>(*GC::curvature_vector(y));
  BOOST_CHECK(within(*curvature_column(x), k, error));
  const double square = CGAL::to_double(*GC::curvature_squared(y));
  BOOST_CHECK_SMALL(CGAL::to_double(*GC::curvature_squared(x)) - square,
                    3 * error * length(k) + error * error + 8 * d * u * square);
  if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3)
    if (d == 3) {
      const double tau = CGAL::to_double(*GC::torsion(y)), g2 = CGAL::to_double(GC::gram_determinants(y, 2)[2]);
      const double l = length(y[1]) * length(y[2]);
      BOOST_CHECK_SMALL(CGAL::to_double(*GC::torsion(x)) - tau,
                        32 * u * (l * length(y[3]) / g2 + std::abs(tau) * l * l / g2));
    }
}

BOOST_AUTO_TEST_SUITE_END()
