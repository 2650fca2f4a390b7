// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_FILE_DIGITS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_FILE_DIGITS_H

#include <CGAL/Fraction_traits.h>
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

  static bool is_integer(const Number& x) {
    typedef CGAL::Fraction_traits<Number> Fraction;
    typename Fraction::Numerator_type numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(x, numerator, denominator);
    return denominator == 1 || denominator == -1;
  }

  static Number power_of_ten(int n) {
    Number result(1);
    for (int i = std::abs(n); i > 0; --i) result = Number(result * 10);
    return n < 0 ? Number(1 / result) : result;
  }

public:
  // The digits that count are those of the number of a file which has the most of them: single
  // numbers are often short because they are round.
  explicit File_digits(int digits = 0) : digits_(digits) {}

  int digits() const { return digits_; }

  // Half a unit of the last digit; integers are exact.
  Number uncertainty(const Number& x) const {
    if (is_integer(x)) return Number(0);
    const double size = std::fabs(CGAL::to_double(x));
    if (!(1e-300 < size && size < 1e300)) return Number(0);
    return Number(power_of_ten(static_cast<int>(std::floor(std::log10(size))) + 1 - digits_) / 2);
  }

  // The digits leave so much open of a gap and of a kink.
  struct Bounds {
    Number gap, kink;
  };
  // Bounds for a join behind a line, an arc or a spiral.
  Bounds bounds(const GC::Road_geometry& a, const GC::Road_geometry& b) const {
    const auto d = [this](const Number& x) { return uncertainty(x); };
    const bool is_bent = a.shape != GC::Road_shape::line, is_arc = a.shape == GC::Road_shape::arc;
    const Number zero(0), &l = a.length, &k0 = is_bent ? a.parameters.front() : zero,
                          &k1 = is_bent ? a.parameters.back() : zero;
    const Number bend = is_arc ? Number(d(k0) / 2) : Number(d(k0) / 3 + d(k1) / 6);
    return {Number(d(a.x) + d(b.x) + d(a.y) + d(b.y) + l * d(a.heading) + l * l * bend +
                   d(l) * (1 + CGAL::abs(Number(k1 - k0)) * l / 6)),
            Number(d(a.heading) + d(b.heading) + l * (d(k0) + d(k1)) / 2 + d(l) * (CGAL::abs(k0) + CGAL::abs(k1)) / 2)};
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_FILE_DIGITS_H
