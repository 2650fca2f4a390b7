// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_RECORDS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_RECORDS_H

#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/number_utils.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file Road_records.h
/// The types of `Road_network.h`: what a file says of roads, and what is decided about their joins.
/// They stand here because `Road_decider.h` needs them, which `Road_network.h` includes.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlignments
/// The exact numbers of road networks.
using Road_number = Exact_field<double>::type;

/// \ingroup PkgGeometricContinuityAlignments
/// The shape of a piece of a reference line.
enum class Road_shape {
  line,
  arc,        ///< it has one curvature
  spiral,     ///< a clothoid: the curvature is linear in the length
  poly3,      ///< \f$ v = a + b u + c u^2 + d u^3 \f$, as far as its arc length reaches
  param_poly3 ///< \f$ u, v \f$ are cubic polynomials of a parameter
};

/// \ingroup PkgGeometricContinuityAlignments
/// The interval of the parameter of a `param_poly3`.
enum class Road_parameter_range {
  normalized, ///< from 0 to 1
  arc_length, ///< from 0 to the length
  missing     ///< not said: read as `normalized`, and where the other reading differs, that is said
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A piece of a reference line: it starts at \f$ (x, y) \f$ in direction `heading`, in radians
/// counter-clockwise, which is the axis \f$ u \f$ of its shape; \f$ v \f$ points to the left.
struct Road_geometry {
  Road_shape shape = Road_shape::line;
  Road_number s, x, y, heading, length;
  /// of an arc its curvature; of a spiral those of its start and its end; of a polynomial the
  /// coefficients `a`, `b`, `c`, `d`, first those of \f$ u \f$ and then those of \f$ v \f$
  std::vector<Road_number> parameters = {};
  Road_parameter_range range = Road_parameter_range::normalized;
  long long line = 0; ///< where it stands in its file; 0 where that is not known
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A record of a profile: from the length \f$ s \f$ on, the value is
/// \f$ a + b\,u + c\,u^2 + d\,u^3 \f$ with \f$ u \f$ the length since \f$ s \f$.
struct Road_cubic {
  Road_number s; ///< for widths and borders, from the start of the lane section on
  Road_number a, b, c, d;
  long long line = 0; ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A value and its first and second derivative.
struct Road_jet {
  Road_number value = 0, slope = 0, second = 0;
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A lane in a section. Lanes left of the reference line have the numbers 1, 2, ... outwards, those
/// right of it -1, -2, ....
struct Road_lane {
  int id = 0;
  std::string type = {};
  bool is_level = false; ///< it does not take part in the superelevation
  bool has_height = false;
  std::vector<int> predecessors = {}, successors = {}; ///< the lanes that it names
  std::vector<Road_cubic> widths = {}, borders = {};   ///< the widths count, if there are any
  long long line = 0;                                  ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// The lanes of a road from \f$ s \f$ to the start of the next section.
struct Road_section {
  Road_number s;
  std::vector<Road_lane> lanes = {};
  bool is_single_side = false; ///< it says nothing of the side on which it has no lanes
  long long line = 0;          ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// An end of a road.
enum class Road_end { start, end };

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A link names what comes before or after a road.
struct Road_link {
  /// nothing, a road, a junction, or something else
  enum class Target { none, road, junction, other };
  Target target = Target::none;
  std::string id = {};
  std::optional<Road_end> contact = {}; ///< the end of the other road
  std::optional<Road_number> at = {};   ///< a place of the other road in place of an end
  bool is_against = false;              ///< at this place the other road is driven against its direction
  long long line = 0;                   ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A road.
struct Road {
  std::string id = {}, junction = {};
  Road_number length;
  Road_link predecessor = {}, successor = {};
  std::vector<Road_geometry> plan = {};
  std::vector<Road_cubic> elevation = {}, superelevation = {}, lane_offset = {};
  std::vector<Road_section> sections = {};
  /// what gives lanes other heights than elevation and superelevation do, e.g. "crossfall"; empty
  /// where there is nothing
  std::string other_heights = {};
  long long line = 0; ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A connection of a junction: from a road that leads into it to one inside of it, or to one that
/// leads out of a direct junction.
struct Road_connection {
  std::string id = {}, incoming = {}, connecting = {};
  std::optional<Road_end> contact = {};        ///< the end of the connecting road
  std::vector<std::pair<int, int>> lanes = {}; ///< from lanes of the one to lanes of the other
  bool is_direct = false, has_overlap = false; ///< overlapping lanes may change their width
  long long line = 0;                          ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A junction.
struct Road_junction {
  std::string id = {}, type = {};
  std::vector<Road_connection> connections = {};
  long long line = 0; ///< as in `Road_geometry`
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A road network.
struct Road_network {
  std::vector<Road> roads = {};
  std::vector<Road_junction> junctions = {};
};

/// \ingroup PkgGeometricContinuityAlignments
/// Returns whether a piece of a reference line is a polynomial, and no line, arc or spiral.
inline bool is_polynomial(const Road_geometry& g) {
  return g.shape == Road_shape::poly3 || g.shape == Road_shape::param_poly3;
}

/// \ingroup PkgGeometricContinuityAlignments
/// Returns the part of a piece from its start on that has a length. \pre `!is_polynomial(g)`
inline Clothoid_segment clothoid_segment(const Road_geometry& g, const Road_number& length) {
  const bool is_bent = g.shape != Road_shape::line;
  const Road_number start = is_bent ? g.parameters.front() : Road_number(0);
  Road_number end = is_bent ? g.parameters.back() : Road_number(0);
  if (start != end && length != g.length) end = Road_number(start + (end - start) * length / g.length);
  return Clothoid_segment(g.x, g.y, Heading(g.heading), start, end, length);
}

/// \ingroup PkgGeometricContinuityAlignments
/// Returns a piece with the parameter of a `param_poly3` from 0 to 1, or to the length.
/// \pre `is_polynomial(g)`
inline Parametric_cubic parametric_cubic(const Road_geometry& g, bool by_length) {
  const std::vector<Road_number>& p = g.parameters;
  if (g.shape == Road_shape::poly3)
    return Parametric_cubic::graph(g.x, g.y, Heading(g.heading), {p[0], p[1], p[2], p[3]}, g.length);
  return Parametric_cubic(g.x, g.y, Heading(g.heading), {p[0], p[1], p[2], p[3]}, {p[4], p[5], p[6], p[7]},
                          by_length ? g.length : Road_number(1));
}

/// \ingroup PkgGeometricContinuityAlignments
/// Returns an end of a piece of a reference line, with its direction and curvature.
inline Alignment_end alignment_end(const Road_geometry& g, Road_end end) {
  if (is_polynomial(g)) {
    const Parametric_cubic cubic = parametric_cubic(g, g.range == Road_parameter_range::arc_length);
    return end == Road_end::start ? cubic.start() : cubic.end();
  }
  const Clothoid_segment segment = clothoid_segment(g, g.length);
  return end == Road_end::start ? segment.start() : segment.end();
}

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// Two pieces of a reference line that follow each other.
struct Road_plan_join {
  const Road& road;
  const Road_geometry &before, &after;
  Road_number s_error; ///< how far the second one's \f$ s \f$ is from the end of the first
  Alignment_join join; ///< what is decided
  /// the same for the other reading of a range that is `missing`, where its order is another one
  std::optional<Alignment_join> other_reading;
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// The arc length of a `param_poly3` and the length that is declared.
struct Road_length_check {
  const Road& road;
  const Road_geometry& geometry;
  Enclosure error; ///< their distance
  Verdict within;  ///< the tolerance of gaps
  /// the same for the other reading of a range that is `missing`
  std::optional<std::pair<Enclosure, Verdict>> other_reading;
  bool is_near_stop; ///< the speed at an end is so low that its direction may be noise
};

/// \ingroup PkgGeometricContinuityAlignments
/// The profiles of a road and of its lanes.
enum class Road_profile_kind { elevation, superelevation, lane_offset, width, border };

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A place where one record of a profile passes into the next one.
struct Road_profile_join {
  const Road& road;
  const Road_lane* lane; ///< the lane of widths and borders
  Road_profile_kind kind;
  Road_number s; ///< along the road
  long long line;
  Road_jet jump;              ///< how much larger each is after it
  std::array<bool, 3> equal;  ///< value, slope and second derivative, exactly
  std::array<bool, 2> within; ///< value and slope, within the tolerance
  bool is_compensated;        ///< a lane offset where a lane section starts, of which the borders tell
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A lane that passes into one of the next lane section.
struct Road_section_join {
  const Road& road;
  const Road_lane &lane, &to;
  Road_number s;
  std::optional<Road_number> left, right; ///< the jumps of the borders that meet
  bool is_named_back;                     ///< only the second lane names the first
  /// The borders are known; they are not where a lane inside of one of them is missing.
  bool is_known;
  bool equal, within;

