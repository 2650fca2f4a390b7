// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/Rounded_outlines.h"

#include "formats/solids/shell_of_solid.h"

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

Wall_curve::Spline spline_like(const Wall_curve::Spline& curve, const std::vector<Rail_vector>& points) {
  std::vector<Rail_point> p;
  for (const Rail_vector& x : points) p.emplace_back(x[0], x[1], x[2]);
  return {p.begin(), p.end(), curve.weights().begin(), curve.weights().end(), curve.knots()};
}

// The two unit vectors of a plane with a normal that is an axis, or any others.
std::array<Rail_vector, 2> vectors_in_plane(const Rail_vector& normal) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal[k]) < std::abs(normal[least])) least = k;
  Rail_vector x(3);
  x[least] = 1;
  x -= dot(x, normal) * normal;
  x = 1 / wall_norm(x) * x;
  return {x, cross_product(normal, x)};
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

// Fills a `Shell_model`.
class Outline_shell {
  const Rounded_outlines& r_;
  const Outlined_solid& solid_;
  Shell_model model_;
  typedef Rounded_outlines::Level Level;
  // of walls, on the wall and in the plane: an edge for each span; systems that integrate along
  // edges expect no inner knots
  std::map<Level, std::vector<int>> rim_edges_, rail_edges_;
  std::map<Level, int> side_vertices_, plane_vertices_; // of sides
  std::map<Level, int> profiles_;                       // of sides
  std::map<std::size_t, int> side_edges_;

  static std::array<double, 3> doubles(const Rail_vector& p) { return {p[0], p[1], p[2]}; }
  template <class P> static std::array<double, 3> numbers(const P& p) { return {p.x(), p.y(), p.z()}; }

  static bool all_equal(const std::vector<double>& weights) {
    return std::all_of(weights.begin(), weights.end(), [&](double w) { return w == weights[0]; });
  }

  int vertex(std::map<Level, int>& known, const Level& at, const std::array<double, 3>& p) {
    const auto [place, is_new] = known.emplace(at, static_cast<int>(model_.vertices.size()));
    if (is_new) model_.vertices.push_back(p);
    return place->second;
  }

  int add_edge(int degree, const std::vector<double>& knots, std::vector<std::array<double, 3>> points,
               std::vector<double> weights, int start, int end) {
    if (!weights.empty() && all_equal(weights)) weights.clear();
    model_.edges.push_back({{degree, knots, std::move(points), std::move(weights)}, start, end});
    return static_cast<int>(model_.edges.size()) - 1;
  }

  // The control points of the edge of a wall at one level.
  std::vector<std::array<double, 3>> points_at(std::size_t number, std::size_t level) const {
    std::vector<std::array<double, 3>> points;
    const auto rail = r_.rails_.find({number, level});
    if (rail == r_.rails_.end()) {
      for (const Rail_vector& p : r_.rim_points(solid_.walls[number], number, level)) points.push_back(doubles(p));
      return points;
    }
    const Rounded_outlines::Surface& s = r_.blends_[rail->second.blend].surface;
    for (int i = 0; i < s.number_of_points_u(); ++i) points.push_back(numbers(s.control_point(i, 0)));
    return points;
  }

