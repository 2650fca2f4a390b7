// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_DESIGN_SEGMENT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_DESIGN_SEGMENT_H

#include "formats/ifc/Segment.h"

namespace ifc {

// Sets the ends of a segment of the horizontal layer of a design. Throws Not_covered.
void read_horizontal_design(const File& file, Segment& s, const Entity& e);

// Sets the ends of a segment of the vertical layer: of height over distance. The segment is between
// two others, which may be missing. Throws Not_covered.
void read_vertical_design(const File& file, Segment& s, const Entity& e, const Entity* before, const Entity* after);

} // namespace ifc

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_DESIGN_SEGMENT_H
