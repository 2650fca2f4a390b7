// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_INPUT_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_INPUT_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Degree_factors.h>
#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_filter.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

/// \file Join_input.h
/// Each kind of ends has a class here that tells the stages of Join_ladder.h what they need:
///
/// - signs: `first_left()` and `first_right()`, the first differences with the signs of the exact
///   ones;
/// - factors: `find_factors()`, or else `first_derivatives_differ()`;
/// - the filter: `left()`, `right()`, `left_bounds()`, `right_bounds()` and `rounded_factors()`,
///   with the errors of `Rounding`;
/// - residues: `find_unit()`, `integer_factors()`, `left_in()`, `right_in()` and
///   `units_of_factors()`, in as many limbs as the first of `Limbs` that suffices;
/// - the grid: `left_grid()` and `right_grid()`.
///
/// All differences have the pivot as their first coordinate, unless the question is parametric.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The lengths of two domains as whole numbers of at most 1024, if the ends of the domains are
// multiples of 2^-20 up to 2^20.
struct Short_lengths {
  std::int64_t left = 1, right = 1;
  bool valid = true;

  Short_lengths() = default;
  Short_lengths(const std::pair<double, double>& x, const std::pair<double, double>& y) {
    const auto in_units = [](double end) { return static_cast<std::int64_t>(end * 0x1p20); };
    for (const double end : {x.first, x.second, y.first, y.second})
      if (!(std::abs(end) <= 0x1p20) || end * 0x1p20 != static_cast<double>(in_units(end))) {
        valid = false;
        return;
      }
    const std::int64_t h = in_units(x.second) - in_units(x.first), l = in_units(y.second) - in_units(y.first);
    const int zeros = trailing_zeros(h | l);
    left = h >> zeros;
    right = l >> zeros;
    valid = left <= 1024 && right <= 1024;
  }
};

// Returns whether m l a1 and n h b1, to which the first derivatives are proportional, differ by
// more than their rounding errors, for domains of any lengths h and l. Each number is rounded four
// times.
template <std::size_t N>
bool first_derivatives_differ(const std::array<double, N>& a1, int m, const std::pair<double, double>& left,
                              const std::array<double, N>& b1, int n, const std::pair<double, double>& right) {
  const double h = left.second - left.first, l = right.second - right.first;
  if (!(0x1p-500 <= (std::min)(h, l))) return false;
  for (std::size_t i = 0; i < N; ++i) {
    const double x = (m * l) * a1[i], y = (n * h) * b1[i], size = std::abs(x) + std::abs(y);
    if (0x1p-500 <= size && std::abs(x - y) > 0x1p-48 * size) return true;
  }
  return false;
}

// The degrees up to which factors are exact.
CGAL_GC_FORCEINLINE bool degrees_fit(int m, int n) { return (std::max)(m, n) <= 1000; }

// An end with double coordinates, which is read once for all questions. The points are as given;
// the coordinate number `first` of the first differences is exchanged for the first one.
template <int N> class Double_end {
  int degree_;
  std::pair<double, double> domain_;
  End_polygon<double, N> points_; // the last one repeated
  First_differences<double, N> first_differences_;

public:
  template <class Points>
  Double_end(const Points& end, int first)
      : degree_(end.degree()), domain_(end.domain()), points_(points_of<3, N>(end)),
        first_differences_(internal::first_differences<3>(points_of<3, N>(end, first))) {}

  int degree() const { return degree_; }
  int dimension() const { return N; }
  const std::pair<double, double>& domain() const { return domain_; }
  double coordinate(int j, int i) const { return points_[j][i]; }
  const End_polygon<double, N>& points() const { return points_; }
  // inwards
  const First_differences<double, N>& first_differences() const { return first_differences_; }
};

