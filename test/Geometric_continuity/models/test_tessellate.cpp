// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tessellation of patches, surfaces and models, face graphs and files of triangles.

#include "support/net_of.h"

#include <CGAL/Geometric_continuity/IO/mesh.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/ipower.h>

BOOST_AUTO_TEST_SUITE(tessellate)

typedef CGAL::Simple_cartesian<Q> Exact_kernel;
typedef CGAL::Simple_cartesian<double> Rounded;
typedef std::tuple<Rounded, Exact_kernel> Kernels;

template <class K> using Patch = GC::Bezier_patch<GC::Traits_3<K>>;
template <class K> using Mesh = GC::Tessellation<GC::Traits_3<K>>;
template <class K> using Net = std::vector<std::vector<typename K::Point_3>>;
typedef Patch<Exact_kernel> Exact_patch;
typedef std::vector<Exact_patch> Exact_model;
typedef Exact_kernel::Point_3 Exact_point;

template <class K> constexpr bool is_exact = !std::is_floating_point_v<typename K::FT>;

// ---------------------------------------------------------------- models, made of rationals

// Returns the patch in another kernel; with rounded numbers the coordinates must be doubles.
template <class K> Patch<K> in_kernel(const Exact_patch& s) { return surface_exactly<GC::Traits_3<K>>(s); }
template <class K> std::vector<Patch<K>> in_kernel(const Exact_model& model) {
  std::vector<Patch<K>> result;
  for (const Exact_patch& s : model) result.push_back(in_kernel<K>(s));
  return result;
}

// Whole numbers, so that elevated patches are whole, too.
Exact_patch scaled(const Exact_patch& s, int factor) {
  return s.transform(CGAL::Aff_transformation_3<Exact_kernel>(CGAL::SCALING, Q(factor)));
}

// Six patches over the faces of a cube of side 288, seen from outside. The middle control points of
// edges are moved outwards by the factor `edge`, those of faces by a factor for each. Some are
// turned, run through backwards and elevated.
Exact_model cube(const Q& edge, const std::array<Q, 6>& face) {
  Exact_model model;
  for (int k = 0; k < 6; ++k) {
    const int axis = k / 2, sign = k % 2 == 0 ? 1 : -1;
    Exact_patch s(net_of(3, 3, [&](int i, int j) {
      const Q factor = i == 1 && j == 1 ? face[k] : i == 1 || j == 1 ? edge : Q(1);
      std::array<Q, 3> x;
      x[axis] = Q(factor * Q(144 * sign));
      x[(axis + 1) % 3] = Q(factor * Q(144 * (i - 1)));
      x[(axis + 2) % 3] = Q(factor * Q(144 * sign * (j - 1)));
      return Exact_point(x[0], x[1], x[2]);
    }));
    if (k % 3 == 1) s = s.swap_parameters().reverse_u();
    if (k % 3 == 2) s = s.reverse_u().reverse_v();
    model.push_back(s.elevate(k % 2, k / 3));
  }
  return model;
}

// n x m biquadratic patches that form a torus.
Exact_model torus(int n, int m) {
  const auto control_point = [&](int i, int j) {
    const double pi = 3.14159265358979323846, a = pi * (i % (2 * n)) / n, b = pi * (j % (2 * m)) / m;
    const double around = i % 2 == 0 ? 1 : 1.5, across = j % 2 == 0 ? 1 : 1.5;
    const auto whole = [](double x) { return Q(static_cast<int>(std::lround(100 * x))); };
    const double radius = around * (3 + across * std::cos(b));
    return Exact_point(whole(radius * std::cos(a)), whole(radius * std::sin(a)), whole(across * std::sin(b)));
  };
  Exact_model model;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      model.emplace_back(net_of(3, 3, [&](int k, int l) { return control_point(2 * i + k, 2 * j + l); }));
  return model;
}

// A bicubic patch that closes up, u0 = u1, around the z-axis; its end v1 is a point if `tip`.
Exact_patch tube(bool tip) {
  const int x[] = {6, 6, -18, 6}, y[] = {0, 18, 0, 0};
  return Exact_patch(net_of(4, 4, [&](int i, int j) {
    return tip && j == 3 ? Exact_point(0, 0, 12) : Exact_point(x[i] * (4 - j), y[i] * (4 - j), 3 * j);
  }));
}

Exact_patch random_patch(std::mt19937& random, int p, int q) {
  std::uniform_int_distribution<int> wave(-64, 64);
  return Exact_patch(net_of(p + 1, q + 1,
                            [&](int i, int j) {
                              const Q x(256 * i + wave(random)), y(256 * j + wave(random)), z(wave(random));
                              return Exact_point(Q(x / 256), Q(y / 256), Q(z / 64));
                            }),
                     {Q(-1), Q(3)}, {Q(2), Q(Q(5) / Q(2))});
}

// ------------------------------------------------------------ what is checked of each tessellation

template <class K> double distance(const typename K::Point_3& p, const typename K::Point_3& q) {
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
}

// Every point lies on its patch: exactly, or within some roundings of convex combinations.
// Triangles have different corners.
template <class K> void check_points(const std::vector<Patch<K>>& model, const Mesh<K>& mesh) {
  BOOST_REQUIRE_EQUAL(mesh.points.size(), mesh.places.size());
  BOOST_REQUIRE_EQUAL(mesh.triangles.size(), mesh.patches.size());
  int missed = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto& place = mesh.places[i];
    const typename K::Point_3 p = model[place.patch](place.u, place.v);
    if constexpr (is_exact<K>)
      missed += !(p == mesh.points[i]);
    else { // degree at most 10, coordinates at most `size`
      double size = 0;
      for (const auto& b : model[place.patch])
        size = std::max({size, std::abs(b.x()), std::abs(b.y()), std::abs(b.z())});
      missed += !(distance<K>(p, mesh.points[i]) <= 100 * size * std::numeric_limits<double>::epsilon());
    }
  }
  BOOST_CHECK_EQUAL(missed, 0);
  for (const auto& t : mesh.triangles) {
    missed += mesh.points[t[0]] == mesh.points[t[1]] || mesh.points[t[1]] == mesh.points[t[2]] ||
              mesh.points[t[2]] == mesh.points[t[0]];
    for (std::size_t corner : t) BOOST_REQUIRE(corner < mesh.points.size());
  }
  BOOST_CHECK_EQUAL(missed, 0);
}

