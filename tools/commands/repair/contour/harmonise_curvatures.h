// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_HARMONISE_CURVATURES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_HARMONISE_CURVATURES_H

#include "commands/repair/repair_contour.h"

#include <vector>

// Makes the curvatures of smooth joins agree such that doing it again would change nothing. Where
// handles would go on and on, beyond how far they may, they all stay.
std::vector<Curvature_jump> harmonise_curvatures(Grid_contour& contour, const Repair_options& options);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_HARMONISE_CURVATURES_H
