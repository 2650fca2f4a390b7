// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/kink_proposals.h"

#include "commands/repair/decimal_text.h"
#include "commands/repair/grid_vectors.h"

#include <cstdlib>
#include <utility>

namespace {

typedef GC::Grid_vector Vector;

// Moves of handles to whole units from their nodes, and those to places with more digits, which are
// for where none of the first are near enough.
struct Choices {
  std::vector<Moves> whole, longer;
};

// Adds moves of both handles to whole units from the node.
void add_both(const Movable_contour& contour, std::size_t join, const Vector& in, const Vector& out,
              const CGAL::Exact_rational& bound, std::vector<Moves>& choices) {
  if (contour.points(join).size() == contour.points(contour.next(join)).size())
    if (std::optional<Moves> moves = symmetric(contour, join, in, out)) return choices.push_back(*std::move(moves));
  if (dot(in, out) < (std::abs)(cross(in, out))) return;
  if (const std::optional<GC::Aligned_handles> handles = aligned(in, out, bound))
    choices.push_back({contour.to_left(join, handles->left), contour.to_right(join, handles->right)});
  choices.push_back({contour.to_left(join, GC::align_handle(in, out)), contour.to_right(join, out)});
  choices.push_back({contour.to_left(join, in), contour.to_right(join, GC::align_handle(out, in))});
  if (rank(in) < rank(out)) std::swap(choices[choices.size() - 1], choices[choices.size() - 2]);
}

// Adds moves of one handle into the direction of the other one, which is u on the left and v on the
// right.
void add_single(const Movable_contour& contour, std::size_t join, const Grid_offset& u, const Grid_offset& v,
                Choices& choices) {
  const std::size_t left = join, right = contour.next(join);
  if (contour.is_free(left)) {
    if (const std::optional<Vector> d = primitive_direction(v))
      choices.whole.push_back({contour.to_left(join, nearest(u, *d))});
    const std::size_t last = contour.points(left).size() - 1;
    choices.longer.push_back({contour.to_place(left, contour.tip(left, true), last, -along(u, v))});
  }
  if (contour.is_free(right)) {
    if (const std::optional<Vector> d = primitive_direction(u))
      choices.whole.push_back({contour.to_right(join, nearest(v, *d))});
    choices.longer.push_back({contour.to_place(right, contour.tip(right, false), 0, along(v, u))});
  }
}

// Adds the places of the handle of a quadratic, or the reason why there are none.
void add_quadratic(const Movable_contour& contour, std::size_t join, std::size_t curve, const Grid_offset& direction,
                   Choices& choices, std::string& reason) {
  const bool at_end = curve == join;
  const std::size_t node = at_end ? 2 : 0;
  const Grid_curve& c = contour.curve(curve);
  const Grid_offset given = exact_vector(c, node, 1), d = at_end ? -direction : direction; // from the node on
  const Quadratic_handle handle = quadratic_handle(contour, join, curve, d);
  if (!handle.is_bound) {
    if (const std::optional<Vector> whole = primitive_direction(d))
      choices.whole.push_back({{curve, 1, c.points[node] + nearest(given, *whole), offset(c, node)}});
    choices.longer.push_back({contour.to_place(curve, 1, node, along(given, d))});
  }
  if (!handle.reason.empty()) reason = handle.reason;
  if (!handle.k) return;
  const Grid_offset place = *handle.k * d;
  const Grid_fraction unit = power_of_ten(-contour.now().decimals);
  const Drawing_traits::Point p = exact_point(c, node) + place;
  const bool can_be_written = contour.now().takes_fractions || (decimal_text(Grid_fraction(p.x() * unit)).has_value() &&
                                                                decimal_text(Grid_fraction(p.y() * unit)).has_value());
  if (*handle.k > 0 && can_be_written)
    choices.longer.push_back({contour.to_place(curve, 1, node, place)});
  else if (handle.is_bound)
    reason = "both nodes bind the handle of a quadratic, and the only place for it is no decimal";
}

} // namespace

Proposal propose_beside_grid(Movable_contour& contour, std::size_t join, const Vector& in, const Vector& out) {
  const std::size_t left = join, right = contour.next(join);
  const Grid_offset u = contour.exact_direction(left, true), v = contour.exact_direction(right, false);
  if (u == CGAL::NULL_VECTOR || v == CGAL::NULL_VECTOR) return {join, {}, "all handles lie at the node"};
  const CGAL::Exact_rational sine = cross_product(u, v);
  if (u * v < (sine < 0 ? CGAL::Exact_rational(-sine) : sine)) return {join, {}, "the angle is more than 45 degrees"};
  Proposal proposal{join, {}, "", max_move(contour, join, u, v)};
  const Vector zero{0, 0};
  const bool are_short = is_short(in) && is_short(out) && in != zero && out != zero;
  const bool right_first = rank(in) < rank(out);
  const bool both = contour.is_free(left) && contour.is_free(right);
  Choices choices;
  if (both && are_short) add_both(contour, join, in, out, proposal.bound, choices.whole);
  add_single(contour, join, u, v, choices);
  if (both && right_first) std::swap(choices.longer[0], choices.longer[1]);
  std::string reason;
  for (const bool of_right : {right_first, !right_first}) {
    const std::size_t curve = of_right ? right : left;
    if (contour.is_free_quadratic(curve)) add_quadratic(contour, join, curve, of_right ? u : v, choices, reason);
  }
  if (!contour.now().may_add_decimals) {
    if (choices.whole.empty() && reason.empty() && !choices.longer.empty())
      reason = "no unit of this grid lies in the direction";
    choices.longer.clear();
  }
  if (choices.whole.empty() && choices.longer.empty() && !reason.empty()) {
    proposal.reason = reason;
    return proposal;
  }
  choose(contour, choices.whole, proposal);
  if (proposal.moves.empty() && !choices.longer.empty()) {
    const std::string first_reason = std::exchange(proposal.reason, "");
    choose(contour, choices.longer, proposal);
    if (proposal.moves.empty() && !choices.whole.empty()) proposal.reason = first_reason;
  }
  return proposal;
}
