// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A bracket, one of whose edges is concave: all its edges are rounded with continuous curvature,
// and the result is closed. In exact numbers and in floating point, order 2 is decided exactly.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

template <class Kernel> bool round_bracket() {
  typedef typename Kernel::Point_3 Point;
  typedef typename Kernel::FT FT;
  std::vector<Point> points;
  for (int z : {0, 20})
    for (const auto& p : {std::make_pair(0, 0), {40, 0}, {40, 10}, {10, 10}, {10, 40}, {0, 40}})
      points.emplace_back(p.first, p.second, z);
  std::vector<std::vector<std::vector<int>>> faces = {{{5, 4, 3, 2, 1, 0}}, {{6, 7, 8, 9, 10, 11}}};
  for (int i = 0; i < 6; ++i) faces.push_back({{i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6}});

  const auto solid = GC::round_polyhedron(points, faces, FT(2));
  std::cout << solid.faces.size() << " faces, " << solid.blends.size() << " blends:";
  bool good = true;
  for (const auto& blend : solid.blends) {
    std::cout << ' ' << blend.edges.size() << (blend.closed ? " closed" : "");
    good = good && !GC::possible_fold(blend.surface);
  }
  const std::vector<int> orders = GC::edge_orders(solid);
  std::cout << "\nG2 along " << std::count(orders.begin(), orders.end(), 2) << " of " << orders.size() << " edges\n";
  return good && std::count(orders.begin(), orders.end(), 2) == std::ptrdiff_t(orders.size());
}

int main() {
  if (!round_bracket<CGAL::Simple_cartesian<CGAL::Exact_rational>>()) return 1;
  if (!round_bracket<CGAL::Simple_cartesian<double>>()) return 1;
  try { // there is not so much room on a tetrahedron
    GC::round_polyhedron(
        std::vector<CGAL::Simple_cartesian<double>::Point_3>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}},
        {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}, 4);
  } catch (const GC::Error& error) {
    std::cout << error.what() << '\n';
  }
}
