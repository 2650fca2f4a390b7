// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_ISOLATE_ROOTS_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_ISOLATE_ROOTS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Power_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <utility>
#include <vector>

/// \file isolate_roots.h
/// The real roots of a polynomial in [0, 1], each in an interval of its own, with their
/// multiplicities: Descartes' rule in Bernstein form and bisection. Collins, Akritas; Lane, Riesenfeld.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A root of a polynomial: the only one in the interval [`begin`, `end`], and inside unless `begin == end`; then it is
/// this number.
/// \tparam FT a field number type
template <class FT> struct Isolated_root {
  FT begin;             ///< the lower end of the interval
  FT end;               ///< the upper end
  int multiplicity = 1; ///< the polynomial changes its sign at the root if and only if this is odd
};

/// \ingroup PkgGeometricContinuityAlgebra
/// How many bisections `isolate_roots()` does unless told otherwise: enough for about 100 roots that are 2^-30 apart.
constexpr int default_bisections = 4096;

namespace internal {

// \pre the polynomial is not zero
template <class FT> class Root_isolation {
  typedef Bernstein_polynomial<FT> Polynomial;
  typedef Isolated_root<FT> Root;
  typedef Whole_polynomial<FT> Whole;
  typedef typename Whole::NT Number;

  // A multiple of the polynomial on [begin, end], reparametrised to [0, 1], without the roots at these ends.
  struct Part {
    Whole rest;
    FT begin, end;
    bool root_at_begin, root_at_end;
  };

  const FT width_;
  const int most_bisections_;
  const Work_on_object work_{"isolate_roots"};
  int bisections_ = 0; // that are left
  bool all_simple_ = true, given_up_ = false;
  std::vector<Root> roots_;
  std::vector<Part> parts_;

public:
  Root_isolation(const FT& width, int bisections) : width_(width), most_bisections_(bisections) {}

  // Most polynomials have simple roots only, which Descartes' rule shows without Euclid's algorithm: an interval with one
  // variation has one root, and it is simple. The square-free part is for those where bisection does not end.
  std::vector<Root> operator()(const Polynomial& p) {
    find(whole_multiple(p));
    if (given_up_) find_with_multiplicities(p);
    std::sort(roots_.begin(), roots_.end(), [](const Root& x, const Root& y) { return bool(x.begin < y.begin); });
    return std::move(roots_);
  }

  // Whether s, which is square-free and has no other roots than the polynomial of `root`, has this one.
  static bool has_root(const Polynomial& s, const Root& root) {
    return sign_of(s(root.begin)) * sign_of(s(root.end)) <= 0;
  }

private:
  void find_with_multiplicities(const Polynomial& p) {
    all_simple_ = given_up_ = false;
    roots_.clear();
    parts_.clear();
    Power_polynomial<FT> f(p), g = greatest_common_divisor(f, f.derivative());
    find(whole_multiple(f.divide(g).bernstein()));
    while (g.degree() >= 1) { // it has the same roots, each once less
      f = std::move(g);
      g = greatest_common_divisor(f, f.derivative());
      const Polynomial s = f.divide(g).bernstein();
      for (Root& root : roots_)
        if (has_root(s, root)) ++root.multiplicity;
    }
  }

  void find(const Whole& s) {
    bisections_ = most_bisections_;
    if (s.degree() == 0) return;
    given_up_ = all_simple_ && (s.order_at_0() > 1 || s.order_at_1() > 1);
    if (s[0] == Number(0)) roots_.push_back({FT(0), FT(0)});
    if (s[s.degree()] == Number(0)) roots_.push_back({FT(1), FT(1)});
    add_part(s, FT(0), FT(1), false, false);
    while (!parts_.empty() && !given_up_) {
      const Part part = std::move(parts_.back());
      parts_.pop_back();
      bisect(part);
    }
  }

  // Keeps a part that may have roots inside and is too long.
  void add_part(const Whole& s, const FT& begin, const FT& end, bool root_at_begin, bool root_at_end) {
    Without_end_roots<Number> inside(s);
    root_at_begin = root_at_begin || inside.root_at_0;
    root_at_end = root_at_end || inside.root_at_1;
    const Whole& q = inside.rest;
    const int variations = sign_variations(q);
    if (variations == 0) return;
    if (q.degree() == 1) {
      const FT root = begin + (end - begin) * FT(q[0]) / (FT(q[0]) - FT(q[1]));
      roots_.push_back({root, root});
    } else if (variations == 1 && !(width_ < FT(end - begin)) && !root_at_begin && !root_at_end)
      roots_.push_back({begin, end});
    else {
      given_up_ = given_up_ || (all_simple_ && variations > 1 && FT(end - begin) * FT(1 << 24) * FT(1 << 24) < FT(1));
      parts_.push_back({std::move(inside.rest), begin, end, root_at_begin, root_at_end});
    }
  }

  void bisect(const Part& part) {
    if (--bisections_ < 0) {
      given_up_ = all_simple_;
      if (given_up_) return;
      throw Error(Error_code::work_limit, "isolate_roots: too many bisections");
    }
    const double n = part.rest.degree();
    work_meter().charge_sums(n * (n + 3), number_words(part.rest[0])); // and n shifts
    const FT middle = (part.begin + part.end) / FT(2);
    const std::pair<Whole, Whole> halves = part.rest.halves();
    const bool root = halves.second[0] == Number(0);
    if (root) roots_.push_back({middle, middle});
    given_up_ = given_up_ || (all_simple_ && halves.second.order_at_0() > 1);
    add_part(halves.first, part.begin, middle, part.root_at_begin, root);
    add_part(halves.second, middle, part.end, root, part.root_at_end);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Finds the roots of `p` in the closed interval [0, 1] in increasing order, each in an interval of its own whose
/// length is at most `width > 0`, with their multiplicities. A root is given exactly if it is the only one of `p`, on
/// or outside the interval, or if bisection meets it. The result is empty for the zero polynomial, which has no
/// isolated roots.
///
/// Exact: floating-point coefficients are taken as the rational numbers they are. Descartes' rule in Bernstein form
/// separates the roots by bisection; where it does not, as with multiple roots, those of the square-free part.
///
/// \param p the polynomial, of degree `n`
/// \param width the greatest length of an interval
/// \param most_bisections the work that is allowed. Each bisection takes \f$ O(n^2) \f$ additions of whole numbers that
///        grow by `n` binary digits with each of those before it that led to the same interval. An interval of length
///        \f$ 2^{-k} \f$ takes `k` bisections; roots that are close to each other take more, at most about \f$ n \f$
///        times as many as the coefficients have digits. Where roots are multiple or less than about \f$ 2^{-48} \f$ apart,
///        there are up to twice as many, and the square-free part and the multiplicities cost \f$ O(n^2) \f$ operations
///        besides.
/// \throws Error `empty_domain` unless `width > 0`, `not_finite` when a coefficient is infinite or not a number
/// \throws Error `work_limit` when more bisections or more work are needed, `negative_count` when `most_bisections` is negative
template <class FT>
std::vector<Isolated_root<typename Exact_field<FT>::type>> isolate_roots(const Bernstein_polynomial<FT>& p,
                                                                         const typename Exact_field<FT>::type& width,
                                                                         int most_bisections = default_bisections) {
  typedef typename Exact_field<FT>::type Field;
  typedef typename internal::Exact_number<Field>::type Exact;
  if (!(Field(0) < width)) throw Error(Error_code::empty_domain, "isolate_roots: width");
  if (most_bisections < 0) throw Error(Error_code::negative_count, "isolate_roots: bisections");
  const Bernstein_polynomial<Exact> exact = internal::exact_polynomial(p);
  std::vector<Isolated_root<Field>> roots;
  if (Power_polynomial<Exact>(exact).is_zero()) return roots;
  internal::Root_isolation<Exact> isolation(Exact(internal::Exact_number<Field>::of(width)), most_bisections);
  for (const Isolated_root<Exact>& root : isolation(exact))
    roots.push_back({Field(root.begin), Field(root.end), root.multiplicity});
  return roots;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Finds the roots of `p` in the closed interval [0, 1] in intervals of at most 1/1024, with at most
/// `default_bisections` bisections, see the function with these two as arguments.
/// \throws Error `not_finite` when a coefficient is infinite or not a number, `work_limit` when more bisections are
///   needed
template <class FT>
std::vector<Isolated_root<typename Exact_field<FT>::type>> isolate_roots(const Bernstein_polynomial<FT>& p) {
  typedef typename Exact_field<FT>::type Field;
  return isolate_roots(p, Field(Field(1) / Field(1024)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_ISOLATE_ROOTS_H
