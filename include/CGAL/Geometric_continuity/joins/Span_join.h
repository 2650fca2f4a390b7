// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_SPAN_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_SPAN_JOIN_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/joins/internal/Grid_join.h>
#include <CGAL/Geometric_continuity/joins/internal/Spline_knot.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The join between the end of a span of a curve and the start of another one, whose numbers are as
/// they are written. It is prepared once for all that is asked. In the plane and in space up to
/// order 3, where all numbers are short decimals, it is decided on integers, otherwise from the
/// jets of the spans. The spans must outlive it. One object must not be asked by two threads at the
/// same time.
/// \tparam Span `G2_span`
template <class Span> class Span_join {
  template <int N>
  using Ends = std::conditional_t<std::is_floating_point_v<typename Span::Number>, internal::Double_part_join<N>,
                                  internal::Grid_join<N>>;
  const Span &left_, &right_;
  mutable std::variant<std::monostate, Ends<2>, Ends<3>> ends_; // nothing where jets are needed
  mutable bool is_prepared_ = false;

public:
  /// The answer of `continuity()`.
  typedef Join_continuity<Predicate_FT<typename Span::Traits>> Result;

  /// Takes the two spans.
  /// \throws Error `dimension_mismatch` when the dimensions differ
  Span_join(const Span& left, const Span& right) : left_(left), right_(right) {
    if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "continuity of two spans");
  }

  /// Returns the span that ends at the join.
  const Span& left() const { return left_; }
  /// Returns the span that starts at the join.
  const Span& right() const { return right_; }

  /// Decides the join as `continuity()` of two curves does.
  /// \throws Error as `continuity()` does
  Result continuity(int max_order = 3) const { return decided(max_order, internal::Join_asked::all); }

  /// Decides the orders, as `continuity()` does, and nothing else: the flags and shape parameters
  /// of the result are unspecified.
  /// \throws Error as `continuity()` does
  Result orders(int max_order = 3) const { return decided(max_order, internal::Join_asked::orders); }

  /// Completes the result of `orders()` to the result of `continuity()` for the same `max_order`,
  /// without deciding the orders again.
  /// \throws Error as `continuity()` does
  void complete(Result& join, int max_order = 3) const {
    if (max_order < 2 || max_order > 3 ||
        !visit_ends([&](const auto& ends) { return ends.decide(max_order, join, internal::Join_asked::flags); }))
      join = continuity(max_order);
  }

  /// Calls `f(x, y)` with enclosures of the jets of order 3 at the end of the left span and at the
  /// start of the right one, with respect to parameters of the domain [0, 1] each:
  /// `Coordinate_jet`s of `Interval_nt<false>`, with which `f` can compute. Returns false, without
  /// a call, where `continuity()` takes the jets of the spans.
  template <class Function> bool visit_enclosures(Function f) const {
    return visit_ends([&f](const auto& ends) {
      const Protect_FPU_rounding<true> rounding_upwards;
      const auto jets = ends.enclosed_jets();
      f(jets.first, jets.second);
      return true;
    });
  }

private:
  bool have_one_span() const { return left_.has_one_span_ && right_.has_one_span_; }

  // Returns f(ends), or false where there are none.
  template <class Function> bool visit_ends(Function f) const {
    if (!std::exchange(is_prepared_, true) && have_one_span()) {
      if (left_.dimension() == 2) prepare<2>();
      if (left_.dimension() == 3) prepare<3>();
    }
    return std::visit(
        [&f](const auto& ends) {
          if constexpr (std::is_same_v<std::decay_t<decltype(ends)>, std::monostate>)
            return false;
          else
            return f(ends);
        },
        ends_);
  }
  template <int N> void prepare() const {
    if (!ends_.template emplace<Ends<N>>().set(left_.part_, right_.part_)) ends_.template emplace<0>();
  }

  Result decided(int max_order, internal::Join_asked asked) const {
    if (max_order < 0) throw Error(Error_code::negative_count, "continuity: order");
    Result join;
    if (max_order <= 3) {
      if (asked == internal::Join_asked::orders && is_decided_at_knot(max_order, join)) return join;
      if (visit_ends([&](const auto& ends) { return ends.decide(max_order, join, asked); })) return join;
    }
    return Geometric_continuity::continuity(left_.jets(), right_.jets(), max_order);
  }

  bool is_decided_at_knot(int max_order, Result& join) const {
    if (!have_one_span()) return false;
    return left_.dimension() == 2 ? internal::decide_at_spline_knot<2>(left_.part_, right_.part_, max_order, join)
                                  : left_.dimension() == 3 &&
                                        internal::decide_at_spline_knot<3>(left_.part_, right_.part_, max_order, join);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_SPAN_JOIN_H
