// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_SPAN_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_SPAN_H

#include <CGAL/Geometric_continuity/IO/internal/G2_spline_parts.h>
#include <CGAL/Geometric_continuity/joins/internal/Grid_join.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/local/Curve_end_jets.h>

#include <memory>

namespace CGAL {
namespace Geometric_continuity {

template <class Traits, class Number, class Concurrency_tag> class G2_span_reader;

/// \ingroup PkgGeometricContinuityIO
/// A span of a curve as it stands in a text, with the numbers as they are written; see `G2_span_reader`.
/// \tparam Traits, Number as those of `G2_span_reader`
template <class Traits_, class Number_ = Text_number> class G2_span {
  internal::G2_spline_part<Number_> part_;
  bool has_one_span_ = false; // and no weights
  int order_ = 0;
  mutable std::shared_ptr<const Curve_end_jets<Traits_>> jets_;

  template <class, class, class> friend class G2_span_reader;

public:
  typedef Traits_ Traits; ///< the traits class
  typedef Number_ Number; ///< the numbers as they are written

  /// Returns the dimension of the space.
  int dimension() const { return part_.dimension; }
  /// Returns the degree.
  int degree() const { return part_.degree; }

  /// Returns the jets at both ends. They are computed when they are asked for first; therefore two threads must not ask one object at
  /// the same time.
  /// \throws Error `work_limit`
  const Curve_end_jets<Traits>& jets() const {
    if (!jets_)
      jets_ = std::make_shared<const Curve_end_jets<Traits>>(
          internal::polynomial_curve<Traits>(part_).span_end_jets(order_).front());
    return *jets_;
  }

  /// Decides the join of two spans as `continuity()` of two curves does: in the plane and in space up to order 3, where all
  /// numbers are short decimals, on integers, otherwise from `jets()`.
  /// \throws Error as `continuity()` does
  friend Join_continuity<Predicate_FT<Traits_>> continuity(const G2_span& left, const G2_span& right,
                                                           int max_order = 3) {
    return decided(left, right, max_order, false);
  }

  /// Decides the orders of the join of two spans, as `continuity()` does, and nothing else: the flags and shape parameters of the
  /// result are unspecified.
  /// \throws Error as `continuity()` does
  friend Join_continuity<Predicate_FT<Traits_>> continuity_orders(const G2_span& left, const G2_span& right,
                                                                  int max_order = 3) {
    return decided(left, right, max_order, true);
  }

  /// Calls `f(x, y)` with enclosures of the jets of order 3 at the end of `left` and at the start of `right`, with respect to parameters of
  /// the domain [0, 1] each: `Coordinate_jet`s of `Interval_nt<false>`, with which `f` can compute. Returns false, without a call, where
  /// `continuity()` takes `jets()`.
  template <class Function> static bool visit_enclosures(const G2_span& left, const G2_span& right, Function f) {
    if (!left.has_one_span_ || !right.has_one_span_ || left.dimension() != right.dimension()) return false;
    return left.dimension() == 2   ? visit_enclosures_in<2>(left, right, f)
           : left.dimension() == 3 ? visit_enclosures_in<3>(left, right, f)
                                   : false;
  }

private:
  template <int N, class Function>
  static bool visit_enclosures_in(const G2_span& left, const G2_span& right, Function& f) {
    internal::Grid_join<N> grid;
    if (!grid.set(left.part_, right.part_)) return false;
    const Protect_FPU_rounding<true> rounding_upwards;
    const auto jets = grid.enclosed_jets();
    f(jets.first, jets.second);
    return true;
  }

  static Join_continuity<Predicate_FT<Traits_>> decided(const G2_span& left, const G2_span& right, int max_order,
                                                        bool only_orders) {
    if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "continuity of two spans");
    if (max_order < 0) throw Error(Error_code::negative_count, "continuity: order");
    if (max_order <= 3 && left.has_one_span_ && right.has_one_span_) {
      Join_continuity<Predicate_FT<Traits_>> join;
      if ((left.dimension() == 2 && decide_on_grid<2>(left, right, max_order, only_orders, join)) ||
          (left.dimension() == 3 && decide_on_grid<3>(left, right, max_order, only_orders, join)))
        return join;
    }
    return Geometric_continuity::continuity(left.jets(), right.jets(), max_order);
  }

  template <int N, class Join>
  static bool decide_on_grid(const G2_span& left, const G2_span& right, int max_order, bool only_orders, Join& join) {
    internal::Grid_join<N> grid;
    return grid.set(left.part_, right.part_) && grid.decide(max_order, join, only_orders);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_SPAN_H
