// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_BSPLINE_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_BSPLINE_SHAPE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <array>
#include <type_traits>
#include <vector>

/// \file Rational_bspline_shape.h
/// This is what only rational B-spline curves have: jets on spans, knots that are inserted, and
/// their Bézier pieces.

namespace CGAL {
namespace Geometric_continuity {

template <class Shape> class Rational_curve;

namespace internal {

template <class Traits> struct Curve_shape<Bspline_curve<Traits>> {
  typedef Bspline_curve<Traits> Shape;
  typedef Rational_curve<Shape> Curve;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Bspline_curve<Homogeneous_traits<Traits>> Homogeneous;
  typedef Bspline_curve<Traits> Elevated;
  static constexpr int Degree = dynamic_degree;
  static constexpr int N = dimension_v<Traits>, M = N == 0 ? 0 : N + 1; // M counts the weight

  // Returns the curve with other points, over the knots of c.
  template <class Result, class Polygon, class Points>
  static Result with_points(const Polygon& c, const Points& points) {
    return Result(points.begin(), points.end(), c.knots());
  }
  template <class Weights> static void check_weights(const Shape& shape, const Weights& weights) {
    check_denominator(shape.knots(), weights, "Rational_bspline_curve: weights");
  }
  // Returns the points.
  // \throws Error `wrong_number_of_points` unless points and weights are as many as the knots need
  static const std::vector<Point>& checked(const std::vector<Point>& points, const std::vector<FT>& weights,
                                           const Knot_vector<FT>& knots) {
    check_number_of_coefficients(knots, points, "Rational_bspline_curve: control points");
    check_number_of_coefficients(knots, weights, "Rational_bspline_curve: weights");
    return points;
  }

  static Point point(const Curve& c, const FT& u) { return jet(c, u, 0).point(); }
  static Curve_jet<Traits> jet(const Curve& c, const FT& u, int k) { return c.right_jet(u, k); }
  template <int k> static Curve_jet<Traits> jet(const Curve& c, const FT& u) { return jet(c, u, k); }
  template <class Field> static Coordinate_jet<Field, N> start_jet_over(const Curve& c, int k) {
    return c.template right_jet_over<Field>(c.domain().first, k);
  }
  template <class Field> static Coordinate_jet<Field, N> end_jet_over(const Curve& c, int k) {
    return c.template left_jet_over<Field>(c.domain().second, k);
  }

  template <class Field> static Coordinate_jet<Field, N> jet_over(const Curve& c, const FT& u, int span, int k) {
    Coordinate_jet<Field, M> jet(c.dimension() + 1, k);
    derivatives_over<Field>(
        c.knots(), span, u, k, [&](int i) { return c.template homogeneous_row<Field>(i); },
        [&](int j, const Coordinate_vector<Field, M>& x) { jet[j] = x; });
    return project(jet);
  }
  static Curve_jet<Traits> jet_on_span(const Curve& c, const FT& u, int span, int k) {
    return std::is_floating_point_v<FT> && 0 <= k && k <= 3 ? short_jet_on_span(c, u, span, k)
                                                            : Curve_jet<Traits>(jet_over<FT>(c, u, span, k));
  }

  // Functions of Bezier curves, refused by the sentence that tells the call.
  template <class C> static std::pair<C, C> split(const C& c, const FT&) {
    static_assert(never<C>, CGAL_GEOMETRIC_CONTINUITY_ASK_SPLIT);
    return {c, c};
  }
  template <class C> static const C& with_domain(const C& c, const FT&, const FT&) {
    static_assert(never<C>, "c.with_domain(a, b) is of a Bezier curve: give a spline other knots");
    return c;
  }
  template <class C> static Rational_curve<Bezier_curve<Traits>> derivative(const C& c) {
    static_assert(never<C>, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE);
    return bezier_pieces(c).front();
  }
  template <class C> static auto bounding_box(const C& c) {
    static_assert(never<C>, CGAL_GEOMETRIC_CONTINUITY_ASK_BOX);
    return std::pair(c.control_point(0), c.control_point(0));
  }

  static Curve insert(const Curve& c, const FT& u, int times) {
    typedef typename Homogeneous::Point Row;
    const Knot_vector<FT> finer = c.knots().insert(u, times);
    const Knot_insertion<FT> insertion(c.knots(), u, times);
    const std::vector<Row> changed =
        insertion.template new_coefficients<Row>([&](int j) { return c.template homogeneous_row<FT>(j); });
    const auto point = [&](int i) { return to_point<Traits>(affine_point(changed[i])); };
    const auto weight = [&](int i) { return changed[i][c.dimension()]; };
    return Curve(insertion.replaced(c.control_points(), point), insertion.replaced(c.weights(), weight), finer);
  }

  static std::vector<Rational_curve<Bezier_curve<Traits>>> bezier_pieces(const Curve& c) {
    std::vector<Rational_curve<Bezier_curve<Traits>>> pieces;
    for (const auto& piece : c.homogeneous().bezier_pieces()) pieces.emplace_back(piece);
    return pieces;
  }

  static std::vector<Curve_end_jets<Traits>> span_end_jets(const Curve& c, int k) {
    std::vector<Curve_end_jets<Traits>> result;
    const Work_scope scope(Work_scope::limit_of_each(), "derivatives of a spline");
    for (const auto& jets : c.homogeneous().span_end_jets(k))
      result.emplace_back(project(jets.template start_jet_over<FT>(k)), project(jets.template end_jet_over<FT>(k)));
    return result;
  }

private:
  static Curve_jet<Traits> short_jet_on_span(const Curve& c, const FT& u, int span, int k) {
    typedef Coordinate_row<FT, M> Row;
    Curve_jet<Traits> x(c.dimension(), k, Unspecified());
    std::array<Row, 4> p;
    for (int j = c.degree() + 1; j <= k; ++j)
      p[j] = coordinate_row<FT, M>(c.dimension() + 1, [](int) { return FT(0); });
    derivatives_over<FT>(
        c.knots(), span, u, k,
        [&](int i) {
          return coordinate_row<FT, M>(c.dimension() + 1,
                                       [&](int l) { return c.template homogeneous_coordinate<FT>(i, l); });
        },
        [&](int j, const Row& y) {
          // unreachable: tells compilers what holds
          if (j <= 3) p[j] = y; // as a compiler may not see
        });
    project_short<FT>(p, c.dimension(), k, x);
    return x;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_BSPLINE_SHAPE_H
