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

#include <boost/iterator/transform_iterator.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
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
  const std::vector<typename Traits::Point> p(first, last);
  const int n = static_cast<int>(p.size()), spans = closure == Closure::closed ? n : n - 1;
  std::vector<FT> u(1, FT(0));
  u.reserve(n + 1);
  for (int i = 0; i < spans; ++i) {
    double distance = 1;
    if (parametrisation != Parametrisation::uniform) {
      const Coordinates<Traits> a = coordinates<Traits>(p[i]), b = coordinates<Traits>(p[(i + 1) % n]);
      if (a.dimension() != b.dimension())
        throw Error(Error_code::dimension_mismatch, "interpolation_parameters: point " + std::to_string(i + 1));
      double length = 0;
      for (int x = 0; x < a.dimension(); ++x) length = std::hypot(length, CGAL::to_double(FT(b[x] - a[x])));
      internal::check_finite(length, "interpolation_parameters: a distance");
      if (!(length > 0))
        throw Error(Error_code::empty_domain, "interpolation_parameters: the points " + std::to_string(i) + " and " +
                                                  std::to_string((i + 1) % n) + " coincide");
      distance = internal::short_double<10>(parametrisation == Parametrisation::chordal ? length : std::sqrt(length));
    }
    u.push_back(FT(u.back() + internal::short_number_in<FT>(distance)));
  }
  return u;
}

namespace internal {

// The equation a x_{i-1} + b x_i + c x_{i+1} = r for points x_0, x_1, ...
template <class FT, class Value> struct Tridiagonal_equation {
  FT a, b, c;
  Value r;
};

// Solves n of them, equation(i) for each i in turn, by elimination without a choice of pivots. In a cyclic system, a_0 belongs to the last
// unknown, and the last c to the first one; there are 3 equations at least.
template <class FT, class Value, class Equation>
std::vector<Value> solve_tridiagonal(std::size_t n, Equation equation, bool cyclic) {
  typedef Tridiagonal_equation<FT, Value> Row;
  std::vector<Value> x;              // the right sides, then the unknowns
  std::vector<FT> b, c, last_column; // what is left of the equations, but for the last
  x.reserve(n);
  b.reserve(n);
  c.reserve(n);
  Row last = equation(n - 1), row = equation(0);
  FT last_row = cyclic ? last.c : FT(0), in_last_column = cyclic ? row.a : FT(0); // in the columns i and n - 1
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const bool joins_last = i + 2 == n; // the unknown i + 1 is the last one
    work_meter().charge_fractions(4 + number_of_coordinates(row.r), number_words(row.b));
    Row next = joins_last ? last : equation(i + 1);
    if (cyclic && joins_last) {
      row.c += in_last_column;
      next.a += last_row;
    }
    const FT factor = FT(next.a / row.b);
    next.b -= factor * row.c;
    next.r -= factor * row.r;
    if (cyclic && !joins_last) {
      last_column.push_back(in_last_column);
      const FT factor_of_last = FT(last_row / row.b);
      last_row = FT(-factor_of_last * row.c);
      last.b -= factor_of_last * in_last_column;
      last.r -= factor_of_last * row.r;
      in_last_column = FT(-factor * in_last_column);
    }
    b.push_back(std::move(row.b));
    c.push_back(std::move(row.c));
    x.push_back(std::move(row.r));
    row = std::move(next);
  }
  x.push_back(row.r / row.b);
  for (std::size_t i = n - 1; i-- > 0;) {
    x[i] -= c[i] * x[i + 1];
    if (cyclic && i + 2 < n) x[i] -= last_column[i] * x[n - 1];
    x[i] /= b[i];
  }
  return x;
}

