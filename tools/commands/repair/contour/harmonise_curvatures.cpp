// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/harmonise_curvatures.h"

#include "commands/repair/contour/Movable_contour.h"
#include "commands/repair/contour/mend_kinks.h"
#include "commands/repair/grid_vectors.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace {

typedef GC::Grid_vector Vector;

// Nothing where a handle lies at the node.
std::optional<GC::Enclosure> curvature_jump(const Grid_contour& contour, std::size_t join) {
  const Grid_curve &left = contour.curves[join], &right = contour.curves[contour.next(join)];
  return contour.is_beside_grid ? GC::deviation(exact_bezier(left), exact_bezier(right)).curvature_jump
                                : GC::deviation(grid_bezier(left.points), grid_bezier(right.points)).curvature_jump;
}

// The side of a node for harmonising. A handle of a cubic moves the curvature at the other end,
// too: it stays where that is G2.
GC::Handle_side side(const Movable_contour& contour, std::size_t curve, bool at_end) {
  const std::vector<Vector>& p = contour.points(curve);
  const std::size_t n = p.size() - 1;
  const std::optional<std::size_t> other = contour.other_join(curve, at_end);
  const bool keeps = n == 3 && other && contour.grade(*other) == GC::Visual_class::g2;
  return {at_end ? p[n] - p[n - 1] : p[1] - p[0], at_end ? p[n] - p[n - 2] : p[2] - p[0], static_cast<int>(n),
          contour.is_free(curve) && !keeps};
}

// The sum over all joins of the curves that moves change; of those with an arc there is none. As
// only what lessens it is accepted, the sum over all joins decreases.
double sum_of_jumps(const Movable_contour& contour, const Moves& moves) {
  double sum = 0;
  for (const std::size_t j : contour.joins_of(moves))
    if (contour.is_bezier_join(j) && contour.grade(j) == GC::Visual_class::g1)
      if (const std::optional<GC::Enclosure> x = curvature_jump(contour.now(), j)) sum += x->upper;
  return sum;
}

// Returns whether handles of these lengths have one curvature: p n^2 = q m^2 for m d and n d.
bool is_exact(const GC::Handle_side& a, const GC::Handle_side& b, const GC::Aligned_handles& handles) {
  const Vector d = GC::primitive(handles.left);
  const auto times_square = [&](int factor, std::int64_t turn, const Vector& handle) {
    const CGAL::Exact_rational n = exact_number(dot(handle, d) / squared_length(d));
    return CGAL::Exact_rational(factor * exact_number(turn) * n * n);
  };
  return times_square((a.degree - 1) * b.degree, cross(a.second, d), handles.right) ==
         times_square((b.degree - 1) * a.degree, cross(d, b.second), handles.left);
}

// The handle at the other end of a cubic may move along itself where nothing depends on the
// curvature there: at a free end, and at a corner. Returns its direction, from the node to it.
std::optional<Vector> free_direction(const Movable_contour& contour, std::size_t curve, bool at_end) {
  const std::vector<Vector>& p = contour.points(curve);
  if (p.size() != 4 || !contour.is_free(curve)) return std::nullopt;
  const std::optional<std::size_t> other = contour.other_join(curve, at_end);
  if (other && contour.grade(*other) != GC::Visual_class::corner) return std::nullopt;
  const Vector handle = at_end ? p[1] - p[0] : p[2] - p[3];
  if (handle == Vector{0, 0}) return std::nullopt;
  return GC::primitive(handle);
}

