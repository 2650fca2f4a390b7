// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Jets, curvature with torsion, blends and grids of surfaces in double: one at a time and in batches, against instructions
// written by hand and against OpenCASCADE and SISL where they were found. Results are compared before anything is timed.

#include "Ratio_table.h"

#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLProp_CLProps.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <sisl.h>
#endif

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits, 5> Quintic;
typedef GC::Bezier_patch<Traits> Patch;

namespace {

constexpr std::size_t n = 1024; // parameters, jets or blends of a batch
constexpr double tolerance = 1e-9;

void check(bool good, const char* what) {
  if (good) return;
  std::cerr << "wrong result: " << what << '\n';
  std::exit(1);
}

bool near(double x, double y) { return std::abs(x - y) <= tolerance * (1 + std::abs(x) + std::abs(y)); }

// ---------------------------------------------------------------- input

struct Input {
  std::vector<double> parameters;
  std::array<Point, 6> points;
  Quintic curve;
  GC::Jet_arrays<double, 3, 3> jets;
  GC::Jet_arrays<double, 3, 2> left, right;
  std::vector<GC::Curve_jet<Traits>> left_jets, right_jets;
  std::vector<double> grid_parameters;
  Patch patch;

  static std::array<Point, 6> random_points(std::mt19937& random) {
    std::array<Point, 6> p;
    for (Point& x : p) x = random_point(random);
    return p;
  }
  static Point random_point(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    const double x = number(random), y = number(random), z = number(random);
    return Point(x, y, z);
  }
  static Patch random_patch(std::mt19937& random) {
    std::vector<std::vector<Point>> net(7, std::vector<Point>(2));
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 2; ++j) {
        const Point p = random_point(random);
        net[i][j] = Point(i + 0.3 * p.x(), j + 0.3 * p.y(), p.z());
      }
    return Patch(net);
  }

  explicit Input(std::mt19937 random)
      : points(random_points(random)), curve(points.begin(), points.end()), jets(n), left(n), right(n),
        patch(random_patch(random)) {
    for (std::size_t l = 0; l < n; ++l) parameters.push_back(l / double(n - 1));
    for (std::size_t l = 0; l < n; ++l)
      for (bool end : {true, false}) {
        const std::array<Point, 6> b = random_points(random);
        const Quintic c(b.begin(), b.end());
        const GC::Curve_jet<Traits> jet = c.start_jet(2);
        (end ? left_jets : right_jets).push_back(jet);
        (end ? left : right).set(l, jet);
      }
    for (int l = 0; l < 200; ++l) grid_parameters.push_back(l / 199.0);
    GC::evaluate(curve, parameters.data(), n, jets);
  }
};

const Input& input() {
  static const Input in{std::mt19937(2026)};
  return in;
}

// ---------------------------------------------------------------- by hand

// The curve and its derivatives in powers of the parameter, each prepared for Horner's rule.
struct Hand_quintic {
  double c[3][4][6] = {}; // coordinate, derivative, power

  explicit Hand_quintic(const std::array<Point, 6>& b) {
    static const int m[6][6] = {{1, 0, 0, 0, 0, 0},       {-5, 5, 0, 0, 0, 0},     {10, -20, 10, 0, 0, 0},
                                {-10, 30, -30, 10, 0, 0}, {5, -20, 30, -20, 5, 0}, {-1, 5, -10, 10, -5, 1}};
    for (int x = 0; x < 3; ++x) {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) c[x][0][i] += m[i][j] * b[j][x];
      for (int d = 1; d < 4; ++d)
        for (int i = 0; i + d < 6; ++i) c[x][d][i] = (i + 1) * c[x][d - 1][i + 1];
    }
  }

  void operator()(double t, double* out) const {
    for (int x = 0; x < 3; ++x) {
      const double(*p)[6] = c[x];
      out[x] = ((((p[0][5] * t + p[0][4]) * t + p[0][3]) * t + p[0][2]) * t + p[0][1]) * t + p[0][0];
      out[3 + x] = (((p[1][4] * t + p[1][3]) * t + p[1][2]) * t + p[1][1]) * t + p[1][0];
      out[6 + x] = ((p[2][3] * t + p[2][2]) * t + p[2][1]) * t + p[2][0];
      out[9 + x] = (p[3][2] * t + p[3][1]) * t + p[3][0];
    }
  }

  void batch(const double* __restrict t, std::size_t size, double* out) const { // [derivative][coordinate][parameter]
    for (int x = 0; x < 3; ++x) {
      const double(*p)[6] = c[x];
      double* __restrict o0 = out + x * size, * __restrict o1 = o0 + 3 * size, * __restrict o2 = o1 + 3 * size, * __restrict o3 = o2 + 3 * size;
      for (std::size_t l = 0; l < size; ++l) {
        const double s = t[l];
        o0[l] = ((((p[0][5] * s + p[0][4]) * s + p[0][3]) * s + p[0][2]) * s + p[0][1]) * s + p[0][0];
        o1[l] = (((p[1][4] * s + p[1][3]) * s + p[1][2]) * s + p[1][1]) * s + p[1][0];
        o2[l] = ((p[2][3] * s + p[2][2]) * s + p[2][1]) * s + p[2][0];
        o3[l] = (p[3][2] * s + p[3][1]) * s + p[3][0];
      }
    }
  }
};

