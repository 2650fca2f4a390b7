// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_CORES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_CORES_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>

#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#endif

// As long as it lives, the program runs on at most eight cores, which keeps its memory small; on
// one where the memory of processes is limited, since threads need room of their own.
class Cores {
#ifdef CGAL_LINKED_WITH_TBB
  static std::size_t number() {
    constexpr rlim_t room = rlim_t(1) << 28;
    rlimit memory;
    if (::getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur < room) return 1;
    return (std::min)(std::size_t(8), tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  }
  const tbb::global_control control_{tbb::global_control::max_allowed_parallelism, number()};

public:
  Cores() {
#ifdef __GLIBC__
    ::mallopt(M_ARENA_MAX, 1); // threads would reserve 64 MiB each
#endif
  }
#endif
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_CORES_H
