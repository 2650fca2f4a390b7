// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random.h"

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>

// The tests of splines have this in common. In exact kernels all identities hold with ==. In
// rounded kernels the bounds are multiples of the unit roundoff u = 2^-53, times the largest
// coefficient:
// - A weight of a value or a blossom is made in p levels of a triangle, each with 6 roundings,
//   where all terms are nonnegative; the sum over p + 1 coefficients adds p + 2. So values and
//   coefficients over finer knots are known to value_roundings(p) = 7 p + 2.
// - Arguments of a blossom outside its span multiply the sum of the absolute weights by at most 2
//   s - 1 each, where s is the number of spans between the arguments.

typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Simple_cartesian<double>, CGAL::Epeck, CGAL::Epick> Kernels;

template <class FT> constexpr bool exact_v = !std::is_floating_point_v<FT>;

template <class K> constexpr bool exact_predicates_v = !std::is_same_v<K, CGAL::Simple_cartesian<double>>;

template <class FT> using Knot = typename GC::Knot_vector<FT>::Knot;
template <class FT> using Function = GC::Bspline_function<FT>;
template <class K> using Traits3 = GC::Traits_3<K>;
template <class K> using Curve3 = GC::Bspline_curve<GC::Traits_3<K>>;
template <class K> using Bezier3 = GC::Bezier_curve<GC::Traits_3<K>>;

// ---------------------------------------------------------------- random input

template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }

template <class FT> class Random : public Random_integers<> {
public:
  // at most 9 in absolute value; in floating point with few digits
  FT number() {
    return exact_v<FT> ? this->template fraction_of<FT>(-999, 999, 111, 999) : ratio<FT>(integer(-999, 999), 128);
  }
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

  // Makes knots of degree p: inner knots have the multiplicity 1 to `highest`; sometimes not
  // clamped, when that is allowed.
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
  for (int i = 0; i < times; ++i) BOOST_TEST_CONTEXT("seed " << random.seed << ", round " << i) test(random);
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

// ------------------------------------------------------------ bounds and an independent definition

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

// N_i^p(u) by the recursion of Cox, de Boor and Mansfield. On the intervals [u_i, u_{i+1}), or
// (u_i, u_{i+1}] from the left.
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

// Checks that two functions are the same: at p + 1 parameters in each span, and from both sides at
// its ends.
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

// More copies of knots, and new knots.
template <class FT> GC::Knot_vector<FT> finer(GC::Knot_vector<FT> knots, Random<FT>& random) {
  for (const FT& u : parameters(knots, random))
    knots = knots.insert(u, random.integer(0, knots.degree() + 1 - knots.multiplicity(u)));
  return knots;
}
