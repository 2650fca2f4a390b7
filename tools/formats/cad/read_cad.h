// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_READ_CAD_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_READ_CAD_H

#include "commands/commands.h"
#include "formats/cad/Cad_model.h"
#include "formats/cad/Cad_reading.h"
#include "formats/cad/Cad_solid.h"

#include <string>

// Returns whether these are CAD models, by their extensions. Throws std::invalid_argument when only
// some are.
bool are_cad_files(const Arguments& files);

// Reads a STEP, IGES or BREP file. Throws with its name and the reason: also when the program has
// been built without OpenCASCADE.
Cad_model read_cad(const std::string& file, const Cad_reading& reading);

// Reads the faces of such a file, which has planes and walls only. Throws with the name of the
// file, and the face or the edge, for others.
Cad_solid read_cad_solid(const std::string& file);

// Makes a model of the splines in a file .shapes, or of the shell in a file .shell, see
// write_cad(). Throws std::runtime_error with the reason.
void make_cad_model(const std::string& given, const std::string& model);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_READ_CAD_H
