// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Reads the 32 bicubic patches of the Utah teapot, and decides G1 and G2 along each whole edge that
// two of them share, exactly for the numbers in the file. No edge is sampled.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

#ifndef GEOMETRIC_CONTINUITY_DATA // the folder of the data, which the build defines
#define GEOMETRIC_CONTINUITY_DATA "."
#endif

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;

int main(int argc, char* argv[]) {
  const char* const file = argc > 1 ? argv[1] : GEOMETRIC_CONTINUITY_DATA "/teapot.g2";
  std::ifstream stream(file);
  try {
    const auto patches = GC::read_g2_surfaces<Traits>(stream, file);
    const auto model = GC::model_continuity(patches);
    std::cout << patches.size() << " patches: " << model.summary << '\n';

    // At the bottom and at the knob whole edges of patches shrink to a point, where the normal
    // vanishes.
    for (const auto& edge : model.edges)
      if (edge.kind == GC::Model_edge_kind::shared && edge.continuity.g_order == 0)
        std::cout << edge << ", normal vanishes at " << edge.continuity.vanishing->first << '\n';
    const bool proved = model.summary.g2 == 24 && model.summary.g1 == 20 && model.summary.g0 == 8;
    return argc > 1 || proved ? 0 : 1;
  } catch (const GC::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
