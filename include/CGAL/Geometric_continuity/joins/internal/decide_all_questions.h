// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_ALL_QUESTIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_ALL_QUESTIONS_H

#include <CGAL/Geometric_continuity/joins/internal/Join_ladder.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_in_ring.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

/// \file decide_all_questions.h
/// The verdict of continuity(), from the answers to single questions by the ladder about two ends
/// that are read once.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// |a1 x a2|^2 times the square of the weight, and g = |a1|^2, from two first differences of an end,
// or from its first two differences.
template <class T, std::size_t N>
T square_of_area(const std::array<std::array<T, N>, 3>& differences, const T& weight, T& g) {
  T area(0);
  g = T(0);
  for (std::size_t i = 0; i < N; ++i) {
    g = T(g + T(differences[0][i] * differences[0][i]));
    for (std::size_t j = 0; j < i; ++j) {
      const T x = T(differences[0][i] * differences[1][j]) - T(differences[0][j] * differences[1][i]);
      area = T(area + T(x * x));
    }
  }
  return T(area * T(weight * weight));
}

// The two sides of |a1 x a2|^2 |b1|^6 = |b1 x b2|^2 |a1|^6 (for equal degrees): the curvatures have
// one magnitude.
template <class T, std::size_t N>
std::array<T, 2> curvature_forms(const std::array<std::array<T, N>, 3>& left,
                                 const std::array<std::array<T, N>, 3>& right, const T& left_weight,
                                 const T& right_weight) {
  T g, h;
  const T a = square_of_area(left, left_weight, g), b = square_of_area(right, right_weight, h);
  return {T(a * T(h * T(h * h))), T(b * T(g * T(g * g)))};
}

// Returns whether the curvatures have different magnitudes, modulo 2^64 for first differences on
// the left in units of 2^units to those on the right. Only `true` is a proof, as below.
template <int N>
bool curvatures_differ(const First_differences<std::int64_t, N>& left, const First_differences<std::int64_t, N>& right,
                       const Degree_factors<std::int64_t>& w, int units) {
  typedef std::uint64_t Residue;
  const auto [a, b] = curvature_forms(converted<2, Residue>(left), converted<2, Residue>(right),
                                      static_cast<Residue>(w.a2), static_cast<Residue>(w.b2));
  return units < 0 ? (a << -2 * units) != b : a != (b << 2 * units);
}
template <int N> bool curvatures_differ(const Integer_end<N>& left, const Integer_end<N>& right) {
  const Degree_factors<std::int64_t> w =
      Degree_factors<std::int64_t>::geometric<Join_question::g2>(left.degree(), right.degree());
  return curvatures_differ<N>(left.first_differences(), right.first_differences(), w, 0);
}
// Decides on grids, or in interval arithmetic.
template <int N> bool curvatures_differ(const Double_end<N>& left, const Double_end<N>& right) {
  if (!degrees_fit(left.degree(), right.degree())) return false;
  const Degree_factors<std::int64_t> w =
      Degree_factors<std::int64_t>::geometric<Join_question::g2>(left.degree(), right.degree());
  const Grid_differences<N> x = grid_differences_of<2>(left.points()), y = grid_differences_of<2>(right.points());
  // the left first differences are in units of 2^units
  const int units = x.exponent + x.zeros - y.exponent - y.zeros;
  if (x.valid && y.valid && -14 <= units && units <= 14 &&
      curvatures_differ<N>(without_zeros<2>(x.differences, x.zeros), without_zeros<2>(y.differences, y.zeros), w,
                           units))
    return true;
  typedef Interval_nt<false> Interval;
  const Interval::Protector rounding;
  const auto differences = [](const End_polygon<double, N>& points) {
    End_polygon<Interval, N> intervals;
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i < N; ++i) intervals[j][i] = Interval(points[j][i]);
    return first_differences<2>(intervals);
  };
  const auto [a, b] = curvature_forms(differences(left.points()), differences(right.points()),
                                      Interval(static_cast<double>(w.a2)), Interval(static_cast<double>(w.b2)));
  return !a.do_overlap(b);
}
// Decides by numbers of any length. \pre no tangent vanishes
template <int N> BOOST_NOINLINE bool curvatures_are_equal(const Double_end<N>& left, const Double_end<N>& right) {
  constexpr Join_question question = Join_question::g2;
  Ring_join<N, false, Join_scale_of_doubles> join(question, left, right);
  const int moduli = join.template moduli<question>(10);
  for (int i = 0; i < moduli; ++i) {
    join.take_modulus(i);
    const auto w = join.template factors<question>();
    const auto [x, y] = curvature_forms(join.left(), join.right(), w.a2, w.b2);
    if (!(x == y)) return false;
  }
  return true;
}

