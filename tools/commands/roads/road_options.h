// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_OPTIONS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_OPTIONS_H

#include "commands/command_line.h"
#include "commands/roads/verify_roads.h"

#include <stdexcept>
#include <string>

inline void describe_road_tolerances(po::options_description_easy_init add) {
  add("gap", po::value<std::string>(),
      "for road networks and alignments: the largest gap, step and error of a length, in the unit of the file; 0.001 "
      "if not given, in IFC the precision of the file");
  add("kink", po::value<std::string>(),
      "for road networks and alignments: the largest angle of two headings, in radians, and the largest jump of a "
      "slope; 0.001 if not given, in IFC atan2(precision, length)");
  add("curvature", po::value<std::string>(),
      "for road networks and alignments: the largest jump of the curvature that is G2; 0.000001 if not given");
}

// The tolerances that are given.
inline void read_road_tolerances(const Command_line& line, Road_demand& demand) {
  typedef CGAL::Geometric_continuity::Alignment_tolerance::FT FT;
  const auto read = [&line](const std::string& option, FT& x, std::string& text) {
    x = line.number<FT>(option, x);
    if (x < FT(0)) throw std::invalid_argument("--" + option + ": " + line.text(option) + " is negative");
    if (line.has(option)) text = line.text(option);
  };
  read("gap", demand.tolerance.gap, demand.gap);
  read("kink", demand.tolerance.kink, demand.kink);
  read("curvature", demand.tolerance.curvature, demand.curvature);
}

// Returns the demands on road networks; G1 where none is given.
template <class Required> Road_demand road_demand(const Command_line& line, const Required& required) {
  line.refuse({"surfaces", "closed", "within", "kernel", "max-order", "kink-angle", "certificate"},
              "not for road networks");
  Road_demand demand;
  read_road_tolerances(line, demand);
  demand.borders = line.has("lane-borders");
  if (!required) return demand;
  if (required->text() != "G0" && required->text() != "G1" && required->text() != "G2")
    throw std::invalid_argument("--require " + required->text() + ": of road networks G0, G1 and G2 are decided");
  demand.order = required->order();
  return demand;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_OPTIONS_H
