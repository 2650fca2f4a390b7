// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_CURVE_SEGMENT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_CURVE_SEGMENT_H

#include "formats/ifc/Segment.h"

#include <cstdint>

namespace ifc {

// Returns a segment of a curve in the plan, in the profile, or, over the distance, of a cant.
Segment read_curve_segment(const File& file, std::uint64_t id, const Entity& of, bool is_cant);

} // namespace ifc

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_CURVE_SEGMENT_H
