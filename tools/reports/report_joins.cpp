// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "reports/report_joins.h"

#include "commands/chains/join_report.h"
#include "commands/drawings/segment_joins.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

Report_grade report_grade(const std::optional<GC::Visual_class>& grade) {
  if (!grade) return Report_grade::undecided;
  switch (*grade) {
  case GC::Visual_class::gap: return Report_grade::gap;
  case GC::Visual_class::corner: return Report_grade::corner;
  case GC::Visual_class::kink: return Report_grade::kink;
  case GC::Visual_class::g1: return Report_grade::g1;
  case GC::Visual_class::g2: return Report_grade::g2;
  }
  return Report_grade::undecided;
}

const char* report_words(Report_grade grade, bool retracted) {
  switch (grade) {
  case Report_grade::gap: return "the ends are apart";
  case Report_grade::kink: return "the tangents differ by a small angle";
  case Report_grade::bend: return "two lines meet at a small angle, and no handle could mend it";
  case Report_grade::rounding: return "the tangents differ by no more than rounding explains";
  case Report_grade::fading:
  case Report_grade::corner: return "the tangents differ";
  case Report_grade::g0: return "the ends meet";
  case Report_grade::undecided: return "not decided";
  case Report_grade::g1: return retracted ? "one tangent, and a handle lies on the node" : "the curvature jumps";
  case Report_grade::g2: return "smooth: tangent and curvature agree";
  }
  return "";
}

Report_item measured_join(const Plane_curve& left, const Plane_curve& right, const Report_demand& demand) {
  Report_item item;
  item.grade = report_grade(segment_class(left, right, demand.corner_threshold));
  item.gap = item.angle = GC::Enclosure{0, 0};
  bool retracted = false;
  switch (item.grade) {
  case Report_grade::gap: {
    const GC::Join_deviation d = GC::deviation(left, right);
    item.gap = d.gap;
    item.angle = d.tangent_angle ? std::optional<GC::Enclosure>(GC::in_degrees(*d.tangent_angle)) : std::nullopt;
    item.severity = d.gap.upper;
    break;
  }
  case Report_grade::kink:
  case Report_grade::corner: {
    const GC::Kink_size size = *segment_kink(left, right);
    item.angle = GC::in_degrees(size.angle);
    if (item.grade == Report_grade::kink) item.offset = size.handle_offset;
    item.severity = size.severity.upper;
    break;
  }
  case Report_grade::fading: // no grades of the library
  case Report_grade::bend:
  case Report_grade::rounding:
  case Report_grade::g0:
  case Report_grade::undecided: item.angle.reset(); break;
  case Report_grade::g1: {
    const GC::Join_deviation d = GC::deviation(left, right);
    retracted = !d.curvature_jump;
    if (!retracted) item.curvature_jump = GC::in_percent(*d.curvature_jump);
    item.severity = retracted ? 0 : item.curvature_jump->upper;
    break;
  }
  case Report_grade::g2: item.curvature_jump = GC::Enclosure{0, 0}; break;
  }
  item.verdict = item.grade == Report_grade::undecided ? "a curve has no length, hence no direction"
                                                       : report_words(item.grade, retracted);
  for (int i = 0; i < 2; ++i) item.point.push_back(rounded(CGAL::to_double(right.coordinates(0)[i]), 9));
  return item;
}

std::shared_ptr<const Report_curve> drawn_curve(const Plane_curve& curve, std::size_t group) {
  return drawn_curve<Plane_curve>(curve, group);
}
