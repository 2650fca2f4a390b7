// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_ladder.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_join.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file join_predicates.h
/// One question about a join, answered exactly on the control points as given, for every kernel. With `double` coordinates,
/// of whatever kernel, the answer costs little more than a test in floating-point arithmetic: a value that exceeds its
/// proven rounding error refutes the join, integers of fixed length on a grid decide nearly all others, and multi-precision
/// numbers the rest. Exact kernels are decided in the ring of the common denominators.
///
/// The left curve ends and the right curve starts at the join. `Left` and `Right` have one traits class. They are models of
/// `ParametricCurve`, or types for which `Curve_ends` is specialised; or both are `Prepared_end`. The control points next to
/// the ends are read where there are some (Bézier and segmented Bézier curves, B-spline curves whose knots allow it);
/// otherwise jets in an exact field decide. A type whose ends cannot be read does not compile. All predicates throw
/// Error `dimension_mismatch` when the dimensions differ. They agree with `Join_continuity` where that is decided exactly.
///
/// Hagen's tests (3.1.1) to (3.1.3) on two Bézier polygons of one degree `m`, corrected and for every ratio \f$ \beta \f$ of the first
/// sides (Hagen: \f$ \beta = 1 \f$), are the predicates for \f$ G^1 \f$, \f$ G^2 \f$ and \f$ F^3 \f$ under his names and conditions. The
/// left polygon ends with the sides \f$ p = b_0 - b_{-1} \f$, \f$ r = b_{-2} - b_{-1} \f$, \f$ s = b_{-2} - b_{-3} \f$, the right one starts
/// with \f$ b_0, b_1, b_2, b_3 \f$. The parameter intervals do not matter.
///
/// One question about each of many joins, on several cores if wanted, is answered by `failing_joins()`. The question is a predicate, or
/// any function of two curves that returns a `bool`:
///
/// \code{.cpp}
/// const auto is_g2 = [](const Curve& left, const Curve& right) { return is_g2_join(left, right); };
/// for (std::size_t i : failing_joins<CGAL::Parallel_if_available_tag>(chain, is_g2))
///   std::cout << "curves " << i << " and " << i + 1 << '\n';
/// \endcode
///
/// The curves are read once, in order and where they are. Predicates are called concurrently unless the tag is `Sequential_tag`: those of
/// this header may be, on number types that may be copied concurrently, as those of all kernels with floating-point numbers and rational
/// numbers may. An exception that a predicate throws leaves the function.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// An end with double coordinates and with what its decisions have in common: the legs on their grid.
template <class Traits_, int N> class Prepared_double_end {
  End_polygon<double, N> points_;
  int degree_;
  std::pair<double, double> domain_;
  Prepared_legs<N> legs_;

public:
  typedef Traits_ Traits;

  template <class Points>
  explicit Prepared_double_end(const Points& end)
      : points_(points_of<3, N>(end)), degree_(end.degree()), domain_(end.domain()), legs_(points_) {}

  int degree() const { return degree_; }
  int dimension() const { return N; }
  const std::pair<double, double>& domain() const { return domain_; }
  double coordinate(int j, int i) const { return points_[j][i]; }

  // On the grids, exact or `unknown`. \pre the ends meet, if the question asks for contact
  template <Join_question question, class Stages>
  static CGAL_GC_FORCEINLINE Join_answer decide(const Prepared_double_end& left, const Prepared_double_end& right,
                                                Stages& stages) {
    if (!left.legs_.grid.valid || !right.legs_.grid.valid || !stages.uses(Join_stage::fixed_integer))
      return Join_answer::unknown;
    return decide_by_rungs(Prepared_join<question, N>(left.legs_, left.degree_, right.legs_, right.degree_), stages);
  }
};

