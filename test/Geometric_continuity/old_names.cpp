// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Names of the release before, and of other packages, compile with a warning and mean what they
// meant.

#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
#include <CGAL/Geometric_continuity/IO/figures/svg_surfaces.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/Bezier_polygon.h>
#include <CGAL/Geometric_continuity/joins/Join_certificate.h>
#include <CGAL/Geometric_continuity/joins/Join_deviation.h>
#include <CGAL/Geometric_continuity/joins/Join_grade.h>
#include <CGAL/Geometric_continuity/joins/Kink_bound.h>
#include <CGAL/Geometric_continuity/joins/failing_joins.h>
#include <CGAL/Geometric_continuity/models/Tessellation.h>
#include <CGAL/Geometric_continuity/models/face_graph.h>
#include <CGAL/Geometric_continuity/models/near_edges.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_sides.h>
#include <CGAL/Geometric_continuity/surfaces/boundary_curve.h>
#include <CGAL/Geometric_continuity/surfaces/trim_back.h>
#include <CGAL/Simple_cartesian.h>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Plane;
typedef GC::Bezier_curve<Plane> Curve;
typedef GC::Bezier_patch<GC::Traits_3<CGAL::Simple_cartesian<double>>> Patch;

std::optional<GC::Join_grade> grade(const Curve& a, const Curve& b, const GC::Kink_bound& bound) {
  return GC::join_grade(a, b, bound);
}
GC::Chain_analysis<Curve> chain() { return GC::Chain_analysis<Curve>(2); }
GC::Enclosure root(const GC::Text_number& x) { return GC::root_enclosure(x.value()); }
Patch strip(const Patch& p) { return GC::trim_back(p, GC::Patch_edge::v1, 0.5); }
std::vector<GC::Near_edges> near(const std::vector<Patch>& model, const GC::Edge_tolerance& tolerance) {
  return GC::near_edges(model, GC::model_continuity(model), tolerance);
}
GC::Bezier_curve<Patch::Traits> edge(const Patch& p) { return GC::boundary_curve(p, GC::Patch_edge::u0); }
std::vector<std::size_t> failing(const std::vector<Curve>& chain) { return GC::failing_joins(chain, GC::is_g2_join); }
GC::Svg_figure picture(const Curve& c) { return GC::Svg_figure().add(GC::Svg_panel().add(c)); }

// of other packages
GC::B_spline_curve<Plane> spline(const GC::NURBS_curve<Plane>&);
GC::Bezier_surface<Patch::Traits> same(const Patch& p) { return p; }
GC::Bezier_curve_2<Plane::Kernel> same(const Curve& c) { return c; }
GC::Bezier_patch_3<Patch::Traits::Kernel> same_patch(const Patch& p) { return p; }
GC::Nurbs_curve_3<Plane::Kernel> nurbs(const GC::Rational_bspline_curve<Patch::Traits>&);
bool smooth(const GC::Bspline_curve<Plane>& c, const Patch& p, const std::vector<Curve>& chain) {
  return GC::is_G2(c) && GC::is_g1(p, p) && GC::is_G3(chain) && GC::chain_joins(c).empty() && GC::continuity(c).empty();
}

std::pair<double, double> ends(const Curve& c, const GC::Bspline_curve<Plane>& s,
                               const GC::Composite_bezier_curve<Plane>& p, const GC::Rational_bezier_curve<Plane>& r) {
  return {c.start_parameter() + s.start_parameter(), p.end_parameter() + r.end_parameter()};
}
bool common(const Patch& p) { return GC::edge_continuity(p, GC::U_MAX, p, GC::Patch_edge::V_MIN).g_order >= 0; }
