// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Normals that vanish are found, and those of graphs are proved not to.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>

BOOST_AUTO_TEST_SUITE(possible_folds)

template <class FT> bool contains(const std::pair<FT, FT>& interval, const FT& x) {
  return interval.first <= x && x <= interval.second;
}

// z = (u - a)^2 over (u, v) with the place (a, b) of a vanishing normal: x = (u - a)^2, y = (v -
// b)^2, z = (u - a)(v - b) has there the derivatives zero.
template <class Traits, class FT = typename Traits::FT>
Bezier<Traits> cusp(const typename Traits::FT& a, const typename Traits::FT& b) {
  typedef typename Traits::Point P;
  const auto square = [](const FT& c, int i) {
    return i == 0 ? FT(c * c) : i == 1 ? FT(c * c - c) : FT((c - 1) * (c - 1));
  };
  const auto line = [](const FT& c, int i) { return FT(FT(i) / FT(2) - c); };
  return Bezier<Traits>(
      net_of(3, 3, [&](int i, int j) { return P(square(a, i), square(b, j), line(a, i) * line(b, j)); }));
}

TEST_FOR_EACH(regular_and_folded, Traits, All_traits) {
  typedef typename Traits::Point P;
  // a graph, which turns by nearly two right angles
  const Bezier<Traits> graph({{P(0, 0, 0), P(0, 1, 0), P(0, 2, 0)},
                              {P(1, 0, 40), P(1, 1, 40), P(1, 2, 40)},
                              {P(2, 0, 0), P(2, 1, 0), P(2, 2, 0)}},
                             {FT(3), FT(5)}, {FT(0), FT(1)});
  BOOST_CHECK(!possible_fold(graph));
  BOOST_CHECK(!possible_fold(Bspline<Traits>(graph)));
  BOOST_CHECK(!possible_fold(Patch<Traits>(graph)));
  // far away from the origin
  BOOST_CHECK(!possible_fold(graph.transform([](const P& p) { return P(p.x() + 1000000, p.y(), p.z()); })));
  // x turns back at u = 4 + 1/4, on the whole line: y and z are v and 0
  const Bezier<Traits> fold({{P(0, 0, 0), P(0, 1, 0)}, {P(5, 0, 0), P(5, 1, 0)}, {P(2, 0, 0), P(2, 1, 0)}},
                            {FT(3), FT(5)}, {FT(0), FT(1)});
  const auto found = possible_fold(fold);
  BOOST_REQUIRE(found);
  BOOST_CHECK(contains(found->u, FT(4.25)) && contains(found->v, FT(0)));
  BOOST_CHECK(found->u.second - found->u.first == FT(2) / FT(1024));
  BOOST_CHECK(found->v.second - found->v.first == FT(1) / FT(1024));
  BOOST_CHECK(possible_fold(Bspline<Traits>(fold)));
  // one point, inside, at a corner or on a side
  for (const auto& [a, b] :
       {std::make_pair(FT(0.3), FT(0.7)), std::make_pair(FT(0), FT(1)), std::make_pair(FT(1), FT(0.2))}) {
    const auto place = possible_fold(cusp<Traits>(a, b));
    BOOST_REQUIRE(place);
    // or next to it
    const auto near = [](const std::pair<FT, FT>& part, const FT& x) {
      return contains(std::make_pair(FT(part.first - FT(0.01)), FT(part.second + FT(0.01))), x);
    };
    BOOST_CHECK(near(place->u, a) && near(place->v, b));
  }
  BOOST_CHECK(!possible_fold(cusp<Traits>(FT(-0.25), FT(0.5))));
  // a pole, lines that are points, and a surface without extent in u
  BOOST_CHECK(possible_fold(Bezier<Traits>({{P(0, 0, 0), P(0, 0, 0)}, {P(1, 0, 0), P(1, 1, 0)}})));
  BOOST_CHECK(possible_fold(Bezier<Traits>({{P(0, 0, 0), P(0, 1, 0)}})));
}

// With different weights: an octant of a sphere has a pole; the rest, and a quarter of a cylinder,
// are regular. A patch that is a curve, in u or in v, has no normal.
BOOST_AUTO_TEST_CASE_TEMPLATE(curves, Traits, All_traits) {
  typedef typename Traits::Point P;
  const Bezier<Traits> curve({{P(0, 0, 0)}, {P(1, 0, 0)}, {P(2, 1, 0)}});
  BOOST_CHECK(possible_fold(curve).has_value() && possible_fold(curve.swap_parameters()).has_value());
}

