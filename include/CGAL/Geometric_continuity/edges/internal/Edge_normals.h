// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_NORMALS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_NORMALS_H

#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_equations.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Edge_normals.h
/// The conditions of `Edge_conditions` in polynomials over a ring of multi-precision numbers.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The rows of both sides, in a ring: multiplied by their common denominator. Sides 0 and 1 are S1
// and S2. For N = 4 they are those of homogeneous points.
template <class Field, int N = 3> struct Edge_sides {
  typedef typename Common_denominator<Field>::Ring Ring;
  typedef Homogeneous_polynomial<Ring> Polynomial;
  typedef std::array<Polynomial, N> Vector;
  typedef Edge_tangent<N, Polynomial, Polynomial> Tangent;

  Common_denominator<Field> denominator;
  Vector c[2], t[2], w[2], x[2]; // C, T, W, X

  template <class FT> Edge_sides(const Edge_rows<FT, N>& a, const Edge_rows<FT, N>& b) {
    for (const Edge_rows<FT, N>* rows : {&a, &b})
      for (const auto* row : {&rows->edge, &rows->cross, &rows->second_cross, &rows->third_cross}) {
        if (row->empty() && row != &rows->third_cross)
          throw Error(Error_code::wrong_number_of_points, "edge continuity: a row without coefficients");
        for (const Coordinate_vector<FT, N>& y : *row)
          for (int i = 0; i < N; ++i) {
            const Field number = to_field<Field>(y[i]);
            denominator.include(number);
            // here, and for the numerator
            work_meter().charge_divisors(2, denominator.words(), number_words(number));
          }
      }
    int side = 0;
    for (const Edge_rows<FT, N>* rows : {&a, &b}) {
      c[side] = polynomials(rows->edge);
      t[side] = polynomials(rows->cross);
      w[side] = polynomials(rows->second_cross);
      if (!rows->third_cross.empty()) x[side] = polynomials(rows->third_cross);
      ++side;
    }
  }

  bool collapsed() const {
    if constexpr (N == 4) {
      const Vector& p = c[0];
      const Vector d = derivative(p);
      return p[0] * d[3] == d[0] * p[3] && p[1] * d[3] == d[1] * p[3] && p[2] * d[3] == d[2] * p[3];
    } else
      return is_zero(derivative(c[0]));
  }
  bool same_edge() const { return c[0] == c[1]; }

  // Turns the second side so that both edges are the same curve in one direction, if they are in
  // one of both. Returns whether it has been turned, or nothing if the edges differ. The quick test
  // for two edges that are polynomials; see also same_edge() in Edge_input.h for control points of
  // equal degree, Common_edge_part for pieces, Edge_key for many edges.
  std::optional<bool> align() {
    if (same_edge()) return false;
    for (Vector* v : {&c[1], &t[1], &w[1], &x[1]})
      for (Polynomial& p : *v) p = p.reversed();
    return same_edge() ? std::optional<bool>(true) : std::nullopt;
  }

  // C, of the side with the lower degree along the edge
  const Vector& edge() const { return c[c[1][0].degree() < c[0][0].degree()]; }
  // Returns the tangent plane of the edge, with C' or another vector in its place.
  Tangent tangent(const Vector& d) const { return tangent(edge(), d); }
  static Tangent tangent(const Vector& edge, const Vector& d) {
    if constexpr (N == 4)
      return Tangent(edge, d);
    else
      return Tangent(d);
  }
  // C'
  Vector first_derivative() const { return derivative(edge()); }
  // C''
  Vector second_derivative() const { return derivative(first_derivative()); }
  // T1'
  Vector mixed_derivative() const { return derivative(t[0]); }

  static Vector derivative(const Vector& v) {
    Vector d;
    for (int i = 0; i < N; ++i) d[i] = v[i].derivative();
    return d;
  }
  static bool is_zero(const Vector& v) {
    return std::all_of(v.begin(), v.end(), [](const Polynomial& p) { return p.is_zero(); });
  }

private:
  template <class Row> Vector polynomials(const Row& row) const {
    Vector v;
    for (int i = 0; i < N; ++i) {
      std::vector<Ring> b;
      for (const auto& y : row) b.push_back(denominator.numerator(to_field<Field>(y[i])));
      v[i] = Polynomial::from_bernstein(std::move(b));
    }
    return v;
  }
};

// The normal of a plane, or the normal itself.
template <class NT> const Homogeneous_vector<NT>& normal_part(const Homogeneous_vector<NT>& n) { return n; }
template <class NT> Homogeneous_vector<NT> normal_part(const std::array<Homogeneous_polynomial<NT>, 4>& plane) {
  return {plane[0], plane[1], plane[2]};
}

