// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Surfaces of .g2 files: what is read and written reads back equal, and small models are decided.

#include "fuzz_target.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>

typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef GC::Rational_bspline_surface<Traits> Surface;

namespace {

constexpr std::size_t max_surfaces = 4; // of what is decided
constexpr int max_degree = 3, max_points = 6;

std::vector<Surface> read(std::string_view text) {
  std::istringstream is{std::string(text)};
  return GC::read_g2_rational_bspline_surfaces<Traits>(is, "fuzz.g2");
}

bool is_small(const Surface& s) {
  return s.degree_u() <= max_degree && s.degree_v() <= max_degree && s.number_of_points_u() <= max_points &&
         s.number_of_points_v() <= max_points;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz_text(data, size);
  std::vector<Surface> surfaces;
  if (!accepts([&] { surfaces = read(text); })) return 0;
  std::ostringstream os;
  for (const Surface& surface : surfaces) GC::write_g2(os, surface);
  if (has_long_number(os.str())) return 0;
  require(read(os.str()) == surfaces, "surfaces that are written read back equal");
  if (surfaces.size() > max_surfaces) return 0;
  for (const Surface& surface : surfaces)
    if (!is_small(surface)) return 0;
  const auto decide = [](const auto& model) {
    for (const auto& edge : GC::model_continuity(model).edges)
      require(edge.patch_a < model.size(), "an edge belongs to a patch");
  };
  if (std::all_of(surfaces.begin(), surfaces.end(), [](const Surface& s) { return s.is_polynomial(); })) {
    std::vector<GC::Bspline_surface<Traits>> polynomials;
    for (const Surface& surface : surfaces) polynomials.push_back(*surface.polynomial());
    accepts([&] { decide(polynomials); });
  } else {
    accepts([&] { decide(surfaces); });
  }
  return 0;
}
