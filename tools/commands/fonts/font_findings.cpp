// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"
#include "reports/Finding_writer.h"

namespace {

// The worst joins of each font as findings; how many more there are, one finding tells.
class Font_findings : public Font_report {
  const std::unique_ptr<Finding_writer> writer_ = finding_writer(mode_.format);
  const Finding_level unverified_ = !mode_.allow_undecided ? Finding_level::error : Finding_level::warning;
  const Finding_level level_ = required_ ? Finding_level::error : Finding_level::note;

  static std::string message(const Shown_join& join, const Join_numbers& numbers) {
    const std::string at = " at (" + numbers.x + ", " + numbers.y + ")";
    if (join.grade != GC::Join_grade::kink) return to_string(join.grade) + at + ", the curvature jumps";
    return "kink of " + rounded(numbers.degrees.upper, 3) + " degrees" + at + ", a handle is off by " +
           rounded(numbers.units, 2) + " units, " + rounded(numbers.per_mille, 3) + " per mille of the em" +
           (join.copies == 0 ? "" : "; and " + std::to_string(join.copies) + " more like this");
  }

  void not_verified(const std::string& file, const std::string& kind, const std::string& place,
                    const std::string& reason) {
    writer_->add({file, 0, kind, place, Finding_rule::not_verified, unverified_, "not verified, " + reason, ""});
  }

public:
  using Font_report::Font_report;

  void end_font(const Font_result& font) override {
    const std::string place = font.number ? "font " + std::to_string(*font.number) + ", " : "";
    const std::size_t wanted = font.counts.joins.below(required_.value_or(GC::Join_grade::g1));
    writer_->add_passed(font.file, font.counts.joins.joins() - wanted, "joins");
    std::size_t told = 0;
    for (const Shown_join& join : font.worst) {
      const Join_numbers numbers(join);
      writer_->add({font.file, 0, "glyph",
                    place + "glyph " + join.glyph_name + ", contour " + std::to_string(join.contour) + ", node " +
                        std::to_string(join.node),
                    join.grade == GC::Join_grade::kink ? Finding_rule::kink : Finding_rule::curvature, level_,
                    message(join, numbers), json_members(join)});
      told += 1 + join.copies;
    }
    if (told < wanted)
      writer_->add({font.file, 0, "font", place + font.name, Finding_rule::kink, level_,
                    counted(wanted - told, "more join") + " not " + to_string(required_.value_or(GC::Join_grade::g1)) +
                        "; --worst N tells N of them",
                    "\"joins\":" + std::to_string(wanted - told)});
    for (const Unread_glyph& glyph : font.unread)
      not_verified(font.file, "glyph", place + "glyph " + glyph.name, glyph.reason);
    for (const std::string& glyph : font.missing)
      not_verified(font.file, "glyph", place + "glyph " + glyph, "not in this font");
  }

  void print(std::ostream& os, const Fonts_result& all) override {
    for (const Unread_file& file : all.unread) not_verified(file.name, "font", "font", file.reason);
    std::string summary = "\"summary\":{\"fonts\":" + std::to_string(all.fonts) + ',' + json_members(all.counts) + '}';
    if (required_)
      summary += ",\"required\":\"" + to_string(*required_) + "\",\"met\":" + conclusion(all).json_met(mode_);
    writer_->print(os, summary);
  }
};

} // namespace

std::unique_ptr<Font_report> font_findings(const Report_mode& mode, const std::optional<GC::Join_grade>& required) {
  return std::make_unique<Font_findings>(mode, required);
}
