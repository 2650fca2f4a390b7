// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_JOIN_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_decision.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_ladder.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_in_ring.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Returns whether the question is about the points as well.
// unreachable: computed by the compiler
constexpr bool requires_coincident_ends(Join_question question) {
  return is_parametric(question) || is_geometric(question);
}

template <class Left, class Right> void check_dimensions(const Left& left, const Right& right) {
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "join of two curves");
}

template <class Left, class Right> CGAL_GC_FORCEINLINE bool ends_meet(const Left& left, const Right& right) {
  for (int i = 0; i < left.dimension(); ++i)
    if (left.coordinate(0, i) != right.coordinate(0, i)) return false;
  return true;
}

// Decides from jets of order 3 also that the ends meet.
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

// Where the question has an answer by definition: in the plane the order F ends with 2, and there
// is no torsion.
template <Join_question question, int N>
constexpr bool planar_by_definition = N == 2 && (question == Join_question::f3 || question == Join_question::torsion);

// The field in which the join of two ends is decided, and how their numbers are read.
template <class End> using Join_field = typename Exact_field_of<Predicate_FT<typename End::Traits>>::type;
template <class End, bool doubles = is_double<typename End::Traits::FT>> struct Join_scale {
  typedef Field_scale<Join_field<End>> type;
};
// names no exact field
template <class End> struct Join_scale<End, true> { typedef Join_scale_of_doubles type; };

// Decides by numbers of any length. \pre the ends meet, if the question asks for contact
template <Join_question question, bool weighted = false, class Left, class Right, class Stages>
Join_answer decide_exactly(const Left& left, const Right& right, Stages& stages) {
  constexpr int N = dimension_v<typename Left::Traits>;
  if constexpr ((N == 2 || N == 3) && !planar_by_definition<question, N>)
    return decide_in_ring<question, N, weighted, typename Join_scale<Left>::type>(left, right, stages);
  else {
    Join_answer answer;
    if constexpr (N == 2)
      answer = question == Join_question::f3 ? Join_answer::no : Join_answer::undefined;
    else
      answer = decide_on_jets<question>(jet_of_polygon<Join_field<Left>, Curve_end::end>(left, 3),
                                        jet_of_polygon<Join_field<Right>, Curve_end::start>(right, 3));
    stages.decided(Stage::multiprecision, answer);
    return answer;
  }
}

// How an end is handed to a function that is compiled apart: views stay in registers.
template <class End>
using By_value_or_ref =
    std::conditional_t<std::is_trivially_copyable_v<End> && sizeof(End) <= 2 * sizeof(void*), End, const End&>;

// Decides by all stages, which need much room: ends that do not meet are not to wait for it. \pre
// the ends meet, if the question asks for contact
template <Join_question question, bool weighted, class Left, class Right, class Stages>
BOOST_NOINLINE Join_answer decide_ends(By_value_or_ref<Left> left, By_value_or_ref<Right> right, Stages& stages) {
  typedef typename Left::Traits Traits;
  constexpr int N = dimension_v<Traits>;
  if constexpr (is_double<typename Traits::FT> && (N == 2 || N == 3) && !planar_by_definition<question, N>) {
    const Join_reader<question, N, weighted, Left, Right> join(left, right);
    return decide_on_doubles(join(), left, right, stages);
  } else
    return decide_exactly<question, weighted>(left, right, stages);
}

// The orders C of ends with weights, as far as their first derivatives tell. The weights are not
// looked at any further.
template <Join_question question, class Left, class Right, class Stages>
Join_answer decide_weighted_derivatives(const Left& left, const Right& right, Stages& stages) {
  typedef typename Left::Traits Traits;
  constexpr int N = dimension_v<Traits>;
  if constexpr (is_double<typename Traits::FT> && (N == 2 || N == 3))
    if (stages.uses(Stage::floating_point) && weighted_derivatives_differ<N>(left, right)) {
      stages.decided(Stage::floating_point, Join_answer::no);
      return Join_answer::no;
    }
  return Join_answer::unknown;
}

// The decision on two ends that are given by control points, or `unknown` where a question about
// ends with weights is left to the jets.
template <Join_question question, bool weighted, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_polygons(const Left& left, const Right& right, Stages& stages) {
  constexpr int N = dimension_v<typename Left::Traits>;
  check_dimensions(left, right);
  if constexpr (requires_coincident_ends(question))
    if (!ends_meet(left, right)) {
      stages.decided(Stage::comparison, Join_answer::no);
      return Join_answer::no;
    }
  if constexpr (question == Join_question::c0) {
    stages.decided(Stage::comparison, Join_answer::yes);
    return Join_answer::yes;
  } else if constexpr (weighted && is_parametric(question))
    return decide_weighted_derivatives<question>(left, right, stages);
  else if constexpr (weighted && !(N == 2 || N == 3))
    return Join_answer::unknown;
  else
    return decide_ends<question, weighted, Left, Right>(left, right, stages);
}

