// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SHELL_OF_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SHELL_OF_SOLID_H

#include "formats/cad/Shell_model.h"
#include "formats/solids/Rounded_solid.h"

#include <string>
#include <vector>

// Returns a rounded solid as a shell that can be written to a CAD model, with names for its plane
// faces and its blends. Planes have the axes of the coordinates as parameters, or are surfaces of
// the degrees 1 over a basis of their grid, so that parameter curves are exact.
Shell_model shell_of_solid(const Rounded_solid& solid, const std::vector<std::string>& face_names,
                           const std::vector<std::string>& blend_names);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SHELL_OF_SOLID_H
