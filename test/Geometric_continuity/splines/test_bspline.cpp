// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Knot vectors, spline functions and B-spline curves. In exact kernels all identities hold with ==. In rounded kernels the
// bounds are multiples of the unit roundoff u = 2^-53, times the largest coefficient:
//
// - A weight of a value or a blossom is made in p levels of a triangle, each with 6 roundings, where all terms are
//   nonnegative; the sum over p + 1 coefficients adds p + 2. So values and coefficients over finer knots are known to
//   value_roundings(p) = 7 p + 2.
// - Arguments of a blossom outside its span multiply the sum of the absolute weights by at most 2 s - 1 each, where s is the
//   number of spans between the arguments.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE bspline
#include <boost/test/unit_test.hpp>

#include "support/archetype.h"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/knot_continuity.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Q;
typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Simple_cartesian<double>, CGAL::Epeck, CGAL::Epick> Kernels;

template <class FT> constexpr bool exact_v = !std::is_floating_point_v<FT>;

template <class FT> using Knot = typename GC::Knot_vector<FT>::Knot;
template <class FT> using Function = GC::Bspline_function<FT>;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

// The text of the error that f() throws.
template <class F> std::string error_of(F f) {
  try {
    f();
  } catch (const GC::Error& error) {
    return error.what();
  }
  return "no error";
}

// ---------------------------------------------------------------- random input

template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }

// Set GEOMETRIC_CONTINUITY_SEED to try other numbers.
unsigned first_seed() {
  const char* text = std::getenv("GEOMETRIC_CONTINUITY_SEED");
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 2026;
}

struct Report_seed {
  Report_seed() { std::cout << "random seed " << first_seed() << std::endl; }
};
BOOST_TEST_GLOBAL_FIXTURE(Report_seed);

template <class FT> class Random {
  std::mt19937 engine_{first_seed()};

public:
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  bool coin() { return integer(0, 1) == 1; }

  // at most 9 in absolute value; in floating point with few digits
  FT number() { return ratio<FT>(integer(-999, 999), exact_v<FT> ? integer(111, 999) : 128); }
  std::vector<FT> numbers(int n) {
    std::vector<FT> x;
    for (int i = 0; i < n; ++i) x.push_back(number());
    return x;
  }
  // In [a, b]; in floating point as well.
  FT between(const FT& a, const FT& b) {
    const FT u = a + (b - a) * ratio<FT>(integer(0, 1024), 1024);
    return u < a ? a : b < u ? b : u;
  }
  // The lengths of neighbouring spans differ by factors up to 10^6.
  FT length() { return coin() ? ratio<FT>(integer(1, 9), 4) : ratio<FT>(integer(1, 9), 4000000); }

  // Of degree p: inner knots of multiplicity 1 to `highest`; sometimes not clamped, when that is allowed.
  GC::Knot_vector<FT> knots(int p, int highest, bool may_be_unclamped = true) {
    const FT a = ratio<FT>(integer(-9, 9), 4);
    FT b = a;
    std::vector<Knot<FT>> inner;
    for (int i = integer(0, 3); i >= 0; --i) {
      b += length();
      if (i > 0) inner.push_back({b, integer(1, highest)});
    }
    const GC::Knot_vector<FT> clamped(p, a, b, inner);
    if (!may_be_unclamped || p == 0 || coin()) return clamped;
    std::vector<FT> u(clamped.begin(), clamped.end()); // the knots outside move outwards
    FT left = a, right = b;
    for (int i = 1; i <= p; ++i) {
      if (coin()) left -= ratio<FT>(integer(1, 9), 4);
      if (coin()) right += ratio<FT>(integer(1, 9), 4);
      u[p - i] = left;
      u[u.size() - 1 - p + i] = right;
    }
    return GC::Knot_vector<FT>(p, u);
  }
  Function<FT> function(const GC::Knot_vector<FT>& knots) {
    return Function<FT>(knots, numbers(knots.number_of_coefficients()));
  }
  template <class Traits> GC::Bspline_curve<Traits> curve(const GC::Knot_vector<FT>& knots, int d) {
    std::vector<typename Traits::Point> points;
    for (int i = 0; i < knots.number_of_coefficients(); ++i) {
      const std::vector<FT> x = numbers(d);
      points.push_back(Traits().construct_point_object()(d, x.begin(), x.end()));
    }
    return GC::Bspline_curve<Traits>(points.begin(), points.end(), knots);
  }
};

// test(random) a number of times
template <class FT, class Test> void repeat(int times, Test test) {
  Random<FT> random;
  for (int i = 0; i < times; ++i) BOOST_TEST_CONTEXT("seed " << first_seed() << ", round " << i) test(random);
}

// Parameters of the domain: the ends, the knots, and some between.
template <class FT> std::vector<FT> parameters(const GC::Knot_vector<FT>& knots, Random<FT>& random) {
  std::vector<FT> u;
  for (int k : knots.spans()) {
    u.push_back(knots[k]);
    u.push_back(random.between(knots[k], knots[k + 1]));
  }
  u.push_back(knots.domain().second);
  return u;
}

// ---------------------------------------------------------------- bounds and an independent definition

constexpr int value_roundings(int p) { return 7 * p + 2; }

// Equality; in floating point up to so many roundings of numbers of at most `scale`.
template <class FT> bool close(const FT& x, const FT& y, const FT& scale, double roundings) {
  if constexpr (exact_v<FT>)
    return x == y;
  else
    return std::abs(x - y) <= roundings * 0x1p-53 * scale;
}

template <class FT> FT largest(const std::vector<FT>& x) {
  FT m(0);
  for (const FT& xi : x) m = m < xi ? xi : m < -xi ? FT(-xi) : m;
  return m;
}

// N_i^p(u) by the recursion of Cox, de Boor and Mansfield. On the intervals [u_i, u_{i+1}), or (u_i, u_{i+1}] from the left.
template <class FT> FT basis_by_recursion(const GC::Knot_vector<FT>& u, int i, int p, const FT& t, bool from_left) {
  if (p == 0) return FT((from_left ? u[i] < t && !(u[i + 1] < t) : !(t < u[i]) && t < u[i + 1]) ? 1 : 0);
  FT sum(0);
  if (u[i] < u[i + p]) sum += FT((t - u[i]) / (u[i + p] - u[i])) * basis_by_recursion(u, i, p - 1, t, from_left);
  if (u[i + 1] < u[i + p + 1])
    sum += FT((u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1])) * basis_by_recursion(u, i + 1, p - 1, t, from_left);
  return sum;
}

template <class FT> FT value_by_recursion(const Function<FT>& f, const FT& t, bool from_left) {
  FT sum(0);
  for (int i = 0; i < f.knots().number_of_coefficients(); ++i)
    sum += f[i] * basis_by_recursion(f.knots(), i, f.degree(), t, from_left);
  return sum;
}

// The values from both sides, where there are both.
template <class FT> FT left_value(const Function<FT>& f, const FT& u) { return f.left_derivatives(u, 0)[0]; }

// The same function: at p + 1 parameters in each span, and from both sides at its ends.
template <class FT> void check_same(const Function<FT>& f, const Function<FT>& g, double roundings) {
  const FT scale = largest(f.coefficients());
  BOOST_REQUIRE(f.knots().has_domain_of(g.knots()));
  const GC::Knot_vector<FT> all = merge(f.knots().bezier(0), g.knots().bezier(0));
  for (int k : all.spans()) {
    const FT &a = all[k], &b = all[k + 1];
    BOOST_CHECK(close<FT>(f(a), g(a), scale, roundings));
    BOOST_CHECK(close<FT>(left_value(f, b), left_value(g, b), scale, roundings));
    for (int i = 1; i <= f.degree(); ++i) {
      const FT u = a + (b - a) * ratio<FT>(i, f.degree() + 1);
      if (a < u && u < b) BOOST_CHECK(close<FT>(f(u), g(u), scale, roundings));
    }
  }
}

// ---------------------------------------------------------------- knot vectors