// The quintic with gamma'' = d n at both ends, one division for each end.
void hand_blend(const double* a, const double* d1, const double* d2, double sign, double* b, double* c) {
  const double u = (d1[0] * d2[0] + d1[1] * d2[1] + d1[2] * d2[2]) / (d1[0] * d1[0] + d1[1] * d1[1] + d1[2] * d1[2]);
  for (int x = 0; x < 3; ++x) {
    b[x] = a[x] + sign * 0.2 * d1[x];
    c[x] = a[x] + (sign * 0.4 - 0.05 * u) * d1[x] + 0.05 * d2[x];
  }
}

// ---------------------------------------------------------------- peers

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
Handle(Geom_BezierCurve) occt_curve() {
  TColgp_Array1OfPnt poles(1, 6);
  for (int j = 0; j < 6; ++j)
    poles.SetValue(j + 1, gp_Pnt(input().points[j].x(), input().points[j].y(), input().points[j].z()));
  return new Geom_BezierCurve(poles);
}
Handle(Geom_BezierSurface) occt_surface() {
  TColgp_Array2OfPnt poles(1, 7, 1, 2);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 2; ++j) {
      const Point& p = input().patch.control_point(i, j);
      poles.SetValue(i + 1, j + 1, gp_Pnt(p.x(), p.y(), p.z()));
    }
  return new Geom_BezierSurface(poles);
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
SISLCurve* sisl_curve() {
  static double knots[] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  static double points[18];
  for (int j = 0; j < 18; ++j) points[j] = input().points[j / 3][j % 3];
  static SISLCurve* const curve = newCurve(6, 6, knots, points, 1, 3, 1);
  return curve;
}
SISLSurf* sisl_surface() {
  static double u[] = {0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1}, v[] = {0, 0, 1, 1};
  static double points[42];
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 7; ++i)
      for (int x = 0; x < 3; ++x) points[3 * (7 * j + i) + x] = input().patch.control_point(i, j)[x];
  static SISLSurf* const surface = newSurf(7, 2, 7, 2, u, v, points, 1, 3, 1);
  return surface;
}
#endif

// ---------------------------------------------------------------- what is timed

// `work(l)` for one item after the other.
template <class Work> void one_by_one(const char* name, Work work) {
  benchmark::RegisterBenchmark(name, [work](benchmark::State& state) mutable {
    for (auto _ : state)
      for (std::size_t l = 0; l < n; ++l) work(l);
    state.SetItemsProcessed(state.iterations() * n);
  });
}
// `work()` for `items` at a time.
template <class Work> void at_once(const char* name, std::size_t items, Work work) {
  benchmark::RegisterBenchmark(name, [work, items](benchmark::State& state) mutable {
    for (auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * items);
  });
}

void compare_jets() {
  const Input& in = input();
  const Hand_quintic hand(in.points);
  for (std::size_t l = 0; l < n; ++l) {
    double x[12];
    hand(in.parameters[l], x);
    const GC::Curve_jet<Traits> jet = in.curve.jet(in.parameters[l], 3);
    for (int i = 0; i < 12; ++i) {
      check(near(x[i], jet[i / 3][i % 3]), "jet");
      check(near(x[i], in.jets.array(i / 3, i % 3)[l]), "batch of jets");
    }
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    occt_curve()->D3(in.parameters[l], p, d1, d2, d3);
    check(near(p.X(), x[0]) && near(d1.Y(), x[4]) && near(d3.Z(), x[11]), "jet of OpenCASCADE");
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
    double y[12];
    int left = 0, status = 0;
    s1221(sisl_curve(), 3, in.parameters[l], &left, y, &status);
    if (l + 1 < n)
      for (int i = 0; i < 12; ++i) check(near(x[i], y[i]), "jet of SISL");
#endif
  }
}

