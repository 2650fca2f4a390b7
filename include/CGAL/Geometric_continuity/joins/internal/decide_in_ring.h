// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_equations.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_weights.h>
#include <CGAL/Geometric_continuity/numbers/internal/Double_scale.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

/// \file decide_in_ring.h
/// The last rung of the ladder: the equations of a join on numbers of any length, which are multiplied by their common denominator, so
/// that no fraction is cancelled.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The differences of the orders up to k of one coordinate of an end, because numbers of any length are long to compile.
template <bool weighted, class T>
BOOST_NOINLINE std::array<T, 3> differences_along(std::array<T, 4>& x, int k, bool left, int degree) {
  std::array<T, 3> d{T(0), T(0), T(0)};
  for (int order = 1; order <= k; ++order) {
    if constexpr (weighted)
      d[order - 1] = T(x[order] - x[0]);
    else {
      for (int j = 0; j <= k - order; ++j) x[j] = T(x[j + 1] - x[j]);
      if (order <= degree) d[order - 1] = x[0];
    }
    if (left && order != 2) d[order - 1] = T(T(0) - d[order - 1]);
  }
  return d;
}

// The numbers of two ends that a question needs: points, weights, or for the orders C the ends of the domains. One class for all
// questions, because most programs come here seldom, and all of them compile it.
template <int N, bool weighted, class Scale> class Ring_join {
  typedef typename Scale::Number Number;

  struct End {
    End_polygon<Number, N> points;
    std::array<Number, 4> numbers; // weights, or ends of the domain
    int degree;
  };
  const Join_question question_;
  const int k_;
  Scale points_;
  std::array<Scale, 2> scales_; // of the weights on either side; the first one is of both domains
  End left_, right_;
  int pivot_ = 0; // the first coordinate in which the left end has a tangent

  template <class Points> void read(const Points& end, int side, End& x) {
    x.degree = end.degree();
    for (int j = 0; j <= k_; ++j) {
      const int l = (std::min)(j, x.degree);
      for (int i = 0; i < N; ++i) points_.include(x.points[j][i] = Scale::number(end.coordinate(l, i)));
      if constexpr (weighted) scales_[side].include(x.numbers[j] = Scale::number(end.weight(l)));
    }
    if constexpr (!weighted)
      if (is_parametric(question_)) {
        const auto domain = end.domain();
        scales_[0].include(x.numbers[0] = Scale::number(domain.first));
        scales_[0].include(x.numbers[1] = Scale::number(domain.second));
      }
  }

  // The first coordinate in which the end points of an end and the next ones differ; N if there is none.
  static int first_difference(const End& x) {
    int i = 0;
    while (i < N && x.points[0][i] == x.points[1][i]) ++i;
    return i;
  }

  // The numerator of x in a ring: itself, or its residue.
  template <class Ring> static Ring in_ring(const Scale& scale, const Number& x) {
    if constexpr (std::is_same_v<Ring, typename Scale::Ring>)
      return scale.numerator(x);
    else
      return scale.residue(x);
  }
  // From the pivot on.
  template <class Ring> BOOST_NOINLINE Differences<Ring, N> differences(const End& x, bool left) const {
    Differences<Ring, N> d;
    for (int i = 0; i < N; ++i) {
      std::array<Ring, 4> y{};
      for (int j = 0; j <= k_; ++j) y[j] = in_ring<Ring>(points_, x.points[j][(pivot_ + i) % N]);
      std::array<Ring, 3> z = differences_along<weighted>(y, k_, left, x.degree);
      for (int j = 0; j < k_; ++j) d[j][i] = std::move(z[j]);
    }
    return d;
  }
  template <class Ring> Ring length(const End& x) const {
    return Ring(in_ring<Ring>(scales_[0], x.numbers[1]) - in_ring<Ring>(scales_[0], x.numbers[0]));
  }
  template <class Ring> std::array<Ring, 4> weights(const End& x, const Scale& scale) const {
    std::array<Ring, 4> w{};
    for (int j = 0; j <= k_; ++j) w[j] = in_ring<Ring>(scale, x.numbers[j]);
    return w;
  }

public:
  template <class Left, class Right>
  Ring_join(Join_question question, const Left& left, const Right& right)
      : question_(question), k_(highest_difference(question)) {
    read(left, 0, left_);
    read(right, 1, right_);
    if (!is_parametric(question)) pivot_ = first_difference(left_);
  }

  bool tangents_vanish() const { return !is_parametric(question_) && (pivot_ == N || first_difference(right_) == N); }

  // The first coordinate of the first one on the left is not zero unless the question is parametric. \pre no tangent vanishes
  template <class Ring> Differences<Ring, N> left() const { return differences<Ring>(left_, true); }
  template <class Ring> Differences<Ring, N> right() const { return differences<Ring>(right_, false); }

  // Of ends with weights, in one type for all questions. \pre the question is the one of the object
  template <Join_question question, class Ring> auto factors() const {
    if constexpr (is_parametric(question))
      return Parametric_join_weights<Ring>::of(left_.degree, right_.degree, length<Ring>(left_), length<Ring>(right_));
    else if constexpr (weighted) {
      const auto w = Rational_join_weights<question, Ring>::of(weights<Ring>(left_, scales_[0]), left_.degree,
                                                               weights<Ring>(right_, scales_[1]), right_.degree);
      return Rational_join_weights<Join_question::g3, Ring>{w.a2, w.b2, w.first, w.a3, w.b3, w.mix};
    } else
      return Join_weights<Ring>::template geometric<question>(left_.degree, right_.degree);
  }
};

