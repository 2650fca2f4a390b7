// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/kink_proposals.h"

#include "commands/repair/grid_vectors.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace {

typedef GC::Grid_vector Vector;

// Adds the places of the handle of a quadratic, or the reason why there are none.
void add_quadratic(const Movable_contour& contour, std::size_t join, std::size_t curve, const Vector& difference,
                   std::vector<Moves>& choices, std::string& reason) {
  const bool at_end = curve == join;
  const std::vector<Vector>& p = contour.points(curve);
  const Vector node = at_end ? p[2] : p[0], d = (at_end ? -1 : 1) * GC::primitive(difference); // from the node on
  const Quadratic_handle handle = quadratic_handle(contour, join, curve, exact_vector(d));
  if (!handle.is_bound) choices.push_back({{curve, 1, node + GC::align_handle(p[1] - node, d)}});
  if (!handle.reason.empty()) reason = handle.reason;
  if (!handle.k) return;
  const double k = std::round(CGAL::to_double(*handle.k));
  if (1 <= k && k < double(GC::max_handle_coordinate) && CGAL::Exact_rational(k) == *handle.k)
    choices.push_back({{curve, 1, node + static_cast<std::int64_t>(k) * d}});
  else if (handle.is_bound)
    reason = "both nodes bind the handle of a quadratic, and the only place for it is not on this grid";
}

} // namespace

Proposal propose_on_grid(Movable_contour& contour, std::size_t join, const Vector& in, const Vector& out) {
  const std::size_t left = join, right = contour.next(join);
  const Vector zero{0, 0};
  if (in == zero || out == zero) return {join, {}, "all handles lie at the node"};
  // a long vector that does not move, such as a line, may have a short direction
  const Vector a = is_short(in) || contour.is_movable(left) ? in : GC::primitive(in),
               b = is_short(out) || contour.is_movable(right) ? out : GC::primitive(out);
  if (!is_short(a) || !is_short(b)) return {join, {}, "a handle is longer than 2^28 units of the grid"};
  if (dot(a, b) < (std::abs)(cross(a, b))) return {join, {}, "the angle is more than 45 degrees"};
  Proposal proposal{join, {}, "", max_move(contour, join, exact_vector(a), exact_vector(b))};
  std::vector<Moves> choices;
  const bool are_alike = contour.is_movable(left) && contour.is_movable(right) &&
                         contour.points(left).size() == contour.points(right).size();
  if (const std::optional<Moves> moves = are_alike ? symmetric(contour, join, a, b) : std::nullopt) {
    choose(contour, {*moves}, proposal);
    return proposal;
  }
  const bool right_first = rank(a) < rank(b);
  const bool both = contour.is_free(left) && contour.is_free(right);
  if (both)
    if (const std::optional<GC::Aligned_handles> handles = aligned(a, b, proposal.bound))
      choices.push_back({contour.to_left(join, handles->left), contour.to_right(join, handles->right)});
  if (contour.is_free(left)) choices.push_back({contour.to_left(join, GC::align_handle(a, b))});
  if (contour.is_free(right)) choices.push_back({contour.to_right(join, GC::align_handle(b, a))});
  if (both && right_first) std::swap(choices[choices.size() - 1], choices[choices.size() - 2]);
  std::string reason;
  for (const bool of_right : {right_first, !right_first}) {
    const std::size_t curve = of_right ? right : left;
    if (contour.is_free_quadratic(curve)) add_quadratic(contour, join, curve, of_right ? a : b, choices, reason);
  }
  if (choices.empty() && !reason.empty())
    proposal.reason = reason;
  else
    choose(contour, choices, proposal);
  return proposal;
}
