// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_READ_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_READ_SOLID_H

#include "formats/solids/Outlined_solid.h"
#include "formats/solids/Solid.h"

#include <string>
#include <variant>

// Returns whether the ending of a name is that of a solid: of a CAD model, or .off.
bool is_solid_file(const std::string& file);

// Reads the solid of a CAD model, whose doubles are taken as exact numbers, or of a polygon mesh
// .off, whose decimals and fractions are. Its faces are made planar, see make_planar(). Edges of
// a mesh are numbered as they come first in the faces. A CAD model may have outlines. Throws with
// the name of the file, the face, edge or vertex, and the reason.
std::variant<Solid, Outlined_solid> read_solid(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_READ_SOLID_H
