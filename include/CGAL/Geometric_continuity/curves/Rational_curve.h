// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_CURVE_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/Joined_bezier_curves.h>
#include <CGAL/Geometric_continuity/curves/internal/Rational_bezier_shape.h>
#include <CGAL/Geometric_continuity/curves/internal/Rational_bspline_shape.h>
#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <algorithm>
#include <array>
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

/// \ingroup PkgGeometricContinuityCurves
/// A rational curve \f$ x(u) = \sum_i w_i b_i B_i(u) / \sum_i w_i B_i(u) \f$: control points
/// \f$ b_i \f$ with weights \f$ w_i \f$ in a polynomial shape, a `Bezier_curve` or a
/// `Bspline_curve`, whose basis functions are the \f$ B_i \f$. Arcs of circles and all other
/// conics, and all NURBS curves. `Rational_bezier_curve` and `Rational_bspline_curve` are its
/// names.
///
/// Numerator and denominator are a polynomial curve of the homogeneous points
/// \f$ (w_i b_i, w_i) \f$, see `homogeneous()`, and all that is done with this curve is done with
/// that one. A common factor of all weights changes nothing. All derivatives are taken with respect
/// to `u`; those beyond the degree are not zero.
///
/// A weight may be negative or zero as long as the denominator is positive on the domain, which is
/// decided exactly. The control point of the weight 0 is infinite, \f$ (x, 0) \f$; then
/// `control_point()` is its direction \f$ x \f$. Given as a control point and a weight, such a
/// point contributes nothing, \f$ (0, 0) \f$.
///
/// The curve is a value: operations return new curves. With an exact kernel they are exact. The
/// energy \f$ \int |x^{(k)}|^2 \f$ is not a rational number in general; `fairness()` computes such
/// measures.
///
/// \tparam Shape `Bezier_curve<Traits, Degree>` or `Bspline_curve<Traits>`
/// \cgalModels{ParametricCurve}
template <class Shape_> class Rational_curve : public internal::Other_members {
  typedef internal::Curve_shape<Shape_> Kind;
  static constexpr int Degree = Kind::Degree;
  friend Kind;

public:
  /// the polynomial curve with the same control points
  typedef Shape_ Shape;
  typedef typename Shape::Traits Traits;  ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel
  /// the polynomial curve of the homogeneous points
  typedef typename Kind::Homogeneous Homogeneous;
  /// the dimension, or 0 when it is known at run time only
  static constexpr int N = Shape::N;
  /// a container of one number for each control point
  typedef typename Shape::template Per_point<FT> Weights;
  typedef typename Shape::const_iterator const_iterator; ///< iterates over the control points

  /// Takes a range of control points, a range of as many weights, and the domain [a, b] of a Bézier
  /// curve.
  /// \throws Error `wrong_number_of_points` unless the ranges have `Degree + 1` points and weights
  ///   (as many as each other, and at least one, if dynamic)
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point number, and when
  ///   `b - a` overflows
  template <class InputIterator, class WeightIterator>
  Rational_curve(InputIterator first, InputIterator last, WeightIterator first_weight, WeightIterator last_weight,
                 const FT& a = FT(0), const FT& b = FT(1))
      : shape_(first, last, a, b), weights_(Kind::template taken<Weights>(shape_, first_weight, last_weight)) {
    Kind::check_weights(shape_, weights_);
    place_infinite_points();
  }

  /// Takes a range of control points, such as a `std::vector`, a range of their weights, and the
  /// domain of a Bézier curve.
  /// \throws Error as the constructor from iterators
  template <class Points, class Numbers, class = internal::Range_of_points<Points, Point>>
  Rational_curve(const Points& points, const Numbers& weights, const FT& a = FT(0), const FT& b = FT(1))
      : Rational_curve(std::begin(points), std::end(points), std::begin(weights), std::end(weights), a, b) {}

  /// Takes a list of control points and their weights, also in braces, for a Bézier curve on
  /// [0, 1].
  /// \throws Error as for ranges
  Rational_curve(std::initializer_list<Point> points, const std::vector<FT>& weights)
      : Rational_curve(points.begin(), points.end(), weights.begin(), weights.end()) {}

  /// Takes a range of control points, a range of as many weights, and the knots of a B-spline
  /// curve.
  /// \throws Error `wrong_number_of_points` unless there are `n` control points and `n` weights
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  template <class InputIterator, class WeightIterator>
  Rational_curve(InputIterator first, InputIterator last, WeightIterator first_weight, WeightIterator last_weight,
                 Knot_vector<FT> knots)
      : Rational_curve(internal::Unspecified(), std::vector<Point>(first, last), Weights(first_weight, last_weight),
                       knots) {
    place_infinite_points();
  }

  /// Takes a range of control points, such as a `std::vector`, a range of their weights, and the
  /// knots of a B-spline curve.
  /// \throws Error as the constructor from iterators
  template <class Points, class Numbers, class = internal::Range_of_points<Points, Point>>
  Rational_curve(const Points& points, const Numbers& weights, Knot_vector<FT> knots)
      : Rational_curve(std::begin(points), std::end(points), std::begin(weights), std::end(weights), std::move(knots)) {
  }

  /// Takes the degree, all knots, the control points and the weights of a B-spline curve, also in
  /// braces. \throws Error as the constructor from iterators, and as that of `Knot_vector`
  template <class Number = FT>
  Rational_curve(int degree, const std::vector<Number>& knots, const std::vector<Point>& points,
                 const std::vector<FT>& weights)
      : Rational_curve(points, weights, Knot_vector<FT>(degree, knots)) {}

  // This refuses the same in other orders, or without the degree.
  template <class First, class Second, class Third, class... Fourth,
            class = std::enable_if_t<internal::misses_order<FT, First, Second, Third, Fourth...>>>
  Rational_curve(const First&, const Second&, const Third&, const Fourth&...)
      : Rational_curve(internal::refused_order<First>(), std::vector<FT>(), std::vector<Point>(), std::vector<FT>()) {}

  /// Takes the curve of the homogeneous points \f$ (w_i b_i, w_i) \f$.
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain,
  ///   `not_finite` when a quotient overflows
  explicit Rational_curve(const Homogeneous& c) : shape_(affine(c)), weights_(ones()) {
    for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = c.control_points()[i][c.dimension() - 1];
    Kind::check_weights(shape_, weights_);
  }

  /// Converts a polynomial curve, whose degree may be forgotten or remembered as in `Bezier_curve`:
  /// all weights are 1.
  /// \throws Error `wrong_number_of_points` when the curve does not have the degree `Degree`
  template <class Polynomial_curve, class = std::enable_if_t<std::is_convertible_v<const Polynomial_curve&, Shape>>>
  Rational_curve(const Polynomial_curve& c) : shape_(c), weights_(ones()) {}

  /// Converts a Bézier curve by forgetting its degree, or by remembering it.
  /// \throws Error `wrong_number_of_points` when the curve does not have the degree `Degree`
  template <class Other, std::enable_if_t<std::is_convertible_v<const Other&, Shape>, int> = 0>
  Rational_curve(const Rational_curve<Other>& c) : shape_(c.unweighted()), weights_(ones()) {
    std::copy(c.weights().begin(), c.weights().end(), weights_.begin());
  }

  /// Converts a Bézier curve to a B-spline curve.
  template <class Other, std::enable_if_t<std::is_constructible_v<Shape, const Other&> &&
                                              !std::is_convertible_v<const Other&, Shape>,
                                          bool> = true>
  explicit Rational_curve(const Rational_curve<Other>& c) : shape_(c.unweighted()), weights_(ones()) {
    std::copy(c.weights().begin(), c.weights().end(), weights_.begin());
  }

  /// Joins rational Bézier curves that continue each other to a B-spline curve: each starts where
  /// the one before it ends. Their weights are multiplied by a factor each, so that the homogeneous
  /// points meet, and all are elevated to one degree. The knots between them have the multiplicity
  /// of the degree. The lengths of the domains are kept.
  /// \throws Error `wrong_number_of_points` for an empty range, `dimension_mismatch`,
  ///   `curves_do_not_meet` when two neighbours do not fit, `empty_domain` when knots become equal
  ///   by rounding
  template <class ForwardIterator, class = typename std::iterator_traits<ForwardIterator>::value_type>
  Rational_curve(ForwardIterator first, ForwardIterator last) : Rational_curve(joined(first, last)) {}

  /// \name Control Points and Weights
  /// @{

  int degree() const { return shape_.degree(); } ///< Returns the degree.
  /// Returns the dimension of the control points.
  int dimension() const { return shape_.dimension(); }
  std::pair<FT, FT> domain() const { return shape_.domain(); } ///< Returns the domain.

#ifndef CGAL_NO_DEPRECATED_CODE
  /// \cond SKIP_IN_MANUAL
  [[deprecated("call domain().first")]] FT start_parameter() const { return domain().first; }
  [[deprecated("call domain().second")]] FT end_parameter() const { return domain().second; }
  /// \endcond
#endif

  /// Returns the control points, in order.
  const typename Shape::template Per_point<Point>& control_points() const { return shape_.control_points(); }
  /// Returns the control point \f$ b_i \f$. \pre there is one
  const Point& control_point(int i) const { return shape_.control_point(i); }
  /// Returns the coordinates of \f$ b_i \f$. \pre there is one
  Coordinates<Traits> coordinates(int i) const { return shape_.coordinates(i); }
  /// Returns an iterator to the first control point.
  const_iterator begin() const { return shape_.begin(); }
  /// Returns the iterator after the last control point.
  const_iterator end() const { return shape_.end(); }

  /// Returns the weights, in the order of the control points.
  const Weights& weights() const { return weights_; }
  /// Returns the weight \f$ w_i \f$. \pre there is one
  const FT& weight(int i) const { return weights_[i]; }

  /// Returns the number of control points.
  int number_of_points() const { return shape_.number_of_points(); }
  /// Returns the knots of a B-spline.
  const Knot_vector<FT>& knots() const { return shape_.knots(); }

  /// Returns the polynomial curve of the homogeneous points \f$ (w_i b_i, w_i) \f$, on the same
  /// domain.
  /// \throws Error `not_finite` when a product of floating-point numbers overflows
  Homogeneous homogeneous() const {
    typename Homogeneous::template Per_point<typename Homogeneous::Point> points;
    if constexpr (Degree == dynamic_degree) points.resize(weights_.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = homogeneous_row<FT>(static_cast<int>(i));
    return Kind::template with_points<Homogeneous>(shape_, points);
  }

  /// Returns the polynomial curve with the same control points, whatever the weights are.
  const Shape& unweighted() const { return shape_; }
  /// Returns whether all weights are equal. Then the curve is the polynomial one with the same
  /// control points.
  bool is_polynomial() const {
    return std::all_of(weights_.begin(), weights_.end(), [&](const FT& w) { return bool(w == weights_[0]); });
  }
  /// Returns the polynomial curve with the same control points if all weights are equal, otherwise
  /// nothing.
  std::optional<Shape> polynomial() const {
    if (!is_polynomial()) return std::nullopt;
    return shape_;
  }

  /// @}
  /// \name Evaluation
  /// The parameter is in the domain of a B-spline curve (`parameter_outside_domain`), and may lie
  /// outside that of a Bézier curve. With floating-point numbers results are not checked: products
  /// of weights and coordinates, and derivatives, must not overflow.
  /// @{

  /// Returns the point at `u`, from the right at a knot. \f$ O(m^2) \f$ in degree `m`, and the
  /// search for the span
  /// \throws Error `zero_weight` when the denominator is zero there
  Point operator()(const FT& u) const { return Kind::point(*this, u); }

  /// Returns the jet of order `k` at `u`, from the right at a knot. \f$ O(m^2 + m k^2 + k^3) \f$,
  /// and the search for the span
  /// \throws Error `negative_count` unless `k >= 0`, `zero_weight` when the denominator is zero
  ///   there
  Curve_jet<Traits> jet(const FT& u, int k) const { return Kind::jet(*this, u, k); }
  /// Returns the jet of an order `k >= 0` that is known at compile time.
  /// \throws Error `zero_weight` when the denominator is zero there
  template <int k> Curve_jet<Traits> jet(const FT& u) const {
    static_assert(k >= 0);
    return Kind::template jet<k>(*this, u);
  }

  /// Returns the jet of order `k` of a B-spline curve at `u` from the left; at the start of the
  /// domain from the right.
  Curve_jet<Traits> left_jet(const FT& u, int k) const { return Kind::jet_on_span(*this, u, knots().left_span(u), k); }
  /// Returns the jet of order `k` of a B-spline curve at `u` from the right; at the end of the
  /// domain from the left.
  Curve_jet<Traits> right_jet(const FT& u, int k) const { return Kind::jet_on_span(*this, u, knots().span(u), k); }

  /// Returns the jet of order `k` at the start of the domain; of a Bézier curve from `k + 1`
  /// control points, in \f$ O(k^2) \f$.
  /// \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> start_jet(int k) const { return Curve_jet<Traits>(start_jet_over<FT>(k)); }
  /// Returns the jet of order `k` at the end of the domain; of a Bézier curve from `k + 1` control
  /// points, in \f$ O(k^2) \f$.
  /// \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> end_jet(int k) const { return Curve_jet<Traits>(end_jet_over<FT>(k)); }

  /// Returns the jet of a B-spline curve from the left in another field, to which all numbers are
  /// converted before anything is computed.
  template <class Field> Coordinate_jet<Field, N> left_jet_over(const FT& u, int k) const {
    return Kind::template jet_over<Field>(*this, u, knots().left_span(u), k);
  }
  /// Returns the jet of a B-spline curve from the right in another field, to which all numbers are
  /// converted before anything is computed.
  template <class Field> Coordinate_jet<Field, N> right_jet_over(const FT& u, int k) const {
    return Kind::template jet_over<Field>(*this, u, knots().span(u), k);
  }
  /// Returns the jet of order `k` at the start of the domain in another field, to which all numbers
  /// are converted before anything is computed. \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const {
    return Kind::template start_jet_over<Field>(*this, k);
  }
  /// Returns the jet of order `k` at the end of the domain in another field, to which all numbers
  /// are converted before anything is computed. \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const {
    return Kind::template end_jet_over<Field>(*this, k);
  }

  /// @}
  /// \name Other Curves
  /// They cost and throw as those of the polynomial shape.
  /// @{

  /// Returns this curve with the degree raised by `times`; a B-spline curve is clamped.
  /// \throws Error `negative_count` unless `times >= 0`
  Rational_curve<typename Kind::Elevated> elevate(int times = 1) const {
    return Rational_curve<typename Kind::Elevated>(homogeneous().elevate(times));
  }

  /// Returns the curve in the opposite direction, on the same domain: its point at `u` is that of
  /// this curve at `a + b - u`.
  Rational_curve reverse() const {
    Rational_curve r = *this;
    r.shape_ = shape_.reverse();
    std::reverse(r.weights_.begin(), r.weights_.end());
    return r;
  }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`. The
  /// images are not checked.
  template <class Transformation> Rational_curve transform(const Transformation& map) const {
    Rational_curve r = *this;
    auto w = weights_.begin();
    r.shape_ = shape_.transform([&](const Point& p) { return internal::image_of_control_point<Traits>(map, p, *w++); });
    return r;
  }

  /// @}
  /// \name Functions of Bézier Curves
  /// @{

  /// Returns the same points in another rational parametrisation, with the weights \f$ w_i c^i \f$.
  /// Where two such curves meet themselves, they are smooth of every order \f$ G^k \f$, and in
  /// general not \f$ C^1 \f$.
  /// \throws Error `zero_weight` unless `c > 0`, `not_finite` when a weight overflows
  Rational_curve reparametrised(const FT& c) const { return Kind::reparametrised(*this, c); }

  /// \cond SKIP_IN_MANUAL
  using internal::Other_members::derivative; // with arguments
  /// \endcond

  /// Returns the derivative (hodograph) \f$ (p' w - p w') / w^2 \f$: the curve of degree `2 m`
  /// whose point at `u` has the coordinates of the first derivative. \f$ O(n m^2) \f$
  /// \throws Error `not_finite` when a floating-point coordinate overflows
  Rational_curve<Bezier_curve<Traits>> derivative() const { return Kind::derivative(*this); }

  /// Returns the parts on [a, u] and [u, b]. \f$ O(m^2) \f$
  /// \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Rational_curve, Rational_curve> split(const FT& u) const { return Kind::split(*this, u); }

  /// Returns this curve of fixed degree with the degree raised by `times`, without allocation.
  template <int times> Rational_curve<Bezier_curve<Traits, Degree + times>> elevate_fixed() const {
    return Rational_curve<Bezier_curve<Traits, Degree + times>>(homogeneous().template elevate_fixed<times>());
  }

  /// Returns the curve with these control points and weights on another domain.
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when one of them is not finite or
  ///   `b - a` overflows
  Rational_curve with_domain(const FT& a, const FT& b) const { return Kind::with_domain(*this, a, b); }

  /// Returns two opposite corners of a box that contains the curve: that of the control points
  /// where all weights are positive, otherwise that of the control points of its parts, see
  /// `positive_parts()`.
  std::pair<Point, Point> bounding_box() const { return Kind::bounding_box(*this); }
  /// Returns the box as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(Kind::bounding_box(*this)); }

  /// Returns the curve halved until each part has positive weights only; then it lies in the convex
  /// hull of its control points.
  /// \throws Error `work_limit` where the denominator is so close to zero that 64 halvings in a row
  ///   do not suffice
  std::vector<Rational_curve> positive_parts() const {
    std::vector<Rational_curve> parts;
    internal::add_positive_parts(*this, 64, parts);
    return parts;
  }

  /// @}
  /// \name Functions of B-spline Curves
  /// These functions cost and throw as those of `Bspline_curve`.
  /// @{

  /// Returns the same curve with `times >= 0` more copies of the knot `u`. \f$ O(n + p\,times) \f$
  Rational_curve insert(const FT& u, int times = 1) const { return Kind::insert(*this, u, times); }
  /// Returns the same curve over finer knots. \f$ O(p) \f$ for each knot that is inserted, and the
  /// copy
  Rational_curve refine(const Knot_vector<FT>& finer) const { return Rational_curve(homogeneous().refine(finer)); }
  /// Returns the same curve with knots of multiplicity `p + 1` at the ends, without those outside
  /// the domain.
  Rational_curve clamp() const { return Rational_curve(homogeneous().clamp()); }

  /// Returns the same curve with `times >= 0` copies of the inner knot `u` less, or nothing if that
  /// changed the homogeneous curve.
  std::optional<Rational_curve> remove(const FT& u, int times = 1) const {
    const std::optional<Homogeneous> c = homogeneous().remove(u, times);
    if (!c) return std::nullopt;
    return Rational_curve(*c);
  }
  /// Returns the same curve without the inner knots that its homogeneous points do not need.
  Rational_curve remove_superfluous_knots() const { return Rational_curve(homogeneous().remove_superfluous_knots()); }

  /// Returns the rational Bézier curves on the spans that are not empty, in order.
  /// \throws Error `work_limit`
  std::vector<Rational_curve<Bezier_curve<Traits>>> bezier_pieces() const { return Kind::bezier_pieces(*this); }

  /// Returns the jets of order `k` at both ends of each span, those of `bezier_pieces()`; see
  /// `Bspline_curve::span_end_jets()`.
  /// \throws Error `negative_count` unless `k >= 0`, `work_limit`
  std::vector<Curve_end_jets<Traits>> span_end_jets(int k) const { return Kind::span_end_jets(*this, k); }

  /// @}

  /// Returns whether control points, weights, and domains or knots are equal.
  friend bool operator==(const Rational_curve& c, const Rational_curve& d) {
    return c.shape_ == d.shape_ && c.weights_ == d.weights_;
  }
  /// Returns whether some of them differ.
  friend bool operator!=(const Rational_curve& c, const Rational_curve& d) { return !(c == d); }

  /// Writes the domain or the knots, the control points and the weights.
  friend std::ostream& operator<<(std::ostream& os, const Rational_curve& c) {
    os << "Rational " << c.shape_ << ", weights";
    for (const FT& w : c.weights_) os << ' ' << w;
    return os;
  }

private:
  static constexpr int M = N == 0 ? 0 : N + 1; // of homogeneous points

  Shape shape_;
  Weights weights_;

  // This constructor is for splines.
  Rational_curve(internal::Unspecified, const std::vector<Point>& points, Weights weights, const Knot_vector<FT>& knots)
      : shape_(Kind::checked(points, weights, knots).begin(), points.end(), knots), weights_(std::move(weights)) {
    Kind::check_weights(shape_, weights_);
  }
  Weights ones() const {
    if constexpr (Degree == dynamic_degree)
      return Weights(shape_.control_points().size(), FT(1));
    else {
      Weights weights;
      weights.fill(FT(1));
      return weights;
    }
  }
  void place_infinite_points() {
    if (std::none_of(weights_.begin(), weights_.end(), [](const FT& w) { return bool(w == FT(0)); })) return;
    const Point origin = to_point<Traits>(Coordinates<Traits>(dimension()));
    auto w = weights_.begin();
    shape_ = shape_.transform([&](const Point& p) { return *w++ == FT(0) ? origin : p; });
  }

  static Shape affine(const Homogeneous& c) {
    typename Shape::template Per_point<Point> points;
    if constexpr (Degree == dynamic_degree) points.resize(c.control_points().size());
    auto p = points.begin();
    for (const auto& x : c.control_points()) *p++ = to_point<Traits>(affine_point(x));
    return Kind::template with_points<Shape>(c, points);
  }

  template <class ForwardIterator> static Homogeneous joined(ForwardIterator first, ForwardIterator last) {
    const auto curves = internal::meeting_homogeneous_curves<Traits>(first, last);
    return Homogeneous(curves.begin(), curves.end());
  }

  // The i-th coordinate of the j-th homogeneous point, see homogeneous_point(). \tparam Field the
  // numbers of the result
  template <class Field = FT> CGAL_GC_FORCEINLINE Field homogeneous_coordinate(int j, int i) const {
    const Field w = internal::to_field<Field>(weights_[j]);
    if (i == dimension()) return w;
    const Field x = internal::to_field<Field>(FT(Traits().compute_coordinate_object()(control_point(j), i)));
    return w == Field(0) ? x : Field(w * x);
  }

  // (w_i b_i, w_i), multiplied in the field
  template <class Field> Coordinate_vector<Field, M> homogeneous_row(int i) const {
    return homogeneous_point(Geometric_continuity::coordinates<Traits, Field>(control_point(i)),
                             internal::to_field<Field>(weights_[i]));
  }
};

/// \ingroup PkgGeometricContinuityCurves
/// A rational Bézier curve \f$ x(u) = \sum_i w_i b_i B_i^m(t) / \sum_i w_i B_i^m(t) \f$,
/// \f$ t = (u-a)/(b-a) \f$, with control points \f$ b_0, \dots, b_m \f$ and weights
/// \f$ w_0, \dots, w_m \f$ on the domain [a, b], by default [0, 1]: arcs of circles and all other
/// conics, the pieces of NURBS curves. See `Rational_curve`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
template <class Traits, int Degree = dynamic_degree>
using Rational_bezier_curve = Rational_curve<Bezier_curve<Traits, Degree>>;

/// \ingroup PkgGeometricContinuityCurves
/// A rational B-spline curve (NURBS) \f$ x(u) = \sum_i w_i b_i N_i^p(u) / \sum_i w_i N_i^p(u) \f$
/// with control points \f$ b_0, \dots, b_{n-1} \f$, as many weights, and any knot vector with `n`
/// coefficients. See `Rational_curve`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Rational_bspline_curve = Rational_curve<Bspline_curve<Traits>>;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_CURVE_H
