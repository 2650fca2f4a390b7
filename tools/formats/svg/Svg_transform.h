// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_TRANSFORM_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_TRANSFORM_H

#include "formats/svg/Svg_scanner.h"
#include "formats/svg/svg_size.h"
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// An affine map of the plane, \f$ (x, y) \mapsto (ax + cy + e, bx + dy + f) \f$, as in SVG's
/// `matrix(a b c d e f)`.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> class Svg_transform {
public:
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

private:
  std::array<FT, 6> m_{{FT(1), FT(0), FT(0), FT(1), FT(0), FT(0)}};

public:
  /// Makes the identity.
  Svg_transform() = default;

  /// Makes the map of the numbers `a, b, c, d, e, f`.
  /// \throws Error `not_finite` for a number that is not finite
  explicit Svg_transform(const std::array<FT, 6>& matrix) : m_(matrix) {
    for (const FT& x : m_) check_svg_finite(x, "Svg_transform");
  }

  /// Returns the numbers `a, b, c, d, e, f`.
  const std::array<FT, 6>& matrix() const { return m_; }

  /// Returns \f$ ad - bc \f$; the map is invertible unless this is zero.
  FT determinant() const { return FT(m_[0] * m_[3] - m_[1] * m_[2]); }

  /// Returns the inverse map. \pre the map is invertible
  Svg_transform inverse() const {
    const FT d = determinant();
    const std::array<FT, 4> linear{FT(m_[3] / d), FT(FT(0) - m_[1] / d), FT(FT(0) - m_[2] / d), FT(m_[0] / d)};
    return Svg_transform({linear[0], linear[1], linear[2], linear[3], FT(FT(0) - linear[0] * m_[4] - linear[2] * m_[5]),
                          FT(FT(0) - linear[1] * m_[4] - linear[3] * m_[5])});
  }

  /// Returns the image of a point.
  Point operator()(const Point& p) const {
    const Geometric_continuity::Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(p);
    Geometric_continuity::Coordinates<Traits> y(2);
    y[0] = FT(m_[0] * x[0] + m_[2] * x[1] + m_[4]);
    y[1] = FT(m_[1] * x[0] + m_[3] * x[1] + m_[5]);
    return Geometric_continuity::to_point<Traits>(y);
  }

  /// Returns the map that applies first `inner`, then `outer`. In an exact field it is exact as
  /// long as no numerator or denominator has more than `max_svg_transform_bits` bits; otherwise all
  /// six numbers are rounded to `double`, so that products of many maps stay short. No order of
  /// continuity depends on that, see `parse_svg_transform()`.
  /// \throws Error `not_finite` when the product is outside the range of floating-point numbers;
  ///   `work_limit` when its numbers are too long, and rounded ones would be infinite or make an
  ///   invertible map singular or vice versa
  friend Svg_transform operator*(const Svg_transform& outer, const Svg_transform& inner) {
    const std::array<FT, 6>&m = outer.m_, &n = inner.m_;
    return Svg_transform({FT(m[0] * n[0] + m[2] * n[1]), FT(m[1] * n[0] + m[3] * n[1]), FT(m[0] * n[2] + m[2] * n[3]),
                          FT(m[1] * n[2] + m[3] * n[3]), FT(m[0] * n[4] + m[2] * n[5] + m[4]),
                          FT(m[1] * n[4] + m[3] * n[5] + m[5])})
        .shortened();
  }

private:
  Svg_transform shortened() const {
    bool is_short = true;
    for (const FT& x : m_) is_short = is_short && has_short_parts<max_svg_transform_bits>(x);
    if (is_short) return *this;
    std::array<FT, 6> rounded;
    bool faithful = true;
    for (std::size_t i = 0; i < 6; ++i) {
      const double x = CGAL::to_double(m_[i]);
      faithful = faithful && std::isfinite(x);
      rounded[i] = std::isfinite(x) ? FT(x) : FT(0);
    }
    const Svg_transform result(rounded);
    faithful = faithful && (result.determinant() == FT(0)) == (determinant() == FT(0));
    if (!faithful)
      throw Error(Error_code::work_limit,
                  "Svg_transform: numbers of more than " + std::to_string(max_svg_transform_bits) + " bits");
    return result;
  }
};

