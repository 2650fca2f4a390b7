// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/Rounded_outlines.h"

#include <CGAL/Geometric_continuity/models/round_polyhedron.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace {

typedef Rounded_outlines::Vector Rail_vector;
typedef Wall_curve::Traits::Point Rail_point;

std::string number_words(double x) {
  std::ostringstream os;
  os << x;
  return os.str();
}
std::string place_words(const Rail_vector& p) {
  return '(' + number_words(p[0]) + ", " + number_words(p[1]) + ", " + number_words(p[2]) + ')';
}
[[noreturn]] void refuse_edge(std::size_t edge, const std::string& reason) {
  throw std::runtime_error("edge " + std::to_string(edge) + ": " + reason);
}

} // namespace

Rounded_outlines::Rounded_outlines(const Outlined_solid& solid, std::vector<double> cuts, double fullness,
                                   const Rounded_solid* polyhedron)
    : solid_(solid), cuts_(std::move(cuts)), fullness_(fullness > 0 ? fullness : 0.6875), polyhedron_(polyhedron) {
  for (const Outlined_solid::Wall& wall : solid.walls) {
    curves_.push_back(wall.curve);
    if (cuts_[wall.rims[0]] > 0 || cuts_[wall.rims[1]] > 0) curves_.back().refine();
  }
  find_planes();
  check_sides();
  check_heights();
  for (std::size_t i = 0; i < solid.outlines.size(); ++i) add_outline(i);
  for (const auto& [face, plane] : planes_) check_rails(face);
}

double Rounded_outlines::error() const {
  double error = 0;
  for (const auto& [level, rail] : rails_) error = (std::max)(error, curves_[level.first].error());
  return error;
}

void Rounded_outlines::find_planes() {
  for (const Outlined_solid::Outline& outline : solid_.outlines) {
    const Cad_solid::Face& face = solid_.given.faces[outline.face];
    Rail_vector origin(3), normal(3);
    for (int k = 0; k < 3; ++k) origin[k] = face.point[static_cast<std::size_t>(k)];
    normal = outline.sign * solid_.wall_at(outline.rims[0]).axis.direction();
    const auto number = std::find(solid_.faces_of_polyhedron.begin(), solid_.faces_of_polyhedron.end(), outline.face);
    if (number != solid_.faces_of_polyhedron.end()) {
      const auto place =
          std::find_if(polyhedron_->faces.begin(), polyhedron_->faces.end(), [&](const Rounded_solid::Face& f) {
            return f.face == static_cast<std::size_t>(number - solid_.faces_of_polyhedron.begin());
          });
      if (place == polyhedron_->faces.end())
        throw std::runtime_error(solid_.face_name(outline.face) +
                                 ": a neighbour lies in its plane; unite them, so that its outlines can be rounded");
      origin = wall_vector(place->origin);
      const Rail_vector across = cross_product(wall_vector(place->x), wall_vector(place->y));
      if (wall_norm(cross_product(normal, across)) != 0) normal = 1 / wall_norm(across) * across;
    }
    planes_[outline.face] = {origin, normal};
  }
}

Rail_vector Rounded_outlines::on_plane(std::size_t face, const Wall_axis& axis, const Vector& flat) const {
  const Plane& plane = planes_.at(face);
  if (axis.is_coordinate_axis() && is_zero(cross_product(plane.normal, axis.direction())))
    return axis.at(flat, axis.height(plane.origin));
  return axis.at(flat, dot(plane.normal, plane.origin - flat) / dot(plane.normal, axis.direction()));
}

// The control points of a rim that is not rounded.
std::vector<Rail_vector> Rounded_outlines::rim_points(const Outlined_solid::Wall& wall, std::size_t number,
                                                      std::size_t level) const {
  std::vector<Vector> points;
  for (const Rail_point& p : curves_[number].spline())
    points.push_back(on_plane(wall.planes[level], wall.axis, wall_vector(p)));
  return points;
}

// Sides of walls are not rounded.
void Rounded_outlines::check_sides() const {
  for (const Outlined_solid::Wall& wall : solid_.walls)
    for (const std::size_t side : wall.sides)
      if (cuts_[side] > 0)
        refuse_edge(side,
                    "it runs along the walls of an outline, where edges are not rounded: leave it out of --edges, "
                    "or name the others there");
}

