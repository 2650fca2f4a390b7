// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_EQUATIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_EQUATIONS_H

#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_input.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rounding_bound.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

/// \file Edge_equations.h
/// The conditions of continuity along an edge in forms of any kind: rounded numbers with a bound
/// (here), integers of fixed length (Edge_on_grid.h), polynomials over a ring (Edge_normals.h).
///
/// Along two edges that are the same curve C in one direction, let T1, T2 be the first and W1, W2
/// the second derivatives across it, and N = C' x T1, n2 = C' x T2, n3 = T2 x T1. The tangent
/// planes agree when N . T2 = 0; that both surfaces continue each other is the sign of N . n2. The
/// curvatures agree when, for each coordinate i,
///   N_i^2 (N . W2) = n3_i^2 (N . C'') + 2 n3_i n2_i (N . T1') + n2_i^2 (N . W1);
/// as n2 = q N and n3 = p N with rational functions p and q, one coordinate with N_i != 0 decides
/// for all. For homogeneous points the normals are planes.
///
/// The third derivatives X1 and X2 agree when, for a coordinate i with N_i != 0 and the derivatives
/// of second order p2 and q2 of the reparametrisation, V = N_i^2 (p2 C' + q2 T1) = N_i^2 W2 -
/// n3_i^2 C'' - 2 n3_i n2_i T1' - n2_i^2 W1, v2 = C' x V, v3 = V x T1,
///   N_i^4 (N . X2) = N_i (n3_i^3 (N . C''') + 3 n3_i^2 n2_i (N . T1'') + 3 n3_i n2_i^2 (N . W1') + n2_i^3 (N . X1))
///                  + 3 (n3_i v3_i (N . C'') + (n3_i v2_i + v3_i n2_i) (N . T1') + n2_i v2_i (N . W1)).
/// Homogeneous points have T2 = l C + p C' + q T1 with another factor l: then V has - 2 l_i (n3_i
/// C' + n2_i T1), and the right side 3 l_i N_i^3 (N . W2), where l_i = l N_i is a minor as n2_i and
/// n3_i are. Order 3 is decided by multi-precision only.
///
/// With control points, the degrees n along the edge and q1, q2 across it, the differences
///   d = C'/n, a = T1/q1, b = T2/q2, e = C''/(n (n-1)), f = T1'/(n q1), g = W1/(q1 (q1-1)), h = W2/(q2 (q2-1))
/// take the place of the derivatives: with N = d x a, n2 = d x b, n3 = b x a the identity is
///   n q1 (q2-1) N_i^2 (N.h) = q1 q2 (n-1) n3_i^2 (N.e) + 2 n q1 q2 n3_i n2_i (N.f) + n q2 (q1-1) n2_i^2 (N.g).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The words of the longest coefficient.
template <class NT> std::size_t most_words(const Homogeneous_polynomial<NT>& p) {
  std::size_t words = 1;
  for (int k = 0; k <= p.degree(); ++k) words = (std::max)(words, number_words(p[k]));
  return words;
}

// The product; the meter takes note of those of polynomials over a ring.
template <class NT>
Homogeneous_polynomial<NT> counted_product(const Homogeneous_polynomial<NT>& p, const Homogeneous_polynomial<NT>& q) {
  work_meter().charge_products((p.degree() + 1.) * (q.degree() + 1), most_words(p), most_words(q));
  return p * q;
}
template <class X, class Y> constexpr CGAL_GC_FORCEINLINE auto counted_product(const X& x, const Y& y) { return x * y; }
// 1, 2 or 3
template <class NT> Homogeneous_polynomial<NT> times(int w, const Homogeneous_polynomial<NT>& p) {
  return w == 1 ? p : w == 2 ? p + p : p + p + p;
}
template <class W, class X> constexpr CGAL_GC_FORCEINLINE auto times(const W& w, const X& x) { return w * x; }

