// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ROTATED_ELLIPSE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ROTATED_ELLIPSE_H

#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

/// \file Rotated_ellipse.h
/// The data that an arc of an ellipse needs of a rotation by an angle \f$ \varphi \f$. Its quarter
/// turn and \f$ \lambda \f$, see `Elliptical_arc`, are linear in \f$ \cos 2\varphi \f$ and
/// \f$ \sin 2\varphi \f$: with \f$ p, q = \frac12 (\frac{r_y}{r_x} \pm \frac{r_x}{r_y}) \f$
/// \f[ k = p\,(-h_y, h_x) + q \cos 2\varphi\,(h_y, h_x) + q \sin 2\varphi\,(-h_x, h_y), \quad
///     \lambda r_x r_y = p\,(h_x^2 + h_y^2) + q \cos 2\varphi\,(h_x^2 - h_y^2) + q \sin 2\varphi\,2 h_x h_y. \f]
/// So both are rational for multiples of 45 degrees.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Numbers that are linear in the cosine and the sine of an angle: x[0] + x[1] cos + x[2] sin.
template <class FT> using Turned_number = std::array<FT, 3>;

template <class Number, class FT> Number turned(const Turned_number<FT>& x, const Number& cosine, const Number& sine) {
  return Number(Number(Number(x[0]) + Number(Number(x[1]) * cosine)) + Number(Number(x[2]) * sine));
}

// The quarter turn of half a chord and lambda, as functions of an angle between 0 and 90 degrees,
// which is not rational.
template <class FT> struct Rotated_ellipse {
  FT degrees; // of the angle, twice that of the rotation up to half turns and the sign
  std::array<Turned_number<FT>, 2> k;
  Turned_number<FT> lambda;

  // Makes an ellipse with these radii, rotated by so many degrees.
  Rotated_ellipse(const FT& rx, const FT& ry, const FT& rotation, const std::array<FT, 2>& h) {
    const FT area = FT(rx * ry), half = FT(FT(2) * area), p = FT(FT(rx * rx + ry * ry) / half),
             q = FT(FT(ry * ry - rx * rx) / half), x = h[0], y = h[1];
    k[0] = {FT(FT(0) - p * y), FT(q * y), FT(FT(0) - q * x)};
    k[1] = {FT(p * x), FT(q * x), FT(q * y)};
    lambda = {FT(p * FT(x * x + y * y) / area), FT(q * FT(x * x - y * y) / area), FT(FT(2) * q * x * y / area)};
    const Quarter_turns<FT> turns(rotation), more(FT(FT(2) * turns.rest));
    degrees = more.rest;
    for (int i = (2 * turns.count + more.count) % 4; i > 0; --i) add_quarter_turn();
    if (degrees < FT(0)) {
      degrees = FT(FT(0) - degrees);
      change_sign(2);
    }
  }

  // Returns whether the angle is zero.
  bool is_rational() const { return degrees == FT(0); }

private:
  template <class Function> void for_each_number(Function f) {
    f(k[0]);
    f(k[1]);
    f(lambda);
  }
  void change_sign(std::size_t part) {
    for_each_number([&](Turned_number<FT>& x) { x[part] = FT(FT(0) - x[part]); });
  }
  // cos(t + 90) = -sin(t), sin(t + 90) = cos(t)
  void add_quarter_turn() {
    for_each_number([](Turned_number<FT>& x) { std::swap(x[1], x[2]); });
    change_sign(2);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ROTATED_ELLIPSE_H