BOOST_AUTO_TEST_CASE_TEMPLATE(knot_vectors, K, Kernels) {
  typedef typename K::FT FT;
  typedef GC::Knot_vector<FT> Knots;
  const Knots u(2, {FT(-1), FT(0), FT(0), FT(1), FT(1), FT(4), FT(6), FT(7)});
  BOOST_CHECK_EQUAL(u.degree(), 2);
  BOOST_CHECK_EQUAL(u.size(), 8);
  BOOST_CHECK_EQUAL(u.number_of_coefficients(), 5);
  BOOST_CHECK(u.domain() == std::make_pair(FT(0), FT(4)));
  BOOST_CHECK(!u.is_clamped());
  BOOST_CHECK((u.spans() == std::vector<int>{2, 4}));
  for (int i = -1; i <= 8; ++i)
    BOOST_CHECK_EQUAL(u.multiplicity(FT(i)), (i == 0 || i == 1) ? 2 : (i == -1 || i == 4 || i == 6 || i == 7) ? 1 : 0);
  BOOST_REQUIRE_EQUAL(u.distinct_knots().size(), 3u);
  BOOST_CHECK(u.distinct_knots()[0].value == FT(0) && u.distinct_knots()[0].multiplicity == 2);
  BOOST_CHECK(u.distinct_knots()[2].value == FT(4) && u.distinct_knots()[2].multiplicity == 1);
  BOOST_REQUIRE_EQUAL(u.inner_knots().size(), 1u);
  BOOST_CHECK(u.inner_knots()[0].value == FT(1) && u.inner_knots()[0].multiplicity == 2);

  // right-continuous, the right end closed
  BOOST_CHECK_EQUAL(u.span(FT(0)), 2);
  BOOST_CHECK_EQUAL(u.span(ratio<FT>(1, 2)), 2);
  BOOST_CHECK_EQUAL(u.span(FT(1)), 4);
  BOOST_CHECK_EQUAL(u.span(FT(4)), 4);
  BOOST_CHECK_EQUAL(u.left_span(FT(0)), 2);
  BOOST_CHECK_EQUAL(u.left_span(FT(1)), 2);
  BOOST_CHECK_EQUAL(u.left_span(ratio<FT>(3, 2)), 4);
  BOOST_CHECK_EQUAL(u.left_span(FT(4)), 4);
  for (const FT& outside : {FT(-1), ratio<FT>(-1, 1000), ratio<FT>(4001, 1000), FT(7)}) {
    BOOST_CHECK(!u.contains(outside));
    CHECK_ERROR(u.span(outside), parameter_outside_domain);
    CHECK_ERROR(u.left_span(outside), parameter_outside_domain);
    CHECK_ERROR(u.insert(outside), parameter_outside_domain);
  }

  BOOST_CHECK(u.greville_abscissa(0) == FT(0));
  BOOST_CHECK(u.greville_abscissa(1) == ratio<FT>(1, 2));
  BOOST_CHECK(u.greville_abscissa(4) == FT(5));
  BOOST_CHECK(Knots(0, {FT(0), FT(1), FT(4)}).greville_abscissa(1) == ratio<FT>(5, 2));

  BOOST_CHECK(u.insert(FT(1)) == Knots(2, {FT(-1), FT(0), FT(0), FT(1), FT(1), FT(1), FT(4), FT(6), FT(7)}));
  BOOST_CHECK(u.insert(FT(3), 2).inner_knots()[1].multiplicity == 2);
  BOOST_CHECK(u.insert(FT(3), 0) == u);
  BOOST_CHECK(u.insert(FT(0)).domain() == u.domain());
  BOOST_CHECK(u.insert(FT(4), 2).domain() == u.domain());
  CHECK_ERROR(u.insert(FT(1), 2), knot_multiplicity);
  BOOST_CHECK(u.insert(FT(3), 2).remove(FT(3), 2) == u);
  BOOST_CHECK(u.insert(FT(3), 2).remove(FT(3)) == u.insert(FT(3)));
  CHECK_ERROR(u.remove(FT(3)), knot_multiplicity);
  CHECK_ERROR(u.remove(FT(0)), knot_multiplicity);
  BOOST_CHECK(u.with_inner_knots({}) == Knots(2, {FT(-1), FT(0), FT(0), FT(4), FT(6), FT(7)}));
  const Knots clamped(2, {FT(0), FT(0), FT(0), FT(1), FT(1), FT(4), FT(4), FT(4)});
  BOOST_CHECK(u.clamp() == clamped);
  BOOST_CHECK(clamped.is_clamped());
  BOOST_CHECK(Knots(2, FT(0), FT(4), {{FT(1), 2}}) == clamped);
  BOOST_CHECK(u.bezier(1) == Knots(1, {FT(0), FT(0), FT(1), FT(1), FT(4), FT(4)}));
  BOOST_CHECK(merge(u, Knots(2, FT(0), FT(4), {{FT(1), 1}, {FT(2), 3}})) ==
              Knots(2, FT(0), FT(4), {{FT(1), 2}, {FT(2), 3}}));
  CHECK_ERROR(merge(u, Knots(2, FT(0), FT(5))), parameter_outside_domain);
  CHECK_ERROR(merge(u, Knots(3, FT(0), FT(4))), wrong_number_of_points);
  BOOST_CHECK(u.reverse() == Knots(2, {FT(-3), FT(-2), FT(0), FT(3), FT(3), FT(4), FT(4), FT(5)}));
  BOOST_CHECK(u.reverse().reverse() == u);
  BOOST_CHECK(u != clamped);
  BOOST_CHECK(Knots(1, FT(0), FT(1)) != Knots(0, {FT(0), FT(1)}));
  std::ostringstream os;
  os << clamped;
  BOOST_CHECK_EQUAL(os.str(), "0 0 0 1 1 4 4 4");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(refused_knot_vectors, K, Kernels) {
  typedef typename K::FT FT;
  const auto error = [](int p, std::initializer_list<int> knots) {
    return error_of([&] { GC::Knot_vector<FT>(p, std::vector<FT>(knots.begin(), knots.end())); });
  };
  BOOST_CHECK_EQUAL(error(-1, {0, 1, 2}), "wrong_number_of_points: Knot_vector: degree -1");
  BOOST_CHECK_EQUAL(error(2, {0, 0, 0, 1, 1}), "wrong_number_of_points: Knot_vector: 5 knots are too few for degree 2");
  BOOST_CHECK_EQUAL(error(0, {}), "wrong_number_of_points: Knot_vector: 0 knots are too few for degree 0");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 2, 1, 3, 3}), "empty_domain: Knot_vector: knot 3 is less than the one before it");
  BOOST_CHECK_EQUAL(error(1, {0, 1, 1, 2}), "empty_domain: Knot_vector: the ends of the domain are equal");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 1, 1, 1, 2, 2}),
                    "knot_multiplicity: Knot_vector: knot 4 is repeated more than 2 times");
  BOOST_CHECK_EQUAL(error(0, {0, 1, 1, 2}), "knot_multiplicity: Knot_vector: knot 2 is repeated more than 1 times");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 0, 1, 1}), "knot_multiplicity: Knot_vector: knot 2 is repeated more than 2 times");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 1, 1, 2, 2}), "no error");
  CHECK_ERROR(GC::Knot_vector<FT>(-2, FT(0), FT(1)), wrong_number_of_points);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(1), FT(1)), empty_domain);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(5), 1}}), empty_domain);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(1), 4}}), knot_multiplicity);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(1), -1}}), knot_multiplicity);
  if constexpr (!exact_v<FT>) {
    const FT infinity = std::numeric_limits<FT>::infinity(), nan = std::numeric_limits<FT>::quiet_NaN();
    CHECK_ERROR((GC::Knot_vector<FT>(1, {0, 0, 1, infinity})), not_finite);
    CHECK_ERROR((GC::Knot_vector<FT>(1, {0, nan, 1, 1})), not_finite);
    BOOST_CHECK(!GC::Knot_vector<FT>(1, 0, 1).contains(nan));
    CHECK_ERROR(GC::Knot_vector<FT>(1, 0, 1).span(nan), parameter_outside_domain);
  }
}

// ---------------------------------------------------------------- values, blossoms, derivatives

BOOST_AUTO_TEST_CASE_TEMPLATE(basis_and_values_are_those_of_the_recursion, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(40, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    const FT scale = largest(f.coefficients()), end = f.domain().second;
    for (const FT& u : parameters(f.knots(), random)) {
      const std::vector<FT> basis = bspline_basis(f.knots(), u);
      FT sum(0);
      for (int i = 0; i < f.knots().number_of_coefficients(); ++i) {
        // both are made of nonnegative terms
        BOOST_CHECK(close<FT>(basis[i], basis_by_recursion(f.knots(), i, p, u, u == end), FT(1), 12 * p));
        BOOST_CHECK(!(basis[i] < FT(0)));
        sum += basis[i];
      }
      BOOST_CHECK(close<FT>(sum, FT(1), FT(1), value_roundings(p)));
      BOOST_CHECK(close<FT>(f(u), value_by_recursion(f, u, u == end), scale, 2 * value_roundings(p)));
      BOOST_CHECK(
          close<FT>(left_value(f, u), value_by_recursion(f, u, u != f.domain().first), scale, 2 * value_roundings(p)));
    }
    CHECK_ERROR(f(FT(f.domain().first - FT(1))), parameter_outside_domain);
    CHECK_ERROR(f.left_derivatives(FT(end + FT(1)), 0), parameter_outside_domain);
  });
}

