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

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file interpolate.h
/// Cubic B-spline curves through points, \f$ C^2 \f$ with the parameters of the points as simple knots.
/// \cgalCite{Boor-78}
///
/// At the parameter \f$ u_i \f$ three basis functions are not zero, with the values
/// \f[ \frac{(u_{i+1} - u_i)^2}{(u_{i+1} - u_{i-1})(u_{i+1} - u_{i-2})}, \quad 1 - \dots, \quad
///     \frac{(u_i - u_{i-1})^2}{(u_{i+1} - u_{i-1})(u_{i+2} - u_{i-1})}. \f]
/// The matrix of these values is totally positive: elimination needs no other pivots than those of its diagonal, and no root.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// How the parameters of points are chosen through which a curve runs.
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
/// Returns parameters for points, from 0 on; for a closed curve one more, at which it is back at the first point. Distances and their
/// roots are rounded to 10 binary digits, so that the parameters are short numbers in every field. Any increasing numbers are as good
/// for `interpolate()`. \f$ O(n) \f$
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \throws Error `empty_domain` when two consecutive points coincide (not if uniform), `dimension_mismatch`, `not_finite` when a
///   distance is not in the range of floating-point numbers
template <class Traits, class InputIterator>
std::vector<typename Traits::FT> interpolation_parameters(InputIterator first, InputIterator last,
                                                          Parametrisation parametrisation,
                                                          Closure closure = Closure::open) {
  typedef typename Traits::FT FT;
  std::vector<FT> u(1, FT(0));
  if (first == last) return u;
  const Coordinates<Traits> start = coordinates<Traits>(*first);
  Coordinates<Traits> a = start;
  for (bool is_last = false; !is_last;) {
    is_last = ++first == last;
    if (is_last && closure == Closure::open) break;
    const Coordinates<Traits> b = is_last ? start : coordinates<Traits>(*first);
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

// Solves the equations row(i) of n unknowns, for each i in turn, in the place of the right sides: get(i) returns one or the other, and
// set(i, x) takes what is found. In the first row a is not read, in the last one c.
template <class FT, class Row, class Get, class Set> void solve_tridiagonal(int n, Row row, Get get, Set set) {
  typedef std::decay_t<decltype(get(0))> Value;
  std::vector<FT> c; // x_i + c_i x_{i+1} = what is left of the right side
  c.reserve(n);
  for (int i = 0; i < n; ++i) {
    Tridiagonal_row<FT> r = row(i);
    Value x = get(i);
    if constexpr (!std::is_floating_point_v<FT>)
      work_meter().charge_fractions(4 + number_of_coordinates(x), number_words(r.b));
    if (i > 0) {
      r.b -= r.a * c.back();
      x -= r.a * get(i - 1);
    }
    const FT inverse = FT(FT(1) / r.b);
    x *= inverse;
    c.push_back(FT(inverse * r.c));
    set(i, x);
  }
  for (int i = n - 2; i >= 0; --i) set(i, get(i) - c[i] * get(i + 1));
}

// The same for a cyclic system of 3 unknowns or more: in the first row, a belongs to the last unknown, in the last row c to the first
// one. The others are y_i - z_i x_{n-1}, where y and z solve the equations without the last unknown.
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

// The points, the first and the last one twice, and the check of their parameters.
template <class Traits, class InputIterator>
std::vector<typename Traits::Point> points_to_interpolate(InputIterator first, InputIterator last,
                                                          const std::vector<typename Traits::FT>& u, Closure closure) {
  const bool closed = closure == Closure::closed;
  std::vector<typename Traits::Point> p;
  p.reserve(u.size() + 2);
  for (; first != last; ++first) {
    p.push_back(*first);
    const Coordinates<Traits> x = coordinates<Traits>(p.back());
    if (p.size() == 1) p.push_back(p.back());
    if (x.dimension() != coordinates<Traits>(p[0]).dimension())
      throw Error(Error_code::dimension_mismatch, "interpolate: points");
    for (const typename Traits::FT& c : x) check_finite(c, "interpolate: a coordinate");
  }
  const std::size_t n = p.empty() ? 0 : p.size() - 1;
  if (n < (closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate: " + std::to_string(n) + " points");
  if (u.size() != n + (closed ? 1 : 0))
    throw Error(Error_code::wrong_number_of_points,
                "interpolate: " + std::to_string(u.size()) + " parameters for " + std::to_string(n) + " points");
  for (const typename Traits::FT& x : u) check_finite(x, "interpolate: a parameter");
  for (std::size_t i = 1; i < u.size(); ++i)
    if (!(u[i - 1] < u[i]))
      throw Error(Error_code::empty_domain, "interpolate: the parameters " + std::to_string(i - 1) + " and " +
                                                std::to_string(i) + " do not increase");
  p.push_back(p.back());
  return p;
}

// The equation of the value at the simple knot t_k.
template <class FT> Tridiagonal_row<FT> value_at_knot(const Knot_vector<FT>& t, int k) {
  const FT h = t[k + 1] - t[k], g = t[k] - t[k - 1], length = h + g;
  const FT a = FT(h * h / FT(length * FT(t[k + 1] - t[k - 2]))), c = FT(g * g / FT(length * FT(t[k + 2] - t[k - 1])));
  return {a, FT(FT(1) - a - c), c};
}

// The points of an open curve become its control points. It has the given derivatives at its ends, or second derivatives that vanish.
template <class Traits>
Bspline_curve<Traits>
interpolate_open(std::vector<typename Traits::Point> b, const std::vector<typename Traits::FT>& u,
                 const std::optional<std::pair<Coordinates<Traits>, Coordinates<Traits>>>& derivatives) {
  typedef typename Traits::FT FT;
  const Work_on_object work("interpolate");
  const int n = static_cast<int>(u.size());
  std::vector<FT> knots;
  knots.reserve(n + 6);
  knots.insert(knots.end(), 3, u.front());
  knots.insert(knots.end(), u.begin(), u.end());
  knots.insert(knots.end(), 3, u.back());
  Knot_vector<FT> t(3, std::move(knots));
  const auto get = [&](int i) { return coordinates<Traits>(b[i + 1]); };
  const auto set = [&](int i, const Coordinates<Traits>& x) { b[i + 1] = to_point<Traits>(x); };
  const FT h = u[1] - u[0], g = u[n - 1] - u[n - 2], h2 = t[5] - t[3], g2 = t[n + 2] - t[n];
  Tridiagonal_row<FT> first{FT(0), FT(1), FT(0)}, last = first;
  if (derivatives) { // S' = 3 (b_1 - b_0) / h
    const FT third = FT(FT(1) / FT(3));
    set(0, get(0) + FT(h * third) * derivatives->first);
    set(n - 1, get(n - 1) - FT(g * third) * derivatives->second);
  } else { // S'' = 0 is h (b_2 - b_1) = h2 (b_1 - b_0)
    first = {FT(0), FT(h + h2), FT(-h)};
    last = {FT(-g), FT(g + g2), FT(0)};
    set(0, h2 * get(0));
    set(n - 1, g2 * get(n - 1));
  }
  const auto row = [&](int i) { return i == 0 ? first : i == n - 1 ? last : value_at_knot(t, i + 3); };
  solve_tridiagonal<FT>(n, row, get, set);
  return Bspline_curve<Traits>(std::move(b), std::move(t));
}

template <class Traits>
Bspline_curve<Traits> interpolate_closed(std::vector<typename Traits::Point> b,
                                         const std::vector<typename Traits::FT>& u) {
  typedef typename Traits::FT FT;
  const Work_on_object work("interpolate");
  const int n = static_cast<int>(u.size()) - 1;
  const FT period = u[n] - u[0];
  std::vector<FT> knots; // three periods of u, as far as splines on [u_0, u_n] need them
  knots.reserve(n + 7);
  for (int i = -3; i <= n + 3; ++i)
    knots.push_back(i < 0 ? FT(u[n + i] - period) : i > n ? FT(u[i - n] + period) : u[i]);
  Knot_vector<FT> t(3, std::move(knots));
  solve_cyclic<FT>(
      n, [&](int i) { return value_at_knot(t, i + 3); }, [&](int i) { return coordinates<Traits>(b[i + 1]); },
      [&](int i, const Coordinates<Traits>& x) { b[i + 1] = to_point<Traits>(x); });
  b[0] = b[n];
  b[n + 1] = b[1];
  b.push_back(b[2]);
  return Bspline_curve<Traits>(std::move(b), std::move(t));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the cubic spline through points at given parameters, \f$ C^2 \f$ inside: an open one is \em natural, with second derivatives
/// that vanish at both ends; a closed one returns to the first point at one more parameter and is \f$ C^2 \f$ there, too, over periodic
/// knots that are not clamped. With an exact kernel it is exact. \f$ O(n) \f$ operations; exact numbers become longer from point to
/// point.
/// \param first, last the points
/// \param parameters one for each point, increasing; for a closed curve one more, at which it is back at the first point
/// \param closure whether the curve is closed
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \throws Error `wrong_number_of_points` for fewer than 2 points, or 3 if closed, and for another number of parameters; `empty_domain`
///   unless the parameters increase; `dimension_mismatch`; `not_finite` also when floating-point numbers overflow; `work_limit`
template <class Traits, class InputIterator>
Bspline_curve<Traits> interpolate(InputIterator first, InputIterator last,
                                  const std::vector<typename Traits::FT>& parameters, Closure closure = Closure::open) {
  std::vector<typename Traits::Point> p = internal::points_to_interpolate<Traits>(first, last, parameters, closure);
  return closure == Closure::closed ? internal::interpolate_closed<Traits>(std::move(p), parameters)
                                    : internal::interpolate_open<Traits>(std::move(p), parameters, std::nullopt);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the \em clamped cubic spline through points at given parameters, \f$ C^2 \f$ inside, with the given first derivatives at both
/// ends. Of the points of a cubic polynomial and its derivatives, it is that polynomial. \f$ O(n) \f$
/// \throws Error as for a natural spline
template <class Traits, class InputIterator>
Bspline_curve<Traits>
interpolate(InputIterator first, InputIterator last, const std::vector<typename Traits::FT>& parameters,
            const typename Traits::Vector& start_derivative, const typename Traits::Vector& end_derivative) {
  std::vector<typename Traits::Point> p =
      internal::points_to_interpolate<Traits>(first, last, parameters, Closure::open);
  const std::pair<Coordinates<Traits>, Coordinates<Traits>> d(coordinates<Traits>(start_derivative),
                                                              coordinates<Traits>(end_derivative));
  for (const Coordinates<Traits>* x : {&d.first, &d.second}) {
    if (x->dimension() != coordinates<Traits>(p[0]).dimension())
      throw Error(Error_code::dimension_mismatch, "interpolate: a derivative");
    for (const typename Traits::FT& c : *x) internal::check_finite(c, "interpolate: a derivative");
  }
  return internal::interpolate_open<Traits>(std::move(p), parameters, d);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural or closed cubic spline through points, with the parameters of `interpolation_parameters()`. \f$ O(n) \f$
/// \throws Error as for given parameters, and as `interpolation_parameters()`
template <class Traits, class InputIterator>
Bspline_curve<Traits> interpolate(InputIterator first, InputIterator last, Parametrisation parametrisation,
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
/// Returns the natural or closed cubic spline through points, with the parameters of `interpolation_parameters()`.
/// \throws Error as for the points between two iterators
template <class Traits>
Bspline_curve<Traits> interpolate(const std::vector<typename Traits::Point>& points, Parametrisation parametrisation,
                                  Closure closure = Closure::open) {
  return interpolate<Traits>(points.begin(), points.end(), parametrisation, closure);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the natural or closed cubic spline through points of a \cgal kernel, over whose traits class (`Traits_of`) it is.
/// \throws Error as for the points between two iterators
template <class Point>
Bspline_curve<Traits_of<Point>> interpolate(const std::vector<Point>& points,
                                            Parametrisation parametrisation = Parametrisation::chordal,
                                            Closure closure = Closure::open) {
  return interpolate<Traits_of<Point>>(points.begin(), points.end(), parametrisation, closure);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERPOLATE_H
