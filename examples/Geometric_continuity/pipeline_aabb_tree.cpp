// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Computes the distance of a point from a curve, with a guaranteed error: an AABB tree of CGAL
// answers for a polyline that is nowhere farther from the curve than its tolerance. (AABB_tree is
// under the GPL.)

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<Kernel::Segment_3> Segments;
#if CGAL_VERSION_MAJOR >= 6
typedef CGAL::AABB_segment_primitive_3<Kernel, Segments::const_iterator> Primitive;
typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> Tree;
#else
typedef CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator> Primitive;
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
#endif

int main() {
  typedef GC::Bezier_curve<GC::Traits_3<Kernel>> Curve;
  // x = 3 t, y = 3 t^2, z = 2 t^3
  const Curve cubic{Point(0, 0, 0), Point(1, 0, 0), Point(2, 1, 0), Point(3, 3, 2)};
  bool ok = true;
  for (double tolerance : {0.1, 0.001, 0.00001}) {
    std::vector<Point> points;
    GC::chord_polyline(cubic, tolerance, std::back_inserter(points));
    Segments segments;
    for (std::size_t i = 1; i < points.size(); ++i) segments.emplace_back(points[i - 1], points[i]);
    Tree tree(segments.begin(), segments.end());

    // Two units from the point at t = 1/2 along the normal (-2, 1, 2).
    const Point query(1.5 - 4 / 3., 0.75 + 2 / 3., 0.25 + 4 / 3.);
    const double distance = std::sqrt(tree.squared_distance(query));
    std::cout << std::setw(4) << segments.size() << " segments: " << std::fixed << std::setprecision(5)
              << distance - tolerance << " <= distance <= " << distance + tolerance << '\n';
    ok = ok && std::abs(distance - 2) <= tolerance;
  }
  return ok ? 0 : 1;
}
