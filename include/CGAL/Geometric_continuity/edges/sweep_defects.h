// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEEP_DEFECTS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEEP_DEFECTS_H

#include <CGAL/Geometric_continuity/algebra/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/isolate_roots.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Extrusion_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/Revolution_surface_3.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A parameter of a profile at which the normal of its swept surface vanishes.
///
/// If neither `on_axis` nor `zero_tangent`, the profile is tangent there to the lines of the sweep: parallel to the direction
/// of an extrusion, or along a parallel of a surface of revolution.
/// \tparam FT the field in which it was decided
template <class FT> struct Sweep_defect {
  FT begin;     ///< the parameter of the profile lies between this and the next,
  FT end;       ///< it is the only one there, and it is this one if they are equal
  bool on_axis; ///< the profile meets the axis of revolution
  /// On the axis, \f$ c' \ne 0 \f$ is orthogonal to it: the surface has a tangent plane at this pole all the same.
  bool smooth_pole;
  bool zero_tangent; ///< \f$ c' = 0 \f$
  int multiplicity;  ///< how often the normal vanishes, as a polynomial in the parameter
  /// The normal has opposite directions before and after: the parameter is inside the domain and the multiplicity is odd.
  /// On the axis the surface passes through a pole, elsewhere it folds.
  bool normal_flips;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Lists all parameters of a profile at which the normal of its swept surface vanishes.
template <class FT> struct Sweep_defects {
  /// The normal vanishes everywhere: the profile is a point, lies on the axis, or is straight in the direction of extrusion.
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

  // of the normal n, where d is c', `axis` is zero on the axis, and `pole` where also c' is orthogonal to it
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
/// Finds the parameters at which the normal \f$ c' \times w \f$ of the extrusion of a Bézier curve vanishes. They are the common
/// roots of its coordinates, found exactly and with every kernel: the control points are taken as they are given. The
/// intervals have at most 1/1024 of the length of the domain.
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
/// Finds the parameters at which the normal \f$ c' \times (w \times (c - a)) \f$ of the surface of revolution of a Bézier curve
/// vanishes: at these parameters for all angles, and at no others. They are found exactly and with every kernel, in intervals
/// of at most 1/1024 of the length of the domain, as for an extrusion.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Sweep_defects<Edge_field<Traits>> sweep_defects(const Revolution_surface_3<Bezier_curve<Traits, Degree>>& s) {
  typedef Edge_field<Traits> Field;
  return internal::Sweep_analysis<Traits>(s.profile(), Geometric_continuity::coordinates<Traits, Field>(s.axis_point()))
      .revolved(Geometric_continuity::coordinates<Traits, Field>(s.axis()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the signed distance of a profile from the axis, times a positive constant, as a polynomial on [0, 1], for a profile that
/// lies in a plane through the axis; otherwise empty. Its first coefficient that is not zero is positive. Where it changes
/// its sign the profile crosses the axis, and the normal of the surface flips. Decided exactly, with every kernel; its
/// signs are found by `sign_pattern()`.
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

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SWEEP_DEFECTS_H
