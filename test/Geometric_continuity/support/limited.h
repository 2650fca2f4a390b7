// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

// Returns work() with a limit of the work on each object.
template <class Work> auto limited(CGAL::Geometric_continuity::Work_limit limit, Work work) {
  const CGAL::Geometric_continuity::Work_scope each(limit);
  return work();
}
