// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/Outlined_solid.h"

#include "formats/solids/check_closed.h"
#include "formats/solids/make_planar.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

typedef Outlined_solid::Vector Outline_vector;

std::string edge_word(std::size_t edge) { return "edge " + std::to_string(edge); }

} // namespace

Outline_vector Outlined_solid::vertex(std::size_t v) const { return wall_vector(given.vertices[v]); }

std::string Outlined_solid::face_name(std::size_t face) const {
  const Cad_solid::Face& f = given.faces[face];
  return "face " + std::to_string(face) + (f.name.empty() ? "" : " (" + f.name + ")");
}

void Outlined_solid::refuse(std::size_t face, const std::string& reason) const {
  throw std::runtime_error(face_name(face) + ": " + reason);
}

std::array<Outline_vector, 2> Outlined_solid::tangents(const Rim& rim, const Rim& next) const {
  const std::array<Vector, 2> a = wall_at(rim).curve.end_tangents(), b = wall_at(next).curve.end_tangents();
  return {rim.along ? a[1] : Vector(-1 * a[0]), next.along ? b[0] : Vector(-1 * b[1])};
}

// Each edge has two faces that pass it in opposite directions, and all faces are connected.
void Outlined_solid::check_shell() const {
  std::vector<std::size_t> group(given.faces.size());
  std::iota(group.begin(), group.end(), std::size_t(0));
  const auto representative = [&](std::size_t f) {
    while (group[f] != f) f = group[f];
    return f;
  };
  for (std::size_t e = 0; e < passes_.size(); ++e) {
    const std::vector<Pass>& p = passes_[e];
    if (p.empty()) continue;
    if (p.size() == 1)
      refuse(p[0].face, edge_word(e) + " has no other face: the shell is open, and a closed solid is needed");
    if (p.size() > 2) refuse(p[0].face, edge_word(e) + " has " + std::to_string(p.size()) + " faces, not two");
    if (p[0].reversed == p[1].reversed)
      refuse(p[0].face, "at " + edge_word(e) + " it and " + face_name(p[1].face) +
                            " are oriented as if one of them were inside out");
    group[representative(p[0].face)] = representative(p[1].face);
  }
  for (std::size_t f = 1; f < group.size(); ++f)
    if (representative(f) != representative(0))
      refuse(f, "no edges lead from it to face 0: one solid is expected in a file, without voids");
}

// Decides by a plane that has the whole solid on one side.
bool Outlined_solid::is_inside_out() const {
  std::vector<Vector> points;
  for (std::size_t e = 0; e < given.edges.size(); ++e)
    if (!passes_[e].empty())
      for (int k = 0; k < 8; ++k) points.push_back(wall_vector(point_of_edge(given, given.edges[e], k / 8.)));
  for (const Cad_solid::Face& face : given.faces) {
    if (face.wall) continue;
    const Vector normal = (face.turned ? -1. : 1.) * wall_vector(face.normal), origin = wall_vector(face.point);
    double low = 0, high = 0;
    for (const Vector& p : points) {
      low = (std::min)(low, dot(normal, p - origin));
      high = (std::max)(high, dot(normal, p - origin));
    }
    if (high < 1e-3 * -low) return false;
    if (-low < 1e-3 * high) return true;
  }
  return false;
}

void Outlined_solid::turn_inside_out() {
  for (Cad_solid::Face& face : given.faces) {
    face.turned = !face.turned;
    for (Cad_solid::Loop& loop : face.loops) {
      std::reverse(loop.edges.begin(), loop.edges.end());
      std::reverse(loop.reversed.begin(), loop.reversed.end());
      for (std::size_t i = 0; i < loop.edges.size(); ++i) {
        loop.reversed[i] = loop.reversed[i] == 0;
        loop.vertices[i] = given.edges[loop.edges[i]].ends[loop.reversed[i] != 0 ? 1 : 0];
      }
    }
  }
}

bool Outlined_solid::is_along(std::size_t edge, const Vector& axis) const {
  const Cad_solid::Edge& e = given.edges[edge];
  if (e.kind != "line") return false;
  const Vector d = vertex(e.ends[1]) - vertex(e.ends[0]);
  return wall_norm(cross_product(d, axis)) <= 1e-7 * wall_norm(d) + tolerance_;
}

