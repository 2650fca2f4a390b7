// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curves through and near many points: natural cubic splines against elimination written by hand for just that, against a sparse
// solver of Eigen's, and against OpenCASCADE, where they were found; and fits of polylines against OpenCASCADE's. What the results
// are worth is printed before anything is timed: how far they are from the points, and how smooth.

#include "Ratio_table.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
#include <Eigen/SparseLU>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Bspline_curve<Traits> Curve;
typedef Traits::Point Point;

namespace {

void check(bool good, const std::string& what) {
  if (good) return;
  std::cerr << "wrong result: " << what << '\n';
  std::exit(1);
}

// Along a curve with bends of many sizes, about as many for each thousand points.
std::vector<Point> points_of(int n) {
  std::vector<Point> p;
  for (int i = 0; i < n; ++i) {
    const double t = 0.01 * i;
    p.emplace_back(t + .3 * std::sin(3 * t), 2 * std::sin(t) + .1 * std::cos(7 * t), .5 * std::sin(.3 * t));
  }
  return p;
}

// The control points of the natural spline, by elimination on arrays of numbers, without any check.
std::vector<std::array<double, 3>> by_hand(const std::vector<Point>& p, const std::vector<double>& u) {
  const int n = static_cast<int>(p.size());
  std::vector<std::array<double, 3>> x(n + 2);
  std::vector<double> upper(n + 2);
  const auto knot = [&](int i) { return u[(std::min)((std::max)(i, 0), n - 1)]; };
  const auto row = [&](int i, double a, double b, double c, const std::array<double, 3>& r) {
    const double pivot = 1 / (i == 0 ? b : b - a * upper[i - 1]);
    upper[i] = c * pivot;
    for (int k = 0; k < 3; ++k) x[i][k] = (r[k] - (i == 0 ? 0 : a * x[i - 1][k])) * pivot;
  };
  row(0, 0, 1, 0, {p[0].x(), p[0].y(), p[0].z()});
  const double h = u[1] - u[0], h2 = knot(2) - u[0];
  row(1, h2, -h - h2, h, {0, 0, 0});
  for (int i = 1; i + 1 < n; ++i) {
    const double next = u[i + 1] - u[i], last = u[i] - u[i - 1], both = next + last,
                 a = next * next / (both * (u[i + 1] - knot(i - 2))),
                 c = last * last / (both * (knot(i + 2) - u[i - 1]));
    row(i + 1, a, 1 - a - c, c, {p[i].x(), p[i].y(), p[i].z()});
  }
  const double g = u[n - 1] - u[n - 2], g2 = u[n - 1] - knot(n - 3);
  row(n, g, -g - g2, g2, {0, 0, 0});
  row(n + 1, 0, 1, 0, {p[n - 1].x(), p[n - 1].y(), p[n - 1].z()});
  for (int i = n; i >= 0; --i)
    for (int k = 0; k < 3; ++k) x[i][k] -= upper[i] * x[i + 1][k];
  return x;
}

#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
// The same by a general solver for sparse matrices.
Eigen::MatrixXd by_eigen(const std::vector<Point>& p, const std::vector<double>& u) {
  const int n = static_cast<int>(p.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * n + 4);
  Eigen::MatrixXd r = Eigen::MatrixXd::Zero(n + 2, 3);
  const auto knot = [&](int i) { return u[(std::min)((std::max)(i, 0), n - 1)]; };
  const auto row = [&](int i, double a, double b, double c) {
    if (i > 0) entries.emplace_back(i, i - 1, a);
    entries.emplace_back(i, i, b);
    if (i < n + 1) entries.emplace_back(i, i + 1, c);
  };
  const auto right = [&](int i, const Point& q) { r.row(i) << q.x(), q.y(), q.z(); };
  row(0, 0, 1, 0);
  right(0, p[0]);
  const double h = u[1] - u[0], h2 = knot(2) - u[0], g = u[n - 1] - u[n - 2], g2 = u[n - 1] - knot(n - 3);
  row(1, h2, -h - h2, h);
  for (int i = 1; i + 1 < n; ++i) {
    const double next = u[i + 1] - u[i], last = u[i] - u[i - 1], both = next + last,
                 a = next * next / (both * (u[i + 1] - knot(i - 2))),
                 c = last * last / (both * (knot(i + 2) - u[i - 1]));
    row(i + 1, a, 1 - a - c, c);
    right(i + 1, p[i]);
  }
  row(n, g, -g - g2, g2);
  row(n + 1, 0, 1, 0);
  right(n + 1, p[n - 1]);
  Eigen::SparseMatrix<double> matrix(n + 2, n + 2);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> solver(matrix);
  return solver.solve(r);
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
Handle(Geom_BSplineCurve) occt_interpolate(const std::vector<Point>& p) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, static_cast<int>(p.size()));
  for (std::size_t i = 0; i < p.size(); ++i)
    points->SetValue(static_cast<int>(i) + 1, gp_Pnt(p[i].x(), p[i].y(), p[i].z()));
  GeomAPI_Interpolate interpolation(points, Standard_False, 1e-9);
  interpolation.Perform();
  return interpolation.Curve();
}
Handle(Geom_BSplineCurve) occt_fit(const std::vector<Point>& p, double tolerance, GeomAbs_Shape order) {
  TColgp_Array1OfPnt points(1, static_cast<int>(p.size()));
  for (std::size_t i = 0; i < p.size(); ++i) points(static_cast<int>(i) + 1) = gp_Pnt(p[i].x(), p[i].y(), p[i].z());
  return GeomAPI_PointsToBSpline(points, 3, 5, order, tolerance).Curve();
}
// The largest distance of the points from the chords between many points of a curve that runs by them in their order.
double distance(const std::vector<Point>& p, const Handle(Geom_BSplineCurve) & curve) {
  const int samples = 40 * static_cast<int>(p.size());
  const double a = curve->FirstParameter(), b = curve->LastParameter();
  std::vector<gp_XYZ> x;
  for (int i = 0; i <= samples; ++i) x.push_back(curve->Value(a + (b - a) * i / samples).XYZ());
  double worst = 0;
  std::size_t at = 0; // the chord from here on is the nearest one
  for (const Point& q : p) {
    double least = -1;
    for (std::size_t i = at; i < (std::min)(at + 400, x.size() - 1); ++i) {
      const gp_XYZ chord = x[i + 1] - x[i], to_point = gp_XYZ(q.x(), q.y(), q.z()) - x[i];
      const double t = (std::min)((std::max)(to_point.Dot(chord) / chord.SquareModulus(), 0.), 1.),
                   d = (to_point - chord * t).Modulus();
      if (0 <= least && least <= d) continue;
      least = d;
      at = i;
    }
    worst = (std::max)(worst, least);
  }
  return worst;
}
#endif

