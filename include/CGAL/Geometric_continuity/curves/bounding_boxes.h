// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BOUNDING_BOXES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BOUNDING_BOXES_H

#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// A box that contains the piece of a curve over a part of its domain. It is a model of the \cgal concept
/// `BoxIntersectionBox_d`: ranges of such boxes go into `CGAL::box_intersection_d()` as they are. There two boxes with equal
/// handles and piece numbers are one box, in two ranges as well: the curves of one call must have different handles.
///
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2 or 3
/// \tparam Handle says which curve it is: a number, a pointer, an iterator; it must be ordered and comparable
template <class Traits, class Handle> class Curve_piece_box {
public:
  typedef typename Traits::FT FT;                    ///< the field
  typedef double NT;                                 ///< the type of the sides of the box
  typedef std::pair<Handle, int> ID;                 ///< the curve and the number of the piece
  typedef std::pair<FT, FT> Interval;                ///< an interval of parameters
  static constexpr int N = Traits::Dimension::value; ///< the dimension
  static_assert(N == 2 || N == 3, "boxes are of dimension 2 or 3");

  /// A box without a curve, for arrays.
  Curve_piece_box() = default;

  /// The box between `low` and `high` of the piece number `piece` of a curve over an interval.
  Curve_piece_box(Handle curve, int piece, Interval interval, const std::array<double, N>& low,
                  const std::array<double, N>& high)
      : id_(std::move(curve), piece), interval_(std::move(interval)), low_(low), high_(high) {}

  /// Returns the handle, which says which curve it is.
  const Handle& handle() const { return id_.first; }
  /// Returns the part of the domain.
  const Interval& interval() const { return interval_; }
  /// Returns the box as a `Bbox_2` or `Bbox_3`.
  auto bbox() const {
    if constexpr (N == 2)
      return Bbox_2(low_[0], low_[1], high_[0], high_[1]);
    else
      return Bbox_3(low_[0], low_[1], low_[2], high_[0], high_[1], high_[2]);
  }

  /// \name BoxIntersectionBox_d
  /// @{

  /// Returns the dimension.
  static int dimension() { return N; }
  /// Returns the curve and the number of the piece.
  const ID& id() const { return id_; }
  /// Returns the smallest `i`-th coordinate of the box. \pre `0 <= i < N`
  double min_coord(int i) const { return low_[i]; }
  /// Returns the largest `i`-th coordinate of the box. \pre `0 <= i < N`
  double max_coord(int i) const { return high_[i]; }

  /// @}

private:
  ID id_;
  Interval interval_;
  std::array<double, N> low_{}, high_{};
};

namespace internal {

// Halves a Bezier curve over [a, b] k times and calls add(a', b', control points) for each part in order.
template <class Curve, class Function>
void for_each_part(const std::vector<Control_row<Curve>>& rows, const typename Curve::FT& a,
                   const typename Curve::FT& b, int k, Function& add) {
  typedef typename Curve::FT FT;
  if (k == 0) return add(a, b, affine_rows<Curve>(rows));
  const auto parts = halves(rows);
  const FT middle = FT(a + (b - a) / FT(2));
  for_each_part<Curve>(parts.first, a, middle, k - 1, add);
  for_each_part<Curve>(parts.second, middle, b, k - 1, add);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Writes boxes that contain the pieces of a curve: each Bézier curve that it is made of is halved `k` times, and each of the
/// \f$ 2^k \f$ pieces gets the box of its control points, rounded outwards. Neighbouring boxes have a point in common. The
/// boxes shrink towards those of the pieces themselves with \f$ 4^{-k} \f$. \f$ O(2^k m^2) \f$
///
/// The boxes are certain with every kernel: those of control points in floating-point numbers are made larger by a bound of all
/// rounding errors (in degrees up to 200).
///
/// \param curve a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, or what is derived from them, or a rational one;
///        of dimension 2 or 3
/// \param k how often to halve, between 0 and 20
/// \param handle is copied into each box, to say which curve it belongs to
/// \param out takes values of type `Curve_piece_box<Traits, Handle>`
/// \returns the iterator after the last box
/// \throws Error `negative_count` unless `k >= 0`, `work_limit` unless `k <= 20`
template <class Curve, class Handle, class OutputIterator>
OutputIterator bounding_boxes(const Curve& curve, int k, const Handle& handle, OutputIterator out) {
  typedef typename Curve::Traits Traits;
  typedef typename Curve::FT FT;
  typedef Curve_piece_box<Traits, Handle> Box;
  typedef std::vector<Geometric_continuity::Coordinates<Traits>> Rows;
  internal::check_count(k, "bounding_boxes: halvings");
  if (k > 20) throw Error(Error_code::work_limit, "bounding_boxes: " + std::to_string(k) + " halvings");
  int piece = 0;
  internal::for_each_piece(curve, [&](const auto& bezier) {
    const std::vector<internal::Control_row<Curve>> polygon = internal::control_rows(bezier);
    const FT allowance = internal::rounding_allowance_of<Curve>(polygon);
    auto add = [&](const FT& a, const FT& b, const Rows& rows) {
      std::array<double, Box::N> low, high;
      for (int i = 0; i < Box::N; ++i) {
        FT least = rows[0][i], greatest = rows[0][i];
        for (const Geometric_continuity::Coordinates<Traits>& row : rows) {
          if (row[i] < least) least = row[i];
          if (greatest < row[i]) greatest = row[i];
        }
        low[i] = CGAL::to_interval(FT(least - allowance)).first;
        high[i] = CGAL::to_interval(FT(greatest + allowance)).second;
      }
      *out++ = Box(handle, piece++, {a, b}, low, high);
    };
    internal::for_each_part<Curve>(polygon, bezier.domain().first, bezier.domain().second, k, add);
  });
  return out;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BOUNDING_BOXES_H