// Returns whether a1 x a2 is not zero, from two first differences in space that have been rounded
// once. Only `true` is a proof.
inline bool is_curved(const First_differences<double, 3>& differences) {
  const double size = largest(differences[0]) * largest(differences[1]);
  return 0x1p-900 <= size && size <= 0x1p900 && largest(cross_form(differences[0], differences[1])) > 0x1p-49 * size;
}
// unreachable: asked for in space only
inline bool is_curved(const First_differences<double, 2>&) { return false; }

// The extent of a decision: everything, the orders, or what is left when the orders, up to 2 or 3,
// are known.
enum class Join_asked { all, orders, flags };

// Everything that Join_continuity says but the shape parameters, for a join in the plane or in
// space and orders up to 3; if only the orders are wanted, the flags are left as they are where
// they are not decided by the way. `Questions` answers questions about the two ends. Returns false
// when some of it needs multi-precision numbers; then `join` is unspecified.
template <class Questions, class Result>
bool decide_all_questions(const Questions& questions, int max_order, Result& join, Join_asked asked) {
  constexpr int N = Questions::dimension;
  bool unknown = false;
  // nothing is asked any more once one answer has been unknown
  const auto holds = [&](auto question) {
    if (unknown) return false;
    const Join_answer answer = questions.template decide<decltype(question)::value>();
    unknown = answer == Join_answer::unknown;
    return answer == Join_answer::yes;
  };
  int contact = 0; // of the curves, wherever their ends are
  join.regular = questions.regular();
  const bool meet = questions.ends_meet(), is_known = asked == Join_asked::flags && meet,
             only_orders = asked == Join_asked::orders;
  // C^k is asked first, since it costs least, and curves that are regular and C^k are G^k
  if (meet && !is_known) {
    join.c_order = join.g_order = join.f_order = 0;
    if (max_order >= 1 && holds(Question<Join_question::c1>())) {
      join.c_order = 1;
      if (max_order >= 3 && holds(Question<Join_question::c3>()))
        join.c_order = 3;
      else if (max_order >= 2 && holds(Question<Join_question::c2>()))
        join.c_order = 2;
    }
  }
  if (join.regular && (meet || !only_orders)) {
    if (is_known)
      contact = join.g_order;
    else if (max_order >= 3 && (join.c_order == 3 || holds(Question<Join_question::g3>())))
      contact = 3;
    else
      contact = join.c_order >= 2 || holds(Question<Join_question::g2>())   ? 2
                : join.c_order == 1 || holds(Question<Join_question::g1>()) ? 1
                                                                            : 0;
    join.tangent_equal = contact >= 1;
  }
  // The third derivatives with respect to arc length agree, so torsions do where there is
  // curvature.
  const bool torsions_agree = N == 3 && contact == 3 && questions.is_curved();
  if (join.regular && !only_orders) {
    join.curvature_vector_equal = contact >= 2 || (contact == 0 && holds(Question<Join_question::curvature_vector>()));
    join.curvature_equal = *join.curvature_vector_equal;
    if (!unknown && !*join.curvature_vector_equal) {
      const Join_answer answer = questions.equal_curvatures();
      unknown = answer == Join_answer::unknown;
      join.curvature_equal = answer == Join_answer::yes;
    }
    if constexpr (N == 3) {
      if (unknown) return false;
      if (torsions_agree)
        join.torsion_equal = true;
      else {
        const Join_answer answer = questions.template decide<Join_question::torsion>();
        if (answer == Join_answer::unknown) return false;
        if (answer != Join_answer::undefined) join.torsion_equal = answer == Join_answer::yes;
      }
    }
  }
  if (unknown) return false;
  if (meet && contact >= 1 && max_order >= 1) {
    join.g_order = (std::min)(contact, max_order);
    join.f_order = (std::min)(join.g_order, 2);
    if constexpr (N == 3)
      if (join.f_order == 2 && max_order >= 3 &&
          (join.c_order == 3 || torsions_agree ||
           (join.torsion_equal ? *join.torsion_equal : holds(Question<Join_question::f3>()))))
        join.f_order = 3;
  }
  return !unknown;
}

