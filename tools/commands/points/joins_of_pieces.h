// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_JOINS_OF_PIECES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_JOINS_OF_PIECES_H

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>

#include <cstddef>
#include <string>
#include <vector>

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

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_JOINS_OF_PIECES_H
