// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_SHAPE_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_SHAPE_TEXT_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/number.h>

#include <istream>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// A B-spline curve or surface as a text in the format .g2 has it, which this program has written.
struct Shape_text {
  struct Direction {
    int points, degree;
    std::vector<std::string> knots;
  };
  int dimension;
  bool is_rational;
  std::vector<Direction> directions; // one of a curve, u and v of a surface
  // w x, w y, ... and w, or x, y, ...; of a surface u runs first
  std::vector<std::vector<std::string>> rows;

  bool is_surface() const { return directions.size() == 2; }

  // Reads the next shape. Returns false at the end.
  bool read(std::istream& is) {
    int kind, ignored;
    if (!(is >> kind >> ignored >> ignored >> ignored >> dimension >> is_rational)) return false;
    directions.assign(kind == 200 ? 2 : 1, {});
    std::size_t count = 1;
    for (Direction& d : directions) {
      is >> d.points >> d.degree;
      --d.degree;
      d.knots.resize(static_cast<std::size_t>(d.points + d.degree + 1));
      for (std::string& knot : d.knots) is >> knot;
      count *= static_cast<std::size_t>(d.points);
    }
    rows.assign(count, std::vector<std::string>(static_cast<std::size_t>(dimension + is_rational)));
    for (std::vector<std::string>& row : rows)
      for (std::string& x : row) is >> x;
    return true;
  }

  static double number(const std::string& text) { return GC::parse_number<double>(text); }

  // Returns a weight, 1 of a polynomial shape.
  double weight(std::size_t i) const { return is_rational ? number(rows[i].back()) : 1; }

  // Returns a coordinate of a control point, rounded once.
  double coordinate(std::size_t i, std::size_t axis) const {
    if (!is_rational) return number(rows[i][axis]);
    typedef CGAL::Exact_rational Exact;
    return CGAL::to_double(Exact(GC::parse_number<Exact>(rows[i][axis]) / GC::parse_number<Exact>(rows[i].back())));
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SHAPES_SHAPE_TEXT_H
