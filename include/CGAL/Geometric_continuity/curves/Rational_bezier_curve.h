// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BEZIER_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BEZIER_CURVE_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/curves/internal/positive_parts.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// A rational Bézier curve \f$ x(u) = \sum_i w_i b_i B_i^m(t) / \sum_i w_i B_i^m(t) \f$, \f$ t = (u-a)/(b-a) \f$, with control
/// points \f$ b_0, \dots, b_m \f$ and weights \f$ w_0, \dots, w_m \f$ on the domain [a, b], by default [0, 1]: arcs of circles
/// and all other conics, the pieces of NURBS curves.
///
/// Numerator and denominator are a polynomial curve of the homogeneous points \f$ (w_i b_i, w_i) \f$, see `homogeneous()`, and
/// all that is done with this curve is done with that one. A common factor of all weights changes nothing. All derivatives are
/// taken with respect to `u`; those beyond the degree are not zero.
///
/// A weight may be negative or zero as long as the denominator is positive on the domain, which is decided exactly. The control
/// point of the weight 0 is infinite, \f$ (x, 0) \f$; then `control_point()` is its direction \f$ x \f$. Given as a control point
/// and a weight, such a point contributes nothing, \f$ (0, 0) \f$.
///
/// The curve is a value: operations return new curves. With an exact kernel they are exact. The energy
/// \f$ \int |x^{(k)}|^2 \f$ is not a rational number in general; `fairness()` computes such measures.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
/// \models ParametricCurve
template <class Traits_, int Degree = dynamic_degree>
class Rational_bezier_curve : private Bezier_polygon<Traits_, Degree> {
  typedef Bezier_polygon<Traits_, Degree> Polygon;
  using Polygon::a_;
  using Polygon::b_;
  using Polygon::points_;
  using typename Polygon::Coordinates;
  template <class T> using Per_point = typename Polygon::template Per_point<T>;

public:
  typedef Traits_ Traits;                 ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel
  /// The polynomial curve of the homogeneous points.
  typedef Bezier_curve<Homogeneous_traits<Traits>, Degree> Homogeneous;
  using Polygon::N;                                        ///< the dimension, or 0 when it is known at run time only
  typedef Per_point<FT> Weights;                           ///< a container of one number for each control point
  typedef typename Polygon::const_iterator const_iterator; ///< iterates over the control points

  using Polygon::begin;          ///< Returns an iterator to the first control point.
  using Polygon::control_point;  ///< Returns the `j`-th control point. \pre `0 <= j <= degree()`
  using Polygon::control_points; ///< Returns the control points, in order.
  using Polygon::coordinates;    ///< Returns the coordinates of the `j`-th control point. \pre `0 <= j <= degree()`
  using Polygon::degree;         ///< Returns the degree `m`.
  using Polygon::dimension;      ///< Returns the dimension of the control points.
  using Polygon::domain;         ///< Returns the domain [a, b].
  using Polygon::end;            ///< Returns the iterator after the last control point.

  /// Takes a range of control points, a range of as many weights, and the domain.
  /// \throws Error `wrong_number_of_points` unless the ranges have `Degree + 1` points and weights (as many as each other, and at
  ///   least one, if dynamic)
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point number, and when `b - a` overflows
  template <class InputIterator, class WeightIterator>
  Rational_bezier_curve(InputIterator first, InputIterator last, WeightIterator first_weight,
                        WeightIterator last_weight, const FT& a = FT(0), const FT& b = FT(1))
      : Polygon(first, last, a, b), weights_(checked(first_weight, last_weight, points_.size())) {
    for (int j = 0; j <= degree(); ++j)
      if (weights_[j] == FT(0)) points_[j] = Geometric_continuity::to_point<Traits>(Coordinates(dimension()));
  }

  /// Takes a list of control points and a list of their weights, on [0, 1].
  /// \throws Error as for ranges
  Rational_bezier_curve(std::initializer_list<Point> points, std::initializer_list<FT> weights)
      : Rational_bezier_curve(points.begin(), points.end(), weights.begin(), weights.end()) {}

