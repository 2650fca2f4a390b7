// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_NORMALS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_NORMALS_H

#include <CGAL/Geometric_continuity/algebra/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Edge_normals.h
/// The conditions of `Edge_conditions` in polynomials over a ring of multi-precision numbers.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The words of the longest coefficient.
template <class NT> std::size_t most_words(const Homogeneous_polynomial<NT>& p) {
  std::size_t words = 1;
  for (int k = 0; k <= p.degree(); ++k) words = (std::max)(words, number_words(p[k]));
  return words;
}
template <class NT> std::size_t most_words(const Homogeneous_vector<NT>& v) {
  return (std::max)({most_words(v[0]), most_words(v[1]), most_words(v[2])});
}

// Takes note of as many products of two polynomials.
template <class NT>
void charge_product(double number, const Homogeneous_polynomial<NT>& p, const Homogeneous_polynomial<NT>& q,
                    Work_meter& work) {
  work.charge_products(number * (p.degree() + 1.) * (q.degree() + 1), most_words(p), most_words(q));
}

// Products of polynomials as without a meter.
template <class NT>
Homogeneous_polynomial<NT> product(const Homogeneous_polynomial<NT>& p, const Homogeneous_polynomial<NT>& q,
                                   Work_meter& work) {
  charge_product(1, p, q, work);
  return p * q;
}
template <class NT>
Homogeneous_polynomial<NT> scalar_product(const Homogeneous_vector<NT>& v, const Homogeneous_vector<NT>& w,
                                          Work_meter& work) {
  for (int i = 0; i < 3; ++i) charge_product(1, v[i], w[i], work);
  return Geometric_continuity::scalar_product(v, w);
}
template <class NT>
Homogeneous_vector<NT> cross_product(const Homogeneous_vector<NT>& v, const Homogeneous_vector<NT>& w,
                                     Work_meter& work) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) charge_product(1, v[i], w[j], work);
  return Geometric_continuity::cross_product(v, w);
}

