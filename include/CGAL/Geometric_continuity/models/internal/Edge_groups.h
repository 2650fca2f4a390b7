// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_GROUPS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_GROUPS_H

#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_key.h>
#include <CGAL/Geometric_continuity/models/internal/name_work_limit.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Edge_groups.h
/// Which edges of the patches of a model are the same.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An edge of a patch as one use of an edge of the model.
struct Edge_use {
  std::size_t patch;
  Patch_edge edge;
  bool backwards; // against the direction of the first use

  friend bool operator<(const Edge_use& a, const Edge_use& b) {
    return std::make_pair(a.patch, a.edge) < std::make_pair(b.patch, b.edge);
  }
};

// The control points of an edge over its knots, in the direction that makes them smaller. Edges of one form, i.e. of one degree
// over the same knots, are the same if and only if their points are; other edges are compared by Edge_key.
template <class Traits> class Edge_polygon {
  typedef Edge_field<Traits> Field;
  typedef typename Traits::FT FT;

  std::vector<Coordinates<Traits>> points_;
  std::vector<Field> knots_; // the inner knots, where the domain is [0, 1]
  int degree_ = -1;
  bool turned_ = false;

public:
  Edge_polygon(const Bezier_patch<Traits>& s, Patch_edge edge) : degree_(s.degree_along(edge)) {
    for (int i = 0; i <= degree_; ++i) add(s.control_point(edge, i, 0));
    turn();
  }
  Edge_polygon(const Bspline_surface<Traits>& s, Patch_edge edge) {
    const Knot_vector<FT>&along = s.knots_along(edge), &across = s.knots_across(edge);
    const int last = across.number_of_coefficients() - 1, side = at_upper_end(edge) ? last : 0;
    if (!along.is_clamped() || !across.is_clamped()) return;
    degree_ = along.degree();
    for (int i = 0; i < along.number_of_coefficients(); ++i)
      add(runs_along_u(edge) ? s.control_point(i, side) : s.control_point(side, i));
    const Field begin = to_field<Field>(along.domain().first), length = to_field<Field>(along.domain().second) - begin;
    for (int i = degree_ + 1; i < along.number_of_coefficients(); ++i)
      knots_.push_back(Field((to_field<Field>(along[i]) - begin) / length));
    turn();
  }

  // Whether the control points at the ends are points of the edge.
  bool valid() const { return degree_ >= 0; }
  // See Edge_key.
  bool turned() const { return turned_; }
  bool single_point() const {
    return std::all_of(points_.begin(), points_.end(), [&](const auto& p) { return p == points_[0]; });
  }

  // Whether equality of the points decides. Over inner knots the direction of a closed edge may be that of its points, but
  // not that of the curve.
  bool has_form_of(const Edge_polygon& other) const {
    return degree_ == other.degree_ && knots_ == other.knots_ &&
           (knots_.empty() || !(points_.front() == points_.back()));
  }

  // By the points at the ends.
  static bool ends_before(const Edge_polygon& x, const Edge_polygon& y) {
    const int first = compare(x.points_.front(), y.points_.front());
    return first < 0 || (first == 0 && compare(x.points_.back(), y.points_.back()) < 0);
  }
  // By all points. \pre both have one form
  friend bool operator<(const Edge_polygon& x, const Edge_polygon& y) { return before(x.points_, y.points_); }

private:
  typedef std::vector<Coordinates<Traits>> Points;

  void add(const typename Traits::Point& p) { points_.push_back(Geometric_continuity::coordinates<Traits>(p)); }

  void turn() {
    const Points points(points_.rbegin(), points_.rend());
    std::vector<Field> knots;
    for (auto k = knots_.rbegin(); k != knots_.rend(); ++k) knots.push_back(Field(Field(1) - *k));
    turned_ = before(points, points_) || (points == points_ && knots < knots_);
    if (!turned_) return;
    points_ = points;
    knots_.swap(knots);
  }

  static int compare(const Coordinates<Traits>& p, const Coordinates<Traits>& q) {
    for (int i = 0; i < p.dimension(); ++i) {
      if (p[i] < q[i]) return -1;
      if (q[i] < p[i]) return 1;
    }
    return 0;
  }
  static bool before(const Points& x, const Points& y) {
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end(),
                                        [](const auto& p, const auto& q) { return compare(p, q) < 0; });
  }
};

