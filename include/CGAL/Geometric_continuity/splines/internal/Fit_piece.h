// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_PIECE_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_PIECE_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

// A Bezier curve near some segments of a polyline, and the proof that it is near.
//
// x and p run monotonically along both, over [t0, t1] and along a segment at one time. There x is a
// Bezier curve, and so is x - p, which is not larger than the largest of its control points. So no
// point of either is farther from the other than that, nor is it the distance of Frechet.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The degree is 3, or 5 where second derivatives are taken at the ends.
template <int N, int degree> class Fit_piece {
  static constexpr int free_points = (degree - 1) / 2, most_halvings = 40;

public:
  typedef Coordinate_vector<double, N> Vector;

  std::array<Vector, degree + 1> points;
  std::vector<Vector> polyline;   // its vertices, from the start of the piece to its end
  std::vector<double> parameters; // of these
  // A point of the segment that ends at the vertex of this number, and its parameter.
  struct Division {
    std::size_t segment;
    double parameter;
    Vector point;
  };
  std::vector<Division> divisions; // in order

  // The Bernstein polynomials, in the order of the points
  static std::array<double, degree + 1> bernstein(double t) {
    const double u = 1 - t;
    if constexpr (degree == 3)
      return {u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t};
    else
      return {u * u * u * u * u,      5 * u * u * u * u * t, 10 * u * u * u * t * t,
              10 * u * u * t * t * t, 5 * u * t * t * t * t, t * t * t * t * t};
  }
  // x(t) - p, x'(t)
  std::array<Vector, 2> offset(double t, const Vector& p) const {
    std::array<Vector, degree + 1> b = points;
    for (int m = degree; m > 1; --m)
      for (int i = 0; i < m; ++i) b[i] += t * (b[i + 1] - b[i]);
    const Vector difference = b[1] - b[0];
    return {b[0] + t * difference - p, double(degree) * difference};
  }
  // The parameter of the point that is next to p, nearer than t.
  double projected(double t, const Vector& p) const {
    const std::array<Vector, 2> x = offset(t, p);
    const double square = dot(x[1], x[1]);
    // unreachable: protects a division: a piece stops by chance only
    return square > 0 ? t - dot(x[0], x[1]) / square : t;
  }

  // Returns whether the piece is near its polyline; if so, `worst` is at least the square of its
  // distance. Adds where it has divided segments to `divided`. A proof by intervals begins with the
  // divisions of the search, because where a curve is slow rounding decides about these.
  template <class NT>
  bool is_near(double squared_tolerance, double& worst, std::vector<Division>* divided = nullptr) const {
    Points_of<NT> b; // from the first one, which is the origin: small numbers have small errors
    const Vector_of<NT> origin = over<NT>(points[0]);
    for (int i = 0; i <= degree; ++i) b[i] = over<NT>(points[i]) - origin;
    Place<NT> from = place<NT>(b, 0, over<NT>(polyline[0]) - origin);
    auto next = divisions.begin();
    for (std::size_t k = 1; k < parameters.size();) {
      const bool is_division = next != divisions.end() && next->segment == k;
      Place<NT> to = is_division ? place<NT>(b, next->parameter, over<NT>(next->point) - origin)
                                 : place<NT>(b, parameters[k], over<NT>(polyline[k]) - origin);
      const std::size_t before = divided ? divided->size() : 0;
      if (!near_segment(b, from, to, squared_tolerance, worst, 0, divided)) return false;
      for (std::size_t i = before; divided && i < divided->size(); ++i) (*divided)[i].segment = k;
      from = std::move(to);
      if (is_division)
        ++next;
      else
        ++k;
    }
    return true;
  }

private:
  template <class NT> using Vector_of = Coordinate_vector<NT, N>;
  template <class NT> using Points_of = std::array<Vector_of<NT>, degree + 1>;

  static double upper(double x) { return x; }
  static double upper(const Interval_nt<false>& x) { return x.sup(); }

  template <class NT> static Vector_of<NT> over(const Vector& v) {
    if constexpr (std::is_same_v<NT, double>)
      return v;
    else {
      Vector_of<NT> r(v.dimension());
      for (int x = 0; x < v.dimension(); ++x) r[x] = NT(v[x]);
      return r;
    }
  }

  // Point and derivatives, as many as there are free points, at a parameter: as differences of
  // control points.
  template <class NT> struct Place {
    double t;
    std::array<Vector_of<NT>, free_points + 1> x;
    Vector_of<NT> p; // the point of the polyline
  };
  template <class NT> static Place<NT> place(Points_of<NT> b, double t, const Vector_of<NT>& p) {
    const NT at(t);
    const auto step = [&](int m) {
      for (int i = 0; i < m; ++i) b[i] += at * (b[i + 1] - b[i]);
    };
    for (int m = degree; m > free_points; --m) step(m);
    Place<NT> result{t, {}, p};
    if constexpr (free_points == 2) {
      result.x[2] = NT(degree * (degree - 1)) * (b[2] - b[1] - (b[1] - b[0]));
      step(2);
    }
    result.x[1] = NT(degree) * (b[1] - b[0]);
    step(1);
    result.x[0] = b[0];
    return result;
  }

  template <class NT>
  bool near_segment(const Points_of<NT>& b, const Place<NT>& from, const Place<NT>& to, double squared_tolerance,
                    double& worst, int halvings, std::vector<Division>* divided) const {
    const NT h = NT(to.t) - NT(from.t);
    double gap = 0;
    for (int i = 0; i <= free_points; ++i)
      for (const int sign : {1, -1}) {
        const Place<NT>&at = sign == 1 ? from : to, &other = sign == 1 ? to : from;
        const NT part = NT(i) / NT(degree), step = NT(sign) * h * part;
        Vector_of<NT> d = at.x[0] + step * at.x[1] - (at.p + part * (other.p - at.p));
        if constexpr (free_points == 2)
          if (i == 2) d += (h * h / NT(degree * (degree - 1))) * at.x[2];
        const double square = upper(dot(d, d));
        if (i == 0 && !(square <= squared_tolerance)) return false;
        gap = (std::max)(gap, square);
      }
    constexpr int refinements = std::is_same_v<NT, double> ? 0 : 4; // for a close bound
    const bool suffices = gap <= squared_tolerance;
    if (suffices && (gap <= worst || halvings >= refinements)) {
      worst = (std::max)(worst, gap);
      return true;
    }
    if (halvings == most_halvings) return false;
    const Vector_of<NT> middle = (from.p + to.p) / NT(2);
    Vector p = points[0];
    for (int x = 0; x < p.dimension(); ++x) p[x] += upper(middle[x]);
    const Place<NT> between = place<NT>(b, parameter_between(from.t, to.t, p), middle);
    double of_halves = worst;
    const auto divide = [&] {
      if (divided) divided->push_back({0, between.t, p});
      return true;
    };
    const bool halves = near_segment(b, from, between, squared_tolerance, of_halves, halvings + 1, divided) &&
                        divide() && near_segment(b, between, to, squared_tolerance, of_halves, halvings + 1, divided);
    if (halves || suffices) worst = halves ? of_halves : (std::max)(worst, gap);
    return halves || suffices;
  }

  // As projected(), again and again, between two parameters, also where the curve is slow: a step
  // that leaves the interval halves it.
  double parameter_between(double low, double high, const Vector& p) const {
    double t = low + (high - low) / 2;
    for (int repetition = 0; repetition < 40; ++repetition) {
      const std::array<Vector, 2> x = offset(t, p);
      // unreachable: protects a division: a piece stops by chance only
      const double slope = dot(x[0], x[1]), square = dot(x[1], x[1]), next = square > 0 ? t - slope / square : low;
      if (std::abs(next - t) <= 1e-9 * t) return (std::min)((std::max)(next, low), high);
      (slope > 0 ? high : low) = t;
      t = low < next && next < high ? next : low + (high - low) / 2;
    }
    return t;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_PIECE_H