template <class K> long euler_characteristic(const Mesh<K>& mesh) {
  return static_cast<long>(mesh.points.size()) - static_cast<long>(GC::mesh_edges(mesh.triangles).number_of_edges()) +
         static_cast<long>(mesh.triangles.size());
}

// Six times the volume inside.
template <class K> typename K::FT volume(const Mesh<K>& mesh) {
  typename K::FT sum(0);
  for (const auto& t : mesh.triangles)
    sum += CGAL::determinant(mesh.points[t[0]] - CGAL::ORIGIN, mesh.points[t[1]] - CGAL::ORIGIN,
                             mesh.points[t[2]] - CGAL::ORIGIN);
  return sum;
}

// A closed oriented manifold with this Euler characteristic, to every mesh of CGAL.
template <class K> void check_closed(const std::vector<Patch<K>>& model, const Mesh<K>& mesh, long characteristic) {
  check_points<K>(model, mesh);
  BOOST_CHECK(GC::mesh_edges(mesh.triangles).watertight());
  BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), characteristic);
  CGAL::Surface_mesh<typename K::Point_3> surface_mesh;
  GC::to_face_graph(mesh, surface_mesh);
  BOOST_CHECK(CGAL::is_valid_polygon_mesh(surface_mesh) && CGAL::is_closed(surface_mesh));
}

GC::Uniform_grid grid(int n) { return GC::Uniform_grid{n}; }
GC::Chord_tolerance within(double distance) { return GC::Chord_tolerance{distance}; }

// ---------------------------------------------------------------- one patch

BOOST_AUTO_TEST_CASE_TEMPLATE(uniform_grids, K, Kernels) {
  std::mt19937 random(41);
  const std::vector<Patch<K>> model{in_kernel<K>(random_patch(random, 2, 3))};
  for (int n : {1, 2, 3, 7}) {
    const Mesh<K> mesh = GC::tessellate(model[0], grid(n));
    BOOST_CHECK_EQUAL(mesh.points.size(), (n + 1) * (n + 1));
    BOOST_CHECK_EQUAL(mesh.triangles.size(), 2 * n * n);
    const GC::Mesh_edges edges = GC::mesh_edges(mesh.triangles);
    BOOST_CHECK_EQUAL(edges.boundary, 4 * n);
    BOOST_CHECK_EQUAL(edges.irregular, 0);
    BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 1);
    check_points<K>(model, mesh);
    // the parameters are those of a grid, each once
    std::set<std::pair<typename K::FT, typename K::FT>> parameters;
    for (const auto& place : mesh.places) parameters.emplace(place.u, place.v);
    BOOST_CHECK_EQUAL(parameters.size(), mesh.points.size());
    BOOST_CHECK(parameters.begin()->first == -1 && parameters.rbegin()->first == 3);
    // each triangle has half of a cell, and turns as the parameters do
    for (const auto& t : mesh.triangles) {
      const auto &a = mesh.places[t[0]], &b = mesh.places[t[1]], &c = mesh.places[t[2]];
      const double area = CGAL::to_double(typename K::FT((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u)));
      BOOST_CHECK_CLOSE_FRACTION(area, 2.0 / (n * n), 1e-12);
    }
  }
}

// As many cells as the bound of Patch_flatness needs, which is the distance in the corners' middle
// for a paraboloid.
BOOST_AUTO_TEST_CASE(numbers_of_cells) {
  const auto check = [](double a, double b, double distance, int u, int v) { // (u, v, a u^2 + b v^2)
    const Patch<Rounded> s(
        net_of(3, 3, [&](int i, int j) { return Rounded::Point_3(i / 2.0, j / 2.0, a * (i == 2) + b * (j == 2)); }));
    const std::optional<GC::Patch_cells> c = GC::Patch_flatness(s).cells(distance, 1, 4096);
    BOOST_CHECK(u == 0 ? !c : c && c->u == u && c->v == v);
  };
  check(1, 0, 0.26, 1, 1);
  check(1, 0, 0.24, 2, 1);
  check(0, 1, 1 / 63.0, 1, 4);
  check(1, 1, 1 / 31.0, 4, 4);
  check(1, 1, 0.51, 1, 1);
  check(16, 1, 0.51, 4, 1);
  check(1, 1, 1e-9, 0, 0);
  // bilinear: the diagonal of the whole is 1/4 away from u v
  const Patch<Rounded> saddle{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}};
  BOOST_CHECK_CLOSE_FRACTION(GC::Patch_flatness(saddle).distance({1, 1}), 0.25, 1e-12);
  BOOST_CHECK_CLOSE_FRACTION(GC::Patch_flatness(saddle).distance({4, 2}), 0.25 / 8, 1e-12);
  BOOST_CHECK_EQUAL(GC::tessellate(saddle, within(0.26)).triangles.size(), 2);
  BOOST_CHECK_EQUAL(GC::tessellate(saddle, within(0.24)).triangles.size(), 4);
}

