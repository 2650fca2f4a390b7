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
  friend std::ostream& operator<<(std::ostream& os, No_result) { return os; }
};

// Members that curves of other packages have: the first error of the compiler is the sentence that
// tells the call.
struct Other_members {
#define CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(name, sentence)                                                            \
  template <class... Given> No_result name(const Given&...) const {                                                    \
    static_assert(never<Given...>, sentence);                                                                          \
    return {};                                                                                                         \
  }
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(point, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(evaluate, "c(u) is the point at the parameter u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(curvature, "the curvature is a function: curvature(c, u)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(torsion, "the torsion is a function: torsion(c, u)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(continuity_at, "knot_continuity(spline, u).g_order is the order at a knot")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(source, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(target, "a curve ends at c(c.domain().second)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(elevate_degree, "elevate() raises the degree by one, elevate(times) by more")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(number_of_control_points, "number_of_points() is the number of control points")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(tangent, "to_vector<Traits>(c.jet(u, 1)[1]) is the first derivative at u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(unit_tangent, "frenet_frame(c.jet(u, 2)) has the tangent and the normal at u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(normal, "frenet_frame(c.jet(u, 2)) has the tangent and the normal at u")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(start_point, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(end_point, "a curve ends at c(c.domain().second)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(first_point, "a curve starts at c(c.domain().first)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(last_point, "a curve ends at c(c.domain().second)")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(is_closed, "continuity(c, c) decides how a curve closes")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(insert_knot, "insert(u) of a spline inserts a knot, split(u) cuts a curve")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(to_bezier, "bezier_pieces() of a spline are its Bezier curves")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(bezier_segments, "bezier_pieces() of a spline are its Bezier curves")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(parameter_range, "c.domain() are the first and the last parameter")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(multiplicity, "knots().multiplicity(u) is the multiplicity of a knot")
#undef CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_MEMBERS_H
