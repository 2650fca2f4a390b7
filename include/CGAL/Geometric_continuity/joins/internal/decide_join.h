// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_JOIN_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_decision.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_equations.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_doubles.h>
#include <CGAL/Geometric_continuity/joins/internal/rational_join_in_ring.h>
#include <CGAL/Geometric_continuity/joins/internal/rational_join_on_doubles.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <boost/config.hpp>

#include <algorithm>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Whether the question is about the points as well.
constexpr bool asks_for_contact(Join_question question) { return is_parametric(question) || is_geometric(question); }

template <class Left, class Right> void check_dimensions(const Left& left, const Right& right) {
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "join of two curves");
}

template <class Left, class Right> CGAL_GC_FORCEINLINE bool ends_meet(const Left& left, const Right& right) {
  for (int i = 0; i < left.dimension(); ++i)
    if (left.coordinate(0, i) != right.coordinate(0, i)) return false;
  return true;
}

// In dimension 2 and 3: the equations in the ring of the common denominators.
template <Join_question question, int N, class Left, class Right>
Join_answer decide_in_ring(const Left& left, const Right& right) {
  typedef Join_field<Left> Field;
  typedef typename Common_denominator<Field>::Ring Ring;
  constexpr int k = highest_difference(question);
  const int m = left.degree(), n = right.degree();
  const auto points = [](const auto& end) {
    End_polygon<Field, N> x;
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < N; ++i) x[j][i] = to_field<Field>(end.coordinate((std::min)(j, end.degree()), i));
    return x;
  };
  const End_polygon<Field, N> p = points(left), q = points(right);
  Common_denominator<Field> scale;
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i < N; ++i) {
      scale.include(p[j][i]);
      scale.include(q[j][i]);
    }
  End_polygon<Ring, N> x, y;
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i < N; ++i) {
      x[j][i] = scale.numerator(p[j][i]);
      y[j][i] = scale.numerator(q[j][i]);
    }
  const Legs<Ring, N> legs_x = legs_of<k>(x), legs_y = legs_of<k>(y);
  const int pivot = is_parametric(question) ? 0 : first_nonzero(legs_x[0]);
  if (!is_parametric(question) && (pivot == N || first_nonzero(legs_y[0]) == N))
    return is_geometric(question) ? Join_answer::no : Join_answer::undefined;
  const Differences<Ring, N> a = differences_of<k, true>(rotated<k>(legs_x, pivot), m),
                             b = differences_of<k, false>(rotated<k>(legs_y, pivot), n);

  Join_weights_of<question, Ring> w;
  if constexpr (is_parametric(question)) {
    const Field h = to_field<Field>(left.domain().second) - to_field<Field>(left.domain().first),
                l = to_field<Field>(right.domain().second) - to_field<Field>(right.domain().first);
    Common_denominator<Field> lengths;
    lengths.include(h);
    lengths.include(l);
    w = Parametric_join_weights<Ring>::of(m, n, lengths.numerator(h), lengths.numerator(l));
  } else
    w = Join_weights<Ring>::template geometric<question>(m, n);
  return decide_equations<question>(a, b, w);
}

// From jets of order 3, that the ends meet included.
template <Join_question question, class Field, int N>
Join_answer decide_on_jets(const Coordinate_jet<Field, N>& x, const Coordinate_jet<Field, N>& y) {
  const Join_continuity<Field> join = Join_decision<Field, N>(x, y, 3)();
  const auto answer = [](bool holds) { return holds ? Join_answer::yes : Join_answer::no; };
  const auto optional = [](const std::optional<bool>& b) {
    return !b ? Join_answer::undefined : *b ? Join_answer::yes : Join_answer::no;
  };
  switch (question) {
  case Join_question::curvature_vector: return optional(join.curvature_vector_equal);
  case Join_question::torsion: return optional(join.torsion_equal);
  case Join_question::f3: return answer(join.f_order >= 3);
  default: return answer((is_parametric(question) ? join.c_order : join.g_order) >= highest_difference(question));
  }
}

// Where the question has an answer by definition: in the plane the order F ends with 2, and there is no torsion.
template <Join_question question, int N>
constexpr bool planar_by_definition = N == 2 && (question == Join_question::f3 || question == Join_question::torsion);

// In multi-precision, or in the field of an exact kernel. \pre the ends meet, if the question asks for contact
template <Join_question question, class Left, class Right, class Stages>
BOOST_NOINLINE Join_answer decide_exactly(const Left& left, const Right& right, Stages& stages) {
  constexpr int N = dimension_v<typename Left::Traits>;
  Join_answer answer;
  if constexpr (planar_by_definition<question, N>)
    answer = question == Join_question::f3 ? Join_answer::no : Join_answer::undefined;
  else if constexpr (N == 2 || N == 3)
    answer = decide_in_ring<question, N>(left, right);
  else
    answer = decide_on_jets<question>(jet_of_polygon<Join_field<Left>, Curve_end::end>(left, 3),
                                      jet_of_polygon<Join_field<Right>, Curve_end::start>(right, 3));
  stages.decided(Join_stage::multiprecision, answer);
  return answer;
}