void Rounded_outlines::check_heights() const {
  for (const Outlined_solid::Wall& wall : solid_.walls) {
    const double below = cuts_[wall.rims[0]], above = cuts_[wall.rims[1]], height = wall.heights[1] - wall.heights[0];
    if (below + above < height) continue;
    const std::string bound = below > 0 && above > 0
                                  ? (below == above ? " must be less than " + number_words(height / 2)
                                                    : "s " + number_words(below) + " and " + number_words(above) +
                                                          " together must be less than " + number_words(height))
                                  : " must be less than " + number_words(height);
    refuse_edge(wall.rims[above > 0 ? 1 : 0], "the cuts meet on " + solid_.face_name(wall.face) + ", which is " +
                                                  number_words(height) + " high; the set-back" + bound);
  }
}

// The direction of the rails where rim i of an outline begins: the normal of the outline in the
// plane, or where two lines meet in a corner, the way to where their rails meet.
Rail_vector Rounded_outlines::direction_at(const Outlined_solid::Outline& outline, std::size_t i) {
  const std::size_t n = outline.rims.size();
  const Outlined_solid::Rim &rim = outline.rims[i], &before = outline.rims[(i + n - 1) % n];
  const auto [s, t] = solid_.tangents(before, rim);
  const Vector axis = outline.sign * solid_.wall_at(rim).axis.direction(), m = cross_product(axis, s),
               k = cross_product(axis, t);
  const double angle = std::atan2(wall_norm(cross_product(s, t)), dot(s, t)) * 180 / M_PI;
  if (angle <= smooth_degrees) {
    const Vector sum = curves_[rim.wall].kind() == Wall_curve::Kind::line ? k : m;
    return 1 / wall_norm(sum) * sum;
  }
  const std::size_t edge = solid_.edge_of(rim), other = solid_.edge_of(before);
  if (angle < 150 && curves_[rim.wall].kind() == Wall_curve::Kind::line &&
      curves_[before.wall].kind() == Wall_curve::Kind::line) {
    ++mitres_;
    return 1 / (1 + dot(m, k)) * (m + k);
  }
  const Cad_solid::Edge& e = solid_.given.edges[edge];
  const bool from_start = rim.along == solid_.wall_at(rim).along[rim.level];
  refuse_edge(edge, "at " + place_words(solid_.vertex(e.ends[from_start ? 0 : 1])) + " it meets edge " +
                        std::to_string(other) + " at a corner of " + number_words(angle) +
                        " degrees; arcs and splines are rounded where the outline is smooth: leave all of its edges "
                        "sharp, by --edges with others");
}

void Rounded_outlines::check_curve(const Outlined_solid::Rim& rim, int side, const Directions& directions) const {
  const Wall_curve& curve = curves_[rim.wall];
  const std::size_t edge = solid_.edge_of(rim);
  const double d = cut(rim);
  if (const auto least = curve.least_radius(side); least && !(d < least->radius))
    refuse_edge(
        edge, "near " +
                  place_words(on_plane(solid_.wall_at(rim).planes[rim.level], solid_.wall_at(rim).axis, least->place)) +
                  " it bends to the side of its plane with the radius " + number_words(least->radius) +
                  "; the set-back " + number_words(d) + " must be less");
  const Wall_curve::Spline rail = spline_like(curve.spline(), curve.rail(d, side, directions));
  const auto derivative = [](const Wall_curve::Spline& c, double u) { return wall_vector(c.jet(u, 1).derivative(1)); };
  for (const double u : curve.samples(8))
    if (!(dot(derivative(rail, u), derivative(curve.spline(), u)) > 0))
      refuse_edge(edge, "the cuts at its ends meet; take a smaller set-back than " + number_words(d));
}

