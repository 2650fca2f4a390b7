// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_POINTS_FROM_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_POINTS_FROM_JET_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <string>
#include <vector>

/// \file points_from_jet.h
/// The first control points of a Bézier curve that has a given jet at its start.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The first k+1 Bezier points b_0, ..., b_k of the curve of degree m >= k with this jet at its
// start: the j-th difference of the points is h^j (m-j)!/m! x^(j). With h < 0, the last points from
// the end inwards.
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
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_POINTS_FROM_JET_H