// r + x y and r - x y, where no better is known.
template <class R, class X, class Y> constexpr CGAL_GC_FORCEINLINE void add_product(R& r, const X& x, const Y& y) {
  r = std::move(r) + counted_product(x, y);
}
template <class R, class X, class Y> constexpr CGAL_GC_FORCEINLINE void subtract_product(R& r, const X& x, const Y& y) {
  r = std::move(r) - counted_product(x, y);
}

// The first of a sum of so many products, of which the type may depend.
template <int terms, class X, class Y> constexpr CGAL_GC_FORCEINLINE auto first_of_products(const X& x, const Y& y) {
  return counted_product(x, y);
}

// The scalar product of the first coordinates, so many.
template <int terms, class V, class W> auto sum_of_products(const V& v, const W& w) {
  auto sum = first_of_products<terms>(v[0], w[0]);
  for (std::size_t i = 1; i < terms; ++i) add_product(sum, v[i], w[i]);
  return sum;
}

// v_i w_j - v_j w_i
template <class V, class W> auto minor_of(const V& v, const W& w, int i, int j) {
  auto difference = first_of_products<2>(v[i], w[j]);
  subtract_product(difference, v[j], w[i]);
  return difference;
}

// An edge C and the tangent D. The normals D x T of surfaces with the derivatives T across the
// edge,
template <int N, class C, class D> class Edge_tangent {
  static_assert(N == 3);
  const std::array<D, 3>& d_;

public:
  explicit Edge_tangent(const std::array<D, 3>& d) : d_(d) {}

  // The coordinate i.
  template <class T> auto normal(int i, const std::array<T, 3>& t) const {
    return minor_of(d_, t, (i + 1) % 3, (i + 2) % 3);
  }
  template <class T> auto normal(const std::array<T, 3>& t) const {
    return std::array<decltype(normal(0, t)), 3>{normal(0, t), normal(1, t), normal(2, t)};
  }
};

// and in homogeneous space the planes p = C ^ D ^ T as covectors: p . v = det(v, C, D, T). The line
// C ^ D has the coordinates C_i D_j - C_j D_i, i < j.
template <class C, class D> class Edge_tangent<4, C, D> {
  decltype(first_of_products<2>(std::declval<C>(), std::declval<D>())) m_[4][4];

public:
  Edge_tangent(const std::array<C, 4>& c, const std::array<D, 4>& d) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) m_[i][j] = minor_of(c, d, i, j);
  }

  template <class T> auto normal(int i, const std::array<T, 4>& t) const {
    const int x = i == 0, y = i <= 1 ? 2 : 1, z = i <= 2 ? 3 : 2; // the others, in order
    const bool even = i % 2 == 0;                                 // the sign of the minor of these
    auto p = even ? first_of_products<3>(m_[x][y], t[z]) : first_of_products<3>(m_[x][z], t[y]);
    if (even) {
      subtract_product(p, m_[x][z], t[y]);
      add_product(p, m_[y][z], t[x]);
    } else {
      subtract_product(p, m_[x][y], t[z]);
      subtract_product(p, m_[y][z], t[x]);
    }
    return p;
  }
  template <class T> auto normal(const std::array<T, 4>& t) const {
    return std::array<decltype(normal(0, t)), 4>{normal(0, t), normal(1, t), normal(2, t), normal(3, t)};
  }
};

// The factors of the terms of the identity of second order; those of the derivatives themselves are
// 1, 2 and 1.
template <class Factor> struct Edge_factors {
  Factor along, mixed, across[2]; // across is that of each side
};

// Returns the factors for differences of control points. They are at most 2 n q^2.
template <class Points> CGAL_GC_FORCEINLINE Edge_factors<int> edge_factors(const Points& s1, const Points& s2) {
  const int n = s1.along, q1 = s1.across, q2 = s2.across;
  return {q1 * q2 * (n - 1), 2 * n * q1 * q2, {n * q2 * (q1 - 1), n * q1 * (q2 - 1)}};
}

