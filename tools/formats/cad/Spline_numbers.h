// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_SPLINE_NUMBERS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_SPLINE_NUMBERS_H

#include <array>
#include <cstddef>
#include <iomanip>
#include <istream>
#include <ostream>
#include <vector>

// A B-spline curve or surface in space over doubles, as it is handed to the process that writes CAD
// models: as a text, with 17 digits.
struct Spline_numbers {
  struct Direction {
    int points = 0, degree = 0;
    std::vector<double> knots;
  };
  std::vector<Direction> directions;         // one of a curve, u and v of a surface
  std::vector<std::array<double, 4>> points; // x, y, z and the weight; of a surface u runs first

  void write(std::ostream& os) const {
    os << std::setprecision(17) << directions.size() << '\n';
    for (const Direction& d : directions) {
      os << d.points << ' ' << d.degree;
      for (const double x : d.knots) os << ' ' << x;
      os << '\n';
    }
    for (const std::array<double, 4>& p : points) os << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3] << '\n';
  }

  // Reads the next one. Returns false at the end.
  bool read(std::istream& is) {
    std::size_t n;
    if (!(is >> n)) return false;
    directions.assign(n, {});
    std::size_t count = 1;
    for (Direction& d : directions) {
      is >> d.points >> d.degree;
      d.knots.resize(static_cast<std::size_t>(d.points + d.degree + 1));
      for (double& x : d.knots) is >> x;
      count *= static_cast<std::size_t>(d.points);
    }
    points.resize(count);
    for (std::array<double, 4>& p : points)
      for (double& x : p) is >> x;
    return true;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_SPLINE_NUMBERS_H