// The join of two ends that are read once.
template <int N> class Double_ends {
  Double_end<N> left_, right_;
  bool meet_;
  Short_lengths lengths_; // which nobody asks for where the ends do not meet

public:
  static constexpr int dimension = N;

  template <class Left, class Right>
  Double_ends(const Left& left, const Right& right) : Double_ends(left, right, pivot_of<N>(left)) {}
  template <class Left, class Right>
  Double_ends(const Left& left, const Right& right, int pivot)
      : left_(left, pivot), right_(right, pivot), meet_(left_.points()[0] == right_.points()[0]) {
    if (meet_) lengths_ = Short_lengths(left_.domain(), right_.domain());
  }

  const Double_end<N>& left() const { return left_; }
  const Double_end<N>& right() const { return right_; }

  bool regular() const { return left_.points()[0] != left_.points()[1] && right_.points()[0] != right_.points()[1]; }
  bool ends_meet() const { return meet_; }
  template <Join_question question> Join_answer decide() const {
    const All_stages stages;
    return decide_on_doubles(Double_join<question, N>(left_, right_, lengths_), left_, right_, stages);
  }
  Join_answer equal_curvatures() const {
    return !curvatures_differ<N>(left_, right_) && curvatures_are_equal<N>(left_, right_) ? Join_answer::yes
                                                                                          : Join_answer::no;
  }
  bool is_curved() const { return internal::is_curved(left_.first_differences()); }
};

// The shape parameters of such a join, which are to be computed when someone asks for them.
template <class FT, int N> Join_parameters<FT> parameters_of(const Double_end<N>& left, const Double_end<N>& right) {
  const int i = largest_coordinate(internal::minus(left.points()[1], left.points()[0]));
  const auto along = [i](const Double_end<N>& end) {
    const auto& x = end.points();
    return Parameter_end{{x[0][i], x[1][i], x[2][i], x[3][i]}, end.domain().first, end.domain().second, end.degree()};
  };
  return Join_parameters<FT>(along(left), along(right));
}
template <class FT, int N> Join_parameters<FT> parameters_of(const Integer_end<N>& left, const Integer_end<N>& right) {
  const int i = largest_coordinate(internal::minus(left.points()[1], left.points()[0]));
  const auto along = [i](const Integer_end<N>& end) {
    Parameter_end result{{}, 0, static_cast<double>(end.length()), end.degree()};
    for (int j = 0; j <= 3; ++j) {
      const std::int64_t x = end.points()[j][i];
      result.points[j] = static_cast<double>(x);
      result.rests[j] = static_cast<double>(x - static_cast<std::int64_t>(result.points[j]));
    }
    return result;
  };
  return Join_parameters<FT>(along(left), along(right));
}

// Everything that Join_continuity says, for two ends with double coordinates and orders up to 3;
// see decide_all_questions().
template <int N, class Result>
void decide_all_on_doubles(const Double_ends<N>& ends, int max_order, Result& join, Join_asked asked) {
  decide_all_questions(ends, max_order, join, asked);
  if (join.g_order >= 1 && asked != Join_asked::orders)
    join.parameters = parameters_of<typename Result::Number, N>(ends.left(), ends.right());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_ALL_QUESTIONS_H
