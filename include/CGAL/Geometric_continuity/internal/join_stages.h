// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_JOIN_STAGES_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_JOIN_STAGES_H

#include <CGAL/Geometric_continuity/internal/common_grid.h>
#include <CGAL/Geometric_continuity/internal/join_filter.h>

#include <array>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

enum class Join_answer { no, yes, undefined, unknown };

// Where a decision was made.
enum class Join_stage {
  comparison,     // equality and signs of the numbers as given
  floating_point, // a form is larger than its rounding error
  residue,        // a form is not zero modulo 2^64
  simple_ratio,   // integers of fixed length, with p/q short
  fixed_integer,  // integers of fixed length
  multiprecision
};

// Which stages are taken, and what hears of the decision: the default uses all and does not listen.
struct All_join_stages {
  static constexpr bool uses(Join_stage) { return true; }
  void decided(Join_stage, Join_answer) const {}
};

template <class T> struct Exact_zero {
  static constexpr bool exact = true, pivot_is_first = true;
  template <class X> bool operator()(Join_kind, const X& x) const {
    if constexpr (std::is_same_v<X, T>)
      return bool(x == T(0));
    else
      return is_zero(x);
  }
};

// The residue of zero is zero; the residue of another number may be.
struct Residue_zero {
  static constexpr bool exact = false, pivot_is_first = true;
  bool operator()(Join_kind, std::uint64_t x) const { return x == 0; }
};

// The points of an end from the join inwards, x_0 to x_k; beyond the degree the last one is repeated.
template <class T, int N> using End_points = std::array<std::array<T, N>, 4>;

// The legs x_1 - x_0, x_2 - x_1, x_3 - x_2, as many as the order k needs.
template <int k, class T, std::size_t N>
BOOST_FORCEINLINE Differences<T, N> legs_of(const std::array<std::array<T, N>, 4>& x) {
  if constexpr (k == 1)
    return {internal::minus(x[1], x[0])};
  else if constexpr (k == 2)
    return {internal::minus(x[1], x[0]), internal::minus(x[2], x[1])};
  else
    return {internal::minus(x[1], x[0]), internal::minus(x[2], x[1]), internal::minus(x[3], x[2])};
}

// The differences a_k (left) or b_k (right) from the legs: from the join inwards, those of odd order point backwards on the
// left.
template <int k, bool left, class T, std::size_t N>
BOOST_FORCEINLINE Differences<T, N> differences_of(const std::array<std::array<T, N>, 3>& legs, int degree) {
  std::array<T, N> zero;
  zero.fill(T(0));
  Differences<T, N> d{};
  d[0] = left ? internal::minus(zero, legs[0]) : legs[0];
  if constexpr (k >= 2) {
    d[1] = internal::minus(legs[1], legs[0]);
    if constexpr (k >= 3) {
      const std::array<T, N> second = internal::minus(legs[2], legs[1]);
      d[2] = left ? internal::minus(d[1], second) : internal::minus(second, d[1]);
      if (degree < 3) d[2] = zero;
    }
    if (degree < 2) d[1] = zero;
  }
  return d;
}

// The coordinates in cyclic order from `first`.
template <class T> BOOST_FORCEINLINE std::array<T, 2> rotated(const std::array<T, 2>& x, int first) {
  return {x[first], x[1 - first]};
}
template <class T> BOOST_FORCEINLINE std::array<T, 3> rotated(const std::array<T, 3>& x, int first) {
  const int second = first == 2 ? 0 : first + 1;
  return {x[first], x[second], x[3 - first - second]};
}
template <int k, class T, std::size_t N>
BOOST_FORCEINLINE Differences<T, N> rotated(const std::array<std::array<T, N>, 3>& legs, int first) {
  if constexpr (k == 1)
    return {rotated(legs[0], first)};
  else if constexpr (k == 2)
    return {rotated(legs[0], first), rotated(legs[1], first)};
  else
    return {rotated(legs[0], first), rotated(legs[1], first), rotated(legs[2], first)};
}

