// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The jets of profiles that are given.

#include "support/swept_surfaces.h"

#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>

BOOST_AUTO_TEST_SUITE(sweep_input)

// A curve may promise more derivatives than it has.
BOOST_AUTO_TEST_CASE(jets_of_profiles) {
  const Curve c{Point(1, 0, 0), Point(2, 0, 1)};
  BOOST_CHECK_EQUAL(GC::internal::require_space_jet(c.start_jet(2), 2, "a curve").order(), 2);
  CHECK_ERROR(GC::internal::require_space_jet(c.start_jet(1), 2, "a curve"), jet_order_too_low);
}

BOOST_AUTO_TEST_SUITE_END()
