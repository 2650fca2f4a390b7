// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PLANAR_SOLID_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PLANAR_SOLID_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Planar_solid.h
/// A closed surface of plane faces, which may have holes, by its halfedges. Faces that lie in one
/// plane and have an edge in common become one face, and edges that continue each other one edge.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT> class Planar_solid {
public:
  typedef Coordinate_vector<FT, 3> Vector;
  typedef std::vector<int> Loop; // the numbers of its points
  typedef std::vector<Loop> Polygon;

  struct Halfedge {
    int source, next, previous, opposite, face, edge;
  };
  struct Face {
    int given;              // the number of the first of the given faces that it consists of
    Vector normal;          // outward, of about the length 1 in its largest coordinate
    std::vector<int> loops; // a halfedge of each
  };

  std::vector<Vector> points;
  std::vector<Halfedge> halfedges; // those of the edge e are 2 e and 2 e + 1
  std::vector<Face> faces;
  std::vector<int> leaving;                  // a halfedge of each point; -1 for points inside of faces and edges
  std::vector<std::vector<int>> given_edges; // of each edge, those that are parts of it

  // The edges of the polygons are numbered by `number(source, target)`, where both numbers of an
  // edge are one; `name(number)` is how errors call it. The planes of rounded points are those of
  // the faces within `tolerance` times the size of all.
  template <class Number, class Name>
  Planar_solid(std::vector<Vector> given_points, const std::vector<Polygon>& polygons, const Number& number,
               const Name& name, double tolerance)
      : points(std::move(given_points)), name_(name) {
    measure(tolerance);
    connect(polygons, number);
    find_planes(polygons);
    unite_planes(polygons);
    unite_edges();
    number_all(polygons);
  }

  int size_of_edges() const { return static_cast<int>(halfedges.size() / 2); }
  int target(int h) const { return halfedges[halfedges[h].next].source; }
  Vector direction(int h) const { return points[target(h)] - points[halfedges[h].source]; }
  // The next halfedge counterclockwise around the source: the face of h lies between.
  int turned(int h) const { return halfedges[halfedges[h].previous].opposite; }
  int degree(int vertex) const {
    int n = 0, h = leaving[vertex];
    do ++n, h = turned(h);
    while (h != leaving[vertex]);
    return n;
  }
  const Vector& normal(int h) const { return faces[halfedges[h].face].normal; }

  std::string edge_text(int edge) const { return name_(given_edges[edge].front()) + ends_text(2 * edge); }
  std::string point_text(int i) const {
    std::ostringstream os;
    os << '(';
    for (int k = 0; k < 3; ++k) os << (k > 0 ? ", " : "") << rounded_number(points[i][k]);
    os << ')';
    return os.str();
  }
  // The length of the box of all points.
  double size() const { return size_; }
  double tolerance() const { return tolerance_; }

