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

  // Finds the opposite halfedges by sorting. The ends of an edge stand beside its number, so that a
  // comparison reads one place of the memory.
  void match() {
    struct Use {
      std::size_t low, high, halfedge;
      bool has_edge_of(const Use& other) const { return low == other.low && high == other.high; }
      bool operator<(const Use& other) const {
        return std::tie(low, high, halfedge) < std::tie(other.low, other.high, other.halfedge);
      }
    };
    std::vector<Use> uses;
    uses.reserve(size());
    for (std::size_t h = 0; h < size(); ++h) {
      const std::size_t a = source(h), b = target(h);
      uses.push_back({(std::min)(a, b), (std::max)(a, b), h});
    }
    std::sort(uses.begin(), uses.end());
    for (std::size_t first = 0, last = 0; first < size(); first = last) {
      while (last < size() && uses[last].has_edge_of(uses[first])) ++last;
      if (last - first == 1) continue;
      const std::size_t g = uses[first].halfedge, h = uses[first + 1].halfedge;
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
