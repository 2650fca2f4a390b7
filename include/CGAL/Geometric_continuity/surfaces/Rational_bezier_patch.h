// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BEZIER_PATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BEZIER_PATCH_H

#include <CGAL/Geometric_continuity/local/homogeneous_surface_jets.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/internal/Rational_net.h>
#include <CGAL/Geometric_continuity/surfaces/internal/surface_denominator.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

template <class Traits> class Rational_bspline_surface;

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product Bézier patch
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} B_i^p(s) B_j^q(t) / \sum_{ij} w_{ij} B_i^p(s) B_j^q(t) \f$, \f$ s = (u-a)/(b-a) \f$,
/// \f$ t = (v-c)/(d-c) \f$, with control points \f$ b_{ij} \f$ and weights \f$ w_{ij} \f$ on [a, b] x [c, d], by default the
/// unit square: pieces of cylinders, spheres and tori, and of all NURBS surfaces.
///
/// Numerator and denominator are a polynomial patch of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$, see
/// `homogeneous()`, and all that is done with this patch is done with that one. A common factor of all weights changes nothing.
///
/// A weight may be negative or zero as long as the denominator is positive on the whole domain, which is decided exactly; see
/// `Rational_bezier_curve` for the control points of the weight 0.
///
/// The patch is a value: operations return new patches. With an exact kernel they are exact.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \models ParametricSurface
template <class Traits_> class Rational_bezier_patch {
  friend class Rational_bspline_surface<Traits_>; // takes the net as it is
  typedef internal::Rational_net<Traits_> Net;

public:
  typedef Traits_ Traits;                 ///< the geometric traits
  typedef typename Traits::FT FT;         ///< the number type
  typedef typename Traits::Point Point;   ///< the points
  typedef typename Traits::Vector Vector; ///< the vectors
  typedef std::pair<FT, FT> Interval;     ///< the two ends of a parameter interval
  /// The polynomial patch of the homogeneous points.
  typedef Bezier_patch<Homogeneous_traits<Traits>> Homogeneous;
  static constexpr int N = dimension_v<Traits>; ///< the dimension, or 0 when it is known at run time only

  /// A row of homogeneous coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, (N == 0 ? 0 : N + 1)>>;
  /// An iterator over control points.
  typedef typename internal::Control_net<Traits>::const_iterator const_iterator;

  /// Constructs a patch from a control net, a net of as many weights and the domain [a, b] x [c, d]. `net[i]` is the range
  /// \f$ b_{i0}, \dots, b_{iq} \f$, and `weights[i]` that of the weights.
  /// \throws Error `wrong_number_of_points` for a net without points, with rows of different lengths, or with other numbers of
  ///   weights; `zero_weight` unless the denominator is positive on the whole domain, `work_limit` when it is positive but comes too
  ///   close to zero inside, or has too high degrees; `dimension_mismatch`, `empty_domain`, `not_finite` as for `Bezier_patch`
  template <class Points, class Weights>
  Rational_bezier_patch(const Points& net, const Weights& weights, const Interval& u = unit_interval(),
                        const Interval& v = unit_interval())
      : Rational_bezier_patch(Net(internal::Control_net<Traits>(net, place), weights, place), u, v) {}
  /// Constructs a patch from a control net and weights that are written as lists of lists, and its domain.
  /// \throws Error as for ranges
  Rational_bezier_patch(std::initializer_list<std::initializer_list<Point>> net,
                        std::initializer_list<std::initializer_list<FT>> weights, const Interval& u = unit_interval(),
                        const Interval& v = unit_interval())
      : Rational_bezier_patch(Net(internal::Control_net<Traits>(net, place), weights, place), u, v) {}

  /// Takes the patch of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$.
  /// \throws Error `zero_weight`, `work_limit` as above, `not_finite` when a quotient overflows
  explicit Rational_bezier_patch(const Homogeneous& s)
      : Rational_bezier_patch(Net(s.degree_u() + 1, s.degree_v() + 1, s.begin(), s.end(), place), s.domain_u(),
                              s.domain_v()) {}

  /// Converts a polynomial patch: all weights are 1.
  Rational_bezier_patch(const Bezier_patch<Traits>& s)
      : net_(internal::Control_net<Traits>(s.degree_u() + 1, s.degree_v() + 1, {s.begin(), s.end()}, place)),
        u_(s.domain_u()), v_(s.domain_v()) {}

  int degree_u() const { return net_.rows() - 1; }            ///< Returns the degree `p` in `u`.
  int degree_v() const { return net_.columns() - 1; }         ///< Returns the degree `q` in `v`.
  int dimension() const { return net_.points().dimension(); } ///< Returns the dimension of the space.
  Interval domain_u() const { return u_; }                    ///< Returns [a, b].
  Interval domain_v() const { return v_; }                    ///< Returns [c, d].

  /// Returns the control point \f$ b_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  const Point& control_point(int i, int j) const { return net_.points()(i, j); }
  /// Returns the coordinates of \f$ b_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  Geometric_continuity::Coordinates<Traits> coordinates(int i, int j) const { return net_.points().coordinates(i, j); }
  const_iterator begin() const { return net_.points().begin(); } ///< Returns the begin of the control points.
  const_iterator end() const { return net_.points().end(); }     ///< Returns the end of the control points.

  /// \name Weights
  /// @{

  /// Returns the weights \f$ w_{00}, w_{01}, \dots, w_{pq} \f$.
  const std::vector<FT>& weights() const { return net_.weights(); }
  /// Returns the weight \f$ w_{ij} \f$. \pre `0 <= i <= degree_u()`, `0 <= j <= degree_v()`
  const FT& weight(int i, int j) const { return net_.weight(i, j); }

  /// Returns the polynomial patch of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$, on the same domain.
  /// \throws Error `not_finite` when a product of floating-point numbers overflows
  Homogeneous homogeneous() const { return Homogeneous(net_.homogeneous(), u_, v_); }

  /// Returns whether all weights are equal. Then the patch is a polynomial one with the same control points.
  bool is_polynomial() const { return net_.is_polynomial(); }
  /// Returns the polynomial patch with the same control points if all weights are equal, otherwise nothing.
  std::optional<Bezier_patch<Traits>> polynomial() const {
    if (!is_polynomial()) return std::nullopt;
    return Bezier_patch<Traits>(internal::part_of_net(net_.points(), 0, degree_u(), 0, degree_v()), u_, v_);
  }

  /// @}
  /// \name Evaluation
  /// The parameters may lie outside the domain, as long as the denominator is not zero (`zero_weight`).
  /// @{

  /// Returns the point at (`u`, `v`). \f$ O(pq^2 + p^2) \f$
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0` at (`u`, `v`). \f$ O(pq^2 + kp^2 + pk^3 + k^4) \f$
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    return project<Traits>(internal::bezier_jet<Homogeneous_traits<Traits>>(
        degree_u(), degree_v(), dimension() + 1, u_, v_, u, v, k,
        [&](int i, int j, int x) { return net_.homogeneous_coordinate(i, j, x); }));
  }

  /// Returns the derivative of order `i >= 0` in `u` and `j >= 0` in `v`; for `i = j = 0` the position vector.
  /// \throws Error `negative_count` for a negative order
  Vector partial(const FT& u, const FT& v, int i, int j) const {
    internal::check_count((std::min)(i, j), "Rational_bezier_patch: order of a partial derivative");
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
    const std::pair<int, int> k = index(edge, i, j);
    return control_point(k.first, k.second);
  }
  /// Returns the weight of the control point number `i` along the edge in the layer `j`.
  /// \pre `0 <= i <= degree_along(edge)`, `0 <= j <= degree_across(edge)`
  const FT& weight(Patch_edge edge, int i, int j) const {
    const std::pair<int, int> k = index(edge, i, j);
    return weight(k.first, k.second);
  }

  /// Returns the rows 0 to `k` at an edge of the polynomial patch of homogeneous points, see `Bezier_patch::rows()`. Control
  /// points and weights are converted to `Field` before anything is computed.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    return internal::bezier_rows<Field, (N == 0 ? 0 : N + 1)>(
        degree_along(edge), degree_across(edge), dimension() + 1, k, [&](int i, int j) {
          const std::pair<int, int> at = index(edge, i, j);
          return net_.template homogeneous<Field>(at.first, at.second);
        });
  }

  /// Returns the patch turned so that the edge is at `v = 0` and keeps its direction.
  Rational_bezier_patch oriented(Patch_edge edge) const {
    const Rational_bezier_patch r = runs_along_u(edge) ? *this : swap_parameters();
    return at_upper_end(edge) ? r.reverse_v() : r;
  }

  /// @}
  /// \name Operations
  /// Those that compute new control points throw as those of `Bezier_patch`.
  /// @{

  /// Returns the patch \f$ (u, v) \mapsto S(v, u) \f$.
  Rational_bezier_patch swap_parameters() const { return with(net_.transpose(), v_, u_); }
  /// Returns the patch \f$ (u, v) \mapsto S(a + b - u, v) \f$.
  Rational_bezier_patch reverse_u() const { return with(net_.reverse_rows(), u_, v_); }
  /// Returns the patch \f$ (u, v) \mapsto S(u, c + d - v) \f$.
  Rational_bezier_patch reverse_v() const { return with(net_.reverse_columns(), u_, v_); }

  /// Returns a patch with the same points whose degrees are raised by `times_u` and `times_v`.
  Rational_bezier_patch elevate(int times_u, int times_v) const {
    return Rational_bezier_patch(homogeneous().elevate(times_u, times_v));
  }

  /// Returns the parts on [a, u] and [u, b]. \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Rational_bezier_patch, Rational_bezier_patch> split_u(const FT& u) const {
    const std::pair<Homogeneous, Homogeneous> parts = homogeneous().split_u(u);
    return {Rational_bezier_patch(parts.first), Rational_bezier_patch(parts.second)};
  }
  /// Returns the parts on [c, v] and [v, d]. \throws Error `parameter_outside_domain` unless `c < v < d`
  std::pair<Rational_bezier_patch, Rational_bezier_patch> split_v(const FT& v) const {
    const std::pair<Homogeneous, Homogeneous> parts = homogeneous().split_v(v);
    return {Rational_bezier_patch(parts.first), Rational_bezier_patch(parts.second)};
  }

  /// Returns the patch with the same control points and weights on another domain.
  /// \throws Error `empty_domain` for a length that is not positive, `not_finite` for an end or a length that is not finite
  Rational_bezier_patch with_domain(const Interval& u, const Interval& v) const {
    internal::check_interval(u, "Rational_bezier_patch: domain in u");
    internal::check_interval(v, "Rational_bezier_patch: domain in v");
    return with(net_, u, v);
  }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Rational_bezier_patch transform(const Transformation& map) const {
    return with(net_.transform(map, "Rational_bezier_patch: image"), u_, v_);
  }

  /// Returns two opposite corners of a box that contains the patch: that of the control points where all weights are positive,
  /// otherwise that of the control points of its parts, see `positive_parts()`.
  std::pair<Point, Point> bounding_box() const {
    std::vector<Point> points;
    for (const Rational_bezier_patch& part : positive_parts()) points.insert(points.end(), part.begin(), part.end());
    return internal::corners_of_box<Traits>(points.begin(), points.end());
  }
  /// Returns the box as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(bounding_box()); }

  /// Returns the patch halved, in `u` and `v` in turn, until each part has positive weights only; then it lies in the convex hull
  /// of its control points.
  /// \throws Error `work_limit` where the denominator is so close to zero that 64 halvings in a row do not suffice
  std::vector<Rational_bezier_patch> positive_parts() const {
    std::vector<Rational_bezier_patch> parts;
    internal::add_positive_parts_of_patch(*this, 64, parts);
    return parts;
  }

  /// @}

  /// Tells whether all of them are equal: domains, degrees, control points and weights.
  friend bool operator==(const Rational_bezier_patch& s, const Rational_bezier_patch& t) {
    return s.u_ == t.u_ && s.v_ == t.v_ && s.net_ == t.net_;
  }
  /// Tells whether a domain, a degree, a control point or a weight differs.
  friend bool operator!=(const Rational_bezier_patch& s, const Rational_bezier_patch& t) { return !(s == t); }

  /// Writes the degrees, the domain, the control net and the weights, one row to a line.
  friend std::ostream& operator<<(std::ostream& os, const Rational_bezier_patch& s) {
    return os << "Rational Bezier patch of degree " << s.degree_u() << " x " << s.degree_v() << " on [" << s.u_.first
              << ", " << s.u_.second << "] x [" << s.v_.first << ", " << s.v_.second << "]:" << s.net_;
  }

private:
  static constexpr const char* place = "Rational_bezier_patch";

  Net net_;
  Interval u_, v_;

  static Interval unit_interval() { return Interval(FT(0), FT(1)); }

  Rational_bezier_patch(Net net, const Interval& u, const Interval& v) : net_(std::move(net)), u_(u), v_(v) {
    internal::check_interval(u_, "Rational_bezier_patch: domain in u");
    internal::check_interval(v_, "Rational_bezier_patch: domain in v");
    internal::check_surface_denominator(net_, "Rational_bezier_patch: weights");
  }

  // With another net whose denominator is known to be positive.
  Rational_bezier_patch with(Net net, const Interval& u, const Interval& v) const {
    Rational_bezier_patch r = *this;
    r.net_ = std::move(net);
    r.u_ = u;
    r.v_ = v;
    return r;
  }

  std::pair<int, int> index(Patch_edge edge, int i, int j) const {
    const int inward = at_upper_end(edge) ? degree_across(edge) - j : j;
    return runs_along_u(edge) ? std::make_pair(i, inward) : std::make_pair(inward, i);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BEZIER_PATCH_H
