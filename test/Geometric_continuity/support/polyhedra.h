// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "fractions.h"
#include "random.h"
#include "test.h"

// Polyhedra of plane faces, as points and loops of their numbers.

struct Solid {
  std::vector<std::array<Q, 3>> points;
  std::vector<std::vector<std::vector<int>>> faces;
};

template <class FT> FT fraction_in(int n, int d) { return FT(FT(n) / FT(d)); }

template <class K> std::vector<typename K::Point_3> points_of(const Solid& solid) {
  std::vector<typename K::Point_3> points;
  for (const auto& p : solid.points)
    if constexpr (std::is_floating_point_v<typename K::FT>)
      points.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
    else
      points.emplace_back(p[0], p[1], p[2]);
  return points;
}

// Over a polygon in the plane z = 0, counterclockwise, and others that are holes in it, clockwise.
inline Solid prism(const std::vector<std::vector<std::array<int, 2>>>& polygons, int height) {
  Solid s;
  std::vector<std::vector<int>> top, bottom;
  for (const auto& polygon : polygons) {
    const int n = static_cast<int>(polygon.size()), first = static_cast<int>(s.points.size());
    for (int z : {0, height})
      for (const auto& p : polygon) s.points.push_back({Q(p[0]), Q(p[1]), Q(z)});
    top.emplace_back();
    bottom.emplace_back();
    for (int i = 0; i < n; ++i) {
      top.back().push_back(first + n + i);
      bottom.back().push_back(first + n - 1 - i);
      const int j = (i + 1) % n;
      s.faces.push_back({{first + i, first + j, first + n + j, first + n + i}});
    }
  }
  s.faces.push_back(bottom);
  s.faces.push_back(top);
  return s;
}
inline Solid prism(const std::vector<std::array<int, 2>>& polygon, int height) {
  return prism(std::vector<std::vector<std::array<int, 2>>>{polygon}, height);
}
inline Solid box(int x, int y, int z) { return prism({{0, 0}, {x, 0}, {x, y}, {0, y}}, z); }
inline Solid plate_with_hole() {
  return prism(
      std::vector<std::vector<std::array<int, 2>>>{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{3, 3}, {3, 5}, {5, 5}, {5, 3}}},
      2);
}

// The points that satisfy a x + b y + c z <= d for planes (a, b, c, d), three of which meet at each
// vertex.
inline Solid intersection_of(const std::vector<std::array<Q, 4>>& planes) {
  Solid s;
  const int n = static_cast<int>(planes.size());
  std::vector<std::array<int, 3>> of_point;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const std::array<Q, 4>&a = planes[i], &b = planes[j], &c = planes[k];
        const auto det = [](const Q* x, const Q* y, const Q* z) -> Q {
          return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
                 x[2] * (y[0] * z[1] - y[1] * z[0]);
        };
        const Q d = det(a.data(), b.data(), c.data());
        if (d == 0) continue;
        std::array<Q, 3> p;
        for (int x = 0; x < 3; ++x) {
          std::array<Q, 4> r[3] = {a, b, c};
          for (auto& row : r) row[x] = row[3];
          p[x] = Q(det(r[0].data(), r[1].data(), r[2].data()) / d);
        }
        bool inside = true;
        for (const auto& q : planes) inside = inside && Q(q[0] * p[0] + q[1] * p[1] + q[2] * p[2]) <= q[3];
        if (!inside) continue;
        s.points.push_back(p);
        of_point.push_back({i, j, k});
      }
  for (int f = 0; f < n; ++f) { // its points, counterclockwise
    std::vector<int> loop;
    for (std::size_t v = 0; v < of_point.size(); ++v)
      if (std::count(of_point[v].begin(), of_point[v].end(), f)) loop.push_back(static_cast<int>(v));
    if (loop.empty()) continue;
    std::array<double, 3> centre{}, normal{}, x{}, y{};
    for (int v : loop)
      for (int k = 0; k < 3; ++k) centre[k] += CGAL::to_double(s.points[v][k]) / static_cast<double>(loop.size());
    for (int k = 0; k < 3; ++k) {
      normal[k] = CGAL::to_double(planes[f][k]);
      x[k] = CGAL::to_double(s.points[loop[0]][k]) - centre[k];
    }
    for (int k = 0; k < 3; ++k) y[k] = normal[(k + 1) % 3] * x[(k + 2) % 3] - normal[(k + 2) % 3] * x[(k + 1) % 3];
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    std::vector<std::pair<double, int>> angles;
    for (int v : loop) {
      double p = 0, q = 0;
      for (int k = 0; k < 3; ++k) {
        p += (CGAL::to_double(s.points[v][k]) - centre[k]) * x[k];
        q += (CGAL::to_double(s.points[v][k]) - centre[k]) * y[k] / length;
      }
      angles.emplace_back(std::atan2(q, p), v);
    }
    std::sort(angles.begin(), angles.end());
    for (std::size_t i = 0; i < loop.size(); ++i) loop[i] = angles[i].second;
    s.faces.push_back({loop});
  }
  return s;
}

