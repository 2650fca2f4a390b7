// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_READ_IFC_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_READ_IFC_H

#include "formats/rails/Rail_check.h"

#include <istream>
#include <string>

// Reads the alignments of a file in IFC 4.3: the curves IfcCompositeCurve, IfcGradientCurve and
// IfcSegmentedReferenceCurve with the claims of their segments, and the layers of IfcAlignment that
// give the design. Each number is the decimal that is written, exactly.
//
// Throws GC::Error with file, line and reason: `malformed_input`, `work_limit`, `cannot_read_file`.
Rail_file read_ifc(const std::string& file);
Rail_file read_ifc(std::istream& stream, const std::string& name);

// Returns whether a file is in IFC: by its name, or by how it begins.
bool is_ifc_file(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_READ_IFC_H
