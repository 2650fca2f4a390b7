// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

#include <limits>

BOOST_AUTO_TEST_SUITE(algebra)

typedef GC::Bernstein_polynomial<FT> Polynomial;
typedef GC::Sign_pattern Sign;

// In rounded kernels coefficients and parameters are multiples of 1/8 of modulus at most 2, and up
// to degree 3 the values below are doubles without rounding. Where a division by 3 or 5 comes in,
// at most 100 roundings happen, of numbers of modulus at most (2 * 5^3)^2, the sum of the moduli of
// all terms.
constexpr int max_degree = exact && cancels ? 6 : 3;
inline bool nearly_equal(const FT& x, const FT& y) { return close(x, y, FT(62500), 100); }

inline Polynomial random_polynomial(Random& random, int n) { return Polynomial(random.numbers(n + 1)); }

inline FT explicit_value(const Polynomial& p, const FT& t) {
  FT sum(0);
  for (int i = 0; i <= p.degree(); ++i)
    sum += FT(binomial(p.degree(), i)) * p[i] * power(t, i) * power(FT(FT(1) - t), p.degree() - i);
  return sum;
}

// the product rule on each term
inline FT explicit_derivative(const Polynomial& p, const FT& t) {
  const int n = p.degree();
  const FT s = FT(1) - t;
  FT sum(0);
  for (int i = 0; i <= n; ++i) {
    const FT c = FT(binomial(n, i)) * p[i];
    if (i > 0) sum += c * FT(i) * power(t, i - 1) * power(s, n - i);
    if (i < n) sum -= c * FT(n - i) * power(t, i) * power(s, n - i - 1);
  }
  return sum;
}

inline Polynomial whole(Row c) {
  std::vector<FT> x;
  for (int value : c) x.push_back(FT(value));
  return Polynomial(x);
}
inline Polynomial constant(const FT& c) { return Polynomial{c}; }
inline Polynomial root(const FT& r) { return Polynomial{FT(-r), FT(FT(1) - r)}; } // t - r
inline Polynomial repeated(const Polynomial& p, int n) {
  Polynomial r = constant(FT(1));
  for (int i = 0; i < n; ++i) r = r * p;
  return r;
}

BOOST_AUTO_TEST_CASE(values_and_basis) {
  repeat([](Random& random) {
    for (int n = 0; n <= max_degree; ++n) {
      const Polynomial p = random_polynomial(random, n);
      const FT t = random.number();
      BOOST_CHECK(p.degree() == n);
      BOOST_CHECK(p(t) == explicit_value(p, t));
      BOOST_CHECK(p(FT(0)) == p[0]);
      BOOST_CHECK(p(FT(1)) == p[n]);
      const std::vector<FT> basis = GC::bernstein_basis(n, t);
      BOOST_REQUIRE(static_cast<int>(basis.size()) == n + 1);
      FT one(0), value(0);
      for (int i = 0; i <= n; ++i) {
        BOOST_CHECK(basis[i] == FT(FT(binomial(n, i)) * power(t, i) * power(FT(FT(1) - t), n - i)));
        one += basis[i];
        value += basis[i] * p[i];
      }
      BOOST_CHECK(one == FT(1));
      BOOST_CHECK(value == p(t));
    }
  });
  const std::vector<FT> row = GC::binomial_coefficients<FT>(6);
  BOOST_CHECK(Polynomial(row) == whole({1, 6, 15, 20, 15, 6, 1}));
}

