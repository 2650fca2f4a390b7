// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_VERIFY_DRAWINGS_H
#define GEOMETRIC_CONTINUITY_DEMO_VERIFY_DRAWINGS_H

#include "commands.h"
#include "join_report.h"

#include <optional>

// Runs `verify` for SVG drawings: prints the joins of all paths and basic shapes, and returns the exit code.
int verify_drawings(const Arguments& files, int max_order, GC::Work_limit limit, const Report_mode& mode,
                    const std::optional<Requirement>& required);

#endif // GEOMETRIC_CONTINUITY_DEMO_VERIFY_DRAWINGS_H
