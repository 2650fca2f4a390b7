// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_SHELL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_SHELL_H

#include "formats/cad/Shell_model.h"

#include <string>

// Writes a shell, with seams where faces of closed surfaces lack them, as a solid in the format
// that the ending of the name tells, STEP or BREP. Splines are read back as the same doubles, u
// and v of surfaces exchanged where this makes v the longer direction; the directions of planes are
// normalised. Throws std::runtime_error with the reason, and writes
// nothing, if OpenCASCADE's BRepCheck_Analyzer does not find the solid valid, or if it is not
// closed or has no positive volume.
void write_shell(Shell_model shell, const std::string& model_file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_SHELL_H