inline Solid tetrahedron() {
  return {{{Q(0), Q(0), Q(0)}, {Q(4), Q(0), Q(0)}, {Q(0), Q(4), Q(0)}, {Q(0), Q(0), Q(4)}},
          {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};
}
// Twelve pentagons.
inline Solid pyritohedron() {
  std::vector<std::array<Q, 4>> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (int i : {-1, 1})
      for (int j : {-1, 1}) {
        std::array<Q, 4> p{Q(0), Q(0), Q(0), Q(3)};
        p[axis] = Q(2 * i);
        p[(axis + 1) % 3] = Q(j);
        planes.push_back(p);
      }
  return intersection_of(planes);
}
inline Solid truncated_box() {
  return intersection_of({{Q(1), Q(0), Q(0), Q(4)},
                          {Q(-1), Q(0), Q(0), Q(0)},
                          {Q(0), Q(1), Q(0), Q(4)},
                          {Q(0), Q(-1), Q(0), Q(0)},
                          {Q(0), Q(0), Q(1), Q(4)},
                          {Q(0), Q(0), Q(-1), Q(0)},
                          {Q(1), Q(1), Q(1), Q(10)}});
}
// A cube without a cube at one corner: three edges are concave, and of the corners where they end
// two edges are convex.
inline Solid step() {
  Solid s;
  for (int z : {0, 2, 4})
    for (int y : {0, 2, 4})
      for (int x : {0, 2, 4}) s.points.push_back({Q(x), Q(y), Q(z)});
  const auto at = [](int x, int y, int z) { return x / 2 + 3 * (y / 2) + 9 * (z / 2); };
  s.faces = {{{at(0, 0, 0), at(0, 4, 0), at(4, 4, 0), at(4, 0, 0)}},
             {{at(0, 0, 0), at(4, 0, 0), at(4, 0, 4), at(0, 0, 4)}},
             {{at(0, 0, 0), at(0, 0, 4), at(0, 4, 4), at(0, 4, 0)}},
             {{at(4, 0, 0), at(4, 4, 0), at(4, 4, 2), at(4, 2, 2), at(4, 2, 4), at(4, 0, 4)}},
             {{at(0, 4, 0), at(0, 4, 4), at(2, 4, 4), at(2, 4, 2), at(4, 4, 2), at(4, 4, 0)}},
             {{at(0, 0, 4), at(4, 0, 4), at(4, 2, 4), at(2, 2, 4), at(2, 4, 4), at(0, 4, 4)}},
             {{at(2, 2, 2), at(2, 4, 2), at(2, 4, 4), at(2, 2, 4)}},
             {{at(2, 2, 2), at(2, 2, 4), at(4, 2, 4), at(4, 2, 2)}},
             {{at(2, 2, 2), at(4, 2, 2), at(4, 4, 2), at(2, 4, 2)}}};
  return s;
}
