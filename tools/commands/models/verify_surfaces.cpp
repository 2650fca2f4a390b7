// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/Model_report.h"
#include "commands/work_limit.h"

#include <optional>
#include <string>

int verify_surfaces(const Arguments& files, const Report_mode& mode, const std::optional<int>& required_g_order,
                    const std::optional<GC::Edge_tolerance>& tolerance) {
  const Edge_demand demand{required_g_order, tolerance};
  const bool as_written = tolerance || mode.certificate != nullptr;
  const Model_surfaces surfaces(files, as_written ? Model_surfaces::Units::of_the_files : Model_surfaces::Units::any);
  const Patch_places places(files, surfaces.places());
  return within_work_limit([&] { return places.names().size() == 1 ? places.names()[0] : places.names()[0] + ", ..."; },
                           [&] { return Model_report(surfaces, places, mode, demand).print(); });
}
