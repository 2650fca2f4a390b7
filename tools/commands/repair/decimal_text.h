// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_DECIMAL_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_DECIMAL_TEXT_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

// Returns a number as a finite decimal with as few digits as it has; nothing where it is none of at
// most so many digits behind the point.
inline std::optional<std::string> decimal_text(const CGAL::Exact_rational& x, int most_digits = 60) {
  typedef CGAL::Fraction_traits<CGAL::Exact_rational> Parts;
  CGAL::Exact_rational scaled = x < 0 ? CGAL::Exact_rational(-x) : x;
  Parts::Numerator_type p;
  Parts::Denominator_type q;
  for (int digits = 0; digits <= most_digits; ++digits, scaled *= 10) {
    Parts::Decompose()(scaled, p, q);
    if (q != 1) continue;
    std::ostringstream integer;
    integer << p;
    std::string text = integer.str();
    if (digits > 0) {
      const std::size_t n = static_cast<std::size_t>(digits);
      if (text.size() <= n) text.insert(0, n + 1 - text.size(), '0');
      text.insert(text.size() - n, ".");
    }
    return (x < 0 ? "-" : "") + text;
  }
  return std::nullopt;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_DECIMAL_TEXT_H
