// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_WRITE_SHAPES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_WRITE_SHAPES_H

#include "commands/command_line.h"

#include <functional>
#include <ostream>
#include <string>

// Curves and surfaces that a command has made are written in the format of the ending of --output:
//   .g2   as they are; with --decimals or --kernel double as the shortest decimals that lead to the
//         nearest doubles, or with so many digits behind the point
//   .svg  plane polynomial curves as paths, those of degrees above 3 by cubics within --flatness
//   .dxf  curves as splines
//   .step, .stp, .brep, .brp  wires and faces, where OpenCASCADE is there
//   .json control points, weights and knots
// All but .g2 and .svg hold the nearest doubles.

// Declares the options --output, with what is written, --decimals and --flatness.
void add_shape_output(po::options_description_easy_init& add, const std::string& what);

// Refuses names and options that do not fit together, before anything is computed.
void check_shape_output(const Command_line& line);

// Writes what write(os) writes in the format .g2 to --output, in the format of its ending. Throws
// std::invalid_argument for shapes that the format does not hold.
void write_shapes(const Command_line& line, const std::function<void(std::ostream&)>& write);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_WRITE_SHAPES_H