// Dense samples of every triangle: the point of the surface and the point of the triangle with the
// same parameters.
TEST_FOR_EACH(tolerance_is_kept, K, Kernels) {
  std::mt19937 random(42);
  const std::array<std::pair<int, int>, 7> degrees = {{{1, 1}, {1, 3}, {2, 2}, {3, 2}, {3, 3}, {5, 1}, {6, 4}}};
  for (const auto& degree : degrees) {
    const Patch<K> s = in_kernel<K>(random_patch(random, degree.first, degree.second));
    for (double tolerance : is_exact<K> ? std::vector<double>{0.3} : std::vector<double>{0.5, 0.1, 0.01}) {
      const Mesh<K> mesh = GC::tessellate(s, within(tolerance));
      check_points<K>({s}, mesh);
      BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 1);
      double most = 0;
      constexpr int steps = is_exact<K> ? 4 : 6;
      for (const auto& t : mesh.triangles)
        for (int i = 0; i <= steps; ++i)
          for (int j = 0; i + j <= steps; ++j) {
            const FT weight[] = {FT(FT(i) / FT(steps)), FT(FT(j) / FT(steps)), FT(FT(steps - i - j) / FT(steps))};
            FT u(0), v(0);
            typename K::Vector_3 x(FT(0), FT(0), FT(0));
            for (int k = 0; k < 3; ++k) {
              u += weight[k] * mesh.places[t[k]].u;
              v += weight[k] * mesh.places[t[k]].v;
              x = x + weight[k] * (mesh.points[t[k]] - CGAL::ORIGIN);
            }
            most = std::max(most, distance<K>(s(u, v), CGAL::ORIGIN + x));
          }
      BOOST_CHECK_LE(most, tolerance * (1 + 1e-12)); // the distance is rounded here
      BOOST_CHECK_GE(most, tolerance / 64);          // and the triangles are not far too many
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(orientation, K, Kernels) {
  std::mt19937 random(43);
  const Patch<K> s = in_kernel<K>(random_patch(random, 3, 3)); // a graph over a plane, nearly
  for (const Mesh<K>& mesh : {GC::tessellate(s, grid(8)), GC::tessellate(s, within(0.01))})
    for (const auto& t : mesh.triangles) {
      const typename K::Vector_3 n = CGAL::normal(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
      BOOST_CHECK(n * s.normal(mesh.places[t[0]].u, mesh.places[t[0]].v) > 0);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(collapsed_edges, K, Kernels) {
  typedef typename K::Point_3 Point;
  // a triangle: u0 is one point
  const std::vector<Patch<K>> model{
      Patch<K>{{Point(0, 0, 0), Point(0, 0, 0), Point(0, 0, 0)}, {Point(4, -4, 0), Point(4, 0, 4), Point(4, 4, 0)}}};
  for (int n : {1, 2, 5}) {
    const Mesh<K> mesh = GC::tessellate(model[0], grid(n));
    BOOST_CHECK_EQUAL(mesh.points.size(), n * (n + 1) + 1);
    BOOST_CHECK_EQUAL(mesh.triangles.size(), 2 * n * n - n);
    BOOST_CHECK_EQUAL(GC::mesh_edges(mesh.triangles).boundary, 3 * n);
    BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 1);
    check_points<K>(model, mesh);
  }
  // all four edges, and the whole patch
  const Point o(0, 0, 0), t(0, 0, 4);
  const std::vector<Patch<K>> bubble{Patch<K>{{o, o, o}, {o, t, o}, {o, o, o}}};
  const Mesh<K> mesh = GC::tessellate(bubble[0], grid(4));
  BOOST_CHECK(GC::mesh_edges(mesh.triangles).watertight());
  BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 2);
  BOOST_CHECK_EQUAL(GC::tessellate(Patch<K>{{o, o}, {o, o}}, grid(1)).triangles.size(), 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_patch_that_closes_up, K, Kernels) {
  for (bool tip : {false, true}) {
    const std::vector<Patch<K>> model{in_kernel<K>(tube(tip))};
    for (double tolerance : {1e6, 10.0, 1.0}) {
      const Mesh<K> mesh = GC::tessellate(model, within(tolerance));
      check_points<K>(model, mesh);
      BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), tip ? 1 : 0);
      CGAL::Surface_mesh<typename K::Point_3> surface_mesh;
      GC::to_face_graph(mesh, surface_mesh);
      BOOST_CHECK(CGAL::is_valid_polygon_mesh(surface_mesh));
    }
    const Mesh<K> mesh = GC::tessellate(model[0], grid(3));
    BOOST_CHECK_EQUAL(mesh.points.size(), tip ? 10 : 12);
    CGAL::Surface_mesh<typename K::Point_3> surface_mesh;
    if (!tip) CHECK_ERROR(GC::to_face_graph(GC::tessellate(model[0], grid(2)), surface_mesh), not_a_manifold);
    BOOST_CHECK_EQUAL(num_vertices(surface_mesh), 0);
    GC::to_face_graph(mesh, surface_mesh);
  }
}

// ---------------------------------------------------------------- models

BOOST_AUTO_TEST_CASE_TEMPLATE(cubes, K, Kernels) {
  const std::vector<Patch<K>> flat = in_kernel<K>(cube(Q(1), {Q(1), Q(1), Q(1), Q(1), Q(1), Q(1)}));
  for (int n : {1, 2, 3}) {
    const Mesh<K> mesh = GC::tessellate(flat, grid(n));
    check_closed<K>(flat, mesh, 2);
    BOOST_CHECK_EQUAL(mesh.points.size(), 6 * n * n + 2);
    if (is_exact<K> || n != 3) BOOST_CHECK(volume<K>(mesh) == 6 * 288 * 288 * 288);
  }
  BOOST_CHECK_EQUAL(GC::tessellate(flat, within(1e-3)).triangles.size(), 12);
  // faces that need different numbers of cells, so that edges have more points than the cells
  // beside them
  const std::vector<Patch<K>> bulging =
      in_kernel<K>(cube(Q(Q(5) / Q(4)), {Q(1), Q(3), Q(Q(3) / Q(2)), Q(9), Q(2), Q(Q(1) / Q(2))}));
  for (double tolerance : {1e6, 30.0, 3.0}) {
    const Mesh<K> mesh = GC::tessellate(bulging, within(tolerance));
    check_closed<K>(bulging, mesh, 2);
    if (tolerance < 100) BOOST_CHECK(volume<K>(mesh) > 6 * 288 * 288 * 288);
  }
  // without a face: only its edges are open
  std::vector<Patch<K>> open = bulging;
  open.pop_back();
  const Mesh<K> mesh = GC::tessellate(open, within(3));
  const GC::Mesh_edges edges = GC::mesh_edges(mesh.triangles);
  BOOST_CHECK(edges.boundary > 0 && edges.boundary % 4 == 0 && edges.irregular == 0);
  BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 1);
  BOOST_CHECK(std::set<std::size_t>(mesh.patches.begin(), mesh.patches.end()) ==
              (std::set<std::size_t>{0, 1, 2, 3, 4}));
}

// A closed cube that is turned, and a sheet beside it, which stays as it is.
BOOST_AUTO_TEST_CASE_TEMPLATE(closed_and_open_parts, K, Kernels) {
  std::vector<Patch<K>> model = in_kernel<K>(cube(Q(1), {Q(1), Q(1), Q(1), Q(1), Q(1), Q(1)}));
  for (Patch<K>& s : model) s = s.swap_parameters();
  const Mesh<K> closed = GC::tessellate(model, grid(2));
  BOOST_CHECK(volume<K>(closed) == 6 * 288 * 288 * 288);
  for (const bool turned : {false, true}) {
    const Patch<K> sheet{{{1000, 0, 0}, {1000, 1, 0}}, {{1001, 0, 0}, {1001, 1, 0}}};
    std::vector<Patch<K>> both = model;
    both.insert(both.begin() + 2, turned ? sheet.swap_parameters() : sheet);
    const Mesh<K> mesh = GC::tessellate(both, grid(2));
    BOOST_CHECK_EQUAL(mesh.triangles.size(), closed.triangles.size() + 8);
    int up = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      if (mesh.patches[i] != 2) continue;
      const auto n = CGAL::normal(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
      up += n.z() > 0 ? 1 : -1;
    }
    BOOST_CHECK_EQUAL(up, turned ? -8 : 8);
  }
}

// A closed model without volume has no outside, and keeps the orientation of its first patch.
BOOST_AUTO_TEST_CASE_TEMPLATE(two_sides_of_a_sheet, K, Kernels) {
  const Exact_patch sheet({{{0, 0, 0}, {0, 1, 1}}, {{1, 0, 1}, {1, 1, 2}}});
  for (const Exact_patch& first : {sheet, sheet.swap_parameters()}) {
    const std::vector<Patch<K>> model = in_kernel<K>({first, first.swap_parameters()});
    const Mesh<K> mesh = GC::tessellate(model, grid(2));
    const GC::Mesh_edges edges = GC::mesh_edges(mesh.triangles);
    BOOST_CHECK(edges.boundary == 0 && edges.irregular == 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.patches[t] != 0) continue;
      const auto& p = mesh.points;
      const auto& i = mesh.triangles[t];
      const auto normal = CGAL::cross_product(p[i[1]] - p[i[0]], p[i[2]] - p[i[0]]),
                 of_patch = CGAL::cross_product(model[0].control_point(1, 0) - model[0].control_point(0, 0),
                                                model[0].control_point(0, 1) - model[0].control_point(0, 0));
      BOOST_CHECK(normal * of_patch > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(tori, K, Kernels) {
  for (const auto& size : {std::make_pair(4, 3), std::make_pair(3, 3), std::make_pair(2, 5), std::make_pair(2, 2)}) {
    const std::vector<Patch<K>> model = in_kernel<K>(torus(size.first, size.second));
    for (double tolerance : {1e6, 20.0, 5.0}) {
      const Mesh<K> mesh = GC::tessellate(model, within(tolerance));
      check_closed<K>(model, mesh, 0);
    }
    check_closed<K>(model, GC::tessellate(model, grid(3)), 0);
  }
}

// Two patches that have all four edges in common, a wedge of two patches with collapsed ends, and
// many around one line.
BOOST_AUTO_TEST_CASE_TEMPLATE(patches_that_meet_more_than_once, K, Kernels) {
  typedef typename K::Point_3 Point;
  const auto cushion = [](int height) {
    return Patch<K>{{Point(0, 0, 0), Point(0, 4, 0), Point(0, 8, 0)},
                    {Point(4, 0, 0), Point(4, 4, height), Point(4, 8, 0)},
                    {Point(8, 0, 0), Point(8, 4, 0), Point(8, 8, 0)}};
  };
  const std::vector<Patch<K>> pillow{cushion(6), cushion(-6).swap_parameters()};
  const auto lune = [](int x, int y) {
    const Point bottom(0, 0, 0), top(0, 0, 8);
    return Patch<K>{
        {bottom, Point(8, 0, 4), top}, {bottom, Point(8 * x, 8 * y, 4), top}, {bottom, Point(-8, 0, 4), top}};
  };
  const std::vector<Patch<K>> ball{lune(0, 2), lune(0, -2).reverse_u()};
  for (double tolerance : {1e6, 0.5}) {
    check_closed<K>(pillow, GC::tessellate(pillow, within(tolerance)), 2);
    check_closed<K>(ball, GC::tessellate(ball, within(tolerance)), 2);
  }
  BOOST_CHECK(volume<K>(GC::tessellate(pillow, within(0.5))) > 0);
  // three patches at an edge are welded, but are no manifold
  std::vector<Patch<K>> fins;
  for (int k = 0; k < 3; ++k)
    fins.push_back(Patch<K>{{Point(0, 0, 0), Point(0, 0, 4)}, {Point(k, 4 - 2 * k, 0), Point(k, 4 - 2 * k, 4)}});
  const Mesh<K> mesh = GC::tessellate(fins, grid(2));
  BOOST_CHECK_EQUAL(mesh.points.size(), 3 + 3 * 6);
  BOOST_CHECK_EQUAL(GC::mesh_edges(mesh.triangles).irregular, 2);
  CGAL::Surface_mesh<Point> surface_mesh;
  CHECK_ERROR(GC::to_face_graph(mesh, surface_mesh), not_a_manifold);
}

// One common edge with other degrees, other directions and other numbers of cells on the two sides.
BOOST_AUTO_TEST_CASE_TEMPLATE(sides_of_an_edge, K, Kernels) {
  std::mt19937 random(44);
  const Exact_patch a = scaled(random_patch(random, 2, 2), 256 * 36 * 4),
                    reversed = a.reverse_v().elevate(2, 1); // its v1 is the v0 of a; multiples of 1/36 of it
  const Exact_patch b(net_of(reversed.degree_u() + 1, reversed.degree_v() + 1, [&](int i, int j) { // bends more
    const Exact_point p = reversed.control_point(i, j);
    const int away = reversed.degree_v() - j;
    return away == 0 ? p : Exact_point(p.x(), Q(Q(-36864) * Q(away)), Q(i % 2 == 0 ? 300000 : -300000));
  }));
  for (int turn = 0; turn < 8; ++turn) {
    Exact_patch c = turn & 1 ? b.reverse_u() : b;
    if (turn & 2) c = c.reverse_v();
    if (turn & 4) c = c.swap_parameters();
    const std::vector<Patch<K>> model = in_kernel<K>({a, c});
    const Mesh<K> mesh = GC::tessellate(model, within(1500));
    check_points<K>(model, mesh);
    BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 1); // a disk: they are joined along one edge
    const std::size_t a_alone = GC::tessellate(model[0], within(1500)).triangles.size(),
                      c_alone = GC::tessellate(model[1], within(1500)).triangles.size();
    // a takes points of c into its outermost cells
    BOOST_CHECK(mesh.triangles.size() > a_alone + c_alone);
    const bool same_orientation = turn == 0 || turn == 3 || turn == 5 || turn == 6;
    BOOST_CHECK_EQUAL(GC::mesh_edges(mesh.triangles).irregular == 0, same_orientation);
  }
}

// A flat square, one cell, with curved patches on some of its sides: it takes their points on
// straight edges, and no triangle has its corners on a line.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_cell_with_many_points, K, Kernels) {
  typedef typename K::Point_3 Point;
  for (int sides = 0; sides < 16; ++sides) {
    std::vector<Patch<K>> model{Patch<K>{{Point(0, 0, 0), Point(0, 4, 0)}, {Point(4, 0, 0), Point(4, 4, 0)}}};
    for (int side = 0; side < 4; ++side) {
      if (!(sides >> side & 1)) continue;
      model.emplace_back(net_of(3, 3, [&](int i, int j) {
        int x = 2 * i, y = -2 * j;
        for (int turn = 0; turn < side; ++turn) std::tie(x, y) = std::make_pair(4 - y, x);
        return Point(x, y, j != 1 ? 0 : i == 1 ? 8 : -8);
      }));
    }
    const Mesh<K> mesh = GC::tessellate(model, within(0.5));
    check_points<K>(model, mesh);
    BOOST_CHECK_EQUAL(euler_characteristic<K>(mesh), 1);
    int flat = 0;
    for (const auto& t : mesh.triangles)
      flat += CGAL::collinear(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    BOOST_CHECK_EQUAL(flat, 0);
    const auto in_square = std::count(mesh.patches.begin(), mesh.patches.end(), 0);
    BOOST_CHECK(sides == 0 ? in_square == 2 : in_square > 4);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bspline_surfaces, K, Kernels) {
  typedef typename K::Point_3 Point;
  typedef typename K::FT FT;
  typedef GC::Bspline_surface<GC::Traits_3<K>> Surface;
  std::mt19937 random(45);
  std::uniform_int_distribution<int> height(-8, 8);
  const Net<K> net = net_of(6, 5, [&](int i, int j) { return Point(8 * i, 8 * j, height(random)); });
  const GC::Knot_vector<FT> u(3, {FT(0), FT(0), FT(0), FT(0), FT(1), FT(3), FT(4), FT(4), FT(4), FT(4)});
  const GC::Knot_vector<FT> v(2, {FT(0), FT(0), FT(0), FT(1), FT(2), FT(4), FT(4), FT(4)});
  const Surface surface(net, u, v);
  const Mesh<K> uniform = GC::tessellate(surface, grid(2));
  BOOST_CHECK_EQUAL(uniform.points.size(), 7 * 7); // 3 x 3 patches
  BOOST_CHECK_EQUAL(euler_characteristic<K>(uniform), 1);
  int missed = 0;
  for (std::size_t i = 0; i < uniform.points.size(); ++i) {
    const Point p = surface(uniform.places[i].u, uniform.places[i].v);
    missed += is_exact<K> ? !(p == uniform.points[i]) : !(distance<K>(p, uniform.points[i]) < 1e-12);
  }
  BOOST_CHECK_EQUAL(missed, 0);
  const Mesh<K> mesh = GC::tessellate(std::vector<Surface>{surface, surface.reverse_u()}, within(0.5));
  BOOST_CHECK(std::count(mesh.patches.begin(), mesh.patches.end(), 0) > 18);
  BOOST_CHECK_EQUAL(std::count(mesh.patches.begin(), mesh.patches.end(), 0),
                    std::count(mesh.patches.begin(), mesh.patches.end(), 1));
  BOOST_CHECK_EQUAL(*std::max_element(mesh.patches.begin(), mesh.patches.end()), 1);
}

// ---------------------------------------------------------------- errors

BOOST_AUTO_TEST_CASE_TEMPLATE(refused, K, Kernels) {
  std::mt19937 random(46);
  const Patch<K> s = in_kernel<K>(random_patch(random, 2, 2));
  const double infinity = std::numeric_limits<double>::infinity();
  for (double tolerance : {0.0, -0.0, -1.0, -1e-300})
    CHECK_ERROR(GC::tessellate(s, within(tolerance)), unreachable_tolerance);
  for (double tolerance : {1e-300, std::numeric_limits<double>::denorm_min(), 1e-9})
    CHECK_ERROR(GC::tessellate(s, within(tolerance)), work_limit);
  for (double tolerance : {infinity, -infinity, std::nan("")})
    CHECK_ERROR(GC::tessellate(s, within(tolerance)), not_finite);
  CHECK_ERROR(GC::tessellate(s, grid(0)), wrong_number_of_points);
  for (int n : {-1, (std::numeric_limits<int>::min)()}) CHECK_ERROR(GC::tessellate(s, grid(n)), negative_count);
  for (int n : {4097, 1 << 16, (std::numeric_limits<int>::max)()}) CHECK_ERROR(GC::tessellate(s, grid(n)), work_limit);
  CHECK_ERROR(GC::tessellate(std::vector<Patch<K>>(17, s), grid(1024)), work_limit);
  // more cells than an int counts
  CHECK_ERROR(GC::tessellate(std::vector<Patch<K>>(200, s), grid(4096)), work_limit);
  BOOST_CHECK(GC::tessellate(std::vector<Patch<K>>(), within(1)).points.empty());
  BOOST_CHECK_EQUAL(GC::tessellate(s, within(1e300)).triangles.size(), 2);
  if constexpr (!is_exact<K>) { // differences beyond the largest number
    const Patch<K> huge{
        {{0, 0, 0}, {1, 0, 0}}, {{1e308, 0, 0}, {-1e308, 1e308, 0}}, {{-1e308, 0, 0}, {1e308, 0, 1e308}}};
    CHECK_ERROR(GC::tessellate(huge, within(1)), unreachable_tolerance);
  }
}

// The patches are reported one by one while surfaces are cut, and then the triangles.
BOOST_AUTO_TEST_CASE(reports) {
  typedef CGAL::Simple_cartesian<double> K;
  typedef GC::Bspline_surface<GC::Traits_3<K>> Surface;
  const GC::Knot_vector<double> u(1, {0., 0., 1., 2., 2.}), v(1, {0., 0., 1., 1.});
  const Surface surface(Net<K>{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 1}, {1, 1, 2}}, {{2, 0, 0}, {2, 1, 0}}}, u, v);
  std::vector<std::size_t> patches, triangles;
  const Mesh<K> mesh = GC::tessellate(
      std::vector<Surface>{surface,
                           surface.transform(K::Aff_transformation_3(CGAL::TRANSLATION, K::Vector_3(0, 0, 9)))},
      grid(2), GC::max_tessellation_triangles, [&](GC::Tessellation_stage stage, std::size_t n) {
        if (stage == GC::Tessellation_stage::patches) BOOST_CHECK(triangles.empty());
        (stage == GC::Tessellation_stage::patches ? patches : triangles).push_back(n);
      });
  BOOST_CHECK((patches == std::vector<std::size_t>{1, 2, 3, 4}));
  BOOST_CHECK((triangles == std::vector<std::size_t>{8, 16, 24, 32}));
  BOOST_CHECK_EQUAL(mesh.triangles.size(), 32);
}

// The triangles are counted before they are made: of surfaces, of patches with edges in common, and
// by a tolerance.
BOOST_AUTO_TEST_CASE(limit_of_triangles) {
  typedef CGAL::Simple_cartesian<double> K;
  std::mt19937 random(47);
  const auto message = [](const auto& surfaces, const auto& mode, std::size_t most) -> std::string {
    try {
      return std::to_string(GC::tessellate(surfaces, mode, most).triangles.size()) + " triangles";
    } catch (const GC::Error& error) {
      BOOST_CHECK(error.code() == GC::Error_code::work_limit);
      return error.what();
    }
  };
  const auto too_many = [](int surface, const std::string& count, std::size_t most) {
    return "work_limit: tessellate: surface " + std::to_string(surface) + " leads to " + count +
           " triangles or more, where at most " + std::to_string(most) + " are made";
  };
  const Patch<K> s = in_kernel<K>(random_patch(random, 2, 2));
  BOOST_CHECK_EQUAL(message(s, grid(4), 32), "32 triangles");
  BOOST_CHECK_EQUAL(message(s, grid(4), 31), too_many(0, "32", 31));
  BOOST_CHECK_EQUAL(message(std::vector<Patch<K>>(3, s), grid(4096), 100000000), too_many(2, "100663296", 100000000));
  BOOST_CHECK_EQUAL(message(s, grid(4096), GC::max_tessellation_triangles),
                    too_many(0, "33554432", GC::max_tessellation_triangles));
  // a strip that is bent in one direction only needs many cells there, and few triangles
  const Patch<K> bent{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 8}, {1, 1, 8}}, {{2, 0, 0}, {2, 1, 0}}};
  for (const Patch<K>& t : {bent, bent.swap_parameters()})
    BOOST_CHECK_EQUAL(message(t, within(1e-8), GC::max_tessellation_triangles),
                      "work_limit: tessellate: surface 0 needs more than 4096 cells of a patch in one direction");
  const std::string tiny = message(s, within(1e-300), GC::max_tessellation_triangles);
  BOOST_CHECK(tiny.find("surface 0 leads to ") != std::string::npos && tiny.find("e+30") != std::string::npos);
  BOOST_CHECK(message(s, within(5e-324), GC::max_tessellation_triangles).find("1e+300 triangles") != std::string::npos);
  // a plane beside a curved patch: points on their edge add triangles to the plane
  const Patch<K> plane{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}},
      wave{{{1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}}, {{2, 0, 0}, {2, 0.5, 8}, {2, 1, 0}}};
  for (const Patch<K>& t : {wave, wave.swap_parameters()}) {
    const std::vector<Patch<K>> model{plane, t};
    const Mesh<K> mesh = GC::tessellate(model, within(0.01));
    BOOST_CHECK_GT(std::count(mesh.patches.begin(), mesh.patches.end(), 0), 2);
    const std::size_t needed = mesh.triangles.size();
    BOOST_CHECK_EQUAL(message(model, within(0.01), needed), std::to_string(needed) + " triangles");
    BOOST_CHECK_EQUAL(message(model, within(0.01), needed - 1), too_many(0, std::to_string(needed), needed - 1));
  }
  // the knots alone tell that there are too many
  typedef GC::Bspline_surface<GC::Traits_3<K>> Surface;
  std::vector<double> knots(1, 0.0);
  for (int i = 0; i < 61; ++i) knots.push_back(i);
  knots.push_back(60.0);
  const GC::Knot_vector<double> u(1, knots);
  const Surface surface(net_of(61, 61, [](int i, int j) { return K::Point_3(i, j, i * j % 7); }), u, u);
  BOOST_CHECK_EQUAL(message(surface, grid(1), 7200), "7200 triangles");
  BOOST_CHECK_EQUAL(message(surface, grid(2), 28799), too_many(0, "28800", 28799));
  BOOST_CHECK_EQUAL(message(std::vector<Surface>{surface, surface}, within(1), 14399), too_many(1, "14400", 14399));
}