  /// Takes the curve of the homogeneous points \f$ (w_i b_i, w_i) \f$.
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain, `not_finite` when a quotient overflows
  explicit Rational_bezier_curve(const Homogeneous& c)
      : Polygon(affine_rows(c), c.domain().first, c.domain().second), weights_(weights_of(c)) {}

  /// Converts a polynomial curve, whose degree may be forgotten: all weights are 1.
  /// \throws Error `wrong_number_of_points` when the curve does not have the degree `Degree`
  template <int Other>
  Rational_bezier_curve(const Bezier_curve<Traits, Other>& c)
      : Polygon(c.begin(), c.end(), c.domain().first, c.domain().second), weights_(ones(points_.size())) {
    static_assert(Other == Degree || Other == dynamic_degree || Degree == dynamic_degree, "the degrees differ");
  }

  /// Converts a curve by forgetting its degree, or by remembering it.
  /// \throws Error `wrong_number_of_points` when the curve does not have the degree `Degree`
  template <int Other, class = std::enable_if_t<Other != Degree>>
  Rational_bezier_curve(const Rational_bezier_curve<Traits, Other>& c)
      : Polygon(c.begin(), c.end(), c.domain().first, c.domain().second), weights_(ones(points_.size())) {
    static_assert(Other == dynamic_degree || Degree == dynamic_degree, "the degrees differ");
    std::copy(c.weights().begin(), c.weights().end(), weights_.begin());
  }

  /// \name Weights
  /// @{

  /// Returns the weights, in the order of the control points.
  const Weights& weights() const { return weights_; }
  /// Returns the weight \f$ w_j \f$. \pre `0 <= j <= degree()`
  const FT& weight(int j) const { return weights_[j]; }

  /// Returns the polynomial curve of the homogeneous points \f$ (w_j b_j, w_j) \f$, on the same domain.
  /// \throws Error `not_finite` when a product of floating-point numbers overflows
  Homogeneous homogeneous() const {
    Per_point<typename Homogeneous_traits<Traits>::Point> points;
    if constexpr (Degree == dynamic_degree) points.resize(points_.size());
    for (int j = 0; j <= degree(); ++j) points[j] = homogeneous_point(coordinates(j), weights_[j]);
    return Homogeneous(points, a_, b_);
  }

  /// Returns whether all weights are equal. Then the curve is a polynomial one with the same control points.
  bool is_polynomial() const {
    return std::all_of(weights_.begin(), weights_.end(), [&](const FT& w) { return bool(w == weights_[0]); });
  }
  /// Returns the polynomial curve with the same control points if all weights are equal, otherwise nothing.
  std::optional<Bezier_curve<Traits, Degree>> polynomial() const {
    if (!is_polynomial()) return std::nullopt;
    return Bezier_curve<Traits, Degree>(begin(), end(), a_, b_);
  }

  /// Returns the same points in another rational parametrisation, with the weights \f$ w_i c^i \f$. Where two such curves meet
  /// themselves, they are smooth of every order \f$ G^k \f$, and in general not \f$ C^1 \f$.
  /// \throws Error `zero_weight` unless `c > 0`, `not_finite` when a weight overflows
  Rational_bezier_curve reparametrised(const FT& c) const {
    internal::check_finite(c, "Rational_bezier_curve::reparametrised");
    if (!(FT(0) < c)) throw Error(Error_code::zero_weight, "Rational_bezier_curve::reparametrised");
    Rational_bezier_curve r = *this;
    FT power(1);
    for (FT& w : r.weights_) {
      w *= power;
      power *= c;
    }
    internal::check_finite_weights(r.weights_, "Rational_bezier_curve::reparametrised");
    return r;
  }

  /// @}
  /// \name Evaluation
  /// With floating-point numbers results are not checked: products of weights and coordinates, and derivatives, must not overflow.
  /// @{

  /// Returns the point at `u`, which may lie outside the domain. \f$ O(m^2) \f$
  /// \throws Error `zero_weight` when the denominator is zero there
  Point operator()(const FT& u) const {
    if constexpr (internal::unrolls_jets<FT, Degree>) {
      Coordinates x(dimension());
      write_jet<0>(u, 0, &x);
      return Geometric_continuity::to_point<Traits>(x);
    } else
      return jet_of_any_order(u, 0).point();
  }

