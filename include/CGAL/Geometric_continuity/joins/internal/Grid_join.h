// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_GRID_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_GRID_JOIN_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_all_questions.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/kernel_access.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Grid_join.h
/// Decimals become integers when they are multiplied by a power of ten. No order of continuity
/// changes when all points are multiplied by one factor and all parameters by another one. So the
/// stages decide the joins of curves that are given by decimals on ends of integers. Of a span of a
/// B-spline curve whose knots and control points are integers, the Bézier points are found first,
/// as long as the numbers stay short.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// A point with short rational coordinates: these divided by one denominator.
template <int N> struct Short_point {
  std::array<std::int64_t, N> numerators;
  std::int64_t denominator = 1;
};

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// ((whole - part) x + part y) / whole, for 0 <= part <= whole and 0 < whole < 2^60. Returns false
// where numbers get longer than 60 bits.
template <int N>
bool combine(const Short_point<N>& x, const Short_point<N>& y, std::int64_t part, std::int64_t whole,
             Short_point<N>& result) {
  constexpr std::int64_t largest = (std::int64_t(1) << 60) - 1;
  if (part == 0 || part == whole) {
    result = part == 0 ? x : y;
    return true;
  }
  const auto product = [](std::int64_t a, std::int64_t b, std::int64_t& c) {
    return !__builtin_mul_overflow(a, b, &c) && c <= largest;
  };
  const std::int64_t unit = std::gcd(part, whole), common = std::gcd(x.denominator, y.denominator);
  const std::int64_t b = part / unit, all = whole / unit, a = all - b;
  std::int64_t first, second, denominator;
  if (!product(a, y.denominator / common, first) || !product(b, x.denominator / common, second) ||
      !product(x.denominator / common, y.denominator, denominator) || !product(denominator, all, denominator))
    return false;
  std::array<Signed_128, N> sums;
  std::int64_t divisor = denominator;
  for (int i = 0; i < N; ++i) {
    sums[i] = static_cast<Signed_128>(first) * x.numerators[i] + static_cast<Signed_128>(second) * y.numerators[i];
    divisor = std::gcd(divisor, static_cast<std::int64_t>(sums[i] % divisor));
  }
  result.denominator = denominator / divisor;
  for (int i = 0; i < N; ++i) {
    const Signed_128 quotient = sums[i] / divisor;
    if (quotient < -largest || largest < quotient) return false;
    result.numerators[i] = static_cast<std::int64_t>(quotient);
  }
  return true;
}

// The Bezier point with the blossom f(a, ..., a, b, ..., b), where a is taken `as` times, of the
// span [a, b] of a B-spline curve of degree p with the control points c_0, ..., c_p and knots t_0,
// ..., t_2p+1: a = t_p and b = t_p+1.
template <int N>
bool short_bezier_point(const std::vector<std::int64_t>& t, std::vector<Short_point<N>> c, int as,
                        Short_point<N>& result) {
  const int p = static_cast<int>(c.size()) - 1;
  for (int r = 1; r <= p; ++r) {
    const std::int64_t x = r <= as ? t[p] : t[p + 1];
    for (int i = p; i >= r; --i) {
      Short_point<N> point;
      if (!combine(c[i - 1], c[i], x - t[i], t[i + p + 1 - r] - t[i], point)) return false;
      c[i] = point;
    }
  }
  result = c[p];
  return true;
}

#else