// The bound never excludes numbers of cells that suffice.
BOOST_AUTO_TEST_CASE(least_numbers_of_cells) {
  typedef CGAL::Simple_cartesian<double> K;
  std::mt19937 random(48);
  for (int p = 1; p <= 3; ++p)
    for (int q = 1; q <= 3; ++q) {
      const GC::Patch_flatness flatness(in_kernel<K>(random_patch(random, p, q)));
      for (double tolerance : {1e3, 1.0, 0.1, 1e-3}) {
        const std::optional<GC::Patch_cells> cells = flatness.cells(tolerance, 1, 4096);
        BOOST_REQUIRE(cells);
        BOOST_CHECK_LE(flatness.least_cells(tolerance), double(cells->u) * cells->v);
        BOOST_CHECK_GE(16 * flatness.least_cells(tolerance), double(cells->u) * cells->v);
      }
      for (double tolerance : {0.0, -1.0}) CHECK_ERROR(flatness.least_cells(tolerance), unreachable_tolerance);
      CHECK_ERROR(flatness.least_cells(std::nan("")), not_finite);
    }
}

// Every number of cells and every tolerance has an answer at once.
BOOST_AUTO_TEST_CASE(numbers_of_cells_that_are_refused) {
  typedef CGAL::Simple_cartesian<double> K;
  const Patch<K> flat{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}},
      saddle{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}};
  const double infinity = std::numeric_limits<double>::infinity();
  const int largest = (std::numeric_limits<int>::max)(), smallest = (std::numeric_limits<int>::min)();
  for (const Patch<K>& s : {flat, saddle}) {
    const GC::Patch_flatness flatness(s);
    for (const auto& [least, most] : {std::make_pair(0, 16), std::make_pair(1, 0), std::make_pair(0, 0)})
      CHECK_ERROR(flatness.cells(0.1, least, most), wrong_number_of_points);
    for (const auto& [least, most] :
         {std::make_pair(-1, 16), std::make_pair(1, -16), std::make_pair(smallest, smallest)})
      CHECK_ERROR(flatness.cells(0.1, least, most), negative_count);
    for (double tolerance : {0.0, -0.0, -1.0}) CHECK_ERROR(flatness.cells(tolerance, 1, 16), unreachable_tolerance);
    for (double tolerance : {infinity, -infinity, std::nan("")})
      CHECK_ERROR(flatness.cells(tolerance, 1, 16), not_finite);
    BOOST_CHECK(!flatness.cells(0.3, 5, 7)); // no power of two
    BOOST_CHECK(!flatness.cells(0.3, 8, 4));
    BOOST_CHECK(!flatness.cells(0.3, largest, largest));
    const std::optional<GC::Patch_cells> between = flatness.cells(0.3, 3, 13);
    BOOST_CHECK(between && between->u == 4 && between->v == 4);
    CHECK_ERROR(flatness.distance({0, 1}), wrong_number_of_points);
    CHECK_ERROR(flatness.distance({1, -1}), negative_count);
    BOOST_CHECK(flatness.distance({largest, largest}) < 1e-18);
  }
  const GC::Patch_flatness bent(saddle); // 1 / (4 uv)
  const std::optional<GC::Patch_cells> most = bent.cells(0x1.1p-62, 1, largest), fewest = bent.cells(1e300, 1, largest);
  BOOST_CHECK(most && double(most->u) * most->v == 0x1p60 && bent.distance(*most) <= 0x1.1p-62);
  BOOST_CHECK(!bent.cells(0x1p-63, 1, largest));
  BOOST_CHECK(fewest && fewest->u == 1 && fewest->v == 1);
}

