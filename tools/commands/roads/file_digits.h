// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_FILE_DIGITS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_FILE_DIGITS_H

#include <CGAL/Geometric_continuity/models/Road_network.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace GC = CGAL::Geometric_continuity;

// A file with few digits and a wrong one look alike where pieces do not meet. With an uncertainty d
// of every number the end of a line, an arc or a spiral of the length L is off by at most
//   d(x) + d(y) + L d(h) + L^2 (d(k0) / 3 + d(k1) / 6) + d(L) (1 + |k1 - k0| L / 6),
// because |exp(ia) - exp(ib)| <= |a - b|, and its direction by at most
//   d(h) + L (d(k0) + d(k1)) / 2 + d(L) (|k0| + |k1|) / 2.
class File_digits {
  typedef GC::Road_number Number;

  int digits_;

public:
  // The digits that count are those of the number of a file which has the most of them: single
  // numbers are often short because they are round.
  explicit File_digits(int digits = 0) : digits_(digits) {}

  int digits() const { return digits_; }

  // Half a unit of the last digit; integers are exact.
  double uncertainty(const Number& x) const {
    const double y = CGAL::to_double(x), size = std::fabs(y);
    if (!(1e-300 < size && size < 1e300) || (y == std::floor(y) && Number(y) == x)) return 0;
    return std::pow(10., std::floor(std::log10(size)) + 1 - digits_) / 2;
  }

  // The digits leave so much open of a gap and of a kink, at least.
  struct Bounds {
    double gap, kink;
  };
  // Bounds for a join behind a line, an arc or a spiral.
  Bounds bounds(const GC::Road_geometry& a, const GC::Road_geometry& b) const {
    const auto d = [this](const Number& x) { return uncertainty(x); };
    const bool is_bent = a.shape != GC::Road_shape::line, is_arc = a.shape == GC::Road_shape::arc;
    const double l = CGAL::to_double(a.length), k0 = is_bent ? CGAL::to_double(a.parameters.front()) : 0,
                 k1 = is_bent ? CGAL::to_double(a.parameters.back()) : 0, d0 = is_bent ? d(a.parameters.front()) : 0,
                 d1 = is_bent ? d(a.parameters.back()) : 0, bend = is_arc ? d0 / 2 : d0 / 3 + d1 / 6;
    const double gap = d(a.x) + d(b.x) + d(a.y) + d(b.y) + l * d(a.heading) + l * l * bend +
                       d(a.length) * (1 + std::fabs(k1 - k0) * l / 6),
                 kink = d(a.heading) + d(b.heading) + l * (d0 + d1) / 2 +
                        d(a.length) * (std::fabs(k0) + std::fabs(k1)) / 2;
    constexpr double least = 1 - 1e-12; // of what is rounded here
    return {gap * least, kink * least};
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_FILE_DIGITS_H