// (u - y)^p = sum_i (u_{i+1} - y) ... (u_{i+p} - y) N_i(u)
BOOST_AUTO_TEST_CASE_TEMPLATE(marsden_identity, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(30, [](Random<FT>& random) {
    const int p = random.integer(0, 5);
    const GC::Knot_vector<FT> knots = random.knots(p, p + 1);
    const FT y = random.number();
    std::vector<FT> c;
    for (int i = 0; i < knots.number_of_coefficients(); ++i) {
      FT product(1);
      for (int j = 1; j <= p; ++j) product *= knots[i + j] - y;
      c.push_back(product);
    }
    for (const FT& u : parameters(knots, random)) {
      FT power(1);
      for (int j = 0; j < p; ++j) power *= u - y;
      BOOST_CHECK(close<FT>(bspline_value(knots, c, u), power, largest(c), value_roundings(p) + 6 * p));
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(greville_abscissae_reproduce_the_parameter, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(20, [](Random<FT>& random) {
    const int p = random.integer(1, 5);
    const GC::Knot_vector<FT> knots = random.knots(p, p + 1);
    std::vector<FT> c;
    for (int i = 0; i < knots.number_of_coefficients(); ++i) c.push_back(knots.greville_abscissa(i));
    for (const FT& u : parameters(knots, random))
      BOOST_CHECK(close<FT>(bspline_value(knots, c, u), u, largest(c), value_roundings(p) + p));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(blossoms, K, Kernels) {
  typedef typename K::FT FT;
  if constexpr (exact_v<FT>)
    repeat<FT>(30, [](Random<FT>& random) {
      const int p = random.integer(1, 4);
      const Function<FT> f = random.function(random.knots(p, p + 1));
      for (int k : f.knots().spans()) {
        const auto blossom = [&](const std::vector<FT>& t) {
          return bspline_blossom(f.knots(), f.coefficients(), k, t);
        };
        // knots of the neighbourhood and other arguments, anywhere, in any order
        std::vector<FT> t;
        for (int i = 0; i < p; ++i)
          t.push_back(random.coin() ? f.knots()[k + random.integer(1 - p, p)] : random.number());
        const FT x = random.number(), y = random.coin() ? f.knots()[k] : random.number(), s = random.number();
        const FT value = blossom(t);
        std::reverse(t.begin(), t.end());
        BOOST_CHECK(blossom(t) == value);
        std::swap(t[0], t[random.integer(0, p - 1)]);
        BOOST_CHECK(blossom(t) == value);
        t[0] = x;
        const FT at_x = blossom(t);
        t[0] = y;
        const FT at_y = blossom(t);
        t[0] = (FT(1) - s) * x + s * y;
        BOOST_CHECK(blossom(t) == FT((FT(1) - s) * at_x + s * at_y));
        // the diagonal is the polynomial
        const FT u = random.between(f.knots()[k], f.knots()[k + 1]);
        BOOST_CHECK(u == f.knots()[k + 1] || blossom(std::vector<FT>(p, u)) == f(u));
        for (int i = k - p; i <= k; ++i)
          BOOST_CHECK(blossom({f.knots().begin() + i + 1, f.knots().begin() + i + p + 1}) == f[i]);
      }
      CHECK_ERROR(bspline_blossom(f.knots(), f.coefficients(), f.knots().spans()[0], std::vector<FT>(p + 1, FT(0))),
                  wrong_number_of_points);
    });
  else
    repeat<FT>(30, [](Random<FT>& random) { // arguments within the span
      const int p = random.integer(1, 5);
      const Function<FT> f = random.function(random.knots(p, p + 1));
      for (int k : f.knots().spans()) {
        std::vector<FT> t;
        for (int i = 0; i < p; ++i) t.push_back(random.between(f.knots()[k], f.knots()[k + 1]));
        std::vector<Q> u(f.knots().begin(), f.knots().end()), c(f.coefficients().begin(), f.coefficients().end());
        const Q exact = bspline_blossom(GC::Knot_vector<Q>(p, u), c, k, std::vector<Q>(t.begin(), t.end()));
        const double computed = bspline_blossom(f.knots(), f.coefficients(), k, t);
        BOOST_CHECK(close<Q>(Q(computed), exact, Q(0), 0) ||
                    std::abs(CGAL::to_double(Q(Q(computed) - exact))) <=
                        value_roundings(p) * 0x1p-53 * largest(f.coefficients()));
      }
    });
}

// What a sum of at most p + 1 terms can lose in the j-th derivative: the quotients are at most 2 p / h for the shortest
// difference h of knots, so that the j-th derivative of coefficients up to 1 is at most (2 p / h)^j.
template <class FT> FT derivative_scale(const Function<FT>& f, int j) {
  FT h = f.domain().second - f.domain().first;
  for (int k : f.knots().spans()) h = std::min(h, FT(f.knots()[k + 1] - f.knots()[k]));
  FT scale = largest(f.coefficients());
  for (; j > 0; --j) scale *= FT(2 * f.degree()) / h;
  return scale;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(30, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    Function<FT> d = f;
    for (int j = 0; j <= p + 1; ++j) {
      const FT scale = derivative_scale(f, j);
      for (const FT& u : parameters(f.knots(), random)) {
        const std::vector<FT> right = f.right_derivatives(u, p + 2), left = f.left_derivatives(u, j);
        BOOST_CHECK_EQUAL(right.size(), p + 3u);
        BOOST_CHECK(close<FT>(right[j], d(u), scale, 20 * p));
        BOOST_CHECK(close<FT>(left[j], left_value(d, u), scale, 20 * p));
        if (j > p) BOOST_CHECK(right[j] == FT(0));
      }
      BOOST_CHECK_EQUAL(d.degree(), std::max(0, p - j));
      d = d.derivative();
      BOOST_CHECK(d.knots().has_domain_of(f.knots()));
    }
  });
  // the derivative by its definition, as a limit of rational functions of the step: for a quadratic it is the mean of two
  // difference quotients
  const Function<FT> f(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}}), {FT(1), FT(3), FT(-1), FT(5)});
  BOOST_CHECK(f.derivative()(FT(1)) == FT((f(FT(2)) - f(FT(0))) / FT(2)));
  BOOST_CHECK(f.derivative().knots() == GC::Knot_vector<FT>(1, FT(0), FT(4), {{FT(2), 1}}));
  // where the function may jump, one of the knots is superfluous in the derivative
  const Function<FT> jump(GC::Knot_vector<FT>(1, FT(0), FT(4), {{FT(2), 2}}), {FT(0), FT(2), FT(7), FT(3)});
  BOOST_CHECK(jump.derivative() ==
              Function<FT>(GC::Knot_vector<FT>(0, {FT(0), FT(2), FT(4)}), std::vector<FT>{FT(1), FT(-2)}));
}

// ---------------------------------------------------------------- other knots

BOOST_AUTO_TEST_CASE_TEMPLATE(insertion, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(40, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    for (const FT& u : parameters(f.knots(), random)) {
      const int m = f.knots().multiplicity(u), n = f.knots().number_of_coefficients();
      CHECK_ERROR(f.insert(u, p + 2 - m), knot_multiplicity);
      for (int times = 0; times <= p + 1 - m; ++times) {
        const Function<FT> g = f.insert(u, times);
        BOOST_CHECK_EQUAL(g.knots().multiplicity(u), m + times);
        BOOST_CHECK_EQUAL(g.knots().number_of_coefficients(), n + times);
        check_same(f, g, 2 * value_roundings(p));
      }
      if (m > p) continue;
      // Boehm's formula
      const Function<FT> g = f.insert(u);
      for (int i = 0; i <= n; ++i) {
        const FT &low = f.knots()[i], &high = f.knots()[i + p];
        if (!(low < u))
          BOOST_CHECK(g[i] == f[std::max(i - 1, 0)]);
        else if (!(u < high))
          BOOST_CHECK(g[i] == f[std::min(i, n - 1)]);
        else {
          const FT a = (u - low) / (high - low);
          BOOST_CHECK(close<FT>(g[i], FT((FT(1) - a) * f[i - 1] + a * f[i]), largest(f.coefficients()), 12));
        }
      }
    }
    CHECK_ERROR(f.insert(FT(f.domain().second + FT(1))), parameter_outside_domain);
  });
}

// More copies of knots, and new knots.
template <class FT> GC::Knot_vector<FT> finer(GC::Knot_vector<FT> knots, Random<FT>& random) {
  for (const FT& u : parameters(knots, random))
    knots = knots.insert(u, random.integer(0, knots.degree() + 1 - knots.multiplicity(u)));
  return knots;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(refinement, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(40, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    const GC::Knot_vector<FT> knots = finer(f.knots(), random);
    const Function<FT> g = f.refine(knots), clamped = f.refine(knots.clamp());
    BOOST_CHECK(g.knots() == knots);
    check_same(f, g, 2 * value_roundings(p));
    check_same(f, clamped, 2 * value_roundings(p));
    BOOST_CHECK(f.clamp().knots() == f.knots().clamp());
    check_same(f, f.clamp(), 2 * value_roundings(p));
    BOOST_CHECK(f.refine(f.knots()) == f);
    if constexpr (exact_v<FT>) { // knot by knot
      Function<FT> h = f;
      for (const Knot<FT>& knot : knots.distinct_knots())
        h = h.insert(knot.value, knot.multiplicity - h.knots().multiplicity(knot.value));
      BOOST_CHECK(h == g);
    } else // convex combinations do not leave the range of the coefficients, up to their roundings
      BOOST_CHECK(largest(g.coefficients()) <= largest(f.coefficients()) * (1 + value_roundings(p) * 0x1p-53));
    CHECK_ERROR(f.refine(elevated_knots(f.knots())), wrong_number_of_points);
    CHECK_ERROR(f.refine(GC::Knot_vector<FT>(p, f.domain().first, FT(f.domain().second + FT(1)))),
                parameter_outside_domain);
    if (!f.knots().inner_knots().empty())
      CHECK_ERROR(f.refine(GC::Knot_vector<FT>(p, f.domain().first, f.domain().second)), knot_multiplicity);
  });
  // knots outside the domain are no refinement
  const GC::Knot_vector<FT> u(1, {FT(0), FT(1), FT(2), FT(3)});
  const Function<FT> f(u, std::vector<FT>{FT(5), FT(7)});
  CHECK_ERROR(f.refine(GC::Knot_vector<FT>(1, {FT(-1), FT(1), FT(2), FT(3)})), knot_multiplicity);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(removal, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(40, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    // random coefficients need all their knots
    for (const Knot<FT>& knot : f.knots().inner_knots()) {
      BOOST_CHECK(!f.remove(knot.value));
      BOOST_CHECK(f.remove(knot.value, 0) == f);
      BOOST_CHECK(!f.remove(knot.value, knot.multiplicity + 1));
      BOOST_CHECK_EQUAL(f.smoothness(knot.value), p - knot.multiplicity);
    }
    BOOST_CHECK(f.remove_superfluous_knots() == f);
    for (const FT& end : {f.domain().first, f.domain().second}) {
      CHECK_ERROR(f.remove(end), parameter_outside_domain);
      CHECK_ERROR(f.smoothness(end), parameter_outside_domain);
    }
    if constexpr (exact_v<FT>) {
      const Function<FT> g = f.refine(finer(f.knots(), random).clamp());
      BOOST_CHECK(g.remove_superfluous_knots() == f.clamp());
      Function<FT> h = g;
      for (const Knot<FT>& knot : g.knots().inner_knots()) {
        const int more = knot.multiplicity - f.knots().multiplicity(knot.value);
        BOOST_CHECK_EQUAL(g.smoothness(knot.value), p - f.knots().multiplicity(knot.value));
        BOOST_CHECK(!h.remove(knot.value, more + 1));
        for (int i = 0; i < more; ++i) {
          BOOST_REQUIRE(h.remove(knot.value));
          h = *h.remove(knot.value);
        }
      }
      BOOST_CHECK(h == f.clamp());
    }
  });
  // whole numbers, where the arithmetic of floating point is exact
  const Function<FT> f(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}}), {FT(0), FT(4), FT(8), FT(2)});
  BOOST_CHECK(f.insert(FT(2)).remove(FT(2)) == f);
  BOOST_CHECK(f.insert(FT(1)).insert(FT(2), 2).remove_superfluous_knots() == f);
  BOOST_CHECK(!f.remove(FT(2)));
  const Function<FT> line(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 2}}), {FT(0), FT(1), FT(2), FT(3), FT(4)});
  BOOST_CHECK_EQUAL(line.smoothness(FT(2)), 2);
  BOOST_CHECK_EQUAL(line.smoothness(FT(3)), 2);
  BOOST_CHECK(line.remove(FT(2), 2) ==
              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(4)), std::vector<FT>{FT(0), FT(2), FT(4)}));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bezier_pieces_and_back, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(40, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    const std::vector<FT> pieces = bspline_bezier(f.knots(), f.coefficients());
    const std::vector<int> spans = f.knots().spans();
    BOOST_REQUIRE_EQUAL(pieces.size(), spans.size() * (p + 1));
    for (std::size_t s = 0; s < spans.size(); ++s) {
      const FT &a = f.knots()[spans[s]], &b = f.knots()[spans[s] + 1];
      const GC::Bernstein_polynomial<FT> piece(pieces.begin() + s * (p + 1), pieces.begin() + (s + 1) * (p + 1));
      for (int i = 0; i <= p; ++i) {
        const FT u = a + (b - a) * ratio<FT>(i, p + 1), t = (u - a) / (b - a);
        if (u < b) BOOST_CHECK(close<FT>(piece(t), f(u), largest(f.coefficients()), 3 * value_roundings(p) + 8 * p));
      }
    }
    const std::vector<FT> back = bspline_from_bezier(f.knots(), pieces);
    // at most p arguments outside a span, and p spans; knots far outside the domain make extrapolations of the coefficients
    const double roundings = 2 * value_roundings(p) * std::pow(2 * p + 1, p);
    if (exact_v<FT> || f.knots().is_clamped())
      for (std::size_t i = 0; i < back.size(); ++i)
        BOOST_CHECK(close<FT>(back[i], f[static_cast<int>(i)], largest(f.coefficients()), roundings));
    if (exact_v<FT> || f.knots().is_clamped()) check_same(f, Function<FT>(f.knots(), back), roundings);
    CHECK_ERROR(bspline_from_bezier(f.knots(), std::vector<FT>(pieces.size() + 1, FT(0))), wrong_number_of_points);
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(coefficients_must_fit_the_knots, K, Kernels) {
  typedef typename K::FT FT;
  const GC::Knot_vector<FT> knots(2, FT(0), FT(4), {{FT(2), 1}});
  for (int n : {0, 3, 5}) {
    const std::vector<FT> c(n, FT(1));
    CHECK_ERROR(Function<FT>(knots, c), wrong_number_of_points);
    CHECK_ERROR(bspline_value(knots, c, FT(1)), wrong_number_of_points);
    CHECK_ERROR(bspline_blossom(knots, c, 2, std::vector<FT>(2, FT(1))), wrong_number_of_points);
    CHECK_ERROR(bspline_derivative(knots, c), wrong_number_of_points);
    CHECK_ERROR(bspline_insert(knots, c, FT(1)), wrong_number_of_points);
    CHECK_ERROR(bspline_refine(knots, c, knots), wrong_number_of_points);
    CHECK_ERROR(bspline_bezier(knots, c), wrong_number_of_points);
    CHECK_ERROR(bspline_remove(knots, c, FT(2)), wrong_number_of_points);
    CHECK_ERROR(minimal_knots(knots, c), wrong_number_of_points);
    CHECK_ERROR(bspline_elevate(knots, c), wrong_number_of_points);
    CHECK_ERROR(bspline_product(knots, c, knots, std::vector<FT>(4, FT(1))), wrong_number_of_points);
    CHECK_ERROR(bspline_product(knots, std::vector<FT>(4, FT(1)), knots, c), wrong_number_of_points);
  }
  if constexpr (!exact_v<FT>)
    CHECK_ERROR(Function<FT>(knots, std::vector<FT>{0, 1, std::numeric_limits<FT>::infinity(), 0}), not_finite);
}

// ---------------------------------------------------------------- elevation and product

BOOST_AUTO_TEST_CASE_TEMPLATE(elevation, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(30, [](Random<FT>& random) {
    const int p = random.integer(0, 4), times = random.integer(0, 3), d = p + times;
    const Function<FT> f = random.function(random.knots(p, p + 1)), g = f.elevate(times);
    BOOST_CHECK_EQUAL(g.degree(), d);
    BOOST_CHECK(g.knots().is_clamped());
    const std::vector<Knot<FT>> old = f.knots().inner_knots(), raised = g.knots().inner_knots();
    BOOST_REQUIRE_EQUAL(old.size(), raised.size());
    for (std::size_t i = 0; i < old.size(); ++i) {
      BOOST_CHECK(old[i].value == raised[i].value);
      BOOST_CHECK_EQUAL(old[i].multiplicity + times, raised[i].multiplicity);
      if constexpr (exact_v<FT>) BOOST_CHECK(!g.remove(raised[i].value));
    }
    check_same(f, g, (2 * value_roundings(d) + 4 * d) * std::pow(2 * d + 1, d));
    if constexpr (exact_v<FT>) {
      BOOST_CHECK(f.elevate(times).elevate() == f.elevate(times + 1));
      BOOST_CHECK(f.clamp().elevate(times) == g);
    }
  });
  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2)});
  BOOST_CHECK(f.elevate() ==
              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 2}}), {FT(0), FT(1), FT(2), FT(0), FT(-2)}));
  CHECK_ERROR(f.elevate(-1), wrong_number_of_points);
}

