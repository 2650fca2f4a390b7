// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/kink_proposals.h"

#include "commands/repair/grid_vectors.h"

#include <algorithm>
#include <cstdint>

Proposal propose(Movable_contour& contour, std::size_t join) {
  const std::optional<GC::Grid_vector> in = contour.first_difference(join, true),
                                       out = contour.first_difference(contour.next(join), false);
  if (!in || !out) return {join, {}, "no point of the grid lies in the direction of the arc"};
  return contour.now().is_beside_grid ? propose_beside_grid(contour, join, *in, *out)
                                      : propose_on_grid(contour, join, *in, *out);
}

void choose(Movable_contour& contour, const std::vector<Moves>& choices, Proposal& proposal) {
  for (const Moves& moves : choices) {
    Harm harm;
    const std::string objection = contour.objection(proposal.join, moves, proposal.bound, harm);
    if (proposal.moves.empty() && proposal.reason.empty()) proposal.reason = objection;
    if (!objection.empty() || (!proposal.moves.empty() && !(harm < proposal.harm))) continue;
    proposal.moves = moves;
    proposal.harm = harm;
    proposal.reason.clear();
  }
  if (proposal.moves.empty() && proposal.reason.empty()) proposal.reason = "no handle can move";
}

CGAL::Exact_rational max_move(const Movable_contour& contour, std::size_t join, const Grid_offset& in,
                              const Grid_offset& out) {
  if (contour.options().max_move) return *contour.options().max_move;
  const Grid_curve &left = contour.curve(join), &right = contour.curve(contour.next(join));
  double off = 0;
  if (left.arc || right.arc) { // the distance of the tip of the handle from the tangent
    const CGAL::Exact_rational c = cross_product(in, out);
    off = GC::sqrt_enclosure(CGAL::Exact_rational(c * c / (left.arc ? in : out).squared_length())).lower;
  } else
    off = contour.kink_size(join)->handle_offset.lower;
  return CGAL::Exact_rational(2 * CGAL::Exact_rational(off) + 1);
}

std::optional<Moves> symmetric(const Movable_contour& contour, std::size_t join, const GC::Grid_vector& in,
                               const GC::Grid_vector& out) {
  for (const GC::Grid_vector& d :
       {GC::Grid_vector{1, 0}, GC::Grid_vector{0, 1}, GC::Grid_vector{1, 1}, GC::Grid_vector{1, -1}}) {
    if (cross(d, in) != -cross(d, out) || dot(d, in) != dot(d, out)) continue;
    const GC::Grid_vector direction = dot(d, in) < 0 ? -1 * d : d, handle = GC::align_handle(in, direction);
    return Moves{contour.to_left(join, handle), contour.to_right(join, handle)};
  }
  return std::nullopt;
}

std::optional<GC::Aligned_handles> aligned(const GC::Grid_vector& in, const GC::Grid_vector& out,
                                           const CGAL::Exact_rational& most) {
  typedef GC::Grid_vector Vector;
  const bool turned = rank(in) < rank(out);
  const Vector &first = turned ? out : in, &second = turned ? in : out;
  for (const bool swap : {false, true})
    for (const std::int64_t sx : {1, -1})
      for (const std::int64_t sy : {1, -1}) {
        const auto image = [&](const Vector& v) -> Vector {
          return swap ? Vector{sy * v.y, sx * v.x} : Vector{sx * v.x, sy * v.y};
        };
        const auto preimage = [&](const Vector& v) -> Vector {
          return swap ? Vector{sx * v.y, sy * v.x} : Vector{sx * v.x, sy * v.y};
        };
        const Vector u = image(first), v = image(second);
        const bool on_axis = u.y == 0 || u.x == u.y;
        if (u.y < 0 || u.x < u.y || (on_axis && cross(u, v) < 0) || (u.y == 0 && u.x <= 0)) continue;
        const double squared = (std::min)(CGAL::to_double(most * most), 1e18);
        const std::optional<GC::Aligned_handles> handles = GC::align_handles(u, v, static_cast<std::int64_t>(squared));
        if (!handles) return std::nullopt;
        const Vector x = preimage(handles->left), y = preimage(handles->right);
        return turned ? GC::Aligned_handles{y, x} : GC::Aligned_handles{x, y};
      }
  return std::nullopt;
}

Quadratic_handle quadratic_handle(const Movable_contour& contour, std::size_t join, std::size_t curve,
                                  const Grid_offset& direction) {
  const bool at_end = curve == join;
  const std::size_t node = at_end ? 2 : 0;
  const Grid_curve& c = contour.curve(curve);
  const std::optional<std::size_t> other_join = contour.other_join(curve, at_end);
  const bool has_other = other_join && other_join != join;
  std::optional<GC::Visual_class> there;
  if (has_other) there = contour.grade(*other_join);
  Quadratic_handle result;
  result.is_bound = has_other && (!there || *there >= GC::Visual_class::g1);
  // node + k direction = other + t e, where e is the tangent at the other node
  Grid_offset e = exact_vector(c, 2 - node, 1);
  if (!result.is_bound) { // but both kinks may be mended at once
    const std::size_t neighbour = at_end ? contour.previous(curve) : contour.next(curve);
    if (there != GC::Visual_class::kink || !contour.first_difference(neighbour, at_end)) return result;
    e = contour.exact_direction(neighbour, at_end);
  }
  const CGAL::Exact_rational denominator = cross_product(direction, e);
  if (denominator != 0)
    result.k = CGAL::Exact_rational(cross_product(exact_vector(c, node, 2 - node), e) / denominator);
  else if (result.is_bound)
    result.reason = "both nodes of a quadratic bind its handle to parallel lines";
  return result;
}
