// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_KEY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_KEY_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Numbers that two edges have in common if and only if they are the same curve after affine maps of
// both domains to [0, 1], in either direction, whatever their degrees and knots. For each interval
// on which the curve is one polynomial: its start and the coefficients of the powers of the
// parameter of the whole, up to the last that is not zero; in the direction that makes them
// smaller. Homogeneous points, N = 4, have them in common up to a factor, see normalise(). For
// sorting many edges; two edges are compared by Common_edge_part and Edge_sides::align().
template <class Traits, int N = 3> class Edge_key {
  typedef Edge_field<Traits> Field;
  typedef typename Exact_number<Field>::type Exact; // compared often, evaluated once
  typedef typename Edge_rows<Field, N>::Row Row;
  struct Piece {
    Field begin, end;
    Row row; // the polynomial on [0, 1]
  };

  std::vector<std::vector<Exact>> numbers_;
  bool turned_ = false;

public:
  template <class Surface> Edge_key(const Surface& surface, Patch_edge edge) {
    const Work_guard work("model_continuity");
    std::vector<Piece> pieces = unit_pieces(surface, edge);
    for (const Piece& piece : pieces) charge_powers<Field>(piece.row);
    numbers_ = numbers(pieces);
    std::reverse(pieces.begin(), pieces.end());
    for (Piece& piece : pieces) {
      std::reverse(piece.row.begin(), piece.row.end());
      piece.begin = Field(Field(1) - piece.end);
    }
    std::vector<std::vector<Exact>> backwards = numbers(pieces);
    turned_ = backwards < numbers_;
    if (turned_) numbers_.swap(backwards);
  }

  bool single_point() const { return numbers_.size() == 1 && numbers_[0].size() == N + 1; }

  // Returns whether the numbers are those of the reversed edge. If two edges with equal keys differ
  // in this, one is the reverse of the other. (An edge that is the same backwards is not turned.)
  bool turned() const { return turned_; }

  // Negative, zero or positive.
  int compare(const Edge_key& other) const {
    return numbers_ < other.numbers_ ? -1 : other.numbers_ < numbers_ ? 1 : 0;
  }

private:
  // Homogeneous points are divided by the first number of the last coefficient; but those of a
  // single point become this point.
  static void normalise(Row& powers) {
    if constexpr (N == 4) {
      const auto& last = powers.back();
      const auto is_multiple = [&](const auto& x) {
        for (int i = 0; i < 3; ++i)
          if (x[i] * last[3] != last[i] * x[3]) return false;
        return true;
      };
      int i = 0;
      while (last[i] == Field(0)) ++i;
      if (last[3] != Field(0) && std::all_of(powers.begin(), powers.end(), is_multiple)) {
        const typename Row::value_type point = last;
        powers.assign(1, point);
        i = 3;
      }
      const Field factor = powers.back()[i];
      for (auto& x : powers) x /= factor;
    }
  }

  template <class Surface> static std::vector<Piece> unit_pieces(const Surface& surface, Patch_edge edge) {
    // row 0 is that of the only piece; no division is needed
    if constexpr (Is_patch<Surface>::value)
      return {{Field(0), Field(1), row_in_space<Field, N>(surface.template rows<Field>(edge, 0)[0])}};
    else
      return pieces_of_spline(surface, edge);
  }

  template <class Surface> static std::vector<Piece> pieces_of_spline(const Surface& surface, Patch_edge edge) {
    const Knot_vector<Field> knots = knots_over<Field>(surface.knots_along(edge));
    const Row rows = bernstein_pieces(knots, row_in_space<Field, N>(surface.template rows<Field>(edge, 0)[0]));
    const std::pair<Field, Field> domain = knots.domain();
    const Field length = domain.second - domain.first;
    std::vector<Piece> pieces;
    auto row = rows.begin();
    for (int k : knots.spans()) {
      const Field span = knots[k + 1] - knots[k];
      const auto end = row + (knots.degree() + 1);
      pieces.push_back({Field(Field(knots[k] - domain.first) / length),
                        Field(Field(knots[k + 1] - domain.first) / length),
                        restricted(Row(row, end), Field(Field(domain.first - knots[k]) / span),
                                   Field(Field(domain.second - knots[k]) / span))});
      row = end;
    }
    return pieces;
  }

  static std::vector<std::vector<Exact>> numbers(const std::vector<Piece>& pieces) {
    std::vector<std::vector<Exact>> result;
    Row last;
    for (const Piece& piece : pieces) {
      Row powers = powers_from_bernstein<Field>(piece.row);
      normalise(powers);
      if (powers == last) continue; // the same polynomial goes on
      result.emplace_back(1, Exact_number<Field>::of(piece.begin));
      for (const auto& a : powers)
        for (const Field& x : a) result.back().push_back(Exact_number<Field>::of(x));
      last.swap(powers);
    }
    return result;
  }
};

// Coordinate by coordinate: negative, zero or positive.
template <class Coordinates> int compare_coordinates(const Coordinates& p, const Coordinates& q) {
  for (int i = 0; i < p.dimension(); ++i) {
    if (p[i] < q[i]) return -1;
    if (q[i] < p[i]) return 1;
  }
  return 0;
}

// The control points of an edge over its knots and its weights, in the direction that makes them
// smaller. Edges of one form, i.e. of one degree over the same knots, are the same if and only if
// their points are and their weights up to a factor; other edges are compared by Edge_key.
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
    if constexpr (Is_rational<Surface>::value)
      take_weights(points, [&](int i) -> const FT& { return along_u ? s.weight(i, side) : s.weight(side, i); });
    turn();
  }

  // See Edge_key. Where some points are infinite, it also decides if all points are one.
  bool turned() const { return turned_; }
  bool single_point() const {
    return !has_infinite_points_ &&
           std::all_of(points_.begin(), points_.end(), [&](const auto& p) { return p == points_[0]; });
  }

  // Returns whether points and weights decide about equality. Over inner knots the direction of a
  // closed edge may be that of its points, but not that of the curve. \pre the other one has its
  // own form
  bool has_form_of(const Edge_polygon& other) const {
    return degree_ == other.degree_ && knots_ == other.knots_ && !has_infinite_points_ &&
           (knots_.empty() || !(points_.front() == points_.back()));
  }

  // Compares by all points, then by the weights. \pre both have one form
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

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_KEY_H
