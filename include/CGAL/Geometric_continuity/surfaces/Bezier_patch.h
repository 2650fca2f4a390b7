// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H

#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>
#include <CGAL/Geometric_continuity/surfaces/internal/bezier_net.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A tensor-product Bézier patch
/// \f$ S(u, v) = \sum_{i=0}^p \sum_{j=0}^q b_{ij} B_i^p\left(\frac{u-a}{b-a}\right) B_j^q\left(\frac{v-c}{d-c}\right) \f$ on the
/// domain [a, b] x [c, d], by default the unit square. All derivatives are taken with respect to the parameters of the
/// domain, unless stated otherwise. The patch is a value: operations return new patches. With an exact kernel they are exact.
///
/// With floating-point numbers a result that overflows is refused: all functions that compute points throw `Error` with
/// `not_finite` instead of returning infinite numbers or NaN.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \models ParametricSurface
template <class Traits_> class Bezier_patch {
public:
  typedef Traits_ Traits;                       ///< the geometric traits
  typedef typename Traits::FT FT;               ///< the number type
  typedef typename Traits::Point Point;         ///< the points
  typedef typename Traits::Vector Vector;       ///< the vectors
  typedef std::pair<FT, FT> Interval;           ///< the two ends of a parameter interval
  static constexpr int N = dimension_v<Traits>; ///< the dimension, or 0 when it is known at run time only

  /// A row of coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, N>>;

private:
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  typedef internal::Control_net<Traits> Net;
  template <class Shape> friend class Rational_surface; // takes and gives the net as it is

  Net net_;
  Interval u_, v_;

public:
  typedef typename Net::const_iterator const_iterator; ///< an iterator over control points

  /// Constructs a patch from a control net and the domain [a, b] x [c, d]. `net[i]` is the range
  /// \f$ b_{i0}, \dots, b_{iq} \f$.
  /// \throws Error `wrong_number_of_points` for a net without points or with rows of different lengths,
  ///   `dimension_mismatch` when the points differ in dimension, `empty_domain` unless `a < b` and `c < d`, `not_finite` for
  ///   floating-point coordinates, ends of the domain or lengths of the domain that are infinite or not a number
  template <class Points>
  explicit Bezier_patch(const Points& net, const Interval& u = unit_interval(), const Interval& v = unit_interval())
      : Bezier_patch(Net(net, "Bezier_patch"), u, v) {}
  /// Constructs a patch from a control net that is written as a list of lists, and its domain.
  /// \throws Error `wrong_number_of_points`, `dimension_mismatch`, `empty_domain` or `not_finite` for what is no net of points
  ///   or no domain
  explicit Bezier_patch(std::initializer_list<std::initializer_list<Point>> net, const Interval& u = unit_interval(),
                        const Interval& v = unit_interval())
      : Bezier_patch(Net(net, "Bezier_patch"), u, v) {}

  int degree_u() const { return net_.rows() - 1; }    ///< Returns the degree `p` in `u`.
  int degree_v() const { return net_.columns() - 1; } ///< Returns the degree `q` in `v`.
  int dimension() const { return net_.dimension(); }  ///< Returns the dimension of the space.
  Interval domain_u() const { return u_; }            ///< Returns [a, b].
  Interval domain_v() const { return v_; }            ///< Returns [c, d].

  /// Returns the control point \f$ b_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  const Point& control_point(int i, int j) const { return net_(i, j); }
  /// Returns the coordinates of \f$ b_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  Coordinates coordinates(int i, int j) const { return net_.coordinates(i, j); }

  const_iterator begin() const { return net_.begin(); } ///< Returns the begin of \f$ b_{00}, b_{01}, \dots, b_{pq} \f$.
  const_iterator end() const { return net_.end(); }     ///< Returns the end of the control points.

  /// \name Evaluation
  /// The parameters may lie outside the domain: the polynomial is extended.
  /// @{

  /// Returns the point at (`u`, `v`). \f$ O(pq^2 + p^2) \f$
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0` at (`u`, `v`). \f$ O(pq^2 + kp^2 + pk^3) \f$
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    const Traits traits;
    return internal::bezier_jet<Traits>(degree_u(), degree_v(), dimension(), u_, v_, u, v, k, [&](int i, int j, int x) {
      return FT(traits.compute_coordinate_object()(net_(i, j), x));
    });
  }

  /// Returns the derivative of order `i >= 0` in `u` and `j >= 0` in `v`; for `i = j = 0` the position vector.
  /// \throws Error `negative_count` for a negative order
  Vector partial(const FT& u, const FT& v, int i, int j) const {
    internal::check_count((std::min)(i, j), "Bezier_patch: order of a partial derivative");
    return jet(u, v, i + j).partial(i, j);
  }

  /// Returns the normal \f$ S_u \times S_v \f$, not normalised; zero where the patch is not regular.
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

  /// Returns the degree of an edge.
  int degree_along(Patch_edge edge) const { return runs_along_u(edge) ? degree_u() : degree_v(); }
  /// Returns the degree in the parameter that is constant on an edge.
  int degree_across(Patch_edge edge) const { return runs_along_u(edge) ? degree_v() : degree_u(); }
  /// Returns the domain of an edge.
  Interval domain(Patch_edge edge) const { return runs_along_u(edge) ? u_ : v_; }

  /// Returns the control point number `i` along the edge in the layer `j`, where layer 0 is the edge itself.
  /// \pre `0 <= i <= degree_along(edge)`, `0 <= j <= degree_across(edge)`
  const Point& control_point(Patch_edge edge, int i, int j) const {
    const int inward = at_upper_end(edge) ? degree_across(edge) - j : j;
    return runs_along_u(edge) ? control_point(i, inward) : control_point(inward, i);
  }

  /// Returns the rows 0 to `k` at an edge: the Bernstein coefficients, along the edge, of the edge and of the first `k`
  /// derivatives across it, where the patch is taken on the unit square and turned so that the edge is at `v = 0`:
  /// \f$ \frac{q!}{(q-r)!} \Delta^r b_{i0} \f$, differences into the patch. Rows beyond the degree are zero. The control
  /// points are converted to `Field` before anything is computed. \f$ O(pk^2) \f$ for an edge of degree `p`
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    return internal::bezier_rows<Field, N>(degree_along(edge), degree_across(edge), dimension(), k, [&](int i, int j) {
      return Geometric_continuity::coordinates<Traits, Field>(control_point(edge, i, j));
    });
  }

  /// Returns the patch turned so that the edge is at `v = 0` and keeps its direction.
  Bezier_patch oriented(Patch_edge edge) const {
    const Bezier_patch r = runs_along_u(edge) ? *this : swap_parameters();
    return at_upper_end(edge) ? r.reverse_v() : r;
  }

  /// @}
  /// \name Operations
  /// @{

  /// Returns the patch \f$ (u, v) \mapsto S(v, u) \f$.
  Bezier_patch swap_parameters() const { return Bezier_patch(net_.transpose(), v_, u_); }

  /// Returns the patch \f$ (u, v) \mapsto S(a + b - u, v) \f$.
  Bezier_patch reverse_u() const { return Bezier_patch(net_.reverse_rows(), u_, v_); }

  /// Returns the patch \f$ (u, v) \mapsto S(u, c + d - v) \f$.
  Bezier_patch reverse_v() const { return swap_parameters().reverse_u().swap_parameters(); }

  /// Returns a patch with the same points whose degrees are raised by `times_u` and `times_v`.
  /// \throws Error `negative_count` for a negative number, `work_limit` for a degree that would be raised above 4096
  Bezier_patch elevate(int times_u, int times_v) const {
    internal::check_elevation(degree_u(), times_u, "Bezier_patch: elevate in u");
    internal::check_elevation(degree_v(), times_v, "Bezier_patch: elevate in v");
    const Net in_u = times_u == 0 ? net_ : internal::elevate_rows(net_, times_u);
    return Bezier_patch(times_v == 0 ? in_u : internal::elevate_rows(in_u.transpose(), times_v).transpose(), u_, v_);
  }

  /// Returns the parts on [a, u] and [u, b].
  /// \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Bezier_patch, Bezier_patch> split_u(const FT& u) const {
    if (!(u_.first < u && u < u_.second)) throw Error(Error_code::parameter_outside_domain, "Bezier_patch: split");
    const std::pair<Net, Net> parts = internal::split_rows(net_, internal::local_parameter(u, u_));
    return {Bezier_patch(parts.first, Interval(u_.first, u), v_),
            Bezier_patch(parts.second, Interval(u, u_.second), v_)};
  }

  /// Returns the parts on [c, v] and [v, d].
  /// \throws Error `parameter_outside_domain` unless `c < v < d`
  std::pair<Bezier_patch, Bezier_patch> split_v(const FT& v) const {
    const std::pair<Bezier_patch, Bezier_patch> parts = swap_parameters().split_u(v);
    return {parts.first.swap_parameters(), parts.second.swap_parameters()};
  }

  /// Returns the patch with the same control points on another domain.
  /// \throws Error `empty_domain` for a length that is not positive, `not_finite` for an end or a length that is not finite
  Bezier_patch with_domain(const Interval& u, const Interval& v) const { return Bezier_patch(net_, u, v); }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Bezier_patch transform(const Transformation& map) const {
    return Bezier_patch(net_.transform(map, "Bezier_patch: image"), u_, v_);
  }

  /// Returns two opposite corners of the bounding box of the control points, which contains the patch.
  std::pair<Point, Point> bounding_box() const { return internal::corners_of_box<Traits>(begin(), end()); }

  /// Returns the bounding box of the control points as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(bounding_box()); }

  /// @}

  /// Tells whether domains, degrees and control points are equal.
  friend bool operator==(const Bezier_patch& s, const Bezier_patch& t) {
    return s.u_ == t.u_ && s.v_ == t.v_ && s.net_ == t.net_;
  }
  /// Tells whether a domain, a degree or a control point differs.
  friend bool operator!=(const Bezier_patch& s, const Bezier_patch& t) { return !(s == t); }

  /// Writes the degrees, the domain and the control net, one row \f$ b_{i0}, \dots, b_{iq} \f$ to a line.
  friend std::ostream& operator<<(std::ostream& os, const Bezier_patch& s) {
    return os << "Bezier patch of degree " << s.degree_u() << " x " << s.degree_v() << " on [" << s.u_.first << ", "
              << s.u_.second << "] x [" << s.v_.first << ", " << s.v_.second << "]:" << s.net_;
  }

private:
  static Interval unit_interval() { return Interval(FT(0), FT(1)); }

  Bezier_patch(Net net, const Interval& u, const Interval& v) : net_(std::move(net)), u_(u), v_(v) {
    internal::check_interval(u_, "Bezier_patch: domain in u");
    internal::check_interval(v_, "Bezier_patch: domain in v");
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BEZIER_PATCH_H
