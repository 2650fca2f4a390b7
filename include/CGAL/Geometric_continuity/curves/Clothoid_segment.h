// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_CLOTHOID_SEGMENT_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_CLOTHOID_SEGMENT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/internal/alignment_numbers.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Clothoid_segment.h
/// The pieces of roads and rails: lines, arcs and clothoids, transitions whose curvature is a
/// polynomial, a cosine or a sine of the length, and parametric cubics. All data are exact rational
/// numbers. Headings and curvatures at the ends are exact; most positions are transcendental, and
/// enclosed to any precision. With \f$ \theta' = k \f$ a piece of length \f$ L \f$ ends at
/// \f[ p + e^{i \theta(0)} L \int_0^1 e^{i (\theta(w) - \theta(0))} \, dw. \f]

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

struct Alignment_parts;

} // namespace internal

/// \ingroup PkgGeometricContinuityAlignments
/// The direction of a curve in the plane: `angle` + atan2(`y`, `x`), with rational numbers. Of two
/// rational angles none is the other plus a multiple of \f$ 2 \pi \f$.
class Heading {
  internal::Direction value_;

  friend class Clothoid_segment;
  friend class Enclosed_point;
  friend class Parametric_cubic;
  friend struct internal::Alignment_parts;

public:
  /// The number type.
  typedef Exact_field<double>::type FT;

  /// Constructs the direction of so many radians, counter-clockwise from the x-axis.
  Heading(const FT& angle = FT(0)) { value_.angle = angle; }
  /// Constructs the direction of `angle` radians, turned further by the angle of the vector (x, y).
  /// \throws Error `zero_direction`
  Heading(const FT& angle, const FT& x, const FT& y) {
    if (x == 0 && y == 0) throw Error(Error_code::zero_direction, "Heading");
    value_ = {angle, x, y};
  }

  /// Returns the rational part, in radians.
  const FT& angle() const { return value_.angle; }
  /// Returns the vector whose angle is added, (1, 0) if there is none.
  std::pair<FT, FT> vector() const { return {value_.x, value_.y}; }

  /// Returns whether the whole direction is known exactly. It is not at the end of a graph that is
  /// given by its arc length, where a third part is added which is enclosed.
  bool is_exact() const { return !value_.end; }

  /// Returns the direction turned further by the angle of the vector (x, y).
  /// \throws Error `zero_direction`
  Heading turned(const FT& x, const FT& y) const {
    if (x == 0 && y == 0) throw Error(Error_code::zero_direction, "Heading::turned");
    Heading h = *this;
    h.value_.turn(x, y);
    return h;
  }
  /// Returns the opposite direction.
  Heading reversed() const { return turned(FT(-1), FT(0)); }

  /// Returns an enclosure of the angle in radians, where the angle of the vector is in
  /// \f$ (-\pi, \pi] \f$.
  Enclosure enclosure() const {
    if (value_.y == 0 && value_.x > 0 && !value_.end) return Geometric_continuity::enclosure(value_.angle);
    Enclosure result{};
    internal::with_more_and_more_bits("Heading::enclosure", [&](const auto& a) {
      typedef typename std::decay_t<decltype(a)>::Number Number;
      const auto v = internal::vector_part(a, value_);
      const Number sum = a(value_.angle) + internal::angle_of_vector(a, v.re, v.im);
      result = a.enclosure(sum);
      return internal::is_narrow(result);
    });
    return result;
  }
};

/// \ingroup PkgGeometricContinuityAlignments
/// The curvature at an end of a curve in the plane, positive to the left: rational, or the root of
/// a rational number with a sign.
class End_curvature {
  internal::Curvature value_;

  friend class Parametric_cubic;
  friend struct internal::Alignment_parts;

public:
  /// The number type.
  typedef Exact_field<double>::type FT;

  /// Constructs a rational curvature.
  End_curvature(const FT& k = FT(0)) : value_{k < 0 ? -1 : k > 0 ? 1 : 0, FT(k * k), k, nullptr} {}
  /// Constructs \f$ sign \sqrt{square} \f$. \pre `sign` is -1, 0 or 1, and 0 exactly for 0
  End_curvature(int sign, const FT& square) : value_{sign, square, rational_square_root(square), nullptr} {
    if (sign < 0 && value_.rational) value_.rational = FT(-*value_.rational);
  }

