// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/open_boundaries.h"

#include "formats/cad/opencascade/read_model.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace {

// The samples of an edge that are compared: those inside of it.
constexpr std::size_t parts = 16;

// Where a curve runs in the same direction as another one: the cosine of the angle.
constexpr double least_cosine = 0.9;

double squared_distance(const gp_Pnt& p, const gp_Pnt& a, const gp_Pnt& b, double& t) {
  const gp_Vec along(a, b), to(a, p);
  const double length = along.SquareMagnitude();
  t = length > 0 ? (std::min)((std::max)(to.Dot(along) / length, 0.), 1.) : 0.;
  return p.SquareDistance(a.Translated(t * along));
}

// An edge as a polyline.
class Edge_samples {
  const Boundary_edge& edge_;
  BRepAdaptor_Curve curve_;
  double tolerance_, length_ = 0, sag_ = 0;
  std::vector<gp_Pnt> points_;            // at equal distances of the parameter
  std::array<gp_Pnt, parts + 1> samples_; // likewise
  std::array<double, 6> box_;

  double parameter(double part) const {
    return curve_.FirstParameter() + part * (curve_.LastParameter() - curve_.FirstParameter());
  }
  // Nothing where there is no curve in the parameter plane.
  std::optional<gp_Pnt2d> in_plane(double t) const {
    double begin, end;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge_.edge, edge_.face, begin, end);
    if (curve.IsNull()) return std::nullopt;
    const double part = (t - curve_.FirstParameter()) / (curve_.LastParameter() - curve_.FirstParameter());
    return curve->Value(begin + part * (end - begin));
  }

public:
  explicit Edge_samples(const Boundary_edge& edge) : edge_(edge), tolerance_(BRep_Tool::Tolerance(edge.edge)) {
    double begin, end;
    if (BRep_Tool::Curve(edge.edge, begin, end).IsNull())
      curve_.Initialize(edge.edge, edge.face);
    else
      curve_.Initialize(edge.edge);
    if (!is_finite(curve_.FirstParameter(), curve_.LastParameter())) return;
    const auto pieces = static_cast<std::size_t>(curve_.NbIntervals(GeomAbs_C1));
    const std::size_t n = curve_.GetType() == GeomAbs_Line ? 1 : 4 * (std::min)(2 * pieces, std::size_t(16));
    for (std::size_t i = 0; i <= n; ++i) points_.push_back(curve_.Value(parameter(double(i) / double(n))));
    for (std::size_t i = 0; i <= parts; ++i) samples_[i] = curve_.Value(sample_parameter(i));
    constexpr double inf = std::numeric_limits<double>::infinity();
    box_ = {inf, inf, inf, -inf, -inf, -inf};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        double &low = box_[static_cast<std::size_t>(k)], &high = box_[static_cast<std::size_t>(k + 3)];
        low = (std::min)(low, points_[i].Coord(k + 1));
        high = (std::max)(high, points_[i].Coord(k + 1));
      }
      if (i > 0) length_ += points_[i].Distance(points_[i - 1]);
      double t;
      if (i > 0 && i + 1 < points_.size())
        sag_ = (std::max)(sag_, std::sqrt(squared_distance(points_[i], points_[i - 1], points_[i + 1], t)));
    }
    if (!(length_ < infinite)) points_.clear();
  }

  bool is_empty() const { return points_.empty(); }
  double tolerance() const { return tolerance_; }
  double length() const { return length_; }
  const TopoDS_Face& face() const { return edge_.face; }
  const gp_Pnt& first() const { return points_.front(); }
  const gp_Pnt& last() const { return points_.back(); }
  // The ends of its box, with what polylines leave out.
  double low(std::size_t k) const { return box_[k] - sag_; }
  double high(std::size_t k) const { return box_[k + 3] + sag_; }

  bool is_near_box(const gp_Pnt& p, double distance) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (p.Coord(static_cast<int>(k) + 1) < low(k) - distance || p.Coord(static_cast<int>(k) + 1) > high(k) + distance)
        return false;
    return true;
  }

  double sample_parameter(std::size_t i) const { return parameter(double(i) / double(parts)); }
  const gp_Pnt& sample(std::size_t i) const { return samples_[i]; }

  // The parameter of the nearest point, if it is no farther away than the distance.
  std::optional<double> nearest(const gp_Pnt& p, double distance) const {
    if (!is_near_box(p, distance)) return std::nullopt;
    double least = std::numeric_limits<double>::infinity(), at = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      double t;
      const double d = squared_distance(p, points_[i], points_[i + 1], t);
      if (!(d < least)) continue;
      least = d;
      at = (double(i) + t) / double(points_.size() - 1);
    }
    if (!(std::sqrt(least) <= distance + 2 * sag_)) return std::nullopt;
    double t = parameter(at);
    gp_Pnt foot;
    for (int i = 0; i < 10; ++i) { // Newton's method
      gp_Vec first, second;
      curve_.D2(t, foot, first, second);
      const gp_Vec off(p, foot);
      double slope = first.SquareMagnitude() + off.Dot(second);
      if (!(slope > 0)) slope = first.SquareMagnitude();
      if (!(slope > 0)) break;
      const double before = t;
      t = (std::min)((std::max)(t - off.Dot(first) / slope, curve_.FirstParameter()), curve_.LastParameter());
      if (t == before) break;
    }
    return curve_.Value(t).Distance(p) <= distance ? std::optional<double>(t) : std::nullopt;
  }

  gp_Pnt point(double t) const { return curve_.Value(t); }
  gp_Vec direction(double t) const {
    gp_Pnt p;
    gp_Vec result;
    curve_.D1(t, p, result);
    return result;
  }

  // Returns whether the points of two edges of one face are the two sides of a narrow part of it,
  // and not those of a cut that closes it. Where the parameter plane does not tell, as of an edge
  // that is there twice, they are not.
  bool is_across(double t, const Edge_samples& other, double s, double distance) const {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(edge_.face);
    if (surface.IsNull()) return true;
    const std::optional<gp_Pnt2d> a = in_plane(t), b = other.in_plane(s);
    if (!a || !b || a->Distance(*b) <= Precision::PConfusion()) return false;
    const gp_Pnt middle = surface->Value((a->X() + b->X()) / 2, (a->Y() + b->Y()) / 2);
    return middle.Distance(point(t)) <= 2 * distance;
  }
};