// An end with double coordinates for one question. Its points are read again where residues need
// them: few joins do, and all of them together would not stay in registers.
template <Join_question question, int N, class Points> class Double_end_view {
  static constexpr int k = highest_difference(question);
  const Points& end_;
  std::pair<double, double> domain_; // if it is asked for
  First_differences<double, N> first_differences_;

public:
  CGAL_GC_FORCEINLINE Double_end_view(const Points& end, int first)
      : end_(end), first_differences_(internal::first_differences<k>(points_of<k, N>(end, first))) {
    if constexpr (is_parametric(question)) domain_ = end.domain();
  }

  CGAL_GC_FORCEINLINE int degree() const { return end_.degree(); }
  const std::pair<double, double>& domain() const { return domain_; }
  CGAL_GC_FORCEINLINE const Points& end() const { return end_; }
  const First_differences<double, N>& first_differences() const { return first_differences_; }
};

// Two ends without weights have this in common: first differences as doubles that are rounded once,
// and the factors of the degrees.
template <Join_question question_, int N> class Rounded_polygons {
  static constexpr int k = highest_difference(question_);

protected:
  int m_, n_;
  const First_differences<double, N>&left_differences_, &right_differences_; // inwards

  CGAL_GC_FORCEINLINE Rounded_polygons(const First_differences<double, N>& left, int m,
                                       const First_differences<double, N>& right, int n)
      : m_(m), n_(n), left_differences_(left), right_differences_(right) {}

  // Takes domains whose lengths are as h to l, which are at most 1024, if the question is
  // parametric.
  CGAL_GC_FORCEINLINE bool factors_with(std::int64_t h, std::int64_t l,
                                        Degree_factors_of<question_, std::int64_t>& w) const {
    if (!degrees_fit(m_, n_)) return false;
    if constexpr (is_parametric(question_)) {
      w = Parametric_degree_factors<std::int64_t>::of(m_, n_, h, l);
      return weights_fit<k>(w);
    } else {
      w = Degree_factors<std::int64_t>::geometric<question_>(m_, n_);
      return true;
    }
  }

public:
  static constexpr Join_question question = question_;
  static constexpr int dimension = N;

  CGAL_GC_FORCEINLINE std::array<double, N> first_left() const {
    return internal::minus(zero_vector<double, N>(), left_differences_[0]);
  }
  CGAL_GC_FORCEINLINE const std::array<double, N>& first_right() const { return right_differences_[0]; }

  typedef Degree_factors_of<question, std::int64_t> Factors;

  static constexpr bool weighted = false;
  typedef Rounding_of_differences Rounding;
  typedef Degree_factors_of<question, double> Rounded_factors;
  CGAL_GC_FORCEINLINE Differences<double, N> left() const { return differences_of<k, true>(left_differences_, m_); }
  CGAL_GC_FORCEINLINE Differences<double, N> right() const { return differences_of<k, false>(right_differences_, n_); }
  CGAL_GC_FORCEINLINE Difference_bounds left_bounds() const { return bounds_of_differences<k>(left_differences_); }
  CGAL_GC_FORCEINLINE Difference_bounds right_bounds() const { return bounds_of_differences<k>(right_differences_); }
  CGAL_GC_FORCEINLINE Rounded_factors rounded_factors(const Factors& w) const { return converted<double>(w); }

  template <int> using Integer_factors = Factors;
  template <int> static constexpr bool has_short_factors = false; // these are
  // The factors of a form on doubles are 2^units_of_factors()(form) times the whole ones.
  struct Units {
    CGAL_GC_FORCEINLINE int operator()(Join_question) const { return 0; }
  };
  CGAL_GC_FORCEINLINE Units units_of_factors(const Factors&) const { return Units(); }
};

// The common unit of points that are read for it. The four points of both ends are read in a
// function that is compiled apart, lest they take the registers of the filter.
template <int k, int N, class Left, class Right>
BOOST_NOINLINE bool find_unit_apart(Left left, Right right, double largest, int& unit) {
  return find_common_unit<k>(points_of<k, N>(left), points_of<k, N>(right), largest, unit);
}
template <int N, Join_question question, class Left, class Right>
CGAL_GC_FORCEINLINE bool find_unit_of(const Double_end_view<question, N, Left>& left,
                                      const Double_end_view<question, N, Right>& right, double largest, int& unit) {
  constexpr int k = highest_difference(question);
  if constexpr (k == 3)
    return find_unit_apart<k, N, Left, Right>(left.end(), right.end(), largest, unit);
  else
    return find_common_unit<k>(points_of<k, N>(left.end()), points_of<k, N>(right.end()), largest, unit);
}

