// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/internal/Degree_factors.h>
#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_equations.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_ladder.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/Remainder.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>
#ifndef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#endif

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

/// \file decide_in_ring.h
/// The last stage of the ladder: the equations of a join in a ring, for numbers of any length,
/// which are multiplied by their common denominator, so that no fraction is cancelled. The ring is
/// that of the numerators of an exact field; for floating-point numbers those of the remainders by
/// as many moduli as prove that a form is zero (Remainder.h).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
typedef Remainder_scale Join_scale_of_doubles;
#else
typedef Field_scale<Exact_field_of<double>::type> Join_scale_of_doubles;
#endif

// The differences of the orders up to k of one coordinate of an end, because numbers of an exact
// field are long to compile.
template <bool weighted, class T>
BOOST_NOINLINE std::array<T, 3> differences_along(const std::array<T, 4>& x, int k, bool left, int degree) {
  std::array<T, 3> d{T(x[1] - x[0]), T(0), T(0)};
  if constexpr (weighted) {
    if (k >= 2) d[1] = T(x[2] - x[0]);
    if (k >= 3) d[2] = T(x[3] - x[0]);
  } else if (k >= 2 && degree >= 2) {
    const T difference(x[2] - x[1]);
    d[1] = T(difference - d[0]);
    if (k >= 3 && degree >= 3) d[2] = T(T(T(x[3] - x[2]) - difference) - d[1]);
  }
  if (left) {
    d[0] = T(T(0) - d[0]);
    d[2] = T(T(0) - d[2]);
  }
  return d;
}

// A form of this degree is less than 2 to this power, if the coordinates, the degrees of the
// curves, and the weights on either side or the ends of the domains have so many bits. The
// differences of the orders 1 to 3 are less than 2, 4 and 8 times the coordinates, and a form is
// the sum of so few of their products that 24 bits more than these suffice. The factors are
// products of at most four degrees, and 3, of weights, and of lengths of the domains.
template <Join_question question, bool weighted>
constexpr int bits_of_form(int form_degree, int coordinates, int degrees, int first_numbers, int second_numbers) {
  int factors = 4 * degrees + 2;
  if constexpr (is_parametric(question))
    factors += highest_difference(question) * (first_numbers + 1);
  else if constexpr (weighted) {
    typedef Weighted_degree_factors<question, int> Weights;
    factors += Weights::left_degree(question) * first_numbers + Weights::right_degree(question) * second_numbers;
  }
  return form_degree * coordinates + factors + 24;
}

