// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_MODEL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_MODEL_H

#include <string>

// Reads splines as Spline_numbers writes them, and writes them as a model in the format that the
// ending of the name tells; see write_cad(). Throws std::runtime_error with the reason.
void write_model(const std::string& shapes_file, const std::string& model_file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_MODEL_H
