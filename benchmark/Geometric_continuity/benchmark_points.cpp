// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curves through and near many points: natural cubic splines against elimination written by hand
// for just that, against FITPACK's method, against Eigen and OpenCASCADE, where they were found;
// and fits of polylines against OpenCASCADE's. What the results are worth is printed before
// anything is timed: how far they are from the points, and how smooth.

#include "Ratio_table.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
#include <Eigen/SparseLU>
#include <unsupported/Eigen/Splines>
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

// Along a curve with bends of many sizes, about as many for each thousand points.
std::vector<Point> points_of(int n) {
  std::vector<Point> p;
  for (int i = 0; i < n; ++i) {
    const double t = 0.01 * i;
    p.emplace_back(t + .3 * std::sin(3 * t), 2 * std::sin(t) + .1 * std::cos(7 * t), .5 * std::sin(.3 * t));
  }
  return p;
}

// The equations of the control points of the natural spline: row(i, a, b, c, x, y, z) for a b_i-1 +
// b b_i + c b_i+1 = (x, y, z).
template <class Row> void for_equations(const std::vector<Point>& p, const std::vector<double>& u, Row row) {
  const int n = static_cast<int>(p.size());
  const auto knot = [&](int i) { return u[(std::min)((std::max)(i, 0), n - 1)]; };
  row(0, 0., 1., 0., p[0].x(), p[0].y(), p[0].z());
  const double h = u[1] - u[0], h2 = knot(2) - u[0];
  row(1, h2, -h - h2, h, 0., 0., 0.);
  for (int i = 1; i + 1 < n; ++i) {
    const double next = u[i + 1] - u[i], last = u[i] - u[i - 1], both = next + last,
                 a = next * next / (both * (u[i + 1] - knot(i - 2))),
                 c = last * last / (both * (knot(i + 2) - u[i - 1]));
    row(i + 1, a, 1 - a - c, c, p[i].x(), p[i].y(), p[i].z());
  }
  const double g = u[n - 1] - u[n - 2], g2 = u[n - 1] - knot(n - 3);
  row(n, g, -g - g2, g2, 0., 0., 0.);
  row(n + 1, 0., 1., 0., p[n - 1].x(), p[n - 1].y(), p[n - 1].z());
}

// They are solved by elimination on arrays of numbers, without any check.
std::vector<std::array<double, 3>> by_hand(const std::vector<Point>& p, const std::vector<double>& u) {
  const int n = static_cast<int>(p.size());
  std::vector<std::array<double, 3>> x(n + 2);
  std::vector<double> upper(n + 2);
  for_equations(p, u, [&](int i, double a, double b, double c, double r, double s, double t) {
    const double pivot = 1 / (i == 0 ? b : b - a * upper[i - 1]);
    const std::array<double, 3> right = {r, s, t};
    upper[i] = c * pivot;
    for (int k = 0; k < 3; ++k) x[i][k] = (right[k] - (i == 0 ? 0 : a * x[i - 1][k])) * pivot;
  });
  for (int i = n; i >= 0; --i)
    for (int k = 0; k < 3; ++k) x[i][k] -= upper[i] * x[i + 1][k];
  return x;
}

// Solves the system by rotations of rows of a band matrix, as FITPACK solves such systems (fpgivs,
// fprota, fpback), with two diagonals above the first one.
std::vector<std::array<double, 3>> by_rotations(const std::vector<Point>& p, const std::vector<double>& u) {
  const int n = static_cast<int>(p.size());
  std::vector<std::array<double, 3>> band(n + 2), x(n + 2); // of row i, the columns i, i + 1, i + 2
  for_equations(p, u, [&](int i, double a, double b, double c, double r, double s, double t) {
    band[i] = {b, c, 0};
    x[i] = {r, s, t};
    if (i == 0) return;
    std::array<double, 3>&above = band[i - 1], &y = x[i - 1];
    const double length = std::sqrt(above[0] * above[0] + a * a), cosine = above[0] / length, sine = a / length;
    const auto rotate = [&](double& from, double& to) {
      const double f = from;
      from = cosine * f + sine * to;
      to = cosine * to - sine * f;
    };
    above[0] = length;
    rotate(above[1], band[i][0]);
    rotate(above[2], band[i][1]);
    for (int k = 0; k < 3; ++k) rotate(y[k], x[i][k]);
  });
  for (int i = n + 1; i >= 0; --i)
    for (int k = 0; k < 3; ++k) {
      if (i <= n) x[i][k] -= band[i][1] * x[i + 1][k];
      if (i < n) x[i][k] -= band[i][2] * x[i + 2][k];
      x[i][k] /= band[i][0];
    }
  return x;
}

