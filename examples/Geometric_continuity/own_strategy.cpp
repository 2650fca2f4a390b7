// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Defines a strategy of your own, which chooses how far the inner control points of a blend slide
// along the end tangents. Whatever it chooses, the joins stay G2. Here the strategy puts the middle
// of the blend at a given height. It works in every field, and says so: then the package computes
// the blend in a field that is faster than rational numbers.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::FT FT;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

// gamma(1/2) = (A1 + 5 B1 + 10 C1 + 10 C2 + 5 B2 + A2) / 32 with C1 = C1(0) + s u and C2 = C2(0) -
// s v
struct Middle_at_height {
  typedef CGAL::Tag_true Works_in_every_field;
  Traits::FT y;

  template <class FT, int N> GC::Quintic_parameters<FT> operator()(const GC::Quintic_ends<FT, N>& e) const {
    const GC::Coordinate_vector<FT, N> middle =
        (e.a1 + FT(5) * e.b1() + FT(10) * e.c1(0) + FT(10) * e.c2(0) + FT(5) * e.b2() + e.a2) / FT(32);
    const FT slope = FT(10) * (e.u[1] - e.v[1]) / FT(32);
    GC::Quintic_parameters<FT> p;
    if (slope == 0) {
      p.fallback_start = p.fallback_end = true; // the height does not depend on s
      return p;
    }
    p.s1 = (FT(y) - middle[1]) / slope;
    p.s2 = -p.s1;
    return p;
  }
};

int main() {
  const Curve phi{Point(0, 0), Point(0, 1), Point(0, 2)}, psi{Point(4, 2), Point(4, 1), Point(5, 0)};
  bool ok = true;
  for (int y : {3, 4, 5}) {
    const GC::Quintic_blend<Traits> gamma = GC::blend(phi, psi, Middle_at_height{FT(y)});
    const auto start = GC::continuity(phi, gamma), end = GC::continuity(gamma, psi);
    std::cout << "height " << gamma(FT(1) / 2).y() << ": start " << start << ", end " << end << '\n';
    ok = ok && gamma(FT(1) / 2).y() == y && start.g_order >= 2 && end.g_order >= 2;
  }
  return ok ? 0 : 1;
}
