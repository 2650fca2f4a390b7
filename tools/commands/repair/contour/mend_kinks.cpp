// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/mend_kinks.h"

#include "commands/repair/contour/kink_proposals.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

// Returns whether a proposal waits for that of a join next to it, with which it shares the handle
// of a quadratic: what harms less comes first, and of what is equal nothing unless both agree on
// the handle.
bool waits(const Movable_contour& contour, const Proposal& x, const Proposal& y) {
  const std::size_t shared = contour.next(x.join) == y.join ? y.join : x.join;
  if (x.join == y.join || contour.points(shared).size() != 3 || y.moves.empty() || x.harm < y.harm) return false;
  if (y.harm < x.harm) return true;
  const auto place_of_handle = [&](const Proposal& p) -> std::optional<std::pair<GC::Grid_vector, Grid_offset>> {
    for (const Move& m : p.moves)
      if (m.curve == shared) return std::pair(m.to, m.offset);
    return std::nullopt;
  };
  return place_of_handle(x) != place_of_handle(y);
}

// Mends what the proposals say, unless they contradict each other. Returns whether a kink was
// mended.
bool mend(Movable_contour& contour, const std::vector<Proposal>& proposals) {
  const auto at = [&](std::size_t join) {
    const auto found = std::lower_bound(proposals.begin(), proposals.end(), join,
                                        [](const Proposal& p, std::size_t j) { return p.join < j; });
    return found != proposals.end() && found->join == join ? &*found : nullptr;
  };
  bool any = false;
  for (const Proposal& p : proposals) {
    const Proposal *const before = at(contour.previous(p.join)), *const after = at(contour.next(p.join));
    if (p.moves.empty() || (before && waits(contour, p, *before)) || (after && waits(contour, p, *after))) continue;
    Harm harm;
    if (contour.grade(p.join) != GC::Visual_class::kink || !contour.objection(p.join, p.moves, p.bound, harm).empty())
      continue;
    contour.execute(p.moves);
    any = true;
  }
  return any;
}

// Returns the kinks that are left, and why.
std::vector<Unrepaired_join> repair_kinks(Movable_contour& contour) {
  std::vector<Proposal> proposals;
  do {
    proposals.clear();
    for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
      if (contour.grade(j) == GC::Visual_class::kink) proposals.push_back(propose(contour, j));
  } while (mend(contour, proposals)); // one repair may make room for another
  std::vector<Unrepaired_join> left;
  for (const Proposal& p : proposals)
    left.push_back({p.join, p.reason.empty() ? "the handle would have to move to two places" : p.reason});
  return left;
}

void add_gaps(const Movable_contour& contour, std::vector<Unrepaired_join>& unrepaired) {
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
    if (contour.grade(j) == GC::Visual_class::gap) {
      const Grid_curve& right = contour.curve(contour.next(j));
      unrepaired.push_back(
          {j,
           "a gap, as the next curve starts at " + contour.now().text(right.points.front(), offset(right, 0)) +
               (contour.options().close ? ", which is farther away than --close" : ": nodes move with --close only")});
    }
}

// Counts the joins without a grade for each reason.
std::map<std::string, std::size_t> count_undecided(const Movable_contour& contour) {
  std::map<std::string, std::size_t> counts;
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
    if (!contour.grade(j)) {
      const Grid_curve &left = contour.curve(j), &right = contour.curve(contour.next(j));
      const std::string& reason = left.reason.empty() ? right.reason : left.reason;
      ++counts[reason.empty() ? "a curve has no length" : reason];
    }
  return counts;
}

} // namespace

Contour_repair mend_kinks(Grid_contour& given, const Repair_options& options) {
  Movable_contour contour(given, options);
  Contour_repair result;
  result.unrepaired = repair_kinks(contour);
  add_gaps(contour, result.unrepaired);
  result.undecided = count_undecided(contour);
  return result;
}
