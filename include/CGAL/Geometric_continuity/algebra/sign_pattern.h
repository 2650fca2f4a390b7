// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file sign_pattern.h
/// The signs that a polynomial takes on an interval, one by one and all together as a pattern,
/// decided exactly: by its coefficients if they suffice, and otherwise by the roots of its
/// square-free part. The real roots of a polynomial in [0, 1], each in an interval of its own, with
/// their multiplicities: Descartes' rule in Bernstein form and bisection. Collins, Akritas; Lane,
/// Riesenfeld.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// The signs that a function takes on a closed interval.
enum class Sign_pattern {
  positive,    ///< only +
  negative,    ///< only -
  nonnegative, ///< + and 0
  nonpositive, ///< - and 0
  mixed,       ///< both + and -
  zero         ///< only 0
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the name of a pattern, as spelled in the enumeration.
inline std::string to_string(Sign_pattern pattern) {
  // unreachable: every value has a case
  switch (pattern) {
  case Sign_pattern::positive: return "positive";
  case Sign_pattern::negative: return "negative";
  case Sign_pattern::nonnegative: return "nonnegative";
  case Sign_pattern::nonpositive: return "nonpositive";
  case Sign_pattern::mixed: return "mixed";
  case Sign_pattern::zero: return "zero";
  }
  // unreachable: every value has a case
  return "unknown";
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Writes the name of a pattern.
inline std::ostream& operator<<(std::ostream& os, Sign_pattern pattern) { return os << to_string(pattern); }

/// \ingroup PkgGeometricContinuityAlgebra
/// A set of signs, from which a pattern is made.
class Sign_set {
  bool negative_ = false, zero_ = false, positive_ = false;

public:
  /// Adds the sign of a number: negative, zero or positive.
  void add(int sign) { (sign < 0 ? negative_ : sign > 0 ? positive_ : zero_) = true; }

  /// Adds all signs of a pattern; `Sign_pattern::mixed` counts as + and -.
  void add(Sign_pattern pattern) {
    negative_ = negative_ || pattern == Sign_pattern::negative || pattern == Sign_pattern::nonpositive ||
                pattern == Sign_pattern::mixed;
    zero_ = zero_ || pattern == Sign_pattern::zero || pattern == Sign_pattern::nonnegative ||
            pattern == Sign_pattern::nonpositive;
    positive_ = positive_ || pattern == Sign_pattern::positive || pattern == Sign_pattern::nonnegative ||
                pattern == Sign_pattern::mixed;
  }

  /// Decides whether both + and - are in the set.
  bool is_mixed() const { return negative_ && positive_; }

  /// Returns the pattern of the signs in the set. An empty set gives `Sign_pattern::zero`.
  Sign_pattern pattern() const {
    if (is_mixed()) return Sign_pattern::mixed;
    if (positive_) return zero_ ? Sign_pattern::nonnegative : Sign_pattern::positive;
    if (negative_) return zero_ ? Sign_pattern::nonpositive : Sign_pattern::negative;
    return Sign_pattern::zero;
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the pattern of the signs of two functions together, or of one function on two intervals.
inline Sign_pattern joint_pattern(Sign_pattern a, Sign_pattern b) {
  Sign_set signs;
  signs.add(a);
  signs.add(b);
  return signs.pattern();
}

namespace internal {

// A positive multiple of a polynomial over a field, in whole numbers where the field has a common
// denominator.
template <class Exact> using Whole_polynomial = Homogeneous_polynomial<typename Common_denominator<Exact>::Ring>;
template <class Exact> Whole_polynomial<Exact> whole_multiple(const Bernstein_polynomial<Exact>& p) {
  Common_denominator<Exact> denominator;
  for (const Exact& x : p.coefficients()) denominator.include(x);
  std::vector<typename Common_denominator<Exact>::Ring> c;
  for (const Exact& x : p.coefficients()) c.push_back(denominator.numerator(x));
  return Whole_polynomial<Exact>::from_bernstein(std::move(c));
}

// How often the coefficients change the sign, of a polynomial in Bernstein or in homogeneous form.
template <class Polynomial> int sign_variations(const Polynomial& p) {
  int variations = 0, last = 0;
  for (int k = 0; k <= p.degree(); ++k) {
    const int s = sign_of(p[k]);
    if (s != 0 && last != 0 && s != last) ++variations;
    if (s != 0) last = s;
  }
  return variations;
}

// A polynomial without the roots that it has at 0 and at 1. \pre p is not zero
template <class NT> struct Without_end_roots {
  bool root_at_0, root_at_1;
  Homogeneous_polynomial<NT> rest; // of the same sign as p inside

  explicit Without_end_roots(const Homogeneous_polynomial<NT>& p) {
    const int k = p.order_at_0(), l = p.order_at_1();
    root_at_0 = k > 0;
    root_at_1 = l > 0;
    rest = k + l > 0 ? p.without_end_factors(k, l) : p;
  }
};

// The signs of a polynomial on [0, 1] if those of its coefficients decide: the basis functions are
// positive inside, so that without coefficients of both signs only the ends can be zero.
inline std::optional<Sign_pattern> decided_by_coefficients(Sign_pattern coefficients, bool zero_at_an_end) {
  switch (coefficients) {
  case Sign_pattern::mixed: return std::nullopt;
  case Sign_pattern::nonnegative: return zero_at_an_end ? coefficients : Sign_pattern::positive;
  case Sign_pattern::nonpositive: return zero_at_an_end ? coefficients : Sign_pattern::negative;
  default: return coefficients;
  }
}

// The work of halves(): about n^2 sums of numbers that are by n digits longer than the
// coefficients.
template <class NT> double bisection_steps(const Homogeneous_polynomial<NT>& p) {
  // equivalent [1 -> 2, 1]: an estimate of work
  const double n = p.degree() + 1;
  // equivalent [max -> min, 1]: an estimate of work
  return n * n * Work_meter::sum_steps((std::max)(number_words(p[0]), number_words(p[p.degree() / 2])));
}
template <class NT> void charge_bisection(const Homogeneous_polynomial<NT>& p) {
  work_meter().charge_sums(bisection_steps(p) / Work_meter::sum_steps(1), 1);
}

// The signs of the coefficients. Those of one strict sign prove this sign on the closed interval.
template <class NT> Sign_pattern coefficient_signs(const Homogeneous_polynomial<NT>& p) {
  Sign_set signs;
  for (int k = 0; k <= p.degree(); ++k) signs.add(sign_of(p[k]));
  return signs.pattern();
}

// Positive, negative or zero if bisection proves that, otherwise mixed.
template <class NT> Sign_pattern strict_sign(const Homogeneous_polynomial<NT>& p, int bisections) {
  const Sign_pattern s = coefficient_signs(p);
  if (s == Sign_pattern::positive || s == Sign_pattern::negative || s == Sign_pattern::zero) return s;
  if (bisections == 0 || sign_of(p[0]) * sign_of(p[p.degree()]) != 1) return Sign_pattern::mixed;
  charge_bisection(p);
  const std::pair<Homogeneous_polynomial<NT>, Homogeneous_polynomial<NT>> halves = p.halves();
  const Sign_pattern left = strict_sign(halves.first, bisections - 1);
  if (left == Sign_pattern::mixed) return left;
  return strict_sign(halves.second, bisections - 1) == left ? left : Sign_pattern::mixed;
}

// Adds the signs of p on the open interval (0, 1), where p is not zero at 0 and 1 and s is its
// square-free part. Bisection ends because the roots of s are simple.
template <class NT, class Ring>
void add_signs(const Homogeneous_polynomial<NT>& p, const Homogeneous_polynomial<Ring>& s, Sign_set& signs) {
  typedef Homogeneous_polynomial<NT> Polynomial;
  typedef Homogeneous_polynomial<Ring> Square_free;
  std::vector<std::pair<Polynomial, Square_free>> parts{{p, s}}; // p has one sign at all their ends
  const auto split = [&](const Polynomial& x, const Square_free& y) {
    const Without_end_roots<NT> inside(x);
    if (inside.root_at_0 || inside.root_at_1) signs.add(0);
    signs.add(sign_of(inside.rest[0]));
    signs.add(sign_of(inside.rest[inside.rest.degree()]));
    parts.push_back({inside.rest, Without_end_roots<Ring>(y).rest});
  };
  while (!parts.empty() && !signs.is_mixed()) {
    const std::pair<Polynomial, Square_free> part = std::move(parts.back());
    parts.pop_back();
    const int variations = sign_variations(part.second);
    if (variations == 1) signs.add(0); // one root
    if (variations <= 1) continue;
    charge_bisection(part.first);
    charge_bisection(part.second);
    const std::pair<Polynomial, Polynomial> x = part.first.halves();
    const std::pair<Square_free, Square_free> y = part.second.halves();
    split(x.first, y.first);
    split(x.second, y.second);
  }
}

// The signs of p on [0, 1], where Exact is a field without numbers that are evaluated on demand.
template <class Exact, class NT> Sign_pattern exact_sign_pattern(const Homogeneous_polynomial<NT>& p) {
  const bool zero_at_an_end = p[0] == NT(0) || p[p.degree()] == NT(0);
  if (const auto decided = decided_by_coefficients(coefficient_signs(p), zero_at_an_end)) return *decided;
  const Without_end_roots<NT> inside(p);
  Sign_set signs;
  if (inside.root_at_0 || inside.root_at_1) signs.add(0);
  signs.add(sign_of(inside.rest[0]));
  signs.add(sign_of(inside.rest[inside.rest.degree()]));
  if (!signs.is_mixed())
    add_signs(inside.rest, whole_multiple(square_free_part(inside.rest.template bernstein<Exact>())), signs);
  return signs.pattern();
}

// Decides the signs of p on the closed interval [0, 1], exactly: by up to four bisections, and if
// those do not decide, by the square-free part and as many as are needed. \throws Error
// `work_limit`
template <class Exact, class NT> Sign_pattern sign_pattern(const Homogeneous_polynomial<NT>& p) {
  const Work_on_part work("sign_pattern");
  constexpr int bisections = 4;
  const Sign_pattern s = strict_sign(p, bisections);
  return s == Sign_pattern::mixed ? exact_sign_pattern<Exact>(p) : s;
}

// The coefficients of a polynomial as exact numbers. \throws Error `not_finite`
template <class FT> auto exact_polynomial(const Bernstein_polynomial<FT>& p) {
  typedef typename Exact_field<FT>::type Field;
  typedef typename Exact_number<Field>::type Exact;
  std::vector<Exact> c;
  for (const FT& x : p.coefficients()) c.push_back(Exact_number<Field>::of(to_field<Field>(x)));
  return Bernstein_polynomial<Exact>(std::move(c));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides the signs of `p` on the closed interval [0, 1], exactly: floating-point coefficients are
/// taken as the rational numbers they are.
///
/// Coefficients of one sign decide in \f$ O(n) \f$. Otherwise the square-free part is computed, and
/// \f$ O(n^2) \f$ additions are done for each bisection that separates its roots; there are about
/// as many bisections as the distance of the closest roots, complex ones included, has binary
/// digits.
/// \throws Error `not_finite` when a coefficient is infinite or not a number, `work_limit`
template <class FT> Sign_pattern sign_pattern(const Bernstein_polynomial<FT>& p) {
  const auto exact = internal::exact_polynomial(p);
  typedef typename std::decay_t<decltype(exact)>::FT Exact;
  Sign_set signs;
  for (const Exact& x : exact.coefficients()) signs.add(internal::sign_of(x));
  const bool zero_at_an_end = exact[0] == Exact(0) || exact[exact.degree()] == Exact(0);
  if (const auto decided = internal::decided_by_coefficients(signs.pattern(), zero_at_an_end)) return *decided;
  const internal::Work_on_part work("sign_pattern");
  return internal::exact_sign_pattern<Exact>(internal::whole_multiple(exact));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides the signs of `p` on the closed interval [a, b], `a < b`, exactly, at the cost of
/// `sign_pattern(p)` after \f$ O(n^2) \f$ operations that restrict `p`.
/// \throws Error `empty_domain` unless `a < b`
/// \throws Error `not_finite` when a coefficient or an end of the interval is infinite or not a
///   number, `work_limit`
template <class FT> Sign_pattern sign_pattern(const Bernstein_polynomial<FT>& p, const FT& a, const FT& b) {
  typedef typename Exact_field<FT>::type Field;
  if (!(a < b)) throw Error(Error_code::empty_domain, "sign_pattern: interval");
  std::vector<Field> c;
  for (const FT& x : p.coefficients()) c.push_back(internal::to_field<Field>(x));
  return sign_pattern(
      Bernstein_polynomial<Field>(std::move(c)).restricted(internal::to_field<Field>(a), internal::to_field<Field>(b)));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// A root of a polynomial: the only one in the interval [`begin`, `end`], and inside unless
/// `begin == end`; then it is this number.
/// \tparam FT a field number type
template <class FT> struct Isolated_root {
  FT begin;             ///< the lower end of the interval
  FT end;               ///< the upper end
  int multiplicity = 1; ///< the polynomial changes its sign at the root if and only if this is odd
};

/// \ingroup PkgGeometricContinuityAlgebra
/// The number of bisections that `isolate_roots()` allows by default: enough for about 100 roots
/// that are 2^-30 apart.
constexpr int default_bisections = 4096;

namespace internal {

// \pre the polynomial is not zero
template <class FT> class Root_isolation {
  typedef Bernstein_polynomial<FT> Polynomial;
  typedef Isolated_root<FT> Root;
  typedef Whole_polynomial<FT> Whole;
  typedef typename Whole::NT Number;

  // A multiple of the polynomial on [begin, end], reparametrised to [0, 1], without the roots at
  // these ends.
  struct Part {
    Whole rest;
    FT begin, end;
    bool root_at_begin, root_at_end;
  };

  const FT width_;
  const int most_bisections_;
  const Work_guard work_{"isolate_roots"};
  int bisections_ = 0; // that are left
  bool all_simple_ = true, given_up_ = false;
  std::vector<Root> roots_;
  std::vector<Part> parts_;

public:
  Root_isolation(const FT& width, int bisections) : width_(width), most_bisections_(bisections) {}

  // Most polynomials have simple roots only, which Descartes' rule shows without Euclid's
  // algorithm: an interval with one variation has one root, and it is simple. The square-free part
  // is for those where bisection does not end.
  std::vector<Root> operator()(const Polynomial& p) {
    find(whole_multiple(p));
    if (given_up_) find_with_multiplicities(p);
    std::sort(roots_.begin(), roots_.end(), [](const Root& x, const Root& y) { return bool(x.begin < y.begin); });
    return std::move(roots_);
  }

  // Returns whether s, which is square-free and has no other roots than the polynomial of `root`,
  // has this one.
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
/// Finds the roots of `p` in the closed interval [0, 1] in increasing order, each in an interval of
/// its own whose length is at most `width > 0`, with their multiplicities. A root is given exactly
/// if it is the only one of `p`, on or outside the interval, or if bisection meets it. The result
/// is empty for the zero polynomial, which has no isolated roots.
///
/// Exact: floating-point coefficients are taken as the rational numbers they are. Descartes' rule
/// in Bernstein form separates the roots by bisection; where it does not, as with multiple roots,
/// those of the square-free part.
///
/// \param p the polynomial, of degree `n`
/// \param width the greatest length of an interval
/// \param most_bisections the work that is allowed. Each bisection takes \f$ O(n^2) \f$ additions
///   of whole numbers that
///   grow by `n` binary digits with each of those before it that led to the same interval. An
///   interval of length \f$ 2^{-k} \f$ takes `k` bisections; roots that are close to each other
///   take more, at most about \f$ n \f$ times as many as the coefficients have digits. Where roots
///   are multiple or less than about \f$ 2^{-48} \f$ apart, there are up to twice as many, and the
///   square-free part and the multiplicities cost \f$ O(n^2) \f$ operations besides.
/// \throws Error `empty_domain` unless `width > 0`, `not_finite` when a coefficient is infinite or
///   not a number
/// \throws Error `work_limit` when more bisections or more work are needed, `negative_count` when
///   `most_bisections` is negative
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
/// Finds the roots of `p` in the closed interval [0, 1] in intervals of at most 1/1024, with at
/// most `default_bisections` bisections, see the function with these two as arguments.
/// \throws Error `not_finite` when a coefficient is infinite or not a number, `work_limit` when
///   more bisections are needed
template <class FT>
std::vector<Isolated_root<typename Exact_field<FT>::type>> isolate_roots(const Bernstein_polynomial<FT>& p) {
  typedef typename Exact_field<FT>::type Field;
  return isolate_roots(p, Field(Field(1) / Field(1024)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H
