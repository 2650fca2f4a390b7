// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_FIT_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_FIT_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/Geometric_continuity/splines/internal/Polyline_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file fit.h
/// Few Bézier curves near a polyline, with joins that are exactly \f$ G^1 \f$ or \f$ G^2 \f$, also
/// in floating-point numbers, and with a proven distance.
///
/// The control points next to a join are \f$ A \pm b_\pm D \f$ and, for \f$ G^2 \f$,
/// \f$ A \pm f_\pm D + b_\pm^2 Q \f$: with a tangent `D` and a second difference `Q` that both
/// curves share, and integers \f$ b_\pm > 0, f_\pm \f$. All are multiples of one power of two, with
/// so few digits that no rounding is needed.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A curve near a polyline: cubics with \f$ G^1 \f$ joins, or quintics with \f$ G^2 \f$ joins, over
/// the knots 0, 1, 2, ...
template <class Traits> struct Fitted_curve : Composite_bezier_curve<Traits> {
  /// For each knot the number of the vertex that it belongs to, of those that were given; at a
  /// corner and at an end the curve goes through it, up to the rounding to a grid.
  std::vector<int> vertices;
  /// The numbers of the knots, in increasing order, at which a corner of the polyline is kept. The
  /// knot 0 of a closed curve stands for its last one, too.
  std::vector<int> corners;
  /// A proven bound: no point of the curve is farther than that from the polyline, and no point of
  /// the polyline from the curve. It bounds the distance of Fréchet, too: both can be run through
  /// without going back, and so that the two points are never farther apart.
  double distance;

  /// Takes the curve, the vertices, the corners and the distance.
  Fitted_curve(Composite_bezier_curve<Traits> curve, std::vector<int> at_vertices, std::vector<int> at_corners,
               double proven_distance)
      : Composite_bezier_curve<Traits>(std::move(curve)), vertices(std::move(at_vertices)),
        corners(std::move(at_corners)), distance(proven_distance) {}

  /// \cond SKIP_IN_MANUAL
  template <class... Given> internal::No_result max_error(const Given&...) const {
    static_assert(internal::never<Given...>, "the member distance is the proven bound of the error");
    return {};
  }
  /// \endcond
};

