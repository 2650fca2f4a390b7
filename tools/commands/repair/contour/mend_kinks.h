// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_MEND_KINKS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_MEND_KINKS_H

#include "commands/repair/repair_contour.h"

// Makes the kinks smooth. Returns the joins that are not repaired, and those that have no grade.
Contour_repair mend_kinks(Grid_contour& contour, const Repair_options& options);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_MEND_KINKS_H
