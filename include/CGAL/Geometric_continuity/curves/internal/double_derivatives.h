// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DOUBLE_DERIVATIVES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DOUBLE_DERIVATIVES_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

// The first three derivatives of the pieces of a curve in floating-point numbers, by a parameter in
// [0, 1] on each piece. Their purpose depends neither on the scale nor on the parameter of the
// curve.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <int N> using Double_derivatives = std::array<Coordinate_vector<double, N>, 3>;

// Evaluates the derivatives of a Bezier curve.
template <int N> class Bezier_derivatives {
  typedef Coordinate_vector<double, N> Vector;
  std::array<std::vector<Vector>, 3> rows_; // the control points of the derivatives

public:
  explicit Bezier_derivatives(std::vector<Vector> rows) {
    const Vector zero(rows.front().dimension());
    for (std::vector<Vector>& derivative : rows_) {
      const int m = static_cast<int>(rows.size()) - 1;
      if (m == 0)
        rows.front() = zero;
      else {
        difference_step(rows, m);
        rows.pop_back();
        for (Vector& row : rows) row *= static_cast<double>(m);
      }
      derivative = rows;
    }
  }

  Double_derivatives<N> operator()(double t) const {
    const auto value = [t](std::vector<Vector> rows) -> Vector {
      return bernstein_value(rows, static_cast<int>(rows.size()) - 1, t);
    };
    return {value(rows_[0]), value(rows_[1]), value(rows_[2])};
  }
};

// Evaluates the derivatives of a rational curve, from its control points and weights.
template <int N> class Rational_derivatives {
  static constexpr int M = N == 0 ? 0 : N + 1;
  std::vector<Coordinate_vector<double, M>> rows_;

public:
  Rational_derivatives(const std::vector<Coordinate_vector<double, N>>& points, const std::vector<double>& weights) {
    for (std::size_t j = 0; j < points.size(); ++j) rows_.push_back(homogeneous_point(points[j], weights[j]));
  }

  Double_derivatives<N> operator()(double t) const {
    std::vector<Coordinate_vector<double, M>> rows = rows_;
    Coordinate_jet<double, M> jet(rows.front().dimension(), 3);
    bernstein_derivatives(rows, static_cast<int>(rows.size()) - 1, t, 3,
                          [&](int j, const Coordinate_vector<double, M>& x) { jet[j] = x; });
    const Coordinate_jet<double, N> x = project(jet);
    return {x[1], x[2], x[3]};
  }
};

// Evaluates the derivatives of any model of ParametricCurve, divided by the length of the first
// derivative in the middle, if it is not zero.
template <class Curve> class Curve_derivatives {
  typedef typename Curve::Traits Traits;
  typedef typename Traits::FT FT;
  static constexpr int N = dimension_v<Traits>;
  const Curve* curve_;
  FT a_, h_; // the domain is [a, a + h]
  double scale_ = 1;

public:
  explicit Curve_derivatives(const Curve& curve)
      : curve_(&curve), a_(curve.domain().first), h_(FT(curve.domain().second - a_)) {
    const Coordinate_vector<double, N> d1 = (*this)(0.5)[0];
    const double speed = std::sqrt(dot(d1, d1));
    if (speed > 0) scale_ = 1 / speed;
  }

  Double_derivatives<N> operator()(double t) const {
    const Curve_jet<Traits> jet = curve_->jet(FT(a_ + FT(t) * h_), 3);
    if (jet.order() < 3) throw Error(Error_code::jet_order_too_low, "fairness of a curve");
    Double_derivatives<N> d;
    double factor = scale_;
    for (int k = 0; k < 3; ++k) {
      factor *= CGAL::to_double(h_);
      d[k] = Coordinate_vector<double, N>(jet.dimension());
      for (int i = 0; i < jet.dimension(); ++i) d[k][i] = factor * CGAL::to_double(jet[k + 1][i]);
    }
    return d;
  }
};

// The pieces of a curve that is made of Bezier curves, moved to the origin and divided by their
// size, so that numbers of any size become doubles.
template <class Curve> auto bezier_derivatives(const Curve& curve) {
  typedef typename Curve::FT FT;
  constexpr int N = Curve::N;
  constexpr bool rational = Is_rational<Curve>::value;
  std::vector<std::vector<Coordinate_vector<FT, N>>> pieces;
  std::vector<std::vector<double>> weights;
  for_each_piece(curve, [&](const auto& piece) {
    pieces.push_back(affine_rows<Curve>(control_rows(piece)));
    if constexpr (rational) {
      weights.emplace_back();
      for (const FT& w : piece.weights()) weights.back().push_back(CGAL::to_double(FT(w / piece.weights()[0])));
    }
  });
  const Coordinate_vector<FT, N> origin = pieces.front().front();
  FT size(0);
  for (std::vector<Coordinate_vector<FT, N>>& rows : pieces)
    for (Coordinate_vector<FT, N>& row : rows) {
      row -= origin;
      for (const FT& x : row) {
        check_finite(x, "fairness of a curve");
        if (size < x) size = x;
        if (size < -x) size = FT(-x);
      }
    }
  std::vector<std::conditional_t<rational, Rational_derivatives<N>, Bezier_derivatives<N>>> result;
  for (const std::vector<Coordinate_vector<FT, N>>& rows : pieces) {
    std::vector<Coordinate_vector<double, N>> points;
    for (const Coordinate_vector<FT, N>& row : rows) {
      points.emplace_back(row.dimension());
      for (int i = 0; i < row.dimension(); ++i)
        points.back()[i] = size == FT(0) ? 0 : CGAL::to_double(FT(row[i] / size));
    }
    if constexpr (rational)
      result.emplace_back(points, weights[result.size()]);
    else
      result.emplace_back(std::move(points));
  }
  return result;
}

template <class Curve, class = void> struct Has_bezier_pieces : std::false_type {};
template <class Curve>
struct Has_bezier_pieces<Curve, std::void_t<decltype(for_each_piece(std::declval<const Curve&>(), 0))>>
    : std::true_type {};

// Returns one function for each piece. A curve of which no pieces are known is one piece.
template <class Curve> auto derivatives_of_pieces(const Curve& curve) {
  if constexpr (Has_bezier_pieces<Curve>::value)
    return bezier_derivatives(curve);
  else
    return std::vector<Curve_derivatives<Curve>>(1, Curve_derivatives<Curve>(curve));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DOUBLE_DERIVATIVES_H
