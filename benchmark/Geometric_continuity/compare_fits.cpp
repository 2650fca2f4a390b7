// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// How many pieces `fit` takes near 20 polylines, beside the fewest of a chain with the same joins
// that is known, and the least number without any condition where they meet: prints the table in
// the manual, in some minutes. Usage: compare_fits

#include "least_pieces.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;

int main() {
  std::cout << "| Input | Tolerance | G1: fit | fewest known | bound | G2: fit | fewest known | bound |\n"
               "|---|---|---|---|---|---|---|---|\n";
  for (const Polyline_to_fit& polyline : polylines_to_fit()) {
    std::vector<Traits::Point> p;
    for (const auto& [x, y] : polyline.points) p.emplace_back(x, y);
    const Plane_polyline reversed(polyline.points.rbegin(), polyline.points.rend());
    std::cout << "| " << polyline.name << " | " << polyline.tolerance;
    for (const int order : {1, 2}) {
      const int degree = 2 * order + 1, bound = least_pieces(polyline.points, degree, polyline.tolerance),
                fitted = GC::fit<Traits>(p.begin(), p.end(), polyline.tolerance, GC::Closure::open, order)
                             .number_of_segments(),
                fewest = (std::min)({fitted, pieces_of_chain(polyline.points, degree, polyline.tolerance),
                                     pieces_of_chain(reversed, degree, polyline.tolerance)});
      std::cout << " | " << fitted << " | " << fewest << " | " << bound << std::flush;
      if (fewest < bound) std::cout << " (too large)";
    }
    std::cout << " |\n";
  }
  return 0;
}
