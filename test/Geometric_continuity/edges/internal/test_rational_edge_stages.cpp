// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Edges of rational surfaces in integers of fixed length against the decision in integers of any
// length: on homogeneous points with few digits and with many, where an edge holds and where a
// number is off by one unit, with weights that are alike, large, small and mixed.

#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

BOOST_AUTO_TEST_SUITE(rational_edge_stages)

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

using GC::internal::Stage;

struct Stages {
  bool fixed_length;
  std::array<int, GC::internal::number_of_stages> count{};
  bool uses(Stage) const { return fixed_length; }
  void decided(Stage s, bool) { ++count[static_cast<int>(s)]; }
};

// How many orders of an edge have been decided in integers of fixed length, or by comparison.
int fixed = 0, multiprecision = 0;

template <int order, class A, class B> bool has_order(const A& a, Patch_edge ea, const B& b, Patch_edge eb) {
  Stages all{true, {}}, exact{false, {}};
  const bool answer = GC::internal::edge_has_order<order>(a, ea, b, eb, all);
  BOOST_CHECK_EQUAL(answer, (GC::internal::edge_has_order<order>(a, ea, b, eb, exact)));
  multiprecision += all.count[static_cast<int>(Stage::multiprecision)];
  fixed += all.count[static_cast<int>(Stage::fixed_integer)] + all.count[static_cast<int>(Stage::comparison)];
  return answer;
}

// The order, -1 for a gap; with and without numbers of fixed length, and as reported.
template <class A, class B> int order(const A& a, Patch_edge ea, const B& b, Patch_edge eb) {
  const bool answers[] = {has_order<0>(a, ea, b, eb), has_order<1>(a, ea, b, eb), has_order<2>(a, ea, b, eb)};
  const int found = answers[2] ? 2 : answers[1] ? 1 : answers[0] ? 0 : -1;
  const auto report = edge_continuity(a, ea, b, eb);
  if (answers[0] || report.whole_a) BOOST_CHECK_EQUAL(report.g_order, found);
  // converted to numbers of any length
  const auto of_rows = edge_continuity(spline_edge_rows(a, ea), spline_edge_rows(b, eb));
  BOOST_CHECK(of_rows.g_order == report.g_order && of_rows.defect == report.defect && of_rows.side == report.side &&
              of_rows.coplanar == report.coplanar && of_rows.reversed == report.reversed);
  return found;
}

typedef std::array<Q, 4> Point; // homogeneous
typedef std::vector<std::vector<Point>> Net;

// A patch from homogeneous control points with positive weights.
Patch<Exact> patch(const Net& h) {
  const int m = static_cast<int>(h.size()), n = static_cast<int>(h[0].size());
  const auto point = [&](int i, int j) {
    const Point& x = h[i][j];
    return Exact::Point(x[0] / x[3], x[1] / x[3], x[2] / x[3]);
  };
  return Patch<Exact>(net_of(m, n, point), net_of(m, n, [&](int i, int j) { return h[i][j][3]; }));
}

struct Pair {
  Net a, b;
};

