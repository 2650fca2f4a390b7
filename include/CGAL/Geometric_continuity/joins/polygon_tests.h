// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_POLYGON_TESTS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_POLYGON_TESTS_H

#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <vector>

/// \file polygon_tests.h
/// Hagen's tests (3.1.1) to (3.1.3) on two Bézier polygons of one degree `m`, corrected and for every ratio
/// \f$ \beta \f$ of the first legs (Hagen: \f$ \beta = 1 \f$), without derivatives and without divisions. The left polygon ends
/// with the legs \f$ p = b_0 - b_{-1} \f$, \f$ r = b_{-2} - b_{-1} \f$, \f$ s = b_{-2} - b_{-3} \f$, the right one starts with
/// \f$ b_0, b_1, b_2, b_3 \f$. The parameter intervals do not matter.
///
/// The answers are those of `continuity()`: \f$ F^1 \f$, \f$ F^2 \f$ and \f$ F^3 \f$. They are exact with every exact kernel and
/// with `Exact_predicates_inexact_constructions_kernel`.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Traits, int Left, int Right> class Polygon_join {
  typedef Predicate_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Traits>> Vector;

  const Bezier_curve<Traits, Left>& left_;
  const Bezier_curve<Traits, Right>& right_;
  const int m_;
  Vector p_, q1_; // the legs at the join
  Field g_, a_;   // p.p and p.q1, so that beta = a/g

public:
  Polygon_join(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right)
      : left_(left), right_(right), m_(left.degree()) {
    if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "polygon tests");
    if (right.degree() != m_)
      throw Error(Error_code::wrong_number_of_points, "polygon tests: the polygons differ in degree");
  }

  // (3.1.1): q1 = beta p with beta > 0
  bool tangent() {
    if (b(0) != q(0) || m_ < 1) return false;
    p_ = b(0) - b(1);
    q1_ = q(1) - q(0);
    g_ = dot(p_, p_);
    a_ = dot(p_, q1_);
    return Field(0) < a_ && g_ * q1_ == a_ * p_;
  }

  // (3.1.2): [p, b2 - b0] = beta^2 [p, r], that is b2 - b0 - beta^2 r is parallel to p
  bool curvature() {
    if (!tangent()) return false;
    if (m_ < 2) return true; // both second derivatives are zero
    return dependent({p_, Field(g_ * g_) * (q(2) - q(0)) - Field(a_ * a_) * r()});
  }

  // (3.1.3): <[p, r], b3 - b0> = beta^3 <[p, r], s>, that is b3 - b0 - beta^3 s lies in the span of p and r
  bool torsion() {
    if (left_.dimension() < 3) throw Error(Error_code::dimension_mismatch, "polygon test of torsion in the plane");
    if (!curvature()) return false;
    if (m_ < 3) return true;
    const Vector v = Field(g_ * g_ * g_) * (q(3) - q(0)) - Field(a_ * a_ * a_) * (b(2) - b(3));
    return dependent({p_, r()}) ? dependent({p_, v}) : dependent({p_, r(), v});
  }

private:
  Vector b(int i) const { return coordinates<Traits, Field>(left_.control_point(m_ - i)); } // b_{-i}
  Vector q(int i) const { return coordinates<Traits, Field>(right_.control_point(i)); }     // b_i
  Vector r() const { return b(2) - b(1); }

  static bool dependent(const std::vector<Vector>& v) { return gram_determinant(v) == Field(0); }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Whether the tangent is continuous: \f$ b_1 - b_0 = \beta p \f$ with \f$ \beta > 0 \f$. Hagen (3.1.1).
/// False where a leg at the join is zero and where the end points differ. \f$ O(n) \f$ in dimension `n`
/// \throws Error `dimension_mismatch`, `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_tangent_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  return internal::Polygon_join<Traits, Left, Right>(left, right).tangent();
}

/// \ingroup PkgGeometricContinuityContinuity
/// Whether the curvature vector is continuous as well: \f$ [p, b_2 - b_0] = \beta^2 [p, r] \f$. Hagen (3.1.2), corrected: the
/// vectors are equal, not their lengths only. \f$ O(n) \f$
/// \throws Error `dimension_mismatch`, `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_curvature_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  return internal::Polygon_join<Traits, Left, Right>(left, right).curvature();
}

/// \ingroup PkgGeometricContinuityContinuity
/// Whether the torsion is continuous as well: \f$ \langle [p, r], b_3 - b_0 \rangle = \beta^3 \langle [p, r], s \rangle \f$.
/// Hagen (3.1.3), corrected. Where \f$ [p, r] = 0 \f$ (zero curvature) both sides vanish always; there, and in more than three
/// dimensions, \f$ b_3 - b_0 - \beta^3 s \f$ must lie in the span of \f$ p, r \f$. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ or are less than 3, `wrong_number_of_points` when the
///   degrees differ
template <class Traits, int Left, int Right>
bool is_torsion_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  return internal::Polygon_join<Traits, Left, Right>(left, right).torsion();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_POLYGON_TESTS_H
