// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_ANSWER_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_ANSWER_H

#include "cad_build.h"

#include <string_view>

// The program `geometric_continuity_cad`, which alone needs OpenCASCADE, writes to its standard
// output this text, which identifies its build, then one of these, and behind it the bytes of a
// model or a reason. It is called as
//   geometric_continuity_cad FILE READING MEMORY
// with the bytes of a `Cad_reading` in hexadecimal digits, or with the word `solid` for an answer
// with the bytes of a `Cad_solid`, and the bytes of memory that it may take. When the file is
// one of Spline_numbers, .shapes, or has the bytes of a Shell_model, .shell, it writes that to the
// model of this name in the place of the reading, and answers with the model of no bytes. Its
// standard input is a pipe, the other end of which is open as long as anybody waits for the answer.
constexpr std::string_view cad_build = GEOMETRIC_CONTINUITY_CAD_BUILD;

enum class Cad_answer : char { model = 'M', bad_file = 'B', no_memory = 'N' };

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_ANSWER_H