template <int N>
bool short_bezier_point(const std::vector<std::int64_t>&, std::vector<Short_point<N>>, int, Short_point<N>&) {
  return false;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Returns whether the control points next to an end of a part that has one span are Bezier points;
// see Bspline_ends.
template <class Part> bool has_bezier_points(const Part& part, bool at_end) {
  const int p = part.degree, few = (std::min)(p, 3), before = at_end ? few : p, after = at_end ? p : few;
  for (int i = 1; i < before; ++i)
    if (!(part.knots[p - i] == part.knots[p])) return false;
  for (int i = 1; i < after; ++i)
    if (!(part.knots[p + 1 + i] == part.knots[p + 1])) return false;
  return true;
}

// The product of an interval and an integer below 2^60 in absolute value, or another interval.
inline Interval_nt<false> enclosed_product(std::int64_t x, const Interval_nt<false>& y) {
  const double infinity = std::numeric_limits<double>::infinity(), rounded = static_cast<double>(x);
  return static_cast<std::int64_t>(rounded) == x
             ? rounded * y
             : Interval_nt<false>(std::nextafter(rounded, -infinity), std::nextafter(rounded, infinity)) * y;
}
inline Interval_nt<false> enclosed_product(const Interval_nt<false>& x, const Interval_nt<false>& y) { return x * y; }

// Encloses the jet of order 3 at an end with respect to a parameter of the domain [0, 1], from the
// points in these units: differences of integers are exact. \pre rounding upwards, as in the scope
// of Protect_FPU_rounding
template <bool left, class T, std::size_t N>
Coordinate_jet<Interval_nt<false>, static_cast<int>(N)> enclosed_jet(const std::array<std::array<T, N>, 4>& points,
                                                                     int degree, const Interval_nt<false>& unit) {
  typedef Interval_nt<false> Interval;
  constexpr int dimension = static_cast<int>(N);
  const Differences<T, dimension> d = differences_of<3, left>(first_differences<3>(points), degree);
  Coordinate_jet<Interval, dimension> jet(dimension, 3);
  double factor = 1; // m!/(m-k)!
  for (int i = 0; i < dimension; ++i) jet[0][i] = enclosed_product(points[0][i], unit);
  for (int k = 1; k <= 3; ++k) {
    factor *= (std::max)(degree - k + 1, 0);
    const Interval scale = Interval(factor) * unit;
    for (int i = 0; i < dimension; ++i) jet[k][i] = enclosed_product(d[k - 1][i], scale);
  }
  return jet;
}

// The join of two parts whose numbers are doubles.
template <int N> class Double_part_join {
  std::optional<Double_ends<N>> ends_;

  template <class Part> struct End {
    const Part& part;
    bool at_end;
    int degree() const { return part.degree; }
    int dimension() const { return N; }
    std::pair<double, double> domain() const { return {part.knots[part.degree], part.knots[part.degree + 1]}; }
    double coordinate(int j, int i) const { return part.coordinates[(at_end ? part.degree - j : j) * N + i]; }
  };

public:
  template <class Part> bool set(const Part& x, const Part& y) {
    if (!has_bezier_points(x, true) || !has_bezier_points(y, false)) return false;
    ends_.emplace(End<Part>{x, true}, End<Part>{y, false});
    return true;
  }
  template <class Result> bool decide(int max_order, Result& join, Join_asked asked) const {
    decide_all_on_doubles(*ends_, max_order, join, asked);
    return true;
  }
  typedef Coordinate_jet<Interval_nt<false>, N> Jet;
  std::pair<Jet, Jet> enclosed_jets() const {
    const auto numbers = [](const Double_end<N>& end) {
      End_polygon<Interval_nt<false>, N> x;
      for (int j = 0; j <= 3; ++j)
        for (int i = 0; i < N; ++i) x[j][i] = Interval_nt<false>(end.points()[j][i]);
      return x;
    };
    const Double_end<N>&left = ends_->left(), &right = ends_->right();
    return {enclosed_jet<true>(numbers(left), left.degree(), 1),
            enclosed_jet<false>(numbers(right), right.degree(), 1)};
  }
};

// A join on grids: the points and parameters of the curves are these times powers of ten. It
// answers questions as decide_all_questions() asks them.
template <int N> class Grid_join {
  Integer_end<N> left_, right_;
  bool is_short_ = false; // as the first differences of double numbers are
  double unit_of_parameters_ = 1;
  int exponent_ = 0, exponent_of_parameters_ = 0;
  std::int64_t denominator_ = 1; // of the unit of the points
  static constexpr std::int64_t largest = (std::int64_t(1) << 60) - 1;

public:
  static constexpr int dimension = N;

  Grid_join() {} // leaves what set() assigns

  // Brings the join of two parts without weights on grids. Returns false if that is not possible.
  template <class Part> bool set(const Part& x, const Part& y) {
    if (!has_bezier_points(x, true) || !has_bezier_points(y, false)) return set_spans(x, y);
    typedef std::decay_t<decltype(x.coordinates[0])> Number;
    const Number* numbers[8 * N];
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i < N; ++i) {
        numbers[j * N + i] = &x.coordinates[(x.degree - (std::min)(x.degree, j)) * N + i];
        numbers[(4 + j) * N + i] = &y.coordinates[(std::min)(y.degree, j) * N + i];
      }
    const Number* const parameters[4] = {&x.knots[x.degree], &x.knots[x.degree + 1], &y.knots[y.degree],
                                         &y.knots[y.degree + 1]};
    std::int64_t integers[8 * N], ends[4];
    return integers_on_grid<8 * N>(numbers, integers, exponent_) &&
           integers_on_grid<4>(parameters, ends, exponent_of_parameters_) &&
           set_integers(x.degree, y.degree, integers, ends);
  }

  // Brings the join of two Bezier curves with rational coordinates over domains with integers as
  // ends on grids. Returns false if the numbers are too long.
  template <class Traits, int Degree>
  bool set_rationals(const Bezier_polygon<Traits, Degree>& x, const Bezier_polygon<Traits, Degree>& y) {
    typedef Rational_parts<typename Traits::FT> Parts;
    std::int64_t numerators[8 * N], denominators[8 * N], ends[4], one;
    int i = 0;
    for (const typename Traits::FT* end : {&x.a_, &x.b_, &y.a_, &y.b_})
      if (!Parts::short_parts(*end, ends[i++], one) || one != 1) return false;
    for (int k = 0; k < 8 * N; ++k) {
      const int j = k / N, degree = j < 4 ? x.degree() : y.degree();
      const typename Traits::Point& point =
          j < 4 ? x.control_point(degree - (std::min)(degree, j)) : y.control_point((std::min)(degree, j - 4));
      const auto split = [&](const auto& coordinate) {
        return Parts::short_parts(coordinate, numerators[k], denominators[k]);
      };
      if (!with_coordinate<Traits>(point, k % N, split)) return false;
    }
    return set_fractions(x.degree(), y.degree(), numerators, denominators, ends);
  }

  // Everything that Join_continuity says, or only the orders, for orders up to 3. Returns false
  // when some of it needs multi-precision numbers; then `join` is unspecified.
  template <class FT> bool decide(int max_order, Join_continuity<FT>& join, Join_asked asked) const {
    if (!decide_all_questions(*this, max_order, join, asked)) return false;
    if (join.g_order >= 1 && asked != Join_asked::orders) {
      join.parameters = parameters_of<FT, N>(left_, right_);
      join.parameters.set_unit(unit_of_parameters_, exponent_of_parameters_);
    }
    return true;
  }

  bool regular() const { return left_.points()[0] != left_.points()[1] && right_.points()[0] != right_.points()[1]; }
  bool ends_meet() const { return left_.points()[0] == right_.points()[0]; }
  template <Join_question question> Join_answer decide() const {
    const All_stages stages;
    const Join_answer answer =
        is_short_ ? decide_by_stages(Integer_join<question, N, 1>(left_, right_), stages) : Join_answer::unknown;
    return answer != Join_answer::unknown ? answer
                                          : decide_by_stages(Integer_join<question, N, 2>(left_, right_), stages);
  }
  bool is_curved() const { return internal::is_curved(left_.rounded_differences()); }
  Join_answer equal_curvatures() const {
    return curvatures_differ<N>(left_, right_) ? Join_answer::no : Join_answer::unknown;
  }

  // Enclosures of the jets of order 3 on both sides, with respect to parameters of the domain [0,
  // 1]. \pre rounding upwards, as in the scope of Protect_FPU_rounding
  typedef Coordinate_jet<Interval_nt<false>, N> Jet;
  std::pair<Jet, Jet> enclosed_jets() const {
    typedef Interval_nt<false> Interval;
    Interval unit = Interval(1) / enclosed_product(denominator_, Interval(1));
    for (int e = exponent_; e < 0;) {
      double power = 1; // exact up to 10^22
      for (int last = (std::min)(e + 22, 0); e < last; ++e) power *= 10;
      unit /= Interval(power);
    }
    return {enclosed_jet<true>(left_.points(), left_.degree(), unit),
            enclosed_jet<false>(right_.points(), right_.degree(), unit)};
  }

private:
  // Spans of B-spline curves without Bezier points at the join: these are computed.
  template <class Part> bool set_spans(const Part& x, const Part& y) {
    std::int64_t numerators[8 * N], denominators[8 * N];
    for (const Part* part : {&x, &y}) {
      for (const auto& number : part->coordinates) exponent_ = (std::min)(exponent_, number.exponent());
      for (const auto& knot : part->knots)
        exponent_of_parameters_ = (std::min)(exponent_of_parameters_, knot.exponent());
    }
    std::int64_t ends[4];
    for (const bool at_end : {true, false}) {
      const Part& part = at_end ? x : y;
      const int p = part.degree;
      std::vector<std::int64_t> knots(part.knots.size());
      for (std::size_t i = 0; i < knots.size(); ++i)
        if (!part.knots[i].on_grid(exponent_of_parameters_, knots[i])) return false;
      std::vector<Short_point<N>> points(p + 1);
      for (int j = 0; j <= p; ++j)
        for (int i = 0; i < N; ++i)
          if (!part.coordinates[j * N + i].on_grid(exponent_, points[j].numerators[i])) return false;
      for (int j = 0; j <= 3; ++j) {
        const int from_end = (std::min)(p, j);
        Short_point<N> point;
        if (!short_bezier_point(knots, points, at_end ? from_end : p - from_end, point)) return false;
        for (int i = 0; i < N; ++i) {
          const int k = (at_end ? j : 4 + j) * N + i;
          numerators[k] = point.numerators[i];
          denominators[k] = point.denominator;
        }
      }
      ends[at_end ? 0 : 2] = knots[p];
      ends[at_end ? 1 : 3] = knots[p + 1];
    }
    return set_fractions(x.degree, y.degree, numerators, denominators, ends);
  }

  // Numbers with their denominators.
  bool set_fractions(int left_degree, int right_degree, std::int64_t* numerators, const std::int64_t* denominators,
                     const std::int64_t* ends) {
    for (int k = 0; k < 8 * N; ++k) {
      if (denominator_ % denominators[k] == 0) continue;
      const std::int64_t factor = denominators[k] / std::gcd(denominator_, denominators[k]);
      if (factor > largest / denominator_) return false;
      denominator_ *= factor;
    }
    for (int k = 0; k < 8 * N; ++k) {
      const std::int64_t factor = denominator_ / denominators[k];
      if (std::abs(numerators[k]) > largest / factor) return false;
      numerators[k] *= factor;
    }
    return set_integers(left_degree, right_degree, numerators, ends);
  }

  bool set_integers(int left_degree, int right_degree, const std::int64_t* integers, const std::int64_t* ends) {
    const auto is_exact_double = [](std::int64_t x) { return static_cast<std::int64_t>(static_cast<double>(x)) == x; };
    const std::int64_t length = ends[1] - ends[0], other = ends[3] - ends[2],
                       unit = length == other ? length : std::gcd(length, other);
    if (!is_exact_double(length / unit) || !is_exact_double(other / unit) || !is_exact_double(unit)) return false;
    unit_of_parameters_ = static_cast<double>(unit);
    End_polygon<std::int64_t, N> x, y;
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i < N; ++i) {
        x[j][i] = integers[j * N + i];
        y[j][i] = integers[(4 + j) * N + i];
      }
    const int pivot = largest_coordinate(internal::minus(x[1], x[0]));
    left_ = Integer_end<N>(x, pivot, left_degree, length / unit);
    right_ = Integer_end<N>(y, pivot, right_degree, other / unit);
    is_short_ = left_.is_short() && right_.is_short();
    return true;
  }

  // The numbers as integers below 2^60 times 10^exponent.
  template <int n, class Number>
  static bool integers_on_grid(const Number* const* numbers, std::int64_t* integers, int& exponent) {
    exponent = 0; // integers stay as they are
    // equivalent [min -> max, 1]: numbers that are not on a grid that is too coarse are left to
    //   the general decision
    for (int i = 0; i < n; ++i) exponent = (std::min)(exponent, numbers[i]->exponent());
    for (int i = 0; i < n; ++i)
      if (!numbers[i]->on_grid(exponent, integers[i])) return false;
    return true;
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_GRID_JOIN_H
