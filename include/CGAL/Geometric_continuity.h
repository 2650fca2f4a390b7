// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_H

/// \file Geometric_continuity.h
/// Everything but edges of CAD models (cad/cad_edge_continuity.h, ...), what needs Boost.Odeint
/// (curves/curve_from_curvatures.h), and input and output other than in the format .g2.

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>

#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>

#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Geometric_continuity/joins/Visual_join.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/joins/path_continuity.h>

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/cut_back.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h>

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/blends/clothoid_blend.h>
#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/swept_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <CGAL/Geometric_continuity/surface_blends/match.h>
#include <CGAL/Geometric_continuity/surface_blends/representable_blend_surfaces.h>

#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>

#include <CGAL/Geometric_continuity/repairs/align_handles.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>

#include <CGAL/Geometric_continuity/models/Road_network.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/models/round_edges.h>
#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>

#include <CGAL/Geometric_continuity/IO/g2.h>

#include <CGAL/Geometric_continuity/internal/other_names.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_H
