// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polyhedra with rounded edges: they are closed, G2 along all rails and seams, exactly, and without
// folds, with exact numbers and in floating point.

#include "support/polyhedra.h"
#include "support/random_surfaces.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>

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
  const auto& s = blend.surface;
  const auto to_exact = [](const auto& knots) {
    std::vector<Q> x;
    for (const auto& u : knots) x.push_back(Q(u));
    return GC::Knot_vector<Q>(knots.degree(), std::move(x));
  };
  const auto vector = [](const auto& p) { return Exact_traits::Vector(Q(p.x()), Q(p.y()), Q(p.z())); };
  std::vector<std::vector<Exact_traits::Point>> net;
  for (int i = 0; i < s.number_of_points_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j < 6; ++j) net.back().push_back(CGAL::ORIGIN + vector(s.control_point(i, j)));
  }
  const GC::Bspline_surface<Exact_traits> exact(net, to_exact(s.knots_u()), to_exact(s.knots_v())),
      part = part_of(exact, Q(use.begin), Q(use.end));
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

BOOST_AUTO_TEST_SUITE_END()
