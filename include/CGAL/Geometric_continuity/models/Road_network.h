// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_ROAD_NETWORK_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_ROAD_NETWORK_H

#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/models/internal/Road_decider.h>
#include <CGAL/Geometric_continuity/models/internal/Road_records.h>

#include <type_traits>

/// \file Road_network.h
/// Roads as ASAM OpenDRIVE describes them: a reference line in the plane, profiles along it, lanes
/// beside it, and links; and `road_joins()`, which decides all places where one piece passes into
/// the next one.
///
/// All numbers are exact. What is rational is decided in rational numbers: profiles, widths and
/// borders of lanes. Points in the plane need sines and integrals of Fresnel, and are enclosed.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlignments
/// Decides all joins of a network, in the order of the roads and then of the junctions. `visitor`
/// is called with a `Road_plan_join`, `Road_length_check`, `Road_profile_join`,
/// `Road_section_join`, `Road_link_join`, `Road_lane_join` or `Road_remark` for each, and with a
/// `Road_border_join` if it can be.
///
/// - A *plan join* has the gap of two pieces, the angle of their headings and the jump of their
///   curvatures.
/// - *Profiles* and the borders of *lanes across sections* are rational, and so are their jumps.
/// - Roads that are *linked*, or meet in a junction, are compared by lanes: the left border of a
///   lane with the left one of the lane into which it passes, the right one with the right one; of
///   several lanes that pass into one, or one into several, those at the rims. A border is the
///   point \f$ (x - t \cos\varphi \sin h, y + t \cos\varphi \cos h, z + t \sin\varphi) \f$ with the
///   heading \f$ h \f$, the superelevation \f$ \varphi \f$ and the elevation \f$ z \f$.
///
/// The tolerance of gaps is also that of heights, widths and lengths; that of kinks also that of
/// slopes and of the superelevation. Each link is decided once, whoever names it. Linear in the
/// number of records, up to sorting.
///
/// `with_borders` asks for a `Road_border_join`, besides, wherever a border of a lane may have a
/// kink or a jump of its curvature: at plan joins, where a profile across the road changes its
/// record, and where lanes pass into others. With the curvature \f$ k \f$ of the reference line and
/// the offset \f$ t \f$ of the border, \f$ 1 - k t \leq 0 \f$ there is a fault: the lane folds. A
/// superelevation is not taken into account.
template <class Visitor>
void road_joins(const Road_network& network, const Alignment_tolerance& tolerance, Visitor&& visitor,
                bool with_borders = false) {
  internal::Road_decider<std::remove_reference_t<Visitor>>(network, tolerance, visitor, with_borders)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_ROAD_NETWORK_H