  /// Returns the jet of order `k` at `u`, which may lie outside the domain. \f$ O(m^2 + k^3) \f$
  /// \throws Error `negative_count` unless `k >= 0`, `zero_weight` when the denominator is zero there
  Curve_jet<Traits> jet(const FT& u, int k) const {
    if constexpr (Degree == dynamic_degree)
      return k <= 3 ? jet_of_order<3>(u, k) : jet_of_any_order(u, k);
    else
      switch (k) {
      case 0: return jet<0>(u);
      case 1: return jet<1>(u);
      case 2: return jet<2>(u);
      case 3: return jet<3>(u);
      default: return jet_of_any_order(u, k);
      }
  }

  /// Returns the jet of an order `k >= 0` that is known at compile time, at `u`, which may lie outside the domain.
  /// \f$ O(m^2 + k^3) \f$ \throws Error `zero_weight` when the denominator is zero there
  template <int k> Curve_jet<Traits> jet(const FT& u) const {
    static_assert(k >= 0);
    if constexpr (Degree == dynamic_degree)
      return jet(u, k);
    else
      return jet_of_order<k>(u, k);
  }

  /// Returns the jet of order `k` at the start of the domain, from the first `k + 1` control points. \f$ O(k^2) \f$
  /// \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> start_jet(int k) const { return Curve_jet<Traits>(start_jet_over<FT>(k)); }

  /// Returns the jet of order `k` at the end of the domain, from the last `k + 1` control points. \f$ O(k^2) \f$
  /// \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> end_jet(int k) const { return Curve_jet<Traits>(end_jet_over<FT>(k)); }