// The equations in a ring. What several questions ask is one function for all of them.
template <class T, int N, class Weights, class Zero> class Ring_equations : public Join_equations<T, N, Weights, Zero> {
  typedef Join_equations<T, N, Weights, Zero> Base;

public:
  using Base::Base;
  BOOST_NOINLINE bool tangents_parallel() const { return Base::tangents_parallel(); }
  BOOST_NOINLINE bool g2(const Join_ratio<T>& r) const { return Base::g2(r); }
  template <int k> BOOST_NOINLINE bool derivatives_equal() const { return Base::template derivatives_equal<k>(); }
};

// What the equations say in a ring: `no` is a proof, all others as far as `Zero` is exact. \pre no tangent vanishes
template <Join_question question, class T, class Zero, int N, bool weighted, class Scale>
Join_answer answer_in(const Ring_join<N, weighted, Scale>& join) {
  const Differences<T, N> a = join.template left<T>(), b = join.template right<T>();
  const auto w = join.template factors<question, T>();
  Zero zero;
  const Ring_equations<T, N, std::decay_t<decltype(w)>, Zero> equations(a, b, w, zero);
  if constexpr (Zero::exact) {
    if (is_geometric(question) && ((T(0) < a[0][0]) != (T(0) < b[0][0]) || b[0][0] == T(0))) return Join_answer::no;
    if constexpr (question == Join_question::torsion)
      if (!equations.both_have_curvature()) return Join_answer::undefined;
  }
  return all_hold<question>(equations) ? Join_answer::yes : Join_answer::no;
}

// The answer, by residues of doubles where these refute, and by whole numbers or the numbers of the field. The ends need
// positive weights if they are asked for them.
template <Join_question question, int N, bool weighted, class Scale, class Left, class Right, class Stages>
BOOST_NOINLINE Join_answer decide_in_ring(const Left& left, const Right& right, Stages& stages) {
  const Ring_join<N, weighted, Scale> join(question, left, right);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  if (join.tangents_vanish())
    return decided(Join_stage::multiprecision, is_geometric(question) ? Join_answer::no : Join_answer::undefined);
#ifdef CGAL_USE_GMP
  if constexpr (std::is_same_v<Scale, Binary_scale>)
    if (stages.uses(Join_stage::residue) && answer_in<question, std::uint64_t, Residue_zero>(join) == Join_answer::no)
      return decided(Join_stage::residue, Join_answer::no);
#endif
  typedef typename Scale::Ring Ring;
  return decided(Join_stage::multiprecision, answer_in<question, Ring, Exact_zero<Ring>>(join));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H
