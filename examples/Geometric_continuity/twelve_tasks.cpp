// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Twelve common tasks, a few lines each: how the calls look.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <iostream>
#include <sstream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef CGAL::Simple_cartesian<FT> Kernel; // exact constructions
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;
typedef Kernel::Point_2 Point;
typedef Kernel::Point_3 Point_3;
typedef GC::Traits_2<CGAL::Epick> Doubles; // exact decisions about doubles
typedef Doubles::Point Double_point;
using GC::Closure;
using GC::Patch_edge;

int main() {
  //! [tasks]
  // 1. blend two curves, and prove the joins
  const GC::Bezier_curve<Plane> phi{Point(0, 0), Point(1, 2), Point(2, 2)}, psi{Point(5, 1), Point(6, 0), Point(7, 1)};
  const auto gamma = GC::blend(phi, psi);
  std::cout << "1. " << GC::continuity(phi, gamma) << ", " << GC::continuity(gamma, psi) << '\n';

  // 2. the fairest blend: E, and how good it was before the search
  const auto fair = GC::blend(phi, psi, GC::Fair());
  std::cout << "2. " << fair.report << '\n';

  // 3. the orders of the joins of a chain; one question about all of them
  const std::vector<GC::Bezier_curve<Plane>> chain{phi, gamma, psi};
  const auto summary = GC::chain_continuity(chain, 3, Closure::open);
  std::cout << "3. " << summary << ": at least G" << *summary.g_order() << '\n';
  for (const auto& join : GC::chain_joins(chain)) std::cout << "   G" << join.g_order << '\n';

  // 4. doubles: what is decided, how far it is from smooth, and within which tolerance it is smooth
  const GC::Bezier_curve<Doubles> a{Double_point(0, 0), Double_point(0.1, 0.3)},
      b{Double_point(0.1, 0.3), Double_point(0.3, 0.9)};
  GC::Join_tolerance tolerance;
  tolerance.tangent_angle = 1e-12; // radians
  std::cout << "4. G" << GC::continuity(a, b).g_order << ", the tangents differ by at most "
            << GC::deviation(a, b).tangent_angle->upper << " rad, within 1e-12: order "
            << GC::order_within(a, b, tolerance).proved_order() << '\n';

  // 5. a B-spline curve of degree 3, its control points and knots; the continuity at a knot
  const std::vector<Point> points{Point(0, 0), Point(1, 1), Point(2, 0), Point(3, 1), Point(4, 0)};
  const GC::Bspline_curve<Plane> spline(points, GC::Knot_vector<FT>(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}));
  std::cout << "5. " << GC::knot_continuity(spline, FT(1)) << '\n';

  // 6. a curve through points, with continuous second derivatives
  const auto through = GC::interpolate<Plane>(points, GC::Parametrisation::chordal, Closure::open);
  std::cout << "6. degree " << through.degree() << ", " << through.number_of_points() << " control points\n";

  // 7. round the corners of a closed outline
  const std::vector<GC::Bezier_curve<Plane>> outline{
      {Point(0, 0), Point(4, 0)}, {Point(4, 0), Point(4, 3)}, {Point(4, 3), Point(0, 0)}};
  const auto rounded = GC::round_corners(outline, 0.5, Closure::closed);
  std::cout << "7. " << rounded.curves.size() << " curves, " << GC::chain_continuity(rounded.curves, 2, Closure::closed)
            << '\n';

  // 8. two patches along a common edge; net[i][j] belongs to u^i v^j
  const GC::Bezier_patch<Space> left({{Point_3(0, 0, 0), Point_3(0, 1, 0)}, {Point_3(1, 0, 1), Point_3(1, 1, 1)}}),
      right({{Point_3(1, 0, 1), Point_3(1, 1, 1)}, {Point_3(3, 0, 3), Point_3(3, 1, 3)}});
  std::cout << "8. " << GC::edge_continuity(left, Patch_edge::u1, right, Patch_edge::u0) << '\n';

  // 9. a surface that is G2 with two others
  const GC::Bezier_patch<Space> far({{Point_3(4, 0, 0), Point_3(4, 1, 0)}, {Point_3(5, 0, 0), Point_3(5, 1, 0)}});
  const auto between = GC::blend(left, Patch_edge::u1, far, Patch_edge::u0);
  std::cout << "9. " << GC::edge_continuity(left, Patch_edge::u1, between, Patch_edge::v0) << '\n';

  // 10. write curves as .g2, and read them
  std::stringstream file;
  for (const auto& curve : outline) GC::write_g2(file, curve);
  const std::vector<GC::Bezier_curve<Plane>> read = GC::read_g2_curves<Plane>(file);
  std::cout << "10. " << read.size() << " curves\n";

  // 11. a closed chain: its last curve leads to the first
  std::cout << "11. " << GC::chain_continuity(read, 3, Closure::closed) << '\n';

  // 12. a picture with curvature combs and the curvature against the arc length
  GC::Svg_style combed;
  combed.curvature_comb = combed.curvature_plot = true;
  std::ostringstream picture;
  picture << GC::Svg_figure("A blend").add(phi).add(gamma, combed).add(psi);
  std::cout << "12. " << (picture.str().size() > 1000 ? "drawn" : "empty") << '\n';
  //! [tasks]
  return 0;
}