// The normals n1 = C' x T1 and n2 = C' x T2 of both sides, and what they decide. `Sides` is
// Edge_sides or what has its derivatives. For homogeneous points, N = 4, these are the tangent
// planes C ^ C' ^ T1 and C ^ C' ^ T2, whose first three coordinates are the normals times powers of
// the denominator; all identities have the same form, as det(x, C, C', T1) = n1 . x.
// \pre both sides have the same edge, in one direction
template <class Field, int N = 3> struct Edge_normals {
  typedef Edge_sides<Field, N> Sides;
  typedef typename Sides::Ring Ring;
  typedef typename Sides::Polynomial Polynomial;
  typedef typename Sides::Vector Vector;
  typedef typename Common_denominator<Field>::Exact Exact;

  Vector n1, n2;
  Polynomial det;  // det(C', T1, T2) = n1 . T2
  Polynomial side; // n1 . n2, of the normals

  template <class AnySides> Edge_normals(const AnySides& s) : Edge_normals(s, s.first_derivative()) {}

  // The order 1, from the signs of n1 . n2.
  bool coplanar() const { return det.is_zero(); }
  Sign_pattern side_signs() const { return sign_pattern<Exact>(side); }
  bool first_order() const { return coplanar() && side_signs() == Sign_pattern::negative; }

  // Returns whether n1 or n2 vanishes somewhere on the closed interval. It needs the signs of n1 .
  // n2.
  bool normal_vanishes(Sign_pattern side_signs) const {
    if (side_signs == Sign_pattern::positive || side_signs == Sign_pattern::negative) return false;
    // the normals are parallel, so that n1 . n2 is zero only where one of them is
    if (coplanar()) return true;
    return vanishes(n1) || vanishes(n2);
  }

  // Returns whether the curvatures agree, see Edge_equations.h. \pre coplanar()
  template <class AnySides> bool second_order(const AnySides& s) const {
    const int i = nonzero_coordinate();
    if (i == 3) return true;
    const Polynomial n3 = s.tangent(s.t[1]).normal(i, s.t[0]);
    return second_order_form(n1[i], n2[i], n3, Edge_factors<int>{1, 2, {1, 1}}, Products<AnySides>{n1, s}).is_zero();
  }

  // Returns whether the third derivatives agree, see Edge_equations.h. \pre first_order() and
  // second_order()
  bool third_order(const Sides& s) const {
    const int i = nonzero_coordinate();
    const Vector c1 = s.first_derivative(), c2 = s.second_derivative(), t1 = s.mixed_derivative();
    const typename Sides::Tangent tangent = s.tangent(c1);
    const Polynomial &n = n1[i], &q = n2[i], p = s.tangent(s.t[1]).normal(i, s.t[0]);
    const auto product = [](const Polynomial& x, const Polynomial& y) { return counted_product(x, y); };
    Polynomial l; // zero without weights
    if constexpr (N == 4) l = Sides::tangent(s.t[1], c1).normal(i, s.t[0]);
    const Polynomial nn = product(n, n), pp = product(p, p), pq = product(p, q), qq = product(q, q);
    Vector rest; // N_i^2 (lambda_2 C + p_2 C' + q_2 T1)
    for (int k = 0; k < N; ++k) {
      rest[k] = product(nn, s.w[1][k]) - product(pp, c2[k]) - times(2, product(pq, t1[k])) - product(qq, s.w[0][k]);
      if constexpr (N == 4) rest[k] = rest[k] - times(2, product(l, product(p, c1[k]) + product(q, s.t[0][k])));
    }
    const Polynomial q2 = tangent.normal(i, rest), p2 = s.tangent(rest).normal(i, s.t[0]);
    const auto normal_times = [&](const Vector& v) { return sum_of_products<N>(n1, v); };
    const Polynomial first = product(product(pp, p), normal_times(Sides::derivative(c2))) +
                             times(3, product(product(pp, q), normal_times(Sides::derivative(t1)))) +
                             times(3, product(product(p, qq), normal_times(Sides::derivative(s.w[0])))) +
                             product(product(qq, q), normal_times(s.x[0]));
    const Polynomial second = product(product(p, p2), normal_times(c2)) +
                              product(product(p, q2) + product(p2, q), normal_times(t1)) +
                              product(product(q, q2), normal_times(s.w[0]));
    Polynomial form = product(product(nn, nn), normal_times(s.x[1])) - product(n, first) - times(3, second);
    if constexpr (N == 4) form = form - times(3, product(product(product(nn, n), l), normal_times(s.w[1])));
    return form.is_zero();
  }

  static Polynomial square(const Vector& v) { return sum_of_products<3>(v, v); }
  // Returns whether the vector is zero somewhere on the closed interval.
  static bool vanishes(const Vector& v) { return sign_pattern<Exact>(square(v)) != Sign_pattern::positive; }

private:
  // Returns a nonzero coordinate of the normal n1, or 3 if there is none.
  int nonzero_coordinate() const {
    return static_cast<int>(std::find_if(n1.begin(), n1.begin() + 3, [](const Polynomial& p) { return !p.is_zero(); }) -
                            n1.begin());
  }

  // See second_order_form().
  template <class AnySides> struct Products {
    const Vector& n1;
    const AnySides& s;

    Polynomial mixed() const { return sum_of_products<N>(n1, s.mixed_derivative()); }
    Polynomial along() const { return sum_of_products<N>(n1, s.second_derivative()); }
    Polynomial across(int of_side) const { return sum_of_products<N>(n1, s.w[of_side]); }
  };

  template <class AnySides> Edge_normals(const AnySides& s, const Vector& d) {
    const typename Sides::Tangent tangent = s.tangent(d);
    n1 = tangent.normal(s.t[0]);
    n2 = tangent.normal(s.t[1]);
    det = sum_of_products<N>(n1, s.t[1]);
    side = sum_of_products<3>(n1, n2);
  }
};

// The normal of one side along its own edge, times a power of the denominator for homogeneous
// points.
template <class Field, int N>
Homogeneous_vector<typename Edge_sides<Field, N>::Ring> normal_along_edge(const Edge_sides<Field, N>& s, int side) {
  typedef Edge_sides<Field, N> Sides;
  const typename Sides::Vector d = Sides::derivative(s.c[side]);
  return normal_part<typename Sides::Ring>(Sides::tangent(s.c[side], d).normal(s.t[side]));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_NORMALS_H
