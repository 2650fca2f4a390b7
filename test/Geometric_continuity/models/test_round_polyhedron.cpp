// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polyhedra with rounded edges: they are closed, G2 along all rails and seams, exactly, and without
// folds, with exact numbers and in floating point.

#include "support/net_of.h"
#include "support/polyhedra.h"
#include "support/random_surfaces.h"

#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Surface_mesh.h>

BOOST_AUTO_TEST_SUITE(rounded_polyhedra)

typedef CGAL::Simple_cartesian<Q> Exact_kernel;
typedef CGAL::Simple_cartesian<double> Double_kernel;
typedef std::tuple<Exact_kernel, Double_kernel> Kernels;

template <class Traits>
int count(const GC::Rounded_polyhedron<Traits>& r, typename GC::Rounded_polyhedron<Traits>::Edge_kind kind) {
  return static_cast<int>(std::count_if(r.edges.begin(), r.edges.end(), [&](const auto& e) { return e.kind == kind; }));
}

// The surface that goes on in the plane across a part of a side of a blend.
template <class Surface> Surface strip(const Surface& part, bool at_start) {
  typedef typename Surface::Traits Traits;
  std::vector<std::vector<typename Traits::Point>> net;
  for (int i = 0; i < part.number_of_points_u(); ++i) {
    const auto p = part.coordinates(i, at_start ? 0 : 5), q = part.coordinates(i, at_start ? 1 : 4);
    net.push_back({GC::to_point<Traits>(p), GC::to_point<Traits>(p + (p - q))});
  }
  return Surface(net, part.knots_u(), GC::Knot_vector<typename Traits::FT>(1, 0, 1));
}

template <class Surface, class FT> Surface part_of(Surface s, const FT& begin, const FT& end) {
  if (s.domain_u().first < begin) s = s.split_u(begin).second;
  if (end < s.domain_u().second) s = s.split_u(end).first;
  return s;
}

// Returns whether second-order contact with the plane of a face is exact, by the decision about
// the blend and a strip of the plane.
template <class Blend, class Use, class Face>
bool is_g2_with_plane(const Blend& blend, const Use& use, const Face& face) {
  typedef GC::Traits_3<Exact_kernel> Exact_traits;
  const auto vector = [](const auto& p) { return Exact_traits::Vector(Q(p.x()), Q(p.y()), Q(p.z())); };
  const auto part = part_of(surface_exactly<Exact_traits>(blend.surface), Q(use.begin), Q(use.end));
  const bool at_start = use.side == v0;
  const auto plane = strip(part, at_start);
  const Exact_traits::Vector normal = CGAL::cross_product(vector(face.x), vector(face.y));
  for (const auto& p : plane)
    if (normal * (p - (CGAL::ORIGIN + vector(face.origin))) != 0) return false;
  const auto verdict = GC::edge_continuity(part, use.side, plane, v0);
  return verdict.g_order == 2 && verdict.whole_a && verdict.whole_b;
}

