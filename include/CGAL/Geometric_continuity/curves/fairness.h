// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_FAIRNESS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_FAIRNESS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/internal/Gauss_rule.h>
#include <CGAL/Geometric_continuity/curves/internal/Curvature_polynomials.h>
#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/curves/internal/decision_numbers.h>
#include <CGAL/Geometric_continuity/curves/internal/double_derivatives.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

/// \file fairness.h
/// Measures of the fairness of a curve.
/// Two numbers measure a curve, independently of its scale and its parameter: the variation of its
/// curvature, which the strategy `Fair` makes small, and its bending energy (Moreton and Séquin).
/// Designers also want few extrema of the curvature and few inflections. Both are counted exactly,
/// by the changes of sign of polynomials. In the plane these are
/// \f$ g \det(d_1,d_3) - 3 (d_1\cdot d_2) \det(d_1,d_2) \f$ of degree `4m - 7`, with
/// \f$ g = d_1\cdot d_1 \f$, and \f$ \det(d_1,d_2) \f$; in other dimensions the numerator of the
/// derivative of \f$ \kappa^2 = |d_1\wedge d_2|^2/g^3 \f$, of degree `6m - 11`, and
/// \f$ |d_1\wedge d_2|^2 \f$.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Two integrals over a curve, of functions that are not negative: its length and another one. By
// Gauss's quadrature on intervals that are halved until the halves say the same as the whole. An
// integrand returns both functions for a parameter in [0, 1]; an infinite value is allowed.
template <class Integrand> class Adaptive_quadrature {
  typedef std::array<double, 2> Values;

  struct Part {
    std::size_t piece;
    double a, b;
    Values left, right; // the integrals over both halves
    Values error;       // how far they are from that over the whole
  };

  static constexpr double precision = 1e-8; // relative, of both integrals
  // the second integral is not distinguished from 0 below this
  static constexpr double least = 1e-24;
  static constexpr double shortest_part =
      0x1p-20; // where it is still in doubt on such a part of a piece, it is infinite
  static constexpr std::size_t most_parts = 1000; // and twice as many as there are pieces

  const std::vector<Integrand>& pieces_;
  std::vector<Part> parts_;

public:
  explicit Adaptive_quadrature(const std::vector<Integrand>& pieces) : pieces_(pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) add(parts_, i, 0, 1, gauss(i, 0, 1));
  }

  // The second integral may be infinite. Throws Error `work_limit` when too many parts are needed.
  Values operator()() {
    for (;;) {
      const Values total = sums(), share = {precision * total[0] / static_cast<double>(parts_.size()),
                                            precision * total[1] / static_cast<double>(parts_.size()) + least};
      std::vector<Part> finer;
      for (const Part& part : parts_) {
        if (part.error[0] <= share[0] && part.error[1] <= share[1]) {
          finer.push_back(part);
          continue;
        }
        if (part.b - part.a < shortest_part) return {total[0], std::numeric_limits<double>::infinity()};
        const double middle = (part.a + part.b) / 2;
        add(finer, part.piece, part.a, middle, part.left);
        add(finer, part.piece, middle, part.b, part.right);
      }
      if (finer.size() == parts_.size()) return total;
      if (finer.size() > most_parts + 2 * pieces_.size()) throw Error(Error_code::work_limit, "fairness of a curve");
      parts_ = std::move(finer);
    }
  }

private:
  Values sums() const {
    Values sum{};
    for (const Part& part : parts_)
      for (int k = 0; k < 2; ++k) sum[k] += part.left[k] + part.right[k];
    return sum;
  }

  void add(std::vector<Part>& parts, std::size_t piece, double a, double b, const Values& whole) const {
    const double middle = (a + b) / 2;
    Part part{piece, a, b, gauss(piece, a, middle), gauss(piece, middle, b), {}};
    for (int k = 0; k < 2; ++k) {
      part.error[k] = std::abs(part.left[k] + part.right[k] - whole[k]);
      if (std::isnan(part.error[k])) part.error[k] = std::numeric_limits<double>::infinity();
    }
    parts.push_back(part);
  }

  Values gauss(std::size_t piece, double a, double b) const {
    const Gauss_rule<10>& rule = Gauss_rule<10>::instance();
    const double middle = (a + b) / 2, half = (b - a) / 2;
    Values sum{};
    for (std::size_t i = 0; i < rule.abscissa.size(); ++i)
      for (double x : {-rule.abscissa[i], rule.abscissa[i]}) {
        const Values values = pieces_[piece](middle + half * x);
        for (int k = 0; k < 2; ++k) sum[k] += half * rule.weight[i] * values[k];
      }
    return sum;
  }
};