// The multiplicity of each inner knot of a product of splines whose coefficients are not special.
template <class FT> int product_multiplicity(const Function<FT>& f, const Function<FT>& g, const FT& u) {
  const int mf = f.knots().multiplicity(u), mg = g.knots().multiplicity(u);
  return std::max(mf > 0 ? mf + g.degree() : 0, mg > 0 ? mg + f.degree() : 0);
}

template <class FT> void check_product(const Function<FT>& f, const Function<FT>& g, Random<FT>& random) {
  const Function<FT> h = f * g;
  const int d = f.degree() + g.degree();
  BOOST_CHECK_EQUAL(h.degree(), d);
  BOOST_CHECK(h.knots().is_clamped());
  BOOST_CHECK(h.knots().has_domain_of(f.knots()));
  // nonnegative weights everywhere but in the last step
  const FT scale = largest(f.coefficients()) * largest(g.coefficients());
  const double roundings = (4 * value_roundings(d) + 6 * d) * std::pow(2 * d + 1, d);
  for (const FT& u : parameters(h.knots(), random)) {
    BOOST_CHECK(close<FT>(h(u), FT(f(u) * g(u)), scale, roundings));
    BOOST_CHECK(close<FT>(left_value(h, u), FT(left_value(f, u) * left_value(g, u)), scale, roundings));
  }
  for (const Knot<FT>& knot : h.knots().inner_knots()) {
    BOOST_CHECK_EQUAL(knot.multiplicity, product_multiplicity(f, g, knot.value));
    BOOST_CHECK(f.knots().multiplicity(knot.value) + g.knots().multiplicity(knot.value) > 0);
  }
  for (const Function<FT>& x : {f, g})
    for (const Knot<FT>& knot : x.knots().inner_knots()) BOOST_CHECK(h.knots().multiplicity(knot.value) > 0);
  if constexpr (exact_v<FT>) {
    for (const Knot<FT>& knot : h.knots().inner_knots()) {
      BOOST_CHECK(!h.remove(knot.value));
      // all one-sided derivatives, by Leibniz' rule
      for (bool left : {false, true}) {
        const auto jet = [&](const Function<FT>& x) {
          return left ? x.left_derivatives(knot.value, d) : x.right_derivatives(knot.value, d);
        };
        const std::vector<FT> hj = jet(h), fj = jet(f), gj = jet(g);
        for (int j = 0; j <= d; ++j) {
          const std::vector<FT> binomials = GC::binomial_coefficients<FT>(j);
          FT sum(0);
          for (int i = 0; i <= j; ++i) sum += binomials[i] * fj[i] * gj[j - i];
          BOOST_CHECK(hj[j] == sum);
        }
      }
    }
    BOOST_CHECK(h == g * f);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(products, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(40, [](Random<FT>& random) {
    const int p = random.integer(0, 4), q = random.integer(0, 3);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    // other knots on the same domain, some of them common, and some very near to each other
    const FT a = f.domain().first, b = f.domain().second;
    std::vector<FT> inner;
    for (const Knot<FT>& knot : f.knots().inner_knots())
      if (random.coin()) inner.push_back(knot.value);
    for (int i = random.integer(0, 2); i > 0; --i) inner.push_back(random.between(a, b));
    std::sort(inner.begin(), inner.end());
    std::vector<Knot<FT>> knots;
    for (const FT& u : inner)
      if (a < u && u < b && (knots.empty() || knots.back().value != u)) knots.push_back({u, random.integer(1, q + 1)});
    GC::Knot_vector<FT> v(q, a, b, knots);
    if (q > 0 && random.coin()) { // not clamped
      std::vector<FT> w(v.begin(), v.end());
      w.front() -= FT(1);
      w.back() += FT(3);
      v = GC::Knot_vector<FT>(q, w);
    }
    check_product(f, random.function(v), random);
    check_product(f, random.function(f.knots()), random);
  });
  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2)});
  BOOST_CHECK(f * f ==
              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 2}}), {FT(0), FT(0), FT(4), FT(-4), FT(4)}));
  CHECK_ERROR(f * Function<FT>(GC::Knot_vector<FT>(0, {FT(0), FT(3)}), {FT(1)}), parameter_outside_domain);
}

