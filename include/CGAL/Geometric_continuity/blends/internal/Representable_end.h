// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_REPRESENTABLE_END_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_REPRESENTABLE_END_H

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/ipower.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// All of this holds in every rounding mode: what is computed in floating-point numbers is exact, or
// a choice near to others.

// 2^n, also where that is no double.
inline Exact_rational exact_power_of_two(int n) {
  const Exact_rational two(2);
  return CGAL::ipower(n < 0 ? Exact_rational(Exact_rational(1) / two) : two, std::abs(n));
}

// Returns whether x is a number of the floating-point type Float.
template <class Float> bool is_representable(const Exact_rational& x) {
  const double rounded = CGAL::to_double(x);
  if (!(std::abs(rounded) <= static_cast<double>((std::numeric_limits<Float>::max)()))) return false;
  return Exact_rational(static_cast<Float>(rounded)) == x;
}

// The integer nearest to x, or of two the even one.
template <class Float> Float nearest_integer(Float x) {
  const Float n = std::trunc(x), rest = std::abs(x - n); // exact
  if (rest < Float(0.5) || (rest == Float(0.5) && std::fmod(n, Float(2)) == Float(0))) return n;
  return n + std::copysign(Float(1), x);
}

// Returns whether the multiple m of 2^n is too large for Float.
template <class Float> bool overflows(Float m, int n) {
  return m != Float(0) && std::ilogb(m) >= std::numeric_limits<Float>::max_exponent - n;
}

// The multiple of 2^n nearest to the number x, or of two the one with the even quotient; nothing
// when it is too large.
template <class Float> std::optional<Float> rounded_to_grid(Float x, int n) {
  if (x == Float(0) || std::ilogb(x) - std::numeric_limits<Float>::digits >= n) return x;
  if (std::ilogb(x) < n - 1) return Float(0);
  // the quotient has at most as many digits as x
  const Float multiple = nearest_integer(std::ldexp(x, -n));
  if (overflows(multiple, n)) return std::nullopt;
  return std::ldexp(multiple, n);
}

// The number with `digits` binary digits nearest to x; x > 0 is not far from 1.
inline Exact_rational short_number(const Exact_rational& x, int digits) {
  const double approximation = CGAL::to_double(x);
  const int n = std::ilogb(approximation) + 1 - digits;
  return Exact_rational(nearest_integer(std::ldexp(approximation, -n))) * exact_power_of_two(n);
}

// How a curve leaves, read inward from the join: its degree m, and by which lengths of the
// parameter the first and the second difference of control points are divided, for the derivatives
// m (b_0 - b_1) / first and m (m-1) ((b_0 - b_1) / first - (b_1 - b_2) / second) / first.
template <class Float> struct Inward_lengths {
  int degree;
  // the length of the domain of a Bezier curve, of a clamped spline its first knots
  Float first, second;
};

