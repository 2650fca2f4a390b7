// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_COMMANDS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_COMMANDS_H

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace boost {
namespace program_options {
class options_description_easy_init;
} // namespace program_options
} // namespace boost

namespace CGAL {
namespace Geometric_continuity {
struct Edge_tolerance;
} // namespace Geometric_continuity
} // namespace CGAL

// The program returns one of these to the shell.
enum Exit_code { requirement_met = 0, requirement_not_met = 1, bad_input = 2 };

// How `verify` prints what it decided.
enum class Report_format { text, json, sarif, junit };

class Baseline;

// How `verify` reports and judges what it decided.
struct Report_mode {
  Report_format format = Report_format::text;
  bool allow_undecided = false;        // what is undecided does not count
  bool allow_uncovered = false;        // what is not covered does not count
  bool allow_empty = false;            // nothing to decide is no error
  bool summary = false;                // only the counts, and what is not met and not decided
  std::ostream* certificate = nullptr; // where certificates are written
  const Baseline* baseline = nullptr;  // what it knows is not reported

  // Returns whether the report consists of findings.
  bool has_findings() const {
    return format == Report_format::sarif || format == Report_format::junit || baseline != nullptr;
  }
};

typedef std::vector<std::string> Arguments;

class Command_line;

// A command: its name, the text of its help, its options, and what it does: it returns an
// Exit_code, and throws on bad input.
struct Command {
  const char* name;
  const char* usage;
  void (*describe)(boost::program_options::options_description_easy_init add);
  int (*run)(const Command_line& line);
};

extern const Command blend_command, connect_command, extend_command, fit_command, interpolate_command, match_command,
    merge_command, plot_command, repair_command, report_command, round_edges_command, tessellate_command,
    verify_command;

// A picture of surfaces, as its options describe it.
struct Surface_picture {
  std::string output, title;
  std::string view;    // "AZIMUTH,ELEVATION" in degrees; empty for the default
  bool shaded = false; // otherwise in strips that show kinks
};

// Runs `plot --surfaces`: draws the surfaces of the files as one model.
int plot_surfaces(const Arguments& files, const Surface_picture& picture);

// Runs `verify --surfaces`: decides the edges of the model that the files form, and prints a
// report. With a tolerance an edge meets the requirement also when it does so within the tolerance.
int verify_surfaces(const Arguments& files, const Report_mode& mode, const std::optional<int>& required_g_order,
                    const std::optional<CGAL::Geometric_continuity::Edge_tolerance>& tolerance);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_COMMANDS_H
