// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_ALIGNMENT_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_ALIGNMENT_JOIN_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>
#include <CGAL/Geometric_continuity/curves/internal/alignment_numbers.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

/// \file alignment_join.h
/// Joins of roads and rails: how far two ends are apart, in position, direction and curvature, as
/// enclosures, and verdicts about tolerances. Floating-point numbers decide first; where they leave
/// a question open, integers of more and more bits do. By the theorem of Lindemann and Weierstrass
/// a number that is not rational never equals a rational tolerance, except by a coincidence of
/// Fresnel integrals, so the refinement ends.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlignments
/// The tolerances at a join, which are exact numbers and inclusive.
struct Alignment_tolerance {
  /// The number type.
  typedef Exact_field<double>::type FT;

  FT gap = FT(FT(1) / FT(1000));          ///< in units of the coordinates
  FT kink = FT(FT(1) / FT(1000));         ///< in radians
  FT curvature = FT(FT(1) / FT(1000000)); ///< in units of 1/length
};

/// \ingroup PkgGeometricContinuityAlignments
/// A distance, or the absolute value of another difference, and what is decided about it.
struct Decided_distance {
  Enclosure distance; ///< encloses it
  bool is_zero;       ///< is true when it is proved to be exactly 0
  Verdict within;     ///< answers if it is at most the tolerance
};

/// \ingroup PkgGeometricContinuityAlignments
/// A join of two ends.
struct Alignment_join {
  Enclosure gap;                 ///< the distance of the points
  Enclosure kink;                ///< the angle between the directions, in \f$ [0, \pi] \f$
  std::optional<Enclosure> jump; ///< the difference of the curvatures; empty when one is not defined
  bool same_point;               ///< is true when the gap is proved to be exactly 0
  bool same_heading;             ///< is true when the kink is proved to be exactly 0
  bool same_curvature;           ///< is true when the jump is proved to be exactly 0
  Verdict g0;                    ///< answers if the gap is within its tolerance
  Verdict g1;                    ///< answers if the kink is within its tolerance, whatever the gap
  Verdict g2;                    ///< answers if the jump is within its tolerance, whatever the rest

  /// Returns the order within the tolerances: -1 for a gap, 0 for a kink, 1 for a jump, else 2.
  /// Empty when the verdict on which it depends is undecided.
  std::optional<int> order() const {
    int k = -1;
    for (const Verdict v : {g0, g1, g2}) {
      if (v == Verdict::undecided) return std::nullopt;
      if (v == Verdict::refuted) break;
      ++k;
    }
    return k;
  }
};

