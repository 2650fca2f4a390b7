// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_SPLINE_KNOT_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_SPLINE_KNOT_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

/// \file Spline_knot.h
/// The join of two spans of one B-spline curve, at a knot u of multiplicity m. Their polynomials
/// have p + 1 - m control points in common, at each of which their blossoms have the argument u m
/// times; therefore they agree up to the derivatives of order p - m, whatever the numbers are. What
/// is left to decide is whether the tangent vanishes, and whether the next derivative jumps: at
/// most knots intervals suffice for that, however long the numbers are. De Boor, "A Practical Guide
/// to Splines".

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The span [t_p, t_p+1] of a B-spline curve of degree p, enclosed. \pre rounding upwards, as in the
// scope of Protect_FPU_rounding
template <int N> class Enclosed_span {
  typedef Interval_nt<false> Interval;
  typedef Coordinate_vector<Interval, N> Vector;
  static constexpr int most_points = 16;

  const int p_;
  std::array<Interval, 2 * most_points> t_;
  std::array<Vector, most_points> c_;

  template <class Number> static Interval enclosure(const Number& x) {
    if constexpr (std::is_floating_point_v<Number>)
      return Interval(x);
    else
      return x.enclosure();
  }

public:
  // Takes a part of a curve with this span. \pre its degree is below most_points
  template <class Part> explicit Enclosed_span(const Part& part) : p_(part.degree) {
    for (int i = 0; i <= 2 * p_ + 1; ++i) t_[i] = enclosure(part.knots[i]);
    for (int j = 0; j <= p_; ++j)
      for (int i = 0; i < N; ++i) c_[j][i] = enclosure(part.coordinates[j * N + i]);
  }

  // The derivative of order r at an end of the span: r differences, and then the steps of de Boor's
  // algorithm.
  Vector derivative(int r, bool at_end) const {
    std::array<Vector, most_points> d = c_;
    const Interval& u = t_[p_ + at_end];
    for (int k = 1; k <= p_; ++k)
      for (int i = p_; i >= k; --i) {
        const Interval length = t_[i + p_ + 1 - k] - t_[i];
        const Vector step = d[i] - d[i - 1];
        d[i] = k <= r ? Interval(p_ + 1 - k) / length * step : d[i - 1] + (u - t_[i]) / length * step;
      }
    return d[p_];
  }
};

// The multiplicity of the knot between two neighbouring spans of one curve, up to the degree; 0 for
// any other two of one dimension.
template <class Part> int multiplicity_between(const Part& left, const Part& right) {
  const int p = left.degree;
  if (right.degree != p) return 0;
  int m = 1;
  while (m <= p && left.knots[p + 1 + m] == left.knots[p + 1]) ++m;
  const auto continues = [](const auto& x, const auto& y, int shift) {
    return std::equal(x.begin() + shift, x.end(), y.begin(), y.end() - shift);
  };
  return m <= p && continues(left.knots, right.knots, m) &&
                 continues(left.coordinates, right.coordinates, m * left.dimension)
             ? m
             : 0;
}

// The orders of the join of two neighbouring spans of one curve in the plane or in space, up to
// order 3. Returns false for any other two, and where intervals do not suffice; then `join` is
// unspecified.
template <int N, class Part, class Join>
bool decide_at_spline_knot(const Part& left, const Part& right, int max_order, Join& join) {
  typedef Interval_nt<false> Interval;
  typedef Coordinate_vector<Interval, N> Vector;
  const auto has_sign = [](const Interval& x) { return x.inf() > 0 || x.sup() < 0; };
  const int m = multiplicity_between(left, right), smooth = left.degree - m;
  if (m == 0 || smooth == 0) return false;
  const Protect_FPU_rounding<true> rounding_upwards;
  const Enclosed_span<N> x(left);
  const Vector tangent = x.derivative(1, true);
  if (std::none_of(tangent.begin(), tangent.end(), has_sign)) return false;
  if (smooth < max_order) {
    const Vector jump = Enclosed_span<N>(right).derivative(smooth + 1, false) - x.derivative(smooth + 1, true);
    const auto minor = [&](int i, int j) { return Interval(tangent[i] * jump[j] - tangent[j] * jump[i]); };
    if constexpr (N == 2) {
      if (!has_sign(minor(0, 1))) return false;
    } else {
      const std::array<Interval, 3> normal = {minor(1, 2), minor(2, 0), minor(0, 1)};
      if (std::none_of(normal.begin(), normal.end(), has_sign)) return false;
      if (smooth == 2) { // the torsion jumps
        const Vector second = x.derivative(2, true);
        if (!has_sign(normal[0] * second[0] + normal[1] * second[1] + normal[2] * second[2])) return false;
      }
    }
  }
  join.regular = true;
  join.tangent_equal = true;
  join.c_order = join.g_order = (std::min)(smooth, max_order);
  join.f_order = (std::min)(join.g_order, N);
  return true;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_SPLINE_KNOT_H
