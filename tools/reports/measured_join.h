// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_MEASURED_JOIN_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_MEASURED_JOIN_H

#include "commands/report_inputs.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <memory>
#include <optional>

// A curve in the plane, as a page shows it.
typedef GC::Bezier_curve<GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>>> Plane_curve;

// The grade of the page; an empty one is that of curves without length.
Report_grade report_grade(const std::optional<GC::Visual_class>& grade);

// The verdict in words; `retracted`: a handle lies on the node, so that the curvature is not known.
const char* report_words(Report_grade grade, bool retracted);

// Returns the grade, the verdict and all measures of the join of two curves in the plane. Throws
// GC::Error `work_limit`.
Report_item measured_join(const Plane_curve& left, const Plane_curve& right, const Report_demand& demand);

// The curve as it is drawn.
std::shared_ptr<const Report_curve> drawn_curve(const Plane_curve& curve, std::size_t group);

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_MEASURED_JOIN_H