// Points and tangents do not depend on weights.
// unreachable: computed by the compiler
constexpr bool weights_matter(Join_question question) {
  return question != Join_question::c0 && question != Join_question::g1;
}

// Returns whether x_j/y_j = a c^j for j = 0 ... k with powers of two a and c, which change no
// mantissa. \pre x and y are the bits of positive normal numbers
template <int k>
CGAL_GC_FORCEINLINE bool ratios_are_powers(const std::array<std::int64_t, 4>& x, const std::array<std::int64_t, 4>& y) {
  constexpr std::int64_t mantissa = (std::int64_t(1) << 52) - 1;
  const std::int64_t a = x[0] - y[0], c = x[1] - y[1] - a;
  bool powers = ((a | c) & mantissa) == 0;
  for (int j = 2; j <= k; ++j) powers &= x[j] - y[j] == a + j * c;
  return powers;
}

// Returns whether two ends with positive weights may be decided as polynomial ones. Weights a c^j
// w_j are those of the same shape as w_j. Where both ends have the same, as the arcs of a circle
// have, these are common factors in all questions about shapes but G3. And where all weights of an
// end are the same, it is polynomial in another parameter.
template <Join_question question, class Left, class Right>
CGAL_GC_FORCEINLINE bool weights_cancel(const Left& left, const Right& right) {
  if constexpr (!weights_matter(question))
    // equivalent [true -> false, 1]: the weights are decided with, which changes no answer of a
    //   question in which they do not matter
    return true;
  else if constexpr (!is_parametric(question) && is_double<typename Left::Traits::FT>) {
    constexpr int k = highest_difference(question);
    double least = left.weight(0);
    const auto bits_of_weights = [&least](const auto& end) {
      std::array<std::int64_t, 4> bits{};
      for (int j = 0; j <= k; ++j) {
        const double w = end.weight((std::min)(j, end.degree()));
        least = (std::min)(least, w);
        bits[j] = static_cast<std::int64_t>(bits_of(w));
      }
      return bits;
    };
    const std::array<std::int64_t, 4> w = bits_of_weights(left), v = bits_of_weights(right);
    const auto all_same = [](const std::array<std::int64_t, 4>& bits) {
      return ratios_are_powers<k>(bits, {bits[0], bits[0], bits[0], bits[0]});
    };
    return 0x1p-1022 <= least &&
           ((question != Join_question::g3 && ratios_are_powers<k>(w, v)) || (all_same(w) && all_same(v)));
  } else
    return false;
}

// The decision on the control points of two curves, with weights where these matter, or `unknown`
// where one has none or the question is left to the jets.
template <Join_question question, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_control_points(const Left& left, const Right& right, Stages& stages) {
  bool polynomial = has_polygon(left, Curve_end::end) && has_polygon(right, Curve_end::start);
  if constexpr (Has_weights<Left>::value || Has_weights<Right>::value)
    if (!polynomial && has_weighted_polygon(left, Curve_end::end) && has_weighted_polygon(right, Curve_end::start)) {
      polynomial = weights_cancel<question>(left_end(left), right_end(right));
      if constexpr (weights_matter(question))
        if (!polynomial) return decide_polygons<question, true>(left_end(left), right_end(right), stages);
    }
  return polynomial ? decide_polygons<question, false>(left_end(left), right_end(right), stages) : Join_answer::unknown;
}

// The decision on two curves: on control points where both curves have them, otherwise on jets in
// an exact field.
template <Join_question question, class Left, class Right, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_join(const Left& left, const Right& right, Stages& stages) {
  static_assert(std::is_same_v<typename Left::Traits, typename Right::Traits>,
                "both curves must have the same traits class");
  Join_answer answer = Join_answer::unknown;
  if constexpr (Curve_ends<Left>::have_polygons && Curve_ends<Right>::have_polygons)
    answer = decide_on_control_points<question>(left, right, stages);
  if constexpr (!Always_has_polygons<Left>::value ||
                !Always_has_polygons<Right>::value) // spares the compiler what is never asked
    if (answer == Join_answer::unknown) {
      typedef Join_field<Left> Field;
      answer =
          decide_on_jets<question>(jet_at<Field, Curve_end::end>(left, 3), jet_at<Field, Curve_end::start>(right, 3));
      stages.decided(Stage::multiprecision, answer);
    }
  return answer;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_JOIN_H
