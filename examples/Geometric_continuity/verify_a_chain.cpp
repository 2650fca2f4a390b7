// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Verifies a closed chain of curves with double coordinates. The constructions of the kernel are
// inexact, but its predicates are exact: the answer holds for the coordinates as given, and one
// unit in the last place makes a difference.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits, 3> Curve; // the degree is fixed: no allocation

// Four cubics that resemble quarters of a circle, with handles of length h.
std::vector<Curve> rounded_square(double h) {
  return {Curve{Point(1, 0), Point(1, h), Point(h, 1), Point(0, 1)},
          Curve{Point(0, 1), Point(-h, 1), Point(-1, h), Point(-1, 0)},
          Curve{Point(-1, 0), Point(-1, -h), Point(-h, -1), Point(0, -1)},
          Curve{Point(0, -1), Point(h, -1), Point(1, -h), Point(1, 0)}};
}

// Prints the orders of all joins, of which the last closes the chain, and returns the least G
// order.
int least_g_order(const std::vector<Curve>& chain) {
  int least = 3, i = 0;
  for (const auto& join : GC::chain_joins(chain, 3, GC::Closure::closed)) {
    std::cout << "  join " << i++ << ": C" << join.c_order << " G" << join.g_order << '\n';
    least = (std::min)(least, join.g_order);
  }
  return least;
}

int main() {
  std::cout << "rounded square:\n";
  const std::vector<Curve> chain = rounded_square(0.5522847498307936);
  const int order = least_g_order(chain);

  std::cout << "one handle turned by one unit in the last place:\n";
  std::vector<Curve> moved = chain;
  moved[1] = Curve{Point(0, 1), Point(-0.5522847498307936, std::nextafter(1.0, 2.0)), Point(-1, 0.5522847498307936),
                   Point(-1, 0)};
  const int moved_order = least_g_order(moved);
  return order == 2 && moved_order == 0 ? 0 : 1;
}
