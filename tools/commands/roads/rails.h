// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_RAILS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_RAILS_H

#include "commands/chains/curvature_bound.h"
#include "commands/command_line.h"
#include "commands/commands.h"

#include <CGAL/Exact_rational.h>

#include <optional>
#include <stdexcept>
#include <string>

// The demands on alignments in IFC and LandXML. Without tolerances those of the file hold.
struct Rail_demand {
  std::optional<CGAL::Exact_rational> gap = {}, kink = {};
  CGAL::Exact_rational curvature = CGAL::Exact_rational(CGAL::Exact_rational(1) / 1000000);
  std::optional<int> order = {}; // up to which claims are decided, and which is asked where nothing is claimed
  std::optional<Curvature_bound> bound = {}; // of pieces in the plan
};

// Returns whether a file has alignments that verify_rails() reads.
bool is_rail_file(const std::string& file);

// Runs `verify` for alignments: prints all that is decided about them, and returns the exit code.
int verify_rails(const Arguments& files, const Report_mode& mode, const Rail_demand& demand);

// Returns the demands on alignments.
template <class Required> Rail_demand rail_demand(const Command_line& line, const Required& required) {
  typedef CGAL::Exact_rational FT;
  line.refuse({"surfaces", "closed", "within", "kernel", "max-order", "kink-angle", "certificate"},
              "not for alignments");
  const auto given = [&line](const std::string& option) -> std::optional<FT> {
    if (!line.has(option)) return std::nullopt;
    const FT x = line.number<FT>(option, FT(0));
    if (x < FT(0)) throw std::invalid_argument("--" + option + ": " + line.text(option) + " is negative");
    return x;
  };
  Rail_demand demand{given("gap"), given("kink")};
  demand.curvature = given("curvature").value_or(demand.curvature);
  if (!required) return demand;
  if (required->text() != "G0" && required->text() != "G1" && required->text() != "G2")
    throw std::invalid_argument("--require " + required->text() + ": of alignments G0, G1 and G2 are decided");
  demand.order = required->order();
  return demand;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_RAILS_H
