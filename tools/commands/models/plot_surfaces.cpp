// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/commands.h"
#include "commands/models/exact_models.h"
#include "files/output.h"

#include <CGAL/Geometric_continuity/IO/number.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

int plot_surfaces(const Arguments& files, const Surface_picture& picture) {
  GC::Svg_surface_style style;
  style.title = picture.title;
  if (picture.shaded) style.shading = GC::Svg_shading::smooth;
  if (!picture.view.empty()) {
    const std::size_t comma = picture.view.find(',');
    if (comma == std::string::npos) throw std::invalid_argument("--view: AZIMUTH,ELEVATION is expected");
    style.azimuth = GC::parse_number<double>(picture.view.substr(0, comma));
    style.elevation = GC::parse_number<double>(picture.view.substr(comma + 1));
    if (!(std::abs(style.azimuth) <= 360) || !(std::abs(style.elevation) <= 90))
      throw std::invalid_argument("--view: at most 360 and 90 degrees");
  }
  const Surface_model<Exact_space> model = read_exact_model(files);
  write_output(picture.output, [&](std::ostream& os) {
    model.visit([&](const auto& surfaces) { draw_surfaces(os, surfaces, style); });
  });
  return requirement_met;
}
