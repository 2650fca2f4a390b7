// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_CLOTHOID_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_CLOTHOID_BLEND_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/oscillating_integral.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file clothoid_blend.h
/// Three clothoids that lead from one end to another with continuous curvature, after Bertolazzi
/// and Frego. Their lengths and curvatures are found in floating-point arithmetic; then each of
/// them starts where the one before ends, rounded from an enclosure, and the joins are enclosed.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlignments
/// Three clothoids between two ends, and their joins: with the start, with each other, and with the
/// end.
struct Clothoid_blend {
  std::array<Clothoid_segment, 3> segments; ///< all numbers but those of `start` are decimals of at most 17 digits
  std::array<Alignment_join, 4> joins;      ///< the curvatures are equal exactly
};

namespace internal {

// The arithmetic of floating-point numbers, which proves nothing.
struct Plain_arithmetic {
  typedef double Number;

  static constexpr int accuracy() { return 60; }
  static void charge(double) {}
  double operator()(int x) const { return x; }
  static double symmetric(int) { return 0; }
};

// A displacement and a turn.
struct Plain_way {
  std::complex<double> displacement;
  double turn;

  void append(double k0, double k1, double length) {
    const int pieces = (std::max)(1, static_cast<int>(std::ceil((std::fabs(k0) + std::fabs(k1 - k0)) * length)));
    const double h = 1. / pieces;
    for (int i = 0; i < pieces; ++i) {
      const double start = k0 + (k1 - k0) * h * i, step = length * h;
      const std::vector<double> t = {start * step, (k1 - k0) * h * step};
      const int terms = number_of_terms(Plain_arithmetic::accuracy(),
                                        [&](double r) { return std::fabs(t[0]) * r + std::fabs(t[1]) * r * r / 2; });
      const Complex_number<double> z = integral_of_series(Plain_arithmetic(), t, terms);
      displacement += step * std::polar(1., turn) * std::complex<double>(z.re, z.im);
      turn += t[0] + t[1] / 2;
    }
  }
};

// Three clothoids: their lengths, and the curvatures at both ends and at the two joins.
struct Three_clothoids {
  std::array<double, 3> length;
  std::array<double, 4> curvature;

  bool is_reasonable() const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(length[i] > 0)) return false;
      sum += length[i] * (std::fabs(curvature[i]) + std::fabs(curvature[i + 1]));
    }
    return sum < 200;
  }
  Plain_way way(double heading) const {
    Plain_way w{0, heading};
    for (std::size_t i = 0; i < 3; ++i) w.append(curvature[i], curvature[i + 1], length[i]);
    return w;
  }
  double& unknown(std::size_t i) { return i < 2 ? curvature[i + 1] : length[1]; }
};

// Solves a system of three equations by elimination.
inline std::optional<std::array<double, 3>> solved(std::array<std::array<double, 4>, 3> a) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i; r < 3; ++r)
      if (std::fabs(a[r][i]) > std::fabs(a[pivot][i])) pivot = r;
    std::swap(a[i], a[pivot]);
    if (!(std::fabs(a[i][i]) > 0)) return std::nullopt;
    for (std::size_t r = 0; r < 3; ++r)
      if (r != i) {
        const double factor = a[r][i] / a[i][i];
        for (std::size_t c = i; c < 4; ++c) a[r][c] -= factor * a[i][c];
      }
  }
  return std::array<double, 3>{a[0][3] / a[0][0], a[1][3] / a[1][1], a[2][3] / a[2][2]};
}

// Where three clothoids should lead, in the frame in which the chord is 1 and lies on the x-axis.
struct Blend_goal {
  double heading, turn_to; // of the start and the end

  std::array<double, 3> error(const Three_clothoids& c) const {
    const Plain_way w = c.way(heading);
    return {w.displacement.real() - 1, w.displacement.imag(), w.turn - turn_to};
  }
  // A step of Newton's iteration that removes an error; the derivatives are differences.
  std::optional<std::array<double, 3>> step(const Three_clothoids& c,
                                            const std::array<double, 3>& error_to_remove) const {
    std::array<std::array<double, 4>, 3> system;
    for (std::size_t j = 0; j < 3; ++j) {
      Three_clothoids more = c, less = c;
      const double h = 1e-6 * (std::max)(1., std::fabs(more.unknown(j)));
      more.unknown(j) += h;
      less.unknown(j) -= h;
      const std::array<double, 3> e = error(more), f = error(less);
      for (std::size_t i = 0; i < 3; ++i) system[i][j] = (e[i] - f[i]) / (2 * h);
    }
    for (std::size_t i = 0; i < 3; ++i) system[i][3] = -error_to_remove[i];
    return solved(system);
  }
  static double size(const std::array<double, 3>& e) { return std::hypot(e[0], e[1], e[2]); }

