// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_JOIN_REPORT_H
#define GEOMETRIC_CONTINUITY_DEMO_JOIN_REPORT_H

#include "curves.h"

#include <CGAL/Geometric_continuity/joins/chain_continuity.h>

#include <string>

typedef GC::Join_continuity<Exact> Join;

// An order of continuity that is asked for, e.g. "G2".
class Requirement {
  GC::Continuity_kind kind_;
  int order_;

public:
  // Throws when the text is not C, G or F and a number, or can't be met in this dimension.
  explicit Requirement(const std::string& text);
  GC::Continuity_kind kind() const { return kind_; }
  int order() const { return order_; }
  bool met(const Join& join) const { return GC::order_of(join, kind_) >= order_; }
  void check_dimension(int dimension) const; // F3 can't be met in the plane
  std::string text() const;
};

// "C1 G2 F2"
std::string orders(const Join& join);

// What a reader wants to know of the join beyond its orders, in words and rounded numbers.
std::string remark(const Join& join, const Exact_curve& left, const Exact_curve& right);

// The same from the jets of order 3 at the join.
std::string remark(const Join& join, const GC::Curve_jet<Program_traits<Exact>>& left,
                   const GC::Curve_jet<Program_traits<Exact>>& right);

// One line of a table: the numbers of the curves, the point, the orders, the remark.
std::string table_row(const Join& join, int left, int right, const Exact_curve& left_curve,
                      const Exact_curve& right_curve);
std::string table_head();

#endif // GEOMETRIC_CONTINUITY_DEMO_JOIN_REPORT_H
