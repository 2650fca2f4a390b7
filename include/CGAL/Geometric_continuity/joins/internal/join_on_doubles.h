// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_DOUBLES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_DOUBLES_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_parameters.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_integers.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Numbers that become doubles without rounding.
template <class FT> constexpr bool is_double = std::is_floating_point_v<FT> && sizeof(FT) <= sizeof(double);

// Two numbers of at most 1024 that are as the lengths of two domains, if the ends of these are multiples of 2^-20 up to 2^20.
// Otherwise returns false.
inline bool short_lengths(const std::pair<double, double>& left, const std::pair<double, double>& right, int& h,
                          int& l) {
  const auto in_units = [](double x) { return static_cast<std::int64_t>(x * 0x1p20); };
  for (const double x : {left.first, left.second, right.first, right.second})
    if (!(std::abs(x) <= 0x1p20) || x * 0x1p20 != static_cast<double>(in_units(x))) return false;
  const std::int64_t first = in_units(left.second) - in_units(left.first),
                     second = in_units(right.second) - in_units(right.first);
  const int zeros = trailing_zeros(first | second);
  if ((first >> zeros) > 1024 || (second >> zeros) > 1024) return false;
  h = static_cast<int>(first >> zeros);
  l = static_cast<int>(second >> zeros);
  return true;
}

// Whether m l a1 and n h b1, to which the first derivatives are proportional, differ by more than their rounding errors, for
// domains of any lengths h and l. Each number is rounded four times.
template <int N>
bool first_derivatives_differ(const std::array<double, N>& a1, int m, const std::pair<double, double>& left,
                              const std::array<double, N>& b1, int n, const std::pair<double, double>& right) {
  const double h = left.second - left.first, l = right.second - right.first;
  if (!(0x1p-500 <= (std::min)(h, l))) return false;
  for (int i = 0; i < N; ++i) {
    const double x = -(m * l) * a1[i], y = (n * h) * b1[i], size = std::abs(x) + std::abs(y); // a1 points inwards
    if (0x1p-500 <= size && std::abs(x - y) > 0x1p-48 * size) return true;
  }
  return false;
}

// The end of a curve with double coordinates, or its start, as given. `Points` is something with degree(), domain() and
// coordinate(j, i).
template <int k, int N, class Points> CGAL_GC_FORCEINLINE End_polygon<double, N> points_of(const Points& end) {
  const int m = end.degree();
  const auto point = [&](int j) -> std::array<double, N> {
    if constexpr (N == 2)
      return {end.coordinate(j, 0), end.coordinate(j, 1)};
    else
      return {end.coordinate(j, 0), end.coordinate(j, 1), end.coordinate(j, 2)};
  };
  if constexpr (k == 0)
    return {point(0)};
  else if constexpr (k == 1)
    return {point(0), point((std::min)(m, 1))};
  else if constexpr (k == 2)
    return {point(0), point((std::min)(m, 1)), point((std::min)(m, 2))};
  else
    return {point(0), point((std::min)(m, 1)), point((std::min)(m, 2)), point((std::min)(m, 3))};
}

// Whether all coordinates but one are zero.
template <std::size_t N> CGAL_GC_FORCEINLINE bool is_on_axis(const std::array<double, N>& x, int axis) {
  for (int i = 0; i < static_cast<int>(N); ++i)
    if (i != axis && x[static_cast<std::size_t>(i)] != 0) return false;
  return true;
}

// The decision by the signs of the first differences a1 and b1, of which the largest coordinate of a1 is the pivot, or `unknown`: the
// signs of rounded differences are exact.
template <Join_question question, std::size_t N>
CGAL_GC_FORCEINLINE Join_answer decide_by_signs(const std::array<double, N>& a1, const std::array<double, N>& b1,
                                                int pivot) {
  const double x = coordinate_at(a1, pivot), y = coordinate_at(b1, pivot);
  if (is_geometric(question)) return (x < 0 && y < 0) || (0 < x && 0 < y) ? Join_answer::unknown : Join_answer::no;
  return x == 0 || largest(b1) == 0 ? Join_answer::undefined : Join_answer::unknown;
}

