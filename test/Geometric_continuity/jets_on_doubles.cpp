// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A question that is decided on jets, over a kernel that brings no exact numbers: it does not
// compile without them, and the compiler says what to include. A test builds it without and with
// WITH_EXACT_NUMBERS.

#include <CGAL/Geometric_continuity/Traits.h>
#ifdef WITH_EXACT_NUMBERS
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#endif
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Simple_cartesian.h>

#include <utility>

namespace GC = CGAL::Geometric_continuity;

// The parabola (u, u^2).
struct Parabola {
  typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;
  typedef double FT;

  std::pair<double, double> domain() const { return {0, 1}; }
  GC::Curve_jet<Traits> jet(double u, int k) const {
    GC::Curve_jet<Traits> x(2, k);
    const double derivatives[3][2] = {{u, u * u}, {1, 2 * u}, {0, 2}};
    for (int j = 0; j <= k && j < 3; ++j)
      for (int i = 0; i < 2; ++i) x[j][i] = derivatives[j][i];
    return x;
  }
};

int main() { return GC::is_g2_join(Parabola(), Parabola()) ? 1 : 0; }