void register_jets() {
  const Input& in = input();
  static const Hand_quintic hand(in.points);
  static double out[12];
  one_by_one("jets of order 3, degree 5 | by hand, prepared powers", [&in](std::size_t l) {
    hand(in.parameters[l], out);
    benchmark::DoNotOptimize(out);
  });
  one_by_one("jets of order 3, degree 5 | Bezier_curve<Traits, 5>", [&in](std::size_t l) {
    const GC::Curve_jet<Traits> jet = in.curve.jet(in.parameters[l], 3);
    benchmark::DoNotOptimize(jet);
  });
  static const GC::Bezier_curve<Traits> dynamic(in.curve);
  one_by_one("jets of order 3, degree 5 | Bezier_curve<Traits>", [&in](std::size_t l) {
    const GC::Curve_jet<Traits> jet = dynamic.jet(in.parameters[l], 3);
    benchmark::DoNotOptimize(jet);
  });
  static std::vector<double> batch(12 * n);
  at_once("jets of order 3, degree 5 | by hand, prepared powers, batch", n,
          [&in] { hand.batch(in.parameters.data(), n, batch.data()); });
  static GC::Jet_arrays<double, 3, 3> jets;
  at_once("jets of order 3, degree 5 | evaluate(), batch", n,
          [&in] { GC::evaluate(in.curve, in.parameters.data(), n, jets); });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static const GeomAdaptor_Curve adaptor(occt_curve());
  one_by_one("jets of order 3, degree 5 | OpenCASCADE, adaptor", [&in](std::size_t l) {
    gp_Pnt p;
    gp_Vec d1, d2, d3;
    adaptor.D3(in.parameters[l], p, d1, d2, d3);
    benchmark::DoNotOptimize(d3);
  });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  one_by_one("jets of order 3, degree 5 | SISL", [&in](std::size_t l) {
    int left = 0, status = 0;
    s1221(sisl_curve(), 3, in.parameters[l], &left, out, &status);
    benchmark::DoNotOptimize(out);
  });
#endif
}

void register_curvatures() {
  const Input& in = input();
  static std::vector<double> kappa(n), tau(n);
  const auto by_hand = [&in] {
    const double *x1 = in.jets.array(1, 0), *y1 = in.jets.array(1, 1), *z1 = in.jets.array(1, 2),
                 *x2 = in.jets.array(2, 0), *y2 = in.jets.array(2, 1), *z2 = in.jets.array(2, 2),
                 *x3 = in.jets.array(3, 0), *y3 = in.jets.array(3, 1), *z3 = in.jets.array(3, 2);
    double* __restrict k = kappa.data(), * __restrict t = tau.data();
    for (std::size_t l = 0; l < n; ++l) {
      const double x = y1[l] * z2[l] - z1[l] * y2[l], y = z1[l] * x2[l] - x1[l] * z2[l],
                   z = x1[l] * y2[l] - y1[l] * x2[l];
      const double g = x1[l] * x1[l] + y1[l] * y1[l] + z1[l] * z1[l], square = x * x + y * y + z * z;
      k[l] = std::sqrt(square / g) / g;
      t[l] = (x * x3[l] + y * y3[l] + z * z3[l]) / square;
    }
  };
  by_hand();
  const std::vector<double> hand_kappa = kappa, hand_tau = tau;
  GC::curvature_and_torsion(in.jets, kappa.data(), tau.data());
  for (std::size_t l = 0; l < n; ++l)
    check(near(kappa[l], hand_kappa[l]) && near(tau[l], hand_tau[l]), "curvature and torsion");
  at_once("curvature and torsion of jets | by hand, batch", n, by_hand);
  at_once("curvature and torsion of jets | curvature_and_torsion(), batch", n,
          [&in] { GC::curvature_and_torsion(in.jets, kappa.data(), tau.data()); });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static GeomLProp_CLProps properties(occt_curve(), 3, 1e-12);
  one_by_one("curvature and torsion of jets | OpenCASCADE, CLProps, curvature only, with the jet",
             [&in](std::size_t l) {
               properties.SetParameter(in.parameters[l]);
               benchmark::DoNotOptimize(properties.Curvature());
             });
#endif
}

