// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_ZEROS_ON_SQUARE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_ZEROS_ON_SQUARE_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// \file zeros_on_square.h
/// Decides if a polynomial f(u, v) that is not zero on the boundary of the unit square is zero
/// inside, also where it is nowhere negative and its zeros are no rational numbers.
///
/// The zeros inside are a closed set. Where one of them has the least u, a factor of f and its
/// derivative are zero: otherwise the zero would go on to the left. So are f and f_v, divided by
/// their greatest common divisor, and with them all that Euclid's algorithm makes of these two, up
/// to factors in u alone that are divided out on the way; the last of it is 1. So f has zeros if
/// and only if f(u, .) has one in (0, 1) for a root u of one of those factors. Such a u is an
/// algebraic number, known by an interval; the zeros of f(u, .) are counted by Sturm's theorem. See
/// Basu, Pollack, Roy, "Algorithms in Real Algebraic Geometry", chapters 2 and 11.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT> Power_polynomial<FT> constant(const FT& c) { return Power_polynomial<FT>(std::vector<FT>{c}); }

// a b - c d
template <class FT>
Power_polynomial<FT> difference_of_products(const Power_polynomial<FT>& a, const Power_polynomial<FT>& b,
                                            const Power_polynomial<FT>& c, const Power_polynomial<FT>& d) {
  std::vector<FT> r((std::max)({a.degree() + b.degree(), c.degree() + d.degree(), 0}) + 1, FT(0));
  work_meter().charge_products((a.degree() + 1.) * (b.degree() + 1), most_words(a), most_words(b));
  work_meter().charge_products((c.degree() + 1.) * (d.degree() + 1), most_words(c), most_words(d));
  for (int i = 0; i <= a.degree(); ++i)
    for (int j = 0; j <= b.degree(); ++j) r[i + j] += a[i] * b[j];
  for (int i = 0; i <= c.degree(); ++i)
    for (int j = 0; j <= d.degree(); ++j) r[i + j] -= c[i] * d[j];
  return Power_polynomial<FT>(std::move(r));
}

// A polynomial in v: its coefficients are polynomials in u, the last of them not zero.
template <class FT> using Polynomial_in_v = std::vector<Power_polynomial<FT>>;

template <class FT> Polynomial_in_v<FT> derivative_in_v(const Polynomial_in_v<FT>& f) {
  Polynomial_in_v<FT> d;
  for (std::size_t k = 1; k < f.size(); ++k)
    d.push_back(difference_of_products(f[k], constant(FT(static_cast<int>(k))), {}, {}));
  return d;
}

// Leaves the remainder of l^k f divided by g, where l is the leading coefficient of g and k even.
template <class FT> void pseudo_remainder(Polynomial_in_v<FT>& f, const Polynomial_in_v<FT>& g) {
  const Power_polynomial<FT> leading = g.back(), zero;
  bool odd = false;
  for (; f.size() >= g.size(); odd = !odd) {
    const std::size_t shift = f.size() - g.size();
    const Power_polynomial<FT> last = f.back();
    for (std::size_t i = 0; i < f.size(); ++i)
      f[i] = difference_of_products(f[i], leading, last, i < shift ? zero : g[i - shift]);
    while (!f.empty() && f.back().is_zero()) f.pop_back();
  }
  if (odd)
    for (Power_polynomial<FT>& c : f) c = difference_of_products(c, leading, zero, zero);
}