// All stages on control points. \pre the ends meet, if the question asks for contact
template <Join_question question, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_legs(const Left& left, const Right& right, Stages& stages) {
  typedef typename Left::Traits Traits;
  constexpr int N = dimension_v<Traits>;
  if constexpr (is_double<typename Traits::FT> && (N == 2 || N == 3) && !planar_by_definition<question, N>) {
    const Join_answer answer = decide_on_doubles<question, N>(left, right, stages);
    if (answer != Join_answer::unknown) return answer;
  }
  return decide_exactly<question>(left, right, stages);
}

// The decision on two ends that are given by control points.
template <Join_question question, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_polygons(const Left& left, const Right& right, Stages& stages) {
  static_assert(std::is_same_v<typename Left::Traits, typename Right::Traits>,
                "both curves must have the same traits class");
  check_dimensions(left, right);
  if constexpr (asks_for_contact(question))
    if (!ends_meet(left, right)) {
      stages.decided(Join_stage::comparison, Join_answer::no);
      return Join_answer::no;
    }
  if constexpr (question == Join_question::c0) {
    stages.decided(Join_stage::comparison, Join_answer::yes);
    return Join_answer::yes;
  } else
    return decide_legs<question>(left, right, stages);
}

// The decision on two ends with positive weights, or `unknown` where the question is left to the jets. Tangents do not depend on the
// weights; into what is of higher order they enter by Rational_join_weights.
template <Join_question question, class Left, class Right, class Stages>
Join_answer decide_weighted_polygons(const Left& left, const Right& right, Stages& stages) {
  typedef typename Left::Traits Traits;
  constexpr int N = dimension_v<Traits>;
  check_dimensions(left, right);
  if constexpr (asks_for_contact(question))
    if (!ends_meet(left, right)) {
      stages.decided(Join_stage::comparison, Join_answer::no);
      return Join_answer::no;
    }
  if constexpr (question == Join_question::c0) {
    stages.decided(Join_stage::comparison, Join_answer::yes);
    return Join_answer::yes;
  } else if constexpr (!(N == 2 || N == 3))
    return Join_answer::unknown;
  else if constexpr (is_parametric(question)) {
    if constexpr (is_double<typename Traits::FT>)
      if (stages.uses(Join_stage::floating_point) && rational_first_derivatives_differ<N>(left, right)) {
        stages.decided(Join_stage::floating_point, Join_answer::no);
        return Join_answer::no;
      }
    return Join_answer::unknown;
  } else if constexpr (question == Join_question::g1 || planar_by_definition<question, N>)
    return decide_legs<question>(left, right, stages);
  else {
    if constexpr (is_double<typename Traits::FT>) {
      const Join_answer answer = decide_rational_on_doubles<question, N>(left, right, stages);
      if (answer != Join_answer::unknown) return answer;
    }
    return decide_rational_exactly<question, N>(left, right, stages);
  }
}

// The decision on two curves: on control points where both curves have them, or on control points with weights, otherwise on jets in
// an exact field.
template <Join_question question, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_join(const Left& left, const Right& right, Stages& stages) {
  static_assert(std::is_same_v<typename Left::Traits, typename Right::Traits>,
                "both curves must have the same traits class");
  if constexpr (Curve_ends<Left>::have_polygons && Curve_ends<Right>::have_polygons)
    if (has_polygon(left, Curve_end::end) && has_polygon(right, Curve_end::start)) {
      const Curve_end_view<Left, Curve_end::end> x(left);
      const Curve_end_view<Right, Curve_end::start> y(right);
      return decide_polygons<question>(x, y, stages);
    }
  if constexpr (Curve_ends<Left>::have_polygons && Curve_ends<Right>::have_polygons &&
                (Has_weights<Left>::value || Has_weights<Right>::value))
    if (has_weighted_polygon(left, Curve_end::end) && has_weighted_polygon(right, Curve_end::start)) {
      const Curve_end_view<Left, Curve_end::end> x(left);
      const Curve_end_view<Right, Curve_end::start> y(right);
      const Join_answer answer = decide_weighted_polygons<question>(x, y, stages);
      if (answer != Join_answer::unknown) return answer;
    }
  typedef typename Exact_field<Predicate_FT<typename Left::Traits>>::type Field;
  const Join_answer answer =
      decide_on_jets<question>(jet_at<Field, Curve_end::end>(left, 3), jet_at<Field, Curve_end::start>(right, 3));
  stages.decided(Join_stage::multiprecision, answer);
  return answer;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_JOIN_H
