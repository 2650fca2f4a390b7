// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SHELL_OF_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SHELL_OF_SOLID_H

#include "formats/cad/Shell_model.h"
#include "formats/solids/Rounded_solid.h"

#include <string>
#include <vector>

// Adds the vertices and edges of a rounded solid to a shell that has none.
void add_edges_of_solid(const Rounded_solid& solid, Shell_model& model);

// Adds its faces, with names for the plane ones and the blends. Loops may have other edges of the
// shell. Planes have the axes of the coordinates as parameters, or are surfaces of the degrees 1
// over a basis of their grid, so that parameter curves are exact.
void add_faces_of_solid(const Rounded_solid& solid, const std::vector<std::string>& face_names,
                        const std::vector<std::string>& blend_names, Shell_model& model);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SHELL_OF_SOLID_H
