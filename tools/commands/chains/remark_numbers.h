// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_REMARK_NUMBERS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_REMARK_NUMBERS_H

#include "commands/chains/join_report.h"

#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

// The rounded numbers that a remark on a join tells.

typedef GC::Curve_jet<Program_traits<Exact>> Jet;

constexpr double degrees = 57.29577951308232; // of a radian

inline std::string four_digits(double x) { return rounded(x, 4); }

// The square root, for reports only.
inline double root(const Exact& square) { return std::sqrt(CGAL::to_double(square)); }

// From exact jets.
class Exact_numbers {
  const Jet &x_, &y_;

public:
  Exact_numbers(const Jet& left, const Jet& right) : x_(left), y_(right) {}

  bool left_is_zero() const { return is_zero(x_[1]); }
  bool right_is_zero() const { return is_zero(y_[1]); }

  std::string coordinate(int i) const { return four_digits(CGAL::to_double(x_[0][i])); }

  std::string gap() const {
    const GC::Coordinate_vector<Exact, 0> d = y_[0] - x_[0];
    return four_digits(root(dot(d, d)));
  }

  // The angle between the tangents in degrees. The sine comes from an exact square, so that the
  // tiny kinks that designers look for keep their digits.
  std::string angle() const {
    const Exact xx = dot(x_[1], x_[1]), yy = dot(y_[1], y_[1]), xy = dot(x_[1], y_[1]);
    const Exact sine_squared = (xx * yy - xy * xy) / (xx * yy), cosine_squared = xy * xy / (xx * yy);
    const double angle = std::atan2(root(sine_squared), root(cosine_squared)) * degrees;
    return four_digits(xy < 0 ? 180 - angle : angle);
  }

  bool is_cusp() const {
    const Exact xx = dot(x_[1], x_[1]), yy = dot(y_[1], y_[1]), xy = dot(x_[1], y_[1]);
    return xy < 0 && xx * yy == xy * xy;
  }

  bool is_corner(const GC::Corner_threshold& bound) const { return exceeds(bound, x_[1], y_[1]); }

  std::string left_curvature() const { return curvature(x_); }
  std::string right_curvature() const { return curvature(y_); }
  std::string curvature_jump() const {
    const Program_traits<Exact>::Vector d = *GC::curvature_vector(x_) - *GC::curvature_vector(y_);
    return four_digits(root(d.squared_length()));
  }

  std::string left_torsion() const { return four_digits(CGAL::to_double(*GC::torsion(x_))); }
  std::string right_torsion() const { return four_digits(CGAL::to_double(*GC::torsion(y_))); }
  std::string torsion_jump() const {
    return four_digits(std::abs(CGAL::to_double(*GC::torsion(x_)) - CGAL::to_double(*GC::torsion(y_))));
  }

private:
  static std::string curvature(const Jet& jet) {
    if (jet.dimension() != 2) return four_digits(root(*GC::curvature_squared(jet)));
    const GC::Signed_square<Exact> k = *GC::signed_curvature(jet);
    return four_digits(k.sign * root(k.square));
  }
};

typedef CGAL::Interval_nt<false> Interval;

