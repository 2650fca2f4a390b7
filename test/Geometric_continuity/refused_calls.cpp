// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls that people guess and that do not compile. For each, the compiler prints one error, with
// the words in the comment above it: check_refused_calls compares them.

#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <iterator>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Plane;
typedef GC::Bezier_curve<Plane> Curve;
typedef GC::Bezier_patch<GC::Traits_3<CGAL::Simple_cartesian<double>>> Patch;

void calls(const Curve& curve, const GC::Bspline_curve<Plane>& spline, const std::vector<Curve>& curves,
           const Patch& patch, const Patch::Point& corner, const std::vector<std::vector<Patch::Point>>& net,
           std::vector<Plane::Point>& points, std::vector<Curve>& out) {
  // is_g2_join(a, b) is true or false
  GC::check_join(curve, curve, 2);
  // edge_continuity(a, b) decides
  GC::continuity(patch, patch);
  // of two surfaces, name the edges
  GC::blend(patch, patch);
  // number_of_segments() is the number
  GC::fit(points, 0.1).size();
  // order_within(a, b, 1e-6) proves
  GC::is_G1(curve, curve, 1e-6);
  // returns the chain, which has begin()
  GC::round_corners(points, 1, std::back_inserter(out));
  // chain_joins(curves) has one Join_continuity
  GC::chain_continuity(curves).operator std::vector<int>();
  // control points are no curve
  GC::deviation(points, points);
  // there is no degree to give
  GC::interpolate(points, 3);
  GC::fit(points);
  GC::fit(points, 3, 0.1);
  // is the next segment
  GC::extend(curve, 2.5);
  GC::extend(spline, 2);
  // is a blend with G2, blend(a, b, Fair_g3()) with G3
  GC::blend(curve, curve, GC::G2);
  GC::blend<3>(curve, curve);
  GC::blend(spline, spline, GC::Fair(), 3);
  // a polyline to a curve
  GC::approximate(spline, 0.01, points.begin());
  // control_points() are the control points
  curve[0];
  // g_order
  GC::continuity(curve, curve).geometric() >= 2;
  // is the order at one parameter
  GC::is_G2(curve, 0.5);
  // is the order of two surfaces along these edges
  GC::is_G1(patch, GC::Patch_edge::u1, patch, GC::Patch_edge::u0);
  // fits a smooth curve
  GC::fit_curve<Plane::Kernel>(points.begin(), points.end(), 0.1);
  // there is no kernel
  GC::interpolate<Plane::Kernel>(points.begin(), points.end(), 3);
  // decides a chain, which is given as a range
  GC::is_G2(curves.begin(), curves.end());
  // joins two curves with G2
  GC::quintic_blend(curve, curve);
  // in radians
  GC::kink_angle_in_degrees(curve, curve);
  // takes two ends
  GC::clothoid_blend(points[0], points[1]);
  // takes an open std::ofstream
  GC::write_g2("curve.g2", curve);
  GC::write_g2(curve, "curve.g2");
  GC::write_g2(curves, std::cout);
  // is the first derivative
  GC::Bezier_curve<Plane>(curve).tangent(0.5);
  // is the frame of a curve
  GC::frenet_frame(curve, 0.5);
  GC::Bspline_curve<Plane>(curve).frenet_frame(0.5);
  // is an open std::ifstream
  GC::read_g2_curves<Plane>("curve.g2");
  GC::read_g2_bsplines<Plane>("curve.g2");
  GC::read_g2_surfaces(std::cin);
  // lists the joins of a chain that fail
  GC::chain_order(curves, true);
  GC::kinks(curves, 10);
  // c(u) is the point
  GC::Bezier_curve<Plane>(curve).point(0.5);
  GC::evaluate(curve, 0.5);
  GC::Bspline_curve<Plane>(curve).at(0.5);
  // is the order at a knot
  GC::Bspline_curve<Plane>(curve).continuity_at(0.5);
  // move handles on a grid
  GC::repair_chain(curves, 1, 0.01);
  // is the highest order to decide
  GC::chain_continuity(curves, 1e-6);
  GC::chain_joins(curves.begin(), curves.end(), 1e-6);
  GC::knot_continuities(GC::Bspline_curve<Plane>(curve), 1e-6);
  // the program reads drawings
  GC::read_svg<Plane>("leaf.svg");
  // of whole curves is not measured
  GC::is_within(curve, curve, 1e-6);
  // are the first and the last parameter
  GC::Bezier_curve<Plane>(curve).parameter_range();
  // decides two surfaces along
  GC::continuity(patch, GC::Patch_edge::u1, patch, GC::Patch_edge::u0);
  // decides all common edges
  GC::Patch_mesh<Plane::Kernel>(curves.begin(), curves.end());
  // decides the joins of a chain
  GC::continuity(curves.begin(), curves.end());
  GC::continuity(curves);
  GC::continuity({curve, curve});
  // takes a range of curves
  GC::chain_joins({curve, curve});
  // name the predicate
  GC::failing_joins(curves, 2);
  // decides within a tolerance
  GC::order_within(curve, curve);
  // a predicate takes two curves
  GC::is_g2_join(curves);
  GC::is_g2_join(curves.begin(), curves.end());
  GC::is_g2_join(curve, curve, 1e-6);
  // decide the join of any two curves
  GC::is_tangent_continuous(spline, spline);
  // a join has several orders
  GC::continuity(curve, curve).is_G(1);
  GC::continuity(curve, curve) >= 2;
  GC::continuity(curve, curve) == 2;
  GC::continuity(curve, curve).geometric_order();
  // is the least G order of all joins
  GC::chain_continuity(curves).is_g2();
  // is the order along an edge
  GC::edge_continuity(patch, patch).order();
  // is the largest order that is proved
  GC::order_within(curve, curve, 1e-6).order();
  // encloses the angle at the join
  GC::deviation(curve, curve).angle();
  // measures the edge of two surfaces
  GC::deviation(patch, patch);
  // is of two Bezier curves
  GC::kink_size(spline, spline);
  // chain_continuity(curves) is of a chain
  GC::order(curves);
  // decides the join of two curves
  GC::is_G<2>(curve, curve);
  // is the derivative of order k at u
  GC::Bezier_curve<Plane>(curve).derivative(0.5);
  GC::Bspline_curve<Plane>(curve).derivative(0.5, 2);
  GC::NURBS<Plane>(spline).derivative(1);
  GC::derivative(curve, 0.5);
  GC::NURBS<Plane>(spline).derivative();
  // c.split(u) cuts a Bezier curve
  GC::NURBS<Plane>(spline).split(0.5);
  GC::Bspline_curve<Plane>(curve).split(0.5);
  // give a spline other knots
  GC::NURBS<Plane>(spline).with_domain(0, 2);
  // s(u, v) is the point
  GC::evaluate(patch, 0.5, 0.5);
  GC::Bezier_patch<Patch::Traits>(patch).evaluate(0.5, 0.5);
  // is the normal of a surface
  GC::normal(patch, 0.5, 0.5);
  // encloses the extreme curvatures
  GC::signed_curvature(curve, 0.5);
  // is the curvature vector at u
  GC::curvature_vector(curve, 0.5);
  // writes boxes of the parts
  GC::Bspline_curve<Plane>(curve).bounding_box();
  GC::NURBS<Plane>(spline).bbox();
  // joins Bezier curves that meet
  GC::Bspline_curve<Plane>(curves).degree();
  // takes the degree, all knots
  GC::Bspline_curve<Plane>({points[0], points[1]}, std::vector<double>());
  // only a Clothoid_segment
  GC::length(curve);
  // curves are not intersected here
  GC::intersect(curve, curve);
  // curves have no offsets here
  GC::offset(curve, 0.5);
  // nearest points are not computed here
  GC::closest_point(curve, points[0]);
  // is the curve in the opposite direction
  GC::reverse(curve);
  // inserts a knot
  GC::insert_knot(spline, 0.5);
  // convert a Bezier curve
  GC::to_bspline(curve);
  // writes points whose chords
  GC::tessellate(curve, 0.01);
  GC::tessellate(spline, 0.01, std::back_inserter(points));
  GC::chord_polyline(curve, 0.01);
  // takes a tolerance, tessellate
  GC::tessellate(patch, 0.01);
  // is an edge as a curve
  GC::edge_curve(patch, GC::Patch_edge::u0);
  GC::Bezier_patch<Patch::Traits>(patch).boundary_curve(GC::Patch_edge::u0);
  // is the derivative of order i
  GC::Bezier_patch<Patch::Traits>(patch).derivative(0.5, 0.5, 1, 0);
  // a control net is a range of rows
  GC::Bezier_patch<Patch::Traits>({corner, corner, corner, corner});
  // takes the degrees before the points
  GC::Bezier_patch<Patch::Traits>(std::vector(4, corner), 1, 1);
  // take the weights in rows
  GC::Rational_bspline_surface<Patch::Traits>(net, spline.knots(), spline.knots());
  // decides if two curves are G2
  GC::G2(curve, curve);
  // takes Bezier curves
  GC::round_corner(spline, spline, 0.5);
  // rounds the corners
  GC::round_polygon(points, 0.5);
  // at given parameters
  GC::interpolate(points, std::vector<double>());
  // there is no traits class to give
  GC::interpolate<Plane>(points);
  // IO/g2.h> returns Bezier curves
  GC::read_g2<Plane>("curve.g2");
  // Svg_panel().add(curve
  GC::write_svg("curve.svg", curve);
}
