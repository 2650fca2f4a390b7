// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Twelve tasks on what curves and surfaces are made of: coefficients and knots in arrays, bases,
// points and rows.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/swept_continuity.h>
#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef CGAL::Simple_cartesian<FT> Kernel;
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;
typedef Kernel::Point_2 Point;
typedef Kernel::Vector_2 Vector;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;

template <class Range> void print(const char* text, const Range& range) {
  std::cout << text;
  for (const auto& x : range) std::cout << ' ' << x;
  std::cout << '\n';
}

int main() {
  //! [tasks]
  // 1. a spline as knots and coefficients in any array: its basis, blossom and derivatives at a
  //    parameter
  const GC::Knot_vector<FT> knots(2, {0, 0, 0, 1, 2, 2, 2});
  const std::vector<FT> c{0, 2, 1, 3};
  const FT half = FT(1) / 2;
  print("1. basis", GC::bspline_basis(knots, half));
  print("   derivatives", GC::bspline_derivatives(knots, c, knots.span(half), half, 2));
  std::cout << "   blossom " << GC::bspline_blossom(knots, c, knots.span(half), {FT(0), FT(1)}) << '\n';

  // 2. its derivative as a spline
  std::cout << "2. over " << GC::derivative_knots(knots);
  print(":", GC::bspline_derivative(knots, c));

  // 3. one knot more, and without what is superfluous
  const GC::Knot_vector<FT> finer = knots.insert(half);
  const std::vector<FT> more = GC::bspline_insert(knots, c, half);
  print("3.", more);
  std::cout << "   over " << GC::minimal_knots(finer, more);
  print(":", *GC::bspline_remove(finer, more, half));

  // 4. its polynomials, and back
  const std::vector<FT> pieces = GC::bspline_bezier(knots, c);
  print("4.", pieces);
  print("   again", GC::bspline_from_bezier(knots, pieces));

  // 5. its square, and the same spline in degree 3
  std::cout << "5. over " << GC::product_knots(knots, knots);
  print(":", GC::bspline_product(knots, c, knots, c));
  std::cout << "   over " << GC::elevated_knots(knots);
  print(":", GC::bspline_elevate(knots, c));

  // 6. a cubic by its ends and the derivatives there; its control points
  const GC::Hermite_geometry<Plane> ends{Point(0, 0), Point(3, 0), Vector(3, 3), Vector(3, -3)};
  const GC::Cubic_blended_curve<Plane, GC::Hermite_basis> hermite(ends);
  print("6.", hermite.in_basis<GC::Bezier_basis>().geometry());
  std::cout << GC::basis_conversion<FT>(GC::Hermite_basis(), GC::Bezier_basis()) << '\n'
            << GC::hermite_matrix<FT>() * GC::hermite_constraint_matrix<FT>() << '\n';

  // 7. the polynomials with which the columns of its geometry are weighted, and those of Bernstein
  for (const auto& f : GC::blending_functions<FT>(GC::Hermite_basis())) std::cout << "7. " << f << '\n';
  std::cout << "   " << GC::bernstein_polynomials<FT>(3)[1] << '\n';
  print("   at 1/2:", GC::bernstein_basis(3, half));

  // 8. one step of de Casteljau's algorithm, by which three numbers become two; the pattern of
  //    their signs
  std::array<FT, 3> steps{0, 4, -4};
  GC::de_casteljau_step(steps, 2, half);
  GC::Sign_set signs;
  for (int i = 0; i < 2; ++i) signs.add(CGAL::sign(steps[i]));
  std::cout << "8. " << steps[0] << ' ' << steps[1] << ": " << signs.pattern() << '\n';

  // 9. a point is in a convex hull: the weights prove it. The squared length and area that
  //    derivatives span
  const auto column = [](int x, int y) { return GC::coordinates<Plane>(Point(x, y)); };
  print("9.", *GC::convex_weights(std::vector{column(0, 0), column(4, 0), column(0, 4)}, column(1, 1)));
  print("  ", GC::gram_determinants(hermite.start_jet_over<FT>(2), 2));

  // 10. which edges two patches share, and what continuity along one of them depends on
  const GC::Bezier_patch<Space> flat{{Point_3(0, 0, 0), Point_3(0, 1, 0)}, {Point_3(1, 0, 0), Point_3(1, 1, 0)}},
      steep{{Point_3(1, 1, 0), Point_3(1, 1, 2)}, {Point_3(1, 0, 0), Point_3(1, 0, 2)}};
  for (const GC::Common_edge& edge : GC::common_edges(flat, steep))
    std::cout << "10. " << edge.edge_a << ' ' << edge.edge_b << (edge.reversed ? ", backwards" : "") << '\n';
  std::cout << "   cross derivatives";
  for (const auto& t : GC::edge_rows_over<FT>(flat, GC::Patch_edge::u1).cross)
    std::cout << " (" << GC::to_vector<Space>(t) << ')';
  std::cout << '\n';

  // 11. a curve that is swept, as a patch; a spline that is swept, as a surface; where the normal
  //     vanishes
  const GC::Bezier_curve<Space> hook{Point_3(0, 0, 0), Point_3(0, 0, 1), Point_3(1, 0, 0)};
  const GC::Extrusion_surface_3<GC::Bezier_curve<Space>> swept(hook, Vector_3(0, 0, 1));
  std::cout << "11. " << GC::bezier_patch(swept) << '\n';
  typedef GC::Rational_bspline_curve<Space> Spline;
  const GC::Extrusion_surface_3<Spline> swept_spline(Spline(GC::Bspline_curve<Space>(hook)), Vector_3(0, 1, 0));
  std::cout << "    " << *GC::bspline_surface(swept_spline).polynomial() << '\n';
  const GC::Sweep_defects<FT> defects = GC::sweep_defects(swept);
  for (const GC::Sweep_defect<FT>& d : defects.points) std::cout << "   normal zero at " << d.begin << '\n';

  // 12. Hagen's next points: how the derivatives are connected for the scalars C_0, C_1, C_2, in
  //     degree 3
  const GC::Alternative_parameters<FT> scalars{5, 7, GC::g3_c2<FT>(3, 1, 5)};
  const GC::Connection_coefficients<FT> k = GC::connection_coefficients<FT>(3, 1, scalars);
  std::cout << "12. beta " << k.beta1 << ' ' << k.beta2 << ", mu " << k.mu << ", delta " << k.delta << "; "
            << GC::connection_beta2<FT>(3, 1, 5) << "; " << GC::reflection<Plane>(Point(1, 1), Point(0, 3)) << '\n';
  //! [tasks]
  return 0;
}