// The difference of both sides of the identity, from the coordinates N_i, n2_i and n3_i and the
// products of N with the second derivatives: mixed(), along(), across(side).
template <class Form, class Form_3, class Factor, class Products>
constexpr CGAL_GC_FORCEINLINE auto second_order_form(const Form& n1, const Form& n2, const Form_3& n3,
                                                     const Edge_factors<Factor>& w, const Products& normal_times) {
  const auto inner = times(w.mixed, counted_product(n2, normal_times.mixed())) +
                     times(w.along, counted_product(n3, normal_times.along()));
  const auto first = normal_times.across(0), second = normal_times.across(1);
  const auto square_1 = times(w.across[1], counted_product(n1, n1)),
             square_2 = times(w.across[0], counted_product(n2, n2));
  decltype(inner * n3 + square_2 * first - square_1 * second) form(counted_product(inner, n3));
  add_product(form, square_2, first);
  subtract_product(form, square_1, second);
  return form;
}

// The sum of rounded products, none of which is larger than the bound.
struct Rounded_form {
  double value, bound;

  friend CGAL_GC_FORCEINLINE Rounded_form operator*(const Rounded_form& x, const Rounded_form& y) {
    return {x.value * y.value, x.bound * y.bound};
  }
  friend CGAL_GC_FORCEINLINE Rounded_form operator+(const Rounded_form& x, const Rounded_form& y) {
    return {x.value + y.value, (std::max)(x.bound, y.bound)};
  }
  friend CGAL_GC_FORCEINLINE Rounded_form operator-(const Rounded_form& x, const Rounded_form& y) {
    return {x.value - y.value, (std::max)(x.bound, y.bound)};
  }
  friend CGAL_GC_FORCEINLINE Rounded_form operator*(int w, const Rounded_form& x) { return {w * x.value, w * x.bound}; }
  CGAL_GC_FORCEINLINE bool exceeds(double error) const { return std::abs(value) > error * bound; }
};

// A vector with a bound of its coordinates, or of the numbers of which these are the differences.
struct Rounded_vector {
  static constexpr double least = 0x1p-100, most = 0x1p100;

  std::array<double, 3> x;
  double bound;

  CGAL_GC_FORCEINLINE bool in_range() const { return least <= bound && bound <= most; }
  CGAL_GC_FORCEINLINE Rounded_form operator[](int i) const { return {x[static_cast<std::size_t>(i)], bound}; }

  friend CGAL_GC_FORCEINLINE Rounded_form dot(const Rounded_vector& v, const Rounded_vector& w) {
    return {dot_form(v.x, w.x), v.bound * w.bound};
  }
  friend CGAL_GC_FORCEINLINE Rounded_vector cross(const Rounded_vector& v, const Rounded_vector& w) {
    return {cross_form(v.x, w.x), v.bound * w.bound};
  }
};

// The errors of both conditions when the bounds of all differences and factors are 1; otherwise
// times the largest of the products of bounds, as for joins (Join_rounding). First differences are
// rounded once, and so are the two of which a second one is the difference.
struct Edge_rounding {
  double tangent_planes, curvatures;

  // unreachable: computed by the compiler
  constexpr Edge_rounding() : tangent_planes(0), curvatures(0) {
    const Rounding_bound one(1), first(1, 0x1p-52), half(0.5, 0x1p-53), second = half - half;
    const std::array<Rounding_bound, 3> v{first, first, first}, w{second, second, second}, n = cross_form(v, v);
    const Second_products products{dot_form(n, w)};
    const Edge_factors<Rounding_bound> factors{one, one, {one, one}};
    tangent_planes = with_margin(dot_form(n, v));
    curvatures = with_margin(second_order_form(n[0], n[0], n[0], factors, products));
  }

private:
  struct Second_products {
    Rounding_bound x;
    // unreachable: computed by the compiler
    constexpr Rounding_bound mixed() const { return x; }
    constexpr Rounding_bound along() const { return x; }
    constexpr Rounding_bound across(int) const { return x; }
  };
  // unreachable: computed by the compiler see below
  static constexpr double with_margin(const Rounding_bound& x) { return x.error * (1 + 0x1p-20); }
};

