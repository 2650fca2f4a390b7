// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Case.h"
#include "Report.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

// The result of the comparison of one case.
struct Verdict {
  std::vector<std::string> mismatches; // "path: expected ..., computed ..."
  int compared = 0;                    // leaves
  int undecided = 0;                   // leaves of a rounded kernel that its rounding leaves open
};

inline bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("+-/0123456789") == std::string::npos;
}

inline std::string to_text(const Leaf& leaf) {
  if (!leaf.number) return leaf.text;
  std::ostringstream s;
  s << *leaf.number;
  return s.str();
}

// Equality, without tolerance.
inline bool equal(const std::string& expected, const Leaf& leaf) {
  if (leaf.number && is_number(expected))
    return *leaf.number == CGAL::Geometric_continuity::parse_number<CGAL::Exact_rational>(expected);
  return !leaf.number && leaf.text == expected;
}

inline void compare_leaf(const std::string& path, const std::string& expected, const Leaf* leaf, Verdict& verdict) {
  ++verdict.compared;
  if (!leaf)
    verdict.mismatches.push_back(path + ": expected " + expected + ", not computed");
  else if (!equal(expected, *leaf))
    verdict.mismatches.push_back(path + ": expected " + expected + ", computed " + to_text(*leaf));
}

inline const Leaf* find(const Report& report, const std::string& path) {
  const auto found = report.leaves().find(path);
  return found == report.leaves().end() ? nullptr : &found->second;
}

// Exact kernels: every expected leaf is computed and equal.
inline Verdict compare_exact(const Case& c, const Report& report) {
  Verdict verdict;
  for (const auto& [path, expected] : c.out) compare_leaf(path, expected, find(report, path), verdict);
  return verdict;
}

inline bool representable(const Case& c) {
  for (const auto& [path, value] : c.in)
    if (is_number(value)) {
      const CGAL::Exact_rational x = CGAL::Geometric_continuity::parse_number<CGAL::Exact_rational>(value);
      if (CGAL::Exact_rational(CGAL::to_double(x)) != x) return false;
    }
  return true;
}

// Rounded kernels. The same operation in interval arithmetic encloses both the exact result and the
// double result, which makes the same operations on numbers inside the intervals: its width is the
// bound, proved for this input. Decisions are compared where the intervals decide them, and always
// where exact predicates decide on input that doubles represent.
inline Verdict compare_rounded(const Case& c, const Report& report, const Report& enclosures, bool exact_predicates) {
  // relative to max(1, |x|): far from what 53 bits may lose here
  const double maximal_width = std::ldexp(1.0, -20);
  const bool input_exact = representable(c);
  Verdict verdict;
  for (const auto& [path, expected] : c.out) {
    const Leaf *leaf = find(report, path), *enclosure = find(enclosures, path);
    const bool decided_exactly = exact_predicates && input_exact && leaf && leaf->source == Source::predicate;
    if (decided_exactly)
      compare_leaf(path, expected, leaf, verdict);
    else if (!enclosure)
      ++verdict.undecided;
    else if (!enclosure->enclosure) {
      compare_leaf(path, expected, enclosure, verdict);
      compare_leaf(path, expected, leaf, verdict);
    } else if (!leaf || !leaf->number || !is_number(expected))
      compare_leaf(path, expected, leaf, verdict);
    else {
      ++verdict.compared;
      const CGAL::Interval_nt<>& i = *enclosure->enclosure;
      const CGAL::Exact_rational e = CGAL::Geometric_continuity::parse_number<CGAL::Exact_rational>(expected);
      const double scale = std::max(1.0, std::abs(CGAL::to_double(e)));
      const double width = i.sup() - i.inf();
      const bool inside = CGAL::Exact_rational(i.inf()) <= *leaf->number &&
                          *leaf->number <= CGAL::Exact_rational(i.sup()) && CGAL::Exact_rational(i.inf()) <= e &&
                          e <= CGAL::Exact_rational(i.sup());
      if (!(width <= maximal_width * scale)) {
        --verdict.compared;
        ++verdict.undecided;
      } else if (!inside)
        verdict.mismatches.push_back(path + ": expected " + expected + ", computed " +
                                     std::to_string(CGAL::to_double(*leaf->number)) + ", further apart than proved");
    }
  }
  return verdict;
}
