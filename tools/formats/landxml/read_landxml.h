// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_LANDXML_READ_LANDXML_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_LANDXML_READ_LANDXML_H

#include "formats/rails/Rail_check.h"

#include <istream>
#include <string>
#include <string_view>

// Reads the alignments of a file in LandXML, whose elements Line, Curve and Spiral say the same
// more than once: points, directions, lengths, radii, constants and angles. Each number is the
// decimal that is written, exactly.
//
// Throws GC::Error with file, line and reason: `malformed_input`, `work_limit`, `cannot_read_file`.
Rail_file read_landxml(const std::string& file);
Rail_file read_landxml(std::istream& stream, const std::string& name);

// Returns whether a text begins as a file in LandXML does.
bool begins_as_landxml(std::string_view text);

// Returns whether a file is in LandXML, by how it begins.
bool is_landxml_file(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_LANDXML_READ_LANDXML_H
