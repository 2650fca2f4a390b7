// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes solids, as the program does, to the current folder: a box, a box with a rounded edge, a
// ring of two closed surfaces, and a cushion of one closed surface between two planes. Checks that
// their splines are read back as the same doubles, and that shells which are no solid are refused,
// with the reason and without a file.

#include "write_model.h"

#include "formats/cad/opencascade/cad_surface.h"
#include "formats/cad/opencascade/read_model.h"
#include "formats/cad/opencascade/write_shell.h"
#include "formats/cad/run_along_v.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>

#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <variant>

namespace {

typedef std::array<double, 3> Point;
typedef std::array<double, 2> Point_2;

// Knots of one polynomial of this degree on [0, 1].
std::vector<double> unit_knots(int degree) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return knots;
}

Shell_model::Spline_curve_2 line_2(const std::vector<double>& knots, const Point_2& a, const Point_2& b) {
  return {1, {knots.front(), knots.front(), knots.back(), knots.back()}, {a, b}};
}

// A shell with its vertices found by their points.
class Shell_maker {
public:
  Shell_model shell;

  int vertex(const Point& p) {
    const auto found = std::find(shell.vertices.begin(), shell.vertices.end(), p);
    if (found != shell.vertices.end()) return static_cast<int>(found - shell.vertices.begin());
    shell.vertices.push_back(p);
    return static_cast<int>(shell.vertices.size()) - 1;
  }
  int edge(int degree, const std::vector<double>& knots, const std::vector<Point>& points) {
    shell.edges.push_back({{degree, knots, points}, vertex(points.front()), vertex(points.back())});
    return static_cast<int>(shell.edges.size()) - 1;
  }
  int line(const Point& a, const Point& b) { return edge(1, unit_knots(1), {a, b}); }

  // A face of the plane o + u x + v y. A loop passes an edge number e forwards if it is given as e,
  // and backwards if as ~e.
  void plane(const Point& o, const Point& x, const Point& y, const std::vector<std::vector<int>>& loops,
             const std::string& name) {
    Shell_model::Face face;
    face.surface.degree_u = face.surface.degree_v = 0;
    face.surface.plane = true;
    face.surface.origin = o;
    face.surface.x = x;
    face.surface.y = y;
    face.name = name;
    for (const std::vector<int>& loop : loops) {
      face.loops.emplace_back();
      for (const int e : loop) {
        const Shell_model::Spline_curve& c = shell.edges[static_cast<std::size_t>(e < 0 ? ~e : e)].curve;
        Shell_model::Spline_curve_2 flat{c.degree, c.knots, {}};
        for (const Point& p : c.points) {
          Point_2 uv{0, 0};
          for (std::size_t i = 0; i < 3; ++i) {
            uv[0] += (p[i] - o[i]) * x[i];
            uv[1] += (p[i] - o[i]) * y[i];
          }
          flat.points.push_back(uv);
        }
        face.loops.back().push_back({e < 0 ? ~e : e, e < 0, flat});
      }
    }
    shell.faces.push_back(face);
  }

  // A face of a spline surface with all of its rectangle of parameters, by the edges along v = 0,
  // u = 1, v = 1 and u = 0, which run in the direction of the parameters.
  void patch(int degree_u, int degree_v, const std::vector<std::vector<Point>>& points, const std::array<int, 4>& e,
             const std::string& name) {
    Shell_model::Face face;
    const std::vector<double> u = unit_knots(degree_u), v = unit_knots(degree_v);
    face.surface = {degree_u, degree_v, u, v, points, false, {}, {}, {}};
    face.name = name;
    face.loops = {{{e[0], false, line_2(u, {0, 0}, {1, 0})},
                   {e[1], false, line_2(v, {1, 0}, {1, 1})},
                   {e[2], true, line_2(u, {0, 1}, {1, 1})},
                   {e[3], true, line_2(v, {0, 0}, {0, 1})}}};
    shell.faces.push_back(face);
  }

  // A face of a surface that is closed in u, between two closed edges that run along u.
  void ring(int degree_u, const std::vector<double>& u, int degree_v, const std::vector<std::vector<Point>>& points,
            int low, int high, const std::string& name) {
    Shell_model::Face face;
    face.surface = {degree_u, degree_v, u, unit_knots(degree_v), points, false, {}, {}, {}};
    face.name = name;
    face.loops = {{{high, true, line_2(u, {u.front(), 1}, {u.back(), 1})}},
                  {{low, false, line_2(u, {u.front(), 0}, {u.back(), 0})}}};
    shell.faces.push_back(face);
  }
};