#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
// Solves the system by a general solver for sparse matrices.
Eigen::MatrixXd by_eigen(const std::vector<Point>& p, const std::vector<double>& u) {
  const int n = static_cast<int>(p.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * n + 4);
  Eigen::MatrixXd right(n + 2, 3);
  for_equations(p, u, [&](int i, double a, double b, double c, double r, double s, double t) {
    if (i > 0) entries.emplace_back(i, i - 1, a);
    entries.emplace_back(i, i, b);
    if (i < n + 1) entries.emplace_back(i, i + 1, c);
    right.row(i) << r, s, t;
  });
  Eigen::SparseMatrix<double> matrix(n + 2, n + 2);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> solver(matrix);
  return solver.solve(right);
}
// By elimination on arrays of Eigen's.
Eigen::Array3Xd by_eigen_arrays(const std::vector<Point>& p, const std::vector<double>& u) {
  const int n = static_cast<int>(p.size());
  Eigen::Array3Xd x(3, n + 2);
  Eigen::ArrayXd upper(n + 2);
  for_equations(p, u, [&](int i, double a, double b, double c, double r, double s, double t) {
    const double pivot = 1 / (i == 0 ? b : b - a * upper[i - 1]);
    upper[i] = c * pivot;
    x.col(i) << r, s, t;
    if (i > 0) x.col(i) -= a * x.col(i - 1);
    x.col(i) *= pivot;
  });
  for (int i = n; i >= 0; --i) x.col(i) -= upper[i] * x.col(i + 1);
  return x;
}
// Eigen's own splines: through the same points at the same parameters, with other knots, and with a
// matrix that is not sparse.
Eigen::Spline3d eigen_spline(const std::vector<Point>& p, const std::vector<double>& u) {
  Eigen::Matrix3Xd points(3, p.size());
  Eigen::RowVectorXd parameters(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) << p[i].x(), p[i].y(), p[i].z();
    parameters[static_cast<Eigen::Index>(i)] = u[i] / u.back();
  }
  return Eigen::SplineFitting<Eigen::Spline3d>::Interpolate(points, 3, parameters);
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
// The largest distance of the points from the chords between many points of a curve that runs by
// them in their order.
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
  const auto compared = [&](const auto& coordinate) {
    for (int i = 0; i < n + 2; ++i)
      for (int k = 0; k < 3; ++k) check(std::abs(coordinate(i, k) - x[i][k]) < 1e-7, work);
  };
  compared([&](int i, int k) { return curve.control_point(i)[k]; });
  timed(work + "elimination by hand", n, [p, u] { return by_hand(*p, *u); });
  timed(work + "interpolate", n, [p, u] { return GC::interpolate<Traits>(p->begin(), p->end(), *u); });
  const std::vector<std::array<double, 3>> rotated = by_rotations(*p, *u);
  compared([&](int i, int k) { return rotated[i][k]; });
  timed(work + "rotations of a band, as FITPACK does", n, [p, u] { return by_rotations(*p, *u); });
#ifdef GEOMETRIC_CONTINUITY_WITH_EIGEN
  const Eigen::Array3Xd y = by_eigen_arrays(*p, *u);
  compared([&](int i, int k) { return y(k, i); });
  timed(work + "elimination on Eigen's arrays", n, [p, u] { return by_eigen_arrays(*p, *u); });
  const Eigen::MatrixXd z = by_eigen(*p, *u);
  compared([&](int i, int k) { return z(i, k); });
  timed(work + "Eigen's SparseLU", n, [p, u] { return by_eigen(*p, *u); });
  if (n <= 1000) { // its matrix is not sparse
    const Eigen::Spline3d spline = eigen_spline(*p, *u);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < 3; ++k) check(std::abs(spline((*u)[i] / u->back())[k] - (*p)[i][k]) < 1e-7, work);
    timed(work + "Eigen's SplineFitting", n, [p, u] { return eigen_spline(*p, *u); });
  }
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
