// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_JOINS_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_JOINS_H

#include "commands/report_inputs.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#include <memory>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

typedef GC::Bezier_curve<Drawing_traits> Plane_curve;

// The grade of the page; an empty one is that of curves without length.
Report_grade report_grade(const std::optional<GC::Visual_class>& grade);

// Returns the grade, the verdict and all measures of the join of two curves in the plane. Throws
// GC::Error `work_limit`.
Report_item measured_join(const Plane_curve& left, const Plane_curve& right, const Report_demand& demand);

// Takes two segments of a path, which may be arcs.
Report_item measured_join(const GC::Svg_segment<Drawing_traits>& left, const GC::Svg_segment<Drawing_traits>& right,
                          const Report_demand& demand);

// The verdict in words; `retracted`: a handle lies on the node, so that the curvature is not known.
const char* report_words(Report_grade grade, bool retracted);

// The curve as links have it.
template <class Curve> Report_curve_link link_of(const Curve& curve) {
  std::ostringstream points, weights, domain;
  bool is_weighted = false;
  for (int i = 0; i <= curve.degree(); ++i) {
    const auto x = curve.coordinates(i);
    for (int k = 0; k < x.dimension(); ++k) GC::write_number(points << (k > 0 ? "," : i > 0 ? ";" : ""), x[k]);
    if constexpr (std::is_same_v<Curve, Exact_curve>) {
      is_weighted = !curve.is_polynomial();
      GC::write_number(weights << (i > 0 ? ";" : ""), curve.weight(i));
    }
  }
  const auto [begin, end] = curve.domain();
  GC::write_number(domain, begin);
  GC::write_number(domain << ';', end);
  return {points.str(), is_weighted ? weights.str() : "", domain.str() == "0;1" ? "" : domain.str()};
}

// The curve as it is drawn.
template <class Curve> std::shared_ptr<const Report_curve> drawn_curve(const Curve& curve, std::size_t group) {
  Report_curve result{{}, {}, group, link_of(curve)};
  for (int i = 0; i <= curve.degree(); ++i) {
    const auto x = curve.coordinates(i);
    for (int k = 0; k < x.dimension(); ++k) result.points.push_back(CGAL::to_double(x[k]));
  }
  return std::make_shared<const Report_curve>(std::move(result));
}

// There is no link to an arc, which becomes a rational curve of degree 4.
std::shared_ptr<const Report_curve> drawn_curve(const GC::Svg_segment<Drawing_traits>& segment, std::size_t group);

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_JOINS_H
