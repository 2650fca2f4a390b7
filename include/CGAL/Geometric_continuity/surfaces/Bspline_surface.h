// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BSPLINE_SURFACE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BSPLINE_SURFACE_H

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A tensor-product B-spline surface \f$ S(u, v) = \sum_{i=0}^{m-1} \sum_{j=0}^{n-1} b_{ij} N_i^p(u) N_j^q(v) \f$ over two
/// `Knot_vector`s, one for `u` with `m` coefficients and one for `v` with `n` coefficients. The knots may have any
/// multiplicity up to degree + 1, and need not be clamped.
///
/// The surface is a value: operations return new surfaces. With an exact kernel they are exact. With rounded numbers,
/// insertion, refinement and Bézier patches take convex combinations only.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \models ParametricSurface
template <class Traits_> class Bspline_surface {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef std::pair<FT, FT> Interval;
  static constexpr int N = dimension_v<Traits>;

  /// A row of coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, N>>;

private:
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  typedef Bspline_function<FT, Coordinate_vector<FT, 0>>
      Rows; // u -> the coordinates of all columns, one after the other

  Knot_vector<FT> u_, v_;
  std::vector<Point> points_; // b_ij at i n + j

public:
  typedef typename std::vector<Point>::const_iterator const_iterator;

  /// From a control net and the knots. `net[i]` is the range \f$ b_{i0}, \dots, b_{i,n-1} \f$.
  /// \throws Error `wrong_number_of_points` unless there are `m` rows of `n` points,
  ///   `dimension_mismatch` when the points differ in dimension, `not_finite`
  template <class Net>
  Bspline_surface(const Net& net, Knot_vector<FT> knots_u, Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)) {
    take(net);
  }
  Bspline_surface(std::initializer_list<std::initializer_list<Point>> net, Knot_vector<FT> knots_u,
                  Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)) {
    take(net);
  }

  /// The same surface, without inner knots.
  explicit Bspline_surface(const Bezier_patch<Traits>& patch)
      : u_(patch.degree_u(), patch.domain_u().first, patch.domain_u().second),
        v_(patch.degree_v(), patch.domain_v().first, patch.domain_v().second), points_(patch.begin(), patch.end()) {}

  /// The degree `p` in `u`.
  int degree_u() const { return u_.degree(); }
  /// The degree `q` in `v`.
  int degree_v() const { return v_.degree(); }
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// \name Control Points and Knots
  /// @{

  /// The number `m` of control points in the direction of `u`.
  int number_of_points_u() const { return u_.number_of_coefficients(); }
  /// The number `n` of control points in the direction of `v`.
  int number_of_points_v() const { return v_.number_of_coefficients(); }
  /// The control point \f$ b_{ij} \f$, `0 <= i < m`, `0 <= j < n`.
  const Point& control_point(int i, int j) const { return points_[i * number_of_points_v() + j]; }
  /// The coordinates of \f$ b_{ij} \f$.
  Coordinates coordinates(int i, int j) const { return Geometric_continuity::coordinates<Traits>(control_point(i, j)); }
  /// The control points \f$ b_{00}, b_{01}, \dots, b_{m-1,n-1} \f$.
  const_iterator begin() const { return points_.begin(); }
  const_iterator end() const { return points_.end(); }

  const Knot_vector<FT>& knots_u() const { return u_; }
  const Knot_vector<FT>& knots_v() const { return v_; }
  /// The domain \f$ [u_p, u_m] \f$ of the knots in `u`.
  Interval domain_u() const { return u_.domain(); }
  /// The domain \f$ [v_q, v_n] \f$ of the knots in `v`.
  Interval domain_v() const { return v_.domain(); }

  /// @}
  /// \name Evaluation
  /// All these functions throw `Error` with `parameter_outside_domain` outside the domain, whose upper ends are included. At
  /// an inner knot they take the side of the larger parameters.
  /// @{

  /// The point at (`u`, `v`). \f$ O(\log m + \log n + p^2 + q^2 + pq) \f$
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// The jet of order `k >= 0` at (`u`, `v`); derivatives beyond the degrees are zero. \f$ O(\log m + \log n + kpq) \f$
  /// multiplications of a point, in addition to the weights of the derivatives in `u` and in `v`.
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    Surface_jet<Traits> jet(dimension(), k);
    const int p = degree_u(), q = degree_v(), span_u = u_.span(u), span_v = v_.span(v);
    std::vector<std::vector<Coordinates>> columns(k + 1); // derivatives with respect to v
    internal::derivative_weights(v_, q, span_v, v, k, [&](int j, const internal::Spline_weights<FT>& weights) {
      for (int i = span_u - p; i <= span_u; ++i) {
        Coordinates sum(dimension());
        for (int l = 0; l <= q; ++l) sum += weights.w[l] * coordinates(i, weights.first + l);
        columns[j].push_back(sum);
      }
    });
    internal::derivative_weights(u_, p, span_u, u, k, [&](int i, const internal::Spline_weights<FT>& weights) {
      for (int j = 0; j <= k - i; ++j)
        for (int l = 0; l <= p && !columns[j].empty(); ++l) jet(i, j) += weights.w[l] * columns[j][l];
    });
    return jet;
  }

  /// The derivative of order `i` in `u` and `j` in `v`, `i + j > 0`.
  Vector partial(const FT& u, const FT& v, int i, int j) const { return jet(u, v, i + j).partial(i, j); }

  /// The normal \f$ S_u \times S_v \f$, not normalised; zero where the surface is not regular.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(jet(u, v, 1)); }

  /// The unit normal, empty where \f$ S_u \times S_v = 0 \f$; only for number types that have a square root.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  std::optional<Vector> unit_normal(const FT& u, const FT& v) const {
    return Geometric_continuity::unit_normal(jet(u, v, 1));
  }

  /// @}
  /// \name Edges
  /// @{

  /// The knots of an edge.
  const Knot_vector<FT>& knots_along(Patch_edge edge) const { return runs_along_u(edge) ? u_ : v_; }
  /// The knots in the parameter that is constant on an edge.
  const Knot_vector<FT>& knots_across(Patch_edge edge) const { return runs_along_u(edge) ? v_ : u_; }

  /// The edge as a curve over the knots of the surface. \f$ O(m q + q^2) \f$ for an edge run through by `u`
  Bspline_curve<Traits> boundary_curve(Patch_edge edge) const {
    std::vector<Point> points;
    const std::vector<Row<FT>> edge_row = rows(edge, 0);
    for (const Coordinates& x : edge_row[0]) points.push_back(Geometric_continuity::to_point<Traits>(x));
    return Bspline_curve<Traits>(points.begin(), points.end(), knots_along(edge));
  }

  /// The rows 0 to `k` at an edge: the coefficients, over `knots_along(edge)`, of the edge and of the first `k` derivatives
  /// across it, with respect to the parameter that grows into the surface. Rows beyond the degree are zero. Control points
  /// and knots are converted to `Field` before anything is computed.
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    const bool upper = at_upper_end(edge);
    const Interval across = knots_across(edge).domain();
    return rows_at<Field>(runs_along_u(edge), upper ? across.second : across.first, upper, k);
  }

  /// The rows 0 to `k` at the line on which `v` (if `along_u`) or `u` is a given parameter of the domain: the coefficients,
  /// over the knots along the line, of the line and of the first `k` derivatives across it, of the part of the surface at
  /// larger parameters or, if `from_below`, at smaller ones, with respect to the parameter that grows into that part. At an
  /// end of the domain they are those of the only part.
  /// \throws Error `parameter_outside_domain`
  template <class Field = FT>
  std::vector<Row<Field>> rows_at(bool along_u, const FT& parameter, bool from_below, int k) const {
    const Knot_vector<FT>& across = along_u ? v_ : u_;
    const int q = across.degree(), m = (along_u ? u_ : v_).number_of_coefficients(),
              span = from_below ? across.left_span(parameter) : across.span(parameter);
    std::vector<Field> knots; // next to the line, with the control points that belong to them
    for (int j = span - q; j <= span + q; ++j) knots.push_back(internal::to_field<Field>(across[j]));
    std::vector<Row<Field>> points(m);
    for (int i = 0; i < m; ++i)
      for (int j = span - q; j <= span; ++j)
        points[i].push_back(
            Geometric_continuity::coordinates<Traits, Field>(along_u ? control_point(i, j) : control_point(j, i)));
    std::vector<Row<Field>> rows(k + 1, Row<Field>(m, Coordinate_vector<Field, N>(dimension())));
    internal::derivative_weights(knots, q, q, internal::to_field<Field>(parameter), k,
                                 [&](int r, const internal::Spline_weights<Field>& weights) {
                                   const Field sign(from_below && r % 2 == 1 ? -1 : 1);
                                   for (int i = 0; i < m; ++i) rows[r][i] = sign * weights(points[i]);
                                 });
    return rows;
  }

  /// @}
  /// \name Operations
  /// The costs are those of the operation on `n` curves with `m` control points, or the reverse.
  /// @{

  /// The surface \f$ (u, v) \mapsto S(v, u) \f$.
  Bspline_surface swap_parameters() const {
    std::vector<Point> points;
    for (int j = 0; j < number_of_points_v(); ++j)
      for (int i = 0; i < number_of_points_u(); ++i) points.push_back(control_point(i, j));
    return Bspline_surface(std::move(points), v_, u_);
  }

  /// The surface run through backwards in `u`, on the same domain, see `Knot_vector::reverse()`.
  Bspline_surface reverse_u() const {
    return along_u([](const Rows& rows) { return rows.reverse(); });
  }
  /// The same in `v`.
  Bspline_surface reverse_v() const {
    return along_v([](const Rows& rows) { return rows.reverse(); });
  }

  /// The same surface with the degrees raised by `times_u >= 0` and `times_v >= 0`. A direction in which the degree is raised
  /// becomes clamped; the multiplicities of its inner knots rise as much.
  /// \throws Error `wrong_number_of_points` for a negative number
  Bspline_surface elevate(int times_u, int times_v) const {
    const auto elevated = [](int times) {
      return [times](const Rows& rows) { return times == 0 ? rows : rows.elevate(times); };
    };
    return along_u(elevated(times_u)).along_v(elevated(times_v));
  }

  /// The same surface with `times >= 0` more copies of the knot `u`.
  /// \throws Error `parameter_outside_domain`, and `knot_multiplicity` when it would be repeated more than `p + 1` times
  Bspline_surface insert_u(const FT& u, int times = 1) const {
    return along_u([&](const Rows& rows) { return rows.insert(u, times); });
  }
  /// The same in `v`.
  Bspline_surface insert_v(const FT& v, int times = 1) const {
    return along_v([&](const Rows& rows) { return rows.insert(v, times); });
  }

  /// The same surface over finer knots, see `bspline_refine()`.
  /// \throws Error `wrong_number_of_points` when the degrees differ, `parameter_outside_domain` when the domains differ,
  ///   `knot_multiplicity` when a knot is missing
  Bspline_surface refine(const Knot_vector<FT>& finer_u, const Knot_vector<FT>& finer_v) const {
    return along_u([&](const Rows& rows) { return rows.refine(finer_u); }).along_v([&](const Rows& rows) {
      return rows.refine(finer_v);
    });
  }

  /// The same surface without the knots outside the domain, and with control points at its corners.
  Bspline_surface clamp() const { return refine(u_.clamp(), v_.clamp()); }

  /// The image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Bspline_surface transform(const Transformation& map) const {
    Bspline_surface r = *this;
    for (Point& p : r.points_) p = map(p);
    return r;
  }

  /// The Bézier patches on the rectangles of a span in `u` and a span in `v`, each with its rectangle as domain. All that
  /// belong to the first span in `u` come first. \f$ O(mn(p^3 + q^3)) \f$
  std::vector<Bezier_patch<Traits>> bezier_patches() const {
    const Bspline_surface r = refine(u_.bezier(degree_u()), v_.bezier(degree_v()));
    std::vector<Bezier_patch<Traits>> patches;
    for (int k : r.u_.spans())
      for (int l : r.v_.spans()) { // the last control points of the patch are b_kl
        std::vector<std::vector<Point>> net;
        for (int i = k - degree_u(); i <= k; ++i) {
          const auto last = r.points_.begin() + (i * r.number_of_points_v() + l + 1);
          net.emplace_back(last - (degree_v() + 1), last);
        }
        patches.emplace_back(net, Interval(r.u_[k], r.u_[k + 1]), Interval(r.v_[l], r.v_[l + 1]));
      }
    return patches;
  }

  /// @}

  /// Equality of knots and control points.
  friend bool operator==(const Bspline_surface& s, const Bspline_surface& t) {
    return s.u_ == t.u_ && s.v_ == t.v_ && s.points_ == t.points_;
  }
  friend bool operator!=(const Bspline_surface& s, const Bspline_surface& t) { return !(s == t); }

  /// Writes the degrees, the knots and the control net, one row \f$ b_{i0}, \dots, b_{i,n-1} \f$ to a line.
  friend std::ostream& operator<<(std::ostream& os, const Bspline_surface& s) {
    os << "B-spline surface of degree " << s.degree_u() << " x " << s.degree_v() << " over " << s.u_ << " and " << s.v_
       << ':';
    for (int i = 0; i < s.number_of_points_u(); ++i) {
      os << '\n';
      for (int j = 0; j < s.number_of_points_v(); ++j) {
        const Coordinates p = s.coordinates(i, j);
        for (int x = 0; x < p.dimension(); ++x) os << (x > 0 ? ", " : j > 0 ? " (" : "(") << p[x];
        os << ')';
      }
    }
    return os;
  }

