// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_PATH_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_PATH_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// A polyline to which curves are fitted, by arc length, and the joints of these curves: points,
// tangents and curvatures near its vertices. In floating-point numbers, in a unit of which all
// coordinates are multiples. See splines/internal/Polyline_fit.h.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <int N> struct Fit_joint { Coordinate_vector<double, N> point, difference, second_difference; };

// A point on a polyline: a vertex, or a part of the segment behind it, less than 1.
struct Fit_place {
  int vertex;
  double part;
  bool operator<(const Fit_place& other) const {
    return vertex < other.vertex || (vertex == other.vertex && part < other.part);
  }
};

// On which sides of a vertex the polyline counts.
enum class Fit_side { both, before, after };

template <int N> class Fit_path {
public:
  typedef Coordinate_vector<double, N> Vector;

private:
  typedef Fit_joint<N> Joint;
  typedef Fit_side Side;
  static constexpr std::size_t most_joints = 6;

  const std::vector<Vector>& p_;  // no two neighbours are equal
  const std::vector<char>& stop_; // whether there is a corner or an end
  const double tolerance_;
  const bool periodic_;   // the last vertex is the first one, and no corner
  std::vector<double> s_; // arc lengths
  std::vector<int> stop_before_, stop_after_;

public:
  Fit_path(const std::vector<Vector>& p, const std::vector<char>& stop, double tolerance, bool periodic)
      : p_(p), stop_(stop), tolerance_(tolerance), periodic_(periodic), s_(p.size(), 0), stop_before_(p.size(), 0),
        stop_after_(p.size(), static_cast<int>(p.size()) - 1) {
    const int n = segments();
    for (int k = 1; k <= n; ++k) {
      s_[k] = s_[k - 1] + length(p[k] - p[k - 1]);
      stop_before_[k] = stop_[k - 1] ? k - 1 : stop_before_[k - 1];
    }
    for (int k = n - 1; k >= 0; --k) stop_after_[k] = stop_[k + 1] ? k + 1 : stop_after_[k + 1];
  }

  int segments() const { return static_cast<int>(p_.size()) - 1; }
  const Vector& vertex(int k) const { return p_[k]; }
  double arc_length(int k) const { return s_[k]; } // up to the vertex k
  double arc_length(const Fit_place& x) const {
    return x.part == 0 ? s_[x.vertex] : s_[x.vertex] + x.part * (s_[x.vertex + 1] - s_[x.vertex]);
  }
  Vector point(const Fit_place& x) const {
    return x.part == 0 ? p_[x.vertex] : Vector(p_[x.vertex] + x.part * (p_[x.vertex + 1] - p_[x.vertex]));
  }
  bool stops(int k) const { return stop_[k] != 0; }
  int stop_after(int k) const { return stop_after_[k]; }
  bool is_periodic() const { return periodic_; }
  double tolerance() const { return tolerance_; }

  static double length(const Vector& v) { return std::sqrt(dot(v, v)); }

  // The point at an arc length; beyond an end this end, where the polyline is not periodic.
  Vector point_at(double s) const {
    if (periodic_) s -= std::floor(s / s_.back()) * s_.back();
    const int k = vertex_after(s) - 1;
    const double h = s_[k + 1] - s_[k], t = h > 0 ? (std::min)((std::max)((s - s_[k]) / h, 0.), 1.) : 0;
    return p_[k] + t * (p_[k + 1] - p_[k]);
  }

  // The first vertex that is farther along than that, or the last one.
  int vertex_after(double s) const {
    return static_cast<int>(std::upper_bound(s_.begin() + 1, s_.end() - 1, s) - s_.begin());
  }

  // The place between two vertices that is next to a point, on one of some segments about an arc
  // length.
  Fit_place place_near(const Vector& x, double s, int first, int last) const {
    const int about = vertex_after(s);
    Fit_place best{first, 0};
    double least = std::numeric_limits<double>::infinity();
    for (int k = (std::max)(first, about - 4); k <= (std::min)(last - 1, about + 3); ++k) {
      const Vector u = p_[k + 1] - p_[k];
      const double square = dot(u, u), part = (std::min)((std::max)(dot(x - p_[k], u) / square, 0.), 1.);
      const double d = length(p_[k] + part * u - x);
      if (!(d < least)) continue;
      least = d;
      best = part < 1 ? Fit_place{k, part} : Fit_place{k + 1, 0};
    }
    return best;
  }

  // Joints at a vertex, the most trusted one first: of the cubic polynomials on windows, each twice
  // as wide as the one before it, that are near. Those with the smallest residual for their width
  // are the surest of the tangent. The second difference is that of a curve of this degree.
  std::vector<Joint> joints(int k, Side side, int degree) const {
    const int n = segments(), before = k == 0 && periodic_ ? n : k;
    // differences of arc lengths may be rounded to zero
    const double length_before = before > 0 ? length(p_[before] - p_[before - 1]) : 0,
                 length_after = k < n ? length(p_[k + 1] - p_[k]) : 0;
    double w = side == Side::before  ? length_before
               : side == Side::after ? length_after
                                     : (std::min)(length_before, length_after),
           limit = side == Side::before  ? s_[k] - s_[stop_before_[k]]
                   : side == Side::after ? s_[stop_after_[k]] - s_[k]
                                         // equivalent [min -> max, 1]: a window that reaches
                                         //   beyond a corner is near only where the corner is not
                                         //   seen
                                         : (std::min)(s_[k] - s_[stop_before_[k]], s_[stop_after_[k]] - s_[k]);
    if (periodic_) limit = s_.back() / 2;
    std::vector<std::pair<double, Joint>> found; // by the error of the tangent
    for (w = (std::min)((std::max)(w, tolerance_ / 4), limit);; w = (std::min)(2 * w, limit)) {
      const Window next = window(k, w, side);
      // equivalent [16 -> 17, 1]: wider windows are still farther
      if (!(next.residual <= 16 * tolerance_)) break;
      const double speed = length(next.c[1]), difference = this->difference(4 * w, degree);
      if (next.residual <= 0.75 * tolerance_ && speed > w / 16) {
        const Vector normal = next.c[2] - (dot(next.c[2], next.c[1]) / (speed * speed)) * next.c[1];
        const double curvature = 2 * difference * difference / (speed * speed) * degree / (degree - 1);
        found.emplace_back(
            (next.residual + tolerance_ / 20) / w,
            Joint{rounded(p_[k] + next.c[0]), rounded((difference / speed) * next.c[1]), rounded(curvature * normal)});
      }
      if (w == limit) break;
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Joint> result;
    for (const auto& [error, joint] : found)
      if (result.size() < most_joints) result.push_back(joint);
    if (!result.empty()) return result;
    // in a zigzag, or where the polyline turns back
    Vector direction(p_[k].dimension());
    // unreachable: at an end the first window is a segment, which does not turn back
    if (before > 0 && side != Side::after) direction += (p_[before] - p_[before - 1]) / length_before;
    // unreachable: at an end the first window is a segment, which does not turn back
    if (k < n && side != Side::before) direction += (p_[k + 1] - p_[k]) / length_after;
    double d = length(direction);
    const double difference = (std::max)(tolerance_ / 16, 64.);
    if (!(d > 1e-7)) {
      direction = p_[before] - p_[before - 1];
      d = length_before;
    }
    result.push_back({rounded(p_[k]), rounded((difference / d) * direction), Vector(p_[k].dimension())});
    return result;
  }

  static Vector rounded(Vector v) {
    for (int x = 0; x < v.dimension(); ++x) v[x] = std::nearbyint(v[x]);
    return v;
  }

  // How long the difference of a joint is, from how long pieces are: of the longest error by
  // rounding it (times the square of a multiple, for second differences) and of that by rounding
  // multiples, the larger one is least; and so long that the first one is small next to the
  // tolerance.
  double difference(double length, int degree) const {
    const double balanced = degree == 3 ? 2 * std::sqrt(length) : 0.6 * std::cbrt(length * length);
    return (std::max)({balanced, 4 * length / tolerance_, 64.});
  }

private:
  // A cubic polynomial near a window of the polyline, in a parameter that is 0 at the vertex and 1
  // at the end of the window.
  struct Window {
    std::array<Vector, 4> c;
    double residual; // the largest one
  };
  // By least squares; at a corner or an end through the vertex.
  Window window(int k, double w, Side side) const {
    constexpr int half = 8;
    const int from = side == Side::after ? 0 : -half, to = side == Side::before ? 0 : half,
              least = side == Side::both ? 0 : 1;
    std::vector<Vector> x;
    std::array<std::array<double, 4>, 4> a{};
    std::array<Vector, 4> b;
    b.fill(Vector(p_[k].dimension()));
    for (int i = from; i <= to; ++i) {
      const double t = i / double(half);
      x.push_back(point_at(s_[k] + t * w) - p_[k]);
      const std::array<double, 4> power = {1, t, t * t, t * t * t};
      for (int r = least; r < 4; ++r) {
        for (int c = least; c < 4; ++c) a[r][c] += power[r] * power[c];
        b[r] += power[r] * x.back();
      }
    }
    if (least == 1) a[0][0] = 1;
    Window result{{}, 0};
    result.c.fill(Vector(p_[k].dimension()));
    for (int d = 0; d < p_[k].dimension(); ++d) {
      const std::array<double, 4> c =
          solve_positive_definite(a, std::array<double, 4>{b[0][d], b[1][d], b[2][d], b[3][d]});
      for (int r = least; r < 4; ++r) result.c[r][d] = c[r];
    }
    for (int i = from; i <= to; ++i) {
      const double t = i / double(half);
      const Vector e = result.c[0] + t * (result.c[1] + t * (result.c[2] + t * result.c[3])) - x[i - from];
      result.residual = (std::max)(result.residual, length(e));
    }
    return result;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_PATH_H