  // Newton's iteration with halved steps where a whole one does not help.
  bool reach(Three_clothoids& c) const {
    std::array<double, 3> e = error(c);
    for (int i = 0; i < 60; ++i) {
      const auto s = step(c, e);
      if (!s) return false;
      double factor = 1;
      for (;; factor /= 2) {
        if (factor < 1e-3) return size(e) < 1e-12;
        Three_clothoids next = c;
        for (std::size_t j = 0; j < 3; ++j) next.unknown(j) += factor * (*s)[j];
        if (!next.is_reasonable()) continue;
        const std::array<double, 3> f = error(next);
        if (!(size(f) < size(e))) continue;
        c = next;
        e = f;
        break;
      }
    }
    return size(e) < 1e-12;
  }
};

// The curvatures and the length of one clothoid along a chord of 1, with headings at both ends:
// sharpness A with the integral of sin(A w^2 + (d - A) w + a) over [0, 1] zero.
inline std::optional<std::array<double, 3>> single_clothoid(double a, double b) {
  const double d = b - a;
  const auto integral = [&](double sharpness) {
    Plain_way w{0, a};
    w.append(d - sharpness, d + sharpness, 1);
    return w.displacement;
  };
  double sharpness = 3 * (a + b);
  for (int i = 0; i < 50; ++i) {
    const double h = 1e-6, y = integral(sharpness).imag(),
                 slope = (integral(sharpness + h).imag() - integral(sharpness - h).imag()) / (2 * h);
    const double step = y / slope;
    if (!std::isfinite(step)) return std::nullopt;
    sharpness -= (std::max)(-2., (std::min)(2., step));
    if (std::fabs(step) < 1e-9) break;
  }
  const double scale = integral(sharpness).real();
  if (!(scale > 1e-3)) return std::nullopt;
  return std::array<double, 3>{(d - sharpness) * scale, (d + sharpness) * scale, 1 / scale};
}

// Clothoids for the goal. The outer ones are as long as a third of a single clothoid, but change
// the curvature by little; where that leads nowhere they are made shorter.
inline std::optional<Three_clothoids> three_clothoids(const Blend_goal& goal, double k0, double k1) {
  const auto single = single_clothoid(goal.heading, goal.turn_to);
  const std::array<double, 3> guess = single ? *single : std::array<double, 3>{0, 0, 1.5};
  const auto outer = [&](double given, double of_single) {
    return (std::min)(guess[2] / 3, 0.8 / (std::max)(1e-9, std::fabs(given - of_single)));
  };
  const double first = outer(k0, guess[0]), last = outer(k1, guess[1]);
  for (double factor = 1; factor > 1e-3; factor /= 1.5) {
    Three_clothoids c{{first * factor, guess[2] - (first + last) * factor, last * factor},
                      {k0, guess[0], guess[1], k1}};
    if (goal.reach(c)) return c;
  }
  return std::nullopt;
}

// The decimal with the fewest digits that is read as a floating-point number.
inline Rational shortest_decimal(double x) {
  std::array<char, 40> text;
  const char* const end =
      std::to_chars(text.data(), text.data() + text.size(), std::fabs(x), std::chars_format::scientific).ptr;
  std::int64_t digits = 0;
  int exponent = 0;
  bool fraction = false;
  const char* c = text.data();
  for (; c != end && *c != 'e'; ++c) {
    if (*c == '.') {
      fraction = true;
      continue;
    }
    digits = 10 * digits + (*c - '0');
    exponent -= fraction;
  }
  int given = 0;
  std::from_chars(c + (c[1] == '+' ? 2 : 1), end, given);
  Rational value(static_cast<double>(digits)), power(1);
  if (static_cast<std::int64_t>(static_cast<double>(digits)) != digits) // more than 53 bits
    value = Rational(Rational(static_cast<double>(digits / 1000)) * 1000 + static_cast<int>(digits % 1000));
  for (int e = std::abs(exponent + given); e > 0; --e) power = Rational(power * 10);
  value = exponent + given < 0 ? Rational(value / power) : Rational(value * power);
  return x < 0 ? Rational(-value) : value;
}

inline double middle(const Enclosure& x) { return x.lower / 2 + x.upper / 2; }

// The segment with these curvatures and this length, which starts where the one before ends: there
// exactly if that is given so, otherwise at decimals.
inline Clothoid_segment segment_from(const Alignment_end& before, bool as_given, const Rational& k0, const Rational& k1,
                                     double length) {
  const std::array<Enclosure, 2> p = before.point.enclosure();
  std::pair<Rational, Rational> place(shortest_decimal(middle(p[0])), shortest_decimal(middle(p[1])));
  Rational heading = shortest_decimal(middle(before.heading.enclosure()));
  if (as_given) {
    if (const auto exact = before.point.rational()) place = *exact;
    if (before.heading.is_exact() && before.heading.vector() == std::pair<Rational, Rational>(1, 0))
      heading = before.heading.angle();
  }
  return Clothoid_segment(place.first, place.second, heading, k0, k1, shortest_decimal(length));
}

