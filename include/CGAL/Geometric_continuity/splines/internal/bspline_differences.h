// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_DIFFERENCES_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_DIFFERENCES_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_spans.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file bspline_differences.h
/// The Bernstein coefficients of the spans of a spline with rational coefficients, and the
/// derivatives at their ends, by additions of integers. The same coefficients in convex
/// combinations of numbers of any type are `Bernstein_spans`; test_bspline_pieces compares both.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class Ring> Ring exact_quotient(const Ring& x, const Ring& y) { return Ring(CGAL::integral_division(x, y)); }

// The divided differences c_i = n_i / d_i of rational numbers in place, without a greatest common
// divisor of long numbers: those of the next order are (c_i - c_{i-1}) / l_i. Fractions are not
// cancelled, but the quotients d_i / d_{i-1} = a_i / b_i of neighbours are kept and cancelled,
// which are much shorter than the d_i: the least common denominator of two neighbours is d_i b_i,
// and n_i b_i - n_{i-1} a_i stands over it.
template <class FT> class Divided_differences {
  typedef typename Common_denominator<FT>::Ring Ring;
  struct Entry {
    Ring n, d;
    Ring a = Ring(1), b = Ring(1);
    Ring factor = Ring(1); // of d in the last round
  };
  std::vector<Entry> c_;

public:
  explicit Divided_differences(const std::vector<FT>& c) {
    for (const FT& x : c) {
      Entry e;
      e.d = Common_denominator<FT>::denominator_of(x);
      e.n = Common_denominator<FT>(e.d).numerator(x);
      if (!c_.empty()) set_quotient(e, e.d, c_.back().d);
      c_.push_back(std::move(e));
    }
  }

  FT operator[](int i) const { return FT(FT(c_[i].n) / FT(c_[i].d)); }

  // The next order for the indices from `first` on. Those with length(i) = 0 are left out.
  template <class Length> void next(int first, Length length) {
    for (std::size_t i = first; i < c_.size(); ++i) {
      const Ring l = length(static_cast<int>(i));
      c_[i].factor = l == Ring(0) ? Ring(1) : Ring(c_[i].b * l);
    }
    for (std::size_t i = c_.size() - 1; i >= static_cast<std::size_t>(first); --i) {
      Entry &x = c_[i], &left = c_[i - 1];
      if (length(static_cast<int>(i)) != Ring(0)) {
        // equivalent [3 -> 4, 1]: an estimate of work
        work_meter().charge_products(3, number_words(x.d), number_words(x.factor));
        x.n = Ring(x.n * x.b - left.n * x.a);
        x.d *= x.factor;
      }
      if (i > static_cast<std::size_t>(first)) set_quotient(x, Ring(x.a * x.factor), Ring(x.b * left.factor));
    }
  }

private:
  void set_quotient(Entry& x, const Ring& a, const Ring& b) {
    const Ring common(CGAL::gcd(a, b));
    x.a = exact_quotient(a, common);
    x.b = exact_quotient(b, common);
    work_meter().charge_divisors(1, number_words(a), number_words(b));
  }
};

