// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Counts the regions into which curves divide the plane: an arrangement of their polylines, in
// exact numbers throughout, so that common points stay common points. (Arrangement_on_surface_2 is
// under the GPL.)

#include <CGAL/Arr_polyline_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>

#include <iostream>
#include <iterator>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef GC::Traits_2<Kernel> Traits;
typedef Kernel::FT FT;
typedef Kernel::Point_2 Point;
typedef CGAL::Arr_polyline_traits_2<CGAL::Arr_segment_traits_2<Kernel>> Arr_traits;
typedef CGAL::Arrangement_2<Arr_traits> Arrangement;

template <class Curve> Arr_traits::Curve_2 polyline(const Arr_traits& traits, const Curve& curve) {
  std::vector<Point> points;
  GC::chord_polyline(curve, FT(1) / 64, std::back_inserter(points));
  return traits.construct_curve_2_object()(points.begin(), points.end());
}

int main() {
  // A curve with a loop, a parabola, the blend that leads from one to the other, and an oval around
  // them.
  const GC::Bezier_curve<Traits> loop{Point(-4, 0), Point(8, 8), Point(-8, 8), Point(4, 0)};
  const GC::Bezier_curve<Traits> parabola{Point(6, 6), Point(2, 2), Point(-6, 2)};
  const GC::Quintic_blend<Traits> blend = GC::blend(loop, parabola);
  const std::vector<Point> ring{Point(-3, 3), Point(-3, 7),  Point(3, 7), Point(3, 3),
                                Point(3, -1), Point(-3, -1), Point(-3, 3)};
  const GC::Composite_bezier_curve<Traits> oval(ring.begin(), ring.end(), {0, 1, 2});

  const Arr_traits traits;
  Arrangement arrangement(&traits);
  const auto report = [&](const char* name, const Arr_traits::Curve_2& curve) {
    insert(arrangement, curve);
    std::size_t crossings = 0;
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) crossings += v->degree() > 2;
    std::cout << name << ": " << arrangement.number_of_faces() << " faces, crossings: " << crossings << '\n';
  };
  report("loop", polyline(traits, loop));
  report("with the blend", polyline(traits, blend));
  report("with the parabola", polyline(traits, parabola));
  report("with the oval", polyline(traits, oval));
  // Euler's formula for a connected arrangement.
  const bool connected =
      arrangement.number_of_vertices() + arrangement.number_of_faces() == arrangement.number_of_edges() + 2;
  return connected && arrangement.is_valid() ? 0 : 1;
}
