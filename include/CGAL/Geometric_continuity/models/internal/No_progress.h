// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_NO_PROGRESS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_NO_PROGRESS_H

#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// What is told about the progress of a long work when nobody asks for it.
struct No_progress {
  void operator()(std::size_t) const {}
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_NO_PROGRESS_H
