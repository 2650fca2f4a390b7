// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/Rounded_outlines.h"
#include "formats/solids/shell_of_solid.h"

#include <algorithm>

namespace {

typedef Rounded_outlines::Vector Rail_vector;
typedef Wall_curve::Traits::Point Rail_point;

} // namespace

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
