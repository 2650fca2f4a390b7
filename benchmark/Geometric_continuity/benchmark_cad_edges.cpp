// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Enclosures over whole edges of CAD models: for each edge, to the default precision, with the
// number of ranges that it takes.

#include <CGAL/Geometric_continuity/cad/cad_edge_continuity.h>

#include <benchmark/benchmark.h>

#include <memory>
#include <random>

namespace {

namespace GC = CGAL::Geometric_continuity;
typedef GC::Cad_elementary_surface Elementary;

const GC::Cad_placement unmoved{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
const GC::Cad_frame standard{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

template <class Surface, class Curve> GC::Edge_side side(const Surface& surface, const Curve& curve) {
  return {std::make_shared<GC::Cad_surface>(surface), std::make_shared<GC::Cad_curve<2>>(curve), unmoved, false};
}

// Two bicubic surfaces of 8 x 8 points that deviate from each other by 1e-5.
GC::Cad_spline_surface bicubic(double deviation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  const std::vector<double> knots{0, 0, 0, 0, 0.2, 0.4, 0.6, 0.8, 1, 1, 1, 1};
  GC::Cad_spline_surface s{3, 3, knots, knots, {}, {}};
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double x = i + noise(random), y = j + noise(random), z = 5 * noise(random);
      s.points.push_back({x, y, z + deviation * noise(random)});
    }
  return s;
}

void enclose(benchmark::State& state, const GC::Edge_side& a, const GC::Edge_side& b, double first, double last,
             bool with_curvature = true) {
  GC::Edge_precision precision;
  precision.with_curvature = with_curvature;
  int boxes = 0;
  for (auto _ : state) {
    const GC::Edge_enclosure e = GC::edge_enclosure(a, b, first, last, precision);
    boxes = e.boxes;
    benchmark::DoNotOptimize(e);
  }
  state.counters["ranges"] = boxes;
  state.counters["per_range"] =
      benchmark::Counter(boxes * state.iterations(), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void along_an_isoparametric_line(benchmark::State& state) {
  const GC::Cad_line<2> line{{0, 0}, {1, 0}};
  enclose(state, side(bicubic(0), line), side(bicubic(1e-4), line), 0, 1);
}
BENCHMARK(along_an_isoparametric_line)->Name("bicubic surfaces, along a parameter line | edge_enclosure()");

void along_a_curve(benchmark::State& state) {
  const GC::Cad_spline_curve<2> c{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0.1}, {0.3, 0.5}, {0.6, 0.2}, {1, 0.7}}, {}};
  enclose(state, side(bicubic(0), c), side(bicubic(1e-4), c), 0, 1);
}
BENCHMARK(along_a_curve)->Name("bicubic surfaces, along a curve | edge_enclosure()");

void along_a_curve_without_curvature(benchmark::State& state) {
  const GC::Cad_spline_curve<2> c{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0.1}, {0.3, 0.5}, {0.6, 0.2}, {1, 0.7}}, {}};
  enclose(state, side(bicubic(0), c), side(bicubic(1e-4), c), 0, 1, false);
}
BENCHMARK(along_a_curve_without_curvature)
    ->Name("bicubic surfaces, along a curve | edge_enclosure(), gap and angle only");

void cylinder_on_plane(benchmark::State& state) {
  const GC::Cad_frame frame{{0, 0, 3}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
  enclose(state, side(Elementary{Elementary::Kind::plane, standard}, GC::Cad_line<2>{{0, 0}, {0, 1}}),
          side(Elementary{Elementary::Kind::cylinder, frame, 3}, GC::Cad_line<2>{{0, 0}, {0, -1}}), -1, 5);
}
BENCHMARK(cylinder_on_plane)->Name("cylinder on a plane | edge_enclosure()");

void sphere_cut_by_plane(benchmark::State& state) {
  const GC::Cad_frame frame{{0, 0, 1.5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const GC::Cad_conic<2> circle{GC::Cad_conic<2>::Kind::ellipse, {0, 0}, {1, 0}, {0, 1}, 2, 2};
  enclose(state,
          side(Elementary{Elementary::Kind::sphere, standard, 2.5}, GC::Cad_line<2>{{0, 0.6435011087932844}, {1, 0}}),
          side(Elementary{Elementary::Kind::plane, frame}, circle), 0, 6.283185307179586);
}
BENCHMARK(sphere_cut_by_plane)->Name("sphere cut by a plane | edge_enclosure()");

} // namespace

BENCHMARK_MAIN();
