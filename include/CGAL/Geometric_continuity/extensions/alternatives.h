// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ALTERNATIVES_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ALTERNATIVES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/extensions/internal/Polygon_end.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

/// \file alternatives.h
/// All choices for the first points of a Bézier polygon that continues another one of the same
/// degree `m`.
///
/// The left polygon ends in \f$ b_{-3}, b_{-2}, b_{-1}, b_0 \f$ with the sides
/// \f$ p = b_0 - b_{-1} \f$, \f$ r = b_{-2} - b_{-1} \f$, \f$ s = b_{-2} - b_{-3} \f$; the right
/// one starts in \f$ b_0, b_1, b_2, b_3 \f$. The ratio \f$ \beta = |b_1 - b_0| / |p| \f$ is that of
/// the parameter intervals, right by left, when the derivatives shall agree. Everything holds in
/// any dimension. A torsion-continuous join has scalars that choose the points and scalars that
/// connect the derivatives, and they determine each other. Hagen, theorem 3.2, corrected, with
/// general \f$ \beta \f$ (Hagen: \f$ \beta = 1 \f$).
///
/// `midpoint_construction()` is Hagen's constructions (3.3.1) and (3.3.2), corrected: first points
/// of a polygon that continues another one with a continuous curvature vector and
/// \f$ \beta = 1 \f$, by reflections only.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// The scalars that choose \f$ b_2 \f$ (`c0`) and \f$ b_3 \f$ (`c1`, `c2`) of a right polygon.
/// Hagen (3.2.2), (3.2.3).
/// \tparam FT a field number type
template <class FT> struct Alternative_parameters {
  FT c0; ///< \f$ C_0 \f$
  FT c1; ///< \f$ C_1 \f$
  FT c2; ///< \f$ C_2 \f$
};

/// \ingroup PkgGeometricContinuityExtensions
/// The coefficients that connect the derivatives at a join of the curves `X` and `Y` over intervals
/// of length 1: \f$ Y' = \beta_1 X' \f$, \f$ Y'' = \beta_1^2 X'' + \beta_2 X' \f$,
/// \f$ Y''' = \beta_1^3 X''' + \mu X'' + \delta X' \f$. The join is \f$ F^3 \f$, and \f$ G^3 \f$
/// with \f$ \beta_3 = \delta \f$ when \f$ \mu = 3\beta_1\beta_2 \f$. Hagen (2.2).
/// \tparam FT a field number type
template <class FT> struct Connection_coefficients {
  FT beta1; ///< \f$ \beta_1 \f$
  FT beta2; ///< \f$ \beta_2 \f$
  FT mu;    ///< \f$ \mu \f$
  FT delta; ///< \f$ \delta \f$
};