template <class Traits> void check(const GC::Rounded_polyhedron<Traits>& r, int holes = 0) {
  typedef GC::Rounded_polyhedron<Traits> Polyhedron;
  typedef typename Traits::FT FT;
  std::vector<std::array<int, 2>> uses(r.edges.size());
  std::size_t rails = 0;
  std::map<std::size_t, std::pair<const typename Polyhedron::Blend*, const typename Polyhedron::Blend_use*>> blend_of;
  const auto ends = [&](const auto& use) {
    const auto& e = r.edges[use.edge];
    return use.reversed ? std::make_pair(e.end, e.start) : std::make_pair(e.start, e.end);
  };
  const auto check_loop = [&](const auto& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      ++uses[loop[i].edge][loop[i].reversed];
      BOOST_CHECK_EQUAL(ends(loop[i]).second, ends(loop[(i + 1) % loop.size()]).first);
    }
  };
  for (const auto& b : r.blends) {
    check_loop(b.loop);
    BOOST_CHECK(!GC::possible_fold(b.surface));
    BOOST_CHECK(b.surface.degree_u() == 5 && b.surface.degree_v() == 5);
    for (const auto& knot : b.surface.knots_u().inner_knots()) BOOST_CHECK_LE(knot.multiplicity, 3); // C2
    if (b.closed) {
      const auto seam = GC::edge_continuity(b.surface, u0, b.surface, u1);
      BOOST_CHECK(seam.g_order == 2 && seam.whole_a && seam.whole_b && !seam.reversed);
    }
    for (const auto& use : b.loop) {
      const auto& curve = r.edges[use.edge].curve;
      blend_of[use.edge] = {&b, &use};
      for (int k = 0; k <= 4; ++k) { // the side of the blend is the edge
        const FT t = curve.domain().first + FT(k) / FT(4) * (curve.domain().second - curve.domain().first),
                 x = use.begin + FT(k) / FT(4) * (use.end - use.begin);
        const bool along_u = use.side == v0 || use.side == v1;
        const auto p = along_u
                           ? b.surface(x, FT(use.side == v1 ? 1 : 0))
                           : b.surface(use.side == u1 ? b.surface.domain_u().second : b.surface.domain_u().first, x);
        if constexpr (std::is_floating_point_v<FT>)
          BOOST_CHECK_SMALL(CGAL::to_double(CGAL::squared_distance(p, curve(t))), 1e-14);
        else
          BOOST_CHECK(p == curve(t));
      }
    }
  }
  int inner_loops = 0;
  for (const auto& f : r.faces) {
    inner_loops += static_cast<int>(f.loops.size()) - 1;
    for (const auto& loop : f.loops) {
      check_loop(loop);
      for (const auto& use : loop) {
        if (r.edges[use.edge].kind != Polyhedron::Edge_kind::rail) continue;
        BOOST_REQUIRE(blend_of.count(use.edge));
        BOOST_CHECK(is_g2_with_plane(*blend_of[use.edge].first, *blend_of[use.edge].second, f));
        ++rails;
      }
    }
  }
  for (const auto& u : uses) BOOST_CHECK(u[0] == 1 && u[1] == 1);
  for (const auto& e : r.edges) {
    BOOST_CHECK(e.kind == Polyhedron::Edge_kind::sharp || e.curve(e.curve.domain().first) == r.vertices[e.start] ||
                e.kind == Polyhedron::Edge_kind::mitre);
    rails += e.kind == Polyhedron::Edge_kind::seam;
  }
  const std::vector<int> orders = GC::edge_orders(r);
  for (std::size_t e = 0; e < orders.size(); ++e)
    BOOST_CHECK_EQUAL(
        orders[e], r.edges[e].kind == Polyhedron::Edge_kind::rail || r.edges[e].kind == Polyhedron::Edge_kind::seam ? 2
                   : orders[e] > 0                                                                                  ? -9
                                   : orders[e]);
  // Euler's formula; each inner loop of a face adds 1, each hole through the solid subtracts 2
  BOOST_CHECK_EQUAL(static_cast<int>(r.vertices.size()) - static_cast<int>(r.edges.size()) +
                        static_cast<int>(r.blends.size() + r.faces.size()) - inner_loops,
                    2 - 2 * holes);
}

template <class K, class Cut = double> auto rounded(const Solid& solid, const Cut& cut) {
  return GC::round_polyhedron(points_of<K>(solid), solid.faces, cut);
}

