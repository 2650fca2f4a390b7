// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_MEASURED_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_MEASURED_POLYGON_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// The arc length of a Bézier curve, rational or not, from one of its ends on, in floating-point
// numbers. The length of a curve lies between that of its chord c and that of its polygon p. Halves
// are halved until c and p are near each other; then the length of a curve of degree m is nearly
// (2c + (m-1)p) / (m+1): Gravesen, "Adaptive subdivision and the length and energy of Bézier
// curves", 1997.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <int N> class Measured_polygon {
  typedef Coordinate_vector<double, N> Vector;
  typedef std::vector<Coordinate_vector<double, (N == 0 ? 0 : N + 1)>> Rows;

  // homogeneous points from that end on, which is the origin; scaled so that the largest
  // coordinate is near 1
  Rows rows_;
  int exponent_ = 0; // of the scale

  static constexpr double precision = 0x1p-12; // relative, of a length
  static constexpr double tolerance = 0x1p-11; // relative, of the length up to parameter_at()
  static constexpr int deepest = 40;           // number of halvings: reached next to a cusp only

public:
  // \throws Error `not_finite` when the size of the curve is out of the range of `double`
  template <class Curve> Measured_polygon(const Curve& curve, Curve_end end) {
    typedef typename Curve::FT FT;
    const int m = curve.degree();
    double largest = 0;
    std::vector<Vector> sides;
    std::vector<double> weights(m + 1, 1.);
    for (int j = 0; j <= m; ++j) {
      const int number = end == Curve_end::start ? j : m - j;
      Coordinate_vector<FT, N> side = curve.coordinates(number);
      if constexpr (Is_rational<Curve>::value)
        weights[j] = CGAL::to_double(FT(curve.weight(number) / curve.weight(end == Curve_end::start ? 0 : m)));
      // else it is a direction
      if (weights[j] != 0) side -= curve.coordinates(end == Curve_end::start ? 0 : m);
      Vector row(side.dimension());
      for (int i = 0; i < side.dimension(); ++i) {
        row[i] = CGAL::to_double(side[i]);
        largest = (std::max)(largest, std::abs(row[i]));
      }
      sides.push_back(row);
    }
    if (!(largest <= (std::numeric_limits<double>::max)())) throw Error(Error_code::not_finite, "length of a curve");
    if (largest > 0) exponent_ = std::ilogb(largest);
    for (int j = 0; j <= m; ++j) {
      for (int i = 0; i < sides[j].dimension(); ++i) sides[j][i] = std::ldexp(sides[j][i], -exponent_);
      rows_.push_back(homogeneous_point(sides[j], weights[j]));
    }
  }

  // Returns the arc length, with a relative error of at most 2^-12.
  double length() const {
    Rows rows = rows_;
    // equivalent [0 -> 1, 1]: one halving less next to a cusp
    return std::ldexp(length_of(rows, 0), exponent_);
  }

  // Returns the parameter in (0, 1), counted from that end, up to which the curve has the wanted
  // length with a relative error of at most 2^-11 + 2^-12 < 1/1000. It is the first such number
  // that bisection comes to, so that it has few digits.
  // \pre 0 < distance < length() \throws Error `not_representable` when there is no such
  //   floating-point number
  double parameter_at(double distance) const {
    const double wanted = std::ldexp(distance, -exponent_);
    Rows after = rows_; // the curve on [low, low + 2 half]
    double low = 0, length_to_low = 0;
    // unreachable: needs a curve that passes the whole distance between neighbouring parameters
    for (double half = 0.5; low + half != low; half /= 2) {
      Rows before = after;
      bernstein_split(after, degree(), 0.5, before);
      Rows measured = before;
      const double length = length_to_low + length_of(measured, 0);
      if (std::abs(length - wanted) <= tolerance * wanted) return low + half;
      if (length < wanted) {
        low += half;
        length_to_low = length;
      } else
        after = before;
    }
    // unreachable: needs a curve that passes the whole distance between neighbouring parameters
    throw Error(Error_code::not_representable, "parameter at the arc length " + std::to_string(distance));
  }

private:
  int degree() const { return static_cast<int>(rows_.size()) - 1; }

  // The rows are overwritten.
  double length_of(Rows& rows, int depth) const {
    const int m = degree();
    std::vector<Vector> points;
    bool positive = true; // else the curve need not be between its chord and its polygon
    for (const auto& row : rows) {
      points.push_back(affine_point(row));
      positive = positive && row[row.dimension() - 1] > 0;
    }
    double polygon = 0;
    for (int j = 0; j < m; ++j) polygon += distance(points[j], points[j + 1]);
    const double chord = distance(points[0], points[m]);
    // unreachable: ends a search that others end earlier, but at a cusp of a scale that no double
    //   has
    if ((positive && polygon - chord <= precision * polygon) || depth == deepest)
      return (2 * chord + (m - 1) * polygon) / (m + 1);
    Rows left = rows;
    bernstein_split(rows, m, 0.5, left);
    const double length = length_of(left, depth + 1);
    return length + length_of(rows, depth + 1);
  }

  static double distance(const Vector& a, const Vector& b) { return std::sqrt(dot(b - a, b - a)); }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_MEASURED_POLYGON_H