// Recognises each edge of a model once, by sorting: first by the points at its ends; then those with the same ends by their
// control points, if they have one degree and the same knots, otherwise by Edge_key.
template <class Surface> class Edge_groups {
  typedef typename Surface::Traits Traits;
  typedef Edge_key<Traits> Key;
  typedef Edge_polygon<Traits> Polygon;
  typedef typename std::vector<std::size_t>::iterator Iterator;

  const std::vector<const Surface*>& surfaces_;
  const Work_limit limit_;
  std::vector<Edge_use> uses_;
  std::vector<Polygon> polygons_; // of the uses
  std::vector<Edge_use> collapsed_;
  std::vector<std::vector<Edge_use>> edges_;

public:
  explicit Edge_groups(const std::vector<const Surface*>& surfaces, Work_limit limit = Work_limit())
      : surfaces_(surfaces), limit_(limit) {
    std::vector<std::size_t> with_polygon, other;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      for (Patch_edge edge : patch_edges) {
        Polygon polygon(*surfaces_[i], edge);
        if (polygon.valid() && polygon.single_point()) {
          collapsed_.push_back({i, edge, false});
          continue;
        }
        (polygon.valid() ? with_polygon : other).push_back(uses_.size());
        uses_.push_back({i, edge, false});
        polygons_.push_back(std::move(polygon));
      }
    if (other.empty())
      group_by_ends(with_polygon);
    else { // a control point may be no point of the edge
      other.insert(other.end(), with_polygon.begin(), with_polygon.end());
      std::sort(other.begin(), other.end());
      group_by_keys(other.begin(), other.end());
    }
    std::sort(collapsed_.begin(), collapsed_.end());
    std::sort(edges_.begin(), edges_.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  }

  // The uses of each edge that is not collapsed, by their patches; the edges by their first uses.
  const std::vector<std::vector<Edge_use>>& edges() const { return edges_; }
  // The edges that are single points, by their patches.
  const std::vector<Edge_use>& collapsed() const { return collapsed_; }

private:
  // Sorts, and calls f(first, last) for each run of elements none of which is less than another.
  template <class Less, class Function>
  static void for_each_run(Iterator begin, Iterator end, const Less& less, const Function& f) {
    std::stable_sort(begin, end, less);
    for (Iterator first = begin, last = begin; first != end; first = last) {
      while (last != end && !less(*first, *last)) ++last;
      f(first, last);
    }
  }

  void group_by_ends(std::vector<std::size_t>& uses) {
    const auto less_ends = [&](std::size_t a, std::size_t b) {
      return Polygon::ends_before(polygons_[a], polygons_[b]);
    };
    const auto less = [&](std::size_t a, std::size_t b) { return polygons_[a] < polygons_[b]; };
    const auto turned = [&](std::size_t a) { return polygons_[a].turned(); };
    for_each_run(uses.begin(), uses.end(), less_ends, [&](Iterator begin, Iterator end) {
      const bool one_form =
          std::all_of(begin, end, [&](std::size_t a) { return polygons_[a].has_form_of(polygons_[*begin]); });
      if (one_form)
        for_each_run(begin, end, less, [&](Iterator first, Iterator last) { add(first, last, turned); });
      else
        group_by_keys(begin, end);
    });
  }

  void group_by_keys(Iterator begin, Iterator end) {
    std::vector<std::size_t> numbers; // of the uses, in the order of the keys
    std::vector<Key> keys;
    std::vector<std::size_t> order;
    for (Iterator i = begin; i != end; ++i) {
      std::optional<Key> key;
      name_work_limit([&] { return edge_name(uses_[*i].patch, uses_[*i].edge); },
                      [&] { key.emplace(*surfaces_[uses_[*i].patch], uses_[*i].edge, limit_); });
      if (key->single_point()) {
        collapsed_.push_back(uses_[*i]);
        continue;
      }
      order.push_back(keys.size());
      numbers.push_back(*i);
      keys.push_back(*std::move(key));
    }
    const auto less = [&](std::size_t a, std::size_t b) { return keys[a].compare(keys[b]) < 0; };
    for_each_run(order.begin(), order.end(), less, [&](Iterator first, Iterator last) {
      const bool turned = keys[*first].turned();
      edges_.emplace_back();
      for (; first != last; ++first) {
        edges_.back().push_back(uses_[numbers[*first]]);
        edges_.back().back().backwards = keys[*first].turned() != turned;
      }
    });
  }

  template <class Turned> void add(Iterator first, Iterator last, const Turned& turned) {
    edges_.emplace_back();
    for (Iterator i = first; i != last; ++i) {
      edges_.back().push_back(uses_[*i]);
      edges_.back().back().backwards = turned(*i) != turned(*first);
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_GROUPS_H
