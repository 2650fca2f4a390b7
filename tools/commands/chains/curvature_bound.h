// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CURVATURE_BOUND_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CURVATURE_BOUND_H

#include "formats/g2_text/curves.h"
#include "reports/Conclusion.h"

#include <CGAL/Geometric_continuity/curves/fairness.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// The bound of --max-curvature K, or of --min-radius R with K = 1/R.
struct Curvature_bound {
  Exact curvature;
  std::string words; // e.g. "bent by at most the curvature 0.5", behind "is" or "not"
};

// Asks for the bound in the subject of a report on joins: of them, too, if they have a requirement.
void demand_curvature(Report_subject& subject, const Curvature_bound& bound);

// Writes the bound as a member of a JSON object.
std::string json_member(const Curvature_bound& bound);

// The place where a curve is bent most, if it exceeds a bound, and its words.
std::optional<GC::Curvature_excess> curvature_excess(const Exact_curve& curve, const Curvature_bound& bound);
std::string to_string(const GC::Curvature_excess& excess);
void write_json_members(std::ostream& os, const GC::Curvature_excess& excess);

// The absolute value of the curvature there.
GC::Enclosure size_of(const GC::Curvature_excess& excess);

// The curves of a text .g2 that exceed a bound.
struct Bent_curves {
  struct Curve {
    std::size_t number;
    GC::Curvature_excess excess;
  };
  std::vector<Curve> curves = {};
  bool is_met() const { return curves.empty(); }
};
Bent_curves bent_curves(const std::string& text, const Curvature_bound& bound);

// Write what is decided about curves: lines of text, and a member of a JSON object with a comma
// before it.
void write_text(std::ostream& os, const Bent_curves& bent, const Curvature_bound& bound);
void write_json_member(std::ostream& os, const Bent_curves& bent, const Curvature_bound& bound);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CURVATURE_BOUND_H
