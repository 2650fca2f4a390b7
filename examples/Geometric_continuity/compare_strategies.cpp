// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends the same two curves by each strategy, and compares energy and orders of continuity. Every
// quintic strategy gives G2 joins; they differ in two scalars. The septic strategies give G3 or F3
// joins: torsion is continuous as well.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iomanip>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

// Prints what a strategy gives, and returns whether both joins have the F order.
template <class Strategy>
bool report(const char* name, const Curve& phi, const Curve& psi, const Strategy& strategy, int f_order) {
  const auto gamma = GC::blend(phi, psi, strategy, {1, 1}); // with the speed of the given curves
  const auto start = GC::continuity(phi, gamma), end = GC::continuity(gamma, psi);
  std::cout << std::left << std::setw(28) << name << "degree " << gamma.degree() << "  C" << start.c_order << " G"
            << start.g_order << " F" << start.f_order << "  energy " << CGAL::to_double(gamma.energy(2)) << '\n';
  return start.f_order >= f_order && end.f_order >= f_order;
}

int main() {
  const Curve phi{Point(-3, 0, 0), Point(-3, 2, 1), Point(-2, 3, 1), Point(0, 3, 0)};
  const Curve psi{Point(4, 0, 2), Point(5, -1, 2), Point(7, -1, 0), Point(8, 1, 0)};

  bool proved = report("matching 2nd derivative", phi, psi, GC::Matching_second_derivative(), 2);
  proved = report("normal offset", phi, psi, GC::Normal_offset(), 2) && proved;
  proved = report("minimal 2nd derivative", phi, psi, GC::Minimal_second_derivative(), 2) && proved;
  proved = report("near line", phi, psi, GC::Near_line(), 2) && proved;
  proved = report("minimal energy, order 2", phi, psi, GC::Minimal_energy<2>(), 2) && proved;
  proved = report("minimal energy, order 3", phi, psi, GC::Minimal_energy<3>(), 2) && proved;
  proved = report("matching 3rd derivative", phi, psi, GC::Matching_third_derivative(), 3) && proved;
  proved = report("sequential G3", phi, psi, GC::Sequential_g3(), 3) && proved;
  proved = report("sequential F3", phi, psi, GC::Sequential_f3(), 3) && proved;
  proved = report("joint G3", phi, psi, GC::Joint_g3(), 3) && proved;
  proved = report("minimal energy G3, order 4", phi, psi, GC::Minimal_energy_g3<4>(), 3) && proved;
  std::cout << (proved ? "all joins proved\n" : "a join failed\n");
  return proved ? 0 : 1;
}
