// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE make_planar
#include "support/test.h"

#include "formats/solids/check_closed.h"
#include "formats/solids/make_planar.h"

namespace {

// A mesh with numbers for its edges.
Solid solid(const std::vector<Solid::Point>& points, const std::vector<std::vector<std::size_t>>& faces) {
  Solid result;
  result.vertices = points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges;
  for (const std::vector<std::size_t>& f : faces) {
    Solid::Loop loop{f, {}};
    for (std::size_t i = 0; i < f.size(); ++i) {
      const std::pair<std::size_t, std::size_t> ends = std::minmax(f[i], f[(i + 1) % f.size()]);
      loop.edges.push_back(edges.emplace(ends, edges.size()).first->second);
    }
    result.faces.push_back({{loop}, ""});
  }
  return result;
}

const std::vector<std::vector<std::size_t>> faces_of_cube{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

std::vector<Solid::Point> corners() {
  std::vector<Solid::Point> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0});
  return points;
}

typedef std::vector<std::optional<Solid_plane>> Planes;
Planes no_planes(const Solid& s) { return Planes(s.faces.size()); }

Q determinant(const Solid::Point& o, const Solid::Point& a, const Solid::Point& b, const Solid::Point& c) {
  Q m[3][3];
  const Solid::Point* const p[] = {&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = (*p[i])[k] - o[k];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
bool is_planar(const Solid& s) {
  for (const Solid::Face& f : s.faces) {
    const std::vector<std::size_t>& v = f.loops[0].vertices;
    for (std::size_t i = 3; i < v.size(); ++i)
      if (determinant(s.vertices[v[0]], s.vertices[v[1]], s.vertices[v[2]], s.vertices[v[i]]) != 0) return false;
  }
  return true;
}

template <class F> std::string reason(F f) {
  try {
    f();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "no error";
}
std::string reason_of_planes(Solid s, double tolerance = 0) {
  return reason([&] { make_planar(s, no_planes(s), tolerance); });
}
std::string reason_of_shell(Solid s) {
  return reason([&] { check_closed(s); });
}
bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

// A vertex that lies exactly in its planes stays as it is, whatever the planes of the file are.
BOOST_AUTO_TEST_CASE(exact_vertices_stay) {
  Solid s = solid(corners(), faces_of_cube);
  check_closed(s);
  make_planar(s, Planes(6, Solid_plane{{0, 0, Q(1, 10)}, {1, 2, 3}}), 0);
  BOOST_CHECK(s.vertices == corners());
  BOOST_CHECK(s.largest_move == 0);
}

// A cube that has been turned and rounded is planar again, and its vertices have hardly moved.
BOOST_AUTO_TEST_CASE(rounded_vertices_move) {
  std::mt19937 random(60);
  std::uniform_real_distribution<double> angle(0, 6);
  for (int i = 0; i < 10; ++i) {
    const double a = angle(random), b = angle(random);
    const std::array<std::array<double, 3>, 3> axes{
        {{std::cos(a), std::sin(a), 0},
         {-std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b)},
         {std::sin(a) * std::sin(b), -std::cos(a) * std::sin(b), std::cos(b)}}};
    Solid s = solid(corners(), faces_of_cube);
    for (Solid::Point& p : s.vertices) {
      std::array<double, 3> turned{0.1, 0.2, 0.3};
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t m = 0; m < 3; ++m) turned[m] += CGAL::to_double(p[k]) * axes[k][m];
      p = {turned[0], turned[1], turned[2]};
    }
    const std::vector<Solid::Point> before = s.vertices;
    BOOST_CHECK(!is_planar(s));
    check_closed(s);
    make_planar(s, no_planes(s), 0);
    BOOST_CHECK(is_planar(s));
    BOOST_CHECK_GT(s.largest_move, 0);
    BOOST_CHECK_LT(s.largest_move, 1e-14);
    Q largest = 0; // square
    for (std::size_t v = 0; v < 8; ++v) {
      Q square = 0;
      for (std::size_t k = 0; k < 3; ++k)
        square += (s.vertices[v][k] - before[v][k]) * (s.vertices[v][k] - before[v][k]);
      if (square > largest) largest = square;
      if (v == s.most_moved) BOOST_CHECK_CLOSE(std::sqrt(CGAL::to_double(square)), s.largest_move, 1e-6);
    }
    BOOST_CHECK_CLOSE(std::sqrt(CGAL::to_double(largest)), s.largest_move, 1e-6);
  }
}

// The plane of the file is taken, not one through the points.
BOOST_AUTO_TEST_CASE(planes_of_the_file) {
  Solid s = solid(corners(), faces_of_cube);
  s.vertices[7][2] += Q(1, 1000000000);
  Planes planes = no_planes(s);
  planes[1] = Solid_plane{{0, 0, 1}, {0, 0, 1}};
  make_planar(s, planes, 0);
  BOOST_CHECK(s.vertices == corners());
  BOOST_CHECK(s.most_moved == 7);
  BOOST_CHECK_CLOSE(s.largest_move, 1e-9, 1e-6);
}

// Two halves of a face have one plane, the point between them stays on the edge, and one inside of
// a face in the plane.
BOOST_AUTO_TEST_CASE(divided_faces) {
  const Q little(1, 1000000000);
  std::vector<Solid::Point> points = corners();
  points.push_back({0, Q(1, 2) + little, 1 + 2 * little}); // 8 on the edge from 4 to 6
  points.push_back({1 - little, Q(1, 2), 1});              // 9 on that from 5 to 7
  points.push_back({Q(1, 3), Q(1, 2), 1 - 3 * little});    // 10 on the top
  const std::vector<std::vector<std::size_t>> faces{{0, 2, 3, 1},    {0, 1, 5, 4},     {2, 6, 7, 3},    {0, 4, 8, 6, 2},
                                                    {1, 3, 7, 9, 5}, {4, 5, 9, 10, 8}, {8, 10, 9, 7, 6}};
  Solid s = solid(points, faces);
  Planes planes = no_planes(s);
  planes[5] = Solid_plane{{0, 0, 1}, {0, 0, 1}};
  planes[6] = Solid_plane{{0, 0, 1}, {0, little, 1}}; // only one of both counts
  planes[3] = Solid_plane{{0, 0, 0}, {1, 0, 0}};
  planes[4] = Solid_plane{{1, 0, 0}, {1, 0, 0}};
  check_closed(s);
  make_planar(s, planes, 0);
  points[8] = {0, Q(1, 2) + little, 1};
  points[9] = {1, Q(1, 2), 1};
  points[10] = {Q(1, 3), Q(1, 2), 1};
  BOOST_CHECK(s.vertices == points);
  BOOST_CHECK(s.most_moved == 10);
  BOOST_CHECK_CLOSE(s.largest_move, 3e-9, 1e-6);
}

// A hole in a face, the vertices of which have been rounded.
BOOST_AUTO_TEST_CASE(faces_with_holes) {
  std::vector<Solid::Point> points;
  for (const Solid::Point& p : corners()) points.push_back({3 * p[0], 3 * p[1], p[2]});
  for (const Solid::Point& p : corners()) points.push_back({p[0] + 1, p[1] + 1, p[2]});
  std::vector<std::vector<std::size_t>> faces = faces_of_cube;
  for (std::size_t f = 2; f < 6; ++f) {
    faces.push_back(faces_of_cube[f]);
    for (std::size_t& v : faces.back()) v += 8;
    std::reverse(faces.back().begin(), faces.back().end());
  }
  Solid s = solid(points, faces);
  const auto edge = [&](std::size_t a, std::size_t b) {
    for (const Solid::Face& f : s.faces)
      for (std::size_t i = 0; i < 4; ++i)
        if (f.loops[0].vertices[i] == b && f.loops[0].vertices[(i + 1) % 4] == a) return f.loops[0].edges[i];
    return std::size_t(0);
  };
  s.faces[0].loops.push_back({{8, 9, 11, 10}, {edge(8, 9), edge(9, 11), edge(11, 10), edge(10, 8)}});
  s.faces[1].loops.push_back({{12, 14, 15, 13}, {edge(12, 14), edge(14, 15), edge(15, 13), edge(13, 12)}});
  check_closed(s); // the volume is 8
  s.vertices[12][2] += Q(1, 1000000000);
  Planes planes = no_planes(s);
  planes[1] = Solid_plane{{0, 0, 1}, {0, 0, 1}};
  make_planar(s, planes, 0);
  BOOST_CHECK(s.vertices == points);
  s.faces[1].loops.pop_back();
  BOOST_CHECK(says(reason_of_shell(s), "has no other face: the shell is open"));
}

BOOST_AUTO_TEST_CASE(no_planes_can_be_found) {
  Solid s = solid(corners(), faces_of_cube);
  s.vertices[7] = {1, 1, Q(3, 2)};
  s.faces[1].name = "#17 \"top\"";
  BOOST_CHECK(says(reason_of_planes(s), "vertex 6 at (0, 1, 1): the planes of its faces meet in a point that is ") ||
              says(reason_of_planes(s), "vertex 4 at (0, 0, 1): the planes of its faces meet in a point that is "));
  BOOST_CHECK(reason_of_planes(s, 1) == "no error"); // it is within the tolerance of the file
  // Four rhombs of a rhombic dodecahedron meet in a point of an axis, exactly or not.
  std::vector<Solid::Point> points{{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}};
  for (const Solid::Point& p : corners()) points.push_back({2 * p[0] - 1, 2 * p[1] - 1, 2 * p[2] - 1});
  std::vector<std::vector<std::size_t>> rhombs;
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = a / 2 * 2 + 2; b < 6; ++b) {
      std::vector<std::size_t> between; // the corners beside both
      for (std::size_t c = 6; c < 14; ++c)
        if (points[c][a / 2] * points[a][a / 2] > 0 && points[c][b / 2] * points[b][b / 2] > 0) between.push_back(c);
      rhombs.push_back({a, between.at(0), b, between.at(1)});
    }
  BOOST_CHECK(reason_of_planes(solid(points, rhombs)) == "no error");
  points[0][0] += Q(1, 1000000000);
  BOOST_CHECK(says(reason_of_planes(solid(points, rhombs)),
                   "vertex 0 at (2, 0, 0): 4 planes meet there, but up to rounding only"));
  BOOST_CHECK(says(reason_of_planes(solid(corners(), {{0, 1, 3, 2}, {0, 1, 0}})), "face 1: its area is 0"));
}

