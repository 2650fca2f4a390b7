// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_join.h>

#include <optional>

/// \file join_predicates.h
/// One question about a join, answered exactly on the control points as given, for every kernel.
/// With `double` coordinates, of whatever kernel, the answer costs little more than a test in
/// floating-point arithmetic: a value that exceeds its proven rounding error refutes the join, a
/// residue of a form that is proved to be smaller than the modulus decides nearly all others, and
/// numbers of any length the rest. Exact kernels are decided in the ring of the common
/// denominators.
///
/// The left curve ends and the right curve starts at the join. `Left` and `Right` have one traits
/// class. They are models of `ParametricCurve`, or types for which `Curve_ends` is specialised. The
/// control points next to the ends are read where there are some (Bézier and segmented Bézier
/// curves, B-spline curves whose knots allow it); otherwise, and in more than three dimensions,
/// jets in an exact field decide. A type whose ends cannot be read does not compile. All predicates
/// throw Error `dimension_mismatch` when the dimensions differ. They agree with `Join_continuity`
/// where that is decided exactly.
///
/// A kernel that brings no exact numbers, as `Simple_cartesian<double>`, needs none for control
/// points in the plane and in space: they would double the time of compilation. Where such a kernel
/// meets jets, the compiler asks for numbers/Exact_field.h.
///
/// Hagen's tests (3.1.1) to (3.1.3) on two Bézier polygons of one degree `m`, corrected and for
/// every ratio \f$ \beta \f$ of the first sides (Hagen: \f$ \beta = 1 \f$), are the predicates for
/// \f$ G^1 \f$, \f$ G^2 \f$ and \f$ F^3 \f$ under his names and conditions. The left polygon ends
/// with the sides \f$ p = b_0 - b_{-1} \f$, \f$ r = b_{-2} - b_{-1} \f$,
/// \f$ s = b_{-2} - b_{-3} \f$, the right one starts with \f$ b_0, b_1, b_2, b_3 \f$. The parameter
/// intervals do not matter.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <Join_question question, class Left, class Right>
Join_answer join_answer(const Left& left, const Right& right) {
  const All_join_stages stages;
  return decide_join<question>(left, right, stages);
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
/// Returns whether all derivatives up to order `k` agree, `0 <= k <= 3`. This is the only predicate
/// that reads the domains. It is fast when their ends are multiples of \f$ 2^{-20} \f$ up to
/// \f$ 2^{20} \f$ and their lengths are as two whole numbers of at most 1024, and when the first
/// derivatives differ clearly.
/// \throws Error `dimension_mismatch`
template <int k, class Left, class Right> bool is_c_join(const Left& left, const Right& right) {
  static_assert(0 <= k && k <= 3, "orders 0 to 3");
  return internal::join_is<static_cast<internal::Join_question>(k)>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the points agree and the tangents, which are not zero, have one direction. A
/// form of degree 2.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g1_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g1>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents and curvature vectors agree. A form of degree 4 in the sides of
/// the polygons: with \f$ a_k, b_k \f$ the `k`-th differences of the polygons at the join and
/// \f$ i \f$ a coordinate with \f$ a_{1,i} \ne 0 \f$, \f$ a_{1,i}^2 b_2 - b_{1,i}^2 a_2 \f$ must be
/// a multiple of \f$ a_1 \f$ (for equal degrees).
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g2_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g2>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents, curvature vectors and third derivatives with respect to arc
/// length agree. A form of degree 6.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g3_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g3>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, Frenet frames, curvatures and torsions agree (Hagen 2.1, corrected: the
/// curvature \em vector counts). A form of degree 6: the normals \f$ n = a_1 \times a_2 \f$ are
/// parallel by G2, and \f$ (n \cdot b_3) a_{1,i}^3 = (n \cdot a_3) b_{1,i}^3 \f$ (for equal
/// degrees). False in the plane, where the order F ends with 2.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_f3_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::f3>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the curvature vectors agree, wherever the points are; empty when a tangent is
/// zero. A form of degree 4 if the tangents are parallel, otherwise 7.
/// \throws Error `dimension_mismatch`
template <class Left, class Right>
std::optional<bool> has_equal_curvature_vector(const Left& left, const Right& right) {
  return internal::optional_join_answer<internal::Join_question::curvature_vector>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the torsions agree, wherever the points are; empty unless both curves lie in
/// space and have nonzero curvature. A form of degree 7.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> std::optional<bool> has_equal_torsion(const Left& left, const Right& right) {
  return internal::optional_join_answer<internal::Join_question::torsion>(left, right);
}

namespace internal {

template <class Traits, int Left, int Right>
void check_polygons(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "polygon tests");
  if (right.degree() != left.degree())
    throw Error(Error_code::wrong_number_of_points, "polygon tests: the polygons differ in degree");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the tangent is continuous: \f$ b_1 - b_0 = \beta p \f$ with \f$ \beta > 0 \f$.
/// Hagen (3.1.1). False where a side at the join is zero and where the end points differ.
/// \f$ O(n) \f$ in dimension `n`
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the
///   degrees differ
template <class Traits, int Left, int Right>
bool is_tangent_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  return is_g1_join(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent and curvature vector are continuous:
/// \f$ [p, b_2 - b_0] = \beta^2 [p, r] \f$. Hagen (3.1.2), corrected: the vectors are equal, not
/// their lengths only. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the
///   degrees differ
template <class Traits, int Left, int Right>
bool is_curvature_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  return is_g2_join(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent, curvature vector and torsion are continuous:
/// \f$ \langle [p, r], b_3 - b_0 \rangle = \beta^3 \langle [p, r], s \rangle \f$. Hagen (3.1.3),
/// corrected. Where \f$ [p, r] = 0 \f$ (zero curvature) both sides vanish always; there, and in
/// more than three dimensions, \f$ b_3 - b_0 - \beta^3 s \f$ must lie in the span of \f$ p, r \f$.
/// \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ or are less than 3,
///   `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_torsion_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  if (left.dimension() < 3) throw Error(Error_code::dimension_mismatch, "polygon test of torsion in the plane");
  return is_f3_join(left, right);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
