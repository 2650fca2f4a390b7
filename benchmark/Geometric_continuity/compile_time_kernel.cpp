// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// This program includes a kernel alone, for comparison: see compile_time.sh.

#ifdef WITH_FILTERED_KERNEL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
#else
#include <CGAL/Simple_cartesian.h>
typedef CGAL::Simple_cartesian<double> Kernel;
#endif

#include <iostream>

int main() {
  const Kernel::Point_3 p(0, 1, 2);
  std::cout << p << '\n';
}