// The index of the first coordinate with the largest absolute value.
template <class T> BOOST_FORCEINLINE int largest_coordinate(const std::array<T, 2>& x) {
  return std::abs(x[0]) < std::abs(x[1]) ? 1 : 0;
}
template <class T> BOOST_FORCEINLINE int largest_coordinate(const std::array<T, 3>& x) {
  const int i = std::abs(x[0]) < std::abs(x[1]) ? 1 : 0;
  return std::max(std::abs(x[0]), std::abs(x[1])) < std::abs(x[2]) ? 2 : i;
}

// The numbers in another type.
template <class T, class S> BOOST_FORCEINLINE std::array<T, 2> converted(const std::array<S, 2>& x) {
  return {static_cast<T>(x[0]), static_cast<T>(x[1])};
}
template <class T, class S> BOOST_FORCEINLINE std::array<T, 3> converted(const std::array<S, 3>& x) {
  return {static_cast<T>(x[0]), static_cast<T>(x[1]), static_cast<T>(x[2])};
}
template <int k, class T, class S, std::size_t N>
BOOST_FORCEINLINE Differences<T, N> converted(const std::array<std::array<S, N>, 3>& x) {
  if constexpr (k == 1)
    return {converted<T>(x[0])};
  else if constexpr (k == 2)
    return {converted<T>(x[0]), converted<T>(x[1])};
  else
    return {converted<T>(x[0]), converted<T>(x[1]), converted<T>(x[2])};
}

// Bounds of the differences from the legs; of the second one also if it is zero.
template <int k, std::size_t N>
BOOST_FORCEINLINE Difference_bounds bounds_of_differences(const std::array<std::array<double, N>, 3>& legs) {
  const double first = largest(legs[0]), second = k >= 2 ? std::max(first, largest(legs[1])) : first,
               third = k >= 3 ? std::max(second, largest(legs[2])) : second;
  return {first, 2 * second, 4 * third};
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// (q, p) of at most 12 bits, so that the cubes with factors of at most 16 bits take one limb. The types of the forms are
// shorter: |q^2 b2 - p^2 a2| < 2^(24+16+55+1), times p and a factor of 16 bits < 2^124; |q^3 a1_0| < 2^(36+16+54).
struct Short_join_ratio {
  typedef Fixed_integer<1> Square, Cube;
  Fixed_integer<1> q, p;
  static Square square(const Fixed_integer<1>& x) { return Square(x.top() * x.top()); }
  static Cube cube(const Fixed_integer<1>& x) { return Cube(x.top() * x.top() * x.top()); }
  template <class V> V p_times(const V& v, std::int64_t w) const { return scaled(v, p.top() * w); }
};

// b/a, if it is a fraction with denominator 2^8 and a numerator of at most 12 bits
BOOST_FORCEINLINE bool short_ratio(std::int64_t a, std::int64_t b, Short_join_ratio& r) {
  const double x = 256 * (static_cast<double>(b) / static_cast<double>(a));
  if (!(std::abs(x) < 4096)) return false;
  std::int64_t p = static_cast<std::int64_t>(x), q = 256;
  if (static_cast<Signed_128>(p) * a != static_cast<Signed_128>(q) * b || p == 0) return false;
  r.q = q;
  r.p = p;
  return true;
}

BOOST_FORCEINLINE bool weights_are_short(const Join_weights<std::int64_t>& w) {
  return (w.a2 | w.b2 | w.a3 | w.b3 | w.mix) < (std::int64_t(1) << 16);
}

// The decision on differences in units of 2^d (left) and 1 (right), of 53 bits for the points: |a1| <= 2^54, |a2| <= 2^55,
// |a3| <= 2^56. With factors w2 < 2^19 of a2 and b2, w3 < 2^28 and a factor < 2^16 of the mixed term (see take_up) no form
// or part of it exceeds its limbs: q^2 w2 < 2^127, V < 2^(108+19+55+1) < 2^191, its product with a1 < 2^239; q^3 w3 < 2^191,
// n.b3 < 2^(110+56+2) < 2^191, their products < 2^360; q^3 w3 a1_0 < 2^245, p V w < 2^254, the sum of three terms
// < 2^312, its product with a1 < 2^367; curvature vector: (b1.b1)^2 w2 < 2^(220+19), times 2^167; torsion: (n.a3) w < 2^188, times
// 2^222.
template <Join_kind kind, int N, class Weights, class Stages>
BOOST_FORCEINLINE Join_answer decide_on_grids(const Differences<std::int64_t, N>& a,
                                              const Differences<std::int64_t, N>& b, const Weights& w, Stages& stages) {
  typedef Fixed_integer<1> Integer;
  constexpr int k = order_of(kind);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  if (stages.uses(Join_stage::residue)) {
    const Differences<std::uint64_t, N> x = converted<k, std::uint64_t>(a), y = converted<k, std::uint64_t>(b);
    Residue_zero zero;
    const Join_equations<std::uint64_t, N, Weights, Residue_zero> equations(x, y, w, zero);
    if (!all_hold<kind>(equations)) return decided(Join_stage::residue, Join_answer::no);
  }
  const Differences<Integer, N> x = converted<k, Integer>(a), y = converted<k, Integer>(b);
  Exact_zero<Integer> zero;
  const Join_equations<Integer, N, Weights, Exact_zero<Integer>> equations(x, y, w, zero);
  const auto answer = [](bool holds) { return holds ? Join_answer::yes : Join_answer::no; };
  if constexpr (kind == Join_kind::torsion)
    if (!equations.both_have_curvature()) return decided(Join_stage::fixed_integer, Join_answer::undefined);
  if constexpr (is_geometric(kind) || kind == Join_kind::curvature_vector) {
    constexpr Join_kind given_parallel = kind == Join_kind::curvature_vector ? Join_kind::g2 : kind;
    const bool parallel = equations.tangents_parallel();
    if (is_geometric(kind) && !parallel) return decided(Join_stage::fixed_integer, Join_answer::no);
    Short_join_ratio r;
    if (parallel && order_of(kind) >= 2 && stages.uses(Join_stage::simple_ratio) && weights_are_short(w) &&
        short_ratio(a[0][0], b[0][0], r))
      return decided(Join_stage::simple_ratio, answer(equations_hold<given_parallel>(equations, r)));
    if (parallel)
      return decided(Join_stage::fixed_integer, answer(equations_hold<given_parallel>(equations, equations.ratio())));
  }
  return decided(Join_stage::fixed_integer, answer(equations_hold<kind>(equations, equations.ratio())));
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The legs of an end in units of 2^exponent, if its points lie on such a grid.
template <int N> struct Grid_legs {
  Differences<std::int64_t, N> legs;
  int exponent;
  int zeros; // trailing bits that are zero in all legs
  bool valid;
};

BOOST_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 2>& x) { return x[0] | x[1]; }
BOOST_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 3>& x) { return x[0] | x[1] | x[2]; }