// ---------------------------------------------------------------- face graphs

BOOST_AUTO_TEST_CASE(face_graphs) {
  typedef CGAL::Simple_cartesian<double> K;
  const std::vector<Patch<K>> closed = in_kernel<K>(torus(4, 3));
  const Mesh<K> torus_mesh = GC::tessellate(closed, grid(2)), disk = GC::tessellate(closed[0], grid(3));
  const auto check = [&](auto mesh) {
    GC::to_face_graph(torus_mesh, mesh);
    GC::to_face_graph(disk, mesh); // beside it
    BOOST_CHECK(CGAL::is_valid_polygon_mesh(mesh));
    BOOST_CHECK_EQUAL(vertices(mesh).size(), torus_mesh.points.size() + disk.points.size());
    BOOST_CHECK_EQUAL(faces(mesh).size(), torus_mesh.triangles.size() + disk.triangles.size());
    int border = 0, wrong = 0;
    const auto points = get(CGAL::vertex_point, mesh);
    std::multiset<K::Point_3> expected(torus_mesh.points.begin(), torus_mesh.points.end());
    expected.insert(disk.points.begin(), disk.points.end());
    for (const auto v : vertices(mesh)) {
      const auto place = expected.find(get(points, v));
      if (place == expected.end())
        ++wrong;
      else
        expected.erase(place);
      wrong += target(halfedge(v, mesh), mesh) != v;
    }
    for (const auto h : halfedges(mesh)) {
      border += CGAL::is_border(h, mesh);
      wrong += source(next(h, mesh), mesh) != target(h, mesh) ||
               CGAL::is_border(next(h, mesh), mesh) != CGAL::is_border(h, mesh);
    }
    BOOST_CHECK_EQUAL(border, 12);
    BOOST_CHECK_EQUAL(wrong, 0);
  };
  typedef CGAL::Linear_cell_complex_traits<3, K> Cell_traits;
  check(CGAL::Surface_mesh<K::Point_3>());
  check(CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Cell_traits>::type());
}

