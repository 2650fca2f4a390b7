// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/wires.h"

#include "formats/cad/opencascade/cad_curve.h"
#include "formats/cad/opencascade/placement.h"
#include "formats/cad/opencascade/read_model.h"

#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace {

// An end without a partner meets the next one within this part of the length of each curve.
constexpr double largest_gap = 0.01;

// So many points of a curve are drawn, besides its end.
constexpr int drawn_steps = 64;

std::string curve_name(const Standard_Transient* curve) {
  if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(curve))
    return curve_name(trimmed->BasisCurve().get());
  if (dynamic_cast<const Geom_Line*>(curve)) return "line";
  if (dynamic_cast<const Geom_Circle*>(curve)) return "circle";
  if (dynamic_cast<const Geom_Ellipse*>(curve)) return "ellipse";
  if (dynamic_cast<const Geom_Hyperbola*>(curve)) return "hyperbola";
  if (dynamic_cast<const Geom_Parabola*>(curve)) return "parabola";
  if (dynamic_cast<const Geom_BezierCurve*>(curve)) return "Bezier curve";
  if (dynamic_cast<const Geom_BSplineCurve*>(curve)) return "B-spline curve";
  return dynamic_cast<const Geom_OffsetCurve*>(curve) ? "offset curve" : curve->DynamicType()->Name();
}

double distance(const GC::Cad_point<3>& p, const GC::Cad_point<3>& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// One of both ends of a curve.
struct End {
  std::size_t curve;
  bool is_last; // where the parameter is largest
  double parameter;
  TopoDS_Vertex vertex;
  GC::Cad_point<3> point;
  double tolerance, length; // of the vertex, of the curve
};

class Wire_finder {
  const double gap_;
  Cad_wires result_;
  std::vector<End> ends_;
  std::vector<std::size_t> group_; // of each end the number of one that stands for all that meet

  void add_curve(const TopoDS_Edge& edge, int order) {
    const std::size_t number = result_.curves.size();
    Cad_curve_edge& e = result_.curves.emplace_back();
    TopLoc_Location location;
    double &begin = e.begin, &end = e.end;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, begin, end);
    if (curve.IsNull()) {
      e.kind = "point";
      if (!BRep_Tool::Degenerated(edge)) e.reason = "an edge without a curve in space";
      return;
    }
    e.kind = curve_name(curve.get());
    try {
      if (!is_finite(begin, end) || !(begin < end)) throw Not_covered("an empty or infinite range of parameters");
      e.space = {std::make_shared<const GC::Cad_curve<3>>(cad_curve(curve, {begin, end})), placement(location)};
    } catch (const Not_covered& reason) {
      e.reason = reason.what();
      return;
    }
    for (int i = 0; i <= drawn_steps; ++i) {
      const gp_Pnt p = curve->Value(begin + (end - begin) * i / drawn_steps).Transformed(location.Transformation());
      e.points.push_back({p.X(), p.Y(), p.Z()});
    }
    double length = 0;
    for (std::size_t i = 1; i < e.points.size(); ++i) length += distance(e.points[i - 1], e.points[i]);
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge, first, last);
    const auto add_end = [&](bool is_last, double parameter, const TopoDS_Vertex& vertex) {
      const double tolerance = vertex.IsNull() ? 0 : BRep_Tool::Tolerance(vertex);
      ends_.push_back(
          {number, is_last, parameter, vertex, is_last ? e.points.back() : e.points.front(), tolerance, length});
    };
    add_end(false, begin, first);
    add_end(true, end, last);
    for (const double knot : GC::curve_knots(*e.space->curve, order))
      if (begin < knot && knot < end)
        result_.joins.push_back({{number, number}, {{{*e.space, knot}, {*e.space, knot}}}, true});
  }

  std::size_t root(std::size_t i) const {
    while (group_[i] != i) i = group_[i];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { group_[(std::max)(root(i), root(j))] = (std::min)(root(i), root(j)); }

  // Calls f(i, j, distance) for all pairs of some ends that are no farther apart than the sum of
  // their radii.
  template <class Radius, class Function>
  void for_neighbours(std::vector<std::size_t> some, const Radius& radius, const Function& f) const {
    std::sort(some.begin(), some.end(), [&](std::size_t i, std::size_t j) { return ends_[i].point < ends_[j].point; });
    double largest = 0;
    for (const std::size_t i : some) largest = (std::max)(largest, radius(ends_[i]));
    for (std::size_t a = 0; a < some.size(); ++a)
      for (std::size_t b = a + 1; b < some.size(); ++b) {
        const End &x = ends_[some[a]], &y = ends_[some[b]];
        if (y.point[0] - x.point[0] > 2 * largest) break;
        const double d = distance(x.point, y.point);
        if (d <= radius(x) + radius(y)) f(some[a], some[b], d);
      }
  }

  void find_groups() {
    group_.resize(ends_.size());
    std::iota(group_.begin(), group_.end(), std::size_t(0));
    std::map<const TopoDS_TShape*, std::vector<std::size_t>> at_vertex;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (ends_[i].vertex.IsNull()) continue;
      std::vector<std::size_t>& others = at_vertex[ends_[i].vertex.TShape().get()];
      for (const std::size_t j : others)
        if (ends_[i].vertex.IsSame(ends_[j].vertex)) unite(i, j);
      others.push_back(i);
    }
    std::vector<std::size_t> all(ends_.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    // a curve that is shorter than the tolerance has two ends all the same
    const auto radius = [this](const End& e) { return (std::min)((std::max)(gap_, e.tolerance), e.length / 2) / 2; };
    for_neighbours(all, radius, [this](std::size_t i, std::size_t j, double) { unite(i, j); });
  }

  // Joins those ends without a partner of which each is next to the other one.
  void close_gaps(const std::vector<std::size_t>& free) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::pair<double, std::size_t>> next(ends_.size(), {HUGE_VAL, none});
    const auto radius = [](const End& e) { return largest_gap / 2 * e.length; };
    for_neighbours(free, radius, [&](std::size_t i, std::size_t j, double d) {
      if (d > largest_gap * (std::min)(ends_[i].length, ends_[j].length)) return;
      next[i] = (std::min)(next[i], {d, j});
      next[j] = (std::min)(next[j], {d, i});
    });
    for (const std::size_t i : free)
      if (next[i].second != none && next[next[i].second].second == i) unite(i, next[i].second);
  }

  std::vector<std::vector<std::size_t>> groups() const {
    std::vector<std::vector<std::size_t>> result(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) result[root(i)].push_back(i);
    return result;
  }

  void add_join(const End& a, const End& b) {
    const bool is_turned = !a.is_last && b.is_last; // the first curve ends there if one does
    const End &left = is_turned ? b : a, &right = is_turned ? a : b;
    result_.joins.push_back({{left.curve, right.curve},
                             {{{*result_.curves[left.curve].space, left.parameter, !left.is_last},
                               {*result_.curves[right.curve].space, right.parameter, right.is_last}}},
                             false});
  }