private:
  Bspline_surface(std::vector<Point> points, Knot_vector<FT> knots_u, Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)), points_(std::move(points)) {
    check();
  }

  template <class Net> void take(const Net& net) {
    for (const auto& row : net) check_number(std::distance(std::begin(row), std::end(row)), v_, "points in a row");
    check_number(std::distance(std::begin(net), std::end(net)), u_, "rows");
    for (const auto& row : net) points_.insert(points_.end(), std::begin(row), std::end(row));
    check();
  }

  template <class Size> static void check_number(Size size, const Knot_vector<FT>& knots, const char* what) {
    if (size != knots.number_of_coefficients())
      throw Error(Error_code::wrong_number_of_points, "Bspline_surface: " + std::to_string(size) + ' ' + what +
                                                          " where the knots need " +
                                                          std::to_string(knots.number_of_coefficients()));
  }

  void check() const {
    for (int i = 0; i < number_of_points_u(); ++i)
      for (int j = 0; j < number_of_points_v(); ++j) {
        const Coordinates x = coordinates(i, j);
        if (x.dimension() != dimension())
          throw Error(Error_code::dimension_mismatch,
                      "Bspline_surface: control point " + std::to_string(i) + ", " + std::to_string(j));
        for (const FT& c : x) internal::check_finite(c, "Bspline_surface: control points");
      }
  }

  // The surface after an operation on all its columns at once.
  template <class Operation> Bspline_surface along_u(Operation operation) const {
    const int n = number_of_points_v(), d = dimension();
    std::vector<Coordinate_vector<FT, 0>> rows;
    for (int i = 0; i < number_of_points_u(); ++i) {
      rows.emplace_back(n * d);
      for (int j = 0; j < n; ++j) {
        const Coordinates x = coordinates(i, j);
        for (int l = 0; l < d; ++l) rows.back()[j * d + l] = x[l];
      }
    }
    const Rows result = operation(Rows(u_, std::move(rows)));
    std::vector<Point> points;
    for (const Coordinate_vector<FT, 0>& row : result.coefficients())
      for (int j = 0; j < n; ++j) {
        Coordinates x(d);
        for (int l = 0; l < d; ++l) x[l] = row[j * d + l];
        points.push_back(Geometric_continuity::to_point<Traits>(x));
      }
    return Bspline_surface(std::move(points), result.knots(), v_);
  }
  template <class Operation> Bspline_surface along_v(Operation operation) const {
    return swap_parameters().along_u(operation).swap_parameters();
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BSPLINE_SURFACE_H
