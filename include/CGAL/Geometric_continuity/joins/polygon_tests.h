// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_POLYGON_TESTS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_POLYGON_TESTS_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

/// \file polygon_tests.h
/// Hagen's tests (3.1.1) to (3.1.3) on two Bézier polygons of one degree `m`, corrected and for every ratio
/// \f$ \beta \f$ of the first legs (Hagen: \f$ \beta = 1 \f$), without derivatives and without divisions. The left polygon ends
/// with the legs \f$ p = b_0 - b_{-1} \f$, \f$ r = b_{-2} - b_{-1} \f$, \f$ s = b_{-2} - b_{-3} \f$, the right one starts with
/// \f$ b_0, b_1, b_2, b_3 \f$. The parameter intervals do not matter.
///
/// They are the predicates of join_predicates.h for \f$ G^1 \f$, \f$ G^2 \f$ and \f$ F^3 \f$ under Hagen's names and conditions,
/// and exact with every kernel.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Traits, int Left, int Right>
void check_polygons(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "polygon tests");
  if (right.degree() != left.degree())
    throw Error(Error_code::wrong_number_of_points, "polygon tests: the polygons differ in degree");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the tangent is continuous: \f$ b_1 - b_0 = \beta p \f$ with \f$ \beta > 0 \f$. Hagen (3.1.1).
/// False where a leg at the join is zero and where the end points differ. \f$ O(n) \f$ in dimension `n`
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_tangent_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  return is_g1_join(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent and curvature vector are continuous: \f$ [p, b_2 - b_0] = \beta^2 [p, r] \f$. Hagen (3.1.2), corrected: the
/// vectors are equal, not their lengths only. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_curvature_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  return is_g2_join(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent, curvature vector and torsion are continuous: \f$ \langle [p, r], b_3 - b_0 \rangle = \beta^3 \langle [p, r], s \rangle \f$.
/// Hagen (3.1.3), corrected. Where \f$ [p, r] = 0 \f$ (zero curvature) both sides vanish always; there, and in more than three
/// dimensions, \f$ b_3 - b_0 - \beta^3 s \f$ must lie in the span of \f$ p, r \f$. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ or are less than 3, `wrong_number_of_points` when the
///   degrees differ
template <class Traits, int Left, int Right>
bool is_torsion_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  if (left.dimension() < 3) throw Error(Error_code::dimension_mismatch, "polygon test of torsion in the plane");
  return is_f3_join(left, right);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_POLYGON_TESTS_H
