// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_PATH_SEGMENT_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_PATH_SEGMENT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/Rotated_ellipse.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// The description of an arc of an ellipse besides its start and end, as the command A of SVG's
/// path data does.
template <class FT> struct Elliptical_arc_parameters {
  FT rx;               ///< the first radius, not zero; its sign does not matter
  FT ry;               ///< the second radius, not zero; its sign does not matter
  FT rotation = FT(0); ///< the angle from the x-axis to the first radius, in degrees
  bool large = false;  ///< more than half of the ellipse
  bool sweep = false;  ///< with growing angle: it turns from the x-axis to the y-axis
};

namespace internal {
template <class Traits> class Enclosed_arc;
}

/// \ingroup PkgGeometricContinuityCurves
/// An arc of an ellipse as SVG describes it, by its ends, with exact derivatives at the ends with
/// respect to the eccentric angle. All orders of continuity but C are those of the arc in any
/// parametrisation.
///
/// Let `h` be half the chord, from the middle to the start, and `k` its image under the quarter
/// turn of the ellipse, \f$ k = (-\frac{r_x}{r_y} h_y, \frac{r_y}{r_x} h_x) \f$ without rotation.
/// With \f$ \lambda = (h_x/r_x)^2 + (h_y/r_y)^2 \f$ and \f$ D = \frac{1-\lambda}{\lambda} \f$ the
/// centre is \f$ m - s k \f$, where \f$ s = \sqrt D \f$ when the two flags differ and
/// \f$ s = -\sqrt D \f$ otherwise. Radii that are too small, \f$ \lambda > 1 \f$, are enlarged to
/// \f$ \lambda = 1 \f$: then \f$ D = 0 \f$, and the ratio of the radii remains. So everything is
/// rational when `D` is a square, and otherwise it lies in the field extended by \f$ \sqrt D \f$. A
/// rotation matters when the radii differ, and then `k` and \f$ \lambda \f$ are rational for
/// multiples of 45 degrees only. With another angle they are enclosed, see `continuity()` of paths;
/// in floating-point numbers they are rounded.
///
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits_> class Elliptical_arc {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  static constexpr int N = 2;

private:
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  Coordinates start_, end_, k_{2};
  FT radicand_ = FT(0);    // D
  std::optional<FT> root_; // of D, when it is rational
  bool same_flags_, sweep_;
  std::vector<internal::Rotated_ellipse<FT>>
      rotated_; // instead of k and D, where these are not rational: one, which is long

  friend class internal::Enclosed_arc<Traits>;

public:
  /// Makes the arc from `start` to `end`.
  /// \throws Error `zero_direction` when the ends coincide; `parameter_outside_domain` for a zero
  ///   radius, for a rotation by more than 10^9 degrees, and when the sizes differ so much that
  ///   \f$ D \f$ is no finite floating-point number; `not_finite` for a number that is not finite
  Elliptical_arc(const Point& start, const Point& end, const Elliptical_arc_parameters<FT>& parameters)
      : start_(Geometric_continuity::coordinates<Traits>(start)), end_(Geometric_continuity::coordinates<Traits>(end)),
        same_flags_(parameters.large == parameters.sweep), sweep_(parameters.sweep) {
    for (const FT& x : {start_[0], start_[1], end_[0], end_[1], parameters.rx, parameters.ry, parameters.rotation})
      internal::check_finite(x, "Elliptical_arc");
    if (start_ == end_) throw Error(Error_code::zero_direction, "Elliptical_arc: the ends coincide");
    FT rx = absolute(parameters.rx), ry = absolute(parameters.ry);
    if (rx == FT(0) || ry == FT(0))
      throw Error(Error_code::parameter_outside_domain, "Elliptical_arc: a radius is zero");
    const Coordinates h = half_chord();
    const Quarter_turns<FT> turns(rx == ry ? FT(0) : parameters.rotation);
    if (turns.rest != FT(0)) {
      internal::Rotated_ellipse<FT> ellipse(rx, ry, parameters.rotation, {h[0], h[1]});
      if (ellipse.is_rational() || std::is_floating_point_v<FT>)
        set_rounded(ellipse);
      else
        rotated_.push_back(std::move(ellipse));
    } else {
      if (turns.count % 2 != 0) std::swap(rx, ry);
      const FT x = FT(h[0] / rx), y = FT(h[1] / ry);
      k_[0] = FT(FT(0) - rx * y);
      k_[1] = FT(ry * x);
      set_radicand(FT(x * x + y * y));
    }
  }

  /// Returns the point where the arc starts.
  Point start() const { return Geometric_continuity::to_point<Traits>(start_); }

  /// Returns the point where the arc ends.
  Point end() const { return Geometric_continuity::to_point<Traits>(end_); }

  /// Returns whether the derivatives are known, be it with a square root: the rotation is a
  /// multiple of 45 degrees, or does not matter.
  bool is_known() const { return rotated_.empty(); }

  /// Returns an arc between the same ends, for pictures and reports: with the cosine and the sine
  /// of the rotation rounded to `double` unless `is_known()`.
  Elliptical_arc rounded() const {
    Elliptical_arc r = *this;
    if (is_known()) return r;
    r.rotated_.clear();
    r.set_rounded(rotated_.front());
    return r;
  }

  /// Returns whether the derivatives are known and rational.
  bool is_rational() const { return root_.has_value(); }

  /// Returns the number `D`, whose square root appears in the derivatives; 0 unless `is_known()`.
  const FT& radicand() const { return radicand_; }

  /// Returns the jet at the start in a field, given the root of `radicand()` in it:
  /// \f$ x' = \pm R(x-c) \f$, \f$ x'' = -(x-c) \f$, \f$ x''' = -x' \f$, ... with the quarter turn
  /// `R` of the ellipse.
  /// \throws Error `negative_count` for a negative order; `parameter_outside_domain` unless
  ///   `is_known()`
  template <class Field> Coordinate_jet<Field, 2> start_jet_over(int order, const Field& root) const {
    return jet<Field>(order, root, start_, half_chord(), k_);
  }

  /// Returns the jet at the end in a field, given the root of `radicand()` in it; see
  /// `start_jet_over()`.
  /// \throws Error `negative_count` for a negative order; `parameter_outside_domain` unless
  ///   `is_known()`
  template <class Field> Coordinate_jet<Field, 2> end_jet_over(int order, const Field& root) const {
    return jet<Field>(order, root, end_, FT(-1) * half_chord(), FT(-1) * k_);
  }

  /// Returns the jet at the start; empty unless `is_rational()`.
  /// \throws Error `negative_count` for a negative order
  std::optional<Curve_jet<Traits>> start_jet(int order) const {
    if (!root_) return std::nullopt;
    return Curve_jet<Traits>(start_jet_over<FT>(order, *root_));
  }

  /// Returns the jet at the end; empty unless `is_rational()`.
  /// \throws Error `negative_count` for a negative order
  std::optional<Curve_jet<Traits>> end_jet(int order) const {
    if (!root_) return std::nullopt;
    return Curve_jet<Traits>(end_jet_over<FT>(order, *root_));
  }

  /// Returns the arc as a rational curve, exactly; empty unless `is_rational()`. With
  /// \f$ U = x(0) - c \f$ and its quarter turn \f$ V \f$ in the direction of the arc it is
  /// \f$ c + ((a^2-b^2) U + 2ab V) / (a^2+b^2) \f$, \f$ b = t \f$, \f$ a = 1 - t \pm st \f$,
  /// because \f$ \tan(\theta/2) = \pm 1/s \f$ for its angle. Its middle weight is \f$ \pm s \f$:
  /// infinite for half an ellipse, negative for more.
  std::optional<Rational_bezier_curve<Traits, 2>> curve() const {
    if (!root_) return std::nullopt;
    typedef typename Homogeneous_traits<Traits>::Point Row;
    const Coordinates h = half_chord();
    const FT s = same_flags_ ? FT(FT(0) - *root_) : *root_, a = sweep_ ? s : FT(FT(0) - s);
    const Coordinates u = h + s * k_, turned = k_ - s * h, v = sweep_ ? turned : FT(-1) * turned, c = start_ - u;
    const auto row = [&](const FT& weight, const FT& in_u, const FT& in_v) -> Row {
      const Coordinates p = weight * c + in_u * u + in_v * v;
      Row r(3);
      r[0] = p[0];
      r[1] = p[1];
      r[2] = weight;
      return r;
    };
    const std::array<Row, 3> rows{row(FT(1), FT(1), FT(0)), row(a, a, FT(1)),
                                  row(FT(a * a + FT(1)), FT(a * a - FT(1)), FT(FT(2) * a))};
    return Rational_bezier_curve<Traits, 2>(typename Rational_bezier_curve<Traits, 2>::Homogeneous(rows));
  }

  /// Returns the image under an affine map of points, which is an arc of an ellipse again. The map
  /// must be affine and invertible; this is not checked.
  template <class Transformation> Elliptical_arc transform(const Transformation& map) const {
    const auto image = [&](const Coordinates& x) {
      return Geometric_continuity::coordinates<Traits>(map(Geometric_continuity::to_point<Traits>(x)));
    };
    Elliptical_arc r = *this;
    const auto image_of_vector = [&](const Coordinates& v) { return image(start_ + v) - image(start_); };
    r.k_ = image_of_vector(k_);
    for (internal::Rotated_ellipse<FT>& ellipse : r.rotated_)
      for (std::size_t j = 0; j < 3; ++j) {
        Coordinates v(2);
        for (std::size_t i = 0; i < 2; ++i) v[static_cast<int>(i)] = ellipse.k[i][j];
        v = image_of_vector(v);
        for (std::size_t i = 0; i < 2; ++i) ellipse.k[i][j] = v[static_cast<int>(i)];
      }
    r.start_ = image(start_);
    r.end_ = image(end_);
    return r;
  }

private:
  static FT absolute(const FT& x) { return x < FT(0) ? FT(FT(0) - x) : x; }

  Coordinates half_chord() const { return (start_ - end_) / FT(2); }

  void set_radicand(const FT& lambda) {
    if (lambda < FT(1)) radicand_ = FT((FT(1) - lambda) / lambda);
    if constexpr (std::is_floating_point_v<FT>)
      if (!(FT(0) < lambda) || !std::isfinite(radicand_) || !std::isfinite(k_[0]) || !std::isfinite(k_[1]))
        throw Error(Error_code::parameter_outside_domain,
                    "Elliptical_arc: the sizes differ too much for floating-point numbers");
    root_ = rational_square_root(radicand_);
  }

  // With the cosine and the sine rounded, unless the angle is zero.
  void set_rounded(const internal::Rotated_ellipse<FT>& ellipse) {
    const double angle = CGAL::to_double(ellipse.degrees) * (std::acos(-1.0) / 180);
    const FT cosine(std::cos(angle)), sine(std::sin(angle));
    for (int i = 0; i < 2; ++i) k_[i] = internal::turned(ellipse.k[static_cast<std::size_t>(i)], cosine, sine);
    set_radicand(internal::turned(ellipse.lambda, cosine, sine));
  }

  // At the end h of the chord, seen from its middle, with the image k of h: x - c = h + s k_ and
  // R(x - c) = k - s (half chord), because R R = -1.
  template <class Field>
  Coordinate_jet<Field, 2> jet(int order, const Field& root, const Coordinates& x, const Coordinates& h,
                               const Coordinates& k) const {
    if (order < 0) throw Error(Error_code::negative_count, "Elliptical_arc: order " + std::to_string(order));
    if (!is_known())
      throw Error(Error_code::parameter_outside_domain, "Elliptical_arc: the rotation of the ellipse is not rational");
    const Coordinates c = half_chord();
    const Field s = same_flags_ ? Field(Field(0) - root) : root;
    Coordinate_jet<Field, 2> jet(2, order);
    for (int i = 0; i < 2; ++i) {
      const Field radius = Field(Field(h[i]) + Field(s * Field(k_[i])));
      const Field turned = Field(Field(k[i]) - Field(s * Field(c[i])));
      jet[0][i] = Field(x[i]);
      for (int j = 1; j <= order; ++j) {
        const Field& size = j % 2 == 1 ? turned : radius;
        const bool negative = (j % 4 == 2 || j % 4 == 3) != (j % 2 == 1 && !sweep_);
        jet[j][i] = negative ? Field(Field(0) - size) : size;
      }
    }
    return jet;
  }
};

