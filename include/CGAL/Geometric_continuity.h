// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_H

/// \file Geometric_continuity.h
/// Everything but input and output and what needs Boost.Odeint (construction/curve_from_curvatures.h).

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/algebra/Bell_polynomials.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Bspline_function.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/Enclosure.h>
#include <CGAL/Geometric_continuity/algebra/Knot_vector.h>
#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/algebra/blending_functions.h>
#include <CGAL/Geometric_continuity/algebra/convex_weights.h>
#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/algebra/isolate_roots.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>

#include <CGAL/Geometric_continuity/local/Coordinate_jet.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/Frenet_frame.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/curvature_batch.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/local/frenet_equations.h>

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/curves/Jet_polynomials.h>
#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Geometric_continuity/curves/bounding_boxes.h>
#include <CGAL/Geometric_continuity/curves/control_polygon.h>
#include <CGAL/Geometric_continuity/curves/cubic_bases.h>
#include <CGAL/Geometric_continuity/curves/end_control_points.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Geometric_continuity/curves/polygon_invariants.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>

#include <CGAL/Geometric_continuity/continuity/Prepared_end.h>
#include <CGAL/Geometric_continuity/continuity/Verdict.h>
#include <CGAL/Geometric_continuity/continuity/chain_continuity.h>
#include <CGAL/Geometric_continuity/continuity/deviation.h>
#include <CGAL/Geometric_continuity/continuity/edge_continuity.h>
#include <CGAL/Geometric_continuity/continuity/join_batch.h>
#include <CGAL/Geometric_continuity/continuity/join_continuity.h>
#include <CGAL/Geometric_continuity/continuity/join_predicates.h>
#include <CGAL/Geometric_continuity/continuity/knot_continuity.h>
#include <CGAL/Geometric_continuity/continuity/order_within.h>
#include <CGAL/Geometric_continuity/continuity/polygon_tests.h>
#include <CGAL/Geometric_continuity/continuity/spline_edge_continuity.h>

#include <CGAL/Geometric_continuity/construction/Quintic_ends.h>
#include <CGAL/Geometric_continuity/construction/Septic_ends.h>
#include <CGAL/Geometric_continuity/construction/alternatives.h>
#include <CGAL/Geometric_continuity/construction/blend.h>
#include <CGAL/Geometric_continuity/construction/blend_batch.h>
#include <CGAL/Geometric_continuity/construction/extend.h>
#include <CGAL/Geometric_continuity/construction/extend_curves.h>
#include <CGAL/Geometric_continuity/construction/midpoint_construction.h>
#include <CGAL/Geometric_continuity/construction/piecewise_cubics.h>
#include <CGAL/Geometric_continuity/construction/quintic_strategies.h>
#include <CGAL/Geometric_continuity/construction/representable_blend.h>
#include <CGAL/Geometric_continuity/construction/septic_strategies.h>

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Extrusion_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/G1_ribbon.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_flatness.h>
#include <CGAL/Geometric_continuity/surfaces/Revolution_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/Tessellation.h>
#include <CGAL/Geometric_continuity/surfaces/bspline_edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/connect_g1.h>
#include <CGAL/Geometric_continuity/surfaces/edge_predicates.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Geometric_continuity/surfaces/face_graph.h>
#include <CGAL/Geometric_continuity/surfaces/knot_line_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/near_edges.h>
#include <CGAL/Geometric_continuity/surfaces/patch_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/patch_order_within.h>
#include <CGAL/Geometric_continuity/surfaces/sweep_defects.h>
#include <CGAL/Geometric_continuity/surfaces/swept_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/tessellate.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_H