// The number of trailing zeros of a number below 2^54, 53 for zero.
inline int trailing_zeros(std::int64_t x) {
  // the lowest bit, as a double
  return x == 0 ? 53 : binary_exponent(static_cast<double>(x & -x));
}

// The legs without `shift` trailing zeros.
BOOST_FORCEINLINE std::array<std::int64_t, 2> without_zeros(const std::array<std::int64_t, 2>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift};
}
BOOST_FORCEINLINE std::array<std::int64_t, 3> without_zeros(const std::array<std::int64_t, 3>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift, x[2] >> shift};
}
template <int k, std::size_t N>
BOOST_FORCEINLINE Differences<std::int64_t, N> without_zeros(const std::array<std::array<std::int64_t, N>, 3>& x,
                                                             int shift) {
  if constexpr (k == 1)
    return {without_zeros(x[0], shift)};
  else if constexpr (k == 2)
    return {without_zeros(x[0], shift), without_zeros(x[1], shift)};
  else
    return {without_zeros(x[0], shift), without_zeros(x[1], shift), without_zeros(x[2], shift)};
}

template <int k, std::size_t N>
BOOST_FORCEINLINE Grid_legs<N> grid_legs_of(const std::array<std::array<double, N>, 4>& points) {
  double size = std::max(largest(points[0]), largest(points[1]));
  if constexpr (k >= 2) size = std::max(size, largest(points[2]));
  if constexpr (k >= 3) size = std::max(size, largest(points[3]));
  Grid grid(size);
  if (!grid.valid()) return {{}, 0, 0, false};
  End_points<std::int64_t, N> x;
  x[0] = grid(points[0]);
  x[1] = grid(points[1]);
  if constexpr (k >= 2) x[2] = grid(points[2]);
  if constexpr (k >= 3) x[3] = grid(points[3]);
  const Differences<std::int64_t, N> legs = legs_of<k>(x);
  std::int64_t bits = any_bits(legs[0]);
  if constexpr (k >= 2) bits |= any_bits(legs[1]);
  if constexpr (k >= 3) bits |= any_bits(legs[2]);
  return {legs, grid.exponent(), trailing_zeros(bits), grid.valid()};
}

