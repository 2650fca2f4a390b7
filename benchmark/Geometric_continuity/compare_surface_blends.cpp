// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The blends of two surfaces that the strategies choose, and how fair they are:
//   compare_surface_blends [PAIRS [SEED [unfolded]]]
// For random pairs of patches it prints the ratio of the mean variation of curvature to the least
// one that a search over beta and delta at both ends finds, folded or not, and how many blends may
// be folded. With `unfolded` the search leaves out folded blends where a strategy has one without a
// fold. Nothing of how the package measures fairness, or looks for it, is used: the mean is over
// other curves, by another quadrature, and the search is that of Nelder and Mead, from each
// strategy and from the best places of a grid.

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

namespace {

typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Bezier_patch<Traits> Patch;
typedef GC::Surface_blend_shape<double> Shape;
typedef std::array<double, 3> Vector;
typedef std::array<double, 4> Unknowns; // log beta and delta / beta at both ends
constexpr GC::Patch_edge edge_a = GC::Patch_edge::v1, edge_b = GC::Patch_edge::v0;
constexpr double infinity = std::numeric_limits<double>::infinity();

double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

// By de Casteljau's algorithm.
Vector value(std::vector<Vector> points, double t) {
  for (std::size_t n = points.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i)
      for (int k = 0; k < 3; ++k) points[i][k] += t * (points[i + 1][k] - points[i][k]);
  return points[0];
}

// L^3 int |(dK/ds)_perp|^2 ds of a Bezier curve, by the midpoint rule.
double variation(std::vector<Vector> points) {
  constexpr int parts = 200;
  std::array<std::vector<Vector>, 3> derivatives;
  for (std::vector<Vector>& derivative : derivatives) {
    const double degree = static_cast<double>(points.size() - 1);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (int k = 0; k < 3; ++k) points[i][k] = degree * (points[i + 1][k] - points[i][k]);
    points.pop_back();
    derivative = points;
  }
  double length = 0, integral = 0;
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) / parts;
    const Vector d1 = value(derivatives[0], t), d2 = value(derivatives[1], t), d3 = value(derivatives[2], t);
    const double g = dot(d1, d1), a = dot(d1, d2) / g, b = dot(d1, d3) / g;
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double x = d3[k] - b * d1[k] - 3 * a * (d2[k] - a * d1[k]);
      square += x * x;
    }
    length += std::sqrt(g) / parts;
    integral += square / (g * g * std::sqrt(g)) / parts;
  }
  const double e = length * length * length * integral;
  return e >= 0 ? e : infinity;
}

// The mean over eleven curves across.
double mean_variation(const Patch& s) {
  double sum = 0;
  for (int k = 0; k <= 10; ++k) {
    std::vector<Vector> points;
    for (int j = 0; j <= s.degree_v(); ++j) {
      std::vector<Vector> column;
      for (int i = 0; i <= s.degree_u(); ++i) {
        const Patch::Point& p = s.control_point(i, j);
        column.push_back({p.x(), p.y(), p.z()});
      }
      points.push_back(value(column, k / 10.));
    }
    sum += variation(points);
  }
  return sum / 11;
}

Shape shape_of(const Unknowns& x) {
  Shape shape;
  shape.start.beta = {std::exp(x[0])};
  shape.start.delta = {x[1] * std::exp(x[0])};
  shape.end.beta = {std::exp(x[2])};
  shape.end.delta = {x[3] * std::exp(x[2])};
  return shape;
}
Unknowns unknowns_of(const Shape& s) {
  return {std::log(s.start.beta[0]), s.start.delta[0] / s.start.beta[0], std::log(s.end.beta[0]),
          s.end.delta[0] / s.end.beta[0]};
}

// The method of Nelder and Mead from x. Returns the least value, and sets x to where it is.
template <class Function> double search(const Function& f, Unknowns& x) {
  typedef std::pair<double, Unknowns> Corner;
  std::vector<Corner> simplex = {{f(x), x}};
  for (int k = 0; k < 4; ++k) {
    Unknowns y = x;
    y[k] += k % 2 == 0 ? 0.2 : 0.8;
    simplex.push_back({f(y), y});
  }
  for (int i = 0; i < 300; ++i) {
    std::sort(simplex.begin(), simplex.end());
    if (simplex[4].first - simplex[0].first < 1e-5 * simplex[0].first) break;
    const auto on_line = [&](double t) { // from the middle of the best four to the worst one
      Unknowns y;
      for (int k = 0; k < 4; ++k) {
        double middle = 0;
        for (int j = 0; j < 4; ++j) middle += simplex[j].second[k] / 4;
        y[k] = middle + t * (simplex[4].second[k] - middle);
      }
      return Corner(f(y), y);
    };
    const Corner reflected = on_line(-1);
    if (reflected.first < simplex[0].first) {
      const Corner farther = on_line(-2);
      simplex[4] = farther.first < reflected.first ? farther : reflected;
    } else if (reflected.first < simplex[3].first) {
      simplex[4] = reflected;
    } else {
      const Corner nearer = on_line(reflected.first < simplex[4].first ? -0.5 : 0.5);
      if (nearer.first < (std::min)(reflected.first, simplex[4].first))
        simplex[4] = nearer;
      else
        for (int j = 1; j < 5; ++j) {
          for (int k = 0; k < 4; ++k) simplex[j].second[k] = (simplex[j].second[k] + simplex[0].second[k]) / 2;
          simplex[j].first = f(simplex[j].second);
        }
    }
  }
  std::sort(simplex.begin(), simplex.end());
  x = simplex[0].second;
  return simplex[0].first;
}

