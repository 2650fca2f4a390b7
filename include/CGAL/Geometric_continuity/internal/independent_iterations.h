// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_INDEPENDENT_ITERATIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_INDEPENDENT_ITERATIONS_H

// Before a loop: its iterations do not depend on each other, so that a compiler may vectorise it.
#if defined(__clang__)
#define CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
#endif

// Before and after functions with such loops: clang shall not warn where it cannot compute several
// iterations at a time, as with exact numbers.
#if defined(__clang__)
#define CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF                                                                    \
  _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Wpass-failed\"")
#define CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON _Pragma("clang diagnostic pop")
#else
#define CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF
#define CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON
#endif

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_INDEPENDENT_ITERATIONS_H