namespace internal {

// An integer times 2^exponent in any field.
template <class FT> FT grid_number_in(double x, int exponent) {
  if constexpr (has_interval_v<FT>)
    return FT(std::ldexp(x, exponent));
  else { // in parts of 24 digits
    FT sum(0);
    for (double rest = std::ldexp(x, exponent); rest != 0;) {
      int e;
      // equivalent [24 -> 25, 2]: halves of the parts: more of them, with the same sum
      const double part = std::ldexp(std::trunc(std::ldexp(std::frexp(rest, &e), 24)), e - 24);
      sum += short_number_in<FT>(part);
      rest -= part;
    }
    return sum;
  }
}

// A number as a double, and a bound of the error of that.
template <class FT> std::pair<double, double> rounded_with_error(const FT& x) {
  if constexpr (std::is_floating_point_v<FT>)
    return {double(x), 0};
  else if constexpr (has_interval_v<FT>) {
    const std::pair<double, double> i = exact_interval(x);
    check_finite(i.second, "fit: a coordinate");
    return {i.first, i.first == i.second ? 0 : next_above(i.second - i.first)};
  } else {
    const double y = rounded_number(x);
    check_finite(y, "fit: a coordinate");
    return {y, std::abs(y) * 0x1p-48};
  }
}

// The distinct vertices of a polyline in a unit of which all coordinates of a curve near it are
// multiples.
template <int N> struct Fit_polyline {
  std::vector<Coordinate_vector<double, N>> points;
  std::vector<int> numbers; // of the vertices
  std::vector<char> stop;   // whether there is a corner or an end
  int exponent;             // of the unit
  double tolerance, radius; // in units
  bool periodic;
};

// Tells whether a polyline turns by more than an angle at vertices, from the cosine of that.
template <int N> class Corner_finder {
  typedef Coordinate_vector<double, N> Vector;
  const std::vector<Vector>& p_;
  const double cosine_, tolerance_;
  const bool closed_; // the last vertex is the first one

  bool turns(const Vector& u, const Vector& v) const { return dot(u, v) < cosine_ * std::sqrt(dot(u, u) * dot(v, v)); }

  // The way from the vertex k to where the polyline leaves the ball about it, in one direction;
  // none if it does not, or to the end. Of many segments in the ball, longer and longer parts are
  // taken as chords.
  std::optional<Vector> way_out(int k, int direction, double radius, bool to_end) const {
    const int n = static_cast<int>(p_.size()) - 1, all = closed_ ? n : direction > 0 ? n - k : k;
    Vector last(p_[k].dimension());
    for (int done = 0; done < all;) {
      done = (std::min)(done + 1 + done / 16, all);
      const int j = k + direction * done;
      const Vector v = p_[j < 0 ? j + n : j > n ? j - n : j] - p_[k], step = v - last;
      const double a = dot(step, step), b = dot(last, step), c = dot(last, last) - radius * radius;
      if (dot(v, v) >= radius * radius) return Vector(last + ((std::sqrt(b * b - a * c) - b) / a) * step);
      last = v;
    }
    if (to_end && !closed_) return last;
    return std::nullopt;
  }

  // Tells whether it turns at a vertex between the points where it leaves the ball.
  bool turns_within(int k, double radius, bool otherwise) const {
    const std::optional<Vector> before = way_out(k, -1, radius, otherwise), after = way_out(k, 1, radius, otherwise);
    return before && after ? turns(-1. * *before, *after) : otherwise;
  }

  // Tells whether a segment is a step: short, and between two others that do not turn, or at an
  // end.
  bool is_step(int k) const {
    const int n = static_cast<int>(p_.size()) - 1;
    const auto at = [&](int j) -> const Vector& { return p_[j < 0 ? j + n : j > n ? j - n : j]; };
    const Vector step = at(k + 1) - at(k);
    if (dot(step, step) > 9 * tolerance_ * tolerance_) return false;
    if (!closed_ && (k < 1 || n <= k + 1)) return true;
    const Vector before = at(k) - at(k - 1), after = at(k + 2) - at(k + 1);
    // a turn by the angle itself is none, however it is rounded: 45 degrees between pixels
    return dot(before, after) >= (cosine_ - 1e-9) * std::sqrt(dot(before, before) * dot(after, after));
  }
  bool is_at_step(int k) const { return is_step(k == 0 ? static_cast<int>(p_.size()) - 2 : k - 1) || is_step(k); }

  // The cosine of the turn at a vertex, seen from a distance; 2 where it is not seen.
  double cosine_of_turn(int k, double radius) const {
    const std::optional<Vector> before = way_out(k, -1, radius, true), after = way_out(k, 1, radius, true);
    if (!before || !after) return 2;
    return -dot(*before, *after) / std::sqrt(dot(*before, *before) * dot(*after, *after));
  }

public:
  Corner_finder(const std::vector<Vector>& p, double cosine, double tolerance, bool closed)
      : p_(p), cosine_(cosine), tolerance_(tolerance), closed_(closed) {}

  // At the vertex itself, and seen from as far as the tolerance lets it be seen: from two
  // tolerances away, and from four or from the end before: the steps of a staircase that is near a
  // smooth curve are not corners. A vertex of a step must be seen from four tolerances away, and
  // from eight or from the end before: long steps are near a smooth curve, too.
  bool operator()(int k) const {
    Work_meter::pause();
    const int n = static_cast<int>(p_.size()) - 1, before = k == 0 ? n - 1 : k - 1, after = k + 1;
    if (!turns(p_[k] - p_[before], p_[after] - p_[k]) || !turns_within(k, 2 * tolerance_, false)) return false;
    const bool is_step = is_at_step(k);
    return turns_within(k, 4 * tolerance_, !is_step) && (!is_step || turns_within(k, 8 * tolerance_, true));
  }

  // Takes corners at steps out that are next to a sharper one, within six tolerances.
  void thin_out(std::vector<char>& corners) const {
    const int n = static_cast<int>(p_.size()) - 1;
    std::vector<int> found;
    for (int k = 0; k < n; ++k)
      if (corners[k] && is_at_step(k)) found.push_back(k);
    const auto are_near = [&](int j, int k) {
      const Vector d = p_[k] - p_[j];
      return dot(d, d) <= 36 * tolerance_ * tolerance_;
    };
    const int all = static_cast<int>(found.size());
    for (int i = 0; i < all && all > 1; ++i) {
      const int k = found[i], next = found[i + 1 == all ? 0 : i + 1];
      if ((i + 1 == all && !closed_) || !corners[k] || !are_near(k, next)) continue;
      const bool is_first_sharper = cosine_of_turn(k, 8 * tolerance_) <= cosine_of_turn(next, 8 * tolerance_);
      corners[is_first_sharper ? next : k] = 0;
      if (is_first_sharper) found[i + 1 == all ? 0 : i + 1] = k;
    }
  }
};

// Which pieces are found depends on the end at which the search starts, and on how long those are
// that it tries first. Of a short polyline, and where nothing is found, the fewest of four searches
// are taken.
template <int N, int degree>
typename Polyline_fit<N, degree>::Result fitted_pieces(const Fit_polyline<N>& polyline, double largest) {
  typedef Polyline_fit<N, degree> Fit;
  constexpr std::size_t most_points = 1024;
  std::vector<Coordinate_vector<double, N>> backwards;
  std::vector<char> stop_backwards;
  std::array<std::optional<Fit>, 2> fits; // the second one backwards, where it is asked
  fits[0].emplace(polyline.points, polyline.stop, polyline.tolerance, polyline.periodic, largest);
  decltype(fits[0]->spans(false)) fewest;
  bool is_backwards = false;
  std::optional<Error> error;
  for (const bool from_all : {false, true})
    for (const bool backward : {false, true}) {
      if (fewest.size() == 1 || (!fewest.empty() && polyline.points.size() > most_points)) continue;
      if (!fits[backward]) {
        backwards.assign(polyline.points.rbegin(), polyline.points.rend());
        stop_backwards.assign(polyline.stop.rbegin(), polyline.stop.rend());
        fits[backward].emplace(backwards, stop_backwards, polyline.tolerance, polyline.periodic, largest);
      }
      try {
        auto spans = fits[backward]->spans(from_all);
        if (!fewest.empty() && fewest.size() <= spans.size()) continue;
        fewest = std::move(spans);
        is_backwards = backward;
      } catch (const Error& e) {
        if (fewest.empty() && e.code() != Error_code::unreachable_tolerance) throw;
        if (!error) error = e;
      }
    }
  if (fewest.empty()) throw *error;
  const Protect_FPU_rounding<true> upwards;
  typename Fit::Result result = fits[is_backwards]->proved(fewest, polyline.radius);
  if (!is_backwards) return result;
  std::reverse(result.points.begin(), result.points.end());
  std::reverse(result.vertices.begin(), result.vertices.end());
  for (int& v : result.vertices) v = static_cast<int>(polyline.points.size()) - 1 - v;
  return result;
}

// N is the dimension of the computation.
template <int N, class Traits>
Fitted_curve<Traits> fitted_curve(const std::vector<Coordinates<Traits>>& given, double tolerance, double corner_cosine,
                                  Closure closure, int order) {
  typedef typename Traits::FT FT;
  constexpr int digits = std::is_floating_point_v<FT> ? std::numeric_limits<FT>::digits : 53;
  const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  const int dimension = given[0].dimension();
  Fit_polyline<N> polyline{{}, {}, {}, 0, 0, 0, closure == Closure::closed};
  // The unit, so that coordinates from an origin have less than 2^(digits-3) of them. Where these
  // are too coarse for the tolerance, the origin is the first vertex, to which numbers are added
  // that are not rounded.
  Coordinates<Traits> origin(dimension);
  const auto tolerance_from_origin = [&] {
    double size = 0;
    for (const Coordinates<Traits>& x : given)
      for (const FT& c : Coordinates<Traits>(x - origin))
        size = (std::max)(size, std::abs(rounded_with_error(c).first));
    polyline.exponent = (size > 0 ? std::ilogb(size) : 0) + 4 - digits;
    return std::ldexp(tolerance, -polyline.exponent);
  };
  polyline.tolerance = tolerance_from_origin();
  if (!std::is_floating_point_v<FT> && has_interval_v<FT> && !(polyline.tolerance >= 1024)) {
    origin = given[0];
    polyline.tolerance = tolerance_from_origin();
  }
  polyline.tolerance = (std::min)(polyline.tolerance, std::ldexp(1., digits - 3));
  if (polyline.exponent < std::numeric_limits<double>::min_exponent)
    throw Error(Error_code::unreachable_tolerance, "fit: the coordinates are too small");
  for (std::size_t k = 0; k < given.size(); ++k) {
    Work_meter::pause();
    Coordinate_vector<double, N> p(dimension);
    const Coordinates<Traits> from_origin = given[k] - origin;
    for (int x = 0; x < dimension; ++x) {
      const std::pair<double, double> c = rounded_with_error(from_origin[x]);
      p[x] = std::ldexp(c.first, -polyline.exponent);
      polyline.radius = (std::max)(polyline.radius, std::ldexp(c.second, -polyline.exponent));
    }
    if (!polyline.points.empty() && polyline.points.back() == p) continue;
    polyline.points.push_back(p);
    polyline.numbers.push_back(static_cast<int>(k));
  }
  if (polyline.periodic && polyline.points.size() > 1 && polyline.points.front() == polyline.points.back()) {
    polyline.points.pop_back();
    polyline.numbers.pop_back();
  }
  const std::size_t least = polyline.periodic ? 3 : 2;
  if (polyline.points.size() < least)
    throw Error(Error_code::wrong_number_of_points,
                "fit: " + std::to_string(polyline.points.size()) + " points that differ");
  if (!(polyline.tolerance >= 1024))
    throw Error(Error_code::unreachable_tolerance,
                "fit: the tolerance is below 2^" + std::to_string(13 - digits) + " of the largest coordinate" +
                    (std::is_floating_point_v<FT> ? "; take a larger one, or move the points towards the origin"
                                                  : " from the first point on; take a larger one"));

  // a closed polyline starts at a corner, if it has one
  std::vector<Coordinate_vector<double, N>>& p = polyline.points;
  if (polyline.periodic) p.push_back(p.front());
  const Corner_finder<N> is_corner(p, corner_cosine, polyline.tolerance, polyline.periodic);
  const int n = static_cast<int>(p.size()) - 1;
  polyline.stop.assign(p.size(), 0);
  for (int k = polyline.periodic ? 0 : 1; k < n; ++k) polyline.stop[k] = is_corner(k);
  is_corner.thin_out(polyline.stop);
  if (polyline.periodic) {
    const std::ptrdiff_t first = std::find(polyline.stop.begin(), polyline.stop.end() - 1, 1) - polyline.stop.begin();
    polyline.periodic = first == n;
    if (!polyline.periodic) {
      p.pop_back();
      polyline.stop.pop_back();
      std::rotate(p.begin(), p.begin() + first, p.end());
      std::rotate(polyline.stop.begin(), polyline.stop.begin() + first, polyline.stop.end());
      std::rotate(polyline.numbers.begin(), polyline.numbers.begin() + first, polyline.numbers.end());
      p.push_back(p.front());
      polyline.stop.push_back(1);
    }
    polyline.numbers.push_back(polyline.numbers.front());
  }
  const bool has_corner_at_start = polyline.stop[0] != 0;
  polyline.stop.front() = polyline.stop.back() = 1;

  const auto finish = [&](const auto& result) {
    std::vector<typename Traits::Point> points;
    points.reserve(result.points.size());
    for (const Coordinate_vector<double, N>& x : result.points) {
      Coordinates<Traits> c(dimension);
      for (int i = 0; i < dimension; ++i) c[i] = origin[i] + grid_number_in<FT>(x[i], polyline.exponent);
      points.push_back(to_point<Traits>(c));
    }
    std::vector<FT> knots;
    std::vector<int> vertices, corners;
    for (std::size_t k = 0; k < result.vertices.size(); ++k) {
      const int v = result.vertices[k];
      knots.push_back(FT(static_cast<int>(k)));
      vertices.push_back(polyline.numbers[v]);
      if (v == 0 ? has_corner_at_start : v < n && polyline.stop[v]) corners.push_back(static_cast<int>(k));
    }
    return Fitted_curve<Traits>(Composite_bezier_curve<Traits>(points, std::move(knots)), std::move(vertices),
                                std::move(corners), std::ldexp(root_above(result.squared_distance), polyline.exponent));
  };
  const double largest = std::ldexp(1., digits - 2);
  return order == 1 ? finish(fitted_pieces<N, 3>(polyline, largest)) : finish(fitted_pieces<N, 5>(polyline, largest));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a curve of few pieces near a polyline. Its joins are *exactly* \f$ G^1 \f$ or
/// \f$ G^2 \f$, with floating-point numbers, too, as the exact predicates on its control points
/// confirm; and that it is near is proved, with intervals, in both directions: see
/// `Fitted_curve::distance`.
///
/// A piece is at first the longest that is found from where the one before it ends: its ends are
/// near vertices, points, tangents and curvatures there are those of one of several cubic
/// polynomials near the polyline, in windows of different widths, and the rest is found by least
/// squares of the distances orthogonal to the curve. Then up to 8 pieces in a row are replaced by
/// one less where all their joints can move, also between vertices, so that it is near. A polyline
/// of at most 1024 points is searched from both ends, and with short or long pieces first. How many
/// pieces there are is not proved to be the least.
/// Where the polyline bends sharply but less than at a corner, pieces are short, and so are
/// tangents.
///
/// Vertices that are equal to the one before them are skipped; a closed polyline may end with its
/// first vertex.
///
/// \f$ O(n \log n) \f$ for `n` vertices, all in `double`. With other numbers the vertices are
/// rounded first, of which the proof takes account; control points have at most as many binary
/// digits as a `double`, or, where that is too coarse for the tolerance, their differences from the
/// first vertex have.
///
/// \param first, last the vertices
/// \param tolerance the bound of the distance, in the unit of the coordinates, at least about
///   \f$ 2^{-40} \f$ of the largest coordinate (\f$ 2^{-11} \f$ with `float`)
/// \param closure whether the polyline is closed
/// \param order 1 for cubics with \f$ G^1 \f$ joins, 2 for quintics with \f$ G^2 \f$ joins
/// \param corner_angle in degrees, from 0 to 180. A vertex is a corner where the polyline turns by
///   more than that, at the vertex and between the points where it leaves the balls of two and of
///   four tolerances about it, or ends there; also where it turns back there. Corners are kept: the
///   curve has a kink there. Steps of a staircase that is near a smooth curve are none.
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \throws Error `wrong_number_of_points` for fewer than 2 different vertices, or 3 if closed
/// \throws Error `parameter_outside_domain` for another order or angle
/// \throws Error `unreachable_tolerance` unless the tolerance is positive and large enough
/// \throws Error `dimension_mismatch`, `not_finite`
template <class Traits, class InputIterator>
Fitted_curve<Traits> fit(InputIterator first, InputIterator last, const typename Traits::FT& tolerance,
                         Closure closure = Closure::open, int order = 1, double corner_angle = 45) {
  typedef typename Traits::FT FT;
  if (order != 1 && order != 2)
    throw Error(Error_code::parameter_outside_domain, "fit: the order " + std::to_string(order) + " is not 1 or 2");
  if (!(corner_angle >= 0 && corner_angle <= 180))
    throw Error(Error_code::parameter_outside_domain, "fit: the angle of corners is not from 0 to 180 degrees");
  internal::check_finite(tolerance, "fit: tolerance");
  if (!(FT(0) < tolerance)) throw Error(Error_code::unreachable_tolerance, "fit: the tolerance is not positive");
  std::vector<Coordinates<Traits>> p;
  for (; first != last; ++first) p.push_back(Geometric_continuity::coordinates<Traits>(*first));
  if (p.empty()) throw Error(Error_code::wrong_number_of_points, "fit: no points");
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p[k].dimension() != p[0].dimension())
      throw Error(Error_code::dimension_mismatch, "fit: the point " + std::to_string(k));
    if constexpr (std::is_floating_point_v<FT>)
      for (const FT& c : p[k])
        if (!std::isfinite(c)) throw Error(Error_code::not_finite, "fit: the point " + std::to_string(k));
  }
  const std::pair<double, double> t = internal::rounded_with_error(tolerance);
  const double rounded_tolerance = t.second == 0 ? t.first : t.first * (1 - 0x1p-40),
               cosine = (std::max)(std::cos(corner_angle * (3.141592653589793 / 180)), -0.9999999);
  constexpr int N = dimension_v<Traits>;
  if constexpr (N == 0) { // as far as the dimension is known to the compiler, it is faster
    if (p[0].dimension() == 2) return internal::fitted_curve<2, Traits>(p, rounded_tolerance, cosine, closure, order);
    if (p[0].dimension() == 3) return internal::fitted_curve<3, Traits>(p, rounded_tolerance, cosine, closure, order);
  }
  return internal::fitted_curve<N, Traits>(p, rounded_tolerance, cosine, closure, order);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a curve of few pieces near a polyline with vertices of a \cgal kernel, over whose traits
/// class (`Traits_of`) it is.
/// \throws Error as for the vertices between two iterators
template <class Point>
Fitted_curve<Traits_of<Point>> fit(const std::vector<Point>& vertices, const typename Traits_of<Point>::FT& tolerance,
                                   Closure closure = Closure::open, int order = 1, double corner_angle = 45) {
  return fit<Traits_of<Point>>(vertices.begin(), vertices.end(), tolerance, closure, order, corner_angle);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_FIT_H
