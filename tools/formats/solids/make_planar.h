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
// vertices with the normal of Newell, the sum of the cross products of successive vertices. Faces
// on both sides of an edge, the normals of which are parallel up to a millionth, have one plane:
// that of one of them.
//
// A vertex which lies exactly in the planes of its faces stays. Another one moves to where its
// planes meet, three of them in a point; the shortest way to the line where there are two planes,
// and to the plane where there is one.
//
// Throws std::runtime_error, with the face or vertex: if a vertex would move by more than the
// tolerance and by more than a millionth of the size of the solid, or if more planes than three
// meet in it, but not exactly.
void make_planar(Solid& solid, const std::vector<std::optional<Solid_plane>>& planes, double tolerance);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_MAKE_PLANAR_H