TEST_FOR_EACH(solids, K, Kernels) {
  const auto cut = [](int n, int d) { return fraction_in<typename K::FT>(n, d); };
  struct Case {
    const char* name;
    Solid solid;
    int n, d; // the cut
    int closed, blends, faces;
    int holes;
  };
  const std::vector<Case> cases = {
      {"box", box(6, 4, 3), 1, 2, 2, 6, 6, 0},
      {"long box", box(100, 4, 3), 1, 1, 2, 6, 6, 0},
      {"hexagonal prism", prism({{4, 0}, {2, 3}, {-2, 3}, {-4, 0}, {-2, -3}, {2, -3}}, 5), 1, 2, 2, 8, 8, 0},
      {"bracket", prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 2), 1, 4, 2, 8, 8, 0},
      {"wedge", prism({{0, 0}, {6, 0}, {0, 2}}, 4), 1, 4, 2, 5, 5, 0},
      {"tetrahedron", tetrahedron(), 1, 4, -1, -1, 4, 0},
      {"pyritohedron", pyritohedron(), 1, 16, -1, -1, 12, 0},
      {"truncated box", truncated_box(), 1, 8, -1, -1, 7, 0},
      {"plate with a hole", plate_with_hole(), 1, 4, 4, 12, 10, 1},
      {"step", step(), 1, 4, -1, -1, 9, 0},
  };
  for (const Case& c : cases) BOOST_TEST_CONTEXT(c.name) {
      const auto r = rounded<K>(c.solid, cut(c.n, c.d));
      check(r, c.holes);
      BOOST_CHECK_EQUAL(static_cast<int>(r.faces.size()), c.faces);
      if (c.closed < 0) continue;
      BOOST_CHECK_EQUAL(std::count_if(r.blends.begin(), r.blends.end(), [](const auto& b) { return b.closed; }),
                        c.closed);
      BOOST_CHECK_EQUAL(static_cast<int>(r.blends.size()), c.blends);
    }
}

// Along its middle a blend is bent in corners only, where the curvature rises once and falls once,
// as that of the profile does.
BOOST_AUTO_TEST_CASE(middles) {
  const std::vector<std::pair<Solid, Q>> cases = {
      {box(6, 4, 3), Q(1, 2)},
      {prism({{4, 0}, {2, 3}, {-2, 3}, {-4, 0}, {-2, -3}, {2, -3}}, 5), Q(1, 2)},
      {prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 2), Q(1, 4)},
      {prism({{0, 0}, {6, 0}, {0, 2}}, 4), Q(1, 4)},
      {tetrahedron(), Q(1, 4)},
      {pyritohedron(), Q(1, 16)}};
  for (const auto& [solid, cut] : cases) {
    const auto r = GC::round_polyhedron(points_of<Exact_kernel>(solid), solid.faces, cut);
    std::size_t corners = 0;
    for (const auto& blend : r.blends) {
      const auto knots = blend.surface.knots_u().distinct_knots();
      const auto profile = GC::boundary_curve(blend.surface, GC::Patch_edge::u0);
      BOOST_CHECK_EQUAL(GC::curvature_extrema(profile).size(), 1U);
      for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const auto part = part_of(blend.surface, knots[i].value, knots[i + 1].value);
        const auto middle = GC::boundary_curve(part.split_v(Q(1, 2)).first, GC::Patch_edge::v1);
        const GC::Curvature_extrema bends = GC::curvature_extrema(middle);
        if (bends.largest().upper == 0) continue;
        BOOST_CHECK_EQUAL(bends.size(), 1U);
        ++corners;
      }
    }
    BOOST_CHECK_EQUAL(corners, solid.points.size());
  }
}

// Planes that touch a sphere: three meet at each vertex. Cuts are halved until there is room.
TEST_FOR_EACH(random_solids, K, Kernels) {
  struct Random : Random_integers<> {
    using Random_integers<>::Random_integers;
  } random;
  for (int run = 0; run < 6; ++run) BOOST_TEST_CONTEXT("seed " << random.seed << ", run " << run) {
      std::vector<std::array<Q, 4>> planes;
      for (int i = 0; i < 6; ++i) // those of a box, so that it is bounded
        planes.push_back({Q(i / 2 == 0 ? 1 - 2 * (i % 2) : 0), Q(i / 2 == 1 ? 1 - 2 * (i % 2) : 0),
                          Q(i / 2 == 2 ? 1 - 2 * (i % 2) : 0), Q(10)});
      for (int i = random.integer(0, 8); i > 0; --i) { // rational points of the unit sphere
        const Q s = fraction_in<Q>(2 * random.integer(-30, 30) + 1, 20),
                t = fraction_in<Q>(2 * random.integer(-21, 20) + 1, 14), n = Q(s * s + t * t + 1);
        planes.push_back({Q(2 * s / n), Q(2 * t / n), Q((s * s + t * t - 1) / n), Q(10)});
      }
      const Solid solid = intersection_of(planes);
      FT cut(2);
      bool done = false;
      for (int i = 0; i < 20 && !done; ++i, cut = FT(cut / FT(2))) try {
          check(rounded<K>(solid, cut));
          done = true;
        } catch (const GC::Error& e) {
          BOOST_CHECK_MESSAGE(
              e.code() == GC::Error_code::parameter_outside_domain &&
                  (contains(e.what(), "must be less than") || contains(e.what(), "take smaller set-backs")),
              e.what());
        }
      BOOST_CHECK(done);
    }
}

