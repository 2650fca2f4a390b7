// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H

#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>
#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file swept_continuity.h
/// The continuity of surfaces that two profiles sweep, along the line swept by the point in which
/// the profiles join.

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
    // equivalent [2 -> 3, 1]: a derivative more, which is not used
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

// The derivatives C', C'' of a common edge and T = S_v, T' = S_uv, W = S_vv of both sides at one
// point, in a ring, as polynomials that are constant: what Edge_decision reads of Edge_sides, for
// an edge whose points are all alike.
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
  typename Edge_sides<Field>::Tangent tangent(const Vector& d) const { return typename Edge_sides<Field>::Tangent(d); }
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
/// Decides the continuity of the extrusions of two profiles in the direction `w` along their common
/// ruling, which starts where `left` ends and `right` starts. It is `edge_continuity()` of the
/// polynomial rows \f$ C = c + v w \f$, \f$ T = \mp c' \f$, \f$ W = c'' \f$, decided on the whole
/// ruling.
///
/// A profile that is \f$ G^2 \f$ gives a surface that is \f$ G^2 \f$, unless its tangent is
/// parallel to `w`. The converse is false: the surface depends on the profile as it is seen in the
/// direction `w` only, and is smooth where a crease of the profile lies in a plane with `w`.
///
/// The decision is exact with every kernel: control points are taken as they are given, and
/// otherwise the derivatives as `ParametricCurve::jet()` returns them.
/// \tparam Left, Right models of `ParametricCurve` with one traits class, in dimension 3
/// \throws Error `zero_direction`, `dimension_mismatch` unless in dimension 3, `jet_order_too_low`,
///   `not_finite`
template <class Left, class Right>
Edge_continuity<Edge_field<typename Left::Traits>>
extrusion_continuity(const Left& left, const Right& right, const typename Left::Traits::Vector& direction) {
  typedef typename Left::Traits Traits;
  typedef internal::Profile_join<Left, Right> Join;
  typedef typename Join::Field Field;
  const Join join(left, right);
  const auto w = Join::vector(internal::direction_coordinates<Traits, Field>(direction, "extrusion_continuity"));
  const auto rows = [&](const auto& x, const Field& inwards) {
    // equivalent [+ -> -, 1]: a direction and its opposite sweep the same surface
    return Edge_rows<Field>{{x[0], x[0] + w}, {inwards * x[1]}, {x[2]}};
  };
  return edge_continuity(rows(join.left, Field(-1)), rows(join.right, Field(1)));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of the surfaces that two profiles sweep by a full turn about one axis,
/// along the parallel on which `left` ends and `right` starts. The profiles may end and start at
/// different points of it.
///
/// The decision is made at one point, from the derivatives with respect to the angle:
/// \f$ C' = w \times x \f$, \f$ C'' = w \times C' \f$, \f$ T = \mp c' \f$, \f$ T' = w \times T \f$,
/// \f$ W = c'' \f$ with \f$ x = c - a \f$. One point suffices: each rotation about the axis maps
/// both surfaces to themselves, and takes this point to any other of the parallel; tangent planes
/// and curvatures go with it. In the result, intervals are [0, 1] for the whole parallel.
///
/// A profile that is \f$ G^2 \f$ gives a surface that is \f$ G^2 \f$, unless the normal vanishes.
/// The converse is false: the surface depends on the distance from the axis and the height only,
/// and is smooth where a crease of the profile lies in a plane with the tangent of the parallel. On
/// the axis the parallel is a point, and the continuity along it is undefined: the defect is
/// `collapsed`.
///
/// The decision is exact with every kernel: control points are taken as they are given, and
/// otherwise the derivatives as `ParametricCurve::jet()` returns them.
/// \tparam Left, Right models of `ParametricCurve` with one traits class, in dimension 3
/// \throws Error `zero_direction`, `dimension_mismatch` unless in dimension 3, `jet_order_too_low`,
///   `not_finite`, `work_limit`
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
    // the rotation that takes y to x: v + sin w x v + (1 - cos) w x (w x v), with w taken as a unit
    // vector
    const Field sine = dot(m, cross_product(w, my)) / (W * radius), versine = (Field(1) - dot(m, my) / radius) / W;
    for (int j = 1; j < 3; ++j) {
      const Vector wv = cross_product(w, join.right[j]);
      join.right[j] += sine * wv + versine * cross_product(w, wv);
    }
  }
  const Vector inwards = Field(-1) * join.left[1];
  const internal::Point_of_edge<Field> point(m, cross_product(w, m), {inwards, join.right[1]},
                                             cross_product(w, inwards), {join.left[2], join.right[2]});
  const internal::Work_guard work("revolution_continuity");
  Edge_continuity<Field> edge = internal::Edge_decision<Field>()(point);
  if (edge.deviation) {
    edge.deviation->begin = Field(0);
    edge.deviation->end = Field(1);
  }
  return edge;
}