public:
  explicit Wire_finder(double gap) : gap_(gap) {}

  Cad_wires operator()(const std::vector<TopoDS_Edge>& edges, int order) {
    for (const TopoDS_Edge& edge : edges) add_curve(edge, order);
    find_groups();
    std::vector<std::size_t> free;
    for (const std::vector<std::size_t>& group : groups())
      if (group.size() == 1) free.push_back(group[0]);
    close_gaps(free);
    for (const std::vector<std::size_t>& group : groups()) {
      if (group.size() == 1) result_.free_ends.push_back(ends_[group[0]].point);
      if (group.size() == 2) add_join(ends_[group[0]], ends_[group[1]]);
      if (group.size() < 3) continue;
      result_.branchings.emplace_back();
      for (const std::size_t i : group) result_.branchings.back().push_back(ends_[i].curve);
    }
    std::stable_sort(result_.joins.begin(), result_.joins.end(), [](const Cad_join& a, const Cad_join& b) {
      return std::pair(a.curves[0], !a.is_knot) < std::pair(b.curves[0], !b.is_knot);
    });
    return std::move(result_);
  }
};

} // namespace

std::vector<TopoDS_Edge> edges_without_face(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces, edges, of_faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= faces.Extent(); ++i) TopExp::MapShapes(faces(i), TopAbs_EDGE, of_faces);
  std::vector<TopoDS_Edge> result;
  for (int i = 1; i <= edges.Extent(); ++i)
    if (!of_faces.Contains(edges(i))) result.push_back(TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD)));
  return result;
}

Cad_wires wires(const std::vector<TopoDS_Edge>& edges, double gap, int order) { return Wire_finder(gap)(edges, order); }
