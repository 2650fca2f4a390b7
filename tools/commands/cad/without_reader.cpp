// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/verify_cad.h"
#include "commands/report_inputs.h"
#include "formats/cad/read_cad.h"

// The program without OpenCASCADE: there is no reader, and reading says so.

int verify_cad(const Arguments& files, const Report_mode&, const Cad_demand&, const Cad_reading& reading) {
  for (const std::string& file : files) read_cad(file, reading);
  return requirement_not_met;
}

void report_cad(const Arguments& files, const Report_demand&, Report_page&) {
  for (const std::string& file : files) read_cad(file, Cad_reading());
}
