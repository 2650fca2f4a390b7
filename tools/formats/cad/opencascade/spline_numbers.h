// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SPLINE_NUMBERS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SPLINE_NUMBERS_H

#include "formats/cad/opencascade/cad_curve.h"

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

// The coordinates of points and of directions.
inline GC::Cad_point<2> coordinates(const gp_XY& p) { return {p.X(), p.Y()}; }
inline GC::Cad_point<3> coordinates(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

// A number as it is, if it is finite.
inline double checked(double x) {
  if (!std::isfinite(x)) throw Not_covered("a number that is not finite");
  return x;
}

// A point as it is, if its coordinates are finite.
template <class Coordinates> auto checked(const Coordinates& p) {
  const auto point = coordinates(p);
  for (const double x : point) checked(x);
  return point;
}

// The knots of a spline in one direction, each as often as its multiplicity. With n control points
// of a period, control point i of the spline is number i mod n of the file.
struct Flat_knots {
  int degree;
  std::vector<double> knots;
  std::size_t points() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }
};

// Returns the knots of a spline that is not periodic, or of as many periods as its use needs, with
// the knots before and behind them that the first and the last span have.
inline Flat_knots flat_knots(int degree, bool periodic, const std::vector<double>& knots,
                             const std::vector<int>& multiplicities, const Used_range& used) {
  Flat_knots result{degree, {}};
  std::vector<double>& flat = result.knots;
  const std::size_t spans = knots.size() - 1, order = static_cast<std::size_t>(degree) + 1;
  const auto append = [&](double knot, std::size_t times) { flat.insert(flat.end(), times, checked(knot)); };
  const auto multiplicity = [&](std::size_t i) { return static_cast<std::size_t>(multiplicities[i]); };
  if (!periodic) {
    for (std::size_t i = 0; i <= spans; ++i) append(knots[i], multiplicity(i));
    return result;
  }
  const double period = knots[spans] - knots[0];
  const auto periods = [&](double parameter) { // before this parameter
    const double n = std::floor((checked(parameter) - knots[0]) / period);
    if (!(std::abs(n) < 1000)) throw Not_covered("a spline of so many periods");
    return static_cast<long>(n);
  };
  const double little = 1e-9 * period; // beyond which a curve leaves the period by rounding only
  const long first = (std::min)(periods(used.begin + little), 0L),
             last = (std::max)(periods(used.end - little), 0L) + 1;
  // Knot number i, counted from the first one of the period 0, without multiplicities.
  const long n = static_cast<long>(spans), begin = first * n, end = last * n;
  const auto period_of = [n](long i) { return i < 0 ? -((n - 1 - i) / n) : i / n; };
  const auto index = [&](long i) { return static_cast<std::size_t>(i - period_of(i) * n); };
  const auto append_knot = [&](long i) {
    const long p = period_of(i);
    const std::size_t k = index(i);
    append(i == n ? knots[spans] : p == 0 ? knots[k] : knots[k] + double(p) * period, multiplicity(k));
  };
  // knots up to the begin; the first span needs as many as the order says
  std::size_t before = multiplicity(0);
  long i = begin;
  while (before < order) before += multiplicity(index(--i));
  for (; i <= begin; ++i) append_knot(i);
  flat.erase(flat.begin(), flat.end() - static_cast<std::ptrdiff_t>(order));
  for (; i <= end; ++i) append_knot(i);
  const std::size_t needed = flat.size() - multiplicity(0) + order;
  for (; flat.size() < needed; ++i) append_knot(i);
  flat.resize(needed);
  return result;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SPLINE_NUMBERS_H