BOOST_AUTO_TEST_CASE(no_face_graphs) {
  typedef CGAL::Simple_cartesian<double> K;
  typedef std::vector<std::array<std::size_t, 3>> Triangles;
  const auto refuse = [](std::size_t points, const Triangles& triangles, const std::string& reason) {
    Mesh<K> mesh;
    for (std::size_t i = 0; i < points; ++i) mesh.points.emplace_back(double(i), double(i * i), 0.0);
    mesh.triangles = triangles;
    CGAL::Surface_mesh<K::Point_3> result;
    BOOST_CHECK_EXCEPTION(GC::to_face_graph(mesh, result), GC::Error, [&](const GC::Error& e) {
      return e.code() == GC::Error_code::not_a_manifold && std::string(e.what()).find(reason) != std::string::npos;
    });
    BOOST_CHECK_EQUAL(num_vertices(result), 0);
  };
  refuse(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, "more than two triangles");
  refuse(4, {{0, 1, 2}, {0, 1, 3}}, "opposite orientations");
  refuse(3, {{0, 1, 1}}, "one point twice");
  refuse(3, {{0, 1, 3}}, "does not exist");
  // two boundary fans
  refuse(5, {{0, 1, 2}, {0, 3, 4}}, "at point 0");
  // two cones
  refuse(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}}, "at point 0");
  // a cone and a fan
  refuse(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}, "at point 0");
  CGAL::Surface_mesh<K::Point_3> result;
  GC::to_face_graph(Mesh<K>(), result);
  BOOST_CHECK_EQUAL(num_vertices(result), 0);
}

