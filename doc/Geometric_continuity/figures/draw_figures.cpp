// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Usage: draw_figures FOLDER

#include "figures.h"

#include <exception>
#include <iostream>

int main(int count, char** arguments) try {
  if (count != 2) throw std::invalid_argument("usage: draw_figures FOLDER");
  const std::string folder = std::string(arguments[1]) + '/';
  draw_curve_figures(folder);
  draw_surface_figures(folder);
  draw_enclosure(folder);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