template <class Work> void timed(const std::string& name, std::size_t points, Work work) {
  benchmark::RegisterBenchmark(name.c_str(), [work, points](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(work());
    state.SetItemsProcessed(static_cast<std::int64_t>(points) * state.iterations());
  });
}

void register_interpolation(int n) {
  const auto p = std::make_shared<std::vector<Point>>(points_of(n));
  const auto u = std::make_shared<std::vector<double>>(
      GC::interpolation_parameters<Traits>(p->begin(), p->end(), GC::Parametrisation::chordal));
  const std::string work = "natural cubic spline through " + std::to_string(n) + " points in space, for each | ";
  const Curve curve = GC::interpolate<Traits>(p->begin(), p->end(), *u);
  const std::vector<std::array<double, 3>> x = by_hand(*p, *u);
  for (int i = 0; i < n + 2; ++i)
    for (int k = 0; k < 3; ++k) check(std::abs(curve.control_point(i)[k] - x[i][k]) < 1e-7, work);
  timed(work + "elimination by hand", n, [p, u] { return by_hand(*p, *u); });
  timed(work + "interpolate", n, [p, u] { return GC::interpolate<Traits>(p->begin(), p->end(), *u); });
#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
  const Eigen::MatrixXd y = by_eigen(*p, *u);
  for (int i = 0; i < n + 2; ++i)
    for (int k = 0; k < 3; ++k) check(std::abs(y(i, k) - x[i][k]) < 1e-7, work);
  timed(work + "Eigen's SparseLU", n, [p, u] { return by_eigen(*p, *u); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  if (n > 1000) return; // its matrix is not sparse
  std::cout << "OpenCASCADE's interpolation of " << n << " points: distance from the points "
            << distance(*p, occt_interpolate(*p)) << '\n';
  timed(work + "OpenCASCADE's GeomAPI_Interpolate", n, [p] { return occt_interpolate(*p); });
#endif
}

void register_fit(int n, double tolerance) {
  const auto p = std::make_shared<std::vector<Point>>(points_of(n));
  std::string work = "curves near a polyline with " + std::to_string(n) + " vertices, tolerance " +
                     std::to_string(tolerance).substr(0, 6) + ", for each | ";
  for (const int order : {1, 2}) {
    const auto fit = [p, tolerance, order] {
      return GC::fit<Traits>(p->begin(), p->end(), tolerance, GC::Closure::open, order);
    };
    const GC::Fitted_curve<Traits> curve = fit();
    check(curve.distance <= tolerance, work);
    std::cout << work << "fit, G" << order << ": " << curve.number_of_segments() << " curves, proved to be within "
              << curve.distance << ", joins exactly G" << order << '\n';
    timed(work + "fit, G" + std::to_string(order), n, fit);
  }
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  if (n > 1000) return;
  for (const auto& [order, name] : {std::pair(GeomAbs_C1, "C1"), std::pair(GeomAbs_C2, "C2")}) {
    const auto fit = [p, tolerance, order = order] { return occt_fit(*p, tolerance, order); };
    const Handle(Geom_BSplineCurve) curve = fit();
    std::cout << work << "OpenCASCADE, " << name << ": " << curve->NbKnots() - 1 << " curves of degree "
              << curve->Degree() << ", distance from the points " << distance(*p, curve) << ", continuity "
              << curve->Continuity() << " of GeomAbs_Shape\n";
    timed(work + "OpenCASCADE's GeomAPI_PointsToBSpline, " + name, n, fit);
  }
#endif
}

void register_fair(int n) {
  const std::vector<Point> dense = points_of(20 * n);
  const auto p = std::make_shared<std::vector<Point>>();
  for (int i = 0; i < n; ++i) p->push_back(dense[20 * i]);
  timed("fair spline through " + std::to_string(n) + " points in space, for each | interpolate_fair", n,
        [p] { return GC::interpolate_fair<Traits>(p->begin(), p->end()); });
}

} // namespace

int main(int argc, char** argv) {
  for (const int n : {1000, 100000, 1000000}) register_interpolation(n);
  for (const int n : {1000, 100000}) register_fit(n, 0.01);
  register_fair(1000);
  return run_benchmarks(argc, argv);
}
