// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_OFFER_ARCS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_OFFER_ARCS_H

#include "commands/repair/repair_contour.h"

#include <vector>

// Changes arcs of joins that were not repaired, where that is asked for and can be written, and
// notes what there is for the others.
void offer_arcs(Grid_contour& contour, const Repair_options& options, Contour_repair& result);

// Returns what has changed of arcs.
std::vector<Arc_change> arc_changes(const Grid_contour& given, const Grid_contour& contour);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_OFFER_ARCS_H
