// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curvatures, frames and congruence of jets with very large and very small coordinates, in many
// dimensions, and what is refused: nothing returns an undefined number.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>

BOOST_AUTO_TEST_SUITE(numbers_of_any_size)

template <class Traits> using Jet = GC::Curve_jet<Traits>;

const double undefined = std::numeric_limits<double>::quiet_NaN();

// A jet of order k with whole numbers, whose derivatives are independent as far as they can be.
template <class Traits> Jet<Traits> whole_jet(std::mt19937& random, int d, int k) {
  for (;;) {
    Jet<Traits> x(d, k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < d; ++i) x[j][i] = typename Traits::FT(static_cast<int>(random() % 41) - 20);
    if (GC::gram_determinants(x, (std::min)(d, k)).back() != typename Traits::FT(0)) return x;
  }
}

// The jet with the j-th derivative times 2^(a + j b): the curve is 2^a times as large, and run
// through 2^b times as fast.
template <class Traits> Jet<Traits> scaled(Jet<Traits> x, int a, int b = 0) {
  for (int j = 0; j <= x.order(); ++j)
    for (int i = 0; i < x.dimension(); ++i) x[j][i] = std::ldexp(x[j][i], a + j * b);
  return x;
}
template <class Traits> Jet<Traits> times(Jet<Traits> x, double factor) {
  for (int j = 0; j <= x.order(); ++j) x[j] *= factor;
  return x;
}
template <class Traits> GC::Coordinate_jet<Q, GC::dimension_v<Traits>> exact(const Jet<Traits>& x) {
  GC::Coordinate_jet<Q, GC::dimension_v<Traits>> r(x.dimension(), x.order());
  for (int j = 0; j <= x.order(); ++j)
    for (int i = 0; i < x.dimension(); ++i) r[j][i] = Q(x[j][i]);
  return r;
}

// x, y, z to y, z, x: a rotation without rounding
template <class Traits> Jet<Traits> turned(Jet<Traits> x) {
  for (int j = 0; j <= x.order(); ++j) {
    const double c = x[j][0];
    x[j][0] = x[j][1];
    x[j][1] = x[j][2];
    x[j][2] = c;
  }
  return x;
}

const int binary_sizes[] = {-500, -300, -254, -100, 100, 254, 300, 500};
const double decimal_sizes[] = {1e-150, 1e-100, 1e-80, 1e78, 1e80, 1e100, 1e150};

// Powers of two only shift the exponent: the results are those of the jet of normal size, bit by
// bit.
BOOST_AUTO_TEST_CASE(powers_of_two_change_exponents_only) {
  std::mt19937 random(1);
  for (int a : binary_sizes)
    for (int round = 0; round < 10; ++round) {
      const Jet<Double_3> x = whole_jet<Double_3>(random, 3, 3);
      for (int b : {0, a > 0 ? -60 : 60}) {
        const Jet<Double_3> y = scaled(x, a, b);
        BOOST_CHECK_EQUAL(*GC::torsion(y), std::ldexp(*GC::torsion(x), -a));
        BOOST_CHECK_EQUAL(*GC::curvature_squared(y), std::ldexp(*GC::curvature_squared(x), -2 * a));
        const auto kx = GC::curvature_vector(x), ky = GC::curvature_vector(y);
        for (int i = 0; i < 3; ++i) BOOST_CHECK_EQUAL((*ky)[i], std::ldexp((*kx)[i], -a));
        const auto cx = GC::frenet_curvatures(x), cy = GC::frenet_curvatures(y);
        for (int i = 0; i < 2; ++i) {
          BOOST_CHECK_EQUAL(cy[i]->sign, cx[i]->sign);
          BOOST_CHECK_EQUAL(cy[i]->square, std::ldexp(cx[i]->square, -2 * a));
        }
        const auto ex = GC::frenet_frame(x)->normalized(), ey = GC::frenet_frame(y)->normalized();
        for (int j = 1; j <= 3; ++j) BOOST_CHECK(ex.coordinates(j) == ey.coordinates(j));
        const auto wx = GC::frenet_matrix(x), wy = GC::frenet_matrix(y);
        for (int i = 1; i < 3; ++i) BOOST_CHECK_EQUAL((*wy)(i, i + 1), std::ldexp((*wx)(i, i + 1), b));
      }
      const Jet<Double_2> p = whole_jet<Double_2>(random, 2, 2), q = scaled(p, a);
      BOOST_CHECK_EQUAL(GC::signed_curvature(q)->sign, GC::signed_curvature(p)->sign);
      BOOST_CHECK_EQUAL(GC::signed_curvature(q)->square, std::ldexp(GC::signed_curvature(p)->square, -2 * a));
      BOOST_CHECK_EQUAL(GC::gram_determinants(q, 1)[1], std::ldexp(GC::gram_determinants(p, 1)[1], 2 * a));
      GC::Surface_jet<Double_3> s(3, 1), t(3, 1);
      s(1, 0) = x[1], s(0, 1) = x[2], t(1, 0) = scaled(x, a)[1], t(0, 1) = scaled(x, a)[2];
      BOOST_CHECK(*GC::unit_normal(s) == *GC::unit_normal(t));
    }
}