// Two such ends without weights, and the lengths of their domains. They must outlive the object.
template <Join_question question_, int N, class Left = Double_end<N>, class Right = Double_end<N>>
class Double_join : public Rounded_polygons<question_, N> {
  typedef Rounded_polygons<question_, N> Base;
  static constexpr int k = highest_difference(question_);
  const Left& left_;
  const Right& right_;
  const Short_lengths& lengths_;

public:
  using typename Base::Factors;

  // \pre the lengths are those of the domains if the question is parametric
  CGAL_GC_FORCEINLINE Double_join(const Left& left, const Right& right, const Short_lengths& lengths)
      : Base(left.first_differences(), left.degree(), right.first_differences(), right.degree()), left_(left),
        right_(right), lengths_(lengths) {}

  CGAL_GC_FORCEINLINE bool find_factors(Factors& w) const {
    return lengths_.valid && this->factors_with(lengths_.left, lengths_.right, w);
  }
  CGAL_GC_FORCEINLINE bool first_derivatives_differ() const {
    if constexpr (is_parametric(question_))
      return internal::first_derivatives_differ(this->first_left(), left_.degree(), left_.domain(), this->first_right(),
                                                right_.degree(), right_.domain());
    else
      return false;
  }

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  // These numbers of limbs suffice as a rule: a form of degree d in numbers of n bits that has
  // passed the filter has about (d - 1) n bits.
  typedef std::integer_sequence<int, form_degree(question_) <= 2 ? 2 : form_degree(question_) <= 4 ? 3 : 4> Limbs;
  // A number of one limb of which products are residues.
  template <int limbs> using Integer = Fixed_integer<1, limbs>;

  CGAL_GC_FORCEINLINE bool find_unit(double largest, int& unit) const {
    if constexpr (std::is_same_v<Left, Double_end<N>>)
      return find_common_unit<k>(left_.points(), right_.points(), largest, unit);
    else
      return find_unit_of<N>(left_, right_, largest, unit);
  }
  template <int>
  CGAL_GC_FORCEINLINE bool integer_factors(const Factors& given, const typename Base::Units&, Factors& w) const {
    w = given;
    if constexpr (is_parametric(question_))
      return true;
    else
      return factors_fit<question_>(w);
  }
  template <int limbs> CGAL_GC_FORCEINLINE Differences<Integer<limbs>, N> left_in(int unit) const {
    return in_units<k, Integer<limbs>>(this->left(), power_of_two(-unit));
  }
  template <int limbs> CGAL_GC_FORCEINLINE Differences<Integer<limbs>, N> right_in(int unit) const {
    return in_units<k, Integer<limbs>>(this->right(), power_of_two(-unit));
  }
#endif
};

// An end with integers as coordinates, all below 2^60 in absolute value: its first differences are
// below 2^61, and become doubles by one rounding. Their coordinate number `first` is exchanged for
// the first one.
template <int N> class Integer_end {
  End_polygon<std::int64_t, N> points_;                  // the last one repeated
  First_differences<std::int64_t, N> first_differences_; // inwards
  First_differences<double, N> rounded_differences_;
  std::int64_t length_; // of the domain, in units of both curves; it is a double
  int degree_;

public:
  Integer_end() = default;
  Integer_end(const End_polygon<std::int64_t, N>& points, int first, int degree, std::int64_t length)
      : points_(points), first_differences_(internal::first_differences<3>(points)), length_(length), degree_(degree) {
    for (std::array<std::int64_t, N>& difference : first_differences_) std::swap(difference[0], difference[first]);
    rounded_differences_ = converted<3, double>(first_differences_);
  }

  int degree() const { return degree_; }
  std::int64_t length() const { return length_; }
  const End_polygon<std::int64_t, N>& points() const { return points_; }
  const First_differences<std::int64_t, N>& first_differences() const { return first_differences_; }
  const First_differences<double, N>& rounded_differences() const { return rounded_differences_; }

  // Returns whether the first differences are as short as those of double numbers.
  bool is_short() const {
    constexpr std::int64_t longest = std::int64_t(1) << 54;
    for (const std::array<std::int64_t, N>& difference : first_differences_)
      for (const std::int64_t x : difference)
        if (x < -longest || longest < x) return false;
    return true;
  }
};