// Moves that make curvatures agree exactly where no lengths of the handles at the node do: also
// the handles at the other ends get other lengths. Those of which the longest is shortest, then
// their sum.
std::optional<Moves> with_far_handles(const Movable_contour& contour, std::size_t join, const GC::Handle_side& a,
                                      const GC::Handle_side& b, const CGAL::Exact_rational& bound) {
  constexpr int most_steps = 12;
  const std::size_t next = contour.next(join);
  const std::vector<Vector>&p = contour.points(join), &q = contour.points(next);
  const std::optional<Vector> e = free_direction(contour, join, true), f = free_direction(contour, next, false);
  const double most = (std::min)(CGAL::to_double(bound), 1e6);
  const auto steps = [&](const std::optional<Vector>& d) {
    return d ? (std::min)(most_steps, static_cast<int>(most / std::hypot(double(d->x), double(d->y)))) : 0;
  };
  const Vector zero{0, 0}, node = q.front(), left = p[p.size() - 3], right = q[2];
  const auto size = [](const Vector& v) { return std::hypot(double(v.x), double(v.y)); };
  std::optional<Moves> best;
  std::pair<double, double> least(most, 1e300);
  const bool turned = rank(a.handle) < rank(b.handle); // so that mirror images of equal moves are one
  const int outer = steps(turned ? f : e), inner = steps(turned ? e : f);
  for (int k = -outer; k <= outer; ++k)
    for (int l = -inner; l <= inner; ++l) {
      const int i = turned ? l : k, j = turned ? k : l;
      if (i == 0 && j == 0) continue;
      const Vector u = e ? i * *e : zero, v = f ? j * *f : zero;
      GC::Handle_side x = a, y = b;
      x.second = x.second - u;
      y.second = y.second + v;
      const std::optional<GC::Aligned_handles> handles =
          GC::harmonise_handles(x, y, static_cast<std::int64_t>(most * most));
      if (!handles || !is_exact(x, y, *handles)) continue;
      const std::array<double, 4> sizes{size(u), size(v), size(handles->left - a.handle),
                                        size(handles->right - b.handle)};
      const std::pair<double, double> cost(*std::max_element(sizes.begin(), sizes.end()),
                                           sizes[0] + sizes[1] + sizes[2] + sizes[3]);
      if (!(cost < least)) continue;
      least = cost;
      best = Moves{};
      if (u != zero) best->push_back({join, p.size() - 3, left + u});
      if (v != zero) best->push_back({next, 2, right + v});
      if (handles->left != a.handle) best->push_back({join, p.size() - 2, node - handles->left});
      if (handles->right != b.handle) best->push_back({next, 1, node + handles->right});
    }
  return best;
}

// Makes moves that lessen the sum of the jumps. Returns an objection to them.
std::string accept_if_better(Movable_contour& contour, std::size_t join, const Moves& moves,
                             const CGAL::Exact_rational& bound) {
  const double before = sum_of_jumps(contour, moves);
  Harm harm;
  const std::string reason = contour.objection(join, moves, bound, harm);
  if (!reason.empty()) return reason;
  const Moves back = contour.execute(moves);
  if (!(sum_of_jumps(contour, moves) < before)) contour.execute(back); // the jumps next to it would grow by more
  return "";
}

// Harmonises handles beside the grid: to short decimal multiples of themselves. Of the handles l
// and m with the curvatures p / l^2 and q / m^2 the sum of the lengths stays.
std::string harmonise_beside_grid(Movable_contour& contour, std::size_t join, const GC::Handle_side& a,
                                  const GC::Handle_side& b, const CGAL::Exact_rational& bound) {
  const std::size_t left = join, right = contour.next(join), n = contour.points(left).size() - 1;
  const Grid_curve &x = contour.curve(left), &y = contour.curve(right);
  const Grid_offset u = exact_vector(x, n - 1, n), v = exact_vector(y, 0, 1);
  const auto curvature = [](const Grid_offset& handle, const CGAL::Exact_rational& turn, int degree) {
    const double size = std::sqrt(CGAL::to_double(handle.squared_length()));
    return (degree - 1.) / degree * CGAL::to_double(turn) / (size * size * size);
  };
  const double p = curvature(u, cross_product(exact_vector(x, n - 2, n), u), a.degree),
               q = curvature(v, cross_product(v, exact_vector(y, 0, 2)), b.degree),
               l = std::sqrt(CGAL::to_double(u.squared_length())), m = std::sqrt(CGAL::to_double(v.squared_length()));
  if (!(p * q > 0)) return "the curvatures have different signs, or one of them is zero";
  const double ratio = std::sqrt(q / p), // of the factors of the right and the left handle
      factor = !a.movable   ? 1
               : !b.movable ? 1 / ratio
                            : (l + m) / (l + ratio * m);
  // by whole units where the direction has short steps
  const auto multiple = [](const Grid_offset& handle, double times) {
    constexpr std::int64_t short_step = 4;
    const Grid_offset wanted = CGAL::Exact_rational(times) * handle;
    const std::optional<Vector> d = primitive_direction(handle);
    return d && largest_coordinate(*d) <= short_step ? exact_vector(nearest(wanted, *d)) : along(wanted, handle);
  };
  Moves moves;
  if (a.movable) moves.push_back(contour.to_place(left, n - 1, n, -multiple(u, factor)));
  if (b.movable) moves.push_back(contour.to_place(right, 1, 0, multiple(v, a.movable ? factor * ratio : ratio)));
  return accept_if_better(contour, join, moves, bound);
}