// Against exact rational numbers, with the rounding of numbers that are no powers of two.
BOOST_AUTO_TEST_CASE(decimal_sizes_against_rationals) {
  std::mt19937 random(2);
  const auto near = [](double x, const Q& y) {
    const Q error = Q(x) - y, bound = Q(1e-9) * y;
    return error * error <= bound * bound;
  };
  for (double factor : decimal_sizes)
    for (int round = 0; round < 10; ++round) {
      const Jet<Double_3> x = times(whole_jet<Double_3>(random, 3, 3), factor);
      const auto y = exact(x);
      BOOST_CHECK(near(*GC::torsion(x), *GC::torsion(y)));
      BOOST_CHECK(near(*GC::curvature_squared(x), *GC::curvature_squared(y)));
      const auto cx = GC::frenet_curvatures(x);
      const auto cy = GC::frenet_curvatures(y);
      for (int i = 0; i < 2; ++i) {
        BOOST_CHECK_EQUAL(cx[i]->sign, cy[i]->sign);
        BOOST_CHECK(near(cx[i]->square, cy[i]->square));
      }
      const auto e = GC::frenet_frame(x);
      BOOST_REQUIRE(e);
      const GC::Frenet_frame<Double_3> unit = e->normalized();
      for (int j = 1; j <= 3; ++j)
        for (double c : unit.coordinates(j)) BOOST_CHECK(std::abs(c) <= 1 + 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(what_overflows_is_refused_and_what_underflows_is_zero) {
  Jet<Double_3> x(3, 3);
  x[1][0] = 0x1p-300, x[2][1] = 1, x[3][2] = 1; // the curvature is 2^600
  CHECK_ERROR(GC::curvature_squared(x), not_finite);
  CHECK_ERROR(GC::frenet_curvatures(x), not_finite);
  BOOST_CHECK_EQUAL((*GC::curvature_vector(x)).y(), 0x1p600);
  BOOST_CHECK_EQUAL(*GC::torsion(x), 0x1p300);
  x[1][0] = 0x1p300; // and here 2^-600
  BOOST_CHECK_EQUAL(*GC::curvature_squared(x), 0);
  BOOST_CHECK_EQUAL(GC::frenet_curvatures(x)[0]->sign, 1);
  BOOST_CHECK_EQUAL((*GC::curvature_vector(x)).y(), 0x1p-600);
  BOOST_CHECK_EQUAL(*GC::torsion(x), 0x1p-300);
  x[2][1] = 0x1p-1074; // the smallest number
  BOOST_CHECK_EQUAL(*GC::torsion(x), 0x1p774);
  BOOST_CHECK(GC::frenet_frame(x));
  CHECK_ERROR(GC::gram_determinants(scaled(x, 400), 1), not_finite);
  for (double bad : {infinity, -infinity, undefined})
    for (int j = 1; j <= 3; ++j) {
      Jet<Double_3> y = x;
      y[j][2] = bad;
      CHECK_ERROR(GC::torsion(y), not_finite);
      CHECK_ERROR(GC::frenet_curvatures(y), not_finite);
      if (j < 3) CHECK_ERROR(GC::curvature_squared(y), not_finite);
      if (j < 3) CHECK_ERROR(GC::frenet_frame(y), not_finite);
      CHECK_ERROR(GC::congruence(y, x), not_finite);
      CHECK_ERROR(GC::congruence(x, y), not_finite);
    }
  GC::Surface_jet<Double_3> s(3, 1);
  s(1, 0)[0] = s(0, 1)[1] = 0x1p600;
  CHECK_ERROR(GC::normal(s), not_finite);
  BOOST_CHECK_EQUAL(GC::unit_normal(s)->z(), 1);
}

template <class Traits> void check_congruence_of_any_size(unsigned seed) {
  std::mt19937 random(seed);
  const Jet<Traits> whole = whole_jet<Traits>(random, 3, 4);
  const auto is_the_turn = [](const std::optional<GC::Isometry<Traits>>& map) {
    if (!map) return false;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (std::abs(map->entry(i, j) - ((i + 1) % 3 == j ? 1 : 0)) > 1e-12) return false;
    return true;
  };
  for (int a :
       // whole numbers up to 20 times the smallest power fit
       {-1060, -900, -500, -254, 0, 254, 500, 900, 1010}) {
    const Jet<Traits> x = scaled(whole, a), y = turned(x);
    BOOST_CHECK(is_the_turn(GC::congruence(x, y)));
    for (int j = 1; j <= 4; ++j) {
      Jet<Traits> z = y;
      z[j][0] = std::nextafter(z[j][0], infinity);
      if (std::is_same_v<Traits, Epick_3>) BOOST_CHECK(!GC::congruence(x, z)); // exactly
    }
    if (a != 0) BOOST_CHECK(!GC::congruence(whole, y));
    if (a != 0) BOOST_CHECK(!GC::congruence(y, whole));
  }
}

BOOST_AUTO_TEST_CASE(congruence_of_any_size) {
  check_congruence_of_any_size<Epick_3>(3);
  check_congruence_of_any_size<Double_3>(4);
  std::mt19937 random(5);
  for (double factor : decimal_sizes) {
    const Jet<Epick_3> x = times(whole_jet<Epick_3>(random, 3, 3), factor);
    const auto map = GC::congruence(x, turned(x));
    BOOST_REQUIRE(map);
    for (int i = 0; i < 3; ++i) BOOST_CHECK(std::abs(map->entry(i, (i + 1) % 3) - 1) <= 1e-15);
  }
}

// Rounded Frenet frames would be singular here: the derivatives differ in the last bit.
BOOST_AUTO_TEST_CASE(nearly_singular_jets_are_congruent_exactly) {
  Jet<Epick_3> x(3, 3);
  x[1][0] = x[2][0] = 1. / 3, x[1][1] = x[2][1] = 0.1, x[1][2] = x[2][2] = 0.7;
  x[2][1] = std::nextafter(x[2][1], 1);
  x[3][2] = 1;
  const auto map = GC::congruence(x, turned(x));
  BOOST_REQUIRE(map);
  for (int i = 0; i < 3; ++i) BOOST_CHECK(std::abs(map->entry(i, (i + 1) % 3) - 1) <= 1e-15);
}

// 2^n minors of a determinant would be more than anybody waits for.
BOOST_AUTO_TEST_CASE(twenty_dimensions) {
  const int n = 20;
  std::mt19937 random(6);
  const Jet<Exact_d> x = whole_jet<Exact_d>(random, n, n + 1);
  Jet<Exact_d> y = x, z = x;
  for (int j = 0; j <= n + 1; ++j) {
    for (int i = 0; i < n; i += 2) { // n / 2 quarter turns
      y[j][i] = Q(-x[j][i + 1]);
      y[j][i + 1] = x[j][i];
    }
    z[j][0] = Q(-x[j][0]); // a mirror
  }
  const auto map = GC::congruence(x, y);
  BOOST_REQUIRE(map);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      BOOST_CHECK_EQUAL(map->entry(i, j), Q(i % 2 == 0 && j == i + 1 ? -1 : i % 2 == 1 && j == i - 1 ? 1 : 0));
  BOOST_CHECK(!GC::congruence(x, z));
  // (t, t^2, ..., t^n) at 0: kappa_i = i + 1, and G_i is the product of the squares of the first
  // factorials
  Jet<Exact_d> moment(n, n);
  Q factorial(1), gram(1);
  for (int j = 1; j <= n; ++j) moment[j][j - 1] = factorial *= Q(j);
  const std::vector<Q> g = GC::gram_determinants(moment, n);
  const auto kappa = GC::frenet_curvatures(moment);
  for (int i = 1; i <= n; ++i) {
    gram *= moment[i][i - 1] * moment[i][i - 1];
    BOOST_CHECK_EQUAL(g[i], gram);
    if (i < n) BOOST_CHECK_EQUAL(kappa[i - 1]->square, Q((i + 1) * (i + 1)));
    if (i < n) BOOST_CHECK_EQUAL(kappa[i - 1]->sign, 1);
  }
}

// By elimination, with swaps of rows: a permuted triangular matrix, in rational numbers and in
// doubles.
BOOST_AUTO_TEST_CASE(large_determinants) {
  std::mt19937 random(7);
  for (int n : {7, 8, 11}) {
    std::vector<int> order(n);
    for (int i = 0; i < n; ++i) order[i] = i;
    int sign = 1, product = 1;
    for (int i = n - 1; i > 0; --i) {
      const int j = static_cast<int>(random() % static_cast<unsigned>(i + 1));
      if (i != j) sign = -sign;
      std::swap(order[i], order[j]);
    }
    std::vector<std::vector<int>> a(n, std::vector<int>(n, 0));
    for (int i = 0; i < n; ++i) {
      a[i][i] = i % 3 == 0 ? 2 : -1;
      product *= a[i][i];
      for (int j = 0; j < i; ++j) a[i][j] = static_cast<int>(random() % 9) - 4;
    }
    BOOST_CHECK_EQUAL(GC::determinant<Q>(n, [&](int i, int j) { return Q(a[order[i]][j]); }), Q(sign * product));
    BOOST_CHECK_CLOSE(GC::determinant<double>(n, [&](int i, int j) { return double(a[order[i]][j]); }), sign * product,
                      1e-9);
    a[n - 1] = a[0];
    BOOST_CHECK_EQUAL(GC::determinant<Q>(n, [&](int i, int j) { return Q(a[order[i]][j]); }), Q(0));
  }
}

BOOST_AUTO_TEST_CASE(batches_in_their_range) {
  std::mt19937 random(8);
  for (int a : {-196, 0, 195}) { // whole numbers from 1 to 20 times 2^a
    GC::Jet_arrays<double, 3, 3> jets(50);
    for (std::size_t l = 0; l < 50; ++l) jets.set(l, scaled(whole_jet<Double_3>(random, 3, 3), a));
    std::vector<double> kappa(50), tau(50);
    BOOST_CHECK_EQUAL(GC::curvature_and_torsion(jets, kappa.data(), tau.data()), 0u);
    for (std::size_t l = 0; l < 50; ++l) {
      BOOST_CHECK_CLOSE(kappa[l], std::sqrt(*GC::curvature_squared(jets.jet(l))), 1e-8);
      if (*GC::torsion(jets.jet(l)) == 0)
        BOOST_CHECK_EQUAL(tau[l], 0);
      else
        BOOST_CHECK_CLOSE(tau[l], *GC::torsion(jets.jet(l)), 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(refused_counts_and_dimensions) {
  typedef GC::Coordinate_vector<double, 3> Vector_3;
  typedef GC::Coordinates<Double_d> Vector_d;
  for (int k : {-1, -2, std::numeric_limits<int>::min()}) {
    CHECK_ERROR((GC::Coordinate_jet<double, 3>(3, k)), negative_count);
    CHECK_ERROR((GC::Coordinate_jet<double, 0>(3, k)), negative_count);
    CHECK_ERROR((GC::Coordinate_jet<double, 0>(k, 1)), negative_count);
    CHECK_ERROR(Jet<Double_3>(3, k), negative_count);
    CHECK_ERROR(GC::gram_determinants(Jet<Double_3>(3, 2), k), negative_count);
    const GC::Bezier_curve<Epick_3> curve{Epick_3::Point(0, 0, 0), Epick_3::Point(1, 0, 0)};
    CHECK_ERROR(GC::end_jet<Q>(curve, k), negative_count);
    CHECK_ERROR(GC::start_jet<Q>(curve, k), negative_count);
    CHECK_ERROR((GC::Surface_jet<Double_d>(k, 1)), negative_count);
  }
  CHECK_ERROR((GC::Coordinate_jet<double, 3>(2, 1)), dimension_mismatch);
  GC::Jet_arrays<double, 3, 2> jets(1);
  CHECK_ERROR(jets.set(0, Jet<Double_3>(3, 1)), jet_order_too_low);
  CHECK_ERROR(jets.set(0, Jet<Double_d>(2, 2)), dimension_mismatch);
  CHECK_ERROR(GC::frenet_frame(Jet<Double_3>()), jet_order_too_low);
  CHECK_ERROR(GC::Frenet_frame<Double_3>({Vector_3(3), Vector_3(3)}), dimension_mismatch);
  CHECK_ERROR(GC::Frenet_frame<Double_d>({Vector_d(2), Vector_d(3)}), dimension_mismatch);
  CHECK_ERROR(GC::Frenet_frame<Double_2>({GC::Coordinates<Double_2>(2), GC::Coordinates<Double_2>(2)}).normalized(),
              zero_direction);
  const GC::Frenet_matrix<double> w(1, {1, 2});
  CHECK_ERROR(w(std::vector<Vector_3>(2, Vector_3(3))), dimension_mismatch);
  CHECK_ERROR(w(std::vector<Vector_d>(3, Vector_d(2))), dimension_mismatch);
  Vector_d one(2), bad(2);
  one[0] = 1, bad[1] = undefined;
  CHECK_ERROR(GC::Isometry<Double_d>({one}, one), dimension_mismatch);
  CHECK_ERROR(GC::Isometry<Double_d>({one, Vector_d(3)}, one), dimension_mismatch);
  CHECK_ERROR(GC::Isometry<Double_d>({one, bad}, one), not_finite);
  CHECK_ERROR(GC::Isometry<Double_d>({one, one}, bad), not_finite);
  CHECK_ERROR(GC::Isometry<Double_d>({one, one}, one)(Jet<Double_d>(3, 1)), dimension_mismatch);
}

BOOST_AUTO_TEST_SUITE_END()
