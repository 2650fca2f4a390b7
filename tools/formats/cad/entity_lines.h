// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_ENTITY_LINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_ENTITY_LINES_H

#include <string>
#include <unordered_map>

// The lines of a CAD file in which its entities stand, from 1 on, by their ids: "#123" of STEP,
// where "#123=" begins; "D123" of IGES, the line of the directory with this number. Empty for BREP,
// which has no ids, and for a file that cannot be read again.
std::unordered_map<std::string, long long> entity_lines(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_ENTITY_LINES_H
