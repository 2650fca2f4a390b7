// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/atomic_file.h>
#include <CGAL/Geometric_continuity/IO/figures/svg_surfaces.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;

// The view is AZIMUTH,ELEVATION in degrees.
int plot_surfaces(const Arguments& files, const std::string& output, const std::string& title, bool shaded,
                  const std::string& view) {
  GC::Svg_surface_style style;
  style.title = title;
  if (shaded) style.shading = GC::Svg_shading::smooth;
  if (!view.empty()) {
    const std::size_t comma = view.find(',');
    if (comma == std::string::npos) throw std::invalid_argument("--view: AZIMUTH,ELEVATION is expected");
    style.azimuth = GC::parse_number<double>(view.substr(0, comma));
    style.elevation = GC::parse_number<double>(view.substr(comma + 1));
    if (!(std::abs(style.azimuth) <= 360) || !(std::abs(style.elevation) <= 90))
      throw std::invalid_argument("--view: at most 360 and 90 degrees");
  }
  std::vector<GC::Bspline_surface<Traits>> model;
  for (const std::string& name : files) {
    std::ifstream stream(name);
    if (!stream) throw GC::Error(GC::Error_code::cannot_read_file, name);
    for (GC::Bspline_surface<Traits>& surface : GC::read_g2_bspline_surfaces<Traits>(stream, name))
      model.push_back(std::move(surface));
  }
  GC::write_file_atomically(output, [&](std::ostream& os) { GC::write_svg_surfaces(os, model, style); });
  return requirement_met;
}
