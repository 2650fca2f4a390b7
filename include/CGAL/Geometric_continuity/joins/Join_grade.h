// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_GRADE_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_GRADE_H

#include <CGAL/Geometric_continuity/joins/Kink_bound.h>
#include <CGAL/Geometric_continuity/joins/internal/Image_end.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <cmath>
#include <optional>
#include <ostream>
#include <string>

/// \file Join_grade.h
/// What a designer sees of a join in the plane: a corner that is meant, a kink that nobody wants, or a smooth join.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What a join of two plane curves looks like, from the roughest to the smoothest.
enum class Join_grade {
  gap,    ///< the second curve does not start where the first one ends
  corner, ///< the angle between the tangents is larger than a `Kink_bound`
  kink,   ///< the tangents differ, by no more than the bound
  g1,     ///< one tangent, while the curvature jumps, or is not defined where a handle is retracted
  g2      ///< \f$ G^2 \f$ or more: one tangent and one curvature
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns `gap`, `corner`, `kink`, `G1` or `G2`.
inline std::string to_string(Join_grade grade) {
  switch (grade) {
  case Join_grade::gap: return "gap";
  case Join_grade::corner: return "corner";
  case Join_grade::kink: return "kink";
  case Join_grade::g1: return "G1";
  case Join_grade::g2: return "G2";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes `to_string(grade)`.
inline std::ostream& operator<<(std::ostream& os, Join_grade grade) { return os << to_string(grade); }

namespace internal {

inline const Kink_bound& usual_kink_bound() {
  static const Kink_bound bound;
  return bound;
}

// Whether the angle between two ends is larger than the bound; empty when it is zero. \pre both have a length
template <class Left_end, class Right_end>
std::optional<bool> exceeds(const Left_end& a, const Right_end& b, const Kink_bound& bound) {
  typedef typename Left_end::Traits Traits;
  if constexpr (is_double<typename Traits::FT>) {
    // Differences, products and sums are rounded by 2^-52 in every rounding mode, once each.
    const Leg_products<double> r(a.template vector<double>(), b.template vector<double>());
    const double error = 0x1p-49 * r.size;
    if (0x1p-800 < r.size && r.size < 0x1p800) {
      if (error < std::abs(r.cross))
        if (const std::optional<bool> answer = bound.is_exceeded(r.cross, r.dot, 2 * error)) return answer;
      if (is_g1_join(a.curve(), b.curve())) return std::nullopt;
    }
  }
  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  const Leg_products<Field> p(a.template vector<Field>(), b.template vector<Field>());
  if (p.cross == Field(0) && Field(0) < p.dot) return std::nullopt;
  return bound.is_exceeded(p.cross, p.dot);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what the join between the end of `left` and the start of `right` looks like; empty when the ends meet and one of the curves has
/// no length, hence no direction. The bound is 5 degrees unless another one is given.
///
/// It is decided exactly on the control points as given, with every kernel, and about the curves as they are drawn:
/// - A curve whose control points lie on its chord, in order, is that line, also where handles are retracted.
/// - Of other curves with a retracted handle, a first leg that is zero, the first leg that is not zero is the direction in which the curve
///   leaves the node. Such a join is `g1` at most, because the curvature at the node is infinite or not told by the second differences.
///
/// Where no handle is retracted `g1` and `g2` are the answers of `is_g1_join()` and `is_g2_join()`. \f$ O(1) \f$ then, otherwise
/// \f$ O(m) \f$ for the degree `m`
/// \throws Error `not_finite` for an infinite or undefined coordinate that it reads
template <class Traits, int Left, int Right>
std::optional<Join_grade> join_grade(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right,
                                     const Kink_bound& bound = internal::usual_kink_bound()) {
  typedef internal::Image_end<Traits, Left, Curve_end::end> Left_end;
  typedef internal::Image_end<Traits, Right, Curve_end::start> Right_end;
  static_assert(dimension_v<Traits> == 2, "grades are those of curves in the plane");
  const Left_end a(left);
  const Right_end b(right);
  if (!is_c_join<0>(left, right)) {
    a.check_node();
    b.check_node();
    return Join_grade::gap;
  }
  if (!a.has_length() || !b.has_length()) return std::nullopt;
  if (const std::optional<bool> corner = internal::exceeds(a, b, bound))
    return *corner ? Join_grade::corner : Join_grade::kink;
  const bool left_line = a.is_retracted() && a.is_line(), right_line = b.is_retracted() && b.is_line();
  // A zero first leg is never that of a G2 join.
  const bool curvature_agrees = left_line && right_line ? true
                                : left_line             ? is_g2_join(a.curve(), right)
                                : right_line            ? is_g2_join(left, b.curve())
                                                        : is_g2_join(left, right);
  return curvature_agrees ? Join_grade::g2 : Join_grade::g1;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_GRADE_H