private:
  static constexpr bool is_rounded = std::is_floating_point_v<FT>;

  std::function<std::string(int)> name_;
  double size_ = 0, tolerance_ = 0; // absolute, 0 for exact numbers
  FT unit_ = FT(1);                 // a power of two, about the size

  [[noreturn]] static void refuse(Error_code code, const std::string& text) {
    throw Error(code, "round_polyhedron: " + text);
  }
  std::string ends_text(int h) const {
    return " from " + point_text(halfedges[h].source) + " to " + point_text(halfedges[halfedges[h].opposite].source);
  }

  void measure(double tolerance) {
    if (points.empty()) refuse(Error_code::wrong_number_of_points, "there are no faces");
    double lower[3], upper[3];
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const double x = rounded_number(points[i][k]);
        if (!std::isfinite(x)) refuse(Error_code::not_finite, "a coordinate of the point " + point_text(int(i)));
        lower[k] = i == 0 ? x : (std::min)(lower[k], x);
        upper[k] = i == 0 ? x : (std::max)(upper[k], x);
      }
    for (int k = 0; k < 3; ++k) size_ = (std::max)(size_, upper[k] - lower[k]);
    if (!(size_ > 0)) refuse(Error_code::zero_tangent, "all points are one");
    if (!(1e-100 < size_ && size_ < 1e100))
      refuse(Error_code::not_finite, "the points are so near to each other or so far apart that products overflow");
    if (is_rounded) tolerance_ = tolerance * size_;
    int exponent;
    std::frexp(size_, &exponent);
    const FT two(2);
    for (; exponent > 0; --exponent) unit_ *= two;
    for (; exponent < 0; ++exponent) unit_ /= two;
  }

  template <class Number> void connect(const std::vector<Polygon>& polygons, const Number& number) {
    std::map<std::pair<int, int>, int> known;
    for (std::size_t f = 0; f < polygons.size(); ++f)
      for (const Loop& loop : polygons[f]) {
        const int first = static_cast<int>(halfedges.size()), n = static_cast<int>(loop.size());
        if (n < 3)
          refuse(Error_code::wrong_number_of_points, "the face " + std::to_string(f) + " has less than three edges");
        for (int i = 0; i < n; ++i) {
          const int source = loop[i], target = loop[(i + 1) % n];
          if (points[source] == points[target])
            refuse(Error_code::zero_tangent,
                   name_(number(source, target)) + " at " + point_text(source) + " has the length 0");
          if (!known.emplace(std::make_pair(source, target), first + i).second)
            refuse(Error_code::not_a_manifold, name_(number(source, target)) + " from " + point_text(source) + " to " +
                                                   point_text(target) +
                                                   " is passed twice in the same direction; faces must meet two by "
                                                   "two, and have one orientation");
          halfedges.push_back({source, first + (i + 1) % n, first + (i + n - 1) % n, -1, static_cast<int>(f), -1});
          numbers_.push_back(number(source, target));
        }
      }
    for (const auto& [ends, h] : known) {
      const auto other = known.find({ends.second, ends.first});
      if (other == known.end())
        refuse(Error_code::not_a_manifold, name_(numbers_[h]) + " from " + point_text(ends.first) + " to " +
                                               point_text(ends.second) +
                                               " has a face on one side only; the surface must be closed");
      halfedges[h].opposite = other->second;
    }
  }

  static FT magnitude(const FT& x) { return x < FT(0) ? FT(-x) : x; }

  // Divided by a power of two that is about its largest coordinate.
  static Vector shortened(const Vector& n) {
    FT largest(0);
    for (const FT& x : n)
      if (largest < magnitude(x)) largest = magnitude(x);
    if (largest == FT(0)) return n;
    int exponent;
    std::frexp(rounded_number(largest), &exponent);
    FT factor(1);
    const FT two(2);
    for (; exponent > 0; --exponent) factor /= two;
    for (; exponent < 0; ++exponent) factor *= two;
    return factor * n;
  }

  // The sum of the areas of the triangles of all loops, as a vector.
  Vector area(const Polygon& loops) const {
    Vector sum(3);
    const Vector& origin = points[loops[0][0]];
    for (const Loop& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        sum += cross_product(FT(1) / unit_ * (points[loop[i]] - origin),
                             FT(1) / unit_ * (points[loop[(i + 1) % loop.size()]] - origin));
    return sum;
  }

  // Returns whether a point is in the plane through another one.
  bool lies_in(const Vector& normal, const Vector& origin, const Vector& point) const {
    const FT height = dot(normal, point - origin);
    if constexpr (is_rounded)
      return std::abs(height) <= tolerance_ * std::sqrt(dot(normal, normal));
    else
      return height == FT(0);
  }

  void find_planes(const std::vector<Polygon>& polygons) {
    for (const Polygon& loops : polygons) {
      const Vector n = area(loops);
      const std::string face = "the face " + std::to_string(normals_.size());
      if (is_zero(n)) refuse(Error_code::singular_frame, face + " has no area");
      normals_.push_back(shortened(n));
      for (const Loop& loop : loops)
        for (int i : loop)
          if (!lies_in(normals_.back(), points[loops[0][0]], points[i]))
            refuse(Error_code::singular_frame, face + " is not plane: the point " + point_text(i) +
                                                   " is not in the plane through " + point_text(loops[0][0]) +
                                                   "; faces of a polyhedron are rounded only where they are plane");
    }
  }

  int representative(int face) {
    while (group_[face] != face) face = group_[face] = group_[group_[face]];
    return face;
  }

  // Faces in one plane that have an edge in common, to which points of triangles belong.
  void unite_planes(const std::vector<Polygon>& polygons) {
    group_.resize(polygons.size());
    std::iota(group_.begin(), group_.end(), 0);
    removed_.assign(halfedges.size(), false);
    for (std::size_t h = 0; h < halfedges.size(); ++h) {
      const int f = halfedges[h].face, g = halfedges[halfedges[h].opposite].face;
      if (f == g) {
        refuse(Error_code::singular_frame, name_(numbers_[h]) + ends_text(int(h)) + " has one face on both sides");
      }
      if (g < f) continue;
      const FT cosine = dot(normals_[f], normals_[g]);
      const Vector& origin = points[halfedges[h].source];
      const auto holds_all = [&](const Vector& normal, const Polygon& polygon) {
        return std::all_of(polygon.begin(), polygon.end(), [&](const Loop& loop) {
          return std::all_of(loop.begin(), loop.end(), [&](int i) { return lies_in(normal, origin, points[i]); });
        });
      };
      if (!holds_all(normals_[f], polygons[g]) || !holds_all(normals_[g], polygons[f])) continue;
      if (cosine < FT(0))
        refuse(Error_code::singular_frame,
               name_(numbers_[h]) + ends_text(int(h)) + " lies between two faces that cover each other");
      removed_[h] = removed_[halfedges[h].opposite] = true;
      const int a = representative(f), b = representative(g);
      group_[(std::max)(a, b)] = (std::min)(a, b);
    }
    for (std::size_t h = 0; h < halfedges.size(); ++h) {
      if (removed_[h]) continue;
      int next = halfedges[h].next;
      while (removed_[next]) next = halfedges[halfedges[next].opposite].next;
      halfedges[h].next = next;
    }
    for (std::size_t h = 0; h < halfedges.size(); ++h)
      if (!removed_[h]) {
        halfedges[halfedges[h].next].previous = static_cast<int>(h);
        halfedges[h].face = representative(halfedges[h].face);
      }
  }

  // Where only two edges meet, which then continue each other, they become one.
  void unite_edges() {
    parts_.resize(halfedges.size());
    for (std::size_t h = 0; h < halfedges.size(); ++h) parts_[h] = {numbers_[h]};
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      const int h = static_cast<int>(i);
      if (removed_[h]) continue;
      for (;;) { // next into h
        const int n = halfedges[h].next, o = halfedges[h].opposite, p = halfedges[n].opposite;
        if (n == h || halfedges[p].next != o || p == h) break;
        const int after = halfedges[n].next, before = halfedges[p].previous;
        halfedges[h].next = after;
        halfedges[after].previous = h;
        halfedges[o].source = halfedges[p].source;
        halfedges[o].previous = before;
        halfedges[before].next = o;
        removed_[n] = removed_[p] = true;
        parts_[h].insert(parts_[h].end(), parts_[n].begin(), parts_[n].end());
        parts_[o] = parts_[h];
        if (after == p || after == o) break;
      }
    }
  }

  void number_all(const std::vector<Polygon>& polygons) {
    std::vector<int> number(halfedges.size(), -1);
    std::vector<Halfedge> kept;
    for (std::size_t h = 0; h < halfedges.size(); ++h)
      if (!removed_[h] && number[h] < 0) {
        number[h] = static_cast<int>(kept.size());
        number[halfedges[h].opposite] = number[h] + 1;
        kept.push_back(halfedges[h]);
        kept.push_back(halfedges[halfedges[h].opposite]);
        given_edges.push_back(parts_[h]);
      }
    std::vector<int> face_number(polygons.size(), -1);
    for (std::size_t h = 0; h < kept.size(); ++h) {
      Halfedge& x = kept[h];
      x.next = number[x.next];
      x.previous = number[x.previous];
      x.opposite = number[x.opposite];
      x.edge = static_cast<int>(h / 2);
      int& f = face_number[x.face];
      if (f < 0) {
        f = static_cast<int>(faces.size());
        faces.push_back({x.face, Vector(3), {}});
      }
      x.face = f;
    }
    halfedges = std::move(kept);
    for (std::size_t f = 0; f < polygons.size(); ++f) // the largest parts count most
      faces[face_number[representative(int(f))]].normal += area(polygons[f]);
    for (Face& f : faces) f.normal = shortened(f.normal);
    leaving.assign(points.size(), -1);
    std::vector<int> counted(points.size(), 0);
    std::vector<bool> seen(halfedges.size(), false);
    for (std::size_t h = 0; h < halfedges.size(); ++h) {
      leaving[halfedges[h].source] = static_cast<int>(h);
      ++counted[halfedges[h].source];
      if (seen[h]) continue;
      faces[halfedges[h].face].loops.push_back(static_cast<int>(h));
      for (int x = static_cast<int>(h); !seen[x]; x = halfedges[x].next) seen[x] = true;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      if (leaving[i] >= 0 && degree(int(i)) != counted[i])
        refuse(Error_code::not_a_manifold, "at the point " + point_text(int(i)) +
                                               " the surface touches itself; its faces must form one ring there");
  }

  std::vector<int> numbers_, group_;
  std::vector<bool> removed_;
  std::vector<Vector> normals_;
  std::vector<std::vector<int>> parts_;
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PLANAR_SOLID_H
