// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_POLYGON_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Coordinate by coordinate: negative, zero or positive.
template <class Coordinates> int compare_coordinates(const Coordinates& p, const Coordinates& q) {
  for (int i = 0; i < p.dimension(); ++i) {
    if (p[i] < q[i]) return -1;
    if (q[i] < p[i]) return 1;
  }
  return 0;
}

// The control points of an edge over its knots and its weights, in the direction that makes them smaller. Edges of one form, i.e. of
// one degree over the same knots, are the same if and only if their points are and their weights up to a factor; other edges are
// compared by Edge_key.
// \pre has_corner_points()
template <class Surface> class Edge_polygon {
  typedef typename Surface::Traits Traits;
  typedef Edge_field<Traits> Field;
  typedef typename Traits::FT FT;
  typedef std::vector<Coordinates<Traits>> Points;

  Points points_;
  std::vector<Field> weights_; // divided by the first; empty if all are equal
  std::vector<Field> knots_;   // the inner knots, where the domain is [0, 1]
  int degree_;
  bool turned_ = false, has_infinite_points_ = false;

public:
  Edge_polygon(const Surface& s, Patch_edge edge) {
    int m = 0, n = 0; // the control points in u and v
    if constexpr (Is_patch<Surface>::value) {
      m = s.degree_u() + 1;
      n = s.degree_v() + 1;
      degree_ = s.degree_along(edge);
    } else {
      m = s.number_of_points_u();
      n = s.number_of_points_v();
      const Knot_vector<FT>& along = s.knots_along(edge);
      degree_ = along.degree();
      take_knots(along);
    }
    const bool along_u = runs_along_u(edge);
    const int points = along_u ? m : n, side = at_upper_end(edge) ? (along_u ? n : m) - 1 : 0;
    for (int i = 0; i < points; ++i)
      points_.push_back(
          Geometric_continuity::coordinates<Traits>(along_u ? s.control_point(i, side) : s.control_point(side, i)));
    if constexpr (Is_rational_surface<Surface>::value)
      take_weights(points, [&](int i) -> const FT& { return along_u ? s.weight(i, side) : s.weight(side, i); });
    turn();
  }

  // See Edge_key. Whether all points are one is left to it where some are infinite.
  bool turned() const { return turned_; }
  bool single_point() const {
    return !has_infinite_points_ &&
           std::all_of(points_.begin(), points_.end(), [&](const auto& p) { return p == points_[0]; });
  }

  // Whether points and weights decide about equality. Over inner knots the direction of a closed edge may be that of its points,
  // but not that of the curve.
  bool has_form_of(const Edge_polygon& other) const {
    return degree_ == other.degree_ && knots_ == other.knots_ && !has_infinite_points_ && !other.has_infinite_points_ &&
           (knots_.empty() || !(points_.front() == points_.back()));
  }

  // By all points, then by the weights. \pre both have one form
  friend bool operator<(const Edge_polygon& x, const Edge_polygon& y) {
    return before(x.points_, y.points_) ||
           (x.weights_ != y.weights_ && x.points_ == y.points_ && x.weights_ < y.weights_);
  }

private:
  void take_knots(const Knot_vector<FT>& along) {
    const int inner = along.number_of_coefficients() - degree_ - 1;
    if (inner == 0) return;
    const Field begin = to_field<Field>(along.domain().first), length = to_field<Field>(along.domain().second) - begin;
    for (int i = degree_ + 1; i <= degree_ + inner; ++i)
      knots_.push_back(Field((to_field<Field>(along[i]) - begin) / length));
  }

  template <class Weight> void take_weights(int n, Weight weight) {
    bool equal = true;
    for (int i = 0; i < n; ++i) {
      equal = equal && weight(i) == weight(0);
      has_infinite_points_ = has_infinite_points_ || weight(i) == FT(0);
    }
    if (equal || has_infinite_points_) return;
    const Field first = to_field<Field>(weight(0));
    for (int i = 0; i < n; ++i) weights_.push_back(Field(to_field<Field>(weight(i)) / first));
  }

  void turn() {
    const int order = compare_with_reversed();
    turned_ = order < 0;
    if (!turned_ && order == 0) { // by what else is not the same backwards
      const std::vector<Field> weights = reversed_weights(), knots = reversed_knots();
      turned_ = weights < weights_ || (weights == weights_ && knots < knots_);
    }
    if (!turned_) return;
    std::reverse(points_.begin(), points_.end());
    weights_ = reversed_weights();
    knots_ = reversed_knots();
  }

  // The sign of what the reversed points are compared to these.
  int compare_with_reversed() const {
    for (std::size_t i = 0, j = points_.size(); i < points_.size(); ++i)
      if (const int order = compare_coordinates(points_[--j], points_[i])) return order;
    return 0;
  }
  std::vector<Field> reversed_weights() const {
    std::vector<Field> weights;
    for (auto w = weights_.rbegin(); w != weights_.rend(); ++w) weights.push_back(Field(*w / weights_.back()));
    return weights;
  }
  std::vector<Field> reversed_knots() const {
    std::vector<Field> knots;
    for (auto k = knots_.rbegin(); k != knots_.rend(); ++k) knots.push_back(Field(Field(1) - *k));
    return knots;
  }

  static bool before(const Points& x, const Points& y) {
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end(),
                                        [](const auto& p, const auto& q) { return compare_coordinates(p, q) < 0; });
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_POLYGON_H
