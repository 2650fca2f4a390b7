// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_PATCH_SUMS_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_PATCH_SUMS_H

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <vector>

/// \file patch_sums.h
/// The summands of a point of a patch: the control points, or the homogeneous points of a rational
/// patch.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// B_j^m = s B_j^(m-1) + t B_(j-1)^(m-1): replaces the values of degree m - 1, in b[1], ..., b[m],
// by those of degree m, in b[1], ..., b[m+1]. In front, and in b[m+1] before, is a zero. The values
// are those at t if s + t = 1, otherwise those at t / (s + t) multiplied by (s + t)^m.
template <class FT> void raise_bernstein_values(std::vector<FT>& b, int m, const FT& s, const FT& t) {
  for (int j = m + 1; j > 0; --j) b[j] = FT(s * b[j] + t * b[j - 1]);
}

template <class Traits> Coordinates<Traits> summand(const Bezier_patch<Traits>& s, int i, int j) {
  return s.coordinates(i, j);
}
template <class Traits> auto summand(const Rational_bezier_patch<Traits>& s, int i, int j) {
  return homogeneous_point(s.coordinates(i, j), s.weight(i, j));
}

// Takes the point number k along an edge.
template <class Patch> auto summand(const Patch& s, Patch_edge edge, int k) {
  const int across = at_upper_end(edge) ? s.degree_across(edge) : 0;
  return runs_along_u(edge) ? summand(s, k, across) : summand(s, across, k);
}

template <class Traits>
typename Traits::Point point_of_sum(const Bezier_patch<Traits>&, const Coordinates<Traits>& sum) {
  return to_point<Traits>(sum);
}
template <class Traits, class Sum>
typename Traits::Point point_of_sum(const Rational_bezier_patch<Traits>&, const Sum& sum) {
  return to_point<Traits>(affine_point(sum));
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_PATCH_SUMS_H
