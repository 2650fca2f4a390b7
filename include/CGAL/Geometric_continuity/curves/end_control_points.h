// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_END_CONTROL_POINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_END_CONTROL_POINTS_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/end_jet.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// \file end_control_points.h
/// The control points at an end of a Bézier curve from a jet: the inverse of `Bezier_curve::start_jet()` and
/// `Bezier_curve::end_jet()`. The `j`-th difference of the points is \f$ h^j \frac{(m-j)!}{m!} x^{(j)} \f$.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The first k+1 Bezier points b_0, ..., b_k of the curve of degree m >= k with this jet at its start:
// the j-th difference of the points is h^j (m-j)!/m! x^(j). With h < 0, the last points from the end inwards.
template <class FT, int N>
std::vector<Coordinate_vector<FT, N>> points_from_jet(const Coordinate_jet<FT, N>& jet, int m, const FT& h) {
  const int k = jet.order();
  if (k < 0 || m < k)
    throw Error(Error_code::wrong_number_of_points,
                "a jet of order " + std::to_string(k) + " does not fit degree " + std::to_string(m));
  std::vector<Coordinate_vector<FT, N>> b;
  FT factor(1);
  for (int j = 0; j <= k; ++j) {
    b.push_back(factor * jet[j]);
    if (j < k) factor *= h / FT(m - j);
  }
  // sum the differences up: b holds the j-th differences at 0
  for (int level = k; level > 0; --level)
    for (int j = level; j <= k; ++j) b[j] += b[j - 1];
  return b;
}

template <class FT, int N>
std::vector<Coordinate_vector<FT, N>> finite_points_from_jet(const Coordinate_jet<FT, N>& jet, int m, const FT& h) {
  check_finite(h, "control points from a jet: length of the domain");
  std::vector<Coordinate_vector<FT, N>> b = points_from_jet(jet, m, h);
  for (const Coordinate_vector<FT, N>& p : b)
    for (const FT& x : p) check_finite(x, "control points from a jet");
  return b;
}

template <class Traits> std::vector<typename Traits::Point> to_points(const std::vector<Coordinates<Traits>>& b) {
  std::vector<typename Traits::Point> points;
  for (const Coordinates<Traits>& x : b) points.push_back(to_point<Traits>(x));
  return points;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns the first `k + 1` control points of every Bézier curve of degree `m` on a domain of length `h` that has the given jet
/// of order `k` at its start: \f$ b_1 = b_0 + \frac{h}{m} y' \f$,
/// \f$ b_2 = 2 b_1 - b_0 + \frac{h^2}{m(m-1)} y'' \f$, and so on.
/// \throws Error `wrong_number_of_points` when `m < k`, `empty_domain` unless `h > 0`, `not_finite` when `h` or a result is
///   not finite
template <class Traits>
std::vector<typename Traits::Point> start_control_points(const Curve_jet<Traits>& jet, int m,
                                                         const typename Traits::FT& h = typename Traits::FT(1)) {
  if (!(typename Traits::FT(0) < h)) throw Error(Error_code::empty_domain, "start_control_points");
  return internal::to_points<Traits>(internal::finite_points_from_jet(jet, m, h));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the last `k + 1` control points, in the order of the curve, of every Bézier curve of degree `m` on a domain of length
/// `h` that has the given jet of order `k` at its end.
/// \throws Error `wrong_number_of_points` when `m < k`, `empty_domain` unless `h > 0`, `not_finite` when `h` or a result is
///   not finite
template <class Traits>
std::vector<typename Traits::Point> end_control_points(const Curve_jet<Traits>& jet, int m,
                                                       const typename Traits::FT& h = typename Traits::FT(1)) {
  typedef typename Traits::FT FT;
  if (!(FT(0) < h)) throw Error(Error_code::empty_domain, "end_control_points");
  std::vector<typename Traits::Point> points =
      internal::to_points<Traits>(internal::finite_points_from_jet(jet, m, FT(-h)));
  std::reverse(points.begin(), points.end());
  return points;
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the Taylor polynomial of degree `m` of a curve at its end: the Bézier curve on the same domain that has the derivatives of
/// order 0 to `m` of the curve there. What reads the end of a polynomial polygon, as the families of alternatives do, can read that of any curve
/// by it. \f$ O(m^2) \f$, besides the jet
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `negative_count` unless `m >= 0`, `not_finite` when a result is not finite
template <class Curve> Bezier_curve<typename Curve::Traits> taylor_polynomial_at_end(const Curve& curve, int m) {
  typedef typename Curve::Traits Traits;
  typedef typename Traits::FT FT;
  const std::pair<FT, FT> domain = curve.domain();
  const Curve_jet<Traits> jet(end_jet<FT>(curve, m));
  const std::vector<typename Traits::Point> points = end_control_points(jet, m, FT(domain.second - domain.first));
  return {points.begin(), points.end(), domain.first, domain.second};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_END_CONTROL_POINTS_H