// Turned, tiny, huge and far away.
BOOST_AUTO_TEST_CASE(positions_in_floating_point) {
  typedef Double_kernel::Point_3 Point;
  for (const double unit : {1e-30, 1e-3, 1., 1e6, 1e30})
    for (const bool turned : {false, true}) BOOST_TEST_CONTEXT("unit " << unit) {
        const Solid solid = prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 2);
        std::vector<Point> points;
        for (const Point& p : points_of<Double_kernel>(solid)) {
          const double c = std::cos(0.3), s = std::sin(0.3), x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
          const Point q = turned ? Point(x, c * y - s * p.z(), s * y + c * p.z()) : p;
          points.emplace_back(unit * q.x(), unit * (q.y() + 10), unit * q.z());
        }
        const auto r = GC::round_polyhedron(points, solid.faces, 0.25 * unit);
        const std::vector<int> orders = GC::edge_orders(r);
        BOOST_CHECK_EQUAL(std::count(orders.begin(), orders.end(), 2), static_cast<int>(orders.size()));
        for (const auto& b : r.blends) BOOST_CHECK(!GC::possible_fold(b.surface));
        BOOST_CHECK_EQUAL(r.blends.size(), 8u);
      }
}

// Rails are at the distance of the cut, and control points of a convex solid inside of it.
BOOST_AUTO_TEST_CASE(distances) {
  const Solid solid = box(6, 4, 3);
  const auto r = rounded<Exact_kernel>(solid, fraction(1, 2));
  for (const auto& b : r.blends)
    for (const auto& p : b.surface)
      BOOST_CHECK(0 <= p.x() && p.x() <= 6 && 0 <= p.y() && p.y() <= 4 && 0 <= p.z() && p.z() <= 3);
  for (const auto& e : r.edges) {
    if (e.kind != GC::Rounded_polyhedron<GC::Traits_3<Exact_kernel>>::Edge_kind::rail) continue;
    const auto p = e.curve(e.curve.domain().first);
    int on = 0, near = 0; // faces, and those at the distance of the cut
    const std::array<Q, 3> c{p.x(), p.y(), p.z()}, size{Q(6), Q(4), Q(3)};
    for (int k = 0; k < 3; ++k) {
      const Q d = (std::min)(c[k], Q(size[k] - c[k]));
      on += d == 0;
      near += d == fraction(1, 2);
    }
    BOOST_CHECK(on == 1 && near >= 1);
  }
}

// Only some edges: what breaks, what runs out, and what would be half done.
TEST_FOR_EACH(some_edges, K, Kernels) {
  typedef GC::Rounded_polyhedron<GC::Traits_3<K>> Polyhedron;
  const auto kinds = [](const Polyhedron& r) {
    return std::array<int, 5>{count(r, Polyhedron::Edge_kind::rail), count(r, Polyhedron::Edge_kind::seam),
                              count(r, Polyhedron::Edge_kind::mitre), count(r, Polyhedron::Edge_kind::end),
                              count(r, Polyhedron::Edge_kind::sharp)};
  };
  const Solid solid = box(6, 4, 3);
  const auto points = points_of<K>(solid);
  // an edge is known by its ends; those of the prism over four points come in the order of the
  // faces beside it
  std::vector<std::pair<int, int>> edges;
  for (const auto& face : solid.faces)
    for (std::size_t i = 0; i < face[0].size(); ++i) {
      const auto ends = std::minmax({face[0][i], face[0][(i + 1) % face[0].size()]});
      if (std::count(edges.begin(), edges.end(), std::pair<int, int>(ends)) == 0) edges.push_back(ends);
    }
  const auto round = [&](const auto& is_rounded) {
    const auto r = GC::round_polyhedron(points, solid.faces, [&](std::size_t e) {
      return is_rounded(edges[e].first, edges[e].second) ? fraction_in<FT>(1, 2) : FT(0);
    });
    check(r);
    return kinds(r);
  };
  // one edge runs out on both sides
  BOOST_CHECK((round([](int a, int b) { return a == 0 && b == 1; }) == std::array<int, 5>{2, 0, 0, 2, 11}));
  // those of the top break at the upright ones
  BOOST_CHECK((round([](int a, int) { return a >= 4; }) == std::array<int, 5>{8, 0, 4, 0, 8}));
  // the upright ones are rounded, too: one closed chain
  BOOST_CHECK((round([](int a, int b) { return a >= 4 || b == a + 4; }) == std::array<int, 5>{24, 1, 0, 4, 4}));
  // three edges of one vertex
  BOOST_CHECK((round([](int a, int) { return a == 0; })[3] == 3));
  BOOST_CHECK((round([](int, int) { return false; }) == std::array<int, 5>{0, 0, 0, 0, 12}));
}

