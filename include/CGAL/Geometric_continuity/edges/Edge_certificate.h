// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CERTIFICATE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CERTIFICATE_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// A certificate that lets anybody check the order of two surfaces along a span of an edge by
/// multiplying polynomials. All points are homogeneous, of polynomial surfaces with the weight 1;
/// `P(u)` is the edge, `u` in [0, 1], and \f$ P_u, P_v, Q_v, P_{vv}, \dots \f$ are derivatives of
/// the first surface `P` and of the second one `Q`, where `v` grows into each surface. With the
/// planes \f$ \pi \f$ and \f$ \rho \f$, \f$ \pi \cdot x = \det(x, P, P_u, P_v) \f$ and
/// \f$ \rho \cdot x = \det(x, P, P_u, Q_v) \f$, and coordinates `i` of planes:
///
/// - \f$ G^1 \f$ holds if \f$ \pi \cdot Q_v \equiv 0 \f$, which is the determinant, and
///   \f$ \pi_1\rho_1 + \pi_2\rho_2 + \pi_3\rho_3 < 0 \f$ on the closed interval, where the first
///   three coordinates are normals;
/// - then \f$ Q_v = a P + \frac{m}{d} P_u + \frac{n}{d} P_v \f$ with the factors \f$ d = \pi_i \f$,
///   \f$ m = \det(e_i, P, Q_v, P_v) \f$ and \f$ n = \rho_i \f$, where `i` is the first coordinate
///   with \f$ \pi_i \not\equiv 0 \f$;
/// - \f$ G^2 \f$ holds if
///   \f$ d^2 (\pi \cdot Q_{vv}) - m^2 (\pi \cdot P_{uu}) - 2 m n (\pi \cdot P_{uv}) - n^2 (\pi \cdot P_{vv}) \equiv 0 \f$,
///   too.
/// \tparam FT an exact field
template <class FT> struct Edge_certificate {
  typedef Power_polynomial<FT> Polynomial; ///< in the parameter `u`

  FT begin;           ///< the parameter of the first edge
  FT end;             ///< where the span ends
  int g_order;        ///< as `Edge_continuity::g_order`
  Edge_rows<FT, 4> a; ///< \f$ P, P_v, P_{vv} \f$
  Edge_rows<FT, 4>
      /// \f$ Q, Q_v, Q_{vv} \f$, in the direction of the first edge, with the weight of `P` where
      /// the span begins
      b;
  std::optional<Polynomial> determinant; ///< empty where the edges are different curves
  /// the scalar product of the normals; empty where the edges are different curves
  std::optional<Polynomial> side;
  std::vector<Polynomial> factors; ///< `d`, `m`, `n` for an order of 1 or 2
  /// the difference of both sides of the identity of \f$ G^2 \f$, for an order of 1 or 2
  std::optional<Polynomial> second_order;
};