// The numbers of two ends that a question needs: points, weights, or for the orders C the ends of
// the domains. One class for all questions, because most programs come here seldom, and all of them
// compile it.
template <int N, bool weighted, class Scale> class Ring_join {
public:
  typedef typename Scale::Ring Ring;

private:
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

  // The first coordinate in which the end points of an end and the next ones differ; N if there is
  // none.
  static int first_difference(const End& x) {
    int i = 0;
    while (i < N && x.points[0][i] == x.points[1][i]) ++i;
    return i;
  }

  // Returns the differences with the coordinates from the pivot on.
  BOOST_NOINLINE Differences<Ring, N> differences(const End& x, bool left) const {
    Differences<Ring, N> d;
    for (int i = 0; i < N; ++i) {
      std::array<Ring, 4> y{};
      for (int j = 0; j <= k_; ++j) y[j] = points_.numerator(x.points[j][(pivot_ + i) % N]);
      std::array<Ring, 3> z = differences_along<weighted>(y, k_, left, x.degree);
      for (int j = 0; j < k_; ++j) d[j][i] = std::move(z[j]);
    }
    return d;
  }
  Ring length(const End& x) const {
    return Ring(scales_[0].numerator(x.numbers[1]) - scales_[0].numerator(x.numbers[0]));
  }
  std::array<Ring, 4> weights(const End& x, const Scale& scale) const {
    std::array<Ring, 4> w{};
    for (int j = 0; j <= k_; ++j) w[j] = scale.numerator(x.numbers[j]);
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

  // Returns by how many moduli the remainders of a form must be zero so that it is.
  template <Join_question question> int moduli(int form_degree = internal::form_degree(question)) const {
    const int digits = 64 - leading_zero_bits(static_cast<std::uint64_t>((std::max)(left_.degree, right_.degree) | 1));
    return Scale::moduli(
        bits_of_form<question, weighted>(form_degree, points_.bits(), digits, scales_[0].bits(), scales_[1].bits()));
  }
  void take_modulus(int i) {
    points_.take_modulus(i);
    for (Scale& scale : scales_) scale.take_modulus(i);
  }

  // The first coordinate of the first one on the left is not zero unless the question is
  // parametric. \pre no tangent vanishes
  Differences<Ring, N> left() const { return differences(left_, true); }
  Differences<Ring, N> right() const { return differences(right_, false); }

  // Returns the factors of ends with weights, in one type for all questions. \pre the question is
  // the one of the object
  template <Join_question question> auto factors() const {
    if constexpr (is_parametric(question))
      return Parametric_degree_factors<Ring>::of(left_.degree, right_.degree, length(left_), length(right_));
    else if constexpr (weighted) {
      const auto w = Weighted_degree_factors<question, Ring>::of(weights(left_, scales_[0]), left_.degree,
                                                                 weights(right_, scales_[1]), right_.degree);
      return Weighted_degree_factors<Join_question::g3, Ring>{w.a2, w.b2, w.first, w.a3, w.b3, w.mix};
    } else
      return Degree_factors<Ring>::template geometric<question>(left_.degree, right_.degree, points_.one());
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

// Evaluates the equations in the ring of an exact field, or modulo one number, where `no` is a
// proof. `curved` means that the join has been proved to have curvature, for the torsion and,
// modulo a number, for F3, where `unknown` stands for `no` if the left end is straight.
template <Join_question question, int N, bool exact, class Join>
Join_answer answer_in(const Join& join, std::array<bool, 2>& curved) {
  typedef typename Join::Ring Ring;
  const Differences<Ring, N> a = join.left(), b = join.right();
  const auto w = join.template factors<question>();
  Exact_zero<Ring> zero;
  const Ring_equations<Ring, N, std::decay_t<decltype(w)>, Exact_zero<Ring>> equations(a, b, w, zero);
  if constexpr (exact && is_geometric(question))
    if ((Ring(0) < a[0][0]) != (Ring(0) < b[0][0]) || b[0][0] == Ring(0)) return Join_answer::no;
  if constexpr (question == Join_question::torsion || (question == Join_question::f3 && !exact)) {
    const bool is_curved = equations.left_has_curvature();
    curved[0] |= is_curved;
    if constexpr (question == Join_question::torsion)
      curved[1] |= equations.right_has_curvature();
    else if (!is_curved && all_hold<Join_question::g2>(equations) && !equations.f3(equations.ratio()))
      return Join_answer::unknown;
  }
  return all_hold<question>(equations) ? Join_answer::yes : Join_answer::no;
}

// The answer by numbers of any length. The ends need positive weights if they are asked for them.
// \pre decide_by_signs() has not answered, if the numbers are of floating-point type
template <Join_question question, int N, bool weighted, class Scale, class Left, class Right, class Stages>
BOOST_NOINLINE Join_answer decide_in_ring(const Left& left, const Right& right, Stages& stages) {
  Ring_join<N, weighted, Scale> join(question, left, right);
  const auto decided = [&](Stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  if constexpr (Scale::exact)
    if (join.tangents_vanish())
      return decided(Stage::multiprecision, is_geometric(question) ? Join_answer::no : Join_answer::undefined);
  std::array<bool, 2> curved{};
  bool straight_fails = false;
  const int moduli = join.template moduli<question>();
  for (int i = 0; i < moduli; ++i) {
    join.take_modulus(i);
    const Join_answer answer = answer_in<question, N, Scale::exact>(join, curved);
    if (answer == Join_answer::no) {
      const bool residue = !Scale::exact && i == 0 && stages.uses(Stage::residue);
      return decided(residue ? Stage::residue : Stage::multiprecision, Join_answer::no);
    }
    straight_fails |= answer == Join_answer::unknown;
  }
  if constexpr (question == Join_question::torsion)
    if (!curved[0] || !curved[1]) return decided(Stage::multiprecision, Join_answer::undefined);
  return decided(Stage::multiprecision, straight_fails && !curved[0] ? Join_answer::no : Join_answer::yes);
}

// The answer on two ends with double coordinates: by all stages, of which the last one reads the
// ends again. \pre as above
template <class Input, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_doubles(const Input& join, const Left& left, const Right& right,
                                                  Stages& stages) {
  const Join_answer answer = decide_by_stages(join, stages);
  if (answer != Join_answer::unknown) return answer;
  return decide_in_ring<Input::question, Input::dimension, Input::weighted, Join_scale_of_doubles>(left, right, stages);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_IN_RING_H