namespace internal {

inline void check_degree(int m, int least, const char* place) {
  if (m < least)
    throw Error(Error_code::wrong_number_of_points,
                std::string(place) + ": there are no alternatives of degree " + std::to_string(m));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the scalars of the \f$ C^2 \f$ and \f$ C^3 \f$ members, when `beta` is the ratio of the
/// parameter intervals: \f$ C_0 = 2\beta^2 + 2\beta \f$, \f$ C_1 = \beta^3 + 3\beta^2 + 3\beta \f$,
/// \f$ C_2 = 2\beta^3 + 3\beta^2 \f$; that is 4, 7, 5 for \f$ \beta = 1 \f$.
template <class FT> Alternative_parameters<FT> ck_parameters(const FT& beta) {
  const FT square = beta * beta, cube = square * beta;
  return {FT(FT(2) * square + FT(2) * beta), FT(cube + FT(3) * square + FT(3) * beta),
          FT(FT(2) * cube + FT(3) * square)};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns \f$ \beta_2 = (m-1) (C_0 - 2\beta^2 - 2\beta) \f$.
/// \throws Error `wrong_number_of_points` when `m < 2`
template <class FT> FT connection_beta2(int m, const FT& beta, const FT& c0) {
  internal::check_degree(m, 2, "connection_beta2");
  return FT(FT(m - 1) * (c0 - ck_parameters<FT>(beta).c0));
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns all coefficients: \f$ \beta_1 = \beta \f$, \f$ \beta_2 \f$ as `connection_beta2()`,
/// \f$ \mu = (m-2) (C_2 - 3\beta^2 - 2\beta^3) \f$,
/// \f$ \delta = (m-1)(m-2) (C_1 - C_2 - 3C_0 + \beta^3 + 6\beta^2 + 3\beta) \f$.
/// \throws Error `wrong_number_of_points` when `m < 3`
template <class FT>
Connection_coefficients<FT> connection_coefficients(int m, const FT& beta, const Alternative_parameters<FT>& c) {
  internal::check_degree(m, 3, "connection_coefficients");
  const Alternative_parameters<FT> ck = ck_parameters<FT>(beta);
  const FT mu = FT(m - 2) * (c.c2 - ck.c2);
  // beta^3 + 6 beta^2 + 3 beta = 3 (C^2 choice of C_0) - (C^3 choice of C_1) + (C^3 choice of C_2)
  const FT delta = FT(m - 1) * FT(m - 2) * ((c.c1 - ck.c1) - (c.c2 - ck.c2) - FT(3) * (c.c0 - ck.c0));
  return {beta, connection_beta2<FT>(m, beta, c.c0), mu, delta};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the \f$ C_2 \f$ of the \f$ G^3 \f$ members of the plane:
/// \f$ C_2 = 3\beta^2 + 2\beta^3 + 3\beta \frac{m-1}{m-2} (C_0 - 2\beta^2 - 2\beta) \f$.
/// \throws Error `wrong_number_of_points` when `m < 3`
template <class FT> FT g3_c2(int m, const FT& beta, const FT& c0) {
  internal::check_degree(m, 3, "g3_c2");
  return FT(ck_parameters<FT>(beta).c2 + FT(3) * beta * connection_beta2<FT>(m, beta, c0) / FT(m - 2));
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the \f$ C_1 \f$ for which the connection has a wished \f$ \delta \f$:
/// \f$ C_1 = C_2 + 3C_0 - \beta^3 - 6\beta^2 - 3\beta + \frac{\delta}{(m-1)(m-2)} \f$.
/// \throws Error `wrong_number_of_points` when `m < 3`
template <class FT> FT connection_c1(int m, const FT& beta, const FT& c0, const FT& c2, const FT& delta) {
  internal::check_degree(m, 3, "connection_c1");
  const Alternative_parameters<FT> ck = ck_parameters<FT>(beta);
  return FT(ck.c1 + (c2 - ck.c2) + FT(3) * (c0 - ck.c0) + delta / (FT(m - 1) * FT(m - 2)));
}

/// \ingroup PkgGeometricContinuityExtensions
/// The second point of every next segment with a continuous tangent: \f$ b_1 = b_0 + \beta p \f$.
/// Hagen (3.2.1).
template <class Traits> class Tangent_alternative : public internal::Polygon_end<Traits, 2> {
  typedef internal::Polygon_end<Traits, 2> Base;

public:
  typedef typename Base::FT FT;
  typedef typename Base::Point Point;
  /// The number type of the kernel, or the exact one in which predicates are decided.
  typedef typename Base::Field Field;

  /// Takes the last points \f$ b_{-1}, b_0 \f$ of a polygon of degree `m`.
  /// \throws Error `wrong_number_of_points` when `m < 1`, `nonpositive_beta` unless `ratio > 0`,
  ///   `dimension_mismatch`, `zero_tangent` when \f$ p = 0 \f$, `not_finite` for an infinite or
  ///   undefined floating-point number
  Tangent_alternative(const std::array<Point, 2>& last_points, int m, const FT& ratio = FT(1))
      : Base(last_points, m, ratio, "tangent_alternative") {}

  using Base::beta;   ///< returns the ratio \f$ \beta \f$
  using Base::degree; ///< returns the degree `m` of both polygons

  /// Returns \f$ b_1 \f$. \throws Error `not_finite` when it overflows the number type
  Point point() const { return this->to_point(this->b(0) + beta() * this->p()); }

  /// Returns the ratio \f$ \beta > 0 \f$ of the tangent alternative of this polygon (of whatever
  /// ratio) that is `b1`; empty if none is. Decided exactly where predicates are exact. \throws
  /// Error `dimension_mismatch`, `not_finite`
  std::optional<Field> ratio_of(const Point& b1) const {
    const std::optional<Field> ratio =
        internal::coefficient<Field>(this->in_field(b1) - this->template b<Field>(0), this->template p<Field>());
    return ratio && Field(0) < *ratio ? ratio : std::nullopt;
  }
};

/// \ingroup PkgGeometricContinuityExtensions
/// The third point of every next segment with a continuous curvature vector, behind
/// \f$ b_1 = b_0 + \beta p \f$: the points \f$ b_2 = b_0 + \beta^2 (b_{-2} - b_0) + C_0 p \f$ of an
/// affine line. Hagen (3.2.2).
template <class Traits> class Curvature_alternatives : public internal::Polygon_end<Traits, 3> {
  typedef internal::Polygon_end<Traits, 3> Base;

public:
  typedef typename Base::FT FT;
  typedef typename Base::Point Point;
  typedef typename Base::Vector Vector;
  /// The number type of the kernel, or the exact one in which predicates are decided.
  typedef typename Base::Field Field;

  /// Takes the last points \f$ b_{-2}, b_{-1}, b_0 \f$ of a polygon of degree `m`.
  /// \throws Error `wrong_number_of_points` when `m < 2`, `nonpositive_beta` unless `ratio > 0`,
  ///   `dimension_mismatch`, `zero_tangent` when \f$ p = 0 \f$, `not_finite` for an infinite or
  ///   undefined floating-point number
  Curvature_alternatives(const std::array<Point, 3>& last_points, int m, const FT& ratio = FT(1))
      : Base(last_points, m, ratio, "curvature_alternatives") {}

  using Base::beta;   ///< returns the ratio \f$ \beta \f$
  using Base::degree; ///< returns the degree `m` of both polygons

  /// Returns the member with \f$ C_0 = 0 \f$. \throws Error `not_finite` when it overflows the
  /// number type
  Point base_point() const { return this->to_point(base()); }
  /// Returns the direction \f$ p \f$ of the line.
  Vector direction() const { return Geometric_continuity::to_vector<Traits>(this->p()); }

  /// Returns the member \f$ b_2 \f$ with this \f$ C_0 \f$. \throws Error `not_finite` when it
  /// overflows the number type
  Point point_at(const FT& c0) const { return this->to_point(base() + c0 * this->p()); }

  /// Returns the \f$ C_0 \f$ of a point, empty if it is not on the line. Decided exactly where
  /// predicates are exact.
  /// \throws Error `dimension_mismatch`, `not_finite`
  std::optional<Field> parameter_of(const Point& b2) const {
    return internal::coefficient<Field>(this->in_field(b2) - base<Field>(), this->template p<Field>());
  }

  /// Returns the \f$ C_0 \f$ of the member nearest to a point: orthogonal projection.
  /// \throws Error `dimension_mismatch`, `not_finite`
  FT nearest_parameter(const Point& wished) const { return nearest(this->coordinates(wished)); }

  /// Returns \f$ C_0 = 2\beta^2 + 2\beta \f$, which chooses the \f$ C^2 \f$ member when
  /// \f$ \beta \f$ is the ratio of the parameter intervals.
  FT ck_parameter() const { return ck_parameters<FT>(beta()).c0; }

  /// Returns \f$ \beta_2 \f$ of the join in unit intervals: \f$ Y'' = \beta^2 X'' + \beta_2 X' \f$.
  /// \throws Error `not_finite` when it overflows the number type
  FT beta2(const FT& c0) const { return this->finite(connection_beta2<FT>(degree(), beta(), c0)); }

  /// Returns the \f$ C_0 \f$ for which the next segment with the given points
  /// \f$ b_3, \dots, b_m \f$ has the least energy \f$ \int |\gamma''|^2 \f$, on whatever interval.
  /// \f$ O(m^3) \f$
  /// \throws Error `wrong_number_of_points` unless `m - 2` points are given, `dimension_mismatch`,
  ///   `not_finite`
  template <class InputIterator> FT least_energy_parameter(InputIterator first, InputIterator last) const {
    return nearest(this->least_energy_point({this->b(0), this->b(0) + beta() * this->p()}, first, last));
  }

private:
  template <class F = FT> typename Base::template Coordinates_over<F> base() const {
    const F ratio = internal::to_field<F>(beta()), square = ratio * ratio;
    // b_{-2} when beta = 1
    return F(F(1) - square) * this->template b<F>(0) + square * this->template b<F>(2);
  }
  FT nearest(const typename Base::Coordinates& x) const {
    return this->finite(FT(dot(x - base(), this->p()) / dot(this->p(), this->p())));
  }
};

/// \ingroup PkgGeometricContinuityExtensions
/// The scalars of one member of `Torsion_alternatives`.
template <class FT> struct Torsion_parameters {
  FT c1; ///< \f$ C_1 \f$
  FT c2; ///< \f$ C_2 \f$

  /// Returns whether both scalars are equal.
  friend bool operator==(const Torsion_parameters& x, const Torsion_parameters& y) {
    return x.c1 == y.c1 && x.c2 == y.c2;
  }
  /// Returns whether a scalar differs.
  friend bool operator!=(const Torsion_parameters& x, const Torsion_parameters& y) { return !(x == y); }
};

/// \ingroup PkgGeometricContinuityExtensions
/// The fourth point of every next segment with a continuous Frenet frame, curvature and torsion
/// (\f$ F^3 \f$), behind \f$ b_1 = b_0 + \beta p \f$ and the member \f$ b_2 \f$ of
/// `Curvature_alternatives` with a given \f$ C_0 \f$: the points
/// \f$ b_3 = b_0 + \beta^3 (b_{-2} - b_{-3}) + C_1 p + C_2 r \f$ of an affine plane, which does not
/// depend on \f$ C_0 \f$. Hagen (3.2.3), corrected: the printed \f$ b_3 = C_1 p + C_2 r \f$ does
/// not even move with the curve.
///
/// Where the curvature is zero (\f$ r \parallel p \f$) the plane shrinks to a line and
/// \f$ C_1, C_2 \f$ cannot be distinguished; functions that choose a member then take the
/// \f$ C_2 \f$ of the \f$ G^3 \f$ members.
template <class Traits> class Torsion_alternatives : public internal::Polygon_end<Traits, 4> {
  typedef internal::Polygon_end<Traits, 4> Base;

public:
  typedef typename Base::FT FT;
  typedef typename Base::Point Point;
  typedef typename Base::Vector Vector;
  /// The number type of the kernel, or the exact one in which predicates are decided.
  typedef typename Base::Field Field;

  /// Takes the last points \f$ b_{-3}, \dots, b_0 \f$ of a polygon of degree `m`, and the
  /// \f$ C_0 \f$ of \f$ b_2 \f$.
  /// \throws Error `wrong_number_of_points` when `m < 3`, `nonpositive_beta` unless `ratio > 0`,
  ///   `dimension_mismatch`, `zero_tangent` when \f$ p = 0 \f$, `not_finite` for an infinite or
  ///   undefined floating-point number
  Torsion_alternatives(const std::array<Point, 4>& last_points, int m, const FT& c0, const FT& ratio = FT(1))
      : Base(last_points, m, ratio, "torsion_alternatives"), c0_(this->finite(c0)) {}

  using Base::beta;                    ///< returns the ratio \f$ \beta \f$
  using Base::degree;                  ///< returns the degree `m` of both polygons
  const FT& c0() const { return c0_; } ///< returns the \f$ C_0 \f$ of \f$ b_2 \f$

  /// Returns the member with \f$ C_1 = C_2 = 0 \f$. \throws Error `not_finite` when it overflows
  /// the number type
  Point base_point() const { return this->to_point(base()); }
  /// Returns the directions \f$ p, r \f$ of the plane.
  std::pair<Vector, Vector> directions() const {
    return {Geometric_continuity::to_vector<Traits>(this->p()), Geometric_continuity::to_vector<Traits>(this->r())};
  }

  /// Decides whether the curvature is zero, so that the members form a line only. Exact where
  /// predicates are exact.
  bool is_line() const {
    return internal::coefficient<Field>(this->template r<Field>(), this->template p<Field>()).has_value();
  }

  /// Returns the member \f$ b_3 \f$ with these scalars. \throws Error `not_finite` when it
  /// overflows the number type
  Point point_at(const Torsion_parameters<FT>& x) const {
    return this->to_point(base() + x.c1 * this->p() + x.c2 * this->r());
  }

  /// Decides whether a point is a member. Exact where predicates are exact.
  /// \throws Error `dimension_mismatch`, `not_finite`
  bool contains(const Point& b3) const {
    const typename Base::template Coordinates_over<Field> v = this->in_field(b3) - base<Field>(),
                                                          p = this->template p<Field>();
    return is_line() ? internal::coefficient<Field>(v, p).has_value()
                     : Plane_coordinates(p, this->template r<Field>(), "torsion_alternatives")(v).has_value();
  }

  /// Returns the scalars of a point, empty if it is not in the plane. Decided exactly where
  /// predicates are exact.
  /// \throws Error `dimension_mismatch`, `not_finite`; `singular_frame` where the curvature is zero
  std::optional<Torsion_parameters<Field>> parameters_of(const Point& b3) const {
    if (is_line())
      throw Error(Error_code::singular_frame,
                  "torsion_alternatives: the curvature is zero, C1 and C2 are not separable");
    const std::optional<std::pair<Field, Field>> c =
        Plane_coordinates(this->template p<Field>(), this->template r<Field>(),
                          "torsion_alternatives")(this->in_field(b3) - base<Field>());
    if (!c) return std::nullopt;
    return Torsion_parameters<Field>{c->first, c->second};
  }

  /// Returns the scalars of the member nearest to a point: orthogonal projection.
  /// \throws Error `dimension_mismatch`, `not_finite`
  Torsion_parameters<FT> nearest_parameters(const Point& wished) const { return nearest(this->coordinates(wished)); }

  /// Returns \f$ C_1 = \beta^3 + 3\beta^2 + 3\beta \f$ and \f$ C_2 = 2\beta^3 + 3\beta^2 \f$: with
  /// the \f$ C^2 \f$ choice of \f$ C_0 \f$ they choose the \f$ C^3 \f$ member when \f$ \beta \f$ is
  /// the ratio of the parameter intervals.
  Torsion_parameters<FT> ck_parameters() const {
    const Alternative_parameters<FT> c = Geometric_continuity::ck_parameters<FT>(beta());
    return {c.c1, c.c2};
  }

  /// Returns the scalars of the \f$ G^3 \f$ member with this \f$ \beta_3 \f$ (in unit intervals).
  /// There is one for each.
  /// \throws Error `not_finite` when they overflow the number type
  Torsion_parameters<FT> g3_parameters(const FT& beta3 = FT(0)) const {
    const FT c2 = g3_c2<FT>(degree(), beta(), c0_);
    return {this->finite(connection_c1<FT>(degree(), beta(), c0_, c2, beta3)), this->finite(c2)};
  }

  /// Returns \f$ \beta, \beta_2, \mu, \delta \f$ of the join with this member, in unit intervals.
  /// \throws Error `not_finite` when one of them overflows the number type
  Connection_coefficients<FT> connection(const Torsion_parameters<FT>& x) const {
    const Connection_coefficients<FT> c = connection_coefficients<FT>(degree(), beta(), {c0_, x.c1, x.c2});
    for (const FT& coefficient : {c.beta2, c.mu, c.delta}) this->finite(coefficient);
    return c;
  }

  /// Returns the scalars for which the next segment with the given points \f$ b_4, \dots, b_m \f$
  /// has the least energy \f$ \int |\gamma''|^2 \f$, on whatever interval. \f$ O(m^3) \f$
  /// \throws Error `wrong_number_of_points` unless `m - 3` points are given, `dimension_mismatch`,
  ///   `not_finite`
  template <class InputIterator>
  Torsion_parameters<FT> least_energy_parameters(InputIterator first, InputIterator last) const {
    // b_2 = b_0 + beta^2 (r - p) + C_0 p
    const typename Base::Coordinates b0 = this->b(0), p = this->p();
    const FT ratio = beta(), ratio_squared = ratio * ratio;
    return nearest(
        this->least_energy_point({b0, b0 + ratio * p, b0 + ratio_squared * (this->r() - p) + c0_ * p}, first, last));
  }

private:
  FT c0_;

  template <class F = FT> typename Base::template Coordinates_over<F> base() const {
    const F ratio = internal::to_field<F>(beta());
    return this->template b<F>(0) + F(ratio * ratio * ratio) * this->template s<F>();
  }
  // x - base = C_1 p + C_2 r up to a vector orthogonal to p and r; with q, the part of r orthogonal
  // to p, the normal equations are triangular
  Torsion_parameters<FT> nearest(const typename Base::Coordinates& x) const {
    const typename Base::Coordinates v = x - base(), p = this->p(), r = this->r(), q = orthogonal_component(r, p);
    const FT c2 = is_line() ? g3_parameters().c2 : FT(dot(v, q) / dot(q, q));
    return {this->finite(FT(dot(v - c2 * r, p) / dot(p, p))), this->finite(c2)};
  }
};

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the second point of the segments that continue `left` with a continuous tangent, as an
/// object.
/// \throws Error like the constructor of `Tangent_alternative`
template <class Traits, int Degree>
Tangent_alternative<Traits> tangent_alternative(const Bezier_curve<Traits, Degree>& left,
                                                const typename Traits::FT& beta = typename Traits::FT(1)) {
  return {internal::last_points<2>(left, "tangent_alternative"), left.degree(), beta};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the line of third points of the segments that continue `left` with a continuous
/// curvature vector.
/// \throws Error like the constructor of `Curvature_alternatives`
template <class Traits, int Degree>
Curvature_alternatives<Traits> curvature_alternatives(const Bezier_curve<Traits, Degree>& left,
                                                      const typename Traits::FT& beta = typename Traits::FT(1)) {
  return {internal::last_points<3>(left, "curvature_alternatives"), left.degree(), beta};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the plane of fourth points of the segments that continue `left` with continuous torsion,
/// when \f$ b_2 \f$ has been chosen by \f$ C_0 \f$. \throws Error like the constructor of
/// `Torsion_alternatives`
template <class Traits, int Degree>
Torsion_alternatives<Traits> torsion_alternatives(const Bezier_curve<Traits, Degree>& left,
                                                  const typename Traits::FT& c0,
                                                  const typename Traits::FT& beta = typename Traits::FT(1)) {
  return {internal::last_points<4>(left, "torsion_alternatives"), left.degree(), c0, beta};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the reflection \f$ 2c - x \f$ of a point in a centre, which becomes the midpoint of
/// both. With \f$ c = b_0 \f$ and \f$ x = b_{-1} \f$ this is Hagen's construction (3.3.1) of the
/// \f$ b_1 \f$ of a continuous tangent.
/// \throws Error `dimension_mismatch`, `not_finite` when the result overflows the number type
template <class Traits>
typename Traits::Point reflection(const typename Traits::Point& centre, const typename Traits::Point& x) {
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const Coordinates c = Geometric_continuity::coordinates<Traits>(centre),
                    d = Geometric_continuity::coordinates<Traits>(x);
  if (c.dimension() != d.dimension()) throw Error(Error_code::dimension_mismatch, "reflection");
  const Coordinates reflected = c + (c - d);
  for (const typename Traits::FT& y : reflected) internal::check_finite(y, "reflection");
  return Geometric_continuity::to_point<Traits>(reflected);
}

/// \ingroup PkgGeometricContinuityExtensions
/// The points of Hagen's construction (3.3.2), corrected, for curvature continuity with
/// \f$ \beta = 1 \f$. All of them come from midpoints, with two operations per coordinate each, in
/// any dimension and over any field.
///
/// A space curve can be constructed from two planar projections (Hagen, remark 2) only when both
/// use the same \f$ C_0 \f$. This is automatic where the tangent is not orthogonal to the axis that
/// the projections share.
template <class Traits> struct Midpoint_construction {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  Point b1; ///< \f$ b_0 \f$ is the midpoint of \f$ b_{-1}, b_1 \f$
  Point d0; ///< \f$ b_{-1} \f$ is the midpoint of \f$ b_{-2}, d_0 \f$
  /// \f$ \tilde b_2 \f$: \f$ b_1 \f$ is the midpoint of \f$ d_0, \tilde b_2 \f$; \f$ C_0 = 4 \f$,
  /// the \f$ C^2 \f$ join
  Point b2_tilde;
  /// \f$ \bar b_2 \f$: \f$ b_0 \f$ is the midpoint of \f$ d_0, \bar b_2 \f$; \f$ C_0 = 2 \f$
  Point b2_bar;

  /// Returns the alternatives \f$ b_2 = \bar b_2 + \frac{C_0 - 2}{2} (\tilde b_2 - \bar b_2) \f$,
  /// an affine line.
  /// \throws Error `not_finite` when the result overflows the number type
  Point b2(const FT& c0) const {
    typedef Geometric_continuity::Coordinates<Traits> Coordinates;
    const Coordinates bar = Geometric_continuity::coordinates<Traits>(b2_bar),
                      point =
                          bar + FT((c0 - FT(2)) / FT(2)) * (Geometric_continuity::coordinates<Traits>(b2_tilde) - bar);
    for (const FT& x : point) internal::check_finite(x, "midpoint_construction: b2");
    return Geometric_continuity::to_point<Traits>(point);
  }
};

/// \ingroup PkgGeometricContinuityExtensions
/// Constructs the points of Hagen (3.3.1) and (3.3.2) at the end \f$ b_{-2}, b_{-1}, b_0 \f$ of a
/// polygon. Where \f$ b_{-1} = b_0 \f$ the line of alternatives shrinks to a point.
/// \throws Error `dimension_mismatch`, `not_finite` when a point overflows the number type
template <class Traits>
Midpoint_construction<Traits> midpoint_construction(const typename Traits::Point& b_2,
                                                    const typename Traits::Point& b_1,
                                                    const typename Traits::Point& b0) {
  Midpoint_construction<Traits> m;
  m.b1 = reflection<Traits>(b0, b_1);
  m.d0 = reflection<Traits>(b_1, b_2);
  m.b2_tilde = reflection<Traits>(m.b1, m.d0);
  m.b2_bar = reflection<Traits>(b0, m.d0);
  return m;
}

/// \ingroup PkgGeometricContinuityExtensions
/// Constructs the points of Hagen (3.3.1) and (3.3.2) behind a Bézier curve, from its last three
/// control points.
/// \throws Error `wrong_number_of_points` for a degree below 2, `not_finite` when a point overflows
///   the number type
template <class Traits, int Degree>
Midpoint_construction<Traits> midpoint_construction(const Bezier_curve<Traits, Degree>& left) {
  const int m = left.degree();
  if (m < 2)
    throw Error(Error_code::wrong_number_of_points,
                "midpoint_construction: it does not exist for degree " + std::to_string(m));
  return midpoint_construction<Traits>(left.control_point(m - 2), left.control_point(m - 1), left.control_point(m));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ALTERNATIVES_H
