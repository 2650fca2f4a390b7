// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/internal/Range_of_points.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_join.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file join_predicates.h
/// One question about a join, answered exactly on the control points as given, for every kernel.
/// With `double` coordinates, of whatever kernel, the answer costs little more than a test in
/// floating-point arithmetic: a value that exceeds its proven rounding error refutes the join, a
/// residue of a form that is proved to be smaller than the modulus decides nearly all others, and
/// numbers of any length the rest. Exact kernels are decided in the ring of the common
/// denominators.
///
/// The left curve ends and the right curve starts at the join. `Left` and `Right` have one traits
/// class. They are models of `ParametricCurve`, or types for which `Curve_ends` is specialised. The
/// control points next to the ends are read where there are some (Bézier and segmented Bézier
/// curves, B-spline curves whose knots allow it); otherwise, and in more than three dimensions,
/// jets in an exact field decide. A type whose ends cannot be read does not compile. All predicates
/// throw Error `dimension_mismatch` when the dimensions differ. They agree with `Join_continuity`
/// where that is decided exactly.
///
/// A kernel that brings no exact numbers, as `Simple_cartesian<double>`, needs none for control
/// points in the plane and in space: they would double the time of compilation. Where such a kernel
/// meets jets, the compiler asks for numbers/Exact_field.h.
///
/// Hagen's tests (3.1.1) to (3.1.3) on two Bézier polygons of one degree `m`, corrected and for
/// every ratio \f$ \beta \f$ of the first sides (Hagen: \f$ \beta = 1 \f$), are the predicates for
/// \f$ G^1 \f$, \f$ G^2 \f$ and \f$ F^3 \f$ under his names and conditions. The left polygon ends
/// with the sides \f$ p = b_0 - b_{-1} \f$, \f$ r = b_{-2} - b_{-1} \f$,
/// \f$ s = b_{-2} - b_{-3} \f$, the right one starts with \f$ b_0, b_1, b_2, b_3 \f$. The parameter
/// intervals do not matter.
///
/// All predicates are function objects, which are called like functions and passed like numbers.
/// One question about each of many joins, on several cores if wanted, is answered by
/// `failing_joins()`. The question is a predicate, or any function of two curves that returns a
/// `bool`:
///
/// \code{.cpp}
/// for (std::size_t i : failing_joins<CGAL::Parallel_if_available_tag>(chain, is_g2_join))
///   std::cout << "curves " << i << " and " << i + 1 << '\n';
/// \endcode
///
/// The curves are read once, in order and where they are. Predicates are called concurrently unless
/// the tag is `Sequential_tag`: those of this file may be, on number types that may be copied
/// concurrently, as those of all kernels with floating-point numbers and rational numbers may. An
/// exception that a predicate throws leaves the function.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <Join_question question, class Left, class Right>
Join_answer join_answer(const Left& left, const Right& right) {
  const All_stages stages;
  return decide_join<question>(left, right, stages);
}

// Decides whether a join has a property.
template <Join_question question> struct Join_predicate {
  template <class Left, class Right> bool operator()(const Left& left, const Right& right) const {
    if constexpr (Has_traits<Left>::value)
      return join_answer<question>(left, right) == Join_answer::yes;
    else
      return refused<Left>();
  }

  // This refuses a chain, and a tolerance.
  template <class Given, class... Others, class = std::enable_if_t<sizeof...(Others) != 1>>
  bool operator()(const Given&, const Others&...) const {
    return refused<Given>();
  }

private:
  template <class Given> static bool refused() {
    static_assert(never<Given>, "a predicate takes two curves: failing_joins(curves, is_g2_join).empty() decides a "
                                "chain, order_within(a, b, 1e-6) allows a tolerance");
    return false;
  }
};
template <int k> struct Parametric_join_predicate : Join_predicate<static_cast<Join_question>(k)> {
  static_assert(0 <= k && k <= 3, "orders 0 to 3");
};

// Decides whether an invariant is equal on both sides, where it exists.
template <Join_question question> struct Invariant_predicate {
  template <class Left, class Right> std::optional<bool> operator()(const Left& left, const Right& right) const {
    const Join_answer answer = join_answer<question>(left, right);
    if (answer == Join_answer::undefined) return std::nullopt;
    return answer == Join_answer::yes;
  }
};

// Tells whether a curve is a Bezier curve, or is derived from one.
template <class Traits, int Degree> std::true_type test_bezier_curve(const Bezier_curve<Traits, Degree>*);
std::false_type test_bezier_curve(const void*);
template <class Curve>
constexpr bool is_bezier_curve = decltype(test_bezier_curve(std::declval<const Curve*>()))::value;