Shell_model box(double a, double b, double c) {
  Shell_maker m;
  const auto corner = [&](int i) { return Point{i & 1 ? a : 0, i & 2 ? b : 0, i & 4 ? c : 0}; };
  int edges[8][8];
  for (int i = 0; i < 8; ++i)
    for (int bit = 1; bit < 8; bit *= 2)
      if ((i & bit) == 0) {
        edges[i][i | bit] = m.line(corner(i), corner(i | bit));
        edges[i | bit][i] = ~edges[i][i | bit];
      }
  const auto face = [&](int i, int j, int k, int l, const Point& x, const Point& y, const char* name) {
    m.plane(corner(i), x, y, {{edges[i][j], edges[j][k], edges[k][l], edges[l][i]}}, name);
  };
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  face(0, 2, 3, 1, y, x, "bottom");
  face(4, 5, 7, 6, x, y, "top");
  face(0, 1, 5, 4, x, z, "front");
  face(3, 2, 6, 7, {-1, 0, 0}, z, "back");
  face(1, 3, 7, 5, y, z, "right");
  face(2, 0, 4, 6, {0, -1, 0}, z, "");
  return m.shell;
}

// A box whose edge at x = a, z = c is rounded by a quintic profile, at a distance of r.
Shell_model rounded_box(double a, double b, double c, double r) {
  Shell_maker m;
  std::array<std::vector<Point>, 2> profile;
  for (std::size_t side = 0; side < 2; ++side) {
    const double y = side == 0 ? 0 : b;
    for (const auto& [x, z] :
         std::array<std::array<double, 2>, 6>{{{0, 1}, {0.5, 1}, {1, 1}, {1, 1}, {1, 0.5}, {1, 0}}})
      profile[side].push_back({a - r + x * r, y, c - r + z * r});
  }
  // Around the ends: the corners at y = 0, then at y = b.
  std::array<std::array<Point, 5>, 2> p;
  for (std::size_t side = 0; side < 2; ++side) {
    const double y = side == 0 ? 0 : b;
    p[side] = {Point{0, y, 0}, {a, y, 0}, profile[side].back(), profile[side].front(), {0, y, c}};
  }
  std::array<std::array<int, 5>, 2> around; // edge i leads from corner i to the next one
  std::array<int, 5> across;
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t side = 0; side < 2; ++side)
      around[side][i] = i == 2 ? ~m.edge(5, unit_knots(5), profile[side]) : m.line(p[side][i], p[side][(i + 1) % 5]);
    across[i] = m.line(p[0][i], p[1][i]);
  }
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, minus_x{-1, 0, 0};
  const auto& f = around[0];
  const auto& k = around[1];
  m.plane({0, 0, 0}, x, z, {{f[0], f[1], f[2], f[3], f[4]}}, "front");
  m.plane({0, b, 0}, minus_x, z, {{~k[4], ~k[3], ~k[2], ~k[1], ~k[0]}}, "back");
  m.plane({0, 0, 0}, y, x, {{across[0], k[0], ~across[1], ~f[0]}}, "bottom");
  m.plane({a, 0, 0}, y, z, {{across[1], k[1], ~across[2], ~f[1]}}, "right");
  m.plane({0, 0, c}, x, y, {{~f[3], across[3], k[3], ~across[4]}}, "top");
  m.plane({0, 0, 0}, {0, -1, 0}, z, {{across[4], k[4], ~across[0], ~f[4]}}, "left");
  std::vector<std::vector<Point>> net;
  for (std::size_t i = 0; i < 6; ++i) net.push_back({profile[0][i], profile[1][i]});
  m.patch(5, 1, net, {~f[2], across[2], ~k[2], across[3]}, "blend 0");
  return m.shell;
}

// A closed cubic spline round the z axis, uniform but clamped, through no point twice: its control
// points, of which the last one is the first one.
struct Round {
  std::vector<double> knots;
  std::vector<Point_2> points;

