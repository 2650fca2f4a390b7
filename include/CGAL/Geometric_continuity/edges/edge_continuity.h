// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_polynomials.h>
#include <CGAL/Geometric_continuity/edges/normal_deviation.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <optional>
#include <ostream>
#include <string>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// Why two surfaces are not smoother along an edge than they are.
enum class Edge_defect {
  none,             ///< they have the highest order that is decided, \f$ G^2 \f$
  gap,              ///< the edges are different curves
  collapsed,        ///< the edge is a single point
  vanishing_normal, ///< the tangent planes agree wherever there are any, but the normal of one side vanishes somewhere
  crease,           ///< the tangent planes differ somewhere
  fold,             ///< the tangent planes agree, but somewhere both surfaces lie on the same side of the edge
  curvature         ///< the tangent planes agree, the curvatures do not
};

/// \ingroup PkgGeometricContinuityContinuity
inline std::string to_string(Edge_defect defect) {
  switch (defect) {
  case Edge_defect::none: return "none";
  case Edge_defect::gap: return "gap";
  case Edge_defect::collapsed: return "collapsed";
  case Edge_defect::vanishing_normal: return "vanishing_normal";
  case Edge_defect::crease: return "crease";
  case Edge_defect::fold: return "fold";
  case Edge_defect::curvature: return "curvature";
  }
  return "unknown";
}

inline std::ostream& operator<<(std::ostream& os, Edge_defect defect) { return os << to_string(defect); }

/// \ingroup PkgGeometricContinuityContinuity
/// The polynomials that decide the continuity of two surfaces \f$ S_1, S_2 \f$ with the same edge, run through in the same
/// direction. With the rows \f$ C, T_1, W_1 \f$ and \f$ C, T_2, W_2 \f$ and \f$ N = C' \times T_1 \f$:
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

  /// Of two surfaces with the same edge in the same direction, which is not checked. The degrees may differ.
  /// A number of ring operations that is quadratic in the degree.
  /// \throws Error `wrong_number_of_points` for an empty row, `not_finite`
  Edge_conditions(const Edge_rows<FT>& a, const Edge_rows<FT>& b) : sides_(a, b), normals_(sides_) {}

  /// \f$ \det(C', T_1, T_2) \f$. With rows of degrees `p` (the lower of the two edges), `l` and `m` it has the coefficients
  /// \f$ \binom{p+l+m-1}{k}^{-1} \sum_{i+j+h=k} \binom{p-1}{i} \binom{l}{j} \binom{m}{h} \det(p\,\Delta C_i, T_{1,j}, T_{2,h}) \f$.
  Bernstein_polynomial<Field> determinant() const { return bernstein(normals_.det, 3); }

  /// \f$ (C' \times T_1) \cdot (C' \times T_2) \f$: negative where the surfaces lie on different sides of the edge.
  Bernstein_polynomial<Field> side() const { return bernstein(normals_.side, 4); }

  /// Whether the determinant vanishes identically: the tangent planes agree wherever there are any.
  bool coplanar() const { return normals_.coplanar(); }

  /// The signs of `side()` on the closed interval.
  Sign_pattern side_pattern() const { return normals_.side_signs(); }

  /// Whether a normal vanishes somewhere on the closed interval.
  bool normal_vanishes() const { return normals_.normal_vanishes(side_pattern()); }

  /// Whether `coplanar()` holds and the identity of \f$ G^2 \f$, which alone does not see on which sides the surfaces lie.
  bool second_order() const { return coplanar() && normals_.second_order(sides_); }

  bool g1() const { return coplanar() && side_pattern() == Sign_pattern::negative; }
  bool g2() const { return g1() && second_order(); }

