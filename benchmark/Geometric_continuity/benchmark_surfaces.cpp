// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Grids of points and unit normals of surfaces in double, against instructions written by hand for
// just that surface, and against OpenCASCADE and SISL where they were found. Blends of two bicubic
// patches, on double against sums of control points by hand, and on rational numbers against
// integers over one denominator, and against fillings and lofts of OpenCASCADE and SISL, of which
// is told how smooth they are.
// Results are compared before anything is timed.

#include "Ratio_table.h"
#include "measure.h"
#include "surface_blends_by_hand.h"
#include "surface_fillings.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <sisl.h>
#endif

#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_patch<Traits> Patch;

namespace {

constexpr std::size_t size = 200; // parameters in each direction

#define GRID "vertices of a 200 x 200 grid, degree 6 x 1, unit normals | "

Patch random_patch() {
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<std::vector<Point>> net(7, std::vector<Point>(2));
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 2; ++j) {
      const double x = number(random), y = number(random), z = number(random);
      net[i][j] = Point(i + 0.3 * x, j + 0.3 * y, z);
    }
  return Patch(net);
}

const Patch& patch() {
  static const Patch p = random_patch();
  return p;
}
const std::vector<double>& parameters() {
  static const std::vector<double> t = [] {
    std::vector<double> x;
    for (std::size_t l = 0; l < size; ++l) x.push_back(l / double(size - 1));
    return x;
  }();
  return t;
}

// Along a line u = constant, points and normals S_u x S_v are linear in v: a + v b for each
// coordinate.
struct Hand_grid {
  double net[7][2][3];
  std::vector<double> numbers;

  Hand_grid() : numbers(6 * size * size) {
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 2; ++j)
        for (int x = 0; x < 3; ++x) net[i][j][x] = patch().control_point(i, j)[x];
  }

  double* array(int i) { return numbers.data() + i * size * size; }

  void line(double u, double (*c)[3], double (*d)[3]) const { // S and S_u at v = 0 and 1
    for (int j = 0; j < 2; ++j)
      for (int x = 0; x < 3; ++x) {
        double b[7];
        for (int i = 0; i < 7; ++i) b[i] = net[i][j][x];
        for (int m = 6; m > 1; --m)
          for (int i = 0; i < m; ++i) b[i] += u * (b[i + 1] - b[i]);
        d[j][x] = 6 * (b[1] - b[0]);
        c[j][x] = b[0] + u * (b[1] - b[0]);
      }
  }

  void operator()(const double* u, const double* __restrict v) {
    for (std::size_t l = 0; l < size; ++l) {
      double c[2][3], d[2][3], e[3], n[2][3];
      line(u[l], c, d);
      for (int x = 0; x < 3; ++x) e[x] = c[1][x] - c[0][x];
      for (int j = 0; j < 2; ++j)
        for (int x = 0; x < 3; ++x) n[j][x] = d[j][(x + 1) % 3] * e[(x + 2) % 3] - d[j][(x + 2) % 3] * e[(x + 1) % 3];
      for (int x = 0; x < 3; ++x) n[1][x] -= n[0][x];
      double* __restrict o[6];
      for (int i = 0; i < 6; ++i) o[i] = array(i) + l * size;
      double* __restrict px = o[0], * __restrict py = o[1], * __restrict pz = o[2], * __restrict nx = o[3], * __restrict ny = o[4], * __restrict nz = o[5];
      for (std::size_t k = 0; k < size; ++k) {
        const double t = v[k];
        px[k] = c[0][0] + t * e[0];
        py[k] = c[0][1] + t * e[1];
        pz[k] = c[0][2] + t * e[2];
        const double x = n[0][0] + t * n[1][0], y = n[0][1] + t * n[1][1], z = n[0][2] + t * n[1][2];
        const double scale = 1 / std::sqrt(x * x + y * y + z * z);
        nx[k] = scale * x;
        ny[k] = scale * y;
        nz[k] = scale * z;
      }
    }
  }
};

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
Handle(Geom_BezierSurface) occt_surface() {
  TColgp_Array2OfPnt poles(1, 7, 1, 2);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 2; ++j) {
      const Point& p = patch().control_point(i, j);
      poles.SetValue(i + 1, j + 1, gp_Pnt(p.x(), p.y(), p.z()));
    }
  return new Geom_BezierSurface(poles);
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
SISLSurf* sisl_surface() {
  static double u[] = {0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1}, v[] = {0, 0, 1, 1};
  static double points[42];
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 7; ++i)
      for (int x = 0; x < 3; ++x) points[3 * (7 * j + i) + x] = patch().control_point(i, j)[x];
  static SISLSurf* const surface = newSurf(7, 2, 7, 2, u, v, points, 1, 3, 1);
  return surface;
}
#endif

