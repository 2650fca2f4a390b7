// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_SEVERAL_CORES_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_SEVERAL_CORES_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Whether TBB may use more than one core. Otherwise it need not be started, which takes memory.
inline bool several_cores() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL
#endif

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_SEVERAL_CORES_H
