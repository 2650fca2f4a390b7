// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPORT_INPUTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPORT_INPUTS_H

#include "commands/commands.h"
#include "commands/fonts/Glyph_join.h"
#include "commands/roads/verify_roads.h"
#include "formats/cad/Cad_reading.h"
#include "formats/font/Glyph_selection.h"
#include "reports/report_page.h"

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <string>

// The demands of `report` on its inputs.
struct Report_demand {
  GC::Corner_threshold corner_threshold;
  bool closed = false;      // the last curve of a chain leads back to its first
  Glyph_selection glyphs;   // of fonts
  Handle_rounding rounding; // of fonts
  std::string tolerance;    // of CAD models, as it is written; empty for that of `verify`
  Cad_reading reading;      // of CAD models
  Road_demand roads = {};   // of road networks
};

// Each of these reads files, decides about their joins, and puts these on the page.
void report_cad(const Arguments& files, const Report_demand& demand, Report_page& page);
void report_chain(const Arguments& files, const Report_demand& demand, Report_page& page);
void report_drawings(const Arguments& files, const Report_demand& demand, Report_page& page);
void report_fonts(const Arguments& files, const Report_demand& demand, Report_page& page);
void report_roads(const Arguments& files, const Report_demand& demand, Report_page& page);
void report_surfaces(const Arguments& files, const Report_demand& demand, Report_page& page);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPORT_INPUTS_H
