// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/exact_models.h"

Surface_model<Exact_space> read_exact_model(const std::vector<std::string>& files) {
  return read_surfaces<Exact_space>(files);
}

void draw_surfaces(std::ostream& os, const std::vector<Exact_surface>& surfaces, const GC::Svg_surface_style& style) {
  GC::write_svg_surfaces(os, surfaces, style);
}
void draw_surfaces(std::ostream& os, const std::vector<Exact_rational_surface>& surfaces,
                   const GC::Svg_surface_style& style) {
  GC::write_svg_surfaces(os, surfaces, style);
}

template std::optional<GC::Parameter_rectangle<Exact>> GC::possible_fold(const Exact_surface& surface);
template std::optional<GC::Parameter_rectangle<Exact>> GC::possible_fold(const Exact_rational_surface& surface);
