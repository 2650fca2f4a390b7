// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/Model_report.h"
#include "commands/work_limit.h"
#include "formats/g2_text/surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Simple_cartesian.h>

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

// Surfaces with exact numbers, or with floating-point numbers, about which everything is decided
// exactly as well.
template <class FT>
using Surface_traits =
    GC::Traits_3<std::conditional_t<std::is_same_v<FT, double>, CGAL::Exact_predicates_inexact_constructions_kernel,
                                    CGAL::Simple_cartesian<FT>>>;

// Decides the edges of surfaces with numbers FT, whose parameters are those of the files divided by
// `parameter_unit`. With a tolerance the coordinates are those of the files.
template <class FT>
int verify_surfaces_on(const Surface_model<Surface_traits<FT>>& model, const Patch_places& places,
                       const Report_mode& mode, const Edge_demand& demand, const Exact& parameter_unit) {
  return within_work_limit([&] { return places.names().size() == 1 ? places.names()[0] : places.names()[0] + ", ..."; },
                           [&] {
                             return model.visit([&](const auto& surfaces) {
                               return Model_report(surfaces, places, mode, demand, parameter_unit).print();
                             });
                           });
}

} // namespace

int verify_surfaces(const Arguments& files, const Report_mode& mode, const std::optional<int>& required_g_order,
                    const std::optional<GC::Edge_tolerance>& tolerance) {
  typedef Surface_traits<Exact> Exact_traits;
  typedef Surface_traits<double> Double_traits;
  const Edge_demand demand{required_g_order, tolerance};
  Surface_texts<Exact_traits> texts = read_surface_texts<Exact_traits>(files);
  const Patch_places places(files, texts.places());
  if (!tolerance && mode.certificate == nullptr) { // which are in the units of the files
    GC::G2_grid grid;
    std::vector<GC::Bspline_surface<Double_traits>> surfaces;
    if (texts.on_grid(grid, surfaces)) {
      Exact unit(1);
      for (int e = grid.exponent_of_knots(); e < 0; ++e) unit /= Exact(10);
      Surface_model<Double_traits> model(std::move(surfaces));
      return verify_surfaces_on<double>(model, places, mode, demand, unit);
    }
  }
  return verify_surfaces_on<Exact>(texts.model(), places, mode, demand, Exact(1));
}
