// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_NAME_WORK_LIMIT_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_NAME_WORK_LIMIT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Calls work(), and adds the place in the model, place(), to the refusal of work that is too much.
template <class Place, class Work> void name_work_limit(Place place, Work work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.code() != Error_code::work_limit) throw;
    const std::size_t code_length = to_string(error.code()).size() + 2;
    throw Error(error.code(), place() + ": " + std::string(error.what()).substr(code_length));
  }
}

inline std::string edge_name(std::size_t patch, Patch_edge edge) {
  return "patch " + std::to_string(patch) + ' ' + to_string(edge);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_NAME_WORK_LIMIT_H
