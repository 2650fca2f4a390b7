// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Determinants of many rows, which are computed by elimination.

#include "support/test.h"

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

BOOST_AUTO_TEST_SUITE(determinant)

typedef std::tuple<Q, double> Numbers; // whole numbers in this test, which doubles represent

template <class FT> FT determinant(const std::vector<std::vector<FT>>& a) {
  return GC::determinant<FT>(static_cast<int>(a.size()), [&](int i, int j) -> const FT& { return a[i][j]; });
}

// The rows (1, x, x^2, ...) for x = 0, 1, ..., n - 1, in another order: odd rows first. Zeros are
// met as pivots.
std::vector<std::vector<Q>> vandermonde(int n, Q& expected) {
  std::vector<int> x;
  for (int i = 1; i < n; i += 2) x.push_back(i);
  for (int i = 0; i < n; i += 2) x.push_back(i);
  std::vector<std::vector<Q>> a(n, std::vector<Q>(n, Q(1)));
  expected = Q(1);
  for (int i = 0; i < n; ++i) {
    for (int j = 1; j < n; ++j) a[i][j] = a[i][j - 1] * x[i];
    for (int j = 0; j < i; ++j) expected *= x[i] - x[j];
  }
  return a;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(permutations, FT, Numbers) {
  for (int n = 3; n <= 12; ++n) { // a cycle of the rows
    std::vector<std::vector<FT>> a(n, std::vector<FT>(n, FT(0)));
    for (int i = 0; i < n; ++i) a[i][(i + 1) % n] = FT(i + 2);
    FT product(n % 2 == 0 ? -1 : 1);
    for (int i = 0; i < n; ++i) product *= FT(i + 2);
    BOOST_CHECK(determinant(a) == product);
    a[n / 2][(n / 2 + 1) % n] = FT(0);
    BOOST_CHECK(determinant(a) == FT(0));
  }
}

BOOST_AUTO_TEST_CASE(vandermonde_matrices) {
  for (int n = 1; n <= 14; ++n) {
    Q expected;
    std::vector<std::vector<Q>> a = vandermonde(n, expected);
    BOOST_CHECK(determinant(a) == expected);
    if (n == 1) continue;
    std::swap(a[0], a[n - 1]);
    BOOST_CHECK(determinant(a) == Q(-expected));
    a[0] = a[n - 1];
    BOOST_CHECK(determinant(a) == Q(0));
  }
}

BOOST_AUTO_TEST_CASE(numbers_of_rows) {
  const auto none = [](int, int) -> Q { throw 1; };
  BOOST_CHECK(GC::determinant<Q>(0, none) == Q(1));
  CHECK_ERROR(GC::determinant<Q>(-1, none), negative_count);
}

// The inverse of a matrix of whole numbers is one only where the determinant is 1 or -1.
BOOST_AUTO_TEST_CASE(inverse_matrices_of_whole_numbers) {
  const auto diagonal = [](int d) {
    return GC::Basis_matrix<int>({{{1, 3, 0, 0}, {0, 1, 0, 0}, {0, 0, d, 5}, {0, 0, 0, 1}}});
  };
  for (const int d : {1, -1}) {
    const GC::Basis_matrix<int> inverse = diagonal(d).inverse();
    BOOST_CHECK(inverse == GC::Basis_matrix<int>({{{1, -3, 0, 0}, {0, 1, 0, 0}, {0, 0, d, -5 * d}, {0, 0, 0, 1}}}));
    BOOST_CHECK(inverse != diagonal(d) && inverse.inverse() == diagonal(d));
  }
  for (const int d : {0, 2, -2, -3}) CHECK_ERROR(diagonal(d).inverse(), singular_frame);
}

BOOST_AUTO_TEST_CASE(powers_of_nothing) { BOOST_CHECK(GC::powers_from_bernstein<Q>(std::vector<Q>()).empty()); }

BOOST_AUTO_TEST_SUITE_END()
