// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_EQUATIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_EQUATIONS_H

#include <CGAL/Geometric_continuity/edges/internal/Edge_input.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

/// \file Edge_equations.h
/// The conditions of continuity along an edge in forms of any kind: rounded numbers with a bound (here), integers of fixed length
/// (Edge_on_grid.h), polynomials over a ring (Edge_normals.h).
///
/// Along two edges that are the same curve C in one direction, let T1, T2 be the first and W1, W2 the second derivatives across it, and
/// N = C' x T1, n2 = C' x T2, n3 = T2 x T1. The tangent planes agree when N . T2 = 0; that both surfaces continue each other is the sign
/// of N . n2. The curvatures agree when, for each coordinate i,
///   N_i^2 (N . W2) = n3_i^2 (N . C'') + 2 n3_i n2_i (N . T1') + n2_i^2 (N . W1);
/// as n2 = q N and n3 = p N with rational functions p and q, one coordinate with N_i != 0 decides for all. For homogeneous points the
/// normals are planes.
///
/// Of control points, with the degrees n along the edge and q1, q2 across it, the differences
///   d = C'/n, a = T1/q1, b = T2/q2, e = C''/(n (n-1)), f = T1'/(n q1), g = W1/(q1 (q1-1)), h = W2/(q2 (q2-1))
/// take the place of the derivatives: with N = d x a, n2 = d x b, n3 = b x a the identity is
///   n q1 (q2-1) N_i^2 (N.h) = q1 q2 (n-1) n3_i^2 (N.e) + 2 n q1 q2 n3_i n2_i (N.f) + n q2 (q1-1) n2_i^2 (N.g).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// r + x y and r - x y, where no better is known.
template <class R, class X, class Y> CGAL_GC_FORCEINLINE void add_product(R& r, const X& x, const Y& y) {
  r = std::move(r) + x * y;
}
template <class R, class X, class Y> CGAL_GC_FORCEINLINE void subtract_product(R& r, const X& x, const Y& y) {
  r = std::move(r) - x * y;
}

// The difference of both sides of the identity, from the coordinates N_i, n2_i and n3_i and the products of N with the second
// derivatives, each with its factor: mixed(), along() if is_curved_along(), across(side) if is_curved_across(side).
template <class Form, class Products>
CGAL_GC_FORCEINLINE auto second_order_form(const Form& n1, const Form& n2, const Form& n3,
                                           const Products& normal_times) {
  auto inner = n2 * normal_times.mixed();
  if (normal_times.is_curved_along()) add_product(inner, n3, normal_times.along());
  auto form = inner * n3;
  if (normal_times.is_curved_across(0)) add_product(form, n2 * n2, normal_times.across(0));
  if (normal_times.is_curved_across(1)) subtract_product(form, n1 * n1, normal_times.across(1));
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
  CGAL_GC_FORCEINLINE Rounded_form times(int w) const { return {w * value, w * bound}; } // w > 0
  CGAL_GC_FORCEINLINE bool exceeds(double part) const { return std::abs(value) > part * bound; }
};

// A vector with a bound of its coordinates, or of the numbers of which these are the differences.
struct Rounded_vector {
  static constexpr double least = 0x1p-100, most = 0x1p100;

  std::array<double, 3> x;
  double bound;

  CGAL_GC_FORCEINLINE bool in_range() const { return least <= bound && bound <= most; }
  CGAL_GC_FORCEINLINE Rounded_form operator[](int i) const { return {x[static_cast<std::size_t>(i)], bound}; }

  friend CGAL_GC_FORCEINLINE Rounded_form dot(const Rounded_vector& x, const Rounded_vector& y) {
    return {dot_form(x.x, y.x), x.bound * y.bound};
  }
  friend CGAL_GC_FORCEINLINE Rounded_vector cross(const Rounded_vector& x, const Rounded_vector& y) {
    return {cross_form(x.x, y.x), x.bound * y.bound};
  }
};