BOOST_AUTO_TEST_CASE(own_cuts) {
  const Solid solid = box(6, 4, 3);
  const auto r = GC::round_polyhedron(points_of<Exact_kernel>(solid), solid.faces,
                                      [](std::size_t e) { return fraction(1, static_cast<int>(e % 3) + 2); });
  check(r);
  GC::Polyhedron_rounding_options tight;
  tight.fullness = 0.9;
  check(GC::round_polyhedron(points_of<Exact_kernel>(solid), solid.faces, fraction(1, 2), tight));
}

BOOST_AUTO_TEST_CASE(refused_polyhedra) {
  const Solid solid = box(6, 4, 3);
  const auto text_of = [](const Solid& s, const Q& cut) { return error_of([&] { rounded<Exact_kernel>(s, cut); }); };
  BOOST_CHECK(contains(text_of(solid, Q(2)), "parameter_outside_domain") &&
              contains(text_of(solid, Q(2)), "the set-back 2 must be less than 1.5 (exactly 3/2)"));
  BOOST_CHECK(contains(text_of(solid, fraction(3, 2)), "must be less than 1.5"));
  rounded<Exact_kernel>(solid, fraction(149, 100));
  // two cuts that meet on a face between edges that are no neighbours
  const Solid slot = prism({{0, 0}, {20, 0}, {20, 10}, {11, 10}, {11, 4}, {9, 4}, {9, 10}, {0, 10}}, 20);
  BOOST_CHECK(contains(text_of(slot, Q(2)), "must be less than"));
  Solid open = solid;
  open.faces.pop_back();
  BOOST_CHECK(contains(text_of(open, Q(1)), "has a face on one side only"));
  Solid bent = solid;
  bent.points[0][2] = fraction(-1, 1000);
  BOOST_CHECK(contains(text_of(bent, Q(1)), "is not plane: the point "));
  Solid turned = solid;
  std::reverse(turned.faces[0][0].begin(), turned.faces[0][0].end());
  BOOST_CHECK(contains(text_of(turned, Q(1)), "is passed twice in the same direction"));
  Solid twice = solid;
  twice.points[1] = twice.points[0];
  BOOST_CHECK(contains(text_of(twice, Q(1)), "zero_tangent"));
  Solid pyramid{{{Q(0), Q(0), Q(0)}, {Q(4), Q(0), Q(0)}, {Q(4), Q(4), Q(0)}, {Q(0), Q(4), Q(0)}, {Q(2), Q(2), Q(3)}},
                {{{3, 2, 1, 0}}, {{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}}};
  BOOST_CHECK(contains(text_of(pyramid, fraction(1, 4)), "the vertex (2, 2, 3): 4 edges meet there"));
  CHECK_ERROR(rounded<Exact_kernel>(solid, Q(-1)), parameter_outside_domain);
  GC::Polyhedron_rounding_options options;
  options.fullness = 1;
  CHECK_ERROR(GC::round_polyhedron(points_of<Exact_kernel>(solid), solid.faces, Q(1), options),
              parameter_outside_domain);
  CHECK_ERROR(GC::round_polyhedron(points_of<Exact_kernel>(solid), {{{0, 1, 99}}}, Q(1)), parameter_outside_domain);
  // at a vertex with a face of more than 180 degrees, an edge cannot end alone
  const Solid bracket = prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 2);
  bool refused = false;
  for (std::size_t only = 0; only < 18; ++only) try {
      GC::round_polyhedron(points_of<Exact_kernel>(bracket), bracket.faces,
                           [&](std::size_t e) { return e == only ? fraction(1, 4) : Q(0); });
    } catch (const GC::Error& e) {
      refused = true;
      BOOST_CHECK(e.code() == GC::Error_code::incompatible_corner);
      BOOST_CHECK(contains(e.what(), "as well"));
    }
  BOOST_CHECK(refused);
}

