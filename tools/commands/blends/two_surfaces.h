// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_TWO_SURFACES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_TWO_SURFACES_H

#include "commands/command_line.h"
#include "commands/models/exact_models.h"
#include "files/input.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Two files with one surface each, and an edge of each.

// Returns the only one of the surfaces of a file.
template <class Surface> const Surface& only_surface(const std::string& file, const std::vector<Surface>& surfaces) {
  if (surfaces.size() != 1)
    throw GC::Error(GC::Error_code::malformed_input,
                    input_name(file) + ": " + std::to_string(surfaces.size()) + " surfaces where one is expected");
  return surfaces[0];
}

// Reads the surfaces of both files, each of which has one. They are rational surfaces if one of
// them is.
inline Surface_model<Exact_space> read_both_surfaces(const Arguments& files) {
  Surface_model<Exact_space> both;
  for (const std::string& file : files)
    read_exact_model({file}).visit([&](const auto& surfaces) { both.push_back(only_surface(file, surfaces)); });
  return both;
}
// Returns the edge of this name, u0 to v1.
inline GC::Patch_edge edge_of(const std::string& name) {
  for (GC::Patch_edge edge : GC::patch_edges)
    if (to_string(edge) == name) return edge;
  throw std::invalid_argument("--edges: '" + name + "' is none of u0, u1, v0, v1");
}
// Returns the edges of --edges, by default v1 and v0.
inline std::pair<GC::Patch_edge, GC::Patch_edge> given_edges(const Command_line& line) {
  if (!line.has("edges")) return {GC::Patch_edge::v1, GC::Patch_edge::v0};
  const std::string text = line.text("edges");
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw std::invalid_argument("--edges: two names are needed, e.g. v1,v0");
  return {edge_of(text.substr(0, comma)), edge_of(text.substr(comma + 1))};
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_TWO_SURFACES_H
