// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_JOIN_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_JOIN_REPORT_H

#include "commands/commands.h"
#include "formats/g2_text/curves.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Sqrt_extension.h>

#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Geometric_continuity {
template <class Span> class Span_join;
}
} // namespace CGAL

typedef GC::Join_continuity<Exact> Join;

// Returns whether the angle of two tangents, in any dimension, exceeds the bound, decided exactly.
inline bool exceeds(const GC::Corner_threshold& bound, const GC::Coordinate_vector<Exact, 0>& a,
                    const GC::Coordinate_vector<Exact, 0>& b) {
  typedef CGAL::Sqrt_extension<Exact, Exact> Root; // |a x b|, which is a number in the plane only
  const Exact ab = dot(a, b), sine_squared = dot(a, a) * dot(b, b) - ab * ab;
  if (sine_squared == 0) return ab < 0; // which is no number with a root
  return bound.is_exceeded(Root(Exact(0), Exact(1), sine_squared), Root(ab));
}

// An order of continuity that is asked for, e.g. "G2".
class Requirement {
  GC::Continuity_kind kind_;
  int order_;

public:
  // Throws std::invalid_argument unless the text is C, G or F with a number from 0 to 32.
  explicit Requirement(const std::string& text);
  GC::Continuity_kind kind() const { return kind_; }
  int order() const { return order_; }
  bool met(const Join& join) const { return GC::order_of(join, kind_) >= order_; }

  // Throws std::invalid_argument for an F order that no join has in this dimension, such as F3 in
  // the plane.
  void check_dimension(int dimension) const;

  std::string text() const;
};

// The words for a chain without joins.
constexpr const char* no_join = "a single curve has no join; --closed asks for the join of its end and its start";

// Returns the orders of a join, e.g. "C1 G2 F2", or "gap".
std::string orders(const Join& join);

// Returns what a reader wants to know of a join beyond its orders, in words and rounded numbers,
// from the jets of order 3 on both sides.
std::string remark(const Join& join, const GC::Curve_jet<Program_traits<Exact>>& left,
                   const GC::Curve_jet<Program_traits<Exact>>& right);

// Returns the remark from enclosures of the jets in the plane, while rounding is upwards; it is
// empty where they do not determine the rounded numbers.
std::optional<std::string> remark(const Join& join, const GC::Coordinate_jet<CGAL::Interval_nt<false>, 2>& left,
                                  const GC::Coordinate_jet<CGAL::Interval_nt<false>, 2>& right);

// The point and the remark of a join, for a table and for findings.
struct Join_words {
  std::string point, remark;
};

// A larger angle than `bound` is a corner.
template <class Span>
Join_words join_words(const Join& join, const GC::Span_join<Span>& ends, const GC::Corner_threshold& bound);

// Tells which of two curves with a gap between them would close it if it were reversed.
struct Closing_reversal {
  bool left = false, right = false;
};
template <class Span> Closing_reversal closing_reversal(const GC::Span_join<Span>& ends);

// Returns the first line of a table of joins.
std::string table_head();

// Appends the line of a join: the numbers of both curves, the orders, the point, the remark.
void append_table_row(std::string& table, const Join& join, std::size_t left, std::size_t right,
                      const Join_words& words);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_JOIN_REPORT_H
