// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYLINE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYLINE_H

#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <optional>
#include <utility>
#include <vector>

/// \file polyline.h
/// Curves as polylines, for algorithms that work on segments. The functions write the vertices to an output iterator, from the
/// start of the curve to its end, both of which are vertices. No two vertices in a row are equal: a curve that is a single
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

// A proof that a Bezier curve x of degree m and its chord L are nowhere farther apart than `tolerance`, in both directions:
//
// (1) |x(t) - L(t)| <= m (m-1) / 8 max |b_i - 2 b_{i+1} + b_{i+2}|: the error of linear interpolation is at most 1/8 of the
//     largest second derivative, and the second derivative is a convex combination of m (m-1) times these differences; or
// (2) no control point is farther than that from the chord. The distance from a convex set is a convex function, so no point
//     of the curve is farther away. And no point of the chord is farther from the curve: the foot on the line of the chord
//     of a point that runs along the curve runs over the whole chord, and while it is on the chord the distance from the
//     chord is that to the foot.
//
// (1) is the better bound for a short piece: it is sharp for parabolas. (2) sees that a straight curve is straight, at
// whatever its speed. All is measured in units of the tolerance, so that squares of doubles do not overflow
// unnoticed. An undefined number proves nothing. (1) is not asked for a rational curve, which (2) holds for if the weights are
// positive.
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
/// Writes a polyline whose Hausdorff distance from the curve is at most `tolerance`, in the unit of the coordinates: no point
/// of either is farther than that from the other. Pieces of the curve are halved until a bound on their distance from the
/// chord is met, so that vertices are dense where the curve bends. Straight pieces are kept whole. \f$ O(\sqrt{s/\tau}) \f$
/// vertices for second derivatives of size \f$ s \f$, each in \f$ O(m^2) \f$; with exact numbers nothing else bounds their
/// number.
///
/// With an exact kernel all vertices lie on the curve. With floating-point numbers they do up to rounding, and the tolerance
/// is kept all the same: a part of it is set aside for all rounding errors (in dimensions up to 16 and degrees up to 200).
///
/// \param curve a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, or what is derived from them, or a rational one; its
///        parts with positive weights are halved
/// \param tolerance positive
/// \param out takes values of type `Traits::Point`
/// \returns the iterator after the last point
/// \throws Error `unreachable_tolerance` unless `tolerance > 0`, and when it is below \f$ (m+1) 2^{-42} \f$ of the largest
///   coordinate of a piece of degree `m` with `double` coordinates, for rational curves times the ratio of the weights and 2
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
/// \throws Error `negative_count` unless `n >= 0`, `wrong_number_of_points` for `n == 0`, and whatever the curve throws
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
/// Writes a polyline within `tolerance` of any curve with a bounded second derivative: the points at equal distances of the
/// parameter, as `uniform_polyline()` does, with the least number `n` of parts for which
/// \f$ \left(\frac{b-a}{n}\right)^2 \frac{s}{8} \f$ is at most `tolerance`. This bounds the distance from the chord at the
/// same parameter, and with it the Hausdorff distance. It is kept up to the rounding of the curve's own points.
/// \tparam Curve a model of `ParametricCurve` that can be evaluated in its whole domain [a, b]
/// \param curve a curve with a continuous first derivative
/// \param s an upper bound of \f$ |x''| \f$ in the domain
/// \param tolerance positive
/// \param out takes values of type `Traits::Point`
/// \returns the iterator after the last point
/// \throws Error `unreachable_tolerance` unless `tolerance > 0` and `s >= 0`, and when `n` would exceed \f$ 2^{30} \f$
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

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYLINE_H