// The rows of both sides, in a ring: multiplied by their common denominator. Sides 0 and 1 are S1 and S2.
template <class Field> struct Edge_sides {
  typedef typename Common_denominator<Field>::Ring Ring;
  typedef Homogeneous_polynomial<Ring> Polynomial;
  typedef Homogeneous_vector<Ring> Vector;

  Common_denominator<Field> denominator;
  Vector c[2], t[2], w[2]; // C, T, W

  template <class FT> Edge_sides(const Edge_rows<FT>& a, const Edge_rows<FT>& b, Work_meter& work) {
    for (const Edge_rows<FT>* rows : {&a, &b})
      for (const auto* row : {&rows->edge, &rows->cross, &rows->second_cross}) {
        if (row->empty())
          throw Error(Error_code::wrong_number_of_points, "edge continuity: a row without coefficients");
        for (const Coordinate_vector<FT, 3>& x : *row)
          for (int i = 0; i < 3; ++i) {
            const Field number = to_field<Field>(x[i]);
            denominator.include(number);
            work.charge_products(2, denominator.words(), number_words(number)); // here, and for the numerator
          }
      }
    int side = 0;
    for (const Edge_rows<FT>* rows : {&a, &b}) {
      c[side] = polynomials(rows->edge);
      t[side] = polynomials(rows->cross);
      w[side] = polynomials(rows->second_cross);
      ++side;
    }
  }

  bool collapsed() const { return is_zero(derivative(c[0])); }
  bool same_edge() const { return c[0] == c[1]; }

  // Turns the second side so that both edges are the same curve in one direction, if they are in one of both. Returns
  // whether it has been turned, or nothing if the edges differ. The quick test for two edges that are polynomials; see also
  // same_edge() in edge_layers.h for control points of equal degree, Common_edge_part for pieces, Edge_key for many edges.
  std::optional<bool> align() {
    if (same_edge()) return false;
    for (Vector* v : {&c[1], &t[1], &w[1]}) *v = {(*v)[0].reversed(), (*v)[1].reversed(), (*v)[2].reversed()};
    return same_edge() ? std::optional<bool>(true) : std::nullopt;
  }

  // C', of the side with the lower degree along the edge
  Vector first_derivative() const { return derivative(c[c[1][0].degree() < c[0][0].degree()]); }
  // C''
  Vector second_derivative() const { return derivative(first_derivative()); }
  // T1'
  Vector mixed_derivative() const { return derivative(t[0]); }

  static Vector derivative(const Vector& v) { return {v[0].derivative(), v[1].derivative(), v[2].derivative()}; }
  static bool is_zero(const Vector& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

private:
  template <class Row> Vector polynomials(const Row& row) const {
    Vector v;
    for (int i = 0; i < 3; ++i) {
      std::vector<Ring> b;
      for (const auto& x : row) b.push_back(denominator.numerator(to_field<Field>(x[i])));
      v[i] = Polynomial::from_bernstein(std::move(b));
    }
    return v;
  }
};

// The normals n1 = C' x T1 and n2 = C' x T2 of both sides, and what they decide. `Sides` is Edge_sides or what has its
// derivatives. \pre both sides have the same edge, in one direction
template <class Field> struct Edge_normals {
  typedef Edge_sides<Field> Sides;
  typedef typename Sides::Polynomial Polynomial;
  typedef typename Sides::Vector Vector;
  typedef typename Common_denominator<Field>::Exact Exact;

  Vector n1, n2;
  Polynomial det;  // det(C', T1, T2) = n1 . T2
  Polynomial side; // n1 . n2

  template <class AnySides>
  Edge_normals(const AnySides& s, Work_meter& work) : Edge_normals(s.first_derivative(), s.t, work) {}

  // The order 1, from the signs of n1 . n2.
  bool coplanar() const { return det.is_zero(); }
  Sign_pattern side_signs(Work_meter& work) const { return internal::sign_pattern<Exact>(side, work); }
  bool first_order(Work_meter& work) const { return coplanar() && side_signs(work) == Sign_pattern::negative; }

  // Whether n1 or n2 vanishes somewhere on the closed interval. It needs the signs of n1 . n2.
  bool normal_vanishes(Sign_pattern side_signs, Work_meter& work) const {
    if (side_signs == Sign_pattern::positive || side_signs == Sign_pattern::negative) return false;
    if (coplanar()) return true; // the normals are parallel, so that n1 . n2 is zero only where one of them is
    return vanishes(n1, work) || vanishes(n2, work);
  }

  // N_i^2 (N . W2) = n3_i^2 (N . C'') + 2 n3_i n2_i (N . T1') + n2_i^2 (N . W1) with N = n1, n3 = T2 x T1. As n2 = q N and
  // n3 = p N with rational functions p and q, one coordinate with N_i != 0 decides for all. The same identity is decided in
  // Edge_on_grid by integers of fixed length and in Edge_filter by floating-point numbers. \pre coplanar()
  template <class AnySides> bool second_order(const AnySides& s, Work_meter& work) const {
    int i = 0;
    while (i < 3 && n1[i].is_zero()) ++i;
    if (i == 3) return true;
    charge_product(6, s.t[0][0], s.t[1][0], work);
    const Polynomial n3 = s.t[1][(i + 1) % 3] * s.t[0][(i + 2) % 3] - s.t[1][(i + 2) % 3] * s.t[0][(i + 1) % 3];
    const Polynomial mixed = internal::scalar_product(n1, s.mixed_derivative(), work);
    const Polynomial last = internal::scalar_product(n1, s.w[1], work);
    for (const Polynomial& x : {n1[i], n2[i], n3}) {
      charge_product(1, x, x, work);
      charge_product(2, x, last, work);
    }
    const Polynomial left = n1[i] * n1[i] * last;
    const Polynomial right = n3 * (n3 * scalar_product(n1, s.second_derivative()) + n2[i] * (mixed + mixed)) +
                             n2[i] * n2[i] * scalar_product(n1, s.w[0]);
    return left == right;
  }

  static Polynomial square(const Vector& v, Work_meter& work) { return internal::scalar_product(v, v, work); }
  // Whether the vector is zero somewhere on the closed interval.
  static bool vanishes(const Vector& v, Work_meter& work) {
    return internal::sign_pattern<Exact>(square(v, work), work) != Sign_pattern::positive;
  }

private:
  Edge_normals(const Vector& d, const Vector (&t)[2], Work_meter& work)
      : n1(internal::cross_product(d, t[0], work)), n2(internal::cross_product(d, t[1], work)),
        det(internal::scalar_product(n1, t[1], work)), side(internal::scalar_product(n1, n2, work)) {}
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_NORMALS_H
