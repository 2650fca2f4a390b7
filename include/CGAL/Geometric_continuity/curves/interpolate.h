// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERPOLATE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERPOLATE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file interpolate.h
/// Cubic B-spline curves through points, \f$ C^2 \f$ with the parameters of the points as simple
/// knots. \cgalCite{Boor-78}
///
/// At the parameter \f$ u_i \f$ three basis functions are not zero, with the values
/// \f[ \frac{(u_{i+1} - u_i)^2}{(u_{i+1} - u_{i-1})(u_{i+1} - u_{i-2})}, \quad 1 - \dots, \quad
///     \frac{(u_i - u_{i-1})^2}{(u_{i+1} - u_{i-1})(u_{i+2} - u_{i-1})}. \f]
/// The matrix of these values is totally positive: elimination needs no other pivots than those of
/// its diagonal, and no root.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The ways to choose the parameters of points through which a curve runs.
enum class Parametrisation {
  uniform,    ///< at the distance 1
  chordal,    ///< at the distances of the points
  centripetal ///< at the square roots of the distances of the points
};

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the name of a parametrisation, as spelled in the enumeration.
inline std::string to_string(Parametrisation p) {
  return p == Parametrisation::uniform ? "uniform" : p == Parametrisation::chordal ? "chordal" : "centripetal";
}

/// \ingroup PkgGeometricContinuityConstruction
/// Writes the name of a parametrisation.
inline std::ostream& operator<<(std::ostream& os, Parametrisation p) { return os << to_string(p); }

/// \ingroup PkgGeometricContinuityConstruction
/// Returns parameters for points, from 0 on; for a closed curve one more, at which it is back at
/// the first point. Distances and their roots are rounded to 10 binary digits, so that the
/// parameters are short numbers in every field. Any increasing numbers are as good for
/// `interpolate()`. \f$ O(n) \f$
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \throws Error `empty_domain` when two consecutive points coincide (not if uniform),
///   `dimension_mismatch`, `not_finite` when a distance is not in the range of floating-point
///   numbers
template <class Traits, class InputIterator>
std::vector<typename Traits::FT> interpolation_parameters(InputIterator first, InputIterator last,
                                                          Parametrisation parametrisation,
                                                          Closure closure = Closure::open) {
  typedef typename Traits::FT FT;
  std::vector<FT> u(1, FT(0));
  if (first == last) return u;
  const Coordinates<Traits> start = Geometric_continuity::coordinates<Traits>(*first);
  Coordinates<Traits> a = start;
  for (bool is_last = false; !is_last;) {
    is_last = ++first == last;
    if (is_last && closure == Closure::open) break;
    const Coordinates<Traits> b = is_last ? start : Geometric_continuity::coordinates<Traits>(*first);
    const std::size_t i = u.size() - 1, j = is_last ? 0 : i + 1; // the numbers of the points
    double distance = 1;
    if (parametrisation != Parametrisation::uniform) {
      if (a.dimension() != b.dimension())
        throw Error(Error_code::dimension_mismatch, "interpolation_parameters: point " + std::to_string(j));
      double length = 0;
      for (int x = 0; x < a.dimension(); ++x) length = std::hypot(length, CGAL::to_double(FT(b[x] - a[x])));
      internal::check_finite(length, "interpolation_parameters: a distance");
      if (!(length > 0))
        throw Error(Error_code::empty_domain, "interpolation_parameters: the points " + std::to_string(i) + " and " +
                                                  std::to_string(j) + " coincide");
      distance = internal::short_double<10>(parametrisation == Parametrisation::chordal ? length : std::sqrt(length));
    }
    u.push_back(FT(u.back() + internal::short_number_in<FT>(distance)));
    a = b;
  }
  return u;
}

