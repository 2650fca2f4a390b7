// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/verify_fonts.h"

#include "commands/chains/plane_curvature.h"
#include "commands/fonts/font_report.h"
#include "commands/fonts/read_fonts.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

// Finds where the curvature of a segment exceeds a bound, in units of the font, if it does.
std::optional<GC::Curvature_excess> curvature_excess(const Glyph_segment& segment, std::int64_t steps,
                                                     const Curvature_bound& bound) {
  typedef CGAL::Simple_cartesian<Exact> Kernel;
  if (segment.degree == 1) return std::nullopt;
  const Exact unit(static_cast<double>(steps));
  std::vector<Kernel::Point_2> points;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(segment.degree); ++i)
    points.emplace_back(Exact(static_cast<double>(segment.points[i].x)) / unit,
                        Exact(static_cast<double>(segment.points[i].y)) / unit);
  return curvature_excess(GC::Bezier_curve<GC::Traits_2<Kernel>>(points), bound);
}

// Grades the joins of fonts, bounds their curvature if that is asked for, and reports both.
class Font_grader : public Font_visitor {
  const Join_rule rule_;
  const std::optional<Curvature_bound> bound_;
  Font_report& report_;
  Worst_joins worst_, worst_of_font_, worst_of_glyph_;

public:
  Font_grader(const Font_demand& demand, Font_report& report)
      : rule_(demand.rule), bound_(demand.bound), report_(report), worst_(demand.worst, true),
        worst_of_font_(report.has_findings() && !demand.is_worst_given ? Worst_joins::all : demand.worst,
                       !report.has_findings()),
        worst_of_glyph_(demand.worst, false) {}

  // Returns the worst joins of all fonts.
  const std::vector<Shown_join>& worst() { return worst_.sorted(); }

  void begin_font(const Font_face&, const Font_result& result) override { report_.begin_font(result); }

  Join_counts glyph(const Font_face& font, int glyph, const Glyph_outline& outline,
                    const Font_result& result) override {
    const double em = result.units_per_em;
    Worst_joins& worst = report_.is_by_glyph() ? worst_of_glyph_ : worst_of_font_;
    const Join_counts joins = grade_joins(
        outline, rule_,
        [&](std::size_t contour, std::size_t node, Glyph_grade grade, bool fails, const Glyph_join& join,
            const Glyph_segment& left, const Glyph_segment& right) {
          if (!fails && !is_defect(grade)) return;
          const bool is_smooth = grade == Glyph_grade::g1;
          worst.add({glyph, outline.part(contour), contour, node, grade, fails, is_smooth ? 0 : join.units_off(),
                     is_smooth ? 0 : join.severity() / em, left, right, outline.steps()});
        });
    if (report_.is_by_glyph()) {
      std::vector<Shown_join> shown = worst.sorted();
      for (Shown_join& join : shown) join.part_name = part_name(font, join.part);
      report_.glyph(glyph, font.glyph_name(glyph), joins, shown);
      worst.clear();
    }
    if (bound_) bound_curvature(font, glyph, outline, result);
    return joins;
  }

  void end_font(const Font_face& font, Font_result& result) override {
    result.worst = worst_of_font_.sorted();
    worst_of_font_.clear();
    for (Shown_join& join : result.worst) {
      join.glyph_name = font.glyph_name(join.glyph);
      join.part_name = part_name(font, join.part);
      join.font_name = result.shown_name();
      worst_.add(join);
    }
    report_.end_font(result);
  }

private:
  void bound_curvature(const Font_face& font, int glyph, const Glyph_outline& outline, const Font_result& result) {
    for (std::size_t contour = 0; contour < outline.contours(); ++contour)
      for (const Glyph_segment* s = outline.begin(contour); s != outline.end(contour); ++s) {
        const auto excess = curvature_excess(*s, outline.steps(), *bound_);
        if (!excess)
          report_.bounded_curve(result);
        else
          report_.bent_curve(result, {font.glyph_name(glyph), part_name(font, outline.part(contour)), contour,
                                      static_cast<std::size_t>(s - outline.begin(contour)), *excess});
      }
  }
};

} // namespace

int verify_fonts(const Arguments& files, const Report_mode& mode, const Font_demand& demand) {
  const std::optional<GC::Visual_class>& required = demand.rule.required;
  Font_requirement requirement{{}, {}, demand.off_by};
  if (required) requirement = {to_string(*required), "\"required\":\"" + to_string(*required) + '"', demand.off_by};
  if (!demand.max_kink.empty()) {
    requirement.text += (required ? " and " : "") + ("within " + demand.max_kink + " degrees");
    requirement.json += (required ? "," : "") + ("\"max_kink\":\"" + demand.max_kink + '"');
  }
  Font_report report(mode, requirement, demand.bound);
  Font_grader grader(demand, report);
  Fonts_result result = read_fonts(files, demand.glyphs, grader);
  result.worst = grader.worst();
  return report.print(std::cout, result);
}