// The decision on legs on grids, or `unknown`.
template <Join_kind kind, int N, class Weights, class Stages>
BOOST_FORCEINLINE Join_answer decide_on_grid_legs(const Grid_legs<N>& left, int m, const Grid_legs<N>& right, int n,
                                                  int pivot, Weights w, Stages& stages) {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  constexpr int k = order_of(kind);
  if (!left.valid || !right.valid) return Join_answer::unknown;
  // The coarsest grid that has all legs, as far as the legs of each end allow: short numbers leave residues that say more.
  const int e = std::min(left.exponent + left.zeros, right.exponent + right.zeros), x = std::max(e - left.exponent, 0),
            y = std::max(e - right.exponent, 0);
  if (take_up<kind>(w, left.exponent + x - right.exponent - y))
    return decide_on_grids<kind, N>(differences_of<k, true>(without_zeros<k>(rotated<k>(left.legs, pivot), x), m),
                                    differences_of<k, false>(without_zeros<k>(rotated<k>(right.legs, pivot), y), n), w,
                                    stages);
#endif
  return Join_answer::unknown;
}

// The lengths of two domains, if both have small whole numbers as ends.
inline bool whole_lengths(const std::pair<double, double>& left, const std::pair<double, double>& right, int& h,
                          int& l) {
  for (const double x : {left.first, left.second, right.first, right.second})
    if (!(std::abs(x) <= 0x1p20) || x != static_cast<int>(x)) return false;
  h = static_cast<int>(left.second - left.first);
  l = static_cast<int>(right.second - right.first);
  return h <= 1024 && l <= 1024;
}

// The end of a curve with double coordinates, or its start, as given. `Points` is something with degree(), domain() and
// coordinate(j, i).
template <int k, int N, class Points> BOOST_FORCEINLINE End_points<double, N> points_of(const Points& end) {
  const int m = end.degree();
  const auto point = [&](int j) -> std::array<double, N> {
    if constexpr (N == 2)
      return {end.coordinate(j, 0), end.coordinate(j, 1)};
    else
      return {end.coordinate(j, 0), end.coordinate(j, 1), end.coordinate(j, 2)};
  };
  if constexpr (k == 0)
    return {point(0)};
  else if constexpr (k == 1)
    return {point(0), point(std::min(m, 1))};
  else if constexpr (k == 2)
    return {point(0), point(std::min(m, 1)), point(std::min(m, 2))};
  else
    return {point(0), point(std::min(m, 1)), point(std::min(m, 2)), point(std::min(m, 3))};
}

