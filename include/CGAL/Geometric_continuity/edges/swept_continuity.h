// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/patch_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>

#include <type_traits>
#include <vector>

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

// The second-order conditions of Edge_conditions at one point of a common edge, from the derivatives C', C'' of the edge and
// T = S_v, T' = S_uv, W = S_vv of both sides.
template <class Field> struct Point_of_edge {
  typedef Coordinate_vector<Field, 3> Vector;
  Vector c1, c2, t[2], t1, w[2]; // t1 is T' of the first side

  // The decision for all points of the edge, if all are alike.
  Edge_continuity<Field> operator()() const {
    Edge_continuity<Field> edge;
    edge.g_order = 0;
    const Vector n1 = cross_product(c1, t[0]), n2 = cross_product(c1, t[1]);
    const Field det = dot(n1, t[1]), side = dot(n1, n2);
    edge.collapsed = is_zero(c1);
    edge.coplanar = det == Field(0);
    Sign_set sign;
    sign.add(internal::sign_of(side));
    edge.side = sign.pattern();
    edge.normal_vanishes = is_zero(n1) || is_zero(n2);
    if (edge.collapsed) {
      edge.defect = Edge_defect::collapsed;
      return edge;
    }
    if (edge.normal_vanishes) {
      edge.vanishing = std::pair<Field, Field>(Field(0), Field(1));
      edge.defect = Edge_defect::vanishing_normal;
      return edge;
    }
    edge.defect = !edge.coplanar ? Edge_defect::crease : Field(0) < side ? Edge_defect::fold : Edge_defect::curvature;
    const Field square = det * det * dot(c1, c1) / (dot(n1, n1) * dot(n2, n2)); // sin^2 of the angle of the normals
    const Field measure = Field(0) < side ? Field(Field(2) - square) : square;
    edge.deviation = Normal_deviation<Field>{measure, measure, Field(0), Field(1)};
    if (edge.defect == Edge_defect::curvature) {
      edge.g_order = 1;
      if (second_order(n1, n2)) {
        edge.g_order = 2;
        edge.defect = Edge_defect::none;
      }
    }
    return edge;
  }

private:
  // N_i^2 (N . W2) = n3_i^2 (N . C'') + 2 n3_i n2_i (N . T1') + n2_i^2 (N . W1), N = n1, n3 = T2 x T1, for one N_i != 0
  bool second_order(const Vector& n1, const Vector& n2) const {
    const Vector n3 = cross_product(t[1], t[0]);
    int i = 0;
    while (n1[i] == Field(0)) ++i;
    const Field left = n1[i] * n1[i] * dot(n1, w[1]);
    const Field right =
        n3[i] * n3[i] * dot(n1, c2) + Field(2) * n3[i] * n2[i] * dot(n1, t1) + n2[i] * n2[i] * dot(n1, w[0]);
    return left == right;
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
/// \throws Error `zero_direction`, `dimension_mismatch` unless in dimension 3, `jet_order_too_low`, `not_finite`
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
  return internal::Point_of_edge<Field>{
      m, cross_product(w, m), {inwards, join.right[1]}, cross_product(w, inwards), {join.left[2], join.right[2]}}();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H