// Decides whether two polygons of one degree pass a test of Hagen.
template <Join_question question> struct Polygon_predicate {
  template <class Traits, int Left, int Right>
  bool operator()(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) const {
    if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "polygon tests");
    if (right.degree() != left.degree())
      throw Error(Error_code::wrong_number_of_points, "polygon tests: the polygons differ in degree");
    if (question == Join_question::f3 && left.dimension() < 3)
      throw Error(Error_code::dimension_mismatch, "polygon test of torsion in the plane");
    return Join_predicate<question>()(left, right);
  }

  template <class Left, class Right, class = std::enable_if_t<!is_bezier_curve<Left> || !is_bezier_curve<Right>>>
  No_result operator()(const Left&, const Right&) const {
    static_assert(never<Left>,
                  "is_g1_join(a, b) and is_g2_join(a, b) decide the join of any two curves; this is a test "
                  "of Hagen for two Bezier curves of one degree");
    return {};
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether all derivatives up to order `k` agree, `0 <= k <= 3`. This is the only predicate
/// that reads the domains. It is fast when their ends are multiples of \f$ 2^{-20} \f$ up to
/// \f$ 2^{20} \f$ and their lengths are as two whole numbers of at most 1024, and when the first
/// derivatives differ clearly.
/// \throws Error `dimension_mismatch`
template <int k> inline constexpr internal::Parametric_join_predicate<k> is_c_join{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the points agree and the tangents, which are not zero, have one direction. A
/// form of degree 2.
/// \throws Error `dimension_mismatch`
inline constexpr internal::Join_predicate<internal::Join_question::g1> is_g1_join{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents and curvature vectors agree. A form of degree 4 in the sides of
/// the polygons: with \f$ a_k, b_k \f$ the `k`-th differences of the polygons at the join and
/// \f$ i \f$ a coordinate with \f$ a_{1,i} \ne 0 \f$, \f$ a_{1,i}^2 b_2 - b_{1,i}^2 a_2 \f$ must be
/// a multiple of \f$ a_1 \f$ (for equal degrees).
/// \throws Error `dimension_mismatch`
inline constexpr internal::Join_predicate<internal::Join_question::g2> is_g2_join{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents, curvature vectors and third derivatives with respect to arc
/// length agree. A form of degree 6.
/// \throws Error `dimension_mismatch`
inline constexpr internal::Join_predicate<internal::Join_question::g3> is_g3_join{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, Frenet frames, curvatures and torsions agree (Hagen 2.1, corrected: the
/// curvature \em vector counts). A form of degree 6: the normals \f$ n = a_1 \times a_2 \f$ are
/// parallel by G2, and \f$ (n \cdot b_3) a_{1,i}^3 = (n \cdot a_3) b_{1,i}^3 \f$ (for equal
/// degrees). False in the plane, where the order F ends with 2.
/// \throws Error `dimension_mismatch`
inline constexpr internal::Join_predicate<internal::Join_question::f3> is_f3_join{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the curvature vectors agree, wherever the points are; empty when a tangent is
/// zero. A form of degree 4 if the tangents are parallel, otherwise 7.
/// \throws Error `dimension_mismatch`
inline constexpr internal::Invariant_predicate<internal::Join_question::curvature_vector> has_equal_curvature_vector{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the torsions agree, wherever the points are; empty unless both curves lie in
/// space and have nonzero curvature. A form of degree 7.
/// \throws Error `dimension_mismatch`
inline constexpr internal::Invariant_predicate<internal::Join_question::torsion> has_equal_torsion{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the tangent is continuous: \f$ b_1 - b_0 = \beta p \f$ with \f$ \beta > 0 \f$.
/// Hagen (3.1.1). False where a side at the join is zero and where the end points differ.
/// \f$ O(n) \f$ in dimension `n`
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the
///   degrees differ
inline constexpr internal::Polygon_predicate<internal::Join_question::g1> is_tangent_continuous{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent and curvature vector are continuous:
/// \f$ [p, b_2 - b_0] = \beta^2 [p, r] \f$. Hagen (3.1.2), corrected: the vectors are equal, not
/// their lengths only. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the
///   degrees differ
inline constexpr internal::Polygon_predicate<internal::Join_question::g2> is_curvature_continuous{};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent, curvature vector and torsion are continuous:
/// \f$ \langle [p, r], b_3 - b_0 \rangle = \beta^3 \langle [p, r], s \rangle \f$. Hagen (3.1.3),
/// corrected. Where \f$ [p, r] = 0 \f$ (zero curvature) both sides vanish always; there, and in
/// more than three dimensions, \f$ b_3 - b_0 - \beta^3 s \f$ must lie in the span of \f$ p, r \f$.
/// \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ or are less than 3,
///   `wrong_number_of_points` when the degrees differ
inline constexpr internal::Polygon_predicate<internal::Join_question::f3> is_torsion_continuous{};

namespace internal {

// The numbers 0 <= i < n with !holds(i), in increasing order.
template <class Concurrency_tag, class Predicate>
std::vector<std::size_t> failing_indices(std::size_t n, const Predicate& holds) {
  typedef std::vector<std::size_t> Indices;
  std::vector<Indices> found; // those of one block each, in the order in which blocks are done
  std::mutex mutex;
  for_each_block<Concurrency_tag>(n, [&](std::size_t begin, std::size_t end) {
    Indices failing;
    for (std::size_t i = begin; i < end; ++i)
      if (!holds(i)) failing.push_back(i);
    if (failing.empty()) return;
    const std::lock_guard<std::mutex> lock(mutex);
    found.push_back(std::move(failing));
  });
  std::sort(found.begin(), found.end(), [](const Indices& x, const Indices& y) { return x[0] < y[0]; });
  Indices all;
  for (const Indices& failing : found) all.insert(all.end(), failing.begin(), failing.end());
  return all;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the joins of a chain of curves at which `holds` is false: numbers \f$ i \f$ in
/// increasing order, for the join between the curves \f$ i \f$ and \f$ i + 1 \f$, counted from 0
/// on. Empty for a chain without joins, i.e. of at most one curve.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam RandomAccessIterator over curves, or whatever `holds` takes
/// \tparam Predicate called as `holds(left, right)`, concurrently unless the tag is
///   `Sequential_tag`
///
/// One call of `holds` for each join; memory is allocated for the joins that fail only.
template <class Concurrency_tag = Sequential_tag, class RandomAccessIterator, class Predicate>
std::vector<std::size_t> failing_joins(RandomAccessIterator first, RandomAccessIterator last, const Predicate& holds) {
  typedef typename std::iterator_traits<RandomAccessIterator>::difference_type Difference;
  const Difference n = last - first;
  return internal::failing_indices<Concurrency_tag>(n < 2 ? 0 : static_cast<std::size_t>(n - 1), [&](std::size_t i) {
    const RandomAccessIterator left = first + static_cast<Difference>(i);
    return bool(holds(left[0], left[1]));
  });
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the joins of the curves of a range, such as a `std::vector`, at which `holds` is false.
template <class Concurrency_tag = Sequential_tag, class Range, class Predicate>
std::vector<std::size_t> failing_joins(const Range& chain, const Predicate& holds) {
  return failing_joins<Concurrency_tag>(std::begin(chain), std::end(chain), holds);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the joins of many pairs of curves at which `holds` is false: numbers \f$ i \f$ in
/// increasing order, for the join between the left curve \f$ i \f$ and the right curve \f$ i \f$,
/// counted from 0 on.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam Left_iterator, Right_iterator random access iterators over curves, or whatever `holds`
///   takes
/// \tparam Predicate called as `holds(left, right)`, concurrently unless the tag is
///   `Sequential_tag`
///
/// One call of `holds` for each join; memory is allocated for the joins that fail only.
/// \throws Error `wrong_number_of_points` when there are not as many right curves as left ones
template <class Concurrency_tag = Sequential_tag, class Left_iterator, class Right_iterator, class Predicate>
std::vector<std::size_t> failing_joins(Left_iterator left, Left_iterator left_end, Right_iterator right,
                                       Right_iterator right_end, const Predicate& holds) {
  typedef typename std::iterator_traits<Left_iterator>::difference_type Left_difference;
  typedef typename std::iterator_traits<Right_iterator>::difference_type Right_difference;
  const std::size_t n = static_cast<std::size_t>(left_end - left);
  if (static_cast<std::size_t>(right_end - right) != n)
    throw Error(Error_code::wrong_number_of_points, "failing_joins: the numbers of left and right curves differ");
  return internal::failing_indices<Concurrency_tag>(n, [&](std::size_t i) {
    return bool(holds(left[static_cast<Left_difference>(i)], right[static_cast<Right_difference>(i)]));
  });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
