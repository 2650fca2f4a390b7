// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_SHORT_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_SHORT_JET_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_points.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_turns.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

/// \file Short_jet.h
/// The jet at a point of a fair spline, of numbers so short that the quintics between two jets have
/// both exactly.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The jet at a point: the tangent as long as the shorter chord h, or as its speed, and its square
// times the curvature, both of short numbers, from which all is constructed in the field.
template <class Traits> struct Short_jet {
  Coordinate_jet<typename Traits::FT, dimension_v<Traits>> jet;
  double speed;
  int digits; // binary ones that are left for handles
};

// Given tangents that are not rounded stay as they are.
template <class Traits>
Short_jet<Traits> short_jet(const Fair_points<Traits>& p, const std::vector<Fair_joint<dimension_v<Traits>>>& joints,
                            const std::vector<double>& lengths, int i) {
  typedef typename Traits::FT FT;
  constexpr bool rounds = std::is_floating_point_v<FT>;
  constexpr int most_digits = rounds ? (std::min)(20, std::numeric_limits<FT>::digits / 3) : 20,
                fewest_digits = 4; // so that no tangent is lost next to points that are far away
  const int n = p.exponent(), dimension = p.points[0].dimension();
  const double before = i > 0 ? lengths[i - 1] : lengths.back(), after = i < p.pieces() ? lengths[i] : before,
               h = (std::min)(p.closed || i > 0 ? before : after, after);
  // the binary digits below h that are left, and those of handles; the products of them and of
  // the jets need room
  const int room = rounds ? std::numeric_limits<FT>::digits - 4 + std::ilogb(h) + n - std::ilogb(p.size) : 80,
            digits = (std::min)(13, (room - 4) / 3);
  int unit = std::ilogb(h) - (digits >= 5 ? 20 : most_digits), unit_of_second = unit;
  if (digits >= 5) {
    unit = (std::max)(unit, std::ilogb(h) - room + digits);
    unit_of_second = (std::max)(unit, std::ilogb(h) - room + 2 * digits + 2);
  } else
    unit_of_second = unit = (std::max)(
        unit, (std::min)(std::ilogb(p.size) - n + 9 - std::numeric_limits<FT>::digits, std::ilogb(h) - fewest_digits));
  const bool is_kept = !rounds && joints[i].given;
  Short_jet<Traits> result{Coordinate_jet<FT, dimension_v<Traits>>(dimension, 2), h, digits};
  auto& jet = result.jet;
  jet[0] = p.points[i];
  double speed = h;
  if (is_kept) {
    jet[1] = *p.tangents[i];
    const Coordinate_vector<double, dimension_v<Traits>> t = rounded_column<Traits>(jet[1], dimension, p.given(i));
    speed = length(t);
    result.speed = std::ldexp(speed, -n);
  }
  const int unit_of_bend = is_kept ? unit + 2 * (std::ilogb(speed) - std::ilogb(h)) : unit_of_second;
  for (int k = 0; k < dimension; ++k) {
    if (!is_kept) jet[1][k] = short_number_in<FT>(std::ldexp(multiple_of_power(h * joints[i].tangent[k], unit), n));
    const double bend = multiple_of_power(speed * speed * joints[i].curvature[k], unit_of_bend),
                 second = std::ldexp(bend, is_kept ? -n : n);
    check_finite(second, "interpolate_fair: a second derivative");
    jet[2][k] = short_number_in<FT>(second);
  }
  return result;
}

// The end and the start of curves with a jet at their join: parabolas with these control points.
template <class Traits>
Bezier_curve<Traits> parabola(const Coordinate_jet<typename Traits::FT, dimension_v<Traits>>& jet, bool ends) {
  typedef typename Traits::FT FT;
  const FT half = FT(FT(1) / FT(2));
  const Coordinates<Traits> difference = half * jet[1], middle = ends ? jet[0] - difference : jet[0] + difference,
                            far = (ends ? middle - difference : middle + difference) + half * jet[2];
  const typename Traits::Point p[] = {to_point<Traits>(ends ? far : jet[0]), to_point<Traits>(middle),
                                      to_point<Traits>(ends ? jet[0] : far)};
  return Bezier_curve<Traits>(p, p + 3);
}

