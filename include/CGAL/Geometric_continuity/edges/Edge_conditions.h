// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONDITIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONDITIONS_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The polynomials that decide the continuity of two surfaces \f$ S_1, S_2 \f$ whose edges are the same
/// curve in the same direction. With the rows \f$ C, T_1, W_1 \f$ and \f$ C, T_2, W_2 \f$ and \f$ N = C' \times T_1 \f$:
///
/// - \f$ G^1 \f$: \f$ \det(C', T_1, T_2) \equiv 0 \f$ and \f$ (C' \times T_1) \cdot (C' \times T_2) < 0 \f$ on the whole closed
///   interval;
/// - \f$ G^2 \f$: in addition, with \f$ n_2 = C' \times T_2 \f$ and \f$ n_3 = T_2 \times T_1 \f$, for each coordinate `i`
///   \f$ N_i^2 (N \cdot W_2) \equiv n_{3,i}^2 (N \cdot C'') + 2 n_{3,i} n_{2,i} (N \cdot T_1') + n_{2,i}^2 (N \cdot W_1) \f$.
///
/// For \f$ T_2 = p\,C' + q\,T_1 \f$ this is the equality of the second fundamental forms: \f$ n_2 = qN \f$,
/// \f$ n_3 = pN \f$.
///
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
template <class FT> class Edge_conditions {
public:
  /// The field of the answers: `FT`, or `Exact_rational` for floating-point numbers.
  typedef typename Exact_field<FT>::type Field;

  /// Takes the rows of two surfaces with the same edge in the same direction, which is not checked. The degrees may differ.
  /// Costs a number of ring operations that is quadratic in the degree.
  /// \param a, b the rows
  /// \throws Error `wrong_number_of_points` for an empty row, `not_finite`, `work_limit`: here and in each question
  Edge_conditions(const Edge_rows<FT>& a, const Edge_rows<FT>& b)
      : Edge_conditions(a, b, internal::Work_on_object(place)) {}

  /// Returns \f$ \det(C', T_1, T_2) \f$. With rows of degrees `p` (the lower of the two edges), `l` and `m` it has the coefficients
  /// \f$ \binom{p+l+m-1}{k}^{-1} \sum_{i+j+h=k} \binom{p-1}{i} \binom{l}{j} \binom{m}{h} \det(p\,\Delta C_i, T_{1,j}, T_{2,h}) \f$.
  Bernstein_polynomial<Field> determinant() const { return bernstein(normals_.det, 3); }

  /// Returns \f$ (C' \times T_1) \cdot (C' \times T_2) \f$: negative where the surfaces lie on different sides of the edge.
  Bernstein_polynomial<Field> side() const { return bernstein(normals_.side, 4); }

  /// Returns whether the determinant vanishes identically: the tangent planes agree wherever there are any.
  bool coplanar() const { return normals_.coplanar(); }

  /// Returns the signs of `side()` on the closed interval.
  Sign_pattern side_pattern() const {
    const internal::Work_on_object work(place);
    return normals_.side_signs();
  }

  /// Returns whether a normal vanishes somewhere on the closed interval.
  bool normal_vanishes() const {
    const internal::Work_on_object work(place);
    return normals_.normal_vanishes(side_pattern());
  }

  /// Returns whether `coplanar()` holds and the identity of \f$ G^2 \f$, which alone does not see on which sides the surfaces lie.
  bool second_order() const {
    const internal::Work_on_object work(place);
    return coplanar() && normals_.second_order(sides_);
  }

  /// Returns whether the surfaces are \f$ G^1 \f$ along the whole closed edge.
  bool g1() const { return coplanar() && side_pattern() == Sign_pattern::negative; }
  /// Returns whether the surfaces are \f$ G^2 \f$ along the whole closed edge.
  bool g2() const { return g1() && second_order(); }

private:
  static constexpr const char* place = "Edge_conditions";
  internal::Edge_sides<Field> sides_;
  internal::Edge_normals<Field> normals_;

  Edge_conditions(const Edge_rows<FT>& a, const Edge_rows<FT>& b, internal::Work_on_object&&)
      : sides_(a, b), normals_(sides_) {}

  template <class Polynomial> Bernstein_polynomial<Field> bernstein(const Polynomial& p, int power) const {
    typedef typename internal::Common_denominator<Field>::Exact Exact;
    const Bernstein_polynomial<Exact> scaled = p.template bernstein<Exact>();
    std::vector<Field> b;
    for (const Exact& x : scaled.coefficients()) b.push_back(sides_.denominator.divided(x, power));
    return Bernstein_polynomial<Field>(std::move(b));
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONDITIONS_H
