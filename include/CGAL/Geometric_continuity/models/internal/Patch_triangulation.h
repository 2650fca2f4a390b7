// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PATCH_TRIANGULATION_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PATCH_TRIANGULATION_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/models/internal/Point_sums.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Patch_triangulation.h
/// The triangles of one patch of a model, between the points on its edges.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Compares the diagonals of the cells between two rows of points. The answers are those of the
// number type. For rational numbers they are found by intervals of floating-point numbers wherever
// these suffice.
template <class Traits> class Cell_diagonals {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Interval_nt<false> Interval;
  static constexpr bool filtered = Rational_parts<FT>::value;

  const std::vector<Point>& points_;
  struct Row {
    std::vector<std::size_t> numbers; // of points
    std::vector<std::array<Interval, 3>> boxes;
  };
  Row low_, high_;

public:
  explicit Cell_diagonals(const std::vector<Point>& points) : points_(points) {}

  // The upper row becomes the lower one; `point(j)` is the number of the point number j < n of the
  // next row.
  template <class Function> void next_row(std::size_t n, const Function& point) {
    std::swap(low_, high_);
    high_.numbers.clear();
    high_.boxes.clear();
    for (std::size_t j = 0; j < n; ++j) {
      high_.numbers.push_back(point(j));
      if constexpr (filtered) {
        const Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(points_[high_.numbers[j]]);
        high_.boxes.push_back(
            {Interval(CGAL::to_interval(x[0])), Interval(CGAL::to_interval(x[1])), Interval(CGAL::to_interval(x[2]))});
      }
    }
  }

  // Compares the diagonals of the cell between the points number j and j + 1: the one from number j
  // of the lower row is shorter than the other, equal, or longer.
  Comparison_result operator()(std::size_t j) const {
    if constexpr (filtered) {
      const Protect_FPU_rounding<true> protection;
      const Interval difference = square(low_.boxes[j], high_.boxes[j + 1]) - square(low_.boxes[j + 1], high_.boxes[j]);
      if (difference.sup() < 0) return SMALLER;
      if (difference.inf() > 0) return LARGER;
    }
    return CGAL::compare(square(low_.numbers[j], high_.numbers[j + 1]), square(low_.numbers[j + 1], high_.numbers[j]));
  }

private:
  // The squares of distances.
  static Interval square(const std::array<Interval, 3>& p, const std::array<Interval, 3>& q) {
    return CGAL::square(p[0] - q[0]) + CGAL::square(p[1] - q[1]) + CGAL::square(p[2] - q[2]);
  }
  FT square(std::size_t i, std::size_t j) const {
    const Coordinates<Traits> d =
        Geometric_continuity::coordinates<Traits>(points_[i]) - Geometric_continuity::coordinates<Traits>(points_[j]);
    return dot(d, d);
  }
};

// i/n between a and b
template <class FT> FT fraction_of(const std::pair<FT, FT>& interval, std::size_t i, std::size_t n) {
  if (i == 0) return interval.first;
  if (i == n) return interval.second;
  return FT(interval.first +
            FT(interval.second - interval.first) * FT(FT(static_cast<int>(i)) / FT(static_cast<int>(n))));
}

// The ends of n equal parts of an interval.
template <class FT> std::vector<FT> ends_of_parts(const std::pair<FT, FT>& interval, std::size_t n) {
  std::vector<FT> ends;
  ends.reserve(n + 1);
  for (std::size_t i = 0; i <= n; ++i) ends.push_back(fraction_of(interval, i, n));
  return ends;
}

