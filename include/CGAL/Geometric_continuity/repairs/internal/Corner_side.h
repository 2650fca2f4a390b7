// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_CORNER_SIDE_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_CORNER_SIDE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/repairs/internal/Measured_polygon.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

// A curve that leads to a corner, measured from there on.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The square root of a positive number, exactly where it is rational and the number type tells;
// otherwise it is rounded to a floating-point number, in one way for equal numbers. `near` is a
// number of its size.
template <class FT> FT length_of_square(const FT& square, double near) {
  if constexpr (has_rational_roots<FT>())
    if (const std::optional<FT> root = rational_square_root(square)) return *root;
  const int e = (std::min)((std::max)(std::ilogb(near), -1000), 1000);
  const FT scale(std::ldexp(1., -e)), scaled = FT(FT(square * scale) * scale);
  return FT(std::ldexp(std::sqrt(CGAL::to_double(Exact_number<FT>::of(scaled))), e));
}

template <class Curve> class Corner_side {
  typedef typename Curve::FT FT;
  typedef Coordinate_vector<FT, Curve::N> Vector;

  const Curve& curve_;
  const Curve_end end_;
  const Measured_polygon<Curve::N> polygon_;
  const double near_; // its length
  const bool is_line_;
  const FT length_;

  // The control points and weights, counted from the corner.
  int number(int j) const { return end_ == Curve_end::start ? j : curve_.degree() - j; }
  Vector side(int j) const { return curve_.coordinates(number(j)) - curve_.coordinates(number(0)); }
  FT weight(int j) const {
    if constexpr (Is_rational<Curve>::value)
      return curve_.weight(number(j));
    else
      return FT(1);
  }

  // Returns whether it is a line whose arc length is known at each parameter: one of degree 1 with
  // positive weights, or one that is run through at one speed.
  bool is_line() const {
    const int m = curve_.degree();
    if (m == 0 || !(0 < near_)) return false;
    if (m == 1) return FT(0) < FT(weight(0) * weight(1));
    const Vector chord = side(m);
    for (int j = 1; j <= m; ++j)
      if (weight(j) != weight(0) || FT(m) * side(j) != FT(j) * chord) return false;
    return true;
  }

  FT measured_length() const {
    if constexpr (!std::is_floating_point_v<FT>)
      if (is_line_) return length_of_square(FT(dot(side(curve_.degree()), side(curve_.degree()))), near_);
    return FT(near_);
  }

  // The part of the domain up to a point of a line, where the weights of a line of degree 1 may
  // differ.
  FT part_of_line(const FT& distance) const {
    const FT part = FT(distance / length_), first = weight(0), last = weight(curve_.degree());
    if (first == last) return part;
    const FT weighted = FT(part * first);
    return FT(weighted / FT(weighted + FT(FT(FT(1) - part) * last)));
  }

public:
  // \throws Error `not_finite` when the size of the curve is out of the range of `double`
  Corner_side(const Curve& curve, Curve_end end)
      : curve_(curve), end_(end), polygon_(curve, end), near_(polygon_.length()), is_line_(is_line()),
        length_(measured_length()) {}

  // The arc length: exact for a line with a rational length and an exact number type, with a
  // relative error of at most 2^-12 for a curve.
  const FT& length() const { return length_; }

  // The parameter of the curve at this distance from the corner. \pre 0 < distance <
  // length() \throws Error `not_representable`
  FT parameter_at(const FT& distance) const {
    const std::pair<FT, FT> domain = curve_.domain();
    const FT part = is_line_ ? part_of_line(distance) : FT(polygon_.parameter_at(CGAL::to_double(distance))),
             step = FT(part * FT(domain.second - domain.first));
    return end_ == Curve_end::start ? FT(domain.first + step) : FT(domain.second - step);
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_CORNER_SIDE_H
