// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_GRADE_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_GRADE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

/// \file Join_grade.h
/// What a designer sees of a join in the plane: a corner that is meant, a kink that nobody wants and how large it is, or a
/// smooth join. Which angle is a corner is decided exactly, for any bound in degrees.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The arc tangent of 1/k for k >= 5 in units of 2^-w. Each term 1/((2i+1) k^(2i+1)) is rounded downwards twice and wrong by less than
// 2 units, and there are less than w/4 + 1 of them that are not zero.
inline boost::multiprecision::cpp_int arc_tangent_of_inverse(int k, int w) {
  boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1) << w, sum = 0;
  power /= k;
  for (int i = 0; !power.is_zero(); ++i) {
    const boost::multiprecision::cpp_int term = power / (2 * i + 1);
    if (i % 2 == 0)
      sum += term;
    else
      sum -= term;
    power /= k * k;
  }
  return sum;
}

// cos(a) and sin(a) for the angle a of p/q degrees, 0 < p/q < 180, in units of 2^-w, w >= 128, wrong by less than `error` units.
//
// Pi = 16 atan(1/5) - 4 atan(1/239), by Machin, is wrong by less than 20 (2 (w/4 + 1)) units, and a by one more. The error of sin(a)/a
// is multiplied by a < 3.2, and the product rounded: with the error of a that is less than 10 w + 41 + 3.2 (w + 8) + 1 < 14 w.
struct Rotation_bounds {
  typedef boost::multiprecision::cpp_int Integer;
  Integer cosine, sine;
  const int error;

  Rotation_bounds(const std::pair<Integer, Integer>& fraction, int w) : error(14 * w) {
    const auto& [p, q] = fraction;
    const Integer pi = 16 * arc_tangent_of_inverse(5, w) - 4 * arc_tangent_of_inverse(239, w),
                  angle = pi * p / (180 * q);
    const Cosine_and_sinc<Integer> c(Integer(angle * angle >> w), w);
    cosine = c.cosine;
    sine = c.sinc * angle >> w;
  }
};

// The numerator and the denominator of a rational number.
template <class FT> std::pair<Rotation_bounds::Integer, Rotation_bounds::Integer> long_fraction(const FT& x) {
  typedef Fraction_traits<FT> Traits;
  typename Traits::Numerator_type p;
  typename Traits::Denominator_type q;
  typename Traits::Decompose()(x, p, q);
  const auto integer = [](const auto& n) {
    std::ostringstream text;
    text << n;
    return Rotation_bounds::Integer(text.str());
  };
  return {integer(p), integer(q)};
}

