// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Keys by which the edges of a model are recognised.

#include "support/spline_surfaces.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

BOOST_AUTO_TEST_CASE(keys_of_edges) {
  typedef GC::internal::Edge_key<GC::Traits_3<Exact>> Key;
  std::mt19937_64 random = seeded();
  const S s = with_points(spline(wave, knots(0, 4, {1, 2, 3, 3}), knots(0, 1)), [&](int, int, const Exact::Point_3&) {
    return Exact::Point_3{int(random() % 7), int(random() % 7), int(random() % 7)};
  });
  const Key key(s, v0);
  for (const S& t : {s.elevate(2, 1), s.reverse_u(), with_knots(s, Q(5) / 3, -1), s.insert_u(Q(1) / 2, 2).clamp(),
                     with_knots(s.insert_u(2, 2).reverse_u(), Q(1) / 7, 0).elevate(1, 0)})
    BOOST_CHECK_EQUAL(key.compare(Key(t, v0)), 0);
  BOOST_CHECK_EQUAL(key.compare(Key(s.reverse_v(), v1)), 0);
  BOOST_CHECK_EQUAL(key.compare(Key(s.swap_parameters(), u0)), 0);
  for (const S& t : {lifted(s, 3, 0), part(s, 0, 3), part(s, 0, 1)}) {
    BOOST_CHECK_NE(key.compare(Key(t, v0)), 0);
    BOOST_CHECK_EQUAL(key.compare(Key(t, v0)), -Key(t, v0).compare(key));
  }
  BOOST_CHECK(!key.single_point());
  BOOST_CHECK(
      Key(with_points(s, [](int, int j, const Exact::Point_3& p) { return j == 0 ? Exact::Point_3(1, 2, 3) : p; }), v0)
          .single_point());
  // with weights: a point is one whatever they are
  typedef GC::Rational_bezier_patch<GC::Traits_3<Exact>> Rational;
  typedef Exact::Point_3 P;
  const auto single_point = [](const P& middle, const P& end) {
    const Rational lid({{P(1, 2, 3), P(0, 0, 0)}, {middle, P(1, 0, 0)}, {end, P(2, 0, 0)}}, {{1, 1}, {3, 1}, {2, 1}});
    return GC::internal::Edge_key<GC::Traits_3<Exact>, 4>(lid, v0).single_point();
  };
  BOOST_CHECK(single_point(P(1, 2, 3), P(1, 2, 3)));
  BOOST_CHECK(!single_point(P(1, 2, 4), P(1, 2, 3)));
  BOOST_CHECK(!single_point(P(1, 2, 3), P(1, 2, 4)));
  // the same for Bezier patches
  const S one = spline(wave, knots(0, 4, {1, 2}), knots(0, 1));
  BOOST_CHECK_EQUAL(Key(one, v0).compare(Key(spline(wave, knots(0, 4), knots(0, 1)).bezier_patches()[0], v0)), 0);
}
