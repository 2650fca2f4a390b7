include <CGAL/Geometric_continuity/extensions/extend.h>// Copyright (c) 2026 The Geometric_continuity developers
include <CGAL/Geometric_continuity/extensions/extend.h>//
include <CGAL/Geometric_continuity/extensions/extend.h>// SPDX-License-Identifier: LGPL-3.0-or-later
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Knot vectors, spline functions and B-spline curves. In exact kernels all identities hold with ==. In rounded kernels the
include <CGAL/Geometric_continuity/extensions/extend.h>// bounds are multiples of the unit roundoff u = 2^-53, times the largest coefficient:
include <CGAL/Geometric_continuity/extensions/extend.h>//
include <CGAL/Geometric_continuity/extensions/extend.h>// - A weight of a value or a blossom is made in p levels of a triangle, each with 6 roundings, where all terms are
include <CGAL/Geometric_continuity/extensions/extend.h>//   nonnegative; the sum over p + 1 coefficients adds p + 2. So values and coefficients over finer knots are known to
include <CGAL/Geometric_continuity/extensions/extend.h>//   value_roundings(p) = 7 p + 2.
include <CGAL/Geometric_continuity/extensions/extend.h>// - Arguments of a blossom outside its span multiply the sum of the absolute weights by at most 2 s - 1 each, where s is the
include <CGAL/Geometric_continuity/extensions/extend.h>//   number of spans between the arguments.
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#define BOOST_TEST_DYN_LINK
include <CGAL/Geometric_continuity/extensions/extend.h>#define BOOST_TEST_MODULE bspline
include <CGAL/Geometric_continuity/extensions/extend.h>#include <boost/test/unit_test.hpp>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include "support/archetype.h"
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Cartesian_d.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Exact_rational.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/IO/g2.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/Traits_2.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/Traits_3.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/Traits_d.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/blends/blend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/joins/knot_continuity.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Simple_cartesian.h>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <algorithm>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <cmath>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <cstdlib>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <iostream>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <limits>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <random>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <sstream>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <string>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <tuple>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <type_traits>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <vector>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>namespace GC = CGAL::Geometric_continuity;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef CGAL::Exact_rational Q;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Simple_cartesian<double>, CGAL::Epeck, CGAL::Epick> Kernels;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> constexpr bool exact_v = !std::is_floating_point_v<FT>;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> using Knot = typename GC::Knot_vector<FT>::Knot;
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> using Function = GC::Bspline_function<FT>;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#define CHECK_ERROR(expression, expected)                                                                              \
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
include <CGAL/Geometric_continuity/extensions/extend.h>                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The text of the error that f() throws.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class F> std::string error_of(F f) {
include <CGAL/Geometric_continuity/extensions/extend.h>  try {
include <CGAL/Geometric_continuity/extensions/extend.h>    f();
include <CGAL/Geometric_continuity/extensions/extend.h>  } catch (const GC::Error& error) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return error.what();
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  return "no error";
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- random input
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Set GEOMETRIC_CONTINUITY_SEED to try other numbers.
include <CGAL/Geometric_continuity/extensions/extend.h>unsigned first_seed() {
include <CGAL/Geometric_continuity/extensions/extend.h>  const char* text = std::getenv("GEOMETRIC_CONTINUITY_SEED");
include <CGAL/Geometric_continuity/extensions/extend.h>  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 2026;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>struct Report_seed {
include <CGAL/Geometric_continuity/extensions/extend.h>  Report_seed() { std::cout << "random seed " << first_seed() << std::endl; }
include <CGAL/Geometric_continuity/extensions/extend.h>};
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_TEST_GLOBAL_FIXTURE(Report_seed);
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> class Random {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::mt19937 engine_{first_seed()};
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>public:
include <CGAL/Geometric_continuity/extensions/extend.h>  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
include <CGAL/Geometric_continuity/extensions/extend.h>  bool coin() { return integer(0, 1) == 1; }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // at most 9 in absolute value; in floating point with few digits
include <CGAL/Geometric_continuity/extensions/extend.h>  FT number() { return ratio<FT>(integer(-999, 999), exact_v<FT> ? integer(111, 999) : 128); }
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<FT> numbers(int n) {
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<FT> x;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < n; ++i) x.push_back(number());
include <CGAL/Geometric_continuity/extensions/extend.h>    return x;
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  // In [a, b]; in floating point as well.
include <CGAL/Geometric_continuity/extensions/extend.h>  FT between(const FT& a, const FT& b) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT u = a + (b - a) * ratio<FT>(integer(0, 1024), 1024);
include <CGAL/Geometric_continuity/extensions/extend.h>    return u < a ? a : b < u ? b : u;
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  // The lengths of neighbouring spans differ by factors up to 10^6.
include <CGAL/Geometric_continuity/extensions/extend.h>  FT length() { return coin() ? ratio<FT>(integer(1, 9), 4) : ratio<FT>(integer(1, 9), 4000000); }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // Of degree p: inner knots of multiplicity 1 to `highest`; sometimes not clamped, when that is allowed.
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::Knot_vector<FT> knots(int p, int highest, bool may_be_unclamped = true) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT a = ratio<FT>(integer(-9, 9), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    FT b = a;
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<Knot<FT>> inner;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = integer(0, 3); i >= 0; --i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      b += length();
include <CGAL/Geometric_continuity/extensions/extend.h>      if (i > 0) inner.push_back({b, integer(1, highest)});
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Knot_vector<FT> clamped(p, a, b, inner);
include <CGAL/Geometric_continuity/extensions/extend.h>    if (!may_be_unclamped || p == 0 || coin()) return clamped;
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<FT> u(clamped.begin(), clamped.end()); // the knots outside move outwards
include <CGAL/Geometric_continuity/extensions/extend.h>    FT left = a, right = b;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 1; i <= p; ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      if (coin()) left -= ratio<FT>(integer(1, 9), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>      if (coin()) right += ratio<FT>(integer(1, 9), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>      u[p - i] = left;
include <CGAL/Geometric_continuity/extensions/extend.h>      u[u.size() - 1 - p + i] = right;
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    return GC::Knot_vector<FT>(p, u);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  Function<FT> function(const GC::Knot_vector<FT>& knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return Function<FT>(knots, numbers(knots.number_of_coefficients()));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  template <class Traits> GC::Bspline_curve<Traits> curve(const GC::Knot_vector<FT>& knots, int d) {
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<typename Traits::Point> points;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < knots.number_of_coefficients(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const std::vector<FT> x = numbers(d);
include <CGAL/Geometric_continuity/extensions/extend.h>      points.push_back(Traits().construct_point_object()(d, x.begin(), x.end()));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    return GC::Bspline_curve<Traits>(points.begin(), points.end(), knots);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>};
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// test(random) a number of times
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT, class Test> void repeat(int times, Test test) {
include <CGAL/Geometric_continuity/extensions/extend.h>  Random<FT> random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = 0; i < times; ++i) BOOST_TEST_CONTEXT("seed " << first_seed() << ", round " << i) test(random);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Parameters of the domain: the ends, the knots, and some between.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> std::vector<FT> parameters(const GC::Knot_vector<FT>& knots, Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<FT> u;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int k : knots.spans()) {
include <CGAL/Geometric_continuity/extensions/extend.h>    u.push_back(knots[k]);
include <CGAL/Geometric_continuity/extensions/extend.h>    u.push_back(random.between(knots[k], knots[k + 1]));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  u.push_back(knots.domain().second);
include <CGAL/Geometric_continuity/extensions/extend.h>  return u;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- bounds and an independent definition
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>constexpr int value_roundings(int p) { return 7 * p + 2; }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Equality; in floating point up to so many roundings of numbers of at most `scale`.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> bool close(const FT& x, const FT& y, const FT& scale, double roundings) {
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (exact_v<FT>)
include <CGAL/Geometric_continuity/extensions/extend.h>    return x == y;
include <CGAL/Geometric_continuity/extensions/extend.h>  else
include <CGAL/Geometric_continuity/extensions/extend.h>    return std::abs(x - y) <= roundings * 0x1p-53 * scale;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT largest(const std::vector<FT>& x) {
include <CGAL/Geometric_continuity/extensions/extend.h>  FT m(0);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& xi : x) m = m < xi ? xi : m < -xi ? FT(-xi) : m;
include <CGAL/Geometric_continuity/extensions/extend.h>  return m;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// N_i^p(u) by the recursion of Cox, de Boor and Mansfield. On the intervals [u_i, u_{i+1}), or (u_i, u_{i+1}] from the left.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT basis_by_recursion(const GC::Knot_vector<FT>& u, int i, int p, const FT& t, bool from_left) {
include <CGAL/Geometric_continuity/extensions/extend.h>  if (p == 0) return FT((from_left ? u[i] < t && !(u[i + 1] < t) : !(t < u[i]) && t < u[i + 1]) ? 1 : 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  FT sum(0);
include <CGAL/Geometric_continuity/extensions/extend.h>  if (u[i] < u[i + p]) sum += FT((t - u[i]) / (u[i + p] - u[i])) * basis_by_recursion(u, i, p - 1, t, from_left);
include <CGAL/Geometric_continuity/extensions/extend.h>  if (u[i + 1] < u[i + p + 1])
include <CGAL/Geometric_continuity/extensions/extend.h>    sum += FT((u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1])) * basis_by_recursion(u, i + 1, p - 1, t, from_left);
include <CGAL/Geometric_continuity/extensions/extend.h>  return sum;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT value_by_recursion(const Function<FT>& f, const FT& t, bool from_left) {
include <CGAL/Geometric_continuity/extensions/extend.h>  FT sum(0);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = 0; i < f.knots().number_of_coefficients(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>    sum += f[i] * basis_by_recursion(f.knots(), i, f.degree(), t, from_left);
include <CGAL/Geometric_continuity/extensions/extend.h>  return sum;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The values from both sides, where there are both.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT left_value(const Function<FT>& f, const FT& u) { return f.left_derivatives(u, 0)[0]; }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The same function: at p + 1 parameters in each span, and from both sides at its ends.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> void check_same(const Function<FT>& f, const Function<FT>& g, double roundings) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT scale = largest(f.coefficients());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE(f.knots().has_domain_of(g.knots()));
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Knot_vector<FT> all = merge(f.knots().bezier(0), g.knots().bezier(0));
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int k : all.spans()) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT &a = all[k], &b = all[k + 1];
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(close<FT>(f(a), g(a), scale, roundings));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(close<FT>(left_value(f, b), left_value(g, b), scale, roundings));
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 1; i <= f.degree(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT u = a + (b - a) * ratio<FT>(i, f.degree() + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      if (a < u && u < b) BOOST_CHECK(close<FT>(f(u), g(u), scale, roundings));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- knot vectors
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(knot_vectors, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Knot_vector<FT> Knots;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Knots u(2, {FT(-1), FT(0), FT(0), FT(1), FT(1), FT(4), FT(6), FT(7)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.degree(), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.size(), 8);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.number_of_coefficients(), 5);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.domain() == std::make_pair(FT(0), FT(4)));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(!u.is_clamped());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK((u.spans() == std::vector<int>{2, 4}));
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = -1; i <= 8; ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(u.multiplicity(FT(i)), (i == 0 || i == 1) ? 2 : (i == -1 || i == 4 || i == 6 || i == 7) ? 1 : 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE_EQUAL(u.distinct_knots().size(), 3u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.distinct_knots()[0].value == FT(0) && u.distinct_knots()[0].multiplicity == 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.distinct_knots()[2].value == FT(4) && u.distinct_knots()[2].multiplicity == 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE_EQUAL(u.inner_knots().size(), 1u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.inner_knots()[0].value == FT(1) && u.inner_knots()[0].multiplicity == 2);
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // right-continuous, the right end closed
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.span(FT(0)), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.span(ratio<FT>(1, 2)), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.span(FT(1)), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.span(FT(4)), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.left_span(FT(0)), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.left_span(FT(1)), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.left_span(ratio<FT>(3, 2)), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(u.left_span(FT(4)), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& outside : {FT(-1), ratio<FT>(-1, 1000), ratio<FT>(4001, 1000), FT(7)}) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(!u.contains(outside));
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(u.span(outside), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(u.left_span(outside), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(u.insert(outside), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.greville_abscissa(0) == FT(0));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.greville_abscissa(1) == ratio<FT>(1, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.greville_abscissa(4) == FT(5));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Knots(0, {FT(0), FT(1), FT(4)}).greville_abscissa(1) == ratio<FT>(5, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(1)) == Knots(2, {FT(-1), FT(0), FT(0), FT(1), FT(1), FT(1), FT(4), FT(6), FT(7)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(3), 2).inner_knots()[1].multiplicity == 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(3), 0) == u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(0)).domain() == u.domain());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(4), 2).domain() == u.domain());
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(u.insert(FT(1), 2), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(3), 2).remove(FT(3), 2) == u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.insert(FT(3), 2).remove(FT(3)) == u.insert(FT(3)));
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(u.remove(FT(3)), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(u.remove(FT(0)), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.with_inner_knots({}) == Knots(2, {FT(-1), FT(0), FT(0), FT(4), FT(6), FT(7)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  const Knots clamped(2, {FT(0), FT(0), FT(0), FT(1), FT(1), FT(4), FT(4), FT(4)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.clamp() == clamped);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(clamped.is_clamped());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Knots(2, FT(0), FT(4), {{FT(1), 2}}) == clamped);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.bezier(1) == Knots(1, {FT(0), FT(0), FT(1), FT(1), FT(4), FT(4)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(merge(u, Knots(2, FT(0), FT(4), {{FT(1), 1}, {FT(2), 3}})) ==
include <CGAL/Geometric_continuity/extensions/extend.h>              Knots(2, FT(0), FT(4), {{FT(1), 2}, {FT(2), 3}}));
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(merge(u, Knots(2, FT(0), FT(5))), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(merge(u, Knots(3, FT(0), FT(4))), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.reverse() == Knots(2, {FT(-3), FT(-2), FT(0), FT(3), FT(3), FT(4), FT(4), FT(5)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u.reverse().reverse() == u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(u != clamped);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Knots(1, FT(0), FT(1)) != Knots(0, {FT(0), FT(1)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::ostringstream os;
include <CGAL/Geometric_continuity/extensions/extend.h>  os << clamped;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(os.str(), "0 0 0 1 1 4 4 4");
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(refused_knot_vectors, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto error = [](int p, std::initializer_list<int> knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return error_of([&] { GC::Knot_vector<FT>(p, std::vector<FT>(knots.begin(), knots.end())); });
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(-1, {0, 1, 2}), "wrong_number_of_points: Knot_vector: degree -1");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(2, {0, 0, 0, 1, 1}), "wrong_number_of_points: Knot_vector: 5 knots are too few for degree 2");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(0, {}), "wrong_number_of_points: Knot_vector: 0 knots are too few for degree 0");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(1, {0, 0, 2, 1, 3, 3}), "empty_domain: Knot_vector: knot 3 is less than the one before it");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(1, {0, 1, 1, 2}), "empty_domain: Knot_vector: the ends of the domain are equal");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(1, {0, 0, 1, 1, 1, 2, 2}),
include <CGAL/Geometric_continuity/extensions/extend.h>                    "knot_multiplicity: Knot_vector: knot 4 is repeated more than 2 times");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(0, {0, 1, 1, 2}), "knot_multiplicity: Knot_vector: knot 2 is repeated more than 1 times");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(1, {0, 0, 0, 1, 1}), "knot_multiplicity: Knot_vector: knot 2 is repeated more than 2 times");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error(1, {0, 0, 1, 1, 2, 2}), "no error");
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Knot_vector<FT>(-2, FT(0), FT(1)), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(1), FT(1)), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(5), 1}}), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(1), 4}}), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(1), -1}}), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (!exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT infinity = std::numeric_limits<FT>::infinity(), nan = std::numeric_limits<FT>::quiet_NaN();
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR((GC::Knot_vector<FT>(1, {0, 0, 1, infinity})), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR((GC::Knot_vector<FT>(1, {0, nan, 1, 1})), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(!GC::Knot_vector<FT>(1, 0, 1).contains(nan));
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(GC::Knot_vector<FT>(1, 0, 1).span(nan), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- values, blossoms, derivatives
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(basis_and_values_are_those_of_the_recursion, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(40, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT scale = largest(f.coefficients()), end = f.domain().second;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : parameters(f.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const std::vector<FT> basis = bspline_basis(f.knots(), u);
include <CGAL/Geometric_continuity/extensions/extend.h>      FT sum(0);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int i = 0; i < f.knots().number_of_coefficients(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>        // both are made of nonnegative terms
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(close<FT>(basis[i], basis_by_recursion(f.knots(), i, p, u, u == end), FT(1), 12 * p));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(!(basis[i] < FT(0)));
include <CGAL/Geometric_continuity/extensions/extend.h>        sum += basis[i];
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(close<FT>(sum, FT(1), FT(1), value_roundings(p)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(close<FT>(f(u), value_by_recursion(f, u, u == end), scale, 2 * value_roundings(p)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(
include <CGAL/Geometric_continuity/extensions/extend.h>          close<FT>(left_value(f, u), value_by_recursion(f, u, u != f.domain().first), scale, 2 * value_roundings(p)));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(f(FT(f.domain().first - FT(1))), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(f.left_derivatives(FT(end + FT(1)), 0), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// (u - y)^p = sum_i (u_{i+1} - y) ... (u_{i+p} - y) N_i(u)
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(marsden_identity, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(30, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 5);
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Knot_vector<FT> knots = random.knots(p, p + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT y = random.number();
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<FT> c;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < knots.number_of_coefficients(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      FT product(1);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int j = 1; j <= p; ++j) product *= knots[i + j] - y;
include <CGAL/Geometric_continuity/extensions/extend.h>      c.push_back(product);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : parameters(knots, random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>      FT power(1);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int j = 0; j < p; ++j) power *= u - y;
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(close<FT>(bspline_value(knots, c, u), power, largest(c), value_roundings(p) + 6 * p));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(greville_abscissae_reproduce_the_parameter, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(20, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(1, 5);
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Knot_vector<FT> knots = random.knots(p, p + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<FT> c;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < knots.number_of_coefficients(); ++i) c.push_back(knots.greville_abscissa(i));
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : parameters(knots, random))
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(close<FT>(bspline_value(knots, c, u), u, largest(c), value_roundings(p) + p));
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(blossoms, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (exact_v<FT>)
include <CGAL/Geometric_continuity/extensions/extend.h>    repeat<FT>(30, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const int p = random.integer(1, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>      const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int k : f.knots().spans()) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const auto blossom = [&](const std::vector<FT>& t) {
include <CGAL/Geometric_continuity/extensions/extend.h>          return bspline_blossom(f.knots(), f.coefficients(), k, t);
include <CGAL/Geometric_continuity/extensions/extend.h>        };
include <CGAL/Geometric_continuity/extensions/extend.h>        // knots of the neighbourhood and other arguments, anywhere, in any order
include <CGAL/Geometric_continuity/extensions/extend.h>        std::vector<FT> t;
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 0; i < p; ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>          t.push_back(random.coin() ? f.knots()[k + random.integer(1 - p, p)] : random.number());
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT x = random.number(), y = random.coin() ? f.knots()[k] : random.number(), s = random.number();
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT value = blossom(t);
include <CGAL/Geometric_continuity/extensions/extend.h>        std::reverse(t.begin(), t.end());
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(blossom(t) == value);
include <CGAL/Geometric_continuity/extensions/extend.h>        std::swap(t[0], t[random.integer(0, p - 1)]);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(blossom(t) == value);
include <CGAL/Geometric_continuity/extensions/extend.h>        t[0] = x;
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT at_x = blossom(t);
include <CGAL/Geometric_continuity/extensions/extend.h>        t[0] = y;
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT at_y = blossom(t);
include <CGAL/Geometric_continuity/extensions/extend.h>        t[0] = (FT(1) - s) * x + s * y;
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(blossom(t) == FT((FT(1) - s) * at_x + s * at_y));
include <CGAL/Geometric_continuity/extensions/extend.h>        // the diagonal is the polynomial
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT u = random.between(f.knots()[k], f.knots()[k + 1]);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(u == f.knots()[k + 1] || blossom(std::vector<FT>(p, u)) == f(u));
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = k - p; i <= k; ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(blossom({f.knots().begin() + i + 1, f.knots().begin() + i + p + 1}) == f[i]);
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(bspline_blossom(f.knots(), f.coefficients(), f.knots().spans()[0], std::vector<FT>(p + 1, FT(0))),
include <CGAL/Geometric_continuity/extensions/extend.h>                  wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    });
include <CGAL/Geometric_continuity/extensions/extend.h>  else
include <CGAL/Geometric_continuity/extensions/extend.h>    repeat<FT>(30, [](Random<FT>& random) { // arguments within the span
include <CGAL/Geometric_continuity/extensions/extend.h>      const int p = random.integer(1, 5);
include <CGAL/Geometric_continuity/extensions/extend.h>      const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int k : f.knots().spans()) {
include <CGAL/Geometric_continuity/extensions/extend.h>        std::vector<FT> t;
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 0; i < p; ++i) t.push_back(random.between(f.knots()[k], f.knots()[k + 1]));
include <CGAL/Geometric_continuity/extensions/extend.h>        std::vector<Q> u(f.knots().begin(), f.knots().end()), c(f.coefficients().begin(), f.coefficients().end());
include <CGAL/Geometric_continuity/extensions/extend.h>        const Q exact = bspline_blossom(GC::Knot_vector<Q>(p, u), c, k, std::vector<Q>(t.begin(), t.end()));
include <CGAL/Geometric_continuity/extensions/extend.h>        const double computed = bspline_blossom(f.knots(), f.coefficients(), k, t);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(close<Q>(Q(computed), exact, Q(0), 0) ||
include <CGAL/Geometric_continuity/extensions/extend.h>                    std::abs(CGAL::to_double(Q(Q(computed) - exact))) <=
include <CGAL/Geometric_continuity/extensions/extend.h>                        value_roundings(p) * 0x1p-53 * largest(f.coefficients()));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// What a sum of at most p + 1 terms can lose in the j-th derivative: the quotients are at most 2 p / h for the shortest
include <CGAL/Geometric_continuity/extensions/extend.h>// difference h of knots, so that the j-th derivative of coefficients up to 1 is at most (2 p / h)^j.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT derivative_scale(const Function<FT>& f, int j) {
include <CGAL/Geometric_continuity/extensions/extend.h>  FT h = f.domain().second - f.domain().first;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int k : f.knots().spans()) h = std::min(h, FT(f.knots()[k + 1] - f.knots()[k]));
include <CGAL/Geometric_continuity/extensions/extend.h>  FT scale = largest(f.coefficients());
include <CGAL/Geometric_continuity/extensions/extend.h>  for (; j > 0; --j) scale *= FT(2 * f.degree()) / h;
include <CGAL/Geometric_continuity/extensions/extend.h>  return scale;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(30, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    Function<FT> d = f;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int j = 0; j <= p + 1; ++j) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT scale = derivative_scale(f, j);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const FT& u : parameters(f.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const std::vector<FT> right = f.right_derivatives(u, p + 2), left = f.left_derivatives(u, j);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(right.size(), p + 3u);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(close<FT>(right[j], d(u), scale, 20 * p));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(close<FT>(left[j], left_value(d, u), scale, 20 * p));
include <CGAL/Geometric_continuity/extensions/extend.h>        if (j > p) BOOST_CHECK(right[j] == FT(0));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(d.degree(), std::max(0, p - j));
include <CGAL/Geometric_continuity/extensions/extend.h>      d = d.derivative();
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(d.knots().has_domain_of(f.knots()));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  // the derivative by its definition, as a limit of rational functions of the step: for a quadratic it is the mean of two
include <CGAL/Geometric_continuity/extensions/extend.h>  // difference quotients
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}}), {FT(1), FT(3), FT(-1), FT(5)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(f.derivative()(FT(1)) == FT((f(FT(2)) - f(FT(0))) / FT(2)));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(f.derivative().knots() == GC::Knot_vector<FT>(1, FT(0), FT(4), {{FT(2), 1}}));
include <CGAL/Geometric_continuity/extensions/extend.h>  // where the function may jump, one of the knots is superfluous in the derivative
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> jump(GC::Knot_vector<FT>(1, FT(0), FT(4), {{FT(2), 2}}), {FT(0), FT(2), FT(7), FT(3)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(jump.derivative() ==
include <CGAL/Geometric_continuity/extensions/extend.h>              Function<FT>(GC::Knot_vector<FT>(0, {FT(0), FT(2), FT(4)}), std::vector<FT>{FT(1), FT(-2)}));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- other knots
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(insertion, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(40, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : parameters(f.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const int m = f.knots().multiplicity(u), n = f.knots().number_of_coefficients();
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(f.insert(u, p + 2 - m), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int times = 0; times <= p + 1 - m; ++times) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const Function<FT> g = f.insert(u, times);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(g.knots().multiplicity(u), m + times);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(g.knots().number_of_coefficients(), n + times);
include <CGAL/Geometric_continuity/extensions/extend.h>        check_same(f, g, 2 * value_roundings(p));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      if (m > p) continue;
include <CGAL/Geometric_continuity/extensions/extend.h>      // Boehm's formula
include <CGAL/Geometric_continuity/extensions/extend.h>      const Function<FT> g = f.insert(u);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int i = 0; i <= n; ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT &low = f.knots()[i], &high = f.knots()[i + p];
include <CGAL/Geometric_continuity/extensions/extend.h>        if (!(low < u))
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(g[i] == f[std::max(i - 1, 0)]);
include <CGAL/Geometric_continuity/extensions/extend.h>        else if (!(u < high))
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(g[i] == f[std::min(i, n - 1)]);
include <CGAL/Geometric_continuity/extensions/extend.h>        else {
include <CGAL/Geometric_continuity/extensions/extend.h>          const FT a = (u - low) / (high - low);
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(close<FT>(g[i], FT((FT(1) - a) * f[i - 1] + a * f[i]), largest(f.coefficients()), 12));
include <CGAL/Geometric_continuity/extensions/extend.h>        }
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(f.insert(FT(f.domain().second + FT(1))), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// More copies of knots, and new knots.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> GC::Knot_vector<FT> finer(GC::Knot_vector<FT> knots, Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& u : parameters(knots, random))
include <CGAL/Geometric_continuity/extensions/extend.h>    knots = knots.insert(u, random.integer(0, knots.degree() + 1 - knots.multiplicity(u)));
include <CGAL/Geometric_continuity/extensions/extend.h>  return knots;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(refinement, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(40, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Knot_vector<FT> knots = finer(f.knots(), random);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> g = f.refine(knots), clamped = f.refine(knots.clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(g.knots() == knots);
include <CGAL/Geometric_continuity/extensions/extend.h>    check_same(f, g, 2 * value_roundings(p));
include <CGAL/Geometric_continuity/extensions/extend.h>    check_same(f, clamped, 2 * value_roundings(p));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(f.clamp().knots() == f.knots().clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>    check_same(f, f.clamp(), 2 * value_roundings(p));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(f.refine(f.knots()) == f);
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) { // knot by knot
include <CGAL/Geometric_continuity/extensions/extend.h>      Function<FT> h = f;
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const Knot<FT>& knot : knots.distinct_knots())
include <CGAL/Geometric_continuity/extensions/extend.h>        h = h.insert(knot.value, knot.multiplicity - h.knots().multiplicity(knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(h == g);
include <CGAL/Geometric_continuity/extensions/extend.h>    } else // convex combinations do not leave the range of the coefficients, up to their roundings
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(largest(g.coefficients()) <= largest(f.coefficients()) * (1 + value_roundings(p) * 0x1p-53));
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(f.refine(elevated_knots(f.knots())), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(f.refine(GC::Knot_vector<FT>(p, f.domain().first, FT(f.domain().second + FT(1)))),
include <CGAL/Geometric_continuity/extensions/extend.h>                parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    if (!f.knots().inner_knots().empty())
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(f.refine(GC::Knot_vector<FT>(p, f.domain().first, f.domain().second)), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  // knots outside the domain are no refinement
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Knot_vector<FT> u(1, {FT(0), FT(1), FT(2), FT(3)});
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(u, std::vector<FT>{FT(5), FT(7)});
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(f.refine(GC::Knot_vector<FT>(1, {FT(-1), FT(1), FT(2), FT(3)})), knot_multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(removal, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(40, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    // random coefficients need all their knots
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Knot<FT>& knot : f.knots().inner_knots()) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(!f.remove(knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(f.remove(knot.value, 0) == f);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(!f.remove(knot.value, knot.multiplicity + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(f.smoothness(knot.value), p - knot.multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(f.remove_superfluous_knots() == f);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& end : {f.domain().first, f.domain().second}) {
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(f.remove(end), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(f.smoothness(end), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Function<FT> g = f.refine(finer(f.knots(), random).clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(g.remove_superfluous_knots() == f.clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>      Function<FT> h = g;
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const Knot<FT>& knot : g.knots().inner_knots()) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const int more = knot.multiplicity - f.knots().multiplicity(knot.value);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(g.smoothness(knot.value), p - f.knots().multiplicity(knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(!h.remove(knot.value, more + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 0; i < more; ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_REQUIRE(h.remove(knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>          h = *h.remove(knot.value);
include <CGAL/Geometric_continuity/extensions/extend.h>        }
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(h == f.clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  // whole numbers, where the arithmetic of floating point is exact
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}}), {FT(0), FT(4), FT(8), FT(2)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(f.insert(FT(2)).remove(FT(2)) == f);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(f.insert(FT(1)).insert(FT(2), 2).remove_superfluous_knots() == f);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(!f.remove(FT(2)));
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> line(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 2}}), {FT(0), FT(1), FT(2), FT(3), FT(4)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(line.smoothness(FT(2)), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(line.smoothness(FT(3)), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(line.remove(FT(2), 2) ==
include <CGAL/Geometric_continuity/extensions/extend.h>              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(4)), std::vector<FT>{FT(0), FT(2), FT(4)}));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(bezier_pieces_and_back, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(40, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<FT> pieces = bspline_bezier(f.knots(), f.coefficients());
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<int> spans = f.knots().spans();
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(pieces.size(), spans.size() * (p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    for (std::size_t s = 0; s < spans.size(); ++s) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT &a = f.knots()[spans[s]], &b = f.knots()[spans[s] + 1];
include <CGAL/Geometric_continuity/extensions/extend.h>      const GC::Bernstein_polynomial<FT> piece(pieces.begin() + s * (p + 1), pieces.begin() + (s + 1) * (p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int i = 0; i <= p; ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT u = a + (b - a) * ratio<FT>(i, p + 1), t = (u - a) / (b - a);
include <CGAL/Geometric_continuity/extensions/extend.h>        if (u < b) BOOST_CHECK(close<FT>(piece(t), f(u), largest(f.coefficients()), 3 * value_roundings(p) + 8 * p));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<FT> back = bspline_from_bezier(f.knots(), pieces);
include <CGAL/Geometric_continuity/extensions/extend.h>    // at most p arguments outside a span, and p spans; knots far outside the domain make extrapolations of the coefficients
include <CGAL/Geometric_continuity/extensions/extend.h>    const double roundings = 2 * value_roundings(p) * std::pow(2 * p + 1, p);
include <CGAL/Geometric_continuity/extensions/extend.h>    if (exact_v<FT> || f.knots().is_clamped())
include <CGAL/Geometric_continuity/extensions/extend.h>      for (std::size_t i = 0; i < back.size(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(close<FT>(back[i], f[static_cast<int>(i)], largest(f.coefficients()), roundings));
include <CGAL/Geometric_continuity/extensions/extend.h>    if (exact_v<FT> || f.knots().is_clamped()) check_same(f, Function<FT>(f.knots(), back), roundings);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_from_bezier(f.knots(), std::vector<FT>(pieces.size() + 1, FT(0))), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(coefficients_must_fit_the_knots, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Knot_vector<FT> knots(2, FT(0), FT(4), {{FT(2), 1}});
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int n : {0, 3, 5}) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<FT> c(n, FT(1));
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Function<FT>(knots, c), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_value(knots, c, FT(1)), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_blossom(knots, c, 2, std::vector<FT>(2, FT(1))), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_derivative(knots, c), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_insert(knots, c, FT(1)), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_refine(knots, c, knots), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_bezier(knots, c), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_remove(knots, c, FT(2)), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(minimal_knots(knots, c), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_elevate(knots, c), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_product(knots, c, knots, std::vector<FT>(4, FT(1))), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(bspline_product(knots, std::vector<FT>(4, FT(1)), knots, c), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (!exact_v<FT>)
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Function<FT>(knots, std::vector<FT>{0, 1, std::numeric_limits<FT>::infinity(), 0}), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- elevation and product
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(elevation, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(30, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4), times = random.integer(0, 3), d = p + times;
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1)), g = f.elevate(times);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(g.degree(), d);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(g.knots().is_clamped());
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Knot<FT>> old = f.knots().inner_knots(), raised = g.knots().inner_knots();
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(old.size(), raised.size());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (std::size_t i = 0; i < old.size(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(old[i].value == raised[i].value);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(old[i].multiplicity + times, raised[i].multiplicity);
include <CGAL/Geometric_continuity/extensions/extend.h>      if constexpr (exact_v<FT>) BOOST_CHECK(!g.remove(raised[i].value));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    check_same(f, g, (2 * value_roundings(d) + 4 * d) * std::pow(2 * d + 1, d));
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(f.elevate(times).elevate() == f.elevate(times + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(f.clamp().elevate(times) == g);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(f.elevate() ==
include <CGAL/Geometric_continuity/extensions/extend.h>              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 2}}), {FT(0), FT(1), FT(2), FT(0), FT(-2)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(f.elevate(-1), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The multiplicity of each inner knot of a product of splines whose coefficients are not special.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> int product_multiplicity(const Function<FT>& f, const Function<FT>& g, const FT& u) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const int mf = f.knots().multiplicity(u), mg = g.knots().multiplicity(u);
include <CGAL/Geometric_continuity/extensions/extend.h>  return std::max(mf > 0 ? mf + g.degree() : 0, mg > 0 ? mg + f.degree() : 0);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> void check_product(const Function<FT>& f, const Function<FT>& g, Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> h = f * g;
include <CGAL/Geometric_continuity/extensions/extend.h>  const int d = f.degree() + g.degree();
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(h.degree(), d);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(h.knots().is_clamped());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(h.knots().has_domain_of(f.knots()));
include <CGAL/Geometric_continuity/extensions/extend.h>  // nonnegative weights everywhere but in the last step
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT scale = largest(f.coefficients()) * largest(g.coefficients());
include <CGAL/Geometric_continuity/extensions/extend.h>  const double roundings = (4 * value_roundings(d) + 6 * d) * std::pow(2 * d + 1, d);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& u : parameters(h.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(close<FT>(h(u), FT(f(u) * g(u)), scale, roundings));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(close<FT>(left_value(h, u), FT(left_value(f, u) * left_value(g, u)), scale, roundings));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const Knot<FT>& knot : h.knots().inner_knots()) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(knot.multiplicity, product_multiplicity(f, g, knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(f.knots().multiplicity(knot.value) + g.knots().multiplicity(knot.value) > 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const Function<FT>& x : {f, g})
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Knot<FT>& knot : x.knots().inner_knots()) BOOST_CHECK(h.knots().multiplicity(knot.value) > 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Knot<FT>& knot : h.knots().inner_knots()) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(!h.remove(knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>      // all one-sided derivatives, by Leibniz' rule
include <CGAL/Geometric_continuity/extensions/extend.h>      for (bool left : {false, true}) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const auto jet = [&](const Function<FT>& x) {
include <CGAL/Geometric_continuity/extensions/extend.h>          return left ? x.left_derivatives(knot.value, d) : x.right_derivatives(knot.value, d);
include <CGAL/Geometric_continuity/extensions/extend.h>        };
include <CGAL/Geometric_continuity/extensions/extend.h>        const std::vector<FT> hj = jet(h), fj = jet(f), gj = jet(g);
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int j = 0; j <= d; ++j) {
include <CGAL/Geometric_continuity/extensions/extend.h>          const std::vector<FT> binomials = GC::binomial_coefficients<FT>(j);
include <CGAL/Geometric_continuity/extensions/extend.h>          FT sum(0);
include <CGAL/Geometric_continuity/extensions/extend.h>          for (int i = 0; i <= j; ++i) sum += binomials[i] * fj[i] * gj[j - i];
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(hj[j] == sum);
include <CGAL/Geometric_continuity/extensions/extend.h>        }
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(h == g * f);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(products, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(40, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4), q = random.integer(0, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    // other knots on the same domain, some of them common, and some very near to each other
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT a = f.domain().first, b = f.domain().second;
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<FT> inner;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Knot<FT>& knot : f.knots().inner_knots())
include <CGAL/Geometric_continuity/extensions/extend.h>      if (random.coin()) inner.push_back(knot.value);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = random.integer(0, 2); i > 0; --i) inner.push_back(random.between(a, b));
include <CGAL/Geometric_continuity/extensions/extend.h>    std::sort(inner.begin(), inner.end());
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<Knot<FT>> knots;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : inner)
include <CGAL/Geometric_continuity/extensions/extend.h>      if (a < u && u < b && (knots.empty() || knots.back().value != u)) knots.push_back({u, random.integer(1, q + 1)});
include <CGAL/Geometric_continuity/extensions/extend.h>    GC::Knot_vector<FT> v(q, a, b, knots);
include <CGAL/Geometric_continuity/extensions/extend.h>    if (q > 0 && random.coin()) { // not clamped
include <CGAL/Geometric_continuity/extensions/extend.h>      std::vector<FT> w(v.begin(), v.end());
include <CGAL/Geometric_continuity/extensions/extend.h>      w.front() -= FT(1);
include <CGAL/Geometric_continuity/extensions/extend.h>      w.back() += FT(3);
include <CGAL/Geometric_continuity/extensions/extend.h>      v = GC::Knot_vector<FT>(q, w);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    check_product(f, random.function(v), random);
include <CGAL/Geometric_continuity/extensions/extend.h>    check_product(f, random.function(f.knots()), random);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(f * f ==
include <CGAL/Geometric_continuity/extensions/extend.h>              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 2}}), {FT(0), FT(0), FT(4), FT(-4), FT(4)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(f * Function<FT>(GC::Knot_vector<FT>(0, {FT(0), FT(3)}), {FT(1)}), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Cubics with simple knots: one argument outside a span, of two spans, multiplies the roundings by at most 3.
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(product_of_cubics_in_floating_point) {
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<double>(100, [](Random<double>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Knot_vector<double> u = random.knots(3, 1, false);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<double> f = random.function(u), g = random.function(u), h = f * g;
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto exact = [](const Function<double>& x) {
include <CGAL/Geometric_continuity/extensions/extend.h>      return Function<Q>(GC::Knot_vector<Q>(3, std::vector<Q>(x.knots().begin(), x.knots().end())),
include <CGAL/Geometric_continuity/extensions/extend.h>                         std::vector<Q>(x.coefficients().begin(), x.coefficients().end()));
include <CGAL/Geometric_continuity/extensions/extend.h>    };
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<Q> expected = exact(f) * exact(g);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(expected.coefficients().size(), h.coefficients().size());
include <CGAL/Geometric_continuity/extensions/extend.h>    const double scale = largest(f.coefficients()) * largest(g.coefficients());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < h.knots().number_of_coefficients(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(std::abs(CGAL::to_double(Q(Q(h[i]) - expected[i]))) <=
include <CGAL/Geometric_continuity/extensions/extend.h>                  3 * (2 * value_roundings(3) + 20) * 0x1p-53 * scale);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(sums, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(20, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 3), q = random.integer(0, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> g =
include <CGAL/Geometric_continuity/extensions/extend.h>        random.function(GC::Knot_vector<FT>(q, f.domain().first, f.domain().second,
include <CGAL/Geometric_continuity/extensions/extend.h>                                            {{random.between(f.domain().first, f.domain().second) * ratio<FT>(1, 2) +
include <CGAL/Geometric_continuity/extensions/extend.h>                                                  (f.domain().first + f.domain().second) * ratio<FT>(1, 4),
include <CGAL/Geometric_continuity/extensions/extend.h>                                              1}}));
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> sum = f + g, difference = f - g;
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(sum.degree(), std::max(p, q));
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT scale = largest(f.coefficients()) + largest(g.coefficients());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : parameters(sum.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(close<FT>(sum(u), FT(f(u) + g(u)), scale, 100 * value_roundings(3) * 343));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(close<FT>(difference(u), FT(f(u) - g(u)), scale, 100 * value_roundings(3) * 343));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) BOOST_CHECK(sum - f == (g + f) - f);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2)});
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(f + Function<FT>(GC::Knot_vector<FT>(1, FT(0), FT(3)), {FT(1), FT(1)}), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(reversal, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(20, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Function<FT> f = random.function(random.knots(p, p + 1)), r = f.reverse();
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(r.domain() == f.domain());
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const FT& u : parameters(f.knots(), random))
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(left_value(r, FT(f.domain().first + (f.domain().second - u))) == f(u) || u == f.domain().second);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(r.reverse() == f);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- curves
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class K> using Traits3 = GC::Traits_3<K>;
include <CGAL/Geometric_continuity/extensions/extend.h>template <class K> using Curve3 = GC::Bspline_curve<GC::Traits_3<K>>;
include <CGAL/Geometric_continuity/extensions/extend.h>template <class K> using Bezier3 = GC::Bezier_curve<GC::Traits_3<K>>;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The i-th coordinate as a function.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> Function<typename Traits::FT> coordinate(const GC::Bspline_curve<Traits>& c, int i) {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<typename Traits::FT> x;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int j = 0; j < c.number_of_points(); ++j) x.push_back(c.coordinates(j)[i]);
include <CGAL/Geometric_continuity/extensions/extend.h>  return Function<typename Traits::FT>(c.knots(), x);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Curves do what functions do, coordinate by coordinate, with the same arithmetic: compared with == in floating point, too.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits, class Test> void in_each_coordinate(const GC::Bspline_curve<Traits>& c, Test test) {
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = 0; i < c.dimension(); ++i) test(coordinate(c, i), i);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> void check_curve_operations(Random<typename Traits::FT>& random, int d) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Bspline_curve<Traits> Curve;
include <CGAL/Geometric_continuity/extensions/extend.h>  const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve c = random.template curve<Traits>(random.knots(p, p + 1), d);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(c.dimension(), d);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(c.degree(), p);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.domain() == c.knots().domain());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(c.function()) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Knot_vector<FT> knots = finer(c.knots(), random);
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT u = random.between(c.domain().first, c.domain().second);
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> factor(GC::Knot_vector<FT>(2, c.domain().first, c.domain().second), random.numbers(3));
include <CGAL/Geometric_continuity/extensions/extend.h>  const int times = c.knots().multiplicity(u) > p ? 0 : 1;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve derivative = c.derivative(), refined = c.refine(knots), inserted = c.insert(u, times),
include <CGAL/Geometric_continuity/extensions/extend.h>              elevated = c.elevate(2), reversed = c.reverse(), clamped = c.clamp(), scaled = product(factor, c),
include <CGAL/Geometric_continuity/extensions/extend.h>              minimal = refined.remove_superfluous_knots();
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(c.insert(u, 0), c);
include <CGAL/Geometric_continuity/extensions/extend.h>  in_each_coordinate(c, [&](const Function<FT>& x, int i) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(derivative, i) == x.derivative());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(refined, i) == x.refine(knots));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(inserted, i) == x.insert(u, times));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(elevated, i) == x.elevate(2));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(reversed, i) == x.reverse());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(clamped, i) == x.clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(coordinate(scaled, i) == factor * x);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& v : parameters(c.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const std::vector<FT> right = x.right_derivatives(v, p + 1), left = x.left_derivatives(v, p + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      const GC::Curve_jet<Traits> jet = c.jet(v, p + 1), right_jet = c.right_jet(v, p + 1),
include <CGAL/Geometric_continuity/extensions/extend.h>                                  left_jet = c.left_jet(v, p + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(jet.order(), p + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int j = 0; j <= p + 1; ++j) {
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(jet[j][i] == right[j]);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(right_jet[j][i] == right[j]);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(left_jet[j][i] == left[j]);
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(GC::coordinates<Traits>(c(v))[i] == x(v));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.start_jet(3)[2][i] == x.right_derivatives(c.domain().first, 2)[2]);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.end_jet(3)[2][i] == x.left_derivatives(c.domain().second, 2)[2]);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  if (c.knots().is_clamped()) { // exactly, in floating point as well
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.start_jet(2)[0] == c.coordinates(0));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.end_jet(2)[0] == c.coordinates(c.number_of_points() - 1));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(minimal == c || minimal.knots() != c.knots());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Knot<FT>& knot : c.knots().inner_knots()) BOOST_CHECK(!c.remove(knot.value));
include <CGAL/Geometric_continuity/extensions/extend.h>    if (c.knots().multiplicity(u) == 0) BOOST_CHECK(*c.insert(u).remove(u) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& v : {FT(c.domain().first - FT(1)), FT(c.domain().second + FT(1))}) {
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c(v), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.jet(v, 2), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.left_jet(v, 2), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.insert(v), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(curves_are_functions_in_each_coordinate, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(12, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    check_curve_operations<GC::Traits_2<K>>(random, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>    check_curve_operations<GC::Traits_3<K>>(random, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(curves_in_higher_dimension) {
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<Q>(10, [](Random<Q>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    check_curve_operations<GC::Traits_d<CGAL::Cartesian_d<Q>>>(random, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>    check_curve_operations<GC::Traits_d<CGAL::Cartesian_d<Q>>>(random, 5);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// What the concept of a traits class does not offer is not used.
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(curves_over_an_archetype) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef archetype::Traits<CGAL::Dimension_tag<2>> Traits;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef archetype::Number FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Bspline_curve<Traits> Curve;
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto point = [](int x, int y) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT c[] = {FT(x), FT(y)};
include <CGAL/Geometric_continuity/extensions/extend.h>    return Traits().construct_point_object()(2, c, c + 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Traits::Point> points{point(0, 0), point(2, 4), point(4, 4), point(8, 0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve c(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}));
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT half = FT(FT(1) / FT(2));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.jet(half, 3)[0] == c.insert(half).jet(half, 3)[0]);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.elevate(2).jet(half, 3) == c.jet(half, 3));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(*c.insert(half).remove(half) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.insert(half, 2).remove_superfluous_knots() == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.reverse().reverse() == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.derivative().jet(half, 0)[0] == c.jet(half, 1)[1]);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<GC::Bezier_curve<Traits>> pieces = c.bezier_pieces();
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(pieces.begin(), pieces.end()).remove_superfluous_knots() == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  const Function<FT> f(GC::Knot_vector<FT>(1, FT(0), FT(2)), {FT(1), FT(3)});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(product(f, c).jet(FT(1), 0)[0] == FT(2) * c.jet(FT(1), 0)[0]);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(knot_continuity(c, FT(1)).c_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(knot_continuities(c).size(), 1u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(continuity(c, blend(c, c), 2).g_order, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(GC::extend(c, GC::Frenet_order::curvature).number_of_points(), 6);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(GC::extend_toward(c, GC::Frenet_order::tangent, point(9, 1)).number_of_points(), 6);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL((f + f)[1] == FT(6), true);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(bezier_curves_and_back, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Curve3<K> Curve;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Bezier3<K> Bezier;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(25, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(1, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Curve c = random.template curve<Traits3<K>>(random.knots(p, p), 3); // continuous
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Bezier> pieces = c.bezier_pieces();
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<int> spans = c.knots().spans();
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(pieces.size(), spans.size());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (std::size_t i = 0; i < pieces.size(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT &a = c.knots()[spans[i]], &b = c.knots()[spans[i] + 1];
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(pieces[i].domain() == std::make_pair(a, b));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(pieces[i].degree(), p);
include <CGAL/Geometric_continuity/extensions/extend.h>      if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(pieces[i].start_jet(p) == c.right_jet(a, p));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(pieces[i].end_jet(p) == c.left_jet(b, p));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Curve joined(pieces.begin(), pieces.end());
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const Knot<FT>& knot : joined.knots().inner_knots()) BOOST_CHECK_EQUAL(knot.multiplicity, p);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(joined.knots().inner_knots().size(), pieces.size() - 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(joined.bezier_pieces() == pieces);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(joined.remove_superfluous_knots() == c.clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  const typename K::Point_3 a(0, 0, 0), b(1, 2, 0), x(3, 2, 1), y(4, 0, 1), z(6, 1, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  const Bezier line({a, b}), parabola({b, x, y}), far({z, a});
include <CGAL/Geometric_continuity/extensions/extend.h>  // a line elevated, and domains that do not continue each other
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier> mixed{line, parabola, Bezier({y, z}).with_domain(FT(7), FT(10))};
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve joined(mixed.begin(), mixed.end());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(joined.knots() == GC::Knot_vector<FT>(2, FT(0), FT(5), {{FT(1), 2}, {FT(2), 2}}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joined.number_of_points(), 7);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(joined.control_point(0) == a && joined.control_point(2) == b && joined.control_point(3) == x &&
include <CGAL/Geometric_continuity/extensions/extend.h>              joined.control_point(4) == y && joined.control_point(6) == z);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(joined.coordinates(1)[1] == FT(1));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(joined(FT(5)) == z);
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Composite_bezier_curve<Traits3<K>> segmented(mixed.begin(), mixed.end());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(segmented.segments().begin(), segmented.segments().end()) == joined);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier> gap{line, far}, none;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error_of([&] { Curve(gap.begin(), gap.end()); }),
include <CGAL/Geometric_continuity/extensions/extend.h>                    "curves_do_not_meet: Bspline_curve: Bezier curve 1");
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Curve(none.begin(), none.end()), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  // points, where the degree 0 leaves no inner knot
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier> points{Bezier({a}), Bezier({a})};
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(points.begin(), points.end()).knots() == GC::Knot_vector<FT>(0, FT(0), FT(2)));
include <CGAL/Geometric_continuity/extensions/extend.h>  // one curve
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(parabola) == Curve(&parabola, &parabola + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(parabola).bezier_pieces() == std::vector<Bezier>{parabola});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Curve(parabola).knots() == GC::Knot_vector<FT>(2, FT(0), FT(1)));
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (!exact_v<FT>) { // the length of the second domain vanishes beside the first
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Bezier> tiny{line.with_domain(FT(0), FT(1e20)), parabola};
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Curve(tiny.begin(), tiny.end()), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(bezier_curves_of_different_dimensions_do_not_join) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef CGAL::Cartesian_d<Q> K;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Bezier_curve<GC::Traits_d<K>> Bezier;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Q zeros[] = {Q(0), Q(0), Q(0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const K::Point_d plane(2, zeros, zeros + 2), space(3, zeros, zeros + 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier> two{Bezier({plane, plane}), Bezier({space, space})};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Bspline_curve<GC::Traits_d<K>>(two.begin(), two.end()), dimension_mismatch);
include <CGAL/Geometric_continuity/extensions/extend.h>  const K::Point_d points[] = {plane, space};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::Bspline_curve<GC::Traits_d<K>>(points, points + 2, GC::Knot_vector<Q>(1, Q(0), Q(1))),
include <CGAL/Geometric_continuity/extensions/extend.h>              dimension_mismatch);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(refused_curves_equality_and_output, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Bspline_curve<GC::Traits_2<K>> Curve;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::Point_2 Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(3, 4), Point(5, 6)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Knot_vector<FT> knots(2, FT(0), FT(4), {{FT(1), 1}});
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve c(points.begin(), points.end(), knots);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error_of([&] { Curve(points.begin(), points.end() - 1, knots); }),
include <CGAL/Geometric_continuity/extensions/extend.h>                    "wrong_number_of_points: Bspline_curve: 3 coefficients where the knots need 4");
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Point> others = points;
include <CGAL/Geometric_continuity/extensions/extend.h>  others[3] = Point(5, 7);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c == Curve(points.begin(), points.end(), knots));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c != Curve(others.begin(), others.end(), knots));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c != Curve(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}})));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::ostringstream os;
include <CGAL/Geometric_continuity/extensions/extend.h>  os << c;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(os.str(), "B-spline curve of degree 2 over 0 0 0 1 4 4 4: (0, 0) (1, 2) (3, 4) (5, 6)");
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (!exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>    others[1] = Point(std::numeric_limits<FT>::quiet_NaN(), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Curve(others.begin(), others.end(), knots), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  const CGAL::Aff_transformation_2<K> shift(CGAL::TRANSLATION, typename K::Vector_2(1, -1));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.transform(shift).control_point(1) == Point(2, 1));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.transform(shift).knots() == knots);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- continuity and blends
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class K> constexpr bool exact_predicates_v = !std::is_same_v<K, CGAL::Simple_cartesian<double>>;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(continuity_at_knots, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  // in the kernel without exact predicates there is no certain answer
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (exact_predicates_v<K>)
include <CGAL/Geometric_continuity/extensions/extend.h>    repeat<FT>(25, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>      Curve3<K> c = random.template curve<Traits3<K>>(random.knots(p, p + 1), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>      // numbers with all digits
include <CGAL/Geometric_continuity/extensions/extend.h>      if constexpr (!exact_v<FT>) c = c.reverse().refine(c.knots().reverse().clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>      const auto all = knot_continuities(c, p + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      const std::vector<Knot<FT>> knots = c.knots().inner_knots();
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_REQUIRE_EQUAL(all.size(), knots.size());
include <CGAL/Geometric_continuity/extensions/extend.h>      for (std::size_t i = 0; i < all.size(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const int m = knots[i].multiplicity;
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(all[i].knot == knots[i].value);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(all[i].multiplicity, m);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(all[i].join.c_order, p - m);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(knot_continuity(c, knots[i].value, 1).c_order, std::min(p - m, 1));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(c.function().smoothness(knots[i].value), p - m);
include <CGAL/Geometric_continuity/extensions/extend.h>        if (m < p) BOOST_CHECK(all[i].join.g_order >= std::min(p - m, 1));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT u = random.between(c.domain().first, c.domain().second);
include <CGAL/Geometric_continuity/extensions/extend.h>      if (c.knots().multiplicity(u) == 0) BOOST_CHECK_EQUAL(knot_continuity(c, u, 7).c_order, 7);
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(knot_continuity(c, c.domain().first), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(knot_continuity(c, c.domain().second), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>      CHECK_ERROR(knot_continuity(c, FT(c.domain().second + FT(1))), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    });
include <CGAL/Geometric_continuity/extensions/extend.h>  // whole numbers: a corner, a curve that is G1 and not C1, and one with the same curvature on both sides
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::Point_2 Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Bspline_curve<GC::Traits_2<K>> Curve;
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto join = [](std::vector<Point> points, int multiplicity) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return knot_continuity(
include <CGAL/Geometric_continuity/extensions/extend.h>        Curve(points.begin(), points.end(), GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), multiplicity}})), FT(2));
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto corner = join({Point(0, 0), Point(2, 0), Point(4, 0), Point(4, 2), Point(4, 4)}, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(corner.c_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(corner.g_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto smooth = join({Point(0, 4), Point(0, 0), Point(2, 0), Point(6, 0), Point(8, 8)}, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(smooth.c_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(smooth.g_order >= 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(smooth.betas[0], FT(2));
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto simple = join({Point(0, 0), Point(2, 4), Point(6, 4), Point(9, 0)}, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(simple.c_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto jump = join({Point(0, 0), Point(2, 4), Point(6, 4), Point(8, 0), Point(9, 9), Point(10, 3)}, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(jump.c_order, -1);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The same curve with rational coordinates.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class K> Curve3<CGAL::Simple_cartesian<Q>> rational(const Curve3<K>& c) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef CGAL::Simple_cartesian<Q> Exact;
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Exact::Point_3> points;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = 0; i < c.number_of_points(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>    points.emplace_back(Q(c.coordinates(i)[0]), Q(c.coordinates(i)[1]), Q(c.coordinates(i)[2]));
include <CGAL/Geometric_continuity/extensions/extend.h>  return {points.begin(), points.end(),
include <CGAL/Geometric_continuity/extensions/extend.h>          GC::Knot_vector<Q>(c.degree(), std::vector<Q>(c.knots().begin(), c.knots().end()))};
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(jets_over_another_field_are_exact) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef CGAL::Epick K;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<double>(20, [](Random<double>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(0, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Curve3<K> c = random.curve<Traits3<K>>(random.knots(p, p + 1), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Curve3<CGAL::Simple_cartesian<Q>> exact = rational<K>(c);
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto same = [](const GC::Coordinate_jet<Q, 3>& x, const GC::Coordinate_jet<Q, 3>& y) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(x.order(), 5);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(x == y);
include <CGAL/Geometric_continuity/extensions/extend.h>    };
include <CGAL/Geometric_continuity/extensions/extend.h>    same(c.start_jet_over<Q>(5), exact.start_jet(5));
include <CGAL/Geometric_continuity/extensions/extend.h>    same(c.end_jet_over<Q>(5), exact.end_jet(5));
include <CGAL/Geometric_continuity/extensions/extend.h>    for (double u : parameters(c.knots(), random)) {
include <CGAL/Geometric_continuity/extensions/extend.h>      same(c.left_jet_over<Q>(u, 5), exact.left_jet(Q(u), 5));
include <CGAL/Geometric_continuity/extensions/extend.h>      same(c.right_jet_over<Q>(u, 5), exact.right_jet(Q(u), 5));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(splines_are_blended_and_joined, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(10, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const Curve3<K> phi = random.template curve<Traits3<K>>(random.knots(3, 2, !exact_v<FT>), 3),
include <CGAL/Geometric_continuity/extensions/extend.h>                    psi = random.template curve<Traits3<K>>(random.knots(random.integer(2, 4), 2), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<FT> x = random.numbers(9);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Bezier3<K> bezier({typename K::Point_3(x[0], x[1], x[2]), typename K::Point_3(x[3], x[4], x[5]),
include <CGAL/Geometric_continuity/extensions/extend.h>                             typename K::Point_3(x[6], x[7], x[8])});
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto quintic = blend(phi, psi);
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto mixed = blend(bezier, psi, GC::Minimal_second_derivative());
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto septic = blend(phi, psi, GC::Sequential_g3());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(quintic.start_jet(0)[0] == phi.end_jet(0)[0]);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(quintic.end_jet(0)[0] == psi.start_jet(0)[0]);
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(continuity(phi, quintic, 2).g_order, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(continuity(quintic, psi, 2).g_order, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(continuity(mixed, psi, 2).g_order, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(continuity(phi, septic, 3).g_order, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(continuity(septic, psi, 3).g_order, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>      // splines that continue each other
include <CGAL/Geometric_continuity/extensions/extend.h>      const std::vector<Bezier3<K>> pieces = phi.bezier_pieces();
include <CGAL/Geometric_continuity/extensions/extend.h>      for (std::size_t i = 1; i < pieces.size(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(continuity(Curve3<K>(pieces[i - 1]), Curve3<K>(pieces[i]), 3).c_order,
include <CGAL/Geometric_continuity/extensions/extend.h>                          3 - phi.knots().multiplicity(pieces[i].domain().first));
include <CGAL/Geometric_continuity/extensions/extend.h>    } else if constexpr (exact_predicates_v<K>) // the clamped end point is a control point, taken over without rounding
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(continuity(phi.clamp(), blend(phi.clamp(), psi), 2).c_order >= 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Clamped or not, and with inner knots of any multiplicity: the last span decides.
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(splines_are_extended, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(6, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int p = random.integer(3, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Curve3<K> c = random.template curve<Traits3<K>>(random.knots(p, p), 3), clamped = c.clamp();
include <CGAL/Geometric_continuity/extensions/extend.h>    const Bezier3<K> last = clamped.bezier_pieces().back();
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT beta = ratio<FT>(random.integer(1, 9), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<FT> x = random.numbers(3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const typename K::Point_3 wished(x[0], x[1], x[2]);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion})
include <CGAL/Geometric_continuity/extensions/extend.h>      for (bool toward : {false, true}) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const GC::Extension_parameters<FT> parameters{beta, random.number(), random.number(), random.number()};
include <CGAL/Geometric_continuity/extensions/extend.h>        const Curve3<K> longer = toward ? GC::extend_toward(c, order, wished, beta) : GC::extend(c, order, parameters);
include <CGAL/Geometric_continuity/extensions/extend.h>        const Bezier3<K> next =
include <CGAL/Geometric_continuity/extensions/extend.h>            toward ? GC::extend_toward(last, order, wished, beta) : GC::extend(last, order, parameters);
include <CGAL/Geometric_continuity/extensions/extend.h>        // the old control points, then those of the new segment
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_REQUIRE_EQUAL(longer.number_of_points(), clamped.number_of_points() + p);
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 0; i < clamped.number_of_points(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(longer.control_point(i) == clamped.control_point(i));
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 1; i <= p; ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(longer.control_point(clamped.number_of_points() - 1 + i) == next.control_point(i));
include <CGAL/Geometric_continuity/extensions/extend.h>        // the old knots, a join of multiplicity p, and the end of the new segment
include <CGAL/Geometric_continuity/extensions/extend.h>        std::vector<Knot<FT>> inner = clamped.knots().inner_knots();
include <CGAL/Geometric_continuity/extensions/extend.h>        inner.push_back({c.domain().second, p});
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(longer.knots() == GC::Knot_vector<FT>(p, c.domain().first, next.domain().second, inner));
include <CGAL/Geometric_continuity/extensions/extend.h>        if (toward && static_cast<int>(order) < p) BOOST_CHECK(longer(longer.domain().second) == wished);
include <CGAL/Geometric_continuity/extensions/extend.h>        if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(longer.bezier_pieces().back() == next);
include <CGAL/Geometric_continuity/extensions/extend.h>          for (const FT& u : ::parameters(c.knots(), random)) BOOST_CHECK(longer.left_jet(u, p) == c.left_jet(u, p));
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK_GE(knot_continuity(longer, c.domain().second).f_order, static_cast<int>(order));
include <CGAL/Geometric_continuity/extensions/extend.h>        } else if constexpr (exact_predicates_v<K>)
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK_GE(knot_continuity(longer, c.domain().second).c_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    // without parameters the last polynomial goes on, and the join is no knot at all
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Curve3<K> on = GC::extend(c, GC::Frenet_order::torsion, {beta, {}, {}, {}});
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(on.function().smoothness(c.domain().second), p);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(on.remove_superfluous_knots().knots().inner_knots().size() == c.knots().inner_knots().size());
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(GC::extend(c, GC::Frenet_order::tangent, {FT(0), {}, {}, {}}), nonpositive_beta);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(GC::extend_toward(c, GC::Frenet_order::tangent, wished, FT(-1)), nonpositive_beta);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::Point_3 P;
include <CGAL/Geometric_continuity/extensions/extend.h>  // only the last span is asked whether it can be extended: its points are equal, then those before it
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Knot_vector<FT> knots(1, FT(0), FT(2), {{FT(1), 1}});
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<P> stops{P(0, 0, 0), P(1, 0, 0), P(1, 0, 0)}, starts{P(1, 0, 0), P(1, 0, 0), P(2, 0, 0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::extend(Curve3<K>(stops.begin(), stops.end(), knots), GC::Frenet_order::tangent), zero_tangent);
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve3<K> line = GC::extend(Curve3<K>(starts.begin(), starts.end(), knots), GC::Frenet_order::tangent);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(line(FT(3)) == P(3, 0, 0));
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(GC::extend(line, GC::Frenet_order::curvature), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  // the segment that closes a spline, from its own ends
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<P> arch{P(0, 0, 0), P(0, 4, 0), P(4, 4, 4), P(4, 0, 0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const Curve3<K> open(arch.begin(), arch.end(), GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}));
include <CGAL/Geometric_continuity/extensions/extend.h>  const Bezier3<K> closing = GC::close(open, open, GC::Frenet_order::tangent);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(closing.control_point(0) == P(4, 0, 0) && closing.control_point(3) == P(0, 0, 0));
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (exact_v<FT>) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(continuity(open, closing, 1).g_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(continuity(closing, open, 1).g_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// A chain of splines and their blends.
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(chains_of_splines) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef CGAL::Simple_cartesian<Q> K;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<Q>(5, [](Random<Q>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const Curve3<K> phi = random.curve<Traits3<K>>(random.knots(3, 2), 3),
include <CGAL/Geometric_continuity/extensions/extend.h>                    psi = random.curve<Traits3<K>>(random.knots(4, 2), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Curve3<K>> chain{phi, Curve3<K>(blend(phi, psi)), psi,
include <CGAL/Geometric_continuity/extensions/extend.h>                                       Curve3<K>(blend(psi, phi, GC::Sequential_g3()))};
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Chain_summary summary = GC::chain_continuity(chain.begin(), chain.end(), 3, true);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(*summary.least_order(GC::Continuity_kind::G), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(summary.counts(GC::Continuity_kind::G).at(3), 2u);
include <CGAL/Geometric_continuity/extensions/extend.h>    // the pieces as a segmented curve, and back
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Bezier3<K>> pieces = phi.bezier_pieces();
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Composite_bezier_curve<Traits3<K>> segmented(pieces.begin(), pieces.end());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(Curve3<K>(segmented.segments().begin(), segmented.segments().end()).remove_superfluous_knots() ==
include <CGAL/Geometric_continuity/extensions/extend.h>                phi.clamp());
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto joins = GC::chain_continuity(segmented).joins;
include <CGAL/Geometric_continuity/extensions/extend.h>    const auto knots = knot_continuities(phi);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(joins.size(), knots.size());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (std::size_t i = 0; i < joins.size(); ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(joins[i].continuity.c_order, knots[i].join.c_order);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ---------------------------------------------------------------- files
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(splines_in_files, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  repeat<FT>(10, [](Random<FT>& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<Curve3<K>> curves;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int p = 0; p <= 4; ++p) curves.push_back(random.template curve<Traits3<K>>(random.knots(p, p + 1), 3));
include <CGAL/Geometric_continuity/extensions/extend.h>    std::stringstream text;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Curve3<K>& curve : curves) GC::write_g2(text, curve);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(GC::read_g2_bsplines<Traits3<K>>(text, "f.g2") == curves);
include <CGAL/Geometric_continuity/extensions/extend.h>    // a Bezier curve is written and read as both
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Bezier3<K>> pieces = curves[3].bezier_pieces();
include <CGAL/Geometric_continuity/extensions/extend.h>    std::stringstream bezier, spline;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Bezier3<K>& piece : pieces) {
include <CGAL/Geometric_continuity/extensions/extend.h>      GC::write_g2(bezier, piece);
include <CGAL/Geometric_continuity/extensions/extend.h>      GC::write_g2(spline, Curve3<K>(piece));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(bezier.str(), spline.str());
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(GC::read_g2_curves<Traits3<K>>(spline, "f.g2") == pieces);
include <CGAL/Geometric_continuity/extensions/extend.h>    const std::vector<Curve3<K>> read = GC::read_g2_bsplines<Traits3<K>>(bezier, "f.g2");
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(read.size(), pieces.size());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (std::size_t i = 0; i < read.size(); ++i) BOOST_CHECK(read[i] == Curve3<K>(pieces[i]));
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(refused_splines_in_files, K, Kernels) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Traits_2<K> Traits;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename K::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto text = [](const std::string& size, const std::string& knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return "100 1 0 0\n2 0\n" + size + "\n" + knots + "\n0 0\n1 2\n3 4\n5 6\n";
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto error = [&](const std::string& size, const std::string& knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>    std::istringstream is(text(size, knots));
include <CGAL/Geometric_continuity/extensions/extend.h>    return error_of([&] { GC::read_g2_bsplines<Traits>(is, "f.g2"); });
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto refused = [](int line, const std::string& reason) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return "malformed_input: f.g2:" + std::to_string(line) + ": " + reason;
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1/2 2 2 2"), "no error");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "-2 -1 0 1/2 2 3 4"), "no error");
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1/2 2 2\n1"), refused(5, "the knots decrease at '1'"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "0 0 1\n.5 2 2 2"), refused(5, "the knots decrease at '.5'"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "0 0 0\n0 2 2 2"), refused(5, "knot 4 of 7 is repeated more than 3 times"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "0 1 2 2 2 3 4"), refused(4, "knot 3 of 7 is equal to knot 5: empty domain"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1 1 1\n1"), refused(5, "knot 7 of 7 is repeated more than 3 times"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("4 5", ""), refused(3, "4 control points and order 5: there must be at least as many control "
include <CGAL/Geometric_continuity/extensions/extend.h>                                                 "points as the order says"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("2147483647 3", "0 0 0 1 2 x"), refused(4, "not a number: 'x'"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("5 3", "0 0 0 1 2 3 3 3"), refused(8, "file ends after 4 of 5 control points"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error("40 3", "0"), refused(8, "file ends after 9 of 43 knots"));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::istringstream inner(text("4 3", "0 0 0 1/2 2 2 2"));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_curves<Traits>(inner, "f.g2"); }),
include <CGAL/Geometric_continuity/extensions/extend.h>                    refused(3, "4 control points and order 3: inner knots are not supported, only Bezier curves"));
include <CGAL/Geometric_continuity/extensions/extend.h>  // numbers as written
include <CGAL/Geometric_continuity/extensions/extend.h>  std::istringstream good(text("4 3", "0 0 0 1/4 2 2 2"));
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Bspline_curve<Traits> c = GC::read_g2_bsplines<Traits>(good, "f.g2").at(0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.knots() == GC::Knot_vector<FT>(2, FT(0), FT(2), {{ratio<FT>(1, 4), 1}}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c.control_point(3) == typename K::Point_2(5, 6));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::ostringstream os;
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::write_g2(os, c);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(os.str(), "100 1 0 0\n2 0\n4 3\n0 0 0 " + std::string(exact_v<FT> ? "1/4" : "0.25") +
include <CGAL/Geometric_continuity/extensions/extend.h>                                  " 2 2 2\n0 0\n1 2\n3 4\n5 6\n\n");
include <CGAL/Geometric_continuity/extensions/extend.h>}
