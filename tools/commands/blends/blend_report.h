// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_REPORT_H

#include "commands/chains/curvature_bound.h"
#include "commands/chains/join_report.h"
#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

// The report about a blend: its joins, decided in exact arithmetic, and how fair it is.
struct Blend_report {
  Blend_report(const std::string& strategy, const Exact_curve& gamma, const Exact_curve& phi, const Exact_curve& psi,
               const Exact& beta, const Exact& eta, const std::string& parameters,
               const std::optional<GC::Fair_report>& search, bool limited);

  std::string strategy;
  Exact_curve curve;
  Join start, end;
  Exact beta, eta;
  std::string parameters; // in words
  double fairness, bending_energy;
  std::optional<GC::Curvature_extrema> curvature; // empty where the blend has a cusp
  std::optional<GC::Fair_report> search;          // of the strategies that search
  // why it is hardly what is wanted, smooth as it is; may be empty
  std::string warning;
  // whether the curvature is within the bound, if there is one
  std::optional<bool> is_within = {};

  // How many of both joins do not have the order 2 or 3 that was asked for.
  std::size_t broken_joins(int order) const;
  bool is_proved(int order) const { return broken_joins(order) == 0; }
};

// Write the reports on blends of order 2 or 3 as a table, and as JSON. Energies that cost more than
// the limit are left out, unless the user has set it.
void write_table(std::ostream& os, const std::vector<Blend_report>& reports, int order, bool limited);
void write_json(std::ostream& os, const std::vector<Blend_report>& reports, int order,
                const std::optional<Curvature_bound>& bound);

// Writes which strategies are within the bound, or which is nearest to it. `taken` is the one that
// is chosen, or empty.
void write_choice(std::ostream& os, const std::vector<Blend_report>& reports, const Curvature_bound& bound,
                  const std::string& taken);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_REPORT_H
