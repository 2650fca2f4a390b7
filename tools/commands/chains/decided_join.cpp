// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/decided_join.h"

#include "formats/g2_text/spans.h"

#include <CGAL/Geometric_continuity/joins/join_continuity.h>

#include <algorithm>
#include <sstream>
#include <utility>

GC::Join_continuity<Exact> decided_join(const Exact_curve& left, const Exact_curve& right, int max_order) {
  return GC::continuity(left, right, max_order);
}

template <class Number>
Joins_of_pieces decide_joins(const std::string& text, GC::Closure closure, const std::vector<int>& corners) {
  typedef Program_span<Number> Span;
  std::istringstream is(text);
  GC::G2_span_reader<Program_traits<Exact>, Number> reader(is, "what is written", 3);
  Joins_of_pieces result;
  const auto decide = [&](const Span& left, const Span& right, std::size_t number) {
    if (std::binary_search(corners.begin(), corners.end(), static_cast<int>(number))) return;
    const GC::Join_continuity<Exact> join = continuity_orders(left, right, 2);
    ++result.joins;
    result.c_order = (std::min)(result.c_order, join.c_order);
    result.g_order = (std::min)(result.g_order, join.g_order);
    result.not_c2 += join.c_order < 2;
    result.not_g2 += join.g_order < 2;
  };
  Span first, last;
  for (Span next; reader.next(next); ++result.pieces) {
    if (result.pieces == 0)
      first = next;
    else
      decide(last, next, result.pieces);
    std::swap(last, next);
  }
  if (closure == GC::Closure::closed) decide(last, first, 0);
  return result;
}

template Joins_of_pieces decide_joins<GC::Decimal>(const std::string&, GC::Closure, const std::vector<int>&);
template Joins_of_pieces decide_joins<double>(const std::string&, GC::Closure, const std::vector<int>&);
