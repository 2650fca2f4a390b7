// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_G1_RIBBON_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_G1_RIBBON_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// What is asked of a ribbon at one end of its curve \f$ C \f$, and how well it can be met. With \f$ x = C_1 - C \f$ and
/// \f$ D = \frac12 (C_1 - C_2) \f$, these are the demands (ii) \f$ T_1 = x \f$ and (iii) \f$ T_1' = x' \f$ of *Algebraic
/// G1 connection retaining fixed twist vectors*; the same residuals belong to \f$ C_2 - C \f$ and \f$ T_2 \f$.
/// \tparam FT the field in which it was decided
template <class FT> struct Ribbon_end {
  FT determinant;            ///< \f$ F = \det(C_1 - C,\, C_2 - C,\, C') \f$
  FT determinant_derivative; ///< \f$ F' \f$
  FT position_residual;      ///< the square of the length of \f$ x - T_1 \f$: zero if and only if (ii) holds
  FT twist_residual;         ///< the square of the length of \f$ x' - T_1' \f$: zero if and only if (iii) holds
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A pair of surfaces \f$ S_k(u, v) = C(u) + T_k(u)\,v \f$, `v` in [0, 1], on both sides of a curve, with
/// \f$ T_k = D\,\alpha_k + C'\,\beta_k \f$, and what was decided about them. See `connect_g1()`.
///
/// The numbers that are not control points are exact: they belong to the field in which predicates are decided, and to the
/// given curves without rounding.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 3
template <class Traits_> struct G1_ribbon {
  typedef Traits_ Traits;                         ///< of the curves and the surfaces
  typedef Edge_field<Traits> Field;               ///< the field of the numbers that are not control points
  typedef Bernstein_polynomial<Field> Polynomial; ///< of \f$ \alpha_k \f$ and \f$ \beta_k \f$
  typedef Bspline_surface<Traits> Surface;        ///< of each side

  Polynomial alpha;        ///< \f$ \alpha_1 \f$, with the domain mapped to [0, 1]
  Polynomial beta;         ///< \f$ \beta_1 \f$, with the domain mapped to [0, 1]
  Polynomial alpha2;       ///< \f$ \alpha_2 = \alpha_1 - 2 \f$
  Polynomial beta2;        ///< \f$ \beta_2 = \beta_1 \f$
  Ribbon_end<Field> start; ///< at the start of the domain
  Ribbon_end<Field> end;   ///< at its end
  Surface side1;           ///< \f$ S_1 \f$; its edge `v0` is \f$ C \f$
  Surface side2;           ///< \f$ S_2 \f$, with the same knots

  /// Returns whether both sides attain the given first derivatives \f$ C_1 - C \f$, \f$ C_2 - C \f$ at both ends.
  bool position_coplanar() const { return start.position_residual == Field(0) && end.position_residual == Field(0); }
  /// Returns whether both sides attain the given twists \f$ C_1' - C' \f$, \f$ C_2' - C' \f$ at both ends. Together with
  /// `position_coplanar()` this is \f$ F = F' = 0 \f$ at both ends.
  bool twist_coplanar() const { return start.twist_residual == Field(0) && end.twist_residual == Field(0); }

  /// Returns the signs of \f$ \alpha_1 \f$ on the closed domain. Where it is not positive, the first side turns over.
  Sign_pattern alpha_signs() const { return sign_pattern(alpha); }
  /// Returns the signs of \f$ 2 - \alpha_1 = -\alpha_2 \f$ on the closed domain. Where it is not positive, the second side turns over.
  Sign_pattern two_minus_alpha_signs() const { return sign_pattern(Polynomial{Field(2)} - alpha); }
  /// Returns whether \f$ 0 < \alpha_1 < 2 \f$ fails somewhere on the closed domain: there, both surfaces lie on one side of the edge.
  bool folds() const {
    return alpha_signs() != Sign_pattern::positive || two_minus_alpha_signs() != Sign_pattern::positive;
  }

  /// Decides the continuity of the surfaces along \f$ C \f$ as they are, one decision for each span of the knots, see
  /// `edge_continuity()`. Control points are taken as they are given; parameters are those of the domain. When they have
  /// been rounded, the surfaces are not exactly \f$ G^1 \f$, and each decision bounds the angle between the normals.
  std::vector<Edge_continuity<Field>> continuity() const;

  /// Returns whether `continuity()` is \f$ G^1 \f$ or more on all spans: a proof for the whole edge.
  bool g1() const { return edge_continuity(side1, Patch_edge::v0, side2, Patch_edge::v0).g_order >= 1; }

  /// Writes all but the surfaces, one item to a line.
  friend std::ostream& operator<<(std::ostream& os, const G1_ribbon& r) {
    const auto write_end = [&os](const char* name, const Ribbon_end<Field>& e) {
      os << name << ": F = " << e.determinant << ", F' = " << e.determinant_derivative
         << ", squared residuals: position " << e.position_residual << ", twist " << e.twist_residual << '\n';
    };
    os << "alpha: " << r.alpha << "\nbeta: " << r.beta << '\n';
    write_end("start", r.start);
    write_end("end", r.end);
    os << "first derivatives " << (r.position_coplanar() ? "" : "not ") << "attained, twists "
       << (r.twist_coplanar() ? "" : "not ") << "attained\n";
    return os << "alpha is " << r.alpha_signs() << ", 2 - alpha is " << r.two_minus_alpha_signs() << ": "
              << (r.folds() ? "fold" : "no fold");
  }
};

template <class Traits> auto G1_ribbon<Traits>::continuity() const -> std::vector<Edge_continuity<Field>> {
  std::vector<Edge_continuity<Field>> result;
  Spline_edge_continuity<Field> edge = edge_continuity(side1, Patch_edge::v0, side2, Patch_edge::v0);
  for (Edge_span<Field>& span : edge.spans) result.push_back(std::move(span.continuity));
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_G1_RIBBON_H