// The rational rotation next to the given one: cos = (1 - t^2)/(1 + t^2), sin = 2t/(1 + t^2) with
// t = tan(angle/2) rounded to double, after the quarter turns, which are exact.
template <class Traits> Svg_transform<Traits> svg_rotation(const typename Traits::FT& degrees) {
  typedef typename Traits::FT FT;
  const Quarter_turns<FT> turns(degrees);
  const FT t = turns.rest == FT(0) ? FT(0) : FT(std::tan(CGAL::to_double(turns.rest) * (std::acos(-1.0) / 360)));
  const FT length = FT(FT(1) + t * t);
  FT cosine = FT((FT(1) - t * t) / length), sine = FT((t + t) / length);
  for (int i = 0; i < turns.count; ++i) {
    const FT old = cosine;
    cosine = FT(FT(0) - sine);
    sine = old;
  }
  return Svg_transform<Traits>({cosine, sine, FT(FT(0) - sine), cosine, FT(0), FT(0)});
}

// The product of a list of transforms, of which the last one is applied first. Consecutive
// rotations about one centre are one rotation, by the sum of the angles: the numbers do not grow
// with the list.
template <class Traits> class Svg_transform_product {
  typedef typename Traits::FT FT;
  typedef Svg_transform<Traits> Transform;

  struct Rotation {
    FT degrees, x, y; // around (x, y)
  };

  Transform result_;                 // of what was added before the rotation
  std::optional<Rotation> rotation_; // that was added last

public:
  void multiply(const Transform& map) {
    apply_rotation();
    result_ = result_ * map;
  }

  void translate(const FT& x, const FT& y) { multiply(translation(x, y)); }
  void scale(const FT& x, const FT& y) { multiply(Transform({x, FT(0), FT(0), y, FT(0), FT(0)})); }

  // Throws Error `malformed_input` for a right angle.
  void skew(const FT& x_degrees, const FT& y_degrees) {
    multiply(Transform({FT(1), tangent(y_degrees), tangent(x_degrees), FT(1), FT(0), FT(0)}));
  }

  void rotate(const FT& degrees, const FT& x, const FT& y) {
    const FT angle = less_than_a_turn(degrees);
    if (rotation_ && rotation_->x == x && rotation_->y == y) {
      rotation_->degrees = less_than_a_turn(FT(rotation_->degrees + angle));
      return;
    }
    apply_rotation();
    rotation_ = Rotation{angle, x, y};
  }

  Transform operator()() {
    apply_rotation();
    return result_;
  }

  static Transform translation(const FT& x, const FT& y) { return Transform({FT(1), FT(0), FT(0), FT(1), x, y}); }

private:
  // The tangent is exact at 0 and 45 degrees, otherwise rounded to double.
  static FT tangent(const FT& degrees) {
    const Quarter_turns<FT> turns(degrees);
    if (turns.rest == FT(0) && turns.count % 2 != 0)
      throw Error(Error_code::malformed_input, "a skew by a right angle");
    FT t = turns.rest == FT(0)     ? FT(0)
           : turns.rest == FT(45)  ? FT(1)
           : turns.rest == FT(-45) ? FT(-1)
                                   : FT(std::tan(CGAL::to_double(turns.rest) * (std::acos(-1.0) / 180)));
    return turns.count % 2 == 0 ? t : FT(FT(-1) / t);
  }

  void apply_rotation() {
    if (!rotation_) return;
    const Rotation r = *rotation_;
    rotation_.reset();
    const Transform turn = svg_rotation<Traits>(r.degrees);
    if (r.x == FT(0) && r.y == FT(0))
      result_ = result_ * turn;
    else
      result_ = result_ * (translation(r.x, r.y) * turn * translation(FT(FT(0) - r.x), FT(FT(0) - r.y)));
  }

  static FT less_than_a_turn(const FT& degrees) {
    const Quarter_turns<FT> turns(degrees);
    return FT(FT(90 * turns.count) + turns.rest);
  }
};

