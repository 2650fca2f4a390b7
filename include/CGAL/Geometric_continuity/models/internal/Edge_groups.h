// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_GROUPS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_GROUPS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_key.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
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

// The uses of one edge.
class Edge_uses {
  const Edge_use *first_, *last_;

public:
  Edge_uses(const Edge_use* first, const Edge_use* last) : first_(first), last_(last) {}

  const Edge_use* begin() const { return first_; }
  const Edge_use* end() const { return last_; }
  std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }
  const Edge_use& operator[](std::size_t i) const { return first_[i]; }
};

// The numbers of the two corners where an edge begins and ends; a corner has the number 4 * patch +
// 2 * (at the end of u) + (at the end of v).
inline std::pair<std::size_t, std::size_t> corners_of(std::size_t patch, Patch_edge edge) {
  const std::size_t side = at_upper_end(edge), first = 4 * patch;
  return runs_along_u(edge) ? std::make_pair(first + side, first + 2 + side)
                            : std::make_pair(first + 2 * side, first + 2 * side + 1);
}

// Calls work(), and adds the place in the model, place(), to an error: where everything has been
// checked, the refusal of work that is too much.
template <class Place, class Work> void name_place(Place place, Work work) {
  try {
    work();
  } catch (const Error& error) {
    const std::size_t code_length = to_string(error.code()).size() + 2;
    throw Error(error.code(), place() + ": " + std::string(error.what()).substr(code_length));
  }
}

inline std::string edge_name(std::size_t patch, Patch_edge edge) {
  return "patch " + std::to_string(patch) + ' ' + to_string(edge);
}

// Returns whether the control points at the corners are points of the surface, and those of the
// edges belong to these alone.
template <class Surface> bool has_corner_points(const Surface& s) {
  if constexpr (Is_patch<Surface>::value)
    return true;
  else
    return s.knots_u().is_clamped() && s.knots_v().is_clamped();
}

// The control point at a corner.
template <class Surface> const typename Surface::Point& corner_point(const Surface& s, bool u, bool v) {
  if constexpr (Is_patch<Surface>::value)
    return s.control_point(u ? s.degree_u() : 0, v ? s.degree_v() : 0);
  else
    return s.control_point(u ? s.number_of_points_u() - 1 : 0, v ? s.number_of_points_v() - 1 : 0);
}