TEST_FOR_EACH(rational, Traits, All_traits) {
  typedef typename Traits::Point P;
  const Patch<Traits> cylinder({{P(1, 0, 0), P(1, 0, 5)}, {P(1, 1, 0), P(1, 1, 5)}, {P(0, 1, 0), P(0, 1, 5)}},
                               {{1, 1}, {1, 1}, {2, 2}});
  BOOST_CHECK(!possible_fold(cylinder));
  BOOST_CHECK(!possible_fold(Spline<Traits>(cylinder)));
  const Patch<Traits> sphere({{P(1, 0, 0), P(1, 0, 1), P(0, 0, 1)},
                              {P(1, 1, 0), P(1, 1, 1), P(0, 0, 1)},
                              {P(0, 1, 0), P(0, 1, 1), P(0, 0, 1)}},
                             {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}});
  const auto pole = possible_fold(sphere);
  BOOST_REQUIRE(pole);
  BOOST_CHECK(contains(pole->v, FT(1)));
  BOOST_CHECK(!possible_fold(sphere.split_v(FT(0.5)).first));
  // x = u, y = v as polynomials; the weights make no fold, the points do
  const auto net = [](int middle) {
    return std::vector<std::vector<P>>{
        {P(0, 0, 0), P(0, 1, 0)}, {P(middle, 0, 0), P(middle, 1, 0)}, {P(2, 0, 0), P(2, 1, 0)}};
  };
  const std::vector<std::vector<FT>> weights = {{1, 2}, {3, 1}, {2, 5}};
  BOOST_CHECK(!possible_fold(Patch<Traits>(net(1), weights)));
  BOOST_CHECK(possible_fold(Patch<Traits>(net(4), weights)));
}

// Only in one span; the rectangle is in the parameters of the surface.
// x' = (u - r)^2 - e along u, with two zeros next to r if e > 0 and none if e < 0, also with the
// weights 1, 2, 4, 8 along u and as the v of a patch that is of degree 3 in both.
BOOST_AUTO_TEST_CASE(narrow_folds) {
  typedef Exact::Point P;
  for (int k = 1; k < 10; ++k)
    for (const Q& e : {Q(1, 100000), Q(-1, 100000)}) {
      const Q r(k, 10), h[] = {r * r - e, r * r - r - e, (1 - r) * (1 - r) - e};
      const Q x[] = {0, h[0] / 3, (h[0] + h[1]) / 3, (h[0] + h[1] + h[2]) / 3};
      const auto along_u = net_of(4, 4, [&](int i, int j) { return P(x[i], Q(j, 3), Q(0)); }),
                 along_v = net_of(4, 4, [&](int i, int j) { return P(Q(i, 3), x[j], Q(0)); });
      const auto weights = net_of(4, 4, [](int i, int) { return Q(1 << i); });
      const auto u = possible_fold(Bezier<Exact>(along_u)), v = possible_fold(Bezier<Exact>(along_v)),
                 w = possible_fold(Patch<Exact>(along_u, weights));
      BOOST_CHECK(bool(u) == (e > 0) && bool(v) == (e > 0) && bool(w) == (e > 0));
      if (!u || !v || !w) continue;
      const auto is_near = [](const std::pair<Q, Q>& range, const Q& zero) {
        return abs(range.first - zero) < Q(1, 100);
      };
      // of 2 u / (1 + u) = r
      BOOST_CHECK(is_near(u->u, r) && is_near(v->v, r) && is_near(w->u, r / (2 - r)));
    }
}

BOOST_AUTO_TEST_CASE(spans) {
  Random_surfaces random;
  const Knots u(1, {0, 0, 1, 3, 4, 4}), v(1, {0, 0, 1, 1});
  const auto surface = [&](int x) {
    std::vector<std::vector<Exact::Point>> net;
    for (int a : {0, 1, 2, 3}) net.push_back({{Q(a), Q(0), Q(0)}, {Q(a == 2 ? x : a), Q(a == 2 ? -1 : 1), Q(0)}});
    return Bspline<Exact>(net, u, v);
  };
  const auto found = possible_fold(surface(2));
  BOOST_REQUIRE(found);
  BOOST_CHECK(found->u.first >= Q(1) && found->u.second <= Q(3));
  const GC::Work_scope each(GC::Work_limit(100));
  CHECK_ERROR(possible_fold(surface(2)), work_limit);
}

// The random surfaces are graphs over the plane, nearly: what is decided is compared with normals
// at points.
BOOST_AUTO_TEST_CASE(random_graphs) {
  Random_surfaces random;
  for (int i = 0; i < 4; ++i) {
    BOOST_CHECK(!possible_fold(random.surface<Bezier<Exact>>()));
    BOOST_CHECK(!possible_fold(random.surface<Bspline<Exact>>()));
    BOOST_CHECK(!possible_fold(random.surface<Patch<Exact>>()));
  }
}

BOOST_AUTO_TEST_SUITE_END()