// An algebraic number: the only root of a polynomial without multiple roots in an interval.
template <class FT> class Algebraic_number {
  Power_polynomial<FT> s_;
  FT begin_, end_;

public:
  Algebraic_number(Power_polynomial<FT> s, FT begin, FT end)
      : s_(std::move(s)), begin_(std::move(begin)), end_(std::move(end)) {
    if (begin_ == end_) s_ = Power_polynomial<FT>(std::vector<FT>{FT(-begin_), FT(1)});
  }

  // Leaves a polynomial of less degree with the same value at the number.
  void reduce(Power_polynomial<FT>& p) const {
    // equivalent [* -> +, 1]: an estimate of work
    work_meter().charge_products((std::max)(p.degree() - s_.degree() + 1, 0) * (s_.degree() + 1.),
                                 (std::max)(most_words(p), most_words(s_)));
    p.divide(s_);
  }

  // The sign of p at the number; the interval becomes shorter.
  int sign(Power_polynomial<FT> p) {
    reduce(p);
    if (p.degree() <= 0) return p.is_zero() ? 0 : sign_of(p[0]);
    const Bernstein_polynomial<FT> common = greatest_common_divisor(p, s_).bernstein(), s = s_.bernstein();
    if (sign_of(common(begin_)) * sign_of(common(end_)) < 0) return 0;
    const Bernstein_polynomial<FT> b = p.bernstein();
    for (;;) {
      const Sign_pattern pattern = sign_pattern(b, begin_, end_);
      if (pattern == Sign_pattern::positive) return 1;
      if (pattern == Sign_pattern::negative) return -1;
      const FT middle = FT((begin_ + end_) / FT(2));
      work_meter().charge_products(s.degree() * (s.degree() + 1.), most_words(s_), number_words(middle));
      const int side = sign_of(s(middle));
      if (side == 0) {
        *this = Algebraic_number({}, middle, middle);
        return sign(std::move(p));
      }
      (side == sign_of(s(begin_)) ? begin_ : end_) = middle;
    }
  }

  // The polynomial in v at this u: zeros at the end are dropped, and the numbers are made shorter
  // by a positive factor.
  void simplify(Polynomial_in_v<FT>& f) {
    for (Power_polynomial<FT>& c : f) reduce(c);
    while (!f.empty() && sign(f.back()) == 0) f.pop_back();
    if (f.empty()) return;
    const FT& leading = f.back()[f.back().degree()];
    // equivalent [< -> <=, 1]: the leading coefficient is not zero
    const Power_polynomial<FT> factor = constant(FT(FT(1) / (leading < FT(0) ? FT(-leading) : leading)));
    for (Power_polynomial<FT>& c : f) c = difference_of_products(c, factor, {}, {});
  }

  // The number of zeros of f at this u for v in (0, 1). \pre none is at 0 or 1
  int zeros(Polynomial_in_v<FT> f) {
    Polynomial_in_v<FT> g = derivative_in_v(f);
    simplify(f);
    simplify(g);
    int zeros = 0, last[2] = {0, 0};
    for (;; f.swap(g)) { // f is not empty
      Power_polynomial<FT> sum;
      for (const Power_polynomial<FT>& c : f) sum = difference_of_products(sum, constant(FT(1)), c, constant(FT(-1)));
      const int signs[2] = {sign(f.front()), sign(sum)};
      for (int end = 0; end < 2; ++end)
        if (signs[end] != 0) {
          if (signs[end] == -last[end]) zeros += end == 0 ? 1 : -1;
          last[end] = signs[end];
        }
      if (g.empty()) break;
      pseudo_remainder(f, g);
      for (Power_polynomial<FT>& c : f) c = difference_of_products({}, {}, c, constant(FT(1)));
      simplify(f);
    }
    return zeros;
  }
};

// Divides by the greatest common divisor of the coefficients, which is returned.
template <class FT> Power_polynomial<FT> divide_by_content(Polynomial_in_v<FT>& f) {
  Power_polynomial<FT> content;
  for (const Power_polynomial<FT>& c : f) content = greatest_common_divisor(c, content);
  content.make_monic();
  const Power_polynomial<FT> leading = constant(f.back()[f.back().degree()]); // for shorter numbers
  for (Power_polynomial<FT>& c : f) {
    c = c.divide(content);
    c = c.divide(leading);
  }
  return content;
}

// Polynomials in u of which one is zero at the least u of the zeros of f, see above.
template <class FT> std::vector<Power_polynomial<FT>> ends_of_zeros(Polynomial_in_v<FT> f) {
  std::vector<Power_polynomial<FT>> ends;
  Polynomial_in_v<FT> g = derivative_in_v(f);
  divide_by_content(f);
  for (; !g.empty(); f.swap(g)) {
    pseudo_remainder(f, g);
    if (!f.empty()) ends.push_back(divide_by_content(f));
  }
  return ends;
}

// Returns whether f, given by the coefficients of u^i v^j in row i, has a zero on the unit square.
// \pre it has none on the boundary
// \throws Error `work_limit`
template <class FT> bool has_zero_on_square(const std::vector<std::vector<FT>>& coefficients) {
  const Work_guard work("zeros of a denominator");
  Polynomial_in_v<FT> f;
  for (std::size_t j = 0; j < coefficients[0].size(); ++j) {
    std::vector<FT> c;
    for (const std::vector<FT>& row : coefficients) c.push_back(row[j]);
    f.emplace_back(std::move(c));
  }
  while (f.back().is_zero()) f.pop_back(); // not all are: there is no zero on the boundary
  if (f.size() <= 1) return false;
  for (const Power_polynomial<FT>& end : ends_of_zeros(f)) {
    if (end.degree() < 1) continue;
    const Bernstein_polynomial<FT> s = square_free_part(end.bernstein());
    for (const Isolated_root<FT>& root : isolate_roots(s)) {
      if (root.begin == root.end && (root.begin == FT(0) || root.begin == FT(1))) continue;
      if (Algebraic_number<FT>(Power_polynomial<FT>(s), root.begin, root.end).zeros(f) > 0) return true;
    }
  }
  return false;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_ZEROS_ON_SQUARE_H
