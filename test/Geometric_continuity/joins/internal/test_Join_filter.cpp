// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The filter multiplies an error, which Gappa proves for bounds of 1, by the largest product of the
// bounds. This compares that product with the equations themselves, in numbers whose sum and
// difference are the larger of both: the value of a form is then its largest product.

#include "support/test.h"

#include <CGAL/Geometric_continuity/joins/internal/Join_input.h>

BOOST_AUTO_TEST_SUITE(join_filter)

using namespace GC::internal;

struct Largest {
  double value = 0;

  Largest() = default;
  explicit Largest(double v) : value(v) {}
  friend Largest operator+(const Largest& x, const Largest& y) { return Largest((std::max)(x.value, y.value)); }
  friend Largest operator-(const Largest& x, const Largest& y) { return x + y; }
  friend Largest operator*(const Largest& x, const Largest& y) { return Largest(x.value * y.value); }
};

// The largest value of each form.
struct Values {
  std::array<double, join_questions> of{};
  static constexpr bool exact = false;

  bool operator()(Join_question form, const Largest& x) {
    double& value = of[static_cast<int>(form)];
    value = (std::max)(value, x.value);
    return true;
  }
};

Differences<Largest, 3> differences(const Difference_bounds& d) {
  const auto vector = [](double x) { return std::array<Largest, 3>{Largest(x), Largest(x), Largest(x)}; };
  return {vector(d.d1), vector(d.d2), vector(d.d3)};
}

// Checks the bounds of powers of two.
template <class Factors> void check(const Difference_bounds& a, const Difference_bounds& b, const Factors& w) {
  const Join_filter<Factors> filter{a, b, w};
  Values values;
  const Differences<Largest, 3> x = differences(a), y = differences(b);
  const Join_equations<Largest, 3, Factors, Values> equations(x, y, w, values);
  std::vector<Join_question> forms;
  if constexpr (Factors::parametric) {
    (void)equations.template derivatives_equal<1>();
    (void)equations.template derivatives_equal<2>();
    (void)equations.template derivatives_equal<3>();
    forms = {Join_question::c1, Join_question::c2, Join_question::c3};
  } else {
    (void)equations.tangents_parallel();
    (void)equations.g2(equations.ratio());
    (void)equations.g3(equations.ratio());
    (void)equations.f3(equations.ratio());
    (void)equations.curvature_vectors_equal();
    (void)equations.torsions_equal();
    forms = {
        Join_question::g1,     Join_question::g2, Join_question::g3, Join_question::f3, Join_question::curvature_vector,
        Join_question::torsion};
  }
  const Join_rounding rounding = Rounding_of_differences::value();
  for (const Join_question form : forms) {
    const auto k = static_cast<std::size_t>(form);
    BOOST_CHECK_EQUAL(filter.exponent_of_bound(form), binary_exponent(rounding.error[k] * values.of[k]) + 2);
  }
}

BOOST_AUTO_TEST_CASE(largest_products_of_the_bounds) {
  constexpr unsigned seed = 2026;
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 engine(seed);
  const auto power = [&](int range) { return std::ldexp(1., static_cast<int>(engine() % range)); };
  const auto bounds = [&]() -> Difference_bounds {
    const double d1 = std::ldexp(power(60), -40), d2 = d1 * power(20), d3 = d2 * power(20);
    return {d1, d2, d3};
  };
  for (int i = 0; i < 2000; ++i) {
    const Difference_bounds a = bounds(), b = bounds();
    const auto w = [&] { return power(20); };
    check(a, b, Degree_factors<double>{w(), w(), w(), w(), w()});
    check(a, b, Parametric_degree_factors<double>{w(), w(), w(), w(), w(), w()});
    check(a, b, Weighted_degree_factors<Join_question::g3, double>{w(), w(), w(), w(), w(), w()});
  }
}

BOOST_AUTO_TEST_SUITE_END()
