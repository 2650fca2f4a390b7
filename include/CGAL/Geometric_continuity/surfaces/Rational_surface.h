// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_SURFACE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_SURFACE_H

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/internal/surface_denominator.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Describes the differences between the shapes of rational surfaces. A side gives the domain in one
// parameter.
template <class Shape> struct Surface_shape;
template <class Traits> struct Surface_shape<Bezier_patch<Traits>> {
  typedef Bezier_patch<Homogeneous_traits<Traits>> Homogeneous;
  typedef std::pair<typename Traits::FT, typename Traits::FT> Side;
  static constexpr bool is_spline = false;
  static constexpr const char *name = "Rational_bezier_patch", *image = "Rational_bezier_patch: image";

  static Side unit() { return Side(typename Traits::FT(0), typename Traits::FT(1)); }
  template <class Points> static Control_net<Traits> net(const Points& points, const Side&, const Side&) {
    return Control_net<Traits>(points, name);
  }
  static void check(const Control_net<Traits>& net, const std::vector<typename Traits::FT>& weights, const Side& u,
                    const Side& v) {
    check_interval(u, "Rational_bezier_patch: domain in u");
    check_interval(v, "Rational_bezier_patch: domain in v");
    check_surface_denominator(net.rows(), net.columns(), weights, "Rational_bezier_patch: weights");
  }
};
template <class Traits> struct Surface_shape<Bspline_surface<Traits>> {
  typedef Bspline_surface<Homogeneous_traits<Traits>> Homogeneous;
  typedef Knot_vector<typename Traits::FT> Side;
  static constexpr bool is_spline = true;
  static constexpr const char *name = "Rational_bspline_surface", *image = "Rational_bspline_surface: image";

  template <class Points> static Control_net<Traits> net(const Points& points, const Side& u, const Side& v) {
    return spline_net<Traits>(points, u, v);
  }
  static void check(const Control_net<Traits>&, const std::vector<typename Traits::FT>& weights, const Side& u,
                    const Side& v) {
    check_surface_denominator(weights, u, v, "Rational_bspline_surface: weights");
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product surface
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} B_i(u) B_j(v) / \sum_{ij} w_{ij} B_i(u) B_j(v) \f$:
/// control points \f$ b_{ij} \f$ with weights \f$ w_{ij} \f$ in a polynomial shape, a
/// `Bezier_patch` or a `Bspline_surface`, whose basis functions are the \f$ B_i \f$ and
/// \f$ B_j \f$. Cylinders, spheres, tori, and all NURBS surfaces. `Rational_bezier_patch` and
/// `Rational_bspline_surface` are its names.
///
/// Numerator and denominator are a polynomial surface of the homogeneous points
/// \f$ (w_{ij} b_{ij}, w_{ij}) \f$, see `homogeneous()`, and all that is done with this surface is
/// done with that one. A common factor of all weights changes nothing.
///
/// A weight may be negative or zero as long as the denominator is positive on the whole domain,
/// which is decided exactly; see `Rational_curve` for the control points of the weight 0.
///
/// The surface is a value: operations return new surfaces. With an exact kernel they are exact.
///
/// \tparam Shape `Bezier_patch<Traits>` or `Bspline_surface<Traits>`
/// \cgalModels{ParametricSurface}
template <class Shape_>
class Rational_surface : public Surface_evaluation<Rational_surface<Shape_>, typename Shape_::Traits> {
  typedef Surface_evaluation<Rational_surface<Shape_>, typename Shape_::Traits> Base;
  typedef internal::Surface_shape<Shape_> Kind;
  typedef typename Kind::Side Side;
  static constexpr bool is_spline = Kind::is_spline;

public:
  using Base::N;
  using typename Base::FT;
  using typename Base::Interval;
  using typename Base::Point;
  using typename Base::Traits;
  /// the polynomial surface with the same control points
  typedef Shape_ Shape;
  /// the polynomial surface of the homogeneous points
  typedef typename Kind::Homogeneous Homogeneous;

  /// A row of homogeneous coordinates along an edge.
  template <class Field> using Row = std::vector<Coordinate_vector<Field, (N == 0 ? 0 : N + 1)>>;
  /// An iterator over control points.
  typedef typename Shape::const_iterator const_iterator;

  /// Constructs a surface from a control net, a net of as many weights and what tells the domain in
  /// `u` and in `v`: the knots of a B-spline surface, or the two intervals of a Bézier patch, by
  /// default [0, 1]. `net[i]` is the range \f$ b_{i0}, b_{i1}, \dots \f$, and `weights[i]` that of
  /// the weights.
  /// \throws Error `wrong_number_of_points` for a net without points, with rows of different
  ///   lengths, with others than the knots need, or with other numbers of weights; `zero_weight`
  ///   unless the denominator is positive on the whole domain, `work_limit` when it is positive but
  ///   comes too close to zero inside, or has too high degrees for that to be decided there;
  ///   `dimension_mismatch`, `empty_domain`, `not_finite` as for the polynomial shape
  template <class Points, class Weights>
  Rational_surface(const Points& net, const Weights& weights, const Side& u = Kind::unit(),
                   const Side& v = Kind::unit())
      : Rational_surface(given(Kind::net(net, u, v), weights, u, v)) {}
  /// Constructs a surface from a control net and weights that are written as lists of lists.
  /// \throws Error as for ranges
  Rational_surface(std::initializer_list<std::initializer_list<Point>> net,
                   std::initializer_list<std::initializer_list<FT>> weights, const Side& u = Kind::unit(),
                   const Side& v = Kind::unit())
      : Rational_surface(given(Kind::net(net, u, v), weights, u, v)) {}

  // This refuses weights that are missing, or given behind knots or domains.
  template <class Points, class... Weights, class = std::enable_if_t<sizeof...(Weights) < 2>>
  Rational_surface(const Points&, const Side&, const Side&, const Weights&...)
      : Rational_surface(Homogeneous(Homogeneous(internal::No_result()))) {
    static_assert(!std::is_same_v<Points, Points>,
                  "Rational_bspline_surface<Traits>(net, weights, knots_u, knots_v) and "
                  "Rational_bezier_patch<Traits>(net, weights) take the weights in "
                  "rows, like the points");
  }

  /// Takes the surface of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$.
  /// \throws Error `zero_weight`, `work_limit` as above, `not_finite` when a quotient overflows
  explicit Rational_surface(const Homogeneous& s) : Rational_surface(affine_net(s), weights_of(s), s.u_, s.v_) {}

  /// Converts a polynomial surface: all weights are 1.
  Rational_surface(const Shape& s) : shape_(s), weights_(s.end() - s.begin(), FT(1)) {}

  /// Converts a rational Bézier patch to a B-spline surface.
  template <class Other, class = std::enable_if_t<is_spline && std::is_same_v<Other, Bezier_patch<Traits>>>>
  explicit Rational_surface(const Rational_surface<Other>& s) : shape_(s.unweighted()), weights_(s.weights()) {}

  int degree_u() const { return shape_.degree_u(); }      ///< Returns the degree `p` in `u`.
  int degree_v() const { return shape_.degree_v(); }      ///< Returns the degree `q` in `v`.
  int dimension() const { return shape_.dimension(); }    ///< Returns the dimension of the space.
  Interval domain_u() const { return shape_.domain_u(); } ///< Returns the domain in `u`.
  Interval domain_v() const { return shape_.domain_v(); } ///< Returns the domain in `v`.

  /// \name Control Points and Weights
  /// @{

  /// Returns the control point \f$ b_{ij} \f$. \pre there is one
  const Point& control_point(int i, int j) const { return shape_.control_point(i, j); }
  /// Returns the coordinates of \f$ b_{ij} \f$. \pre there is one
  Coordinates<Traits> coordinates(int i, int j) const { return shape_.coordinates(i, j); }
  /// Returns the begin of \f$ b_{00}, b_{01}, \dots \f$.
  const_iterator begin() const { return shape_.begin(); }
  /// Returns the end of the control points.
  const_iterator end() const { return shape_.end(); }

  /// Returns the weights \f$ w_{00}, w_{01}, \dots \f$.
  const std::vector<FT>& weights() const { return weights_; }
  /// Returns the weight \f$ w_{ij} \f$. \pre there is one
  const FT& weight(int i, int j) const { return weights_[static_cast<std::size_t>(i) * number_of_points_v() + j]; }

  int number_of_points_u() const {
    return shape_.net_.rows();
  } ///< Returns the number of control points in the direction of `u`.
  int number_of_points_v() const {
    return shape_.net_.columns();
  } ///< Returns the number of control points in the direction of `v`.
  const Knot_vector<FT>& knots_u() const {
    return shape_.knots_u();
  } ///< Returns the knots of a B-spline surface in `u`.
  const Knot_vector<FT>& knots_v() const {
    return shape_.knots_v();
  } ///< Returns the knots of a B-spline surface in `v`.

  /// Returns the polynomial surface of the homogeneous points \f$ (w_{ij} b_{ij}, w_{ij}) \f$, on
  /// the same domain.
  /// \throws Error `not_finite` when a product of floating-point numbers overflows
  Homogeneous homogeneous() const {
    std::vector<std::vector<typename Homogeneous::Point>> net(number_of_points_u());
    for (int i = 0; i < number_of_points_u(); ++i)
      for (int j = 0; j < number_of_points_v(); ++j) net[i].push_back(homogeneous_row<FT>(i, j));
    return Homogeneous(net, shape_.u_, shape_.v_);
  }

  /// Returns the polynomial surface with the same control points, whatever the weights are.
  const Shape& unweighted() const { return shape_; }
  /// Returns whether all weights are equal. Then the surface is the polynomial one with the same
  /// control points.
  bool is_polynomial() const {
    return std::all_of(weights_.begin(), weights_.end(), [&](const FT& w) { return bool(w == weights_[0]); });
  }
  /// Returns the polynomial surface with the same control points if all weights are equal,
  /// otherwise nothing.
  std::optional<Shape> polynomial() const {
    if (!is_polynomial()) return std::nullopt;
    return shape_;
  }

  /// @}
  /// \name Evaluation
  /// The parameters are in the domain of a B-spline surface, whose upper ends are included
  /// (`parameter_outside_domain`); at an inner knot the side of the larger parameters is taken.
  /// Those of a Bézier patch may lie outside, as long as the denominator is not zero
  /// (`zero_weight`).
  /// @{

  /// Returns the point at (`u`, `v`).
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0` at (`u`, `v`). The cost is that of the polynomial shape, and
  /// \f$ O(k^4) \f$.
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    typedef Homogeneous_traits<Traits> Homogeneous_points;
    const auto coordinate = [&](int i, int j, int x) { return homogeneous_coordinate(i, j, x); };
    if constexpr (is_spline)
      return project<Traits>(
          internal::bspline_jet<Homogeneous_points>(dimension() + 1, knots_u(), knots_v(), u, v, k, coordinate));
    else
      return project<Traits>(internal::bezier_jet<Homogeneous_points>(degree_u(), degree_v(), dimension() + 1,
                                                                      domain_u(), domain_v(), u, v, k, coordinate));
  }

  /// @}
  /// \name Edges
  /// @{

  /// Returns the rows 0 to `k` at an edge of the polynomial surface of homogeneous points, see
  /// `Bezier_patch::rows()` and `Bspline_surface::rows()`. Control points, weights and knots are
  /// converted to `Field` before anything is computed.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field = FT> std::vector<Row<Field>> rows(Patch_edge edge, int k) const {
    if constexpr (is_spline) {
      const Interval across = knots_across(edge).domain();
      const Parameter_line line = runs_along_u(edge) ? Parameter_line::along_u : Parameter_line::along_v;
      return at_upper_end(edge) ? rows_at<Field>(line, across.second, Line_side::smaller_parameters, k)
                                : rows_at<Field>(line, across.first, Line_side::larger_parameters, k);
    } else
      return internal::bezier_rows<Field, M>(degree_along(edge), degree_across(edge), dimension() + 1, k,
                                             [&](int i, int j) {
                                               const std::pair<int, int> at = index(edge, i, j);
                                               return homogeneous_row<Field>(at.first, at.second);
                                             });
  }
  /// Returns the rows 0 to `k` at the line on which one parameter has a constant value, of the
  /// B-spline surface of homogeneous points, see `Bspline_surface::rows_at()`.
  /// \throws Error `parameter_outside_domain` for a parameter outside the domain, `negative_count`
  ///   unless `k >= 0`
  template <class Field = FT>
  std::vector<Row<Field>> rows_at(Parameter_line line, const FT& parameter, Line_side side, int k) const {
    return internal::bspline_rows_at<Field, M>(knots_u(), knots_v(), dimension() + 1, line, parameter, side, k,
                                               [&](int i, int j) { return homogeneous_row<Field>(i, j); });
  }

  /// Returns the knots of an edge of a B-spline surface.
  const Knot_vector<FT>& knots_along(Patch_edge edge) const { return shape_.knots_along(edge); }
  /// Returns the knots of a B-spline surface in the parameter that is constant on an edge.
  const Knot_vector<FT>& knots_across(Patch_edge edge) const { return shape_.knots_across(edge); }

  /// Returns the degree of an edge of a Bézier patch.
  int degree_along(Patch_edge edge) const { return shape_.degree_along(edge); }
  /// Returns the degree of a Bézier patch in the parameter that is constant on an edge.
  int degree_across(Patch_edge edge) const { return shape_.degree_across(edge); }
  /// Returns the domain of an edge of a Bézier patch.
  Interval domain(Patch_edge edge) const { return shape_.domain(edge); }
  /// Returns the control point number `i` along the edge of a Bézier patch in the layer `j`, where
  /// layer 0 is the edge itself.
  /// \pre `0 <= i <= degree_along(edge)`, `0 <= j <= degree_across(edge)`
  const Point& control_point(Patch_edge edge, int i, int j) const { return shape_.control_point(edge, i, j); }
  /// Returns the weight of the control point number `i` along the edge of a Bézier patch in the
  /// layer `j`.
  /// \pre `0 <= i <= degree_along(edge)`, `0 <= j <= degree_across(edge)`
  const FT& weight(Patch_edge edge, int i, int j) const {
    const std::pair<int, int> at = index(edge, i, j);
    return weight(at.first, at.second);
  }

  /// @}
  /// \name Operations
  /// Operations that compute new control points have the cost and the errors of the polynomial
  /// shape.
  /// @{

  /// Returns the surface \f$ (u, v) \mapsto S(v, u) \f$.
  Rational_surface swap_parameters() const {
    return Rational_surface(shape_.swap_parameters(),
                            internal::transposed(weights_, number_of_points_u(), number_of_points_v()));
  }
  /// Returns the surface with `u` in the opposite direction, on the same domain.
  Rational_surface reverse_u() const {
    return Rational_surface(shape_.reverse_u(), internal::reversed_rows(weights_, number_of_points_v()));
  }
  /// Returns the surface with `v` in the opposite direction, on the same domain.
  Rational_surface reverse_v() const { return swap_parameters().reverse_u().swap_parameters(); }

  /// Returns a surface with the same points whose degrees are raised by `times_u` and `times_v`.
  Rational_surface elevate(int times_u, int times_v) const {
    return Rational_surface(homogeneous().elevate(times_u, times_v));
  }

  /// Returns the parts where the parameter in `u` is at most `u`, and at least `u`.
  std::pair<Rational_surface, Rational_surface> split_u(const FT& u) const {
    const std::pair<Homogeneous, Homogeneous> parts = homogeneous().split_u(u);
    return {Rational_surface(parts.first), Rational_surface(parts.second)};
  }
  /// Returns the parts where the parameter in `v` is at most `v`, and at least `v`.
  std::pair<Rational_surface, Rational_surface> split_v(const FT& v) const {
    const std::pair<Homogeneous, Homogeneous> parts = homogeneous().split_v(v);
    return {Rational_surface(parts.first), Rational_surface(parts.second)};
  }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Rational_surface transform(const Transformation& map) const {
    std::vector<Point> images;
    auto w = weights_.begin();
    for (const Point& p : *this) images.push_back(internal::image_of_control_point<Traits>(map, p, *w++));
    return Rational_surface(
        Shape(Net(number_of_points_u(), number_of_points_v(), std::move(images), Kind::image), shape_.u_, shape_.v_),
        weights_);
  }

  /// @}
  /// \name Functions of Bézier Patches
  /// @{

  /// Returns the patch turned so that the edge is at `v = 0` and keeps its direction.
  Rational_surface oriented(Patch_edge edge) const {
    const Rational_surface r = runs_along_u(edge) ? *this : swap_parameters();
    return at_upper_end(edge) ? r.reverse_v() : r;
  }

  /// Returns the patch with the same control points and weights on another domain.
  /// \throws Error `empty_domain` for a length that is not positive, `not_finite` for an end or a
  ///   length that is not finite
  Rational_surface with_domain(const Interval& u, const Interval& v) const {
    internal::check_interval(u, "Rational_bezier_patch: domain in u");
    internal::check_interval(v, "Rational_bezier_patch: domain in v");
    return Rational_surface(shape_.with_domain(u, v), weights_);
  }

  /// Returns two opposite corners of a box that contains the patch: that of the control points
  /// where all weights are positive, otherwise that of the control points of its parts, see
  /// `positive_parts()`.
  std::pair<Point, Point> bounding_box() const {
    std::vector<Point> points;
    for (const Rational_surface& part : positive_parts()) points.insert(points.end(), part.begin(), part.end());
    return internal::corners_of_box<Traits>(points.begin(), points.end());
  }
  /// Returns the box as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(bounding_box()); }

  /// Returns the patch halved, in `u` and `v` in turn, until each part has positive weights only;
  /// then it lies in the convex hull of its control points.
  /// \throws Error `work_limit` where the denominator is so close to zero that 64 halvings in a row
  ///   do not suffice
  std::vector<Rational_surface> positive_parts() const {
    std::vector<Rational_surface> parts;
    internal::add_positive_parts_of_patch(*this, 64, parts);
    return parts;
  }

  /// @}
  /// \name Functions of B-spline Surfaces
  /// @{

  /// Returns a surface with the same points and `times` more copies of the knot `u`.
  Rational_surface insert_u(const FT& u, int times = 1) const {
    return Rational_surface(homogeneous().insert_u(u, times));
  }
  /// Returns a surface with the same points and `times` more copies of the knot `v`.
  Rational_surface insert_v(const FT& v, int times = 1) const {
    return Rational_surface(homogeneous().insert_v(v, times));
  }
  /// Returns a surface with the same points over finer knots.
  Rational_surface refine(const Knot_vector<FT>& finer_u, const Knot_vector<FT>& finer_v) const {
    return Rational_surface(homogeneous().refine(finer_u, finer_v));
  }
  /// Returns a surface with the same points, without the knots outside the domain, and with control
  /// points at its corners.
  Rational_surface clamp() const { return Rational_surface(homogeneous().clamp()); }

  /// Returns the rational Bézier patches on the rectangles of a span in `u` and a span in `v`, each
  /// with its rectangle as domain. All that belong to the first span in `u` come first.
  std::vector<Rational_surface<Bezier_patch<Traits>>> bezier_patches() const {
    std::vector<Rational_surface<Bezier_patch<Traits>>> patches;
    for_each_bezier_patch([&](Rational_surface<Bezier_patch<Traits>> patch) { patches.push_back(std::move(patch)); });
    return patches;
  }
  /// Calls `f(patch)` for each of the patches that `bezier_patches()` returns, in the same order.
  template <class Function> void for_each_bezier_patch(Function f) const {
    homogeneous().for_each_bezier_patch([&](const Bezier_patch<Homogeneous_traits<Traits>>& patch) {
      f(Rational_surface<Bezier_patch<Traits>>(patch));
    });
  }

  /// @}

  /// Tells whether all of them are equal: domains or knots, degrees, control points and weights.
  friend bool operator==(const Rational_surface& s, const Rational_surface& t) {
    return s.shape_ == t.shape_ && s.weights_ == t.weights_;
  }
  /// Tells whether something of this differs.
  friend bool operator!=(const Rational_surface& s, const Rational_surface& t) { return !(s == t); }

  /// Writes the degrees, the domain or the knots, the control net and the weights, one row to a
  /// line.
  friend std::ostream& operator<<(std::ostream& os, const Rational_surface& s) {
    os << "Rational " << s.shape_ << "\nweights:";
    for (int i = 0; i < s.number_of_points_u(); ++i)
      for (int j = 0; j < s.number_of_points_v(); ++j) os << (j == 0 ? '\n' : ' ') << s.weight(i, j);
    return os;
  }

private:
  static constexpr int M = N == 0 ? 0 : N + 1; // of homogeneous points
  typedef internal::Control_net<Traits> Net;

  Shape shape_;
  std::vector<FT> weights_; // w_ij at i columns + j

  // With weights whose denominator is known to be positive.
  Rational_surface(Shape shape, std::vector<FT> weights) : shape_(std::move(shape)), weights_(std::move(weights)) {}

  Rational_surface(Net net, std::vector<FT> weights, const Side& u, const Side& v)
      : shape_(checked(std::move(net), weights, u, v)), weights_(std::move(weights)) {}
  static Shape checked(Net net, const std::vector<FT>& weights, const Side& u, const Side& v) {
    Kind::check(net, weights, u, v);
    return Shape(std::move(net), u, v);
  }

  // With a range of ranges of weights. Points of the weight 0 contribute nothing and become the
  // origin.
  template <class Weights>
  static Rational_surface given(const Net& net, const Weights& rows, const Side& u, const Side& v) {
    std::vector<FT> weights = weights_of(net, rows);
    std::vector<Point> points(net.begin(), net.end());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (weights[i] == FT(0)) points[i] = to_point<Traits>(Coordinates<Traits>(net.dimension()));
    return Rational_surface(Net(net.rows(), net.columns(), std::move(points), Kind::name), std::move(weights), u, v);
  }
  template <class Weights> static std::vector<FT> weights_of(const Net& net, const Weights& rows) {
    const auto refuse = [](const std::string& what) {
      throw Error(Error_code::wrong_number_of_points, Kind::name + (": " + what));
    };
    std::vector<FT> weights;
    int i = 0;
    for (const auto& row : rows) {
      const int n = static_cast<int>(std::distance(std::begin(row), std::end(row)));
      if (n != net.columns()) refuse(std::to_string(n) + " weights in row " + std::to_string(i));
      weights.insert(weights.end(), std::begin(row), std::end(row));
      ++i;
    }
    if (i != net.rows()) refuse(std::to_string(i) + " rows of weights");
    internal::check_finite_weights(weights, Kind::name);
    return weights;
  }
  static Net affine_net(const Homogeneous& s) {
    std::vector<Point> points;
    for (const auto& p : s) points.push_back(to_point<Traits>(affine_point(p)));
    return Net(s.net_.rows(), s.net_.columns(), std::move(points), Kind::name);
  }
  static std::vector<FT> weights_of(const Homogeneous& s) {
    std::vector<FT> weights;
    for (const auto& p : s) weights.push_back(p[p.dimension() - 1]);
    internal::check_finite_weights(weights, Kind::name);
    return weights;
  }

  // (w_ij b_ij, w_ij), multiplied in the field.
  template <class Field> Coordinate_vector<Field, M> homogeneous_row(int i, int j) const {
    return homogeneous_point(Geometric_continuity::coordinates<Traits, Field>(control_point(i, j)),
                             internal::to_field<Field>(weight(i, j)));
  }
  // The coordinate number x of it.
  FT homogeneous_coordinate(int i, int j, int x) const {
    const FT& w = weight(i, j);
    if (x == dimension()) return w;
    const FT y = FT(Traits().compute_coordinate_object()(control_point(i, j), x));
    return w == FT(0) ? y : FT(w * y);
  }

  // Returns the index of the control point number i along an edge of a patch in the layer j.
  std::pair<int, int> index(Patch_edge edge, int i, int j) const {
    const int inward = at_upper_end(edge) ? degree_across(edge) - j : j;
    return runs_along_u(edge) ? std::make_pair(i, inward) : std::make_pair(inward, i);
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product Bézier patch
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} B_i^p(s) B_j^q(t) / \sum_{ij} w_{ij} B_i^p(s) B_j^q(t) \f$,
/// \f$ s = (u-a)/(b-a) \f$, \f$ t = (v-c)/(d-c) \f$, with control points \f$ b_{ij} \f$ and weights
/// \f$ w_{ij} \f$ on [a, b] x [c, d], by default the unit square: pieces of cylinders, spheres and
/// tori, and of all NURBS surfaces. See `Rational_surface`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Rational_bezier_patch = Rational_surface<Bezier_patch<Traits>>;

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product B-spline surface (NURBS)
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} N_i^p(u) N_j^q(v) / \sum_{ij} w_{ij} N_i^p(u) N_j^q(v) \f$
/// over two `Knot_vector`s, with control points \f$ b_{ij} \f$ and as many weights. See
/// `Rational_surface`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Rational_bspline_surface = Rational_surface<Bspline_surface<Traits>>;

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a rational patch as a rational curve, with the domain and the direction of
/// the edge.
template <class Traits>
Rational_bezier_curve<Traits> boundary_curve(const Rational_bezier_patch<Traits>& patch, Patch_edge edge) {
  const typename Rational_bezier_patch<Traits>::Interval domain = patch.domain(edge);
  typedef typename Rational_bezier_curve<Traits>::Homogeneous Homogeneous;
  return Rational_bezier_curve<Traits>(Homogeneous(patch.rows(edge, 0)[0], domain.first, domain.second));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a rational B-spline surface as a rational curve over the knots of the edge.
template <class Traits>
Rational_bspline_curve<Traits> boundary_curve(const Rational_bspline_surface<Traits>& surface, Patch_edge edge) {
  typedef typename Rational_bspline_curve<Traits>::Homogeneous Homogeneous;
  const auto rows = surface.rows(edge, 0);
  return Rational_bspline_curve<Traits>(Homogeneous(rows[0].begin(), rows[0].end(), surface.knots_along(edge)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_SURFACE_H