// Two patches of degree n along v = 0, with homogeneous points Q = P, Q_v = x P + (y + z u) P_u - c
// P_v, which have Q_vv as G2 asks for:
//   Q_vv = (y + z u)^2 P_uu - 2 c (y + z u) P_uv + c^2 P_vv + s P + t P_v,
// in the powers of u and v, of numbers of at most `size`; the second one times `factor`.
Pair smooth_pair(Random& random, int n, int size, const Q& factor) {
  const auto number = [&](int most) { return Q(random.integer(-most, most)); };
  typedef std::vector<Point> Row; // by powers of u
  const auto row = [&](int degree) {
    Row r(static_cast<std::size_t>(n) + 1, Point{Q(0), Q(0), Q(0), Q(0)});
    for (int i = 0; i <= degree; ++i)
      for (Q& x : r[static_cast<std::size_t>(i)]) x = number(size);
    return r;
  };
  Row p = row(n), pv = row(n - 1), pvv = row(n - 1), qv(p.size()), qvv(p.size());
  p[0][3] += 60 * size; // positive weights
  p[1][0] += 60 * size; // and no vanishing normals
  pv[0][1] += 60 * size;
  const int y = random.integer(-2, 2), z = random.integer(-2, 2), c = random.integer(1, 3);
  const Q x = number(2), s = number(2), t = number(2);
  const auto at = [&](const Row& r, int i, int k) {
    return 0 <= i && i <= n ? r[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] : Q(0);
  };
  const auto derivative = [&](const Row& r, int i, int k) { return Q(Q(i + 1) * at(r, i + 1, k)); };
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k < 4; ++k) {
      const auto second = [&](int j) { return Q(Q((j + 1) * (j + 2)) * at(p, j + 2, k)); };
      const auto pu = [&](int j) { return j < 0 ? Q(0) : derivative(p, j, k); };
      const auto puv = [&](int j) { return j < 0 ? Q(0) : derivative(pv, j, k); };
      const auto puu = [&](int j) { return j < 0 ? Q(0) : second(j); };
      qv[i][k] = x * at(p, i, k) + Q(y) * pu(i) + Q(z) * pu(i - 1) - Q(c) * at(pv, i, k);
      qvv[i][k] = Q(y * y) * puu(i) + Q(2 * y * z) * puu(i - 1) + Q(z * z) * puu(i - 2) -
                  Q(2 * c) * (Q(y) * puv(i) + Q(z) * puv(i - 1)) + Q(c * c) * at(pvv, i, k) + s * at(p, i, k) +
                  t * at(pv, i, k);
    }
  const auto net = [&](const Row& v, const Row& vv, int across, const Q& times) {
    // as Bernstein coefficients in u, and in v with the derivatives in units in which the weights
    // stay positive
    const Q small(random.integer(500, 999));
    Net h(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) {
      const auto bernstein = [&](const Row& r, int k) {
        Q sum(0), weight(1); // C(i,j)/C(n,j)
        for (int j = 0; j <= i; ++j) {
          sum += weight * at(r, j, k);
          weight = Q(weight * Q(i - j) / Q(n - j > 0 ? n - j : 1));
        }
        return sum;
      };
      for (int j = 0; j <= across; ++j) {
        Point x;
        for (int k = 0; k < 4; ++k) {
          const Q c0 = bernstein(p, k), c1 = bernstein(v, k) / small, c2 = bernstein(vv, k) / (small * small);
          x[k] = j == 0   ? c0
                 : j == 1 ? Q(c0 + c1 / Q(across))
                 : j == 2 ? Q(c0 + 2 * c1 / Q(across) + c2 / Q(across * (across - 1)))
                          : Q(k == 3 ? size * 60 : random.integer(-size, size));
          x[k] *= times;
        }
        h[static_cast<std::size_t>(i)].push_back(x);
      }
    }
    return h;
  };
  return {net(pv, pvv, random.integer(2, 4), Q(1)), net(qv, qvv, random.integer(2, 4), factor)};
}

BOOST_AUTO_TEST_CASE(smooth_and_off_by_a_unit) {
  Random random;
  fixed = multiprecision = 0;
  int of_second_order = 0;
  for (int round = 0; round < 24; ++round) {
    const int n = 2 + round % 4, size = round % 3 == 0 ? 5 : 300;
    const Q factor = round % 5 == 0 ? Q(1) : Q(random.integer(1, 99)) / Q(random.integer(1, 99));
    const Pair s = smooth_pair(random, n, size, factor);
    const Patch<Exact> a = patch(s.a), b = patch(s.b);
    BOOST_TEST_CONTEXT("seed " << random.seed << ", round " << round) {
      BOOST_CHECK_EQUAL(order(a, v0, b, v0), 2);
      BOOST_CHECK_EQUAL(order(b.reverse_u(), v0, a, v0), 2);
      BOOST_CHECK_EQUAL(order(a.swap_parameters().reverse_u(), u1, b, v0), 2);
      BOOST_CHECK_EQUAL(order(a, v0, a, v0), 0); // a fold
      for (int layer : {0, 1, 2}) {
        Net off = s.b;
        off[random.integer(0, n)][layer][random.integer(0, 3)] += factor / Q(1000000);
        const int found = order(a, v0, patch(off), v0);
        if (layer == 0)
          BOOST_CHECK_EQUAL(found, -1);
        else
          BOOST_CHECK_LE(layer - 1, found);
        of_second_order += layer == 2 && found == 1;
        if (layer == 1) BOOST_CHECK_LT(found, 2);
      }
    }
  }
  BOOST_TEST_MESSAGE("fixed length " << fixed << ", any length " << multiprecision);
  BOOST_CHECK_GT(of_second_order, 16);
  BOOST_CHECK_GT(fixed, 2 * multiprecision);
}