/// \ingroup PkgGeometricContinuitySurfaces
/// A parameter of a profile at which the normal of its swept surface vanishes.
///
/// If neither `on_axis` nor `zero_tangent`, the profile is tangent there to the lines of the sweep:
/// parallel to the direction of an extrusion, or along a parallel of a surface of revolution.
/// \tparam FT the field in which it was decided
template <class FT> struct Sweep_defect {
  FT begin;     ///< the parameter of the profile lies between this and the next,
  FT end;       ///< it is the only one there, and it is this one if they are equal
  bool on_axis; ///< the profile meets the axis of revolution
  /// On the axis, \f$ c' \ne 0 \f$ is orthogonal to it: the surface has a tangent plane at this
  /// pole all the same.
  bool smooth_pole;
  bool zero_tangent; ///< \f$ c' = 0 \f$
  int multiplicity;  ///< how often the normal vanishes, as a polynomial in the parameter
  /// The normal has opposite directions before and after: the parameter is inside the domain and
  /// the multiplicity is odd. On the axis the surface passes through a pole, elsewhere it folds.
  bool normal_flips;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Lists all parameters of a profile at which the normal of its swept surface vanishes.
template <class FT> struct Sweep_defects {
  /// The normal vanishes everywhere: the profile is a point, lies on the axis, or is straight in
  /// the direction of extrusion.
  bool degenerate = false;
  std::vector<Sweep_defect<FT>> points; ///< in increasing order; none if `degenerate`
};

namespace internal {

// The polynomials of a Bezier profile on [0, 1], in an exact field.
template <class Traits> class Sweep_analysis {
  typedef Edge_field<Traits> Field;
  typedef typename Exact_number<Field>::type Exact;
  typedef Bernstein_polynomial<Exact> Polynomial;
  typedef Homogeneous_vector<Exact> Vector;
  typedef Power_polynomial<Exact> Power;

  const Field a_, b_; // the domain of the profile
  Vector x_;          // c minus a point

public:
  template <int Degree>
  Sweep_analysis(const Bezier_curve<Traits, Degree>& c, const Coordinate_vector<Field, dimension_v<Traits>>& origin)
      : a_(to_field<Field>(c.domain().first)),
        b_(to_field<Field>(c.domain().second)), x_{polynomial(c, origin, 0), polynomial(c, origin, 1),
                                                   polynomial(c, origin, 2)} {}

  Sweep_defects<Field> extruded(const Coordinate_vector<Field, dimension_v<Traits>>& w) const {
    const Vector d = derivative();
    const Polynomial nowhere{Exact(1)};
    return defects(cross_product(d, constant(w)), d, nowhere, nowhere);
  }

  Sweep_defects<Field> revolved(const Coordinate_vector<Field, dimension_v<Traits>>& w) const {
    const Vector d = derivative(), direction = constant(w), m = cross_product(direction, x_);
    const Power axis = common_divisor(m), height = power(scalar_product(d, direction));
    return defects(cross_product(d, m), d, simple_roots(axis), simple_roots(greatest_common_divisor(axis, height)));
  }

  std::optional<Bernstein_polynomial<Field>>
  signed_radius(const Coordinate_vector<Field, dimension_v<Traits>>& w) const {
    const Vector m = cross_product(constant(w), x_);
    std::vector<Coordinate_vector<Exact, 3>> rows(m[0].degree() + 1, Coordinate_vector<Exact, 3>(3));
    for (int i = 0; i < 3; ++i) {
      const Polynomial b = m[i].template bernstein<Exact>();
      for (int k = 0; k <= b.degree(); ++k) rows[k][i] = b[k];
    }
    const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return !is_zero(row); });
    std::vector<Field> r;
    for (const Coordinate_vector<Exact, 3>& row : rows) {
      if (first != rows.end() && !is_zero(cross_product(*first, row))) return std::nullopt;
      r.push_back(Field(first == rows.end() ? Exact(0) : dot(*first, row)));
    }
    return Bernstein_polynomial<Field>(std::move(r));
  }

private:
  static Exact exact(const Field& x) { return Exact(Exact_number<Field>::of(x)); }

  template <class Curve, class Origin>
  static Homogeneous_polynomial<Exact> polynomial(const Curve& c, const Origin& origin, int i) {
    if (c.dimension() != 3)
      throw Error(Error_code::dimension_mismatch, "sweep_defects: the profile must be in dimension 3");
    std::vector<Exact> b;
    for (const auto& p : c)
      b.push_back(exact(Field(Geometric_continuity::coordinates<Traits, Field>(p)[i] - origin[i])));
    return Homogeneous_polynomial<Exact>::from_bernstein(std::move(b));
  }

  template <class Column> static Vector constant(const Column& w) {
    Vector v;
    for (int i = 0; i < 3; ++i) v[i] = Homogeneous_polynomial<Exact>(std::vector<Exact>(1, exact(w[i])));
    return v;
  }

  Vector derivative() const { return {x_[0].derivative(), x_[1].derivative(), x_[2].derivative()}; }

  static Power power(const Homogeneous_polynomial<Exact>& p) { return Power(p.template bernstein<Exact>()); }

  // of the coordinates: it has the common roots
  static Power common_divisor(const Vector& v) {
    return greatest_common_divisor(greatest_common_divisor(power(v[0]), power(v[1])), power(v[2]));
  }

  // one, without roots, for zero
  static Polynomial simple_roots(const Power& p) {
    return p.is_zero() ? Polynomial{Exact(1)} : square_free_part(p.bernstein());
  }

  // of the normal n, where d is c', `axis` is zero on the axis, and `pole` where also c' is
  // orthogonal to it
  Sweep_defects<Field> defects(const Vector& n, const Vector& d, const Polynomial& axis, const Polynomial& pole) const {
    typedef Root_isolation<Exact> Isolation;
    Sweep_defects<Field> result;
    const Power divisor = common_divisor(n);
    result.degenerate = divisor.is_zero();
    if (result.degenerate) return result;
    const Polynomial tangent = simple_roots(common_divisor(d));
    for (const Isolated_root<Exact>& root : isolate_roots(divisor.bernstein())) {
      const bool inside = Exact(0) < root.end && root.begin < Exact(1),
                 zero_tangent = Isolation::has_root(tangent, root);
      result.points.push_back({in_domain(root.begin), in_domain(root.end), Isolation::has_root(axis, root),
                               !zero_tangent && Isolation::has_root(pole, root), zero_tangent, root.multiplicity,
                               inside && root.multiplicity % 2 == 1});
    }
    return result;
  }

  Field in_domain(const Exact& t) const { return Field(a_ + Field(t) * (b_ - a_)); }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the parameters at which the normal \f$ c' \times w \f$ of the extrusion of a Bézier curve
/// vanishes. They are the common roots of its coordinates, found exactly and with every kernel: the
/// control points are taken as they are given. The intervals have at most 1/1024 of the length of
/// the domain.
///
/// A B-spline curve or a segmented curve is analysed piece by piece.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Sweep_defects<Edge_field<Traits>> sweep_defects(const Extrusion_surface_3<Bezier_curve<Traits, Degree>>& s) {
  typedef Edge_field<Traits> Field;
  const Coordinate_vector<Field, dimension_v<Traits>> origin(3);
  return internal::Sweep_analysis<Traits>(s.profile(), origin)
      .extruded(Geometric_continuity::coordinates<Traits, Field>(s.direction()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the parameters at which the normal \f$ c' \times (w \times (c - a)) \f$ of the surface of
/// revolution of a Bézier curve vanishes: at these parameters for all angles, and at no others.
/// They are found exactly and with every kernel, in intervals of at most 1/1024 of the length of
/// the domain, as for an extrusion.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Sweep_defects<Edge_field<Traits>> sweep_defects(const Revolution_surface_3<Bezier_curve<Traits, Degree>>& s) {
  typedef Edge_field<Traits> Field;
  return internal::Sweep_analysis<Traits>(s.profile(), Geometric_continuity::coordinates<Traits, Field>(s.axis_point()))
      .revolved(Geometric_continuity::coordinates<Traits, Field>(s.axis()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the signed distance of a profile from the axis, times a positive constant, as a
/// polynomial on [0, 1], for a profile that lies in a plane through the axis; otherwise empty. Its
/// first coefficient that is not zero is positive. Where it changes its sign the profile crosses
/// the axis, and the normal of the surface flips. Decided exactly, with every kernel; its signs are
/// found by `sign_pattern()`.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
std::optional<Bernstein_polynomial<Edge_field<Traits>>>
signed_radius(const Revolution_surface_3<Bezier_curve<Traits, Degree>>& s) {
  typedef Edge_field<Traits> Field;
  return internal::Sweep_analysis<Traits>(s.profile(), Geometric_continuity::coordinates<Traits, Field>(s.axis_point()))
      .signed_radius(Geometric_continuity::coordinates<Traits, Field>(s.axis()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEPT_CONTINUITY_H