void Rounded_outlines::add_outline(std::size_t number) {
  const Outlined_solid::Outline& outline = solid_.outlines[number];
  const double d = cut(outline.rims[0]);
  for (const Outlined_solid::Rim& rim : outline.rims)
    if (cut(rim) != d)
      refuse_edge(solid_.edge_of(rim), "its set-back is " + number_words(cut(rim)) + ", and " + number_words(d) +
                                           " that of edge " + std::to_string(solid_.edge_of(outline.rims[0])) +
                                           ", of the same outline: an outline is rounded as a whole");
  if (!(d > 0)) return;
  rounded_.push_back(number);
  const std::size_t n = outline.rims.size();
  std::vector<Vector> directions;
  for (std::size_t i = 0; i < n; ++i) directions.push_back(direction_at(outline, i));
  for (std::size_t i = 0; i < n; ++i) {
    const Outlined_solid::Rim& rim = outline.rims[i];
    const Outlined_solid::Wall& wall = solid_.wall_at(rim);
    const int side = rim.along ? outline.sign : -outline.sign;
    Directions ends{directions[i], directions[(i + 1) % n]};
    if (!rim.along) std::swap(ends[0], ends[1]);
    check_curve(rim, side, ends);
    const Wall_curve& curve = curves_[rim.wall];
    std::vector<Vector> outline_points = rim_points(wall, rim.wall, rim.level), rail_points;
    for (const Vector& p : curve.rail(d, side, ends))
      rail_points.push_back(on_plane(outline.face, wall.axis, wall.axis.flat(p)));
    const Vector down = (rim.level == 0 ? d : -d) * wall.axis.direction();
    rails_[{rim.wall, rim.level}] = {blends_.size(), side, ends};
    blends_.push_back({solid_.edge_of(rim), number,
                       GC::outline_blend<Wall_curve::Traits>(
                           spline_like(curve.spline(), outline_points), spline_like(curve.spline(), rail_points),
                           Wall_curve::Traits::Vector(down[0], down[1], down[2]), fullness_),
                       false, false, 0});
    decide(blends_.back(), rim);
  }
}

// Three rows lie on the wall, along its direction, and three in the plane: with exact numbers, or
// up to rounding.
void Rounded_outlines::decide(Blend& blend, const Outlined_solid::Rim& rim) const {
  typedef CGAL::Exact_rational Exact;
  typedef GC::Coordinate_vector<Exact, 3> Exact_vector;
  const auto exact = [](const auto& p) {
    Exact_vector v(3);
    for (int k = 0; k < 3; ++k) v[k] = Exact(p[k]);
    return v;
  };
  const Outlined_solid::Wall& wall = solid_.wall_at(rim);
  const Plane& plane = planes_.at(wall.planes[rim.level]);
  const Exact_vector direction = exact(wall.axis.direction()), normal = exact(plane.normal),
                     origin = exact(plane.origin);
  blend.exact_at_wall = blend.exact_in_plane = true;
  Exact most(0);
  const auto look = [&](const Exact& off, bool& exactly) {
    if (off == 0) return;
    exactly = false;
    most = (std::max)(most, CGAL::abs(off));
  };
  for (int i = 0; i < blend.surface.number_of_points_u(); ++i) {
    const Exact_vector rail = exact(blend.surface.control_point(i, 0));
    for (int j = 0; j < 3; ++j) {
      const Exact_vector p = exact(blend.surface.control_point(i, j)),
                         across = cross_product(Exact_vector(p - rail), direction);
      for (int k = 0; k < 3; ++k) look(across[k], blend.exact_at_wall);
    }
    for (int j = 3; j < 6; ++j)
      look(dot(normal, Exact_vector(exact(blend.surface.control_point(i, j)) - origin)), blend.exact_in_plane);
  }
  blend.off = CGAL::to_double(most);
}

std::vector<Rounded_outlines::Polygon> Rounded_outlines::polygons(std::size_t face, double factor) const {
  std::vector<Polygon> result;
  const auto axes = vectors_in_plane(planes_.at(face).normal);
  const auto in_plane = [&](const Vector& p) { return std::array<double, 2>{dot(p, axes[0]), dot(p, axes[1])}; };
  for (const Outlined_solid::Outline& outline : solid_.outlines) {
    if (outline.face != face) continue;
    Polygon polygon{{}, {}, outline.is_outer};
    for (const Outlined_solid::Rim& rim : outline.rims) {
      const Wall_curve& curve = curves_[rim.wall];
      const auto rail = rails_.find({rim.wall, rim.level});
      const Wall_curve::Spline spline =
          rail == rails_.end()
              ? curve.spline()
              : spline_like(curve.spline(), curve.rail(factor * cut(rim), rail->second.side, rail->second.directions));
      std::vector<double> samples = curve.samples(curve.kind() == Wall_curve::Kind::line ? 1 : 24);
      if (!rim.along) std::reverse(samples.begin(), samples.end());
      for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        polygon.points.push_back(in_plane(wall_vector(spline(samples[i]))));
        polygon.edges.push_back(solid_.edge_of(rim));
      }
    }
    result.push_back(std::move(polygon));
  }
  for (std::size_t i = 0; i < solid_.faces_of_polyhedron.size(); ++i) {
    if (solid_.faces_of_polyhedron[i] != face) continue;
    for (const Rounded_solid::Face& f : polyhedron_->faces) {
      if (f.face != i) continue;
      for (std::size_t k = 0; k < f.loops.size(); ++k) {
        Polygon polygon{{}, {}, k == 0};
        for (const Rounded_solid::Use& use : f.loops[k]) {
          const Rounded_solid::Curve& c = polyhedron_->edges[use.edge].curve;
          const auto [begin, end] = c.domain();
          const int n = c.degree() == 1 ? 1 : 24;
          for (int j = 0; j < n; ++j) {
            const double part = static_cast<double>(use.reversed ? n - j : j) / n;
            polygon.points.push_back(in_plane(wall_vector(c(begin + part * (end - begin)))));
            polygon.edges.push_back(static_cast<std::size_t>(-1));
          }
        }
        result.push_back(std::move(polygon));
      }
    }
  }
  return result;
}

