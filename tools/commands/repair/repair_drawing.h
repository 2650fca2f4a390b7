// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_DRAWING_H

#include "commands/repair/repair_contour.h"
#include "commands/repair/repair_report.h"

#include <string>

// Returns the text of a drawing whose paths are repaired, also those that are defined and not
// drawn. The reader of `verify` reads the result again, and its joins are counted as `verify`
// counts them. Throws GC::Error as read_svg_drawing() does, `malformed_input` also for UTF-16, and
// std::logic_error where what would be written is not what was computed.
std::string repaired_drawing(const std::string& text, const std::string& name, const Repair_options& options,
                             Repair_report& report);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_DRAWING_H
