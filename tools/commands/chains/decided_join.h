// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DECIDED_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DECIDED_JOIN_H

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>

#include <cstddef>
#include <string>
#include <vector>

// Joins that several commands ask about; their decision is compiled once.

// Decides the join of two curves as GC::continuity() does.
GC::Join_continuity<Exact> decided_join(const Exact_curve& left, const Exact_curve& right, int max_order);

// The pieces of a curve, and the joins between them that are no corners.
struct Joins_of_pieces {
  std::size_t pieces = 0, joins = 0;
  int c_order = 2, g_order = 2;       // of all joins, 2 at most
  std::size_t not_c2 = 0, not_g2 = 0; // joins
};

// Decides the joins of the pieces of curves that are written, .g2, exactly on numbers that a
// `Number` holds as they stand there. At the starts of the pieces with the numbers `corners`, in
// increasing order, are corners.
template <class Number>
Joins_of_pieces decide_joins(const std::string& text, GC::Closure closure, const std::vector<int>& corners = {});

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_DECIDED_JOIN_H