namespace {

double side_of(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

bool segments_meet(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c,
                   const std::array<double, 2>& d) {
  for (const std::size_t k : {0, 1}) // they may lie on one line
    if ((std::max)(a[k], b[k]) < (std::min)(c[k], d[k]) || (std::max)(c[k], d[k]) < (std::min)(a[k], b[k]))
      return false;
  return side_of(a, b, c) * side_of(a, b, d) <= 0 && side_of(c, d, a) * side_of(c, d, b) <= 0;
}

bool is_inside(const std::vector<std::array<double, 2>>& polygon, const std::array<double, 2>& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if ((side_of(a, b, p) > 0) == (b[1] > a[1])) inside = !inside;
  }
  return inside;
}

} // namespace

// Two edges whose rails meet, or lie on the wrong sides of each other.
std::optional<std::pair<std::size_t, std::size_t>> Rounded_outlines::meeting_edges(std::size_t face,
                                                                                   double factor) const {
  const std::vector<Polygon> all = polygons(face, factor);
  struct Segment {
    std::size_t polygon, number;
    double low, high;
  };
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < all[k].points.size(); ++i) {
      const double a = all[k].points[i][0], b = all[k].points[(i + 1) % all[k].points.size()][0];
      segments.push_back({k, i, (std::min)(a, b), (std::max)(a, b)});
    }
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) { return a.low < b.low; });
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size() && segments[j].low <= segments[i].high; ++j) {
      const Segment &s = segments[i], &t = segments[j];
      const Polygon &p = all[s.polygon], &q = all[t.polygon];
      if (s.polygon == t.polygon && ((s.number + 1) % p.points.size() == t.number ||
                                     (t.number + 1) % p.points.size() == s.number || p.points.size() < 3))
        continue;
      if (segments_meet(p.points[s.number], p.points[(s.number + 1) % p.points.size()], q.points[t.number],
                        q.points[(t.number + 1) % q.points.size()]))
        return std::pair(p.edges[s.number], q.edges[t.number]);
    }
  for (const Polygon& p : all)
    for (const Polygon& q : all)
      if (&p != &q && !q.is_outer &&
          (p.is_outer ? !is_inside(p.points, q.points[0]) : is_inside(p.points, q.points[0])))
        return std::pair(p.edges[0], q.edges[0]);
  return std::nullopt;
}

void Rounded_outlines::check_rails(std::size_t face) const {
  const auto meeting = meeting_edges(face, 1);
  if (!meeting) return;
  double low = 0, high = 1;
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    (meeting_edges(face, middle) ? high : low) = middle;
  }
  const auto [a, b] = *meeting;
  const std::size_t none = static_cast<std::size_t>(-1), edge = a == none ? b : a, other = a == none ? a : b;
  if (edge == none)
    throw std::runtime_error(solid_.face_name(face) + ": the cuts of its straight edges meet; take smaller set-backs");
  const std::string reason = "its cut meets that of " +
                             (other == none   ? "a straight edge"
                              : other == edge ? "another part of it"
                                              : "edge " + std::to_string(other)) +
                             " on " + solid_.face_name(face) + "; ";
  if (low == 0) refuse_edge(edge, reason + "take smaller set-backs");
  refuse_edge(edge, reason + "set-backs of outlines there must be less than " + number_words(low) +
                        " times as large; " + number_words(cuts_[edge]) + " must be less than " +
                        number_words(low * cuts_[edge]));
}