  /// Returns the larger jump.
  Road_number jump() const {
    const Road_number l = left ? CGAL::abs(*left) : Road_number(0), r = right ? CGAL::abs(*right) : Road_number(0);
    return l < r ? r : l;
  }
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A place at which roads meet: an end, or a place inside of a road from which another one branches
/// off in a virtual junction.
struct Road_contact {
  const Road* road;
  Road_end end; ///< inside of the road: which of the two pieces there
  std::optional<Road_number> at = {};
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// Two reference lines that are linked. They need not meet: lanes do.
struct Road_link_join {
  Road_contact from, to;
  Alignment_join join;
  Road_number step, grade_jump; ///< the jumps of the elevation and its slope
  bool is_returned;             ///< the other road names this one, or a junction
  bool has_lanes;               ///< lanes of both are linked, by themselves or by a junction
  long long line;
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A lane that passes into one of another road.
struct Road_lane_join {
  Road_contact from, to;
  const Road_lane &lane, &to_lane;
  bool is_in_junction;                ///< a connection of a junction names them
  bool is_named_back;                 ///< only the second lane names the first
  bool has_overlap;                   ///< it belongs to a direct junction, so widths may change
  std::vector<Enclosure> gaps, steps; ///< distances of the borders that meet, the left ones first
  Verdict within;
  std::optional<Verdict> within_height; ///< nothing where a road gives its lanes other heights
  long long line;
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// The border of a lane that passes from one piece into the next one, or into that of another road,
/// seen from above: a curve of its own. Of one road both contacts are inside of it, at one place.
struct Road_border_join {
  Road_contact from, to;
  const Road_lane &lane, &to_lane;
  bool is_left; ///< the side of the first lane, in the direction of its road
  Alignment_join join;
  long long line;
};

/// \ingroup PkgGeometricContinuityAlignments
/// \headerfile Road_network.h <CGAL/Geometric_continuity/models/Road_network.h>
/// A remark tells what is worth a word besides.
struct Road_remark {
  /// The consequence.
  enum class Kind {
    note,        ///< nothing is left undecided
    fault,       ///< something contradicts itself or is not there, so that nothing can be compared
    not_covered, ///< it is not decided
    undecided    ///< a limit of work was reached
  };
  Kind kind;
  const Road* road; ///< null where there is none
  long long line;
  std::string what;   ///< the thing, e.g. "link"
  std::string reason; ///< what is wrong with it
  std::string place;  ///< where it is, e.g. "successor"
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_RECORDS_H