// A tenth of the shorter one of these handles as they were given.
CGAL::Exact_rational max_change(const Repair_options& options, std::initializer_list<Vector> handles) {
  if (options.max_move) return *options.max_move;
  double shortest = 1e300;
  for (const Vector& difference : handles)
    shortest = (std::min)(shortest, std::hypot(double(difference.x), double(difference.y)));
  return CGAL::Exact_rational((std::max)(1., std::floor(shortest / 10)));
}

// Returns why the curvatures cannot be made to agree better.
std::string harmonise(Movable_contour& contour, std::size_t join) {
  const std::size_t left = join, right = contour.next(join);
  if (contour.points(left).size() < 3 || contour.points(right).size() < 3 || is_line(contour.curve(left)) ||
      is_line(contour.curve(right)))
    return "a line has no curvature";
  const GC::Handle_side a = side(contour, left, true), b = side(contour, right, false);
  const Vector zero{0, 0}, node = contour.points(right).front();
  if (a.handle == zero || b.handle == zero) return "a handle lies at the node";
  if (!a.movable && !b.movable) return "no handle can move without harm to a join that is G2";
  const CGAL::Exact_rational bound = max_change(contour.options(), {a.handle, b.handle});
  if (contour.now().is_beside_grid) return harmonise_beside_grid(contour, join, a, b, bound);
  std::optional<GC::Aligned_handles> handles;
  std::optional<Moves> exact; // with handles at the other ends, too
  try {
    const double squared = (std::min)(CGAL::to_double(bound * bound), 1e15);
    handles = GC::harmonise_handles(a, b, static_cast<std::int64_t>(squared));
    if (handles && !is_exact(a, b, *handles)) exact = with_far_handles(contour, join, a, b, bound);
  } catch (const GC::Error& error) {
    return error.what();
  }
  if (!handles) return "the curvatures have different signs, or one of them is zero";
  if (exact && accept_if_better(contour, join, *exact, bound).empty() && contour.grade(join) == GC::Visual_class::g2)
    return "";
  if (handles->left == a.handle && handles->right == b.handle) return "";
  Moves moves;
  if (a.movable) moves.push_back({left, contour.points(left).size() - 2, node - handles->left});
  if (b.movable) moves.push_back({right, 1, node + handles->right});
  return accept_if_better(contour, join, moves, bound);
}

// Makes the curvatures of smooth joins agree.
std::vector<Curvature_jump> harmonise_all(Grid_contour& given, const Repair_options& options) {
  constexpr int passes = 8; // each changes the curvatures next to a join
  Movable_contour contour(given, options);
  std::vector<Curvature_jump> jumps;
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j)
    if (contour.is_bezier_join(j) && contour.grade(j) == GC::Visual_class::g1)
      if (const std::optional<GC::Enclosure> before = curvature_jump(contour.now(), j))
        jumps.push_back({j, *before, *before, ""});
  for (int pass = 0; pass < passes; ++pass)
    for (Curvature_jump& x : jumps)
      if (contour.grade(x.join) == GC::Visual_class::g1) x.reason = harmonise(contour, x.join);
  for (Curvature_jump& x : jumps) {
    x.after =
        contour.grade(x.join) == GC::Visual_class::g2 ? GC::Enclosure{0, 0} : *curvature_jump(contour.now(), x.join);
    if (x.after.upper == 0) x.reason.clear();
  }
  return jumps;
}

} // namespace

std::vector<Curvature_jump> harmonise_curvatures(Grid_contour& contour, const Repair_options& options) {
  constexpr int most_rounds = 16;
  Grid_contour result = contour;
  std::vector<Curvature_jump> jumps = harmonise_all(result, options);
  Grid_contour again = result;
  for (int round = 0; round < most_rounds; ++round) {
    mend_kinks(again, options);
    harmonise_all(again, options);
    if (same_points(again, result)) {
      contour = result;
      return jumps;
    }
    if (options.max_move && !moves_within(contour, again, *options.max_move)) break;
    result = again;
    for (Curvature_jump& x : jumps) {
      x.after = grade(result, x.join, options.bound) == GC::Visual_class::g2 ? GC::Enclosure{0, 0}
                                                                             : *curvature_jump(result, x.join);
    }
  }
  for (Curvature_jump& x : jumps) {
    x.after = x.before;
    x.reason = "the lengths of the handles find no rest within the allowed moves";
  }
  return jumps;
}