// Cubics with simple knots: one argument outside a span, of two spans, multiplies the roundings by at most 3.
BOOST_AUTO_TEST_CASE(product_of_cubics_in_floating_point) {
  repeat<double>(100, [](Random<double>& random) {
    const GC::Knot_vector<double> u = random.knots(3, 1, false);
    const Function<double> f = random.function(u), g = random.function(u), h = f * g;
    const auto exact = [](const Function<double>& x) {
      return Function<Q>(GC::Knot_vector<Q>(3, std::vector<Q>(x.knots().begin(), x.knots().end())),
                         std::vector<Q>(x.coefficients().begin(), x.coefficients().end()));
    };
    const Function<Q> expected = exact(f) * exact(g);
    BOOST_REQUIRE_EQUAL(expected.coefficients().size(), h.coefficients().size());
    const double scale = largest(f.coefficients()) * largest(g.coefficients());
    for (int i = 0; i < h.knots().number_of_coefficients(); ++i)
      BOOST_CHECK(std::abs(CGAL::to_double(Q(Q(h[i]) - expected[i]))) <=
                  3 * (2 * value_roundings(3) + 20) * 0x1p-53 * scale);
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(sums, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(20, [](Random<FT>& random) {
    const int p = random.integer(0, 3), q = random.integer(0, 3);
    const Function<FT> f = random.function(random.knots(p, p + 1));
    const Function<FT> g =
        random.function(GC::Knot_vector<FT>(q, f.domain().first, f.domain().second,
                                            {{random.between(f.domain().first, f.domain().second) * ratio<FT>(1, 2) +
                                                  (f.domain().first + f.domain().second) * ratio<FT>(1, 4),
                                              1}}));
    const Function<FT> sum = f + g, difference = f - g;
    BOOST_CHECK_EQUAL(sum.degree(), std::max(p, q));
    const FT scale = largest(f.coefficients()) + largest(g.coefficients());
    for (const FT& u : parameters(sum.knots(), random)) {
      BOOST_CHECK(close<FT>(sum(u), FT(f(u) + g(u)), scale, 100 * value_roundings(3) * 343));
      BOOST_CHECK(close<FT>(difference(u), FT(f(u) - g(u)), scale, 100 * value_roundings(3) * 343));
    }
    if constexpr (exact_v<FT>) BOOST_CHECK(sum - f == (g + f) - f);
  });
  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2)});
  CHECK_ERROR(f + Function<FT>(GC::Knot_vector<FT>(1, FT(0), FT(3)), {FT(1), FT(1)}), parameter_outside_domain);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(reversal, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(20, [](Random<FT>& random) {
    const int p = random.integer(0, 4);
    const Function<FT> f = random.function(random.knots(p, p + 1)), r = f.reverse();
    BOOST_CHECK(r.domain() == f.domain());
    if constexpr (exact_v<FT>) {
      for (const FT& u : parameters(f.knots(), random))
        BOOST_CHECK(left_value(r, FT(f.domain().first + (f.domain().second - u))) == f(u) || u == f.domain().second);
      BOOST_CHECK(r.reverse() == f);
    }
  });
}

// ---------------------------------------------------------------- curves

template <class K> using Traits3 = GC::Traits_3<K>;
template <class K> using Curve3 = GC::Bspline_curve<GC::Traits_3<K>>;
template <class K> using Bezier3 = GC::Bezier_curve<GC::Traits_3<K>>;

// The i-th coordinate as a function.
template <class Traits> Function<typename Traits::FT> coordinate(const GC::Bspline_curve<Traits>& c, int i) {
  std::vector<typename Traits::FT> x;
  for (int j = 0; j < c.number_of_points(); ++j) x.push_back(c.coordinates(j)[i]);
  return Function<typename Traits::FT>(c.knots(), x);
}

// Curves do what functions do, coordinate by coordinate, with the same arithmetic: compared with == in floating point, too.
template <class Traits, class Test> void in_each_coordinate(const GC::Bspline_curve<Traits>& c, Test test) {
  for (int i = 0; i < c.dimension(); ++i) test(coordinate(c, i), i);
}

template <class Traits> void check_curve_operations(Random<typename Traits::FT>& random, int d) {
  typedef typename Traits::FT FT;
  typedef GC::Bspline_curve<Traits> Curve;
  const int p = random.integer(0, 4);
  const Curve c = random.template curve<Traits>(random.knots(p, p + 1), d);
  BOOST_CHECK_EQUAL(c.dimension(), d);
  BOOST_CHECK_EQUAL(c.degree(), p);
  BOOST_CHECK(c.domain() == c.knots().domain());
  BOOST_CHECK(Curve(c.function()) == c);
  const GC::Knot_vector<FT> knots = finer(c.knots(), random);
  const FT u = random.between(c.domain().first, c.domain().second);
  const Function<FT> factor(GC::Knot_vector<FT>(2, c.domain().first, c.domain().second), random.numbers(3));
  const int times = c.knots().multiplicity(u) > p ? 0 : 1;
  const Curve derivative = c.derivative(), refined = c.refine(knots), inserted = c.insert(u, times),
              elevated = c.elevate(2), reversed = c.reverse(), clamped = c.clamp(), scaled = product(factor, c),
              minimal = refined.remove_superfluous_knots();
  BOOST_CHECK_EQUAL(c.insert(u, 0), c);
  in_each_coordinate(c, [&](const Function<FT>& x, int i) {
    BOOST_CHECK(coordinate(derivative, i) == x.derivative());
    BOOST_CHECK(coordinate(refined, i) == x.refine(knots));
    BOOST_CHECK(coordinate(inserted, i) == x.insert(u, times));
    BOOST_CHECK(coordinate(elevated, i) == x.elevate(2));
    BOOST_CHECK(coordinate(reversed, i) == x.reverse());
    BOOST_CHECK(coordinate(clamped, i) == x.clamp());
    BOOST_CHECK(coordinate(scaled, i) == factor * x);
    for (const FT& v : parameters(c.knots(), random)) {
      const std::vector<FT> right = x.right_derivatives(v, p + 1), left = x.left_derivatives(v, p + 1);
      const GC::Curve_jet<Traits> jet = c.jet(v, p + 1), right_jet = c.right_jet(v, p + 1),
                                  left_jet = c.left_jet(v, p + 1);
      BOOST_CHECK_EQUAL(jet.order(), p + 1);
      for (int j = 0; j <= p + 1; ++j) {
        BOOST_CHECK(jet[j][i] == right[j]);
        BOOST_CHECK(right_jet[j][i] == right[j]);
        BOOST_CHECK(left_jet[j][i] == left[j]);
      }
      BOOST_CHECK(GC::coordinates<Traits>(c(v))[i] == x(v));
    }
    BOOST_CHECK(c.start_jet(3)[2][i] == x.right_derivatives(c.domain().first, 2)[2]);
    BOOST_CHECK(c.end_jet(3)[2][i] == x.left_derivatives(c.domain().second, 2)[2]);
  });
  if (c.knots().is_clamped()) { // exactly, in floating point as well
    BOOST_CHECK(c.start_jet(2)[0] == c.coordinates(0));
    BOOST_CHECK(c.end_jet(2)[0] == c.coordinates(c.number_of_points() - 1));
  }
  if constexpr (exact_v<FT>) {
    BOOST_CHECK(minimal == c || minimal.knots() != c.knots());
    for (const Knot<FT>& knot : c.knots().inner_knots()) BOOST_CHECK(!c.remove(knot.value));
    if (c.knots().multiplicity(u) == 0) BOOST_CHECK(*c.insert(u).remove(u) == c);
  }
  for (const FT& v : {FT(c.domain().first - FT(1)), FT(c.domain().second + FT(1))}) {
    CHECK_ERROR(c(v), parameter_outside_domain);
    CHECK_ERROR(c.jet(v, 2), parameter_outside_domain);
    CHECK_ERROR(c.left_jet(v, 2), parameter_outside_domain);
    CHECK_ERROR(c.insert(v), parameter_outside_domain);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(curves_are_functions_in_each_coordinate, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(12, [](Random<FT>& random) {
    check_curve_operations<GC::Traits_2<K>>(random, 2);
    check_curve_operations<GC::Traits_3<K>>(random, 3);
  });
}

BOOST_AUTO_TEST_CASE(curves_in_higher_dimension) {
  repeat<Q>(10, [](Random<Q>& random) {
    check_curve_operations<GC::Traits_d<CGAL::Cartesian_d<Q>>>(random, 1);
    check_curve_operations<GC::Traits_d<CGAL::Cartesian_d<Q>>>(random, 5);
  });
}

// What the concept of a traits class does not offer is not used.
BOOST_AUTO_TEST_CASE(curves_over_an_archetype) {
  typedef archetype::Traits<CGAL::Dimension_tag<2>> Traits;
  typedef archetype::Number FT;
  typedef GC::Bspline_curve<Traits> Curve;
  const auto point = [](int x, int y) {
    const FT c[] = {FT(x), FT(y)};
    return Traits().construct_point_object()(2, c, c + 2);
  };
  const std::vector<Traits::Point> points{point(0, 0), point(2, 4), point(4, 4), point(8, 0)};
  const Curve c(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}));
  const FT half = FT(FT(1) / FT(2));
  BOOST_CHECK(c.jet(half, 3)[0] == c.insert(half).jet(half, 3)[0]);
  BOOST_CHECK(c.elevate(2).jet(half, 3) == c.jet(half, 3));
  BOOST_CHECK(*c.insert(half).remove(half) == c);
  BOOST_CHECK(c.insert(half, 2).remove_superfluous_knots() == c);
  BOOST_CHECK(c.reverse().reverse() == c);
  BOOST_CHECK(c.derivative().jet(half, 0)[0] == c.jet(half, 1)[1]);
  const std::vector<GC::Bezier_curve<Traits>> pieces = c.bezier_pieces();
  BOOST_CHECK(Curve(pieces.begin(), pieces.end()).remove_superfluous_knots() == c);
  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2)), {FT(1), FT(3)});
  BOOST_CHECK(product(f, c).jet(FT(1), 0)[0] == FT(2) * c.jet(FT(1), 0)[0]);
  BOOST_CHECK_EQUAL(knot_continuity(c, FT(1)).c_order, 1);
  BOOST_CHECK_EQUAL(knot_continuities(c).size(), 1u);
  BOOST_CHECK_EQUAL(continuity(c, blend(c, c), 2).g_order, 2);
  BOOST_CHECK_EQUAL(GC::extend(c, GC::Frenet_order::curvature).number_of_points(), 6);
  BOOST_CHECK_EQUAL(GC::extend_toward(c, GC::Frenet_order::tangent, point(9, 1)).number_of_points(), 6);
  BOOST_CHECK_EQUAL((f + f)[1] == FT(6), true);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bezier_curves_and_back, K, Kernels) {
  typedef typename K::FT FT;
  typedef Curve3<K> Curve;
  typedef Bezier3<K> Bezier;
  repeat<FT>(25, [](Random<FT>& random) {
    const int p = random.integer(1, 4);
    const Curve c = random.template curve<Traits3<K>>(random.knots(p, p), 3); // continuous
    const std::vector<Bezier> pieces = c.bezier_pieces();
    const std::vector<int> spans = c.knots().spans();
    BOOST_REQUIRE_EQUAL(pieces.size(), spans.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const FT &a = c.knots()[spans[i]], &b = c.knots()[spans[i] + 1];
      BOOST_CHECK(pieces[i].domain() == std::make_pair(a, b));
      BOOST_CHECK_EQUAL(pieces[i].degree(), p);
      if constexpr (exact_v<FT>) {
        BOOST_CHECK(pieces[i].start_jet(p) == c.right_jet(a, p));
        BOOST_CHECK(pieces[i].end_jet(p) == c.left_jet(b, p));
      }
    }
    if constexpr (exact_v<FT>) {
      const Curve joined(pieces.begin(), pieces.end());
      for (const Knot<FT>& knot : joined.knots().inner_knots()) BOOST_CHECK_EQUAL(knot.multiplicity, p);
      BOOST_CHECK_EQUAL(joined.knots().inner_knots().size(), pieces.size() - 1);
      BOOST_CHECK(joined.bezier_pieces() == pieces);
      BOOST_CHECK(joined.remove_superfluous_knots() == c.clamp());
    }
  });
  const typename K::Point_3 a(0, 0, 0), b(1, 2, 0), x(3, 2, 1), y(4, 0, 1), z(6, 1, 1);
  const Bezier line({a, b}), parabola({b, x, y}), far({z, a});
  // a line elevated, and domains that do not continue each other
  const std::vector<Bezier> mixed{line, parabola, Bezier({y, z}).with_domain(FT(7), FT(10))};
  const Curve joined(mixed.begin(), mixed.end());
  BOOST_CHECK(joined.knots() == GC::Knot_vector<FT>(2, FT(0), FT(5), {{FT(1), 2}, {FT(2), 2}}));
  BOOST_CHECK_EQUAL(joined.number_of_points(), 7);
  BOOST_CHECK(joined.control_point(0) == a && joined.control_point(2) == b && joined.control_point(3) == x &&
              joined.control_point(4) == y && joined.control_point(6) == z);
  BOOST_CHECK(joined.coordinates(1)[1] == FT(1));
  BOOST_CHECK(joined(FT(5)) == z);
  const GC::Composite_bezier_curve<Traits3<K>> segmented(mixed.begin(), mixed.end());
  BOOST_CHECK(Curve(segmented.segments().begin(), segmented.segments().end()) == joined);
  const std::vector<Bezier> gap{line, far}, none;
  BOOST_CHECK_EQUAL(error_of([&] { Curve(gap.begin(), gap.end()); }),
                    "curves_do_not_meet: Bspline_curve: Bezier curve 1");
  CHECK_ERROR(Curve(none.begin(), none.end()), wrong_number_of_points);
  // points, where the degree 0 leaves no inner knot
  const std::vector<Bezier> points{Bezier({a}), Bezier({a})};
  BOOST_CHECK(Curve(points.begin(), points.end()).knots() == GC::Knot_vector<FT>(0, FT(0), FT(2)));
  // one curve
  BOOST_CHECK(Curve(parabola) == Curve(&parabola, &parabola + 1));
  BOOST_CHECK(Curve(parabola).bezier_pieces() == std::vector<Bezier>{parabola});
  BOOST_CHECK(Curve(parabola).knots() == GC::Knot_vector<FT>(2, FT(0), FT(1)));
  if constexpr (!exact_v<FT>) { // the length of the second domain vanishes beside the first
    const std::vector<Bezier> tiny{line.with_domain(FT(0), FT(1e20)), parabola};
    CHECK_ERROR(Curve(tiny.begin(), tiny.end()), empty_domain);
  }
}

