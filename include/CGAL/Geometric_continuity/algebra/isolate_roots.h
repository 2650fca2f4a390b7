// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_ISOLATE_ROOTS_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_ISOLATE_ROOTS_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A root of a polynomial: the only one in the interval [`begin`, `end`], and inside unless `begin == end`; then it is this
/// number.
/// \tparam FT a field number type
template <class FT> struct Isolated_root {
  FT begin;             ///< the lower end of the interval
  FT end;               ///< the upper end
  int multiplicity = 1; ///< the polynomial changes its sign at the root if and only if this is odd
};

namespace internal {

// \pre p is not zero
template <class FT> class Root_isolation {
  typedef Bernstein_polynomial<FT> Polynomial;
  typedef Isolated_root<FT> Root;

  const FT width_;
  std::vector<Root> roots_;

public:
  explicit Root_isolation(const FT& width) : width_(width) {}

  std::vector<Root> operator()(const Polynomial& p) {
    Power_polynomial<FT> f(p);
    in_closed_interval(square_free_part(p));
    std::sort(roots_.begin(), roots_.end(), [](const Root& x, const Root& y) { return bool(x.begin < y.begin); });
    for (;;) { // the greatest common divisor with the derivative has the same roots, each once less
      f = greatest_common_divisor(f, f.derivative());
      if (f.degree() < 1) return std::move(roots_);
      const Polynomial s = square_free_part(f.bernstein());
      for (Root& root : roots_)
        if (has_root(s, root)) ++root.multiplicity;
    }
  }

  // Whether s, which is square-free and has no other roots than the polynomial of `root`, has this one.
  static bool has_root(const Polynomial& s, const Root& root) {
    return sign_of(s(root.begin)) * sign_of(s(root.end)) <= 0;
  }

private:
  void in_closed_interval(const Polynomial& s) {
    if (s.degree() == 0) return;
    if (s[0] == FT(0)) roots_.push_back({FT(0), FT(0)});
    if (s[s.degree()] == FT(0)) roots_.push_back({FT(1), FT(1)});
    Signs signs;
    in_open_interval(s, without_end_roots(s, signs), FT(0), FT(1));
  }

  // q is s on [a, b], reparametrised to [0, 1], without the roots at a and b
  void in_open_interval(const Polynomial& s, const Polynomial& q, const FT& a, const FT& b) {
    const int variations = sign_variations(q);
    if (variations == 0) return;
    if (q.degree() == 1) {
      const FT root = a + (b - a) * q[0] / (q[0] - q[1]);
      roots_.push_back({root, root});
      return;
    }
    if (variations == 1 && !(width_ < FT(b - a)) && s(a) != FT(0) && s(b) != FT(0)) {
      roots_.push_back({a, b});
      return;
    }
    const FT middle = (a + b) / FT(2);
    const std::pair<Polynomial, Polynomial> halves = q.split(FT(FT(1) / FT(2)));
    if (halves.second[0] == FT(0)) roots_.push_back({middle, middle});
    Signs signs;
    in_open_interval(s, without_end_roots(halves.first, signs), a, middle);
    in_open_interval(s, without_end_roots(halves.second, signs), middle, b);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The roots of `p` in the closed interval [0, 1] in increasing order, each in an interval of its own whose length is at most
/// `width > 0`, with their multiplicities. A root is given exactly if it is
/// the only one of `p`, on or outside the interval, or if bisection meets it.
/// The result is empty for the zero polynomial, which has no isolated roots.
///
/// Exact: floating-point coefficients are taken as the rational numbers they are. Descartes' rule in Bernstein form separates
/// the roots of the square-free part by bisection.
/// \throws Error `empty_domain` unless `width > 0`, `not_finite` when a coefficient is infinite or not a number
template <class FT>
std::vector<Isolated_root<typename Exact_field<FT>::type>> isolate_roots(const Bernstein_polynomial<FT>& p,
                                                                         const typename Exact_field<FT>::type& width) {
  typedef typename Exact_field<FT>::type Field;
  if (!(Field(0) < width)) throw Error(Error_code::empty_domain, "isolate_roots: width");
  std::vector<Field> c;
  for (const FT& x : p.coefficients()) c.push_back(internal::to_field<Field>(x));
  if (std::all_of(c.begin(), c.end(), [](const Field& x) { return bool(x == Field(0)); })) return {};
  return internal::Root_isolation<Field>(width)(Bernstein_polynomial<Field>(std::move(c)));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The same with the width 1/1024.
template <class FT>
std::vector<Isolated_root<typename Exact_field<FT>::type>> isolate_roots(const Bernstein_polynomial<FT>& p) {
  typedef typename Exact_field<FT>::type Field;
  return isolate_roots(p, Field(Field(1) / Field(1024)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_ISOLATE_ROOTS_H
