// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYLINE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYLINE_H

#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file polyline.h
/// Curves as polylines and in boxes, for algorithms that work on segments or boxes. The functions
/// that make polylines write the vertices to an output iterator, from the start of the curve to its
/// end, both of which are vertices. No two vertices in a row are equal: a curve that is a single
/// point gives one vertex. The polyline of a closed curve ends with the point with which it starts.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Writes points, but none that is equal to the one before it.
template <class Traits, class OutputIterator> class Polyline_output {
  OutputIterator out_;
  std::optional<Coordinates<Traits>> last_;

public:
  explicit Polyline_output(OutputIterator out) : out_(std::move(out)) {}
  OutputIterator iterator() const { return out_; }

  void add(const Coordinates<Traits>& x) {
    if (last_ && *last_ == x) return;
    *out_++ = to_point<Traits>(x);
    last_ = x;
  }
};

// The squared distance of x from the segment between p and q is at most 1.
template <class FT, int N>
bool is_near_segment(const Coordinate_vector<FT, N>& x, const Coordinate_vector<FT, N>& p,
                     const Coordinate_vector<FT, N>& q) {
  typedef Coordinate_vector<FT, N> Coordinates;
  const Coordinates v = x - p, w = q - p;
  const FT t = dot(v, w), ww = dot(w, w);
  if (t <= FT(0)) return dot(v, v) <= FT(1);
  if (t >= ww) return dot(x - q, x - q) <= FT(1);
  const Coordinates h = ww * v - t * w; // ww times the perpendicular
  return dot(h, h) <= FT(ww * ww);
}

// A proof that a Bezier curve x of degree m and its chord L are nowhere farther apart than
// `tolerance`, in both directions:
//
// (1) |x(t) - L(t)| <= m (m-1) / 8 max |b_i - 2 b_{i+1} + b_{i+2}|: the error of linear
//     interpolation is at most 1/8 of the largest second derivative, and the second derivative is a
//     convex combination of m (m-1) times these differences; or
// (2) no control point is farther than that from the chord. The distance from a convex set is a
//     convex function, so no point of the curve is farther away. And no point of the chord is
//     farther from the curve: the foot on the line of the chord of a point that runs along the
//     curve runs over the whole chord, and while it is on the chord the distance from the chord is
//     that to the foot.
//
// (1) is the better bound for a short piece: it is sharp for parabolas. (2) sees that a straight
//     curve is straight, at
// whatever its speed. All is measured in units of the tolerance, so that squares of doubles do not
// overflow unnoticed. An undefined number proves nothing. (1) is not asked for a rational curve,
// which (2) holds for if the weights are positive.
template <class FT, int N>
bool is_chord_near(const std::vector<Coordinate_vector<FT, N>>& rows, const FT& tolerance, bool polynomial) {
  typedef Coordinate_vector<FT, N> Coordinates;
  const int m = static_cast<int>(rows.size()) - 1;
  const FT factor = FT(FT(m) * FT(m - 1) / FT(8));
  bool near_chord = true, slow = polynomial;
  const Coordinates start = rows[0] / tolerance, end = rows[m] / tolerance;
  for (int i = 1; i < m && near_chord; ++i) near_chord = is_near_segment<FT, N>(rows[i] / tolerance, start, end);
  for (int i = 1; i < m && slow && !near_chord; ++i) {
    const Coordinates second = factor * ((rows[i - 1] - rows[i]) + (rows[i + 1] - rows[i])) / tolerance;
    slow = dot(second, second) <= FT(1);
  }
  return near_chord || slow;
}

// Writes the vertices after the first one for a Bezier curve with these control points.
template <class Curve, class Output>
void add_chords(const std::vector<Control_row<Curve>>& rows, const typename Curve::FT& tolerance, Output& output) {
  const std::vector<Coordinates<typename Curve::Traits>> points = affine_rows<Curve>(rows);
  if (is_chord_near<typename Curve::FT, Curve::N>(points, tolerance, !Is_rational<Curve>::value))
    return output.add(points.back());
  const auto parts = halves(rows);
  add_chords<Curve>(parts.first, tolerance, output);
  add_chords<Curve>(parts.second, tolerance, output);
}