// The decision on two ends with double coordinates, exact or `unknown`. That the ends meet is not asked here.
template <Join_question question, int N, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_doubles(const Left& left, const Right& right, Stages& stages) {
  constexpr int k = highest_difference(question);
  static_assert(k > 0, "the points are compared before");
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  const End_polygon<double, N> p = points_of<k, N>(left), q = points_of<k, N>(right);
  const int m = left.degree(), n = right.degree();
  if ((std::max)(m, n) > 1000) return Join_answer::unknown;
  const Legs<double, N> legs_a = legs_of<k>(p), legs_b = legs_of<k>(q);
  const int pivot = is_parametric(question) ? 0 : largest_coordinate(legs_a[0]);
  if constexpr (!is_parametric(question)) {
    const std::array<double, N> zero{};
    const Join_answer by_signs = decide_by_signs<question>(internal::minus(zero, legs_a[0]), legs_b[0], pivot);
    if (by_signs != Join_answer::unknown) return decided(Join_stage::comparison, by_signs);
  }
  if constexpr (question == Join_question::g1) // most tangents at smooth joins of drawings are horizontal or vertical
    if (is_on_axis(legs_a[0], pivot) && is_on_axis(legs_b[0], pivot))
      return decided(Join_stage::comparison, Join_answer::yes);

  Join_weights_of<question, std::int64_t> w;
  if constexpr (is_parametric(question)) {
    int h, l;
    if (!short_lengths(left.domain(), right.domain(), h, l)) {
      if (stages.uses(Join_stage::floating_point) &&
          first_derivatives_differ<N>(legs_a[0], m, left.domain(), legs_b[0], n, right.domain()))
        return decided(Join_stage::floating_point, Join_answer::no);
      return Join_answer::unknown;
    }
    w = Parametric_join_weights<std::int64_t>::of(m, n, h, l);
    if (!weights_fit<k>(w)) return Join_answer::unknown;
  } else
    w = Join_weights<std::int64_t>::template geometric<question>(m, n);

  if (stages.uses(Join_stage::floating_point)) {
    typedef Join_weights_of<question, double> Weights;
    typedef Join_filter<Weights> Filter;
    const Difference_bounds A = bounds_of_differences<k>(legs_a), B = bounds_of_differences<k>(legs_b);
    const Weights weights = converted<double>(w);
    const Filter filter{A, B, weights};
    if (filter.in_range()) {
      const Differences<double, N> a = differences_of<k, true>(legs_a, m), b = differences_of<k, false>(legs_b, n);
      const Join_equations<double, N, Weights, const Filter> equations(a, b, weights, filter, pivot);
      if (!all_hold<question>(equations)) return decided(Join_stage::floating_point, Join_answer::no);
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
      if (stages.uses(Join_stage::bounded_residue) && take_up<question>(w, 0)) {
        const auto no_unit = [](Join_question) { return 0; };
        const Join_answer answer =
            decide_modulo<question, N, Residue<residue_limbs(question)>>(p, q, a, b, pivot, w, filter, no_unit, stages);
        if (answer != Join_answer::unknown) return answer;
      }
#endif
    }
  }
  if (!stages.uses(Join_stage::fixed_integer)) return Join_answer::unknown;
  return decide_on_grid_legs<question, N>(grid_legs_of<k>(points_of<k, N>(left)), m,
                                          grid_legs_of<k>(points_of<k, N>(right)), n, pivot, w, stages);
}

// |a1 x a2|^2 times the square of the weight, and g = |a1|^2, from the legs of an end.
template <class T, int N> T square_of_area(const Legs<T, N>& legs, const T& weight, T& g) {
  T area(0);
  g = T(0);
  for (int i = 0; i < N; ++i) {
    g += T(legs[0][i] * legs[0][i]);
    for (int j = 0; j < i; ++j) {
      const T x = legs[0][i] * legs[1][j] - legs[0][j] * legs[1][i];
      area += T(x * x);
    }
  }
  return T(area * weight * weight);
}

// Whether the curvatures have different magnitudes: |a1 x a2|^2 |b1|^6 is not |b1 x b2|^2 |a1|^6 (for equal degrees), modulo
// 2^64 on grids or in interval arithmetic. Only `true` is a proof.
template <int N, class Left, class Right> bool curvatures_differ(const Left& left, const Right& right) {
  const Join_weights<std::int64_t> w =
      Join_weights<std::int64_t>::template geometric<Join_question::g2>(left.degree(), right.degree());
  const End_polygon<double, N> p = points_of<2, N>(left), q = points_of<2, N>(right);
  const Grid_legs<N> x = grid_legs_of<2>(p), y = grid_legs_of<2>(q);
  const int units = x.exponent + x.zeros - y.exponent - y.zeros; // the left legs are in units of 2^units
  if (x.valid && y.valid && -14 <= units && units <= 14) {
    typedef std::uint64_t Residue;
    Residue g, h;
    Residue a = square_of_area<Residue, N>(converted<2, Residue>(without_zeros<2>(x.legs, x.zeros)), w.a2, g),
            b = square_of_area<Residue, N>(converted<2, Residue>(without_zeros<2>(y.legs, y.zeros)), w.b2, h);
    a *= h * h * h;
    b *= g * g * g;
    if (units < 0 ? (a << -2 * units) != b : a != (b << 2 * units)) return true;
  }
  typedef Interval_nt<false> Interval;
  const Interval::Protector rounding;
  const auto legs = [](const End_polygon<double, N>& points) {
    End_polygon<Interval, N> x;
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i < N; ++i) x[j][i] = Interval(points[j][i]);
    return legs_of<2>(x);
  };
  Interval g, h;
  const Interval a = square_of_area<Interval, N>(legs(p), Interval(static_cast<double>(w.a2)), g),
                 b = square_of_area<Interval, N>(legs(q), Interval(static_cast<double>(w.b2)), h);
  return !Interval(a * h * h * h).do_overlap(Interval(b * g * g * g));
}

