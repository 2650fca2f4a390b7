// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_ARCS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_ARCS_H

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

#include <array>
#include <type_traits>
#include <vector>

/// \file arcs.h
/// Arcs of circles, ellipses and other conics as rational Bézier curves of degree 2. Everything is
/// rational: with an exact kernel each point of an arc lies on its circle exactly. Arcs of more
/// than half a circle have a negative weight in the middle, and half a circle has an infinite
/// control point there. All functions run in constant time. Points of a \cgal kernel, the first of
/// them, say what the traits class is (`Traits_of`); for others it is the first template argument,
/// `circular_arc<Traits>(…)`.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Traits> using Conic_row = typename Homogeneous_traits<Traits>::Point;

// The point x with its weight in homogeneous coordinates, where x is multiplied already.
template <class Traits>
Conic_row<Traits> conic_row(const Coordinates<Traits>& numerator, const typename Traits::FT& weight) {
  Conic_row<Traits> row(numerator.dimension() + 1);
  for (int i = 0; i < numerator.dimension(); ++i) row[i] = numerator[i];
  row[numerator.dimension()] = weight;
  return row;
}

template <class Traits>
Rational_bezier_curve<Traits, 2> conic(const Conic_row<Traits>& a, const Conic_row<Traits>& b,
                                       const Conic_row<Traits>& c) {
  return Rational_bezier_curve<Traits, 2>(
      typename Rational_bezier_curve<Traits, 2>::Homogeneous(std::array<Conic_row<Traits>, 3>{a, b, c}));
}

template <class FT, int N> FT square_of(const Coordinate_vector<FT, N>& v, const char* what) {
  const FT square = dot(v, v);
  if (square == FT(0)) throw Error(Error_code::zero_direction, what);
  return square;
}

template <class FT, int N>
void require_one_dimension(const Coordinate_vector<FT, N>& v, const Coordinate_vector<FT, N>& w, const char* place) {
  if (v.dimension() != w.dimension()) throw Error(Error_code::dimension_mismatch, place);
}

// The arc from p in the direction d to the point p + e / |e|^2. The inversion y = (x - p) / |x -
// p|^2 turns the circle into the line of the points (t e + (1-t) d) / t.
template <class Traits>
Rational_bezier_curve<Traits, 2> inverted_line(const Coordinates<Traits>& p, const Coordinates<Traits>& d,
                                               const Coordinates<Traits>& e) {
  typedef typename Traits::FT FT;
  const FT a = dot(d, d), b = dot(d, e), c = dot(e, e);
  return conic<Traits>(conic_row<Traits>(a * p, a), conic_row<Traits>(b * p + d / FT(2), b),
                       conic_row<Traits>(c * p + e, c));
}

