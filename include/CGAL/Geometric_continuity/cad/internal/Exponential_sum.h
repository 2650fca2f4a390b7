// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXPONENTIAL_SUM_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXPONENTIAL_SUM_H

#include <CGAL/Geometric_continuity/cad/internal/exact_cad_geometry.h>
#include <CGAL/Geometric_continuity/numbers/internal/interval_functions.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

/// \file Exponential_sum.h
/// Functions such as (1 + 2 t) cos(3 + t/2), exactly: whether one vanishes identically is decided.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

typedef Interval_nt<false> Interval;

// A real function sum c t^n exp(i (w + f t)) with complex rational c and rational frequencies f and
// phases w. It vanishes identically if and only if all c do: the functions t^n exp(i f t) are
// linearly independent over the complex numbers, and the numbers exp(i w) with different algebraic
// w are linearly independent over the algebraic numbers (Lindemann and Weierstrass).
class Exponential_sum {
  typedef Model_number Number;
  typedef std::tuple<Number, Number, int> Exponent; // f, w, n
  struct Complex {
    Number re, im;
  };
  std::map<Exponent, Complex> terms_; // without those that are zero

  void add(const Exponent& exponent, const Number& re, const Number& im) {
    const auto place = terms_.emplace(exponent, Complex{Number(0), Number(0)}).first;
    Complex& c = place->second;
    c.re += re;
    c.im += im;
    if (c.re == Number(0) && c.im == Number(0)) terms_.erase(place);
  }

public:
  Exponential_sum() = default; // zero
  Exponential_sum(const Number& constant) { add({Number(0), Number(0), 0}, constant, Number(0)); }
  Exponential_sum(const Linear_function& x) : Exponential_sum(x.constant) {
    add({Number(0), Number(0), 1}, x.slope, Number(0));
  }
  static Exponential_sum cosine(const Linear_function& x) { // (exp(i x) + exp(-i x)) / 2
    Exponential_sum r;
    const Number half = Number(Number(1) / Number(2));
    r.add({x.slope, x.constant, 0}, half, Number(0));
    r.add({Number(-x.slope), Number(-x.constant), 0}, half, Number(0));
    return r;
  }
  static Exponential_sum sine(const Linear_function& x) { // (exp(i x) - exp(-i x)) / (2 i)
    Exponential_sum r;
    const Number half = Number(Number(1) / Number(2));
    r.add({x.slope, x.constant, 0}, Number(0), Number(-half));
    r.add({Number(-x.slope), Number(-x.constant), 0}, Number(0), half);
    return r;
  }

  bool is_zero() const { return terms_.empty(); }

  friend Exponential_sum operator+(Exponential_sum x, const Exponential_sum& y) {
    for (const auto& [e, c] : y.terms_) x.add(e, c.re, c.im);
    return x;
  }
  friend Exponential_sum operator-(Exponential_sum x, const Exponential_sum& y) {
    for (const auto& [e, c] : y.terms_) x.add(e, Number(-c.re), Number(-c.im));
    return x;
  }
  friend Exponential_sum operator*(const Exponential_sum& x, const Exponential_sum& y) {
    Exponential_sum r;
    for (const auto& [e, c] : x.terms_)
      for (const auto& [f, d] : y.terms_)
        r.add({Number(std::get<0>(e) + std::get<0>(f)), Number(std::get<1>(e) + std::get<1>(f)),
               std::get<2>(e) + std::get<2>(f)},
              Number(c.re * d.re - c.im * d.im), Number(c.re * d.im + c.im * d.re));
    return r;
  }
  friend bool operator==(const Exponential_sum& x, const Exponential_sum& y) { return (x - y).is_zero(); }

  Exponential_sum derivative() const {
    Exponential_sum r;
    for (const auto& [e, c] : terms_) {
      const auto& [f, w, n] = e;
      r.add(e, Number(-f * c.im), Number(f * c.re));
      if (n > 0) r.add({f, w, n - 1}, Number(Number(n) * c.re), Number(Number(n) * c.im));
    }
    return r;
  }

  // The sign that it has in all of [first, last]; empty when it vanishes there, or so nearly that
  // it is not found out.
  std::optional<int> sign_on(double first, double last) const {
    struct Term {
      Interval f, w, re, im;
      int n;
    };
    std::vector<Term> terms;
    const auto enclosed = [](const Number& x) {
      const std::pair<double, double> i = CGAL::to_interval(x);
      return Interval(i.first, i.second);
    };
    for (const auto& [e, c] : terms_)
      terms.push_back(
          {enclosed(std::get<0>(e)), enclosed(std::get<1>(e)), enclosed(c.re), enclosed(c.im), std::get<2>(e)});
    const Protect_FPU_rounding<true> rounding_upwards;
    const auto sign = [&](const Interval& t) {
      Interval sum = 0;
      for (const Term& x : terms) {
        const Cosine_and_sine angle = cosine_and_sine(x.w + x.f * t);
        Interval value = x.re * angle.cosine - x.im * angle.sine;
        for (int k = 0; k < x.n; ++k) value = value * t;
        sum += value;
      }
      return sum.inf() > 0 ? 1 : sum.sup() < 0 ? -1 : 0;
    };
    const int whole = sign(Interval(first / 2 + last / 2));
    if (whole == 0) return std::nullopt;
    Newest_first<Range> ranges;
    ranges.add({first, last});
    int evaluated = 0;
    const bool same_everywhere = subdivide(ranges, [&](const Range& range) {
      const int here = sign(Interval(range.lower, range.upper));
      const bool last_one = evaluated++ == 1000;
      if (here == whole) return After_part::drop;
      return here != 0 || last_one || !range.is_divisible() ? After_part::stop : After_part::divide;
    });
    return same_everywhere ? std::optional<int>(whole) : std::nullopt;
  }
};

typedef std::array<Exponential_sum, 3> Exponential_vector;

inline Exponential_vector operator+(const Exponential_vector& x, const Exponential_vector& y) {
  return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}
inline Exponential_vector operator-(const Exponential_vector& x, const Exponential_vector& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
inline Exponential_vector operator*(const Exponential_sum& s, const Exponential_vector& x) {
  return {s * x[0], s * x[1], s * x[2]};
}
inline bool is_zero(const Exponential_vector& x) { return x[0].is_zero() && x[1].is_zero() && x[2].is_zero(); }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXPONENTIAL_SUM_H