// Rounded numbers can refute the conditions at an end of the edge, where they need only few control
// points.
//
// All bounds lie between 2^-100 and 2^100, and factors are below 2^10, so that nothing overflows. A
// product that underflows has an error of 2^-1074, which is less than u 2^-300 times the product of
// the bounds of its factors, at least 2^-700; this is within the margin, as are the roundings of
// the bounds.
//
// The reversed edge has the differences d with the other sign, and so has f; all terms of the
// conditions are odd in d, or all even, so that its start may be taken in place of the end.
class Rounded_edge_end {
  const Edge_layers &s1_, &s2_;
  const bool at_end_;
  const Rounded_vector d_, a_, b_, normal_;
  mutable double largest_bound_ = 0; // of the second differences

public:
  // \pre the edges are the same, in one direction
  CGAL_GC_FORCEINLINE Rounded_edge_end(const Edge_layers& s1, const Edge_layers& s2, bool at_end)
      : s1_(s1), s2_(s2), at_end_(at_end), d_(first_difference(difference(s1, 0, 0, 1))),
        a_(first_difference(cross_difference(s1, 0))), b_(first_difference(cross_difference(s2, 0))),
        normal_(cross(d_, a_)) {}

  CGAL_GC_FORCEINLINE bool in_range() const { return d_.in_range() && a_.in_range() && b_.in_range(); }

  // \pre in_range()
  CGAL_GC_FORCEINLINE bool tangent_planes_differ() const {
    constexpr Edge_rounding error;
    return dot(normal_, b_).exceeds(error.tangent_planes);
  }

  // \pre in_range()
  CGAL_GC_FORCEINLINE bool curvatures_differ() const {
    const std::array<double, 3>& n = normal_.x;
    int i = std::abs(n[0]) < std::abs(n[1]) ? 1 : 0;
    if (std::abs(n[static_cast<std::size_t>(i)]) < std::abs(n[2])) i = 2;
    constexpr Edge_rounding error;
    return second_order_form(normal_[i], cross(d_, b_)[i], cross(b_, a_)[i], edge_factors(s1_, s2_), *this)
               .exceeds(error.curvatures) &&
           largest_bound_ <= Rounded_vector::most;
  }

  // See second_order_form().
  CGAL_GC_FORCEINLINE Rounded_form mixed() const { return normal_times(a_.x, cross_difference(s1_, 1)); }
  CGAL_GC_FORCEINLINE Rounded_form along() const {
    return s1_.along > 1 ? normal_times(d_.x, difference(s1_, 0, 1, 2)) : Rounded_form{0, 0};
  }
  CGAL_GC_FORCEINLINE Rounded_form across(int side) const {
    const Edge_layers& s = side == 0 ? s1_ : s2_;
    return s.across > 1 ? normal_times((side == 0 ? a_ : b_).x, minus(point(s, 2, 0), point(s, 1, 0)))
                        : Rounded_form{0, 0};
  }

private:
  typedef std::array<double, 3> Vector;

  CGAL_GC_FORCEINLINE const Vector& point(const Edge_layers& s, int j, int i) const {
    return s.p[j][at_end_ ? s.along - i : i];
  }
  // from the point number i of a layer to the point number k
  CGAL_GC_FORCEINLINE Vector difference(const Edge_layers& s, int j, int i, int k) const {
    return minus(point(s, j, k), point(s, j, i));
  }
  // from the edge to the first layer
  CGAL_GC_FORCEINLINE Vector cross_difference(const Edge_layers& s, int i) const {
    return minus(point(s, 1, i), point(s1_, 0, i));
  }
  static CGAL_GC_FORCEINLINE Rounded_vector first_difference(const Vector& x) { return {x, largest(x)}; }
  // with the second difference y - x
  CGAL_GC_FORCEINLINE Rounded_form normal_times(const Vector& x, const Vector& y) const {
    const Rounded_vector difference{minus(y, x), (std::max)(Rounded_vector::least, largest(x) + largest(y))};
    largest_bound_ = (std::max)(largest_bound_, difference.bound);
    return dot(normal_, difference);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_EQUATIONS_H
