// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_ADD_SEAMS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_ADD_SEAMS_H

#include "formats/cad/Shell_model.h"

// OpenCASCADE takes a face of a surface that is closed in one direction for valid only if its
// boundary is one loop in the parameters: along one rail, along the seam, back along the other
// rail, and back along the seam. Gives each such face whose two loops are the rails a seam where
// the closed direction begins; both rails have a vertex there, and the surface ends at them. Throws
// std::runtime_error, with the face, where this is not so.
void add_seams(Shell_model& model);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_ADD_SEAMS_H