// Two such ends, which must outlive the object. Differences have one limb; the second one is room
// for the factors, where first differences are long.
template <Join_question question_, int N, int limbs_of_differences>
class Integer_join : public Rounded_polygons<question_, N> {
  typedef Rounded_polygons<question_, N> Base;
  static constexpr int k = highest_difference(question_);
  const Integer_end<N>&left_, &right_;

public:
  using typename Base::Factors;

  CGAL_GC_FORCEINLINE Integer_join(const Integer_end<N>& left, const Integer_end<N>& right)
      : Base(left.rounded_differences(), left.degree(), right.rounded_differences(), right.degree()), left_(left),
        right_(right) {}

  CGAL_GC_FORCEINLINE bool find_factors(Factors& w) const {
    if (is_parametric(question_) && (std::max)(left_.length(), right_.length()) > 1024) return false;
    return this->factors_with(left_.length(), right_.length(), w);
  }
  CGAL_GC_FORCEINLINE bool first_derivatives_differ() const {
    if constexpr (is_parametric(question_))
      return internal::first_derivatives_differ(this->first_left(), left_.degree(),
                                                {0, static_cast<double>(left_.length())}, this->first_right(),
                                                right_.degree(), {0, static_cast<double>(right_.length())});
    else
      return false;
  }

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  typedef std::integer_sequence<int, form_degree(question_) <= 2   ? 2
                                     : form_degree(question_) <= 4 ? 2 + limbs_of_differences
                                                                   : 2 + 2 * limbs_of_differences>
      Limbs;
  template <int limbs> using Integer = Fixed_integer<limbs_of_differences, limbs>;

  CGAL_GC_FORCEINLINE bool find_unit(double, int& unit) const {
    unit = 0;
    return true;
  }
  template <int>
  CGAL_GC_FORCEINLINE bool integer_factors(const Factors& given, const typename Base::Units&, Factors& w) const {
    w = given;
    if constexpr (limbs_of_differences > 1 || is_parametric(question_))
      return true;
    else
      return factors_fit<question_>(w);
  }
  template <int limbs> CGAL_GC_FORCEINLINE Differences<Integer<limbs>, N> left_in(int) const {
    return converted<k, Integer<limbs>>(differences_of<k, true>(left_.first_differences(), this->m_));
  }
  template <int limbs> CGAL_GC_FORCEINLINE Differences<Integer<limbs>, N> right_in(int) const {
    return converted<k, Integer<limbs>>(differences_of<k, false>(right_.first_differences(), this->n_));
  }
#endif
};

