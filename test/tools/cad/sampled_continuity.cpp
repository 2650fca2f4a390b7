// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Prints the verdict of OpenCASCADE, from samples, on each edge of a CAD model that has two sides:
// its number, and G1 or G0.
//   sampled_continuity FILE DEGREES

#include "sampled_continuity.h"

#include "formats/cad/opencascade/read_model.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  const std::vector<std::optional<Sampled_edge>> edges = sampled_edges(read_shape(argv[1], {}).shape);
  const double angle = std::atof(argv[2]) / 180 * M_PI;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (edges[i]) std::cout << i << (is_sampled_g1(*edges[i], angle) ? " G1\n" : " G0\n");
}
