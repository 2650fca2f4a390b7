// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_GCODE_TOOLPATH_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_GCODE_TOOLPATH_H

#include "formats/svg/svg_drawing.h"

#include <istream>
#include <string>
#include <string_view>

// Reads the feed moves of a program in G-code (RS-274: LinuxCNC, grbl, Marlin) as subpaths: G1
// lines, G2 and G3 arcs by centre or radius, G5 cubics and G5.1 quadratics, in the planes G17 to
// G19, with G7 and G8, G20 and G21, G90 and G91, G90.1 and G91.1. Coordinates are those of the
// plane in the unit of the first move. The command of a segment is its line, its letter the digit
// behind G.
//
// A subpath ends at rapid moves, at moves along the third axis alone, and in programs that extrude,
// at moves without extrusion. It is closed where it ends at its start. An arc leads from its start
// to its end, as they are written, around the point of their bisector that is nearest to the
// written centre; the distances of the ends from the written one may differ by 0.1 % of the radius,
// or by 0.005 mm.
//
// These are handed on as not read: moves along all three axes at once, or of rotary axes; moves
// whose start is not told by the program; what is given by parameters and expressions; lines that
// are optional; threads, probing and splines (G5.2); and all that follows O-words and calls of
// subprograms. Lines with one reason that follow each other are one.
void read_toolpath(std::istream& stream, const std::string& name, Drawing_handler& handler);

// Returns whether a text begins as a program in G-code does.
bool begins_as_gcode(std::string_view text);

// Returns whether a file is a program in G-code: by its name, or by how it begins.
bool is_toolpath_file(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_GCODE_TOOLPATH_H