// The weights of an end, w_j c^j times a factor, so that the first two are in [1, 2): powers of two
// do this without rounding, and the curve is the same in another parameter. Not valid unless all
// lie within 2^-20 and 2^20.
template <int k> class End_weights {
  std::array<double, 4> w_; // k + 1 of them
  bool valid_;

public:
  template <class End> CGAL_GC_FORCEINLINE void read(const End& end) {
    const int m = end.degree();
    const double first = end.weight(0), second = end.weight((std::min)(1, m));
    const int e = binary_exponent(first), f = binary_exponent(second) - e;
    valid_ = -300 <= e && e <= 300 && -150 <= f && f <= 150;
    if (!valid_) return;
    w_[0] = first * power_of_two(-e);
    w_[1] = second * power_of_two(-e - f);
    for (int j = 2; j <= k; ++j) {
      w_[j] = end.weight((std::min)(j, m)) * power_of_two(-e - j * f);
      valid_ &= 0x1p-20 <= w_[j] && w_[j] <= 0x1p20;
    }
  }
  CGAL_GC_FORCEINLINE bool valid() const { return valid_; }
  CGAL_GC_FORCEINLINE const std::array<double, 4>& operator()() const { return w_; }

  // The largest power of two of which all weights are multiples is 2 to this power. \pre they are
  // valid
  CGAL_GC_FORCEINLINE int exponent_of_unit() const {
    int unit = 20;
    for (int j = 0; j <= k; ++j) {
      const std::uint64_t bits = bits_of(w_[j]) | std::uint64_t(1) << 52;
      unit = (std::min)(unit, binary_exponent(w_[j]) - 52 + trailing_zero_bits(bits));
    }
    return unit;
  }
  // Converts the weights to whole numbers of 2^unit, unless they are too long.
  template <class Integer> CGAL_GC_FORCEINLINE bool in_units(int unit, std::array<Integer, 4>& w) const {
    for (int j = 0; j <= k; ++j) {
      const double x = w_[j] * power_of_two(-unit);
      if (!(x <= 0x1p56)) return false;
      w[j] = Integer(static_cast<std::int64_t>(x));
    }
    return true;
  }
};

// For differences that are rounded once and factors that come from weights by at most nine
// operations: each factor is at most its value 1 with an error of 16 units.
struct Rounding_of_weighted_ends {
  // unreachable: computed by the compiler
  static constexpr Join_rounding value() {
    constexpr Rounding_bound w(1, 16 * 0x1p-52);
    return Join_rounding(Weighted_degree_factors<Join_question::g3, Rounding_bound>{w, w, w, w, w, w});
  }
};

