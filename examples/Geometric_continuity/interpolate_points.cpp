// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Cubic splines through given points, open and closed, with continuous curvature: what is
// interpolated and how smooth the joins are is decided exactly.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_2<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Bspline_curve<Traits> Curve;

// The least order of parametric continuity at the joins of the Bézier pieces.
int order_of_joins(const Curve& curve, GC::Closure closure) {
  const auto pieces = curve.bezier_pieces();
  int order = 2;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
    order = std::min(order, continuity(pieces[i], pieces[i + 1], 2).c_order);
  if (closure == GC::Closure::closed) order = std::min(order, continuity(pieces.back(), pieces.front(), 2).c_order);
  return order;
}

int main() {
  const std::vector<Point> points = {Point(0, 0), Point(4, 3), Point(9, 3), Point(9, -1), Point(2, -2)};
  bool as_expected = true;
  for (GC::Closure closure : {GC::Closure::open, GC::Closure::closed})
    for (GC::Parametrisation parametrisation :
         {GC::Parametrisation::uniform, GC::Parametrisation::chordal, GC::Parametrisation::centripetal}) {
      const std::vector<FT> u =
          GC::interpolation_parameters<Traits>(points.begin(), points.end(), parametrisation, closure);
      const Curve curve = GC::interpolate<Traits>(points.begin(), points.end(), u, closure);
      bool met = true;
      for (std::size_t i = 0; i < u.size(); ++i) met = met && curve(u[i]) == points[i % points.size()];
      const int order = order_of_joins(curve, closure);
      std::cout << to_string(closure) << ", " << parametrisation << ": " << curve.number_of_points()
                << " control points, C" << order << ", the points are " << (met ? "" : "not ") << "met; parameters";
      for (const FT& x : u) std::cout << ' ' << x;
      std::cout << '\n';
      as_expected = as_expected && met && order == 2;
    }
  return as_expected ? 0 : 1;
}