// One end of a blend with control points that are numbers of type Float. With the end points A =
// b_0, b_1, b_2 of a curve of degree m, read inward from the join, the difference p = +-(b_0 - b_1)
// and q = (b_0 - b_1) - r (b_1 - b_2), r the ratio of the lengths,
//
//   B = A + c p,   C = 2B - A + c^2 f q + e p,   f = 5(m-1)/(4m),
//
// is a G^2 join for each c > 0 and each e. When the odd parts of the denominators of f and r divide
// c, both points lie on a grid that has a few digits more than that of b_0, b_1, b_2, if c and e
// have few digits.
template <class Float, int N> class Representable_end {
public:
  typedef Coordinate_vector<Exact_rational, N> Vector;

private:
  static constexpr int most_digits = 8, fewest_digits = 3; // of c / n
  // e is a multiple of 2^-finest, ..., 2^-coarsest
  static constexpr int finest_e = 16, coarsest_e = 4;
  // more digits of c / n only where e has so many
  static constexpr int plenty = 5, plenty_e = 10;

  const std::array<Coordinate_vector<Float, N>, 3> given_; // b_0, b_1, b_2
  const int sign_;                                         // of the difference p = sign (b_0 - b_1)
  const Inward_lengths<Float> lengths_;
  const char* place_;
  int exponent_;          // of beta / first length
  Exact_rational target_; // of c / 2^exponent
  Exact_rational ratio_, f_, odd_;
  int digits_ = most_digits;
  std::vector<int> grid_;    // coordinate x of the points is a multiple of 2^grid[x]
  std::vector<bool> failed_; // whether coordinate x of the blend was not representable

  std::array<Coordinate_vector<Float, N>, 3> b_;
  Vector a_, p_, q_;
  Exact_rational c_, e_;

public:
  // `sign` is 1 at the end of a curve, -1 at the start of one.
  Representable_end(const std::array<Coordinate_vector<Float, N>, 3>& inward, const Inward_lengths<Float>& lengths,
                    int sign, const Float& beta, const char* place)
      : given_(inward), sign_(sign), lengths_(lengths), place_(place),
        exponent_(std::ilogb(beta) - std::ilogb(lengths.first)), // not 0, and finite
        target_(mantissa(beta) * lengths.degree / (5 * mantissa(lengths.first))),
        ratio_(Exact_rational(lengths.first) / Exact_rational(lengths.second)),
        f_(Exact_rational(5 * (lengths.degree - 1)) / Exact_rational(4 * lengths.degree)),
        odd_(odd_denominator(lengths)), b_(inward) {
    for (int x = 0; x < given_[0].dimension(); ++x) {
      int top = std::numeric_limits<Float>::min_exponent; // the coordinates are below 2^top
      for (const auto& b : given_)
        if (b[x] != Float(0)) top = (std::max)(top, std::ilogb(b[x]) + 1);
      int n = top;
      for (const auto& b : given_)
        while (rounded_to_grid(b[x], n) != b[x]) --n; // ends at the unit of the last digit
      // c has at least so many digits, and the largest coordinate needs all of them
      grid_.push_back((std::max)(n, top - std::numeric_limits<Float>::digits + fewest_digits));
    }
    failed_.resize(grid_.size());
    round();
    take();
  }

  const std::array<Coordinate_vector<Float, N>, 3>& points() const { return b_; }
  // The shape parameter of the join, rounded; it stays positive.
  Float beta() const {
    // next to zero, no number is near the next one
    const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
    const double x = CGAL::to_double(Exact_rational(5 * c_ * Exact_rational(lengths_.first) / lengths_.degree));
    if (!(x <= static_cast<double>((std::numeric_limits<Float>::max)()))) refuse("the shape parameter overflows");
    return (std::max)(static_cast<Float>(x), std::numeric_limits<Float>::denorm_min());
  }
  const std::vector<int>& grid() const { return grid_; }

  Vector a() const { return a_; }
  // of the blend
  Vector tangent() const { return Exact_rational(5 * c_) * p_; }
  // of the blend when e = 0
  Vector second_derivative() const { return Exact_rational(20 * c_ * c_ * f_) * q_; }
  Vector second_point() const { return a_ + Exact_rational(sign_ * c_) * p_; } // B
  Vector third_point() const { return base() + e_ * p_; }                      // C

  // Chooses e so that C is near `wish` and representable, as near as the digits allow.
  bool choose(const Vector& wish) {
    if (!representable(second_point())) return false;
    const Exact_rational exact = dot(Vector(wish - base()), p_) / dot(p_, p_);
    const double approximation = CGAL::to_double(exact);
    for (int digits = finest_e; digits >= (digits_ > plenty ? plenty_e : coarsest_e); --digits) {
      if (!std::isfinite(approximation) || overflows(approximation, digits))
        refuse("the strategy chooses a point that is too far away");
      e_ = Exact_rational(nearest_integer(std::ldexp(approximation, digits))) * exact_power_of_two(-digits);
      if (representable(third_point())) return true;
    }
    return false;
  }

  // No more digits of c than plenty, then fewer, then a coarser grid, where there are none to
  // spare.
  void simplify() {
    if (digits_ > fewest_digits)
      digits_ = (std::min)(digits_ - 1, plenty);
    else {
      digits_ = plenty;
      for (std::size_t x = 0; x < grid_.size(); ++x) grid_[x] += failed_[x];
      round();
    }
    take();
  }

private:
  static Exact_rational mantissa(const Float& x) { return Exact_rational(std::scalbn(x, -std::ilogb(x))); }

  // The odd part of a positive number of few digits.
  static std::int64_t odd_part(const Float& x) {
    std::int64_t n = static_cast<std::int64_t>(std::scalbn(x, std::numeric_limits<Float>::digits - 1 - std::ilogb(x)));
    while (n % 2 == 0) n /= 2;
    return n;
  }

  // The product of the odd parts of the denominators of f and of the ratio of the lengths.
  static Exact_rational odd_denominator(const Inward_lengths<Float>& lengths) {
    const int m = lengths.degree; // m and m-1 have no common factor
    const std::int64_t first = odd_part(lengths.first), second = odd_part(lengths.second);
    const std::int64_t of_f = odd_part(static_cast<Float>(m % 5 == 0 ? m / 5 : m));
    return Exact_rational(static_cast<double>(of_f)) *
           Exact_rational(static_cast<double>(second / std::gcd(first, second)));
  }

  void round() {
    for (int x = 0; x < given_[0].dimension(); ++x) {
      if (overflows(Float(1), grid_[x])) refuse("no grid leaves room below the largest number");
      for (int i = 0; i < 3; ++i) {
        const std::optional<Float> b = rounded_to_grid(given_[i][x], grid_[x]);
        if (!b) refuse("a coordinate overflows when it is rounded");
        b_[i][x] = *b;
      }
    }
  }

  [[noreturn]] void refuse(const char* reason) const {
    throw Error(Error_code::not_representable, std::string(place_) + ": " + reason);
  }

  void take() {
    const auto exact = [](const Coordinate_vector<Float, N>& x) {
      Vector y(x.dimension());
      for (int i = 0; i < x.dimension(); ++i) y[i] = Exact_rational(x[i]);
      return y;
    };
    a_ = exact(b_[0]);
    p_ = Exact_rational(sign_) * (a_ - exact(b_[1]));
    q_ = a_ - exact(b_[1]) - ratio_ * (exact(b_[1]) - exact(b_[2]));
    if (dot(p_, p_) == Exact_rational(0)) refuse("the tangent is lost on each grid that leaves room for the blend");
    c_ = odd_ * short_number(target_ / odd_, digits_) * exact_power_of_two(exponent_);
  }

  Vector base() const { return Exact_rational(2) * second_point() - a_ + Exact_rational(c_ * c_ * f_) * q_; }

  bool representable(const Vector& x) {
    const Exact_rational most((std::numeric_limits<Float>::max)());
    for (int i = 0; i < x.dimension(); ++i) {
      failed_[i] = !is_representable<Float>(x[i]);
      if (failed_[i] && (most < x[i] || x[i] < -most)) refuse("a coordinate of the blend overflows");
    }
    return std::find(failed_.begin(), failed_.end(), true) == failed_.end();
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_REPRESENTABLE_END_H