// How far the first end is from the second one: the coordinates and the angle.
inline std::array<double, 3> difference(const Alignment_end& x, const Alignment_end& y) {
  const std::array<Enclosure, 2> q = y.point.enclosure();
  const auto exact = y.point.rational();
  const Rational qx = exact ? exact->first : Rational(middle(q[0])),
                 qy = exact ? exact->second : Rational(middle(q[1]));
  const std::array<Enclosure, 2> d = x.point.moved(Heading(), Rational(-qx), Rational(-qy)).enclosure();
  const std::pair<Rational, Rational> v = y.heading.vector();
  const double angle =
      y.heading.is_exact()
          ? middle(Heading(Rational(x.heading.angle() - y.heading.angle()), v.first, Rational(-v.second)).enclosure())
          : middle(x.heading.enclosure()) - middle(y.heading.enclosure());
  return {middle(d[0]), middle(d[1]), std::remainder(angle, 2 * 3.141592653589793)};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlignments
/// Returns three clothoids from `start` to `end`, whose curvature is continuous, also at both ends.
/// Where the curvatures at the ends are rational, all four joins have equal curvatures exactly;
/// gaps and kinks are those of rounding, and are enclosed. The verdicts of the joins allow
/// \f$ 2^{-51} \f$ times the distance of both ends as a gap, and \f$ 2^{-51} \f$ as a kink.
/// \throws Error `zero_direction` when the points are equal or too near to each other,
///   `not_representable` when no such clothoids are found, `jet_order_too_low` when a curvature is
///   not defined, `work_limit`
inline Clothoid_blend clothoid_blend(const Alignment_end& start, const Alignment_end& end) {
  using internal::middle;
  typedef internal::Rational Rational;
  if (!start.curvature || !end.curvature)
    throw Error(Error_code::jet_order_too_low, "clothoid_blend: a curvature is not defined; leave it out for 0");
  const std::array<Enclosure, 2> p = start.point.enclosure(), q = end.point.enclosure();
  const double dx = middle(q[0]) - middle(p[0]), dy = middle(q[1]) - middle(p[1]), chord = std::hypot(dx, dy),
               size = std::fabs(middle(p[0])) + std::fabs(middle(p[1]));
  if (!(chord > 1e-12 * size) || chord == 0)
    throw Error(Error_code::zero_direction, "clothoid_blend: start and end are one point");
  if (!std::isfinite(chord)) throw Error(Error_code::not_finite, "clothoid_blend: the distance of start and end");
  const auto curvature = [](const End_curvature& k) {
    return k.rational() ? *k.rational() : internal::shortest_decimal(middle(k.enclosure()));
  };
  const Rational k0 = curvature(*start.curvature), k1 = curvature(*end.curvature);
  const double direction = std::atan2(dy, dx), full = 2 * 3.141592653589793;
  const auto relative = [&](const Heading& h) { return std::remainder(middle(h.enclosure()) - direction, full); };
  const internal::Blend_goal goal{relative(start.heading), relative(end.heading)};
  std::optional<internal::Three_clothoids> found =
      internal::three_clothoids(goal, CGAL::to_double(k0) * chord, CGAL::to_double(k1) * chord);
  if (!found) throw Error(Error_code::not_representable, "clothoid_blend: no three clothoids lead there");

  const Rational unit(std::ldexp(1., -51));
  const Alignment_tolerance tolerance{Rational(unit * Rational(chord)), unit, Rational(0)};
  std::optional<Clothoid_blend> best;
  double least = 0;
  for (int round = 0; round < 4; ++round) { // the error is enclosed, and removed once more
    const internal::Three_clothoids& c = *found;
    const auto inner = [&](std::size_t i) { return internal::shortest_decimal(c.curvature[i] / chord); };
    const Rational a = inner(1), b = inner(2);
    const Clothoid_segment first = internal::segment_from(start, true, k0, a, c.length[0] * chord),
                           second = internal::segment_from(first.end(), false, a, b, c.length[1] * chord),
                           third = internal::segment_from(second.end(), false, b, k1, c.length[2] * chord);
    const Alignment_end last = third.end();
    const Clothoid_blend blend{
        {first, second, third},
        {alignment_join(start, first.start(), tolerance), alignment_join(first.end(), second.start(), tolerance),
         alignment_join(second.end(), third.start(), tolerance), alignment_join(last, end, tolerance)}};
    const double error = blend.joins[3].gap.upper / chord + blend.joins[3].kink.upper;
    if (!best || error < least) {
      best = blend;
      least = error;
    }
    const std::array<double, 3> off = internal::difference(last, end); // which is removed in the frame of the chord
    const double ex = off[0] / chord, ey = off[1] / chord, cosine = dx / chord, sine = dy / chord;
    const auto step = goal.step(c, {ex * cosine + ey * sine, ey * cosine - ex * sine, off[2]});
    if (!step) break;
    for (std::size_t j = 0; j < 3; ++j) found->unknown(j) += (*step)[j];
  }
  return *best;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_CLOTHOID_BLEND_H