// From enclosures of the jets. A number is certain if all numbers of its enclosure are rounded to
// the same text.
template <int N> class Enclosed_numbers {
  typedef GC::Coordinate_jet<Interval, N> Enclosed_jet;
  typedef GC::Coordinate_vector<Interval, N> Vector;
  const Enclosed_jet &x_, &y_;
  mutable bool certain_ = true;

public:
  Enclosed_numbers(const Enclosed_jet& left, const Enclosed_jet& right) : x_(left), y_(right) {}

  // Returns whether all numbers so far are what Exact_numbers says.
  bool certain() const { return certain_; }

  bool left_is_zero() const { return vanishes(x_[1]); }
  bool right_is_zero() const { return vanishes(y_[1]); }
  std::string coordinate(int i) const { return text(x_[0][i]); }
  std::string gap() const { return text(length(Vector(y_[0] - x_[0]))); }

  std::string angle() const {
    const Interval sine = length(cross(x_[1], y_[1])), cosine = dot(x_[1], y_[1]);
    const double least = (std::max)(0.0, sine.inf()), largest = sine.sup(); // 0 without a sign
    // the angle falls with the cosine; with the sine it grows up to a right angle, and falls beyond
    const double low = std::atan2(cosine.sup() < 0 ? largest : least, cosine.sup()),
                 high = std::atan2(cosine.inf() < 0 ? least : largest, cosine.inf());
    const double rounding = 1e-14; // of atan2() in any rounding mode
    return text(Interval(low * degrees * (1 - rounding), high * degrees * (1 + rounding)));
  }

  bool is_cusp() const {
    if (!(length(cross(x_[1], y_[1])).inf() > 0)) certain_ = false;
    return false;
  }

  bool is_corner(const GC::Corner_threshold& bound) const {
    const Interval sine = length(cross(x_[1], y_[1])), cosine = dot(x_[1], y_[1]);
    const std::optional<bool> answer =
        bound.is_exceeded(sine.inf(), cosine.inf(), (sine.sup() - sine.inf()) + (cosine.sup() - cosine.inf()));
    if (!answer) certain_ = false;
    return answer && *answer;
  }

  std::string left_curvature() const { return text(curvature(x_)); }
  std::string right_curvature() const { return text(curvature(y_)); }
  std::string curvature_jump() const { return text(length(Vector(curvature_vector(x_) - curvature_vector(y_)))); }

  std::string left_torsion() const { return text(torsion(x_)); }
  std::string right_torsion() const { return text(torsion(y_)); }
  std::string torsion_jump() const { return text(CGAL::abs(Interval(torsion(x_) - torsion(y_)))); }

private:
  std::string text(const Interval& x) const {
    std::string low = rounded_by_product(x.inf(), x.sup(), 4);
    if (!low.empty()) return low;
    low = four_digits(x.inf());
    if (x.inf() != x.sup() && low != four_digits(x.sup())) certain_ = false;
    return low;
  }

  bool vanishes(const Vector& v) const {
    bool zero = true;
    for (const Interval& x : v) zero = zero && x.inf() == 0 && x.sup() == 0;
    return zero;
  }

  static Interval square_of(const Vector& v) {
    Interval sum(0);
    for (const Interval& x : v) sum += CGAL::square(x);
    return sum;
  }
  static Interval length(const Vector& v) { return CGAL::sqrt(square_of(v)); }
  static Interval length(const Interval& x) { return CGAL::abs(x); }

  // A number in the plane, a vector in space.
  static auto cross(const Vector& a, const Vector& b) {
    const auto minor = [&](int i, int j) { return Interval(a[i] * b[j] - a[j] * b[i]); };
    if constexpr (N == 2)
      return minor(0, 1);
    else {
      Vector c(3);
      for (int i = 0; i < 3; ++i) c[i] = minor((i + 1) % 3, (i + 2) % 3);
      return c;
    }
  }

  static Interval curvature(const Enclosed_jet& jet) {
    const Interval g = square_of(jet[1]), cubed = g * CGAL::sqrt(g);
    if constexpr (N == 2)
      return cross(jet[1], jet[2]) / cubed;
    else
      return length(cross(jet[1], jet[2])) / cubed;
  }
  static Vector curvature_vector(const Enclosed_jet& jet) {
    const Interval g = square_of(jet[1]), h = dot(jet[1], jet[2]), gg = CGAL::square(g);
    Vector k(N);
    for (int i = 0; i < N; ++i) k[i] = (g * jet[2][i] - h * jet[1][i]) / gg;
    return k;
  }
  static Interval torsion(const Enclosed_jet& jet) {
    if constexpr (N == 2)
      return Interval(0);
    else {
      const Vector n = cross(jet[1], jet[2]);
      return dot(n, jet[3]) / square_of(n);
    }
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_REMARK_NUMBERS_H
