// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// The call of C++ that `failing_joins` of Python is measured against: cubic curves, which stand as
// doubles in a file, are copied once, then decided as often as lines come from standard input.
// Prints the number of failing joins and the seconds for each line. Usage: python_benchmark FILE
// DIMENSION

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

template <class Traits> void measure(const std::vector<double>& numbers) {
  constexpr int d = GC::dimension_v<Traits>;
  typedef GC::Bezier_curve<Traits, 3> Curve;
  std::vector<Curve> curves;
  for (std::size_t i = 0; i + 4 * d <= numbers.size(); i += 4 * d) {
    std::vector<typename Traits::Point> points;
    for (std::size_t j = 0; j < 4; ++j) {
      GC::Coordinates<Traits> x(d);
      for (int k = 0; k < d; ++k) x[k] = numbers[i + j * d + k];
      points.push_back(GC::to_point<Traits>(x));
    }
    curves.emplace_back(points);
  }
  std::cout << "ready" << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t failing = GC::failing_joins(curves, GC::is_g2_join).size();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::cout << failing << ' ' << seconds.count() << std::endl;
  }
}

int main(int argc, char* argv[]) {
  if (argc != 3) return 2;
  std::ifstream file(argv[1], std::ios::binary);
  std::vector<double> numbers;
  for (double x; file.read(reinterpret_cast<char*>(&x), sizeof x);) numbers.push_back(x);
  std::string(argv[2]) == "2" ? measure<GC::Traits_2<Kernel>>(numbers) : measure<GC::Traits_3<Kernel>>(numbers);
}
