// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Runs exact cases through the public interface of the package and compares the results:
//
//   run_cases FILE.txt...
//
// Prints each mismatch with the name of its case, and at last "N passed, N failed". The exit code
// is 0 if and only if every case passed. The kernel is chosen when compiling,
// Simple_cartesian<Exact_rational> by default.

#include <CGAL/Cartesian_d.h>
#include <CGAL/Simple_cartesian.h>

#include "run_cases/compare.h"
#include "run_cases/run_case.h"

#include <exception>
#include <iostream>

#if defined(RUN_CASES_ON_EPECK)
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
typedef Kernels<CGAL::Epeck, CGAL::Cartesian_d<CGAL::Epeck::FT>> Kernels_run;
#elif defined(RUN_CASES_ON_EPICK)
#include <CGAL/Epick_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#define RUN_CASES_ROUNDED true
typedef Kernels<CGAL::Epick, CGAL::Epick_d<CGAL::Dynamic_dimension_tag>> Kernels_run;
#elif defined(RUN_CASES_ON_DOUBLE)
#define RUN_CASES_ROUNDED false
typedef Kernels<CGAL::Simple_cartesian<double>, CGAL::Cartesian_d<double>> Kernels_run;
#else
typedef Kernels<CGAL::Simple_cartesian<Exact_rational>, CGAL::Cartesian_d<Exact_rational>> Kernels_run;
#endif

Verdict verify(const Case& c) {
#ifdef RUN_CASES_ROUNDED
  typedef CGAL::Interval_nt<> Interval;
  typedef Kernels<CGAL::Simple_cartesian<Interval>, CGAL::Cartesian_d<Interval>> Interval_kernels;
  return compare_rounded(c, run_case<Kernels_run>(c), run_case<Interval_kernels>(c), RUN_CASES_ROUNDED);
#else
  return compare_exact(c, run_case<Kernels_run>(c));
#endif
}

int main(int argc, char* argv[]) {
  int passed = 0, failed = 0, compared = 0, undecided = 0;
  bool readable = argc > 1;
  if (!readable) std::cerr << "usage: run_cases FILE.txt...\n";
  for (int i = 1; i < argc; ++i) {
    std::vector<Case> cases;
    try {
      cases = read_cases(argv[i]);
    } catch (const std::exception& e) {
      std::cerr << e.what() << '\n';
      readable = false;
    }
    for (const Case& c : cases) {
      Verdict verdict;
      try {
        verdict = verify(c);
      } catch (const std::exception& e) {
        verdict.mismatches.push_back(e.what());
      }
      for (const std::string& mismatch : verdict.mismatches) std::cout << c.id << ' ' << mismatch << '\n';
      ++(verdict.mismatches.empty() ? passed : failed);
      compared += verdict.compared;
      undecided += verdict.undecided;
    }
  }
  std::cout << compared << " values compared";
  if (undecided > 0) std::cout << ", " << undecided << " left open by rounding";
  std::cout << '\n' << passed << " passed, " << failed << " failed\n";
  // a rounded kernel must decide most of what it is asked, or the comparison would say nothing
  return readable && passed > 0 && failed == 0 && undecided < compared ? 0 : 1;
}
