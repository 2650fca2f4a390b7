// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"
#include "commands/fonts/read_fonts.h"
#include "reports/measured_join.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t most_notes = 20;

// A segment of a glyph in units of the font.
Plane_curve plane_curve(const Glyph_segment& s, std::int64_t steps) {
  typedef Plane_curve::Traits::FT FT;
  std::vector<Plane_curve::Traits::Point> points;
  for (int i = 0; i <= s.degree; ++i) {
    const Glyph_point& p = s.points[static_cast<std::size_t>(i)];
    points.emplace_back(FT(p.x) / FT(steps), FT(p.y) / FT(steps));
  }
  return Plane_curve(points.begin(), points.end());
}

Report_grade report_grade(Glyph_grade grade) {
  switch (grade) {
  case Glyph_grade::corner: return Report_grade::corner;
  case Glyph_grade::kink: return Report_grade::kink;
  case Glyph_grade::bend: return Report_grade::bend;
  case Glyph_grade::rounding: return Report_grade::rounding;
  case Glyph_grade::g1: return Report_grade::g1;
  case Glyph_grade::g2: return Report_grade::g2;
  }
  return Report_grade::undecided;
}

// Puts the joins of fonts on a page, and measures those that are shown.
class Fonts_page : public Font_visitor {
  const Report_demand& demand_;
  const Join_rule rule_;
  Report_page& page_;
  std::size_t not_verified_ = 0, contours_ = 0;

  // One contour is drawn for all of its joins.
  std::shared_ptr<const Report_outline> drawing(const Glyph_outline& outline, std::size_t contour) const {
    auto result = std::make_shared<Report_outline>();
    for (const Glyph_segment* s = outline.begin(contour); s != outline.end(contour); ++s)
      result->push_back(drawn_curve(plane_curve(*s, outline.steps()), contours_ + contour));
    return result;
  }

public:
  Fonts_page(const Report_demand& demand, Report_page& page)
      : demand_(demand), rule_{demand.corner_threshold, demand.rounding}, page_(page) {}

  void begin_font(const Font_face&, const Font_result&) override {}

  Join_counts glyph(const Font_face& font, int glyph, const Glyph_outline& outline,
                    const Font_result& result) override {
    // where a join is shown
    std::vector<std::shared_ptr<const Report_outline>> drawn(outline.contours());
    const Join_counts counts = grade_joins(
        outline, rule_,
        [&](std::size_t contour, std::size_t node, Glyph_grade glyph_grade, bool, const Glyph_join& join,
            const Glyph_segment& left, const Glyph_segment& right) {
          const Report_grade grade = report_grade(glyph_grade);
          const double severity = glyph_grade == Glyph_grade::corner ? join.severity() / result.units_per_em : 0,
                       units = is_off(glyph_grade) ? join.units_off() : 0;
          if (!page_.count(grade, is_off(glyph_grade) ? units : severity)) return;
          if (!drawn[contour]) drawn[contour] = drawing(outline, contour);
          Report_item item =
              measured_join(plane_curve(left, outline.steps()), plane_curve(right, outline.steps()), demand_);
          item.number = page_.total();
          item.severity = severity;
          if (is_off(glyph_grade)) {
            item.grade = grade;
            item.verdict = report_words(grade, false);
            item.severity = join.severity() / result.units_per_em;
            item.units_off = units;
          }
          item.place = (result.is_alone ? "" : result.shown_name() + ": ") +
                       join_place(font.glyph_name(glyph), part_name(font, outline.part(contour)), contour, node);
          const auto segment = static_cast<std::size_t>(&right - outline.begin(contour));
          const Report_outline& curves = *drawn[contour];
          item.left = curves[(segment == 0 ? curves.size() : segment) - 1];
          item.right = curves[segment];
          item.outline = drawn[contour];
          page_.add(std::move(item));
        });
    contours_ += outline.contours();
    return counts;
  }

  void leave_out(const char* noun, const std::string& place, const std::string& reason) {
    const bool is_shown = not_verified_++ < most_notes;
    page_.leave_out(noun, not_covered(noun, reason).reason, is_shown ? place + ": not verified, " + reason : "");
  }

  void end_font(const Font_face&, Font_result& result) override {
    const std::string name = result.shown_name();
    for (const Unread_glyph& glyph : result.unread) leave_out("glyph", name + ", glyph " + glyph.name, glyph.reason);
    for (const std::string& glyph : result.missing) leave_out("glyph", name + ", glyph " + glyph, "not in this font");
  }

  void end(const Fonts_result& all) {
    for (const Unread_file& file : all.unread) leave_out("font", file.name, file.reason);
    if (not_verified_ > most_notes)
      page_.notes.push_back(std::to_string(not_verified_ - most_notes) + " more are not verified.");
    page_.summary = counts_text(all);
  }
};

} // namespace

void report_fonts(const Arguments& files, const Report_demand& demand, Report_page& page) {
  page.is_of_fonts = true;
  Fonts_page shown(demand, page);
  shown.end(read_fonts(files, demand.glyphs, shown));
  page.finish();
}
