// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SWEEP_INPUT_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SWEEP_INPUT_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <string>

/// \file sweep_input.h
/// Checks of what surfaces of extrusion and of revolution are made from.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The coordinates of a point or a vector in space.
template <class Traits, class Field, class Point_or_vector>
Coordinate_vector<Field, dimension_v<Traits>> space_coordinates(const Point_or_vector& p, const char* place) {
  static_assert(dimension_v<Traits> == 0 || dimension_v<Traits> == 3, "swept surfaces exist in dimension 3");
  const Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(p);
  if (x.dimension() != 3) throw Error(Error_code::dimension_mismatch, std::string(place) + " must be in dimension 3");
  for (const auto& xi : x) check_finite(xi, place);
  return Geometric_continuity::coordinates<Traits, Field>(p);
}

// The coordinates of a vector in space that is not zero.
template <class Traits, class Field>
Coordinate_vector<Field, dimension_v<Traits>> direction_coordinates(const typename Traits::Vector& w,
                                                                    const char* place) {
  const Coordinate_vector<Field, dimension_v<Traits>> x = space_coordinates<Traits, Field>(w, place);
  if (is_zero(x)) throw Error(Error_code::zero_direction, place);
  return x;
}

// A jet of a curve that must be in space and have all `k` derivatives.
template <class Jet> const Jet& require_space_jet(const Jet& jet, int k, const char* place) {
  if (jet.dimension() != 3) throw Error(Error_code::dimension_mismatch, std::string(place) + " must be in dimension 3");
  if (jet.order() < k) throw Error(Error_code::jet_order_too_low, place);
  return jet;
}

// The jet of order k of a profile.
template <class Curve>
Curve_jet<typename Curve::Traits> profile_jet(const Curve& c, const typename Curve::Traits::FT& u, int k) {
  return require_space_jet(c.jet(u, k), k, "swept surface: the profile");
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SWEEP_INPUT_H
