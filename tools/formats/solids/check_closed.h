// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_CHECK_CLOSED_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_CHECK_CLOSED_H

#include "formats/solids/Solid.h"

// Throws std::runtime_error, with the face and the edge, if faces are not one closed shell: each
// edge belongs to two faces, which pass it in opposite directions, and all faces are connected by
// edges. Turns a shell inside out that has no positive volume.
void check_closed(Solid& solid);

// The words by which errors name a face: its number, and its label if it has one.
std::string face_name(const Solid& solid, std::size_t face);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_CHECK_CLOSED_H
