// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// No include guard: included before functions with CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS, and
// enable_loop_warnings.h after them. Clang shall not warn where it cannot compute several iterations at a time, as with
// exact numbers.
#ifdef __clang__
#define CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_DISABLED
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wpass-failed"
#endif
