// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_VERIFY_CHAIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_VERIFY_CHAIN_H

#include "commands/chains/curvature_bound.h"
#include "commands/chains/join_report.h"
#include "commands/commands.h"
#include "commands/tolerances.h"

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <optional>

// The demands on the joins of a chain, and on its curves.
struct Join_demand {
  int max_order;
  std::optional<Requirement> order;
  std::optional<Tolerances> tolerance;
  GC::Corner_threshold corner_threshold; // a larger angle is a corner
  std::optional<Curvature_bound> curvature = {};
};

// Decides the joins of the chain that the curves of the files form, and of its end and its start
// when it is closed, and how far its curves are bent, and prints a report. The numbers are those of
// the files, or these rounded to doubles.
int verify_chain(const Arguments& files, bool rounded, bool closed, const Report_mode& mode, const Join_demand& demand);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_VERIFY_CHAIN_H