// Returns whether a part of the first edge, or all of it, lies beside the second one.
bool is_beside(const Edge_samples& a, const Edge_samples& b, double gap) {
  if (!(a.length() > Precision::Confusion())) return false; // a point
  // Around an edge that is hardly longer than this distance all would be beside it.
  const double distance = (std::min)((std::max)({gap, a.tolerance(), b.tolerance()}), a.length() / 8);
  std::array<bool, parts + 1> is_near{};
  std::size_t number = 0;
  for (std::size_t i = 1; i < parts; ++i) {
    const std::optional<double> s = b.nearest(a.sample(i), distance);
    if (!s) continue;
    const double t = a.sample_parameter(i);
    const gp_Vec u = a.direction(t), v = b.direction(*s);
    if (!(std::abs(u.Dot(v)) >= least_cosine * u.Magnitude() * v.Magnitude())) continue;
    if (a.face().IsSame(b.face()) && a.is_across(t, b, *s, distance)) continue;
    is_near[i] = true;
    ++number;
  }
  if (number == parts - 1) return true;
  const auto is_common_end = [&](const gp_Pnt& p) {
    return p.Distance(b.first()) <= 2 * distance || p.Distance(b.last()) <= 2 * distance;
  };
  for (std::size_t i = 1; i < parts;) {
    std::size_t end = i;
    while (is_near[end]) ++end; // the last one is false
    const bool is_at_end = (i == 1 && is_common_end(a.first())) || (end == parts && is_common_end(a.last()));
    if (end >= i + 2 && !is_at_end) return true;
    i = (std::max)(end, i + 1);
  }
  return false;
}

} // namespace

std::vector<std::optional<std::size_t>> edges_beside(const std::vector<Boundary_edge>& edges, double gap) {
  std::vector<Edge_samples> sampled;
  std::vector<std::size_t> numbers; // of the edges that can be sampled
  for (std::size_t i = 0; i < edges.size(); ++i) {
    try {
      Edge_samples edge(edges[i]);
      if (edge.is_empty()) continue;
      sampled.push_back(std::move(edge));
      numbers.push_back(i);
    } catch (const Standard_Failure&) { // an edge without a curve
    }
  }
  double most_tolerance = gap;
  for (const Edge_samples& edge : sampled) most_tolerance = (std::max)(most_tolerance, edge.tolerance());
  std::vector<std::size_t> order(sampled.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return sampled[i].low(0) < sampled[j].low(0); });
  std::vector<std::optional<std::size_t>> result(edges.size());
  for (std::size_t x = 0; x < order.size(); ++x)
    for (std::size_t y = x + 1; y < order.size(); ++y) {
      const std::size_t i = order[x], j = order[y];
      const Edge_samples &a = sampled[i], &b = sampled[j];
      if (b.low(0) > a.high(0) + most_tolerance) break;
      if (result[numbers[i]] && result[numbers[j]]) continue;
      const double distance = (std::max)({gap, a.tolerance(), b.tolerance()});
      bool is_apart = false;
      for (std::size_t k = 0; k < 3; ++k)
        is_apart = is_apart || a.low(k) > b.high(k) + distance || b.low(k) > a.high(k) + distance;
      if (is_apart || !(is_beside(a, b, gap) || is_beside(b, a, gap))) continue;
      if (!result[numbers[i]]) result[numbers[i]] = numbers[j];
      if (!result[numbers[j]]) result[numbers[j]] = numbers[i];
    }
  return result;
}

bool is_boundary_open(const TopoDS_Face& face) {
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
    TopTools_IndexedMapOfShape vertices;
    std::vector<int> ends;
    bool is_empty = true;
    for (TopoDS_Iterator i(wire.Current()); i.More(); i.Next()) {
      is_empty = false;
      const TopAbs_Orientation orientation = i.Value().Orientation();
      // inside of the face
      if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) continue;
      TopoDS_Vertex first, last;
      TopExp::Vertices(TopoDS::Edge(i.Value()), first, last);
      for (const TopoDS_Vertex& end : {first, last}) {
        if (end.IsNull()) continue; // of an infinite edge
        const auto vertex = static_cast<std::size_t>(vertices.Add(end) - 1);
        ends.resize(static_cast<std::size_t>(vertices.Extent()), 0);
        ++ends[vertex];
      }
    }
    if (is_empty) return true;
    // Where edges do not share their vertices, these coincide.
    std::vector<TopoDS_Vertex> single;
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (ends[i] % 2 != 0) single.push_back(TopoDS::Vertex(vertices(static_cast<int>(i) + 1)));
    while (!single.empty()) {
      const TopoDS_Vertex vertex = single.back();
      single.pop_back();
      const auto distance = [&](const TopoDS_Vertex& v) { return BRep_Tool::Pnt(vertex).Distance(BRep_Tool::Pnt(v)); };
      const auto same = std::min_element(single.begin(), single.end(),
                                         [&](const auto& v, const auto& w) { return distance(v) < distance(w); });
      if (same == single.end() || distance(*same) > BRep_Tool::Tolerance(vertex) + BRep_Tool::Tolerance(*same))
        return true;
      single.erase(same);
    }
  }
  return false;
}
