// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/decided_join.h"

#include <CGAL/Geometric_continuity/joins/join_continuity.h>

GC::Join_continuity<Exact> decided_join(const Exact_curve& left, const Exact_curve& right, int max_order) {
  return GC::continuity(left, right, max_order);
}
