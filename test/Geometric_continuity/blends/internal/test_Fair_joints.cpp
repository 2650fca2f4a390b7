// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Where the search for tangents and curvatures of a fair spline starts.

#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/internal/Fair_joints.h>

BOOST_AUTO_TEST_SUITE(fair_joints)

// Points on a circle have its tangents and curvatures, also at the ends.
BOOST_AUTO_TEST_CASE(circles_through_points) {
  for (const bool closed : {false, true}) {
    std::vector<GC::internal::Fair_joint<2>> joints;
    for (const double angle : {0., 0.7, 1.5, 2.2, 3.3}) {
      joints.emplace_back();
      joints.back().point[0] = 2 * std::cos(angle);
      joints.back().point[1] = 2 * std::sin(angle);
    }
    GC::internal::take_circles(joints, closed);
    for (const GC::internal::Fair_joint<2>& joint : joints) {
      BOOST_CHECK_SMALL(joint.tangent[0] + joint.point[1] / 2, 1e-12);
      BOOST_CHECK_SMALL(joint.tangent[1] - joint.point[0] / 2, 1e-12);
      for (int x = 0; x < 2; ++x) BOOST_CHECK_SMALL(joint.curvature[x] + joint.point[x] / 4, 1e-12);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