namespace internal {

// The equation a x_{i-1} + b x_i + c x_{i+1} = r_i for values x_0, x_1, ...
template <class FT> struct Tridiagonal_row { FT a, b, c; };

// Solves the equations row(i) of n unknowns, for each i in turn, in the place of the right sides:
// get(i) returns one or the other, and set(i, x) takes the solution. In the first row a is not
// read, in the last one c.
template <class FT, class Row, class Get, class Set> void solve_tridiagonal(int n, Row row, Get get, Set set) {
  typedef std::decay_t<decltype(get(0))> Value;
  std::vector<FT> b, c; // what is left of the rows
  b.reserve(n);
  c.reserve(n);
  for (int i = 0; i < n; ++i) {
    Tridiagonal_row<FT> r = row(i);
    if constexpr (!std::is_floating_point_v<FT>)
      work_meter().charge_fractions(4 + number_of_coordinates(get(i)), number_words(r.b));
    else
      Work_meter::pause();
    if (i > 0) {
      const FT factor = FT(r.a / b.back());
      r.b -= factor * c.back();
      set(i, get(i) - factor * get(i - 1));
    }
    b.push_back(std::move(r.b));
    c.push_back(std::move(r.c));
  }
  for (int i = n - 1; i >= 0; --i) {
    Value x = get(i);
    if (i < n - 1) x -= c[i] * get(i + 1);
    x *= FT(FT(1) / b[i]);
    set(i, x);
  }
}

// Solves a cyclic system of 3 unknowns or more: in the first row, a belongs to the last unknown, in
// the last row c to the first one. The others are y_i - z_i x_{n-1}, where y and z solve the
// equations without the last unknown.
template <class FT, class Row, class Get, class Set> void solve_cyclic(int n, Row row, Get get, Set set) {
  typedef std::decay_t<decltype(get(0))> Value;
  const int last = n - 1;
  const Tridiagonal_row<FT> r = row(last);
  std::vector<FT> z(last, FT(0));
  z[0] += row(0).a;
  z[last - 1] += row(last - 1).c;
  solve_tridiagonal<FT>(last, row, get, set);
  solve_tridiagonal<FT>(
      last, row, [&](int i) -> const FT& { return z[i]; }, [&](int i, const FT& x) { z[i] = x; });
  Value x = get(last) - (r.a * get(last - 1) + r.c * get(0));
  x /= FT(r.b - r.a * z[last - 1] - r.c * z[0]);
  set(last, x);
  for (int i = 0; i < last; ++i) set(i, get(i) - z[i] * x);
}

// Points, the first and the last one twice, which become the control points b_0, b_1, ... Where
// numbers are rounded they stay where they are: fresh memory costs more than elimination. Other
// points can be handles of numbers that are computed when they are asked for; those are taken as
// columns meanwhile.
template <class Traits> class Spline_points {
  typedef typename Traits::Point Point;
  static constexpr bool are_numbers = std::is_floating_point_v<typename Traits::FT>;
  std::vector<std::conditional_t<are_numbers, Point, Coordinates<Traits>>> b_;

public:
  void reserve(std::size_t n) { b_.reserve(n); }
  int size() const { return static_cast<int>(b_.size()); }

  Coordinates<Traits> operator[](int j) const {
    if constexpr (are_numbers)
      return Geometric_continuity::coordinates<Traits>(b_[j]);
    else
      return b_[j];
  }
  void set(int j, const Coordinates<Traits>& x) {
    if constexpr (are_numbers)
      b_[j] = to_point<Traits>(x);
    else
      b_[j] = x;
  }
  void push_back(const Coordinates<Traits>& x) {
    if constexpr (are_numbers)
      b_.push_back(to_point<Traits>(x));
    else
      b_.push_back(x);
  }

  std::vector<Point> points() && {
    if constexpr (are_numbers)
      return std::move(b_);
    else {
      std::vector<Point> points;
      points.reserve(b_.size());
      for (const Coordinates<Traits>& x : b_) points.push_back(to_point<Traits>(x));
      return points;
    }
  }
};

// Reads the points, and checks their parameters.
template <class Traits, class InputIterator>
Spline_points<Traits> points_to_interpolate(InputIterator first, InputIterator last,
                                            const std::vector<typename Traits::FT>& u, Closure closure) {
  const bool closed = closure == Closure::closed;
  Spline_points<Traits> b;
  b.reserve(u.size() + 2);
  for (; first != last; ++first) {
    const Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(*first);
    if (b.size() == 0) b.push_back(x);
    if (x.dimension() != b[0].dimension()) throw Error(Error_code::dimension_mismatch, "interpolate: points");
    for (const typename Traits::FT& c : x) check_finite(c, "interpolate: a coordinate");
    b.push_back(x);
  }
  const int n = (std::max)(b.size() - 1, 0);
  if (n < (closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate: " + std::to_string(n) + " points");
  if (static_cast<int>(u.size()) != n + (closed ? 1 : 0))
    throw Error(Error_code::wrong_number_of_points,
                "interpolate: " + std::to_string(u.size()) + " parameters for " + std::to_string(n) + " points");
  for (const typename Traits::FT& x : u) check_finite(x, "interpolate: a parameter");
  for (std::size_t i = 1; i < u.size(); ++i)
    if (!(u[i - 1] < u[i]))
      throw Error(Error_code::empty_domain, "interpolate: the parameters " + std::to_string(i - 1) + " and " +
                                                std::to_string(i) + " do not increase");
  b.push_back(b[n]);
  return b;
}

// The equation of the value at the simple knot t_2 of the five knots around it.
template <class FT>
Tridiagonal_row<FT> value_at_knot(const FT& t0, const FT& t1, const FT& t2, const FT& t3, const FT& t4) {
  const FT h = t3 - t2, g = t2 - t1, length = h + g;
  const FT a = FT(h * h / FT(length * FT(t3 - t0))), c = FT(g * g / FT(length * FT(t4 - t1)));
  return {a, FT(FT(1) - a - c), c};
}

// The spline over the knots u(-3), ..., u(last + 3).
template <class Traits, class Knots> Bspline_curve<Traits> spline_over(Knots u, int last, Spline_points<Traits>&& b) {
  std::vector<typename Traits::FT> t;
  t.reserve(last + 7);
  for (int i = -3; i <= last + 3; ++i) t.push_back(u(i));
  return Bspline_curve<Traits>(std::move(b).points(), Knot_vector<typename Traits::FT>(3, std::move(t)));
}

// An open curve, with the given derivatives at its ends, or with second derivatives that vanish.
template <class Traits>
Bspline_curve<Traits>
interpolate_open(Spline_points<Traits> b, const std::vector<typename Traits::FT>& parameters,
                 const std::optional<std::pair<Coordinates<Traits>, Coordinates<Traits>>>& derivatives) {
  typedef typename Traits::FT FT;
  const Work_guard work("interpolate");
  const int last = static_cast<int>(parameters.size()) - 1;
  const auto u = [&](int i) -> const FT& { return parameters[(std::min)((std::max)(i, 0), last)]; };
  const auto get = [&](int i) { return b[i + 1]; };
  const auto set = [&](int i, const Coordinates<Traits>& x) { b.set(i + 1, x); };
  const FT h = u(1) - u(0), g = u(last) - u(last - 1), h2 = u(2) - u(0), g2 = u(last) - u(last - 2);
  Tridiagonal_row<FT> at_start{FT(0), FT(1), FT(0)}, at_end = at_start;
  if (derivatives) { // S' = 3 (b_1 - b_0) / h
    const FT third = FT(FT(1) / FT(3));
    set(0, get(0) + FT(h * third) * derivatives->first);
    set(last, get(last) - FT(g * third) * derivatives->second);
  } else { // S'' = 0 is h (b_2 - b_1) = h2 (b_1 - b_0)
    at_start = {FT(0), FT(h + h2), FT(-h)};
    at_end = {FT(-g), FT(g + g2), FT(0)};
    set(0, h2 * get(0));
    set(last, g2 * get(last));
  }
  const auto row = [&](int i) {
    if (i == 0) return at_start;
    if (i == last) return at_end;
    return value_at_knot<FT>(u(i - 2), parameters[i - 1], parameters[i], parameters[i + 1], u(i + 2));
  };
  solve_tridiagonal<FT>(last + 1, row, get, set);
  return spline_over<Traits>(u, last, std::move(b));
}

template <class Traits>
Bspline_curve<Traits> interpolate_closed(Spline_points<Traits> b, const std::vector<typename Traits::FT>& parameters) {
  typedef typename Traits::FT FT;
  const Work_guard work("interpolate");
  const int n = static_cast<int>(parameters.size()) - 1;
  const FT period = parameters[n] - parameters[0];
  const auto u = [&](int i) -> FT {
    return i < 0 ? FT(parameters[n + i] - period) : i > n ? FT(parameters[i - n] + period) : parameters[i];
  };
  solve_cyclic<FT>(
      n, [&](int i) { return value_at_knot<FT>(u(i - 2), u(i - 1), u(i), u(i + 1), u(i + 2)); },
      [&](int i) { return b[i + 1]; }, [&](int i, const Coordinates<Traits>& x) { b.set(i + 1, x); });
  b.set(0, b[n]);
  b.set(n + 1, b[1]);
  b.push_back(b[2]);
  return spline_over<Traits>(u, n, std::move(b));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the cubic spline through points at given parameters, \f$ C^2 \f$ inside: an open one is
/// \em natural, with second derivatives that vanish at both ends; a closed one returns to the first
/// point at one more parameter and is \f$ C^2 \f$ there, too, over periodic knots that are not
/// clamped. With an exact kernel it is exact. \f$ O(n) \f$ operations; exact numbers become longer
/// from point to point.
/// \param first, last the points
/// \param parameters one for each point, increasing; for a closed curve one more, at which it is
///   back at the first point
/// \param closure whether the curve is closed
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \throws Error `wrong_number_of_points` for fewer than 2 points, or 3 if closed, and for another
///   number of parameters; `empty_domain` unless the parameters increase; `dimension_mismatch`;
///   `not_finite` also when floating-point numbers overflow; `work_limit`
template <class Traits, class InputIterator>
Bspline_curve<Traits> interpolate(InputIterator first, InputIterator last,
                                  const std::vector<typename Traits::FT>& parameters, Closure closure = Closure::open) {
  internal::Spline_points<Traits> p = internal::points_to_interpolate<Traits>(first, last, parameters, closure);
  return closure == Closure::closed ? internal::interpolate_closed(std::move(p), parameters)
                                    : internal::interpolate_open(std::move(p), parameters, std::nullopt);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the \em clamped cubic spline through points at given parameters, \f$ C^2 \f$ inside,
/// with the given first derivatives at both ends. For the points of a cubic polynomial and its
/// derivatives, it is that polynomial. \f$ O(n) \f$
/// \throws Error as for a natural spline
template <class Traits, class InputIterator>
Bspline_curve<Traits>
interpolate(InputIterator first, InputIterator last, const std::vector<typename Traits::FT>& parameters,
            const typename Traits::Vector& start_derivative, const typename Traits::Vector& end_derivative) {
  internal::Spline_points<Traits> p = internal::points_to_interpolate<Traits>(first, last, parameters, Closure::open);
  const std::pair<Coordinates<Traits>, Coordinates<Traits>> d(
      Geometric_continuity::coordinates<Traits>(start_derivative),
      Geometric_continuity::coordinates<Traits>(end_derivative));
  for (const Coordinates<Traits>* x : {&d.first, &d.second}) {
    if (x->dimension() != p[0].dimension()) throw Error(Error_code::dimension_mismatch, "interpolate: a derivative");
    for (const typename Traits::FT& c : *x) internal::check_finite(c, "interpolate: a derivative");
  }
  return internal::interpolate_open(std::move(p), parameters, d);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural or closed cubic spline through points, with the parameters of
/// `interpolation_parameters()`. \f$ O(n) \f$
/// \throws Error as for given parameters, and as `interpolation_parameters()`
template <class Traits, class InputIterator>
Bspline_curve<Traits> interpolate(InputIterator first, InputIterator last,
                                  Parametrisation parametrisation = Parametrisation::chordal,
                                  Closure closure = Closure::open) {
  const std::vector<typename Traits::Point> p(first, last);
  if (p.size() < (closure == Closure::closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate: " + std::to_string(p.size()) + " points");
  return interpolate<Traits>(p.begin(), p.end(),
                             interpolation_parameters<Traits>(p.begin(), p.end(), parametrisation, closure), closure);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural or closed cubic spline through points at given parameters.
/// \throws Error as for the points between two iterators
template <class Traits>
Bspline_curve<Traits> interpolate(const std::vector<typename Traits::Point>& points,
                                  const std::vector<typename Traits::FT>& parameters, Closure closure = Closure::open) {
  return interpolate<Traits>(points.begin(), points.end(), parameters, closure);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the clamped cubic spline through points at given parameters.
/// \throws Error as for the points between two iterators
template <class Traits>
Bspline_curve<Traits>
interpolate(const std::vector<typename Traits::Point>& points, const std::vector<typename Traits::FT>& parameters,
            const typename Traits::Vector& start_derivative, const typename Traits::Vector& end_derivative) {
  return interpolate<Traits>(points.begin(), points.end(), parameters, start_derivative, end_derivative);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural or closed cubic spline through points, with the parameters of
/// `interpolation_parameters()`.
/// \throws Error as for the points between two iterators
template <class Traits>
Bspline_curve<Traits> interpolate(const std::vector<typename Traits::Point>& points, Parametrisation parametrisation,
                                  Closure closure = Closure::open) {
  return interpolate<Traits>(points.begin(), points.end(), parametrisation, closure);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural or closed cubic spline through points of a \cgal kernel, over whose traits
/// class (`Traits_of`) it is.
/// \throws Error as for the points between two iterators
template <class Point>
Bspline_curve<Traits_of<Point>> interpolate(const std::vector<Point>& points,
                                            Parametrisation parametrisation = Parametrisation::chordal,
                                            Closure closure = Closure::open) {
  return interpolate<Traits_of<Point>>(points.begin(), points.end(), parametrisation, closure);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural cubic spline through points of a \cgal kernel, with chordal parameters.
/// \throws Error as for a vector of points
template <class InputIterator>
Bspline_curve<Traits_of<typename std::iterator_traits<InputIterator>::value_type>> interpolate(InputIterator first,
                                                                                               InputIterator last) {
  typedef Traits_of<typename std::iterator_traits<InputIterator>::value_type> Traits;
  return interpolate<Traits>(first, last, Parametrisation::chordal);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERPOLATE_H