template <class FT> void check_tolerance(const FT& tolerance, const char* place) {
  check_finite(tolerance, place);
  if (!(FT(0) < tolerance)) throw Error(Error_code::unreachable_tolerance, place);
}

// A B-spline curve may jump, and then it has no polyline.
template <class Curve> void check_continuous(const Curve&) {}
template <class Traits> void check_continuous(const Bspline_curve<Traits>& curve) {
  const auto f = curve.function();
  for (const auto& knot : curve.knots().inner_knots())
    if (knot.multiplicity > curve.degree() && bspline_smoothness(f.knots(), f.coefficients(), knot.value) < 0)
      throw Error(Error_code::curves_do_not_meet, "chord_polyline: the curve jumps at a knot");
}
template <class Traits> void check_continuous(const Rational_bspline_curve<Traits>& curve) {
  if (curve.is_polynomial()) return check_continuous(*curve.polynomial());
  for (const auto& knot : curve.knots().inner_knots())
    if (knot.multiplicity > curve.degree() && curve.left_jet(knot.value, 0) != curve.right_jet(knot.value, 0))
      throw Error(Error_code::curves_do_not_meet, "chord_polyline: the curve jumps at a knot");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Writes a polyline whose Hausdorff distance from the curve is at most `tolerance`, in the unit of
/// the coordinates: no point of either is farther than that from the other. Pieces of the curve are
/// halved until a bound on their distance from the chord is met, so that vertices are dense where
/// the curve bends. Straight pieces are kept whole. \f$ O(\sqrt{s/\tau}) \f$ vertices for second
/// derivatives of size \f$ s \f$, each in \f$ O(m^2) \f$; with exact numbers nothing else bounds
/// their number.
///
/// With an exact kernel all vertices lie on the curve. With floating-point numbers they do up to
/// rounding, and the tolerance is kept all the same: a part of it is set aside for all rounding
/// errors (in dimensions up to 16 and degrees up to 200).
///
/// \param curve a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, or what is derived
///   from them, or a rational one; its
///        parts with positive weights are halved
/// \param tolerance positive
/// \param out takes values of type `Traits::Point`
/// \returns the iterator after the last point
/// \throws Error `unreachable_tolerance` unless `tolerance > 0`, and when it is below
///   \f$ (m+1) 2^{-42} \f$ of the largest coordinate of a piece of degree `m` with `double`
///   coordinates, for rational curves times the ratio of the weights and 2
/// \throws Error `not_finite` for an infinite or undefined tolerance
/// \throws Error `curves_do_not_meet` for a B-spline curve that jumps
template <class Curve, class OutputIterator>
OutputIterator chord_polyline(const Curve& curve, const typename Curve::FT& tolerance, OutputIterator out) {
  typedef typename Curve::Traits Traits;
  typedef typename Curve::FT FT;
  internal::check_tolerance<FT>(tolerance, "chord_polyline: tolerance");
  internal::check_continuous(curve);
  std::vector<std::vector<internal::Control_row<Curve>>> pieces;
  internal::for_each_piece(curve, [&](const auto& piece) { pieces.push_back(internal::control_rows(piece)); });
  for (const auto& rows : pieces)
    if (tolerance < FT(FT(4) * internal::rounding_allowance_of<Curve>(rows)))
      throw Error(Error_code::unreachable_tolerance,
                  "chord_polyline: rounding errors may be larger than the tolerance");
  internal::Polyline_output<Traits, OutputIterator> output(std::move(out));
  output.add(internal::affine_rows<Curve>(pieces.front()).front());
  for (const auto& rows : pieces)
    internal::add_chords<Curve>(rows, FT(tolerance - internal::rounding_allowance_of<Curve>(rows)), output);
  return output.iterator();
}

/// \ingroup PkgGeometricContinuityCurves
/// Writes the points at the `n + 1` parameters that divide the domain into `n` equal parts.
/// \tparam Curve a model of `ParametricCurve` that can be evaluated in its whole domain
/// \returns the iterator after the last point
/// \throws Error `negative_count` unless `n >= 0`, `wrong_number_of_points` for `n == 0`, and
///   whatever the curve throws
template <class Curve, class OutputIterator>
OutputIterator uniform_polyline(const Curve& curve, int n, OutputIterator out) {
  typedef typename Curve::Traits Traits;
  typedef typename Traits::FT FT;
  internal::check_count(n, "uniform_polyline: parts");
  if (n == 0) throw Error(Error_code::wrong_number_of_points, "uniform_polyline: no parts");
  internal::Polyline_output<Traits, OutputIterator> output(std::move(out));
  const std::pair<FT, FT> domain = curve.domain();
  for (int i = 0; i < n; ++i) {
    const FT t = FT(FT(i) / FT(n));
    output.add(curve.jet(FT((FT(1) - t) * domain.first + t * domain.second), 0)[0]);
  }
  output.add(curve.jet(domain.second, 0)[0]);
  return output.iterator();
}

/// \ingroup PkgGeometricContinuityCurves
/// Writes a polyline within `tolerance` of any curve with a bounded second derivative: the points
/// at equal distances of the parameter, as `uniform_polyline()` does, with the least number `n` of
/// parts for which \f$ \left(\frac{b-a}{n}\right)^2 \frac{s}{8} \f$ is at most `tolerance`. This
/// bounds the distance from the chord at the same parameter, and with it the Hausdorff distance. It
/// is kept up to the rounding of the curve's own points.
/// \tparam Curve a model of `ParametricCurve` that can be evaluated in its whole domain [a, b]
/// \param curve a curve with a continuous first derivative
/// \param s an upper bound of \f$ |x''| \f$ in the domain
/// \param tolerance positive
/// \param out takes values of type `Traits::Point`
/// \returns the iterator after the last point
/// \throws Error `unreachable_tolerance` unless `tolerance > 0` and `s >= 0`, and when `n` would
///   exceed \f$ 2^{30} \f$
/// \throws Error `not_finite` when one of them is infinite or undefined
template <class Curve, class OutputIterator>
OutputIterator chord_polyline(const Curve& curve, const typename Curve::Traits::FT& s,
                              const typename Curve::Traits::FT& tolerance, OutputIterator out) {
  typedef typename Curve::Traits::FT FT;
  internal::check_tolerance<FT>(tolerance, "chord_polyline: tolerance");
  internal::check_finite(s, "chord_polyline: bound of the second derivative");
  const FT h = FT(curve.domain().second - curve.domain().first);
  const FT parts_squared = FT(h * h / FT(8) * (s / tolerance));
  const auto suffices = [&](int n) { return parts_squared <= FT(FT(n) * FT(n)); };
  int high = 1;
  while (!suffices(high) && high < 1 << 30) high *= 2;
  if (!suffices(high) || s < FT(0))
    throw Error(Error_code::unreachable_tolerance, "chord_polyline: bound of the second derivative");
  int low = high / 2;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (suffices(middle) ? high : low) = middle;
  }
  return uniform_polyline(curve, high, std::move(out));
}

/// \ingroup PkgGeometricContinuityCurves
/// A box that contains the piece of a curve over a part of its domain. It is a model of the \cgal
/// concept `BoxIntersectionBox_d`: ranges of such boxes go into `CGAL::box_intersection_d()` as
/// they are. There two boxes with equal handles and piece numbers are one box, in two ranges as
/// well: the curves of one call must have different handles.
///
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2 or 3
/// \tparam Handle says which curve it is: a number, a pointer, an iterator; it must be ordered and
///   comparable
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

// Halves a Bezier curve over [a, b] k times and calls add(a', b', control points) for each part in
// order.
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
/// Writes boxes that contain the pieces of a curve: each Bézier curve that it is made of is halved
/// `k` times, and each of the \f$ 2^k \f$ pieces gets the box of its control points, rounded
/// outwards. Neighbouring boxes have a point in common. The boxes shrink towards those of the
/// pieces themselves with \f$ 4^{-k} \f$. \f$ O(2^k m^2) \f$
///
/// The boxes are certain with every kernel: those of control points in floating-point numbers are
/// made larger by a bound of all rounding errors (in degrees up to 200).
///
/// \param curve a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, or what is derived
///   from them, or a rational one;
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

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYLINE_H
