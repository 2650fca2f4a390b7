// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_REPRESENTABLE_END_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_REPRESENTABLE_END_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// 2^n, also where that is no double.
inline Exact_rational exact_power_of_two(int n) {
  Exact_rational x(1);
  const Exact_rational factor = n < 0 ? Exact_rational(1) / Exact_rational(2) : Exact_rational(2);
  for (; n != 0; n += n < 0 ? 1 : -1) x *= factor;
  return x;
}

// Whether x is a number of the floating-point type Float.
template <class Float> bool is_representable(const Exact_rational& x) {
  const Float rounded = static_cast<Float>(CGAL::to_double(x));
  return std::isfinite(rounded) && Exact_rational(rounded) == x;
}

// The multiple of 2^n nearest to the number x, or of two the one with the even quotient.
template <class Float> Float rounded_to_grid(Float x, int n) {
  if (x == Float(0) || std::ilogb(x) - std::numeric_limits<Float>::digits >= n) return x;
  if (std::ilogb(x) < n - 1) return Float(0);
  return std::ldexp(std::nearbyint(std::ldexp(x, -n)), n); // the quotient has at most as many digits as x
}

// The number with `digits` binary digits nearest to x > 0.
inline Exact_rational short_number(const Exact_rational& x, int digits) {
  const double approximation = CGAL::to_double(x);
  const int n = std::ilogb(approximation) + 1 - digits;
  return Exact_rational(std::nearbyint(std::ldexp(approximation, -n))) * exact_power_of_two(n);
}

// One end of a blend with control points that are numbers of type Float. With the end points A = b_0, b_1, b_2 of a curve
// of degree m, read inward from the join, the leg p and the second difference q,
//
//   B = A + c p,   C = 2B - A + c^2 f q + e p,   f = 5(m-1)/(4m),
//
// is a G^2 join for each c > 0 and each e. When the odd part n of the denominator of f divides c, both points lie on a
// grid that has a few digits more than that of b_0, b_1, b_2, if c and e have few digits.
template <class Float, int N> class Representable_end {
public:
  typedef Coordinate_vector<Exact_rational, N> Vector;

private:
  static constexpr int most_digits = 5, fewest_digits = 3; // of c / n
  static constexpr int finest_e = 16, coarsest_e = 4;      // e is a multiple of 2^-finest, ..., 2^-coarsest

  const std::array<Coordinate_vector<Float, N>, 3> given_; // b_0, b_1, b_2
  const int sign_;                                         // of the leg p = sign (b_0 - b_1)
  const int m_;
  const char* place_;
  Exact_rational target_; // of c
  Exact_rational f_, odd_;
  int digits_ = most_digits;
  std::vector<int> grid_;    // coordinate x of the points is a multiple of 2^grid[x]
  std::vector<bool> failed_; // whether coordinate x of the blend was not representable

  std::array<Coordinate_vector<Float, N>, 3> b_;
  Vector a_, p_, q_;
  Exact_rational c_, e_;

public:
  // `sign` is 1 at the end of a curve, -1 at the start of one.
  Representable_end(const std::array<Coordinate_vector<Float, N>, 3>& inward, int degree, int sign, const Float& beta,
                    const char* place)
      : given_(inward), sign_(sign), m_(degree), place_(place), target_(Exact_rational(beta) * degree / 5),
        f_(Exact_rational(5 * (degree - 1)) / Exact_rational(4 * degree)), odd_(odd_denominator(degree)), b_(inward) {
    for (int x = 0; x < given_[0].dimension(); ++x) {
      int top = std::numeric_limits<Float>::min_exponent; // the coordinates are below 2^top
      for (const auto& b : given_)
        if (b[x] != Float(0)) top = std::max(top, std::ilogb(b[x]) + 1);
      int n = top;
      for (const auto& b : given_)
        while (rounded_to_grid(b[x], n) != b[x]) --n;
      // c has at least so many digits, and the largest coordinate needs all of them
      grid_.push_back(std::max(n, top - std::numeric_limits<Float>::digits + fewest_digits));
    }
    failed_.resize(grid_.size());
    round();
    take();
  }

  const std::array<Coordinate_vector<Float, N>, 3>& points() const { return b_; }
  const Exact_rational& c() const { return c_; }
  const std::vector<int>& grid() const { return grid_; }

  Vector a() const { return a_; }
  Vector tangent() const { return Exact_rational(5 * c_) * p_; }                      // of the blend
  Vector second_derivative() const { return Exact_rational(20 * c_ * c_ * f_) * q_; } // likewise, with e = 0
  Vector second_point() const { return a_ + Exact_rational(sign_ * c_) * p_; }        // B
  Vector third_point() const { return base() + e_ * p_; }                             // C

  // Chooses e so that C is near `wish` and representable, as near as the digits allow.
  bool choose(const Vector& wish) {
    if (!representable(second_point())) return false;
    const Exact_rational exact = dot(Vector(wish - base()), p_) / dot(p_, p_);
    const double approximation = CGAL::to_double(exact);
    for (int digits = finest_e; digits >= coarsest_e; --digits) {
      const double multiple = std::nearbyint(std::ldexp(approximation, digits));
      if (!std::isfinite(multiple)) refuse("the strategy chooses a point that is too far away");
      e_ = Exact_rational(multiple) * exact_power_of_two(-digits);
      if (representable(third_point())) return true;
    }
    return false;
  }

  // Fewer digits of c, then a coarser grid.
  void simplify() {
    if (digits_ > fewest_digits)
      --digits_;
    else {
      digits_ = most_digits;
      for (std::size_t x = 0; x < grid_.size(); ++x) grid_[x] += failed_[x];
      round();
    }
    take();
  }

private:
  // The odd part of the denominator of f.
  static Exact_rational odd_denominator(int m) {
    int n = m % 5 == 0 ? m / 5 : m; // m and m-1 have no common factor
    while (n % 2 == 0) n /= 2;
    return Exact_rational(n);
  }

  void round() {
    for (int i = 0; i < 3; ++i)
      for (int x = 0; x < given_[i].dimension(); ++x) {
        b_[i][x] = rounded_to_grid(given_[i][x], grid_[x]);
        if (!std::isfinite(b_[i][x])) refuse("a coordinate overflows when it is rounded");
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
    q_ = a_ - Exact_rational(2) * exact(b_[1]) + exact(b_[2]);
    if (dot(p_, p_) == Exact_rational(0)) refuse("the tangent is lost on each grid that leaves room for the blend");
    c_ = odd_ * short_number(target_ / odd_, digits_);
  }

  Vector base() const { return Exact_rational(2) * second_point() - a_ + Exact_rational(c_ * c_ * f_) * q_; }

  bool representable(const Vector& x) {
    for (int i = 0; i < x.dimension(); ++i) failed_[i] = !is_representable<Float>(x[i]);
    return std::find(failed_.begin(), failed_.end(), true) == failed_.end();
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_REPRESENTABLE_END_H
