// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_CURVE_PIECES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_CURVE_PIECES_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Calls f for each of the Bezier curves that a curve is made of, in order.
template <class Traits, int Degree, class Function>
void for_each_bezier(const Bezier_curve<Traits, Degree>& curve, Function f) {
  f(curve);
}
template <class Traits, int Degree, class Function>
void for_each_bezier(const Rational_bezier_curve<Traits, Degree>& curve, Function f) {
  f(curve);
}
template <class Traits, int Degree, class Function>
void for_each_bezier(const Composite_bezier_curve<Traits, Degree>& curve, Function f) {
  for (int l = 0; l < curve.number_of_segments(); ++l) f(curve.segment(l));
}
template <class Traits, class Function> void for_each_bezier(const Bspline_curve<Traits>& curve, Function f) {
  for (const Bezier_curve<Traits>& piece : curve.bezier_pieces()) f(piece);
}
template <class Traits, class Function> void for_each_bezier(const Rational_bspline_curve<Traits>& curve, Function f) {
  for (const Rational_bezier_curve<Traits>& piece : curve.bezier_pieces()) f(piece);
}

// Applies the function to the pieces of a curve, where rational curves are given in parts whose
// weights are positive, so that each lies in the convex hull of its control points.
template <class Curve, class Function>
auto for_each_piece(const Curve& curve, Function f) -> decltype(for_each_bezier(curve, f)) {
  for_each_bezier(curve, [&](const auto& piece) {
    if constexpr (Is_rational<Curve>::value)
      for (const auto& part : piece.positive_parts()) f(part);
    else
      f(piece);
  });
}

// Returns the coordinates to which the algorithms of Bernstein and de Casteljau are applied: those
// of the control points, or of the homogeneous points of a rational curve.
template <class Traits, int Degree>
std::vector<Coordinates<Traits>> control_rows(const Bezier_curve<Traits, Degree>& curve) {
  std::vector<Coordinates<Traits>> rows;
  for (int j = 0; j <= curve.degree(); ++j) rows.push_back(curve.coordinates(j));
  return rows;
}
template <class Traits, int Degree>
std::vector<Coordinates<Homogeneous_traits<Traits>>> control_rows(const Rational_bezier_curve<Traits, Degree>& curve) {
  const typename Rational_bezier_curve<Traits, Degree>::Homogeneous h = curve.homogeneous();
  return {h.begin(), h.end()};
}

// Columns of coordinates as points.
template <class Traits> struct Coordinates_of { typedef Coordinates<Traits> Point; };

// The type of such a row of a curve.
template <class Curve>
using Control_row = typename std::conditional_t<Is_rational<Curve>::value, Homogeneous_traits<typename Curve::Traits>,
                                                Coordinates_of<typename Curve::Traits>>::Point;

// The coordinates of the control points from such rows.
template <class Curve, class Rows> std::vector<Coordinates<typename Curve::Traits>> affine_rows(const Rows& rows) {
  if constexpr (Is_rational<Curve>::value) {
    std::vector<Coordinates<typename Curve::Traits>> points;
    for (const auto& row : rows) points.push_back(affine_point(row));
    return points;
  } else
    return rows;
}

// The control points of both halves.
template <class FT, int N>
std::pair<std::vector<Coordinate_vector<FT, N>>, std::vector<Coordinate_vector<FT, N>>>
halves(std::vector<Coordinate_vector<FT, N>> rows) {
  std::vector<Coordinate_vector<FT, N>> left = rows;
  bernstein_split(rows, static_cast<int>(rows.size()) - 1, FT(FT(1) / FT(2)), left);
  return {std::move(left), std::move(rows)};
}

// 0 for exact numbers. For floating-point numbers a length that is larger than any error that up to
// 32 halvings make in a control point: each halving of a polygon of m sides takes the middle of two
// numbers at most m times in a row, and each middle is rounded once, by at most 2^-53 |x| (in
// doubles) where |x| is the largest coordinate. That is 32 m 2^-53 |x| in each coordinate, and in
// up to 16 dimensions at most 4 times as much, m 2^-46 |x|. The result, (m + 1) 2^-44 |x|, leaves
// three quarters for the roundings in what is computed from the control points.
template <class FT, int N> FT rounding_allowance(const std::vector<Coordinate_vector<FT, N>>& rows) {
  if constexpr (std::is_floating_point_v<FT>) {
    FT size = (std::numeric_limits<FT>::min)();
    for (const Coordinate_vector<FT, N>& row : rows)
      for (const FT& x : row) size = (std::max)(size, (std::max)(x, -x));
    return FT(256 * std::numeric_limits<FT>::epsilon() * FT(rows.size()) * size);
  } else
    return FT(0);
}

// Takes the homogeneous rows of a rational curve with positive weights. An error e in w x and in w
// makes one of 2 e / w in x.
template <class Curve, class Rows> typename Curve::FT rounding_allowance_of(const Rows& rows) {
  typedef typename Curve::FT FT;
  const FT allowance = rounding_allowance(affine_rows<Curve>(rows));
  if constexpr (Is_rational<Curve>::value && std::is_floating_point_v<FT>) {
    const int n = rows.front().dimension() - 1;
    FT least = rows.front()[n], greatest = least;
    for (const auto& row : rows) {
      least = (std::min)(least, row[n]);
      greatest = (std::max)(greatest, row[n]);
    }
    return FT(FT(2) * (greatest / least) * allowance);
  } else
    return allowance;
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_CURVE_PIECES_H
