// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_SPAN_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_SPAN_READER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_spline_parts.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/Span_join.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <algorithm>
#include <istream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// \file G2_span_reader.h
/// Spans of curves of the format `.g2`, with their numbers as they are written, and the joins of
/// two spans, which are decided from these numbers.

namespace CGAL {
namespace Geometric_continuity {

template <class Traits, class Number, class Concurrency_tag> class G2_span_reader;

/// \ingroup PkgGeometricContinuityIO
/// A span of a curve as it stands in a text, with the numbers as they are written; see
/// `G2_span_reader`.
/// \tparam Traits, Number as those of `G2_span_reader`
template <class Traits_, class Number_ = Decimal> class G2_span {
  internal::G2_spline_part<Number_> part_;
  bool has_one_span_ = false; // and no weights
  int order_ = 0;
  mutable std::shared_ptr<const Curve_end_jets<Traits_>> jets_;

  template <class, class, class> friend class G2_span_reader;
  template <class> friend class Span_join;

public:
  typedef Traits_ Traits; ///< the traits class
  typedef Number_ Number; ///< the numbers as they are written

  /// Returns the dimension of the space.
  int dimension() const { return part_.dimension; }
  /// Returns the degree.
  int degree() const { return part_.degree; }

  /// Returns the jets at both ends. They are computed when they are asked for first; therefore two
  /// threads must not ask one object at the same time.
  /// \throws Error `work_limit`
  const Curve_end_jets<Traits>& jets() const {
    if (!jets_)
      jets_ = std::make_shared<const Curve_end_jets<Traits>>(
          internal::polynomial_curve<Traits>(part_).span_end_jets(order_).front());
    return *jets_;
  }

  /// Decides the join of two spans, see `Span_join`.
  /// \throws Error as `continuity()` of two curves does
  friend Join_continuity<Predicate_FT<Traits_>> continuity(const G2_span& left, const G2_span& right,
                                                           int max_order = 3) {
    return Span_join<G2_span>(left, right).continuity(max_order);
  }

  /// Decides the orders of the join of two spans, see `Span_join`.
  /// \throws Error as `continuity()` of two curves does
  friend Join_continuity<Predicate_FT<Traits_>> continuity_orders(const G2_span& left, const G2_span& right,
                                                                  int max_order = 3) {
    return Span_join<G2_span>(left, right).orders(max_order);
  }

  /// Calls `f(x, y)` with enclosures of the jets at the join of two spans, see `Span_join`.
  template <class Function> static bool visit_enclosures(const G2_span& left, const G2_span& right, Function f) {
    return left.dimension() == right.dimension() && Span_join<G2_span>(left, right).visit_enclosures(f);
  }
};

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text in the `.g2` format span by span, as `G2_piece_reader` does, but
/// keeps the numbers as they are written: `continuity()` of two spans decides most joins from them
/// at once, exactly. That is the fastest way from a file to verdicts. Of a curve, only the knots
/// and what belongs to one span are kept; curves of an order above 16 are read as a whole.
///
/// \tparam Traits a model of `GeometricContinuityTraits` over an exact field, in which the other
///   joins are decided
/// \tparam Number `Decimal`, or a floating-point type to which numbers are rounded when they are
///   read
/// \tparam Concurrency_tag with `Parallel_tag`, or `Parallel_if_available_tag` and TBB, the numbers
///   are read on several cores
template <class Traits, class Number = Decimal, class Concurrency_tag = Sequential_tag> class G2_span_reader {
  static constexpr int highest_order = 16; // of a curve that is cut span by span

  internal::G2_spline_parts<Number, dimension_v<Traits>, Concurrency_tag> parts_;
  int order_;
  int degree_ = 0; // of the last part
  std::vector<Curve_end_jets<Traits>>
      jets_; // of the spans of the last part that was not cut: what is left, the next one last

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`. Joins of the
  /// spans can be decided up to this order.
  /// \throws Error `negative_count` for a negative order, `cannot_read_file` when the stream is not
  ///   good
  G2_span_reader(std::istream& is, std::string name, int order)
      : parts_(is, std::move(name), highest_order), order_(order) {
    internal::check_count(order, "G2_span_reader");
  }

  /// Reads the next span. Returns false at the end of the text. After an error the reader cannot be
  /// used any more.
  /// \throws Error as `G2_bspline_reader` does, `work_limit`
  bool next(G2_span<Traits, Number>& span) {
    if (jets_.empty()) {
      if (!parts_.next(span.part_)) return false;
      const internal::G2_spline_part<Number>& part = span.part_;
      span.order_ = order_;
      span.jets_.reset();
      span.has_one_span_ = !part.rational && part.degree < highest_order;
      if (span.has_one_span_) return true;
      degree_ = part.degree;
      jets_ = part.rational
                  ? parts_.checked([&] { return internal::rational_curve<Traits>(part).span_end_jets(order_); })
                  : internal::polynomial_curve<Traits>(part).span_end_jets(order_);
      std::reverse(jets_.begin(), jets_.end());
    }
    span.has_one_span_ = false;
    span.part_.degree = degree_;
    span.part_.dimension = jets_.back().dimension();
    span.jets_ = std::make_shared<const Curve_end_jets<Traits>>(std::move(jets_.back()));
    jets_.pop_back();
    return true;
  }

  /// Returns the line of the text, from 1 on, in which the last number stands that was read for the
  /// last span: its last control point. When it is asked for each span, each character of the text
  /// is looked at once more.
  long long line() const { return parts_.line(); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_SPAN_READER_H
