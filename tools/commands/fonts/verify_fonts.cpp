// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/verify_fonts.h"

#include "commands/fonts/font_report.h"
#include "files/input.h"
#include "files/progress.h"
#include "formats/font/Font_face.h"
#include "formats/font/font_files.h"

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace {

// Reads fonts and grades their joins.
class Font_grader {
  const Join_rule rule_;
  Glyph_selection selection_;
  Font_report& report_;
  Fonts_result all_;
  const std::vector<Font_file> files_;
  Progress progress_{"joins"};
  Worst_joins worst_, worst_of_font_, worst_of_glyph_;
  std::uintmax_t bytes_ = 0, bytes_done_ = 0;
  bool is_alone_; // the only argument is the only font of a file
  Glyph_outline outline_;

  void read_file(const Font_file& file) {
    std::string number; // in messages, where there are several
    try {
      const std::string bytes = read_bytes(file.name);
      for (int i = 0, fonts = 1; i < fonts; ++i) {
        if (i > 0) number = "font " + std::to_string(i) + ": ";
        try {
          const Font_face font(bytes, i);
          fonts = font.fonts_of_file();
          is_alone_ = is_alone_ && fonts == 1;
          read_font(file, font, fonts == 1 ? std::nullopt : std::optional<int>(i));
        } catch (const Font_error& e) {
          refuse(file, number + e.what());
        }
      }
    } catch (const GC::Error& e) {
      if (!file.from_folder) throw;
      all_.unread.push_back({file.name, e.what()});
    }
  }

  void refuse(const Font_file& file, const std::string& reason) {
    if (!file.from_folder) throw GC::Error(GC::Error_code::malformed_input, input_name(file.name) + ": " + reason);
    all_.unread.push_back({file.name, reason});
  }

  void read_font(const Font_file& file, const Font_face& font, std::optional<int> number) {
    if (!font.has_outlines()) throw Font_error("pictures of letters (bitmaps), no outlines");
    Font_result result{input_name(file.name), number, is_alone_, font.name(), font.units_per_em()};
    const std::vector<int> glyphs = selection_.glyphs(font, result.missing);
    report_.begin_font(result);
    for (const int glyph : glyphs) {
      try {
        font.read(glyph, outline_);
        grade(font, glyph, result);
      } catch (const Font_error& e) {
        result.unread.push_back({glyph, font.glyph_name(glyph), e.what()});
      }
      show_progress(file, result, double(glyph) / font.glyphs());
    }
    result.worst = worst_of_font_.sorted();
    worst_of_font_.clear();
    for (Shown_join& join : result.worst) {
      join.glyph_name = font.glyph_name(join.glyph);
      join.part_name = part_name(font, join);
      join.font_name = result.name.empty() ? result.file : result.name;
      worst_.add(join);
    }
    report_.end_font(result);
    ++all_.fonts;
    all_.counts += result.counts;
  }

  void grade(const Font_face& font, int glyph, Font_result& result) {
    const double em = font.units_per_em();
    Worst_joins& worst = report_.is_by_glyph() ? worst_of_glyph_ : worst_of_font_;
    const Join_counts joins = grade_joins(
        outline_, rule_,
        [&](std::size_t contour, std::size_t node, Glyph_grade grade, bool fails, const Glyph_join& join,
            const Glyph_segment& left, const Glyph_segment& right) {
          const bool is_smooth = grade == Glyph_grade::g1;
          worst.add({glyph, outline_.part(contour), contour, node, grade, fails, is_smooth ? 0 : join.units_off(),
                     is_smooth ? 0 : join.severity() / em, left, right, outline_.steps()});
        });
    ++result.counts.glyphs;
    result.counts.empty += outline_.size() == 0;
    result.counts.joins += joins;
    if (!report_.is_by_glyph()) return;
    std::vector<Shown_join> shown = worst.sorted();
    for (Shown_join& join : shown) join.part_name = part_name(font, join);
    report_.glyph(glyph, font.glyph_name(glyph), joins, shown);
    worst.clear();
  }

  static std::string part_name(const Font_face& font, const Shown_join& join) {
    return join.part == Glyph_outline::own ? std::string() : font.glyph_name(join.part);
  }

  // `part` is that of the font, from 0 to 1.
  void show_progress(const Font_file& file, const Font_result& result, double part) {
    progress_.step(all_.counts.joins.joins() + result.counts.joins.joins(), [&] {
      return bytes_ == 0 ? 0 : (double(bytes_done_) + part * double(file.bytes)) / double(bytes_);
    });
  }

public:
  Font_grader(const Arguments& arguments, const Font_demand& demand, Font_report& report)
      : rule_(demand.rule), selection_(demand.glyphs), report_(report), files_(font_files(arguments, all_.unread)),
        worst_(demand.worst, true), worst_of_font_(demand.worst, true), worst_of_glyph_(demand.worst, false) {
    std::error_code none;
    is_alone_ = arguments.size() == 1 && !std::filesystem::is_directory(arguments[0], none);
    for (const Font_file& file : files_) bytes_ += file.bytes;
  }

  const Fonts_result& read() {
    for (const Font_file& file : files_) {
      read_file(file);
      bytes_done_ += file.bytes;
    }
    progress_.clear();
    if (all_.fonts != 0) selection_.check_all_found();
    all_.worst = worst_.sorted();
    return all_;
  }
};

} // namespace

int verify_fonts(const Arguments& files, const Report_mode& mode, const Font_demand& demand) {
  const std::optional<GC::Join_grade>& required = demand.rule.required;
  Font_requirement requirement{{}, {}, demand.off_by};
  if (required) requirement = {to_string(*required), "\"required\":\"" + to_string(*required) + '"', demand.off_by};
  if (!demand.max_kink.empty()) {
    requirement.text += (required ? " and " : "") + ("within " + demand.max_kink + " degrees");
    requirement.json += (required ? "," : "") + ("\"max_kink\":\"" + demand.max_kink + '"');
  }
  Font_report report(mode, requirement);
  Font_grader grader(files, demand, report);
  return report.print(std::cout, grader.read());
}