BOOST_AUTO_TEST_CASE(bezier_curves_of_different_dimensions_do_not_join) {
  typedef CGAL::Cartesian_d<Q> K;
  typedef GC::Bezier_curve<GC::Traits_d<K>> Bezier;
  const Q zeros[] = {Q(0), Q(0), Q(0)};
  const K::Point_d plane(2, zeros, zeros + 2), space(3, zeros, zeros + 3);
  const std::vector<Bezier> two{Bezier({plane, plane}), Bezier({space, space})};
  CHECK_ERROR(GC::Bspline_curve<GC::Traits_d<K>>(two.begin(), two.end()), dimension_mismatch);
  const K::Point_d points[] = {plane, space};
  CHECK_ERROR(GC::Bspline_curve<GC::Traits_d<K>>(points, points + 2, GC::Knot_vector<Q>(1, Q(0), Q(1))),
              dimension_mismatch);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(refused_curves_equality_and_output, K, Kernels) {
  typedef typename K::FT FT;
  typedef GC::Bspline_curve<GC::Traits_2<K>> Curve;
  typedef typename K::Point_2 Point;
  const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(3, 4), Point(5, 6)};
  const GC::Knot_vector<FT> knots(2, FT(0), FT(4), {{FT(1), 1}});
  const Curve c(points.begin(), points.end(), knots);
  BOOST_CHECK_EQUAL(error_of([&] { Curve(points.begin(), points.end() - 1, knots); }),
                    "wrong_number_of_points: Bspline_curve: 3 coefficients where the knots need 4");
  std::vector<Point> others = points;
  others[3] = Point(5, 7);
  BOOST_CHECK(c == Curve(points.begin(), points.end(), knots));
  BOOST_CHECK(c != Curve(others.begin(), others.end(), knots));
  BOOST_CHECK(c != Curve(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}})));
  std::ostringstream os;
  os << c;
  BOOST_CHECK_EQUAL(os.str(), "B-spline curve of degree 2 over 0 0 0 1 4 4 4: (0, 0) (1, 2) (3, 4) (5, 6)");
  if constexpr (!exact_v<FT>) {
    others[1] = Point(std::numeric_limits<FT>::quiet_NaN(), 0);
    CHECK_ERROR(Curve(others.begin(), others.end(), knots), not_finite);
  }
  const CGAL::Aff_transformation_2<K> shift(CGAL::TRANSLATION, typename K::Vector_2(1, -1));
  BOOST_CHECK(c.transform(shift).control_point(1) == Point(2, 1));
  BOOST_CHECK(c.transform(shift).knots() == knots);
}