  /// Returns the sign and the square. \pre `is_exact()`
  std::pair<int, FT> sign_and_square() const { return {value_.sign, value_.square}; }
  /// Returns the curvature when it is rational.
  const std::optional<FT>& rational() const { return value_.rational; }
  /// Returns whether the sign and the square are known exactly. They are not at the end of a graph
  /// that is given by its arc length.
  bool is_exact() const { return !value_.end; }
  /// Returns the curvature for the other direction of travel.
  End_curvature reversed() const {
    End_curvature k = *this;
    k.value_.sign = -k.value_.sign;
    if (k.value_.rational) k.value_.rational = FT(-*k.value_.rational);
    return k;
  }

  /// Decides whether both are proved to be the same number.
  friend bool operator==(const End_curvature& x, const End_curvature& y) {
    return x.is_exact() && y.is_exact() && x.value_.sign == y.value_.sign && x.value_.square == y.value_.square;
  }
  /// Decides whether that is not proved.
  friend bool operator!=(const End_curvature& x, const End_curvature& y) { return !(x == y); }

  /// Returns an enclosure.
  Enclosure enclosure() const {
    if (value_.rational && is_exact()) return Geometric_continuity::enclosure(*value_.rational);
    Enclosure result{};
    internal::with_more_and_more_bits("End_curvature::enclosure", [&](const auto& a) {
      result = a.enclosure(internal::curvature_number(a, value_));
      return internal::is_narrow(result);
    });
    return result;
  }
};

/// \ingroup PkgGeometricContinuityAlignments
/// A point in the plane that can be enclosed as narrowly as is wanted.
class Enclosed_point {
  internal::Point_sum sum_;

  friend class Clothoid_segment;
  friend class Parametric_cubic;
  friend struct internal::Alignment_parts;

public:
  /// The number type.
  typedef Exact_field<double>::type FT;

  /// Constructs a point with rational coordinates.
  Enclosed_point(const FT& x = FT(0), const FT& y = FT(0)) {
    sum_.x = x;
    sum_.y = y;
  }

  /// Returns the point that is moved by (u, v) cos `roll` in the frame of `heading`: u forwards, v
  /// to the left.
  Enclosed_point moved(const Heading& heading, const FT& u, const FT& v, const FT& roll = FT(0)) const {
    Enclosed_point p = *this;
    p.sum_.add({u, v, roll, heading.value_});
    return p;
  }

  /// Returns the point whose coordinates are the sums of those of both.
  friend Enclosed_point operator+(const Enclosed_point& p, const Enclosed_point& q) {
    Enclosed_point sum = p;
    sum.sum_.add(q.sum_);
    return sum;
  }

  /// Returns the coordinates when the way to them shows that they are rational.
  std::optional<std::pair<FT, FT>> rational() const {
    if (!sum_.is_rational()) return std::nullopt;
    return std::pair<FT, FT>(sum_.x, sum_.y);
  }

  /// Returns enclosures of both coordinates, the closest ones that floating-point numbers allow but
  /// for a unit or two.
  /// \throws Error `parameter_outside_domain` when a piece turns by more than 20000 radians,
  ///   `work_limit`
  std::array<Enclosure, 2> enclosure() const {
    if (sum_.is_rational()) return {Geometric_continuity::enclosure(sum_.x), Geometric_continuity::enclosure(sum_.y)};
    const internal::Work_guard work("Enclosed_point::enclosure");
    const internal::Ball_arithmetic a(160);
    internal::Complex_number<internal::Fixed_ball> z{a(sum_.x), a(sum_.y)};
    sum_.add_to(a, 1, z);
    return {a.enclosure(z.re), a.enclosure(z.im)};
  }
};

/// \ingroup PkgGeometricContinuityAlignments
/// An end of a piece of a road or a rail, in the direction of travel.
struct Alignment_end {
  Enclosed_point point; ///< the position
  Heading heading;      ///< the direction
  /// The curvature. Empty where it is not defined, at a stop of a parametric cubic.
  std::optional<End_curvature> curvature = End_curvature();

  /// Returns the end for the other direction of travel.
  Alignment_end reversed() const {
    std::optional<End_curvature> k;
    if (curvature) k = curvature->reversed();
    return {point, heading.reversed(), k};
  }
};

