// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_H

/// \file Geometric_continuity.h
/// Everything but input and output, edges of CAD models (Edge_enclosure.h, ...) and what needs Boost.Odeint (curves/curve_from_curvatures.h).

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Quarter_turns.h>
#include <CGAL/Geometric_continuity/numbers/Verdict.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/has_short_parts.h>
#include <CGAL/Geometric_continuity/numbers/rational_square_root.h>
#include <CGAL/Geometric_continuity/numbers/units.h>

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/algebra/Bell_polynomials.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Power_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Sign_set.h>
#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/algebra/blending_functions.h>
#include <CGAL/Geometric_continuity/algebra/convex_weights.h>
#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/algebra/isolate_roots.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>

#include <CGAL/Geometric_continuity/local/Coordinate_jet.h>
#include <CGAL/Geometric_continuity/local/Curve_end_jets.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/Frenet_frame.h>
#include <CGAL/Geometric_continuity/local/Homogeneous_traits.h>
#include <CGAL/Geometric_continuity/local/Isometry.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/local/curvature_batch.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/local/end_jet.h>
#include <CGAL/Geometric_continuity/local/frenet_equations.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>
#include <CGAL/Geometric_continuity/local/homogeneous_surface_jets.h>

#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/bspline_evaluate.h>
#include <CGAL/Geometric_continuity/splines/bspline_knots.h>
#include <CGAL/Geometric_continuity/splines/bspline_product.h>

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bezier_polygon.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_polygon.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_polygon.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/curves/Elliptical_arc.h>
#include <CGAL/Geometric_continuity/curves/Jet_polynomials.h>
#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/curves/Rational_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Geometric_continuity/curves/bounding_boxes.h>
#include <CGAL/Geometric_continuity/curves/control_polygon.h>
#include <CGAL/Geometric_continuity/curves/cubic_bases.h>
#include <CGAL/Geometric_continuity/curves/curvature_extrema.h>
#include <CGAL/Geometric_continuity/curves/end_control_points.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/curves/piecewise_cubics.h>
#include <CGAL/Geometric_continuity/curves/polygon_invariants.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>

#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/joins/Join_grade.h>
#include <CGAL/Geometric_continuity/joins/Kink_bound.h>
#include <CGAL/Geometric_continuity/joins/Kink_size.h>
#include <CGAL/Geometric_continuity/joins/Prepared_end.h>
#include <CGAL/Geometric_continuity/joins/Variable_join.h>
#include <CGAL/Geometric_continuity/joins/Variation_region.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/failing_joins.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/joins/knot_continuity.h>
#include <CGAL/Geometric_continuity/joins/largest_kink.h>
#include <CGAL/Geometric_continuity/joins/order_within.h>
#include <CGAL/Geometric_continuity/joins/path_continuity.h>
#include <CGAL/Geometric_continuity/joins/path_grade.h>
#include <CGAL/Geometric_continuity/joins/polygon_tests.h>

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/automatic_shape.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_batch.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>

#include <CGAL/Geometric_continuity/extensions/Grid_vector.h>
#include <CGAL/Geometric_continuity/extensions/align_handles.h>
#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/extensions/close.h>
#include <CGAL/Geometric_continuity/extensions/connection_coefficients.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/extensions/extend_toward.h>
#include <CGAL/Geometric_continuity/extensions/harmonise_handles.h>
#include <CGAL/Geometric_continuity/extensions/midpoint_construction.h>
#include <CGAL/Geometric_continuity/extensions/round_corner.h>
#include <CGAL/Geometric_continuity/extensions/round_corners.h>

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Extrusion_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Revolution_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/Surface_grid.h>
#include <CGAL/Geometric_continuity/surfaces/Swept_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/boundary_curve.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Geometric_continuity/surfaces/swept_patches.h>

#include <CGAL/Geometric_continuity/edges/Edge_conditions.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/G1_ribbon.h>
#include <CGAL/Geometric_continuity/edges/Spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/common_edges.h>
#include <CGAL/Geometric_continuity/edges/connect_g1.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/edge_order_within.h>
#include <CGAL/Geometric_continuity/edges/edge_predicates.h>
#include <CGAL/Geometric_continuity/edges/knot_line_continuity.h>
#include <CGAL/Geometric_continuity/edges/sweep_defects.h>
#include <CGAL/Geometric_continuity/edges/swept_continuity.h>

#include <CGAL/Geometric_continuity/models/Model_edge.h>
#include <CGAL/Geometric_continuity/models/Patch_flatness.h>
#include <CGAL/Geometric_continuity/models/Tessellation.h>
#include <CGAL/Geometric_continuity/models/face_graph.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/models/near_edges.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_H
