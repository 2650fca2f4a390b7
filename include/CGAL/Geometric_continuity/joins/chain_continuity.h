// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_CHAIN_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_CHAIN_CONTINUITY_H

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// A join of a chain, as it is reported. It refers to the two curves and is valid during the report
/// only.
template <class Curve> struct Chain_join {
  std::size_t left, right;  ///< the numbers of the curves in the chain, from 0 on
  const Curve& left_curve;  ///< the curve that ends at the join
  const Curve& right_curve; ///< the curve that starts at the join
  Join_continuity<Predicate_FT<typename Curve::Traits>> continuity; ///< what was decided
};

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the joins of a chain of any length whose curves come one at a time. Only the first curve
/// and the previous one are kept.
///
/// \code{.cpp}
/// Chain_accumulator<Curve> chain(2);
/// while (std::optional<Curve> curve = reader.next())
///   chain.add(*curve, [](const Chain_join<Curve>& join) { std::cout << join.continuity << '\n'; });
/// chain.close();
/// std::cout << chain.summary() << '\n';
/// \endcode
///
/// \tparam Curve a copyable model of `ParametricCurve`
template <class Curve> class Chain_accumulator {
  int max_order_;
  std::size_t size_ = 0;
  std::optional<Curve> first_, last_;
  Chain_summary summary_;

  struct No_report {};

public:
  /// Starts an empty chain. Orders up to `max_order` are decided.
  /// \throws Error `negative_count` for a negative order
  explicit Chain_accumulator(int max_order = 3) : max_order_(max_order) {
    if (max_order < 0) throw Error(Error_code::negative_count, "Chain_accumulator: order");
  }

  /// Appends a curve and decides its join with the one before it, if there is one: `report` is
  /// called with a `Chain_join<Curve>`, then the join is counted. One call of `continuity()`.
  /// \throws Error as `continuity()` does; then the chain is as it was before
  template <class Report> void add(Curve curve, Report&& report) {
    if (last_) decide(size_ - 1, size_, *last_, curve, report);
    if (!first_) first_ = curve;
    last_ = std::move(curve);
    ++size_;
  }

  /// Appends a curve and decides its join with the one before it, if there is one, without a
  /// report.
  /// \throws Error as `continuity()` does; then the chain is as it was before
  void add(Curve curve) {
    No_report no_report;
    add(std::move(curve), no_report);
  }

  /// Decides the join that closes the chain, from the end of the last curve to the start of the
  /// first, which may be the same: `report` is called with a `Chain_join<Curve>`, then the join is
  /// counted. Nothing happens in an empty chain.
  /// \throws Error as `continuity()` does
  template <class Report> void close(Report&& report) {
    if (last_) decide(size_ - 1, 0, *last_, *first_, report);
  }

  /// Decides the join that closes the chain, without a report. \throws Error as `continuity()` does
  void close() {
    No_report no_report;
    close(no_report);
  }

  /// Returns the number of curves so far.
  std::size_t size() const { return size_; }

  /// Returns the counts of the joins so far.
  const Chain_summary& summary() const { return summary_; }

private:
  template <class Report>
  void decide(std::size_t left, std::size_t right, const Curve& left_curve, const Curve& right_curve, Report& report) {
    if constexpr (std::is_same_v<Report, No_report>)
      summary_.add(internal::decide_continuity(left_curve, right_curve, max_order_, true));
    else {
      const Chain_join<Curve> join{left, right, left_curve, right_curve,
                                   Geometric_continuity::continuity(left_curve, right_curve, max_order_)};
      report(join);
      summary_.add(join.continuity);
    }
  }
};

