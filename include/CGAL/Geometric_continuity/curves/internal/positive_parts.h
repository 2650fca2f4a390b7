// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POSITIVE_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POSITIVE_PARTS_H

#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Halves a rational curve until all weights are positive. This ends, because the Bernstein coefficients of the denominator tend
// to its values.
template <class Curve> void add_positive_parts(const Curve& curve, int halvings, std::vector<Curve>& parts) {
  if (all_positive(curve.weights())) return parts.push_back(curve);
  if (halvings == 0) throw Error(Error_code::work_limit, "positive_parts: the denominator is too close to zero");
  typedef typename Curve::FT FT;
  const auto halves = curve.split(FT(FT(curve.domain().first + curve.domain().second) / FT(2)));
  add_positive_parts(halves.first, halvings - 1, parts);
  add_positive_parts(halves.second, halvings - 1, parts);
}

// The image of a control point under an affine map of points; that of an infinite one, a direction, under its linear part.
template <class Traits, class Map>
typename Traits::Point image_of_control_point(const Map& map, const typename Traits::Point& p,
                                              const typename Traits::FT& weight) {
  if (weight != typename Traits::FT(0)) return map(p);
  const Coordinates<Traits> origin(Traits().compute_dimension_object()(p));
  return to_point<Traits>(
      Geometric_continuity::coordinates<Traits>(typename Traits::Point(map(p))) -
      Geometric_continuity::coordinates<Traits>(typename Traits::Point(map(to_point<Traits>(origin)))));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POSITIVE_PARTS_H
