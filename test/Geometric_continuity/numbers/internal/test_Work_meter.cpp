// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// How many steps searches may take that can be stopped at any time: each a quarter of the limit,
// all together half of it.

#include "support/test.h"

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

BOOST_AUTO_TEST_SUITE(work_meters)

BOOST_AUTO_TEST_CASE(searches) {
  GC::internal::Work_meter meter(GC::Work_limit(1000), "a search");
  BOOST_CHECK(!meter.allows_search(0, 251) && !meter.allows_search(200, 51));
  BOOST_CHECK(meter.allows_search(0, 250) && meter.allows_search(100, 150) && meter.allows_search(0, 100));
  BOOST_CHECK(!meter.allows_search(0, 1)); // 500 of 1000
  const GC::Work_scope all(GC::Work_limit(100), "all");
  GC::internal::Work_meter within(GC::Work_limit(1000), "a search");
  BOOST_CHECK(!within.allows_search(0, 26) && within.allows_search(0, 25));
}

BOOST_AUTO_TEST_SUITE_END()
