// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Grids of points and unit normals of surfaces in double, against instructions written by hand for just that surface, and
// against OpenCASCADE and SISL where they were found. Blends of two bicubic patches, on double against sums of control points by hand,
// and on rational numbers against integers over one denominator. Results are compared before anything is timed.

#include "Ratio_table.h"
#include "measure.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/blend_surfaces.h>
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
#include <random>
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

// Along a line u = constant, points and normals S_u x S_v are linear in v: a + v b for each coordinate.
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

// Two patches and a shape of numbers.
template <class FT> struct Blend_input {
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Numbers;
  typedef GC::Bezier_patch<Numbers> Surface;

  Surface a = bicubic(0), b = bicubic(5);
  GC::Surface_blend_shape<FT> shape;

  Blend_input() {
    shape.start.beta = {FT(FT(10) / FT(8))};
    shape.start.delta = {FT(FT(-3) / FT(8))};
    shape.end.beta = {FT(FT(14) / FT(8))};
    shape.end.delta = {FT(FT(12) / FT(8))};
  }
  Surface operator()() const { return GC::blend(a, GC::Patch_edge::v1, b, GC::Patch_edge::v0, shape); }

private:
  static Surface bicubic(int from) {
    std::mt19937_64 random(2026 + static_cast<unsigned>(from));
    const auto number = [&](int base) {
      return FT(FT(1000 * base + static_cast<int>(random() % 601) - 300) / FT(1000));
    };
    std::vector<std::vector<typename Numbers::Point>> net(4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const FT x = number(i), y = number(from + j), z = number(0);
        net[i].push_back({x, y, z});
      }
    return Surface(net);
  }
};

// Sums of the control points of the layers next to the edges.
struct Hand_blend {
  double end[2][4][3][3], b[4][6][3], beta[2], delta[2];

  explicit Hand_blend(const Blend_input<double>& x)
      : beta{x.shape.start.beta[0], x.shape.end.beta[0]}, delta{x.shape.start.delta[0], x.shape.end.delta[0]} {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) {
          end[0][i][j][k] = x.a.control_point(i, 3 - j)[k];
          end[1][i][j][k] = x.b.control_point(i, j)[k];
        }
  }

  void operator()() {
    for (int e = 0; e < 2; ++e) {
      const int first = e == 0 ? 0 : 5, step = e == 0 ? 1 : -1;
      const double f = -3 * beta[e] / 5, g = (-24 * beta[e] - step * 3 * delta[e]) / 20, h = 6 * beta[e] * beta[e] / 20;
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) {
          const double p = end[e][i][0][k], d = end[e][i][1][k] - p, dd = end[e][i][2][k] - end[e][i][1][k] - d;
          b[i][first][k] = p;
          b[i][first + step][k] = p + f * d;
          b[i][first + 2 * step][k] = p + g * d + h * dd;
        }
    }
  }
};

#ifdef CGAL_USE_GMPXX
// The same in integers: one denominator for each patch, beta and delta in eighths, and each result is reduced once.
struct Exact_hand_blend {
  const Blend_input<CGAL::Exact_rational>& x;
  mpz_class n[3][3], denominator, d, dd;
  mpq_class b[4][6][3];

  void operator()() {
    for (int e = 0; e < 2; ++e) {
      const auto point = [&](int i, int j) { return e == 0 ? x.a.control_point(i, 3 - j) : x.b.control_point(i, j); };
      denominator = 1;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) {
          const auto p = point(i, j);
          for (int k = 0; k < 3; ++k)
            if (!mpz_divisible_p(denominator.get_mpz_t(), denominator_of(p[k])))
              mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), denominator_of(p[k]));
        }
      const int step = e == 0 ? 1 : -1, beta = e == 0 ? 10 : 14, delta = e == 0 ? -3 : 12;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
          const auto p = point(i, j);
          for (int k = 0; k < 3; ++k) {
            mpz_divexact(n[j][k].get_mpz_t(), denominator.get_mpz_t(), denominator_of(p[k]));
            mpz_mul(n[j][k].get_mpz_t(), n[j][k].get_mpz_t(), numerator_of(p[k]));
          }
        }
        for (int k = 0; k < 3; ++k) {
          mpq_class* const to = b[i][0] + k;
          const int first = e == 0 ? 0 : 15, second = first + 3 * step, third = second + 3 * step; // 3 numbers a point
          d = n[1][k] - n[0][k];
          dd = n[2][k] - n[1][k] - d;
          to[first].get_num() = n[0][k];
          to[first].get_den() = denominator;
          to[second].get_num() = 40 * n[0][k] - 3 * beta * d;
          to[second].get_den() = 40 * denominator;
          to[third].get_num() = 1280 * n[0][k] - 8 * (24 * beta + step * 3 * delta) * d + 6 * beta * beta * dd;
          to[third].get_den() = 1280 * denominator;
          for (int at : {first, second, third}) to[at].canonicalize();
        }
      }
    }
  }

  static mpz_srcptr numerator_of(const mpq_class& q) { return q.get_num_mpz_t(); }
  static mpz_srcptr denominator_of(const mpq_class& q) { return q.get_den_mpz_t(); }
};
#endif

void register_blends() {
  static const Blend_input<double> input;
  static Hand_blend by_hand(input);
  by_hand();
  const auto s = input();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 3; ++k) check(near(by_hand.b[i][j][k], s.control_point(i, j)[k]), "blend by hand");
  at_once(BLEND "by hand", 1, [] {
    benchmark::DoNotOptimize(&by_hand);
    by_hand();
    benchmark::ClobberMemory();
  });
  at_once(BLEND "blend()", 1, [] { benchmark::DoNotOptimize(input()); });
  at_once(BLEND "blend(), with the shape of least energy", 1,
          [] { benchmark::DoNotOptimize(GC::blend(input.a, GC::Patch_edge::v1, input.b, GC::Patch_edge::v0)); });
#ifdef CGAL_USE_GMPXX
  static const Blend_input<CGAL::Exact_rational> exact;
  static Exact_hand_blend integers{exact, {}, {}, {}, {}, {}};
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