void register_grids() {
  const std::vector<double>& t = parameters();
  static GC::Surface_grid<double> grid;
  static Hand_grid by_hand;
  GC::evaluate_grid(patch(), t, t, grid);
  by_hand(t.data(), t.data());
  for (std::size_t i = 0; i < size; i += 7)
    for (std::size_t j = 0; j < size; j += 7) {
      const Point p = patch()(t[i], t[j]);
      const Traits::Vector normal = *patch().unit_normal(t[i], t[j]);
      for (int x = 0; x < 3; ++x) {
        const std::size_t at = i * size + j;
        check(near(grid.points(x)[at], p[x]) && near(grid.normals(x)[at], normal[x]), "grid");
        check(near(by_hand.array(x)[at], p[x]) && near(by_hand.array(3 + x)[at], normal[x]), "grid by hand");
      }
    }
  at_once(GRID "by hand", size * size, [&t] { by_hand(t.data(), t.data()); });
  at_once(GRID "evaluate_grid()", size * size, [&t] { GC::evaluate_grid(patch(), t, t, grid); });
  at_once(GRID "evaluate_grid(), not normalised", size * size,
          [&t] { GC::evaluate_grid<GC::Grid_normals::unnormalised>(patch(), t, t, grid); });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static const GeomAdaptor_Surface adaptor(occt_surface());
  const auto occt_normal = [](double u, double v, gp_Pnt& p) {
    gp_Vec du, dv;
    adaptor.D1(u, v, p, du, dv);
    return du.Crossed(dv).Normalized();
  };
  gp_Pnt p;
  const gp_Vec normal = occt_normal(t[20], t[30], p);
  for (int x = 0; x < 3; ++x)
    check(near(p.Coord(x + 1), by_hand.array(x)[20 * size + 30]) &&
              near(normal.Coord(x + 1), by_hand.array(3 + x)[20 * size + 30]),
          "grid of OpenCASCADE");
  at_once(GRID "OpenCASCADE, adaptor", size * size, [&t, occt_normal] {
    for (double u : t)
      for (double v : t) {
        gp_Pnt p;
        benchmark::DoNotOptimize(occt_normal(u, v, p));
      }
  });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  static std::vector<double> derivatives(12 * size * size), normals(3 * size * size);
  const auto sisl = [&t] {
    int status = 0;
    s1506(sisl_surface(), 1, static_cast<int>(size), const_cast<double*>(t.data()), static_cast<int>(size),
          const_cast<double*>(t.data()), derivatives.data(), normals.data(), &status);
  };
  sisl();
  for (int x = 0; x < 3; ++x) { // its vertices follow each other in the direction of u
    const std::size_t at = 30 * size + 20;
    const double length = std::hypot(normals[3 * at], normals[3 * at + 1], normals[3 * at + 2]);
    check(near(normals[3 * at + x] / length, by_hand.array(3 + x)[20 * size + 30]), "grid of SISL");
  }
  at_once(GRID "SISL", size * size, sisl);
#endif
}

// ---------------------------------------------------------------- blends

#define BLEND "blend of two bicubic patches, given shape, double | "
#define EXACT_BLEND "blend of two bicubic patches, given shape, decimals p/1000 | "

void register_blends() {
  static const by_hand::Surface_blend_input<double> input;
  static by_hand::Surface_blend sums(input);
  sums();
  const auto s = input();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 3; ++k) check(near(sums.b[i][j][k], s.control_point(i, j)[k]), "blend by hand");
  at_once(BLEND "by hand", 1, [] {
    benchmark::DoNotOptimize(&sums);
    sums();
    benchmark::ClobberMemory();
  });
  at_once(BLEND "blend()", 1, [] { benchmark::DoNotOptimize(input()); });
  at_once(BLEND "blend(), with the shape of least energy", 1, [] {
    benchmark::DoNotOptimize(
        GC::blend(input.a, GC::Patch_edge::v1, input.b, GC::Patch_edge::v0, GC::Minimal_energy<3>()));
  });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  static peers::Filling_input between;
  between.a = peers::occt_patch(input.a);
  between.b = peers::occt_patch(input.b);
  const Handle(Geom_BezierSurface) blend = peers::occt_patch(s);
  for (const bool upper : {false, true}) between.sides[upper] = peers::side(blend, upper);
  std::cout << BLEND "blend(): " << peers::error_of(between, blend) << '\n';
  const auto filling = [](const std::string& name, Handle(Geom_Surface) (*fill)(const peers::Filling_input&)) {
    const Handle(Geom_Surface) surface = fill(between);
    if (surface.IsNull()) {
      std::cout << BLEND << name << ": none\n";
      return;
    }
    std::cout << BLEND << name << ": " << peers::error_of(between, surface) << '\n';
    at_once((BLEND + name).c_str(), 1, [fill] { benchmark::DoNotOptimize(fill(between)); });
  };
  filling("OpenCASCADE, BRepFill_Filling with its defaults, G2", peers::occt_filling);
  filling("OpenCASCADE, GeomFill_ConstrainedFilling, G1", peers::occt_constrained_filling);
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  filling("SISL, s1538, a loft with two derivatives at both edges", peers::sisl_loft);
  filling("SISL, s1390, the same with sides", peers::sisl_blend);
#endif
#endif
#ifdef CGAL_USE_GMPXX
  static const by_hand::Surface_blend_input<CGAL::Exact_rational> exact;
  static by_hand::Exact_surface_blend integers{exact, {}, {}, {}, {}, {}};
  integers();
  const auto t = exact();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 3; ++k) check(integers.b[i][j][k] == t.control_point(i, j)[k], "exact blend by hand");
  at_once(EXACT_BLEND "integers by hand", 1, [] {
    integers();
    benchmark::ClobberMemory();
  });
  at_once(EXACT_BLEND "blend()", 1, [] { benchmark::DoNotOptimize(exact()); });
#endif
}

} // namespace

int main(int argc, char** argv) {
  register_grids();
  register_blends();
  return run_benchmarks(argc, argv);
}