// A random patch of doubles, and its image in the plane y = 0 of the edge: they are G1 where the
// edge is planar, with the cross derivatives normal to the plane, and G2 by symmetry.
struct Symmetric {
  std::vector<std::vector<Filtered::Point>> points, image;
  std::vector<std::vector<double>> weights;
};
template <class Weight> Symmetric symmetric_pair(Random& random, int n, int q, int size, Weight weight) {
  Symmetric s;
  s.points.resize(static_cast<std::size_t>(n) + 1);
  s.image = s.points;
  s.weights.resize(s.points.size());
  for (int i = 0; i <= n; ++i) {
    double edge[3] = {double(3 * size) * i + random.integer(0, size), 0, double(random.integer(-size, size))};
    const double edge_weight = weight();
    for (int j = 0; j <= q; ++j) {
      double x = edge[0], z = edge[2], y = 0, w = edge_weight;
      // straight across: p1 - p0 is a multiple of (0, 1, 0)
      if (j == 1) y = double(2 * size) + random.integer(0, size);
      if (j > 1) {
        x += random.integer(-size, size);
        y = double(2 * size * j) + random.integer(0, size);
        z += random.integer(-size, size);
        w = weight();
      }
      s.points[static_cast<std::size_t>(i)].emplace_back(x, y, z);
      s.image[static_cast<std::size_t>(i)].emplace_back(x, -y, z);
      s.weights[static_cast<std::size_t>(i)].push_back(w);
    }
  }
  return s;
}

Patch<Exact> to_exact(const Patch<Filtered>& s) {
  const int m = s.number_of_points_u(), n = s.number_of_points_v();
  return Patch<Exact>(net_of(m, n, [&](int i, int j) { return point_exactly<Exact>(s.control_point(i, j)); }),
                      net_of(m, n, [&](int i, int j) { return Q(s.weight(i, j)); }));
}

BOOST_AUTO_TEST_CASE(weights_of_all_sizes) {
  Random random;
  fixed = multiprecision = 0;
  const auto unit = [&] { return 1 + random.integer(0, 1 << 30) * 0x1p-30 + random.integer(0, 1 << 21) * 0x1p-52; };
  for (int round = 0; round < 24; ++round) {
    const int n = 1 + round % 4, q = 2 + round % 2, kind = round % 6, size = round % 5 == 0 ? (1 << 26) : 1000;
    const auto weight = [&]() -> double {
      switch (kind) {
      case 0: return 3;
      case 1: return random.integer(1, 9);
      case 2: return unit();                                   // 53 bits
      case 3: return std::ldexp(random.integer(1, 3), 300);    // large
      case 4: return std::ldexp(random.integer(1, 3), -300);   // small
      default: return std::ldexp(1., random.integer(-20, 20)); // mixed
      }
    };
    const Symmetric s = symmetric_pair(random, n, q, size, weight);
    const Patch<Filtered> a(s.points, s.weights), b(s.image, s.weights);
    BOOST_TEST_CONTEXT("seed " << random.seed << ", round " << round) {
      const auto check = [&](const Patch<Filtered>& c) {
        const int found = order(a, v0, c, v0);
        BOOST_CHECK_EQUAL(found, order(to_exact(a), v0, to_exact(c), v0));
        BOOST_CHECK_EQUAL(found, order(a, v0, c.reverse_u(), v0));
        return found;
      };
      BOOST_CHECK_LE(1, check(b));
      BOOST_CHECK_LE(1, check(with_factor(b, kind == 2 ? 0.25 : 0.375)));
      for (int layer : {0, 1, 2})
        for (int of_weight : {0, 1}) { // the next number in one place
          auto points = s.image;
          auto weights = s.weights;
          const std::size_t i = static_cast<std::size_t>(random.integer(0, n)), j = static_cast<std::size_t>(layer);
          if (of_weight)
            weights[i][j] = std::nextafter(weights[i][j], 1e308);
          else
            points[i][j] = Filtered::Point(points[i][j].x(), points[i][j].y(), std::nextafter(points[i][j].z(), 1e308));
          const int found = check(Patch<Filtered>(points, weights));
          if (layer == 0 && (n > 1 || !of_weight)) BOOST_CHECK_EQUAL(found, -1);
        }
    }
  }
  BOOST_TEST_MESSAGE("fixed length " << fixed << ", any length " << multiprecision);
  BOOST_CHECK_GT(fixed, multiprecision);
}