namespace internal {

template <class Field>
Edge_certificate<Field> edge_certificate_on(const std::pair<Edge_rows<Field, 4>, Edge_rows<Field, 4>>& rows,
                                            const Edge_span<Field>& verdict) {
  typedef Homogeneous_polynomial<Field> Polynomial;
  typedef std::array<Polynomial, 4> Vector;
  typedef Edge_tangent<4, Polynomial, Polynomial> Tangent;
  const auto polynomials = [](const typename Edge_rows<Field, 4>::Row& row) -> Vector {
    Vector v;
    for (int i = 0; i < 4; ++i) {
      std::vector<Field> b;
      for (const Coordinate_vector<Field, 4>& x : row) b.push_back(x[i]);
      v[static_cast<std::size_t>(i)] = Polynomial::from_bernstein(std::move(b));
    }
    return v;
  };
  const auto derivative = [](const Vector& v) -> Vector {
    return {v[0].derivative(), v[1].derivative(), v[2].derivative(), v[3].derivative()};
  };
  const auto powers = [](const Polynomial& p) { return Power_polynomial<Field>(p.template bernstein<Field>()); };
  Edge_certificate<Field> c{
      verdict.begin, verdict.end, verdict.continuity.g_order, rows.first, rows.second, {}, {}, {}, {}};
  if (c.g_order < 0) return c;

  const Vector p = polynomials(c.a.edge), pv = polynomials(c.a.cross), pvv = polynomials(c.a.second_cross),
               qv = polynomials(c.b.cross), qvv = polynomials(c.b.second_cross), pu = derivative(p);
  const Tangent tangent(p, pu);
  const Vector pi = tangent.normal(pv), rho = tangent.normal(qv);
  c.determinant = powers(sum_of_products<4>(pi, qv));
  c.side = powers(sum_of_products<3>(pi, rho));
  if (c.g_order < 1) return c;

  std::size_t i = 0;
  while (i < 3 && pi[i].is_zero()) ++i;
  const Polynomial &d = pi[i], &n = rho[i], m = Tangent(p, qv).normal(static_cast<int>(i), pv);
  c.factors = {powers(d), powers(m), powers(n)};
  const auto term = [&](const Polynomial& f, const Polynomial& g, const Vector& x) -> Polynomial {
    return counted_product(counted_product(f, g), sum_of_products<4>(pi, x));
  };
  const Polynomial mixed = term(m, n, derivative(pv));
  c.second_order = powers(term(d, d, qvv) - term(m, m, derivative(pu)) - mixed - mixed - term(n, n, pvv));
  return c;
}

// On each span of the verdict.
template <class Field>
std::vector<Edge_certificate<Field>>
edge_certificates_on(const std::vector<Edge_piece<Field, 4>>& a, const std::vector<Edge_piece<Field, 4>>& b,
                     Edge_direction direction, const Spline_edge_continuity<Field>& verdict) {
  const Edge_match<Field> match = whole_match(a, b, direction);
  std::vector<Edge_certificate<Field>> certificates;
  for (std::size_t i = 0; i < match.spans.size(); ++i)
    certificates.push_back(edge_certificate_on(rows_on(a, b, match.spans[i], match.map), verdict.spans[i]));
  return certificates;
}

// With homogeneous points.
template <class Field, int N> std::vector<Edge_piece<Field, 4>> homogeneous(std::vector<Edge_piece<Field, N>> pieces) {
  if constexpr (N == 4)
    return pieces;
  else
    return lifted(pieces);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what certifies the verdict on two edges that are the same curve as a whole, for each of
/// its spans; computed anew from the surfaces, so that it shows when the verdict is wrong. Each
/// span costs a number of operations that is quadratic in the degrees.
/// \param a, edge_a, b, edge_b the edges
/// \param verdict what `model_continuity()` or `edge_continuity()` has decided about them
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface>
std::vector<Edge_certificate<Edge_field<typename Surface::Traits>>>
edge_certificates(const Surface& a, Patch_edge edge_a, const Surface& b, Patch_edge edge_b,
                  const Spline_edge_continuity<Edge_field<typename Surface::Traits>>& verdict) {
  const internal::Work_guard work("edge_certificates");
  return internal::edge_certificates_on(internal::edge_pieces_in<4>(a, edge_a), internal::edge_pieces_in<4>(b, edge_b),
                                        verdict.reversed ? Edge_direction::opposite : Edge_direction::same, verdict);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what certifies the verdict on a knot line of a surface, for each of its spans; see
/// `edge_certificates()`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface>
std::vector<Edge_certificate<Edge_field<typename Surface::Traits>>>
knot_line_certificates(const Surface& surface, const Knot_line<Edge_field<typename Surface::Traits>>& line) {
  typedef Edge_field<typename Surface::Traits> Field;
  static_assert(std::is_same_v<Field, typename Surface::FT>,
                "certificates of knot lines are for surfaces over an exact field");
  const internal::Work_guard work("knot_line_certificates");
  const Parameter_line along = line.constant_u ? Parameter_line::along_v : Parameter_line::along_u;
  const auto pieces = [&](Line_side side) {
    return internal::homogeneous(
        internal::edge_pieces<Field>(internal::knot_line_rows(surface, along, line.knot, side)));
  };
  return internal::edge_certificates_on(pieces(Line_side::smaller_parameters), pieces(Line_side::larger_parameters),
                                        Edge_direction::same, line.continuity);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CERTIFICATE_H
