// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Defines two types of curves of your own that take part in blends: a circle in rational numbers,
// with a proof of the joins, and a helix in floating-point numbers.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// The unit circle ((1 - t^2) / w, 2 t / w) with w = 1 + t^2. The k-th derivative of x w = p is
// x^(k) w + k x^(k-1) w' + k (k-1) / 2 x^(k-2) w'' = p^(k), which gives x^(k).
template <class Traits_> struct Circle_arc {
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  std::pair<FT, FT> domain() const { return {FT(0), FT(1)}; } // a quarter
  GC::Curve_jet<Traits> jet(const FT& t, int order) const {
    const FT p[2][3] = {{FT(1 - t * t), FT(-2 * t), FT(-2)}, {FT(2 * t), FT(2), FT(0)}}, w = FT(1 + t * t);
    GC::Curve_jet<Traits> x(2, order);
    for (int k = 0; k <= order; ++k)
      for (int i = 0; i < 2; ++i) {
        FT rest = k < 3 ? p[i][k] : FT(0);
        if (k >= 1) rest -= FT(k) * 2 * t * x[k - 1][i];
        if (k >= 2) rest -= FT(k * (k - 1)) * x[k - 2][i];
        x[k][i] = FT(rest / w);
      }
    return x;
  }
};

// (cos t, sin t, t / 2): each derivative turns by a right angle.
struct Helix {
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
  std::pair<double, double> domain() const { return {0, 9}; }
  GC::Curve_jet<Traits> jet(double t, int order) const {
    GC::Curve_jet<Traits> x(3, order);
    for (int k = 0; k <= order; ++k) {
      const double angle = t + k * std::acos(0.0);
      x[k][0] = std::cos(angle), x[k][1] = std::sin(angle), x[k][2] = k == 0 ? t / 2 : k == 1 ? 0.5 : 0;
    }
    return x;
  }
};

int main() {
  typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
  typedef Traits::Point Point;
  const Circle_arc<Traits> arc;
  const GC::Bezier_curve<Traits> line{Point(-3, 2), Point(-5, 2)};
  const auto g2 = GC::blend(arc, line);
  const auto g3 = GC::blend(arc, line, GC::Sequential_g3());
  std::cout << g2 << "\ncircle to blend: " << GC::continuity(arc, g2)
            << "\nblend to line:   " << GC::continuity(g2, line) << "\ndegree 7:        " << GC::continuity(arc, g3)
            << ", " << GC::continuity(g3, line) << '\n';

  const GC::Bezier_curve<Helix::Traits> exit{{0, 0, 6}, {0, 0, 8}};
  std::vector<Helix::Traits::Point> polyline; // |x''| = 1
  GC::chord_polyline(Helix(), 1, 0.001, std::back_inserter(polyline));
  std::cout << "helix: " << polyline.size() << " points, blend of degree " << GC::blend(Helix(), exit).degree() << '\n';
  return GC::continuity(arc, g3).g_order == 3 && GC::continuity(g2, line).g_order >= 2 ? 0 : 1;
}
