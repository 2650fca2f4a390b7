// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BSPLINE_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BSPLINE_CURVE_H

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_bezier_curve.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// A rational B-spline curve (NURBS) \f$ x(u) = \sum_i w_i b_i N_i^p(u) / \sum_i w_i N_i^p(u) \f$ with control points
/// \f$ b_0, \dots, b_{n-1} \f$, as many weights, and any knot vector with `n` coefficients.
///
/// Numerator and denominator are a B-spline curve of the homogeneous points \f$ (w_i b_i, w_i) \f$, see `homogeneous()`, and all
/// that is done with this curve is done with that one. A common factor of all weights changes nothing. A weight may be negative
/// or zero as long as the denominator is positive on the domain, which is decided exactly; see `Rational_bezier_curve` for the
/// control points of the weight 0.
///
/// The curve is a value: operations return new curves. With an exact kernel they are exact.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \models ParametricCurve
template <class Traits_> class Rational_bspline_curve : private Bspline_polygon<Traits_> {
  typedef Bspline_polygon<Traits_> Polygon;
  using Polygon::knots_;
  using Polygon::points_;
  using typename Polygon::Coordinates;

public:
  typedef Traits_ Traits;                 ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel
  /// The B-spline curve of the homogeneous points.
  typedef Bspline_curve<Homogeneous_traits<Traits>> Homogeneous;
  using Polygon::N;                                        ///< the dimension, or 0 when it is known at run time only
  typedef typename Polygon::const_iterator const_iterator; ///< iterates over the control points

  using Polygon::begin;          ///< Returns an iterator to the first control point.
  using Polygon::control_point;  ///< Returns the `i`-th control point. \pre `0 <= i < number_of_points()`
  using Polygon::control_points; ///< Returns the control points, in order.
  using Polygon::
      coordinates;          ///< Returns the coordinates of the `i`-th control point. \pre `0 <= i < number_of_points()`
  using Polygon::degree;    ///< Returns the degree `p`.
  using Polygon::dimension; ///< Returns the dimension of the control points.
  using Polygon::domain;    ///< Returns the domain \f$ [u_p, u_n] \f$.
  using Polygon::end;       ///< Returns the iterator after the last control point.
  using Polygon::knots;     ///< Returns the knots.
  using Polygon::number_of_points; ///< Returns the number `n` of control points.

  /// Takes a range of control points, a range of as many weights, and the knots.
  /// \throws Error `wrong_number_of_points` unless there are `n` control points and `n` weights
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  template <class InputIterator, class WeightIterator>
  Rational_bspline_curve(InputIterator first, InputIterator last, WeightIterator first_weight,
                         WeightIterator last_weight, Knot_vector<FT> knots)
      : Polygon(std::move(knots), std::vector<Point>(first, last)), weights_(first_weight, last_weight) {
    check();
    for (int i = 0; i < number_of_points(); ++i)
      if (weights_[i] == FT(0)) points_[i] = Geometric_continuity::to_point<Traits>(Coordinates(dimension()));
  }

  /// Takes the B-spline curve of the homogeneous points \f$ (w_i b_i, w_i) \f$.
  /// \throws Error `zero_weight` unless the denominator is positive on the whole domain, `not_finite` when a quotient overflows
  explicit Rational_bspline_curve(const Homogeneous& c) : Polygon(c.knots(), {}) {
    for (const typename Homogeneous::Point& p : c.control_points()) {
      points_.push_back(Geometric_continuity::to_point<Traits>(affine_point(p)));
      weights_.push_back(p[p.dimension() - 1]);
    }
    check();
  }

  /// Converts a polynomial curve: all weights are 1.
  Rational_bspline_curve(const Bspline_curve<Traits>& c)
      : Polygon(c.knots(), c.control_points()), weights_(c.control_points().size(), FT(1)) {}

  /// Converts a rational Bézier curve.
  template <int Degree>
  explicit Rational_bspline_curve(const Rational_bezier_curve<Traits, Degree>& c)
      : Polygon(Knot_vector<FT>(c.degree(), c.domain().first, c.domain().second),
                std::vector<Point>(c.begin(), c.end())),
        weights_(c.weights().begin(), c.weights().end()) {}

  /// Joins rational Bézier curves that continue each other: each starts where the one before it ends. Their weights are
  /// multiplied by a factor each, so that the homogeneous points meet, and all are elevated to one degree. The knots between them have the
  /// multiplicity of the degree. The lengths of the domains are kept.
  /// \throws Error `wrong_number_of_points` for an empty range, `dimension_mismatch`, `curves_do_not_meet` when two neighbours do
  ///   not fit, `empty_domain` when knots become equal by rounding
  template <class ForwardIterator>
  Rational_bspline_curve(ForwardIterator first, ForwardIterator last) : Rational_bspline_curve(joined(first, last)) {}

  /// \name Weights
  /// @{

  /// Returns the weights, in the order of the control points.
  const std::vector<FT>& weights() const { return weights_; }
  /// Returns the weight \f$ w_i \f$. \pre `0 <= i < number_of_points()`
  const FT& weight(int i) const { return weights_[i]; }

  /// Returns the B-spline curve of the homogeneous points \f$ (w_i b_i, w_i) \f$ over the same knots.
  /// \throws Error `not_finite` when a product of floating-point numbers overflows
  Homogeneous homogeneous() const {
    std::vector<typename Homogeneous::Point> points;
    for (int i = 0; i < number_of_points(); ++i) points.push_back(homogeneous_point(coordinates(i), weights_[i]));
    return Homogeneous(points.begin(), points.end(), knots_);
  }

  /// Returns whether all weights are equal. Then the curve is a polynomial one with the same control points and knots.
  bool is_polynomial() const {
    return std::all_of(weights_.begin(), weights_.end(), [&](const FT& w) { return bool(w == weights_[0]); });
  }
  /// Returns the polynomial curve with the same control points and knots if all weights are equal, otherwise nothing.
  std::optional<Bspline_curve<Traits>> polynomial() const {
    if (!is_polynomial()) return std::nullopt;
    return Bspline_curve<Traits>(points_.begin(), points_.end(), knots_);
  }

  /// @}
  /// \name Evaluation
  /// All these functions throw `Error` with `parameter_outside_domain`.
  /// @{

  /// Returns the point at `u`, from the right at a knot. \f$ O(\log n + p^2) \f$
  Point operator()(const FT& u) const { return jet(u, 0).point(); }

  /// Returns the jet of order `k >= 0` at `u` from the right; at the end of the domain from the left.
  /// \f$ O(\log n + p^2 + p\,k^2) \f$
  Curve_jet<Traits> jet(const FT& u, int k) const { return right_jet(u, k); }
  /// Returns the jet of order `k >= 0` at `u` from the left; at the start of the domain from the right.
  Curve_jet<Traits> left_jet(const FT& u, int k) const { return Curve_jet<Traits>(left_jet_over<FT>(u, k)); }
  /// Returns the jet of order `k >= 0` at `u` from the right; at the end of the domain from the left.
  Curve_jet<Traits> right_jet(const FT& u, int k) const { return Curve_jet<Traits>(right_jet_over<FT>(u, k)); }

  /// Returns the jet of order `k >= 0` at the start of the domain.
  Curve_jet<Traits> start_jet(int k) const { return right_jet(domain().first, k); }
  /// Returns the jet of order `k >= 0` at the end of the domain.
  Curve_jet<Traits> end_jet(int k) const { return left_jet(domain().second, k); }

  /// Returns the jet from the left in another field, to which all numbers are converted before anything is computed.
  template <class Field> Coordinate_jet<Field, N> left_jet_over(const FT& u, int k) const {
    return jet_over<Field>(u, knots_.left_span(u), k);
  }
  /// Returns the jet from the right in another field, to which all numbers are converted before anything is computed.
  template <class Field> Coordinate_jet<Field, N> right_jet_over(const FT& u, int k) const {
    return jet_over<Field>(u, knots_.span(u), k);
  }
  /// Returns the jet of order `k >= 0` at the start of the domain in another field.
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const {
    return right_jet_over<Field>(domain().first, k);
  }
  /// Returns the jet of order `k >= 0` at the end of the domain in another field.
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const {
    return left_jet_over<Field>(domain().second, k);
  }

  /// @}
  /// \name Other Curves
  /// These functions throw as those of `Bspline_curve`.
  /// @{

  /// Returns the same curve with `times >= 0` more copies of the knot `u`. \f$ O(n + p\,times) \f$
  Rational_bspline_curve insert(const FT& u, int times = 1) const {
    return Rational_bspline_curve(homogeneous().insert(u, times));
  }
  /// Returns the same curve over finer knots. \f$ O(p) \f$ for each knot that is inserted, and the copy
  Rational_bspline_curve refine(const Knot_vector<FT>& finer) const {
    return Rational_bspline_curve(homogeneous().refine(finer));
  }
  /// Returns the same curve with knots of multiplicity `p + 1` at the ends, without those outside the domain.
  Rational_bspline_curve clamp() const { return Rational_bspline_curve(homogeneous().clamp()); }

  /// Returns the same curve with `times >= 0` copies of the inner knot `u` less, or nothing if that changed the homogeneous curve.
  std::optional<Rational_bspline_curve> remove(const FT& u, int times = 1) const {
    const std::optional<Homogeneous> c = homogeneous().remove(u, times);
    if (!c) return std::nullopt;
    return Rational_bspline_curve(*c);
  }
  /// Returns the same curve without the inner knots that its homogeneous points do not need.
  Rational_bspline_curve remove_superfluous_knots() const {
    return Rational_bspline_curve(homogeneous().remove_superfluous_knots());
  }

  /// Returns the same curve with the degree raised by `times >= 0`, clamped.
  Rational_bspline_curve elevate(int times = 1) const { return Rational_bspline_curve(homogeneous().elevate(times)); }

  /// Returns the curve in the opposite direction, on the same domain.
  Rational_bspline_curve reverse() const {
    Rational_bspline_curve r = *this;
    r.knots_ = knots_.reverse();
    std::reverse(r.points_.begin(), r.points_.end());
    std::reverse(r.weights_.begin(), r.weights_.end());
    return r;
  }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`. The images are not checked.
  template <class Transformation> Rational_bspline_curve transform(const Transformation& map) const {
    Rational_bspline_curve r = *this;
    for (int i = 0; i < number_of_points(); ++i)
      r.points_[i] = internal::image_of_control_point<Traits>(map, points_[i], weights_[i]);
    return r;
  }

  /// Returns the rational Bézier curves on the spans that are not empty, in order.
  /// \throws Error `work_limit`
  std::vector<Rational_bezier_curve<Traits>> bezier_pieces(Work_limit limit = Work_limit()) const {
    std::vector<Rational_bezier_curve<Traits>> pieces;
    for (const Bezier_curve<Homogeneous_traits<Traits>>& piece : homogeneous().bezier_pieces(limit))
      pieces.emplace_back(piece);
    return pieces;
  }

  /// Returns the jets of order `k` at both ends of each span, those of `bezier_pieces()`; see `Bspline_curve::span_end_jets()`.
  /// \throws Error `negative_count` unless `k >= 0`, `work_limit`
  std::vector<Curve_end_jets<Traits>> span_end_jets(int k, Work_limit limit = Work_limit()) const {
    std::vector<Curve_end_jets<Traits>> result;
    const Work_scope scope(limit, "derivatives of a spline");
    for (const auto& jets : homogeneous().span_end_jets(k, limit))
      result.emplace_back(project(jets.template start_jet_over<FT>(k)), project(jets.template end_jet_over<FT>(k)));
    return result;
  }

  /// @}

  /// Returns whether knots, control points and weights are equal.
  friend bool operator==(const Rational_bspline_curve& c, const Rational_bspline_curve& d) {
    return static_cast<const Polygon&>(c) == static_cast<const Polygon&>(d) && c.weights_ == d.weights_;
  }
  /// Returns whether knots, control points or weights differ.
  friend bool operator!=(const Rational_bspline_curve& c, const Rational_bspline_curve& d) { return !(c == d); }

  /// Writes the knots, the control points and the weights.
  friend std::ostream& operator<<(std::ostream& os, const Rational_bspline_curve& c) {
    os << "Rational " << static_cast<const Polygon&>(c) << ", weights";
    for (const FT& w : c.weights_) os << ' ' << w;
    return os;
  }

private:
  std::vector<FT> weights_;

  void check() const {
    internal::check_number_of_coefficients(knots_, points_, "Rational_bspline_curve: control points");
    internal::check_number_of_coefficients(knots_, weights_, "Rational_bspline_curve: weights");
    this->check_points();
    internal::check_denominator(knots_, weights_, "Rational_bspline_curve: weights");
  }

  template <class ForwardIterator> static Homogeneous joined(ForwardIterator first, ForwardIterator last) {
    std::vector<Bezier_curve<Homogeneous_traits<Traits>>> curves;
    for (; first != last; ++first) {
      const Bezier_curve<Homogeneous_traits<Traits>> c(first->homogeneous());
      if (curves.empty()) {
        curves.push_back(c);
        continue;
      }
      const auto &end = curves.back().control_point(curves.back().degree()), &start = c.control_point(0);
      const int n = start.dimension() - 1;
      if (end.dimension() != n + 1 || affine_point(end) != affine_point(start))
        throw Error(end.dimension() == n + 1 ? Error_code::curves_do_not_meet : Error_code::dimension_mismatch,
                    "Rational_bspline_curve: Bezier curve " + std::to_string(curves.size()));
      const FT factor = FT(end[n] / start[n]);
      std::vector<typename Homogeneous::Point> points{end}; // not factor * start, which may be rounded
      for (int j = 1; j <= c.degree(); ++j) points.push_back(factor * c.control_point(j));
      curves.emplace_back(points.begin(), points.end(), c.domain().first, c.domain().second);
    }
    return Homogeneous(curves.begin(), curves.end());
  }

  template <class Field> Coordinate_jet<Field, N> jet_over(const FT& u, int span, int k) const {
    Coordinate_jet<Field, (N == 0 ? 0 : N + 1)> jet(dimension() + 1, k);
    internal::derivatives_over<Field>(
        knots_, span, u, k,
        [&](int i) {
          return homogeneous_point(Geometric_continuity::coordinates<Traits, Field>(points_[i]),
                                   internal::to_field<Field>(weights_[i]));
        },
        [&](int j, const auto& x) { jet[j] = x; });
    return project(jet);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BSPLINE_CURVE_H