// One edge alone: what bounds the faces beside its rounding, or those where it ends, may be in its
// way, or have been passed by it.
TEST_FOR_EACH(no_room_for_one_edge, K, Kernels) {
  const auto number_of_errors = [](const Solid& s, const FT& cut, const char* text) {
    std::size_t count = 0;
    const std::size_t edges = 3 * s.points.size() / 2;
    for (std::size_t only = 0; only < edges; ++only)
      count += contains(error_of([&] {
                          GC::round_polyhedron(points_of<K>(s), s.faces,
                                               [&](std::size_t e) { return e == only ? cut : FT(0); });
                        }),
                        text);
    return count;
  };
  const Solid thin = prism({{0, 0}, {40, 0}, {40, 2}, {2, 2}, {2, 40}, {0, 40}}, 5);
  const char* const no_room = "the face where its rounding ends has no room for it at the edge ";
  BOOST_CHECK_EQUAL(number_of_errors(thin, FT(8), no_room), 0U);
  BOOST_CHECK_EQUAL(number_of_errors(thin, FT(9), no_room), 1U);
  BOOST_CHECK_EQUAL(number_of_errors(thin, FT(15), no_room), 1U);
  const Solid block = prism(
      std::vector<std::vector<std::array<int, 2>>>{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{3, 3}, {3, 5}, {5, 5}, {5, 3}}},
      20);
  const char* const beyond = "reaches beyond the boundary to which it belongs";
  BOOST_CHECK_EQUAL(number_of_errors(block, FT(2), beyond), 0U);
  BOOST_CHECK_EQUAL(number_of_errors(block, FT(6), beyond), 8U); // four edges above, four below
}

// Faces of triangles are united, and edges of them that continue each other.
BOOST_AUTO_TEST_CASE(face_graph) {
  typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Mesh;
  Mesh mesh;
  const Solid solid = box(6, 4, 3);
  std::vector<Mesh::Vertex_index> v;
  for (const auto& p : points_of<Exact_kernel>(solid)) v.push_back(mesh.add_vertex(p));
  for (const auto& face : solid.faces) {
    const std::vector<int>& f = face[0];
    mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
    mesh.add_face(v[f[0]], v[f[2]], v[f[3]]);
  }
  const auto r = GC::round_polyhedron(mesh, fraction(1, 2));
  check(r);
  BOOST_CHECK(r.faces.size() == 6 && r.blends.size() == 6);
  const auto some = GC::round_polyhedron(mesh, [&](Mesh::Edge_index e) {
    return mesh.point(mesh.source(mesh.halfedge(e))).z() == 3 && mesh.point(mesh.target(mesh.halfedge(e))).z() == 3
               ? fraction(1, 4)
               : Q(0);
  });
  check(some);
  BOOST_CHECK_EQUAL(some.blends.size(), 4u);
}

// Goes on beside a blend: along the wall with another one of its rulings, or in the plane.
template <class Surface> Surface beside(const Surface& blend, bool wall) {
  typedef typename Surface::Traits Traits;
  std::vector<std::vector<typename Traits::Point>> net;
  std::vector<std::vector<typename Traits::FT>> weights;
  for (int i = 0; i < blend.number_of_points_u(); ++i) {
    const auto p = blend.coordinates(i, wall ? 0 : 5), q = blend.coordinates(i, wall ? 1 : 4);
    net.push_back({GC::to_point<Traits>(p), GC::to_point<Traits>(p + (p - q))});
    weights.emplace_back(2, blend.weight(i, 0));
  }
  return Surface(net, weights, blend.knots_u(), GC::Knot_vector<typename Traits::FT>(1, 0, 1));
}