// Calls action() and refuses, at what the scanner has read last, a product of transforms that is
// not possible.
template <class Action> void refusing_at(const Svg_scanner& scanner, Action action) {
  try {
    action();
  } catch (const Error& error) {
    if (error.code() == Error_code::not_finite) throw;
    scanner.refuse(error.code() == Error_code::malformed_input ? svg_reason(error) : error.what());
  }
}

// Reads a list of transforms.
template <class Traits> class Svg_transform_reader {
  typedef typename Traits::FT FT;
  typedef Svg_transform<Traits> Transform;

  Svg_scanner scanner_;
  Svg_transform_product<Traits> product_;

public:
  Svg_transform_reader(std::string_view text, const std::string& name) : scanner_(text, name) {}

  Transform operator()() {
    scanner_.skip_space();
    while (!scanner_.at_end()) {
      read_transform();
      scanner_.skip_separator();
    }
    scanner_.refuse_comma();
    Transform result;
    refusing_at(scanner_, [&] { result = product_(); });
    return result;
  }

private:
  void read_transform() {
    const std::string name(scanner_.word());
    if (name != "matrix" && name != "translate" && name != "scale" && name != "rotate" && name != "skewX" &&
        name != "skewY")
      scanner_.refuse(name.empty() ? scanner_.found() + " where a transform is expected"
                                   : "'" + name + "' is not a transform");
    const bool turns = name == "rotate" || name == "skewX" || name == "skewY";
    scanner_.expect('(');
    std::vector<FT> x(1, turns ? scanner_.template angle<FT>() : scanner_.template number<FT>());
    while (x.size() < 6 && scanner_.at_number()) x.push_back(scanner_.template number<FT>());
    scanner_.refuse_comma();
    scanner_.expect(')');
    refusing_at(scanner_, [&] { add(name, x); });
  }

  void add(const std::string& name, const std::vector<FT>& x) {
    const std::size_t n = x.size();
    if (name == "matrix" && n == 6) return product_.multiply(Transform({x[0], x[1], x[2], x[3], x[4], x[5]}));
    if (name == "translate" && n <= 2) return product_.translate(x[0], n == 2 ? x[1] : FT(0));
    if (name == "scale" && n <= 2) return product_.scale(x[0], n == 2 ? x[1] : x[0]);
    if (name == "rotate" && n == 1) return product_.rotate(x[0], FT(0), FT(0));
    if (name == "rotate" && n == 3) return product_.rotate(x[0], x[1], x[2]);
    if (name == "skewX" && n == 1) return product_.skew(x[0], FT(0));
    if (name == "skewY" && n == 1) return product_.skew(FT(0), x[0]);
    throw Error(Error_code::malformed_input, name + " with " + std::to_string(n) + (n == 1 ? " number" : " numbers"));
  }
};

/// Returns the map of a list of transforms, the attribute `transform`: `matrix`, `translate`,
/// `scale`, `rotate`, `skewX`, `skewY`, with the numbers of `parse_number()`. The last one is
/// applied first.
///
/// In an exact field the map is exact for all but angles: a rotation by other than a multiple of 90
/// degrees is replaced by a rotation with rational cosine and sine, and a skew by other than a
/// multiple of 45 degrees by one with a rational tangent, at an angle that differs by the error of
/// `std::tan()` in `double`. No order of continuity depends on that: C, G and F orders are the same
/// before and after any invertible affine map, and the rotation does not change any angle or
/// curvature.
///
/// Consecutive rotations about one centre are one rotation, by the sum of the angles. Products
/// whose numbers are longer than `max_svg_transform_bits` are rounded to `double`: not even then
/// does an order of continuity change.
///
/// \throws Error `malformed_input` with a text `name, character N: reason`, also for products that
///   cannot be rounded; `not_finite` when the product of the transforms is outside the range of
///   floating-point numbers
template <class Traits>
Svg_transform<Traits> parse_svg_transform(std::string_view text, const std::string& name = "transform") {
  return Svg_transform_reader<Traits>(text, name)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_TRANSFORM_H
