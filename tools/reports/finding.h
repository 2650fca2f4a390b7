// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_H

#include "reports/Claims.h"

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <optional>
#include <string>
#include <string_view>

// The subject of a finding: the rules of a report.
enum class Finding_rule {
  gap,          // the ends, or the edges, are apart
  corner,       // the angle of the tangents, or of the normals, is larger than that of a kink
  kink,         // the tangents, or the normals, differ
  tangent,      // there is no tangent, or no normal, on a side
  curvature,    // the curvature jumps
  bend,         // a curve is bent more than it may be
  derivative,   // a higher derivative jumps, or one with respect to the parameter
  undecided,    // the tolerance lies inside of the bounds, or the order cannot be decided
  not_verified, // what cannot be read or compared
  rounding,     // segments that are no longer than rounding are looked through
  length        // the arc length is not the one that is declared
};

// The name of a rule in reports.
inline std::string rule_id(Finding_rule rule) {
  switch (rule) {
  case Finding_rule::gap: return "gap";
  case Finding_rule::corner: return "corner";
  case Finding_rule::kink: return "kink";
  case Finding_rule::tangent: return "tangent";
  case Finding_rule::curvature: return "curvature";
  case Finding_rule::bend: return "bend";
  case Finding_rule::derivative: return "derivative";
  case Finding_rule::undecided: return "undecided";
  case Finding_rule::not_verified: break;
  case Finding_rule::rounding: return "rounding";
  case Finding_rule::length: return "length";
  }
  return "not-verified";
}

// The rule of this name.
inline std::optional<Finding_rule> rule_of(std::string_view id) {
  for (const Finding_rule rule :
       {Finding_rule::gap, Finding_rule::corner, Finding_rule::kink, Finding_rule::tangent, Finding_rule::curvature,
        Finding_rule::bend, Finding_rule::derivative, Finding_rule::undecided, Finding_rule::not_verified,
        Finding_rule::rounding, Finding_rule::length})
    if (rule_id(rule) == id) return rule;
  return std::nullopt;
}

// note: worth a word. warning: not decided, which is allowed. error: the requirement is not met, or
// it is not decided.
enum class Finding_level { note, warning, error };

// The name of a level, as compilers and SARIF have it.
inline const char* level_name(Finding_level level) {
  return level == Finding_level::error ? "error" : level == Finding_level::warning ? "warning" : "note";
}

// How far a defect is from none, in guaranteed bounds.
struct Measure {
  const char* quantity; // "gap", "angle_degrees", "curvature_jump", ...
  CGAL::Geometric_continuity::Enclosure bounds;
};

// By what a finding is known again in another version of a file. The numbers behind the hashes
// count those that are equal.
struct Fingerprints {
  std::string place;  // the object and the place on it
  std::string defect; // what is there, wherever it is
};

// The line of a place that stands in no line of its file, though that has lines: SARIF then points
// to the whole file.
constexpr long long no_line = -1;

// A defect, or an undecided thing, at one place of a file. All texts may contain any bytes.
struct Finding {
  std::string file;   // as it is named in messages
  long long line = 0; // from 1 on; 0 where it is not known, no_line where there is none
  std::string kind;   // of the place: "join", "edge", "element", "glyph", ...
  // where in the file, e.g. `path "leaf" (line 50), subpath 1, commands 3 c - 4 c`
  std::string place;
  Finding_rule rule;                         // the kind of the defect
  Finding_level level = Finding_level::note; // how serious it is: set by the report
  std::string message;                       // a sentence with the numbers, without the place
  // the numbers as members of a JSON object, e.g. `"angle_degrees":[1.5,1.6]`; may be empty
  std::string properties;
  Claim claim = Claim::met; // set by the report
  // The object of the place, and the spot on it, as other versions of the file have them: without
  // lines, and without numbers that change when something is inserted elsewhere, as far as names
  // allow. Where there is no object it is the place.
  std::string object = {}, spot = {};
  // The shape of the defect, the same when it is moved or gets another number; the object and the
  // spot where it is empty.
  std::string shape = {};
  std::optional<Measure> measure = {};
  std::optional<Measure> behind = {}; // of a gap: the angle of what does not meet there
  Fingerprints fingerprints = {};     // set by the report
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_H