private:
  internal::Edge_sides<Field> sides_;
  internal::Edge_normals<Field> normals_;

  template <class Polynomial> Bernstein_polynomial<Field> bernstein(const Polynomial& p, int power) const {
    typedef typename internal::Common_denominator<Field>::Exact Exact;
    const Bernstein_polynomial<Exact> scaled = p.template bernstein<Exact>();
    std::vector<Field> b;
    for (const Exact& x : scaled.coefficients()) b.push_back(sides_.denominator.divided(x, power));
    return Bernstein_polynomial<Field>(std::move(b));
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about two surfaces along an edge.
/// \tparam FT the field in which it was decided
template <class FT> struct Edge_continuity {
  /// -1 when the edges differ, 0 when they are the same curve, 1 when the tangent planes agree along the whole closed edge
  /// and the surfaces lie on different sides of it, 2 when the curvatures agree as well.
  int g_order = -1;
  Edge_defect defect = Edge_defect::gap; ///< why the order is not higher
  bool reversed = false;                 ///< the second edge runs backwards
  bool coplanar = false;                 ///< \f$ \det(C', T_1, T_2) \equiv 0 \f$
  /// The signs of \f$ (C' \times T_1) \cdot (C' \times T_2) \f$: `negative` where the surfaces continue each other.
  Sign_pattern side = Sign_pattern::zero;
  bool collapsed = false;       ///< the edge is a single point
  bool normal_vanishes = false; ///< a normal vanishes somewhere on the closed edge
  /// The sub-interval of the parameters of the first edge, at most 1/32 of it, in which a normal vanishes: a point when it
  /// was found exactly. Empty where no normal vanishes or the edge is collapsed.
  std::optional<std::pair<FT, FT>> vanishing;
  /// The enclosure of the largest angle between the normals and the place of a crease or fold, in the parameters of the
  /// first edge. Empty without a common edge, and where one normal vanishes identically.
  std::optional<Normal_deviation<FT>> deviation;

  /// Writes the order, the defect and the upper bound of the angle, e.g. `G1 (curvature)` or `G0 (crease), angle <= 0.3`.
  friend std::ostream& operator<<(std::ostream& os, const Edge_continuity& e) {
    if (e.g_order < 0) return os << "gap";
    os << 'G' << e.g_order;
    if (e.defect != Edge_defect::none) os << " (" << e.defect << ')';
    if (e.reversed) os << ", reversed";
    if (e.deviation && FT(0) < e.deviation->upper) os << ", angle <= " << e.deviation->largest_angle();
    return os;
  }
};

namespace internal {

template <class Field> class Edge_decision {
  typedef Edge_sides<Field> Sides;
  typedef Edge_normals<Field> Normals;
  typedef typename Normals::Polynomial Polynomial;

  Edge_continuity<Field> edge_;

public:
  Edge_continuity<Field> operator()(Sides sides) {
    if (!sides.same_edge()) {
      sides.reverse_second();
      if (!sides.same_edge()) return edge_;
      edge_.reversed = true;
    }
    edge_.g_order = 0;
    const Normals normals(sides);
    edge_.collapsed = sides.collapsed();
    edge_.coplanar = normals.coplanar();
    edge_.side = normals.side_signs();
    edge_.normal_vanishes = normals.normal_vanishes(edge_.side);
    if (edge_.collapsed)
      edge_.defect = Edge_defect::collapsed;
    else {
      edge_.defect = first_order_defect();
      if (edge_.defect == Edge_defect::curvature) {
        edge_.g_order = 1;
        if (normals.second_order(sides)) {
          edge_.g_order = 2;
          edge_.defect = Edge_defect::none;
        }
      }
      locate(normals);
    }
    return edge_;
  }

private:
  Edge_defect first_order_defect() const {
    if (!edge_.coplanar) return Edge_defect::crease;
    switch (edge_.side) {
    case Sign_pattern::negative: return Edge_defect::curvature; // until second order has been decided
    case Sign_pattern::nonpositive:
    case Sign_pattern::zero: return Edge_defect::vanishing_normal;
    default: return Edge_defect::fold;
    }
  }

  void locate(const Normals& n) {
    if (edge_.normal_vanishes) {
      if (Sides::is_zero(n.n1) || Sides::is_zero(n.n2)) {
        edge_.vanishing = std::pair<Field, Field>(Field(0), Field(1));
        return;
      }
      edge_.vanishing =
          zero_interval<Field>(edge_.coplanar ? n.side : Polynomial(Normals::square(n.n1) * Normals::square(n.n2)));
    }
    if (edge_.defect == Edge_defect::crease || edge_.defect == Edge_defect::fold)
      edge_.deviation = largest_angle<Field>(n.n1, n.n2, edge_.normal_vanishes);
    else
      edge_.deviation = Normal_deviation<Field>{Field(0), Field(0), Field(0), Field(1)};
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of two surfaces along their edges `v = 0`, exactly and on the whole closed edge, see
/// `Edge_conditions`. The edges are the same when their points and their parametrisations are, after exact elevation to one
/// degree; the second one may run backwards. (An affine reparametrisation that maps an edge as a whole to itself is the
/// identity or the reversal.) Where the normal of one side vanishes there is no tangent plane, hence no \f$ G^1 \f$; this
/// is reported as such. All parameters in the result are those of the first edge, in [0, 1].
///
/// When the surfaces are not \f$ G^1 \f$, the largest angle between their normals \f$ n_i = C' \times T_i \f$ is enclosed by
/// branch and bound on the Bernstein coefficients of \f$ \sin^2\theta = 1 - (n_1 \cdot n_2)^2 / (|n_1|^2 |n_2|^2) \f$, in
/// exact arithmetic.
///
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
/// \throws Error `wrong_number_of_points` for an empty row, `not_finite`
template <class FT>
Edge_continuity<typename Exact_field<FT>::type> edge_continuity(const Edge_rows<FT>& a, const Edge_rows<FT>& b) {
  typedef typename Exact_field<FT>::type Field;
  return internal::Edge_decision<Field>()(internal::Edge_sides<Field>(a, b));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H
