// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_GAUSS_RULE_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_GAUSS_RULE_H

#include <array>
#include <cmath>
#include <cstddef>

/// \file Gauss_rule.h
/// Gauss's quadrature with an even number of nodes. They are the zeros of Legendre's polynomial
/// \f$ P_n \f$, found by Newton's method from \f$ \cos(\pi (i + 3/4) / (n + 1/2)) \f$, and their
/// weights are \f$ 2 / ((1 - x^2) P_n'(x)^2) \f$. (A library that has them as well takes as long to
/// compile as half a kernel.)

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The nodes on one side of 0, in [-1, 1], from the middle.
template <int nodes> struct Gauss_rule {
  static_assert(nodes % 2 == 0);
  std::array<double, nodes / 2> abscissa, weight;

  static const Gauss_rule& instance() {
    static const Gauss_rule rule;
    return rule;
  }

private:
  Gauss_rule() {
    constexpr long double pi = 3.14159265358979323846L;
    for (int i = 0; i < nodes / 2; ++i) {
      long double x = std::cos(pi * (i + 0.75L) / (nodes + 0.5L)), derivative = 1;
      for (int step = 0; step < 6; ++step) { // three digits are right, and each step doubles them
        long double before = 1, value = x;   // P_{k-1}(x), P_k(x)
        for (int k = 1; k < nodes; ++k) {
          const long double next = ((2 * k + 1) * x * value - k * before) / (k + 1);
          before = value;
          value = next;
        }
        derivative = nodes * (before - x * value) / (1 - x * x);
        x -= value / derivative;
      }
      const std::size_t from_middle = nodes / 2 - 1 - i;
      abscissa[from_middle] = static_cast<double>(x);
      weight[from_middle] = static_cast<double>(2 / ((1 - x * x) * derivative * derivative));
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_GAUSS_RULE_H