namespace internal {

template <class Compute>
Decided_distance decided_distance(const char* place, const Rational& tolerance, const Compute& compute) {
  Decided_distance result{};
  with_more_and_more_bits(place, [&](const auto& a) {
    const typename std::decay_t<decltype(a)>::Number x = compute(a);
    result.within = a.at_most(x, tolerance);
    result.distance = a.enclosure(x);
    result.distance.lower = (std::max)(result.distance.lower, 0.);
    return result.within != Verdict::undecided && (is_narrow(result.distance) || a.accuracy() > 300);
  });
  return result;
}

// A rational difference.
inline Decided_distance exact_distance(const Rational& difference, const Rational& tolerance) {
  const Rational x = difference < 0 ? Rational(-difference) : difference;
  return {enclosure(x), x == 0, x <= tolerance ? Verdict::proved : Verdict::refuted};
}

inline Decided_distance decide_kink(const Direction& x, const Direction& y, const Rational& tolerance) {
  const Rational difference = Rational(x.angle - y.angle), cosine = Rational(x.x * y.x + x.y * y.y),
                 sine = Rational(x.y * y.x - x.x * y.y);
  const bool parallel = !x.end && !y.end && sine == 0 && cosine > 0;
  if (parallel && difference <= 3 && -3 <= difference) return exact_distance(difference, tolerance);
  return decided_distance("alignment_join: kink", tolerance, [&](const auto& a) {
    typedef typename std::decay_t<decltype(a)>::Number Number;
    Number angle = a(difference);
    if (!parallel) {
      Complex_number<Number> v{a(cosine), a(sine)};
      if (x.end) v = v * Complex_number<Number>{a(1), graph_end(a, *x.end).slope};
      if (y.end) v = v * Complex_number<Number>{a(1), -graph_end(a, *y.end).slope};
      angle = angle + angle_of_vector(a, v.re, v.im);
    }
    const Number pi = a.pi();
    if (!std::isfinite(a.middle(angle))) return a.hull(a(0), pi); // beyond floating-point numbers
    const Rational turns(std::nearbyint(a.middle(angle) / 6.283185307179586));
    const Number rest = a.absolute_value(turns == 0 ? angle : angle - a(Rational(2 * turns)) * pi);
    return a.magnitude(rest) < 3 ? rest : pi - a.absolute_value(pi - rest);
  });
}

inline Decided_distance decide_jump(const End_curvature& left, const End_curvature& right, const Rational& tolerance) {
  if (left == right) return {{0, 0}, true, Verdict::proved};
  const Curvature &x = Alignment_parts::of(left), &y = Alignment_parts::of(right);
  if (left.is_exact() && right.is_exact() && x.rational && y.rational)
    return exact_distance(Rational(*x.rational - *y.rational), tolerance);
  return decided_distance("alignment_join: curvature", tolerance, [&](const auto& a) {
    return a.absolute_value(curvature_number(a, x) - curvature_number(a, y));
  });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlignments
/// Encloses the distance of two points, and decides whether it is at most `tolerance`. The distance
/// of rational points is decided exactly.
/// \throws Error `parameter_outside_domain` when a piece on the way to a point turns by more than
///   20000 radians, `work_limit`
inline Decided_distance point_distance(const Enclosed_point& p, const Enclosed_point& q,
                                       const Exact_field<double>::type& tolerance) {
  typedef internal::Rational Rational;
  const internal::Point_sum &x = internal::Alignment_parts::of(p), &y = internal::Alignment_parts::of(q);
  const Rational dx = Rational(x.x - y.x), dy = Rational(x.y - y.y);
  if (x.is_rational() && y.is_rational()) {
    const Rational square = Rational(dx * dx + dy * dy);
    const bool within = tolerance >= 0 && square <= Rational(tolerance * tolerance);
    return {sqrt_enclosure(square), square == 0, within ? Verdict::proved : Verdict::refuted};
  }
  return internal::decided_distance("point_distance", tolerance, [&](const auto& a) {
    typedef typename std::decay_t<decltype(a)>::Number Number;
    internal::Complex_number<Number> d{a(dx), a(dy)};
    x.add_to(a, 1, d);
    y.add_to(a, -1, d);
    const Number re = a.absolute_value(d.re), im = a.absolute_value(d.im);
    return a.square_root(re * re + im * im);
  });
}

/// \ingroup PkgGeometricContinuityAlignments
/// Decides the join between the end of one piece and the start of the next.
/// \throws Error `parameter_outside_domain` when a piece turns by more than 20000 radians, and for
///   a negative tolerance; `work_limit`
inline Alignment_join alignment_join(const Alignment_end& left, const Alignment_end& right,
                                     const Alignment_tolerance& tolerance = {}) {
  for (const auto* t : {&tolerance.gap, &tolerance.kink, &tolerance.curvature})
    if (*t < 0) throw Error(Error_code::parameter_outside_domain, "alignment_join: a negative tolerance");
  const Decided_distance gap = point_distance(left.point, right.point, tolerance.gap),
                         kink = internal::decide_kink(internal::Alignment_parts::of(left.heading),
                                                      internal::Alignment_parts::of(right.heading), tolerance.kink);
  Alignment_join join{gap.distance, kink.distance, std::nullopt, gap.is_zero,       kink.is_zero,
                      false,        gap.within,    kink.within,  Verdict::undecided};
  if (left.curvature && right.curvature) {
    const Decided_distance jump = internal::decide_jump(*left.curvature, *right.curvature, tolerance.curvature);
    join.jump = jump.distance;
    join.same_curvature = jump.is_zero;
    join.g2 = jump.within;
  }
  return join;
}

/// \ingroup PkgGeometricContinuityAlignments
/// A point beside an alignment in space, such as on the border of a lane: `offset` to the left of
/// an end, along a line that is turned out of the horizontal plane by `roll` radians.
struct Border_point {
  /// The number type.
  typedef Exact_field<double>::type FT;

  Enclosed_point plan; ///< its position seen from above
  FT elevation = 0;    ///< the height of the alignment
  FT offset = 0;       ///< the distance from the alignment, to the left
  FT roll = 0;         ///< the angle, positive where the left side is high

  /// Constructs the point that lies `t` to the left, with the height `z` + t sin `phi`.
  Border_point(const Alignment_end& end, const FT& t, const FT& phi = FT(0), const FT& z = FT(0))
      : plan(end.point.moved(end.heading, FT(0), t, phi)), elevation(z), offset(t), roll(phi) {}
};

/// \ingroup PkgGeometricContinuityAlignments
/// Encloses the difference of the heights of two points, and decides whether it is at most
/// `tolerance`.
inline Decided_distance height_distance(const Border_point& p, const Border_point& q,
                                        const Exact_field<double>::type& tolerance) {
  typedef internal::Rational Rational;
  const Rational level = Rational(p.elevation - q.elevation);
  const auto is_level = [](const Border_point& x) { return x.offset == 0 || x.roll == 0; };
  if ((is_level(p) && is_level(q)) || (p.offset == q.offset && p.roll == q.roll))
    return internal::exact_distance(level, tolerance);
  return internal::decided_distance("height_distance", tolerance, [&](const auto& a) {
    typedef typename std::decay_t<decltype(a)>::Number Number;
    const auto height = [&](const Border_point& x) -> Number {
      return is_level(x) ? a(0) : a(x.offset) * a.cosine_and_sine(a(x.roll)).sine;
    };
    return a.absolute_value(a(level) + height(p) - height(q));
  });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_ALIGNMENT_JOIN_H
