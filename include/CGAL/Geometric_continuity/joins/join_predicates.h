// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H

#include <CGAL/Geometric_continuity/joins/Prepared_end.h>

#include <optional>

namespace CGAL {
namespace Geometric_continuity {

/// \file join_predicates.h
/// One question about a join, answered exactly on the control points as given, for every kernel. With `double` coordinates,
/// of whatever kernel, the answer costs little more than a test in floating-point arithmetic: a value that exceeds its
/// proven rounding error refutes the join, integers of fixed length on a grid decide nearly all others, and multi-precision
/// numbers the rest. Exact kernels are decided in the ring of the common denominators.
///
/// The left curve ends and the right curve starts at the join. `Left` and `Right` have one traits class. They are models of
/// `ParametricCurve`, or types for which `Curve_ends` is specialised; or both are `Prepared_end`. The control points next to
/// the ends are read where there are some (Bézier and segmented Bézier curves, B-spline curves whose knots allow it);
/// otherwise jets in an exact field decide. A type whose ends cannot be read does not compile. All predicates throw
/// Error `dimension_mismatch` when the dimensions differ. They agree with `Join_continuity` where that is decided exactly.

namespace internal {

template <Join_question question, class Left, class Right>
Join_answer join_answer(const Left& left, const Right& right) {
  const All_join_stages stages;
  return decide_join<question>(left, right, stages);
}
template <Join_question question, class Traits>
Join_answer join_answer(const Prepared_end<Traits>& left, const Prepared_end<Traits>& right) {
  const All_join_stages stages;
  return Prepared_end<Traits>::template decide<question>(left, right, stages);
}

template <Join_question question, class Left, class Right> bool join_is(const Left& left, const Right& right) {
  return join_answer<question>(left, right) == Join_answer::yes;
}
template <Join_question question, class Left, class Right>
std::optional<bool> optional_join_answer(const Left& left, const Right& right) {
  const Join_answer answer = join_answer<question>(left, right);
  if (answer == Join_answer::undefined) return std::nullopt;
  return answer == Join_answer::yes;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether all derivatives up to order `k` agree, `0 <= k <= 3`. This is the only predicate that reads the domains.
/// It is fast when their ends are multiples of \f$ 2^{-20} \f$ up to \f$ 2^{20} \f$ and their lengths are as two whole
/// numbers of at most 1024, and when the first derivatives differ clearly.
/// \throws Error `dimension_mismatch`
template <int k, class Left, class Right> bool is_c_join(const Left& left, const Right& right) {
  static_assert(0 <= k && k <= 3, "orders 0 to 3");
  return internal::join_is<static_cast<internal::Join_question>(k)>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the points agree and the tangents, which are not zero, have one direction. A form of degree 2.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g1_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g1>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents and curvature vectors agree. A form of degree 4 in the legs of the polygons: with
/// \f$ a_k, b_k \f$ the `k`-th differences of the polygons at the join and \f$ i \f$ a coordinate with
/// \f$ a_{1,i} \ne 0 \f$, \f$ a_{1,i}^2 b_2 - b_{1,i}^2 a_2 \f$ must be a multiple of \f$ a_1 \f$ (for equal degrees).
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g2_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g2>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents, curvature vectors and third derivatives with respect to arc length agree. A form of
/// degree 6.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g3_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g3>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, Frenet frames, curvatures and torsions agree (Hagen 2.1, corrected: the curvature \em vector counts). A
/// form of degree 6: the normals \f$ n = a_1 \times a_2 \f$ are parallel by G2, and
/// \f$ (n \cdot b_3) a_{1,i}^3 = (n \cdot a_3) b_{1,i}^3 \f$ (for equal degrees). False in the plane, where the order F ends
/// with 2.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_f3_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::f3>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the curvature vectors agree, wherever the points are; empty when a tangent is zero. A form of degree 4 if the
/// tangents are parallel, otherwise 7.
/// \throws Error `dimension_mismatch`
template <class Left, class Right>
std::optional<bool> has_equal_curvature_vector(const Left& left, const Right& right) {
  return internal::optional_join_answer<internal::Join_question::curvature_vector>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the torsions agree, wherever the points are; empty unless both curves lie in space and have nonzero curvature. A
/// form of degree 7.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> std::optional<bool> has_equal_torsion(const Left& left, const Right& right) {
  return internal::optional_join_answer<internal::Join_question::torsion>(left, right);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
