// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_READER_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_READER_H

#include "formats/cad/Cad_model.h"

#include <string>

// What the module `geometric_continuity_cad` offers, which alone needs OpenCASCADE: the program loads it when there is a CAD file to
// read. Throws std::runtime_error with the reason, without the name of the file, and std::bad_alloc.
extern "C" void geometric_continuity_read_cad(const std::string& file, const Cad_reading& reading, Cad_model& model);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_READER_H