// Cuts the patch into cells, and each cell into triangles. Points on the edges are there before;
// their number on an edge is a multiple of the number of cells, so that every triangle lies in a
// cell of its patch. They are added to `Mesh`, a Tessellation.
template <class Patch, class Mesh> class Patch_triangulation {
  typedef typename Patch::Traits Traits;
  typedef typename Traits::FT FT;

public:
  // The points along the edges u0, u1, v0, v1 in the direction of the parameter, with both ends; of
  // a collapsed edge the only point.
  typedef std::array<std::vector<std::size_t>, 4> Edges;

private:
  const Patch& patch_;
  std::size_t number_; // of the patch
  const Edges& edges_;
  std::size_t nu_, nv_;
  Mesh& mesh_;
  std::size_t first_inner_;
  Cell_diagonals<Traits> diagonals_;

public:
  Patch_triangulation(const Patch& patch, std::size_t number, const Patch_cells& cells, const Edges& edges, Mesh& mesh)
      : patch_(patch), number_(number), edges_(edges), nu_(cells.u), nv_(cells.v), mesh_(mesh),
        first_inner_(mesh.points.size()), diagonals_(mesh.points) {
    add_inner_points();
    for (std::size_t i = 0; i <= nu_; ++i) {
      diagonals_.next_row(nv_ + 1, [&](std::size_t j) { return grid_point(i, j); });
      for (std::size_t j = 0; i > 0 && j < nv_; ++j) triangulate(i - 1, j);
    }
  }

private:
  // The points of the grid inside the patch, row by row: first the control points of the curve with
  // the constant v.
  void add_inner_points() {
    const int p = patch_.degree_u(), q = patch_.degree_v();
    std::vector<decltype(summand(patch_, 0, 0))> net;
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) net.push_back(summand(patch_, i, j));
    typedef Point_sums<Patch> Sums;
    Sums sums(patch_, net);
    const std::vector<std::vector<typename Sums::Number>> u = sums.weights(p, nu_), v = sums.weights(q, nv_);
    const std::vector<FT> s = ends_of_parts(patch_.domain_u(), nu_), t = ends_of_parts(patch_.domain_v(), nv_);
    std::vector<typename Sums::Vector> row(p + 1, sums.net()[0]);
    for (std::size_t j = 1; j < nv_; ++j) {
      // equivalent [1 -> 2, 1]: an estimate of work
      sums.charge((p + 1.) * (q + 1));
      for (int k = 0; k <= p; ++k) row[k] = weighted_sum(v[j], sums.net(), static_cast<std::size_t>(k) * (q + 1));
      for (std::size_t i = 1; i < nu_; ++i) {
        // equivalent [+ -> -, 1]: an estimate of work
        sums.charge(p + 1.);
        add_point(sums.point(weighted_sum(u[i], row)), s[i], t[j]);
      }
    }
  }

  std::size_t add_point(typename Traits::Point point, const FT& u, const FT& v) {
    mesh_.points.push_back(std::move(point));
    mesh_.places.push_back({number_, u, v});
    return mesh_.points.size() - 1;
  }

  void add_triangle(std::size_t a, std::size_t b, std::size_t c) {
    if (a == b || b == c || c == a) return; // at a collapsed edge
    mesh_.triangles.push_back({a, b, c});
    mesh_.patches.push_back(number_);
  }

  // The points of a side of a cell: from the k-th of n parts of an edge, its end excluded.
  void append_part(std::vector<std::size_t>& polygon, const std::vector<std::size_t>& edge, std::size_t k,
                   std::size_t n, bool backwards) const {
    const std::size_t m = (edge.size() - 1) / n;
    for (std::size_t l = 0; l < (std::max)(m, std::size_t(1)); ++l)
      polygon.push_back(edge[backwards ? (k + 1) * m - l : k * m + l]);
  }

  std::size_t inner(std::size_t i, std::size_t j) const { return first_inner_ + (j - 1) * (nu_ - 1) + i - 1; }

  std::size_t grid_point(std::size_t i, std::size_t j) const {
    const auto on = [](const std::vector<std::size_t>& edge, std::size_t k, std::size_t n) {
      return edge[k * ((edge.size() - 1) / n)];
    };
    if (i == 0) return on(edges_[0], j, nv_);
    if (i == nu_) return on(edges_[1], j, nv_);
    if (j == 0) return on(edges_[2], i, nu_);
    if (j == nv_) return on(edges_[3], i, nu_);
    return inner(i, j);
  }

  // The cell number i in u and j in v, counterclockwise, side by side.
  void triangulate(std::size_t i, std::size_t j) {
    std::vector<std::size_t> polygon;
    std::array<std::size_t, 5> corner; // where the sides begin
    const std::array<bool, 4> outer = {j == 0, i + 1 == nu_, j + 1 == nv_, i == 0};
    for (int side = 0; side < 4; ++side) {
      corner[side] = polygon.size();
      const bool along_u = side % 2 == 0;
      constexpr int edge_of_side[] = {2, 1, 3, 0};
      if (outer[side])
        append_part(polygon, edges_[edge_of_side[side]], along_u ? i : j, along_u ? nu_ : nv_, side >= 2);
      else
        polygon.push_back(grid_point(i + (side == 1 || side == 2), j + (side >= 2)));
    }
    corner[4] = polygon.size();
    if (const std::optional<int> apex = fan_apex(corner, outer, j))
      fan(polygon, corner[*apex]);
    else {
      const FT s = centre(patch_.domain_u(), i, nu_), t = centre(patch_.domain_v(), j, nv_);
      const std::size_t middle = add_point(patch_(s, t), s, t);
      for (std::size_t k = 0; k < polygon.size(); ++k)
        add_triangle(middle, polygon[k], polygon[(k + 1) % polygon.size()]);
    }
  }

  static FT centre(const std::pair<FT, FT>& domain, std::size_t i, std::size_t n) {
    return fraction_of(domain, 2 * i + 1, 2 * n);
  }

  // The corner from which a fan of triangles covers the cell: no other point may lie on the two
  // sides at it, and it should not be on an edge of the patch. Corner number k is where side k
  // begins and side k - 1 ends.
  std::optional<int> fan_apex(const std::array<std::size_t, 5>& corner, const std::array<bool, 4>& outer,
                              std::size_t j) const {
    const auto whole = [&](int side) { return corner[side + 1] - corner[side] == 1; };
    // of the diagonals from the corners 0 and 2, and 1 and 3
    std::optional<Comparison_result> order;
    const auto has_shorter_diagonal = [&](int k, int than) {
      if ((k - than) % 2 == 0) return false;
      if (!order) order = diagonals_(j);
      return *order == (k % 2 == 0 ? SMALLER : LARGER);
    };
    std::optional<int> best;
    int best_sides = 3;
    for (int k = 0; k < 4; ++k) {
      const int before = (k + 3) % 4, outer_sides = outer[k] + outer[before];
      if (!whole(k) || !whole(before) || outer_sides > best_sides) continue;
      if (outer_sides == best_sides && !has_shorter_diagonal(k, *best)) continue;
      best = k;
      best_sides = outer_sides;
    }
    return best;
  }

  void fan(const std::vector<std::size_t>& polygon, std::size_t apex) {
    const std::size_t n = polygon.size();
    for (std::size_t k = 1; k + 1 < n; ++k)
      add_triangle(polygon[apex], polygon[(apex + k) % n], polygon[(apex + k + 1) % n]);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PATCH_TRIANGULATION_H
