// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/make_planar.h"

#include "formats/solids/check_closed.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

typedef CGAL::Exact_rational Exact;
typedef Solid::Point Point;

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Point& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
std::array<double, 3> to_doubles(const Point& a) {
  return {CGAL::to_double(a[0]), CGAL::to_double(a[1]), CGAL::to_double(a[2])};
}
double length(const std::array<double, 3>& a) { return std::hypot(a[0], a[1], a[2]); }

class Planar_maker {
  static constexpr double little = 1e-6; // of the size of the solid
  Solid& solid_;
  std::vector<Solid_plane> planes_;
  std::vector<std::vector<std::size_t>> faces_of_; // of each vertex

  std::string vertex_name(std::size_t v) const {
    std::ostringstream os;
    const std::array<double, 3> p = to_doubles(solid_.vertices[v]);
    os << "vertex " << v << " at (" << p[0] << ", " << p[1] << ", " << p[2] << ')';
    return os.str();
  }

  // The sum of the cross products: twice the area vector of the face.
  Point area_vector(const Solid::Face& face) const {
    Point sum{0, 0, 0};
    const Point& o = solid_.vertices[face.vertices[0]];
    for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i) {
      const Point n =
          cross(difference(solid_.vertices[face.vertices[i]], o), difference(solid_.vertices[face.vertices[i + 1]], o));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
    }
    return sum;
  }

  Point mean(const Solid::Face& face) const {
    Point sum{0, 0, 0};
    for (const std::size_t v : face.vertices)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += solid_.vertices[v][k];
    for (Exact& x : sum) x /= static_cast<int>(face.vertices.size());
    return sum;
  }

  bool is_in(const Solid_plane& plane, std::size_t vertex) const {
    return dot(plane.normal, difference(solid_.vertices[vertex], plane.point)) == 0;
  }

  void add_plane(std::size_t f, const std::optional<Solid_plane>& given) {
    const Solid::Face& face = solid_.faces[f];
    const Point normal = area_vector(face);
    if (is_zero(normal)) throw std::runtime_error(face_name(solid_, f) + ": its area is 0");
    const Solid_plane through{solid_.vertices[face.vertices[0]], normal};
    const bool is_planar =
        std::all_of(face.vertices.begin(), face.vertices.end(), [&](std::size_t v) { return is_in(through, v); });
    planes_.push_back(is_planar ? through : given ? *given : Solid_plane{mean(face), normal});
  }

  // Two faces at an edge are no two faces where they lie in one plane.
  void check_edges() const {
    std::map<std::size_t, std::size_t> face_of;
    for (std::size_t f = 0; f < solid_.faces.size(); ++f)
      for (const std::size_t e : solid_.faces[f].edges) {
        const auto [first, is_new] = face_of.emplace(e, f);
        if (is_new) continue;
        const std::array<double, 3> a = to_doubles(planes_[first->second].normal), b = to_doubles(planes_[f].normal);
        const double sine = length({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
        if (sine < little * length(a) * length(b))
          throw std::runtime_error("edge " + std::to_string(e) + ": " + face_name(solid_, first->second) + " and " +
                                   face_name(solid_, f) +
                                   " lie in one plane there: unite them first (in FreeCAD: Part, Refine shape)");
      }
  }

  void check_vertex(std::size_t v) const {
    if (faces_of_[v].size() == 2)
      throw std::runtime_error(vertex_name(v) +
                               ": it lies inside of a straight edge, which it divides into two: unite them first (in "
                               "FreeCAD: Part, Refine shape)");
  }

  // Where the planes of the faces of a vertex meet: n_i . (x - p_i) = 0 by the rule of Cramer, in
  // coordinates from the vertex as it is.
  Point meeting(std::size_t v) const {
    const std::vector<std::size_t>& f = faces_of_[v];
    if (f.size() != 3)
      throw std::runtime_error(vertex_name(v) + ": " + std::to_string(f.size()) +
                               " faces meet there, and their planes do so up to rounding only: three are expected");
    const Point& o = solid_.vertices[v];
    const Solid_plane &a = planes_[f[0]], &b = planes_[f[1]], &c = planes_[f[2]];
    const Point bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal), ab = cross(a.normal, b.normal);
    const Exact determinant = dot(a.normal, bc);
    if (determinant == 0) throw std::runtime_error(vertex_name(v) + ": the planes of its faces meet in no point");
    const Exact x = dot(a.normal, difference(a.point, o)) / determinant,
                y = dot(b.normal, difference(b.point, o)) / determinant,
                z = dot(c.normal, difference(c.point, o)) / determinant;
    Point result = o;
    for (std::size_t k = 0; k < 3; ++k) result[k] += x * bc[k] + y * ca[k] + z * ab[k];
    return result;
  }

  double size() const {
    std::array<double, 3> low = to_doubles(solid_.vertices[0]), high = low;
    for (const Point& p : solid_.vertices) {
      const std::array<double, 3> x = to_doubles(p);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], x[k]);
        high[k] = (std::max)(high[k], x[k]);
      }
    }
    return length({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }

public:
  Planar_maker(Solid& solid, const std::vector<std::optional<Solid_plane>>& planes)
      : solid_(solid), faces_of_(solid.vertices.size()) {
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
      add_plane(f, planes[f]);
      for (const std::size_t v : solid.faces[f].vertices) faces_of_[v].push_back(f);
    }
  }

  void make(double tolerance) {
    check_edges();
    const double most = (std::max)(tolerance, little * size());
    std::vector<Point> moved = solid_.vertices;
    for (std::size_t v = 0; v < moved.size(); ++v) {
      check_vertex(v);
      if (std::all_of(faces_of_[v].begin(), faces_of_[v].end(), [&](std::size_t f) { return is_in(planes_[f], v); }))
        continue;
      moved[v] = meeting(v);
      const double move = length(to_doubles(difference(moved[v], solid_.vertices[v])));
      if (!(move <= most)) {
        std::ostringstream os;
        os << vertex_name(v) << ": the planes of its faces meet in a point that is " << move << " away from it";
        throw std::runtime_error(os.str());
      }
      if (move > solid_.largest_move) {
        solid_.largest_move = move;
        solid_.most_moved = v;
      }
    }
    solid_.vertices = std::move(moved);
  }
};

} // namespace

void make_planar(Solid& solid, const std::vector<std::optional<Solid_plane>>& planes, double tolerance) {
  Planar_maker(solid, planes).make(tolerance);
}