// ---------------------------------------------------------------- continuity and blends

template <class K> constexpr bool exact_predicates_v = !std::is_same_v<K, CGAL::Simple_cartesian<double>>;

BOOST_AUTO_TEST_CASE_TEMPLATE(continuity_at_knots, K, Kernels) {
  typedef typename K::FT FT;
  // in the kernel without exact predicates there is no certain answer
  if constexpr (exact_predicates_v<K>)
    repeat<FT>(25, [](Random<FT>& random) {
      const int p = random.integer(0, 4);
      Curve3<K> c = random.template curve<Traits3<K>>(random.knots(p, p + 1), 3);
      // numbers with all digits
      if constexpr (!exact_v<FT>) c = c.reverse().refine(c.knots().reverse().clamp());
      const auto all = knot_continuities(c, p + 1);
      const std::vector<Knot<FT>> knots = c.knots().inner_knots();
      BOOST_REQUIRE_EQUAL(all.size(), knots.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        const int m = knots[i].multiplicity;
        BOOST_CHECK(all[i].knot == knots[i].value);
        BOOST_CHECK_EQUAL(all[i].multiplicity, m);
        BOOST_CHECK_EQUAL(all[i].join.c_order, p - m);
        BOOST_CHECK_EQUAL(knot_continuity(c, knots[i].value, 1).c_order, std::min(p - m, 1));
        BOOST_CHECK_EQUAL(c.function().smoothness(knots[i].value), p - m);
        if (m < p) BOOST_CHECK(all[i].join.g_order >= std::min(p - m, 1));
      }
      const FT u = random.between(c.domain().first, c.domain().second);
      if (c.knots().multiplicity(u) == 0) BOOST_CHECK_EQUAL(knot_continuity(c, u, 7).c_order, 7);
      CHECK_ERROR(knot_continuity(c, c.domain().first), parameter_outside_domain);
      CHECK_ERROR(knot_continuity(c, c.domain().second), parameter_outside_domain);
      CHECK_ERROR(knot_continuity(c, FT(c.domain().second + FT(1))), parameter_outside_domain);
    });
  // whole numbers: a corner, a curve that is G1 and not C1, and one with the same curvature on both sides
  typedef typename K::Point_2 Point;
  typedef GC::Bspline_curve<GC::Traits_2<K>> Curve;
  const auto join = [](std::vector<Point> points, int multiplicity) {
    return knot_continuity(
        Curve(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), multiplicity}})), FT(2));
  };
  const auto corner = join({Point(0, 0), Point(2, 0), Point(4, 0), Point(4, 2), Point(4, 4)}, 2);
  BOOST_CHECK_EQUAL(corner.c_order, 0);
  BOOST_CHECK_EQUAL(corner.g_order, 0);
  const auto smooth = join({Point(0, 4), Point(0, 0), Point(2, 0), Point(6, 0), Point(8, 8)}, 2);
  BOOST_CHECK_EQUAL(smooth.c_order, 0);
  BOOST_CHECK(smooth.g_order >= 1);
  BOOST_CHECK_EQUAL(smooth.betas[0], FT(2));
  const auto simple = join({Point(0, 0), Point(2, 4), Point(6, 4), Point(9, 0)}, 1);
  BOOST_CHECK_EQUAL(simple.c_order, 1);
  const auto jump = join({Point(0, 0), Point(2, 4), Point(6, 4), Point(8, 0), Point(9, 9), Point(10, 3)}, 3);
  BOOST_CHECK_EQUAL(jump.c_order, -1);
}

// The same curve with rational coordinates.
template <class K> Curve3<CGAL::Simple_cartesian<Q>> rational(const Curve3<K>& c) {
  typedef CGAL::Simple_cartesian<Q> Exact;
  std::vector<Exact::Point_3> points;
  for (int i = 0; i < c.number_of_points(); ++i)
    points.emplace_back(Q(c.coordinates(i)[0]), Q(c.coordinates(i)[1]), Q(c.coordinates(i)[2]));
  return {points.begin(), points.end(),
          GC::Knot_vector<Q>(c.degree(), std::vector<Q>(c.knots().begin(), c.knots().end()))};
}

BOOST_AUTO_TEST_CASE(jets_over_another_field_are_exact) {
  typedef CGAL::Epick K;
  repeat<double>(20, [](Random<double>& random) {
    const int p = random.integer(0, 4);
    const Curve3<K> c = random.curve<Traits3<K>>(random.knots(p, p + 1), 3);
    const Curve3<CGAL::Simple_cartesian<Q>> exact = rational<K>(c);
    const auto same = [](const GC::Coordinate_jet<Q, 3>& x, const GC::Coordinate_jet<Q, 3>& y) {
      BOOST_CHECK_EQUAL(x.order(), 5);
      BOOST_CHECK(x == y);
    };
    same(c.start_jet_over<Q>(5), exact.start_jet(5));
    same(c.end_jet_over<Q>(5), exact.end_jet(5));
    for (double u : parameters(c.knots(), random)) {
      same(c.left_jet_over<Q>(u, 5), exact.left_jet(Q(u), 5));
      same(c.right_jet_over<Q>(u, 5), exact.right_jet(Q(u), 5));
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(splines_are_blended_and_joined, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(10, [](Random<FT>& random) {
    const Curve3<K> phi = random.template curve<Traits3<K>>(random.knots(3, 2, !exact_v<FT>), 3),
                    psi = random.template curve<Traits3<K>>(random.knots(random.integer(2, 4), 2), 3);
    const std::vector<FT> x = random.numbers(9);
    const Bezier3<K> bezier({typename K::Point_3(x[0], x[1], x[2]), typename K::Point_3(x[3], x[4], x[5]),
                             typename K::Point_3(x[6], x[7], x[8])});
    const auto quintic = blend(phi, psi);
    const auto mixed = blend(bezier, psi, GC::Minimal_second_derivative());
    const auto septic = blend(phi, psi, GC::Sequential_g3());
    BOOST_CHECK(quintic.start_jet(0)[0] == phi.end_jet(0)[0]);
    BOOST_CHECK(quintic.end_jet(0)[0] == psi.start_jet(0)[0]);
    if constexpr (exact_v<FT>) {
      BOOST_CHECK_EQUAL(continuity(phi, quintic, 2).g_order, 2);
      BOOST_CHECK_EQUAL(continuity(quintic, psi, 2).g_order, 2);
      BOOST_CHECK_EQUAL(continuity(mixed, psi, 2).g_order, 2);
      BOOST_CHECK_EQUAL(continuity(phi, septic, 3).g_order, 3);
      BOOST_CHECK_EQUAL(continuity(septic, psi, 3).g_order, 3);
      // splines that continue each other
      const std::vector<Bezier3<K>> pieces = phi.bezier_pieces();
      for (std::size_t i = 1; i < pieces.size(); ++i)
        BOOST_CHECK_EQUAL(continuity(Curve3<K>(pieces[i - 1]), Curve3<K>(pieces[i]), 3).c_order,
                          3 - phi.knots().multiplicity(pieces[i].domain().first));
    } else if constexpr (exact_predicates_v<K>) // the clamped end point is a control point, taken over without rounding
      BOOST_CHECK(continuity(phi.clamp(), blend(phi.clamp(), psi), 2).c_order >= 0);
  });
}

// Clamped or not, and with inner knots of any multiplicity: the last span decides.
BOOST_AUTO_TEST_CASE_TEMPLATE(splines_are_extended, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(6, [](Random<FT>& random) {
    const int p = random.integer(3, 4);
    const Curve3<K> c = random.template curve<Traits3<K>>(random.knots(p, p), 3), clamped = c.clamp();
    const Bezier3<K> last = clamped.bezier_pieces().back();
    const FT beta = ratio<FT>(random.integer(1, 9), 4);
    const std::vector<FT> x = random.numbers(3);
    const typename K::Point_3 wished(x[0], x[1], x[2]);
    for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion})
      for (bool toward : {false, true}) {
        const GC::Extension_parameters<FT> parameters{beta, random.number(), random.number(), random.number()};
        const Curve3<K> longer = toward ? GC::extend_toward(c, order, wished, beta) : GC::extend(c, order, parameters);
        const Bezier3<K> next =
            toward ? GC::extend_toward(last, order, wished, beta) : GC::extend(last, order, parameters);
        // the old control points, then those of the new segment
        BOOST_REQUIRE_EQUAL(longer.number_of_points(), clamped.number_of_points() + p);
        for (int i = 0; i < clamped.number_of_points(); ++i)
          BOOST_CHECK(longer.control_point(i) == clamped.control_point(i));
        for (int i = 1; i <= p; ++i)
          BOOST_CHECK(longer.control_point(clamped.number_of_points() - 1 + i) == next.control_point(i));
        // the old knots, a join of multiplicity p, and the end of the new segment
        std::vector<Knot<FT>> inner = clamped.knots().inner_knots();
        inner.push_back({c.domain().second, p});
        BOOST_CHECK(longer.knots() == GC::Knot_vector<FT>(p, c.domain().first, next.domain().second, inner));
        if (toward && static_cast<int>(order) < p) BOOST_CHECK(longer(longer.domain().second) == wished);
        if constexpr (exact_v<FT>) {
          BOOST_CHECK(longer.bezier_pieces().back() == next);
          for (const FT& u : ::parameters(c.knots(), random)) BOOST_CHECK(longer.left_jet(u, p) == c.left_jet(u, p));
          BOOST_CHECK_GE(knot_continuity(longer, c.domain().second).f_order, static_cast<int>(order));
        } else if constexpr (exact_predicates_v<K>)
          BOOST_CHECK_GE(knot_continuity(longer, c.domain().second).c_order, 0);
      }
    // without parameters the last polynomial goes on, and the join is no knot at all
    if constexpr (exact_v<FT>) {
      const Curve3<K> on = GC::extend(c, GC::Frenet_order::torsion, {beta, {}, {}, {}});
      BOOST_CHECK_EQUAL(on.function().smoothness(c.domain().second), p);
      BOOST_CHECK(on.remove_superfluous_knots().knots().inner_knots().size() == c.knots().inner_knots().size());
    }
    CHECK_ERROR(GC::extend(c, GC::Frenet_order::tangent, {FT(0), {}, {}, {}}), nonpositive_beta);
    CHECK_ERROR(GC::extend_toward(c, GC::Frenet_order::tangent, wished, FT(-1)), nonpositive_beta);
  });
  typedef typename K::Point_3 P;
  // only the last span is asked whether it can be extended: its points are equal, then those before it
  const GC::Knot_vector<FT> knots(1, FT(0), FT(2), {{FT(1), 1}});
  const std::vector<P> stops{P(0, 0, 0), P(1, 0, 0), P(1, 0, 0)}, starts{P(1, 0, 0), P(1, 0, 0), P(2, 0, 0)};
  CHECK_ERROR(GC::extend(Curve3<K>(stops.begin(), stops.end(), knots), GC::Frenet_order::tangent), zero_tangent);
  const Curve3<K> line = GC::extend(Curve3<K>(starts.begin(), starts.end(), knots), GC::Frenet_order::tangent);
  BOOST_CHECK(line(FT(3)) == P(3, 0, 0));
  CHECK_ERROR(GC::extend(line, GC::Frenet_order::curvature), wrong_number_of_points);
  // the segment that closes a spline, from its own ends
  const std::vector<P> arch{P(0, 0, 0), P(0, 4, 0), P(4, 4, 4), P(4, 0, 0)};
  const Curve3<K> open(arch.begin(), arch.end(), GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}));
  const Bezier3<K> closing = GC::close(open, open, GC::Frenet_order::tangent);
  BOOST_CHECK(closing.control_point(0) == P(4, 0, 0) && closing.control_point(3) == P(0, 0, 0));
  if constexpr (exact_v<FT>) {
    BOOST_CHECK_EQUAL(continuity(open, closing, 1).g_order, 1);
    BOOST_CHECK_EQUAL(continuity(closing, open, 1).g_order, 1);
  }
}