// Walls are the faces that are no planes, and the planes beside them along their direction.
void Outlined_solid::find_walls() {
  is_wall_.assign(given.faces.size(), 0);
  axes_.assign(given.faces.size(), Vector(3));
  std::vector<std::size_t> next;
  std::vector<Vector> known;
  for (std::size_t f = 0; f < given.faces.size(); ++f) {
    if (!given.faces[f].wall) continue;
    Vector d = wall_vector(given.faces[f].normal);
    int largest = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(d[largest]) < std::abs(d[k]) - 1e-6) largest = k;
    d = (d[largest] < 0 ? -1 : 1) / wall_norm(d) * d;
    const auto same = std::find_if(known.begin(), known.end(),
                                   [&](const Vector& x) { return wall_norm(cross_product(x, d)) < 1e-9; });
    if (same != known.end())
      d = *same;
    else
      known.push_back(d);
    axes_[f] = d;
    is_wall_[f] = 1;
    next.push_back(f);
  }
  while (!next.empty()) {
    const std::size_t f = next.back();
    next.pop_back();
    for (const std::size_t e : given.faces[f].loops[0].edges)
      if (is_along(e, axes_[f]))
        for (const Pass& pass : passes_[e]) {
          if (is_wall_[pass.face]) {
            if (wall_norm(cross_product(axes_[pass.face], axes_[f])) > 1e-7)
              refuse(pass.face, "at " + edge_word(e) + " it meets " + face_name(f) + ", a wall in another direction");
            continue;
          }
          is_wall_[pass.face] = 1;
          axes_[pass.face] = axes_[f];
          next.push_back(pass.face);
        }
  }
}

// Returns whether an edge runs beside another one at the same places, maybe in the other direction.
bool Outlined_solid::curves_agree(std::size_t wall_edge, std::size_t other, bool reversed,
                                  const Wall_axis& axis) const {
  constexpr int n = 24;
  for (int i = 0; i <= n; ++i) {
    const double s = static_cast<double>(i) / n;
    const Vector p = wall_vector(point_of_edge(given, given.edges[wall_edge], s)),
                 q = wall_vector(point_of_edge(given, given.edges[other], reversed ? 1 - s : s));
    if (wall_norm(axis.flat(p) - axis.flat(q)) > 1e-6 * size + tolerance_) return false;
  }
  return true;
}

void Outlined_solid::add_wall(std::size_t face) {
  const Wall_axis axis(axes_[face]);
  const Cad_solid::Face& f = given.faces[face];
  std::vector<std::size_t> rims, sides;
  for (const std::size_t e : f.loops[0].edges) (is_along(e, axes_[face]) ? sides : rims).push_back(e);
  if (f.loops.size() != 1 || rims.size() != 2 || sides.size() != 2)
    refuse(face, "it has " + std::to_string(f.loops.size() == 1 ? rims.size() + sides.size() : f.loops.size()) +
                     (f.loops.size() == 1 ? " edges" : " boundaries") +
                     "; edges are rounded at walls with four edges, two of them along the wall");
  const auto level_of = [&](std::size_t e) {
    const double a = axis.height(vertex(given.edges[e].ends[0]));
    for (int i = 1; i <= 4; ++i)
      if (std::abs(axis.height(wall_vector(point_of_edge(given, given.edges[e], i / 4.))) - a) >
          1e-6 * size + tolerance_)
        refuse(face, edge_word(e) + " is not at right angles to the wall");
    return a;
  };
  double low = level_of(rims[0]), high = level_of(rims[1]);
  if (high < low) {
    std::swap(low, high);
    std::swap(rims[0], rims[1]);
  }
  const Cad_solid::Edge& below = given.edges[rims[0]];
  const auto has_end = [&](std::size_t side, std::size_t v) {
    return given.edges[side].ends[0] == v || given.edges[side].ends[1] == v;
  };
  if (!has_end(sides[0], below.ends[0])) std::swap(sides[0], sides[1]);
  if (!has_end(sides[0], below.ends[0]) || !has_end(sides[1], below.ends[1]))
    refuse(face, edge_word(rims[0]) + " does not lead from one side of the wall to the other");
  const bool forward = curves_agree(rims[0], rims[1], false, axis);
  if (!forward && !curves_agree(rims[0], rims[1], true, axis))
    refuse(face, edge_word(rims[0]) + " and " + edge_word(rims[1]) + " are not one curve, moved along the wall");
  std::array<std::size_t, 2> planes{};
  for (std::size_t k : {0, 1}) {
    for (const Pass& pass : passes_[rims[k]])
      if (pass.face != face) planes[k] = pass.face;
    const Cad_solid::Face& plane = given.faces[planes[k]];
    if (is_wall_[planes[k]]) refuse(face, edge_word(rims[k]) + " is between two walls in different directions");
    const Vector n = wall_vector(plane.normal);
    if (wall_norm(cross_product(n, axes_[face])) > 1e-7 * wall_norm(n))
      refuse(face, "at " + edge_word(rims[k]) + " it does not meet " + face_name(planes[k]) + " at a right angle");
  }
  wall_of_face_[face] = walls.size();
  walls.push_back({face,
                   axis,
                   {rims[0], rims[1]},
                   {true, forward},
                   {sides[0], sides[1]},
                   Wall_curve(below, axis, axis.flat(vertex(below.ends[0])), axis.flat(vertex(below.ends[1]))),
                   planes,
                   {low, high}});
  if (const auto kink = walls.back().curve.kink(0.05))
    refuse(face,
           edge_word(rims[0]) + " bends by " + std::to_string(kink->degrees) + " degrees inside; divide it there");
}

