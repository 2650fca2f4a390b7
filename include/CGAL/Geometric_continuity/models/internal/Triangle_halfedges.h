// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_TRIANGLE_HALFEDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_TRIANGLE_HALFEDGES_H

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// \file Triangle_halfedges.h
/// The halfedges of triangles that are given by the numbers of their points, and a check that they
/// are an oriented manifold.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The halfedges of triangles: number 3 t + i leads from corner i of triangle t to the next one.
class Triangle_halfedges {
  typedef std::array<std::size_t, 3> Triangle;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const std::vector<Triangle>& triangles_;
  std::vector<std::size_t> opposite_;

public:
  explicit Triangle_halfedges(const std::vector<Triangle>& triangles, std::size_t number_of_points)
      : triangles_(triangles), opposite_(3 * triangles.size(), none) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        if (triangles[t][i] >= number_of_points)
          refuse("triangle " + std::to_string(t) + " has a point that does not exist");
        if (triangles[t][i] == triangles[t][(i + 1) % 3])
          refuse("triangle " + std::to_string(t) + " has one point twice");
      }
    match();
    check_points(number_of_points);
  }

  std::size_t size() const { return opposite_.size(); }
  std::size_t source(std::size_t h) const { return triangles_[h / 3][h % 3]; }
  std::size_t target(std::size_t h) const { return source(next(h)); }
  static std::size_t next(std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::size_t previous(std::size_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  bool on_boundary(std::size_t h) const { return opposite_[h] == none; }
  std::size_t opposite(std::size_t h) const { return opposite_[h]; }

private:
  [[noreturn]] static void refuse(const std::string& reason) {
    throw Error(Error_code::not_a_manifold, "to_face_graph: " + reason);
  }

  void match() {
    std::vector<std::size_t> order;
    for (std::size_t h = 0; h < size(); ++h) order.push_back(h);
    const auto ends = [&](std::size_t h) {
      const std::size_t a = source(h), b = target(h);
      return std::make_pair((std::min)(a, b), (std::max)(a, b));
    };
    std::sort(order.begin(), order.end(), [&](std::size_t g, std::size_t h) { return ends(g) < ends(h); });
    for (std::size_t first = 0, last = 0; first < size(); first = last) {
      while (last < size() && ends(order[last]) == ends(order[first])) ++last;
      if (last - first == 1) continue;
      const std::size_t g = order[first], h = order[first + 1];
      const std::string edge =
          "the edge from point " + std::to_string(source(g)) + " to point " + std::to_string(target(g));
      if (last - first > 2) refuse(edge + " has more than two triangles");
      if (source(g) == source(h)) refuse(edge + " has two triangles of opposite orientations");
      opposite_[g] = h;
      opposite_[h] = g;
    }
  }

  // The triangles at a point must be one fan: turning from one of them, first backwards, leads to
  // all of them.
  void check_points(std::size_t number_of_points) const {
    std::vector<std::size_t> degree(number_of_points), some(number_of_points, none);
    for (std::size_t h = 0; h < size(); ++h) {
      ++degree[source(h)];
      // a boundary halfedge begins the fan
      if (some[source(h)] == none || on_boundary(h)) some[source(h)] = h;
    }
    for (std::size_t p = 0; p < number_of_points; ++p) {
      std::size_t seen = 0, h = some[p];
      for (; h != none && !(seen > 0 && h == some[p]); h = opposite_[previous(h)]) ++seen;
      if (seen != degree[p]) refuse("the triangles at point " + std::to_string(p) + " are not one fan");
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_TRIANGLE_HALFEDGES_H