namespace internal {

// The type of the curves of a range or between two iterators; none for what holds no curves, such
// as the control points of a curve.
template <class Iterator> using Chain_curve = typename std::iterator_traits<Iterator>::value_type;
template <class Range>
using Curve_of_range =
    std::enable_if_t<std::is_class_v<typename Chain_curve<decltype(std::begin(std::declval<const Range&>()))>::Traits>,
                     Chain_curve<decltype(std::begin(std::declval<const Range&>()))>>;

template <class Number> using If_tolerance = std::enable_if_t<std::is_floating_point_v<Number>>;
template <class Curves> No_result no_tolerance() {
  static_assert(never<Curves>, "the argument behind the curves is the highest order to decide, and this function is "
                               "exact: order_within(a, b, 1e-6) allows a tolerance for each join");
  return {};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of a chain of curves up to order `max_order`, with that of the last curve and
/// the first one if the chain is closed, and returns how many of them have which order. Only the
/// orders of each join are decided, which takes less time than `continuity()`. `chain_joins()`
/// returns the joins themselves, and `Chain_accumulator` takes curves one at a time.
/// \tparam InputIterator its value type is a copyable model of `ParametricCurve`
/// \throws Error as `continuity()` does
template <class InputIterator>
Chain_summary chain_continuity(InputIterator first, InputIterator last, int max_order = 3,
                               Closure closure = Closure::open) {
  Chain_accumulator<internal::Chain_curve<InputIterator>> chain(max_order);
  for (; first != last; ++first) chain.add(*first);
  if (closure == Closure::closed) chain.close();
  return chain.summary();
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of the curves of a range, such as a `std::vector`, and returns how many of
/// them have which order.
template <class Range, class = internal::Curve_of_range<Range>>
Chain_summary chain_continuity(const Range& chain, int max_order = 3, Closure closure = Closure::open) {
  return chain_continuity(std::begin(chain), std::end(chain), max_order, closure);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of the curves of a range up to order 3, and returns how many of them have
/// which order.
template <class Range, class = internal::Curve_of_range<Range>>
Chain_summary chain_continuity(const Range& chain, Closure closure) {
  return chain_continuity(chain, 3, closure);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of a chain of curves up to order `max_order`, and returns them: number `i` is
/// the join at the end of the curve number `i`, with that of the last curve and the first one as
/// the last if the chain is closed. One call of `continuity()` for each.
/// \tparam InputIterator its value type is a copyable model of `ParametricCurve`
/// \throws Error as `continuity()` does
template <class InputIterator>
std::vector<Join_continuity<Predicate_FT<typename internal::Chain_curve<InputIterator>::Traits>>>
chain_joins(InputIterator first, InputIterator last, int max_order = 3, Closure closure = Closure::open) {
  typedef internal::Chain_curve<InputIterator> Curve;
  std::vector<Join_continuity<Predicate_FT<typename Curve::Traits>>> joins;
  const auto keep = [&](const Chain_join<Curve>& join) { joins.push_back(join.continuity); };
  Chain_accumulator<Curve> chain(max_order);
  for (; first != last; ++first) chain.add(*first, keep);
  if (closure == Closure::closed) chain.close(keep);
  return joins;
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of the curves of a range, such as a `std::vector`, and returns them.
template <class Range>
std::vector<Join_continuity<Predicate_FT<typename internal::Curve_of_range<Range>::Traits>>>
chain_joins(const Range& chain, int max_order = 3, Closure closure = Closure::open) {
  return chain_joins(std::begin(chain), std::end(chain), max_order, closure);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of the curves of a range up to order 3, and returns them.
template <class Range>
std::vector<Join_continuity<Predicate_FT<typename internal::Curve_of_range<Range>::Traits>>>
chain_joins(const Range& chain, Closure closure) {
  return chain_joins(chain, 3, closure);
}

/// \cond SKIP_IN_MANUAL
// A tolerance in the place of the highest order is refused: it would be rounded to an order.
template <class Curves, class Number, class = internal::If_tolerance<Number>>
internal::No_result chain_continuity(const Curves&, Number, Closure = Closure::open) {
  return internal::no_tolerance<Curves>();
}
template <class Iterator, class Number, class = internal::If_tolerance<Number>>
internal::No_result chain_continuity(Iterator, Iterator, Number, Closure = Closure::open) {
  return internal::no_tolerance<Iterator>();
}
template <class Range, class Number, class = internal::If_tolerance<Number>>
internal::No_result chain_joins(const Range&, Number, Closure = Closure::open) {
  return internal::no_tolerance<Range>();
}
template <class Iterator, class Number, class = internal::If_tolerance<Number>>
internal::No_result chain_joins(Iterator, Iterator, Number, Closure = Closure::open) {
  return internal::no_tolerance<Iterator>();
}
template <class Curve, class Number, class = internal::If_tolerance<Number>>
internal::No_result knot_continuities(const Curve&, Number) {
  return internal::no_tolerance<Curve>();
}
/// \endcond

// A bool in the place of `closed` is refused: it would be taken for the order.
template <class Iterator, class Flag, class = std::enable_if_t<std::is_same_v<Flag, bool>>>
Chain_summary chain_continuity(Iterator first, Iterator last, Flag closed) = delete;
template <class Range, class Flag, class = std::enable_if_t<std::is_same_v<Flag, bool>>>
Chain_summary chain_continuity(const Range& chain, Flag closed) = delete;
template <class Iterator, class Flag, class = std::enable_if_t<std::is_same_v<Flag, bool>>>
void chain_joins(Iterator first, Iterator last, Flag closed) = delete;
template <class Range, class Flag, class = std::enable_if_t<std::is_same_v<Flag, bool>>>
void chain_joins(const Range& chain, Flag closed) = delete;

/// \ingroup PkgGeometricContinuityContinuity
/// Curvature and torsion on one side of a join.
template <class FT> struct Join_side {
  /// \f$ \kappa \f$, signed in the plane; empty where the tangent is zero.
  std::optional<Signed_square<FT>> curvature;
  /// \f$ \tau \f$; empty unless in space with nonzero curvature.
  std::optional<FT> torsion;
};

/// \ingroup PkgGeometricContinuityContinuity
/// The decision about one join of a segmented curve, in its global parameter.
template <class Traits> struct Composite_join {
  typedef Predicate_FT<Traits> FT; ///< the field in which it was decided
  int left;                        ///< the number of the segment that ends here
  int right;                       ///< the number of the segment that starts here
  typename Traits::FT knot;        ///< the parameter at the end of the left segment
  /// the orders, with the shape parameters in the global parameter
  Join_continuity<FT> continuity;
  Join_side<FT> left_side;  ///< the values of the left segment
  Join_side<FT> right_side; ///< the values of the right segment
};

/// \ingroup PkgGeometricContinuityContinuity
/// The decisions about all joins of a segmented curve.
template <class Traits> struct Composite_continuity {
  /// from left to right; that of a closed curve's end and start is the last
  std::vector<Composite_join<Traits>> joins;
  Chain_summary summary; ///< how many joins have which order

  /// Returns the joins that do not have the continuity of this kind and order, which must not
  /// exceed the order that was decided.
  std::vector<Composite_join<Traits>> failing(Continuity_kind kind, int order) const {
    std::vector<Composite_join<Traits>> result;
    for (const Composite_join<Traits>& join : joins)
      if (order_of(join.continuity, kind) < order) result.push_back(join);
    return result;
  }

  /// Writes the summary, e.g. `3 joins, C0 G2 F2 or more`.
  friend std::ostream& operator<<(std::ostream& os, const Composite_continuity& c) { return os << c.summary; }
};

namespace internal {

// Curvature and torsion from a jet of order 2, or 3 in space.
template <class FT, int N> Join_side<FT> join_side(const Coordinate_jet<FT, N>& jet) {
  Join_side<FT> side;
  if constexpr (N == 0 || N == 2)
    if (jet.dimension() == 2) side.curvature = signed_curvature(jet);
  if (jet.dimension() != 2)
    if (const std::optional<FT> square = curvature_squared(jet))
      side.curvature = Signed_square<FT>{sign_of<FT>(*square), *square};
  if constexpr (N == 0 || N == 3)
    if (jet.dimension() == 3) side.torsion = torsion(jet);
  return side;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides all joins of a segmented curve with respect to its global parameter, up to order
/// `max_order`; that between its end and its start as well when the curve is closed. Exact wherever
/// `continuity()` of two curves is: with `Exact_predicates_inexact_constructions_kernel` for the
/// points and knots as given. One decision as in `continuity()` for each join. Hagen 2.1, (2.2),
/// corrected.
/// \throws Error `negative_count` for a negative order
template <class Traits, int Degree>
Composite_continuity<Traits> chain_continuity(const Composite_bezier_curve<Traits, Degree>& curve, int max_order = 3) {
  typedef Predicate_FT<Traits> Field;
  typedef Bezier_curve<Traits, Degree> Segment;
  Composite_continuity<Traits> result;
  for (const auto& join : curve.joins()) {
    const Segment left = curve.segment(join.left), right = curve.segment(join.right);
    const Join_continuity<Field> decided = continuity(left, right, max_order);
    result.joins.push_back({join.left, join.right, curve.knots()[join.left + 1], decided,
                            internal::join_side(left.template end_jet_over<Field>(3)),
                            internal::join_side(right.template start_jet_over<Field>(3))});
    result.summary.add(decided);
  }
  return result;
}

namespace internal {

// A curve cut at a parameter: the part on the left ends there, the part on the right starts there.
template <class Curve> struct Split_view {
  typedef typename Curve::Traits Traits;
  const Curve& curve;
  const typename Traits::FT& u;

  template <class Field> Coordinate_jet<Field, Curve::N> end_jet_over(int k) const {
    return curve.template left_jet_over<Field>(u, k);
  }
  template <class Field> Coordinate_jet<Field, Curve::N> start_jet_over(int k) const {
    return curve.template right_jet_over<Field>(u, k);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The decision about a curve at one of its inner knots.
template <class Traits> struct Knot_continuity {
  typename Traits::FT knot;                   ///< the parameter
  int multiplicity;                           ///< how often it is repeated
  Join_continuity<Predicate_FT<Traits>> join; ///< the join of the pieces on both sides

  /// Writes the parameter, a colon and the join.
  friend std::ostream& operator<<(std::ostream& os, const Knot_continuity& k) { return os << k.knot << ": " << k.join; }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of a B-spline curve at a parameter inside its domain, up to order
/// `max_order`, from its jets on both sides. At a knot of multiplicity `m` the curve is at least
/// \f$ C^{p-m} \f$.
///
/// With `Exact_predicates_inexact_constructions_kernel` the control points, the knots and the
/// parameter are taken over to an exact field before anything is derived from them, so that the
/// answer is exact for the curve as given.
/// \tparam Curve `Bspline_curve` or `Rational_bspline_curve`
/// \throws Error `parameter_outside_domain` also at the ends of the domain, `negative_count` for a
///   negative order
template <class Curve>
Join_continuity<Predicate_FT<typename Curve::Traits>>
knot_continuity(const Curve& curve, const typename Curve::FT& knot, int max_order = 3) {
  if (knot == curve.domain().first || knot == curve.domain().second)
    throw Error(Error_code::parameter_outside_domain, "knot_continuity: an end of the domain has one side only");
  const internal::Split_view<Curve> cut{curve, knot};
  return continuity(cut, cut, max_order);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of a B-spline curve at all its inner knots, up to order `max_order`, and
/// returns it in increasing order of the knots. One call of `knot_continuity()` for each of them.
/// \tparam Curve `Bspline_curve` or `Rational_bspline_curve`
/// \throws Error `negative_count` for a negative order
template <class Curve>
std::vector<Knot_continuity<typename Curve::Traits>> knot_continuities(const Curve& curve, int max_order = 3) {
  std::vector<Knot_continuity<typename Curve::Traits>> result;
  for (const typename Knot_vector<typename Curve::FT>::Knot& knot : curve.knots().inner_knots())
    result.push_back({knot.value, knot.multiplicity, knot_continuity(curve, knot.value, max_order)});
  return result;
}

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
template <class Curve> using Chain_analysis CGAL_DEPRECATED = Chain_accumulator<Curve>;
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_CHAIN_CONTINUITY_H