// Returns whether an end of a quintic has exactly the tangent and the curvature of a jet: b_1 - b_0
// is a positive multiple r of the tangent, and b_2 - b_0 - 5/4 r^2 of the second derivative is a
// multiple of it, too.
template <class Traits, class Jet> bool has_jet(const Bezier_curve<Traits, 5>& curve, const Jet& jet, bool at_end) {
  typedef typename Exact_field<typename Traits::FT>::type Exact;
  const int dimension = jet[0].dimension();
  const auto step = [&](int i, int k) {
    return Exact(Exact(curve.coordinates(at_end ? 5 - i : i)[k]) - Exact(jet[0][k]));
  };
  int large = 0;
  for (int k = 1; k < dimension; ++k)
    if (std::abs(jet[1][large]) < std::abs(jet[1][k])) large = k;
  const Exact tangent(jet[1][large]), r(step(1, large) / tangent);
  const auto rest = [&](int k) { return Exact(step(2, k) - r * r * Exact(jet[2][k]) * Exact(5) / Exact(4)); };
  if (!(at_end ? r < Exact(0) : Exact(0) < r)) return false;
  for (int k = 0; k < dimension; ++k)
    if (step(1, k) != r * Exact(jet[1][k]) || rest(k) * tangent != rest(large) * Exact(jet[1][k])) return false;
  return true;
}

// The blend of two jets by `Fair`, with joins that rounding does not move; nothing if there is
// none.
template <class Traits, class Jet>
std::optional<Bezier_curve<Traits, 5>> unmoved_blend(const Jet& start, const Jet& end) {
  try {
    const Representable_blend<Traits> blend =
        representable_blend(parabola<Traits>(start, true), parabola<Traits>(end, false), Fair());
    if (has_jet<Traits>(blend, start, false) && has_jet<Traits>(blend, end, true)) return blend;
  } catch (const Error& e) {
    if (e.code() != Error_code::not_representable) throw;
  }
  return std::nullopt;
}

// The quintic with these jets and handles; nothing where rounding would move its joins. Handles are
// told in the lengths of the tangents, with so many binary digits behind the point that all is
// exact.
template <class Traits, class Jet>
std::optional<Bezier_curve<Traits, 5>> quintic_with_handles(const Jet& start, const Jet& end, Fair_handles handles,
                                                            const std::array<double, 2>& speeds, int digits,
                                                            double size) {
  typedef typename Traits::FT FT;
  typedef Coordinates<Traits> Column;
  constexpr bool rounds = std::is_floating_point_v<FT>;
  if (rounds && digits < 5) return std::nullopt;
  const FT part = FT(FT(5) / FT(4));
  const auto short_handle = [&](double x) {
    return short_number_in<FT>(rounds ? multiple_of_power(x, -digits) : short_double<20>(x));
  };
  const auto inward = [&](int k) { // from the end: the next two points
    const Jet& jet = k == 0 ? start : end;
    const double least = rounds ? std::ldexp(1., -digits) : 0;
    const FT first = short_handle((std::max)(handles.first[k] / speeds[k], least)),
             second = short_handle(handles.second[k] / speeds[k]), sign = FT(k == 0 ? 1 : -1);
    return std::array<Column, 2>{FT(sign * first) * jet[1],
                                 FT(sign * second) * jet[1] + FT(part * FT(first * first)) * jet[2]};
  };
  const std::array<Column, 2> s = inward(0), e = inward(1);
  const std::array<Column, 6> b = {start[0], start[0] + s[0], start[0] + s[1], end[0] + e[1], end[0] + e[0], end[0]};
  std::vector<typename Traits::Point> points;
  for (const Column& x : b) {
    if constexpr (rounds)
      for (const FT& c : x)
        if (!(std::abs(c) < 8 * size)) return std::nullopt;
    points.push_back(to_point<Traits>(x));
  }
  return Bezier_curve<Traits, 5>(points.begin(), points.end());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_SHORT_JET_H