// The components of the projection of x in the basis u, v of a plane.
template <class FT, int N>
std::array<FT, 2> components(const Coordinate_vector<FT, N>& u, const Coordinate_vector<FT, N>& v,
                             const Coordinate_vector<FT, N>& x) {
  const FT uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ux = dot(u, x), vx = dot(v, x);
  const FT determinant = FT(uu * vv - uv * uv);
  if (determinant == FT(0))
    throw Error(Error_code::singular_frame, "conic_arc: the tangent has the direction of the chord");
  return {FT((ux * vv - vx * uv) / determinant), FT((vx * uu - ux * uv) / determinant)};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns the arc \f$ c + \cos\phi\, u + \sin\phi\, v \f$,
/// \f$ 0 \le \phi \le \theta = 4 \arctan r \f$, of the ellipse with the centre `c` and the
/// conjugate half-axes `u` and `v`, in any dimension. Its weights are 1, \f$ \cos(\theta/2) \f$
/// and 1. For `r < 0` it runs in the other direction. With \f$ \rho \f$ = the rotation by
/// \f$ \theta/2 \f$, whose cosine \f$ (1-r^2)/(1+r^2) \f$ and sine \f$ 2r/(1+r^2) \f$ are rational,
/// the control points are \f$ c + u \f$, \f$ c + \rho u / \cos(\theta/2) \f$ and
/// \f$ c + \rho^2 u \f$.
/// \throws Error `dimension_mismatch`, `empty_domain` for `r == 0`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bezier_curve<Traits, 2> elliptical_arc(const Point& c, const typename Traits::Vector& u,
                                                const typename Traits::Vector& v, const typename Traits::FT& r) {
  typedef typename Traits::FT FT;
  const Coordinates<Traits> centre = internal::point_column<Traits>(c), x = internal::vector_column<Traits>(u),
                            y = internal::vector_column<Traits>(v);
  internal::require_one_dimension(centre, x, "elliptical_arc: half-axes");
  internal::require_one_dimension(centre, y, "elliptical_arc: half-axes");
  internal::check_finite(r, "elliptical_arc: r");
  if (r == FT(0)) throw Error(Error_code::empty_domain, "elliptical_arc: an arc of no length");
  const FT denominator = FT(FT(1) + r * r), cosine = FT(FT(FT(1) - r * r) / denominator),
           sine = FT(FT(FT(2) * r) / denominator);
  return internal::conic<Traits>(
      internal::conic_row<Traits>(centre + x, FT(1)),
      internal::conic_row<Traits>(cosine * (centre + x) + sine * y, cosine),
      internal::conic_row<Traits>(centre + FT(cosine * cosine - sine * sine) * x + FT(FT(2) * sine * cosine) * y,
                                  FT(1)));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the arc of the circle about `centre` in the plane from `start` by the angle
/// \f$ 4 \arctan r \f$, counterclockwise for `r > 0`: `r` is the tangent of a quarter of the angle,
/// not the angle and no radius. `r = FT(1)` is a half circle; for an angle in degrees,
/// `std::tan(degrees * CGAL_PI / 720)` is a number near it, with which every point is on the circle
/// as well. Whole numbers of type `int` are refused by the compiler, because they would be degrees
/// by mistake. See `elliptical_arc()`.
/// \throws Error `zero_direction` when `start` is the centre, `empty_domain` for `r == 0`,
///   `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bezier_curve<Traits, 2> circular_arc(const Point& centre, const typename Traits::Point& start,
                                              const typename Traits::FT& r) {
  static_assert(dimension_v<Traits> == 2, "in space, an arc has an axis");
  const Coordinates<Traits> u = internal::point_column<Traits>(start) - internal::point_column<Traits>(centre);
  internal::square_of(u, "circular_arc: the start is the centre");
  Coordinates<Traits> v(2);
  v[0] = -u[1];
  v[1] = u[0];
  return elliptical_arc<Traits>(centre, to_vector<Traits>(u), to_vector<Traits>(v), r);
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the arc in space that `start` runs through in a rotation about the axis through `centre`
/// in the direction `axis`, by the angle \f$ 4 \arctan(r |axis|) \f$: in this parameter everything
/// is rational, whatever the length of the axis. `centre` may be any point of the axis. An `r` of
/// type `int` is refused by the compiler, as in the plane.
/// \throws Error `zero_direction` when the axis is zero or `start` lies on it, `empty_domain` for
///   `r == 0`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bezier_curve<Traits, 2> circular_arc(const Point& centre, const typename Traits::Point& start,
                                              const typename Traits::Vector& axis, const typename Traits::FT& r) {
  typedef typename Traits::FT FT;
  static_assert(dimension_v<Traits> == 3, "an arc about an axis lies in space");
  internal::check_finite(r, "circular_arc: r");
  if (r == FT(0)) throw Error(Error_code::empty_domain, "circular_arc: an arc of no length");
  const Coordinates<Traits> n = internal::vector_column<Traits>(axis),
                            x = internal::point_column<Traits>(start) - internal::point_column<Traits>(centre);
  const FT length_squared = internal::square_of(n, "circular_arc: axis");
  const Coordinates<Traits> u = orthogonal_component(x, n), foot = internal::point_column<Traits>(start) - u,
                            nu = cross_product(n, u); // |axis| times the second half-axis
  internal::square_of(u, "circular_arc: the start lies on the axis");
  const FT s = FT(r * r * length_squared), denominator = FT(FT(1) + s), cosine = FT(FT(FT(1) - s) / denominator),
           sine = FT(FT(FT(2) * r) / denominator); // divided by |axis|
  return internal::conic<Traits>(
      internal::conic_row<Traits>(foot + u, FT(1)),
      internal::conic_row<Traits>(cosine * (foot + u) + sine * nu, cosine),
      internal::conic_row<Traits>(
          foot + FT(cosine * cosine - sine * sine * length_squared) * u + FT(FT(2) * sine * cosine) * nu, FT(1)));
}

