// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Twelve more tasks, a few lines each: chains, splines, arcs, models, handles and files.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef CGAL::Simple_cartesian<FT> Kernel; // exact constructions
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;
typedef Kernel::Point_2 Point;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef GC::Traits_2<CGAL::Epick> Doubles; // exact decisions about doubles
typedef Doubles::Point Double_point;
using GC::Closure;

int main() {
  //! [tasks]
  // 1. which joins of a closed chain are not G2, and how far from that
  typedef GC::Bezier_curve<Doubles, 3> Cubic;
  const double k = 0.5523;
  const std::vector<Cubic> circle{{{1, 0}, {1, k}, {k, 1}, {0, 1}},
                                  {{0, 1}, {-k, 1}, {-1, k}, {-1, 0}},
                                  {{-1, 0}, {-1, -k}, {-k, -1}, {0, -1}},
                                  {{0, -1}, {k, -1.01}, {1, -k}, {1, 0}}};
  const auto joins = GC::chain_joins(circle, Closure::closed);
  for (std::size_t i = 0; i < joins.size(); ++i)
    if (joins[i].g_order < 2)
      std::cout << "1. join " << i << ": " << joins[i] << "; " << GC::deviation(circle[i], circle[(i + 1) % 4]) << '\n';

  // 2. only their numbers: one question about many joins
  std::cout << "2. " << GC::failing_joins(circle, GC::is_g2_join).size() << " of the inner joins\n";

  // 3. decimals as they are written: 0.1 is 1/10
  const FT x = GC::parse_number<FT>("0.1"), y = GC::parse_number<FT>("0.3"), z = GC::parse_number<FT>("0.9");
  const GC::Bezier_curve<Plane> first{Point(0, 0), Point(x, y)}, second{Point(x, y), Point(y, z)};
  std::cout << "3. " << GC::continuity(first, second) << '\n';

  // 4. one corner: what remains on the left, the blend, what remains on the right
  const GC::Bezier_curve<Plane> along{Point(0, 0), Point(3, 0)}, up{Point(3, 0), Point(3, 2)};
  const auto corner = GC::round_corner(along, up, 0.5);
  std::cout << "4. " << GC::continuity(corner.left, corner.blend) << ", " << GC::continuity(corner.blend, corner.right)
            << '\n';

  // 5. from a line to an arc: r = 1/2 is the tangent of a quarter of the angle, which is 106
  //    degrees
  const GC::Bezier_curve<Plane> line{Point(-5, 0), Point(-2, 0)};
  const auto arc = GC::circular_arc(Point(0, 2), Point(0, 0), FT(1) / 2);
  const auto transition = GC::blend(line, arc, GC::Fair());
  std::cout << "5. the arc ends at " << arc.control_point(2) << "; " << GC::continuity(transition, arc) << '\n';

  // 6. a spline: knots are inserted into a new one, the Bezier curves of its spans
  const std::vector<Point> points{Point(0, 0), Point(1, 1), Point(2, 0), Point(3, 1), Point(4, 0)};
  const GC::Bspline_curve<Plane> spline(points, GC::Knot_vector<FT>(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}));
  const auto finer = spline.insert(FT(1), 2);
  std::cout << "6. " << finer.number_of_points() << " points, " << finer.bezier_pieces().size() << " pieces; again "
            << finer.remove_superfluous_knots().number_of_points() << " points\n";

  // 7. a curve and its tangent, curvature and torsion at a parameter
  const GC::Bezier_curve<Space> cubic{Point_3(0, 0, 0), Point_3(1, 2, 0), Point_3(3, 2, 1), Point_3(4, 0, 1)};
  const auto jet = cubic.jet(FT(1) / 2, 3);
  std::cout << "7. at " << jet.point() << " in the direction " << jet.derivative(1) << ", curvature^2 "
            << *GC::curvature_squared(jet) << ", torsion " << *GC::torsion(jet) << '\n';

  // 8. on from the end of a curve with continuous curvature, to a wished point
  const auto next = GC::extend_toward(cubic, GC::Frenet_order::curvature, Point_3(9, 0, 2));
  std::cout << "8. " << GC::continuity(cubic, next) << " to " << next.control_point(3) << '\n';

  // 9. few curves near a polyline, and a fair spline through its points
  std::vector<Double_point> track;
  for (int i = 0; i <= 40; ++i) track.emplace_back(i, 10 * std::sin(i / 6.));
  const auto fitted = GC::fit(track, 0.05);
  std::cout << "9. " << fitted.number_of_segments() << " cubics, " << GC::chain_continuity(fitted) << "; "
            << GC::chain_continuity(GC::interpolate_fair(track)) << '\n';

  // 10. a blend of doubles with exact joins: it has the curves that it joins, on a grid
  const GC::Bezier_curve<Doubles> phi{{0, 0}, {0.1, 0.3}, {0.5, 0.7}}, psi{{2.3, 0.9}, {3.1, 0.4}, {4, 0.2}};
  const auto blend = GC::representable_blend(phi, psi);
  std::cout << "10. " << GC::continuity(blend.phi, blend) << ", " << GC::continuity(blend, blend.psi)
            << "; phi was moved by " << blend.start_join.moved << '\n';

  // 11. the edges of a model that are not G1
  const auto model =
      GC::model_continuity(GC::cylinder(Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 2)));
  for (const auto& edge : model.edges)
    if (edge.kind == GC::Model_edge_kind::shared && edge.continuity.g_order < 1) std::cout << edge << '\n';
  std::cout << "11. " << model.summary << '\n';

  // 12. what was decided, as JSON
  std::cout << "12. ";
  GC::write_json(std::cout, GC::continuity(first, second));
  std::cout << '\n';
  //! [tasks]
  return 0;
}
