// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_INPUT_H
#define GEOMETRIC_CONTINUITY_DEMO_INPUT_H

#include "progress.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/g2.h>

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// Opens a file for reading. Throws GC::Error `cannot_read_file` when there is none.
inline std::ifstream open_input(const std::string& name) {
  std::ifstream stream(name);
  if (!stream) throw GC::Error(GC::Error_code::cannot_read_file, name);
  return stream;
}

// Reads the surfaces of several files, which together are one model.
template <class Traits> std::vector<GC::Bspline_surface<Traits>> read_surfaces(const std::vector<std::string>& files) {
  std::vector<GC::Bspline_surface<Traits>> model;
  const Reading_position position(files);
  Progress progress("surfaces read");
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::ifstream stream = open_input(files[i]);
    GC::G2_bspline_surface_reader<Traits> reader(stream, files[i]);
    while (std::optional<GC::Bspline_surface<Traits>> surface = reader.next()) {
      model.push_back(*std::move(surface));
      progress.step(model.size(), [&] { return position.part(i, stream); });
    }
  }
  return model;
}

#endif // GEOMETRIC_CONTINUITY_DEMO_INPUT_H
