// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_DECIDE_CAD_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_DECIDE_CAD_H

#include "commands/cad/Cad_verdict.h"
#include "commands/commands.h"
#include "formats/cad/Cad_reading.h"

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Returns what is asked within a tolerance as it is written, without a requirement. Throws
// std::invalid_argument.
Cad_demand demand_within(const std::string& tolerance, const GC::Corner_threshold& kink);

// A CAD file and the verdicts on its edges.
struct Decided_cad_file {
  std::string file;
  Cad_model model;
  std::vector<Cad_verdict> verdicts;   // of each edge
  std::vector<Cad_join_verdict> joins; // the verdicts on those of curves without faces
  // how far each curve is bent, if there is a bound; those that cannot be decided are left out
  std::vector<std::pair<std::size_t, Cad_bend>> bends;
  // edges with two sides, each as often as it is decided: once for all that are equal
  std::size_t compared = 0;
};

// Reads CAD files and decides their edges, on all cores; meanwhile the next file is read. Each is
// passed on in turn.
void decide_cad_files(const Arguments& files, const Cad_demand& demand, const Cad_reading& reading,
                      const std::function<void(const Decided_cad_file&)>& take);

// How many edges there are of each kind, and how they do. Only inner edges, seams, knot lines and
// joins of curves have verdicts.
struct Cad_summary {
  std::size_t faces = 0, inner = 0, seams = 0, boundary = 0, non_manifold = 0, degenerate = 0, knot_lines = 0;
  // By the order that is proved. A report claims the edges that are undecided here as undecided,
  // and edges that are not compared as not covered.
  std::size_t g2 = 0, g1 = 0, g0 = 0, gaps = 0, undecided = 0, not_compared = 0;
  std::size_t kinks = 0, corners = 0, fading_corners = 0, bent = 0, folds = 0, inside_out = 0;
  // of those that are degenerate: it is not proved that they are points
  std::size_t no_points = 0;
  std::size_t exact = 0;     // decided with no tolerance as well
  std::size_t projected = 0; // edges with curves that are not in the file
  std::size_t sewn = 0;      // edges that sewing made of two
  // placed parts, if there are several, and the different ones among them
  std::size_t instances = 0, shapes = 0;
  std::size_t compared = 0; // edges, what is equal once
  std::size_t lost = 0;     // things that could not be read
  // edges of no face, their joins, the ends that meet no other one, places where three or more meet
  std::size_t curves = 0, joins = 0, free_ends = 0, branchings = 0;
  std::size_t beside = 0;      // boundary edges that lie beside others
  std::size_t open_shells = 0; // that are said to be closed

  std::size_t decided() const { return inner + seams + knot_lines + joins; }

  // Returns a hint what to do if no edge is compared; it is empty if there is nothing to say.
  std::string hint() const;

  void add(const Decided_cad_file& file, const Cad_demand& demand);

private:
  void add(Claim claim, int order, Cad_shape shape);
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_DECIDE_CAD_H