// The polynomials of a spline on one span [t, a] after the other, of one coordinate. Knots are
// multiplied by their common denominator. On a span of length h let f = sum_j g_j binomial(p, j)
// (x - t)^j. Then h^j g_j is the j-th forward difference of its Bernstein coefficients b_0, ...,
// b_p, and so is the backward difference of b_p with the g_j of the same polynomial around a. All
// Taylor coefficients binomial(p, j) g_j have one common denominator, which is the same around t
// and a: distances of knots are integers. At a knot of multiplicity m the g_j with j <= p - m stay;
// the others are quotients of differences of the coefficients of the spline.
template <class FT> class Difference_spans {
  typedef typename Common_denominator<FT>::Ring Ring;
  struct Span {
    Ring length;
    std::vector<FT> new_terms; // the last of the g_j at its beginning
  };

  const int p_;
  // binomial(p, j), and their least common multiple divided by each
  std::vector<Ring> binomials_, cofactors_;
  Ring multiple_ = Ring(1); // the least common multiple
  std::vector<Span> spans_;
  std::size_t next_ = 0;
  // binomial(p, j) g_j times the denominator, at the place that has been reached
  std::vector<Ring> terms_;
  Ring denominator_ = Ring(1);
  FT scale_; // of the knots

public:
  // c are the coefficients over the knots.
  Difference_spans(const Knot_vector<FT>& knots, std::vector<FT> c)
      : p_(knots.degree()), binomials_(binomial_coefficients<Ring>(p_)), terms_(p_ + 1, Ring(0)) {
    for (const Ring& b : binomials_) multiple_ *= exact_quotient(b, Ring(CGAL::gcd(multiple_, b)));
    for (const Ring& b : binomials_) cofactors_.push_back(exact_quotient(multiple_, b));
    const std::vector<int> numbers = knots.spans();
    const int begin = numbers[0];
    without_knots_before<1>(&knots[begin], p_, 1, c.data() + (begin - p_));
    Common_denominator<FT> scale;
    for (const FT& x : knots) scale.include(x);
    scale_ = FT(scale.value());
    std::vector<Ring> u;
    for (int i = 0; i < knots.size(); ++i) u.push_back(scale.numerator(knots[(std::max)(i, begin)]));
    for (int k : numbers) {
      int m = 1; // knots that are equal to the k-th and not behind it
      while (m <= p_ && u[k - m] == u[k]) ++m;
      spans_.push_back({Ring(u[k + 1] - u[k]), std::vector<FT>(spans_.empty() ? p_ + 1 : (std::min)(m, p_ + 1))});
    }
    Divided_differences<FT> differences(c);
    // number i is coefficient number i of the spline of degree p - j
    for (int j = 0; j <= p_; ++j) {
      for (std::size_t s = 0; s < numbers.size(); ++s) {
        std::vector<FT>& terms = spans_[s].new_terms;
        const int first = p_ + 1 - static_cast<int>(terms.size());
        if (first <= j) terms[j - first] = differences[numbers[s] - (p_ - j)];
      }
      if (j < p_) differences.next(j + 1, [&](int i) { return Ring(u[i + p_ - j] - u[i]); });
    }
  }

  // Starts the next span. Returns how many derivatives are new.
  int start() {
    const std::vector<FT>& terms = spans_[next_].new_terms;
    take(terms);
    return static_cast<int>(terms.size());
  }

  // The j-th derivative, j <= p, at the start or the end of the span.
  FT derivative(int j) const {
    const std::size_t words = number_words(denominator_);
    work_meter().charge_divisors(1, number_words(terms_[j]), words);
    FT factor(1); // j! scale^j
    for (int i = 1; i <= j; ++i) factor *= FT(FT(i) * scale_);
    return FT(factor * quotient(terms_[j], denominator_));
  }

  // Goes to the end of the span, with its Bernstein coefficients: output(i, numerator,
  // denominator).
  template <class Output> void finish(Output output) {
    const Span& span = spans_[next_++];
    const Ring denominator = Ring(denominator_ * multiple_);
    std::vector<Ring> factors; // of the differences
    Ring power(1);
    for (int j = 0; j <= p_; ++j) {
      factors.push_back(Ring(cofactors_[j] * power));
      power *= span.length;
      terms_[j] *= factors[j];
    }
    // equivalent [+ -> -, 1]: an estimate of work
    work_meter().charge_sums(p_ * (p_ + 1.) / 2, number_words(denominator));
    work_meter().charge_products(2. * (p_ + 1), number_words(denominator));
    output(0, terms_[0], denominator);
    for (int i = 1; i <= p_; ++i) {
      for (int j = 0; j <= p_ - i; ++j) terms_[j] += terms_[j + 1];
      output(i, terms_[0], denominator);
    }
    for (int j = 0; j <= p_; ++j) terms_[j] = exact_quotient(terms_[j], factors[j]);
  }

  static FT quotient(const Ring& x, const Ring& y) { return FT(FT(x) / FT(y)); }

private:
  // Replaces the last terms, and cancels.
  void take(const std::vector<FT>& g) {
    Common_denominator<FT> denominator(denominator_);
    for (const FT& x : g) denominator.include(x);
    const Ring factor = exact_quotient(denominator.value(), denominator_);
    const int first = p_ + 1 - static_cast<int>(g.size());
    for (int j = 0; j < first; ++j) terms_[j] *= factor;
    for (int j = first; j <= p_; ++j) terms_[j] = Ring(binomials_[j] * denominator.numerator(g[j - first]));
    denominator_ = denominator.value();
    Ring common = denominator_;
    for (int j = 0; j <= p_ && !(common == Ring(1)); ++j) {
      work_meter().charge_divisors(1, number_words(common), number_words(terms_[j]));
      common = Ring(CGAL::gcd(common, terms_[j]));
    }
    if (common == Ring(1)) return;
    denominator_ = exact_quotient(denominator_, common);
    for (Ring& x : terms_) x = exact_quotient(x, common);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_DIFFERENCES_H
