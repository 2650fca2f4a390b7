// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Start here: every edge that the patches of a model share, decided on its whole length.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

#ifndef GEOMETRIC_CONTINUITY_DATA // the folder of the data, which the build defines
#define GEOMETRIC_CONTINUITY_DATA "."
#endif

int main() {
  //! [start]
  namespace GC = CGAL::Geometric_continuity;
  typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;

  std::ifstream file(GEOMETRIC_CONTINUITY_DATA "/teapot.g2");
  const auto patches = GC::read_g2_surfaces<Traits>(file, "teapot.g2");
  const auto model = GC::model_continuity(patches);
  std::cout << patches.size() << " patches: " << model.summary << '\n';
  //! [start]
}