  Round() {
    const std::vector<Point_2> given{{3, 0}, {3, 2}, {0, 2}, {-3, 2}, {-3, 0}, {-3, -2}, {0, -2}, {3, -2}};
    const std::size_t n = given.size();
    const auto mix = [](const Point_2& a, const Point_2& b, double t) {
      return Point_2{(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]};
    };
    const Point_2 first = mix(given[0], given[1], 1.0 / 3), last = mix(given[n - 1], given[0], 2.0 / 3),
                  ends = mix(last, first, 0.5);
    points = {ends, first};
    points.insert(points.end(), given.begin() + 1, given.end());
    points.push_back(last);
    points.push_back(ends);
    knots = {0, 0, 0};
    for (std::size_t i = 0; i <= n; ++i) knots.push_back(static_cast<double>(i));
    knots.insert(knots.end(), 3, static_cast<double>(n));
  }
  std::vector<Point> at(double scale, double z) const {
    std::vector<Point> result;
    for (const Point_2& p : points) result.push_back({scale * p[0], scale * p[1], z});
    return result;
  }
  // Rows of points over v: a scale and a height for each.
  std::vector<std::vector<Point>> net(const std::vector<Point_2>& profile) const {
    std::vector<std::vector<Point>> result(points.size());
    for (const Point_2& v : profile) {
      const std::vector<Point> row = at(v[0], v[1]);
      for (std::size_t i = 0; i < points.size(); ++i) result[i].push_back(row[i]);
    }
    return result;
  }
};

Shell_model ring() {
  Shell_maker m;
  const Round round;
  const int low = m.edge(3, round.knots, round.at(1, -1)), high = m.edge(3, round.knots, round.at(1, 1));
  m.ring(3, round.knots, 3, round.net({{1, -1}, {1.5, -1}, {1.5, 1}, {1, 1}}), low, high, "outside");
  m.ring(3, round.knots, 3, round.net({{1, -1}, {0.5, -1}, {0.5, 1}, {1, 1}}), low, high, "inside");
  m.shell.faces.back().reversed = true;
  return m.shell;
}

