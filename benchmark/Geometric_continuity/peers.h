// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_PEERS_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_PEERS_H

// Rational B-spline curves and surfaces of doubles in space, as OpenCASCADE and SISL store them.
// The knots are clamped.

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <sisl.h>
#endif

#include <memory>
#include <vector>

namespace peers {

namespace GC = CGAL::Geometric_continuity;

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
// The different knots and how often each occurs.
struct Occt_knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;

  explicit Occt_knots(const GC::Knot_vector<double>& knots)
      : values(1, number(knots)), multiplicities(1, number(knots)) {
    int at = 0;
    const double* last = nullptr;
    for (const double& u : knots) {
      if (!last || *last != u) {
        values.SetValue(++at, u);
        multiplicities.SetValue(at, 0);
      }
      multiplicities.ChangeValue(at) += 1;
      last = &u;
    }
  }

private:
  static int number(const GC::Knot_vector<double>& knots) {
    int n = 0;
    const double* last = nullptr;
    for (const double& u : knots) {
      n += !last || *last != u;
      last = &u;
    }
    return n;
  }
};

template <class Point> gp_Pnt occt_point(const Point& p) { return gp_Pnt(p.x(), p.y(), p.z()); }

template <class Traits> Handle(Geom_BSplineCurve) occt_curve(const GC::Rational_bspline_curve<Traits>& c) {
  TColgp_Array1OfPnt poles(1, c.number_of_points());
  TColStd_Array1OfReal weights(1, c.number_of_points());
  for (int i = 0; i < c.number_of_points(); ++i) {
    poles.SetValue(i + 1, occt_point(c.control_point(i)));
    weights.SetValue(i + 1, c.weight(i));
  }
  const Occt_knots knots(c.knots());
  return new Geom_BSplineCurve(poles, weights, knots.values, knots.multiplicities, c.degree());
}

template <class Traits> Handle(Geom_BSplineSurface) occt_surface(const GC::Rational_bspline_surface<Traits>& s) {
  TColgp_Array2OfPnt poles(1, s.number_of_points_u(), 1, s.number_of_points_v());
  TColStd_Array2OfReal weights(1, s.number_of_points_u(), 1, s.number_of_points_v());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      poles.SetValue(i + 1, j + 1, occt_point(s.control_point(i, j)));
      weights.SetValue(i + 1, j + 1, s.weight(i, j));
    }
  const Occt_knots u(s.knots_u()), v(s.knots_v());
  return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities, v.multiplicities, s.degree_u(),
                                 s.degree_v());
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
struct Free {
  void operator()(SISLCurve* c) const { freeCurve(c); }
  void operator()(SISLSurf* s) const { freeSurf(s); }
};
typedef std::unique_ptr<SISLCurve, Free> Sisl_curve;
typedef std::unique_ptr<SISLSurf, Free> Sisl_surface;

template <class Point> void add_homogeneous_point(const Point& p, double w, std::vector<double>& numbers) {
  for (double x : {w * p.x(), w * p.y(), w * p.z(), w}) numbers.push_back(x);
}

// SISL copies what it is given.
template <class Traits> Sisl_curve sisl_curve(const GC::Rational_bspline_curve<Traits>& c) {
  std::vector<double> knots(c.knots().begin(), c.knots().end()), numbers;
  for (int i = 0; i < c.number_of_points(); ++i) add_homogeneous_point(c.control_point(i), c.weight(i), numbers);
  return Sisl_curve(newCurve(c.number_of_points(), c.degree() + 1, knots.data(), numbers.data(), 2, 3, 1));
}

template <class Traits> Sisl_surface sisl_surface(const GC::Rational_bspline_surface<Traits>& s) {
  std::vector<double> u(s.knots_u().begin(), s.knots_u().end()), v(s.knots_v().begin(), s.knots_v().end()), numbers;
  for (int j = 0; j < s.number_of_points_v(); ++j)
    for (int i = 0; i < s.number_of_points_u(); ++i)
      add_homogeneous_point(s.control_point(i, j), s.weight(i, j), numbers);
  return Sisl_surface(newSurf(s.number_of_points_u(), s.number_of_points_v(), s.degree_u() + 1, s.degree_v() + 1,
                              u.data(), v.data(), numbers.data(), 2, 3, 1));
}
#endif

} // namespace peers

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_PEERS_H
