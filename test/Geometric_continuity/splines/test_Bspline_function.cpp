// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Spline functions: values, blossoms and derivatives, other knots, elevation, product.

#include "support/splines.h"

// ---------------------------------------------------------------- values, blossoms, derivatives

TEST_FOR_EACH(basis_and_values_are_those_of_the_recursion, K, Kernels) {
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

TEST_FOR_EACH(greville_abscissae_reproduce_the_parameter, K, Kernels) {
  repeat<FT>(20, [](Random<FT>& random) {
    const int p = random.integer(1, 5);
    const GC::Knot_vector<FT> knots = random.knots(p, p + 1);
    std::vector<FT> c;
    for (int i = 0; i < knots.number_of_coefficients(); ++i) c.push_back(knots.greville_abscissa(i));
    for (const FT& u : parameters(knots, random))
      BOOST_CHECK(close<FT>(bspline_value(knots, c, u), u, largest(c), value_roundings(p) + p));
  });
}

TEST_FOR_EACH(blossoms, K, Kernels) {
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

// Bounds the loss of a sum of at most p + 1 terms in the j-th derivative: the quotients are at most
// 2 p / h for the shortest difference h of knots, so that the j-th derivative of coefficients up to
// 1 is at most (2 p / h)^j.
template <class FT> FT derivative_scale(const Function<FT>& f, int j) {
  FT h = f.domain().second - f.domain().first;
  for (int k : f.knots().spans()) h = std::min(h, FT(f.knots()[k + 1] - f.knots()[k]));
  FT scale = largest(f.coefficients());
  for (; j > 0; --j) scale *= FT(2 * f.degree()) / h;
  return scale;
}

TEST_FOR_EACH(derivatives, K, Kernels) {
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
  // the derivative by its definition, as a limit of rational functions of the step: for a quadratic
  // it is the mean of two difference quotients
  const Function<FT> f(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 1}}), {FT(1), FT(3), FT(-1), FT(5)});
  BOOST_CHECK(f.derivative()(FT(1)) == FT((f(FT(2)) - f(FT(0))) / FT(2)));
  BOOST_CHECK(f.derivative().knots() == GC::Knot_vector<FT>(1, FT(0), FT(4), {{FT(2), 1}}));
  // where the function may jump, one of the knots is superfluous in the derivative
  const Function<FT> jump(GC::Knot_vector<FT>(1, FT(0), FT(4), {{FT(2), 2}}), {FT(0), FT(2), FT(7), FT(3)});
  BOOST_CHECK(jump.derivative() ==
              Function<FT>(GC::Knot_vector<FT>(0, {FT(0), FT(2), FT(4)}), std::vector<FT>{FT(1), FT(-2)}));
}

// ---------------------------------------------------------------- other knots

TEST_FOR_EACH(insertion, K, Kernels) {
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

TEST_FOR_EACH(refinement, K, Kernels) {
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

TEST_FOR_EACH(removal, K, Kernels) {
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
  const Function<FT> twice = f.insert(FT(2));
  BOOST_CHECK(GC::bspline_remove<FT>(twice.knots(), twice.coefficients(), FT(2)) == f.coefficients());
  BOOST_CHECK(f.insert(FT(1)).insert(FT(2), 2).remove_superfluous_knots() == f);
  BOOST_CHECK(!f.remove(FT(2)));
  const Function<FT> line(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(2), 2}}), {FT(0), FT(1), FT(2), FT(3), FT(4)});
  BOOST_CHECK_EQUAL(line.smoothness(FT(2)), 2);
  BOOST_CHECK_EQUAL(line.smoothness(FT(3)), 2);
  BOOST_CHECK(line.remove(FT(2), 2) ==
              Function<FT>(GC::Knot_vector<FT>(2, FT(0), FT(4)), std::vector<FT>{FT(0), FT(2), FT(4)}));
}

TEST_FOR_EACH(bezier_pieces_and_back, K, Kernels) {
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
    // at most p arguments outside a span, and p spans; knots far outside the domain make
    // extrapolations of the coefficients
    const double roundings = 2 * value_roundings(p) * std::pow(2 * p + 1, p);
    if (exact_v<FT> || f.knots().is_clamped())
      for (std::size_t i = 0; i < back.size(); ++i)
        BOOST_CHECK(close<FT>(back[i], f[static_cast<int>(i)], largest(f.coefficients()), roundings));
    if (exact_v<FT> || f.knots().is_clamped()) check_same(f, Function<FT>(f.knots(), back), roundings);
    CHECK_ERROR(bspline_from_bezier(f.knots(), std::vector<FT>(pieces.size() + 1, FT(0))), wrong_number_of_points);
  });
}

