// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/decide_cad.h"
#include "commands/tolerances.h"

#include <optional>
#include <stdexcept>
#include <string>

Cad_demand demand_within(const std::string& tolerance, const GC::Corner_threshold& kink) {
  const Tolerances tolerances = parse_tolerances(tolerance, false);
  if (tolerances.order > 2) throw std::invalid_argument("--within: of CAD models GAP,ANGLEdeg,CURVATURE% are compared");
  return {std::nullopt, tolerances.order, tolerances.joins, tolerance, GC::in_radians(kink.degrees())};
}