// The points as columns of one dimension, and the check of their parameters.
template <class Traits, class InputIterator>
std::vector<Coordinates<Traits>> points_to_interpolate(InputIterator first, InputIterator last,
                                                       const std::vector<typename Traits::FT>& u, Closure closure) {
  std::vector<Coordinates<Traits>> p;
  for (; first != last; ++first) p.push_back(coordinates<Traits>(*first));
  const bool closed = closure == Closure::closed;
  if (p.size() < (closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate: " + std::to_string(p.size()) + " points");
  if (u.size() != p.size() + (closed ? 1 : 0))
    throw Error(Error_code::wrong_number_of_points,
                "interpolate: " + std::to_string(u.size()) + " parameters for " + std::to_string(p.size()) + " points");
  for (const typename Traits::FT& x : u) check_finite(x, "interpolate: a parameter");
  for (std::size_t i = 1; i < u.size(); ++i)
    if (!(u[i - 1] < u[i]))
      throw Error(Error_code::empty_domain, "interpolate: the parameters " + std::to_string(i - 1) + " and " +
                                                std::to_string(i) + " do not increase");
  for (const Coordinates<Traits>& x : p) {
    if (x.dimension() != p[0].dimension()) throw Error(Error_code::dimension_mismatch, "interpolate: points");
    for (const typename Traits::FT& c : x) check_finite(c, "interpolate: a coordinate");
  }
  return p;
}

// The equation of the value r at the simple knot t_k.
template <class FT, class Value>
Tridiagonal_equation<FT, Value> value_at_knot(const Knot_vector<FT>& t, int k, const Value& r) {
  const FT h = t[k + 1] - t[k], g = t[k] - t[k - 1], length = h + g;
  const FT a = FT(h * h / FT(length * FT(t[k + 1] - t[k - 2]))), c = FT(g * g / FT(length * FT(t[k + 2] - t[k - 1])));
  return {a, FT(FT(1) - a - c), c, r};
}

template <class Traits>
Bspline_curve<Traits> spline_of(const std::vector<Coordinates<Traits>>& points,
                                const Knot_vector<typename Traits::FT>& knots) {
  const auto as_point = [](const Coordinates<Traits>& x) { return to_point<Traits>(x); };
  return Bspline_curve<Traits>(boost::make_transform_iterator(points.begin(), as_point),
                               boost::make_transform_iterator(points.end(), as_point), knots);
}

// An open curve, with the given derivatives at its ends, or with second derivatives that vanish.
template <class Traits>
Bspline_curve<Traits>
interpolate_open(const std::vector<Coordinates<Traits>>& p, const std::vector<typename Traits::FT>& u,
                 const std::optional<std::pair<Coordinates<Traits>, Coordinates<Traits>>>& derivatives) {
  typedef typename Traits::FT FT;
  typedef Tridiagonal_equation<FT, Coordinates<Traits>> Equation;
  const Work_on_object work("interpolate");
  std::vector<typename Knot_vector<FT>::Knot> inner;
  inner.reserve(u.size());
  for (std::size_t i = 1; i + 1 < u.size(); ++i) inner.push_back({u[i], 1});
  const Knot_vector<FT> t(3, u.front(), u.back(), inner);
  const int n = static_cast<int>(p.size());
  const FT zero(0), one(1), third = FT(FT(1) / FT(3));
  const Coordinates<Traits> nothing(p[0].dimension());
  const FT h = u[1] - u[0],
           g = u[n - 1] - u[n - 2]; // S' = 3 (b_1 - b_0) / h, and S'' = 0 is h (b_2 - b_1) = h2 (b_1 - b_0)
  const FT h2 = t[5] - t[3], g2 = t[n + 2] - t[n];
  const auto equation = [&](std::size_t i) -> Equation {
    const int k = static_cast<int>(i);
    if (k == 0) return {zero, one, zero, p[0]};
    if (k == n + 1) return {zero, one, zero, p[n - 1]};
    if (1 < k && k < n) return value_at_knot(t, k + 2, p[k - 1]);
    if (derivatives)
      return {zero, one, zero,
              k == 1 ? p[0] + FT(h * third) * derivatives->first : p[n - 1] - FT(g * third) * derivatives->second};
    return k == 1 ? Equation{h2, FT(-h - h2), h, nothing} : Equation{g, FT(-g - g2), g2, nothing};
  };
  return spline_of<Traits>(solve_tridiagonal<FT, Coordinates<Traits>>(p.size() + 2, equation, false), t);
}

template <class Traits>
Bspline_curve<Traits> interpolate_closed(const std::vector<Coordinates<Traits>>& p,
                                         const std::vector<typename Traits::FT>& u) {
  typedef typename Traits::FT FT;
  const Work_on_object work("interpolate");
  const int n = static_cast<int>(p.size());
  const FT period = u[n] - u[0];
  std::vector<FT> knots; // three periods of u, as far as splines on [u_0, u_n] need them
  for (int i = -3; i <= n + 3; ++i)
    knots.push_back(i < 0 ? FT(u[n + i] - period) : i > n ? FT(u[i - n] + period) : u[i]);
  const Knot_vector<FT> t(3, std::move(knots));
  const auto equation = [&](std::size_t i) { return value_at_knot(t, static_cast<int>(i) + 3, p[i]); };
  const std::vector<Coordinates<Traits>> x = // x_i is the control point i + 1
      solve_tridiagonal<FT, Coordinates<Traits>>(p.size(), equation, true);
  std::vector<Coordinates<Traits>> b;
  for (int i = 0; i < n + 3; ++i) b.push_back(x[(i + n - 1) % n]);
  return spline_of<Traits>(b, t);
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
  const std::vector<Coordinates<Traits>> p = internal::points_to_interpolate<Traits>(first, last, parameters, closure);
  return closure == Closure::closed ? internal::interpolate_closed<Traits>(p, parameters)
                                    : internal::interpolate_open<Traits>(p, parameters, std::nullopt);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the \em clamped cubic spline through points at given parameters, \f$ C^2 \f$ inside, with the given first derivatives at both
/// ends. Of the points of a cubic polynomial and its derivatives, it is that polynomial. \f$ O(n) \f$
/// \throws Error as for a natural spline
template <class Traits, class InputIterator>
Bspline_curve<Traits>
interpolate(InputIterator first, InputIterator last, const std::vector<typename Traits::FT>& parameters,
            const typename Traits::Vector& start_derivative, const typename Traits::Vector& end_derivative) {
  const std::vector<Coordinates<Traits>> p =
      internal::points_to_interpolate<Traits>(first, last, parameters, Closure::open);
  const std::pair<Coordinates<Traits>, Coordinates<Traits>> d(coordinates<Traits>(start_derivative),
                                                              coordinates<Traits>(end_derivative));
  for (const Coordinates<Traits>* x : {&d.first, &d.second}) {
    if (x->dimension() != p[0].dimension()) throw Error(Error_code::dimension_mismatch, "interpolate: a derivative");
    for (const typename Traits::FT& c : *x) internal::check_finite(c, "interpolate: a derivative");
  }
  return internal::interpolate_open<Traits>(p, parameters, d);
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
