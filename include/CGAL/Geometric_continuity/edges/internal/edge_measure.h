// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_MEASURE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_MEASURE_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_polynomials.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The squared sine s/p of the angle between two normals n1, n2 along an edge, and a polynomial with the sign of n1 . n2, but
// for zeros: p = |n1|^2 |n2|^2 and s = p - (n1 . n2)^2. Zeros that n1 or n2 have are split off, so that p is positive on the
// whole closed interval. \pre neither normal vanishes identically
template <class Field> struct Edge_measure {
  typedef Edge_normals<Field> Normals;
  typedef typename Normals::Polynomial Polynomial;
  typedef typename Normals::Vector Vector;

  Polynomial s, p, side;

  // `vanishing` tells whether a normal is zero somewhere on [0, 1]
  Edge_measure(Vector n1, Vector n2, bool vanishing) {
    Polynomial factor = one(); // of the normals
    if (vanishing) factor = without_square_factors(without_common_factor(n1) * without_common_factor(n2));
    side = scalar_product(n1, n2);
    p = Normals::square(n1) * Normals::square(n2);
    s = p - side * side;
    if (factor.degree() > 0) side = factor * side;
  }

private:
  typedef typename Polynomial::NT Ring;
  typedef typename Normals::Exact Exact;
  typedef Power_polynomial<Exact> Power;

  static Polynomial one() { return Polynomial(std::vector<Ring>(1, Ring(1))); }

  static Power power_form(const Polynomial& p) { return Power(p.template bernstein<Exact>()); }

  // Positive multiples of the polynomials, by one factor, in the ring.
  static std::vector<Polynomial> in_ring(const std::vector<Power>& powers) {
    Common_denominator<Field> denominator;
    std::vector<std::vector<Exact>> b;
    for (const Power& p : powers) {
      b.push_back(p.is_zero() ? std::vector<Exact>(1, Exact(0)) : p.bernstein().coefficients());
      for (const Exact& x : b.back()) denominator.include(Field(x));
    }
    std::vector<Polynomial> result;
    for (const std::vector<Exact>& row : b) {
      std::vector<Ring> c;
      for (const Exact& x : row) c.push_back(denominator.numerator(Field(x)));
      result.push_back(Polynomial::from_bernstein(std::move(c)));
    }
    return result;
  }

  // Divides by the greatest common divisor of the coordinates and returns it, both up to positive factors.
  static Polynomial without_common_factor(Vector& n) {
    std::vector<Power> v;
    for (const Polynomial& x : n) v.push_back(power_form(x));
    const Power factor = greatest_common_divisor(greatest_common_divisor(v[0], v[1]), v[2]);
    for (Power& x : v) {
      Power dividend = x;
      x = dividend.divide(factor);
    }
    const std::vector<Polynomial> quotients = in_ring(v);
    for (int i = 0; i < 3; ++i) n[i] = quotients[i];
    return in_ring({factor})[0];
  }

  // The product of the factors of odd multiplicity, with the same sign as p wherever p is not zero.
  static Polynomial without_square_factors(const Polynomial& p) { return in_ring({odd_factors(power_form(p))})[0]; }

  // With the factors a_i of multiplicity i, g = gcd(p, p') is the product of a_i^(i-1), and p/g that of all a_i, which are
  // the odd ones of p and those of g.
  static Power odd_factors(Power p) {
    if (p.degree() < 1) return p;
    const Power g = greatest_common_divisor(p, p.derivative());
    Power all = p.divide(g);
    return all.divide(odd_factors(g));
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_MEASURE_H
