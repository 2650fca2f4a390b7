// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The orders G^k are those of the points in projective space: they do not change under a projective
// map, which makes rational patches from polynomial ones that are connected in all ways.

#include "support/nets.h"

BOOST_AUTO_TEST_SUITE(projective_edges)

template <class K> using Rational_patch = GC::Rational_bezier_patch<GC::Traits_3<K>>;

// The image under (x, y, z) -> (x, y, z) / (1 + (x + 2 y + 3 z) / 1000), which is defined near the
// origin.
template <class K, class FT = typename K::FT> Rational_patch<K> projected(const Patch<K>& s) {
  typedef typename Rational_patch<K>::Homogeneous Homogeneous;
  return Rational_patch<K>(Homogeneous(net_of(s.degree_u() + 1, s.degree_v() + 1, [&](int i, int j) {
    const auto x = s.coordinates(i, j);
    typename Homogeneous::Point p(4);
    for (int k = 0; k < 3; ++k) p[k] = x[k];
    p[3] = FT(1) + (x[0] + FT(2) * x[1] + FT(3) * x[2]) / FT(1000);
    return p;
  })));
}

typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Epeck> Exact_kernels;

BOOST_AUTO_TEST_CASE_TEMPLATE(orders_are_projective, K, Exact_kernels) {
  Random random;
  const auto check = [](const Connection& connection, int expected) {
    const std::vector<Patch<K>> s = patches<K>({connection.first(), connection.second()});
    BOOST_CHECK_EQUAL(edge_continuity(s[0], v0, s[1], v0).g_order, expected);
    const Rational_patch<K> a = projected(s[0]), b = projected(s[1]);
    BOOST_CHECK_EQUAL(edge_continuity(a, v0, b, v0).g_order, expected);
    BOOST_CHECK_EQUAL(edge_continuity(b.reverse_u(), v0, a.swap_parameters(), u0).g_order, expected);
    BOOST_CHECK_EQUAL(is_g1_edge(a, v0, b, v0), expected >= 1);
    BOOST_CHECK_EQUAL(is_g2_edge(a, v0, b, v0), expected >= 2);
  };
  for (int round = 0; round < 6; ++round) {
    Connection connection(random, random.integer(2, 3));
    const int begin = random.integer(1, 3), end = random.integer(-3, -1), q = -random.integer(1, 3);
    const Polynomial second_along = random.polynomial(1);
    connection.connect(line(begin, end), constant(q), second_along,
                       random.polynomial(1)); // T2 = p C' + q T1 with p not zero
    check(connection, 2);
    Connection first = connection, crease = connection, fold = connection;
    first.w2[2] = first.w2[2] + Polynomial{Q(0), Q(1) / Q(1000)};
    check(first, 1);
    crease.t2[2] = crease.t2[2] + Polynomial{Q(0), Q(1) / Q(1000)};
    check(crease, 0);
    fold.connect(line(1, -1), line(1, -2), constant(0), constant(0)); // q = 0 inside
    check(fold, 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
