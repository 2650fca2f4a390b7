// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_MAKE_PLANAR_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_MAKE_PLANAR_H

#include "formats/solids/Solid.h"

#include <optional>
#include <vector>

// A plane by a point and a normal.
struct Solid_plane {
  Solid::Point point, normal;
};

// Makes the faces of a solid exactly planar. A face whose vertices lie exactly in one plane has
// that plane; another one has that of the file, and without one that through the mean of its
// vertices with the normal of Newell, the sum of the cross products of successive vertices. A
// vertex which lies exactly in the planes of its faces stays. Another one moves to where the planes
// of its three faces meet.
//
// Throws std::runtime_error, with the face, edge or vertex: if a vertex would move by more than the
// tolerance and by more than a millionth of the size of the solid, if it has to move and has
// another number of faces, if two faces at an edge lie in one plane or a vertex lies inside of a
// straight edge.
void make_planar(Solid& solid, const std::vector<std::optional<Solid_plane>>& planes, double tolerance);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_MAKE_PLANAR_H
