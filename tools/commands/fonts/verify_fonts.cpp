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
  const std::optional<GC::Join_grade> required_;
  const GC::Kink_bound bound_;
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
      join.font_name = result.name.empty() ? result.file : result.name;
      worst_.add(join);
    }
    report_.end_font(result);
    ++all_.fonts;
    all_.counts += result.counts;
    all_.unread_glyphs += result.unread.size();
    all_.missing += result.missing.size();
  }

  void grade(const Font_face& font, int glyph, Font_result& result) {
    const double em = font.units_per_em();
    Worst_joins& worst = report_.is_by_glyph() ? worst_of_glyph_ : worst_of_font_;
    const Join_counts joins =
        grade_joins(outline_, bound_, required_.value_or(GC::Join_grade::g1),
                    [&](std::size_t contour, std::size_t node, GC::Join_grade grade, const Glyph_join& join,
                        const Glyph_segment& left, const Glyph_segment& right) {
                      const double severity = grade == GC::Join_grade::kink ? join.severity() / em : 0;
                      worst.add({glyph, contour, node, grade, severity, left, right});
                    });
    ++result.counts.glyphs;
    result.counts.empty += outline_.size() == 0;
    result.counts.joins += joins;
    if (!report_.is_by_glyph()) return;
    report_.glyph(glyph, font.glyph_name(glyph), joins, worst.sorted());
    worst.clear();
  }

  // `part` is that of the font, from 0 to 1.
  void show_progress(const Font_file& file, const Font_result& result, double part) {
    progress_.step(all_.counts.joins.joins() + result.counts.joins.joins(), [&] {
      return bytes_ == 0 ? 0 : (double(bytes_done_) + part * double(file.bytes)) / double(bytes_);
    });
  }

public:
  Font_grader(const Arguments& arguments, const Font_demand& demand, Font_report& report)
      : required_(demand.required), bound_(demand.bound), selection_(demand.glyphs), report_(report),
        files_(font_files(arguments, all_.unread)), worst_(demand.worst, true), worst_of_font_(demand.worst, true),
        worst_of_glyph_(demand.worst, false) {
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
  const std::unique_ptr<Font_report> report = font_report(mode, demand.required);
  Font_grader grader(files, demand, *report);
  const Fonts_result& all = grader.read();
  report->print(std::cout, all);
  return report->conclusion(all).exit_code(mode, "join");
}
