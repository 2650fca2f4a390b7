// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Functions along an edge with given values and slopes at its ends.

#include "support/test.h"

#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>

BOOST_AUTO_TEST_SUITE(interpolating_function)

// Slopes for which no span at an end is short enough.
BOOST_AUTO_TEST_CASE(slopes_that_underflow) {
  typedef GC::internal::Edge_end_value<double> Value;
  const auto f = GC::internal::interpolating_function(Value{1, -1e4}, Value{1, 1e4}, true);
  BOOST_CHECK(f.is_positive() && f(0) == 1 && f(1) == 1);
  CHECK_ERROR(GC::internal::interpolating_function(Value{1e-200, -1e200}, Value{1, 1}, true), not_finite);
}

BOOST_AUTO_TEST_SUITE_END()