void register_blends() {
  const Input& in = input();
  static double b[12];
  const auto by_hand = [&in](std::size_t l) {
    const GC::Curve_jet<Traits>&x = in.left_jets[l], &y = in.right_jets[l];
    hand_blend(&x[0][0], &x[1][0], &x[2][0], 1, b, b + 3);
    hand_blend(&y[0][0], &y[1][0], &y[2][0], -1, b + 6, b + 9);
    benchmark::DoNotOptimize(b);
  };
  static GC::Blend_arrays<double, 3> gamma;
  GC::blend(in.left, in.right, GC::Minimal_second_derivative(), gamma);
  for (std::size_t l = 0; l < n; ++l) {
    by_hand(l);
    const auto single = GC::blend(in.left_jets[l], in.right_jets[l], GC::Minimal_second_derivative());
    for (int x = 0; x < 3; ++x) {
      check(near(b[3 + x], single.control_point(2)[x]) && near(b[9 + x], single.control_point(3)[x]), "blend");
      check(near(b[3 + x], gamma.array(2, x)[l]) && near(b[6 + x], gamma.array(4, x)[l]), "batch of blends");
    }
  }
  one_by_one("quintic blends, min_second | by hand", by_hand);
  one_by_one("quintic blends, min_second | blend()", [&in](std::size_t l) {
    const auto single = GC::blend(in.left_jets[l], in.right_jets[l], GC::Minimal_second_derivative());
    benchmark::DoNotOptimize(single);
  });
  at_once("quintic blends, min_second | blend(), batch", n,
          [&in] { GC::blend(in.left, in.right, GC::Minimal_second_derivative(), gamma); });
  at_once("quintic blends, energy3 | blend(), batch", n,
          [&in] { GC::blend(in.left, in.right, GC::Minimal_energy<3>(), gamma); });
  one_by_one("quintic blends, energy3 | blend()", [&in](std::size_t l) {
    const auto single = GC::blend(in.left_jets[l], in.right_jets[l]);
    benchmark::DoNotOptimize(single);
  });
}

void register_grids() {
  const Input& in = input();
  const std::size_t size = in.grid_parameters.size();
  static GC::Surface_grid<double> grid;
  GC::evaluate_grid(in.patch, in.grid_parameters, in.grid_parameters, grid);
  for (std::size_t l = 0; l < size; l += 7) {
    const double u = in.grid_parameters[l], v = in.grid_parameters[size - 1 - l];
    const Traits::Vector normal = *in.patch.unit_normal(u, v);
    const std::size_t at = l * size + size - 1 - l;
    for (int x = 0; x < 3; ++x)
      check(near(grid.points(x)[at], in.patch(u, v)[x]) && near(grid.normals(x)[at], normal[x]), "grid");
  }
  at_once("vertices of a 200 x 200 grid, degree 6 x 1, unit normals | evaluate_grid()", size * size,
          [&in] { GC::evaluate_grid(in.patch, in.grid_parameters, in.grid_parameters, grid); });
  at_once("vertices of a 200 x 200 grid, degree 6 x 1, unit normals | evaluate_grid(), not normalised", size * size,
          [&in] {
            GC::evaluate_grid<GC::Grid_normals::unnormalised>(in.patch, in.grid_parameters, in.grid_parameters, grid);
          });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static const GeomAdaptor_Surface adaptor(occt_surface());
  at_once("vertices of a 200 x 200 grid, degree 6 x 1, unit normals | OpenCASCADE, adaptor", size * size, [&in] {
    for (double u : in.grid_parameters)
      for (double v : in.grid_parameters) {
        gp_Pnt p;
        gp_Vec du, dv;
        adaptor.D1(u, v, p, du, dv);
        benchmark::DoNotOptimize(gp_Vec(du.Crossed(dv)).Normalized());
      }
  });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  static std::vector<double> derivatives(9 * size * size), normals(3 * size * size);
  at_once("vertices of a 200 x 200 grid, degree 6 x 1, unit normals | SISL", size * size, [&in, size] {
    int status = 0;
    s1506(sisl_surface(), 1, static_cast<int>(size), const_cast<double*>(in.grid_parameters.data()),
          static_cast<int>(size), const_cast<double*>(in.grid_parameters.data()), derivatives.data(), normals.data(),
          &status);
  });
#endif
}

} // namespace

int main(int argc, char** argv) {
  compare_jets();
  register_jets();
  register_curvatures();
  register_blends();
  register_grids();
  return run_benchmarks(argc, argv);
}