/// \ingroup PkgGeometricContinuityAlignments
/// A curvature as a function of the part \f$ w \in [0, 1] \f$ of the length:
/// \f$ \sum p_j w^j + c \cos \pi w + (s + \frac{r}{2 \pi}) \sin 2 \pi w \f$.
struct Curvature_law {
  /// The number type.
  typedef Exact_field<double>::type FT;

  std::vector<FT> polynomial; ///< the coefficients \f$ p_j \f$
  FT cosine = 0;              ///< \f$ c \f$
  FT sine = 0;                ///< \f$ s \f$
  FT sine_over_turn = 0;      ///< \f$ r \f$

  /// Returns the law that leads from one curvature to another: \f$ k_0 + (k_1 - k_0) f(w) \f$, with
  /// `shape` for f, where f(0) = 0 and f(1) = 1.
  static Curvature_law between(const FT& k0, const FT& k1, Curvature_law shape) {
    const FT jump(k1 - k0);
    for (FT* x : {&shape.cosine, &shape.sine, &shape.sine_over_turn}) *x = FT(*x * jump);
    for (FT& x : shape.polynomial) x = FT(x * jump);
    if (shape.polynomial.empty()) shape.polynomial.emplace_back(0);
    shape.polynomial[0] = FT(shape.polynomial[0] + k0);
    return shape;
  }
  /// \f$ f = w \f$: a clothoid.
  static Curvature_law linear() { return {{FT(0), FT(1)}}; }
  /// \f$ f = 3 w^2 - 2 w^3 \f$: the curve of Bloss.
  static Curvature_law bloss() { return {{FT(0), FT(0), FT(3), FT(-2)}}; }
  /// \f$ f = (1 - \cos \pi w) / 2 \f$
  static Curvature_law cosine_curve() { return {{FT(FT(1) / FT(2))}, FT(FT(-1) / FT(2))}; }
  /// \f$ f = w - \sin(2 \pi w) / (2 \pi) \f$: the curve of Klein.
  static Curvature_law sine_curve() { return {{FT(0), FT(1)}, FT(0), FT(0), FT(-1)}; }
  /// \f$ f = 35 w^4 - 84 w^5 + 70 w^6 - 20 w^7 \f$: the Viennese bend, of a plane without cant.
  static Curvature_law viennese_bend() { return {{FT(0), FT(0), FT(0), FT(0), FT(35), FT(-84), FT(70), FT(-20)}}; }

  /// Returns the curvature at the start.
  FT at_start() const { return FT((polynomial.empty() ? FT(0) : polynomial[0]) + cosine); }
  /// Returns the curvature at the end.
  FT at_end() const {
    FT sum(-cosine);
    for (const FT& p : polynomial) sum = FT(sum + p);
    return sum;
  }
  /// Returns the mean, by which a heading grows for each unit of length.
  FT mean() const {
    FT sum(0);
    for (std::size_t j = 0; j < polynomial.size(); ++j) sum = FT(sum + polynomial[j] / FT(static_cast<int>(j + 1)));
    return sum;
  }
};

/// \ingroup PkgGeometricContinuityAlignments
/// A line, an arc, a clothoid, or another curve with a curvature that is given by its length.
/// Heading and curvature at its ends are exact.
class Clothoid_segment {
public:
  /// The number type.
  typedef Exact_field<double>::type FT;

private:
  FT x_, y_, length_;
  Heading heading_;
  Curvature_law curvature_;

public:
  /// Constructs the segment from the start (x, y), the heading there, the curvatures at both ends,
  /// between which it is linear, and the length. Equal curvatures make an arc, or a line.
  /// \throws Error `parameter_outside_domain` for a negative length
  Clothoid_segment(const FT& x, const FT& y, const Heading& heading, const FT& start_curvature, const FT& end_curvature,
                   const FT& length)
      : Clothoid_segment(x, y, heading,
                         start_curvature == end_curvature
                             ? Curvature_law{{start_curvature}}
                             : Curvature_law{{start_curvature, FT(end_curvature - start_curvature)}},
                         length) {}

