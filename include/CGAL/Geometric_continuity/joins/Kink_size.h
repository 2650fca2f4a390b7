// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_KINK_SIZE_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_KINK_SIZE_H

#include <CGAL/Geometric_continuity/joins/internal/Image_end.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// How large a kink is: guaranteed enclosures. With `a` and `b` for the handles at the node, from the control point before it and to
/// the one behind it:
struct Kink_size {
  Enclosure angle; ///< the angle between `a` and `b`, in radians, in \f$ [0, \pi] \f$
  /// By how much a handle is off, in units of the coordinates: how far the tip of one of them must move at least to make their directions
  /// equal, \f$ |a \times b| / \max(|a|, |b|) \f$; from a right angle on \f$ \min(|a|, |b|) \f$. On a grid, about one unit is rounding.
  Enclosure handle_offset;
  /// What the eye sees: the angle times the length of the shorter handle, in units of the coordinates. Compare it to the size of what is
  /// drawn, an em or a drawing.
  Enclosure severity;

  /// Writes e.g. `angle [0.0499583, 0.0499584], handle off by 1, severity [0.999166, 0.999167]`.
  friend std::ostream& operator<<(std::ostream& os, const Kink_size& k) {
    return os << "angle " << k.angle << ", handle off by " << k.handle_offset << ", severity " << k.severity;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns how large the angle at the join between the end of `left` and the start of `right` is, whatever the curvatures; empty when one of
/// the curves has no length. A handle that is retracted is taken as `join_grade()` takes it: by the first leg that is not zero.
/// Everything is computed in an exact field from the control points as given and rounded once, outwards. A gap is not seen.
/// \throws Error `not_finite` for an infinite or undefined coordinate
template <class Traits, int Left, int Right>
std::optional<Kink_size> kink_size(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  static_assert(dimension_v<Traits> == 2, "kinks are those of curves in the plane");
  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  const internal::Image_end<Traits, Left, Curve_end::end> x(left);
  const internal::Image_end<Traits, Right, Curve_end::start> y(right);
  if (!x.has_length() || !y.has_length()) return std::nullopt;
  const std::array<Field, 2> a = x.template vector<Field>(), b = y.template vector<Field>();
  const internal::Leg_products<Field> ab(a, b);
  const Field aa = internal::Leg_products<Field>(a, a).dot, bb = internal::Leg_products<Field>(b, b).dot,
              shorter = (std::min)(aa, bb), longer = (std::max)(aa, bb), sine_squared = Field(ab.cross * ab.cross);
  const Enclosure angle = angle_enclosure(sine_squared, ab.dot), handle = root_enclosure(shorter);
  const Enclosure offset = Field(0) < ab.dot ? root_enclosure(Field(sine_squared / longer)) : handle;
  return Kink_size{angle, offset, internal::nonnegative_product(angle, handle)};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_KINK_SIZE_H