// The end of a curve with the coordinates of its points from the end inwards.
template <class Traits_> class Stored_end {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;

  Stored_end(int m, const FT& a, const FT& b) : degree_(m), domain_(a, b) {}
  void push_back(const Coordinates<Traits>& x) { points_.push_back(x); }

  const std::vector<Coordinates<Traits>>& points() const { return points_; }
  int degree() const { return degree_; }
  int dimension() const { return points_[0].dimension(); }
  const std::pair<FT, FT>& domain() const { return domain_; }
  const FT& coordinate(int j, int i) const { return points_[j][i]; }

private:
  int degree_;
  std::pair<FT, FT> domain_;
  std::vector<Coordinates<Traits>> points_;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The end of a curve, ready to be compared with many others: the four control points next to it, the degree and the domain.
/// With `double` coordinates in the plane or in space the sides of the polygon are kept as integers as well, which saves the
/// predicates the conversion.
///
/// The points run from the end inwards. A start is an end in this sense, too: in a predicate the left curve runs towards the
/// join and the right one away from it.
///
/// Where a B-spline curve, or a curve of the user's own, has no control points next to its end (see `Curve_ends`), the jet of
/// order 3 in an exact field is kept instead and decides; the points are then those of a curve with this jet.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Prepared_end {
public:
  typedef Traits_ Traits;               ///< the traits class
  typedef typename Traits::FT FT;       ///< the numbers of the points
  typedef typename Traits::Point Point; ///< the points

private:
  static constexpr int N = dimension_v<Traits>;
  static constexpr bool on_grid = internal::is_double<FT> && (N == 2 || N == 3);
  // doubles with their legs on a grid, other numbers as they are
  typedef std::conditional_t<on_grid, internal::Prepared_double_end<Traits, on_grid ? N : 2>,
                             internal::Stored_end<Traits>>
      End;

  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  typedef Coordinate_jet<Field, N> Jet;

  End end_;
  std::shared_ptr<const Jet> jet_; // counts instead of the points, if given

public:
  /// Prepares an end from the control points of a curve of degree `degree`, those next to the end first, and its domain [a, b]. At most four
  /// points are read.
  /// \throws Error `wrong_number_of_points` when there are fewer than four points and fewer than `degree + 1`, or `degree < 0`
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class InputIterator>
  Prepared_end(int degree, InputIterator first, InputIterator last, const FT& a = FT(0), const FT& b = FT(1))
      : end_(checked(degree, first, last, a, b)) {}

  /// Returns the end of a curve.
  /// \tparam Curve a model of `ParametricCurve`, or a type for which `Curve_ends` is specialised
  template <class Curve> static Prepared_end at_end(const Curve& curve) { return of<Curve_end::end>(curve); }

  /// Returns the start of a curve.
  /// \tparam Curve a model of `ParametricCurve`, or a type for which `Curve_ends` is specialised
  template <class Curve> static Prepared_end at_start(const Curve& curve) { return of<Curve_end::start>(curve); }

  /// Returns the degree of the curve, or 3 if its jet is kept.
  int degree() const { return end_.degree(); }
  /// Returns the dimension of the points.
  int dimension() const { return end_.dimension(); }
  /// Returns the domain of the curve, or [0, 1] if its jet is kept.
  std::pair<FT, FT> domain() const { return end_.domain(); }
  /// Returns the `i`-th coordinate of the `j`-th point from the end; rounded if the jet of a curve with `double` coordinates is
  /// kept.
  /// \throws Error `wrong_number_of_points` unless `0 <= j <= 3` and `j <= degree()`, `dimension_mismatch` unless
  ///   `0 <= i < dimension()`
  FT coordinate(int j, int i) const {
    if (j < 0 || (std::min)(degree(), 3) < j) throw Error(Error_code::wrong_number_of_points, "Prepared_end: point");
    if (i < 0 || dimension() <= i) throw Error(Error_code::dimension_mismatch, "Prepared_end: coordinate");
    return end_.coordinate(j, i);
  }

  /// \cond
  template <internal::Join_question question, class Stages>
  static internal::Join_answer decide(const Prepared_end& left, const Prepared_end& right, Stages& stages) {
    if (left.jet_ || right.jet_) {
      const internal::Join_answer answer = internal::decide_on_jets<question>(left.template jet<Curve_end::end>(),
                                                                              right.template jet<Curve_end::start>());
      stages.decided(internal::Join_stage::multiprecision, answer);
      return answer;
    }
    if constexpr (on_grid && !internal::is_parametric(question) && !internal::planar_by_definition<question, N>)
      if (!internal::asks_for_contact(question) || internal::ends_meet(left.end_, right.end_)) {
        const internal::Join_answer answer = End::template decide<question>(left.end_, right.end_, stages);
        if (answer != internal::Join_answer::unknown) return answer;
      }
    return internal::decide_polygons<question, false>(left.end_, right.end_, stages);
  }
  /// \endcond

private:
  Prepared_end(End end, std::shared_ptr<const Jet> jet) : end_(std::move(end)), jet_(std::move(jet)) {}

  template <Curve_end which> Jet jet() const { return jet_ ? *jet_ : internal::jet_of_polygon<Field, which>(end_, 3); }

  template <Curve_end which, class Curve> static Prepared_end of(const Curve& curve) {
    std::vector<Point> points;
    if constexpr (Curve_ends<Curve>::have_polygons)
      if (internal::has_polygon(curve, which)) {
        typedef Curve_ends<Curve> Ends;
        const int m = curve.degree(), first = Ends::point_number(curve, which);
        for (int j = 0; j <= (std::min)(m, 3); ++j)
          points.push_back(curve.control_point(which == Curve_end::end ? first - j : first + j));
        const std::pair<FT, FT> domain = Ends::domain(curve, which);
        return Prepared_end(m, points.begin(), points.end(), domain.first, domain.second);
      }
    constexpr bool at_end = which == Curve_end::end;
    const Jet jet = internal::jet_at<Field, which>(curve, 3);
    for (const Coordinate_vector<Field, N>& x : internal::points_from_jet(jet, 3, Field(at_end ? -1 : 1))) {
      Coordinates<Traits> c(x.dimension());
      for (int i = 0; i < x.dimension(); ++i)
        if constexpr (std::is_same_v<FT, Field>)
          c[i] = x[i];
        else
          c[i] = FT(CGAL::to_double(x[i]));
      points.push_back(to_point<Traits>(c));
    }
    return Prepared_end(End(checked(3, points.begin(), points.end(), FT(0), FT(1))), std::make_shared<const Jet>(jet));
  }

  template <class InputIterator>
  static internal::Stored_end<Traits> checked(int degree, InputIterator first, InputIterator last, const FT& a,
                                              const FT& b) {
    internal::Stored_end<Traits> end(degree, a, b);
    int points = 0;
    for (; first != last && points <= (std::min)(degree, 3); ++first, ++points)
      end.push_back(Geometric_continuity::coordinates<Traits>(*first));
    if (points <= (std::min)(degree, 3) || points == 0)
      throw Error(Error_code::wrong_number_of_points,
                  "Prepared_end: degree " + std::to_string(degree) + ", " + std::to_string(points) + " points");
    if (!(a < b)) throw Error(Error_code::empty_domain, "Prepared_end");
    internal::check_finite(a, "Prepared_end: domain");
    internal::check_finite(b, "Prepared_end: domain");
    for (const Coordinates<Traits>& p : end.points()) {
      if (p.dimension() != end.dimension()) throw Error(Error_code::dimension_mismatch, "Prepared_end");
      for (const FT& x : p) internal::check_finite(x, "Prepared_end: control points");
    }
    return end;
  }
};

