// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Finds a kink in the outline of a letter and mends it on the grid of integers: of the pairs of
// handles that lie on one line through the node, the one with the least moves.

#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

Point point(const GC::Grid_vector& v) { return Point(double(v.x), double(v.y)); }

void describe(const char* when, const Curve& left, const Curve& right) {
  std::cout << when << ": " << GC::visual_class(left, right).value() << '\n';
}

int main() {
  // Two curves of the letter S of Latin Modern Sans 12, in units of the font.
  const GC::Grid_vector node{171, 446};
  const Curve left{Point(286, 402), Point(218, 419), Point(193, 425), point(node)},
      right{point(node), Point(158, 460), Point(131, 485), Point(131, 530)};
  describe("as drawn", left, right);
  const GC::Kink_size size = GC::kink_size(left, right).value();
  std::cout << "  in degrees: " << GC::in_degrees(size.angle) << "\n  a handle is off by: " << size.handle_offset
            << '\n';

  const GC::Grid_vector before{193, 425}, behind{158, 460};
  const GC::Aligned_handles legs =
      GC::align_handles({node.x - before.x, node.y - before.y}, {behind.x - node.x, behind.y - node.y}).value();
  const GC::Grid_vector first = node + (-1) * legs.left, second = node + legs.right;
  std::cout << "handles: " << before << " -> " << first << ", " << behind << " -> " << second << '\n';

  const Curve mended_left{Point(286, 402), Point(218, 419), point(first), point(node)},
      mended_right{point(node), point(second), Point(131, 485), Point(131, 530)};
  describe("mended", mended_left, mended_right);
  return GC::is_g1_join(mended_left, mended_right) ? 0 : 1;
}