// The blend along an outline is exactly G2 with wall and plane, whatever outline and rail are.
// Those of a line and an arc have their boundary in common, and are exactly G1 there.
TEST_FOR_EACH(outlines, K, Kernels) {
  typedef GC::Traits_3<K> Traits;
  typedef typename K::Point_3 Point;
  typedef GC::Rational_bspline_curve<Traits> Curve;
  const auto curve = [](const std::vector<Point>& points, const std::vector<FT>& weights, std::vector<FT> knots) {
    const int degree = static_cast<int>(knots.size() - points.size()) - 1;
    return Curve(points.begin(), points.end(), weights.begin(), weights.end(),
                 GC::Knot_vector<FT>(degree, std::move(knots)));
  };
  struct Case {
    const char* name;
    Curve outline, rail;
  };
  const std::vector<FT> quarter_weights{1, 1, 2}, quarter{0, 0, 0, 1, 1, 1}, ones{1, 1};
  const std::vector<Case> cases = {
      {"line", curve({{0, 0, 7}, {9, 0, 7}}, ones, {0, 0, 1, 1}), curve({{0, 2, 7}, {9, 2, 7}}, ones, {0, 0, 1, 1})},
      {"arc", curve({{9, 0, 7}, {15, 0, 7}, {15, 6, 7}}, quarter_weights, quarter),
       curve({{9, 2, 7}, {13, 2, 7}, {13, 6, 7}}, quarter_weights, quarter)},
      {"spline", curve({{0, 0, 7}, {3, 1, 7}, {7, -2, 7}, {8, 5, 7}}, {1, 2, 1, 3}, {0, 0, 0, 1, 3, 3, 3}),
       curve({{-1, 2, 7}, {3, 4, 7}, {6, 1, 7}, {5, 7, 7}}, {1, 2, 1, 3}, {0, 0, 0, 1, 3, 3, 3})}};
  std::vector<GC::Rational_bspline_surface<Traits>> blends;
  for (const Case& c : cases) BOOST_TEST_CONTEXT(c.name) {
      for (const int sign : {-1, 1}) { // convex and concave
        const auto s =
            GC::outline_blend<Traits>(c.outline, c.rail, typename K::Vector_3(0, 0, 2 * sign), FT(11) / FT(16));
        for (const bool wall : {true, false}) {
          const auto verdict = GC::edge_continuity(s, wall ? v0 : v1, beside(s, wall), v0);
          BOOST_CHECK(verdict.g_order == 2 && verdict.whole_a && verdict.whole_b);
        }
        BOOST_CHECK(!GC::possible_fold(s));
        BOOST_CHECK(GC::boundary_curve(s, v1) == c.rail);
        for (int k = 0; k <= 4; ++k) {
          const FT u =
              c.outline.domain().first + FT(k) / FT(4) * (c.outline.domain().second - c.outline.domain().first);
          const Point p = s(u, FT(0)), q = c.outline(u);
          BOOST_CHECK_SMALL(CGAL::to_double(CGAL::squared_distance(p, q + typename K::Vector_3(0, 0, 2 * sign))),
                            1e-28);
        }
        blends.push_back(s);
      }
    }
  const auto joined = GC::edge_continuity(blends[0], u1, blends[2], u0);
  BOOST_CHECK(joined.whole_a && joined.whole_b);
  BOOST_CHECK_EQUAL(joined.g_order, 1);
  CHECK_ERROR(GC::outline_blend<Traits>(cases[0].outline, cases[1].rail, typename K::Vector_3(0, 0, 1), FT(1) / FT(2)),
              wrong_number_of_points);
  CHECK_ERROR(GC::outline_blend<Traits>(cases[0].outline, cases[0].rail, typename K::Vector_3(0, 0, 1), FT(1)),
              parameter_outside_domain);
}

BOOST_AUTO_TEST_SUITE_END()