// A chain of splines and their blends.
BOOST_AUTO_TEST_CASE(chains_of_splines) {
  typedef CGAL::Simple_cartesian<Q> K;
  repeat<Q>(5, [](Random<Q>& random) {
    const Curve3<K> phi = random.curve<Traits3<K>>(random.knots(3, 2), 3),
                    psi = random.curve<Traits3<K>>(random.knots(4, 2), 3);
    const std::vector<Curve3<K>> chain{phi, Curve3<K>(blend(phi, psi)), psi,
                                       Curve3<K>(blend(psi, phi, GC::Sequential_g3()))};
    const GC::Chain_summary summary = GC::chain_continuity(chain.begin(), chain.end(), 3, true);
    BOOST_CHECK_EQUAL(*summary.least_order(GC::Continuity_kind::G), 2);
    BOOST_CHECK_EQUAL(summary.counts(GC::Continuity_kind::G).at(3), 2u);
    // the pieces as a segmented curve, and back
    const std::vector<Bezier3<K>> pieces = phi.bezier_pieces();
    const GC::Composite_bezier_curve<Traits3<K>> segmented(pieces.begin(), pieces.end());
    BOOST_CHECK(Curve3<K>(segmented.segments().begin(), segmented.segments().end()).remove_superfluous_knots() ==
                phi.clamp());
    const auto joins = GC::chain_continuity(segmented).joins;
    const auto knots = knot_continuities(phi);
    BOOST_REQUIRE_EQUAL(joins.size(), knots.size());
    for (std::size_t i = 0; i < joins.size(); ++i)
      BOOST_CHECK_EQUAL(joins[i].continuity.c_order, knots[i].join.c_order);
  });
}

// ---------------------------------------------------------------- files

BOOST_AUTO_TEST_CASE_TEMPLATE(splines_in_files, K, Kernels) {
  typedef typename K::FT FT;
  repeat<FT>(10, [](Random<FT>& random) {
    std::vector<Curve3<K>> curves;
    for (int p = 0; p <= 4; ++p) curves.push_back(random.template curve<Traits3<K>>(random.knots(p, p + 1), 3));
    std::stringstream text;
    for (const Curve3<K>& curve : curves) GC::write_g2(text, curve);
    BOOST_CHECK(GC::read_g2_bsplines<Traits3<K>>(text, "f.g2") == curves);
    // a Bezier curve is written and read as both
    const std::vector<Bezier3<K>> pieces = curves[3].bezier_pieces();
    std::stringstream bezier, spline;
    for (const Bezier3<K>& piece : pieces) {
      GC::write_g2(bezier, piece);
      GC::write_g2(spline, Curve3<K>(piece));
    }
    BOOST_CHECK_EQUAL(bezier.str(), spline.str());
    BOOST_CHECK(GC::read_g2_curves<Traits3<K>>(spline, "f.g2") == pieces);
    const std::vector<Curve3<K>> read = GC::read_g2_bsplines<Traits3<K>>(bezier, "f.g2");
    BOOST_REQUIRE_EQUAL(read.size(), pieces.size());
    for (std::size_t i = 0; i < read.size(); ++i) BOOST_CHECK(read[i] == Curve3<K>(pieces[i]));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(refused_splines_in_files, K, Kernels) {
  typedef GC::Traits_2<K> Traits;
  typedef typename K::FT FT;
  const auto text = [](const std::string& size, const std::string& knots) {
    return "100 1 0 0\n2 0\n" + size + "\n" + knots + "\n0 0\n1 2\n3 4\n5 6\n";
  };
  const auto error = [&](const std::string& size, const std::string& knots) {
    std::istringstream is(text(size, knots));
    return error_of([&] { GC::read_g2_bsplines<Traits>(is, "f.g2"); });
  };
  const auto refused = [](int line, const std::string& reason) {
    return "malformed_input: f.g2:" + std::to_string(line) + ": " + reason;
  };
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1/2 2 2 2"), "no error");
  BOOST_CHECK_EQUAL(error("4 3", "-2 -1 0 1/2 2 3 4"), "no error");
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1/2 2 2\n1"), refused(5, "the knots decrease at '1'"));
  BOOST_CHECK_EQUAL(error("4 3", "0 0 1\n.5 2 2 2"), refused(5, "the knots decrease at '.5'"));
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0\n0 2 2 2"), refused(5, "knot 4 of 7 is repeated more than 3 times"));
  BOOST_CHECK_EQUAL(error("4 3", "0 1 2 2 2 3 4"), refused(4, "knot 3 of 7 is equal to knot 5: empty domain"));
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1 1 1\n1"), refused(5, "knot 7 of 7 is repeated more than 3 times"));
  BOOST_CHECK_EQUAL(error("4 5", ""), refused(3, "4 control points and order 5: there must be at least as many control "
                                                 "points as the order says"));
  BOOST_CHECK_EQUAL(error("2147483647 3", "0 0 0 1 2 x"), refused(4, "not a number: 'x'"));
  BOOST_CHECK_EQUAL(error("5 3", "0 0 0 1 2 3 3 3"), refused(8, "file ends after 4 of 5 control points"));
  BOOST_CHECK_EQUAL(error("40 3", "0"), refused(8, "file ends after 9 of 43 knots"));
  std::istringstream inner(text("4 3", "0 0 0 1/2 2 2 2"));
  BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_curves<Traits>(inner, "f.g2"); }),
                    refused(3, "4 control points and order 3: inner knots are not supported, only Bezier curves"));
  // numbers as written
  std::istringstream good(text("4 3", "0 0 0 1/4 2 2 2"));
  const GC::Bspline_curve<Traits> c = GC::read_g2_bsplines<Traits>(good, "f.g2").at(0);
  BOOST_CHECK(c.knots() == GC::Knot_vector<FT>(2, FT(0), FT(2), {{ratio<FT>(1, 4), 1}}));
  BOOST_CHECK(c.control_point(3) == typename K::Point_2(5, 6));
  std::ostringstream os;
  GC::write_g2(os, c);
  BOOST_CHECK_EQUAL(os.str(), "100 1 0 0\n2 0\n4 3\n0 0 0 " + std::string(exact_v<FT> ? "1/4" : "0.25") +
                                  " 2 2 2\n0 0\n1 2\n3 4\n5 6\n\n");
}
