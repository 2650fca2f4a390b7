// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Fair blends between curves that lead from one to the other, in the plane and in space, against
// OpenCASCADE's curve of minimal variation (in the plane, with the same tangents and curvatures at
// the ends) and against the same functional minimised by Eigen's Levenberg-Marquardt with numeric
// differences. The values of E are compared and printed before anything is timed.

#include "Ratio_table.h"
#include "measure.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <FairCurve_AnalysisCode.hxx>
#include <FairCurve_MinimalVariation.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <gp_Pnt2d.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Plane;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Space;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Exact;

namespace {

// The end of one cubic and the start of another, on a grid.
template <class Traits> struct Pair {
  GC::Curve_jet<Traits> phi, psi;

  explicit Pair(std::mt19937_64& random) : phi(jet(random, -3, true)), psi(jet(random, 2, false)) {}

private:
  static GC::Curve_jet<Traits> jet(std::mt19937_64& random, double from, bool at_end) {
    constexpr int N = Traits::Dimension::value;
    typedef typename Traits::FT FT;
    const auto number = [&] { return std::ldexp(static_cast<double>(random() >> 44), -19) - 1; };
    std::array<GC::Coordinate_vector<FT, N>, 4> p;
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < N; ++c) p[i][c] = FT(c == 0 ? from + i + 0.25 * number() : number());
    const GC::Bezier_curve<Traits, 3> curve(p);
    return at_end ? curve.end_jet(3) : curve.start_jet(3);
  }
};

template <class Traits> std::vector<Pair<Traits>> pairs(std::size_t count) {
  std::mt19937_64 random(2026);
  std::vector<Pair<Traits>> result;
  while (result.size() < count) result.emplace_back(random);
  return result;
}

// One with the median time: E is small enough that the first search is good enough.
const Pair<Plane>& typical(const std::vector<Pair<Plane>>& all) {
  std::vector<std::pair<double, std::size_t>> e;
  for (std::size_t i = 0; i < all.size(); ++i)
    e.emplace_back(GC::blend(all[i].phi, all[i].psi, GC::Fair()).report.fairness, i);
  std::sort(e.begin(), e.end());
  return all[e[e.size() / 2].second];
}

double cross(const GC::Coordinate_vector<double, 2>& x, const GC::Coordinate_vector<double, 2>& y) {
  return x[0] * y[1] - x[1] * y[0];
}

// dκ/ds, from the derivatives.
double slope_of_curvature(const GC::Curve_jet<Plane>& d) {
  const double g = dot(d[1], d[1]), v = std::sqrt(g);
  return (cross(d[1], d[3]) / (v * g) - 3 * cross(d[1], d[2]) * dot(d[1], d[2]) / (v * g * g)) / v;
}

// E of a curve on [0, 1] that gives jets, by many midpoints.
template <class Jet> double fairness_of_jets(const Jet& jet) {
  constexpr int nodes = 2000;
  double length = 0, integral = 0;
  for (int i = 0; i < nodes; ++i) {
    const GC::Curve_jet<Plane> d = jet((i + 0.5) / nodes);
    const double v = std::sqrt(dot(d[1], d[1])), slope = slope_of_curvature(d);
    length += v / nodes;
    integral += slope * slope * v / nodes;
  }
  return length * length * length * integral;
}
double fairness(const GC::Bezier_curve<Plane, 5>& gamma) {
  return fairness_of_jets([&gamma](double t) { return GC::Curve_jet<Plane>(gamma.jet(t, 3)); });
}

#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
// sqrt(L^3 ds) times dκ/ds at midpoints, as a function of log beta, log eta, s1, s2.
struct Residuals {
  typedef double Scalar;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  typedef Eigen::VectorXd InputType;
  typedef Eigen::VectorXd ValueType;
  typedef Eigen::MatrixXd JacobianType;

  const Pair<Plane>* pair;
  GC::Shape_parameters<double> shape;
  int nodes = 48;

  int inputs() const { return 4; }
  int values() const { return nodes; }

  GC::Quintic_blend<Plane> blend(const InputType& x) const {
    return GC::blend(pair->phi, pair->psi, GC::Given_parameters<double>{x[2], x[3]},
                     {shape.beta * std::exp(x[0]), shape.eta * std::exp(x[1])});
  }
  int operator()(const InputType& x, ValueType& f) const {
    const GC::Quintic_blend<Plane> gamma = blend(x);
    double length = 0;
    for (int i = 0; i < nodes; ++i) {
      const GC::Curve_jet<Plane> d = gamma.jet((i + 0.5) / nodes, 3);
      const double v = std::sqrt(dot(d[1], d[1]));
      length += v / nodes;
      f[i] = slope_of_curvature(d) * std::sqrt(v / nodes);
    }
    f *= std::sqrt(length * length * length);
    return 0;
  }
};

