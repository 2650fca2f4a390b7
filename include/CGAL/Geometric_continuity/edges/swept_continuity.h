// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>

#include <type_traits>
#include <vector>

/// \file swept_continuity.h
/// The continuity of surfaces that two profiles sweep, along the line swept by the point in which the profiles join.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The 2-jets, in an exact field, of two profiles at their join.
template <class Left, class Right> struct Profile_join {
  typedef typename Left::Traits Traits;
  static_assert(std::is_same_v<Traits, typename Right::Traits>, "both profiles must have the same traits class");
  typedef Edge_field<Traits> Field;
  typedef Coordinate_vector<Field, 3> Vector;

  Vector left[3], right[3];

  Profile_join(const Left& l, const Right& r) {
    take(end_jet<Field>(l, 2), left);
    take(start_jet<Field>(r, 2), right);
  }

  template <class Column> static Vector vector(const Column& x) {
    Vector v(3);
    for (int i = 0; i < 3; ++i) v[i] = x[i];
    return v;
  }

private:
  template <class Jet> static void take(const Jet& jet, Vector* x) {
    require_space_jet(jet, 2, "continuity of swept surfaces: a profile");
    for (int j = 0; j < 3; ++j) x[j] = vector(jet[j]);
  }
};

// The derivatives C', C'' of a common edge and T = S_v, T' = S_uv, W = S_vv of both sides at one point, in a ring, as
// polynomials that are constant: what Edge_decision reads of Edge_sides, for an edge whose points are all alike.
template <class Field> class Point_of_edge {
  typedef Coordinate_vector<Field, 3> Column;
  typedef typename Edge_sides<Field>::Polynomial Polynomial;
  typedef typename Edge_sides<Field>::Vector Vector;

  Common_denominator<Field> denominator_;
  Vector c1_, c2_, t1_;

public:
  Vector t[2], w[2];

  Point_of_edge(const Column& c1, const Column& c2, const Column (&cross)[2], const Column& mixed,
                const Column (&second_cross)[2]) {
    for (const Column* x : {&c1, &c2, &cross[0], &cross[1], &mixed, &second_cross[0], &second_cross[1]})
      for (const Field& y : *x) denominator_.include(y);
    c1_ = constant(c1);
    c2_ = constant(c2);
    t1_ = constant(mixed);
    for (int side = 0; side < 2; ++side) {
      t[side] = constant(cross[side]);
      w[side] = constant(second_cross[side]);
    }
  }

  bool collapsed() const { return Edge_sides<Field>::is_zero(c1_); }
  const Vector& first_derivative() const { return c1_; }
  const Vector& second_derivative() const { return c2_; }
  const Vector& mixed_derivative() const { return t1_; }

private:
  Vector constant(const Column& x) const {
    const auto number = [&](int i) {
      return Polynomial(std::vector<typename Polynomial::NT>(1, denominator_.numerator(x[i])));
    };
    return {number(0), number(1), number(2)};
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of the extrusions of two profiles in the direction `w` along their common ruling, which starts where
/// `left` ends and `right` starts. It is `edge_continuity()` of the polynomial rows \f$ C = c + v w \f$, \f$ T = \mp c' \f$,
/// \f$ W = c'' \f$, decided on the whole ruling.
///
/// A profile that is \f$ G^2 \f$ gives a surface that is \f$ G^2 \f$, unless its tangent is parallel to `w`. The converse is
/// false: the surface depends on the profile as it is seen in the direction `w` only, and is smooth where a crease of the
/// profile lies in a plane with `w`.
///
/// The decision is exact with every kernel: control points are taken as they are given, and otherwise the derivatives as
/// `ParametricCurve::jet()` returns them.
/// \tparam Left, Right models of `ParametricCurve` with one traits class, in dimension 3
/// \throws Error `zero_direction`, `dimension_mismatch` unless in dimension 3, `jet_order_too_low`, `not_finite`
template <class Left, class Right>
Edge_continuity<Edge_field<typename Left::Traits>>
extrusion_continuity(const Left& left, const Right& right, const typename Left::Traits::Vector& direction) {
  typedef typename Left::Traits Traits;
  typedef internal::Profile_join<Left, Right> Join;
  typedef typename Join::Field Field;
  const Join join(left, right);
  const auto w = Join::vector(internal::direction_coordinates<Traits, Field>(direction, "extrusion_continuity"));
  const auto rows = [&](const auto& x, const Field& inwards) {
    return Edge_rows<Field>{{x[0], x[0] + w}, {inwards * x[1]}, {x[2]}};
  };
  return edge_continuity(rows(join.left, Field(-1)), rows(join.right, Field(1)));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of the surfaces that two profiles sweep by a full turn about one axis, along the parallel on which
/// `left` ends and `right` starts. The profiles may end and start at different points of it.
///
/// The decision is made at one point, from the derivatives with respect to the angle: \f$ C' = w \times x \f$,
/// \f$ C'' = w \times C' \f$, \f$ T = \mp c' \f$, \f$ T' = w \times T \f$, \f$ W = c'' \f$ with \f$ x = c - a \f$. One point
/// suffices: each rotation about the axis maps both surfaces to themselves, and takes this point to any other of the parallel;
/// tangent planes and curvatures go with it. In the result, intervals are [0, 1] for the whole parallel.
///
/// A profile that is \f$ G^2 \f$ gives a surface that is \f$ G^2 \f$, unless the normal vanishes. The converse is false: the
/// surface depends on the distance from the axis and the height only, and is smooth where a crease of the profile lies in a
/// plane with the tangent of the parallel. On the axis the parallel is a point, and the continuity along it is undefined: the
/// defect is `collapsed`.
///
/// The decision is exact with every kernel: control points are taken as they are given, and otherwise the derivatives as
/// `ParametricCurve::jet()` returns them.
/// \tparam Left, Right models of `ParametricCurve` with one traits class, in dimension 3
/// \throws Error `zero_direction`, `dimension_mismatch` unless in dimension 3, `jet_order_too_low`, `not_finite`,
///   `work_limit`
template <class Left, class Right>
Edge_continuity<Edge_field<typename Left::Traits>> revolution_continuity(const Left& left, const Right& right,
                                                                         const typename Left::Traits::Point& axis_point,
                                                                         const typename Left::Traits::Vector& axis) {
  typedef typename Left::Traits Traits;
  typedef internal::Profile_join<Left, Right> Join;
  typedef typename Join::Field Field;
  typedef typename Join::Vector Vector;
  Join join(left, right);
  const Vector a = Join::vector(
                   internal::space_coordinates<Traits, Field>(axis_point, "revolution_continuity: point on the axis")),
               w = Join::vector(internal::direction_coordinates<Traits, Field>(axis, "revolution_continuity: axis"));
  const Vector x = join.left[0] - a, y = join.right[0] - a, m = cross_product(w, x), my = cross_product(w, y);
  const Field radius = dot(m, m), W = dot(w, w);
  if (dot(w, x) != dot(w, y) || radius != dot(my, my)) return {}; // different parallels
  if (radius != Field(0)) {
    // the rotation that takes y to x: v + sin w x v + (1 - cos) w x (w x v), with w taken as a unit vector
    const Field sine = dot(m, cross_product(w, my)) / (W * radius), versine = (Field(1) - dot(m, my) / radius) / W;
    for (int j = 1; j < 3; ++j) {
      const Vector wv = cross_product(w, join.right[j]);
      join.right[j] += sine * wv + versine * cross_product(w, wv);
    }
  }
  const Vector inwards = Field(-1) * join.left[1];
  const internal::Point_of_edge<Field> point(m, cross_product(w, m), {inwards, join.right[1]},
                                             cross_product(w, inwards), {join.left[2], join.right[2]});
  const internal::Work_on_object work("revolution_continuity");
  Edge_continuity<Field> edge = internal::Edge_decision<Field>()(point);
  if (edge.deviation) {
    edge.deviation->begin = Field(0);
    edge.deviation->end = Field(1);
  }
  return edge;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H