  /// Constructs the segment with a curvature of another kind.
  /// \throws Error `parameter_outside_domain` for a negative length
  Clothoid_segment(const FT& x, const FT& y, const Heading& heading, Curvature_law curvature, const FT& length)
      : x_(x), y_(y), length_(length), heading_(heading), curvature_(std::move(curvature)) {
    if (length < 0) throw Error(Error_code::parameter_outside_domain, "Clothoid_segment: a negative length");
  }

  /// Returns the length.
  const FT& length() const { return length_; }
  /// Returns the curvature as a function of the part of the length.
  const Curvature_law& curvature() const { return curvature_; }

  /// Returns the exact curvature at the start.
  FT start_curvature() const { return curvature_.at_start(); }
  /// Returns the exact curvature at the end; that at the start when the length is 0.
  FT end_curvature() const { return length_ == 0 ? curvature_.at_start() : curvature_.at_end(); }
  /// Returns the exact heading at the start.
  const Heading& start_heading() const { return heading_; }
  /// Returns the exact heading at the end.
  Heading end_heading() const {
    const std::pair<FT, FT> v = heading_.vector();
    return Heading(FT(heading_.angle() + curvature_.mean() * length_), v.first, v.second);
  }
  /// Returns the start.
  Enclosed_point start_point() const { return Enclosed_point(x_, y_); }
  /// Returns the end, which is enclosed when it is asked for.
  Enclosed_point end_point() const {
    internal::Angle_rate rate{curvature_.polynomial, curvature_.cosine, curvature_.sine, curvature_.sine_over_turn};
    if (length_ == 0 || rate.is_zero()) return start_point().moved(heading_, length_, FT(0));
    for (FT* x : {&rate.cosine, &rate.sine, &rate.sine_over_turn}) *x = FT(*x * length_);
    for (FT& x : rate.polynomial) x = FT(x * length_);
    Enclosed_point p = start_point();
    p.sum_.ways.push_back({length_, heading_.value_, std::move(rate)});
    return p;
  }

  /// Returns the start with its direction and curvature.
  Alignment_end start() const { return {start_point(), heading_, End_curvature(start_curvature())}; }
  /// Returns the end with its direction and curvature.
  Alignment_end end() const { return {end_point(), end_heading(), End_curvature(end_curvature())}; }
};

/// \ingroup PkgGeometricContinuityAlignments
/// A cubic \f$ (u(t), v(t)) \f$ in the frame of a point and a heading, for \f$ t \in [0, T] \f$.
class Parametric_cubic {
public:
  /// The number type.
  typedef Exact_field<double>::type FT;
  /// The coefficients of 1, t, t^2 and t^3.
  typedef std::array<FT, 4> Coefficients;

private:
  FT x_, y_, range_;
  Heading heading_;
  Coefficients u_, v_;
  bool by_length_ = false;

public:
  /// Constructs the cubic with the range [0, T].
  /// \throws Error `parameter_outside_domain` for a negative T, `zero_tangent` when u and v are
  ///   constant
  Parametric_cubic(const FT& x, const FT& y, const Heading& heading, const Coefficients& u, const Coefficients& v,
                   const FT& range)
      : x_(x), y_(y), range_(range), heading_(heading), u_(u), v_(v) {
    if (range < 0) throw Error(Error_code::parameter_outside_domain, "Parametric_cubic: a negative range");
    if (u[1] == 0 && u[2] == 0 && u[3] == 0 && v[1] == 0 && v[2] == 0 && v[3] == 0)
      throw Error(Error_code::zero_tangent, "Parametric_cubic: all points are equal");
  }
  /// Returns the graph (t, v(t)) that starts at t = 0 and has an arc length.
  /// \throws Error `parameter_outside_domain` for a negative length
  static Parametric_cubic graph(const FT& x, const FT& y, const Heading& heading, const Coefficients& v,
                                const FT& length) {
    Parametric_cubic c(x, y, heading, {FT(0), FT(1), FT(0), FT(0)}, v, length);
    c.by_length_ = true;
    if (v[2] == 0 && v[3] == 0) // a line, perhaps of which the end is rational
      if (const std::optional<FT> speed = rational_square_root(FT(1 + v[1] * v[1]))) {
        c.range_ = FT(length / *speed);
        c.by_length_ = false;
      }
    return c;
  }

