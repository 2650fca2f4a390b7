// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_CERTIFICATES_ON_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_CERTIFICATES_ON_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \file edge_certificates_on.h
/// The certificates of the verdict on two edges, computed anew from their rows.

namespace CGAL {
namespace Geometric_continuity {
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

// Returns the certificate of each span of the verdict.
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

// Returns the pieces with homogeneous points.
template <class Field, int N> std::vector<Edge_piece<Field, 4>> homogeneous(std::vector<Edge_piece<Field, N>> pieces) {
  if constexpr (N == 4)
    return pieces;
  else
    return lifted(pieces);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_CERTIFICATES_ON_H
