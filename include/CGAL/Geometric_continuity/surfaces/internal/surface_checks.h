// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SURFACE_CHECKS_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SURFACE_CHECKS_H

#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/local/internal/check_count.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <string>
#include <type_traits>
#include <utility>

/// \file surface_checks.h
/// What surfaces refuse: each check throws a typed error that names the place.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The degrees to which surfaces are raised end here, so that a wrong number can fill neither memory nor time.
constexpr int most_raised_degree = 4096;

inline void check_elevation(int degree, int times, const char* place) {
  check_count(times, place);
  if (times > 0 && times > most_raised_degree - degree)
    throw Error(Error_code::work_limit, std::string(place) + ": a degree above " + std::to_string(most_raised_degree));
}

// The ends and the length of a domain must be finite, and the length positive.
template <class FT> void check_interval(const std::pair<FT, FT>& interval, const char* place) {
  check_finite(interval.first, place);
  check_finite(interval.second, place);
  if (!(interval.first < interval.second)) throw Error(Error_code::empty_domain, place);
  check_finite(FT(interval.second - interval.first), place);
}

// What overflows in floating-point arithmetic is refused.
template <class Traits> void check_jet(const Surface_jet<Traits>& jet, const char* place) {
  if constexpr (std::is_floating_point_v<typename Traits::FT>)
    for (int i = 0; i <= jet.order(); ++i)
      for (int j = 0; i + j <= jet.order(); ++j)
        for (const typename Traits::FT& x : jet(i, j)) check_finite(x, place);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_SURFACE_CHECKS_H
