// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_VERIFY_DRAWINGS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_VERIFY_DRAWINGS_H

#include "commands/chains/curvature_bound.h"
#include "commands/chains/join_report.h"
#include "commands/commands.h"

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <optional>
#include <string>

// The largest angle that is a kink. Corners, which are larger, are meant, and need not meet a
// requirement of G orders.
struct Kink_rule {
  std::string degrees; // as it is written
  GC::Corner_threshold bound;
};

// Runs `verify` for SVG drawings: prints the joins of all paths and basic shapes, and returns the
// exit code.
int verify_drawings(const Arguments& files, int max_order, const Report_mode& mode,
                    const std::optional<Requirement>& required, const Kink_rule& kinks,
                    const std::optional<Curvature_bound>& bound = std::nullopt);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_VERIFY_DRAWINGS_H
