// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_BEZIER_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_BEZIER_SHAPE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/bezier_jet.h>
#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file Rational_bezier_shape.h
/// This is what only rational Bézier curves have: jets by unrolled code, the derivative, and parts
/// with positive weights.

namespace CGAL {
namespace Geometric_continuity {

template <class Shape> class Rational_curve;

namespace internal {

template <class Traits, int Degree_> struct Curve_shape<Bezier_curve<Traits, Degree_>> {
  typedef Bezier_curve<Traits, Degree_> Shape;
  typedef Rational_curve<Shape> Curve;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Bezier_curve<Homogeneous_traits<Traits>, Degree_> Homogeneous;
  typedef Bezier_curve<Traits> Elevated;
  static constexpr int Degree = Degree_;
  static constexpr int N = dimension_v<Traits>, M = N == 0 ? 0 : N + 1; // M counts the weight

  // Returns the curve with other points, on the domain of c.
  template <class Result, class Polygon, class Points>
  static Result with_points(const Polygon& c, const Points& points) {
    return Result(points.begin(), points.end(), c.domain().first, c.domain().second);
  }
  template <class Weights> static void check_weights(const Shape&, const Weights& weights) {
    check_denominator<FT>(weights, "Rational_bezier_curve: weights");
  }
  // Returns as many weights as the shape has control points.
  // \throws Error `wrong_number_of_points` for another number of weights
  template <class Weights, class Iterator> static Weights taken(const Shape& shape, Iterator first, Iterator last) {
    Weights weights;
    std::size_t given = 0;
    if constexpr (Degree == dynamic_degree) {
      weights.assign(first, last);
      given = weights.size();
    } else
      for (; first != last; ++first, ++given)
        if (given < weights.size()) weights[given] = *first;
    const std::size_t needed = shape.control_points().size();
    if (given != needed)
      throw Error(Error_code::wrong_number_of_points, "Rational_bezier_curve: " + std::to_string(given) +
                                                          " weights of " + std::to_string(needed) + " control points");
    return weights;
  }

  static Point point(const Curve& c, const FT& u) {
    if constexpr (unrolls_jets<FT, Degree>) {
      Coordinates<Traits> x(c.dimension());
      write_jet<0>(c, u, 0, &x);
      return to_point<Traits>(x);
    } else
      return jet_of_any_order(c, u, 0).point();
  }
  static Curve_jet<Traits> jet(const Curve& c, const FT& u, int k) {
    return with_largest_order<FT, Degree>(
        k, [&](auto order) { return jet_of_order<decltype(order)::value>(c, u, k); },
        [&] { return jet_of_any_order(c, u, k); });
  }
  template <int k> static Curve_jet<Traits> jet(const Curve& c, const FT& u) {
    if constexpr (Degree == dynamic_degree)
      return jet(c, u, k);
    else
      return jet_of_order<k>(c, u, k);
  }
  template <class Field> static Coordinate_jet<Field, N> start_jet_over(const Curve& c, int k) {
    return end_jet_over<Field>(c, k, length_over<Field>(c), [](int j) { return j; });
  }
  template <class Field> static Coordinate_jet<Field, N> end_jet_over(const Curve& c, int k) {
    return end_jet_over<Field>(c, k, Field(-length_over<Field>(c)), [m = c.degree()](int j) { return m - j; });
  }

  static Curve reparametrised(Curve c, const FT& factor) {
    check_finite(factor, "Rational_bezier_curve::reparametrised");
    if (!(FT(0) < factor)) throw Error(Error_code::zero_weight, "Rational_bezier_curve::reparametrised");
    FT power(1);
    for (FT& w : c.weights_) {
      w *= power;
      power *= factor;
    }
    check_finite_weights(c.weights_, "Rational_bezier_curve::reparametrised");
    return c;
  }

  static Rational_curve<Bezier_curve<Traits>> derivative(const Curve& c) {
    typedef Rational_curve<Bezier_curve<Traits>> Derivative;
    const Homogeneous h = c.homogeneous();
    const int n = c.dimension();
    const Bernstein_polynomial<FT> w = h.coordinate_polynomial(n), dw = w.derivative();
    const Bernstein_polynomial<FT> square = w * w;
    const FT length = FT(c.domain().second - c.domain().first);
    std::vector<typename Homogeneous::Point> rows(square.degree() + 1, typename Homogeneous::Point(n + 1));
    for (int i = 0; i < n; ++i) {
      const Bernstein_polynomial<FT> p = h.coordinate_polynomial(i);
      const Bernstein_polynomial<FT> numerator = p.derivative() * w - p * dw;
      const Bernstein_polynomial<FT> row = numerator.elevated(square.degree() - numerator.degree());
      for (int j = 0; j <= square.degree(); ++j) rows[j][i] = FT(row[j] / length);
    }
    for (int j = 0; j <= square.degree(); ++j) rows[j][n] = square[j];
    return Derivative(typename Derivative::Homogeneous(rows, c.domain().first, c.domain().second));
  }

  static std::pair<Curve, Curve> split(const Curve& c, const FT& u) {
    const std::pair<Homogeneous, Homogeneous> parts = c.homogeneous().split(u);
    return {Curve(parts.first), Curve(parts.second)};
  }

  static Curve with_domain(Curve c, const FT& a, const FT& b) {
    check_interval(std::pair<FT, FT>(a, b), "Rational_bezier_curve::with_domain");
    c.shape_ = c.shape_.with_domain(a, b);
    return c;
  }

  static std::pair<Point, Point> bounding_box(const Curve& c) {
    if (all_positive(c.weights())) return c.unweighted().bounding_box();
    std::vector<Point> points;
    for (const Curve& part : c.positive_parts()) points.insert(points.end(), part.begin(), part.end());
    return corners_of_box<Traits>(points.begin(), points.end());
  }

private:
  // No lambda expression, which a compiler may refuse to inline.
  struct Homogeneous_coordinates {
    const Curve& curve;
    CGAL_GC_FORCEINLINE FT operator()(int j, int i) const { return curve.template homogeneous_coordinate<FT>(j, i); }
  };

  CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF // of loops that are compiled here
      // x[0], ..., x[order], unrolled for the order k or less
      template <int k, class Jet>
      CGAL_GC_FORCEINLINE static void write_jet(const Curve& c, const FT& u, int order, Jet&& x) {
    const Shape& shape = c.unweighted();
    with_constant_level<Degree, M>(c.dimension() + 1, c.degree(), u, shape.a_, shape.b_, Homogeneous_coordinates{c},
                                   [&](auto level, const auto& coordinate) {
                                     rational_bezier_jet<level, k, N>(c.dimension(), c.degree(), u, shape.a_, shape.b_,
                                                                      coordinate, order, x);
                                   });
  }
  CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

  template <int k> static Curve_jet<Traits> jet_of_order(const Curve& c, const FT& u, int order) {
    Curve_jet<Traits> x(c.dimension(), order, Unspecified());
    write_jet<k>(c, u, order, x);
    return x;
  }
  static Curve_jet<Traits> jet_of_any_order(const Curve& c, const FT& u, int k) {
    Coordinate_jet<FT, M> jet(c.dimension() + 1, k);
    bezier_jet_of_any_order<Degree, M>(
        c.dimension() + 1, c.degree(), u, c.domain().first, c.domain().second, k,
        [&](int j, int i) { return c.template homogeneous_coordinate<FT>(j, i); }, jet);
    return Curve_jet<Traits>(project(jet));
  }

  template <class Field> static Field length_over(const Curve& c) {
    return Field(to_field<Field>(c.domain().second) - to_field<Field>(c.domain().first));
  }
  template <class Field, class Index>
  static Coordinate_jet<Field, N> end_jet_over(const Curve& c, int k, const Field& step, const Index& index) {
    return project(jet_of_differences<Field, M, Degree>(c.dimension() + 1, c.degree(), k, step, [&](int j, int i) {
      return c.template homogeneous_coordinate<Field>(index(j), i);
    }));
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_BEZIER_SHAPE_H
