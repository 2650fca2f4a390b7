// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_CLOSE_GAPS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_CLOSE_GAPS_H

#include "commands/repair/repair_contour.h"

#include <CGAL/Exact_rational.h>

#include <vector>

// Closes the gaps that are no wider than this, in coordinates. Both nodes come to one point, with
// the handles that belong to them alone: to the middle, or to one of the nodes where this harms
// fewer joins.
std::vector<Closed_gap> close_gaps(Grid_contour& contour, const Repair_options& options,
                                   const CGAL::Exact_rational& widest);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_CLOSE_GAPS_H
