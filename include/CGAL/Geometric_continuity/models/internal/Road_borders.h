// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_BORDERS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_BORDERS_H

#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>
#include <CGAL/Geometric_continuity/models/internal/Road_records.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <optional>

/// \file Road_borders.h
/// The border of a lane is a curve of its own in the plane. At the distance \f$ t \f$ to the left
/// of a reference line with tangent T, normal N, curvature \f$ k \f$ and its rate \f$ k' \f$ it has
/// \f[ P' = (1 - k t) T + t' N, \quad P'' = (-k' t - 2 k t') T + (k (1 - k t) + t'') N. \f]

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A place of a reference line.
struct Reference_place {
  Alignment_end end;
  std::optional<Road_number> rate; // of the curvature; empty where it is not known
};

// The rate of the curvature of a cubic of a parameter p, where its speed is not zero: with
// q = u'^2 + v'^2 and c = u' v'' - v' u'' the curvature is c q^(-3/2), and its rate
// c' / q^2 - 3 c q' / (2 q^3), which is rational.
inline std::optional<Road_number> cubic_rate(const Road_geometry& g, Road_end end) {
  const std::vector<Road_number>& p = g.parameters;
  const bool is_graph = g.shape == Road_shape::poly3;
  if (is_graph && end == Road_end::end) return std::nullopt; // its parameter is enclosed
  const std::array<Road_number, 4> u = is_graph ? std::array<Road_number, 4>{0, 1, 0, 0}
                                                : std::array<Road_number, 4>{p[0], p[1], p[2], p[3]},
                                   v = is_graph ? std::array<Road_number, 4>{p[0], p[1], p[2], p[3]}
                                                : std::array<Road_number, 4>{p[4], p[5], p[6], p[7]};
  const Road_number t = end == Road_end::start                        ? Road_number(0)
                        : g.range == Road_parameter_range::arc_length ? g.length
                                                                      : Road_number(1);
  const auto derivatives = [&t](const std::array<Road_number, 4>& c) {
    return std::array<Road_number, 3>{Road_number(c[1] + (2 * c[2] + 3 * c[3] * t) * t),
                                      Road_number(2 * c[2] + 6 * c[3] * t), Road_number(6 * c[3])};
  };
  const std::array<Road_number, 3> du = derivatives(u), dv = derivatives(v);
  const Road_number q = Road_number(du[0] * du[0] + dv[0] * dv[0]), c = Road_number(du[0] * dv[1] - dv[0] * du[1]),
                    dq = Road_number(2 * (du[0] * du[1] + dv[0] * dv[1])),
                    dc = Road_number(du[0] * dv[2] - dv[0] * du[2]);
  if (CGAL::is_zero(q)) return std::nullopt;
  return Road_number((dc - 3 * c * dq / (2 * q)) / (q * q));
}

// The rate of the curvature at an end of a piece.
inline std::optional<Road_number> curvature_rate(const Road_geometry& g, Road_end end) {
  if (is_polynomial(g)) return cubic_rate(g, end);
  if (g.shape != Road_shape::spiral || CGAL::is_zero(g.length)) return Road_number(0);
  return Road_number((g.parameters[1] - g.parameters[0]) / g.length);
}

inline Reference_place reference_end(const Road_geometry& g, Road_end end) {
  return {alignment_end(g, end), curvature_rate(g, end)};
}

// A place on a piece at a length from its start. Inside of a polynomial only that is known which
// does not depend on it.
inline Reference_place reference_inside(const Road_geometry& g, const Road_number& length) {
  if (CGAL::is_zero(length)) return reference_end(g, Road_end::start);
  if (!(length < g.length)) return reference_end(g, Road_end::end);
  if (is_polynomial(g)) return {Alignment_end{Enclosed_point(), Heading(), std::nullopt}, std::nullopt};
  return {clothoid_segment(g, length).end(), curvature_rate(g, Road_end::start)};
}

// A border at a place, as an end of its own. Empty where it folds, and where it needs the curvature
// of the reference line, which is not known or a root.
struct Border_end {
  std::optional<Alignment_end> end;
  bool folds = false; // it does not run forwards: 1 - k t is not positive
};

inline Border_end border_end(const Reference_place& place, const Road_jet& t) {
  const Alignment_end& line = place.end;
  const bool is_parallel = CGAL::is_zero(t.slope) && CGAL::is_zero(t.second);
  if (!line.curvature) return {};
  if (is_parallel && CGAL::is_zero(t.value)) return {line};
  const Enclosed_point point = line.point.moved(line.heading, Road_number(0), t.value);
  if (!line.curvature->rational() || !place.rate) {
    if (!is_parallel) return {};
    // it has the same direction, and a curvature that is no root of a rational number
    const Enclosure k = line.curvature->enclosure();
    if (!std::isfinite(k.lower) || !std::isfinite(k.upper)) return {};
    const Road_number x = Road_number(1 - Road_number(k.lower) * t.value),
                      y = Road_number(1 - Road_number(k.upper) * t.value);
    if (!CGAL::is_positive(x) && !CGAL::is_positive(y)) return {std::nullopt, true};
    if (!CGAL::is_positive(x) || !CGAL::is_positive(y)) return {};
    return {Alignment_end{point, line.heading, std::nullopt}};
  }
  const Road_number &k = *line.curvature->rational(), along = Road_number(1 - k * t.value);
  if (!CGAL::is_positive(along)) return {std::nullopt, true};
  const Road_number second_along = Road_number(-*place.rate * t.value - 2 * k * t.slope),
                    second_across = Road_number(k * along + t.second),
                    cross = Road_number(along * second_across - t.slope * second_along),
                    speed = Road_number(along * along + t.slope * t.slope); // its square
  const End_curvature curvature =
      CGAL::is_zero(t.slope)
          ? End_curvature(Road_number(second_across / (along * along)))
          : End_curvature(static_cast<int>(CGAL::sign(cross)), Road_number(cross * cross / (speed * speed * speed)));
  return {Alignment_end{point, line.heading.turned(along, t.slope), curvature}};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_BORDERS_H