// Recognises each edge of a model once, by sorting: first by the points at its ends, which have
// been numbered; then those with the same ends by their control points and weights, if they have
// one degree and the same knots, otherwise by Edge_key.
template <class Surface> class Edge_groups {
  typedef typename Surface::Traits Traits;
  typedef Edge_key<Traits, row_dimension<Surface>> Key;
  typedef Edge_polygon<Surface> Polygon;

  const std::vector<const Surface*>& surfaces_;
  std::vector<Edge_use> uses_; // edge by edge
  std::vector<Edge_use> collapsed_;
  std::vector<Edge_uses> edges_;

public:
  explicit Edge_groups(const std::vector<const Surface*>& surfaces) : surfaces_(surfaces) {
    uses_.reserve(4 * surfaces_.size()); // so that the edges can point into it
    if (std::all_of(surfaces_.begin(), surfaces_.end(), [](const Surface* s) { return has_corner_points(*s); }))
      group_by_ends();
    else { // a control point may be no point of the edge
      std::vector<Edge_use> all;
      for (std::size_t i = 0; i < surfaces_.size(); ++i)
        for (Patch_edge edge : patch_edges) all.push_back({i, edge, false});
      group_by_keys(all);
    }
    std::sort(collapsed_.begin(), collapsed_.end());
    std::sort(edges_.begin(), edges_.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  }
  Edge_groups(const Edge_groups&) = delete;
  Edge_groups& operator=(const Edge_groups&) = delete;

  // The uses of each edge that is not collapsed, by their patches; the edges by their first uses.
  const std::vector<Edge_uses>& edges() const { return edges_; }
  // The edges that are single points, by their patches.
  const std::vector<Edge_use>& collapsed() const { return collapsed_; }

private:
  // Returns one number for each point that is a corner, by the numbers of the corners.
  std::vector<std::size_t> numbers_of_corners() const {
    struct Corner {
      Coordinates<Traits> x;
      std::size_t number;
    };
    std::vector<Corner> corners;
    corners.reserve(4 * surfaces_.size());
    for (const Surface* s : surfaces_)
      for (bool u : {false, true})
        for (bool v : {false, true})
          corners.push_back({Geometric_continuity::coordinates<Traits>(corner_point(*s, u, v)), corners.size()});
    const auto less = [](const Corner& a, const Corner& b) { return compare_coordinates(a.x, b.x) < 0; };
    std::sort(corners.begin(), corners.end(), less);
    std::vector<std::size_t> numbers(corners.size());
    std::size_t points = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      // equivalent [+= -> -=, 1]: the numbers are compared for equality only
      points += i > 0 && less(corners[i - 1], corners[i]);
      numbers[corners[i].number] = points;
    }
    return numbers;
  }

  void group_by_ends() {
    struct Placed_use {
      std::size_t low, high; // the points at the ends
      Edge_use use;
    };
    std::vector<Placed_use> placed;
    {
      const std::vector<std::size_t> corners = numbers_of_corners();
      placed.reserve(corners.size());
      for (std::size_t i = 0; i < surfaces_.size(); ++i)
        for (Patch_edge edge : patch_edges) {
          const std::pair<std::size_t, std::size_t> ends = corners_of(i, edge);
          const std::size_t a = corners[ends.first], b = corners[ends.second];
          placed.push_back({(std::min)(a, b), (std::max)(a, b), {i, edge, false}});
        }
    }
    const auto less = [](const Placed_use& a, const Placed_use& b) {
      return std::tie(a.low, a.high, a.use) < std::tie(b.low, b.high, b.use);
    };
    std::sort(placed.begin(), placed.end(), less);
    std::vector<Edge_use> same_ends;
    for (auto first = placed.begin(), last = first; first != placed.end(); first = last) {
      same_ends.clear();
      for (; last != placed.end() && last->low == first->low && last->high == first->high; ++last)
        same_ends.push_back(last->use);
      group_by_polygons(same_ends, first->low == first->high);
    }
  }

  // Edges with the same points at their ends.
  void group_by_polygons(const std::vector<Edge_use>& uses, bool closed) {
    if (uses.size() == 1 && !closed) {
      uses_.push_back(uses[0]);
      edges_.emplace_back(uses_.data() + uses_.size() - 1, uses_.data() + uses_.size());
      return;
    }
    std::vector<Edge_use> open;
    std::vector<Polygon> polygons;
    for (const Edge_use& use : uses) {
      Polygon polygon(*surfaces_[use.patch], use.edge);
      if (closed && polygon.single_point()) {
        collapsed_.push_back(use);
        continue;
      }
      open.push_back(use);
      polygons.push_back(std::move(polygon));
    }
    if (std::all_of(polygons.begin(), polygons.end(), [&](const Polygon& p) { return p.has_form_of(polygons[0]); }))
      group(open, polygons, [](const Polygon& a, const Polygon& b) { return a < b; });
    else
      group_by_keys(open);
  }

  void group_by_keys(const std::vector<Edge_use>& uses) {
    std::vector<Edge_use> open;
    std::vector<Key> keys;
    for (const Edge_use& use : uses) {
      std::optional<Key> key;
      name_place([&] { return edge_name(use.patch, use.edge); }, [&] { key.emplace(*surfaces_[use.patch], use.edge); });
      if (key->single_point()) {
        collapsed_.push_back(use);
        continue;
      }
      open.push_back(use);
      keys.push_back(*std::move(key));
    }
    group(open, keys, [](const Key& a, const Key& b) { return a.compare(b) < 0; });
  }

  // Edges are the same when neither of what stands for them is less. \pre the uses are in order
  template <class Form, class Less>
  void group(const std::vector<Edge_use>& uses, const std::vector<Form>& forms, const Less& less) {
    std::vector<std::size_t> order(uses.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return less(forms[a], forms[b]); });
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
      const Form& form = forms[order[first]];
      const Edge_use* const begin = uses_.data() + uses_.size();
      for (; last < order.size() && !less(form, forms[order[last]]); ++last) {
        uses_.push_back(uses[order[last]]);
        uses_.back().backwards = forms[order[last]].turned() != form.turned();
      }
      edges_.emplace_back(begin, uses_.data() + uses_.size());
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_GROUPS_H