namespace internal {

template <Join_question question, class Left, class Right>
Join_answer join_answer(const Left& left, const Right& right) {
  const All_join_stages stages;
  return decide_join<question>(left, right, stages);
}
template <Join_question question, class Traits>
Join_answer join_answer(const Prepared_end<Traits>& left, const Prepared_end<Traits>& right) {
  const All_join_stages stages;
  return Prepared_end<Traits>::template decide<question>(left, right, stages);
}

template <Join_question question, class Left, class Right> bool join_is(const Left& left, const Right& right) {
  return join_answer<question>(left, right) == Join_answer::yes;
}
template <Join_question question, class Left, class Right>
std::optional<bool> optional_join_answer(const Left& left, const Right& right) {
  const Join_answer answer = join_answer<question>(left, right);
  if (answer == Join_answer::undefined) return std::nullopt;
  return answer == Join_answer::yes;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether all derivatives up to order `k` agree, `0 <= k <= 3`. This is the only predicate that reads the domains.
/// It is fast when their ends are multiples of \f$ 2^{-20} \f$ up to \f$ 2^{20} \f$ and their lengths are as two whole
/// numbers of at most 1024, and when the first derivatives differ clearly.
/// \throws Error `dimension_mismatch`
template <int k, class Left, class Right> bool is_c_join(const Left& left, const Right& right) {
  static_assert(0 <= k && k <= 3, "orders 0 to 3");
  return internal::join_is<static_cast<internal::Join_question>(k)>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the points agree and the tangents, which are not zero, have one direction. A form of degree 2.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g1_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g1>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents and curvature vectors agree. A form of degree 4 in the sides of the polygons: with
/// \f$ a_k, b_k \f$ the `k`-th differences of the polygons at the join and \f$ i \f$ a coordinate with
/// \f$ a_{1,i} \ne 0 \f$, \f$ a_{1,i}^2 b_2 - b_{1,i}^2 a_2 \f$ must be a multiple of \f$ a_1 \f$ (for equal degrees).
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g2_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g2>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, tangents, curvature vectors and third derivatives with respect to arc length agree. A form of
/// degree 6.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_g3_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::g3>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether points, Frenet frames, curvatures and torsions agree (Hagen 2.1, corrected: the curvature \em vector counts). A
/// form of degree 6: the normals \f$ n = a_1 \times a_2 \f$ are parallel by G2, and
/// \f$ (n \cdot b_3) a_{1,i}^3 = (n \cdot a_3) b_{1,i}^3 \f$ (for equal degrees). False in the plane, where the order F ends
/// with 2.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> bool is_f3_join(const Left& left, const Right& right) {
  return internal::join_is<internal::Join_question::f3>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the curvature vectors agree, wherever the points are; empty when a tangent is zero. A form of degree 4 if the
/// tangents are parallel, otherwise 7.
/// \throws Error `dimension_mismatch`
template <class Left, class Right>
std::optional<bool> has_equal_curvature_vector(const Left& left, const Right& right) {
  return internal::optional_join_answer<internal::Join_question::curvature_vector>(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the torsions agree, wherever the points are; empty unless both curves lie in space and have nonzero curvature. A
/// form of degree 7.
/// \throws Error `dimension_mismatch`
template <class Left, class Right> std::optional<bool> has_equal_torsion(const Left& left, const Right& right) {
  return internal::optional_join_answer<internal::Join_question::torsion>(left, right);
}

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
/// Returns the joins of a chain of curves at which `holds` is false: numbers \f$ i \f$ in increasing order, for the join between the
/// curves \f$ i \f$ and \f$ i + 1 \f$, counted from 0 on. Empty for a chain without joins, i.e. of at most one curve.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam RandomAccessIterator over curves, or whatever `holds` takes
/// \tparam Predicate called as `holds(left, right)`, concurrently unless the tag is `Sequential_tag`
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
/// Returns the joins of many pairs of curves at which `holds` is false: numbers \f$ i \f$ in increasing order, for the join
/// between the left curve \f$ i \f$ and the right curve \f$ i \f$, counted from 0 on.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam Left_iterator, Right_iterator random access iterators over curves, or whatever `holds` takes
/// \tparam Predicate called as `holds(left, right)`, concurrently unless the tag is `Sequential_tag`
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

namespace internal {

template <class Traits, int Left, int Right>
void check_polygons(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "polygon tests");
  if (right.degree() != left.degree())
    throw Error(Error_code::wrong_number_of_points, "polygon tests: the polygons differ in degree");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the tangent is continuous: \f$ b_1 - b_0 = \beta p \f$ with \f$ \beta > 0 \f$. Hagen (3.1.1).
/// False where a side at the join is zero and where the end points differ. \f$ O(n) \f$ in dimension `n`
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_tangent_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  return is_g1_join(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent and curvature vector are continuous: \f$ [p, b_2 - b_0] = \beta^2 [p, r] \f$. Hagen (3.1.2), corrected: the
/// vectors are equal, not their lengths only. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ, `wrong_number_of_points` when the degrees differ
template <class Traits, int Left, int Right>
bool is_curvature_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  return is_g2_join(left, right);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether tangent, curvature vector and torsion are continuous: \f$ \langle [p, r], b_3 - b_0 \rangle = \beta^3 \langle [p, r], s \rangle \f$.
/// Hagen (3.1.3), corrected. Where \f$ [p, r] = 0 \f$ (zero curvature) both sides vanish always; there, and in more than three
/// dimensions, \f$ b_3 - b_0 - \beta^3 s \f$ must lie in the span of \f$ p, r \f$. \f$ O(n) \f$
/// \throws Error `dimension_mismatch` when the dimensions differ or are less than 3, `wrong_number_of_points` when the
///   degrees differ
template <class Traits, int Left, int Right>
bool is_torsion_continuous(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  internal::check_polygons(left, right);
  if (left.dimension() < 3) throw Error(Error_code::dimension_mismatch, "polygon test of torsion in the plane");
  return is_f3_join(left, right);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_PREDICATES_H
