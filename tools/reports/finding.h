// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_H

#include "commands/commands.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

// What a finding is about: the rules of a report.
enum class Finding_rule {
  gap,         // the ends, or the edges, are apart
  corner,      // the angle of the tangents, or of the normals, is larger than that of a kink
  kink,        // the tangents, or the normals, differ
  tangent,     // there is no tangent, or no normal, on a side
  curvature,   // the curvature jumps
  derivative,  // a higher derivative jumps, or one with respect to the parameter
  undecided,   // the tolerance lies inside of the bounds, or the order cannot be decided
  not_verified // what cannot be read or compared
};

// The name of a rule in reports.
inline std::string rule_id(Finding_rule rule) {
  switch (rule) {
  case Finding_rule::gap: return "gap";
  case Finding_rule::corner: return "corner";
  case Finding_rule::kink: return "kink";
  case Finding_rule::tangent: return "tangent";
  case Finding_rule::curvature: return "curvature";
  case Finding_rule::derivative: return "derivative";
  case Finding_rule::undecided: return "undecided";
  case Finding_rule::not_verified: break;
  }
  return "not-verified";
}

// note: nothing is required. warning: not all could be verified. error: the requirement is not met.
enum class Finding_level { note, warning, error };

// What is wrong, or could not be told, at one place of a file. All texts may hold any bytes.
struct Finding {
  std::string file;       // as it is named in messages
  long long line = 0;     // from 1 on; 0 where it is not known
  std::string kind;       // of the place: "join", "edge", "element", "glyph", ...
  std::string place;      // where in the file, e.g. `path "leaf" (line 50), subpath 1, commands 3 c - 4 c`
  Finding_rule rule;      // the kind of the defect
  Finding_level level;    // how serious it is
  std::string message;    // a sentence with the numbers, without the place
  std::string properties; // the numbers as members of a JSON object, e.g. `"angle_degrees":[1.5,1.6]`; may be empty
};

// Collects findings, one after the other, and writes them in the format of a tool when all input has been read and found good.
// Only what does not fit in a few megabytes goes to a temporary file, whatever the number of findings.
class Finding_writer {
public:
  virtual ~Finding_writer() = default;

  virtual void add(const Finding& finding) = 0;

  // Tells that so many more places of a file, e.g. "joins", are as they should be. So that a file is named in the report, it is
  // called for each file, also with 0.
  virtual void add_passed(const std::string& file, std::size_t number, const std::string& places) = 0;

  // Writes the report. The summary consists of members of a JSON object, e.g. `"joins":3,"met":true`.
  virtual void print(std::ostream& os, const std::string& summary) = 0;
};

std::unique_ptr<Finding_writer> sarif_writer();
std::unique_ptr<Finding_writer> junit_writer();

// Returns a writer for Report_format::sarif or Report_format::junit.
inline std::unique_ptr<Finding_writer> finding_writer(Report_format format) {
  return format == Report_format::sarif ? sarif_writer() : junit_writer();
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_H