// Ends with double coordinates and positive weights, for a question into which the weights enter.
// They must outlive the object.
template <Join_question question_, int N, class Left, class Right> class Weighted_join {
  static constexpr int k = highest_difference(question_);

  const Left& left_end_;
  const Right& right_end_;
  int pivot_;
  Differences<double, N> left_, right_;

public:
  static constexpr Join_question question = question_;
  static constexpr int dimension = N;

  CGAL_GC_FORCEINLINE Weighted_join(const Left& left, const Right& right)
      : left_end_(left), right_end_(right), pivot_(pivot_of<N>(left)),
        left_(chords_from_end<k, true>(points_of<k, N>(left, pivot_))),
        right_(chords_from_end<k, false>(points_of<k, N>(right, pivot_))) {}

  CGAL_GC_FORCEINLINE const std::array<double, N>& first_left() const { return left_[0]; }
  CGAL_GC_FORCEINLINE const std::array<double, N>& first_right() const { return right_[0]; }

  struct Factors {
    End_weights<k> left, right;
    int m, n;
  };
  CGAL_GC_FORCEINLINE bool find_factors(Factors& w) const {
    w.left.read(left_end_);
    w.right.read(right_end_);
    w.m = left_end_.degree();
    w.n = right_end_.degree();
    return degrees_fit(w.m, w.n) && w.left.valid() && w.right.valid();
  }
  CGAL_GC_FORCEINLINE bool first_derivatives_differ() const { return false; }

  static constexpr bool weighted = true;
  typedef Rounding_of_weighted_ends Rounding;
  typedef Weighted_degree_factors<question, double> Rounded_factors;
  CGAL_GC_FORCEINLINE const Differences<double, N>& left() const { return left_; }
  CGAL_GC_FORCEINLINE const Differences<double, N>& right() const { return right_; }
  CGAL_GC_FORCEINLINE Difference_bounds left_bounds() const { return bounds_of_chords<k>(left_); }
  CGAL_GC_FORCEINLINE Difference_bounds right_bounds() const { return bounds_of_chords<k>(right_); }
  CGAL_GC_FORCEINLINE Rounded_factors rounded_factors(const Factors& w) const {
    return Rounded_factors::of(w.left(), w.m, w.right(), w.n);
  }

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  typedef std::conditional_t<question == Join_question::g2, std::integer_sequence<int, 3, 4, 8>,
                             std::integer_sequence<int, 4, 8>>
      Limbs;
  template <int limbs> using Integer = Fixed_integer<1, limbs>;
  template <int limbs> using Integer_factors = Weighted_degree_factors<question, Integer<limbs>>;

  CGAL_GC_FORCEINLINE bool find_unit(double largest, int& unit) const {
    return find_common_unit<k>(points_of<k, N>(left_end_), points_of<k, N>(right_end_), largest, unit);
  }
  struct Units {
    int left, right;
    CGAL_GC_FORCEINLINE int operator()(Join_question form) const {
      return left * Rounded_factors::left_degree(form) + right * Rounded_factors::right_degree(form);
    }
  };
  CGAL_GC_FORCEINLINE Units units_of_factors(const Factors& w) const {
    return {w.left.exponent_of_unit(), w.right.exponent_of_unit()};
  }
  // Those that have one limb, as the factors of ends without weights. Here all products are exact
  // as doubles.
  template <int limbs> static constexpr bool has_short_factors = question == Join_question::g2&& limbs == 3;
  CGAL_GC_FORCEINLINE bool short_factors(const Rounded_factors& factors, const Units& units,
                                         Degree_factors<std::int64_t>& w) const {
    const double scale = power_of_two(-units(question)), a2 = factors.a2 * scale, b2 = factors.b2 * scale;
    if (!((std::max)(a2, b2) < factor_limits<question>().a2)) return false;
    w = {static_cast<std::int64_t>(a2), static_cast<std::int64_t>(b2), 1, 1, 1};
    return true;
  }
  template <int limbs>
  CGAL_GC_FORCEINLINE bool integer_factors(const Factors& given, const Units& units, Integer_factors<limbs>& w) const {
    std::array<Integer<limbs>, 4> x{}, y{};
    if (!given.left.in_units(units.left, x) || !given.right.in_units(units.right, y)) return false;
    w = Integer_factors<limbs>::of(x, given.m, y, given.n);
    return true;
  }
  template <int limbs> CGAL_GC_FORCEINLINE Differences<Integer<limbs>, N> left_in(int unit) const {
    return in_units<k, Integer<limbs>>(left_, power_of_two(-unit));
  }
  template <int limbs> CGAL_GC_FORCEINLINE Differences<Integer<limbs>, N> right_in(int unit) const {
    return in_units<k, Integer<limbs>>(right_, power_of_two(-unit));
  }
#endif
};

// Returns whether the first derivatives of two ends with double coordinates and positive weights
// differ by more than their rounding errors.
template <int N, class Left, class Right> bool weighted_derivatives_differ(const Left& left, const Right& right) {
  const auto ratio = [](const auto& end) -> double {
    // of shorter types, too
    const double first = end.weight(0), second = end.weight((std::min)(1, end.degree()));
    return second / first;
  };
  const auto first_derivative = [](const First_differences<double, N>& d, double factor) {
    std::array<double, N> x = d[0];
    for (double& xi : x) xi *= factor;
    return x;
  };
  const std::pair<double, double> h = left.domain(), l = right.domain();
  const int m = left.degree(), n = right.degree();
  const double r = ratio(left), s = ratio(right);
  const bool in_range = 0x1p-500 <= (std::min)(r, s) && (std::max)(r, s) <= 0x1p500 &&
                        (std::max)(m * (l.second - l.first), n * (h.second - h.first)) <= 0x1p500;
  return in_range &&
         first_derivatives_differ(first_derivative(chords_from_end<1, true>(points_of<1, N>(left)), r), m, h,
                                  first_derivative(chords_from_end<1, false>(points_of<1, N>(right)), s), n, l);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_INPUT_H