// ---------------------------------------------------------------- files

BOOST_AUTO_TEST_CASE(files) {
  typedef CGAL::Simple_cartesian<double> K;
  std::mt19937 random(47);
  const Mesh<K> mesh = GC::tessellate(in_kernel<K>(random_patch(random, 3, 2)), grid(3));
  typedef std::vector<K::Point_3> Points;
  typedef std::vector<std::vector<std::size_t>> Polygons;
  const auto check = [&](GC::Mesh_format format, bool (*read)(std::istream&, Points&, Polygons&)) {
    std::stringstream stream;
    GC::write_mesh(stream, mesh, format);
    Points points;
    Polygons polygons;
    BOOST_CHECK(read(stream, points, polygons));
    BOOST_REQUIRE_EQUAL(polygons.size(), mesh.triangles.size());
    if (format != GC::Mesh_format::stl) BOOST_CHECK(points == mesh.points); // without loss
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (int k = 0; k < 3; ++k) BOOST_CHECK(points[polygons[i][k]] == mesh.points[mesh.triangles[i][k]]);
  };
  check(GC::Mesh_format::off, [](auto& is, auto& x, auto& y) { return CGAL::IO::read_OFF(is, x, y); });
  check(GC::Mesh_format::obj, [](auto& is, auto& x, auto& y) { return CGAL::IO::read_OBJ(is, x, y); });
  check(GC::Mesh_format::ply, [](auto& is, auto& x, auto& y) { return CGAL::IO::read_PLY(is, x, y); });
  check(GC::Mesh_format::stl, [](auto& is, auto& x, auto& y) { return CGAL::IO::read_STL(is, x, y); });
  // exact numbers are rounded; what is too large is refused
  const Exact_point o(0, 0, 0), third(Q(Q(1) / Q(3)), 0, 0), far_away(0, CGAL::ipower(Q(2), 2000), 0);
  std::ostringstream os;
  GC::write_mesh(os, GC::tessellate(Exact_patch{{o, Exact_point(0, 1, 0)}, {third, Exact_point(1, 1, 0)}}, grid(1)),
                 GC::Mesh_format::off);
  BOOST_CHECK(contains(os.str(), "0.33333333333333331 0 0"));
  CHECK_ERROR(GC::write_mesh(os, GC::tessellate(Exact_patch{{o, far_away}, {third, Exact_point(1, 1, 0)}}, grid(1)),
                             GC::Mesh_format::off),
              not_finite);
}

BOOST_AUTO_TEST_SUITE_END()