template <Join_question question> struct Question : std::integral_constant<Join_question, question> {};

// Everything that Join_continuity says but the shape parameters, for a join in the plane or in space and orders up to 3; if only the
// orders are wanted, the flags are left as they are where they are not decided by the way. `Questions` answers questions about the two
// ends. Returns false when some of it needs multi-precision numbers; then `join` is unspecified.
template <class Questions, class Result>
bool decide_all_questions(const Questions& questions, int max_order, Result& join, bool only_orders = false) {
  constexpr int N = Questions::dimension;
  bool unknown = false;
  const auto holds = [&](auto question) { // nothing is asked any more once one answer has been unknown
    if (unknown) return false;
    const Join_answer answer = questions.template decide<decltype(question)::value>();
    unknown = answer == Join_answer::unknown;
    return answer == Join_answer::yes;
  };
  int contact = 0; // of the curves, wherever their ends are
  join.regular = questions.regular();
  const bool meet = questions.ends_meet();
  if (meet) { // C^k is asked first, since it costs least, and curves that are regular and C^k are G^k
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
    if (max_order >= 3 && (join.c_order == 3 || holds(Question<Join_question::g3>())))
      contact = 3;
    else
      contact = join.c_order >= 2 || holds(Question<Join_question::g2>())   ? 2
                : join.c_order == 1 || holds(Question<Join_question::g1>()) ? 1
                                                                            : 0;
    join.tangent_equal = contact >= 1;
  }
  if (join.regular && !only_orders) {
    join.curvature_vector_equal = contact >= 2 || (contact == 0 && holds(Question<Join_question::curvature_vector>()));
    join.curvature_equal = *join.curvature_vector_equal;
    if (!*join.curvature_vector_equal && !questions.curvatures_differ()) return false;
    if constexpr (N == 3) {
      if (unknown) return false;
      const Join_answer answer = questions.template decide<Join_question::torsion>();
      if (answer == Join_answer::unknown) return false;
      if (answer != Join_answer::undefined) join.torsion_equal = answer == Join_answer::yes;
    }
  }
  if (unknown) return false;
  if (meet && contact >= 1 && max_order >= 1) {
    join.g_order = (std::min)(contact, max_order);
    join.f_order = (std::min)(join.g_order, 2);
    if constexpr (N == 3)
      if (join.f_order == 2 && max_order >= 3 &&
          (join.c_order == 3 || (join.torsion_equal ? *join.torsion_equal : holds(Question<Join_question::f3>()))))
        join.f_order = 3;
  }
  return !unknown;
}

// The join of two ends with double coordinates.
template <int N, class Left, class Right> struct Double_join {
  static constexpr int dimension = N;
  const Left& left;
  const Right& right;

  bool regular() const {
    const End_polygon<double, N> p = points_of<1, N>(left), q = points_of<1, N>(right);
    return p[0] != p[1] && q[0] != q[1];
  }
  bool ends_meet() const { return points_of<0, N>(left)[0] == points_of<0, N>(right)[0]; }
  template <Join_question question> Join_answer decide() const {
    const All_join_stages stages;
    return decide_on_doubles<question, N>(left, right, stages);
  }
  bool curvatures_differ() const { return internal::curvatures_differ<N>(left, right); }
};

// The shape parameters of such a join, which are to be computed when someone asks for them.
template <class FT, int N, class Left, class Right>
Join_parameters<FT> parameters_of(const Left& left, const Right& right) {
  const int i = largest_coordinate(legs_of<1>(points_of<1, N>(left))[0]);
  const auto along = [i](const auto& end) {
    const int m = end.degree();
    const auto [a, b] = end.domain();
    return Double_end{{end.coordinate(0, i), end.coordinate((std::min)(m, 1), i), end.coordinate((std::min)(m, 2), i),
                       end.coordinate((std::min)(m, 3), i)},
                      a,
                      b,
                      m};
  };
  return Join_parameters<FT>(along(left), along(right));
}

// Everything that Join_continuity says, for two ends with double coordinates and orders up to 3; see decide_all_questions().
template <int N, class Left, class Right, class Result>
bool decide_all_on_doubles(const Left& left, const Right& right, int max_order, Result& join,
                           bool only_orders = false) {
  if (!decide_all_questions(Double_join<N, Left, Right>{left, right}, max_order, join, only_orders)) return false;
  if (join.g_order >= 1 && !only_orders) join.parameters = parameters_of<typename Result::Number, N>(left, right);
  return true;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_DOUBLES_H
