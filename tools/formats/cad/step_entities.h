// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_STEP_ENTITIES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_STEP_ENTITIES_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// An entity of a STEP file as it stands there, e.g. #20 = ORIENTED_EDGE('',*,*,#21,.T.).
struct Step_entity {
  std::uint64_t id = 0;
  // of one that is composed of several: all of them, with blanks in between
  std::string type;
  std::vector<std::uint64_t> references; // the ids in it, in order
};

// Returns the entities of the text of a STEP file, in order. Text that is no entity is skipped.
std::vector<Step_entity> step_entities(std::string_view text);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_STEP_ENTITIES_H