// Rows whose weights are negative, zero or long at an end are left to numbers of any length.
BOOST_AUTO_TEST_CASE(weights_at_the_ends_of_rows) {
  typedef GC::Edge_rows<Q, 4> Rows;
  const auto rows = [](const Q& weight, int y) {
    const auto vector = [](const Q& x, const Q& y, const Q& w) {
      GC::Coordinate_vector<Q, 4> v(4);
      v[0] = x;
      v[1] = y;
      v[3] = w;
      return v;
    };
    const Q zero(0);
    return Rows{{vector(zero, zero, Q(1)), vector(Q(1), zero, weight)},
                {vector(zero, Q(y), zero), vector(zero, Q(y), zero)},
                {vector(zero, zero, zero), vector(zero, zero, zero)}};
  };
  const auto fit = [&](const Q& weight) {
    GC::internal::Homogeneous_layers x, y;
    return GC::internal::edge_layers(rows(weight, 1), rows(weight, -1), x, y);
  };
  BOOST_CHECK(fit(Q(1)) && fit(Q(3)) && fit(Q(0x1p53)));
  BOOST_CHECK(!fit(Q(-1)) && !fit(Q(0)) && !fit(Q(Q(0x1p53) + Q(1))));
}

BOOST_AUTO_TEST_CASE(degenerate_edges) {
  typedef Filtered::Point P;
  // the apex of a cone with other weights on each side: one point, in another rational
  // parametrisation
  const Patch<Filtered> cone({{P(0, 0, 0), P(1, 0, 1)}, {P(0, 0, 0), P(1, 1, 1)}, {P(0, 0, 0), P(0, 1, 1)}},
                             {{1, 1}, {1, 1}, {2, 2}}),
      other({{P(0, 0, 0), P(1, 0, -1)}, {P(0, 0, 0), P(1, 1, -1)}, {P(0, 0, 0), P(0, 1, -1)}},
            {{1, 1}, {3, 3}, {2, 2}});
  BOOST_CHECK_EQUAL(order(cone, v0, cone, v0), 0);
  BOOST_CHECK_EQUAL(order(cone, v0, other, v0), 0);
  const auto apex = edge_continuity(cone, v0, other, v0);
  BOOST_CHECK(apex.collapsed && apex.defect == GC::Edge_defect::collapsed);
  // a generator that ends in the apex
  const auto generator = edge_continuity(cone, u0, cone, u0);
  BOOST_CHECK(generator.normal_vanishes && generator.g_order == 0);
  // one weight for the edge and others next to it; degrees that differ; lines
  const Patch<Filtered> flat({{P(0, 0, 0), P(0, 1, 0)}, {P(2, 0, 0), P(2, 1, 0)}}, {{1, 2}, {1, 3}}),
      next({{P(0, 0, 0), P(0, -1, 0)}, {P(2, 0, 0), P(2, -3, 0)}}, {{4, 1}, {4, 1}});
  BOOST_CHECK_EQUAL(order(flat, v0, next, v0), 2);
  BOOST_CHECK_EQUAL(order(flat, v0, next.reverse_u(), v0), 2);
  BOOST_CHECK_EQUAL(order(flat, v0, next.elevate(1, 0), v0), 2);
  BOOST_CHECK_EQUAL(order(flat, u1, next, v0), -1);
  // overflow of products of doubles, and numbers that are so far apart that they have no common
  // grid
  const Patch<Filtered> huge({{P(0, 0, 0), P(0, 1e300, 0)}, {P(2, 0, 0), P(2, 1, 1e-300)}},
                             {{1e200, 2e200}, {1e200, 1}});
  BOOST_CHECK_EQUAL(order(huge, v0, huge, v0), 0);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

BOOST_AUTO_TEST_SUITE_END()
