// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_ON_DOUBLES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_ON_DOUBLES_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Rational_join_weights.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_doubles.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_integers.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The weights of an end, w_j c^j times a factor, so that the first two are in [1, 2): powers of two do this without rounding, and the
// curve is the same in another parameter. Not valid unless all lie within 2^-20 and 2^20.
template <int k> class End_weights {
  std::array<double, 4> w_{};
  bool valid_ = true;

public:
  template <class End> CGAL_GC_FORCEINLINE explicit End_weights(const End& end) {
    const int m = end.degree();
    for (int j = 0; j <= k; ++j) w_[j] = end.weight((std::min)(j, m));
    const int e = binary_exponent(w_[0]), f = binary_exponent(w_[1]) - e;
    valid_ = -300 <= e && e <= 300 && -150 <= f && f <= 150;
    if (!valid_) return;
    for (int j = 0; j <= k; ++j) {
      w_[j] *= power_of_two(-e - j * f);
      valid_ &= 0x1p-20 <= w_[j] && w_[j] <= 0x1p20;
    }
  }

  CGAL_GC_FORCEINLINE bool valid() const { return valid_; }
  CGAL_GC_FORCEINLINE const std::array<double, 4>& operator()() const { return w_; }

  // The largest power of two of which all weights are multiples is 2 to this power. \pre they are valid
  CGAL_GC_FORCEINLINE int exponent_of_unit() const {
    int unit = 20;
    for (int j = 0; j <= k; ++j) {
      const std::uint64_t bits = bits_of(w_[j]) | std::uint64_t(1) << 52;
      unit = (std::min)(unit, binary_exponent(w_[j]) - 52 + __builtin_ctzll(bits));
    }
    return unit;
  }
};

// As first_derivatives_differ(), for ends with weights: the factors w_1/w_0 of the first derivatives bring two more roundings, and an
// underflow that is too small to count.
template <int N, class Left, class Right> bool rational_first_derivatives_differ(const Left& left, const Right& right) {
  const auto factor = [](const auto& end) -> double {
    const double first = end.weight(0), second = end.weight((std::min)(1, end.degree())); // of shorter types, too
    return second / first;
  };
  const auto first_derivative = [](const auto& end, double factor) {
    const End_polygon<double, N> x = points_of<1, N>(end);
    std::array<double, N> d = internal::minus(x[1], x[0]);
    for (double& di : d) di *= factor;
    return d;
  };
  const std::pair<double, double> h = left.domain(), l = right.domain();
  const int m = left.degree(), n = right.degree();
  const double r = factor(left), s = factor(right);
  const bool in_range = 0x1p-500 <= (std::min)(r, s) && (std::max)(r, s) <= 0x1p500 &&
                        (std::max)(m * (l.second - l.first), n * (h.second - h.first)) <= 0x1p500;
  return in_range && first_derivatives_differ<N>(first_derivative(left, r), m, h, first_derivative(right, s), n, l);
}

// Factors that are products of at most seven weights and four degrees, each of them rounded. With those of End_weights and degrees up to
// 1000 they lie within 2^-40 (or 0) and 2^70: Join_filter has room for these, too.
struct Rounding_of_rational_ends {
  static constexpr Join_rounding value() {
    constexpr Rounding_bound w(1, 16 * 0x1p-52);
    return Join_rounding(Rational_join_weights<Join_question::g3, Rounding_bound>{w, w, w, w, w, w});
  }
};

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Whole numbers that are at most 2^56, so that products of them with the degrees have room in as many limbs as factors.
template <int k, class Integer>
CGAL_GC_FORCEINLINE bool weights_in_units(const End_weights<k>& weights, int unit, std::array<Integer, 4>& w) {
  for (int j = 0; j <= k; ++j) {
    const double x = weights()[j] * power_of_two(-unit);
    if (!(x <= 0x1p56)) return false;
    w[j] = Integer(static_cast<std::int64_t>(x));
  }
  return true;
}

// The decision in residues modulo 2^(64 limbs), as decide_modulo(). A form of degree d in coordinates of n bits and of degree e in
// weights of l bits that has passed the filter has about (d - 1) n + e l bits.
template <Join_question question, int N, int limbs, int k, class Filter, class Stages>
BOOST_NOINLINE Join_answer decide_rational_modulo(const End_polygon<double, N>& p, const End_polygon<double, N>& q,
                                                  const Differences<double, N>& a, const Differences<double, N>& b,
                                                  int pivot, const Filter& filter, const End_weights<k>& left, int m,
                                                  const End_weights<k>& right, int n, Stages& stages) {
  typedef Rational_join_weights<question, Residue<limbs>> Factors;
  const int g = left.exponent_of_unit(), h = right.exponent_of_unit();
  std::array<Residue<limbs>, 4> w{}, v{};
  if (!weights_in_units<k>(left, g, w) || !weights_in_units<k>(right, h, v)) return Join_answer::unknown;
  const auto unit = [=](Join_question f) { return g * Factors::left_degree(f) + h * Factors::right_degree(f); };
  return decide_modulo<question, N, Residue<limbs>>(p, q, a, b, pivot, Factors::of(w, m, v, n), filter, unit, stages);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The decision on two ends with double coordinates and positive weights, exact or `unknown`: as decide_on_doubles(), with the
// differences and factors of Rational_join_weights.
template <Join_question question, int N, class Left, class Right, class Stages>
Join_answer decide_rational_on_doubles(const Left& left, const Right& right, Stages& stages) {
  constexpr int k = highest_difference(question);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  const End_polygon<double, N> p = points_of<k, N>(left), q = points_of<k, N>(right);
  const int m = left.degree(), n = right.degree();
  if ((std::max)(m, n) > 1000) return Join_answer::unknown;
  const Differences<double, N> a = fan_of<k, true>(p), b = fan_of<k, false>(q);
  const int pivot = largest_coordinate(a[0]);
  const Join_answer by_signs = decide_by_signs<question>(a[0], b[0], pivot);
  if (by_signs != Join_answer::unknown) return decided(Join_stage::comparison, by_signs);

  const End_weights<k> left_weights(left), right_weights(right);
  if (!left_weights.valid() || !right_weights.valid() || !stages.uses(Join_stage::floating_point))
    return Join_answer::unknown;
  typedef Rational_join_weights<question, double> Weights;
  const Weights w = Weights::of(left_weights(), m, right_weights(), n);
  const Difference_bounds A = bounds_of_fan<k>(a), B = bounds_of_fan<k>(b);
  const Join_filter<Weights, Rounding_of_rational_ends> filter{A, B, w};
  if (!filter.in_range()) return Join_answer::unknown;
  const Join_equations<double, N, Weights, const Join_filter<Weights, Rounding_of_rational_ends>> equations(
      a, b, w, filter, pivot);
  if (!all_hold<question>(equations)) return decided(Join_stage::floating_point, Join_answer::no);
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  if (stages.uses(Join_stage::bounded_residue)) {
    const auto modulo = [&](auto limbs) {
      return decide_rational_modulo<question, N, limbs()>(p, q, a, b, pivot, filter, left_weights, m, right_weights, n,
                                                          stages);
    };
    const Join_answer answer = modulo(std::integral_constant<int, 4>());
    return answer != Join_answer::unknown ? answer : modulo(std::integral_constant<int, 8>());
  }
#endif
  return Join_answer::unknown;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_ON_DOUBLES_H