TEST_FOR_EACH(coefficients_must_fit_the_knots, K, Kernels) {
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

TEST_FOR_EACH(elevation, K, Kernels) {
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
  CHECK_ERROR(f.elevate(-1), negative_count);
}

TEST_FOR_EACH(counts_that_are_refused, K, Kernels) {
  const Function<FT> f(GC::Knot_vector<FT>(2, FT(0), FT(2), {{FT(1), 1}}), {FT(0), FT(2), FT(-2), FT(1)}), copy = f;
  CHECK_ERROR(f.insert(FT(1), -1), negative_count);
  CHECK_ERROR(f.remove(FT(1), -1), negative_count);
  CHECK_ERROR(f.elevate(-2), negative_count);
  CHECK_ERROR(f.right_derivatives(FT(1), -1), negative_count);
  CHECK_ERROR(f.left_derivatives(FT(1), -2), negative_count);
  CHECK_ERROR(GC::elevated_knots(f.knots(), -1), negative_count);
  CHECK_ERROR(bspline_elevate(f.knots(), f.coefficients(), -1), negative_count);
  CHECK_ERROR(bspline_insert(f.knots(), f.coefficients(), FT(1), -1), negative_count);
  CHECK_ERROR(bspline_remove(f.knots(), f.coefficients(), FT(1), -1), negative_count);
  // neither span 1, before the domain, nor 4, behind it
  for (int k : {-1, 1, 4, 9}) {
    CHECK_ERROR(bspline_derivatives(f.knots(), f.coefficients(), k, FT(1), 0), parameter_outside_domain);
    CHECK_ERROR(bspline_blossom(f.knots(), f.coefficients(), k, {FT(0), FT(1)}), parameter_outside_domain);
  }
  BOOST_CHECK(f == copy);
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

TEST_FOR_EACH(products, K, Kernels) {
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

// Arguments of a coefficient are more than three knots when the multiplicities are low for the
// degree.
BOOST_AUTO_TEST_CASE(high_degrees_with_simple_knots) {
  repeat<Q>(20, [](Random<Q>& random) {
    const int q = random.integer(1, 2), p = q + random.integer(4, 6);
    const Function<Q> f = random.function(random.knots(p, 1));
    check_product(f, random.function(GC::Knot_vector<Q>(q, f.domain().first, f.domain().second)), random);
    check_same(f, f.elevate(q), 0);
  });
}

// Cubics with simple knots: one argument outside a span, of two spans, multiplies the roundings by
// at most 3.
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

TEST_FOR_EACH(sums, K, Kernels) {
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

TEST_FOR_EACH(reversal, K, Kernels) {
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

BOOST_AUTO_TEST_CASE(equal_functions) {
  typedef GC::Bspline_function<double> Function;
  const GC::Knot_vector<double> clamped(1, {0., 0., 1., 2., 2.}), other(1, {0., 0., 1.5, 2., 2.}),
      open(1, {-1., 0., 1., 2., 3.});
  const Function f(clamped, {1., 2., 3.});
  BOOST_CHECK(f == Function(clamped, {1., 2., 3.}) && !(f != Function(clamped, {1., 2., 3.})));
  for (const Function& g : {Function(clamped, {1., 2., 4.}), Function(other, {1., 2., 3.})})
    BOOST_CHECK(f != g && !(f == g));
  // a sum over one knot vector that is not clamped
  const Function g(open, {1., 2., 3.}), sum = g + g;
  BOOST_CHECK(sum.knots().is_clamped());
  for (double u : {0., 0.5, 1., 1.75, 2.}) BOOST_CHECK_EQUAL(sum(u), 2 * g(u));
}

// A span that is shorter than the normal numbers, and knots at the start of the domain that are not
// before it.
BOOST_AUTO_TEST_CASE(special_spans) {
  typedef GC::Bspline_function<double> Function;
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Function f(GC::Knot_vector<double>(1, {0., 0., 4 * tiny, 1., 1.}), {0., 8., 0.});
  BOOST_CHECK_EQUAL(f(2 * tiny), 4);
  const Function g(GC::Knot_vector<double>(2, {-1., 0., 1., 1., 2., 3., 4., 5.}), {1., 2., 4., 8., 16.});
  const std::vector<double> pieces = GC::bspline_bezier(g.knots(), std::vector<double>{1, 2, 4, 8, 16});
  BOOST_REQUIRE_EQUAL(pieces.size(), 6u); // on [1, 2] and [2, 3]
  BOOST_CHECK_EQUAL(pieces[0], g(1));
  BOOST_CHECK_EQUAL(pieces[2], g(2));
  BOOST_CHECK_EQUAL(pieces[5], g(3));
}