  // The edges of the spans of a curve with these control points.
  std::vector<int> add_pieces(const Wall_curve::Spline& curve, const std::vector<std::array<double, 3>>& points,
                              int start, int end) {
    std::vector<Rail_vector> vectors;
    for (const std::array<double, 3>& p : points) vectors.push_back(wall_vector(p));
    std::vector<int> result;
    const auto pieces = spline_like(curve, vectors).bezier_pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto& piece = pieces[i];
      std::vector<std::array<double, 3>> net;
      for (const Rail_point& p : piece) net.push_back(numbers(p));
      int next = end;
      if (i + 1 < pieces.size()) {
        next = static_cast<int>(model_.vertices.size());
        model_.vertices.push_back(net.back());
      }
      const auto [from, to] = piece.domain();
      std::vector<double> knots(net.size(), from);
      knots.insert(knots.end(), net.size(), to);
      result.push_back(add_edge(piece.degree(), knots, std::move(net), {piece.weights().begin(), piece.weights().end()},
                                start, next));
      start = next;
    }
    return result;
  }

  // The edges along a wall and its blends at one level.
  void add_rim(std::size_t number, std::size_t level) {
    const Outlined_solid::Wall& wall = solid_.walls[number];
    const Wall_curve::Spline& curve = r_.curves_[number].spline();
    const auto rail = r_.rails_.find({number, level});
    const auto add = [&](std::map<Level, int>& vertices, const std::vector<std::array<double, 3>>& points) {
      const int start = vertex(vertices, {wall.sides[0], level}, points.front()),
                end = vertex(vertices, {wall.sides[1], level}, points.back());
      return add_pieces(curve, points, start, end);
    };
    rim_edges_[{number, level}] = add(side_vertices_, points_at(number, level));
    if (rail == r_.rails_.end()) return;
    const Rounded_outlines::Surface& s = r_.blends_[rail->second.blend].surface;
    const int n = s.number_of_points_u();
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < n; ++i) points.push_back(numbers(s.control_point(i, 5)));
    rail_edges_[{number, level}] = add(plane_vertices_, points);
    for (const int k : {0, 1}) {
      const Level side{wall.sides[static_cast<std::size_t>(k)], level};
      if (profiles_.count(side) > 0) continue;
      std::vector<std::array<double, 3>> column;
      for (int j = 0; j < 6; ++j) column.push_back(numbers(s.control_point(k == 0 ? 0 : n - 1, j)));
      profiles_[side] = add_edge(5, s.knots_v().knots(), column, {}, side_vertices_.at(side), plane_vertices_.at(side));
    }
  }

  // The uses of the pieces along u, where v is constant.
  void add_uses(const std::vector<int>& edges, bool reversed, double at, std::vector<Shell_model::Use>& loop) const {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const int edge = edges[reversed ? edges.size() - 1 - i : i];
      const std::vector<double>& knots = model_.edges[static_cast<std::size_t>(edge)].curve.knots;
      loop.push_back(use(edge, reversed, 1, at, knots.front(), knots.back()));
    }
  }

  // The use of an edge where one parameter of a surface is constant, and the other one leads from
  // the first value to the second.
  Shell_model::Use use(int edge, bool reversed, int constant, double at, double from, double to) const {
    const Shell_model::Spline_curve& c = model_.edges[static_cast<std::size_t>(edge)].curve;
    const auto point = [&](double t) {
      return constant == 0 ? std::array<double, 2>{at, t} : std::array<double, 2>{t, at};
    };
    return {edge,
            reversed,
            {1, {c.knots.front(), c.knots.front(), c.knots.back(), c.knots.back()}, {point(from), point(to)}}};
  }

  void add_wall(std::size_t number) {
    const Outlined_solid::Wall& wall = solid_.walls[number];
    const Wall_curve& curve = r_.curves_[number];
    Shell_model::Face face;
    face.name = solid_.given.faces[wall.face].name;
    Shell_model::Surface& s = face.surface;
    const std::array<std::vector<std::array<double, 3>>, 2> rims{points_at(number, 0), points_at(number, 1)};
    s.degree_u = curve.spline().degree();
    s.degree_v = 1;
    s.knots_u = curve.spline().knots().knots();
    s.knots_v = {0, 0, 1, 1};
    for (std::size_t i = 0; i < rims[0].size(); ++i) s.points.push_back({rims[0][i], rims[1][i]});
    if (!curve.spline().is_polynomial())
      for (const double w : curve.spline().weights()) s.weights.push_back({w, w});
    const Rail_vector along = curve.tangent(curve.domain().first);
    s.plane = curve.kind() == Wall_curve::Kind::line && wall.axis.is_coordinate_axis() &&
              std::count_if(along.begin(), along.end(), [](double x) { return x == 0; }) == 2;
    if (s.plane) {
      s.origin = rims[0][0];
      s.x = doubles(along);
      s.y = doubles(wall.axis.direction());
    }
    const auto [begin, end] = curve.domain();
    const int left = side_edges_.at(wall.sides[0]), right = side_edges_.at(wall.sides[1]);
    std::vector<Shell_model::Use>& loop = face.loops.emplace_back();
    add_uses(rim_edges_.at({number, 0}), false, 0, loop);
    loop.push_back(use(right, false, 0, end, 0, 1));
    add_uses(rim_edges_.at({number, 1}), true, 1, loop);
    loop.push_back(use(left, true, 0, begin, 0, 1));
    face.reversed = !runs_with_outside(number);
    model_.faces.push_back(std::move(face));
  }
  // Returns whether the cross product of the curve and the axis points out of the solid.
  bool runs_with_outside(std::size_t number) const {
    for (const Outlined_solid::Outline& outline : solid_.outlines)
      for (const Outlined_solid::Rim& rim : outline.rims)
        if (rim.wall == number) return ((outline.sign > 0) == rim.along) == outline.is_convex;
    return true;
  }

  void add_blend(const Outlined_solid::Rim& rim, const std::string& name) {
    const Outlined_solid::Wall& wall = solid_.wall_at(rim);
    const Level level{rim.wall, rim.level};
    const Rounded_outlines::Surface& s = r_.blends_[r_.rails_.at(level).blend].surface;
    Shell_model::Face face;
    face.name = name;
    face.surface.degree_u = s.degree_u();
    face.surface.degree_v = 5;
    face.surface.knots_u = s.knots_u().knots();
    face.surface.knots_v = s.knots_v().knots();
    for (int i = 0; i < s.number_of_points_u(); ++i) {
      face.surface.points.emplace_back();
      for (int j = 0; j < 6; ++j) face.surface.points.back().push_back(numbers(s.control_point(i, j)));
      if (!s.is_polynomial()) face.surface.weights.push_back(std::vector<double>(6, s.weight(i, 0)));
    }
    const auto [begin, end] = s.domain_u();
    std::vector<Shell_model::Use>& loop = face.loops.emplace_back();
    add_uses(rim_edges_.at(level), false, 0, loop);
    loop.push_back(use(profiles_.at({wall.sides[1], rim.level}), false, 0, end, 0, 1));
    add_uses(rail_edges_.at(level), true, 1, loop);
    loop.push_back(use(profiles_.at({wall.sides[0], rim.level}), true, 0, begin, 0, 1));
    face.reversed = !rim.along;
    model_.faces.push_back(std::move(face));
  }

  std::vector<Rounded_solid::Use> loop(const Outlined_solid::Outline& outline) const {
    std::vector<Rounded_solid::Use> uses;
    for (const Outlined_solid::Rim& rim : outline.rims) {
      const auto rail = rail_edges_.find({rim.wall, rim.level});
      const std::vector<int>& edges = rail == rail_edges_.end() ? rim_edges_.at({rim.wall, rim.level}) : rail->second;
      for (std::size_t i = 0; i < edges.size(); ++i)
        uses.push_back({static_cast<std::size_t>(edges[rim.along ? i : edges.size() - 1 - i]), !rim.along});
    }
    return uses;
  }

  void add_cap(std::size_t number) {
    Rounded_solid::Face cap{number, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {}};
    for (const Outlined_solid::Outline& outline : solid_.outlines) {
      if (outline.face != number) continue;
      cap.loops.push_back(loop(outline));
      if (outline.is_outer) std::swap(cap.loops.front(), cap.loops.back());
    }
    const Rounded_outlines::Plane& plane = r_.planes_.at(number);
    const auto axes = vectors_in_plane(plane.normal);
    Shell_model::Face face;
    face.name = solid_.given.faces[number].name;
    face.surface = Shell_model::Surface{};
    face.surface.plane = true;
    face.surface.origin = doubles(plane.origin);
    face.surface.x = doubles(axes[0]);
    face.surface.y = doubles(axes[1]);
    for (const auto& uses : cap.loops) {
      face.loops.emplace_back();
      for (const Rounded_solid::Use& u : uses) face.loops.back().push_back({static_cast<int>(u.edge), u.reversed, {}});
    }
    model_.faces.push_back(std::move(face));
  }

