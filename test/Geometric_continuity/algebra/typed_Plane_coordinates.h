// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

BOOST_AUTO_TEST_SUITE(plane_coordinates)

typedef std::pair<FT, FT> Pair;

TEST_IN_EVERY_SPACE(vectors_of_the_plane) {
  const Column<Traits> v = column<Traits>(d, {1, 2}), w = column<Traits>(d, {3, 1});
  const GC::Plane_coordinates plane(v, w);
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b) {
      const Column<Traits> u = FT(a) * v + FT(b) * w;
      BOOST_CHECK(plane(u) == Pair(FT(a), FT(b)));
      BOOST_CHECK(plane.nearest(u) == Pair(FT(a), FT(b)));
    }
}

TEST_IN_EVERY_SPACE(vectors_off_the_plane) {
  if (d < 3) return; // in the plane there are none
  const Column<Traits> v = column<Traits>(d, {1, 2}), w = column<Traits>(d, {3, 1});
  Column<Traits> normal(d);
  normal[d - 1] = FT(1);
  const GC::Plane_coordinates plane(v, w);
  const Column<Traits> u = FT(2) * v - w + ratio(1, 1024) * normal;
  BOOST_CHECK(!plane(u));
  BOOST_CHECK(plane.nearest(u) == Pair(FT(2), FT(-1)));
}

BOOST_AUTO_TEST_CASE(random_vectors) {
  if (!exact || !cancels) return;
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    const std::vector<Point<Traits>> points = random_points<Traits>(random, d, 3, &Random::rational);
    const Column<Traits> v = column<Traits>(points[0]), w = column<Traits>(points[1]), u = column<Traits>(points[2]);
    const GC::Plane_coordinates plane(v, w);
    const Pair c = plane.nearest(u);
    const Column<Traits> rest = u - c.first * v - c.second * w; // orthogonal to the plane
    BOOST_CHECK(dot(rest, v) == FT(0));
    BOOST_CHECK(dot(rest, w) == FT(0));
    BOOST_CHECK_EQUAL(plane(u).has_value(), is_zero(rest));
    BOOST_CHECK(plane(u - rest) == c);
  });
}

TEST_IN_EVERY_SPACE(parallel_vectors_are_refused) {
  const Column<Traits> v = column<Traits>(d, {1, 2}), zero = column<Traits>(d, {0});
  for (const Column<Traits>& w : {v, FT(-2) * v, zero}) {
    CHECK_ERROR(GC::Plane_coordinates(v, w), singular_frame);
    CHECK_ERROR(GC::Plane_coordinates(w, v), singular_frame);
  }
}

BOOST_AUTO_TEST_SUITE_END()