BOOST_AUTO_TEST_CASE(shells_that_are_not_closed) {
  std::vector<std::vector<std::size_t>> faces = faces_of_cube;
  faces.pop_back();
  BOOST_CHECK(says(reason_of_shell(solid(corners(), faces)), "face 0: edge 2 has no other face: the shell is open"));
  faces.push_back({1, 5, 7, 3});
  BOOST_CHECK(says(reason_of_shell(solid(corners(), faces)), "at edge 2 it and face 5 are oriented as if one of them"));
  faces = faces_of_cube;
  faces.push_back(faces[0]);
  BOOST_CHECK(says(reason_of_shell(solid(corners(), faces)), "face 0: edge 0 has 3 faces, not two"));
  // another cube beside it
  faces = faces_of_cube;
  std::vector<Solid::Point> points = corners();
  for (const Solid::Point& p : corners()) points.push_back({p[0] + 5, p[1], p[2]});
  for (std::vector<std::size_t> f : faces_of_cube) {
    for (std::size_t& v : f) v += 8;
    faces.push_back(f);
  }
  BOOST_CHECK(says(reason_of_shell(solid(points, faces)), "face 6: no edges lead from it to face 0"));
  BOOST_CHECK(says(reason_of_shell(solid({}, {})), "there is no face"));
  points = corners();
  for (Solid::Point& p : points) p[2] = 0;
  BOOST_CHECK(reason_of_shell(solid(points, faces_of_cube)) == "its volume is 0");
}

// A shell inside out is turned, and its edges stay between their vertices.
BOOST_AUTO_TEST_CASE(inside_out) {
  const Solid right = solid(corners(), faces_of_cube);
  Solid s = right;
  for (Solid::Face& f : s.faces) {
    Solid::Loop& l = f.loops[0];
    std::reverse(l.vertices.begin(), l.vertices.end());
    l.edges = {l.edges[2], l.edges[1], l.edges[0], l.edges[3]};
  }
  check_closed(s);
  for (std::size_t f = 0; f < 6; ++f) {
    BOOST_CHECK(s.faces[f].loops[0].vertices == right.faces[f].loops[0].vertices);
    BOOST_CHECK(s.faces[f].loops[0].edges == right.faces[f].loops[0].edges);
  }
}