// A long integer in a field.
template <class NT> NT from_long_integer(const Rotation_bounds::Integer& x) {
  constexpr int digits = 30;
  NT y(0);
  const Rotation_bounds::Integer size = abs(x);
  for (int shift = size.is_zero() ? 0 : static_cast<int>(msb(size)) / digits * digits; 0 <= shift; shift -= digits)
    y = NT(y * NT(1 << digits)) + NT(static_cast<int>(Rotation_bounds::Integer((size >> shift) & ((1 << digits) - 1))));
  return x < 0 ? NT(-y) : y;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The largest angle between two tangents that is a *kink*; what is larger is a *corner*, which somebody meant.
///
/// With \f$ B \f$ for the bound and \f$ c = |a \times b| \f$, \f$ d = a \cdot b \f$ of two vectors in the plane, their angle is larger
/// than the bound if and only if \f$ c \cos B - d \sin B > 0 \f$. That is decided exactly: by floating-point numbers with a bound of their
/// error, otherwise by enclosures of \f$ \cos B \f$ and \f$ \sin B \f$ whose precision is doubled until they decide. They cannot where
/// the angle is the bound. This is possible for few bounds only: the tangent of \f$ 180 m/n \f$ degrees, in lowest terms, is rational
/// for `n <= 2` and `n = 4` only, and in a field with two square roots for `n <= 24` (I. Niven, *Irrational Numbers*, 1956, theorem 3.11).
/// For these \f$ (d + ic)^n \f$ is real where the angles agree.
class Kink_bound {
public:
  /// Exact numbers.
  typedef typename Exact_field<double>::type Field;

  /// Makes the bound of this many degrees, as an exact number: 5 unless another one is given. (The `double` 0.1 is not the decimal 0.1.)
  /// \throws Error `parameter_outside_domain` unless the angle is larger than 0 and less than 180 degrees, `not_finite`
  explicit Kink_bound(const internal::Given_number<Field>& degrees = 5) : degrees_(degrees.value) {
    if (!(Field(0) < degrees_) || !(degrees_ < Field(180)))
      throw Error(Error_code::parameter_outside_domain, "Kink_bound: an angle that is not between 0 and 180 degrees");
    const Rotation rotation = rotation_bounds(128);
    cosine_ = rounded(rotation.cosine);
    sine_ = rounded(rotation.sine);
  }

  /// Returns the bound in degrees.
  const Field& degrees() const { return degrees_; }

  /// Decides whether the angle of two vectors in the plane is larger than the bound, given their cross product, whose sign does not matter,
  /// and their dot product.
  /// \tparam NT an integer or floating-point type, whose numbers are taken as they are, or an exact ordered field: the rational numbers,
  ///   possibly with one or two square roots
  /// \throws Error `zero_direction` when both products are zero, `not_finite`
  template <class NT> bool is_exceeded(const NT& cross, const NT& dot) const {
    std::optional<bool> answer;
    if constexpr (std::is_arithmetic_v<NT>)
      answer = is_exceeded(static_cast<double>(cross), static_cast<double>(dot), 0);
    else {
      const std::pair<double, double> c = CGAL::to_interval(cross), d = CGAL::to_interval(dot);
      answer = is_exceeded(c.first, d.first, (c.second - c.first) + (d.second - d.first));
    }
    if (answer) return *answer;
    if constexpr (std::is_integral_v<NT>)
      return is_exceeded_exactly(from_integer(cross), from_integer(dot));
    else if constexpr (std::is_arithmetic_v<NT>)
      return is_exceeded_exactly(internal::to_field<Field>(cross), internal::to_field<Field>(dot));
    else
      return is_exceeded_exactly(internal::Exact_number<NT>::of(cross), internal::Exact_number<NT>::of(dot));
  }

  /// Decides the same from rounded products whose errors are, in sum, at most `error`; empty where that does not tell.
  std::optional<bool> is_exceeded(double cross, double dot, double error) const {
    // The products as rounded, cosine and sine, and each operation are wrong by 2^-52, cosine and sine by 2^-51: 5 * 2^-52 in sum,
    // in every rounding mode. Below the normal numbers nothing is decided.
    const double c = std::abs(cross), excess = c * cosine_ - dot * sine_;
    if (std::abs(excess) > 0x1p-49 * (c + std::abs(dot)) + 1.001 * error + 0x1p-900) return 0 < excess;
    return std::nullopt;
  }

private:
  typedef internal::Rotation_bounds Rotation;
  typedef Rotation::Integer Integer;

  Field degrees_;
  double cosine_, sine_; // of the bound, rounded: wrong by less than 2^-52

  Rotation rotation_bounds(int bits) const { return Rotation(internal::long_fraction(degrees_), bits); }

  // A number of at most 1 that is given in units of 2^-128.
  static double rounded(const Integer& x) {
    const Integer size = abs(x) >> 66;
    const double y = std::ldexp(static_cast<double>(static_cast<std::int64_t>(size)), -62);
    return x < 0 ? -y : y;
  }

  // The least n such that the bound is a multiple of 180/n degrees; 0 when it is larger than 24.
  int part_of_half_turn() const {
    const std::pair<Integer, Integer> f = internal::long_fraction(degrees_);
    for (int n = 2; n <= 24; ++n)
      if ((f.first * n) % (f.second * 180) == 0) return n;
    return 0;
  }

  template <class T> static Field from_integer(T x) {
    return Field(static_cast<double>(x / 0x10000)) * Field(0x10000) + Field(static_cast<double>(x % 0x10000));
  }

  template <class NT> bool is_exceeded_exactly(const NT& cross, const NT& dot) const {
    const NT zero(0), c = cross < zero ? NT(-cross) : cross;
    if (c == zero && dot == zero)
      throw Error(Error_code::zero_direction, "Kink_bound: the angle of a vector of no length");
    if (c == zero) return dot < zero; // an angle of 0 or of 180 degrees
    const NT size = c + (dot < zero ? NT(-dot) : dot);
    for (int bits = 128;; bits *= 2) {
      const Rotation r = rotation_bounds(bits);
      const NT excess = NT(c * internal::from_long_integer<NT>(r.cosine)) -
                        NT(dot * internal::from_long_integer<NT>(r.sine)),
               error = size * NT(r.error);
      if (error < excess) return true;
      if (excess < NT(-error)) return false;
      if (bits == 128 && is_part_of_half_turn(c, dot)) return false; // of which only the bound itself is so near
    }
  }

  // Whether the angle is a multiple of the same 180/n degrees, n <= 24, as the bound.
  template <class NT> bool is_part_of_half_turn(const NT& cross, const NT& dot) const {
    const int n = part_of_half_turn();
    NT x = dot, y = cross; // (dot + i cross)^k
    for (int k = 1; k < n; ++k) {
      const NT real = NT(x * dot) - NT(y * cross);
      y = NT(x * cross) + NT(y * dot);
      x = real;
    }
    return n != 0 && y == NT(0);
  }
};

namespace internal {

// The cross and the dot product of two vectors of the plane, and a bound of their terms.
template <class NT> struct Leg_products {
  NT cross, dot, size;

  Leg_products(const std::array<NT, 2>& a, const std::array<NT, 2>& b)
      : cross(NT(a[0] * b[1]) - NT(a[1] * b[0])), dot(NT(a[0] * b[0]) + NT(a[1] * b[1])), size(0) {
    using std::abs;
    if constexpr (std::is_floating_point_v<NT>) size = (abs(a[0]) + abs(a[1])) * (abs(b[0]) + abs(b[1]));
  }
};

// The end of a plane Bézier curve as it is drawn: the direction is that of the first leg that is not zero.
template <class Traits_, int Degree, Curve_end which> class Image_end {
  typedef Bezier_curve<Traits_, Degree> Curve;
  const Curve& curve_;
  int leg_ = 1; // the first control point from the node on that is not the node

public:
  typedef Traits_ Traits;
  typedef Bezier_curve<Traits, 1> Line;

  explicit Image_end(const Curve& curve) : curve_(curve) {
    while (leg_ <= curve.degree() && are_equal(leg_, 0)) ++leg_;
  }

  // \throws Error `not_finite`
  void check_node() const {
    for (int i = 0; i < 2; ++i) check_finite(coordinate(0, i), "join_grade");
  }

  bool has_length() const { return leg_ <= curve_.degree(); }

  // Whether the handle is at the node. \pre has_length()
  bool is_retracted() const { return leg_ > 1; }

  // Whether all control points lie on the chord in order: the legs that are not zero have one direction. \pre has_length()
  bool is_line() const {
    Line leg = line(leg_ - 1, leg_);
    for (int j = leg_; j < curve_.degree(); ++j)
      if (!are_equal(j + 1, j)) {
        const Line next = line(j, j + 1);
        if (!is_g1_join(leg, next)) return false;
        leg = next;
      }
    return true;
  }

  // The first leg that is not zero, as a curve that ends, or starts, at the node.
  Line curve() const { return which == Curve_end::end ? line(leg_, 0) : line(0, leg_); }

  // The same in the direction of the curve, the coordinates subtracted in NT.
  template <class NT> std::array<NT, 2> vector() const {
    const int from = which == Curve_end::end ? leg_ : 0, to = which == Curve_end::end ? 0 : leg_;
    const auto difference = [&](int i) -> NT {
      return NT(to_field<NT>(coordinate(to, i)) - to_field<NT>(coordinate(from, i)));
    };
    return {difference(0), difference(1)};
  }

private:
  const typename Traits::Point& point(int j) const {
    return curve_.control_point(which == Curve_end::end ? curve_.degree() - j : j);
  }
  typename Traits::FT coordinate(int j, int i) const { return Traits().compute_coordinate_object()(point(j), i); }
  bool are_equal(int j, int k) const {
    return coordinate(j, 0) == coordinate(k, 0) && coordinate(j, 1) == coordinate(k, 1);
  }
  Line line(int j, int k) const { return Line({point(j), point(k)}); }
};

} // namespace internal

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
/// the curves has no length. A handle that is retracted is taken as `join_grade()` takes it: by the first side that is not zero.
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

/// \ingroup PkgGeometricContinuityContinuity
/// What a join of two plane curves looks like, from the roughest to the smoothest.
enum class Join_grade {
  gap,    ///< the second curve does not start where the first one ends
  corner, ///< the angle between the tangents is larger than a `Kink_bound`
  kink,   ///< the tangents differ, by no more than the bound
  g1,     ///< one tangent, while the curvature jumps, or is not defined where a handle is retracted
  g2      ///< \f$ G^2 \f$ or more: one tangent and one curvature
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns `gap`, `corner`, `kink`, `G1` or `G2`.
inline std::string to_string(Join_grade grade) {
  switch (grade) {
  case Join_grade::gap: return "gap";
  case Join_grade::corner: return "corner";
  case Join_grade::kink: return "kink";
  case Join_grade::g1: return "G1";
  case Join_grade::g2: return "G2";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes `to_string(grade)`.
inline std::ostream& operator<<(std::ostream& os, Join_grade grade) { return os << to_string(grade); }

namespace internal {

inline const Kink_bound& usual_kink_bound() {
  static const Kink_bound bound;
  return bound;
}

// Whether the angle between two ends is larger than the bound; empty when it is zero. \pre both have a length
template <class Left_end, class Right_end>
std::optional<bool> exceeds(const Left_end& a, const Right_end& b, const Kink_bound& bound) {
  typedef typename Left_end::Traits Traits;
  if constexpr (is_double<typename Traits::FT>) {
    // Differences, products and sums are rounded by 2^-52 in every rounding mode, once each.
    const Leg_products<double> r(a.template vector<double>(), b.template vector<double>());
    const double error = 0x1p-49 * r.size;
    if (0x1p-800 < r.size && r.size < 0x1p800) {
      if (error < std::abs(r.cross))
        if (const std::optional<bool> answer = bound.is_exceeded(r.cross, r.dot, 2 * error)) return answer;
      if (is_g1_join(a.curve(), b.curve())) return std::nullopt;
    }
  }
  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  const Leg_products<Field> p(a.template vector<Field>(), b.template vector<Field>());
  if (p.cross == Field(0) && Field(0) < p.dot) return std::nullopt;
  return bound.is_exceeded(p.cross, p.dot);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what the join between the end of `left` and the start of `right` looks like; empty when the ends meet and one of the curves has
/// no length, hence no direction. The bound is 5 degrees unless another one is given.
///
/// It is decided exactly on the control points as given, with every kernel, and about the curves as they are drawn:
/// - A curve whose control points lie on its chord, in order, is that line, also where handles are retracted.
/// - Of other curves with a retracted handle, a first side that is zero, the first side that is not zero is the direction in which the curve
///   leaves the node. Such a join is `g1` at most, because the curvature at the node is infinite or not given by the second differences.
///
/// Where no handle is retracted `g1` and `g2` are the answers of `is_g1_join()` and `is_g2_join()`. \f$ O(1) \f$ then, otherwise
/// \f$ O(m) \f$ for the degree `m`
/// \throws Error `not_finite` for an infinite or undefined coordinate that it reads
template <class Traits, int Left, int Right>
std::optional<Join_grade> join_grade(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right,
                                     const Kink_bound& bound = internal::usual_kink_bound()) {
  typedef internal::Image_end<Traits, Left, Curve_end::end> Left_end;
  typedef internal::Image_end<Traits, Right, Curve_end::start> Right_end;
  static_assert(dimension_v<Traits> == 2, "grades are those of curves in the plane");
  const Left_end a(left);
  const Right_end b(right);
  if (!is_c_join<0>(left, right)) {
    a.check_node();
    b.check_node();
    return Join_grade::gap;
  }
  if (!a.has_length() || !b.has_length()) return std::nullopt;
  if (const std::optional<bool> corner = internal::exceeds(a, b, bound))
    return *corner ? Join_grade::corner : Join_grade::kink;
  const bool left_line = a.is_retracted() && a.is_line(), right_line = b.is_retracted() && b.is_line();
  // A zero first leg is never that of a G2 join.
  const bool curvature_agrees = left_line && right_line ? true
                                : left_line             ? is_g2_join(a.curve(), right)
                                : right_line            ? is_g2_join(left, b.curve())
                                                        : is_g2_join(left, right);
  return curvature_agrees ? Join_grade::g2 : Join_grade::g1;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_GRADE_H
