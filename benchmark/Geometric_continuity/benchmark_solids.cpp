// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Measures what it costs to round all edges of a solid, with continuous curvature, against the
// fillets of OpenCASCADE, whose sections are arcs: a box, and prisms with a hundred and a thousand
// edges. Both are given the solid in memory, and make a closed shell of surfaces with trimmed
// faces.

#include "Ratio_table.h"

#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Simple_cartesian.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;

constexpr double height = 10, cut = 1;

// A base that is a star with blunt corners, so that all angles are far from 0 and 180 degrees; with
// four corners a rectangle.
std::vector<Point> base(int corners) {
  if (corners == 4) return {{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}};
  std::vector<Point> points;
  const double radius = 3.0 * corners;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, r = radius + (i % 2 == 0 ? 0 : 10);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return points;
}

struct Polygons {
  std::vector<Point> points;
  std::vector<std::vector<std::vector<int>>> faces;

  explicit Polygons(int corners) : points(base(corners)) {
    std::vector<int> top, bottom;
    for (int i = 0; i < corners; ++i) {
      const Point p = points[static_cast<std::size_t>(i)];
      points.emplace_back(p.x(), p.y(), height);
      const int next = (i + 1) % corners;
      faces.push_back({{i, next, next + corners, i + corners}});
      top.push_back(i + corners);
      bottom.push_back(corners - 1 - i);
    }
    faces.push_back({top});
    faces.push_back({bottom});
  }
};

TopoDS_Shape prism(int corners) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const Point& p : base(corners)) polygon.Add(gp_Pnt(p.x(), p.y(), p.z()));
  polygon.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 0, height)).Shape();
}

// Returns the number of edges that have got a fillet.
int fillet(const TopoDS_Shape& solid, TopoDS_Shape& result) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(solid, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet maker(solid);
  for (int i = 1; i <= edges.Extent(); ++i) maker.Add(cut, TopoDS::Edge(edges(i)));
  result = maker.Shape();
  return edges.Extent();
}

void measure(const std::string& work, int corners) {
  const Polygons polygons(corners);
  const auto rounded = GC::round_polyhedron(polygons.points, polygons.faces, cut);
  const std::vector<int> orders = GC::edge_orders(rounded);
  check(std::all_of(orders.begin(), orders.end(), [](int order) { return order == 2; }), work + " is not G2");
  benchmark::RegisterBenchmark((work + " | round_polyhedron()").c_str(), [polygons](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(GC::round_polyhedron(polygons.points, polygons.faces, cut));
  });
  benchmark::RegisterBenchmark((work + " | BRepFilletAPI_MakeFillet, arcs").c_str(), [=](benchmark::State& state) {
    const TopoDS_Shape solid = prism(corners);
    for (auto _ : state) {
      try {
        TopoDS_Shape shape;
        check(fillet(solid, shape) == 3 * corners && !shape.IsNull(), work + " has got no fillets");
        benchmark::DoNotOptimize(shape);
      } catch (const Standard_Failure& e) {
        state.SkipWithError("OpenCASCADE makes no fillets");
      }
    }
  });
}

} // namespace

int main(int argc, char** argv) {
  measure("a box, 12 edges", 4);
  measure("a prism, 102 edges", 34);
  measure("a prism, 1002 edges", 334);
  return run_benchmarks(argc, argv);
}
