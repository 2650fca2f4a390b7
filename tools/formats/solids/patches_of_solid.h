// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_PATCHES_OF_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_PATCHES_OF_SOLID_H

#include "commands/models/exact_models.h"
#include "formats/solids/Rounded_solid.h"
#include "formats/solids/Solid.h"

#include <optional>
#include <vector>

// A solid as a model of surfaces with four edges, and back.

// Returns surfaces without holes between them, over the exact values of the doubles: two surfaces
// have each edge as a whole. Blends are cut into Bezier patches; a plane face has a ring of patches
// along its boundary, and triangles inside of it, each cut into three patches.
std::vector<Exact_surface> patches_of_solid(const Rounded_solid& solid);

// Returns the solid of surfaces that lie in planes and have straight edges, if they are closed. An
// edge of one of them may consist of edges of several others. Edges have the numbers 4 p + e for
// the edge e of the patch p.
std::optional<Solid> solid_of_patches(const std::vector<Exact_surface>& surfaces);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_PATCHES_OF_SOLID_H