// Patches of random degrees whose control points are moved at random, tilted about the edge and
// turned in the plane.
class Random_patches {
  std::mt19937_64 random_;

public:
  explicit Random_patches(unsigned seed) : random_(seed) {}
  double number(double a, double b) { return a + (b - a) * static_cast<double>(random_() >> 11) * 0x1p-53; }

  Patch patch(double tilt, double turn, const Vector& at, bool is_first) {
    const int p = 1 + static_cast<int>(random_() % 3), q = 1 + static_cast<int>(random_() % 4);
    const double a = number(-tilt, tilt), b = number(-turn, turn);
    std::vector<std::vector<Patch::Point>> net(p + 1);
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) {
        const double x = 6. * i / p - 3 + number(-1, 1), up = number(-1, 1),
                     across = (is_first ? j - q : j) * 2. + number(-1, 1);
        const double y = std::cos(a) * across - std::sin(a) * up, z = std::sin(a) * across + std::cos(a) * up;
        net[i].push_back(
            {at[0] + std::cos(b) * x - std::sin(b) * y, at[1] + std::sin(b) * x + std::cos(b) * y, at[2] + z});
      }
    return Patch(net);
  }
};

struct Column {
  const char* name;
  std::vector<double> ratios = {};
  int folds = 0;
  double seconds = 0;
};

void compare(const char* title, int pairs, unsigned seed, bool unfolded, double tilt, double turn) {
  Random_patches random(seed);
  std::vector<Column> columns = {{"c2"}, {"energy2"}, {"energy3"}, {"fair"}, {"fairest"}};
  int least_folded = 0;
  for (int pair = 0; pair < pairs; ++pair) {
    const Patch a = random.patch(tilt, turn, {0, 0, 0}, true),
                b = random.patch(tilt, turn, {random.number(-2, 2), random.number(3, 8), random.number(-3, 3)}, false);
    const GC::Edge_direction direction = nearer_direction(a, edge_a, b, edge_b);
    const auto blend_of = [&](const Shape& s) { return GC::blend(a, edge_a, b, edge_b, s, direction); };
    std::vector<Shape> shapes;
    const auto take = [&](const auto& strategy) {
      const auto start = std::chrono::steady_clock::now();
      shapes.push_back(automatic_surface_shape(a, edge_a, b, edge_b, strategy, direction));
      columns[shapes.size() - 1].seconds +=
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    take(GC::Matching_second_derivative());
    take(GC::Minimal_energy<2>());
    take(GC::Minimal_energy<3>());
    take(GC::Fair());
    take(GC::Fairest());

    const bool leaves_out = unfolded && std::any_of(shapes.begin(), shapes.end(),
                                                    [&](const Shape& s) { return !possible_fold(blend_of(s)); });
    const auto e = [&](const Unknowns& x) {
      if ((std::max)(std::abs(x[0]), std::abs(x[2])) > 8) return infinity;
      const Patch s = blend_of(shape_of(x));
      return leaves_out && possible_fold(s) ? infinity : mean_variation(s);
    };
    std::vector<std::pair<double, Unknowns>> starts;
    for (const Shape& s : shapes) starts.push_back({-1, unknowns_of(s)});
    const Unknowns x = unknowns_of(shapes[2]);
    std::vector<std::pair<double, Unknowns>> grid;
    for (double beta : {-1., 0., 1.})
      for (double eta : {-1., 0., 1.})
        for (double s : {-8., 0., 8.})
          for (double t : {-8., 0., 8.}) {
            const Unknowns y = {x[0] + beta, s, x[2] + eta, t};
            grid.push_back({e(y), y});
          }
    std::sort(grid.begin(), grid.end());
    starts.insert(starts.end(), grid.begin(), grid.begin() + 4);
    double least = infinity;
    Unknowns where{};
    for (std::pair<double, Unknowns>& start : starts)
      if (const double found = search(e, start.second); found < least) {
        least = found;
        where = start.second;
      }
    if (possible_fold(blend_of(shape_of(where)))) ++least_folded;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Patch s = blend_of(shapes[i]);
      columns[i].ratios.push_back(mean_variation(s) / least);
      if (possible_fold(s)) ++columns[i].folds;
    }
  }
  std::printf("%s: %d pairs, seed %u; the fairest that the search finds have %d folds\n", title, pairs, seed,
              least_folded);
  std::printf("| strategy | median | 90 %% | worst | folds | microseconds |\n|---|---|---|---|---|---|\n");
  for (Column& c : columns) {
    std::sort(c.ratios.begin(), c.ratios.end());
    const auto at = [&](double part) {
      return c.ratios[(std::min)(c.ratios.size() - 1, static_cast<std::size_t>(part * static_cast<double>(pairs)))];
    };
    std::printf("| `%s` | %.3g | %.3g | %.3g | %d | %.0f |\n", c.name, at(0.5), at(0.9), c.ratios.back(), c.folds,
                1e6 * c.seconds / pairs);
  }
}

} // namespace

int main(int argc, char** argv) {
  const int pairs = argc > 1 ? (std::max)(1, std::atoi(argv[1])) : 100;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  const bool unfolded = argc > 3 && std::string(argv[3]) == "unfolded";
  compare("Tilted by up to 46 degrees, turned by up to 17", pairs, seed, unfolded, 0.8, 0.3);
  compare("Tilted by up to 92 degrees, turned by up to 57", pairs, seed, unfolded, 1.6, 1);
}