// Functions of the first three derivatives of a curve: the speed |d1|, and the integrand. Without a
// tangent it is infinite.

// |(dK/ds)_perp|^2 |d1|, where (dK/ds)_perp = (d3_perp - 3 a d2_perp) / |d1|^3 and a = d1.d2 /
// d1.d1. The same formula for the blends of one family, at fixed nodes and with its derivatives, is
// in blends/internal/Fairness_quadrature.h.
struct Curvature_variation {
  template <int N> std::array<double, 2> operator()(const Double_derivatives<N>& d) const {
    const double g = dot(d[0], d[0]), speed = std::sqrt(g);
    if (!(g > 0)) return {0, std::numeric_limits<double>::infinity()};
    const double a = dot(d[0], d[1]) / g;
    const Coordinate_vector<double, N> second = d[1] - a * d[0], third = d[2] - (dot(d[0], d[2]) / g) * d[0],
                                       m = third - (3 * a) * second;
    return {speed, dot(m, m) / (g * g * speed)};
  }
};

// |K|^2 |d1|, where K = d2_perp / |d1|^2.
struct Squared_curvature {
  template <int N> std::array<double, 2> operator()(const Double_derivatives<N>& d) const {
    const double g = dot(d[0], d[0]), speed = std::sqrt(g);
    // equivalent [0 -> 1, 2]: the length is not used where the integral is infinite
    if (!(g > 0)) return {0, std::numeric_limits<double>::infinity()};
    const Coordinate_vector<double, N> second = d[1] - (dot(d[0], d[1]) / g) * d[0];
    return {speed, dot(second, second) / (g * speed)};
  }
};

// A formula along a piece of a curve.
template <class Formula, class Derivatives> struct Integrand {
  Derivatives derivatives;
  std::array<double, 2> operator()(double t) const { return Formula()(derivatives(t)); }
};

