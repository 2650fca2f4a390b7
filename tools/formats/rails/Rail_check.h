// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_RAILS_RAIL_CHECK_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_RAILS_RAIL_CHECK_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/models/Road_network.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// pi with an error below 10^-64.
inline const CGAL::Exact_rational& long_pi() {
  static const CGAL::Exact_rational pi =
      GC::parse_number<CGAL::Exact_rational>("3.141592653589793238462643383279502884197169399375105820974944592308");
  return pi;
}

// The sum of five floating-point numbers, which differs from x by less than 2^-260 parts.
inline CGAL::Exact_rational shortened(const CGAL::Exact_rational& x) {
  CGAL::Exact_rational sum(0);
  for (int i = 0; i < 5; ++i) {
    const double rest = CGAL::to_double(CGAL::Exact_rational(x - sum));
    if (!std::isfinite(rest)) return x;
    sum = CGAL::Exact_rational(sum + CGAL::Exact_rational(rest));
  }
  return sum;
}

// The root of x with an error below 2^-250 parts, by Newton's iteration. \pre 1 <= x < 10^300
inline CGAL::Exact_rational long_root(const CGAL::Exact_rational& x) {
  CGAL::Exact_rational root(std::sqrt(CGAL::to_double(x)));
  for (int i = 0; i < 4; ++i) root = shortened(CGAL::Exact_rational((root + x / root) / 2));
  return root;
}

// Two statements of a file about one thing: the end of a piece and the start of the next, or a
// number and others from which it follows.
struct Rail_check {
  std::string kind;  // "horizontal", "vertical", "cant", ...
  std::string curve; // of which they are a part, e.g. "IfcGradientCurve #23"
  std::string place; // on it, e.g. "#34 - #43"
  long long line = 0;
  std::string claim = {}; // what the file says, in its own word; empty where it says nothing
  // the order that is claimed: -1 nothing, 0 one position, 1 one direction, 2 one curvature
  int claimed = -1;

  struct Ends {
    GC::Alignment_end left, right;
  };
  std::optional<Ends> ends = {};
  std::optional<CGAL::Exact_rational> length = {}; // of the piece before, on which a tolerance of angles may depend

  // In the place of ends, a difference of two numbers of some quantity, such as "length".
  struct Difference {
    std::string quantity;
    CGAL::Exact_rational value;
    bool is_angle = false;
    std::optional<GC::Enclosure> enclosed = {}; // in the place of the value, where that is no rational number
  };
  std::optional<Difference> difference = {};

  // Angles are rounded by less than 10^-60 parts, because pi is needed for their unit: bounds are
  // widened by what floating-point numbers show.
  bool rounded = false;
  bool rounded_curvature = false; // the same of curvatures that have pi in them
  bool rounded_points = false;    // and of points whose coordinates are rational numbers close to them

  std::string not_covered = {}; // why nothing is decided; empty where there are ends or a difference
};

// A piece in the plan, for a bound on its curvature.
struct Rail_piece {
  std::string kind, curve, place; // as in Rail_check
  long long line = 0;
  std::string shape;
  // Whose curvatures are those of the piece: a line, an arc, a polynomial, or a spiral where the
  // curvature only rises or falls.
  std::optional<GC::Road_geometry> geometry = {};
  bool rounded = false; // its curvatures are rational numbers close to the true ones
  std::string not_covered = {};
};

// The alignments of a file.
struct Rail_file {
  std::size_t curves = 0; // that have joins
  std::vector<Rail_check> checks;
  std::vector<Rail_piece> pieces;
  std::vector<std::string> notes;                     // in words
  std::optional<CGAL::Exact_rational> precision = {}; // that the file gives: a tolerance of positions
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_RAILS_RAIL_CHECK_H
