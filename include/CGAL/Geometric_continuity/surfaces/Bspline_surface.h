// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BSPLINE_SURFACE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BSPLINE_SURFACE_H

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/internal/bspline_net.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A tensor-product B-spline surface
/// \f$ S(u, v) = \sum_{i=0}^{m-1} \sum_{j=0}^{n-1} b_{ij} N_i^p(u) N_j^q(v) \f$ over two
/// `Knot_vector`s, one for `u` with `m` coefficients and one for `v` with `n` coefficients. The
/// knots may have any multiplicity up to degree + 1, and need not be clamped.
///
/// The surface is a value: operations return new surfaces. With an exact kernel they are exact.
/// With rounded numbers, insertion, refinement and Bézier patches take convex combinations only,
/// and a result that overflows is refused: all functions that compute points throw `Error` with
/// `not_finite` instead of returning infinite numbers or NaN.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \cgalModels{ParametricSurface}
template <class Traits_> class Bspline_surface : public Surface_evaluation<Bspline_surface<Traits_>, Traits_> {
  typedef Surface_evaluation<Bspline_surface<Traits_>, Traits_> Base;

public:
  using Base::N;
  using typename Base::FT;
  using typename Base::Interval;
  using typename Base::Point;
  using typename Base::Traits;

  /// A row of coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, N>>;

private:
  typedef internal::Control_net<Traits> Net;
  typedef internal::Spline_of_rows<Traits> Spline;
  template <class Shape> friend class Rational_surface; // takes and gives the net as it is

  Knot_vector<FT> u_, v_;
  Net net_;

public:
  typedef typename Net::const_iterator const_iterator; ///< an iterator over control points

  /// Constructs a surface from a control net and the knots. `net[i]` is the range
  /// \f$ b_{i0}, \dots, b_{i,n-1} \f$.
  /// \throws Error `wrong_number_of_points` unless there are `m` rows of `n` points,
  ///   `dimension_mismatch` when the points differ in dimension, `not_finite` for floating-point
  ///   coordinates that are infinite or not a number
  template <class Points>
  Bspline_surface(const Points& net, Knot_vector<FT> knots_u, Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)), net_(internal::spline_net<Traits>(net, u_, v_)) {}
  /// Constructs a surface from a control net that is written as a list of lists, and the knots.
  /// \throws Error `wrong_number_of_points`, `dimension_mismatch` or `not_finite` for what is no
  ///   net for the knots
  Bspline_surface(std::initializer_list<std::initializer_list<Point>> net, Knot_vector<FT> knots_u,
                  Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)), net_(internal::spline_net<Traits>(net, u_, v_)) {}

  // This refuses knots without a degree before them, by one error of the compiler instead of a list
  // of all constructors.
  template <
      class First, class Second, class Third, class... Others,
      class = std::enable_if_t<(sizeof...(Others) > 0) || !std::is_convertible_v<const Second&, Knot_vector<FT>> ||
                               !std::is_convertible_v<const Third&, Knot_vector<FT>>>>
  Bspline_surface(const First&, const Second&, const Third&, const Others&...)
      : Bspline_surface(internal::refused_surface<Bspline_surface>()) {}

  // This refuses points that are not in rows.
  template <class Given, class = std::enable_if_t<std::is_same_v<Given, Point>>>
  Bspline_surface(std::initializer_list<Given> points, const Knot_vector<FT>& knots_u, const Knot_vector<FT>& knots_v)
      : Bspline_surface(std::vector<Given>(points), knots_u, knots_v) {}

  /// Constructs the surface without inner knots that is equal to a patch.
  explicit Bspline_surface(const Bezier_patch<Traits>& patch)
      : u_(patch.degree_u(), patch.domain_u().first, patch.domain_u().second),
        v_(patch.degree_v(), patch.domain_v().first, patch.domain_v().second),
        net_(patch.degree_u() + 1, patch.degree_v() + 1, std::vector<Point>(patch.begin(), patch.end()),
             "Bspline_surface") {}

  int degree_u() const { return u_.degree(); }       ///< Returns the degree `p` in `u`.
  int degree_v() const { return v_.degree(); }       ///< Returns the degree `q` in `v`.
  int dimension() const { return net_.dimension(); } ///< Returns the dimension of the space.

  /// \name Control Points and Knots
  /// @{

  /// Returns the number `m` of control points in the direction of `u`.
  int number_of_points_u() const { return net_.rows(); }
  /// Returns the number `n` of control points in the direction of `v`.
  int number_of_points_v() const { return net_.columns(); }
  /// Returns the control point \f$ b_{ij} \f$. \pre `0 <= i < m`, `0 <= j < n`
  const Point& control_point(int i, int j) const { return net_(i, j); }
  /// Returns the coordinates of \f$ b_{ij} \f$. \pre `0 <= i < m`, `0 <= j < n`
  Coordinates<Traits> coordinates(int i, int j) const { return net_.coordinates(i, j); }
  const_iterator begin() const {
    return net_.begin();
  } ///< Returns the begin of \f$ b_{00}, b_{01}, \dots, b_{m-1,n-1} \f$.
  const_iterator end() const { return net_.end(); } ///< Returns the end of the control points.

  const Knot_vector<FT>& knots_u() const { return u_; } ///< Returns the knots in `u`.
  const Knot_vector<FT>& knots_v() const { return v_; } ///< Returns the knots in `v`.
  /// Returns the domain \f$ [u_p, u_m] \f$ of the knots in `u`.
  Interval domain_u() const { return u_.domain(); }
  /// Returns the domain \f$ [v_q, v_n] \f$ of the knots in `v`.
  Interval domain_v() const { return v_.domain(); }

  /// @}
  /// \name Evaluation
  /// All these functions throw `Error` with `parameter_outside_domain` outside the domain, whose
  /// upper ends are included. At an inner knot they take the side of the larger parameters.
  /// @{

  /// Returns the point at (`u`, `v`). \f$ O(\log m + \log n + p^2 + q^2 + pq) \f$
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0` at (`u`, `v`); derivatives beyond the degrees are zero.
  /// \f$ O(\log m + \log n + kpq) \f$ multiplications of a point, in addition to the weights of the
  /// derivatives in `u` and in `v`.
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    const Traits traits;
    const Surface_jet<Traits> jet =
        internal::bspline_jet<Traits>(dimension(), u_, v_, u, v, k, [&](int i, int j, int x) {
          return FT(traits.compute_coordinate_object()(net_(i, j), x));
        });
    internal::check_jet(jet, "Bspline_surface: jet");
    return jet;
  }

  /// @}
  /// \name Edges
  /// @{

  /// Returns the knots of an edge.
  const Knot_vector<FT>& knots_along(Patch_edge edge) const { return runs_along_u(edge) ? u_ : v_; }
  /// Returns the knots in the parameter that is constant on an edge.
  const Knot_vector<FT>& knots_across(Patch_edge edge) const { return runs_along_u(edge) ? v_ : u_; }

  /// Returns the rows 0 to `k` at an edge: the coefficients, over `knots_along(edge)`, of the edge
  /// and of the first `k` derivatives across it, with respect to the parameter that grows into the
  /// surface. Rows beyond the degree are zero. Control points and knots are converted to `Field`
  /// before anything is computed.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    const Interval across = knots_across(edge).domain();
    const Parameter_line line = runs_along_u(edge) ? Parameter_line::along_u : Parameter_line::along_v;
    return at_upper_end(edge) ? rows_at<Field>(line, across.second, Line_side::smaller_parameters, k)
                              : rows_at<Field>(line, across.first, Line_side::larger_parameters, k);
  }

  /// Returns the rows 0 to `k` at the line on which one parameter has a constant value: the
  /// coefficients, over the knots along the line, of the line and of the first `k` derivatives
  /// across it, of the part of the surface on one side of the line, with respect to the parameter
  /// that grows into that part. At an end of the domain they are those of the only part. Rows
  /// beyond the degree are zero. Control points and knots are converted to `Field` before anything
  /// is computed.
  /// \throws Error `parameter_outside_domain` for a parameter outside the domain, `negative_count`
  ///   unless `k >= 0`
  template <class Field = FT>
  std::vector<Row<Field>> rows_at(Parameter_line line, const FT& parameter, Line_side side, int k) const {
    return internal::bspline_rows_at<Field, N>(u_, v_, dimension(), line, parameter, side, k, [&](int i, int j) {
      return Geometric_continuity::coordinates<Traits, Field>(net_(i, j));
    });
  }

  /// @}
  /// \name Operations
  /// The costs are those of the operation on `n` curves with `m` control points, or the reverse.
  /// @{

  /// Returns the surface \f$ (u, v) \mapsto S(v, u) \f$.
  Bspline_surface swap_parameters() const { return Bspline_surface(net_.transpose(), v_, u_); }

  /// Returns the surface with `u` in the opposite direction, on the same domain, see
  /// `Knot_vector::reverse()`.
  Bspline_surface reverse_u() const {
    return along_u([](const Spline& spline) { return spline.reverse(); });
  }
  /// Returns the surface with `v` in the opposite direction, on the same domain, see
  /// `Knot_vector::reverse()`.
  Bspline_surface reverse_v() const {
    return along_v([](const Spline& spline) { return spline.reverse(); });
  }

  /// Returns a surface with the same points whose degrees are raised by `times_u` and `times_v`. A
  /// direction in which the degree is raised becomes clamped; the multiplicities of its inner knots
  /// rise as much.
  /// \throws Error `negative_count` for a negative number, `work_limit` for a degree that would be
  ///   raised above 4096
  Bspline_surface elevate(int times_u, int times_v) const {
    internal::check_elevation(degree_u(), times_u, "Bspline_surface: elevate in u");
    internal::check_elevation(degree_v(), times_v, "Bspline_surface: elevate in v");
    const auto elevated = [](int times) {
      return [times](const Spline& spline) { return times == 0 ? spline : spline.elevate(times); };
    };
    return along_u(elevated(times_u)).along_v(elevated(times_v));
  }

  /// Returns a surface with the same points and `times` more copies of the knot `u`.
  /// \throws Error `negative_count` unless `times >= 0`, `parameter_outside_domain` outside the
  ///   domain, `knot_multiplicity` when the knot would be repeated more than `p + 1` times
  Bspline_surface insert_u(const FT& u, int times = 1) const {
    internal::check_insertion(u_, times);
    return along_u([&](const Spline& spline) { return spline.insert(u, times); });
  }
  /// Returns a surface with the same points and `times` more copies of the knot `v`.
  /// \throws Error `negative_count` unless `times >= 0`, `parameter_outside_domain` outside the
  ///   domain, `knot_multiplicity` when the knot would be repeated more than `q + 1` times
  Bspline_surface insert_v(const FT& v, int times = 1) const {
    internal::check_insertion(v_, times);
    return along_v([&](const Spline& spline) { return spline.insert(v, times); });
  }

  /// Returns a surface with the same points over finer knots, see `bspline_refine()`.
  /// \throws Error `wrong_number_of_points` when the degrees differ, `parameter_outside_domain`
  ///   when the domains differ, `knot_multiplicity` when a knot is missing
  Bspline_surface refine(const Knot_vector<FT>& finer_u, const Knot_vector<FT>& finer_v) const {
    return along_u([&](const Spline& spline) { return spline.refine(finer_u); }).along_v([&](const Spline& spline) {
      return spline.refine(finer_v);
    });
  }

  /// Returns a surface with the same points, without the knots outside the domain, and with control
  /// points at its corners.
  Bspline_surface clamp() const { return refine(u_.clamp(), v_.clamp()); }

  /// Returns the parts where the parameter in `u` is at most `u`, and at least `u`. Knots outside
  /// of the domain stay, and the end between the parts is clamped.
  /// \throws Error `parameter_outside_domain` unless `u` is inside of the domain in `u`
  std::pair<Bspline_surface, Bspline_surface> split_u(const FT& u) const {
    const Interval domain = domain_u();
    if (!(domain.first < u && u < domain.second))
      throw Error(Error_code::parameter_outside_domain, "Bspline_surface: split");
    const int p = degree_u();
    const Bspline_surface cut = insert_u(u, p + 1 - u_.multiplicity(u));
    const auto copies = std::lower_bound(cut.u_.begin(), cut.u_.end(), u);
    const int first = static_cast<int>(copies - cut.u_.begin()), last = cut.net_.rows() - 1, n = cut.net_.columns() - 1;
    return {Bspline_surface(internal::part_of_net(cut.net_, 0, first - 1, 0, n),
                            Knot_vector<FT>(p, std::vector<FT>(cut.u_.begin(), copies + p + 1)), v_),
            Bspline_surface(internal::part_of_net(cut.net_, first, last, 0, n),
                            Knot_vector<FT>(p, std::vector<FT>(copies, cut.u_.end())), v_)};
  }

  /// Returns the parts where the parameter in `v` is at most `v`, and at least `v`, see
  /// `split_u()`.
  /// \throws Error `parameter_outside_domain` unless `v` is inside of the domain in `v`
  std::pair<Bspline_surface, Bspline_surface> split_v(const FT& v) const {
    const std::pair<Bspline_surface, Bspline_surface> parts = swap_parameters().split_u(v);
    return {parts.first.swap_parameters(), parts.second.swap_parameters()};
  }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Bspline_surface transform(const Transformation& map) const {
    return Bspline_surface(net_.transform(map, "Bspline_surface: image"), u_, v_);
  }

  /// Returns the Bézier patches on the rectangles of a span in `u` and a span in `v`, each with its
  /// rectangle as domain. All that belong to the first span in `u` come first.
  /// \f$ O(mn(p^3 + q^3)) \f$
  std::vector<Bezier_patch<Traits>> bezier_patches() const {
    std::vector<Bezier_patch<Traits>> patches;
    patches.reserve(static_cast<std::size_t>(u_.number_of_spans()) * v_.number_of_spans());
    for_each_bezier_patch([&](Bezier_patch<Traits> patch) { patches.push_back(std::move(patch)); });
    return patches;
  }

  /// Calls `f(patch)` for each of the Bézier patches that `bezier_patches()` returns, in the same
  /// order. Only those of one span in `u` are in memory. \f$ O(mn(p^3 + q^3)) \f$
  template <class Function> void for_each_bezier_patch(Function f) const {
    const int p = degree_u(), q = degree_v();
    const Bspline_surface strips = along_u([&](const Spline& spline) { return spline.refine(u_.bezier(p)); });
    const Knot_vector<FT> bezier_v = v_.bezier(q);
    for (int k : strips.u_.spans()) {
      const Interval u(strips.u_[k], strips.u_[k + 1]);
      const Bspline_surface strip(internal::part_of_net(strips.net_, k - p, k, 0, net_.columns() - 1),
                                  Knot_vector<FT>(p, u.first, u.second), v_);
      const Bspline_surface cut = strip.along_v([&](const Spline& spline) { return spline.refine(bezier_v); });
      for (int l : cut.v_.spans())
        f(Bezier_patch<Traits>(internal::part_of_net(cut.net_, 0, p, l - q, l), u, Interval(cut.v_[l], cut.v_[l + 1])));
    }
  }

  /// @}

  /// Tells whether knots and control points are equal.
  friend bool operator==(const Bspline_surface& s, const Bspline_surface& t) {
    return s.u_ == t.u_ && s.v_ == t.v_ && s.net_ == t.net_;
  }
  /// Tells whether a knot or a control point differs.
  friend bool operator!=(const Bspline_surface& s, const Bspline_surface& t) { return !(s == t); }

  /// Writes the degrees, the knots and the control net, one row \f$ b_{i0}, \dots, b_{i,n-1} \f$ to
  /// a line.
  friend std::ostream& operator<<(std::ostream& os, const Bspline_surface& s) {
    return os << "B-spline surface of degree " << s.degree_u() << " x " << s.degree_v() << " over " << s.u_ << " and "
              << s.v_ << ':' << s.net_;
  }

private:
  Bspline_surface(Net net, Knot_vector<FT> knots_u, Knot_vector<FT> knots_v)
      : u_(std::move(knots_u)), v_(std::move(knots_v)), net_(std::move(net)) {
    internal::check_number_of_points(net_.rows(), u_, "rows");
    internal::check_number_of_points(net_.columns(), v_, "points in a row");
  }

  // The surface after an operation on all its columns at once.
  template <class Operation> Bspline_surface along_u(Operation operation) const {
    const Spline result = operation(internal::spline_of_rows(net_, u_));
    return Bspline_surface(internal::net_of<Traits>(result, net_.columns(), dimension()), result.knots(), v_);
  }
  template <class Operation> Bspline_surface along_v(Operation operation) const {
    return swap_parameters().along_u(operation).swap_parameters();
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a B-spline surface as a curve over the knots of the surface along the edge.
/// The knots across the edge need not be clamped. \f$ O(m q + q^2) \f$ for an edge with `m` control
/// points, of degree `q` across the edge
template <class Traits> Bspline_curve<Traits> boundary_curve(const Bspline_surface<Traits>& surface, Patch_edge edge) {
  std::vector<typename Traits::Point> points;
  const auto rows = surface.rows(edge, 0);
  for (const Coordinates<Traits>& x : rows[0]) points.push_back(to_point<Traits>(x));
  return Bspline_curve<Traits>(points.begin(), points.end(), surface.knots_along(edge));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BSPLINE_SURFACE_H