// A whole number would be meant as degrees.
template <class Given = internal::Of_points, class Point = typename Given::Point, class Degrees,
          class Traits = Traits_or_of<Given, Point>, class = std::enable_if_t<std::is_integral_v<Degrees>>>
Rational_bezier_curve<Traits, 2> circular_arc(const Point& centre, const typename Traits::Point& start,
                                              Degrees r) = delete;
template <class Given = internal::Of_points, class Point = typename Given::Point, class Degrees,
          class Traits = Traits_or_of<Given, Point>, class = std::enable_if_t<std::is_integral_v<Degrees>>>
Rational_bezier_curve<Traits, 2> circular_arc(const Point& centre, const typename Traits::Point& start,
                                              const typename Traits::Vector& axis, Degrees r) = delete;

// This refuses a radius and two angles, which other libraries take.
template <class Given = internal::Of_points, class Point = typename Given::Point, class Number,
          class Traits = Traits_or_of<Given, Point>, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
Rational_bezier_curve<Traits, 2> circular_arc(const Point&, Number, const typename Traits::FT&,
                                              const typename Traits::FT&) {
  static_assert(!std::is_same_v<Number, Number>,
                "circular_arc takes the centre, the start point and the tangent of a quarter of the angle, as in "
                "circular_arc(centre, start, std::tan(angle / 4)), where others take a radius and two angles");
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the arc of a circle from `p` to `r` through `q`, which is its point at the parameter
/// 1/2, in any dimension; where `q` lies between `p` and `r` on their line, the segment.
/// \throws Error `zero_direction` when two points are equal, `zero_weight` when `q` lies on the
///   line through `p` and `r` but not between them, `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bezier_curve<Traits, 2> circular_arc_through(const Point& p, const typename Traits::Point& q,
                                                      const typename Traits::Point& r) {
  const Coordinates<Traits> a = internal::point_column<Traits>(p), b = internal::point_column<Traits>(q),
                            c = internal::point_column<Traits>(r);
  internal::require_one_dimension(a, b, "circular_arc_through");
  internal::require_one_dimension(a, c, "circular_arc_through");
  const char* equal = "circular_arc_through: two of the three points are equal";
  internal::square_of(c - b, equal);
  const Coordinates<Traits> d = (b - a) / internal::square_of(b - a, equal),
                            e = (c - a) / internal::square_of(c - a, equal);
  return internal::inverted_line<Traits>(a, d - e, e);
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the arc of a circle that starts at `p` in the direction `tangent` and ends at `r`, in
/// any dimension; a segment where the tangent points to `r`.
/// \throws Error `zero_direction` when the tangent is zero or the points are equal, `zero_weight`
///   when the tangent points away from `r`, `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bezier_curve<Traits, 2> circular_arc_with_tangent(const Point& p, const typename Traits::Vector& tangent,
                                                           const typename Traits::Point& r) {
  const Coordinates<Traits> a = internal::point_column<Traits>(p), d = internal::vector_column<Traits>(tangent),
                            c = internal::point_column<Traits>(r);
  internal::require_one_dimension(a, d, "circular_arc_with_tangent");
  internal::require_one_dimension(a, c, "circular_arc_with_tangent");
  const Coordinates<Traits> e = (c - a) / internal::square_of(c - a, "circular_arc_with_tangent: the points are equal");
  internal::square_of(d, "circular_arc_with_tangent: the tangent is zero");
  return internal::inverted_line<Traits>(a, d, e);
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the arc of a conic from `p` to `r` through `q`, which is its point at the parameter 1/2,
/// with tangents along the lines of the directions `tangent_p` and `tangent_r` at its ends: an
/// ellipse, a parabola or a hyperbola. In space the second tangent and `q` are taken in the plane
/// of `p`, `r` and the first tangent, onto which they are projected. Parallel tangents give a half
/// ellipse.
/// \throws Error `zero_direction` when a tangent is zero, `singular_frame` when `p`, `r` and the
///   point where the tangents meet lie on one line, `zero_weight` when no finite arc runs through
///   `q`, `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bezier_curve<Traits, 2> conic_arc(const Point& p, const typename Traits::Vector& tangent_p,
                                           const typename Traits::Point& r, const typename Traits::Vector& tangent_r,
                                           const typename Traits::Point& q) {
  typedef typename Traits::FT FT;
  const Coordinates<Traits> a = internal::point_column<Traits>(p), c = internal::point_column<Traits>(r),
                            d = internal::vector_column<Traits>(tangent_p),
                            e = internal::vector_column<Traits>(tangent_r), chord = c - a;
  for (const Coordinates<Traits>* x : {&c, &d, &e}) internal::require_one_dimension(a, *x, "conic_arc");
  internal::require_one_dimension(a, internal::point_column<Traits>(q), "conic_arc");
  internal::square_of(d, "conic_arc: tangent at the start");
  internal::square_of(e, "conic_arc: tangent at the end");
  // in the basis chord, d: the second tangent is (ex, ey), and meets the first one at ex != 0
  const std::array<FT, 2> second = internal::components(chord, d, e),
                          through = internal::components(chord, d, internal::point_column<Traits>(q) - a);
  const bool parallel = second[0] == FT(0);
  const FT apex = parallel ? FT(1) : FT(-second[1] / second[0]); // a + apex d, or the direction d
  if (apex == FT(0)) throw Error(Error_code::singular_frame, "conic_arc: the tangents meet on the chord");
  const FT middle = FT(through[1] / apex), end = through[0], start = FT(FT(1) - end - (parallel ? FT(0) : middle));
  const FT w = parallel ? FT(0) : FT(FT(2) * middle); // barycentric coordinates times 4, 2, 4
  return internal::conic<Traits>(internal::conic_row<Traits>(FT(FT(4) * start) * a, FT(FT(4) * start)),
                                 internal::conic_row<Traits>(w * a + FT(FT(2) * through[1]) * d, w),
                                 internal::conic_row<Traits>(FT(FT(4) * end) * c, FT(FT(4) * end)));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the ellipse with the centre `c` and the conjugate half-axes `u` and `v` as a closed
/// rational B-spline curve of degree 2 on [0, 4]: four quarters with the weights 1, 1, 2 and 2, 1,
/// 1 in turn. It is \f$ G^\infty \f$ everywhere, and \f$ C^1 \f$ at its knots. With orthogonal
/// half-axes of one length it is a circle.
/// \throws Error `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bspline_curve<Traits> ellipse(const Point& c, const typename Traits::Vector& u,
                                       const typename Traits::Vector& v) {
  typedef typename Traits::FT FT;
  const Coordinates<Traits> centre = internal::point_column<Traits>(c), x = internal::vector_column<Traits>(u),
                            y = internal::vector_column<Traits>(v);
  internal::require_one_dimension(centre, x, "ellipse: half-axes");
  internal::require_one_dimension(centre, y, "ellipse: half-axes");
  std::vector<typename Traits::Point> points;
  std::vector<FT> weights;
  const int cosine[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, sine[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  for (int i = 0; i < 9; ++i) {
    points.push_back(to_point<Traits>(centre + FT(cosine[i]) * x + FT(sine[i]) * y));
    weights.push_back(FT(i % 4 == 2 ? 2 : 1));
  }
  const std::vector<typename Knot_vector<FT>::Knot> inner = {{FT(1), 2}, {FT(2), 2}, {FT(3), 2}};
  return Rational_bspline_curve<Traits>(points.begin(), points.end(), weights.begin(), weights.end(),
                                        Knot_vector<FT>(2, FT(0), FT(4), inner));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_ARCS_H
