// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/join_report.h"
#include "commands/fonts/Glyph_join.h"
#include "files/input.h"
#include "files/progress.h"
#include "formats/font/Font_face.h"
#include "formats/font/font_files.h"
#include "reports/report_joins.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t most_notes = 20;

// A segment of a glyph in units of the font.
Plane_curve plane_curve(const Glyph_segment& s, std::int64_t steps) {
  std::vector<Drawing_traits::Point> points;
  for (int i = 0; i <= s.degree; ++i) {
    const Glyph_point& p = s.points[static_cast<std::size_t>(i)];
    points.emplace_back(Exact(p.x) / Exact(steps), Exact(p.y) / Exact(steps));
  }
  return Plane_curve(points.begin(), points.end());
}

// Grades the joins of fonts, and measures those that are shown.
class Fonts_page {
  const Report_demand& demand_;
  Report_page& page_;
  Glyph_selection selection_ = demand_.glyphs;
  Glyph_outline outline_;
  Progress progress_{"joins"};
  std::size_t fonts_ = 0, glyphs_ = 0, not_verified_ = 0, contours_ = 0;
  bool several_ = false;

  void leave_out(const char* noun, const std::string& place, const std::string& reason) {
    const bool is_shown = not_verified_++ < most_notes;
    page_.leave_out(noun, reason, is_shown ? place + ": not verified, " + reason : "");
  }

  void read_glyph(const Font_face& font, const std::string& font_name, int glyph) {
    font.read(glyph, outline_);
    ++glyphs_;
    for (std::size_t contour = 0; contour < outline_.contours(); ++contour, ++contours_) {
      const Glyph_segment *const begin = outline_.begin(contour), *const end = outline_.end(contour), *left = end - 1;
      std::shared_ptr<const Report_outline> drawn; // of this contour, as soon as one of its joins is shown
      for (const Glyph_segment* right = begin; right != end; left = right++) {
        const Glyph_join join(*left, *right, outline_.steps());
        const Report_grade grade = report_grade(join.grade(demand_.kink_bound));
        const bool has_angle = grade == Report_grade::kink || grade == Report_grade::corner;
        if (!page_.count(grade, has_angle ? join.severity() / font.units_per_em() : 0)) continue;
        if (!drawn) drawn = drawing(begin, end);
        Report_item item =
            measured_join(plane_curve(*left, outline_.steps()), plane_curve(*right, outline_.steps()), demand_);
        item.number = page_.total();
        item.severity = has_angle ? item.severity / font.units_per_em() : 0;
        item.place = (several_ ? font_name + ": " : "") + "glyph " + font.glyph_name(glyph) + ", contour " +
                     std::to_string(contour) + ", node " + std::to_string(right - begin);
        item.left = (*drawn)[static_cast<std::size_t>(left - begin)];
        item.right = (*drawn)[static_cast<std::size_t>(right - begin)];
        item.outline = drawn;
        page_.add(std::move(item));
      }
    }
  }

  std::shared_ptr<const Report_outline> drawing(const Glyph_segment* begin, const Glyph_segment* end) const {
    auto outline = std::make_shared<Report_outline>();
    const double steps = static_cast<double>(outline_.steps());
    for (const Glyph_segment* s = begin; s != end; ++s) {
      Report_curve curve{{}, {}, contours_};
      for (int i = 0; i <= s->degree; ++i) {
        const Glyph_point& p = s->points[static_cast<std::size_t>(i)];
        curve.points.push_back(static_cast<double>(p.x) / steps);
        curve.points.push_back(static_cast<double>(p.y) / steps);
      }
      outline->push_back(std::make_shared<const Report_curve>(std::move(curve)));
    }
    return outline;
  }

  void read_font(const Font_file& file, const Font_face& font, double part_read) {
    if (!font.has_outlines()) throw Font_error("pictures of letters (bitmaps), no outlines");
    std::vector<std::string> missing;
    const std::string own = font.name(), name = own.empty() ? input_name(file.name) : own;
    for (const int glyph : selection_.glyphs(font, missing)) {
      try {
        read_glyph(font, name, glyph);
      } catch (const Font_error& e) {
        leave_out("glyph", name + ", glyph " + font.glyph_name(glyph), e.what());
      }
      progress_.step(page_.total(), [&] { return part_read; });
    }
    ++fonts_;
  }

  void read_file(const Font_file& file, double part_read) {
    try {
      const std::string bytes = read_bytes(file.name);
      for (int i = 0, fonts = 1; i < fonts; ++i) {
        const Font_face font(bytes, i);
        fonts = font.fonts_of_file();
        several_ = several_ || fonts > 1;
        read_font(file, font, part_read);
      }
    } catch (const Font_error& e) {
      if (!file.from_folder) throw GC::Error(GC::Error_code::malformed_input, input_name(file.name) + ": " + e.what());
      leave_out("font", input_name(file.name), e.what());
    } catch (const GC::Error& e) {
      if (!file.from_folder) throw;
      leave_out("font", input_name(file.name), e.what());
    }
  }

public:
  Fonts_page(const Report_demand& demand, Report_page& page) : demand_(demand), page_(page) {}

  void read(const Arguments& arguments) {
    std::vector<Unread_file> unread;
    const std::vector<Font_file> files = font_files(arguments, unread);
    for (const Unread_file& file : unread) leave_out("font", file.name, file.reason);
    std::uintmax_t bytes = 0, done = 0;
    for (const Font_file& file : files) bytes += file.bytes;
    several_ = files.size() > 1;
    for (const Font_file& file : files) {
      read_file(file, bytes == 0 ? 0 : static_cast<double>(done) / static_cast<double>(bytes));
      done += file.bytes;
    }
    progress_.clear();
    if (fonts_ != 0) selection_.check_all_found();
    if (not_verified_ > most_notes)
      page_.notes.push_back(std::to_string(not_verified_ - most_notes) + " more are not verified.");
    page_.summary =
        counted(page_.total(), "join") + " in " + counted(glyphs_, "glyph") + " of " + counted(fonts_, "font");
  }
};

} // namespace

void report_fonts(const Arguments& files, const Report_demand& demand, Report_page& page) {
  page.whole_is_em = true;
  Fonts_page(demand, page).read(files);
  page.finish();
}
