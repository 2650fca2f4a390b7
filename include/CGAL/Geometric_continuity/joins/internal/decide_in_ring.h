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
#include <cstddef>
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
BOOST_NOINLINE std::array<T, 3> differences_along(std::array<T, 4> x, int k, bool left, int degree) {
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

  bool parametric() const { return is_parametric(question_); }

  template <class Points> void read(const Points& end, int side, End& x) {
    x.degree = end.degree();
    for (int j = 0; j <= k_; ++j) {
      const int l = (std::min)(j, x.degree);
      for (int i = 0; i < N; ++i) points_.include(x.points[j][i] = Scale::number(end.coordinate(l, i)));
      if constexpr (weighted) scales_[side].include(x.numbers[j] = Scale::number(end.weight(l)));
    }
    if constexpr (!weighted)
      if (parametric()) {
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

  // In a ring, where in_ring(scale, x) is the numerator of x, from the pivot on.
  template <class Ring, class Function>
  BOOST_NOINLINE Differences<Ring, N> differences(const End& x, bool left, Function in_ring) const {
    Differences<Ring, N> d;
    for (int i = 0; i < N; ++i) {
      std::array<Ring, 4> y{};
      for (int j = 0; j <= k_; ++j) y[j] = in_ring(points_, x.points[j][(pivot_ + i) % N]);
      std::array<Ring, 3> z = differences_along<weighted>(y, k_, left, x.degree);
      for (int j = 0; j < k_; ++j) d[j][i] = std::move(z[j]);
    }
    return d;
  }
  template <class Ring, class Function>
  BOOST_NOINLINE Parametric_join_weights<Ring> parametric_factors(Function in_ring) const {
    const auto length = [&](const End& x) {
      return Ring(in_ring(scales_[0], x.numbers[1]) - in_ring(scales_[0], x.numbers[0]));
    };
    return Parametric_join_weights<Ring>::of(left_.degree, right_.degree, length(left_), length(right_));
  }
  // Of ends with weights, in one type for all questions.
  template <Join_question question, class Ring>
  Rational_join_weights<Join_question::g3, Ring> rational_factors(const std::array<Ring, 4>& left,
                                                                  const std::array<Ring, 4>& right) const {
    const Rational_join_weights<question, Ring> w =
        Rational_join_weights<question, Ring>::of(left, left_.degree, right, right_.degree);
    return {w.a2, w.b2, w.first, w.a3, w.b3, w.mix};
  }
  template <class Ring, class Function> auto factors(Function in_ring) const {
    if constexpr (weighted) {
      const auto weights = [&](const End& x, const Scale& scale) {
        std::array<Ring, 4> w{};
        for (int j = 0; j <= k_; ++j) w[j] = in_ring(scale, x.numbers[j]);
        return w;
      };
      const std::array<Ring, 4> v = weights(left_, scales_[0]), w = weights(right_, scales_[1]);
      switch (question_) {
      case Join_question::g2: return rational_factors<Join_question::g2>(v, w);
      case Join_question::g3: return rational_factors<Join_question::g3>(v, w);
      case Join_question::f3: return rational_factors<Join_question::f3>(v, w);
      case Join_question::torsion: return rational_factors<Join_question::torsion>(v, w);
      default: return rational_factors<Join_question::curvature_vector>(v, w);
      }
    } else
      return Join_weights<Ring>::geometric(question_, left_.degree, right_.degree);
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

  // Calls decide with differences, of which the first coordinate of the first on the left is not zero unless the question is
  // parametric, and with factors. \pre no tangent vanishes
  template <class Ring, class Function, class Decide> auto operator()(Function in_ring, Decide decide) const {
    const Differences<Ring, N> a = differences<Ring>(left_, true, in_ring),
                               b = differences<Ring>(right_, false, in_ring);
    if constexpr (!weighted)
      if (is_parametric(question_)) return decide(a, b, parametric_factors<Ring>(in_ring));
    return decide(a, b, factors<Ring>(in_ring));
  }
  struct Numerator {
    typename Scale::Ring operator()(const Scale& scale, const Number& x) const { return scale.numerator(x); }
  };
  template <class Decide> auto exactly(Decide decide) const {
    return operator()<typename Scale::Ring>(Numerator(), decide);
  }
};

// The equations in exact numbers. What several questions ask is one function for all of them.
template <class T, int N, class Weights> class Exact_equations : Join_equations<T, N, Weights, Exact_zero<T>> {
  typedef Join_equations<T, N, Weights, Exact_zero<T>> Base;

public:
  using Base::Base;
  using Base::both_have_curvature;
  using Base::curvature_vectors_equal;
  using Base::dimension;
  using Base::f3;
  using Base::g3;
  using Base::parametric;
  using Base::ratio;
  using Base::torsions_equal;
  BOOST_NOINLINE bool tangents_parallel() const { return Base::tangents_parallel(); }
  BOOST_NOINLINE bool g2(const Join_ratio<T>& r) const { return Base::g2(r); }
  template <int k> BOOST_NOINLINE bool derivatives_equal() const { return Base::template derivatives_equal<k>(); }
};

template <class T, std::size_t N, class Weights>
Join_answer decide_equations(Join_question question, const std::array<std::array<T, N>, 3>& a,
                             const std::array<std::array<T, N>, 3>& b, const Weights& w) {
  Exact_zero<T> zero;
  const Exact_equations<T, static_cast<int>(N), Weights> equations(a, b, w, zero);
  if constexpr (!Weights::parametric) {
    if (is_geometric(question) &&
        ((T(0) < a[0][0]) != (T(0) < b[0][0]) || b[0][0] == T(0) || !equations.tangents_parallel()))
      return Join_answer::no;
    if constexpr (N == 3)
      if (question == Join_question::torsion && !equations.both_have_curvature()) return Join_answer::undefined;
  }
  return equations_hold(question, equations, equations.ratio()) ? Join_answer::yes : Join_answer::no;
}

// The answer, by residues of doubles where these refute, and by whole numbers or the numbers of the field. The ends need
// positive weights if they are asked for them.
template <int N, bool weighted, class Scale, class Left, class Right, class Stages>
BOOST_NOINLINE Join_answer decide_in_ring(Join_question question, const Left& left, const Right& right,
                                          Stages& stages) {
  const Ring_join<N, weighted, Scale> join(question, left, right);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  if (join.tangents_vanish())
    return decided(Join_stage::multiprecision, is_geometric(question) ? Join_answer::no : Join_answer::undefined);
#ifdef CGAL_USE_GMP
  if constexpr (std::is_same_v<Scale, Binary_scale>)
    if (stages.uses(Join_stage::residue)) {
      const auto residue = [](const Scale& scale, const typename Scale::Number& x) { return scale.residue(x); };
      const bool may_hold =
          join.template operator()<std::uint64_t>(residue, [question](const auto& a, const auto& b, const auto& w) {
            typedef std::decay_t<decltype(w)> Weights;
            Residue_zero zero;
            const Join_equations<std::uint64_t, N, Weights, Residue_zero> equations(a, b, w, zero);
            return all_hold(question, equations);
          });
      if (!may_hold) return decided(Join_stage::residue, Join_answer::no);
    }
#endif
  return decided(Join_stage::multiprecision, join.exactly([question](const auto& a, const auto& b, const auto& w) {
    return decide_equations(question, a, b, w);
  }));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H