// The area of a loop, as seen from the tip of the normal.
double Outlined_solid::area(const Cad_solid::Loop& loop, const Vector& normal) const {
  std::vector<Vector> points;
  for (std::size_t i = 0; i < loop.edges.size(); ++i)
    for (int k = 0; k < 32; ++k)
      points.push_back(
          wall_vector(point_of_edge(given, given.edges[loop.edges[i]], loop.reversed[i] != 0 ? 1 - k / 32. : k / 32.)));
  Vector sum(3);
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    sum += cross_product(points[i] - points[0], points[i + 1] - points[0]);
  return dot(sum, normal) / 2;
}

void Outlined_solid::add_plane(std::size_t face) {
  const Cad_solid::Face& f = given.faces[face];
  const Vector normal = (f.turned ? -1. : 1.) * wall_vector(f.normal);
  std::vector<Solid::Loop> polygons;
  bool outer_is_polygon = false, has_outline = false;
  for (const Cad_solid::Loop& loop : f.loops) {
    std::size_t at_walls = 0;
    Outline outline{face, {}, area(loop, normal) > 0, 1, true};
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
      const std::vector<Pass>& passes = passes_[loop.edges[i]];
      const std::size_t other = passes[0].face == face ? passes[1].face : passes[0].face;
      const auto wall = wall_of_face_.find(other);
      if (wall == wall_of_face_.end()) {
        if (given.edges[loop.edges[i]].kind != "line")
          refuse(face, edge_word(loop.edges[i]) + " is no line, but a " + given.edges[loop.edges[i]].kind);
        continue;
      }
      ++at_walls;
      const Wall& w = walls[wall->second];
      const std::size_t level = w.rims[0] == loop.edges[i] ? 0 : 1;
      outline.rims.push_back({wall->second, level, w.along[level] == (loop.reversed[i] == 0)});
      outline.sign = dot(normal, w.axis.direction()) > 0 ? 1 : -1;
      outline.is_convex = (level == 1) == (outline.sign > 0);
    }
    if (at_walls > 0 && at_walls < loop.edges.size())
      refuse(face, "only some of the edges beside " + edge_word(loop.edges[0]) +
                       " lead to walls with rounded outlines; all edges of a boundary must, or none");
    if (at_walls > 0) {
      has_outline = true;
      outlines.push_back(std::move(outline));
    } else {
      polygons.push_back({loop.vertices, loop.edges});
      outer_is_polygon = outer_is_polygon || area(loop, normal) > 0;
      if (area(loop, normal) > 0) std::swap(polygons.front(), polygons.back());
    }
  }
  if (polygons.empty())
    caps.push_back(face);
  else if (has_outline && !outer_is_polygon)
    refuse(face,
           "a polygonal boundary inside of a rounded outline is not rounded, at " + edge_word(polygons[0].edges[0]));
  else {
    faces_of_polyhedron.push_back(face);
    polyhedron.faces.push_back({std::move(polygons), f.name});
  }
}

Outlined_solid::Outlined_solid(Cad_solid solid) : given(std::move(solid)), passes_(given.edges.size()) {
  for (const auto& p : given.vertices)
    for (const auto& q : {given.vertices[0], p}) size = (std::max)(size, wall_norm(wall_vector(p) - wall_vector(q)));
  for (const Cad_solid::Edge& e : given.edges) size = (std::max)(size, e.radius);
  tolerance_ = (std::min)(given.tolerance, 1e-4 * size);
  for (std::size_t f = 0; f < given.faces.size(); ++f)
    for (const Cad_solid::Loop& loop : given.faces[f].loops)
      for (std::size_t i = 0; i < loop.edges.size(); ++i) passes_[loop.edges[i]].push_back({f, loop.reversed[i] != 0});
  check_shell();
  if (is_inside_out()) {
    turn_inside_out();
    for (std::vector<Pass>& passes : passes_)
      for (Pass& pass : passes) pass.reversed = !pass.reversed;
  }
  find_walls();
  for (std::size_t f = 0; f < given.faces.size(); ++f)
    if (is_wall_[f]) add_wall(f);
  for (std::size_t f = 0; f < given.faces.size(); ++f)
    if (!is_wall_[f]) add_plane(f);
  if (polyhedron.faces.empty()) return;
  std::vector<std::optional<Solid_plane>> planes;
  const auto exact = [](const Vector& p) {
    return Solid::Point{CGAL::Exact_rational(p[0]), CGAL::Exact_rational(p[1]), CGAL::Exact_rational(p[2])};
  };
  for (std::size_t v = 0; v < given.vertices.size(); ++v) polyhedron.vertices.push_back(exact(vertex(v)));
  for (const std::size_t f : faces_of_polyhedron)
    planes.push_back(Solid_plane{exact(wall_vector(given.faces[f].point)), exact(wall_vector(given.faces[f].normal))});
  check_closed(polyhedron);
  make_planar(polyhedron, planes, given.tolerance);
}