// What rounded numbers can refute: the conditions at an end of the edge, where they need only few control points. With u = 2^-52, which
// bounds the relative error of an operation in every rounding mode, with or without fused multiplication and addition:
//
// - det(d, a, b) has 6 terms; in each of them three differences, two products, and at most four sums are rounded. With
//   bounds D, A, B of the coordinates the error is at most 6 ((1+u)^9 - 1) (1+u)^3 D A B < 2^-46 D A B.
// - The identity of second order has 4 * 24 terms. In each of them six first differences, one second difference (three
//   roundings with respect to the sum of the lengths of its two legs, which is the bound to take), at most seven products and
//   eight sums are rounded. The largest of the four products of bounds is M: the error is less than 96 ((1+u)^24 - 1)
//   (1+u)^20 M < 2^-40 M.
//
// All bounds lie between 2^-100 and 2^100, and factors are below 2^10, so that nothing overflows. A product that underflows
// has an error of 2^-1074, which is less than u 2^-300 times the product of the bounds of its factors, at least 2^-700;
// this is within the margins.
//
// The reversed edge has the differences d with the other sign, and so has f; all terms of the conditions are odd in d, or all even, so
// that its start may be taken in place of the end.
class Rounded_edge_end {
  const Edge_layers &s1_, &s2_;
  const bool at_end_;
  const Rounded_vector d_, a_, b_, normal_;
  mutable double largest_bound_ = 0; // of the second differences

public:
  // \pre the edges are the same, in one direction
  CGAL_GC_FORCEINLINE Rounded_edge_end(const Edge_layers& s1, const Edge_layers& s2, bool at_end)
      : s1_(s1), s2_(s2), at_end_(at_end), d_(first_difference(difference(s1, 0, 0, 1))),
        a_(first_difference(leg(s1, 0))), b_(first_difference(leg(s2, 0))), normal_(cross(d_, a_)) {}

  CGAL_GC_FORCEINLINE bool in_range() const { return d_.in_range() && a_.in_range() && b_.in_range(); }

  // \pre in_range()
  CGAL_GC_FORCEINLINE bool tangent_planes_differ() const { return dot(normal_, b_).exceeds(0x1p-46); }

  // \pre in_range()
  CGAL_GC_FORCEINLINE bool curvatures_differ() const {
    const std::array<double, 3>& n = normal_.x;
    int i = std::abs(n[0]) < std::abs(n[1]) ? 1 : 0;
    if (std::abs(n[static_cast<std::size_t>(i)]) < std::abs(n[2])) i = 2;
    return second_order_form(normal_[i], cross(d_, b_)[i], cross(b_, a_)[i], *this).exceeds(0x1p-40) &&
           largest_bound_ <= Rounded_vector::most;
  }

  // See second_order_form().
  CGAL_GC_FORCEINLINE Rounded_form mixed() const {
    return times(2 * s1_.along * s1_.across * s2_.across, a_.x, leg(s1_, 1));
  }
  CGAL_GC_FORCEINLINE bool is_curved_along() const { return s1_.along > 1; }
  CGAL_GC_FORCEINLINE Rounded_form along() const {
    return times(s1_.across * s2_.across * (s1_.along - 1), d_.x, difference(s1_, 0, 1, 2));
  }
  CGAL_GC_FORCEINLINE bool is_curved_across(int side) const { return (side == 0 ? s1_ : s2_).across > 1; }
  CGAL_GC_FORCEINLINE Rounded_form across(int side) const {
    const Edge_layers &s = side == 0 ? s1_ : s2_, &other = side == 0 ? s2_ : s1_;
    return times(s1_.along * other.across * (s.across - 1), (side == 0 ? a_ : b_).x,
                 minus(point(s, 2, 0), point(s, 1, 0)));
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
  CGAL_GC_FORCEINLINE Vector leg(const Edge_layers& s, int i) const { return minus(point(s, 1, i), point(s1_, 0, i)); }
  static CGAL_GC_FORCEINLINE Rounded_vector first_difference(const Vector& x) { return {x, largest(x)}; }
  // w times the product of the normal and the second difference y - x
  CGAL_GC_FORCEINLINE Rounded_form times(int w, const Vector& x, const Vector& y) const {
    const Rounded_vector difference{minus(y, x), (std::max)(Rounded_vector::least, largest(x) + largest(y))};
    largest_bound_ = (std::max)(largest_bound_, difference.bound);
    return dot(normal_, difference).times(w);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_EQUATIONS_H