GC::Quintic_blend<Plane> minimise_by_eigen(const Pair<Plane>& pair) {
  const GC::Quintic_blend<Plane> automatic = GC::blend(pair.phi, pair.psi);
  Residuals residuals;
  residuals.pair = &pair;
  residuals.shape = automatic.shape;
  Eigen::NumericalDiff<Residuals> differences(residuals);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Residuals>> search(differences);
  search.parameters.ftol = search.parameters.xtol = 1e-3; // of E; as precise as Fair
  Eigen::VectorXd x(4);
  x << 0, 0, automatic.parameters.s1, automatic.parameters.s2;
  search.minimize(x);
  return residuals.blend(x);
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
// From (0,0) to (4,0) with the given angles and curvatures at the ends; the length is free.
Handle(Geom2d_BSplineCurve) occt_blend() {
  FairCurve_MinimalVariation curve(gp_Pnt2d(0, 0), gp_Pnt2d(4, 0), 1);
  curve.SetConstraintOrder1(2);
  curve.SetConstraintOrder2(2);
  curve.SetAngle1(0.3);
  curve.SetAngle2(0.3);
  curve.SetCurvature1(0.2);
  curve.SetCurvature2(0.1);
  curve.SetFreeSliding(true);
  FairCurve_AnalysisCode code;
  check(curve.Compute(code) && code == FairCurve_OK, "OpenCASCADE, blend");
  return curve.Curve();
}
GC::Curve_jet<Plane> occt_jet(const Geom2d_BSplineCurve& curve, double t) {
  const double a = curve.FirstParameter(), h = curve.LastParameter() - a;
  gp_Pnt2d p;
  gp_Vec2d d1, d2, d3;
  curve.D3(a + t * h, p, d1, d2, d3);
  GC::Curve_jet<Plane> jet(2, 3);
  for (int i = 0; i < 2; ++i) {
    jet[0][i] = p.Coord(i + 1);
    jet[1][i] = h * d1.Coord(i + 1);
    jet[2][i] = h * h * d2.Coord(i + 1);
    jet[3][i] = h * h * h * d3.Coord(i + 1);
  }
  return jet;
}
#endif

template <class Traits, class Strategy>
void time_blends(const char* name, const std::vector<Pair<Traits>>& all, Strategy s) {
  at_once(name, all.size(), [&all, s] {
    for (const Pair<Traits>& p : all) {
      auto gamma = GC::blend(p.phi, p.psi, s);
      benchmark::DoNotOptimize(gamma);
    }
  });
}

// The times of single blends, each the least of five: some pairs need one search, others several.
template <class Traits> void print_times(const char* name, const std::vector<Pair<Traits>>& all) {
  typedef std::chrono::duration<double, std::micro> Microseconds;
  std::vector<double> times;
  double sum = 0;
  for (const Pair<Traits>& p : all) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i) {
      const auto start = std::chrono::steady_clock::now();
      auto gamma = GC::blend(p.phi, p.psi, GC::Fair());
      benchmark::DoNotOptimize(gamma);
      least = (std::min)(least, Microseconds(std::chrono::steady_clock::now() - start).count());
    }
    times.push_back(least);
    sum += least;
  }
  std::sort(times.begin(), times.end());
  const std::size_t count = times.size();
  std::cerr << "Fair, " << count << " pairs " << name << ", microseconds: median " << times[count / 2] << ", mean "
            << sum / static_cast<double>(count) << ", 95 % " << times[count * 95 / 100] << ", most " << times.back()
            << '\n';
}

} // namespace

int main(int argc, char** argv) {
  static const std::vector<Pair<Plane>> plane = pairs<Plane>(200);
  static const std::vector<Pair<Space>> space = pairs<Space>(200);
  static const std::vector<Pair<Exact>> exact = pairs<Exact>(200);
  static const Pair<Plane> one = typical(plane);
  const auto fair = GC::blend(one.phi, one.psi, GC::Fair());
  check(fair.report.converged, "fair blend");
  std::cerr << "typical pair: E automatic " << fair.report.automatic_fairness << ", fair " << fairness(fair);
  at_once("fair blends, typical pair in the plane | blend(), Fair", 1, [] {
    auto gamma = GC::blend(one.phi, one.psi, GC::Fair());
    benchmark::DoNotOptimize(gamma);
  });
#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
  const double eigen = fairness(minimise_by_eigen(one));
  std::cerr << ", Eigen " << eigen;
  check(fairness(fair) <= 1.01 * eigen, "fair blend, against Eigen");
  at_once("fair blends, typical pair in the plane | Eigen, numeric differences", 1, [] {
    auto gamma = minimise_by_eigen(one);
    benchmark::DoNotOptimize(gamma);
  });
#endif
  std::cerr << '\n';
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  const Handle(Geom2d_BSplineCurve) occt = occt_blend();
  static const GC::Curve_jet<Plane> left = occt_jet(*occt, 0), right = occt_jet(*occt, 1);
  const double e = fairness(GC::blend(left, right, GC::Fair())),
               occt_e = fairness_of_jets([&occt](double t) { return occt_jet(*occt, t); });
  std::cerr << "ends of OpenCASCADE's curve: E fair " << e << ", OpenCASCADE " << occt_e << '\n';
  check(e <= 1.01 * occt_e, "fair blend, against OpenCASCADE");
  at_once("fair blends, ends of OpenCASCADE's curve | blend(), Fair", 1, [] {
    auto gamma = GC::blend(left, right, GC::Fair());
    benchmark::DoNotOptimize(gamma);
  });
  at_once("fair blends, ends of OpenCASCADE's curve | OpenCASCADE, FairCurve_MinimalVariation", 1,
          [] { occt_blend(); });
#endif
  print_times("in the plane", plane);
  print_times("in space", space);
  time_blends("fair blends, 200 pairs in the plane | blend(), least energy", plane, GC::Minimal_energy<3>());
  time_blends("fair blends, 200 pairs in the plane | blend(), Fair", plane, GC::Fair());
  time_blends("fair blends, 200 pairs in the plane | blend(), Fair_g3", plane, GC::Fair_g3());
  time_blends("fair blends, 200 pairs in the plane | blend(), Fair_f3", plane, GC::Fair_f3());
  time_blends("fair blends, 200 pairs in space | blend(), Fair", space, GC::Fair());
  time_blends("fair blends, 200 pairs in space | blend(), Fair_g3", space, GC::Fair_g3());
  time_blends("fair blends, 200 exact pairs in the plane | blend(), least energy", exact, GC::Minimal_energy<3>());
  time_blends("fair blends, 200 exact pairs in the plane | blend(), Fair", exact, GC::Fair());
  return run_benchmarks(argc, argv);
}