Shell_model cushion() {
  Shell_maker m;
  const Round round;
  const int low = m.edge(3, round.knots, round.at(1, -1)), high = m.edge(3, round.knots, round.at(1, 1));
  m.ring(3, round.knots, 5, round.net({{1, -1}, {1.25, -1}, {1.5, -1}, {1.5, 1}, {1.25, 1}, {1, 1}}), low, high,
         "blend");
  m.plane({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {{high}}, "top");
  m.plane({0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {{~low}}, "bottom");
  return m.shell;
}

// All splines of a model as their numbers: surfaces, curves, and curves in parameter planes.
struct Splines {
  std::multiset<std::vector<double>> surfaces, curves, flat_curves;
};

// The first and the last knot change nothing: they differ where OpenCASCADE has taken a closed
// spline for a periodic one.
void append_knots(std::vector<double>& numbers, const std::vector<double>& knots) {
  numbers.insert(numbers.end(), knots.begin() + 1, knots.end() - 1);
}
template <class Points> void append_points(std::vector<double>& numbers, const Points& points) {
  for (const auto& p : points) numbers.insert(numbers.end(), p.begin(), p.end());
}
template <class Spline> std::vector<double> numbers_of(const Spline& spline) {
  std::vector<double> numbers{double(spline.degree)};
  append_knots(numbers, spline.knots);
  append_points(numbers, spline.points);
  return numbers;
}
template <class Rows>
std::vector<double> numbers_of(int degree_u, int degree_v, const std::vector<double>& u, const std::vector<double>& v,
                               const Rows& rows) {
  std::vector<double> numbers{double(degree_u), double(degree_v)};
  append_knots(numbers, u);
  append_knots(numbers, v);
  for (const auto& row : rows) append_points(numbers, row);
  return numbers;
}

// A surface that is closed has got a seam besides.
Splines splines_of(const Shell_model& shell) {
  Splines result;
  std::set<int> used;
  for (const Shell_model::Face& face : shell.faces) {
    const Shell_model::Surface& s = face.surface;
    if (s.plane) continue;
    result.surfaces.insert(numbers_of(s.degree_u, s.degree_v, s.knots_u, s.knots_v, s.points));
    for (const auto& loop : face.loops)
      for (const Shell_model::Use& use : loop) {
        used.insert(use.edge);
        result.flat_curves.insert(numbers_of(use.curve));
      }
    if (face.loops.size() != 2) continue;
    for (const double v : {s.knots_v.front(), s.knots_v.back()}) // that runs along v
      result.flat_curves.insert(numbers_of(line_2(s.knots_u, {0, v}, {1, v})));
    Shell_model::Spline_curve seam{s.degree_u, s.knots_u, {}};
    for (const auto& row : s.points) seam.points.push_back(row.front());
    result.curves.insert(numbers_of(seam));
  }
  for (const int edge : used) result.curves.insert(numbers_of(shell.edges[static_cast<std::size_t>(edge)].curve));
  return result;
}

template <class Curve> std::vector<double> numbers_read(const Handle(Curve) & curve, double begin, double end) {
  const auto read = cad_curve(curve, {begin, end});
  const auto* spline = std::get_if<2>(&read);
  require(spline != nullptr, "what was a spline is read as something else");
  require(begin == spline->knots[static_cast<std::size_t>(spline->degree)] &&
              end == spline->knots[spline->points.size()],
          "the range of a curve differs");
  return numbers_of(*spline);
}

Splines splines_read(const std::string& file) {
  Splines result;
  const TopoDS_Shape shape = read_shape(file, Cad_reading()).shape;
  TopTools_IndexedMapOfShape edges;
  for (TopExp_Explorer i(shape, TopAbs_FACE); i.More(); i.Next()) {
    const TopoDS_Face face = TopoDS::Face(i.Current().Oriented(TopAbs_FORWARD));
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface_name(surface) == "plane") continue;
    double u0, u1, v0, v1;
    surface->Bounds(u0, u1, v0, v1);
    const auto s = std::get<GC::Cad_spline_surface>(cad_surface(surface, {u0, u1}, {v0, v1}));
    result.surfaces.insert(numbers_of(s.u_degree, s.v_degree, s.u_knots, s.v_knots, std::array{s.points}));
    for (TopExp_Explorer j(face, TopAbs_EDGE); j.More(); j.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(j.Current());
      double begin, end;
      const Handle(Geom2d_Curve) flat = BRep_Tool::CurveOnSurface(edge, face, begin, end);
      require(!flat.IsNull(), file + ": a curve in a parameter plane is not there");
      result.flat_curves.insert(numbers_read(flat, begin, end));
      if (edges.Contains(edge)) continue;
      edges.Add(edge);
      result.curves.insert(numbers_read(BRep_Tool::Curve(edge, begin, end), begin, end));
    }
  }
  return result;
}

void make(Shell_model shell, const std::string& name) {
  for (const char* ending : {".step", ".brep"}) write_shell(shell, name + ending);
  run_along_v(shell);
  for (const char* ending : {".step", ".brep"}) {
    const Splines written = splines_of(shell), read = splines_read(name + ending);
    require(written.surfaces == read.surfaces, name + ending + ": its surfaces differ");
    require(written.curves == read.curves, name + ending + ": its edges differ");
    require(written.flat_curves == read.flat_curves, name + ending + ": its curves in parameter planes differ");
  }
}

void refuse(Shell_model shell, const std::string& reason, const std::function<void(Shell_model&)>& spoil) {
  spoil(shell);
  try {
    write_shell(shell, "refused.step");
  } catch (const std::runtime_error& e) {
    require(std::string(e.what()).find(reason) != std::string::npos,
            "refused with '" + std::string(e.what()) + "', not with '" + reason + "'");
    require(!std::ifstream("refused.step"), "a file is written of what is refused");
    return;
  }
  require(false, "what is to be refused with '" + reason + "' is written");
}

} // namespace

int main() {
  make(box(3, 2, 1), "box");
  make(rounded_box(3, 2, 1, 0.3), "rounded");
  make(ring(), "ring");
  make(cushion(), "cushion");
  refuse(box(1, 1, 1), "faces pass it 1 times forwards and 0 times backwards",
         [](Shell_model& s) { s.faces.pop_back(); });
  refuse(box(1, 1, 1), "its volume is not positive", [](Shell_model& s) {
    for (Shell_model::Face& face : s.faces) face.reversed = true;
  });
  refuse(box(1, 1, 1), "no solid: edge 0: BRepCheck_InvalidPointOnCurve",
         [](Shell_model& s) { s.vertices[0][0] -= 1e-3; });
  refuse(rounded_box(3, 2, 1, 0.3), "blend 0", [](Shell_model& s) { s.faces.back().surface.points[2][0][1] += 1e-3; });
  refuse(ring(), "face 0 (outside): its loops run round a surface that is not closed",
         [](Shell_model& s) { s.faces[0].surface.points[0][1][0] += 1e-3; });
  refuse(ring(), "face 1 (inside): a loop runs round inside of the surface",
         [](Shell_model& s) { s.faces[1].loops[1][0].curve.points[0][1] = 0.1; });
}