// The length of a curve, in a unit that fits it, and the integral of a formula.
template <class Formula, class Curve> std::array<double, 2> curve_integrals(const Curve& curve) {
  const auto pieces = derivatives_of_pieces(curve);
  typedef Integrand<Formula, typename std::decay_t<decltype(pieces)>::value_type> Piece;
  std::vector<Piece> integrands;
  for (const auto& piece : pieces) integrands.push_back(Piece{piece});
  return Adaptive_quadrature<Piece>(integrands)();
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns the variation of curvature \f$ E = L^3 \int_0^L |(dK/ds)^\perp|^2\,ds \f$ of a curve of
/// length `L` in any dimension, with
/// \f$ (dK/ds)^\perp = (d_3^\perp - 3 \tfrac{d_1\cdot d_2}{d_1\cdot d_1}\, d_2^\perp) / |d_1|^3 \f$:
/// in the plane \f$ L^3\int\kappa'^2 \f$, in space \f$ L^3\int\kappa'^2+\kappa^2\tau^2 \f$. It is
/// zero for straight lines and circles, and the same for a curve of any size and in any direction.
/// The smaller, the fairer.
///
/// In floating-point numbers with every kernel, whose points may be of any size, to a relative
/// precision of \f$ 10^{-8} \f$: the length and the integral by Gauss's quadrature with ten nodes
/// on intervals that are halved until both halves say the same as the whole. There are at most 1000
/// intervals and two for each piece. Values below about \f$ 10^{-21} \f$ may be rounding.
///
/// Infinite when the first derivative vanishes in the domain, as in a cusp, also when that only
/// seems so on a millionth of a piece. (Where it vanishes on a straight line the value has no
/// meaning.) A curve of several pieces has the sum of their integrals; what the curvature jumps
/// between them does not count.
///
/// \param curve a model of `ParametricCurve`. Of a `Bezier_curve`, a `Composite_bezier_curve`, a
///   `Bspline_curve`, what is
///   derived from them, and the rational ones the pieces are known; other curves are asked for jets
///   of order 3 inside of the domain, which are expected to be smooth there.
/// \throws Error `work_limit` when more intervals are needed, `jet_order_too_low` when the curve
///   has jets of a lower order
/// \throws Error `not_finite` when differences of floating-point coordinates overflow
template <class Curve> double fairness(const Curve& curve) {
  const std::array<double, 2> r = internal::curve_integrals<internal::Curvature_variation>(curve);
  return std::isinf(r[1]) ? r[1] : r[0] * r[0] * r[0] * r[1];
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the bending energy \f$ L \int_0^L |K|^2\,ds \f$ of a curve of length `L` in any
/// dimension, with the curvature vector \f$ K = d_2^\perp / |d_1|^2 \f$. It is the same for a curve
/// of any size; that of an arc of a circle is the square of its angle. All else as for
/// `fairness()`.
/// \throws Error as `fairness()`
template <class Curve> double bending_energy(const Curve& curve) {
  const std::array<double, 2> r = internal::curve_integrals<internal::Squared_curvature>(curve);
  return std::isinf(r[1]) ? r[1] : r[0] * r[1];
}

/// \ingroup PkgGeometricContinuityCurves
/// The curvature at a place of a curve.
struct Curvature_at {
  Enclosure parameter; ///< in the domain of the curve
  Enclosure curvature; ///< in the plane with a sign, positive in a left turn
};

/// \ingroup PkgGeometricContinuityCurves
/// A place inside of the domain where the curvature turns from rising to falling, or from falling
/// to rising.
struct Curvature_extremum : Curvature_at {
  bool maximum; ///< whether it turns to falling
};

/// \ingroup PkgGeometricContinuityCurves
/// The extrema of the curvature of a curve, and its inflections. It is a range of its extrema.
struct Curvature_extrema {
  /// inside of the domain, in order, maxima and minima by turns
  std::vector<Curvature_extremum> extrema;
  std::vector<Enclosure> inflections; ///< the parameters, inside of the domain, in order
  /// the least curvature, which may be at an end of the domain
  Curvature_at least;
  /// the greatest curvature, which may be at an end of the domain
  Curvature_at greatest;

  /// Returns the number of extrema.
  std::size_t size() const { return extrema.size(); }
  /// Returns an iterator to the first extremum.
  std::vector<Curvature_extremum>::const_iterator begin() const { return extrema.begin(); }
  /// Returns the iterator behind the last extremum.
  std::vector<Curvature_extremum>::const_iterator end() const { return extrema.end(); }

  /// Returns the greatest absolute value of the curvature.
  Enclosure largest() const {
    const Enclosure &x = least.curvature, &y = greatest.curvature;
    return {(std::max)({-x.upper, y.lower, 0.}), (std::max)(std::abs(x.lower), std::abs(y.upper))};
  }

  /// Writes e.g. `2 extrema of curvature, 1 inflection, curvature from -1 to [0.333, 0.334]`.
  friend std::ostream& operator<<(std::ostream& os, const Curvature_extrema& c) {
    return os << c.extrema.size() << (c.extrema.size() == 1 ? " extremum" : " extrema") << " of curvature, "
              << c.inflections.size() << (c.inflections.size() == 1 ? " inflection" : " inflections")
              << ", curvature from " << c.least.curvature << " to " << c.greatest.curvature;
  }
};

namespace internal {

// Goes along a curve piece by piece.
template <class NT> class Curvature_walk {
  Curvature_extrema result_{{}, {}, {{0, 0}, {0, 0}}, {{0, 0}, {0, 0}}};
  bool started_ = false;
  int direction_ = 0;     // in which the curvature changed last: 1 rising, -1 falling
  Curvature_at turn_;     // up to where it did
  std::vector<NT> area_;  // at the end of the last piece that is not straight
  Enclosure bend_;        // the parameter there
  Signed_square<NT> end_; // the curvature at the end of the last piece

public:
  // The rows of a rational curve are homogeneous.
  template <int N>
  void add(const std::vector<Coordinate_vector<NT, N>>& rows, bool rational, const NT& a, const NT& b) {
    const Curvature_polynomials<NT> curve(rows, rational);
    if (!curve.is_regular()) throw Error(Error_code::zero_tangent, "curvature_extrema");
    const auto parameter = [&](const Isolated_root<NT>& r) -> Enclosure {
      return {enclosure(NT(a + (b - a) * r.begin)).lower, enclosure(NT(a + (b - a) * r.end)).upper};
    };
    const auto place = [&](const Isolated_root<NT>& r) -> Curvature_at {
      return {parameter(r), *curve.curvature(r.begin, r.end)};
    };
    const Curvature_at start = place({NT(0), NT(0)}), end = place({NT(1), NT(1)});
    if (started_)
      go(order(end_, curve.start_curvature()), start);
    else
      result_.least = result_.greatest = start;
    started_ = true;
    consider(start);
    if (!curve.is_straight()) {
      const Bernstein_polynomial<NT> slope = curve.slope();
      int direction = 0; // at the start
      for (int k = 0; direction == 0; ++k) direction = sign_of(slope[k]);
      for (const Isolated_root<NT>& root : changes(curve)) {
        go(direction, place(root));
        consider(turn_);
        direction = -direction;
      }
      go(direction, end);

      if (are_opposite(area_, curve.start_area())) result_.inflections.push_back(bend_);
      for (const Isolated_root<NT>& root : inside(curve.inflections(width())))
        result_.inflections.push_back(parameter(root));
      area_ = curve.end_area();
      bend_ = end.parameter;
    }
    consider(end);
    end_ = curve.end_curvature();
  }

  const Curvature_extrema& result() const { return result_; }

private:
  static NT width() { return NT(NT(1) / NT(1 << 20)) / NT(1 << 20); }

  // The places inside where the slope changes its sign, each so short that the curvature has bounds
  // there.
  static std::vector<Isolated_root<NT>> changes(const Curvature_polynomials<NT>& curve) {
    for (NT w = width();; w *= w) {
      std::vector<Isolated_root<NT>> roots = inside(curve.flat_places(w));
      roots.erase(std::remove_if(roots.begin(), roots.end(),
                                 [](const Isolated_root<NT>& r) { return r.multiplicity % 2 == 0; }),
                  roots.end());
      if (std::all_of(roots.begin(), roots.end(),
                      [&](const Isolated_root<NT>& r) { return bool(curve.curvature(r.begin, r.end)); }))
        return roots;
    }
  }

  static std::vector<Isolated_root<NT>> inside(std::vector<Isolated_root<NT>> roots) {
    roots.erase(std::remove_if(roots.begin(), roots.end(),
                               [](const Isolated_root<NT>& r) { return r.end == NT(0) || r.begin == NT(1); }),
                roots.end());
    return roots;
  }

  // The curvature goes up, 1, or down, -1, or not, 0, to this place.
  void go(int direction, const Curvature_at& place) {
    if (direction == 0) return;
    if (direction == -direction_) result_.extrema.push_back({turn_, direction < 0});
    direction_ = direction;
    turn_ = place;
  }

  // Takes a place into account for the least and the greatest curvature.
  void consider(const Curvature_at& place) {
    Curvature_at &x = result_.least, &y = result_.greatest;
    if (place.curvature.lower < x.curvature.lower) x = {place.parameter, {place.curvature.lower, x.curvature.upper}};
    x.curvature.upper = (std::min)(x.curvature.upper, place.curvature.upper);
    if (y.curvature.upper < place.curvature.upper) y = {place.parameter, {y.curvature.lower, place.curvature.upper}};
    y.curvature.lower = (std::max)(y.curvature.lower, place.curvature.lower);
  }

  static int order(const Signed_square<NT>& x, const Signed_square<NT>& y) {
    return x.sign != y.sign ? sign_of(y.sign - x.sign) : x.sign * sign_of(NT(y.square - x.square));
  }

  // Returns whether one is a negative multiple of the other.
  static bool are_opposite(const std::vector<NT>& x, const std::vector<NT>& y) {
    if (x.empty()) return false;
    NT xx(0), xy(0), yy(0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      xx += x[i] * x[i];
      xy += x[i] * y[i];
      yy += y[i] * y[i];
    }
    return xy < NT(0) && xx * yy == xy * xy;
  }
};

// The coordinates of control points as exact values, in homogeneous coordinates where they have
// weights.
template <class Curve> auto exact_rows(const Curve& curve) {
  typedef typename Curve::Traits Traits;
  const auto points = decision_rows<Traits>(curve);
  if constexpr (Is_rational<Curve>::value) {
    std::vector<decltype(homogeneous_point(points[0], points[0][0]))> rows;
    for (std::size_t i = 0; i < points.size(); ++i)
      rows.push_back(homogeneous_point(points[i], decision_number<Traits>(curve.weights()[i])));
    return rows;
  } else
    return points;
}

std::false_type is_spline(...);
template <class Traits> std::true_type is_spline(const Bspline_curve<Traits>&);
template <class Traits> std::true_type is_spline(const Rational_bspline_curve<Traits>&);

// Calls f(rows, a, b) for each of the Bezier curves that a curve is made of, in order: with the
// rows of its control points and with its domain, as exact values from the points and knots as they
// are given.
template <class Curve, class Function> void for_each_exact_piece(const Curve& curve, Function f) {
  typedef typename Curve::Traits Traits;
  typedef Decision_number<Traits> NT;
  if constexpr (decltype(is_spline(curve))::value) {
    std::vector<NT> values;
    for (const typename Traits::FT& knot : curve.knots()) values.push_back(decision_number<Traits>(knot));
    const Knot_vector<NT> knots(curve.degree(), values);
    const auto rows = bspline_bezier<NT>(knots, exact_rows(curve));
    auto first = rows.begin();
    for (int k : knots.spans()) {
      f(std::vector(first, first + curve.degree() + 1), knots[k], knots[k + 1]);
      first += curve.degree() + 1;
    }
  } else
    for_each_bezier(curve, [&](const auto& piece) {
      f(exact_rows(piece), decision_number<Traits>(piece.domain().first),
        decision_number<Traits>(piece.domain().second));
    });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns the extrema of the curvature of a curve and its inflections: how many there are is exact
/// with every kernel for the control points and knots as given, also with floating-point numbers.
/// Parameters and curvatures are guaranteed enclosures, whose parameters are in intervals of at
/// most \f$ 2^{-40} \f$ of a piece.
///
/// In the plane the curvature has a sign, positive in a left turn, and an inflection is a place
/// where it changes. In other dimensions the curvature is not negative, and an inflection is a
/// place where the curvature vector vanishes and has the opposite directions before and behind; it
/// is a minimum there. For a planar curve both have the same inflections.
///
/// A zero without a change of sign, such as a point of undulation, is not counted. Neither are the
/// ends of the domain, also where they meet. A straight line has neither extrema nor inflections. A
/// curve of several pieces is treated as one: where the curvature jumps it rises or falls at once,
/// and the extremum in front of a jump and the one behind have the same parameter. A stretch of
/// constant curvature, a straight piece, between rising and falling counts once, with the parameter
/// where it begins; and the same holds between two bends in opposite directions.
///
/// \param curve a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, or what is derived
///   from them, or a rational one
/// \throws Error `zero_tangent` when the first derivative vanishes anywhere in the domain, as in a
///   cusp
/// \throws Error `not_finite` for an infinite or undefined floating-point coordinate, and for a
///   curvature that is larger than all floating-point numbers
/// \throws Error `work_limit` when roots are so close to each other that `isolate_roots()` refuses
///   to separate them, and when exact numbers are so long that more work is needed
template <class Curve> Curvature_extrema curvature_extrema(const Curve& curve) {
  typedef internal::Decision_number<typename Curve::Traits> NT;
  internal::Curvature_walk<NT> walk;
  internal::for_each_exact_piece(curve, [&](const auto& rows, const NT& a, const NT& b) {
    walk.add(rows, internal::Is_rational<Curve>::value, a, b);
  });
  return walk.result();
}

/// \ingroup PkgGeometricContinuityCurves
/// A place where the curvature of a curve is larger than it may be.
struct Curvature_excess : Curvature_at {
  /// the number of the Bézier curve among those that the curve is made of, from 0 on
  std::size_t piece;
  /// whether the curvature has no bound there: a cusp, or a curve that turns back on itself
  bool unbounded;
};

namespace internal {

// A place in [0, 1] where a polynomial is negative: one of the ends of intervals that are halved.
// \pre there is such a place inside of an interval
template <class NT> NT negative_place(const Bernstein_polynomial<NT>& polynomial) {
  struct Part {
    Bernstein_polynomial<NT> p;
    NT begin, end;
  };
  std::vector<Part> parts = {{polynomial, NT(0), NT(1)}};
  for (;;) {
    std::vector<Part> halves;
    for (const Part& part : parts) {
      const std::vector<NT>& c = part.p.coefficients();
      if (c.front() < NT(0)) return part.begin;
      if (c.back() < NT(0)) return part.end;
      if (std::all_of(c.begin(), c.end(), [](const NT& x) { return !(x < NT(0)); })) continue;
      const NT half = NT(1) / NT(2), middle = (part.begin + part.end) * half;
      auto split = part.p.split(half);
      halves.push_back({std::move(split.first), part.begin, middle});
      halves.push_back({std::move(split.second), middle, part.end});
    }
    parts = std::move(halves);
  }
}

// Where a Bezier curve with these rows is bent most, if its curvature exceeds a bound.
template <class NT, int N>
std::optional<Curvature_excess> excess(const std::vector<Coordinate_vector<NT, N>>& rows, bool rational, const NT& a,
                                       const NT& b, const NT& bound, std::size_t piece) {
  const Curvature_polynomials<NT> curve(rows, rational);
  const auto parameter = [&](const NT& begin, const NT& end) -> Enclosure {
    return {enclosure(NT(a + (b - a) * begin)).lower, enclosure(NT(a + (b - a) * end)).upper};
  };
  const bool is_regular = curve.is_regular();
  if (!is_regular)
    if (const auto r = curve.cusp(NT(NT(1) / NT(1 << 20)) / NT(1 << 20)))
      return Curvature_excess{
          {parameter(r->begin, r->end), {(std::numeric_limits<double>::max)(), HUGE_VAL}}, piece, true};
  const Bernstein_polynomial<NT> rest = curve.rest(bound);
  const Sign_pattern signs = sign_pattern(rest);
  if (signs != Sign_pattern::negative && signs != Sign_pattern::nonpositive && signs != Sign_pattern::mixed)
    return std::nullopt;
  if (!is_regular) { // the extrema are not known
    const NT t = negative_place(rest);
    return Curvature_excess{{parameter(t, t), *curve.curvature(t, t)}, piece, false};
  }
  Curvature_walk<NT> walk;
  walk.add(rows, rational, a, b);
  const Curvature_at &least = walk.result().least, &greatest = walk.result().greatest;
  return Curvature_excess{greatest.curvature.upper < -least.curvature.lower ? least : greatest, piece, false};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Decides whether the curvature of a curve is nowhere larger than a bound, in the plane its
/// absolute value: exactly with every kernel, for the control points, the knots and the bound as
/// given. Returns nothing if that is so, also where the bound is reached, and otherwise the place
/// where the curve is bent most.
///
/// It is the sign of the polynomial \f$ K^2 g^3 - |d_1\wedge d_2|^2 \f$, of degree `6m - 6`, for a
/// rational curve \f$ K^2 g^3 - |d_1\wedge d_2|^2 w^4 \f$ with the numerators of the derivatives
/// and the denominator `w`. Straight lines and points have the curvature 0. Where the first
/// derivative vanishes, the curvature is that of what is drawn: it has no bound in a cusp, and
/// where the curve turns back on itself; it may have one elsewhere, as that of a line with handles
/// of length 0 has. On such a curve the place is one where the curvature exceeds the bound, and
/// need not be where it is largest. The angles at the joins of pieces are not asked for.
///
/// \param curve a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, or what is derived
///   from them, or a rational one
/// \param bound not negative, `1/R` where no radius of curvature may be less than `R`
/// \throws Error `unreachable_tolerance` when the bound is negative
/// \throws Error `not_finite` when the bound is infinite or undefined, and as `curvature_extrema()`
/// \throws Error `work_limit` as `curvature_extrema()`
template <class Curve>
std::optional<Curvature_excess> curvature_excess(const Curve& curve,
                                                 const internal::Convertible_number<typename Curve::FT>& bound) {
  typedef internal::Decision_number<typename Curve::Traits> NT;
  const NT limit = internal::decision_number<typename Curve::Traits>(bound.value);
  if (limit < NT(0)) throw Error(Error_code::unreachable_tolerance, "curvature_excess: a negative bound");
  std::optional<Curvature_excess> worst;
  std::size_t piece = 0;
  const auto size = [](const Curvature_at& x) { return (std::max)(-x.curvature.lower, x.curvature.upper); };
  internal::for_each_exact_piece(curve, [&](const auto& rows, const NT& a, const NT& b) {
    const auto found = internal::excess(rows, internal::Is_rational<Curve>::value, a, b, limit, piece++);
    if (found && (!worst || size(*worst) < size(*found))) worst = found;
  });
  return worst;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_FAIRNESS_H
