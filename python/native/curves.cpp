// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "arrays.h"

#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>

namespace {

// Calls f(FT()) for the numbers in which is constructed.
template <class Function> auto in_field(Field_of_results field, Function f) {
  return field == Field_of_results::exact ? f(Exact()) : f(double());
}

GC::Closure closure(bool closed) { return closed ? GC::Closure::closed : GC::Closure::open; }

template <class Traits, class Curve> Curve_numbers numbers_of(const Curve& curve) {
  return {curve.degree(), array_of<Traits>(curve), array_of_numbers(curve.knots())};
}

template <class Traits, class Curve> Curve_numbers numbers_of_spline(const Curve& curve) {
  std::vector<typename Traits::FT> knots(curve.knots().begin(), curve.knots().end());
  return {curve.degree(), array_of<Traits>(curve), array_of_numbers(knots)};
}

} // namespace

std::optional<Excess_numbers> curvature_excess(const Numbers& given, const Numbers& weights, const Numbers& domain,
                                               const Exact& bound) {
  typedef Array_traits<Exact> Traits;
  const auto p = points<Traits>(given, "curvature_excess");
  const Exact a = number<Exact>(domain, 0), b = number<Exact>(domain, 1);
  const auto excess = [&](const auto& curve) -> std::optional<Excess_numbers> {
    const std::optional<GC::Curvature_excess> e = GC::curvature_excess(curve, bound);
    return e ? std::optional<Excess_numbers>({e->parameter, e->curvature, e->unbounded}) : std::nullopt;
  };
  if (weights.size() == 0) return excess(GC::Bezier_curve<Traits>(p.begin(), p.end(), a, b));
  typedef GC::Rational_bezier_curve<Traits> Curve;
  std::vector<typename Curve::Homogeneous::Point> rows;
  for (std::size_t j = 0; j < p.size(); ++j)
    rows.push_back(GC::homogeneous_point(GC::coordinates<Traits>(p[j]), number<Exact>(weights, j)));
  return excess(Curve(typename Curve::Homogeneous(rows.begin(), rows.end(), a, b)));
}

double fairness(const Numbers& x) { return GC::fairness(curve<Array_traits<double>>(x, "fairness")); }

Curve_numbers interpolate(const Numbers& given, bool closed, const std::string& parametrisation,
                          const Numbers& parameters, Field_of_results field) {
  return in_field(field, [&](auto zero) {
    typedef decltype(zero) FT;
    typedef Array_traits<FT> Traits;
    const auto p = points<Traits>(given, "interpolate");
    if (parameters.size() > 0) {
      std::vector<FT> u;
      for (std::size_t i = 0; i < parameters.size(); ++i) u.push_back(number<FT>(parameters, i));
      return numbers_of_spline<Traits>(GC::interpolate<Traits>(p.begin(), p.end(), u, closure(closed)));
    }
    for (const GC::Parametrisation kind :
         {GC::Parametrisation::uniform, GC::Parametrisation::chordal, GC::Parametrisation::centripetal})
      if (parametrisation == to_string(kind))
        return numbers_of_spline<Traits>(GC::interpolate<Traits>(p.begin(), p.end(), kind, closure(closed)));
    throw GC::Error(GC::Error_code::parameter_outside_domain,
                    "interpolate: '" + parametrisation + "' is none of uniform, chordal, centripetal");
  });
}

Fair_spline_numbers interpolate_fair(const Numbers& given, bool closed, Field_of_results field) {
  return in_field(field, [&](auto zero) {
    typedef Array_traits<decltype(zero)> Traits;
    const auto p = points<Traits>(given, "interpolate_fair");
    const auto spline = GC::interpolate_fair<Traits>(p.begin(), p.end(), closure(closed));
    return Fair_spline_numbers{numbers_of<Traits>(spline), Exact(spline.moved), spline.rounded};
  });
}

Fitted_numbers fit(const Numbers& given, const Exact& tolerance, int order, bool closed, double corner_angle,
                   Field_of_results field) {
  return in_field(field, [&](auto zero) {
    typedef decltype(zero) FT;
    typedef Array_traits<FT> Traits;
    const auto p = points<Traits>(given, "fit");
    FT bound;
    if constexpr (std::is_same_v<FT, double>)
      bound = nearest_double(tolerance);
    else
      bound = tolerance;
    const auto fitted = GC::fit<Traits>(p.begin(), p.end(), bound, closure(closed), order, corner_angle);
    return Fitted_numbers{numbers_of<Traits>(fitted), fitted.vertices, fitted.corners, fitted.distance};
  });
}
