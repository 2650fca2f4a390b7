// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_SVG_PATHS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_SVG_PATHS_H

#include <CGAL/Exact_rational.h>

#include <ostream>
#include <string>

// Writes the curves of a text in the format .g2 as paths of lines and cubics, with y upwards; those
// that follow each other without a gap are one path. Curves of degrees above 3 are drawn by cubics
// that share their points and tangents, and are no farther away than `flatness`, or if that is 0,
// than 1/10000 of the size of the drawing; the stream of errors says so. Numbers are rounded to
// about 8 digits of the size. Where a tangent is continuous, it is so on the rounded numbers:
// handles are moved on their grid by align_handles(). Throws std::invalid_argument for surfaces,
// for curves that do not lie in the plane, and for rational ones.
void write_svg_paths(std::ostream& os, const std::string& g2, const CGAL::Exact_rational& flatness);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_SVG_PATHS_H
