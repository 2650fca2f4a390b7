// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_MEMBERS_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_MEMBERS_H

#include <iosfwd>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class...> constexpr bool never = false;

// The result of a function that does not exist: it fits everywhere, so that there is one error.
struct No_result {
  template <class T> operator T() const;
  template <class T> bool operator==(const T&) const;
  template <class T> bool operator!=(const T&) const;
  template <class T> bool operator<(const T&) const;
  template <class T> bool operator>(const T&) const;
  template <class T> bool operator<=(const T&) const;
  template <class T> bool operator>=(const T&) const;
  friend std::ostream& operator<<(std::ostream& os, No_result) { return os; }
};

// Members that other packages have: the first error of the compiler is the sentence that tells the
// call.
#define CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(name, sentence)                                                            \
  template <class... Given> CGAL::Geometric_continuity::internal::No_result name(const Given&...) const {              \
    static_assert(CGAL::Geometric_continuity::internal::never<Given...>, sentence);                                    \
    return {};                                                                                                         \
  }

// Calls that people guess as members of a curve and as functions of it.
#define CGAL_GEOMETRIC_CONTINUITY_OTHER_CALLS(NO_CALL)                                                                 \
  NO_CALL(point, "c(u) is the point at the parameter u, s(u, v) that of a surface")                                    \
  NO_CALL(derivatives, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE)                                                       \
  NO_CALL(tangent, "to_vector<Traits>(c.jet(u, 1)[1]) is the first derivative at u")                                   \
  NO_CALL(unit_tangent, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)                                                           \
  NO_CALL(principal_normal, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)                                                       \
  NO_CALL(binormal, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)                                                               \
  NO_CALL(frenet, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)                                                                 \
  NO_CALL(max_curvature, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)                                                      \
  NO_CALL(length, CGAL_GEOMETRIC_CONTINUITY_ASK_LENGTH)                                                                \
  NO_CALL(arc_length, CGAL_GEOMETRIC_CONTINUITY_ASK_LENGTH)                                                            \
  NO_CALL(reversed, "c.reverse() is the curve in the opposite direction")                                              \
  NO_CALL(subdivide, CGAL_GEOMETRIC_CONTINUITY_ASK_SPLIT)                                                              \
  NO_CALL(trim, CGAL_GEOMETRIC_CONTINUITY_ASK_SPLIT)                                                                   \
  NO_CALL(split, CGAL_GEOMETRIC_CONTINUITY_ASK_SPLIT)                                                                  \
  NO_CALL(elevate_degree, CGAL_GEOMETRIC_CONTINUITY_ASK_ELEVATE)                                                       \
  NO_CALL(degree_elevate, CGAL_GEOMETRIC_CONTINUITY_ASK_ELEVATE)                                                       \
  NO_CALL(raise_degree, CGAL_GEOMETRIC_CONTINUITY_ASK_ELEVATE)                                                         \
  NO_CALL(insert_knot, "c.insert(u) of a spline inserts a knot, c.split(u) cuts a Bezier curve")                       \
  NO_CALL(remove_knot, "c.remove(u) of a spline removes a knot, if the curve does not need it")                        \
  NO_CALL(to_bezier, "c.bezier_pieces() of a spline are its Bezier curves")                                            \
  NO_CALL(bezier_segments, "c.bezier_pieces() of a spline are its Bezier curves")                                      \
  NO_CALL(decompose, "c.bezier_pieces() of a spline are its Bezier curves")                                            \
  NO_CALL(to_bspline, CGAL_GEOMETRIC_CONTINUITY_ASK_CONVERSION)                                                        \
  NO_CALL(to_nurbs, CGAL_GEOMETRIC_CONTINUITY_ASK_CONVERSION)                                                          \
  NO_CALL(to_rational, CGAL_GEOMETRIC_CONTINUITY_ASK_CONVERSION)                                                       \
  NO_CALL(bbox, CGAL_GEOMETRIC_CONTINUITY_ASK_BOX)                                                                     \
  NO_CALL(bounding_box, CGAL_GEOMETRIC_CONTINUITY_ASK_BOX)                                                             \
  NO_CALL(intersect, CGAL_GEOMETRIC_CONTINUITY_ASK_INTERSECTIONS)                                                      \
  NO_CALL(intersections, CGAL_GEOMETRIC_CONTINUITY_ASK_INTERSECTIONS)                                                  \
  NO_CALL(offset, CGAL_GEOMETRIC_CONTINUITY_ASK_OFFSET)                                                                \
  NO_CALL(offset_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_OFFSET)                                                          \
  NO_CALL(closest_point, CGAL_GEOMETRIC_CONTINUITY_ASK_NEAREST)                                                        \
  NO_CALL(nearest_point, CGAL_GEOMETRIC_CONTINUITY_ASK_NEAREST)                                                        \
  NO_CALL(project_point, CGAL_GEOMETRIC_CONTINUITY_ASK_NEAREST)                                                        \
  NO_CALL(sample, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)                                                              \
  NO_CALL(polyline, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)                                                            \
  NO_CALL(to_polyline, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
#define CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE                                                                       \
  "to_vector<Traits>(c.jet(u, k)[k]) is the derivative of order k at u, s.partial(u, v, i, j) that of a surface; "     \
  "c.derivative() is the curve of the first derivatives"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME                                                                            \
  "frenet_frame(c.jet(u, 3)) is the frame of a curve in space, frenet_frame(c.jet(u, 2)) in the plane: "               \
  "an optional with ->vector(1), the tangent, ->vector(2), the normal, ->vector(3), the binormal"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE                                                                        \
  "curvature(c, u) is the curvature at one parameter, without its sign, signed_curvature(c.jet(u, 2)) that in the "    \
  "plane; curvature_extrema(c) encloses the extreme curvatures of a curve; curvature_excess(c, bound) finds where it " \
  "exceeds a bound"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_LENGTH                                                                           \
  "only a Clothoid_segment has a length(); chord_polyline(c, tolerance, out) writes points of any curve, whose "       \
  "distances approximate its length"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_SPLIT                                                                            \
  "c.split(u) cuts a Bezier curve; c.insert(u).bezier_pieces() are the Bezier curves of a spline that is cut at u, "   \
  "and Bspline_curve<Traits>(first, last) joins those between two iterators"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_ELEVATE "c.elevate() raises the degree by one, c.elevate(times) by more"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_CONVERSION                                                                       \
  "Bspline_curve<Traits>(c) and Rational_bspline_curve<Traits>(c) convert a Bezier curve, "                            \
  "Bspline_curve<Traits>(first, last) Bezier curves that meet"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_BOX                                                                              \
  "a Bezier curve and a patch have bbox() and bounding_box(); bounding_boxes(c, k, handle, out) writes boxes of the "  \
  "parts of any curve"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_INTERSECTIONS                                                                    \
  "curves are not intersected here: chord_polyline(c, tolerance, out) writes points for other packages, and "          \
  "Arr_Bezier_curve_traits_2 of CGAL takes the control points of Bezier curves"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_OFFSET                                                                           \
  "curves have no offsets here: chord_polyline(c, tolerance, out) writes points for other packages, and "              \
  "curvature_excess(c, 1 / distance) finds where an offset would have cusps"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_NEAREST                                                                          \
  "nearest points are not computed here: chord_polyline(c, tolerance, out) writes points for an AABB_tree of CGAL"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE                                                                         \
  "chord_polyline(c, tolerance, out) writes points whose chords are within a tolerance, uniform_polyline(c, n, out) "  \
  "points at n + 1 parameters"

struct Other_members {
  CGAL_GEOMETRIC_CONTINUITY_OTHER_CALLS(CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER)

  // Curves have derivative() without arguments, and this with some.
  template <class Number, class... Given> No_result derivative(const Number&, const Given&...) const {
    static_assert(never<Number, Given...>, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE);
    return {};
  }

  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(operator[],
                                      "control_points() are the control points, c(u) is a point of the curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(evaluate, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(value, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(position, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(eval, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(at, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(Value, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(D0, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(D1, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(D2, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(DN, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(curvature, "the curvature is a function: curvature(c, u)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(signed_curvature,
                                      "the curvature in the plane, with its sign, is signed_curvature(c.jet(u, 2))")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(torsion, "the torsion is a function: torsion(c, u)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(frenet_frame, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(normal, "frenet_frame(c.jet(u, 2)) has the tangent and the normal at u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(continuity, "the continuity of two curves is a function: continuity(a, b)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(continuity_at, "knot_continuity(spline, u).g_order is the order at a knot")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(blend, "a blend is made by a function: blend(a, b)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(source, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(target, "a curve ends at c(c.domain().second)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(start, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(start_point, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(end_point, "a curve ends at c(c.domain().second)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(first_point, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(last_point, "a curve ends at c(c.domain().second)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(start_tangent, "to_vector<Traits>(c.start_jet(1)[1]) is the first derivative at "
                                                     "the start, to_vector<Traits>(c.end_jet(1)[1]) at the end")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(end_tangent, "to_vector<Traits>(c.start_jet(1)[1]) is the first derivative at "
                                                   "the start, to_vector<Traits>(c.end_jet(1)[1]) at the end")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_closed, "continuity(c, c) decides how a curve closes")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(parameter_range, "c.domain() are the first and the last parameter")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(parameter_domain, "c.domain() are the first and the last parameter")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(first_parameter, "c.domain() are the first and the last parameter")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(last_parameter, "c.domain() are the first and the last parameter")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(set_domain, "c.with_domain(a, b) is a Bezier curve on another domain")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(reparametrize, "c.with_domain(a, b) is a Bezier curve on another domain")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(number_of_control_points, "number_of_points() is the number of control points")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(size, "number_of_points() is the number of control points")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(points, "control_points() are the control points, c(u) is a point of the curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(control_polygon, "control_points() are the control points")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(order, "degree() + 1 is the order of a spline, continuity(a, b).g_order that of "
                                             "the continuity of two curves")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(knot_vector, "knots() of a spline is its Knot_vector")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(multiplicity, "knots().multiplicity(u) is the multiplicity of a knot")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(tessellate, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(frame, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(project, CGAL_GEOMETRIC_CONTINUITY_ASK_NEAREST)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(segment, CGAL_GEOMETRIC_CONTINUITY_ASK_SPLIT)
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_G2, "is_g2_join(a, b) decides if two curves are G2 at their join")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_g2, "is_g2_join(a, b) decides if two curves are G2 at their join")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(extend, "extend(c, Frenet_order::curvature, {beta}) is the next segment of a "
                                              "curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(weights, "a Rational_bezier_curve and a Rational_bspline_curve have weights()")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(number_of_knots, "knots().size() is the number of knots of a spline")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(translate, "transform(map) takes an Aff_transformation_2 or _3 of CGAL")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(scale, "transform(map) takes an Aff_transformation_2 or _3 of CGAL")
};

// It depends on the surface, so that a surface of surfaces has no base twice.
template <class Surface> struct Other_surface_members {
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(point, "s(u, v) is the point at the parameters u and v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(evaluate, "s(u, v) is the point at the parameters u and v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(value, "s(u, v) is the point at the parameters u and v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(Value, "s(u, v) is the point at the parameters u and v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(derivative, "s.partial(u, v, i, j) is the derivative of order i in u and j in v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(derivatives, "s.partial(u, v, i, j) is the derivative of order i in u and j in v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(curvature, "surfaces have no function for curvatures here: s.partial(u, v, i, j) "
                                                 "is a derivative, s.normal(u, v) the normal")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(gaussian_curvature,
                                      "surfaces have no function for curvatures here: s.partial(u, v, i, j) is a "
                                      "derivative, s.normal(u, v) the normal")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(control_points, "s.control_point(i, j) is a control point, and begin() and end() "
                                                      "lead from the first one to the last")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(control_net, "s.control_point(i, j) is a control point, and begin() and end() "
                                                   "lead from the first one to the last")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(edge, "boundary_curve(s, Patch_edge::u0) is an edge as a curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(boundary, "boundary_curve(s, Patch_edge::u0) is an edge as a curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(boundary_curve, "boundary_curve(s, Patch_edge::u0) is an edge as a curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(split, "s.split_u(u) and s.split_v(v) cut a surface")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(iso_curve, "the edge u1 of s.split_u(u).first is the curve of a constant u: "
                                                 "boundary_curve(s.split_u(u).first, Patch_edge::u1)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(tessellate, "tessellate(s, Chord_tolerance{0.01}) has triangles near a surface")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(number_of_control_points, "s.number_of_points_u() and s.number_of_points_v() are "
                                                                "the numbers of rows and of columns of control points")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(degree, "s.degree_u() and s.degree_v() are the degrees of a surface")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(knots, "s.knots_u() and s.knots_v() are the knots of a B-spline surface")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(transpose, "s.swap_parameters() exchanges u and v")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(to_bezier, "s.bezier_patches() are the patches of a B-spline surface")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(continuity, "the continuity along an edge is a function: edge_continuity(a, b)")
};

// Members that the orders of a join, of an edge or of a chain do not have.
#define CGAL_GEOMETRIC_CONTINUITY_NO_ORDERS(sentence)                                                                  \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(order, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(geometric, sentence)                                                             \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(geometric_continuity, sentence)                                                  \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(G, sentence)                                                                     \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(g, sentence)                                                                     \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(geometric_order, sentence)                                                       \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(parametric_order, sentence)                                                      \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(has_order, sentence)                                                             \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_smooth, sentence)                                                             \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_continuous, sentence)                                                         \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_G, sentence)                                                                  \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_g, sentence)                                                                  \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_G1, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_g1, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_G2, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_g2, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_G3, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_g3, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_C, sentence)                                                                  \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_C1, sentence)                                                                 \
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_C2, sentence)

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_MEMBERS_H
