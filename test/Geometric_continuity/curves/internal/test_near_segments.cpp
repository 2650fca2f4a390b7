// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which points are near a segment.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/polyline.h>

BOOST_AUTO_TEST_SUITE(near_segments)

// The squares of distances up to 1 are near: of the ends, and beside the segment.
BOOST_AUTO_TEST_CASE(distances_up_to_1) {
  typedef GC::Coordinate_vector<CGAL::Exact_rational, 2> Column;
  const auto is_near = [](const CGAL::Exact_rational& x, const CGAL::Exact_rational& y) {
    Column p(2), q(2), at(2);
    q[0] = 3;
    at[0] = x;
    at[1] = y;
    return GC::internal::is_near_segment(at, p, q);
  };
  const CGAL::Exact_rational more = CGAL::Exact_rational(1) + CGAL::Exact_rational(1) / 1000000;
  BOOST_CHECK(is_near(-1, 0) && is_near(4, 0) && is_near(0, 1) && is_near(3, 1) && is_near(2, -1));
  BOOST_CHECK(!is_near(-more, 0) && !is_near(CGAL::Exact_rational(3 + more), 0) && !is_near(0, more) &&
              !is_near(3, more) && !is_near(2, -more));
}

BOOST_AUTO_TEST_SUITE_END()