  /// Returns the start with its direction and curvature.
  Alignment_end start() const { return end_at(FT(0), false); }
  /// Returns the end with its direction and curvature.
  Alignment_end end() const {
    if (!by_length_ || range_ == 0) return end_at(range_, range_ != 0);
    const auto end = std::make_shared<const internal::Graph_end>(internal::Graph_end{v_, range_});
    Alignment_end result{Enclosed_point(x_, y_), heading_, End_curvature()};
    result.point.sum_.graphs.emplace_back(heading_.value_, end);
    result.heading.value_.end = end;
    if (v_[2] == 0 && v_[3] == 0) { // a line
      result.heading = heading_.turned(FT(1), v_[1]);
      return result;
    }
    result.curvature->value_ = {1, FT(0), std::nullopt, end};
    return result;
  }

  /// Returns an enclosure of the arc length.
  /// \throws Error `work_limit`
  Enclosure length() const {
    Enclosure result{};
    enclose_length_error(FT(0), [&](const Enclosure& x, const auto&, const auto&) {
      result = x;
      return x.upper - x.lower <= 1e-9;
    });
    return result;
  }
  /// Encloses the difference of the arc length and a declared one, and decides whether it is at
  /// most `tolerance`. \throws Error `work_limit`
  std::pair<Enclosure, Verdict> length_error(const FT& declared, const FT& tolerance) const {
    std::pair<Enclosure, Verdict> result{{}, Verdict::undecided};
    enclose_length_error(declared, [&](const Enclosure& x, const auto& a, const auto& number) {
      result = {x, a.at_most(number, tolerance)};
      return result.second != Verdict::undecided && x.upper - x.lower <= 1e-9;
    });
    return result;
  }

  /// Returns whether the speed at an end is below \f$ 10^{-6} \f$ of the mean one for a declared
  /// length: what is exact there may be noise of the last digits.
  bool is_near_stop(const FT& declared_length) const {
    if (by_length_ || range_ == 0) return false;
    const FT slow = FT(declared_length / range_ / FT(1000000)), square = FT(slow * slow);
    for (const FT& t : {FT(0), range_}) {
      const FT du = internal::first_derivative(u_, t), dv = internal::first_derivative(v_, t);
      if (FT(du * du + dv * dv) < square) return true;
    }
    return false;
  }

private:
  template <class F> void enclose_length_error(const FT& declared, F f) const {
    internal::with_more_and_more_bits("Parametric_cubic: arc length", [&](const auto& a) {
      typedef std::decay_t<decltype(a)> Arithmetic;
      typedef typename Arithmetic::Number Number;
      const Number length = by_length_ ? a(range_) : internal::Cubic_length<Arithmetic>(a, u_, v_)(FT(0), range_);
      const Number error = a.absolute_value(length - a(declared));
      return f(a.enclosure(error), a, error);
    });
  }

  // The first derivative that is not zero gives the tangent; before an end the second one leads
  // backwards.
  Alignment_end end_at(const FT& t, bool is_end) const {
    FT du = internal::first_derivative(u_, t), dv = internal::first_derivative(v_, t);
    const FT ddu = internal::second_derivative(u_, t), ddv = internal::second_derivative(v_, t);
    std::optional<End_curvature> curvature;
    if (du != 0 || dv != 0) {
      const FT cross = FT(du * ddv - dv * ddu), speed = FT(du * du + dv * dv);
      curvature = End_curvature(cross < 0 ? -1 : cross > 0 ? 1 : 0, FT(cross * cross / (speed * speed * speed)));
    } else if (ddu != 0 || ddv != 0) {
      du = is_end ? FT(-ddu) : ddu;
      dv = is_end ? FT(-ddv) : ddv;
    } else {
      du = u_[3];
      dv = v_[3];
    }
    return {Enclosed_point(x_, y_).moved(heading_, internal::cubic_value(u_, t), internal::cubic_value(v_, t)),
            heading_.turned(du, dv), curvature};
  }
};

namespace internal {

// The parts, for those who decide about joins.
struct Alignment_parts {
  static const Direction& of(const Heading& x) { return x.value_; }
  static const Curvature& of(const End_curvature& x) { return x.value_; }
  static const Point_sum& of(const Enclosed_point& x) { return x.sum_; }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_CLOTHOID_SEGMENT_H