  /// Returns the jet of order `k` at the start of the domain in another field, to which control points, weights and domain are
  /// converted first. \f$ O(k^2) \f$ \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const {
    return jet_of_legs<Field>(k, length_over<Field>(), [](int j) { return j; });
  }

  /// Returns the jet of order `k` at the end of the domain in another field, to which control points, weights and domain are
  /// converted first. \f$ O(k^2) \f$ \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const {
    return jet_of_legs<Field>(k, Field(-length_over<Field>()), [m = degree()](int j) { return m - j; });
  }

  /// @}
  /// \name Other Curves
  /// @{

  /// Returns the derivative (hodograph) \f$ (p' w - p w') / w^2 \f$: the curve of degree `2 m` whose point at `u` has the
  /// coordinates of the first derivative. \f$ O(n m^2) \f$
  /// \throws Error `not_finite` when a floating-point coordinate overflows
  Rational_bezier_curve<Traits> derivative() const {
    const Homogeneous h = homogeneous();
    const int n = dimension();
    const Bernstein_polynomial<FT> w = h.coordinate_polynomial(n), dw = w.derivative();
    const Bernstein_polynomial<FT> square = w * w;
    const FT length = FT(b_ - a_);
    std::vector<Coordinate_vector<FT, (N == 0 ? 0 : N + 1)>> rows(square.degree() + 1,
                                                                  Coordinate_vector<FT, (N == 0 ? 0 : N + 1)>(n + 1));
    for (int i = 0; i < n; ++i) {
      const Bernstein_polynomial<FT> p = h.coordinate_polynomial(i);
      const Bernstein_polynomial<FT> numerator = p.derivative() * w - p * dw;
      const Bernstein_polynomial<FT> row = numerator.elevated(square.degree() - numerator.degree());
      for (int j = 0; j <= square.degree(); ++j) rows[j][i] = FT(row[j] / length);
    }
    for (int j = 0; j <= square.degree(); ++j) rows[j][n] = square[j];
    return Rational_bezier_curve<Traits>(typename Rational_bezier_curve<Traits>::Homogeneous(rows, a_, b_));
  }

  /// Returns the parts on [a, u] and [u, b]. \f$ O(m^2) \f$
  /// \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Rational_bezier_curve, Rational_bezier_curve> split(const FT& u) const {
    const std::pair<Homogeneous, Homogeneous> parts = homogeneous().split(u);
    return {Rational_bezier_curve(parts.first), Rational_bezier_curve(parts.second)};
  }

  /// Returns this curve with the degree raised by `times`. \f$ O(times (m + times)) \f$
  /// \throws Error `negative_count` unless `times >= 0`
  Rational_bezier_curve<Traits> elevate(int times = 1) const {
    return Rational_bezier_curve<Traits>(homogeneous().elevate(times));
  }

  /// Returns this curve of fixed degree with the degree raised by `times`, without allocation.
  template <int times> Rational_bezier_curve<Traits, Degree + times> elevate_fixed() const {
    return Rational_bezier_curve<Traits, Degree + times>(homogeneous().template elevate_fixed<times>());
  }

  /// Returns the curve in the opposite direction, on the same domain: its point at `u` is that of this curve at `a + b - u`.
  Rational_bezier_curve reverse() const {
    Rational_bezier_curve r = *this;
    std::reverse(r.points_.begin(), r.points_.end());
    std::reverse(r.weights_.begin(), r.weights_.end());
    return r;
  }

  /// Returns the curve with these control points and weights on another domain.
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when one of them is not finite or `b - a` overflows
  Rational_bezier_curve with_domain(const FT& a, const FT& b) const {
    internal::check_interval(std::pair<FT, FT>(a, b), "Rational_bezier_curve::with_domain");
    Rational_bezier_curve r = *this;
    r.a_ = a;
    r.b_ = b;
    return r;
  }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`. The images are not checked.
  template <class Transformation> Rational_bezier_curve transform(const Transformation& map) const {
    Rational_bezier_curve r = *this;
    for (int j = 0; j <= degree(); ++j)
      r.points_[j] = internal::image_of_control_point<Traits>(map, points_[j], weights_[j]);
    return r;
  }

  /// @}
  /// \name Boxes
  /// @{

  /// Returns two opposite corners of a box that contains the curve: that of the control points where all weights are positive,
  /// otherwise that of the control points of its parts, see `positive_parts()`.
  std::pair<Point, Point> bounding_box() const {
    if (internal::all_positive(weights_)) return internal::corners_of_box<Traits>(begin(), end());
    std::vector<Point> points;
    for (const Rational_bezier_curve& part : positive_parts()) points.insert(points.end(), part.begin(), part.end());
    return internal::corners_of_box<Traits>(points.begin(), points.end());
  }

  /// Returns the box as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(bounding_box()); }

  /// Returns the curve halved until each part has positive weights only; then it lies in the convex hull of its control points.
  /// \throws Error `work_limit` where the denominator is so close to zero that 64 halvings in a row do not suffice
  std::vector<Rational_bezier_curve> positive_parts() const {
    std::vector<Rational_bezier_curve> parts;
    internal::add_positive_parts(*this, 64, parts);
    return parts;
  }

  /// @}

  /// Returns whether control points, weights and domains are equal.
  friend bool operator==(const Rational_bezier_curve& c, const Rational_bezier_curve& d) {
    return static_cast<const Polygon&>(c) == static_cast<const Polygon&>(d) && c.weights_ == d.weights_;
  }
  /// Returns whether control points, weights or domains differ.
  friend bool operator!=(const Rational_bezier_curve& c, const Rational_bezier_curve& d) { return !(c == d); }

  /// Writes the domain, the control points and the weights.
  friend std::ostream& operator<<(std::ostream& os, const Rational_bezier_curve& c) {
    os << "Rational " << static_cast<const Polygon&>(c) << ", weights";
    for (const FT& w : c.weights_) os << ' ' << w;
    return os;
  }

private:
  Weights weights_;

  template <class InputIterator>
  static Weights checked(InputIterator first, InputIterator last, std::size_t number_of_points) {
    Weights weights;
    std::size_t given = 0;
    if constexpr (Degree == dynamic_degree) {
      weights.assign(first, last);
      given = weights.size();
    } else
      for (; first != last; ++first, ++given)
        if (given < weights.size()) weights[given] = *first;
    if (given != number_of_points)
      throw Error(Error_code::wrong_number_of_points, "Rational_bezier_curve: " + std::to_string(given) +
                                                          " weights of " + std::to_string(number_of_points) +
                                                          " control points");
    internal::check_denominator<FT>(weights, "Rational_bezier_curve: weights");
    return weights;
  }
  static Weights ones(std::size_t n) {
    if constexpr (Degree == dynamic_degree)
      return Weights(n, FT(1));
    else {
      Weights weights;
      weights.fill(FT(1));
      return weights;
    }
  }
  static Weights weights_of(const Homogeneous& c) {
    Weights weights = ones(c.control_points().size());
    for (int j = 0; j <= c.degree(); ++j) weights[j] = c.control_point(j)[c.dimension() - 1];
    internal::check_denominator<FT>(weights, "Rational_bezier_curve: weights");
    return weights;
  }
  static Per_point<Coordinates> affine_rows(const Homogeneous& c) {
    Per_point<Coordinates> rows;
    if constexpr (Degree == dynamic_degree) rows.resize(c.control_points().size());
    for (int j = 0; j <= c.degree(); ++j) rows[j] = affine_point(c.control_point(j));
    return rows;
  }

  // The i-th coordinate of the j-th homogeneous point, see homogeneous_point(). \tparam Field the numbers of the result
  template <class Field = FT> CGAL_GC_FORCEINLINE Field homogeneous_coordinate(int j, int i) const {
    const Field w = internal::to_field<Field>(weights_[j]);
    if (i == dimension()) return w;
    const Field x = internal::to_field<Field>(FT(Traits().compute_coordinate_object()(points_[j], i)));
    return w == Field(0) ? x : Field(w * x);
  }

  // The coordinates of the homogeneous points as floating-point code wants them, without a branch.
  struct Homogeneous_coordinates {
    const Rational_bezier_curve& curve;
    internal::Bezier_coefficients<Degree, FT> factors; // 1 for infinite points

    CGAL_GC_FORCEINLINE explicit Homogeneous_coordinates(const Rational_bezier_curve& c) : curve(c) {
      if constexpr (Degree == dynamic_degree) factors.resize(c.weights_.size());
      c.for_each_point([&](int j) { factors[j] = c.weights_[j] == FT(0) ? FT(1) : c.weights_[j]; });
    }
    CGAL_GC_FORCEINLINE FT operator()(int j, int i) const {
      if (i == curve.dimension()) return curve.weights_[j];
      return FT(factors[j] * FT(Traits().compute_coordinate_object()(curve.points_[j], i)));
    }
  };

  // x[0], ..., x[order], unrolled for the order k or less
  template <int k, class Jet> CGAL_GC_FORCEINLINE void write_jet(const FT& u, int order, Jet&& x) const {
    internal::with_constant_level<Degree, (N == 0 ? 0 : N + 1)>(
        dimension() + 1, degree(), u, a_, b_, Homogeneous_coordinates(*this), [&](auto level, const auto& coordinate) {
          internal::rational_bezier_jet<level, k, N>(dimension(), degree(), u, a_, b_, coordinate, order, x);
        });
  }

  template <int k> Curve_jet<Traits> jet_of_order(const FT& u, int order) const {
    if constexpr (internal::unrolls_jets<FT, Degree>) {
      Curve_jet<Traits> x(dimension(), order, internal::Unspecified());
      write_jet<k>(u, order, x);
      return x;
    } else
      return jet_of_any_order(u, order);
  }

  Curve_jet<Traits> jet_of_any_order(const FT& u, int k) const {
    constexpr int M = N == 0 ? 0 : N + 1;
    Coordinate_jet<FT, M> jet(dimension() + 1, k);
    internal::bezier_jet_of_any_order<Degree, M>(
        dimension() + 1, degree(), u, a_, b_, k, [&](int j, int i) { return homogeneous_coordinate(j, i); }, jet);
    return Curve_jet<Traits>(project(jet));
  }

  template <class Field> Field length_over() const {
    return Field(internal::to_field<Field>(b_) - internal::to_field<Field>(a_));
  }

  template <class Field, class Index>
  Coordinate_jet<Field, N> jet_of_legs(int k, const Field& step, const Index& index) const {
    constexpr int M = N == 0 ? 0 : N + 1;
    return project(internal::jet_of_legs<Field, M, Degree>(
        dimension() + 1, degree(), k, step, [&](int j, int i) { return homogeneous_coordinate<Field>(index(j), i); }));
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BEZIER_CURVE_H
