// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DECIDED_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DECIDED_JOIN_H

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/joins/join_result.h>

// Decides the join of two curves as GC::continuity() does, which is compiled once.
GC::Join_continuity<Exact> decided_join(const Exact_curve& left, const Exact_curve& right, int max_order);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DECIDED_JOIN_H