// The decision on two ends with double coordinates, exact or `unknown`.
template <Join_kind kind, int N, class Left, class Right, class Stages>
Join_answer decide_on_doubles(const Left& left, const Right& right, Stages& stages) {
  constexpr int k = order_of(kind);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  const End_points<double, N> p = points_of<k, N>(left), q = points_of<k, N>(right);
  if constexpr (is_parametric(kind) || is_geometric(kind))
    if (p[0] != q[0]) return decided(Join_stage::comparison, Join_answer::no);
  if constexpr (k == 0)
    return decided(Join_stage::comparison, Join_answer::yes);
  else {
    const int m = left.degree(), n = right.degree();
    if (std::max(m, n) > 1000) return Join_answer::unknown;
    const Differences<double, N> legs_a = legs_of<k>(p), legs_b = legs_of<k>(q);
    const int pivot = is_parametric(kind) ? 0 : largest_coordinate(legs_a[0]);
    if constexpr (!is_parametric(kind)) {
      // the signs of rounded differences are exact
      const double x = coordinate_at(legs_a[0], pivot), y = coordinate_at(legs_b[0], pivot);
      if constexpr (is_geometric(kind)) {
        if (!((x < 0 && 0 < y) || (0 < x && y < 0))) return decided(Join_stage::comparison, Join_answer::no);
      } else if (x == 0 || largest(legs_b[0]) == 0)
        return decided(Join_stage::comparison, Join_answer::undefined);
    }

    Join_weights_of<kind, std::int64_t> w;
    if constexpr (is_parametric(kind)) {
      int h, l;
      if (!whole_lengths(left.domain(), right.domain(), h, l)) return Join_answer::unknown;
      w = Parametric_join_weights<std::int64_t>::of(m, n, h, l);
      if (!weights_fit<k>(w)) return Join_answer::unknown;
    } else
      w = Join_weights<std::int64_t>::template geometric<kind>(m, n);

    if (stages.uses(Join_stage::floating_point)) {
      typedef Join_weights_of<kind, double> Weights;
      typedef Join_filter<Weights> Filter;
      const Difference_bounds A = bounds_of_differences<k>(legs_a), B = bounds_of_differences<k>(legs_b);
      const Weights weights = converted<double>(w);
      const Filter filter{A, B, weights};
      if (filter.in_range()) {
        const Differences<double, N> a = differences_of<k, true>(legs_a, m), b = differences_of<k, false>(legs_b, n);
        const Join_equations<double, N, Weights, const Filter> equations(a, b, weights, filter, pivot);
        if (!all_hold<kind>(equations)) return decided(Join_stage::floating_point, Join_answer::no);
      }
    }
    if (!stages.uses(Join_stage::fixed_integer)) return Join_answer::unknown;
    return decide_on_grid_legs<kind, N>(grid_legs_of<k>(points_of<k, N>(left)), m,
                                        grid_legs_of<k>(points_of<k, N>(right)), n, pivot, w, stages);
  }
}

// An end with what its decisions have in common: the legs on its grid.
template <class Traits_, int N> class Prepared_double_end {
  End_points<double, N> points_;
  int degree_;
  std::pair<double, double> domain_;
  Grid_legs<N> grid_;
  int pivot_; // the largest coordinate of the first leg

public:
  typedef Traits_ Traits;

  template <class Points>
  explicit Prepared_double_end(const Points& end)
      : points_(points_of<3, N>(end)), degree_(end.degree()), domain_(end.domain()), grid_(grid_legs_of<3>(points_)),
        pivot_(grid_.valid ? largest_coordinate(grid_.legs[0]) : 0) {}

  int degree() const { return degree_; }
  int dimension() const { return N; }
  std::pair<double, double> domain() const { return domain_; }
  double coordinate(int j, int i) const { return points_[j][i]; }

  template <Join_kind kind, class Stages>
  static Join_answer decide(const Prepared_double_end& left, const Prepared_double_end& right, Stages& stages) {
    if constexpr (is_parametric(kind))
      return decide_on_doubles<kind, N>(left, right, stages);
    else {
      const Grid_legs<N>&x = left.grid_, &y = right.grid_;
      const int m = left.degree(), n = right.degree(), pivot = left.pivot_;
      if (!x.valid || !y.valid || std::max(m, n) > 1000 || !stages.uses(Join_stage::fixed_integer))
        return decide_on_doubles<kind, N>(left, right, stages);
      const auto decided = [&](Join_answer answer) {
        stages.decided(Join_stage::comparison, answer);
        return answer;
      };
      const std::int64_t first = x.legs[0][pivot], second = y.legs[0][pivot];
      if constexpr (is_geometric(kind)) {
        if (left.points_[0] != right.points_[0] || !((first < 0 && 0 < second) || (0 < first && second < 0)))
          return decided(Join_answer::no);
      } else if (first == 0 || y.legs[0][right.pivot_] == 0)
        return decided(Join_answer::undefined);
      return decide_on_grid_legs<kind, N>(x, m, y, n, pivot, Join_weights<std::int64_t>::template geometric<kind>(m, n),
                                          stages);
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_JOIN_STAGES_H
