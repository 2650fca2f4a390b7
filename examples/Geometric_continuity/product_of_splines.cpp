// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Computes the exact product of two splines with different knots. Each knot of the product is
// repeated as often as it must be, and no more; the product is checked at random parameters,
// without rounding.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>

#include <iostream>
#include <random>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Knot_vector<FT> Knots;
typedef GC::Bspline_function<FT> Spline;

int main() {
  // A quadratic with the simple knot 1, and a cubic with the double knot 1 and a simple knot that
  // is very near to it.
  const FT near = FT(1) + FT(1) / FT(1000000);
  const Spline f(Knots(2, FT(0), FT(3), {{FT(1), 1}}), {FT(1), FT(-2), FT(5), FT(1) / FT(3)});
  const Spline g(Knots(3, FT(0), FT(3), {{FT(1), 2}, {near, 1}}),
                 {FT(2), FT(7), FT(0), FT(-1), FT(4), FT(1) / FT(7), FT(3)});
  const Spline h = f * g;
  std::cout << "degree " << h.degree() << ", " << h.knots().number_of_coefficients() << " coefficients, knots\n"
            << h.knots() << '\n';
  for (const Knots::Knot& knot : h.knots().inner_knots())
    std::cout << "at " << knot.value << ": " << knot.multiplicity << " times, C" << h.smoothness(knot.value) << '\n';
  const bool minimal = h.remove_superfluous_knots() == h;
  std::cout << (minimal ? "no knot is superfluous\n" : "a knot is superfluous\n");

  std::mt19937 engine(1);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const FT u = FT(static_cast<int>(engine() % 3000001)) / FT(1000000);
    equal += h(u) == FT(f(u) * g(u));
  }
  std::cout << equal << " of 1000 values are equal to the products\n";
  return minimal && equal == 1000 ? 0 : 1;
}
