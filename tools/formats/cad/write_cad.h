// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_WRITE_CAD_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_WRITE_CAD_H

#include "formats/cad/Shell_model.h"
#include "formats/cad/Spline_numbers.h"

#include <ostream>
#include <string>
#include <vector>

// Writes splines as a CAD model, .step, .stp, .brep or .brp, by OpenCASCADE in a process of its
// own. Curves that follow each other without a gap are one wire; a surface is a face. Throws
// std::runtime_error with the reason: also when the program has been built without OpenCASCADE.
void write_cad(std::ostream& os, const std::vector<Spline_numbers>& shapes, const std::string& ending);

// Writes a closed shell in the same way, as a solid whose faces share their edges. Throws also when
// OpenCASCADE does not find it valid.
void write_cad(std::ostream& os, const Shell_model& shell, const std::string& ending);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_WRITE_CAD_H
