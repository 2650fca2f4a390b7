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
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

typedef CGAL::Exact_rational Exact;
typedef Solid::Point Point;

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point added(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
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
  static constexpr double little = 1e-6;
  Solid& solid_;
  std::vector<Solid_plane> planes_;                 // of each face
  std::vector<std::size_t> group_;                  // the face whose plane a face has, or another one of its group
  std::vector<std::vector<std::size_t>> planes_of_; // of each vertex: the faces with its planes

  std::string vertex_name(std::size_t v) const {
    std::ostringstream os;
    const std::array<double, 3> p = to_doubles(solid_.vertices[v]);
    os << "vertex " << v << " at (" << p[0] << ", " << p[1] << ", " << p[2] << ')';
    return os.str();
  }

  template <class Visit> static void for_each_vertex(const Solid::Face& face, const Visit& visit) {
    for (const Solid::Loop& loop : face.loops)
      for (const std::size_t v : loop.vertices) visit(v);
  }

  // The sum of the cross products: twice the area vector of the face.
  Point area_vector(const Solid::Face& face) const {
    Point sum{0, 0, 0};
    for (const Solid::Loop& loop : face.loops) {
      const Point& o = solid_.vertices[loop.vertices[0]];
      for (std::size_t i = 1; i + 1 < loop.vertices.size(); ++i)
        sum = added(sum, cross(difference(solid_.vertices[loop.vertices[i]], o),
                               difference(solid_.vertices[loop.vertices[i + 1]], o)));
    }
    return sum;
  }

  Point mean(const Solid::Face& face) const {
    Point sum{0, 0, 0};
    int n = 0;
    for_each_vertex(face, [&](std::size_t v) {
      sum = added(sum, solid_.vertices[v]);
      ++n;
    });
    for (Exact& x : sum) x /= n;
    return sum;
  }

  bool is_in(const Solid_plane& plane, std::size_t vertex) const {
    return dot(plane.normal, difference(solid_.vertices[vertex], plane.point)) == 0;
  }
  bool is_in(const Solid_plane& plane, const Solid::Face& face) const {
    bool result = true;
    for_each_vertex(face, [&](std::size_t v) { result = result && is_in(plane, v); });
    return result;
  }

  void add_plane(std::size_t f, const std::optional<Solid_plane>& given) {
    const Solid::Face& face = solid_.faces[f];
    const Point normal = area_vector(face);
    if (is_zero(normal)) throw std::runtime_error(face_name(solid_, f) + ": its area is 0");
    const Solid_plane through{solid_.vertices[face.loops[0].vertices[0]], normal};
    planes_.push_back(is_in(through, face) ? through : given ? *given : Solid_plane{mean(face), normal});
  }

  std::size_t representative(std::size_t face) const {
    while (group_[face] != face) face = group_[face];
    return face;
  }

  bool are_parallel(const Solid_plane& a, const Solid_plane& b) const {
    const std::array<double, 3> m = to_doubles(a.normal), n = to_doubles(b.normal);
    return length({m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2], m[0] * n[1] - m[1] * n[0]}) <
           little * length(m) * length(n);
  }

  // Finds the faces that have a plane in common.
  void unite_planes() {
    group_.resize(solid_.faces.size());
    std::iota(group_.begin(), group_.end(), std::size_t(0));
    std::map<std::size_t, std::size_t> face_of; // an edge
    for (std::size_t f = 0; f < solid_.faces.size(); ++f)
      for (const Solid::Loop& loop : solid_.faces[f].loops)
        for (const std::size_t e : loop.edges) {
          const auto [first, is_new] = face_of.emplace(e, f);
          if (!is_new && are_parallel(planes_[first->second], planes_[f]))
            group_[representative(f)] = representative(first->second);
        }
    planes_of_.resize(solid_.vertices.size());
    for (std::size_t f = 0; f < solid_.faces.size(); ++f)
      for_each_vertex(solid_.faces[f], [&](std::size_t v) {
        std::vector<std::size_t>& planes = planes_of_[v];
        if (std::find(planes.begin(), planes.end(), representative(f)) == planes.end())
          planes.push_back(representative(f));
      });
  }

  // The shortest way from a vertex to its planes is a sum of their normals n_i with factors c_i:
  // (sum of c_j n_j) . n_i = (p_i - vertex) . n_i, a linear system with a symmetric matrix.
  Point way(std::size_t v) const {
    const std::vector<std::size_t>& faces = planes_of_[v];
    const std::size_t n = faces.size();
    if (n > 3)
      throw std::runtime_error(vertex_name(v) + ": " + std::to_string(n) +
                               " planes meet there, but up to rounding only: at most three do so in one point");
    Exact system[3][4];
    for (std::size_t i = 0; i < n; ++i) {
      const Solid_plane& plane = planes_[faces[i]];
      for (std::size_t j = 0; j < n; ++j) system[i][j] = dot(plane.normal, planes_[faces[j]].normal);
      system[i][n] = dot(plane.normal, difference(plane.point, solid_.vertices[v]));
    }
    for (std::size_t i = 0; i < n; ++i) { // a positive definite matrix needs no other pivots
      if (system[i][i] == 0) throw std::runtime_error(vertex_name(v) + ": the planes of its faces meet in no point");
      for (std::size_t k = 0; k < n; ++k)
        if (k != i) {
          const Exact factor = system[k][i] / system[i][i];
          for (std::size_t j = i; j <= n; ++j) system[k][j] -= factor * system[i][j];
        }
    }
    Point sum{0, 0, 0};
    for (std::size_t i = 0; i < n; ++i) {
      const Exact c = system[i][n] / system[i][i];
      for (std::size_t k = 0; k < 3; ++k) sum[k] += c * planes_[faces[i]].normal[k];
    }
    return sum;
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
  Planar_maker(Solid& solid, const std::vector<std::optional<Solid_plane>>& planes) : solid_(solid) {
    for (std::size_t f = 0; f < solid.faces.size(); ++f) add_plane(f, planes[f]);
    unite_planes();
  }

  void make(double tolerance) {
    const double most = (std::max)(tolerance, little * size());
    for (std::size_t v = 0; v < solid_.vertices.size(); ++v) {
      if (std::all_of(planes_of_[v].begin(), planes_of_[v].end(), [&](std::size_t f) { return is_in(planes_[f], v); }))
        continue;
      const Point way = this->way(v);
      const double move = length(to_doubles(way));
      if (!(move <= most)) {
        std::ostringstream os;
        os << vertex_name(v) << ": the planes of its faces meet in a point that is " << move << " away from it";
        throw std::runtime_error(os.str());
      }
      solid_.vertices[v] = added(solid_.vertices[v], way);
      if (move > solid_.largest_move) {
        solid_.largest_move = move;
        solid_.most_moved = v;
      }
    }
  }
};

} // namespace

void make_planar(Solid& solid, const std::vector<std::optional<Solid_plane>>& planes, double tolerance) {
  Planar_maker(solid, planes).make(tolerance);
}