/// \ingroup PkgGeometricContinuityCurves
/// One segment of a path in the plane, as drawings have them: a line, another Bézier curve, or an
/// arc of an ellipse.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> struct Path_segment {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  /// a line is a Bézier curve of degree 1
  std::variant<Bezier_curve<Traits>, Elliptical_arc<Traits>> curve;

  /// Returns the arc, or a null pointer for a Bézier curve.
  const Elliptical_arc<Traits>* arc() const { return std::get_if<Elliptical_arc<Traits>>(&curve); }

  /// Returns the Bézier curve, or a null pointer for an arc.
  const Bezier_curve<Traits>* bezier() const { return std::get_if<Bezier_curve<Traits>>(&curve); }

  /// Returns whether the segment has a length: not a Bézier curve all of whose control points
  /// coincide.
  bool has_length() const {
    const auto is_elsewhere = [this](const Point& p) { return p != bezier()->control_point(0); };
    return arc() || std::any_of(bezier()->begin() + 1, bezier()->end(), is_elsewhere);
  }

  /// Returns the point where the segment starts.
  Point start() const { return arc() ? arc()->start() : bezier()->control_point(0); }

  /// Returns the point where the segment ends.
  Point end() const { return arc() ? arc()->end() : bezier()->control_point(bezier()->degree()); }

  /// Returns whether the derivatives at the ends are known: not those of an ellipse with an
  /// irrational rotation.
  bool is_known() const { return !arc() || arc()->is_known(); }

  /// Returns the segment, an arc as `Elliptical_arc::rounded()`.
  Path_segment rounded() const { return arc() ? Path_segment{arc()->rounded()} : *this; }

  /// Returns the number whose square root appears in the derivatives, see
  /// `Elliptical_arc::radicand()`; 0 for a Bézier curve.
  FT radicand() const { return arc() ? arc()->radicand() : FT(0); }

  /// Returns the jet at the start in a field, given the root of `radicand()` in it. An arc is taken
  /// with respect to the eccentric angle, a Bézier curve over its domain.
  /// \tparam Field a field that is constructible from `FT`
  /// \throws Error `negative_count` for a negative order; `parameter_outside_domain` unless
  ///   `is_known()`
  template <class Field> Coordinate_jet<Field, 2> start_jet_over(int order, const Field& root) const {
    if (arc()) return arc()->template start_jet_over<Field>(order, root);
    return converted<Field>(bezier()->start_jet(checked(order)));
  }

  /// Returns the jet at the end in a field, given the root of `radicand()` in it; see
  /// `start_jet_over()`.
  /// \throws Error `negative_count` for a negative order; `parameter_outside_domain` unless
  ///   `is_known()`
  template <class Field> Coordinate_jet<Field, 2> end_jet_over(int order, const Field& root) const {
    if (arc()) return arc()->template end_jet_over<Field>(order, root);
    return converted<Field>(bezier()->end_jet(checked(order)));
  }

  /// Returns the image under an invertible affine map of points.
  template <class Transformation> Path_segment transform(const Transformation& map) const {
    if (arc()) return {arc()->transform(map)};
    return {bezier()->transform(map)};
  }

private:
  static int checked(int order) {
    if (order < 0) throw Error(Error_code::negative_count, "Path_segment: order " + std::to_string(order));
    return order;
  }

  template <class Field> static Coordinate_jet<Field, 2> converted(const Coordinate_jet<FT, 2>& rational) {
    Coordinate_jet<Field, 2> jet(2, rational.order());
    for (int j = 0; j <= rational.order(); ++j)
      for (int i = 0; i < 2; ++i) jet[j][i] = Field(rational[j][i]);
    return jet;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_PATH_SEGMENT_H