public:
  Outline_shell(const Rounded_outlines& r, const std::vector<std::string>& face_names,
                const std::vector<std::string>& blend_names)
      : r_(r), solid_(r.solid_) {
    if (r.polyhedron_ != nullptr) add_edges_of_solid(*r.polyhedron_, model_);
    for (std::size_t w = 0; w < solid_.walls.size(); ++w)
      for (const std::size_t level : {0, 1}) add_rim(w, level);
    for (const Outlined_solid::Wall& wall : solid_.walls)
      for (const std::size_t side : wall.sides) {
        if (side_edges_.count(side) > 0) continue;
        const int low = side_vertices_.at({side, 0}), high = side_vertices_.at({side, 1});
        side_edges_[side] =
            add_edge(1, {0, 0, 1, 1},
                     {model_.vertices[static_cast<std::size_t>(low)], model_.vertices[static_cast<std::size_t>(high)]},
                     {}, low, high);
      }
    if (r.polyhedron_ != nullptr) {
      Rounded_solid with_outlines = *r.polyhedron_;
      for (Rounded_solid::Face& face : with_outlines.faces)
        for (const Outlined_solid::Outline& outline : solid_.outlines)
          if (outline.face == solid_.faces_of_polyhedron[face.face]) face.loops.push_back(loop(outline));
      add_faces_of_solid(with_outlines, face_names, blend_names, model_);
    }
    for (const std::size_t cap : solid_.caps) add_cap(cap);
    for (std::size_t w = 0; w < solid_.walls.size(); ++w) add_wall(w);
    for (const Outlined_solid::Outline& outline : solid_.outlines)
      for (const Outlined_solid::Rim& rim : outline.rims)
        if (r.rails_.count({rim.wall, rim.level}) > 0)
          add_blend(rim, "blend of " + std::to_string(solid_.edge_of(rim)));
  }
  const Shell_model& model() const { return model_; }
};

Shell_model Rounded_outlines::shell(const std::vector<std::string>& face_names,
                                    const std::vector<std::string>& blend_names) const {
  return Outline_shell(*this, face_names, blend_names).model();
}
