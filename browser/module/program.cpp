// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The parts of the program that read and report drawings, fonts, chains and models: one translation
// unit, so that what they instantiate is compiled once.

#include "commands/chains/decided_join.cpp"
#include "commands/chains/join_report.cpp"
#include "commands/chains/verify_chain.cpp"
#include "commands/drawings/Subpath_joins.cpp"
#include "commands/drawings/drawing_kink.cpp"
#include "commands/drawings/segment_joins.cpp"
#include "commands/drawings/verify_drawings.cpp"
#include "commands/fonts/font_json.cpp"
#include "commands/fonts/font_report.cpp"
#include "commands/fonts/font_text.cpp"
#include "commands/fonts/read_fonts.cpp"
#include "commands/fonts/verify_fonts.cpp"
#include "commands/models/Model_surfaces.cpp"
#include "commands/models/verify_surfaces.cpp"
#include "commands/repair/grid_contour.cpp"
#include "commands/repair/path_text.cpp"
#include "commands/repair/repair_contour.cpp"
#include "commands/repair/repair_drawing.cpp"
#include "formats/font/Cff_outlines.cpp"
#include "formats/font/Font_face.cpp"
#include "formats/font/Glyph_selection.cpp"
#include "formats/font/font_files.cpp"
#include "formats/gcode/toolpath.cpp"
#include "formats/svg/Drawing_document.cpp"
#include "formats/svg/svg_drawing.cpp"
#include "reports/Conclusion.cpp"
#include "reports/Report.cpp"
#include "reports/findings.cpp"
#include "reports/junit.cpp"
#include "reports/report_joins.cpp"
#include "reports/report_segments.cpp"
#include "reports/sarif.cpp"
