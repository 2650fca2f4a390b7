// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_ROUNDED_POINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_ROUNDED_POINTS_H

#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <type_traits>
#include <utility>

/// \file rounded_points.h
/// The points at the ends of curves of floating-point numbers, for `Near_miss`.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The first points of the cubic on the domain of a curve that has its derivatives at an end, for
// curves of which no control points are known: b_1 = b_0 + (h/3) y', b_2 = 2 b_1 - b_0 + (h^2/6)
// y''.
template <class Traits, Curve_end which> class Cubic_end {
  typedef typename Traits::FT FT;
  Coordinate_jet<FT, dimension_v<Traits>> points_;

public:
  static constexpr bool has_weights = false;

  template <class Curve> explicit Cubic_end(const Curve& curve) : points_(jet_at<FT, which>(curve, 2)) {
    const std::pair<FT, FT> domain = curve.domain();
    const FT h = which == Curve_end::end ? domain.first - domain.second : domain.second - domain.first;
    points_[1] *= h / 3;
    points_[2] *= h * h / 6;
    points_[1] += points_[0];
    points_[2] += FT(2) * points_[1] - points_[0];
  }
  int degree() const { return 3; }
  int dimension() const { return points_.dimension(); }
  FT coordinate(int j, int i) const { return points_[j][i]; }
};

template <class Curve, class = void> struct Has_domain : std::false_type {};
template <class Curve>
struct Has_domain<Curve, std::void_t<decltype(std::declval<const Curve&>().domain().second)>> : std::true_type {};

// Calls f with the points next to an end.
template <Curve_end which, class Curve, class Function> void with_end_points(const Curve& curve, const Function& f) {
  if constexpr (Curve_ends<Curve>::have_polygons)
    if (has_weighted_polygon(curve, which)) return f(Curve_end_view<Curve, which>(curve));
  if constexpr (Has_domain<Curve>::value &&
                (Has_end_jets_over<typename Curve::Traits::FT, Curve>::value || Has_jets<Curve>::value))
    f(Cubic_end<typename Curve::Traits, which>(curve));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_ROUNDED_POINTS_H