BOOST_AUTO_TEST_CASE(derivatives) {
  repeat([](Random& random) {
    for (int n = 0; n <= max_degree; ++n) {
      const Polynomial p = random_polynomial(random, n);
      const FT t = random.number();
      BOOST_CHECK(p.derivative()(t) == explicit_derivative(p, t));
      BOOST_CHECK(p.derivative().degree() == std::max(n - 1, 0));
      for (int k = 0; k <= n + 2; ++k) { // all at once, at t and at both ends
        std::vector<FT> c = p.coefficients(), start, end;
        for (int i = 0; i <= std::min(k, n); ++i) {
          start.push_back(p[i]);
          end.push_back(p[n - i]);
        }
        std::vector<FT> at_t, at_start, at_end;
        GC::bernstein_derivatives(c, n, t, k, [&](int, const FT& x) { at_t.push_back(x); });
        GC::bernstein_end_derivatives<FT>(start, n, k, [&](int, const FT& x) { at_start.push_back(x); });
        GC::bernstein_end_derivatives<FT>(end, n, k, [&](int j, const FT& x) { at_end.push_back(j % 2 ? FT(-x) : x); });
        BOOST_REQUIRE(static_cast<int>(at_t.size()) == k + 1);
        BOOST_REQUIRE(static_cast<int>(at_start.size()) == k + 1);
        BOOST_REQUIRE(static_cast<int>(at_end.size()) == k + 1);
        Polynomial d = p;
        for (int j = 0; j <= k; ++j, d = d.derivative()) {
          BOOST_CHECK(at_t[j] == d(t));
          BOOST_CHECK(at_start[j] == d(FT(0)));
          BOOST_CHECK(at_end[j] == d(FT(1)));
        }
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(antiderivative_and_integral) {
  repeat([](Random& random) {
    for (int n : {0, 1, 3}) { // divisions by 1, 2 and 4
      const Polynomial p = random_polynomial(random, n), q = p.antiderivative();
      BOOST_CHECK(q.degree() == n + 1);
      BOOST_CHECK(q(FT(0)) == FT(0));
      BOOST_CHECK(q.derivative() == p);
      BOOST_CHECK(p.integral() == q(FT(1)));
    }
  });
  BOOST_CHECK(nearly_equal(whole({0, 0, 1}).integral(), ratio(1, 3))); // t^2
}

BOOST_AUTO_TEST_CASE(arithmetic_and_elevation) {
  repeat([](Random& random) {
    for (int n = 0; n <= max_degree; ++n) {
      const Polynomial p = random_polynomial(random, n), q = random_polynomial(random, random.integer(0, max_degree));
      const FT t = random.number();
      BOOST_CHECK((p * q).degree() == n + q.degree());
      BOOST_CHECK(nearly_equal((p * q)(t), FT(p(t) * q(t))));
      BOOST_CHECK((p + q).degree() == std::max(n, q.degree()));
      BOOST_CHECK(nearly_equal((p + q)(t), FT(p(t) + q(t))));
      BOOST_CHECK(nearly_equal((p - q)(t), FT(p(t) - q(t))));
      for (int times = 0; times <= 3; ++times) {
        const Polynomial e = p.elevated(times);
        BOOST_CHECK(e.degree() == n + times);
        BOOST_CHECK(nearly_equal(e(t), p(t)));
        BOOST_CHECK(e[0] == p[0] && e[n + times] == p[n]);
      }
      BOOST_CHECK(p.elevated(0) == p);
      BOOST_CHECK(p.elevated() != p);
    }
  });
  if constexpr (exact) {
    BOOST_CHECK(whole({1, 2}) * whole({3, 4}) == (Polynomial{FT(3), FT(5), FT(8)}));
  }
}

BOOST_AUTO_TEST_CASE(subdivision) {
  repeat([](Random& random) {
    for (int n = 0; n <= max_degree; ++n) {
      const Polynomial p = random_polynomial(random, n);
      const FT t = random.number(), s = random.number();
      const std::pair<Polynomial, Polynomial> parts = p.split(t);
      BOOST_CHECK(parts.first(s) == p(FT(s * t)));
      BOOST_CHECK(parts.second(s) == p(FT(t + s * (FT(1) - t))));
      const FT a = exact ? random.number() : FT(random.integer(0, 1) * 2), b = random.number();
      if (!(a == b)) BOOST_CHECK(p.restricted(a, b)(s) == p(FT(a + s * (b - a))));
      if (!(b == FT(1))) BOOST_CHECK(p.restricted(FT(1), b)(s) == p(FT(FT(1) + s * (b - FT(1)))));
    }
  });
}

BOOST_AUTO_TEST_CASE(polynomial_interface) {
  CHECK_ERROR(Polynomial(std::vector<FT>()), wrong_number_of_points);
  const std::vector<FT> none;
  CHECK_ERROR(Polynomial(none.begin(), none.end()), wrong_number_of_points);
  BOOST_CHECK(whole({1, 2}) != whole({1, 2, 3}));
  BOOST_CHECK(whole({1, 2}) != whole({1, 3}));
  CHECK_ERROR(whole({1, 2}).elevated(-1), negative_count);
  CHECK_ERROR(GC::bernstein_basis(-1, FT(0)), negative_count);
  CHECK_ERROR(GC::bernstein_polynomials<FT>(-1), negative_count);
  CHECK_ERROR(GC::binomial_coefficients<FT>(-1), negative_count);
  if constexpr (Is_streamable<FT>::value)
    BOOST_CHECK_EQUAL(text(whole({1, -2, 3})), text(FT(1), ' ', FT(-2), ' ', FT(3)));
}

// ---------------------------------------------------------------- signs

BOOST_AUTO_TEST_CASE(signs_of_whole_coefficients) {
  const std::pair<Polynomial, Sign> cases[] = {
      {whole({1}), Sign::positive},
      {whole({0}), Sign::zero},
      {whole({0, 0, 0, 0}), Sign::zero},
      {whole({1, 2, 3}), Sign::positive},
      {whole({1, 0, 0, 1}), Sign::positive},
      {whole({0, 1}), Sign::nonnegative},
      {whole({1, 0}), Sign::nonnegative},
      {whole({0, 1, 0}), Sign::nonnegative},
      {whole({0, 0, 1}), Sign::nonnegative},
      {whole({0, 1, 1}), Sign::nonnegative},
      {whole({-1, 1}), Sign::mixed},
      {whole({1, 1, -1}), Sign::mixed},
      {whole({1, -1, 1}), Sign::nonnegative},                 // (2t-1)^2
      {whole({2, -1, 1}), Sign::positive},                    // 5t^2-6t+2
      {whole({1, -2, 1}), Sign::mixed},                       // two roots
      {whole({1, -2, 3}), Sign::mixed},                       // (1-2t)(1-4t): the middle is a root
      {whole({0, 2, -2, 3}), Sign::nonnegative},              // 3t(5t^2-6t+2): zero at 0 only
      {whole({0, -1, 1}), Sign::mixed},                       // a root at 0 and one inside
      {whole({0, 1, -1, 1, 0}), Sign::nonnegative},           // 2t(1-t)(7t^2-7t+2)
      {whole({0, 1, -1, 0}), Sign::mixed},                    // 3t(1-t)(1-2t)
      {whole({0, 1, -1, 1, 0, 0}), Sign::nonnegative},        // 5t(1-t)^2(5t^2-4t+1)
      {whole({1, -1, 1, -1}), Sign::mixed},                   // (1-2t)^3
      {whole({1, -1, 1, -1, 1}), Sign::nonnegative},          // (1-2t)^4
      {whole({1, -1, 1, -1, 1, -1, 1}), Sign::nonnegative},   // (1-2t)^6
      {whole({1, -1, 1, -1, 1, -1, 1, -1}), Sign::mixed},     // (1-2t)^7
      {whole({3, 3, 1, -3, 3}), Sign::nonnegative},           // 12 (t^2-1/2)^2
      {whole({1, -1, 1, 1}), Sign::positive},                 // at least 1/9
      {whole({1000000, -1, 1000000, -1, 1}), Sign::positive}, // near 1: 6 10^6 s^2 - 4s + 1
  };
  for (const std::pair<Polynomial, Sign>& c : cases) {
    BOOST_TEST_CONTEXT("polynomial " << &c - cases) {
      BOOST_CHECK_EQUAL(GC::sign_pattern(c.first), c.second);
      const Sign opposite = c.second == Sign::positive      ? Sign::negative
                            : c.second == Sign::nonnegative ? Sign::nonpositive
                                                            : c.second;
      BOOST_CHECK_EQUAL(GC::sign_pattern(constant(FT(0)) - c.first), opposite);
      std::vector<FT> c_reversed(c.first.coefficients().rbegin(), c.first.coefficients().rend());
      BOOST_CHECK_EQUAL(GC::sign_pattern(Polynomial(c_reversed)), c.second);
    }
  }
}

// One part in 2^40 decides, in floating point as well.
BOOST_AUTO_TEST_CASE(signs_of_near_misses, *boost::unit_test::enable_if<cancels>()) {
  const FT tiny = FT(1) / power(FT(2), 40);
  const Polynomial touching[] = {whole({1, -1, 1}), whole({1, -1, 1, -1, 1}), whole({3, 3, 1, -3, 3}),
                                 whole({0, 0, 1})};
  for (const Polynomial& p : touching) {
    BOOST_CHECK_EQUAL(GC::sign_pattern(p), Sign::nonnegative);
    BOOST_CHECK_EQUAL(GC::sign_pattern(p + Polynomial(std::vector<FT>(p.degree() + 1, tiny))), Sign::positive);
    BOOST_CHECK_EQUAL(GC::sign_pattern(p - Polynomial(std::vector<FT>(p.degree() + 1, tiny))), Sign::mixed);
  }
}

BOOST_AUTO_TEST_CASE(signs_on_intervals) {
  // touch at 1/2 and at sqrt(1/2)
  const Polynomial square = whole({1, -1, 1}), circle = whole({3, 3, 1, -3, 3});
  const FT half = ratio(1, 2), quarter = ratio(1, 4);
  BOOST_CHECK_EQUAL(GC::sign_pattern(square, FT(0), quarter), Sign::positive);
  BOOST_CHECK_EQUAL(GC::sign_pattern(square, quarter, half), Sign::nonnegative);
  BOOST_CHECK_EQUAL(GC::sign_pattern(square, half, FT(1)), Sign::nonnegative);
  BOOST_CHECK_EQUAL(GC::sign_pattern(square, FT(1), FT(2)), Sign::positive);
  BOOST_CHECK_EQUAL(GC::sign_pattern(circle, ratio(-3, 4), FT(0)), Sign::nonnegative); // -sqrt(1/2)
  BOOST_CHECK_EQUAL(GC::sign_pattern(circle, half, ratio(3, 4)), Sign::nonnegative);
  BOOST_CHECK_EQUAL(GC::sign_pattern(circle, ratio(3, 4), FT(1)), Sign::positive);
  BOOST_CHECK_EQUAL(GC::sign_pattern(whole({-1, 1}), FT(0), quarter), Sign::negative);
  BOOST_CHECK_EQUAL(GC::sign_pattern(whole({-1, 1}), FT(0), half), Sign::nonpositive);
  BOOST_CHECK_EQUAL(GC::sign_pattern(whole({-1, 1}), FT(0), ratio(3, 4)), Sign::mixed);
  BOOST_CHECK_EQUAL(GC::sign_pattern(whole({0, 0}), FT(-5), FT(7)), Sign::zero);
  CHECK_ERROR(GC::sign_pattern(square, half, half), empty_domain);
  CHECK_ERROR(GC::sign_pattern(square, half, quarter), empty_domain);
}

BOOST_AUTO_TEST_CASE(signs_of_high_multiplicities, *boost::unit_test::enable_if<exact && cancels>()) {
  const FT third = ratio(1, 3), tiny = power(ratio(1, 10), 30);
  const Polynomial t = root(FT(0)), s = constant(FT(0)) - root(FT(1)), r = root(third), e = constant(tiny);
  const Polynomial irrational = t * t - constant(ratio(1, 2)),
                   shifted = (t + constant(ratio(-1, 2))) * s; // no double root
  const std::pair<Polynomial, Sign> cases[] = {
      {repeated(r, 8), Sign::nonnegative},
      {repeated(r, 7), Sign::mixed},
      {repeated(r, 8) + e, Sign::positive},
      {repeated(r, 8) - e, Sign::mixed},
      {repeated(t, 3) * repeated(s, 2), Sign::nonnegative},
      {repeated(t, 3) * repeated(s, 2) * repeated(r, 4), Sign::nonnegative},
      {repeated(t, 3) * repeated(s, 2) * repeated(r, 3), Sign::mixed},
      {repeated(irrational, 4), Sign::nonnegative},
      {repeated(irrational, 3), Sign::mixed},
      {repeated(irrational, 2) * repeated(r, 2), Sign::nonnegative},
      {repeated(irrational, 2) * r, Sign::mixed},
      {repeated(irrational, 2) * (r * r + e), Sign::nonnegative},
      {(irrational * irrational + e) * (r * r + e), Sign::positive},
      {r * root(FT(third + tiny)), Sign::mixed},
      {repeated(r, 2) * repeated(root(FT(third + tiny)), 2), Sign::nonnegative},
      {t + e, Sign::positive},
      {t - e, Sign::mixed},
      {s + e, Sign::positive},
      {s - e, Sign::mixed},
      {t * t - e * t, Sign::mixed},
      {repeated(t + e, 2) * repeated(s + e, 2), Sign::positive},
      {shifted, Sign::mixed},
  };
  for (const std::pair<Polynomial, Sign>& c : cases) BOOST_TEST_CONTEXT("polynomial " << &c - cases) {
      BOOST_CHECK_EQUAL(GC::sign_pattern(c.first), c.second);
      BOOST_CHECK_EQUAL(GC::sign_pattern(c.first.elevated(2)), c.second);
    }
}

// Products of powers of linear factors and positive quadratic ones have a known pattern.
BOOST_AUTO_TEST_CASE(signs_of_random_products, *boost::unit_test::enable_if<exact && cancels>()) {
  repeat([](Random& random) {
    Polynomial p = constant(FT(random.integer(0, 1) == 0 ? 1 : -1));
    bool touches = false, crosses = false;
    for (int factors = random.integer(1, 3); factors > 0; --factors) {
      // root at place/6
      const int place = random.integer(-3, 9), multiplicity = random.integer(1, 3);
      p = p * repeated(root(ratio(place, 6)), multiplicity);
      touches = touches || (0 <= place && place <= 6);
    }
    const Polynomial linear = root(ratio(random.integer(0, 5), 5));
    p = p * (linear * linear + constant(ratio(1, random.integer(1, 99))));
    // the sign between possible roots
    int positive = 0;
    for (int i = 0; i < 6; ++i)
      if (FT(0) < explicit_value(p, ratio(2 * i + 1, 12))) ++positive;
    crosses = positive != 0 && positive != 6;
    const Sign expected = crosses         ? Sign::mixed
                          : positive == 6 ? (touches ? Sign::nonnegative : Sign::positive)
                                          : (touches ? Sign::nonpositive : Sign::negative);
    BOOST_CHECK_EQUAL(GC::sign_pattern(p), expected);
  });
}

BOOST_AUTO_TEST_CASE(signs_of_undefined_numbers) {
  if constexpr (std::is_floating_point_v<FT>) {
    const FT infinity = std::numeric_limits<FT>::infinity(), undefined = std::numeric_limits<FT>::quiet_NaN();
    CHECK_ERROR(GC::sign_pattern(Polynomial{FT(1), infinity}), not_finite);
    CHECK_ERROR(GC::sign_pattern(Polynomial{undefined, FT(1)}), not_finite);
    CHECK_ERROR(GC::sign_pattern(whole({1, 2}), FT(0), infinity), not_finite);
    CHECK_ERROR(GC::sign_pattern(whole({1, 2}), FT(0), undefined), empty_domain);
  }
}

BOOST_AUTO_TEST_CASE(names) {
  BOOST_CHECK_EQUAL(text(Sign::positive, Sign::negative, Sign::nonnegative, Sign::nonpositive, Sign::mixed, Sign::zero),
                    "positivenegativenonnegativenonpositivemixedzero");
  const std::pair<GC::Error_code, const char*> codes[] = {
      {GC::Error_code::zero_tangent, "zero_tangent"},
      {GC::Error_code::nonpositive_beta, "nonpositive_beta"},
      {GC::Error_code::singular_frame, "singular_frame"},
      {GC::Error_code::knot_multiplicity, "knot_multiplicity"},
      {GC::Error_code::parameter_outside_domain, "parameter_outside_domain"},
      {GC::Error_code::empty_domain, "empty_domain"},
      {GC::Error_code::wrong_number_of_points, "wrong_number_of_points"},
      {GC::Error_code::dimension_mismatch, "dimension_mismatch"},
      {GC::Error_code::jet_order_too_low, "jet_order_too_low"},
      {GC::Error_code::not_finite, "not_finite"},
      {GC::Error_code::malformed_input, "malformed_input"}};
  for (const std::pair<GC::Error_code, const char*>& c : codes) {
    BOOST_CHECK_EQUAL(GC::to_string(c.first), c.second);
    BOOST_CHECK_EQUAL(GC::Error(c.first, "here").what(), std::string(c.second) + ": here");
  }
}

// --------------------------------------------------------- determinants, Bell polynomials, vectors

typedef std::vector<std::vector<FT>> Matrix;

inline FT cofactor_expansion(const Matrix& a) {
  if (a.empty()) return FT(1);
  FT sum(0);
  for (std::size_t j = 0; j < a.size(); ++j) {
    Matrix minor(a.begin() + 1, a.end());
    for (std::vector<FT>& row : minor) row.erase(row.begin() + j);
    const FT term = a[0][j] * cofactor_expansion(minor);
    sum += j % 2 == 0 ? term : FT(-term);
  }
  return sum;
}

inline FT determinant(const Matrix& a) {
  return GC::determinant<FT>(static_cast<int>(a.size()), [&](int i, int j) -> const FT& { return a[i][j]; });
}

BOOST_AUTO_TEST_CASE(determinants) {
  repeat([](Random& random) {
    for (int n = 0; n <= 6; ++n) {
      Matrix a(n, std::vector<FT>(n, FT(0)));
      for (std::vector<FT>& row : a)
        for (FT& x : row) x = FT(random.integer(-9, 9));
      const FT value = determinant(a);
      BOOST_CHECK(value == cofactor_expansion(a));
      if (n < 2) continue;
      const int i = random.integer(0, n - 2);
      std::swap(a[i], a[i + 1]);
      BOOST_CHECK(determinant(a) == FT(-value));
      a[i] = a[i + 1];
      BOOST_CHECK(determinant(a) == FT(0));
    }
  });
}

BOOST_AUTO_TEST_CASE(gram_determinants_of_vectors) {
  typedef GC::Coordinate_vector<FT, 0> Vector;
  BOOST_CHECK(GC::gram_determinant(std::vector<Vector>()) == FT(1));
  repeat([](Random& random) {
    for (int n = 1; n <= 5; ++n) {
      std::vector<Vector> v(n, Vector(n));
      Matrix a(n, std::vector<FT>(n, FT(0)));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) v[i][j] = a[i][j] = FT(random.integer(-3, 3));
      const FT volume = determinant(a);
      BOOST_CHECK(GC::gram_determinant(v) == FT(volume * volume));
      // n vectors in dimension n+1, of which the last coordinate is the sum of the others times 2
      std::vector<Vector> w(n, Vector(n + 1));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          w[i][j] = v[i][j];
          w[i][n] += FT(2) * v[i][j];
        }
      BOOST_CHECK(GC::gram_determinant(w) == FT(FT(1 + 4 * n) * volume * volume));
      v.back() = n == 1 ? Vector(n) : v[0] - FT(2) * v[n - 2];
      BOOST_CHECK(GC::gram_determinant(v) == FT(0));
    }
  });
}

BOOST_AUTO_TEST_CASE(bell_polynomials) {
  const std::vector<FT> x = {FT(2), FT(-3), FT(5), FT(7), FT(11)};
  GC::Bell_polynomials<FT> b;
  for (const FT& xj : x) b.append(xj);
  BOOST_CHECK(b(2, 2) == power(x[0], 2));
  BOOST_CHECK(b(3, 2) == FT(FT(3) * x[0] * x[1]));
  BOOST_CHECK(b(3, 3) == power(x[0], 3));
  BOOST_CHECK(b(4, 2) == FT(FT(4) * x[0] * x[2] + FT(3) * x[1] * x[1]));
  BOOST_CHECK(b(4, 3) == FT(FT(6) * x[0] * x[0] * x[1]));
  BOOST_CHECK(b(4, 4) == power(x[0], 4));
  BOOST_CHECK(b(5, 2) == FT(FT(5) * x[0] * x[3] + FT(10) * x[1] * x[2]));
  BOOST_CHECK(b(5, 3) == FT(FT(10) * x[0] * x[0] * x[2] + FT(15) * x[0] * x[1] * x[1]));
  BOOST_CHECK(b(6, 2) == FT(FT(6) * x[0] * x[4] + FT(15) * x[1] * x[3] + FT(10) * x[2] * x[2]));
  // Stirling numbers of the second kind, Lah numbers, Stirling numbers of the first kind
  GC::Bell_polynomials<FT> ones, factorials, shifted;
  FT factorial(1);
  for (int j = 1; j <= 6; ++j) {
    ones.append(FT(1));
    shifted.append(factorial);
    factorial *= FT(j);
    factorials.append(factorial);
  }
  const int stirling2[] = {63, 301, 350, 140, 21, 1}, lah[] = {15120, 12600, 4200, 630, 42, 1},
            stirling1[] = {1764, 1624, 735, 175, 21, 1};
  for (int m = 2; m <= 7; ++m) {
    BOOST_CHECK(ones(7, m) == FT(stirling2[m - 2]));
    BOOST_CHECK(factorials(7, m) == FT(lah[m - 2]));
    BOOST_CHECK(shifted(7, m) == FT(stirling1[m - 2]));
  }
}

template <int N> void check_coordinate_vector(int d) {
  typedef GC::Coordinate_vector<FT, N> Vector;
  Vector v(d), w(d);
  BOOST_CHECK_EQUAL(v.dimension(), d);
  BOOST_CHECK(is_zero(v) && v == w);
  for (int i = 0; i < d; ++i) {
    v[i] = FT(i + 1);
    w[i] = FT(8 - 2 * i);
  }
  BOOST_CHECK(!is_zero(v) && v != w);
  FT product(0);
  for (int i = 0; i < d; ++i) {
    BOOST_CHECK((v + w)[i] == FT(9 - i));
    BOOST_CHECK((v - w)[i] == FT(3 * i - 7));
    BOOST_CHECK((FT(3) * v)[i] == FT(3 * i + 3));
    BOOST_CHECK((w / FT(2))[i] == FT(4 - i));
    product += v[i] * w[i];
  }
  BOOST_CHECK(dot(v, w) == product);
  Vector e1(d), e2(d), u(d);
  e1[0] = FT(4);
  e2[1] = FT(2);
  u[0] = u[1] = u[d - 1] = FT(7);
  const Vector rest = orthogonal_component(u, e1);
  BOOST_CHECK(rest[0] == FT(0) && rest[1] == FT(7) && rest[d - 1] == FT(7));
  const Vector both = orthogonal_component(u, std::vector<Vector>{e1, e2});
  BOOST_CHECK(both[0] == FT(0) && both[1] == FT(0) && both[d - 1] == (d == 2 ? FT(0) : FT(7)));
  BOOST_CHECK(orthogonal_component(u, std::vector<Vector>()) == u);
  CHECK_ERROR(orthogonal_component(u, Vector(d)), zero_direction);
  if constexpr (N != 0) {
    CHECK_ERROR(Vector(N - 1), dimension_mismatch);
    CHECK_ERROR(Vector(N + 1), dimension_mismatch);
  } else {
    BOOST_CHECK_EQUAL(Vector().dimension(), 0);
    CHECK_ERROR(Vector(-1), negative_count);
    CHECK_ERROR(cross_product(Vector(2), Vector(3)), dimension_mismatch);
    BOOST_CHECK(Vector(2) != Vector(3));
  }
}

BOOST_AUTO_TEST_CASE(coordinate_vectors) {
  check_coordinate_vector<2>(2);
  check_coordinate_vector<3>(3);
  check_coordinate_vector<5>(5);
  check_coordinate_vector<0>(2);
  check_coordinate_vector<0>(4);
}

BOOST_AUTO_TEST_SUITE_END()
