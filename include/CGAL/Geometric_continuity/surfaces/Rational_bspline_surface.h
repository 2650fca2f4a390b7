// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BSPLINE_SURFACE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BSPLINE_SURFACE_H

#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_bezier_patch.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product B-spline surface (NURBS)
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} N_i^p(u) N_j^q(v) / \sum_{ij} w_{ij} N_i^p(u) N_j^q(v) \f$ over two `Knot_vector`s, with
/// control points \f$ b_{ij} \f$ and as many weights.
///
/// Numerator and denominator are a B-spline surface of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$, see
/// `homogeneous()`, and all that is done with this surface is done with that one. A common factor of all weights changes nothing.
/// Weights may be negative or zero as for `Rational_bezier_patch`.
///
/// The surface is a value: operations return new surfaces. With an exact kernel they are exact.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \models ParametricSurface
template <class Traits_> class Rational_bspline_surface {
  typedef internal::Rational_net<Traits_> Net;

public:
  typedef Traits_ Traits;                 ///< the geometric traits
  typedef typename Traits::FT FT;         ///< the number type
  typedef typename Traits::Point Point;   ///< the points
  typedef typename Traits::Vector Vector; ///< the vectors
  typedef std::pair<FT, FT> Interval;     ///< the two ends of a parameter interval
  /// The B-spline surface of the homogeneous points.
  typedef Bspline_surface<Homogeneous_traits<Traits>> Homogeneous;
  static constexpr int N = dimension_v<Traits>; ///< the dimension, or 0 when it is known at run time only

  /// A row of homogeneous coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, (N == 0 ? 0 : N + 1)>>;
  /// An iterator over control points.
  typedef typename internal::Control_net<Traits>::const_iterator const_iterator;

  /// Constructs a surface from a control net, a net of as many weights and the knots. `net[i]` is the range
  /// \f$ b_{i0}, \dots, b_{i,n-1} \f$, and `weights[i]` that of the weights.
  /// \throws Error `wrong_number_of_points` unless there are `m` rows of `n` points and weights; `zero_weight` unless the
  ///   denominator is positive on the whole domain, `work_limit` when it is positive but comes too close to zero inside, or has too
  ///   high degrees for that to be decided there; `dimension_mismatch`, `not_finite` as for `Bspline_surface`
  template <class Points, class Weights>
  Rational_bspline_surface(const Points& net, const Weights& weights, Knot_vector<FT> knots_u, Knot_vector<FT> knots_v)
      : Rational_bspline_surface(Net(internal::spline_net<Traits>(net, knots_u, knots_v), weights, place), knots_u,
                                 knots_v) {}
  /// Constructs a surface from a control net and weights that are written as lists of lists, and the knots.
  /// \throws Error as for ranges
  Rational_bspline_surface(std::initializer_list<std::initializer_list<Point>> net,
                           std::initializer_list<std::initializer_list<FT>> weights, Knot_vector<FT> knots_u,
                           Knot_vector<FT> knots_v)
      : Rational_bspline_surface(Net(internal::spline_net<Traits>(net, knots_u, knots_v), weights, place), knots_u,
                                 knots_v) {}

  /// Takes the surface of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$.
  /// \throws Error `zero_weight`, `work_limit` as above, `not_finite` when a quotient overflows
  explicit Rational_bspline_surface(const Homogeneous& s)
      : Rational_bspline_surface(Net(s.number_of_points_u(), s.number_of_points_v(), s.begin(), s.end(), place),
                                 s.knots_u(), s.knots_v()) {}

  /// Converts a polynomial surface: all weights are 1.
  Rational_bspline_surface(const Bspline_surface<Traits>& s)
      : u_(s.knots_u()), v_(s.knots_v()),
        net_(internal::Control_net<Traits>(s.number_of_points_u(), s.number_of_points_v(), {s.begin(), s.end()},
                                           place)) {}

  /// Converts a rational Bézier patch.
  explicit Rational_bspline_surface(const Rational_bezier_patch<Traits>& s)
      : u_(s.degree_u(), s.domain_u().first, s.domain_u().second),
        v_(s.degree_v(), s.domain_v().first, s.domain_v().second), net_(s.net_) {}

  int degree_u() const { return u_.degree(); }                ///< Returns the degree `p` in `u`.
  int degree_v() const { return v_.degree(); }                ///< Returns the degree `q` in `v`.
  int dimension() const { return net_.points().dimension(); } ///< Returns the dimension of the space.

  /// \name Control Points, Weights and Knots
  /// @{

  /// Returns the number `m` of control points in the direction of `u`.
  int number_of_points_u() const { return net_.rows(); }
  /// Returns the number `n` of control points in the direction of `v`.
  int number_of_points_v() const { return net_.columns(); }
  /// Returns the control point \f$ b_{ij} \f$. \pre `0 <= i < m`, `0 <= j < n`
  const Point& control_point(int i, int j) const { return net_.points()(i, j); }
  /// Returns the coordinates of \f$ b_{ij} \f$. \pre `0 <= i < m`, `0 <= j < n`
  Geometric_continuity::Coordinates<Traits> coordinates(int i, int j) const { return net_.points().coordinates(i, j); }
  /// Returns the begin of \f$ b_{00}, b_{01}, \dots, b_{m-1,n-1} \f$.
  const_iterator begin() const { return net_.points().begin(); }
  const_iterator end() const { return net_.points().end(); } ///< Returns the end of the control points.
  /// Returns the weights \f$ w_{00}, w_{01}, \dots, w_{m-1,n-1} \f$.
  const std::vector<FT>& weights() const { return net_.weights(); }
  /// Returns the weight \f$ w_{ij} \f$. \pre `0 <= i < m`, `0 <= j < n`
  const FT& weight(int i, int j) const { return net_.weight(i, j); }

  const Knot_vector<FT>& knots_u() const { return u_; } ///< Returns the knots in `u`.
  const Knot_vector<FT>& knots_v() const { return v_; } ///< Returns the knots in `v`.
  /// Returns the domain \f$ [u_p, u_m] \f$ of the knots in `u`.
  Interval domain_u() const { return u_.domain(); }
  /// Returns the domain \f$ [v_q, v_n] \f$ of the knots in `v`.
  Interval domain_v() const { return v_.domain(); }

  /// Returns the B-spline surface of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$ over the same knots.
  /// \throws Error `not_finite` when a product of floating-point numbers overflows
  Homogeneous homogeneous() const { return Homogeneous(net_.homogeneous(), u_, v_); }

  /// Returns whether all weights are equal. Then the surface is a polynomial one with the same control points and knots.
  bool is_polynomial() const { return net_.is_polynomial(); }
  /// Returns the polynomial surface with the same control points and knots if all weights are equal, otherwise nothing.
  std::optional<Bspline_surface<Traits>> polynomial() const {
    if (!is_polynomial()) return std::nullopt;
    return Bspline_surface<Traits>(
        internal::part_of_net(net_.points(), 0, number_of_points_u() - 1, 0, number_of_points_v() - 1), u_, v_);
  }

  /// @}
  /// \name Evaluation
  /// All these functions throw `Error` with `parameter_outside_domain` outside the domain, whose upper ends are included. At
  /// an inner knot they take the side of the larger parameters.
  /// @{

  /// Returns the point at (`u`, `v`).
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0` at (`u`, `v`). The cost is that of `Bspline_surface::jet()`, and \f$ O(k^4) \f$.
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    return project<Traits>(internal::bspline_jet<Homogeneous_traits<Traits>>(
        dimension() + 1, u_, v_, u, v, k, [&](int i, int j) { return net_.homogeneous(i, j); }));
  }

  /// Returns the derivative of order `i >= 0` in `u` and `j >= 0` in `v`; for `i = j = 0` the position vector.
  /// \throws Error `negative_count` for a negative order
  Vector partial(const FT& u, const FT& v, int i, int j) const {
    internal::check_count((std::min)(i, j), "Rational_bspline_surface: order of a partial derivative");
    return jet(u, v, i + j).partial(i, j);
  }

  /// Returns the normal \f$ S_u \times S_v \f$, not normalised; zero where the surface is not regular.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(jet(u, v, 1)); }

  /// Returns the unit normal, empty where \f$ S_u \times S_v = 0 \f$; only for number types that have a square root.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  std::optional<Vector> unit_normal(const FT& u, const FT& v) const {
    return Geometric_continuity::unit_normal(jet(u, v, 1));
  }

  /// @}
  /// \name Edges
  /// @{

  /// Returns the knots of an edge.
  const Knot_vector<FT>& knots_along(Patch_edge edge) const { return runs_along_u(edge) ? u_ : v_; }
  /// Returns the knots in the parameter that is constant on an edge.
  const Knot_vector<FT>& knots_across(Patch_edge edge) const { return runs_along_u(edge) ? v_ : u_; }

  /// Returns the rows 0 to `k` at an edge of the B-spline surface of homogeneous points, see `Bspline_surface::rows()`. Control
  /// points, weights and knots are converted to `Field` before anything is computed.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    const Interval across = knots_across(edge).domain();
    const Parameter_line line = runs_along_u(edge) ? Parameter_line::along_u : Parameter_line::along_v;
    return at_upper_end(edge) ? rows_at<Field>(line, across.second, Line_side::smaller_parameters, k)
                              : rows_at<Field>(line, across.first, Line_side::larger_parameters, k);
  }

  /// Returns the rows 0 to `k` at the line on which one parameter has a constant value, of the B-spline surface of homogeneous
  /// points, see `Bspline_surface::rows_at()`.
  /// \throws Error `parameter_outside_domain` for a parameter outside the domain, `negative_count` unless `k >= 0`
  template <class Field = FT>
  std::vector<Row<Field>> rows_at(Parameter_line line, const FT& parameter, Line_side side, int k) const {
    return internal::bspline_rows_at<Field, (N == 0 ? 0 : N + 1)>(
        u_, v_, dimension() + 1, line, parameter, side, k,
        [&](int i, int j) { return net_.template homogeneous<Field>(i, j); });
  }

  /// @}
  /// \name Operations
  /// Those that compute new control points cost and throw as those of `Bspline_surface`.
  /// @{

  /// Returns the surface \f$ (u, v) \mapsto S(v, u) \f$.
  Rational_bspline_surface swap_parameters() const { return with(net_.transpose(), v_, u_); }
  /// Returns the surface with `u` in the opposite direction, on the same domain, see `Knot_vector::reverse()`.
  Rational_bspline_surface reverse_u() const { return with(net_.reverse_rows(), u_.reverse(), v_); }
  /// Returns the surface with `v` in the opposite direction, on the same domain, see `Knot_vector::reverse()`.
  Rational_bspline_surface reverse_v() const { return with(net_.reverse_columns(), u_, v_.reverse()); }

  /// Returns a surface with the same points whose degrees are raised by `times_u` and `times_v`, see `Bspline_surface`.
  Rational_bspline_surface elevate(int times_u, int times_v) const {
    return Rational_bspline_surface(homogeneous().elevate(times_u, times_v));
  }
  /// Returns a surface with the same points and `times` more copies of the knot `u`.
  Rational_bspline_surface insert_u(const FT& u, int times = 1) const {
    return Rational_bspline_surface(homogeneous().insert_u(u, times));
  }
  /// Returns a surface with the same points and `times` more copies of the knot `v`.
  Rational_bspline_surface insert_v(const FT& v, int times = 1) const {
    return Rational_bspline_surface(homogeneous().insert_v(v, times));
  }
  /// Returns a surface with the same points over finer knots.
  Rational_bspline_surface refine(const Knot_vector<FT>& finer_u, const Knot_vector<FT>& finer_v) const {
    return Rational_bspline_surface(homogeneous().refine(finer_u, finer_v));
  }
  /// Returns a surface with the same points, without the knots outside the domain, and with control points at its corners.
  Rational_bspline_surface clamp() const { return Rational_bspline_surface(homogeneous().clamp()); }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Rational_bspline_surface transform(const Transformation& map) const {
    return with(net_.transform(map, "Rational_bspline_surface: image"), u_, v_);
  }

  /// Returns the rational Bézier patches on the rectangles of a span in `u` and a span in `v`, each with its rectangle as
  /// domain. All that belong to the first span in `u` come first.
  std::vector<Rational_bezier_patch<Traits>> bezier_patches() const {
    std::vector<Rational_bezier_patch<Traits>> patches;
    for_each_bezier_patch([&](Rational_bezier_patch<Traits> patch) { patches.push_back(std::move(patch)); });
    return patches;
  }
  /// Calls `f(patch)` for each of the patches that `bezier_patches()` returns, in the same order.
  template <class Function> void for_each_bezier_patch(Function f) const {
    homogeneous().for_each_bezier_patch([&](const typename Rational_bezier_patch<Traits>::Homogeneous& patch) {
      f(Rational_bezier_patch<Traits>(patch));
    });
  }

  /// @}

  /// Tells whether knots, control points and weights are equal.
  friend bool operator==(const Rational_bspline_surface& s, const Rational_bspline_surface& t) {
    return s.u_ == t.u_ && s.v_ == t.v_ && s.net_ == t.net_;
  }
  /// Tells whether a knot, a control point or a weight differs.
  friend bool operator!=(const Rational_bspline_surface& s, const Rational_bspline_surface& t) { return !(s == t); }

  /// Writes the degrees, the knots, the control net and the weights, one row to a line.
  friend std::ostream& operator<<(std::ostream& os, const Rational_bspline_surface& s) {
    return os << "Rational B-spline surface of degree " << s.degree_u() << " x " << s.degree_v() << " over " << s.u_
              << " and " << s.v_ << ':' << s.net_;
  }

private:
  static constexpr const char* place = "Rational_bspline_surface";

  Knot_vector<FT> u_, v_;
  Net net_;

  Rational_bspline_surface(Net net, Knot_vector<FT> knots_u, Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)), net_(std::move(net)) {
    internal::check_surface_denominator(net_, u_, v_, "Rational_bspline_surface: weights");
  }

  // With another net whose denominator is known to be positive.
  Rational_bspline_surface with(Net net, const Knot_vector<FT>& u, const Knot_vector<FT>& v) const {
    Rational_bspline_surface r = *this;
    r.net_ = std::move(net);
    r.u_ = u;
    r.v_ = v;
    return r;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BSPLINE_SURFACE_H
